#include "run/run_report.h"

#include "observe/whole_file.h"
#include "run/build_mark.h"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <string>
#include <sys/utsname.h>
#include <thread>

namespace tumble::run {

namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) {
            const std::size_t colon = line.find(": ");
            return colon == std::string::npos ? "" : line.substr(colon + 2);
        }
    return "unknown processor";
}

nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

std::string in_one_line(const Problems& problems) {
    std::string text;
    for (const Problem& problem : problems)
        text += (text.empty() ? "" : "; ") + problem.what + (problem.fix.empty() ? "" : " (" + problem.fix + ")");
    return text;
}

} // namespace

nlohmann::json read_summary(const RunFolder& folder) {
    const Result<std::string> text = observe::read_whole(folder.summary());
    const auto json = nlohmann::json::parse(text ? *text : "", nullptr, false);
    return json.is_object() ? json : nlohmann::json::object();
}

std::string version() {
    return TUMBLE_VERSION;
}

std::string host() {
    utsname system{};
    uname(&system);
    return fmt::format("{}, {} cores, {} {}", processor(), std::thread::hardware_concurrency(), system.sysname,
                       system.release);
}

nlohmann::ordered_json to_json(const RunSummary& summary) {
    nlohmann::ordered_json json;
    json["state"] = summary.state;
    json["reason"] = in_one_line(summary.reason);
    json["version"] = version();
    json["build_mark"] = build_mark();
    json["host"] = host();
    json["threads"] = summary.threads;
    json["seed"] = summary.seed;
    json["scene"] = summary.scene.string();
    json["title"] = summary.title;
    json["folder"] = summary.folder.string();
    json["duration_s"] = summary.duration;
    json["solver"] = summary.solver == scene::Solver::box2d ? "box2d" : "soft";
    json["time_step_s"] = summary.time_step;
    json["time_s"] = summary.time;
    json["steps"] = summary.steps;
    json["bodies"] = summary.bodies;
    json["rows"] = summary.rows;
    json["frames"] = summary.frames;
    json["pictures"] = summary.pictures;
    json["video"] = summary.video;
    json["video_slowdown"] = summary.video_slowdown;
    json["video_file"] = summary.video_file.string();
    json["wall_s"] = number(summary.wall_s);
    json["processor_s"] = number(summary.processor_s);
    json["frames_s"] = number(summary.frames_s);
    json["waited_for_frames_s"] = number(summary.waited_s);
    const double stepping = summary.stepping_s;
    json["steps_per_s"] = number(stepping > 0 ? static_cast<double>(summary.steps) / stepping : 0);
    json["body_steps_per_s"] = number(stepping > 0 ? summary.body_steps / stepping : 0);
    nlohmann::ordered_json phases = nlohmann::ordered_json::object();
    for (const PhaseTime& phase : summary.phases)
        phases[phase.name] = number(phase.seconds);
    phases["around the steps"] = number(summary.wall_s - stepping);
    json["phases_s"] = phases;
    json["energy_closure_J"] = number(summary.books.closure);
    json["energy_turnover_J"] = number(summary.energy_turnover);
    json["kinetic_energy_J"] = number(summary.books.kinetic_translation + summary.books.kinetic_rotation);
    json["overlap_ratio_max"] = number(summary.overlap_ratio_max);
    json["unfilled"] = summary.unfilled;
    json["warnings"] = summary.warnings;
    json["checkpoint"] = summary.checkpoint.string();
    json["checkpoints"] = summary.checkpoints;
    json["checkpoint_bytes"] = summary.checkpoint_bytes;
    json["checkpoints_s"] = number(summary.checkpoints_s);
    json["resumed"] = nlohmann::ordered_json::array();
    for (const Resumption& resumption : summary.resumed)
        json["resumed"].push_back({{"checkpoint", resumption.checkpoint},
                                   {"step", resumption.step},
                                   {"time_s", number(resumption.time)},
                                   {"build_mark", resumption.build_mark},
                                   {"changes", resumption.changes}});
    return json;
}

} // namespace tumble::run
