#include "fit/union_moments.h"

#include "base/disc_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>

namespace tumble::fit {

using Eigen::Vector3d;

namespace {

/// 1, x, y, z, xx, yy, zz, xy, yz, zx.
using Moments = Eigen::Matrix<double, 10, 1>;

class Slicer {
public:
    explicit Slicer(std::vector<Sphere> spheres) : spheres_(std::move(spheres)), overlapping_(spheres_.size()) {
        for (std::size_t i = 0; i < spheres_.size(); ++i)
            for (std::size_t j = 0; j < spheres_.size(); ++j)
                if (i != j &&
                    (spheres_[i].centre - spheres_[j].centre).norm() < spheres_[i].radius + spheres_[j].radius)
                    overlapping_[i].push_back(static_cast<int>(j));
    }

    /// Integrals over the plane at height y.
    Moments cut(double y) {
        ++slices;
        discs_.assign(spheres_.size(), {});
        for (std::size_t i = 0; i < spheres_.size(); ++i) {
            const Sphere& sphere = spheres_[i];
            const double square = sphere.radius * sphere.radius - (y - sphere.centre.y()) * (y - sphere.centre.y());
            discs_[i] = {sphere.centre.x(), sphere.centre.z(), square > 0 ? std::sqrt(square) : 0, static_cast<int>(i)};
        }
        AreaMoments sums{};
        for (std::size_t i = 0; i < discs_.size(); ++i)
            if (discs_[i].radius > 0 && outline(i))
                cover_.free_arcs([&](double from, double to) { add_arc(discs_[i], from, to, sums); });
        const auto [area, x, z, xx, zz, xz] = sums;
        Moments moments;
        moments << area, x, y * area, z, xx, y * y * area, zz, x * y, y * z, xz;
        return moments;
    }

    int slices = 0;

private:
    bool outline(std::size_t i) {
        cover_.clear();
        for (const int j : overlapping_[i])
            if (discs_[static_cast<std::size_t>(j)].radius > 0 &&
                !hide_inside(discs_[i], discs_[static_cast<std::size_t>(j)], cover_))
                return false;
        return true;
    }

    std::vector<Sphere> spheres_;
    std::vector<std::vector<int>> overlapping_;
    std::vector<UnionDisc> discs_;
    AngleCover cover_;
};

struct Piece {
    double from = 0;
    double to = 0;
    Moments sum = Moments::Zero();
    double error = 0;
    bool operator<(const Piece& other) const { return error < other.error; }
};

/// Gauss-Kronrod (7, 15): nodes and weights as QUADPACK (Piessens et al. 1983) tabulates them.
Piece integrate(Slicer& slicer, double from, double to, const Moments& scale) {
    static constexpr std::array<double, 8> node{
        0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
        0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
        0.586087235467691130294144432846773, 0.405845151377397166906606412076961,
        0.207784955007898467600689403773245, 0.0};
    static constexpr std::array<double, 8> kronrod{
        0.022935322010529224963732008058970, 0.063092092629978553290700663189204, 0.104790010322250183839876322541518,
        0.140653259715525918745189590510238, 0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
        0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
    static constexpr std::array<double, 4> gauss{
        0.129484966168869693270611432679082, 0.279705391489276667901467771423780, 0.381830050505118944950369775488975,
        0.417959183673469387755102040816327};
    const double middle = (from + to) / 2, half = (to - from) / 2;
    Moments fine = Moments::Zero(), coarse = Moments::Zero();
    for (std::size_t i = 0; i < node.size(); ++i) {
        Moments value = slicer.cut(middle + half * node[i]);
        if (i + 1 < node.size())
            value += slicer.cut(middle - half * node[i]);
        fine += kronrod[i] * value;
        if (i % 2 == 1)
            coarse += gauss[i / 2] * value;
    }
    const double error = ((fine - coarse) * half).cwiseQuotient(scale).cwiseAbs().maxCoeff();
    return {from, to, fine * half, error};
}

std::vector<Sphere> without_contained(const std::vector<Sphere>& spheres) {
    std::vector<Sphere> kept;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        bool contained = false;
        for (std::size_t j = 0; j < spheres.size() && !contained; ++j) {
            const double slack = spheres[j].radius - spheres[i].radius;
            const double apart = (spheres[j].centre - spheres[i].centre).norm();
            contained = i != j && apart <= slack && (slack > 0 || j < i);
        }
        if (!contained)
            kept.push_back(spheres[i]);
    }
    return kept;
}

UnionMoments one_sphere(const Sphere& sphere) {
    UnionMoments result;
    const double r2 = sphere.radius * sphere.radius;
    result.volume = 4.0 / 3 * std::numbers::pi * r2 * sphere.radius;
    result.centre = sphere.centre;
    result.second = Eigen::Matrix3d::Identity() * (result.volume * r2 / 5);
    return result;
}

} // namespace

UnionMoments union_moments(const std::vector<Sphere>& spheres, double tolerance) {
    std::vector<Sphere> kept = without_contained(spheres);
    if (kept.size() == 1)
        return one_sphere(kept.front());

    Vector3d lo = Vector3d::Constant(1e300), hi = -lo;
    double largest = 0;
    for (const Sphere& sphere : kept) {
        lo = lo.cwiseMin(sphere.centre - Vector3d::Constant(sphere.radius));
        hi = hi.cwiseMax(sphere.centre + Vector3d::Constant(sphere.radius));
        largest = std::max(largest, sphere.radius);
    }
    const Vector3d origin = (lo + hi) / 2;
    std::vector<double> heights;
    for (Sphere& sphere : kept) {
        sphere.centre -= origin;
        heights.push_back(sphere.centre.y() - sphere.radius);
        heights.push_back(sphere.centre.y() + sphere.radius);
    }
    std::sort(heights.begin(), heights.end());

    // The largest sphere is a lower bound of the volume and its moment, so errors are never taken too lightly.
    const double v = 4.0 / 3 * std::numbers::pi * largest * largest * largest;
    Moments scale;
    scale << v, Vector3d::Constant(v * largest), Eigen::Matrix<double, 6, 1>::Constant(v * largest * largest / 5);

    Slicer slicer(kept);
    std::priority_queue<Piece> pieces;
    double error = 0;
    const double shortest = 1e-12 * (heights.back() - heights.front());
    constexpr int most_slices = 200'000;
    const auto push = [&](double from, double to) {
        Piece piece = integrate(slicer, from, to, scale);
        error += piece.error;
        pieces.push(std::move(piece));
    };
    for (std::size_t i = 1; i < heights.size(); ++i)
        if (heights[i] - heights[i - 1] > shortest)
            push(heights[i - 1], heights[i]);
    while (error > tolerance && slicer.slices < most_slices) {
        const Piece worst = pieces.top();
        pieces.pop();
        error -= worst.error;
        push(worst.from, (worst.from + worst.to) / 2);
        push((worst.from + worst.to) / 2, worst.to);
    }

    Moments sum = Moments::Zero();
    for (; !pieces.empty(); pieces.pop())
        sum += pieces.top().sum;
    UnionMoments result;
    result.volume = sum[0];
    const Vector3d centre = sum.segment<3>(1) / sum[0];
    result.second << sum[4], sum[7], sum[9], sum[7], sum[5], sum[8], sum[9], sum[8], sum[6];
    result.second -= result.volume * centre * centre.transpose();
    result.centre = origin + centre;
    result.error = error;
    result.slices = slicer.slices;
    return result;
}

} // namespace tumble::fit
