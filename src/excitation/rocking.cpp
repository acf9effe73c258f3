#include "excitation/rocking.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::excitation {

namespace {

using Eigen::Vector3cd;
using Eigen::Vector3d;

constexpr double clear = 4; // standard errors that a harmonic must have to be written

/// A sensor's displacement at one line: zero on an axis that it does not measure.
struct Seen {
    Vector3cd motion = Vector3cd::Zero();
    Vector3d se = Vector3d::Zero();
    Eigen::Array3i measured = Eigen::Array3i::Zero();
};

Seen seen_by(int sensor, const Line& line, const std::vector<Channel>& channels) {
    Seen seen;
    for (std::size_t k = 0; k < channels.size(); ++k) {
        if (channels[k].sensor != sensor)
            continue;
        seen.motion[channels[k].axis] = displacement(line, k);
        seen.se[channels[k].axis] = displacement_se(line, k);
        seen.measured[channels[k].axis] = 1;
    }
    return seen;
}

Turn turn_of(const Line& line, const Seen& first, const Seen& second, const Places& places, const Vector3d& arm) {
    Turn turn;
    turn.frequency = line.frequency;
    const Vector3d axis = Vector3d::Unit(places.about);
    const Vector3cd difference = second.motion - first.motion;
    const Vector3d se = (first.se.array().square() + second.se.array().square()).sqrt();
    const double weight = arm.squaredNorm();
    turn.angle = arm.cast<std::complex<double>>().dot(difference) / weight;
    turn.angle_se = arm.cwiseProduct(se).norm() / weight;
    Vector3cd left = difference - turn.angle * arm.cast<std::complex<double>>();
    for (int k = 0; k < 3; ++k)
        if (!first.measured[k] || !second.measured[k] || k == places.about)
            left[k] = 0;
    turn.misfit = left.norm();
    turn.misfit_se = se.norm();
    turn.motion_se = first.se;
    if (!turn.seen()) {
        turn.pivot_motion = first.motion;
        return turn;
    }
    // u(c) = u1 + angle axis x (c - r1) is least where axis x (c - r1) = -Re(u1 / angle).
    Vector3d in_phase;
    for (int k = 0; k < 3; ++k)
        in_phase[k] = k == places.about ? 0.0 : (first.motion[k] / turn.angle).real();
    const Vector3d reach = axis.cross(in_phase);
    turn.pivot = places.first + reach;
    turn.pivot_se = std::hypot(first.se.norm(), reach.norm() * turn.angle_se) / std::abs(turn.angle);
    turn.pivot_motion = first.motion + turn.angle * axis.cross(reach).cast<std::complex<double>>();
    return turn;
}

} // namespace

Result<std::vector<Turn>> turns_of(const Excitation& found, const std::vector<Channel>& channels,
                                   const Places& places) {
    Vector3d arm = Vector3d(Vector3d::Unit(places.about)).cross(places.second - places.first);
    const Seen first = seen_by(0, found.lines.front(), channels), second = seen_by(1, found.lines.front(), channels);
    for (int k = 0; k < 3; ++k)
        if (!first.measured[k] || !second.measured[k])
            arm[k] = 0;
    if (arm.norm() < 1e-3)
        return Problem{
            .what = fmt::format("the two sensors cannot see a turn about {}: they share no axis that it would move "
                                "differently at the two places",
                                "xyz"[places.about]),
            .fix = "give --at_mm and --second_at_mm, metres of distance across the axis, and measure across the line "
                   "between the sensors"};
    std::vector<Turn> turns;
    for (const Line& line : found.lines)
        if (moves_wall(line))
            turns.push_back(turn_of(line, seen_by(0, line, channels), seen_by(1, line, channels), places, arm));
    return turns;
}

scene::WallMotion motion_of(const std::vector<Turn>& turns, const Places& places, double start) {
    scene::WallMotion motion;
    for (const Turn& turn : turns) {
        if (turn.seen())
            motion.rockings.push_back({{.start = start},
                                       turn.pivot,
                                       Vector3d::Unit(places.about),
                                       std::abs(turn.angle),
                                       turn.frequency,
                                       std::arg(turn.angle)});
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(turn.pivot_motion[axis]) > clear * turn.motion_se[axis])
                motion.harmonics.push_back(harmonic_of(turn.pivot_motion[axis], axis, turn.frequency, start));
    }
    return motion;
}

} // namespace tumble::excitation
