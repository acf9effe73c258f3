#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

namespace tumble::run {

/// How fast steps go. Decides only how often a run looks up from its work, never what it computes.
class Pace {
public:
    /// Steps that take about a tenth of a second, so that a stop is noticed soon and asking costs nothing.
    [[nodiscard]] std::int64_t stretch() const { return stretch_; }

    void start() { begun_ = Clock::now(); }
    void stop(std::int64_t steps) {
        const Clock::time_point now = Clock::now();
        const double seconds = seconds_between(begun_, now);
        const double round = seconds_between(std::exchange(stopped_, now), now);
        seconds_ += seconds;
        if (seconds <= 0 || steps <= 0)
            return;
        const double weight = std::min(1.0, round / 2.0); // remembers about two seconds
        const double lately = static_cast<double>(steps) / round;
        rate_ = rate_ > 0 ? (1 - weight) * rate_ + weight * lately : lately;
        const double ahead = 0.1 * static_cast<double>(steps) / seconds;
        stretch_ = std::clamp(static_cast<std::int64_t>(ahead), std::int64_t{1}, 4 * stretch_);
    }

    /// Of wall time, waiting for observers included: what the time left is guessed from.
    [[nodiscard]] double steps_per_s() const { return rate_; }
    /// s of wall time between all starts and stops.
    [[nodiscard]] double seconds() const { return seconds_; }
    /// s of wall time since this was made.
    [[nodiscard]] double since_made() const { return std::chrono::duration<double>(Clock::now() - made_).count(); }

private:
    using Clock = std::chrono::steady_clock;

    static double seconds_between(Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    }

    Clock::time_point made_ = Clock::now();
    Clock::time_point begun_ = made_;
    Clock::time_point stopped_ = made_;
    double seconds_ = 0;
    double rate_ = 0;
    std::int64_t stretch_ = 1;
};

} // namespace tumble::run
