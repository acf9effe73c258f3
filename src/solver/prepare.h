#pragma once

#include "base/lines.h"
#include "base/problem.h"
#include "contact/material.h"
#include "scene/scene.h"
#include "scene/time_step.h"
#include "solver/kernels.h"

#include <vector>

/// What a world with soft contacts takes from its scene.
namespace tumble::solver {

/// Of each material against each: materials squared.
std::vector<contact::PairConstants> pairs_of(const scene::Scene& scene);

/// Whether contacts of some pair remember more than their spring.
bool remember_more(const std::vector<contact::PairConstants>& pairs);

/// Shifts of the periodic box along two axes or three; the digits of an index to base 3, x first, are -1, 0, +1 box
/// lengths.
Lines<Shift> images_of(const scene::Domain& domain, int dimensions);

/// Laws that these dimensions lack.
Problems faults_of_laws(const scene::Scene& scene, int dimensions);

/// A step above the stable limit that the scene does not insist on; `soften` names what could be softer.
Problems faults_of_step(const scene::Scene& scene, const scene::TimeStepReport& report, const char* soften);

void append(Problems& all, const Problems& more);

} // namespace tumble::solver
