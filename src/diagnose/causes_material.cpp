#include "diagnose/cause_families.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tumble::diagnose {

using scene::Scene;

namespace {

bool is_of_walls(const Scene& scene, std::size_t material) {
    return std::any_of(scene.walls.begin(), scene.walls.end(),
                       [material](const scene::Wall& wall) { return wall.material == static_cast<int>(material); });
}

bool is_of_bodies(const Scene& scene, int material) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                       [material](const scene::BodyTemplate& body) { return body.material == material; });
}

/// A twin of every material that walls share with bodies, for the walls.
void give_walls_their_own(Scene& scene) {
    const std::size_t before = scene.materials.size();
    std::vector<std::size_t> like(before); // of each material after, the one before
    std::iota(like.begin(), like.end(), std::size_t{0});
    for (std::size_t m = 0; m < before; ++m)
        if (is_of_walls(scene, m) && is_of_bodies(scene, static_cast<int>(m))) {
            for (scene::Wall& wall : scene.walls)
                if (wall.material == static_cast<int>(m))
                    wall.material = static_cast<int>(scene.materials.size());
            scene.materials.push_back(scene.materials[m]);
            scene.materials.back().name += "_of_walls";
            like.push_back(m);
        }
    std::vector<contact::PairProperties> pairs;
    for (const std::size_t a : like)
        for (const std::size_t b : like)
            pairs.push_back(scene.pairs[a * before + b]);
    scene.pairs = std::move(pairs);
}

constexpr double step_of_sticking = 0.2; // of a step without: what sticks is damped critically

void stick(Scene& scene, double square) {
    if (square == 0)
        return;
    for (contact::PairProperties& pair : scene.pairs)
        if (pair.restitution > 0)
            pair.sticking_speed = std::sqrt(pair.sticking_speed * pair.sticking_speed + square);
    const bool alone = !scene.bodies_can_meet() && scene.bodies[0].spheres.size() == 1;
    scene.time_step *= alone ? 1 : step_of_sticking;
}

} // namespace

std::vector<Cause> of_the_contact() {
    return {
        {.id = "rest.velocity",
         .family = "restitution",
         .symbol = "p",
         .lo = 0,
         .hi = 0.4,
         .typical = 0.01,
         .name = "restitution that falls with the speed of impact",
         .look = "zero in the first fall; slopes jump at impacts; ln e against ln v is straight with slope -p, "
                 "whatever the "
                 "mass",
         .keys = "pair.*.restitution_exponent, with restitution_speed_m_s 1 where the scene has none",
         .extend =
             [](Scene& s, double d) {
                 for (contact::PairProperties& pair : s.pairs)
                     if (pair.restitution > 0) {
                         pair.restitution_exponent += d;
                         if (pair.restitution_speed == 0)
                             pair.restitution_speed = 1;
                     }
             }},
        {.id = "rest.cutoff",
         .family = "restitution",
         .symbol = "v_stick^2",
         .unit = "m2/s2",
         .lo = 0,
         .hi = 1,
         .typical = 1e-3,
         .in_beds = 0.01,
         .name = "surfaces that stick: slow impacts do not come back",
         .look = "zero in the first fall; every impact loses the same energy besides, so the slow ones lose the most, "
                 "and below v_stick all; whatever the mass",
         .keys = "pair.*.sticking_speed_m_s; time_step_s of many contacts a fifth, as critical dashpots bear it",
         .extend = stick},
        {.id = "rest.factor",
         .family = "restitution",
         .symbol = "ln(e factor)",
         .lo = -1.5,
         .hi = 0.4,
         .typical = 0.02,
         .beds = true,
         .name = "restitution that differs from the scene's",
         .look = "a shaken bed expands more or less; little in a dense one",
         .keys = "pair.*.restitution, times a factor, at most 1",
         .extend =
             [](Scene& s, double d) {
                 for (contact::PairProperties& pair : s.pairs)
                     pair.restitution = std::min(1.0, pair.restitution * std::exp(d));
             }},
    };
}

std::vector<Cause> of_cohesion() {
    return {
        {.id = "cohesion.work",
         .family = "cohesion",
         .symbol = "work of adhesion",
         .unit = "J/m2",
         .lo = 0,
         .hi = 100,
         .typical = 0.01,
         .in_beds = 0.2,
         .name = "surfaces that stick to each other",
         .look = "slow impacts lose more than fast ones; lifts off late; presses on without weight",
         .keys = "pair.*.work_of_adhesion_J_m2, with contact.adhesion \"dmt\" where the scene has none",
         .extend =
             [](Scene& s, double d) {
                 if (s.contact.additions.adhesion == contact::AdhesionLaw::none)
                     s.contact.additions.adhesion = contact::AdhesionLaw::dmt;
                 for (contact::PairProperties& pair : s.pairs)
                     pair.work_of_adhesion += d;
             }},
    };
}

std::vector<Cause> of_the_friction() {
    return {
        {.id = "roll.coulomb",
         .family = "rolling resistance",
         .symbol = "mu_r",
         .lo = 0,
         .hi = 0.3,
         .typical = 1e-3,
         .in_beds = 0.2,
         .name = "rolling resistance of constant torque",
         .look = "rolling slows down evenly and stops sharply; on an incline a = 5/7 g (sin - mu_r cos)",
         .keys = "pair.*.rolling_friction, with contact.rolling \"cdt\" where the scene has none",
         .extend =
             [](Scene& s, double d) {
                 if (s.contact.additions.rolling == contact::RollingLaw::none)
                     s.contact.additions.rolling = contact::RollingLaw::cdt;
                 for (contact::PairProperties& pair : s.pairs)
                     pair.rolling_friction += d;
             }},
        {.id = "roll.viscous",
         .family = "rolling resistance",
         .symbol = "tau",
         .unit = "s",
         .lo = 0,
         .hi = 0.1,
         .typical = 1e-4,
         .in_beds = 0.02,
         .name = "rolling resistance that grows with speed",
         .look = "rolling dies away as an exponential and never stops sharply; only what spins feels it, where drag in "
                 "proportion to speed acts on what slides as well",
         .keys = "pair.*.rolling_time_s",
         .extend =
             [](Scene& s, double d) {
                 for (contact::PairProperties& pair : s.pairs)
                     pair.rolling_time += d;
             }},
        {.id = "fric.factor",
         .family = "friction",
         .symbol = "ln(mu factor)",
         .lo = -3,
         .hi = 1.5,
         .typical = 0.05,
         .name = "friction that differs from the scene's",
         .look = "only while something slides; nothing once it rolls or sticks",
         .keys = "pair.*.friction, times a factor",
         .extend =
             [](Scene& s, double d) {
                 for (contact::PairProperties& pair : s.pairs)
                     pair.friction *= std::exp(d);
             }},
        {.id = "fric.weakening",
         .family = "friction",
         .symbol = "share lost",
         .lo = 0,
         .hi = 1,
         .typical = 0.05,
         .name = "friction that falls in fast sliding",
         .look = "acceleration on an incline grows with speed; stopping takes more than v^2",
         .keys = "pair.*.sliding_friction, with sliding_speed_m_s 0.1 where the scene has none",
         .extend =
             [](Scene& s, double d) {
                 for (contact::PairProperties& pair : s.pairs) {
                     if (pair.sliding_speed == 0) {
                         pair.sliding_speed = 0.1;
                         pair.sliding_friction = pair.friction;
                     }
                     pair.sliding_friction *= 1 - d;
                 }
             }},
        {.id = "fric.wall",
         .family = "friction",
         .symbol = "ln(mu factor)",
         .lo = -3,
         .hi = 1.5,
         .typical = 0.05,
         .beds = true,
         .name = "friction of the walls that differs from the scene's",
         .look = "within three diameters of a wall; none once walls are rougher than bodies are to each other",
         .keys = "pair.*.friction of walls with bodies, times a factor; a material of both gets a twin for walls",
         .extend =
             [](Scene& s, double d) {
                 give_walls_their_own(s);
                 for (std::size_t a = 0; a < s.materials.size(); ++a)
                     for (std::size_t b = 0; b < s.materials.size(); ++b)
                         if (is_of_walls(s, a) != is_of_walls(s, b))
                             s.pairs[a * s.materials.size() + b].friction *= std::exp(d);
             }},
    };
}

std::vector<Cause> of_the_simulation() {
    return {
        {.id = "mass.density",
         .family = "mass",
         .symbol = "ln(mass factor)",
         .lo = -1,
         .hi = 1,
         .typical = 0.05,
         .name = "bodies that are heavier or lighter than the scene's",
         .look = "none on a lone sphere in a vacuum; scales forces, and drag the other way",
         .keys = "material.*.density_kg_m3 and body.*.mass_kg, times a factor",
         .extend =
             [](Scene& s, double d) {
                 for (contact::Material& material : s.materials)
                     material.density *= std::exp(d);
                 for (scene::BodyTemplate& body : s.bodies) {
                     if (body.mass)
                         *body.mass *= std::exp(d);
                     if (body.principal_inertia)
                         *body.principal_inertia *= std::exp(d);
                 }
             }},
        {.id = "num.stiffness",
         .family = "numerics",
         .symbol = "ln(E factor)",
         .lo = -4,
         .hi = 3,
         .typical = 0.1,
         .name = "contacts that are softer or harder than the scene's",
         .look = "every impact comes back early or late by the same time; shrinks when the modulus is raised",
         .keys = "material.*.youngs_modulus_Pa, times a factor",
         .extend =
             [](Scene& s, double d) {
                 for (contact::Material& material : s.materials)
                     material.youngs_modulus *= std::exp(d);
             }},
        {.id = "num.dt",
         .family = "numerics",
         .symbol = "share of dt too much",
         .lo = 0,
         .hi = 0.9,
         .typical = 0.5,
         .in_beds = 0.75,
         .beds = true,
         .name = "steps of time that are too long",
         .look = "the residual shrinks when time_step_s is halved: the simulation is wrong, not the scene",
         .keys = "time_step_s, of box2d as well, times 1 - share",
         .extend =
             [](Scene& s, double d) {
                 s.time_step *= 1 - d;
                 s.box2d.time_step *= 1 - d;
             }},
    };
}

} // namespace tumble::diagnose
