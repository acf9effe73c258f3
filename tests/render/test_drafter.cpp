#include "about.h"
#include "base/disc_union.h"
#include "drawings.h"
#include "render/body_outline.h"
#include "render/letters.h"

#include <numbers>

namespace test_drafter {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

namespace {

// What page_of(80, 80) shows without letters: 80 mm less twice the margin of 3 % for 1 m, about the middle. Pixels of
// 25.4 / 720 mm are whole, so that the middle may lie half of one off.
constexpr double mm_per_metre = 0.94 * 80;
constexpr double half_pixel = 0.5 * 25.4 / 720;
Vector2d on_page(const Vector2d& place) {
    return {40 + mm_per_metre * place.x(), 40 - mm_per_metre * place.y()};
}

// A unit (render/layout.h) in mm where letters have 8 points: 8 / 72 inches times the reach of DejaVu's letters, 2384
// of 2048, are 17 units.
constexpr double unit_mm = 8.0 / 72 * 25.4 * 2384 / 2048 / 17;

} // namespace

TEST_CASE("each disc lies on the page where the scene has it, as large and in the colour of its speed") {
    const auto layout = discs({0.05, 0.1});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0.1, 0.2, 0}, {0.25, 0, 0});
    add_body(frame, 1, {-0.3, -0.15, 0}, {0, 0.8, 0});
    frame.orientation[1] = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitZ());
    const Drawing drawing = drafter_for(page_of(80, 80), layout, bare).draw(frame);
    const pt::ptree svg = xml_of(drawing);
    const auto circles = all(group(svg, "bodies"), "circle");
    REQUIRE(circles.size() == 2);
    const ColorMap map = *find_color_map("viridis", false);
    for (std::size_t b = 0; b < 2; ++b) {
        const Vector2d middle = on_page(frame.position[b].head<2>());
        CHECK(std::abs(number(*circles[b], "cx") - middle.x()) < half_pixel + 1e-3);
        CHECK(std::abs(number(*circles[b], "cy") - middle.y()) < half_pixel + 1e-3);
        // The line lies inside the rim.
        const double reach = number(*circles[b], "r") + 0.5 * number(*circles[b], "stroke-width");
        CHECK(reach == about(mm_per_metre * layout->shapes[b].radii[0], 1e-3));
        CHECK(word(*circles[b], "fill") == hex_of(map.at(frame.velocity[b].norm())));
    }
    // From the centre of mass to the rim: to the right, and after a quarter of a turn upwards.
    const auto turns = all(group(svg, "turns"), "polyline");
    REQUIRE(turns.size() == 2);
    CHECK((points_of(*turns[0])[1] - on_page({0.15, 0.2})).norm() < 2 * half_pixel);
    CHECK((points_of(*turns[1])[1] - on_page({-0.3, -0.05})).norm() < 2 * half_pixel);
}

TEST_CASE("discs that overlap have one outline around what they cover, and rings have a hole") {
    // Two circles of radius 1 a distance d apart cover 2 pi - 2 acos(d / 2) + d / 2 sqrt(4 - d^2).
    const auto circle = [](double x, double y, double radius) { return Arc{{x, y}, radius, 0, 0}; };
    const auto area_of = [](const std::vector<std::vector<Arc>>& loops) {
        AreaMoments sums{};
        for (const auto& loop : loops)
            for (const Arc& arc : loop)
                add_arc({arc.centre.x(), arc.centre.y(), arc.radius, 0}, arc.from, arc.from + arc.sweep, sums);
        return sums[0];
    };
    const auto closes = [](const std::vector<Arc>& loop) {
        double gap = 0;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Arc& next = loop[(k + 1) % loop.size()];
            gap = std::max(gap, (loop[k].at(loop[k].from + loop[k].sweep) - next.at(next.from)).norm());
        }
        return gap < 1e-12;
    };
    const double d = 1.3;
    const auto pair = outline_of({circle(0, 0, 1), circle(d, 0, 1), circle(0.2, 0, 0.1)}); // the third lies inside
    REQUIRE(pair.size() == 1);
    CHECK(pair[0].size() == 2);
    CHECK(closes(pair[0]));
    CHECK(area_of(pair) == about(2 * std::numbers::pi - 2 * std::acos(d / 2) + d / 2 * std::sqrt(4 - d * d)));
    // Six circles of radius 0.6 with centres 1 from the middle and from each other: the hole's six corners lie where
    // neighbours cross, sqrt(0.36 - 0.25) inwards from the middle between them.
    std::vector<Arc> six;
    for (int k = 0; k < 6; ++k)
        six.push_back(circle(std::cos(k * std::numbers::pi / 3), std::sin(k * std::numbers::pi / 3), 0.6));
    const auto ring = outline_of(six);
    REQUIRE(ring.size() == 2);
    for (const auto& loop : ring) {
        CHECK(loop.size() == 6);
        CHECK(closes(loop));
    }
    const double nearest = std::min(ring[0][0].at(ring[0][0].from).norm(), ring[1][0].at(ring[1][0].from).norm());
    CHECK(nearest == about(std::sqrt(0.75) - std::sqrt(0.36 - 0.25)));
    CHECK(outline_of({circle(0, 0, 1), circle(5, 0, 1)}).size() == 2); // apart
    const auto alone = outline_of({circle(3, 4, 2)});
    REQUIRE(alone.size() == 1);
    CHECK(alone[0][0].sweep == about(2 * std::numbers::pi));
}

TEST_CASE("a clump is one path, filled and outlined") {
    const auto layout = discs({0.1});
    layout->shapes[0].centres = {{-0.05, 0, 0}, {0.05, 0, 0}};
    layout->shapes[0].radii = {0.1, 0.1};
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0}, {1, 0, 0});
    const pt::ptree svg = xml_of(drafter_for(page_of(80, 80), layout, bare).draw(frame));
    const auto paths = all(group(svg, "bodies"), "path");
    REQUIRE(paths.size() == 1);
    CHECK(all(group(svg, "bodies"), "circle").empty());
    CHECK(word(*paths[0], "fill") == hex_of(find_color_map("viridis", false)->at(1)));
    const std::string way = word(*paths[0], "d");
    CHECK(std::count(way.begin(), way.end(), 'M') == 1);
    CHECK(std::count(way.begin(), way.end(), 'A') >= 2);
    CHECK(way.back() == 'Z');
}

TEST_CASE("the page has the size asked for in mm, and its smallest letters the points") {
    // PDF counts in points of 1/72 inch: 85 mm are 240.945, 60 mm 170.079.
    const auto layout = discs({0.1});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0}, {0.5, 0, 0});
    for (const double points : {6.0, 9.0}) {
        const Drawing drawing = drafter_for(page_of(85, 60, points), layout).draw(frame);
        const pt::ptree svg = xml_of(drawing);
        CHECK(word(svg, "width") == "85mm");
        CHECK(word(svg, "height") == "60mm");
        CHECK(word(svg, "viewBox") == "0 0 85 60");
        double smallest = 1e9;
        for (const pt::ptree* text : all(svg, "text"))
            smallest = std::min(smallest, number(*text, "font-size"));
        CHECK(smallest == about(points / 72 * 25.4, 1e-4));
        const std::string pdf = encode_pdf(drawing);
        const std::size_t box = pdf.find("/MediaBox");
        REQUIRE(box != std::string::npos);
        std::istringstream numbers(pdf.substr(pdf.find('[', box) + 1, 80));
        double left = -1, low = -1, right = 0, high = 0;
        REQUIRE((numbers >> left >> low >> right >> high));
        CHECK(left == 0);
        CHECK(low == 0);
        CHECK(right == about(85 / 25.4 * 72, 1e-5));
        CHECK(high == about(60 / 25.4 * 72, 1e-5));
    }
}

TEST_CASE("text stays text, in the words of the legend, and lies on the page") {
    const auto layout = discs({0.1});
    observe::Frame frame = empty_frame(layout);
    frame.time = 1.25;
    add_body(frame, 0, {0, 0, 0}, {0.5, 0, 0});
    const Drawing drawing = drafter_for(page_of(85, 60), layout).draw(frame);
    const pt::ptree svg = xml_of(drawing);
    std::string words;
    for (const pt::ptree* text : all(svg, "text")) {
        const std::string content = text->get_value<std::string>();
        words += content + '\n';
        const std::string anchor = text->get<std::string>("<xmlattr>.text-anchor", "start");
        const double size = number(*text, "font-size"), length = size * width_of_letters(content);
        const double left = number(*text, "x") - (anchor == "start" ? 0 : anchor == "middle" ? 0.5 * length : length);
        CAPTURE(content);
        CHECK(left >= 0);
        CHECK(left + length <= 85);
        CHECK(number(*text, "y") - size >= 0);
        CHECK(number(*text, "y") + 0.3 * size <= 60);
    }
    for (const char* part : {"speed [m/s]", "t = 1.25 s", "1.0\n"})
        CHECK_MESSAGE(words.find(part) != std::string::npos, words);
    // Programs find letters in a PDF by a table that a font of its own has.
    CHECK(encode_pdf(drawing).find("/ToUnicode") != std::string::npos);
    // A picture of a screen has its title, with what XML would take for its own written out.
    scene::Render screen = square_view(0.5);
    screen.camera = "side";
    screen.width = 1280;
    screen.height = 720;
    const pt::ptree shown = xml_of(drafter_for(screen, layout).draw(frame));
    const auto titles = all(shown, "text");
    CHECK(std::any_of(titles.begin(), titles.end(),
                      [](const pt::ptree* text) { return text->get_value<std::string>() == "Discs & <others>"; }));
}

TEST_CASE("the colour bar has the colours of the map, all of them in one piece") {
    const auto layout = discs({0.1});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0}, {0.5, 0, 0});
    const pt::ptree svg = xml_of(drafter_for(page_of(85, 60), layout).draw(frame));
    const ColorMap map = *find_color_map("viridis", false);
    const auto stops = all(svg, "stop");
    REQUIRE(stops.size() == map.points.size());
    for (const pt::ptree* stop : stops)
        CHECK(word(*stop, "stop-color") == hex_of(map.at(number(*stop, "offset"))));
    CHECK(all(svg, "linearGradient").size() == 1);
}

TEST_CASE("the same drawing is the same bytes, and no file says when it was made") {
    const auto layout = discs({0.1});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0}, {0.5, 0, 0});
    const Drawing one = drafter_for(page_of(85, 60), layout).draw(frame);
    const Drawing other = drafter_for(page_of(85, 60), layout).draw(frame);
    CHECK(encode_svg(one) == encode_svg(other));
    CHECK(encode_pdf(one) == encode_pdf(other));
    CHECK(encode_pdf(one).find("Date") == std::string::npos);
}

TEST_CASE("force chains are lines as thick as their force, arrows as long as their speed, trails one line each") {
    const auto layout = discs({0.1});
    scene::Render settings = page_of(80, 80);
    settings.marks.chains = true;
    settings.marks.chain_force = 4;
    settings.marks.arrows = "bodies";
    settings.marks.arrow_speed = 2;
    settings.marks.trails = {"0"};
    Drafter drafter = drafter_for(settings, layout);
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {-0.2, 0, 0});
    add_body(frame, 0, {-0.0, 0, 0}, {1.5, 0, 0});
    for (int k = 0; k < 3; ++k) {
        frame.time = 0.1 * k;
        frame.position[0].y() = 0.1 * k * k;
        if (k < 2)
            drafter.pass_over(frame);
    }
    // The body is at (-0.2, 0.4) now.
    frame.contacts.emplace();
    frame.contacts->push_back({.a = 0, .b = 1, .point = {-0.1, 0.2, 0}, .normal = {-1, 0, 0}, .force = {-2, 0, 0}});
    const pt::ptree svg = xml_of(drafter.draw(frame));
    const pt::ptree& marks = group(svg, "marks");
    const std::string chain = hex_of(find_theme("white")->chain), arrow = hex_of(find_theme("white")->arrow);
    int chains = 0, trails = 0;
    for (const pt::ptree* line : all(marks, "polyline")) {
        const std::string color = word(*line, "stroke");
        if (color == chain) {
            ++chains;
            CHECK(number(*line, "stroke-width") == about(0.5 * chain_thickness * unit_mm, 1e-3)); // 2 of 4 N
        } else if (color != hex_of(find_theme("white")->background)) {
            ++trails;
            CHECK(points_of(*line).size() == 3);
        }
    }
    CHECK(chains == 2); // to the contact and on
    CHECK(trails == 1);
    int arrows = 0;
    for (const pt::ptree* shape : all(marks, "polygon"))
        if (word(*shape, "fill") == arrow) {
            ++arrows;
            const auto points = points_of(*shape);
            REQUIRE(points.size() == 7);
            const Vector2d tail = 0.5 * (points[0] + points[6]);
            CHECK((points[3] - tail).x() == about(1.5 / 2 * arrow_length * unit_mm, 1e-3));
            CHECK(std::abs((points[3] - tail).y()) < 1e-3);
        }
    CHECK(arrows == 1); // the other rests
    std::string words;
    for (const pt::ptree* text : all(svg, "text"))
        words += text->get_value<std::string>() + '\n';
    for (const char* part : {"2 m/s", "0 to 4 N", "body 0"})
        CHECK_MESSAGE(words.find(part) != std::string::npos, words);
}

TEST_CASE("small discs have the legend's colour: their lines take no more than a tenth of the radius") {
    const auto layout = discs({0.004, 0.1});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0}, {0.5, 0, 0});
    for (const scene::Render& settings : {page_of(85, 60), page_of(40, 40)}) {
        const pt::ptree svg = xml_of(drafter_for(settings, layout).draw(frame));
        const pt::ptree& circle = *all(group(svg, "bodies"), "circle").at(0);
        const double line = number(circle, "stroke-width"), radius = number(circle, "r") + 0.5 * line;
        CHECK(line == about(0.1 * radius, 1e-2));
    }
}

TEST_CASE("a key of more lines than there is room for stays in the picture and says what it leaves out") {
    const auto layout = discs({0.02});
    observe::Frame frame = empty_frame(layout);
    frame.time = 2.5;
    scene::Marks marks;
    for (int b = 0; b < 30; ++b) {
        add_body(frame, 0, {0.03 * b - 0.45, 0, 0}, {0.5, 0, 0});
        marks.trails.push_back(std::to_string(b));
    }
    frame.contacts.emplace();
    const auto screen = [](int width, int height, bool plot) {
        scene::Render settings = square_view(0.5);
        settings.camera = "side";
        settings.width = width;
        settings.height = height;
        settings.plot = plot;
        return settings;
    };
    for (scene::Render settings : {page_of(85, 60), page_of(60, 90), screen(1280, 720, true), screen(720, 1280, true),
                                   screen(640, 480, false)}) {
        settings.marks = marks;
        settings.marks.chains = !settings.paper; // where letters are small for the page
        settings.marks.arrows = settings.paper ? "none" : "field";
        CAPTURE(settings.width);
        CAPTURE(settings.height);
        Drafter drafter = drafter_for(settings, layout);
        const Drawing drawing = drafter.draw(frame);
        const pt::ptree svg = xml_of(drawing);
        const Layout& shown = drafter.layout();
        int named = 0;
        for (const pt::ptree* text : all(svg, "text")) {
            CHECK(number(*text, "y") < drawing.height_mm);
            named += text->get_value<std::string>().starts_with("body ") ? 1 : 0;
        }
        CHECK(says(svg, fmt::format("and {} more", 30 - named)));
        CHECK(says(svg, "since t = 2.5 s"));
        CHECK((settings.paper || says(svg, ", mean\nt = 2.5 s")));
        CHECK(named <= 4);
        const bool apart = shown.key.top >= shown.legend.bottom || shown.key.right <= shown.legend.left;
        CHECK(apart);
        CHECK(shown.legend.height() > 60 * shown.unit);
        CHECK(shown.scene.height() > 100 * shown.unit);
    }
}

TEST_CASE("a wall is one line from end to end, closed where it ends in its begin") {
    auto layout = discs({0.1});
    observe::FrameWall wall;
    for (int k = 0; k <= 12; ++k) {
        const double angle = 2 * std::numbers::pi * k / 12;
        wall.vertices.emplace_back(0.4 * std::cos(angle), 0.4 * std::sin(angle), 0);
        if (k > 0)
            wall.lines.push_back({k - 1, k});
    }
    layout->walls = {wall};
    layout->walls.emplace_back();
    layout->walls[1].vertices = {{-0.3, 0, 0}, {0, 0.1, 0}, {0, 0.1, 0}, {0.3, 0, 0}}; // two pieces that meet
    layout->walls[1].lines = {{0, 1}, {2, 3}};
    observe::Frame frame = empty_frame(layout);
    frame.walls[1].translation = {0, -0.2, 0};
    const pt::ptree svg = xml_of(drafter_for(page_of(80, 80), layout, bare).draw(frame));
    const pt::ptree& walls = group(svg, "walls");
    REQUIRE(all(walls, "polygon").size() == 1);
    CHECK(points_of(*all(walls, "polygon")[0]).size() == 12);
    REQUIRE(all(walls, "polyline").size() == 1);
    const auto roof = points_of(*all(walls, "polyline")[0]);
    REQUIRE(roof.size() == 3);
    CHECK((roof[1] - on_page({0, -0.1})).norm() < 2 * half_pixel);
}

TEST_CASE("spheres in space are refused, and so is what a painter refuses") {
    const auto refused = Drafter::open(page_of(80, 80), spheres({0.1}));
    REQUIRE(!refused.ok());
    CHECK(refused.problems()[0].what ==
          "spheres in space cannot be drawn as lines: SVG and PDF are for scenes in two dimensions");
    scene::Render settings = page_of(80, 80);
    settings.color = "vz";
    CHECK(!Drafter::open(settings, discs({0.1})).ok());
}

} // namespace test_drafter
