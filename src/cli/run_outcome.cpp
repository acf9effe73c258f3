#include "cli/run_outcome.h"

#include "base/text.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/stop_flag.h"
#include "run/run_report.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::cli {

namespace {

/// In the run's folder, or by its whole path when it lies elsewhere.
std::string name_of_video(const run::RunSummary& summary) {
    const std::filesystem::path& file = summary.video_file;
    return (file.parent_path() == summary.folder ? file.filename() : file).string();
}

std::string sentences(const run::RunSummary& summary) {
    std::string text =
        fmt::format("{}: {} at t = {:.6g} s after {}, {}\n", summary.folder.string(), summary.state, summary.time,
                    counted(summary.steps, "step", "steps"), counted(summary.bodies, "body", "bodies"));
    text += fmt::format("  {}, {}", counted(summary.rows, "row in series.csv", "rows in series.csv"),
                        counted(summary.frames, "frame", "frames"));
    if (summary.pictures > 0)
        text += ", " + counted(summary.pictures, "picture in pictures/", "pictures in pictures/");
    if (summary.video && summary.frames > 0)
        text += ", " + name_of_video(summary) + " (" + video_pace(summary.video_slowdown) + ")";
    text += "\n";
    if (summary.state != "finished" && !summary.checkpoint.empty())
        text += "  " + summary.checkpoint.string() + " is there: the same command with --resume goes on from it\n";
    if (summary.stepping_s > 0)
        text += fmt::format("  took {}: {:.3g} steps/s, {:.3g} body-steps/s on {}\n", duration(summary.wall_s),
                            static_cast<double>(summary.steps) / summary.stepping_s,
                            summary.body_steps / summary.stepping_s, counted(summary.threads, "thread", "threads"));
    if (summary.pictures > 0 || summary.video || summary.waited_s > 0.1 * summary.wall_s)
        text += fmt::format("  drawing and writing frames took {} beside the steps, which waited {} for it\n",
                            duration(summary.frames_s), duration(summary.waited_s));
    if (std::isfinite(summary.books.closure))
        text += fmt::format("  the energy balance misses {} of {}", format_si(summary.books.closure, "J", 3),
                            format_si(summary.energy_turnover, "J", 3));
    else
        text += fmt::format("  losses are known in sum only: {}", format_si(summary.books.lost_in_sum, "J", 3));
    return text;
}

} // namespace

std::string video_pace(double slowdown) {
    if (std::abs(slowdown - 1) < 1e-6)
        return "plays as fast as life";
    return slowdown > 1 ? fmt::format("plays {:.3g} times slower than life", slowdown)
                        : fmt::format("plays {:.3g} times faster than life", 1 / slowdown);
}

int tell_outcome(const run::RunSummary& summary, bool json, bool quiet) {
    if (json)
        say_json(run::to_json(summary));
    else if (!quiet)
        say(sentences(summary));
    if (summary.state == "failed")
        return refuse(summary.reason, false, failed);
    return summary.state == "stopped" ? stop_code() : static_cast<int>(fine);
}

} // namespace tumble::cli
