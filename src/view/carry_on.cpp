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
/// whole number of periods has passed.
template <class Wave> Wave carried(const Wave& running, const Wave& wanted, double now, double step, Next& next) {
    const bool same =
        running.amplitude == wanted.amplitude && running.frequency == wanted.frequency && running.phase == wanted.phase;
    if (same || now >= running.active.stop)
        return running;
    Wave changed = wanted;
    if (now <= running.active.start)
        return changed;
    const double periods = (now - running.active.start) * running.frequency;
    // The step that follows a period's end is its end; half a step more for roundings of many periods.
    const double ended = std::floor(periods + 0.5 * step * running.frequency);
    const double end = running.active.start + ended / running.frequency;
    if (running.amplitude != 0 && now - end > 1.5 * step) {
        next.at(running.active.start + (ended + 1) / running.frequency);
        return running;
    }
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
    }
    carried_on.next = next.time();
    return carried_on;
}

} // namespace tumble::view
