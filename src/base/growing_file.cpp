#include "base/growing_file.h"

#include "base/remedy.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace tumble {

std::filesystem::path growing_name(const std::filesystem::path& file) {
    return file.string() + ".part";
}

Problem file_problem(const std::filesystem::path& file, const char* verb, int error) {
    return {
        .file = file.string(), .what = fmt::format("cannot {}: {}", verb, std::strerror(error)), .fix = remedy(error)};
}

Result<Done> check_writable(const std::filesystem::path& file) {
    std::error_code ignored;
    int error = std::filesystem::is_directory(file, ignored) ? EISDIR : 0;
    const std::filesystem::path trial = growing_name(file);
    const int opened = error == 0 ? ::open(trial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666) : -1;
    if (error == 0 && opened < 0)
        error = errno;
    if (error != 0)
        return file_problem(file, "write the file", error);
    ::close(opened);
    ::unlink(trial.c_str());
    return Done{};
}

} // namespace tumble
