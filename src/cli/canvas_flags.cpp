#include "cli/canvas_flags.h"

#include "base/text.h"
#include "cli/flag_checks.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace tumble::cli {

namespace {

// As of pictures for print, scene keys render.width_mm and the like.
constexpr double least_mm = 20, most_mm = 600;
constexpr double print_dpi = 300, print_font = 8;
constexpr double most_pixels = 8192; // as render.width_px

/// "85x60" or "85,60", mm.
std::optional<std::array<double, 2>> read_size(const std::string& text) {
    const std::size_t cut = text.find_first_of("x,");
    if (cut == std::string::npos)
        return std::nullopt;
    const auto width = parse_number(text.substr(0, cut)), height = parse_number(text.substr(cut + 1));
    const auto fits = [](const Result<double>& mm) { return mm && *mm >= least_mm && *mm <= most_mm; };
    if (!fits(width) || !fits(height))
        return std::nullopt;
    return std::array{*width, *height};
}

} // namespace

void add_canvas_flags(CLI::App& command, CanvasFlags& flags) {
    command.add_option("--size-mm", flags.size, "Size for print, mm, such as 85x60")->type_name("WxH");
    command.add_option("--dpi", flags.dpi, "Pixels an inch of a PNG file; 300 with --size-mm")
        ->type_name("N")
        ->check(number_from(72, 1200));
    command.add_option("--font-pt", flags.font, "Points of the letters; 8 with --size-mm")
        ->type_name("N")
        ->check(number_from(4, 24));
}

std::optional<Problem> refuse_pixels(const sheet::Canvas& canvas) {
    const double pixels = std::max(canvas.width_mm, canvas.height_mm) / 25.4 * canvas.dpi;
    if (pixels <= most_pixels)
        return std::nullopt;
    return Problem{.what = fmt::format("{:.0f} x {:.0f} mm at {:g} dpi are {:.0f} pixels along a side, more than {:g}",
                                       canvas.width_mm, canvas.height_mm, canvas.dpi, pixels, most_pixels),
                   .fix = "choose a lower --dpi or a smaller --size-mm"};
}

Result<sheet::Canvas> canvas_of(const CanvasFlags& flags, const sheet::Canvas& usual) {
    sheet::Canvas canvas = usual;
    if (!flags.size.empty()) {
        const auto size = read_size(flags.size);
        if (!size)
            return Problem{.what = fmt::format("--size-mm {} is no size", excerpt(flags.size)),
                           .fix = fmt::format("write width x height, each from {:g} to {:g} mm, such as 85x60",
                                              least_mm, most_mm)};
        canvas = {
            .width_mm = (*size)[0], .height_mm = (*size)[1], .dpi = print_dpi, .font_pt = print_font, .titled = false};
    }
    canvas.dpi = flags.dpi.value_or(canvas.dpi);
    canvas.font_pt = flags.font.value_or(canvas.font_pt);
    if (auto problem = refuse_pixels(canvas))
        return *problem;
    return canvas;
}

} // namespace tumble::cli
