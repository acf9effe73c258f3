#include "base/hash.h"

#include <fmt/format.h>

namespace tumble {

std::string Hash64::hex() const {
    return fmt::format("{:016x}", value_);
}

} // namespace tumble
