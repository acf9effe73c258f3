#include "observe/part_loads.h"

#include <map>

namespace tumble::observe {

namespace {

using Eigen::Vector3d;

/// Of one body, over all the places where it touches.
struct Sum {
    const WallPush* first = nullptr;
    double pressing = 0;                  // N
    Vector3d shearing = Vector3d::Zero(); // N
};

Touching begun(const WallPush& push, double time) {
    Touching touch;
    touch.body = push.body;
    touch.begin = touch.peak_normal_time = touch.peak_shear_time = time;
    touch.triangle = push.triangle;
    touch.foot = push.foot;
    touch.approach = -push.velocity.dot(push.normal);
    touch.slip = (push.velocity + touch.approach * push.normal).norm();
    return touch;
}

} // namespace

void TouchHistory::take(double time, const std::vector<WallPush>& pushes) {
    std::map<std::int64_t, Sum> bodies;
    for (const WallPush& push : pushes) {
        Sum& sum = bodies[push.body];
        if (!sum.first)
            sum.first = &push;
        sum.pressing += push.pressing();
        sum.shearing += push.shearing();
    }
    for (const auto& [body, sum] : bodies) {
        const auto [entry, fresh] = last_.try_emplace(body, Last{touches_.size(), time});
        Last& last = entry->second;
        if (fresh || time - last.seen > 1.5 * step_) {
            Touching touch = begun(*sum.first, time);
            if (!fresh) {
                touch.since = time - last.seen;
                touch.number = touch.since > pause_ ? 1 : touches_[last.touch].number + 1;
            }
            last.touch = touches_.size();
            touches_.push_back(touch);
        }
        last.seen = time;
        Touching& touch = touches_[last.touch];
        const double shear = sum.shearing.norm();
        touch.duration += step_;
        if (sum.pressing > touch.peak_normal) {
            touch.peak_normal = sum.pressing;
            touch.peak_normal_time = time;
        }
        if (shear > touch.peak_shear) {
            touch.peak_shear = shear;
            touch.peak_shear_time = time;
        }
        touch.normal_impulse += step_ * sum.pressing;
        touch.shear_impulse += step_ * shear;
    }
}

std::vector<Touching> TouchHistory::touches() const {
    return touches_;
}

} // namespace tumble::observe
