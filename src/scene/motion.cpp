#include "scene/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::scene {

using Eigen::Vector3d;

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// A part's own clock: how long it has acted (s, never negative), and whether it acts now.
struct Clock {
    double elapsed = 0;
    bool running = false;
};

/// A part whose stop is not after its start never acts.
bool acts(const Active& active) {
    return active.stop > active.start;
}

Clock clock_at(const Active& active, double t) {
    if (t < active.start || !acts(active))
        return {};
    if (t >= active.stop)
        return {active.stop - active.start, false};
    return {t - active.start, true};
}

/// sin(2 pi (f t + drift t^2 / 2) + phase) - sin(phase) and its rate (1/s).
struct Wave {
    double value = 0;
    double rate = 0;
};

template <class Part> Wave wave_at(const Part& part, double t) {
    const Clock clock = clock_at(part.active, t);
    const double frequency = part.frequency, phase = part.phase;
    // Whole turns are taken off before the factor 2 pi, and fma gives the part of the product that rounding dropped:
    // the phase stays right to a few ulp of one turn after any number of turns.
    const double turns = frequency * clock.elapsed;
    const double dropped = std::fma(frequency, clock.elapsed, -turns);
    const double drifted = 0.5 * part.drift * clock.elapsed * clock.elapsed;
    const double angle =
        turn * ((turns - std::floor(turns)) + dropped) + phase + turn * (drifted - std::floor(drifted));
    const double rate = clock.running ? turn * (frequency + part.drift * clock.elapsed) * std::cos(angle) : 0.0;
    return {std::sin(angle) - std::sin(phase), rate};
}

/// Turns the pose by `angle` about a fixed axis of the unmoved wall, on top of what it already has.
void turn_about(WallPose& pose, const Vector3d& centre, const Vector3d& axis, double angle, double rate) {
    const Eigen::Matrix3d step = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const Vector3d spin = rate * axis;
    const Vector3d arm = step * (pose.translation - centre);
    pose.rotation = step * pose.rotation;
    pose.velocity = spin.cross(arm) + step * pose.velocity;
    pose.angular_velocity = spin + step * pose.angular_velocity;
    pose.translation = centre + arm;
}

void turn_by(WallPose& pose, const Rotation& part, double t) {
    const Clock clock = clock_at(part.active, t);
    const double turns = part.angular_velocity / turn * clock.elapsed;
    turn_about(pose, part.centre, part.axis, turn * (turns - std::floor(turns)),
               clock.running ? part.angular_velocity : 0.0);
}

void turn_by(WallPose& pose, const Rocking& part, double t) {
    const Wave wave = wave_at(part, t);
    turn_about(pose, part.centre, part.axis, part.amplitude * wave.value, part.amplitude * wave.rate);
}

void shift_by(WallPose& pose, const Harmonic& part, double t) {
    const Wave wave = wave_at(part, t);
    pose.translation[part.axis] += part.amplitude * wave.value;
    pose.velocity[part.axis] += part.amplitude * wave.rate;
}

void shift_by(WallPose& pose, const Linear& part, double t) {
    const Clock clock = clock_at(part.active, t);
    pose.translation += clock.elapsed * part.velocity;
    if (clock.running)
        pose.velocity += part.velocity;
}

/// A first row that is not zero is where the wall stands from the beginning (with a later start it would jump there,
/// and resolve_motion refuses it); after its last row it holds that row.
void shift_by(WallPose& pose, const MotionTable& part, double t) {
    if (t < part.active.start || !acts(part.active) || part.time.empty())
        return;
    const Clock clock = clock_at(part.active, t);
    const auto after = std::upper_bound(part.time.begin(), part.time.end(), clock.elapsed);
    if (after == part.time.begin() || after == part.time.end()) {
        pose.translation += after == part.time.begin() ? part.displacement.front() : part.displacement.back();
        return;
    }
    const auto hi = static_cast<std::size_t>(after - part.time.begin());
    const Vector3d slope = (part.displacement[hi] - part.displacement[hi - 1]) / (part.time[hi] - part.time[hi - 1]);
    pose.translation += part.displacement[hi - 1] + (clock.elapsed - part.time[hi - 1]) * slope;
    if (clock.running)
        pose.velocity += slope;
}

double top_speed(const MotionTable& table) {
    double top = 0;
    for (std::size_t i = 1; i < table.time.size(); ++i)
        top = std::max(top, (table.displacement[i] - table.displacement[i - 1]).norm() /
                                (table.time[i] - table.time[i - 1]));
    return top;
}

} // namespace

WallPose pose_at(const WallMotion& motion, double t) {
    WallPose pose;
    for (const Rotation& part : motion.rotations)
        turn_by(pose, part, t);
    for (const Rocking& part : motion.rockings)
        turn_by(pose, part, t);
    for (const Harmonic& part : motion.harmonics)
        shift_by(pose, part, t);
    for (const Linear& part : motion.linears)
        shift_by(pose, part, t);
    for (const MotionTable& part : motion.tables)
        shift_by(pose, part, t);
    return pose;
}

double speed_bound(const WallMotion& motion, const Vector3d& about, double reach) {
    double turning = 0;
    // Each turn widens the ball in which the points may be when the next turn takes them.
    const auto add_turn = [&](const Vector3d& centre, const Vector3d& axis, double rate, double angle_max) {
        const Vector3d arm = about - centre;
        const double radius = (arm - arm.dot(axis) * axis).norm() + reach;
        turning += std::abs(rate) * radius;
        reach += std::min(2.0, std::abs(angle_max)) * radius;
    };
    for (const Rotation& part : motion.rotations)
        if (acts(part.active))
            add_turn(part.centre, part.axis, part.angular_velocity, 2.0);
    for (const Rocking& part : motion.rockings)
        if (acts(part.active))
            add_turn(part.centre, part.axis, turn * top_frequency(part) * part.amplitude, 2 * part.amplitude);

    Vector3d shaking = Vector3d::Zero();
    for (const Harmonic& part : motion.harmonics)
        if (acts(part.active))
            shaking[part.axis] += std::abs(turn * top_frequency(part) * part.amplitude);
    double bound = turning + shaking.norm();
    for (const Linear& part : motion.linears)
        if (acts(part.active))
            bound += part.velocity.norm();
    for (const MotionTable& part : motion.tables)
        if (acts(part.active))
            bound += top_speed(part);
    return bound;
}

} // namespace tumble::scene
