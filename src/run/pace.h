#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace tumble::run {

/// How fast steps go. Decides only how often a run looks up from its work, never what it computes.
class Pace {
public:
    /// Steps that take about a tenth of a second, so that a stop is noticed soon and asking costs nothing.
    [[nodiscard]] std::int64_t stretch() const { return stretch_; }

    void start() { begun_ = Clock::now(); }
    void stop(std::int64_t steps) {
        const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
        seconds_ += seconds;
        if (seconds <= 0 || steps <= 0)
            return;
        const double rate = static_cast<double>(steps) / seconds;
        const double weight = std::min(1.0, seconds / 2.0); // remembers about two seconds
        rate_ = rate_ > 0 ? (1 - weight) * rate_ + weight * rate : rate;
        stretch_ = std::clamp(static_cast<std::int64_t>(0.1 * rate), std::int64_t{1}, 4 * stretch_);
    }

    [[nodiscard]] double steps_per_s() const { return rate_; }
    /// s of wall time between all starts and stops.
    [[nodiscard]] double seconds() const { return seconds_; }
    /// s of wall time since this was made.
    [[nodiscard]] double since_made() const { return std::chrono::duration<double>(Clock::now() - made_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point made_ = Clock::now();
    Clock::time_point begun_ = made_;
    double seconds_ = 0;
    double rate_ = 0;
    std::int64_t stretch_ = 1;
};

} // namespace tumble::run
