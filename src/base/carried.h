#pragma once

#include <concepts>
#include <type_traits>

namespace tumble {

/// T is Struct or const Struct: what a list of members takes that is for writing and for reading (base/archive.h).
template <class T, class Struct>
concept As = std::same_as<std::remove_const_t<T>, Struct>;

} // namespace tumble
