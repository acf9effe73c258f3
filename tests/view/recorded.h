#pragma once

#include "../folder.h"
#include "../run/scenes.h"
#include "run/run_scene.h"
#include "view/recorded_source.h"

#include <doctest/doctest.h>
#include <functional>
#include <memory>

namespace tumble::view::testing {

/// The run of a ball that fell for 0.02 s, 2000 steps, a frame every 5 ms: 0, 5, 10, 15, 20 ms.
struct Recorded {
    test::Folder folder;
    scene::Scene scene = test::loaded(test::falling_ball);
    std::filesystem::path run = folder.path / "run";
    std::unique_ptr<Source> source;

    explicit Recorded(
        bool contacts = false, const std::function<void()>& news = [] {}) {
        scene.observe.contacts = contacts;
        scene.observe.measures.emplace_back("kinetic_energy");
        tumble::run::RunOptions options;
        options.folder = run;
        tumble::run::RunListener silent;
        const auto summary = tumble::run::run_scene(scene, options, silent);
        REQUIRE_MESSAGE(summary.ok(), to_string(summary.problems()));
        source = again(news);
    }
    /// Once more, with the scene as it is now.
    [[nodiscard]] std::unique_ptr<Source> again(const std::function<void()>& news = [] {}) const {
        auto opened = open_recorded(run, scene, news);
        REQUIRE_MESSAGE(opened.ok(), to_string(opened.problems()));
        return std::move(*opened);
    }
    [[nodiscard]] double time() const { return source->newest()->frame.time; }
};

} // namespace tumble::view::testing
