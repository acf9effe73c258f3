#include "throw.h"

#include <algorithm>
#include <cmath>

namespace blind {

namespace {

constexpr double flight_step = 1e-3;            // s
constexpr double contact_step = 1.4e-4 / 14;    // s
constexpr double kept_apart = 5 * contact_step; // s, of states in a contact
constexpr double pi = 3.14159265358979323846;

struct Motion {
    double t = 0, x = 0, y = 0, vx = 0, vy = 0, spin = 0; // spin about z: rad/s
};

class Thrown {
public:
    Thrown(const Ball& ball, const Lane& ground)
        : ball_(ball), ground_(ground), pull_(ball.gravity * std::sin(ground.slope)),
          weight_(ball.gravity * std::cos(ground.slope)) {}

    Flight until(Motion m, double end) {
        std::vector<State> along, height;
        const auto keep = [&] {
            along.push_back({m.t, m.x, m.vx});
            height.push_back({m.t, m.y, m.vy});
        };
        keep();
        while (m.t < end) {
            if (touching_)
                touch(m, std::min(contact_step, end - m.t));
            else
                fly(m, std::min(flight_step, end - m.t));
            if (m.t > along.back().t && (!touching_ || m.t >= along.back().t + kept_apart || m.t >= end))
                keep();
        }
        return {Path(std::move(along)), Path(std::move(height))};
    }

private:
    struct Pull {
        double x = 0, y = 0; // m/s2
    };

    [[nodiscard]] Pull in_flight(const Motion& m) const {
        const double drag = (ball_.linear + ball_.quadratic * std::hypot(m.vx, m.vy)) / ball_.mass;
        const double turn = ball_.magnus * m.spin;
        return {pull_ - drag * m.vx - turn * m.vy, turn * m.vx - drag * m.vy - weight_};
    }

    [[nodiscard]] Motion flown(const Motion& m, double h) const {
        const auto at = [&](double share, const Pull& a) {
            Motion there = m;
            there.vx += share * h * a.x;
            there.vy += share * h * a.y;
            return there;
        };
        const Pull a = in_flight(m), b = in_flight(at(0.5, a)), c = in_flight(at(0.5, b)), d = in_flight(at(1, c));
        Motion next = m;
        next.t += h;
        next.x += h * m.vx + h * h / 6 * (a.x + b.x + c.x);
        next.y += h * m.vy + h * h / 6 * (a.y + b.y + c.y);
        next.vx += h / 6 * (a.x + 2 * b.x + 2 * c.x + d.x);
        next.vy += h / 6 * (a.y + 2 * b.y + 2 * c.y + d.y);
        return next;
    }

    void fly(Motion& m, double h) {
        const Motion next = flown(m, h);
        if (next.y >= ball_.radius) {
            m = next;
            return;
        }
        double lo = 0, hi = h; // bisection down to a rounding error
        for (int k = 0; k < 60; ++k) {
            const double middle = (lo + hi) / 2;
            (flown(m, middle).y >= ball_.radius ? lo : hi) = middle;
        }
        m = flown(m, lo);
        m.y = ball_.radius;
        const double e = rebound_of(ball_, m.vy, m.t, impacts_++);
        damping_ = 2 * std::sqrt(5.0 / 6) * -std::log(e) / std::hypot(pi, std::log(e));
        stretch_ = 0;
        touching_ = true;
    }

    void touch(Motion& m, double h) {
        const double overlap = std::max(0.0, ball_.radius - m.y);
        const double reach = std::sqrt(ball_.radius * overlap); // radius of the contact
        const double elastic = 4.0 / 3 * ball_.modulus * reach * overlap;
        const double pressed =
            elastic - damping_ * std::sqrt(2 * ball_.modulus * reach * ball_.mass) * m.vy; // N, without adhesion
        const double stuck = overlap > 0 ? 2 * pi * ball_.adhesion * ball_.radius : 0;

        const double arm = (ball_.radius + m.y) / 2; // to the middle of the overlap
        const double slip = m.vx + m.spin * arm;
        const double stiffness = 8 * ball_.shear * reach;
        const double limit = friction_at(ground_, slip) * std::abs(pressed);
        stretch_ += slip * h;
        double grip = -stiffness * stretch_;
        if (std::abs(grip) > limit) {
            grip = std::copysign(limit, grip);
            stretch_ = stiffness > 0 ? -grip / stiffness : 0;
        } else {
            grip -= damping_ * std::sqrt(stiffness * ball_.mass) * slip;
        }
        const double held_back =
            m.spin == 0 ? 0 : -std::copysign(ground_.rolling * ball_.radius * std::abs(pressed), m.spin);
        const Pull air = in_flight(m);
        const double inertia = 0.4 * ball_.mass * ball_.radius * ball_.radius;
        m.vx += h * (air.x + grip / ball_.mass);
        m.vy += h * (air.y + (pressed - stuck) / ball_.mass);
        m.spin += h * (grip * arm + held_back) / inertia;
        m.x += h * m.vx;
        m.y += h * m.vy;
        m.t += h;
        if (m.y > ball_.radius && m.vy > 0)
            touching_ = false;
    }

    const Ball& ball_;
    const Lane& ground_;
    double pull_, weight_; // m/s2, along the plate and upon it
    bool touching_ = false;
    int impacts_ = 0;
    double damping_ = 0; // of sqrt(stiffness times mass), what makes it rebound so
    double stretch_ = 0; // m, of Mindlin's spring
};

} // namespace

Flight flight_of(const Ball& ball, const Lane& ground, double height, double speed, double duration) {
    return Thrown(ball, ground).until({.y = height, .vx = speed}, duration);
}

} // namespace blind
