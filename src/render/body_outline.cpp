#include "render/body_outline.h"

#include "base/disc_union.h"

#include <algorithm>
#include <cstddef>

namespace tumble::render {

/// What is seen of each circle. An arc that goes on through the angle 0 is one.
static std::vector<Arc> free_arcs(const std::vector<Arc>& discs) {
    std::vector<UnionDisc> all;
    for (const Arc& disc : discs) {
        all.push_back({disc.centre.x(), disc.centre.y(), disc.radius, static_cast<int>(all.size())});
    }
    std::vector<Arc> arcs;
    AngleCover cover;
    for (const UnionDisc& disc : all) {
        cover.clear();
        const bool seen = std::all_of(all.begin(), all.end(), [&](const UnionDisc& other) {
            return other.number == disc.number || hide_inside(disc, other, cover);
        });
        if (!seen) {
            continue;
        }
        const std::size_t first = arcs.size();
        cover.free_arcs([&](double from, double to) {
            arcs.push_back({{disc.x, disc.y}, disc.radius, from, to - from});
        });
        constexpr double turn = 2 * EIGEN_PI;
        if (arcs.size() > first + 1 && arcs[first].from == 0 && arcs.back().from + arcs.back().sweep == turn) {
            arcs[first].sweep += arcs.back().sweep;
            arcs[first].from = arcs.back().from - turn;
            arcs.pop_back();
        }
    }
    return arcs;
}

std::vector<std::vector<Arc>> outline_of(const std::vector<Arc>& discs) {
    std::vector<Arc> left = free_arcs(discs);
    std::vector<std::vector<Arc>> loops;
    while (!left.empty()) {
        std::vector<Arc>& loop = loops.emplace_back(std::vector<Arc>{left.back()});
        left.pop_back();
        const Eigen::Vector2d begin = loop.front().at(loop.front().from);
        // Arcs meet where circles cross, up to rounding: what begins nearest goes on, unless the loop's begin is
        // nearer.
        while (!left.empty()) {
            const Eigen::Vector2d end = loop.back().at(loop.back().from + loop.back().sweep);
            const auto away = [&](const Arc& arc) { return (arc.at(arc.from) - end).norm(); };
            const auto next = std::min_element(left.begin(), left.end(),
                                               [&](const Arc& a, const Arc& b) { return away(a) < away(b); });
            if ((begin - end).norm() <= away(*next)) {
                break;
            }
            loop.push_back(*next);
            left.erase(next);
        }
    }
    return loops;
}

} // namespace tumble::render
