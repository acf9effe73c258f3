#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tumble::run {

/// Steps at which something is due: those nearest to 0, every, 2 every, ... Computed from the number of the event, so
/// nothing adds up over a long run; events closer than a step fall together.
class Schedule {
public:
    /// every and step in s.
    Schedule(double every, double step) : every_(every), step_(step) {}

    [[nodiscard]] std::int64_t next() const { return step_of(number_); }
    [[nodiscard]] bool due(std::int64_t step) const { return step >= next(); }
    /// To the first event after `step`.
    void pass(std::int64_t step) {
        number_ = std::max(number_, static_cast<std::int64_t>(static_cast<double>(step) * step_ / every_));
        while (next() <= step)
            ++number_;
    }

    /// Events in steps 0 .. last.
    [[nodiscard]] std::int64_t count(std::int64_t last) const {
        if (every_ < step_)
            return last + 1;
        auto number = static_cast<std::int64_t>(static_cast<double>(last) * step_ / every_);
        while (step_of(number + 1) <= last)
            ++number;
        while (number > 0 && step_of(number) > last)
            --number;
        return number + 1;
    }

    /// The same with the last step itself, which is always kept.
    [[nodiscard]] std::int64_t count_with_last(std::int64_t last) const {
        return count(last) + (every_ < step_ || step_of(count(last) - 1) == last ? 0 : 1);
    }

private:
    [[nodiscard]] std::int64_t step_of(std::int64_t number) const {
        return std::llround(static_cast<double>(number) * every_ / step_);
    }

    double every_;
    double step_;
    std::int64_t number_ = 0;
};

} // namespace tumble::run
