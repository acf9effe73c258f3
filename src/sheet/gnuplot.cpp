#include "sheet/gnuplot.h"

#include "base/child_process.h"
#include "base/ending.h"
#include "base/growing_file.h"
#include "base/png_size.h"
#include "base/remedy.h"
#include "base/text.h"
#include "sheet/sheet.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <utility>

namespace tumble::sheet {

namespace {

constexpr std::chrono::seconds patience{60};

/// Gnuplot does not say that it could not write all of a file.
bool is_whole(const std::filesystem::path& file, const std::string& ending) {
    const std::string mark = ending == ".svg" ? "</svg>" : ending == ".pdf" ? "%%EOF" : "IEND";
    std::ifstream content(file, std::ios::binary | std::ios::ate);
    const std::streamoff size = content.tellg(), read = std::min<std::streamoff>(size, 64);
    std::string last(static_cast<std::size_t>(std::max<std::streamoff>(read, 0)), '\0');
    content.seekg(size - read);
    return size > 0 && content.read(last.data(), read) && last.find(mark) != std::string::npos;
}

/// How large a PNG is meant, which gnuplot does not say.
bool tell_size(const std::filesystem::path& file, double dpi) {
    std::ifstream drawn(file, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(drawn)), {});
    constexpr double inches_per_metre = 1 / 0.0254;
    insert_png_size(bytes, dpi * inches_per_metre);
    return static_cast<bool>(std::ofstream(file, std::ios::binary) << bytes << std::flush);
}

/// Taken away at the end, if it is still there.
class Leftover {
public:
    explicit Leftover(std::filesystem::path file) : file_(std::move(file)) {}
    Leftover(const Leftover&) = delete;
    Leftover& operator=(const Leftover&) = delete;
    ~Leftover() {
        std::error_code ignored;
        std::filesystem::remove(file_, ignored);
    }

private:
    std::filesystem::path file_;
};

} // namespace

std::string in_gnuplots_quotes(const std::string& text) {
    std::string safe = "'";
    for (const char c : text)
        safe += c == '\'' ? std::string("''") : std::string(1, c);
    return safe + "'";
}

std::string axis_words(const std::string& label, const std::string& unit) {
    return unit.empty() ? label : fmt::format("{} [{}]", label, unit);
}

std::string color_of(std::size_t index) {
    constexpr std::array<const char*, colors> table{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
    return table[index % colors];
}

Result<Done> run_gnuplot(const std::string& script, const std::filesystem::path& file, const Canvas& canvas,
                         const std::string& without, const std::string& tail) {
    if (Result<Done> place = check_writable(file); !place)
        return place;
    const Leftover leftover(growing_name(file));
    ChildProcess gnuplot({"gnuplot"});
    if (gnuplot.error() == ENOENT)
        return Problem{.what = "gnuplot, which draws the figures, is not installed",
                       .fix = "apt install gnuplot-nox, or " + without};
    if (gnuplot.error() != 0)
        return Problem{.what = fmt::format("gnuplot could not be started: {}", std::strerror(gnuplot.error()))};
    const bool fed = gnuplot.feed({reinterpret_cast<const std::uint8_t*>(script.data()), script.size()});
    if (gnuplot.wait(patience) != 0 || !fed)
        return Problem{.file = file.string(), .what = "gnuplot failed: " + excerpt(trimmed(gnuplot.printed()), 300)};
    const bool whole = is_whole(growing_name(file), ending_of(file));
    if (!whole || (!tail.empty() && !(std::ofstream(growing_name(file), std::ios::app) << tail << std::flush)))
        return Problem{.file = file.string(),
                       .what = "gnuplot could not write it to its end, as on a disk that is full",
                       .fix = remedy(ENOSPC)};
    if (ending_of(file) == ".png" && !tell_size(growing_name(file), canvas.dpi))
        return file_problem(file, "write the file", errno);
    std::error_code error;
    std::filesystem::rename(growing_name(file), file, error);
    if (error)
        return file_problem(file, "write the file", error.value());
    return Done{};
}

} // namespace tumble::sheet
