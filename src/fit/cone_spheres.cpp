#include "fit/spheres.h"
#include "fit/union_moments.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

namespace tumble::fit {

namespace {

using Eigen::Vector3d;

/// Where the spheres of a radius stand that touch the cone from inside in as many places as they can.
struct MedialAxis {
    double base_radius, height;
    double inscribed;   // m, radius of the sphere that touches base and mantle all round
    double sine;        // of half the tip's angle
    double half_corner; // tangent of half the angle between base and mantle

    explicit MedialAxis(const Cone& cone) : base_radius(cone.diameter / 2), height(cone.height) {
        const double mantle = std::hypot(base_radius, height);
        inscribed = base_radius * height / (base_radius + mantle);
        sine = base_radius / mantle;
        half_corner = inscribed / base_radius;
    }
    [[nodiscard]] double height_at(double radius) const { return height - radius / sine; }
    [[nodiscard]] double distance_at(double radius) const { return base_radius - radius / half_corner; }
};

/// Numbers in proportion to the shares that add up to `all`, each at least 3; the largest remainders get what is left.
std::vector<int> divided(int all, const std::vector<double>& shares) {
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    std::vector<int> parts;
    for (const double share : shares)
        parts.push_back(std::max(3, static_cast<int>(all * share / sum)));
    for (int left = all - std::accumulate(parts.begin(), parts.end(), 0); left != 0; left += left > 0 ? -1 : 1) {
        std::size_t best = 0;
        const int way = left > 0 ? 1 : -1;
        for (std::size_t i = 1; i < parts.size(); ++i)
            if (way * (all * shares[i] / sum - parts[i]) > way * (all * shares[best] / sum - parts[best]))
                best = i;
        parts[best] += way;
    }
    return parts;
}

struct Arrangement {
    int rings = 0;
    int on_axis = 0;
};

/// All that leave each ring its three spheres.
std::vector<Arrangement> arrangements_of(int spheres) {
    std::vector<Arrangement> all;
    for (int rings = 1; rings <= 6; ++rings)
        for (int on_axis = 2; on_axis <= 8 && spheres - on_axis >= 3 * rings; ++on_axis)
            all.push_back({rings, on_axis});
    return all;
}

/// Rings each turned by half a pitch against the one before, and the rest on the axis.
std::vector<Sphere> arranged(const MedialAxis& axis, const Arrangement& so, const Wanted& wanted) {
    const auto [rings, on_axis] = so;
    std::vector<Sphere> spheres;
    const double fall = wanted.smallest / axis.inscribed;
    for (int i = 0; i < on_axis; ++i) {
        const double radius = axis.inscribed * std::pow(fall, static_cast<double>(i) / (on_axis - 1));
        spheres.push_back({{0, axis.height_at(radius), 0}, radius});
    }
    std::vector<double> radii, shares;
    for (int k = 1; k <= rings; ++k) {
        radii.push_back(axis.inscribed * std::pow(fall, static_cast<double>(k) / rings));
        shares.push_back(axis.distance_at(radii.back()) / radii.back());
    }
    const std::vector<int> counts = divided(wanted.spheres - on_axis, shares);
    for (std::size_t k = 0; k < radii.size(); ++k)
        for (int i = 0; i < counts[k]; ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.5 * static_cast<double>(k % 2)) / counts[k];
            const double out = axis.distance_at(radii[k]);
            spheres.push_back({{out * std::cos(angle), radii[k], out * std::sin(angle)}, radii[k]});
        }
    return spheres;
}

} // namespace

Result<std::vector<Sphere>> spheres_in(const Cone& cone, const Wanted& wanted, const Tally& tally) {
    const MedialAxis axis(cone);
    if (wanted.spheres < fewest_in_a_cone)
        return Problem{.what = fmt::format("{} spheres are too few for a cone", wanted.spheres),
                       .fix = fmt::format("take {} at least: an axis and a ring", fewest_in_a_cone)};
    if (!(wanted.smallest > 0 && wanted.smallest < axis.inscribed))
        return Problem{.what = fmt::format("the smallest sphere, {:.4g} mm, is not smaller than the largest that fits, "
                                           "{:.4g} mm",
                                           1e3 * wanted.smallest, 1e3 * axis.inscribed),
                       .fix = fmt::format("give --smallest below that and above 0; a quarter of it, {:.4g} mm, leaves "
                                          "room for rings",
                                          1e3 * axis.inscribed / 4)};
    std::vector<Sphere> fullest;
    double most = 0;
    const std::vector<Arrangement> arrangements = arrangements_of(wanted.spheres);
    for (std::size_t k = 0; k < arrangements.size(); ++k) {
        std::vector<Sphere> tried = arranged(axis, arrangements[k], wanted);
        const double volume = union_moments(tried, 1e-4).volume;
        if (volume > most) {
            most = volume;
            fullest = std::move(tried);
        }
        tell_tally(tally, "arrangements tried", static_cast<std::int64_t>(k) + 1,
                   static_cast<std::int64_t>(arrangements.size()));
    }
    return fullest;
}

} // namespace tumble::fit
