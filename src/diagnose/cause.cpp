#include "diagnose/cause.h"

#include "base/text.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tumble::diagnose {

namespace {

using scene::Scene;

constexpr double degree = 3.14159265358979323846 / 180;

void tilt(Scene& scene, double degrees, const Eigen::Vector3d& axis) {
    scene.gravity = Eigen::AngleAxisd(degrees * degree, axis) * scene.gravity;
}

std::vector<Cause> of_the_ground() {
    return {
        {.id = "grav.g",
         .family = "gravity",
         .symbol = "dg/g",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-3,
         .name = "gravity that differs from the scene's",
         .look = "grows as t^2 within every flight; the same for heavy and light bodies; a clock that runs wrong looks "
                 "alike",
         .keys = "gravity_m_s2, its length",
         .extend = [](Scene& s, double d) { s.gravity *= 1 + d; }},
        {.id = "grav.tilt_x",
         .family = "tilt",
         .symbol = "tilt",
         .unit = "deg",
         .lo = -5,
         .hi = 5,
         .typical = 0.1,
         .name = "ground that leans sideways, about z",
         .look = "a sideways pull of g sin(tilt); changes its sign when the apparatus is turned half round",
         .keys = "gravity_m_s2, turned about z",
         .extend = [](Scene& s, double d) { tilt(s, d, Eigen::Vector3d::UnitZ()); }},
        {.id = "grav.tilt_z",
         .family = "tilt",
         .symbol = "tilt",
         .unit = "deg",
         .lo = -5,
         .hi = 5,
         .typical = 0.1,
         .name = "ground that leans sideways, about x",
         .look = "a sideways pull of g sin(tilt); changes its sign when the apparatus is turned half round",
         .keys = "gravity_m_s2, turned about x",
         .extend = [](Scene& s, double d) { tilt(s, d, Eigen::Vector3d::UnitX()); }},
    };
}

constexpr double sphere = 0.44; // drag coefficient where the scene has none (Clift, Grace and Weber 1978)

std::vector<Cause> of_the_air() {
    return {
        {.id = "drag.quadratic",
         .family = "air resistance",
         .symbol = "air density",
         .unit = "kg/m3",
         .lo = 0,
         .hi = 20,
         .typical = 0.1,
         .name = "air resistance that grows with the square of speed",
         .look =
             "zero at release, then k g^2 t^4 / 12 m in the fall; the acceleration's residual follows v|v|; twice the "
             "mass, half the effect",
         .keys = "air.density_kg_m3, with air.drag_coefficient 0.44 where the scene has none",
         .extend =
             [](Scene& s, double d) {
                 s.air.density += d;
                 if (s.air.drag_coefficient == 0)
                     s.air.drag_coefficient = sphere;
             }},
        {.id = "drag.linear",
         .family = "air resistance",
         .symbol = "viscosity",
         .unit = "Pa s",
         .lo = 0,
         .hi = 2,
         .typical = 1e-3,
         .name = "a medium that drags in proportion to speed",
         .look =
             "zero at release, then b g t^3 / 6 m in the fall; the acceleration's residual follows v; twice the mass, "
             "half the effect",
         .keys = "air.viscosity_Pa_s",
         .extend = [](Scene& s, double d) { s.air.viscosity += d; }},
    };
}

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

/// Every harmonic and rocking of every wall.
template <class Change> void excite(Scene& scene, Change change) {
    for (scene::Wall& wall : scene.walls) {
        for (scene::Harmonic& part : wall.motion.harmonics)
            change(part);
        for (scene::Rocking& part : wall.motion.rockings)
            change(part);
    }
}

std::vector<Cause> of_the_excitation() {
    return {
        {.id = "exc.gain",
         .family = "excitation",
         .symbol = "gain",
         .lo = -0.5,
         .hi = 1,
         .typical = 0.01,
         .name = "walls that shake more or less than the scene's",
         .look = "throws are higher or lower from the first on; lift-off at another acceleration",
         .keys = "wall.motion.amplitude_m and amplitude_deg, times 1 + gain",
         .extend = [](Scene& s, double d) { excite(s, [&](auto& part) { part.amplitude *= 1 + d; }); }},
        {.id = "exc.frequency",
         .family = "excitation",
         .symbol = "df/f",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-4,
         .name = "walls that shake faster or slower than the scene's",
         .look = "the phase runs away with time; a motor that slips",
         .keys = "wall.motion.frequency_Hz, times 1 + df/f",
         .extend = [](Scene& s, double d) { excite(s, [&](auto& part) { part.frequency *= 1 + d; }); }},
        {.id = "exc.phase",
         .family = "excitation",
         .symbol = "phase",
         .unit = "deg",
         .lo = -180,
         .hi = 180,
         .typical = 1,
         .name = "sideways shaking that is ahead of the upright one",
         .look = "the orbit opens to an ellipse; circulation changes its sign with it",
         .keys = "wall.motion.phase_deg of harmonics along x and z",
         .extend =
             [](Scene& s, double d) {
                 for (scene::Wall& wall : s.walls)
                     for (scene::Harmonic& part : wall.motion.harmonics)
                         if (part.axis != 1)
                             part.phase += d * degree;
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
    };
}

std::vector<Cause> of_the_clock() {
    return {
        {.id = "ins.clock_offset",
         .family = "clock",
         .symbol = "t0",
         .unit = "s",
         .lo = -0.1,
         .hi = 0.1,
         .typical = 1e-4,
         .name = "a clock that starts early or late",
         .look = "follows the speed: a sawtooth of constant height between impacts",
         .keys = "the instrument's zero of time",
         .distort = [](Instrument& i, double d) { i.clock_offset += d; }},
        {.id = "ins.clock_rate",
         .family = "clock",
         .symbol = "rate",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-4,
         .name = "a clock that runs fast or slow",
         .look = "follows t times speed: a sawtooth that grows with time; a reference clock in the picture moves alike",
         .keys = "the instrument's time, stretched",
         .distort = [](Instrument& i, double d) { i.clock_rate += d; }},
    };
}

std::vector<Cause> of_the_sensor() {
    return {
        {.id = "ins.gain",
         .family = "sensor scale",
         .symbol = "gain",
         .lo = -0.1,
         .hi = 0.1,
         .typical = 1e-3,
         .name = "a scale that reads too much or too little",
         .look = "follows the reading itself, at rest and in motion, without kinks",
         .keys = "the instrument's readings, times 1 + gain",
         .distort = [](Instrument& i, double d) { i.gain += d; }},
        {.id = "ins.bias",
         .family = "sensor scale",
         .symbol = "bias",
         .unit = "SI unit of the channel",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-4,
         .name = "a zero that is shifted",
         .look = "constant, at rest and in motion",
         .keys = "the instrument's readings, plus a constant",
         .distort = [](Instrument& i, double d) { i.bias += d; }},
        {.id = "ins.drift",
         .family = "sensor scale",
         .symbol = "drift",
         .unit = "SI unit of the channel per s",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-4,
         .name = "a zero that wanders with time",
         .look = "straight in time, whatever the body does",
         .keys = "the instrument's readings, plus a constant times time",
         .distort = [](Instrument& i, double d) { i.drift += d; }},
        {.id = "ins.low_pass",
         .family = "filter",
         .symbol = "tau",
         .unit = "s",
         .lo = 0,
         .hi = 0.05,
         .typical = 1e-3,
         .name = "readings that lag and are rounded off",
         .look = "differs from zero mostly where the motion has kinks; behind every impact, decaying",
         .keys = "the instrument's readings, through a first-order low pass",
         .distort = [](Instrument& i, double d) { i.low_pass += d; }},
        {.id = "ins.high_pass",
         .family = "filter",
         .symbol = "2 pi fc",
         .unit = "1_s",
         .lo = 0,
         .hi = 5,
         .typical = 0.01,
         .name = "readings that forget what is constant",
         .look = "what lasts is pulled towards zero, the more the longer",
         .keys = "the instrument's readings, through a first-order high pass",
         .distort = [](Instrument& i, double d) { i.high_pass += d; }},
        {.id = "ins.clipping",
         .family = "sensor range",
         .symbol = "share cut",
         .lo = 0,
         .hi = 0.9,
         .typical = 0.02,
         .name = "readings that are cut off at the top of their range",
         .look = "negative at the highest readings only, zero elsewhere",
         .keys = "the instrument's readings, at most a ceiling",
         .distort = [](Instrument& i, double d) { i.clipping += d; }},
    };
}

std::vector<Cause> collect() {
    std::vector<Cause> all;
    for (auto part : {of_the_air, of_the_contact, of_cohesion, of_the_friction, of_the_excitation, of_the_ground,
                      of_the_simulation, of_the_clock, of_the_sensor})
        for (Cause& cause : part())
            all.push_back(std::move(cause));
    return all;
}

} // namespace

const std::vector<Cause>& all_causes() {
    static const std::vector<Cause> all = collect();
    return all;
}

std::vector<std::string> cause_ids() {
    std::vector<std::string> ids;
    for (const Cause& cause : all_causes())
        ids.push_back(cause.id);
    return ids;
}

Result<std::vector<Cause>> choose_causes(const std::vector<std::string>& ids) {
    if (ids.empty() || ids == std::vector<std::string>{"all"})
        return all_causes();
    std::vector<bool> wanted(all_causes().size(), false);
    Problems problems;
    for (const std::string& id : ids) {
        bool found = false;
        for (std::size_t k = 0; k < all_causes().size(); ++k)
            if (all_causes()[k].id == id || all_causes()[k].family == id)
                wanted[k] = found = true;
        if (!found) {
            const std::string guess = did_you_mean(id, cause_ids());
            problems.push_back({.key = "causes",
                                .what = "there is no cause '" + excerpt(id) + "'",
                                .fix = (guess.empty() ? "" : guess + " ") + "`tumble list causes` names all of them"});
        }
    }
    if (!problems.empty())
        return problems;
    std::vector<Cause> chosen;
    for (std::size_t k = 0; k < wanted.size(); ++k)
        if (wanted[k])
            chosen.push_back(all_causes()[k]);
    return chosen;
}

} // namespace tumble::diagnose
