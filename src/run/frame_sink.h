#pragma once

#include "base/problem.h"
#include "observe/frame.h"
#include "render/plot_line.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tumble::run {

/// One frame on its way to those who keep it.
struct Shot {
    observe::Frame frame;
    std::int64_t number = 0; // from 0, without gaps
    render::PlotLine plot;   // the live plot's measure so far
    bool again = false;      // read from frames/, where the run that is resumed kept it
};

/// Keeps frames in one form. All calls come from one thread, frames in order.
class FrameSink {
public:
    virtual ~FrameSink() = default;
    /// Problems: the frame could not be kept; the run then ends.
    virtual Result<Done> take(const Shot& shot) = 0;
    /// After the last frame; also after a failure elsewhere, to make the best of what came so far.
    virtual Result<Done> finish() { return Done{}; }
    /// What whoever asked for it should know of what was kept.
    [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
};

using FrameSinks = std::vector<std::unique_ptr<FrameSink>>;

} // namespace tumble::run
