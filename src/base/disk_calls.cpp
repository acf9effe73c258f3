#include "base/disk_calls.h"

#include <atomic>

namespace tumble {

namespace {
std::atomic<const DiskCalls*> chosen{nullptr};
}

const DiskCalls& disk_calls() {
    static const DiskCalls of_the_system;
    const DiskCalls* replaced = chosen.load(std::memory_order_acquire);
    return replaced ? *replaced : of_the_system;
}

void use_disk_calls(const DiskCalls* calls) {
    chosen.store(calls, std::memory_order_release);
}

} // namespace tumble
