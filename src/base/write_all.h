#pragma once

#include <string_view>

namespace tumble {

/// Writes all bytes to an open file, however many calls that takes. Returns 0 or what the system said (errno).
int write_all(int file, std::string_view bytes);

} // namespace tumble
