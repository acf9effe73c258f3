#include "diagnose/cause_families.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tumble::diagnose {

using scene::Scene;

namespace {

/// The same shape, so much larger, of the same density; discs keep their depth.
scene::BodyTemplate scaled(scene::BodyTemplate body, double factor, int dimension) {
    const double heavier = std::pow(factor, dimension);
    for (scene::Sphere& sphere : body.spheres) {
        sphere.centre *= factor;
        sphere.radius *= factor;
    }
    if (body.mass)
        *body.mass *= heavier;
    if (body.principal_inertia)
        *body.principal_inertia *= heavier * factor * factor;
    if (body.tracer_point)
        *body.tracer_point *= factor;
    if (body.cone) {
        body.cone->diameter *= factor;
        body.cone->height *= factor;
    }
    return body;
}

/// A body that was placed, and two that cannot be parted in three, stay as they are: a sensor among the bodies does.
bool can_be_parted(const scene::Fill& fill) {
    return !fill.position && fill.count.value_or(3) >= 3;
}

/// Fills in thirds, of larger bodies, of middling and of smaller ones, so large that the volume of all stays; the large
/// ones come first, while there is most room. (-1, 0, 1) sqrt(3/2) has a standard deviation of 1.
void spread_sizes(Scene& scene, double deviation) {
    if (deviation == 0 || std::none_of(scene.fills.begin(), scene.fills.end(), can_be_parted))
        return;
    const double apart = std::sqrt(1.5) * deviation;
    double volumes = 0; // of three bodies whose mean size is 1
    for (const double size : {1 + apart, 1.0, 1 - apart})
        volumes += std::pow(size, scene.dimension);
    const double middle = std::pow(volumes / 3, -1.0 / scene.dimension), smallest = (1 - apart) * middle;
    const std::pair<double, const char*> sizes[] = {
        {(1 + apart) * middle, "_larger"}, {middle, "_middle"}, {smallest, "_smaller"}};
    std::map<std::pair<int, double>, int> known; // templates by what they are made of, and how large
    const auto of_size = [&](int body, double factor, const char* mark) {
        const auto [found, added] = known.try_emplace({body, factor}, static_cast<int>(scene.bodies.size()));
        if (added) {
            scene.bodies.push_back(scaled(scene.bodies[static_cast<std::size_t>(body)], factor, scene.dimension));
            scene.bodies.back().name += mark;
        }
        return found->second;
    };
    std::vector<scene::Fill> fills;
    for (const scene::Fill& fill : scene.fills) {
        if (!can_be_parted(fill)) {
            fills.push_back(fill);
            continue;
        }
        for (const auto& [factor, mark] : sizes) {
            scene::Fill part = fill;
            part.body = of_size(fill.body, factor, mark);
            if (fill.count) // what three do not divide is of the middle size
                part.count = factor == middle ? *fill.count - 2 * (*fill.count / 3) : *fill.count / 3;
            if (fill.mass)
                *part.mass *= std::pow(factor, scene.dimension) / 3;
            fills.push_back(std::move(part));
        }
    }
    scene.fills = std::move(fills);
    // The smallest bear the shortest steps: as their radius with springs of Hertz or of discs, as its power 3/2 with
    // linear ones.
    scene.time_step *= std::pow(smallest, scene.dimension / 2.0);
}

} // namespace

std::vector<Cause> of_the_load() {
    return {
        {.id = "load.fill",
         .family = "load",
         .symbol = "share",
         .lo = -0.5,
         .hi = 0.5,
         .typical = 0.02,
         .beds = true,
         .name = "a load that is more or less than the scene's",
         .look = "the surface stands higher or lower; forces and energies scale with it",
         .keys = "fill.count or fill.mass_kg, times 1 + share",
         .extend =
             [](Scene& s, double d) {
                 for (scene::Fill& fill : s.fills) {
                     if (fill.count)
                         fill.count =
                             std::max<std::int64_t>(1, std::llround(static_cast<double>(*fill.count) * (1 + d)));
                     if (fill.mass)
                         *fill.mass *= 1 + d;
                 }
             }},
        {.id = "size.poly",
         .family = "size",
         .symbol = "relative standard deviation",
         .lo = 0,
         .hi = 0.4,
         .typical = 0.02,
         .in_beds = 0.2,
         .beds = true,
         .name = "bodies that are not all of one size",
         .look =
             "packs denser and lies lower; the small ones sink through in time, and what has formed rows loses them",
         .keys =
             "body.* and fill.*: a third each larger, middling and smaller, of the same volume; time_step_s with the "
             "smallest",
         .extend = spread_sizes},
    };
}

} // namespace tumble::diagnose
