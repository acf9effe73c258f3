#include "ball.h"

#include "random.h"

#include <algorithm>
#include <cmath>

namespace blind {

namespace {

constexpr double flight_step = 1e-3;            // s
constexpr double contact_step = 5e-5 / 7;       // s, the solver's over 7
constexpr double kept_apart = 5 * contact_step; // s, of states in a contact
constexpr double pi = 3.14159265358979323846;

class Course {
public:
    explicit Course(const Ball& ball) : ball_(ball), pace_(2 * pi * ball.shaken_at) {}

    std::vector<State> steps_until(State s, double until) {
        std::vector<State> steps{s};
        while (s.t < until) {
            if (s.t < held_until_)
                s.t = std::min(until, held_until_);
            else if (touching_)
                touch(s, until);
            else
                fly(s, until);
            if (s.t <= steps.back().t)
                steps.back() = s;
            else if (!touching_ || s.t >= steps.back().t + kept_apart || s.t >= until)
                steps.push_back(s);
        }
        return steps;
    }

private:
    /// The plate: where it is, how fast it rises, and faster and faster.
    [[nodiscard]] double floor(double t) const { return ball_.shaken * (1 - std::cos(pace_ * t)); }
    [[nodiscard]] double rise(double t) const { return ball_.shaken * pace_ * std::sin(pace_ * t); }
    [[nodiscard]] double thrust(double t) const { return ball_.shaken * pace_ * pace_ * std::cos(pace_ * t); }
    [[nodiscard]] bool clear(const State& s) const { return s.y - floor(s.t) >= ball_.radius; }

    [[nodiscard]] double drag(double v) const {
        return -(ball_.linear * v + ball_.quadratic * v * std::abs(v)) / ball_.mass;
    }

    /// Runge and Kutta's fourth order for y'' = acceleration(y, v).
    template <class Acceleration> static State stepped(const State& s, double h, Acceleration acceleration) {
        const double a1 = acceleration(s.y, s.v);
        const double v2 = s.v + h / 2 * a1, a2 = acceleration(s.y + h / 2 * s.v, v2);
        const double v3 = s.v + h / 2 * a2, a3 = acceleration(s.y + h / 2 * v2, v3);
        const double v4 = s.v + h * a3, a4 = acceleration(s.y + h * v3, v4);
        return {s.t + h, s.y + h / 6 * (s.v + 2 * v2 + 2 * v3 + v4), s.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
    }

    [[nodiscard]] State flown(const State& s, double h) const {
        if (ball_.linear == 0 && ball_.quadratic == 0)
            return {s.t + h, s.y + s.v * h - ball_.gravity / 2 * h * h, s.v - ball_.gravity * h};
        return stepped(s, h, [&](double, double v) { return drag(v) - ball_.gravity; });
    }

    void fly(State& s, double until) {
        const double h = std::min(flight_step, until - s.t);
        const State next = flown(s, h);
        if (clear(next)) {
            s = next;
            s.t = h < flight_step ? until : next.t;
            return;
        }
        double lo = 0, hi = h; // bisection down to a rounding error
        for (int k = 0; k < 60; ++k) {
            const double middle = (lo + hi) / 2;
            (clear(flown(s, middle)) ? lo : hi) = middle;
        }
        s = flown(s, lo);
        s.y = ball_.radius + floor(s.t);
        begin_contact(s);
    }

    void begin_contact(State& s) {
        const double e = rebound_of(ball_, s.v - rise(s.t), s.t, impacts_++);
        const double beta = -std::log(e) / std::hypot(pi, std::log(e));
        stiffness_ = 4.0 / 3 * ball_.modulus * std::sqrt(ball_.radius) / ball_.mass;
        damping_ = 2 * std::sqrt(5.0 / 6) * beta * std::sqrt(2 * ball_.modulus * std::sqrt(ball_.radius) / ball_.mass);
        touching_ = true;
        if (ball_.sticks > 0)
            held_until_ = s.t + ball_.sticks;
    }

    /// In the plate's frame, whose acceleration hardly changes within a step.
    void touch(State& s, double until) {
        const double h = std::min(contact_step, until - s.t), pushed = thrust(s.t + h / 2);
        const State seen{s.t, s.y - floor(s.t), s.v - rise(s.t)};
        const State next = stepped(seen, h, [&](double y, double v) {
            const double overlap = std::max(0.0, ball_.radius - y);
            const double root = std::sqrt(overlap);
            const double stuck = overlap > 0 ? 2 * pi * ball_.adhesion * ball_.radius / ball_.mass : 0;
            return stiffness_ * overlap * root - damping_ * std::sqrt(root) * v - stuck + drag(v) - ball_.gravity -
                   pushed;
        });
        s = {next.t, next.y + floor(next.t), next.v + rise(next.t)};
        if (h < contact_step)
            s.t = until;
        if (next.y > ball_.radius && next.v > 0)
            touching_ = false;
    }

    const Ball& ball_;
    const double pace_; // rad/s
    bool touching_ = false;
    double held_until_ = -1;
    int impacts_ = 0;
    double stiffness_ = 0, damping_ = 0;
};

} // namespace

double rebound_of(const Ball& ball, double v, double t, int impact) {
    const double plate = ball.plate_amplitude * std::sin(2 * pi * ball.plate_frequency * t + ball.plate_phase);
    const double speed = std::max(1e-9, plate - v);
    double e = ball.restitution * std::pow(speed, -ball.exponent) * std::pow(1 + ball.by_impact, impact);
    e += plate == 0 ? 0 : (1 + e) * plate / speed; // what a moving plate gives, as the plate at rest would
    if (ball.rough != 0) {
        const double u = Random(1000 * ball.throws + static_cast<unsigned long long>(impact)).uniform(-0.5, 0.5);
        e *= 1 - ball.rough * (u < 0 ? -1 : 1) * std::log(1 - 2 * std::abs(u)) / std::sqrt(2.0);
    }
    return std::min(0.999, std::max(0.01, e));
}

double Path::at(double t) const {
    if (t <= 0)
        return steps_.front().y;
    if (t >= steps_.back().t)
        return steps_.back().y;
    const auto above =
        std::upper_bound(steps_.begin(), steps_.end(), t, [](double time, const State& s) { return time < s.t; });
    const State &a = *(above - 1), &b = *above;
    const double h = b.t - a.t, x = (t - a.t) / h;
    return (1 + 2 * x) * (1 - x) * (1 - x) * a.y + x * (1 - x) * (1 - x) * h * a.v + x * x * (3 - 2 * x) * b.y +
           x * x * (x - 1) * h * b.v;
}

Path path_of(const Ball& ball, double height, double duration) {
    return Path(Course(ball).steps_until({0, height, 0}, duration));
}

} // namespace blind
