#include "base/text.h"
#include "observe/xml_arrays.h"
#include "render/drawing_file.h"
#include "render/letters.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// SVG 1.1, www.w3.org/TR/SVG11. Its arcs end at points, so that one of a whole turn has to be told in parts.
constexpr double longest_arc = 2.5; // rad, less than half a turn

std::string hex(const Vector3d& color) {
    std::string word = "#";
    for (int k = 0; k < 3; ++k)
        word += fmt::format("{:02x}", std::lround(255 * color[k]));
    return word;
}

/// Writes shape after shape; lengths come as pixels and go out as mm to a tenth of a micrometre.
struct SvgWriter {
    double mm_per_pixel = 1;
    std::string out{};
    int names = 0; // given to windows and ramps so far

    [[nodiscard]] std::string mm(double pixels) const {
        return shortest(std::round(1e4 * mm_per_pixel * pixels) / 1e4 + 0.0);
    }
    [[nodiscard]] std::string point(const Vector2d& p) const { return mm(p.x()) + ',' + mm(p.y()); }

    [[nodiscard]] std::string points(const std::vector<Vector2d>& all) const {
        std::string words;
        for (const Vector2d& p : all)
            words += (words.empty() ? "" : " ") + point(p);
        return words;
    }

    [[nodiscard]] std::string attributes(const Look& look) const {
        std::string words = fmt::format(" fill=\"{}\"", look.fill ? hex(*look.fill) : "none");
        if (look.ink)
            words += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", hex(*look.ink), mm(look.line));
        if (look.long_ends)
            words += " stroke-linecap=\"square\"";
        if (look.opacity < 1)
            words += fmt::format(" opacity=\"{}\"", shortest(look.opacity));
        return words;
    }

    [[nodiscard]] std::string rectangle(const Area& area) const {
        return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", mm(area.left), mm(area.top),
                           mm(area.width()), mm(area.height()));
    }

    void operator()(const Circle& circle) {
        out += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", mm(circle.centre.x()), mm(circle.centre.y()),
                           mm(circle.radius), attributes(circle.look));
    }

    void operator()(const Polygon& polygon) {
        out += fmt::format("<{} points=\"{}\"{}/>\n", polygon.closed ? "polygon" : "polyline", points(polygon.points),
                           attributes(polygon.look));
    }

    void operator()(const ArcLoops& shape) {
        std::string path;
        for (const std::vector<Arc>& loop : shape.loops) {
            path += 'M' + point(loop.front().at(loop.front().from));
            for (const Arc& arc : loop) {
                const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / longest_arc)));
                for (int k = 1; k <= parts; ++k)
                    path += fmt::format("A{0},{0} 0 0 {1} {2}", mm(arc.radius), arc.sweep > 0 ? 1 : 0,
                                        point(arc.at(arc.from + arc.sweep * k / parts)));
            }
            path += 'Z';
        }
        out += fmt::format("<path d=\"{}\" fill-rule=\"evenodd\"{}/>\n", path, attributes(shape.look));
    }

    void operator()(const Ramp& ramp) {
        const std::string name = fmt::format("ramp{}", ++names);
        out += fmt::format("<linearGradient id=\"{}\" x1=\"0\" y1=\"{}\" x2=\"{}\" y2=\"0\">\n", name,
                           ramp.upright ? 1 : 0, ramp.upright ? 0 : 1);
        const std::size_t last = ramp.map.points.size() - 1;
        for (std::size_t k = 0; k <= last; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(last);
            out += fmt::format("<stop offset=\"{}\" stop-color=\"{}\"/>\n", shortest(share), hex(ramp.map.at(share)));
        }
        out += fmt::format("</linearGradient>\n{} fill=\"url(#{})\"/>\n", rectangle(ramp.area), name);
    }

    void operator()(const Words& words) {
        const char* anchor = words.align == Align::left     ? ""
                             : words.align == Align::middle ? " text-anchor=\"middle\""
                                                            : " text-anchor=\"end\"";
        out += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{} fill=\"{}\">{}</text>\n", mm(words.at.x()),
                           mm(words.at.y()), mm(words.size), anchor, hex(words.color), observe::escaped(words.text));
    }

    void operator()(const GroupBegin& group) {
        std::string clip;
        if (group.window) {
            const std::string name = fmt::format("window{}", ++names);
            out += fmt::format("<clipPath id=\"{}\">{}/></clipPath>\n", name, rectangle(*group.window));
            clip = fmt::format(" clip-path=\"url(#{})\"", name);
        }
        const std::string move = group.at.isZero() ? "" : fmt::format(" transform=\"translate({})\"", point(group.at));
        out += fmt::format("<g class=\"{}\"{}{}>\n", observe::escaped(group.name), move, clip);
    }

    void operator()(const GroupEnd&) { out += "</g>\n"; }
};

} // namespace

std::string encode_svg(const Drawing& drawing) {
    SvgWriter svg{drawing.mm_per_pixel};
    for (const Shape& shape : drawing.shapes)
        std::visit(svg, shape);
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
                       "viewBox=\"0 0 {0} {1}\" font-family=\"{2}, Verdana, sans-serif\" stroke-linejoin=\"round\">\n"
                       "<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n{4}</svg>\n",
                       shortest(drawing.width_mm), shortest(drawing.height_mm), letter_family, hex(drawing.background),
                       svg.out);
}

} // namespace tumble::render
