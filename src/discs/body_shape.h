#pragma once

#include "base/problem.h"
#include "contact/material.h"
#include "discs/bodies.h"
#include "scene/scene.h"

#include <vector>

namespace tumble::discs {

/// A template as solvers use it: mass (density * area * depth), centre and inertia of the union of its discs, exact
/// sums over the arcs of the union's outline; discs moved to the centre of mass. A single disc gets m r^2 / 2. A mass
/// given in the template scales the inertia; a given inertia replaces it. Problems: no discs, a radius, a depth or a
/// density that is not positive, a number that is not finite.
Result<BodyShape> make_body_shape(const scene::BodyTemplate& body, const contact::Material& material, double depth);

/// Indices, ascending, into shape.discs of those that can ever touch anything from outside: without those whose whole
/// rim lies inside others.
std::vector<int> contact_discs(const BodyShape& shape);

/// A template with what touching and placing need of it.
struct ShapeData {
    BodyShape shape;
    int material = 0;
    std::vector<double> exposed; // x y r of the discs that can touch anything, about the centre of mass
};

/// Parallel to the scene's bodies. Problems: those of make_body_shape.
Result<std::vector<ShapeData>> shapes_for(const scene::Scene& scene);

} // namespace tumble::discs
