#pragma once

#include "experiment.h"
#include "random.h"

namespace blind {

/// What is done on a bench, drawn; with `more` also what separates better, and a clock in the picture.
Setup draw_setup(Bench bench, bool more, Random& random);

/// The baseline that every case is held against, by the generator's own account of the scene.
Truth baseline(Bench bench);

} // namespace blind
