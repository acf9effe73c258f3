#pragma once

#include "base/problem.h"
#include "base/stop.h"
#include "run/frame_sink.h"
#include "run/measure_names.h"
#include "run/run_folder.h"
#include "scene/scene.h"

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

/// Frames of a run that is over (finished, stopped, failed or killed), handed on once more.
namespace tumble::run {

struct ReplayOptions {
    double from = -std::numeric_limits<double>::infinity(); // s
    double to = std::numeric_limits<double>::infinity();    // s
    std::optional<Plotted> plotted{};                       // in the small plot; may be missing in series.csv
    double duration = 0;                                    // s, of the whole run: where the plot's time axis ends
    StopFlag stop = nullptr;
};

struct Replayed {
    std::int64_t frames = 0;
    double first = 0; // s
    double last = 0;  // s
    bool stopped = false;
    Problems reason;                   // why it broke off, as on a full disk; empty otherwise
    std::vector<std::string> warnings; // frames that could not be read and were left out, a run that did not end
};

/// Done and all, in frames.
using TellFrames = std::function<void(std::int64_t done, std::int64_t all)>;

/// A frame of a run as far as its head tells of it.
struct RecordedFrame {
    std::filesystem::path file;
    double time = 0;       // s
    bool contacts = false; // it has kept who touches whom
    double slack = 0;      // s by which it may miss the time that it stands for: half a step
};

/// An opened run: its layout and the frames in the wanted stretch of time.
struct Recording {
    RunFolder folder;
    std::shared_ptr<const observe::FrameLayout> layout;
    std::vector<RecordedFrame> frames;
    std::vector<std::string> warnings;
    Eigen::AlignedBox3d bounds{}; // m, of all bodies and walls in these frames; empty where only heads were read
};

/// What is read of a run as it is opened: all of the wanted frames, which are whole and unchanged then and have bounds,
/// or the heads alone, which leaves it to whoever reads a frame to find out that it is damaged. Of frames at other
/// times heads are enough.
enum class Reading { whole, heads };

/// What run.json says of a run that did not reach its end; nothing for one that did.
std::vector<std::string> how_it_ended(const RunFolder& folder);

/// s, that usually lie between frames; nothing where there are not two of them.
std::optional<double> pace_of(const std::vector<RecordedFrame>& frames);

/// Whether a frame lies in a stretch of time (s): frames sit at the steps nearest to their times, so half a step counts
/// as no difference.
bool is_within(const RecordedFrame& frame, double from, double to);

/// Why nothing can be shown of a stretch of time in which no frame lies; `times` (all s) are those of the run's frames,
/// one at least.
Problem refuse_time(const std::string& run, const std::vector<double>& times, double from, double to);

/// With the frames that lie in the stretch of time. Problems: no run's folder, a
/// broken layout, no readable frame in the stretch of time.
Result<Recording> open_recording(const std::filesystem::path& root, const ReplayOptions& options,
                                 Reading reading = Reading::whole);

/// The ends of one scale of colours for all frames of the recordings, SI. Problems: a quantity that one of them has
/// not.
Result<std::array<double, 2>> colors_for(std::span<const Recording> recordings, const std::string& color);

/// Problems: trails of bodies that the last frames of none of the recordings have, two trails of one body.
Result<Done> check_trails(std::span<const Recording> recordings, const std::vector<std::string>& trails);

/// Marks whose scales, where they were left open, hold what all frames of the recordings have: 98th percentiles, as for
/// colours. The mean field's scale stays open: it belongs to a camera. Problems: force chains where no frame has
/// contacts.
Result<scene::Marks> marks_for(std::span<const Recording> recordings, const scene::Marks& marks);

/// Settings whose range of colours and marks hold for all frames of the recordings. Problems: those of the three above.
Result<scene::Render> settle_scales(std::span<const Recording> recordings, const scene::Render& settings);

/// Hands every frame to every sink in order, under the number it has in the run, and finishes them.
Replayed replay(const Recording& recording, const ReplayOptions& options, const FrameSinks& sinks,
                const TellFrames& tell);

} // namespace tumble::run
