#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <optional>
#include <utility>

namespace tumble::run {

/// How fast something goes on, from how much of it was done in which time: the mean over all of it at first, later over
/// about the last quarter, at least ten seconds. What is slow now and then (a frame, a checkpoint) hardly shows.
class SteadyRate {
public:
    void add(double done, double seconds) {
        if (seconds <= 0)
            return;
        watched_ += seconds;
        const double remembers = std::min(watched_, std::max(10.0, watched_ / 4));
        const double weight = std::min(1.0, seconds / remembers); // a stall may last longer than what is remembered
        rate_ += weight * (done / seconds - rate_);
    }
    /// s for as much more; nothing before two seconds were watched.
    [[nodiscard]] std::optional<double> seconds_for(double more) const {
        return watched_ >= 2 && rate_ > 0 ? std::optional(more / rate_) : std::nullopt;
    }

private:
    double watched_ = 0; // s
    double rate_ = 0;    // of it per s
};

/// How fast steps go. Decides only how often a run looks up from its work, never what it computes.
class Pace {
public:
    /// Steps that take about a tenth of a second, so that a stop is noticed soon and asking costs nothing.
    [[nodiscard]] std::int64_t stretch() const { return stretch_; }

    void start() { begun_ = Clock::now(); }
    void stop(std::int64_t steps) {
        const Clock::time_point now = Clock::now();
        const double seconds = seconds_between(begun_, now);
        const double round = seconds_between(std::exchange(stopped_, now).value_or(begun_), now);
        seconds_ += seconds;
        if (seconds <= 0 || steps <= 0)
            return;
        const double weight = std::min(1.0, round / 2.0); // remembers about two seconds
        const double lately = static_cast<double>(steps) / round;
        steady_.add(static_cast<double>(steps), round);
        rate_ = rate_ > 0 ? (1 - weight) * rate_ + weight * lately : lately;
        const double ahead = 0.1 * static_cast<double>(steps) / seconds;
        stretch_ = std::clamp(static_cast<std::int64_t>(ahead), std::int64_t{1}, 4 * stretch_);
    }

    /// Of wall time, waiting for observers included.
    [[nodiscard]] double steps_per_s() const { return rate_; }
    /// s of wall time that so many more steps will take; nothing while too little was seen.
    [[nodiscard]] std::optional<double> seconds_for(std::int64_t steps) const {
        return steady_.seconds_for(static_cast<double>(steps));
    }
    /// s of wall time between all starts and stops.
    [[nodiscard]] double seconds() const { return seconds_; }
    /// s of wall time since this was made.
    [[nodiscard]] double since_made() const { return std::chrono::duration<double>(Clock::now() - made_).count(); }
    /// s of processor time of the program's threads since this was made.
    [[nodiscard]] double processor_since_made() const {
        return static_cast<double>(std::clock() - clock_made_) / CLOCKS_PER_SEC;
    }

private:
    using Clock = std::chrono::steady_clock;

    static double seconds_between(Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    }

    Clock::time_point made_ = Clock::now();
    std::clock_t clock_made_ = std::clock();
    Clock::time_point begun_ = made_;
    std::optional<Clock::time_point> stopped_; // a round lasts from one stop to the next, the first from its start
    double seconds_ = 0;
    double rate_ = 0;
    SteadyRate steady_;
    std::int64_t stretch_ = 1;
};

} // namespace tumble::run
