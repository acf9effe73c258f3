#include "base/write_all.h"

#include <atomic>
#include <cerrno>
#include <unistd.h>

namespace tumble {

namespace {
std::atomic<WriteCall> chosen{nullptr};
}

int write_all(int file, std::string_view bytes) {
    const WriteCall replaced = chosen.load(std::memory_order_relaxed);
    const WriteCall call = replaced ? replaced : &::write;
    while (!bytes.empty()) {
        const ssize_t count = call(file, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR)
            return errno;
        if (count == 0)
            return EIO; // no progress and no reason given
        bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return 0;
}

void write_through(WriteCall call) {
    chosen.store(call, std::memory_order_relaxed);
}

} // namespace tumble
