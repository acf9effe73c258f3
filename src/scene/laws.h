#pragma once

#include <array>

namespace tumble::scene {

/// By the number of contact::RollingLaw.
constexpr std::array<const char*, 3> words_of_rolling{"none", "cdt", "epsd"};

/// By the number of contact::AdhesionLaw.
constexpr std::array<const char*, 4> words_of_adhesion{"none", "sjkr", "jkr", "dmt"};

/// What moves discs: springs and dashpots step by step, or Box2D's impulses between hard bodies.
enum class Solver { soft, box2d };
enum class NormalLaw { hertz, linear };
enum class TangentialLaw { none, mindlin, linear };

} // namespace tumble::scene
