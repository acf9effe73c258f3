#pragma once

#include "base/phases.h"
#include "render/gl.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace tumble::render {

/// Where the time of a picture goes. The graphics library works when it likes: a clock that is on waits for it after
/// every phase.
class PhaseClock {
public:
    void start(bool on) {
        on_ = on;
        began_ = Clock::now();
    }
    /// What has been done since the last lap, or since the start.
    void lap(const char* name) {
        if (!on_) {
            return;
        }
        glFinish();
        const Clock::time_point now = Clock::now();
        auto phase = std::find_if(times_.begin(), times_.end(), [&](const PhaseTime& p) { return p.name == name; });
        if (phase == times_.end()) {
            phase = times_.insert(times_.end(), PhaseTime{name, 0});
        }
        phase->seconds += std::chrono::duration<double>(now - began_).count();
        began_ = now;
    }
    /// Summed over all pictures, in the order in which they first came.
    [[nodiscard]] const std::vector<PhaseTime>& times() const { return times_; }

private:
    using Clock = std::chrono::steady_clock;
    bool on_ = false;
    Clock::time_point began_;
    std::vector<PhaseTime> times_;
};

} // namespace tumble::render
