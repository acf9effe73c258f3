#include "view/carry_on.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tumble::view {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// When the next change can be taken up, over all motions.
class Next {
public:
    void at(double time) { time_ = std::min(time_, time); }
    [[nodiscard]] std::optional<double> time() const {
        return std::isfinite(time_) ? std::optional(time_) : std::nullopt;
    }

private:
    double time_ = std::numeric_limits<double>::infinity();
};

/// Harmonic or Rocking: both are amplitude * (sin(2 pi f (t - start) + phase) - sin(phase)), which is 0 whenever a
/// whole number of periods has passed. A new frequency goes on from the angle that the swing has: harmonics of one file
/// keep their phases to each other.
template <class Wave> Wave carried(const Wave& running, const Wave& wanted, double now, double step, Next& next) {
    if (now >= running.active.stop)
        return running;
    if (running.drift != 0 || wanted.drift != 0) // its periods are not all alike: begun, it is left alone
        return now <= running.active.start ? wanted : running;
    const bool same_swing = running.amplitude == wanted.amplitude && running.phase == wanted.phase;
    if (same_swing && running.frequency == wanted.frequency)
        return running;
    if (now <= running.active.start)
        return wanted;
    Wave changed = running;
    if (running.frequency != wanted.frequency) {
        const double turns = (now - running.active.start) * running.frequency;
        changed.frequency = wanted.frequency;
        changed.active.start = now - (turns - std::floor(turns)) / wanted.frequency;
    }
    if (same_swing)
        return changed;
    const double periods = (now - changed.active.start) * changed.frequency;
    // The step that follows a period's end is its end; half a step more for roundings of many periods.
    const double ended = std::floor(periods + 0.5 * step * changed.frequency);
    const double end = changed.active.start + ended / changed.frequency;
    if (running.amplitude != 0 && now - end > 1.5 * step) {
        next.at(changed.active.start + (ended + 1) / changed.frequency);
        return changed;
    }
    changed = wanted;
    changed.active.start = running.amplitude != 0 ? end : now;
    return changed;
}

double angle_of(const scene::Rotation& rotation, double time) {
    const scene::Active& active = rotation.active;
    return rotation.angular_velocity * (std::clamp(time, active.start, active.stop) - active.start);
}

/// The rotation that has the running one's angle now and the wanted one's speed from here on. Whole turns are left
/// out, so that it begins before now.
scene::Rotation carried(const scene::Rotation& running, const scene::Rotation& wanted, double now) {
    if (now >= wanted.active.stop || now <= wanted.active.start)
        return now <= wanted.active.start ? wanted : running;
    const bool halted = running.active.stop <= now;
    if (halted ? wanted.angular_velocity == 0 : wanted.angular_velocity == running.angular_velocity)
        return running;
    const double angle = std::remainder(angle_of(running, now), turn);
    scene::Rotation changed = wanted;
    if (wanted.angular_velocity == 0) { // a second ago it turned for a second to where it is, and stays
        changed.angular_velocity = angle;
        changed.active = {now - 1, now};
        return changed;
    }
    const bool backwards = angle * wanted.angular_velocity < 0;
    const double turned = backwards ? angle + std::copysign(turn, wanted.angular_velocity) : angle;
    changed.active.start = now - turned / wanted.angular_velocity;
    return changed;
}

/// m and m/s, the largest of a table's rows.
struct Reach {
    double way = 0;
    double speed = 0;
};

Reach reach_of(const scene::MotionTable& table) {
    Reach reach;
    for (std::size_t i = 0; i < table.time.size(); ++i) {
        reach.way = std::max(reach.way, table.displacement[i].norm());
        if (i > 0)
            reach.speed = std::max(reach.speed, (table.displacement[i] - table.displacement[i - 1]).norm() /
                                                    (table.time[i] - table.time[i - 1]));
    }
    return reach;
}

/// Where the running table stands now, and from there by degrees to the rows of the wanted one: over the time that the
/// faster of the two would need for the larger way, so that no wall moves much faster than its tables say.
scene::MotionTable carried(const scene::MotionTable& running, const scene::MotionTable& wanted, double now) {
    if (now >= running.active.stop || wanted.time.size() < 2 || running.time.size() < 2)
        return running;
    if (now <= running.active.start)
        return wanted;
    // Of the wanted table's own clock; both tables have the same rows, faster or slower.
    const double elapsed = (now - running.active.start) * wanted.time.back() / running.time.back();
    const Reach a = reach_of(running), b = reach_of(wanted);
    if (elapsed >= wanted.time.back() || std::max(a.speed, b.speed) == 0)
        return running; // over: it holds its last row
    const double bridge = std::max(a.way, b.way) / std::max(a.speed, b.speed);
    const auto at = [&](double on_wanted_clock) {
        scene::WallMotion alone;
        alone.tables.push_back(running);
        alone.tables.front().active = {};
        return scene::pose_at(alone, on_wanted_clock * running.time.back() / wanted.time.back()).translation;
    };
    scene::MotionTable changed{{now - elapsed, running.active.stop}, {0}, {at(0)}};
    bool same = running.time.back() == wanted.time.back();
    const auto add = [&](double time, const Eigen::Vector3d& displacement) {
        if (time > changed.time.back()) {
            changed.time.push_back(time);
            changed.displacement.push_back(displacement);
        }
    };
    add(elapsed, at(elapsed));
    for (std::size_t i = 0; i < wanted.time.size(); ++i) {
        const double time = wanted.time[i];
        const Eigen::Vector3d before = at(time), &after = wanted.displacement[i];
        const double share = std::clamp((time - elapsed) / bridge, 0.0, 1.0);
        add(time, before + share * (after - before));
        same = same && (time <= elapsed || (before - after).norm() <= 1e-12 * b.way);
    }
    return same ? running : changed;
}

} // namespace

CarriedOn carry_on(const scene::Scene& running, const scene::Scene& wanted, double now) {
    CarriedOn carried_on{wanted, std::nullopt};
    Next next;
    const double step = running.step();
    for (std::size_t w = 0; w < running.walls.size() && w < wanted.walls.size(); ++w) {
        const scene::WallMotion& was = running.walls[w].motion;
        scene::WallMotion& motion = carried_on.scene.walls[w].motion;
        for (std::size_t i = 0; i < was.harmonics.size() && i < motion.harmonics.size(); ++i)
            motion.harmonics[i] = carried(was.harmonics[i], motion.harmonics[i], now, step, next);
        for (std::size_t i = 0; i < was.rockings.size() && i < motion.rockings.size(); ++i)
            motion.rockings[i] = carried(was.rockings[i], motion.rockings[i], now, step, next);
        for (std::size_t i = 0; i < was.rotations.size() && i < motion.rotations.size(); ++i)
            motion.rotations[i] = carried(was.rotations[i], motion.rotations[i], now);
        for (std::size_t i = 0; i < was.tables.size() && i < motion.tables.size(); ++i)
            motion.tables[i] = carried(was.tables[i], motion.tables[i], now);
    }
    carried_on.next = next.time();
    return carried_on;
}

} // namespace tumble::view
