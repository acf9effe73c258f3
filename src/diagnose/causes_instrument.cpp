#include "diagnose/cause_families.h"

#include <numbers>

namespace tumble::diagnose {

std::vector<Cause> of_the_clock() {
    return {
        {.id = "ins.clock_offset",
         .family = "clock",
         .symbol = "t0",
         .unit = "s",
         .lo = -0.1,
         .hi = 0.1,
         .typical = 1e-4,
         .over_time = true,
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
         .over_time = true,
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
         .keys = "the instrument's readings: 1 + gain times the truth",
         .distort = [](Instrument& i, double d) { i.gain += d; }},
        {.id = "ins.bias",
         .family = "sensor scale",
         .symbol = "bias",
         .unit = "SI unit of the channel",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-4,
         .range = Cause::Range::readings,
         .name = "a zero that is shifted",
         .look = "constant, at rest and in motion",
         .keys = "the instrument's readings: the truth plus a constant",
         .distort = [](Instrument& i, double d) { i.bias += d; }},
        {.id = "ins.drift",
         .family = "sensor scale",
         .symbol = "drift",
         .unit = "SI unit of the channel per s",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-4,
         .range = Cause::Range::readings_per_second,
         .over_time = true,
         .name = "a zero that wanders with time",
         .look = "straight in time, whatever the body does",
         .keys = "the instrument's readings: the truth plus a constant times time",
         .distort = [](Instrument& i, double d) { i.drift += d; }},
        {.id = "ins.low_pass",
         .family = "filter",
         .symbol = "tau",
         .unit = "s",
         .lo = 0,
         .hi = 0.05,
         .typical = 1e-3,
         .over_time = true,
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
         .over_time = true,
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
         .over_time = true,
         .name = "readings that are cut off at the end of the sensor's range",
         .look = "at the largest readings only, towards zero; at the same limit in every record",
         .keys = "the instrument's readings, within a limit to either side of zero",
         .distort = [](Instrument& i, double d) { i.clipping += d; }},
    };
}

std::vector<Cause> of_the_camera() {
    return {
        {.id = "ins.align",
         .family = "sensor axes",
         .symbol = "turned",
         .unit = "deg",
         .lo = -10,
         .hi = 10,
         .typical = 0.05,
         .needs = {"centre_of_mass_x", "centre_of_mass_y"},
         .name = "a camera that does not stand upright",
         .look = "each coordinate follows the other, at rest and in motion: x shows a share of the height, the height "
                 "lacks as much of x",
         .keys = "observe.axes_turned_deg",
         .extend = [](scene::Scene& s, double d) { s.observe.axes_turned += d * std::numbers::pi / 180; }},
    };
}

std::vector<Cause> of_the_accelerometer() {
    // What is felt at rest has a share of g along `leaks` where the sensor sits turned about `about`.
    const auto leak = [](const std::string& leaks, const std::string& about, int axis, double sense) {
        return Cause{.id = "ins.gravity_leak_" + leaks,
                     .family = "accelerometer",
                     .symbol = "leans",
                     .unit = "deg",
                     .lo = -10,
                     .hi = 10,
                     .typical = 0.05,
                     .inertial = true,
                     .name = "an accelerometer that sits askew: gravity leaks into " + leaks,
                     .look = "velocity summed up from accelerations runs away in proportion to time while the body "
                             "keeps its attitude, and swings with the body's turning where it does not; what is felt "
                             "at rest has a share of g along " +
                             leaks,
                     .keys = "body.tracer_turned_deg (" + about + ")",
                     .extend = [axis, sense](scene::Scene& s, double d) {
                         for (scene::BodyTemplate& body : s.bodies)
                             body.tracer_turned[axis] += sense * d * std::numbers::pi / 180;
                     }};
    };
    return {leak("x", "z", 2, 1), leak("z", "x", 0, -1)};
}

} // namespace tumble::diagnose
