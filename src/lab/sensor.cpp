#include "base/rng.h"
#include "lab/bench.h"
#include "lab/each.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

constexpr double turn = 2 * std::numbers::pi;

/// A wall that an eccentric mass drives: an ellipse across the motor's axis x, a second order, a half order, rocking.
scene::WallMotion motion_of(const Values& values) {
    const double f = values["speed_rpm"] / 60, phase = values["phase_deg"] / degrees;
    scene::WallMotion motion;
    const auto add = [&](int axis, double amplitude_um, double order, double its_phase) {
        if (amplitude_um > 0)
            motion.harmonics.push_back({{}, axis, 1e-6 * amplitude_um, order * f, its_phase});
    };
    add(1, values["up_um"], 1, 0);
    add(2, values["across_um"], 1, phase);
    add(1, values["second_order_um"], 2, 0.5);
    add(0, values["half_order_um"], 0.5, 1);
    if (values["rocking_mrad"] > 0)
        motion.rockings.push_back(
            {{}, {0, 1e-3 * values["pivot_y_mm"], 0}, Vector3d::UnitX(), 1e-3 * values["rocking_mrad"], f, 0});
    return motion;
}

/// Acceleration of a point of the wall: the second difference of where it is, a thousandth of a period to either side;
/// that is 1 - (2 pi / 1000)^2 / 12 of the truth.
Vector3d acceleration(const scene::WallMotion& motion, const Vector3d& place, double t, double step) {
    const auto at = [&](double when) {
        const scene::WallPose pose = scene::pose_at(motion, when);
        return Vector3d(pose.rotation * place + pose.translation);
    };
    return (at(t + step) - 2 * at(t) + at(t - step)) / (step * step);
}

double normal(Rng& rng) {
    return std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(turn * rng.uniform());
}

Result<Outcome> perform(const Values& values) {
    const scene::WallMotion motion = motion_of(values);
    const double f = values["speed_rpm"] / 60, rate = values["rate_Hz"], step = 1e-3 / f;
    const auto samples = static_cast<int>(rate * values["duration_s"]);
    const std::array<Vector3d, 2> places{Vector3d(0, 0.7, -0.3), Vector3d(0, 0.7, 0.3)};
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(fmt::format(
        "Two accelerometers on the rim of a trough, at z = -300 and 300 mm, y = 700 mm, write {} samples each. They "
        "see gravity, the mains in their cables, and noise. `tumble excitation` has to find the motion again:",
        samples));
    sheet.formula("tumble excitation sensor-1.csv --second sensor-2.csv --at_mm 0,700,-300 --second_at_mm 0,700,300");
    Rng rng(static_cast<std::uint64_t>(values["seed"]));
    for (std::size_t s = 0; s < places.size(); ++s) {
        Recording record{fmt::format("sensor-{}", s + 1), {"t_s", "ax_m_s2", "ay_m_s2", "az_m_s2"}};
        for (int k = 0; k < samples; ++k) {
            // The motion runs before the record begins, so that the first sample has two sides.
            const double t = k / rate;
            Vector3d a = acceleration(motion, places[s], t + 1, step) + Vector3d(0, gravity, 0);
            a.x() += values["mains_m_s2"] * std::sin(turn * 2 * values["mains_Hz"] * t);
            for (int axis = 0; axis < 3; ++axis)
                a[axis] += values["noise_m_s2"] * normal(rng);
            record.rows.push_back({t, a.x(), a.y(), a.z()});
        }
        outcome.recordings.push_back(std::move(record));
    }
    sheet::Grid grid{{{"what was put in"}, {"value", "", 5}, {"unit"}},
                     {{"fundamental", f, "Hz"},
                      {"up and down", values["up_um"], "um"},
                      {"across", values["across_um"], "um"},
                      {"across before up", values["phase_deg"], "deg"},
                      {"rocking about x", values["rocking_mrad"], "mrad"}}};
    sheet.parts.emplace_back(grid);
    sheet::Figure figure{.name = "sensor",
                         .title = "The first tenth of a second of the first sensor",
                         .x = {"time", "s"},
                         .y = {"acceleration", "m/s2"},
                         .curves = {{"x"}, {"y"}, {"z"}}};
    for (const auto& row : outcome.recordings[0].rows)
        if (row[0] <= 0.1)
            for (std::size_t axis = 0; axis < 3; ++axis)
                figure.curves[axis].add(row[0], row[axis + 1]);
    sheet.parts.emplace_back(figure);
    return outcome;
}

} // namespace

Experiment sensor() {
    return {.name = "sensor",
            .title = "Accelerometers on a shaken trough: records to try `tumble excitation` on",
            .parameters = {{"speed_rpm", "rpm", 1478.2, {.lo = 60, .hi = 1e5}, "Speed of the motor"},
                           {"up_um", "um", 1949, {.lo = 0, .hi = 1e5}, "Amplitude up and down"},
                           {"across_um", "um", 404, {.lo = 0, .hi = 1e5}, "Amplitude across"},
                           {"phase_deg", "deg", 90, {.lo = -360, .hi = 360}, "How far across is before up"},
                           {"second_order_um", "um", 8, {.lo = 0, .hi = 1e5}, "Amplitude of order 2, up and down"},
                           {"half_order_um", "um", 16, {.lo = 0, .hi = 1e5}, "Amplitude of order 1/2, along"},
                           {"rocking_mrad", "mrad", 0.5, {.lo = 0, .hi = 50}, "Angle of rocking about x"},
                           {"pivot_y_mm", "mm", 400, {.lo = -1e4, .hi = 1e4}, "Height that it rocks about"},
                           {"mains_m_s2", "m/s2", 0.06, {.lo = 0, .hi = 100}, "Twice the mains frequency, on x"},
                           {"mains_Hz", "Hz", 50, {.lo = 10, .hi = 400}, "Frequency of the mains"},
                           {"noise_m_s2", "m/s2", 0.3, {.lo = 0, .hi = 100}, "Standard deviation of the noise"},
                           {"rate_Hz", "Hz", 2000, {.lo = 100, .hi = 1e5}, "Samples a second"},
                           {"duration_s", "s", 2.56, {.lo = 0.2, .hi = 100}, "Length of the record"},
                           {"seed", "", 1, {.lo = 0, .hi = 1e9}, "Of the noise (whole number)"}},
            .perform = perform};
}

} // namespace tumble::lab
