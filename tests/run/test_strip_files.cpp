#include "../folder.h"
#include "about.h"
#include "run/run_scene.h"
#include "run/strip.h"
#include "scenes.h"

#include <doctest/doctest.h>

namespace test_strip_files {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

void silent(std::int64_t, std::int64_t) {}

run::StripOptions options_for(const fs::path& out, int cells) {
    run::StripOptions options;
    options.redraw.settings = loaded(falling_ball).render;
    options.redraw.settings.width = 640;
    options.redraw.settings.height = 480;
    options.plan.cells = cells;
    options.out = out;
    return options;
}

fs::path finished_run(const Folder& folder) {
    run::RunOptions options;
    options.folder = folder.path / "ball";
    run::RunListener quiet;
    REQUIRE(run::run_scene(loaded(falling_ball), options, quiet).ok());
    return options.folder;
}

} // namespace

TEST_CASE("a strip takes the first, the last and frames evenly between, into one picture or one each") {
    const Folder folder;
    const fs::path run = finished_run(folder); // frames at 0, 5, 10, 15 and 20 ms
    const auto one = run::draw_strip(run, options_for(folder.path / "new" / "strip.png", 3), silent);
    REQUIRE_MESSAGE(one.ok(), to_string(one.problems()));
    CHECK(one->reason.empty());
    CHECK(one->frames == 3);
    CHECK(one->first == 0);
    CHECK(one->last == about(0.02));
    CHECK(fs::file_size(folder.path / "new" / "strip.png") > 1000);
    const auto again = run::draw_strip(run, options_for(folder.path / "new" / "strip.png", 3), silent);
    REQUIRE(!again.ok());
    CHECK(again.problems()[0].what == "is there already, and nothing is overwritten");
    const auto apart = run::draw_strip(run, options_for(folder.path / "apart", 5), silent);
    REQUIRE_MESSAGE(apart.ok(), to_string(apart.problems()));
    CHECK(count_files(folder.path / "apart", ".png") == 5);
    const auto many = run::draw_strip(run, options_for(folder.path / "many.png", 6), silent);
    REQUIRE(!many.ok());
    CHECK(many.problems()[0].what == "6 pictures are asked for, and in that time there are 5 frames");
    CHECK(!fs::exists(folder.path / "many.png"));
}

TEST_CASE("sections are taken of the last frame, each in a picture of its own where a folder is given") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    run::StripOptions options = options_for(folder.path / "sections", 2);
    options.sections = true;
    options.redraw.settings.clip = scene::Box{{-0.1, 0, -0.1}, {0.1, 1, 0.1}};
    const auto done = run::draw_strip(run, options, silent);
    REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
    CHECK(done->first == done->last);
    CHECK(done->last == about(0.02));
    CHECK(fs::exists(folder.path / "sections" / "section_1.png"));
    CHECK(fs::exists(folder.path / "sections" / "section_2.png"));
}

/// The camera looks along +x: what lies before x = 0.05 m is left out, and with it the ball, which is at 0.
TEST_CASE("sections are taken at the places that are given, and a place that no body reaches is refused") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    run::StripOptions options = options_for(folder.path / "given", 3);
    options.sections = true;
    options.redraw.settings.clip = scene::Box{{-0.1, 0, -0.1}, {0.1, 1, 0.1}};
    options.places = {-0.05, -0.01, 0.05};
    options.redraw.settings.width = 300; // too small for the words that tell the places apart
    options.redraw.settings.height = 180;
    REQUIRE(run::draw_strip(run, options, silent).ok());
    const auto picture = [&](int k) {
        return content_of(folder.path / "given" / ("section_" + std::to_string(k) + ".png"));
    };
    CHECK(picture(1) == picture(2)); // the ball is whole in both
    CHECK(picture(2) != picture(3));
    options.redraw.settings.width = 640;
    options.redraw.settings.height = 480;
    options.out = folder.path / "with words";
    REQUIRE(run::draw_strip(run, options, silent).ok());
    CHECK(content_of(options.out / "section_1.png") != content_of(options.out / "section_2.png"));
    options.out = folder.path / "beyond";
    options.places = {0, 27};
    const Problems problems = run::draw_strip(run, options, silent).problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].what == "a section at x = 27 m cuts no bodies");
    CHECK(problems[0].fix == "choose places from -0.1 to 0.1 m");
    CHECK(!fs::exists(options.out));
}

/// Nothing but the words can differ: what is in sight has neither body nor wall, and the clip is all of the domain.
TEST_CASE("sections have each the mean field of all frames, and need one scale of arrows in one picture") {
    const Folder folder;
    const fs::path run = finished_run(folder);
    run::StripOptions options = options_for(folder.path / "sections.png", 2);
    options.sections = true;
    options.redraw.settings.clip = scene::Box{{-0.1, 0, -0.1}, {0.1, 1, 0.1}};
    options.redraw.settings.view = options.redraw.settings.clip;
    options.redraw.settings.range = {0.0, 1.0};
    options.redraw.settings.marks.arrows = "field";
    const Problems problems = run::draw_strip(run, options, silent).problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].what == "the mean fields of several sections need one scale of arrows");
    CHECK(!fs::exists(options.out));
    options.redraw.settings.marks.arrow_speed = 1;
    const auto done = run::draw_strip(run, options, silent);
    REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
    CHECK(done->reason.empty());
    // Of the last frame alone the field, and what the key says of its time, would be another.
    options.redraw.when.from = 0.019;
    options.out = folder.path / "last.png";
    REQUIRE(run::draw_strip(run, options, silent).ok());
    CHECK(content_of(options.out) != content_of(folder.path / "sections.png"));
}

} // namespace test_strip_files
