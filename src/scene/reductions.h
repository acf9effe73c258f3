#pragma once

#include "base/problem.h"
#include "fit/spheres.h"
#include "scene/scene.h"

/// What makes a scene cheaper and a little wrong, on plain values; docs/reduced-order.md. Problems have no place: only
/// what is wrong and what to do.
namespace tumble::scene {

/// Moduli and stiffnesses over `factor`, the step as much longer as impacts get, and the work of adhesion less, so that
/// the energy stays that parts what sticks. Problems: a pull that grows with the area of contact (adhesion = "sjkr").
Result<Done> soften(Scene& scene, double factor);

/// Bodies that come in numbers `factor` times as long and as many times fewer as each is heavier, the step as much
/// longer as impacts get. Problems: no such body; adhesion, cohesion or air, which belong to a size.
Result<Done> enlarge(Scene& scene, double factor);

/// The fewest that refit() takes.
constexpr int fewest_spheres = fit::fewest_in_a_cone;

/// At most `spheres` for each body with a cone. Problems: no body has a cone; the spheres of one do not stand in it;
/// those of fit::spheres_in.
Result<Done> refit(Scene& scene, int spheres);

/// The middle `share` of the periodic length, with as large a share of the bodies. Problems: not exactly one periodic
/// direction; a wall that is not the same all along it.
Result<Done> cut_slice(Scene& scene, double share);

} // namespace tumble::scene
