#include "about.h"
#include "drawings.h"
#include "render/pair_painter.h"
#include "render/strip_painter.h"

namespace test_drawn_sheets {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

TEST_CASE("a strip of drawings has a cell for each instant, and two runs a half each, under one legend") {
    const auto layout = discs({0.1});
    const auto frame_at = [&](double x) {
        observe::Frame frame = empty_frame(layout);
        add_body(frame, 0, {x, 0, 0}, {1, 0, 0});
        return frame;
    };
    const Eigen::AlignedBox3d box(Vector3d(-0.5, -0.5, 0), Vector3d(0.5, 0.5, 0));
    auto strip = StripDrafter::open(page_of(160, 100), layout, box, {.cells = 3, .columns = 3});
    REQUIRE_MESSAGE(strip.ok(), to_string(strip.problems()));
    for (const double x : {-0.2, 0.0, 0.2})
        strip->add(frame_at(x), "words");
    const Drawing drawing = strip->finish();
    CHECK(drawing.width_mm == 160);
    CHECK(drawing.height_mm < 100);
    const pt::ptree svg = xml_of(drawing);
    const auto circles = all(svg, "circle");
    REQUIRE(circles.size() == 3);
    // Each in its own cell: the second in the middle of its, the others as far from theirs as metres say.
    const double shift = number(*circles[1], "cx") - number(*circles[0], "cx");
    const double metre = (number(*circles[0], "r") + 0.5 * number(*circles[0], "stroke-width")) / 0.1;
    CHECK(shift == about(0.2 * metre, 1e-2));
    CHECK(all(svg, "linearGradient").size() == 1);
    CHECK(all(svg, "clipPath").size() == 3);

    auto pair = PairDrafter::open(page_of(160, 80), {layout, layout}, {"left", "right"});
    REQUIRE_MESSAGE(pair.ok(), to_string(pair.problems()));
    pair->fit(box);
    const pt::ptree both = xml_of(pair->draw(frame_at(0), frame_at(0.1)));
    CHECK(all(both, "circle").size() == 2);
    CHECK(all(both, "linearGradient").size() == 1);
}

TEST_CASE(
    "the key of a strip and of a pair holds for all of their pictures, and what the key shows is as large there") {
    const auto layout = discs({0.1});
    const auto pressed = [&](double force) {
        observe::Frame frame = empty_frame(layout);
        add_body(frame, 0, {-0.1, 0, 0});
        add_body(frame, 0, {0.1, 0, 0});
        frame.contacts.emplace();
        frame.contacts->push_back({.a = 0, .b = 1, .point = {0, 0, 0}, .normal = {-1, 0, 0}, .force = {-force, 0, 0}});
        return frame;
    };
    const Eigen::AlignedBox3d box(Vector3d(-0.5, -0.5, 0), Vector3d(0.5, 0.5, 0));
    scene::Render settings = square_view(0.5);
    settings.camera = "side";
    settings.width = 640;
    settings.height = 360; // a unit is 0.68 pixels of 1/96 inch there
    settings.marks.chains = true;
    settings.marks.chain_force = 2;
    const double thick = chain_thickness * 0.68 * 25.4 / 96;
    const auto thickest = [](const pt::ptree& svg) {
        double most = 0;
        for (const pt::ptree* marks : all(svg, "g"))
            if (marks->get<std::string>("<xmlattr>.class") == "marks")
                for (const pt::ptree* line : all(*marks, "polyline"))
                    if (word(*line, "stroke") == hex_of(find_theme("dark")->chain))
                        most = std::max(most, number(*line, "stroke-width"));
        return most;
    };
    for (const bool more_first : {true, false}) {
        const double first = more_first ? 4 : 2, second = more_first ? 2 : 4;
        auto strip = StripDrafter::open(settings, layout, box, {.cells = 2, .note = "what they share"});
        REQUIRE(strip.ok());
        strip->add(pressed(first), "first");
        strip->add(pressed(second), "second");
        const pt::ptree cells = xml_of(strip->finish());
        CHECK(says(cells, "0 to ≥ 2 N"));
        CHECK(says(cells, "what they share"));
        CHECK(thickest(cells) == about(2 * thick, 1e-3));
        auto pair = PairDrafter::open(settings, {layout, layout}, {"left", "right"});
        REQUIRE(pair.ok());
        pair->fit(box);
        const pt::ptree halves = xml_of(pair->draw(pressed(first), pressed(second)));
        CHECK(says(halves, "0 to ≥ 2 N"));
        CHECK(thickest(halves) == about(2 * thick, 1e-3));
    }
}

} // namespace test_drawn_sheets
