#include "diagnose/cause_families.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace tumble::diagnose {

using scene::Scene;

namespace {

constexpr double step_of_twins = 0.5; // of a step of one sphere: both may touch the same wall at once

/// Volume of two equal spheres, or area of two discs, whose centres are `longer` diameters apart, over that of one.
double of_twins(double longer, int dimension) {
    if (dimension == 2)
        return 2 - 2 / std::numbers::pi * (std::acos(longer) - longer * std::sqrt(1 - longer * longer));
    return 1 + 1.5 * longer - 0.5 * longer * longer * longer;
}

/// Two spheres in place of one, of the same volume and mass, `longer` diameters longer than thick.
void lengthen(scene::BodyTemplate& body, double longer, int dimension) {
    scene::Sphere& first = body.spheres[0];
    first.radius *= std::pow(of_twins(longer, dimension), -1.0 / dimension);
    const double apart = longer * first.radius;
    scene::Sphere twin = first;
    first.centre.x() -= apart;
    twin.centre.x() += apart;
    body.spheres.push_back(twin);
    body.principal_inertia.reset(); // it was a sphere's
}

/// Bodies of one sphere that were poured; those that were placed stay as they are: a sensor among the bodies does.
void lengthen_bodies(Scene& scene, double longer) {
    if (longer == 0)
        return;
    std::vector<bool> placed(scene.bodies.size(), false);
    for (const scene::Fill& fill : scene.fills)
        if (fill.position)
            placed[static_cast<std::size_t>(fill.body)] = true;
    double thinnest = 1;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k)
        if (scene.bodies[k].spheres.size() == 1 && !placed[k]) {
            const double before = scene.bodies[k].spheres[0].radius;
            lengthen(scene.bodies[k], longer, scene.dimension);
            thinnest = std::min(thinnest, scene.bodies[k].spheres[0].radius / before);
        }
    if (thinnest < 1)
        scene.time_step *= step_of_twins * thinnest;
}

/// Ribs of bowls and their discs; where there were none, as many as usual.
void raise_ribs(Scene& scene, double height) {
    if (height == 0)
        return;
    const auto raise = [height](scene::Ribs& ribs) {
        ribs.height = ribs.count > 0 ? ribs.height + height : height;
        ribs.count = ribs.count > 0 ? ribs.count : 12;
    };
    for (scene::Wall& wall : scene.walls)
        if (auto* bowl = std::get_if<scene::BowlShape>(&wall.shape))
            raise(bowl->ribs);
        else if (auto* disc = std::get_if<scene::BowlDiscShape>(&wall.shape))
            raise(disc->ribs);
}

} // namespace

std::vector<Cause> of_the_shape() {
    return {
        {.id = "shape.clump",
         .family = "shape",
         .symbol = "length/thickness - 1",
         .lo = 0,
         .hi = 1,
         .typical = 0.05,
         .in_beds = 0.5,
         .beds = true,
         .name = "bodies that are longer than thick",
         .look = "stands steeper and packs otherwise; spins less; a body turns after a straight drop",
         .keys = "body.*: two spheres of the same volume in place of one; time_step_s half, and with their radius",
         .extend = lengthen_bodies},
        {.id = "shape.multicontact",
         .family = "shape",
         .symbol = "share",
         .lo = 0,
         .hi = 1,
         .typical = 0.1,
         .in_beds = 1,
         .beds = true,
         .name = "clumps whose contacts damp one impact several times",
         .look = "flat landings rebound higher than the simulation's, edges and tips alike; shaken clumps expand more",
         .keys = "contact.damping_shared; three dimensions, bodies of several spheres",
         .extend =
             [](Scene& s, double d) {
                 if (s.dimension == 3 && !s.contact.share_among_body_contacts)
                     s.contact.damping_shared = std::min(1.0, s.contact.damping_shared + d);
             }},
        {.id = "wall.ribs",
         .family = "wall geometry",
         .symbol = "height",
         .unit = "mm",
         .lo = 0,
         .hi = 10,
         .typical = 0.1,
         .beds = true,
         .name = "ribs of a bowl that stand higher than the scene's",
         .look = "within three diameters of the wall, which carries the bulk along; none once nothing slips there",
         .keys = "wall.rib_height_m of bowls and their discs, and rib_count 12 where there are none",
         .extend = [](Scene& s, double d) { raise_ribs(s, 1e-3 * d); }},
    };
}

} // namespace tumble::diagnose
