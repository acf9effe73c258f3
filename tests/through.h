#pragma once

#include "base/disk_calls.h"

namespace tumble::test {

/// For as long as it lives, files reach the disk through these calls.
struct Through {
    explicit Through(const DiskCalls& given) : calls(given) { use_disk_calls(&calls); }
    Through(const Through&) = delete;
    Through& operator=(const Through&) = delete;
    ~Through() { use_disk_calls(nullptr); }

    DiskCalls calls;
};

} // namespace tumble::test
