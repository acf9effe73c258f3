#pragma once

#include "../folder.h"
#include "run/checkpoint_files.h"
#include "run/run_scene.h"

#include <atomic>
#include <doctest/doctest.h>
#include <map>
#include <nlohmann/json.hpp>

/// Runs that are stopped, broken off and resumed, and what their folders hold.
namespace tumble::test {

/// Stops its run as soon as it has come to a step, and hears what it says.
struct Stopper : run::RunListener {
    explicit Stopper(std::int64_t step) : at(step) {}
    void started(const std::filesystem::path&, const run::Progress& now) override { progressed(now); }
    void progressed(const run::Progress& now) override {
        if (now.step >= at)
            stop = true;
    }
    void warned(const std::string& sentence) override { heard.push_back(sentence); }

    std::int64_t at;
    std::atomic<bool> stop{false};
    std::vector<std::string> heard;
};

constexpr std::int64_t never = 1'000'000'000;

struct Outcome {
    Problems problems;
    run::RunSummary summary;
    std::vector<std::string> heard;
};

inline Outcome ran(const scene::Scene& scene, run::RunOptions options, std::int64_t stop_at = never) {
    Stopper stopper(stop_at);
    options.stop = &stopper.stop;
    const auto summary = run::run_scene(scene, options, stopper);
    return {summary.problems(), summary ? *summary : run::RunSummary{}, stopper.heard};
}

inline run::RunOptions in(const std::filesystem::path& folder, int threads = 1) {
    run::RunOptions options;
    options.folder = folder;
    options.threads = threads;
    return options;
}

inline run::RunOptions going_on_in(const std::filesystem::path& folder, int threads = 1) {
    run::RunOptions options = in(folder, threads);
    options.resume = true;
    return options;
}

inline std::filesystem::path newest(const std::filesystem::path& folder) {
    const auto files = run::list_checkpoints(folder / "state");
    REQUIRE_FALSE(files.empty());
    return files.front();
}

/// Every file of a run's folder by its name, but for what tells wall times; of the last checkpoint the state.
inline std::map<std::string, std::string> content_of_run(const std::filesystem::path& folder) {
    std::map<std::string, std::string> content;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() != ".ckpt" && entry.path().filename() != "run.json")
            content[entry.path().lexically_relative(folder).string()] = content_of(entry.path());
    const std::filesystem::path last = newest(folder);
    const auto checkpoint = run::checkpoint_from(content_of(last), last);
    REQUIRE_MESSAGE(checkpoint.ok(), to_string(checkpoint.problems()));
    content["the state"] = checkpoint->world;
    return content;
}

inline void check_same_run(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto of_a = content_of_run(a), of_b = content_of_run(b);
    CHECK(of_a.size() == of_b.size());
    for (const auto& [name, content] : of_a)
        CHECK_MESSAGE((of_b.contains(name) && of_b.at(name) == content), name);
}

inline nlohmann::json summary_in(const std::filesystem::path& folder) {
    return nlohmann::json::parse(content_of(folder / "run.json"));
}

} // namespace tumble::test
