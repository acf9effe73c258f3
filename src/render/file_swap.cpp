#include "render/file_swap.h"

#include "base/disk_calls.h"
#include "base/growing_file.h"
#include "base/write_all.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace tumble::render {

Result<Done> finish_file(const std::filesystem::path& file) {
    if (disk_calls().rename(growing_name(file).c_str(), file.c_str()) != 0) {
        const int error = errno;
        ::unlink(growing_name(file).c_str());
        return file_problem(file, "write the file", error);
    }
    return Done{};
}

Result<Done> write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
    const std::filesystem::path growing = growing_name(file);
    const int descriptor = ::open(growing.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return file_problem(file, "write the file", errno);
    }
    int error = write_all(descriptor, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (disk_calls().close(descriptor) != 0 && error == 0) {
        error = errno;
    }
    if (error != 0) {
        ::unlink(growing.c_str());
        return file_problem(file, "write the file", error);
    }
    return finish_file(file);
}

} // namespace tumble::render
