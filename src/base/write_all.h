#pragma once

#include <string_view>
#include <sys/types.h>

namespace tumble {

/// Writes all bytes to an open file, however many calls that takes. Returns 0 or what the system said (errno).
int write_all(int file, std::string_view bytes);

/// The same as POSIX write(2).
using WriteCall = ssize_t (*)(int file, const void* bytes, std::size_t count);

/// From now on write_all calls this instead of write(2), on all threads; null: write(2) again. For tests of disks that
/// fail.
void write_through(WriteCall call);

} // namespace tumble
