#include "fit/spheres.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <queue>

namespace tumble::fit {

namespace {

using Eigen::Vector3d;

constexpr int points_along = 40;

/// The points of a cubic grid around the solid; how deep each lies in it, and whether a chosen sphere holds it.
class Grid {
public:
    explicit Grid(const Solid& solid) {
        Eigen::AlignedBox3d box;
        for (const Triangle& face : solid.faces)
            for (const Vector3d& corner : face)
                box.extend(corner);
        pitch_ = box.sizes().maxCoeff() / points_along;
        for (int k = 0; k < 3; ++k)
            count_[static_cast<std::size_t>(k)] = std::max(1, static_cast<int>(std::ceil(box.sizes()[k] / pitch_)));
        first_ = box.center();
        for (int k = 0; k < 3; ++k)
            first_[k] -= 0.5 * (count_[static_cast<std::size_t>(k)] - 1) * pitch_;
        for (int z = 0; z < count_[2]; ++z)
            for (int y = 0; y < count_[1]; ++y)
                for (int x = 0; x < count_[0]; ++x)
                    depth_.push_back(depth_in(solid, place(x, y, z)));
        free_.assign(depth_.size(), 1);
        for (std::size_t i = 0; i < depth_.size(); ++i)
            free_[i] = depth_[i] > 0 ? 1 : 0;
    }

    [[nodiscard]] int points() const { return static_cast<int>(depth_.size()); }
    [[nodiscard]] double depth(int i) const { return depth_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] Vector3d place(int i) const {
        return place(i % count_[0], i / count_[0] % count_[1], i / (count_[0] * count_[1]));
    }

    /// How many points that are still free the sphere about point i holds.
    int gain(int i) {
        int sum = 0;
        visit(i, [&](char& free) { sum += free; });
        return sum;
    }
    void take(int i) {
        visit(i, [](char& free) { free = 0; });
    }

private:
    [[nodiscard]] Vector3d place(int x, int y, int z) const { return first_ + pitch_ * Vector3d(x, y, z); }

    template <class Action> void visit(int i, Action action) {
        const double radius = depth(i) / pitch_;
        const int reach = static_cast<int>(radius);
        const int x = i % count_[0], y = i / count_[0] % count_[1], z = i / (count_[0] * count_[1]);
        for (int c = std::max(0, z - reach); c <= std::min(count_[2] - 1, z + reach); ++c)
            for (int b = std::max(0, y - reach); b <= std::min(count_[1] - 1, y + reach); ++b)
                for (int a = std::max(0, x - reach); a <= std::min(count_[0] - 1, x + reach); ++a)
                    if ((a - x) * (a - x) + (b - y) * (b - y) + (c - z) * (c - z) < radius * radius)
                        action(free_[static_cast<std::size_t>((c * count_[1] + b) * count_[0] + a)]);
    }

    std::array<int, 3> count_{};
    double pitch_ = 0; // m
    Vector3d first_;
    std::vector<double> depth_; // m
    std::vector<char> free_;
};

} // namespace

Result<std::vector<Sphere>> spheres_in(const Solid& solid, const Wanted& wanted) {
    Grid grid(solid);
    // A sphere's gain can only fall as others are chosen, so that an old gain is a bound: only those at the top of the
    // queue are counted anew. At equal gains the earlier point wins.
    using Entry = std::pair<int, int>; // gain, -point
    std::priority_queue<Entry> queue;
    for (int i = 0; i < grid.points(); ++i)
        if (grid.depth(i) >= wanted.smallest && grid.depth(i) > 0)
            queue.emplace(grid.gain(i), -i);
    if (static_cast<int>(queue.size()) < wanted.spheres)
        return Problem{.what = fmt::format("{} spheres of {:.4g} mm radius or more find {} places in the body",
                                           wanted.spheres, 1e3 * wanted.smallest, queue.size()),
                       .fix =
                           queue.empty()
                               ? "let them be smaller (--smallest), or look at the unit of the mesh (--scale)"
                               : fmt::format("ask for {} at most, or let them be smaller (--smallest)", queue.size())};
    std::vector<Sphere> chosen;
    while (static_cast<int>(chosen.size()) < wanted.spheres && !queue.empty()) {
        const auto [gain, negative] = queue.top();
        queue.pop();
        if (const int now = grid.gain(-negative); now < gain) {
            queue.emplace(now, negative);
            continue;
        }
        grid.take(-negative);
        chosen.push_back({grid.place(-negative), grid.depth(-negative)});
    }
    return chosen;
}

} // namespace tumble::fit
