#include "lane.h"

#include <algorithm>
#include <cmath>

namespace blind {

namespace {

constexpr double step = 5e-4;                              // s
constexpr double gust = 0.02;                              // N s2/m2
constexpr double spot = 0.3;                               // m
constexpr double tremor = 2 * 3.14159265358979323846 * 11; // rad/s

double sign(double v) {
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

/// What the air does to its speed, m/s2.
double air_on(const Lane& lane, double v) {
    const double blown = lane.wind == 0 ? 0 : gust * ((lane.wind - v) * std::abs(lane.wind - v) + v * std::abs(v));
    return (blown - lane.linear * v - lane.quadratic * v * std::abs(v)) / lane.mass;
}

/// What presses a body down while the ground shakes, over its weight.
double shaken(const Lane& lane, double t) {
    return 1 + lane.shakes / lane.gravity * std::sin(tremor * t + 1);
}

/// Speeds: of the centre and of the surface about it, radius times spin.
struct Rates {
    double speed = 0, surface = 0; // m/s2
};

class Course {
public:
    explicit Course(const Lane& lane) : lane_(lane) {
        const double weight = lane.mass * lane.gravity;
        const double sunk = std::pow(0.75 * weight / (lane.modulus * std::sqrt(lane.radius)), 2.0 / 3);
        arm_ = 1 - sunk / lane.radius;
        inertia_ = 0.4 / (arm_ * arm_);
    }

    std::vector<State> steps(double speed, double surface, double until) {
        State s{0, 0, speed};
        surface *= arm_;
        std::vector<State> all{s};
        while (s.t < until) {
            double h = std::min(step, until - s.t);
            if (rolls_) {
                roll(s, h);
                surface = s.v;
            } else {
                slide(s, surface, h);
            }
            all.push_back(s);
        }
        return all;
    }

private:
    [[nodiscard]] double pull(double x) const { return lane_.gravity * std::sin(lane_.slope - lane_.hollow * x); }
    [[nodiscard]] double press(double x, double t) const {
        return lane_.gravity * std::cos(lane_.slope - lane_.hollow * x) * shaken(lane_, t);
    }
    [[nodiscard]] double air(double v) const { return air_on(lane_, v); }
    [[nodiscard]] double resistance(double v) const {
        return (lane_.rolling + lane_.rolling_time * std::abs(v) / (lane_.radius * arm_)) / arm_;
    }
    [[nodiscard]] double friction(double slip, double x) const {
        return friction_at(lane_, slip) * (std::abs(x) < spot ? 1 - lane_.patch : 1);
    }

    /// `way` the slip goes, of the whole step: a stage of it that lies beyond the slip's end must not turn friction
    /// round.
    [[nodiscard]] Rates sliding(double t, double x, double v, double w, double way) const {
        const double grip = way * friction(v - w, x) * press(x, t);
        return {pull(x) + air(v) - grip, (grip - sign(v) * resistance(w) * press(x, t)) / inertia_};
    }

    [[nodiscard]] double rolling(double t, double x, double v) const {
        return (pull(x) + air(v) - sign(v) * resistance(v) * press(x, t)) / (1 + inertia_);
    }

    void slide(State& s, double& w, double h) {
        const State before = s;
        const double spun = w;
        slid(s, w, h);
        if (sign(s.v - w) == sign(before.v - spun))
            return;
        double lo = 0, hi = h; // the slip ends inside: bisection down to a rounding error
        for (int k = 0; k < 50; ++k) {
            const double middle = (lo + hi) / 2;
            State there = before;
            double turned = spun;
            slid(there, turned, middle);
            (sign(there.v - turned) == sign(before.v - spun) ? lo : hi) = middle;
        }
        s = before;
        w = spun;
        slid(s, w, hi);
        s.v = w = (s.v + inertia_ * w) / (1 + inertia_);
        rolls_ = true;
    }

    void slid(State& s, double& w, double h) const {
        const double way = sign(s.v - w);
        const double half = s.t + h / 2;
        const Rates a = sliding(s.t, s.y, s.v, w, way);
        const Rates b = sliding(half, s.y + h / 2 * s.v, s.v + h / 2 * a.speed, w + h / 2 * a.surface, way);
        const Rates c =
            sliding(half, s.y + h / 2 * (s.v + h / 2 * a.speed), s.v + h / 2 * b.speed, w + h / 2 * b.surface, way);
        const Rates d = sliding(s.t + h, s.y + h * (s.v + h / 2 * b.speed), s.v + h * c.speed, w + h * c.surface, way);
        s.y += h * s.v + h * h / 6 * (a.speed + b.speed + c.speed);
        s.v += h / 6 * (a.speed + 2 * b.speed + 2 * c.speed + d.speed);
        w += h / 6 * (a.surface + 2 * b.surface + 2 * c.surface + d.surface);
        s.t += h;
    }

    void roll(State& s, double h) const {
        const bool held = std::abs(pull(s.y) + air(0)) <= resistance(0) * press(s.y, s.t);
        if (s.v == 0 && held) {
            s.t += h;
            return;
        }
        const double before = s.v, half = s.t + h / 2;
        const double a = rolling(s.t, s.y, s.v), b = rolling(half, s.y + h / 2 * s.v, s.v + h / 2 * a),
                     c = rolling(half, s.y + h / 2 * (s.v + h / 2 * a), s.v + h / 2 * b),
                     d = rolling(s.t + h, s.y + h * (s.v + h / 2 * b), s.v + h * c);
        s.y += h * s.v + h * h / 6 * (a + b + c);
        s.v += h / 6 * (a + 2 * b + 2 * c + d);
        s.t += h;
        if (held && sign(s.v) == -sign(before))
            s.v = 0;
    }

    const Lane& lane_;
    double arm_ = 1;     // over the radius
    double inertia_ = 0; // of the mass times the arm squared
    bool rolls_ = false;
};

/// A body that only slides.
class Slide {
public:
    explicit Slide(const Lane& lane) : lane_(lane) {}

    std::vector<State> steps(double until) const {
        State s;
        std::vector<State> all{s};
        while (s.t < until) {
            const double h = std::min(step, until - s.t);
            const double way = s.v != 0 ? sign(s.v) : sign(pull(0));
            const bool held = s.v == 0 && std::abs(pull(s.y)) <= friction(s.t, 0, s.y);
            if (!held)
                go(s, h, way);
            s.t += h;
            if (way * s.v < 0)
                s.v = 0;
            all.push_back(s);
        }
        return all;
    }

private:
    [[nodiscard]] double pull(double x) const { return lane_.gravity * std::sin(lane_.slope - lane_.hollow * x); }
    [[nodiscard]] double friction(double t, double v, double x) const {
        const double press =
            lane_.gravity * std::cos(lane_.slope - lane_.hollow * x) * shaken(lane_, t) + lane_.squeeze;
        return friction_at(lane_, v) * press * (std::abs(x) < spot ? 1 - lane_.patch : 1);
    }
    [[nodiscard]] double rate(double t, double x, double v, double way) const {
        return pull(x) + air_on(lane_, v) - way * friction(t, v, x);
    }
    void go(State& s, double h, double way) const {
        const double half = s.t + h / 2;
        const double a = rate(s.t, s.y, s.v, way), b = rate(half, s.y + h / 2 * s.v, s.v + h / 2 * a, way),
                     c = rate(half, s.y + h / 2 * (s.v + h / 2 * a), s.v + h / 2 * b, way),
                     d = rate(s.t + h, s.y + h * (s.v + h / 2 * b), s.v + h * c, way);
        s.y += h * s.v + h * h / 6 * (a + b + c);
        s.v += h / 6 * (a + 2 * b + 2 * c + d);
    }

    const Lane& lane_;
};

} // namespace

double friction_at(const Lane& lane, double slip) {
    return lane.fast_friction + (lane.friction - lane.fast_friction) * std::exp(-std::abs(slip) / lane.slip_speed) +
           lane.film * std::abs(slip);
}

Path path_down(const Lane& lane, double duration) {
    return Path(Slide(lane).steps(duration));
}

Path path_along(const Lane& lane, double speed, double surface, double duration) {
    return Path(Course(lane).steps(speed, surface, duration));
}

Path spin_of(const Lane& lane, double spin, double foot, double reach, double duration) {
    // Three spheres of a third of the mass: I = m (reach^2 + 2/5 foot^2).
    const double arm = reach / (reach * reach + 0.4 * foot * foot);
    const auto slowing = [&](double t, double w) {
        return -arm * friction_at(lane, w * reach) *
               (lane.gravity * std::cos(lane.slope) * shaken(lane, t) + lane.squeeze);
    };
    State s{0, std::abs(spin), slowing(0, std::abs(spin))};
    std::vector<State> all{s};
    while (s.t < duration) {
        const double h = std::min(step, duration - s.t), half = s.t + h / 2;
        const double a = slowing(s.t, s.y), b = slowing(half, s.y + h / 2 * a), c = slowing(half, s.y + h / 2 * b),
                     d = slowing(s.t + h, s.y + h * c);
        const double mean = (a + 2 * b + 2 * c + d) / 6;
        if (s.y > 0 && s.y + h * mean <= 0) { // it stops inside
            s = {s.t - s.y / mean, 0, a};
            all.push_back(s);
            s.v = 0;
            all.push_back({s.t + 1e-9, 0, 0});
        }
        s.y = s.y > 0 ? s.y + h * mean : 0;
        s.t += h;
        s.v = s.y > 0 ? slowing(s.t, s.y) : 0;
        all.push_back(s);
    }
    return Path(std::move(all));
}

} // namespace blind
