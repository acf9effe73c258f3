#pragma once

namespace tumble::scene {

enum class NormalLaw { hertz, linear };
enum class TangentialLaw { none, mindlin, linear };

} // namespace tumble::scene
