#include "render/screen_pen.h"

#include <array>
#include <cmath>
#include <imgui.h>
#include <utility>

namespace tumble::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

static ImVec2 point(const Vector2d& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

static ImU32 ink(const Vector3d& color, double opacity = 1) {
    return ImGui::ColorConvertFloat4ToU32({static_cast<float>(color.x()), static_cast<float>(color.y()),
                                           static_cast<float>(color.z()), static_cast<float>(opacity)});
}

ImFont* ScreenPen::font(Lettering lettering) const {
    switch (lettering) {
    case Lettering::small:
        return fonts_.small;
    case Lettering::large:
        return fonts_.large;
    case Lettering::normal:
        break;
    }
    return fonts_.normal;
}

double ScreenPen::height(Lettering lettering) const {
    return font(lettering)->FontSize;
}

std::string ScreenPen::writable(const std::string& text) const {
    if (fonts_.complete) {
        return text;
    }
    constexpr std::array<std::pair<const char*, const char*>, 15> plain{{{"\u2212", "-"},
                                                                         {"\u2248", "~"},
                                                                         {"\u2264", "<="},
                                                                         {"\u2265", ">="},
                                                                         {"\u207b", "^-"},
                                                                         {"\u2070", "0"},
                                                                         {"\u00b9", "1"},
                                                                         {"\u00b2", "2"},
                                                                         {"\u00b3", "3"},
                                                                         {"\u2074", "4"},
                                                                         {"\u2075", "5"},
                                                                         {"\u2076", "6"},
                                                                         {"\u2077", "7"},
                                                                         {"\u2078", "8"},
                                                                         {"\u2079", "9"}}};
    std::string result = text;
    for (const auto& [from, to] : plain) {
        for (auto place = result.find(from); place != std::string::npos; place = result.find(from)) {
            result.replace(place, std::string(from).size(), to);
        }
    }
    return result;
}

double ScreenPen::width(const std::string& text, Lettering lettering) const {
    ImFont* f = font(lettering);
    return f->CalcTextSizeA(f->FontSize, 1e9F, 0, writable(text).c_str()).x;
}

void ScreenPen::text(double x, double y, const std::string& words, Lettering lettering, Align align,
                     const Vector3d& color) {
    const std::string letters = writable(words);
    const double long_ = width(words, lettering);
    const double left = align == Align::left ? x : align == Align::middle ? x - 0.5 * long_ : x - long_;
    ImFont* f = font(lettering);
    // Whole pixels keep the letters crisp.
    list_.AddText(f, f->FontSize, point({std::round(left), std::round(y)}), ink(color), letters.c_str());
}

void ScreenPen::rectangle(const Area& area, const Vector3d& color, double opacity) {
    list_.AddRectFilled(point({area.left, area.top}), point({area.right, area.bottom}), ink(color, opacity));
}

void ScreenPen::ramp(const Area& area, const ColorMap& map, bool upright) {
    const auto count = static_cast<int>(map.points.size()) - 1;
    for (int i = 0; i < count; ++i) {
        const double from = static_cast<double>(i) / count;
        const double to = static_cast<double>(i + 1) / count;
        const Area part =
            upright ? Area{area.left, area.bottom - to * area.height(), area.right, area.bottom - from * area.height()}
                    : Area{area.left + from * area.width(), area.top, area.left + to * area.width(), area.bottom};
        const ImU32 first = ink(map.at(upright ? to : from));
        const ImU32 last = ink(map.at(upright ? from : to));
        list_.AddRectFilledMultiColor(point({part.left, part.top}), point({part.right, part.bottom}), first,
                                      upright ? first : last, last, upright ? last : first);
    }
}

void ScreenPen::triangle(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector3d& color) {
    list_.AddTriangleFilled(point(a), point(b), point(c), ink(color));
}

void ScreenPen::line(const Vector2d& from, const Vector2d& to, double thickness, const Vector3d& color,
                     double opacity) {
    list_.AddLine(point(from), point(to), ink(color, opacity), static_cast<float>(thickness));
}

void ScreenPen::curve(const std::vector<Vector2d>& points, double thickness, const Vector3d& color) {
    std::vector<ImVec2> path;
    path.reserve(points.size());
    for (const Vector2d& p : points) {
        path.push_back(point(p));
    }
    list_.AddPolyline(path.data(), static_cast<int>(path.size()), ink(color), 0, static_cast<float>(thickness));
}

void ScreenPen::dot(const Vector2d& at, double radius, const Vector3d& color) {
    list_.AddCircleFilled(point(at), static_cast<float>(radius), ink(color));
}

} // namespace tumble::render
