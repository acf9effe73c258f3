#pragma once

#include "base/problem.h"
#include "scene/scene.h"
#include "support/arguments.h"

#include <string>
#include <utility>

namespace tumble::bench {

/// Scene with material 0 "media" and 1 "wall" as the peers' decks have them (thesis: density 1665.71 kg/m3, E 0.46 GPa,
/// nu 0.2887, restitution 0.67, friction 0.58; lining 25 MPa, 0.25, with media 0.159 and 0.86), Hertz-Mindlin, no
/// bodies, no walls. The time step is not checked: a benchmark takes the peer's.
scene::Scene media_scene();

/// The value, or the end of the program with its problems.
template <class T> T value_or_refuse(Result<T> result) {
    if (!result)
        refuse(to_string(result.problems()));
    return std::move(*result);
}

/// Spheres read from a file of "x y z r" lines, as a body of material 0.
scene::BodyTemplate read_template(const std::string& name, const std::string& file);

} // namespace tumble::bench
