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
        {.id = "grav.g", .family = "gravity", .symbol = "dg/g", .lo = -0.05, .hi = 0.05, .typical = 1e-3,
         .name = "gravity that differs from the scene's",
         .look = "grows as t^2 within every flight; the same for heavy and light bodies; a clock that runs wrong looks alike",
         .keys = "gravity_m_s2, its length",
         .extend = [](Scene& s, double d) { s.gravity *= 1 + d; }},
        {.id = "grav.tilt_x", .family = "tilt", .symbol = "tilt", .unit = "deg", .lo = -5, .hi = 5, .typical = 0.1,
         .name = "ground that leans sideways, about z",
         .look = "a sideways pull of g sin(tilt); changes its sign when the apparatus is turned half round",
         .keys = "gravity_m_s2, turned about z",
         .extend = [](Scene& s, double d) { tilt(s, d, Eigen::Vector3d::UnitZ()); }},
        {.id = "grav.tilt_z", .family = "tilt", .symbol = "tilt", .unit = "deg", .lo = -5, .hi = 5, .typical = 0.1,
         .name = "ground that leans sideways, about x",
         .look = "a sideways pull of g sin(tilt); changes its sign when the apparatus is turned half round",
         .keys = "gravity_m_s2, turned about x",
         .extend = [](Scene& s, double d) { tilt(s, d, Eigen::Vector3d::UnitX()); }},
    };
}

std::vector<Cause> of_the_simulation() {
    return {
        {.id = "num.stiffness", .family = "numerics", .symbol = "ln(E factor)", .lo = -4, .hi = 3, .typical = 0.1,
         .name = "contacts that are softer or harder than the scene's",
         .look = "every impact comes back early or late by the same time; shrinks when the modulus is raised",
         .keys = "material.*.youngs_modulus_Pa, times a factor",
         .extend = [](Scene& s, double d) {
             for (contact::Material& material : s.materials)
                 material.youngs_modulus *= std::exp(d);
         }},
    };
}

std::vector<Cause> of_the_clock() {
    return {
        {.id = "ins.clock_offset", .family = "clock", .symbol = "t0", .unit = "s", .lo = -0.1, .hi = 0.1, .typical = 1e-4,
         .name = "a clock that starts early or late",
         .look = "follows the speed: a sawtooth of constant height between impacts",
         .keys = "the instrument's zero of time",
         .distort = [](Instrument& i, double d) { i.clock_offset += d; }},
        {.id = "ins.clock_rate", .family = "clock", .symbol = "rate", .lo = -0.05, .hi = 0.05, .typical = 1e-4,
         .name = "a clock that runs fast or slow",
         .look = "follows t times speed: a sawtooth that grows with time; a reference clock in the picture moves alike",
         .keys = "the instrument's time, stretched",
         .distort = [](Instrument& i, double d) { i.clock_rate += d; }},
    };
}

std::vector<Cause> of_the_sensor() {
    return {
        {.id = "ins.gain", .family = "sensor scale", .symbol = "gain", .lo = -0.1, .hi = 0.1, .typical = 1e-3,
         .name = "a scale that reads too much or too little",
         .look = "follows the reading itself, at rest and in motion, without kinks",
         .keys = "the instrument's readings, times 1 + gain",
         .distort = [](Instrument& i, double d) { i.gain += d; }},
        {.id = "ins.bias", .family = "sensor scale", .symbol = "bias", .unit = "SI unit of the channel", .lo = -0.05,
         .hi = 0.05, .typical = 1e-4, .name = "a zero that is shifted",
         .look = "constant, at rest and in motion",
         .keys = "the instrument's readings, plus a constant",
         .distort = [](Instrument& i, double d) { i.bias += d; }},
        {.id = "ins.drift", .family = "sensor scale", .symbol = "drift", .unit = "SI unit of the channel per s",
         .lo = -0.05, .hi = 0.05, .typical = 1e-4, .name = "a zero that wanders with time",
         .look = "straight in time, whatever the body does",
         .keys = "the instrument's readings, plus a constant times time",
         .distort = [](Instrument& i, double d) { i.drift += d; }},
        {.id = "ins.low_pass", .family = "filter", .symbol = "tau", .unit = "s", .lo = 0, .hi = 0.05, .typical = 1e-3,
         .name = "readings that lag and are rounded off",
         .look = "differs from zero mostly where the motion has kinks; behind every impact, decaying",
         .keys = "the instrument's readings, through a first-order low pass",
         .distort = [](Instrument& i, double d) { i.low_pass += d; }},
        {.id = "ins.high_pass", .family = "filter", .symbol = "2 pi fc", .unit = "1_s", .lo = 0, .hi = 5, .typical = 0.01,
         .name = "readings that forget what is constant",
         .look = "what lasts is pulled towards zero, the more the longer",
         .keys = "the instrument's readings, through a first-order high pass",
         .distort = [](Instrument& i, double d) { i.high_pass += d; }},
        {.id = "ins.clipping", .family = "sensor range", .symbol = "share cut", .lo = 0, .hi = 0.9, .typical = 0.02,
         .name = "readings that are cut off at the top of their range",
         .look = "negative at the highest readings only, zero elsewhere",
         .keys = "the instrument's readings, at most a ceiling",
         .distort = [](Instrument& i, double d) { i.clipping += d; }},
    };
}

std::vector<Cause> collect() {
    std::vector<Cause> all;
    for (auto part : {of_the_ground, of_the_simulation, of_the_clock, of_the_sensor})
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
