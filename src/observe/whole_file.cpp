#include "observe/whole_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <memory>

namespace tumble::observe {

namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using Stream = std::unique_ptr<std::FILE, Close>;

Problem failed(const std::filesystem::path& file, const char* verb, int error) {
    return {.file = file.string(),
            .what = fmt::format("cannot be {}: {}", verb, std::strerror(error)),
            .fix = error == ENOSPC ? "free some space, or write to another disk" : ""};
}

} // namespace

Result<Done> write_whole(const std::filesystem::path& file, std::string_view content) {
    const std::filesystem::path unfinished = file.string() + ".part";
    Stream stream(std::fopen(unfinished.c_str(), "wb"));
    if (!stream)
        return failed(file, "written", errno);
    errno = 0;
    const bool written = std::fwrite(content.data(), 1, content.size(), stream.get()) == content.size();
    const bool closed = std::fclose(stream.release()) == 0;
    if (written && closed && std::rename(unfinished.c_str(), file.c_str()) == 0)
        return Done{};
    const int error = errno;
    std::remove(unfinished.c_str());
    return failed(file, "written", error);
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
