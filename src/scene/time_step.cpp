#include "scene/time_step.h"

#include "contact/falling_restitution.h"
#include "contact/material.h"
#include "scene/motion.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace tumble::scene {

namespace {

constexpr double pi = std::numbers::pi;

/// Contacts that one body is taken to have at once, sharing one impact between them. docs/bodies.md
constexpr double contacts_at_once = 4;
/// Overlap beyond this share of the smaller radius is not asked to be stable: no law holds there, and a run says long
/// before that its overlaps are too large, though only at a whole radius it stops.
constexpr double overlap_most = 0.5;
/// Impacts are taken at least this fast, m/s: a scene at rest still is poured, pushed or stirred.
constexpr double speed_least = 0.1;

struct Contact {
    contact::PairConstants pair;
    bool rubs = false;               // tangential forces act
    double normal_stiffness = 0;     // N/m, of the linear law
    double tangential_stiffness = 0; // N/m
    double mass = 0;                 // kg, m* of the two bodies
    double radius = 0;               // m, R*
    double radius_small = 0;         // m
    double mobility = 0;             // 1/kg, of both sides together
    double turn_mobility = 0;        // 1/kg, what of it comes from turning the spheres about themselves
    std::string name;
};

Contact contact_of(const Scene& scene, const ContactSide& a, const ContactSide& b, double speed) {
    Contact contact;
    contact.pair = scene.constants(a.material, b.material);
    if (contact.pair.restitution_exponent > 0 && contact.pair.sticking_speed == 0) // what sticks is damped critically
        contact.pair.damping = contact::damping_at(speed, contact.pair);
    contact.rubs =
        scene.contact.tangential != TangentialLaw::none && (contact.pair.friction > 0 || contact.pair.cohesion > 0);
    contact.mass = 1 / (1 / a.mass + 1 / b.mass);
    contact.radius = 1 / (1 / a.radius + 1 / b.radius);
    contact.radius_small = std::min(a.radius, b.radius);
    contact.normal_stiffness = contact.pair.normal_stiffness + contact.pair.stiffness_per_mass * contact.mass;
    contact.tangential_stiffness =
        contact.pair.tangential_stiffness + contact.pair.stiffness_ratio * contact.normal_stiffness;
    contact.mobility = contact.rubs ? a.full_mobility + b.full_mobility : a.push_mobility + b.push_mobility;
    contact.turn_mobility = a.full_mobility - a.push_mobility + b.full_mobility - b.push_mobility;
    contact.name = fmt::format("{} on {} (R* = {:.3g} mm)", a.name, b.name, 1e3 * contact.radius);
    return contact;
}

/// Tangent stiffness of one contact, N/m: of Hertz at the overlap of an impact at `speed` that all contacts at once
/// share (Johnson 1985, 11.22, with as many times the stiffness), or the linear law's.
double stiffness_of(const Contact& contact, const ContactLaws& laws, double speed) {
    const double energy = 15 * contact.mass * speed * speed;
    const double hardness = 16 * contacts_at_once * contact.pair.E_eff * std::sqrt(contact.radius);
    const double overlap = std::min(overlap_most * contact.radius_small, std::pow(energy / hardness, 0.4));
    double reach = std::sqrt(contact.radius * overlap);
    // What sticks rests with a^3 = 9 pi w R*^2 / (2 E*) (JKR without load), less under DMT.
    if (contact.pair.adhesion == contact::AdhesionLaw::jkr || contact.pair.adhesion == contact::AdhesionLaw::dmt)
        reach = std::max(reach, std::cbrt(4.5 * pi * contact.pair.work_of_adhesion * contact.radius * contact.radius /
                                          contact.pair.E_eff));
    double stiffness = laws.normal == NormalLaw::linear ? contact.normal_stiffness : 2 * contact.pair.E_eff * reach;
    if (contact.rubs)
        stiffness = std::max(stiffness, laws.tangential == TangentialLaw::linear ? contact.tangential_stiffness
                                                                                 : 8 * contact.pair.G_eff * reach);
    return stiffness;
}

/// The stable step of leapfrog with damping from the half step before: with W = omega dt the amplification's roots
/// leave the unit circle at W^2 + 4 zeta W = 4, so dt < 2/omega (sqrt(1 + zeta^2) - zeta).
double stable_step(const Contact& contact, const ContactLaws& laws, double period) {
    const double hertz_factor = laws.normal == NormalLaw::linear ? 1.0 : std::sqrt(5.0 / 6);
    // A dashpot of damping_time times the spring is critical at 2 / omega.
    const double zeta =
        hertz_factor * contact.pair.damping * std::sqrt(contacts_at_once * contact.mass * contact.mobility) +
        contact.pair.damping_time * pi / period;
    return period / pi * (std::sqrt(1 + zeta * zeta) - zeta);
}

/// The same for EPSD's spring: k_r R*^-2 on bodies that turn about themselves, of which a sphere that rolls has 7/2 of
/// the inertia and a disc 3: taken for both as 7/2, which shortens a disc's step by less than 8 % of zeta.
double stable_step_of_rolling(const Contact& contact, double stiffness) {
    const double omega = std::sqrt(contact.pair.rolling_stiffness * stiffness * contact.turn_mobility);
    const double zeta = contact.pair.rolling_damping * std::sqrt(3.5 * contacts_at_once);
    return 2 / omega * (std::sqrt(1 + zeta * zeta) - zeta);
}

double height_along(const Vector3d& up, const Box& box, bool top) {
    double height = 0;
    for (int axis = 0; axis < 3; ++axis)
        height += (up[axis] > 0) == top ? up[axis] * box.hi[axis] : up[axis] * box.lo[axis];
    return height;
}

void keep_smallest(double& time, double candidate) {
    if (candidate < time || time == 0)
        time = candidate;
}

void keep_smallest(double& time, std::string& of, double candidate, const std::string& name) {
    if (candidate < time || time == 0) {
        time = candidate;
        of = name;
    }
}

void add_rayleigh(TimeStepReport& report, const NamedRadius& part, const contact::Material& material) {
    const double shear_modulus = material.youngs_modulus / (2 * (1 + material.poisson_ratio));
    const double time =
        pi * part.radius * std::sqrt(material.density / shear_modulus) / (0.1631 * material.poisson_ratio + 0.8766);
    // Twins of the smallest sphere may differ in the last bit.
    if (report.rayleigh == 0 || time < report.rayleigh * (1 - 1e-12)) {
        report.rayleigh = time;
        report.rayleigh_of = fmt::format("{} (r = {:.4g} mm)", part.name, 1e3 * part.radius);
    }
}

void add_contact(TimeStepReport& report, const Scene& scene, const Contact& contact) {
    const bool linear = scene.contact.normal == NormalLaw::linear;
    if (linear)
        keep_smallest(report.linear_period, pi * std::sqrt(contact.mass / contact.normal_stiffness));
    else
        keep_smallest(report.hertz, report.hertz_of,
                      2.87 *
                          std::pow(contact.mass * contact.mass /
                                       (contact.radius * contact.pair.E_eff * contact.pair.E_eff * report.hertz_speed),
                                   0.2),
                      contact.name);
    const double stiffness = contacts_at_once * stiffness_of(contact, scene.contact, report.hertz_speed);
    const double period = 2 * pi / std::sqrt(stiffness * contact.mobility);
    keep_smallest(report.body_period, report.body_of, period, contact.name);
    keep_smallest(report.limit, stable_step(contact, scene.contact, period));
    if (contact.pair.rolling == contact::RollingLaw::epsd)
        keep_smallest(report.limit, stable_step_of_rolling(contact, stiffness));
}

} // namespace

double impact_speed(const Scene& scene) {
    const double g = scene.gravity.norm();
    const Vector3d up = g > 0 ? Vector3d(-scene.gravity / g) : Vector3d::Zero();
    const double bottom = height_along(up, scene.domain.box, false);
    double fall = 0, meeting = 0;
    for (const Fill& fill : scene.fills) {
        const double top = fill.position ? up.dot(*fill.position) : height_along(up, fill.region, true);
        fall = std::max(fall, std::sqrt(fill.velocity.squaredNorm() + 2 * g * std::max(0.0, top - bottom)));
        for (const Fill& other : scene.fills)
            meeting = std::max(meeting, (fill.velocity - other.velocity).norm());
    }
    if (scene.fills.empty())
        fall = std::sqrt(2 * g * (height_along(up, scene.domain.box, true) - bottom));
    const Vector3d middle = (scene.domain.box.lo + scene.domain.box.hi) / 2;
    Vector3d across = scene.domain.box.hi - scene.domain.box.lo;
    if (scene.dimension == 2)
        across.z() = 0;
    const double reach = across.norm() / 2;
    double wall_speed = 0;
    for (const Wall& wall : scene.walls)
        wall_speed = std::max(wall_speed, speed_bound(wall.motion, middle, reach));
    return std::max({fall + wall_speed, meeting, speed_least});
}

TimeStepReport time_step_report(const Scene& scene, const std::vector<ContactSide>& bodies,
                                const std::vector<NamedRadius>& parts) {
    TimeStepReport report;
    report.step = scene.time_step;
    report.hertz_speed = impact_speed(scene);
    for (const NamedRadius& part : parts)
        if (const contact::Material& material = scene.materials[static_cast<std::size_t>(part.material)];
            material.youngs_modulus > 0)
            add_rayleigh(report, part, material);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = i; j < bodies.size() && scene.bodies_can_meet(); ++j)
            add_contact(report, scene, contact_of(scene, bodies[i], bodies[j], report.hertz_speed));
        for (const Wall& wall : scene.walls) {
            ContactSide side;
            side.name = "wall " + wall.name;
            side.material = wall.material;
            add_contact(report, scene, contact_of(scene, bodies[i], side, report.hertz_speed));
        }
    }
    if (report.limit == 0) // nothing can touch
        report.limit = std::numeric_limits<double>::infinity();
    return report;
}

} // namespace tumble::scene
