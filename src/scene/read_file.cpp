#include "scene/read_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace tumble::scene {

std::string in_words(std::size_t bytes) {
    constexpr std::array<const char*, 5> units{"bytes", "KiB", "MiB", "GiB", "TiB"};
    auto value = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; value >= 999.5 && unit + 1 < units.size(); ++unit)
        value /= 1024;
    return fmt::format("{:.3g} {}", value, units[unit]);
}

Result<std::string> read_file(const std::filesystem::path& path, std::size_t cap) {
    const auto refused = [&](std::string what, std::string fix) {
        return Problem{path.string(), 0, 0, "", std::move(what), std::move(fix)};
    };
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status))
        return refused("there is no such file", "check the name; this is where it was looked for");
    if (std::filesystem::is_directory(status))
        return refused("this is a folder, not a file", "name a file inside it");
    if (std::filesystem::is_regular_file(status)) {
        const auto size = std::filesystem::file_size(path, error);
        if (!error && size > cap)
            return refused(
                fmt::format("the file has {}, more than the {} that are read", in_words(size), in_words(cap)),
                "split it or leave out what is not needed");
    }
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        return refused(fmt::format("the file cannot be opened: {}", std::strerror(errno)), "check its permissions");
    std::string text;
    char buffer[65536];
    // Pipes and devices have no size to ask for: the cap must hold while reading, too.
    while (stream.read(buffer, sizeof buffer) || stream.gcount() > 0) {
        text.append(buffer, static_cast<std::size_t>(stream.gcount()));
        if (text.size() > cap)
            return refused(fmt::format("the file has more than the {} that are read", in_words(cap)),
                           "split it or leave out what is not needed");
    }
    if (stream.bad())
        return refused("the file cannot be read to its end", "check the disk it lies on");
    return text;
}

} // namespace tumble::scene
