#include "base/write_all.h"

#include "base/disk_calls.h"

#include <cerrno>

namespace tumble {

int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = disk_calls().write(file, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR)
            return errno;
        if (count == 0)
            return EIO; // no progress and no reason given
        bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return 0;
}

} // namespace tumble
