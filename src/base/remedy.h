#pragma once

namespace tumble {

/// What to do about a file or folder that cannot be written or made, by what the system said (errno); "" where only the
/// system knows.
const char* remedy(int error);

} // namespace tumble
