#include "sheet/gnuplot.h"

#include "base/child_process.h"
#include "base/text.h"
#include "sheet/sheet.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fmt/format.h>

namespace tumble::sheet {

namespace {

constexpr std::chrono::seconds patience{60};

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

Result<Done> run_gnuplot(const std::string& script, const std::filesystem::path& file, const std::string& without) {
    ChildProcess gnuplot({"gnuplot"});
    if (gnuplot.error() == ENOENT)
        return Problem{.what = "gnuplot, which draws the figures, is not installed",
                       .fix = "apt install gnuplot-nox, or " + without};
    if (gnuplot.error() != 0)
        return Problem{.what = fmt::format("gnuplot could not be started: {}", std::strerror(gnuplot.error()))};
    const bool fed = gnuplot.feed({reinterpret_cast<const std::uint8_t*>(script.data()), script.size()});
    if (gnuplot.wait(patience) == 0 && fed)
        return Done{};
    return Problem{.file = file.string(), .what = "gnuplot failed: " + excerpt(trimmed(gnuplot.printed()), 300)};
}

} // namespace tumble::sheet
