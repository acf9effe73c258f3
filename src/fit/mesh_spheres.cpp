#include "base/parallel_for.h"
#include "fit/spheres.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <queue>

namespace tumble::fit {

namespace {

using Eigen::Vector3d;

constexpr int points_along = 40;

/// The points of a cubic grid around the solid; how deep each lies in it, and whether a chosen sphere holds it.
class Grid {
public:
    Grid(const Solid& solid, Crew& crew, StopFlag stop, const Tally& tally) {
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
        depth_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]));
        free_.assign(depth_.size(), 0);
        const Depths depths(solid);
        for (int layer = 0; layer < count_[2]; ++layer) {
            crew.share(count_[1], [&](int row) {
                if (!stop_wanted(stop))
                    find_distances(depths, layer * count_[1] + row);
            });
            tell_tally(tally, "layers of the grid measured", layer + 1, count_[2]);
        }
        find_insides(depths, stop, tally);
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
        visit(i, depth(i), [&](std::size_t held) { sum += free_[held]; });
        return sum;
    }
    void take(int i) {
        visit(i, depth(i), [&](std::size_t held) { free_[held] = 0; });
    }

private:
    [[nodiscard]] Vector3d place(int x, int y, int z) const { return first_ + pitch_ * Vector3d(x, y, z); }

    /// Without their signs. From one point of the row to the next they change by no more than the pitch.
    void find_distances(const Depths& depths, int row) {
        double bound = std::numeric_limits<double>::infinity();
        for (int x = 0; x < count_[0]; ++x) {
            const int i = row * count_[0] + x;
            const double distance = std::sqrt(depths.distance2(place(i), bound));
            depth_[static_cast<std::size_t>(i)] = distance;
            bound = std::pow(1.0001 * (distance + pitch_), 2);
        }
    }

    /// Gives those outside a minus. No surface comes nearer to a point than its distance, so all points nearer than
    /// that lie on its side: few have to be asked.
    void find_insides(const Depths& depths, StopFlag stop, const Tally& tally) {
        std::vector<int> farthest_first(depth_.size());
        std::iota(farthest_first.begin(), farthest_first.end(), 0);
        std::stable_sort(farthest_first.begin(), farthest_first.end(),
                         [&](int a, int b) { return depth(a) > depth(b); });
        std::vector<char> sign(depth_.size(), 0);
        std::int64_t seen = 0;
        for (const int i : farthest_first) {
            if (stop_wanted(stop))
                return;
            tell_tally(tally, "points of the grid told inside from outside", ++seen, points());
            if (sign[static_cast<std::size_t>(i)] != 0)
                continue;
            const char side = depths.inside(place(i)) ? 1 : -1;
            sign[static_cast<std::size_t>(i)] = side;
            visit(i, 0.9999 * depth(i), [&](std::size_t near) { sign[near] = side; });
        }
        for (std::size_t i = 0; i < depth_.size(); ++i)
            depth_[i] *= sign[i];
    }

    /// Calls action(index) for the points nearer to point i than `distance`, m.
    template <class Action> void visit(int i, double distance, Action action) {
        const double radius = distance / pitch_;
        const int reach = static_cast<int>(radius);
        const int x = i % count_[0], y = i / count_[0] % count_[1], z = i / (count_[0] * count_[1]);
        for (int c = std::max(0, z - reach); c <= std::min(count_[2] - 1, z + reach); ++c)
            for (int b = std::max(0, y - reach); b <= std::min(count_[1] - 1, y + reach); ++b)
                for (int a = std::max(0, x - reach); a <= std::min(count_[0] - 1, x + reach); ++a)
                    if ((a - x) * (a - x) + (b - y) * (b - y) + (c - z) * (c - z) < radius * radius)
                        action(static_cast<std::size_t>((c * count_[1] + b) * count_[0] + a));
    }

    std::array<int, 3> count_{};
    double pitch_ = 0; // m
    Vector3d first_;
    std::vector<double> depth_; // m
    std::vector<char> free_;
};

} // namespace

Result<std::vector<Sphere>> spheres_in(const Solid& solid, const Wanted& wanted, int threads, StopFlag stop,
                                       const Tally& tally) {
    Crew crew(threads);
    Grid grid(solid, crew, stop, tally);
    // A sphere's gain can only fall as others are chosen, so that an old gain is a bound: only those at the top of the
    // queue are counted anew. At equal gains the earlier point wins.
    using Entry = std::pair<int, int>; // gain, -point
    std::priority_queue<Entry> queue;
    for (int i = 0; i < grid.points() && !stop_wanted(stop); ++i) {
        if (grid.depth(i) >= wanted.smallest && grid.depth(i) > 0)
            queue.emplace(grid.gain(i), -i);
        tell_tally(tally, "points of the grid tried", i + 1, grid.points());
    }
    if (stop_wanted(stop))
        return Problem{.what = "stopped before the spheres were found"};
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
        tell_tally(tally, "spheres chosen", static_cast<std::int64_t>(chosen.size()), wanted.spheres);
    }
    return chosen;
}

} // namespace tumble::fit
