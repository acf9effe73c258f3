#include "observe/whole_file.h"

#include "base/disk_calls.h"
#include "base/growing_file.h"
#include "base/remedy.h"
#include "base/write_all.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <unistd.h>

namespace tumble::observe {

namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using Stream = std::unique_ptr<std::FILE, Close>;

Problem failed(const std::filesystem::path& file, const char* verb, int error, const char* fix = "") {
    return {.file = file.string(), .what = fmt::format("cannot be {}: {}", verb, std::strerror(error)), .fix = fix};
}

/// Some kinds of disks cannot be waited for, which they call an invalid request.
int sync(int file) {
    return disk_calls().sync(file) == 0 || errno == EINVAL ? 0 : errno;
}

/// 0 or errno.
int write_new(const std::filesystem::path& file, std::string_view content, Writing writing) {
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (opened < 0)
        return errno;
    int error = write_all(opened, content);
    if (error == 0 && writing == Writing::lasting)
        error = sync(opened);
    if (disk_calls().close(opened) != 0 && error == 0)
        error = errno;
    return error;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

} // namespace

Result<Done> write_whole(const std::filesystem::path& file, std::string_view content, Writing writing) {
    const std::filesystem::path unfinished = growing_name(file);
    int error = write_new(unfinished, content, writing);
    if (error == 0 && disk_calls().rename(unfinished.c_str(), file.c_str()) != 0)
        error = errno;
    if (error != 0) {
        std::remove(unfinished.c_str());
        return failed(file, "written", error, remedy(error));
    }
    return writing == Writing::lasting ? wait_for_disk(folder_of(file)) : Done{};
}

Result<Done> wait_for_disk(const std::filesystem::path& place) {
    const int opened = ::open(place.c_str(), O_RDONLY | O_CLOEXEC);
    if (opened < 0)
        return failed(place, "written", errno, remedy(errno));
    const int error = sync(opened);
    ::close(opened);
    if (error != 0)
        return failed(place, "written", error, remedy(error));
    return Done{};
}

Result<std::string> read_whole(const std::filesystem::path& file, std::uintmax_t limit) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
        return failed(file, "read", error.value());
    if (size > limit)
        return Problem{.file = file.string(), .what = fmt::format("has {} bytes, more than the {} read", size, limit)};
    Stream stream(std::fopen(file.c_str(), "rb"));
    if (!stream)
        return failed(file, "read", errno);
    std::string content(size, '\0');
    errno = 0;
    if (std::fread(content.data(), 1, content.size(), stream.get()) != content.size())
        return failed(file, "read", errno ? errno : EIO);
    return content;
}

} // namespace tumble::observe
