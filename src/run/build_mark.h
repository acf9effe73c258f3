#pragma once

#include <string>

namespace tumble::run {

/// 16 hexadecimal digits over the contents of all sources that decide bits, how they are compiled and with what
/// (src/run/build.cmake). Two builds with the same mark on one machine compute the same states, rows and frames; of two
/// with different marks nobody knows.
std::string build_mark();

} // namespace tumble::run
