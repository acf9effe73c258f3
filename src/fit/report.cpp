#include "fit/report.h"

#include "base/table.h"
#include "base/text.h"
#include "fit/union_moments.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::fit {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int surface_samples = 20000;

Vector3d principal(const Matrix3d& second) {
    const Matrix3d inertia = second.trace() * Matrix3d::Identity() - second;
    return Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
}

/// Distance to the nearest sphere, m; where spheres hold the point, minus its depth in the one that holds it deepest.
double height_above(const std::vector<Sphere>& spheres, const Vector3d& point) {
    double least = std::numeric_limits<double>::infinity();
    for (const Sphere& sphere : spheres)
        least = std::min(least, (point - sphere.centre).norm() - sphere.radius);
    return least;
}

std::string percent(double is, double should) {
    const std::string text = fixed(100 * (is / should - 1), 2);
    return (text[0] == '-' ? "" : "+") + text + " %";
}

} // namespace

Report compare(const Solid& solid, const std::vector<Sphere>& spheres) {
    Report report;
    const UnionMoments moments = union_moments(spheres);
    report.solid_volume = solid.volume;
    report.union_volume = moments.volume;
    report.solid_centre = solid.centre;
    report.union_centre = moments.centre;
    report.solid_inertia = principal(solid.second);
    report.union_inertia = principal(moments.second);
    const std::vector<Vector3d> points = surface_points(solid, surface_samples);
    for (const Vector3d& point : points) {
        const double height = height_above(spheres, point);
        report.gap_mean += std::abs(height) / static_cast<double>(points.size());
        report.gap_max = std::max(report.gap_max, height);
    }
    const Depths depths(solid);
    report.smallest = report.largest = spheres.front().radius;
    for (const Sphere& sphere : spheres) {
        report.smallest = std::min(report.smallest, sphere.radius);
        report.largest = std::max(report.largest, sphere.radius);
        report.stands_out = std::max(report.stands_out, sphere.radius - depths.at(sphere.centre));
    }
    if (report.stands_out < 1e-9 * report.largest)
        report.stands_out = 0;
    return report;
}

double scale_to_volume(std::vector<Sphere>& spheres, double volume) {
    const double factor = std::cbrt(volume / union_moments(spheres).volume);
    for (Sphere& sphere : spheres) {
        sphere.centre *= factor;
        sphere.radius *= factor;
    }
    return factor;
}

double equivalent_radius(double volume) {
    return std::cbrt(3 * volume / (4 * std::numbers::pi));
}

std::vector<std::string> sentences(const Report& report, std::size_t spheres) {
    const auto mm = [](double metres) { return fmt::format("{:.4g} mm", 1e3 * metres); };
    std::vector<std::string> lines;
    lines.push_back(fmt::format("{} spheres, radius {} to {}", spheres, mm(report.smallest), mm(report.largest)));
    lines.push_back(fmt::format("volume {:.4f} mm3, the solid's {:.4f} mm3 ({})", 1e9 * report.union_volume,
                                1e9 * report.solid_volume, percent(report.union_volume, report.solid_volume)));
    lines.push_back(
        fmt::format("inertia of unit density {:.5g} {:.5g} {:.5g} mm5, the solid's {:.5g} {:.5g} {:.5g} mm5 "
                    "({}, {}, {})",
                    1e15 * report.union_inertia[0], 1e15 * report.union_inertia[1], 1e15 * report.union_inertia[2],
                    1e15 * report.solid_inertia[0], 1e15 * report.solid_inertia[1], 1e15 * report.solid_inertia[2],
                    percent(report.union_inertia[0], report.solid_inertia[0]),
                    percent(report.union_inertia[1], report.solid_inertia[1]),
                    percent(report.union_inertia[2], report.solid_inertia[2])));
    lines.push_back(fmt::format("centres of mass apart by {}", mm((report.union_centre - report.solid_centre).norm())));
    lines.push_back(fmt::format("surface off by {} on average, by {} at most; spheres stand out by {} at most",
                                mm(report.gap_mean), mm(report.gap_max), mm(report.stands_out)));
    lines.push_back(fmt::format("sphere of equal volume: radius {}", mm(equivalent_radius(report.union_volume))));
    return lines;
}

std::vector<std::string> advice(const Report& report) {
    constexpr double near = 0.01; // of the volume, and so of the mass
    if (std::abs(report.union_volume / report.solid_volume - 1) < near)
        return {};
    return {fmt::format("--volume {:.6g} gives the body the solid's volume, and so its mass: all lengths times {:.4f}",
                        1e9 * report.solid_volume, std::cbrt(report.solid_volume / report.union_volume)),
            "more --spheres come nearer in shape; what smallest radius serves best has to be tried (docs/bodies.md)"};
}

std::string clump_file(const std::vector<Sphere>& spheres, const Report& report,
                       const std::vector<std::string>& made_by) {
    std::string text;
    for (const auto& part : {made_by, sentences(report, spheres.size())})
        for (const std::string& line : part)
            text += "# " + line + "\n";
    text += "# Metres.\nx,y,z,radius\n";
    for (const Sphere& sphere : spheres)
        text += csv_line(std::array{sphere.centre.x(), sphere.centre.y(), sphere.centre.z(), sphere.radius});
    return text;
}

} // namespace tumble::fit
