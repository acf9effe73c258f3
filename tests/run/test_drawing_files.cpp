#include "../folder.h"
#include "about.h"
#include "run/beside.h"
#include "run/redraw.h"
#include "run/run_scene.h"
#include "run/strip.h"
#include "scenes.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <doctest/doctest.h>
#include <sstream>

namespace test_drawing_files {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;
namespace pt = boost::property_tree;

namespace {

/// A disc that falls in a round wall of radius 0.1 m, which turns; a frame every 5 ms.
const std::string falling_disc = R"(
title = "A disc that falls"
claim = "none"
dimension = 2
depth_m = 0.01
duration_s = 0.02
time_step_s = 2e-5
[domain]
lo_m = [-0.11, -0.11]
hi_m = [0.11, 0.11]
[material.glass]
density_kg_m3 = 2500
[pair.glass-glass]
restitution = 0.5
friction = 0.3
normal_stiffness_N_per_m = 1e5
stiffness_ratio = 0.7
[body.disc]
radius_mm = 10
material = "glass"
[[fill]]
body = "disc"
count = 1
position_m = [0, 0.02]
[[wall]]
name = "drum"
shape = "arc"
centre_m = [0, 0]
radius_m = 0.1
material = "glass"
[[wall.motion]]
kind = "rotation"
centre_m = [0, 0]
speed_rpm = 6
[observe]
every_s = 0.005
[render]
every_s = 0.005
style = "paper"
width_mm = 600
height_mm = 600
)";

void silent(std::int64_t, std::int64_t) {}

fs::path finished_run(const Folder& folder, const std::string& text, const std::string& name) {
    run::RunOptions options;
    options.folder = folder.path / name;
    run::RunListener quiet;
    REQUIRE(run::run_scene(loaded(text), options, quiet).ok());
    return options.folder;
}

run::RedrawOptions options_for(const std::string& text, const fs::path& drawing) {
    run::RedrawOptions options;
    options.settings = loaded(text).render;
    options.targets.drawing = drawing;
    return options;
}

std::vector<Eigen::Vector2d> points_of(const pt::ptree& element) {
    std::istringstream text(element.get<std::string>("<xmlattr>.points"));
    std::vector<Eigen::Vector2d> points;
    for (double x = 0, y = 0; text >> x && text.ignore() && text >> y;)
        points.emplace_back(x, y);
    return points;
}

const pt::ptree* find(const pt::ptree& tree, const std::string& name) {
    for (const auto& [key, child] : tree) {
        if (key == name)
            return &child;
        if (const pt::ptree* found = find(child, name))
            return found;
    }
    return nullptr;
}

} // namespace

TEST_CASE("the last frame is drawn into one file, whole or not at all, and nothing is overwritten unasked") {
    const Folder folder;
    const fs::path run = finished_run(folder, falling_disc, "disc");
    for (const char* name : {"a.svg", "a.pdf"}) {
        const fs::path file = folder.path / "new" / name;
        const auto drawn = run::redraw(run, options_for(falling_disc, file), silent);
        REQUIRE_MESSAGE(drawn.ok(), to_string(drawn.problems()));
        CHECK(drawn->reason.empty());
        CHECK(drawn->frames == 1);
        CHECK(drawn->first == drawn->last);
        CHECK(drawn->last == about(0.02));
        const std::string content = content_of(file);
        CHECK(content.size() > 1000);
        CHECK(!fs::exists(file.string() + ".part"));
        const auto again = run::redraw(run, options_for(falling_disc, file), silent);
        REQUIRE(!again.ok());
        CHECK(again.problems()[0].what == "is there already, and nothing is overwritten");
        run::RedrawOptions forced = options_for(falling_disc, file);
        forced.overwrite = true;
        REQUIRE(run::redraw(run, forced, silent).ok());
        CHECK(content_of(file) == content);
    }
}

TEST_CASE("a drawing has the scales of its own frame, whatever was fast before") {
    const Folder folder;
    // Thrown up with 1 m/s and held back by 40 m/s^2, the disc has 0.2 m/s left at the last frame.
    run::RunOptions running;
    running.folder = folder.path / "up";
    run::RunListener quiet;
    REQUIRE(
        run::run_scene(loaded(falling_disc, {"gravity_m_s2=[0, -40]", "fill.0.velocity_m_s=[0, 1]"}), running, quiet)
            .ok());
    const auto drawn = [&](const char* name, double from) {
        run::RedrawOptions options = options_for(falling_disc, folder.path / name);
        options.settings.marks.arrows = "bodies";
        options.when.from = from;
        const auto done = run::redraw(running.folder, options, silent);
        REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
        REQUIRE(done->reason.empty());
        return content_of(folder.path / name);
    };
    const auto has = [](const std::string& svg, const char* words) { return svg.find(words) != std::string::npos; };
    const std::string all = drawn("all.svg", 0), last = drawn("last.svg", 0.019);
    CHECK((has(all, ">0.2 m/s<") && has(last, ">0.2 m/s<"))); // the arrow's
    CHECK((has(all, ">0.20<") && has(last, ">0.20<")));       // the colours' end
}

TEST_CASE("a round wall on the largest page leaves its circle by less than 0.02 mm") {
    // The largest page there is: 600 mm, of which letters and the margin of 3 % take some.
    const Folder folder;
    const fs::path run = finished_run(folder, falling_disc, "disc"), file = folder.path / "a.svg";
    REQUIRE(run::redraw(run, options_for(falling_disc, file), silent).ok());
    pt::ptree tree;
    pt::read_xml(file.string(), tree);
    const pt::ptree* wall = find(tree, "polygon");
    REQUIRE(wall != nullptr);
    const auto points = points_of(*wall);
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points)
        centre += point / static_cast<double>(points.size());
    const double radius = (points[0] - centre).norm();
    CHECK(radius > 200);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Eigen::Vector2d middle = 0.5 * (points[k] + points[(k + 1) % points.size()]);
        CHECK(std::abs((points[k] - centre).norm() - radius) < 0.005);
        CHECK(radius - (middle - centre).norm() < 0.02);
    }
    // The disc fell by g t^2 / 2 = 1.962 mm in 20 ms; it stands where the wall's scale says.
    const pt::ptree* disc = find(tree, "circle");
    REQUIRE(disc != nullptr);
    const Eigen::Vector2d place(disc->get<double>("<xmlattr>.cx"), disc->get<double>("<xmlattr>.cy"));
    CHECK(std::abs(place.x() - centre.x()) < 0.02);
    CHECK(std::abs(centre.y() - place.y() - radius * (0.02 - 0.001962) / 0.1) < 0.05);
}

TEST_CASE("strips and two runs side by side are drawn as lines, too") {
    const Folder folder;
    const fs::path run = finished_run(folder, falling_disc, "disc");
    run::StripOptions strip;
    strip.redraw = options_for(falling_disc, {});
    strip.plan.cells = 3;
    strip.out = folder.path / "strip.pdf";
    const auto cells = run::draw_strip(run, strip, silent);
    REQUIRE_MESSAGE(cells.ok(), to_string(cells.problems()));
    CHECK(cells->reason.empty());
    CHECK(content_of(strip.out).substr(0, 5) == "%PDF-");
    run::BesideOptions beside;
    beside.settings = loaded(falling_disc).render;
    beside.settings.marks.trails = {"disc"};
    beside.labels = {"left", "right"};
    beside.targets.drawing = folder.path / "pair.svg";
    const auto pair = run::draw_beside({run, run}, beside, silent);
    REQUIRE_MESSAGE(pair.ok(), to_string(pair.problems()));
    CHECK(pair->frames == 1);
    CHECK(pair->last == about(0.02));
    CHECK(content_of(folder.path / "pair.svg").find(">right</text>") != std::string::npos);
}

TEST_CASE("a scene in space is refused with its run's name, and nothing is left behind") {
    const Folder folder;
    const fs::path run = finished_run(folder, falling_ball, "ball"), file = folder.path / "a.svg";
    const auto drawn = run::redraw(run, options_for(falling_ball, file), silent);
    REQUIRE(!drawn.ok());
    CHECK(drawn.problems()[0].file == run.string());
    CHECK(drawn.problems()[0].what ==
          "spheres in space cannot be drawn as lines: SVG and PDF are for scenes in two dimensions");
    CHECK(!fs::exists(file));
    run::StripOptions strip;
    strip.redraw = options_for(falling_ball, {});
    strip.plan.cells = 2;
    strip.out = file;
    CHECK(!run::draw_strip(run, strip, silent).ok());
    CHECK(!fs::exists(file));
}

TEST_CASE("a disk that runs full is told once, and leaves neither the drawing nor a part of it") {
    const Folder folder;
    const fs::path run = finished_run(folder, falling_disc, "disc"), file = folder.path / "a.svg";
    fs::create_symlink("/dev/full", file.string() + ".part");
    const auto drawn = run::redraw(run, options_for(falling_disc, file), silent);
    REQUIRE(drawn.ok());
    REQUIRE(drawn->reason.size() == 1);
    CHECK(drawn->reason[0].file == file.string());
    CHECK(drawn->reason[0].fix == "free some space, or write to another disk");
    CHECK(!fs::exists(file));
    CHECK(!fs::exists(fs::symlink_status(file.string() + ".part")));
}

} // namespace test_drawing_files
