#include "base/thrown.h"

#include <new>
#include <stdexcept>
#include <system_error>

namespace tumble {

Problem problem_of(const std::exception& thrown) {
    const bool too_much =
        dynamic_cast<const std::bad_alloc*>(&thrown) || dynamic_cast<const std::length_error*>(&thrown);
    if (too_much)
        return {.what = "there is not enough memory",
                .fix = "free some, or ask for less: fewer bodies, fewer frames, smaller pictures"};
    const auto* refused = dynamic_cast<const std::system_error*>(&thrown);
    if (refused && refused->code() == std::errc::resource_unavailable_try_again)
        return {.what = thrown.what(), .fix = "ask for fewer threads, or end other programs"};
    return {.what = thrown.what()};
}

} // namespace tumble
