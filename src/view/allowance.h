#pragma once

#include <algorithm>
#include <chrono>

namespace tumble::view {

/// So many a second, and as many at once.
class Allowance {
public:
    using Clock = std::chrono::steady_clock;

    explicit Allowance(double per_s, Clock::time_point now = Clock::now())
        : per_s_(per_s), left_(per_s), counted_(now) {}

    /// False when there is none left.
    bool take(Clock::time_point now = Clock::now()) {
        left_ = std::min(per_s_, left_ + per_s_ * std::chrono::duration<double>(now - counted_).count());
        counted_ = now;
        if (left_ < 1)
            return false;
        left_ -= 1;
        return true;
    }

private:
    double per_s_;
    double left_;
    Clock::time_point counted_;
};

} // namespace tumble::view
