#pragma once

#include "base/carried.h"

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

/// What touches a part: contacts as the solver sees them, and the history of each body's.
namespace tumble::observe {

/// A place where a body touches a wall at one instant; vectors in the wall's own frame.
struct WallPush {
    std::int64_t body = 0; // id
    int triangle = 0;
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();     // m, on the wall
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();   // unit, towards the body
    Eigen::Vector3d force = Eigen::Vector3d::Zero();    // N, on the wall
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); // m/s, of the body's centre past the wall
    double patch = 0;                                   // m, radius of the circle in which they touch; 0: a point

    /// N, above 0: pressed.
    [[nodiscard]] double pressing() const { return -force.dot(normal); }
    [[nodiscard]] Eigen::Vector3d shearing() const { return force + pressing() * normal; }
};

/// One unbroken touch of a body. The thesis' impact step is number 1, its sliding step all that follow.
struct Touching {
    std::int64_t body = 0;
    int number = 1;      // in a row of touches that the body never leaves for longer than TouchHistory's pause
    double begin = 0;    // s
    double duration = 0; // s
    double since = std::numeric_limits<double>::quiet_NaN(); // s, from the end of the touch before; NaN: the first
    int triangle = 0;                                        // where it began
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();          // m, there
    double approach = 0;                                     // m/s, towards the wall, before it began
    double slip = 0;                                         // m/s, along it, before it began
    double peak_normal = 0;                                  // N, of all places that the body touches at once
    double peak_shear = 0;                                   // N, the same
    double normal_impulse = 0;                               // N s
    double shear_impulse = 0;                                // N s, of the force's size
    double peak_normal_time = 0;                             // s, when it pressed hardest
    double peak_shear_time = 0;                              // s, when it sheared hardest
};

template <class Archive, As<WallPush> P> void carry(Archive& archive, P& push) {
    auto& [body, triangle, foot, normal, force, velocity, patch] = push;
    archive(body, triangle, foot, normal, force, velocity, patch);
}

template <class Archive, As<Touching> T> void carry(Archive& archive, T& touch) {
    auto& [body, number, begin, duration, since, triangle, foot, approach, slip, peak_normal, peak_shear,
           normal_impulse, shear_impulse, peak_normal_time, peak_shear_time] = touch;
    archive(body, number, begin, duration, since, triangle, foot, approach, slip, peak_normal, peak_shear,
            normal_impulse, shear_impulse, peak_normal_time, peak_shear_time);
}

/// Builds touches from the contacts of every step.
class TouchHistory {
public:
    /// `step`: s, between two takes; `pause`: s, a body that was away for longer begins a new row.
    TouchHistory(double step, double pause) : step_(step), pause_(pause) {}

    /// All contacts with one wall at `time`, s; times rise by `step`.
    void take(double time, const std::vector<WallPush>& pushes);
    /// All touches in the order in which they began, those that still last included.
    [[nodiscard]] std::vector<Touching> touches() const;

    /// All that was taken, for checkpoints.
    template <class Archive, As<TouchHistory> H> friend void carry(Archive& archive, H& history) {
        std::vector<std::int64_t> bodies;
        std::vector<std::size_t> touches;
        std::vector<double> seen;
        for (const auto& [body, last] : history.last_) {
            bodies.push_back(body);
            touches.push_back(last.touch);
            seen.push_back(last.seen);
        }
        archive(history.touches_, bodies, touches, seen);
        if constexpr (!std::is_const_v<H>) {
            history.last_.clear();
            for (std::size_t k = 0; k < bodies.size() && k < touches.size() && k < seen.size(); ++k)
                history.last_[bodies[k]] = {touches[k], seen[k]};
        }
    }

private:
    double step_, pause_;
    std::vector<Touching> touches_;
    struct Last {
        std::size_t touch = 0; // into touches_
        double seen = 0;       // s
    };
    std::unordered_map<std::int64_t, Last> last_;
};

} // namespace tumble::observe
