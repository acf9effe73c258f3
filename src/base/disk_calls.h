#pragma once

#include <cstddef>
#include <cstdio>
#include <sys/types.h>
#include <unistd.h>

namespace tumble {

/// The calls of the system by which files reach the disk; each as POSIX has it. Tests put others in their place: disks
/// that fail, and a record of what was called in which order.
struct DiskCalls {
    ssize_t (*write)(int file, const void* bytes, std::size_t count) = &::write;
    int (*sync)(int file) = &::fsync;
    int (*close)(int file) = &::close;
    int (*rename)(const char* from, const char* to) = &std::rename;
};

/// Those in use.
const DiskCalls& disk_calls();

/// From now on these are used, on all threads; they must live until others are. Null: the system's again.
void use_disk_calls(const DiskCalls* calls);

} // namespace tumble
