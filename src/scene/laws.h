#pragma once

namespace tumble::scene {

/// What moves discs: springs and dashpots step by step, or Box2D's impulses between hard bodies.
enum class Solver { soft, box2d };
enum class NormalLaw { hertz, linear };
enum class TangentialLaw { none, mindlin, linear };

} // namespace tumble::scene
