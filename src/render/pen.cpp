#include "render/pen.h"

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

ImFont* Pen::font(Lettering lettering) const {
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

double Pen::height(Lettering lettering) const {
    return font(lettering)->FontSize;
}

std::string Pen::writable(const std::string& text) const {
    if (fonts_.complete) {
        return text;
    }
    constexpr std::array<std::pair<const char*, const char*>, 13> plain{{{"\u2212", "-"},
                                                                         {"\u2248", "~"},
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

double Pen::width(const std::string& text, Lettering lettering) const {
    ImFont* f = font(lettering);
    return f->CalcTextSizeA(f->FontSize, 1e9F, 0, writable(text).c_str()).x;
}

std::string Pen::shortened(const std::string& text, Lettering lettering, double room) const {
    if (width(text, lettering) <= room) {
        return text;
    }
    std::string part = text;
    while (!part.empty()) {
        // A letter may take several bytes; those after the first begin with the bits 10.
        while ((static_cast<unsigned char>(part.back()) & 0xc0) == 0x80 && part.size() > 1) {
            part.pop_back();
        }
        part.pop_back();
        while (!part.empty() && part.back() == ' ') {
            part.pop_back();
        }
        if (width(part + "...", lettering) <= room) {
            return part + "...";
        }
    }
    return {};
}

void Pen::text(double x, double y, const std::string& words, Lettering lettering, Align align, const Vector3d& color) {
    const std::string letters = writable(words);
    const double long_ = width(words, lettering);
    const double left = align == Align::left ? x : align == Align::middle ? x - 0.5 * long_ : x - long_;
    ImFont* f = font(lettering);
    // Whole pixels keep the letters crisp.
    list_.AddText(f, f->FontSize, point({std::round(left), std::round(y)}), ink(color), letters.c_str());
}

void Pen::rectangle(const Area& area, const Vector3d& color, double opacity) {
    list_.AddRectFilled(point({area.left, area.top}), point({area.right, area.bottom}), ink(color, opacity));
}

void Pen::shade(const Area& area, const Vector3d& left_top, const Vector3d& right_bottom, bool upright) {
    const ImU32 first = ink(left_top);
    const ImU32 last = ink(right_bottom);
    list_.AddRectFilledMultiColor(point({area.left, area.top}), point({area.right, area.bottom}), first,
                                  upright ? first : last, last, upright ? last : first);
}

void Pen::triangle(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector3d& color) {
    list_.AddTriangleFilled(point(a), point(b), point(c), ink(color));
}

void Pen::line(const Vector2d& from, const Vector2d& to, double thickness, const Vector3d& color, double opacity) {
    list_.AddLine(point(from), point(to), ink(color, opacity), static_cast<float>(thickness));
}

void Pen::curve(const std::vector<Vector2d>& points, double thickness, const Vector3d& color) {
    std::vector<ImVec2> path;
    path.reserve(points.size());
    for (const Vector2d& p : points) {
        path.push_back(point(p));
    }
    list_.AddPolyline(path.data(), static_cast<int>(path.size()), ink(color), 0, static_cast<float>(thickness));
}

void Pen::dot(const Vector2d& at, double radius, const Vector3d& color) {
    list_.AddCircleFilled(point(at), static_cast<float>(radius), ink(color));
}

} // namespace tumble::render
