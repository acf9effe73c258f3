#pragma once

#include <array>

namespace tumble::scene {

/// By the number of contact::RollingLaw.
constexpr std::array<const char*, 3> words_of_rolling{"none", "cdt", "epsd"};

enum class NormalLaw { hertz, linear };
enum class TangentialLaw { none, mindlin, linear };

} // namespace tumble::scene
