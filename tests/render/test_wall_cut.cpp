#include "about.h"
#include "fixtures.h"
#include "render/theme.h"
#include "render/wall_cut.h"

#include <numbers>

namespace test_wall_cut {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

namespace {

const Eigen::AlignedBox3d up_to_z(Vector3d::Constant(-10), Vector3d(10, 10, 0.2));

double length_of(const std::vector<Segment>& lines) {
    double sum = 0;
    for (const Segment& line : lines)
        sum += (line[1] - line[0]).norm();
    return sum;
}

/// A tube of `sides` flat sides about the z axis, 1 m in radius and 2 m long.
observe::FrameWall tube(int sides) {
    observe::FrameWall wall;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        for (const double z : {-1.0, 1.0})
            wall.vertices.emplace_back(std::cos(angle), std::sin(angle), z);
    }
    for (int k = 0; k < sides; ++k) {
        const int a = 2 * k, b = 2 * ((k + 1) % sides);
        wall.triangles.push_back({a, b, a + 1});
        wall.triangles.push_back({b, b + 1, a + 1});
    }
    return wall;
}

} // namespace

TEST_CASE("a way enters a box and leaves it at the shares of its length, or stays outside") {
    const Eigen::AlignedBox3d box(Vector3d(0, 0, 0), Vector3d(1, 1, 1));
    const auto through = shares_within(box, {Vector3d(-1, 0.5, 0.5), Vector3d(3, 0.5, 0.5)});
    REQUIRE(through);
    CHECK((*through)[0] == about(0.25));
    CHECK((*through)[1] == about(0.5));
    CHECK(shares_within(box, {Vector3d(0.2, 0.2, 0.2), Vector3d(0.4, 0.3, 0.9)}) == std::array{0.0, 1.0});
    CHECK(!shares_within(box, {Vector3d(-1, 2, 0.5), Vector3d(3, 2, 0.5)}));
    CHECK(!shares_within(box, {Vector3d(-1, 0.5, 0.5), Vector3d(-0.5, 0.5, 0.5)}));
}

TEST_CASE("a plane cuts a tube along the outline of its polygon, wherever the tube has moved to") {
    constexpr int sides = 36;
    const WallSurface surface = make_wall_surface(tube(sides));
    observe::WallPlace place;
    const double around = sides * 2 * std::sin(std::numbers::pi / sides);
    CHECK(length_of(cut_lines(surface, place, up_to_z)) == about(around, 1e-9));
    for (const Segment& line : cut_lines(surface, place, up_to_z))
        CHECK(line[0].z() == 0.2);
    place.translation = {0, 0, -0.9}; // it reaches up to z = 0.1 m now
    CHECK(cut_lines(surface, place, up_to_z).empty());
    // Half of the outline lies beyond the next face of the box.
    place.translation = {0, 0, 0};
    const Eigen::AlignedBox3d half(Vector3d(-10, 0, -10), Vector3d(10, 10, 0.2));
    const double straight = 2 * (0.2 + 1); // down both sides, where y = 0 cuts them
    CHECK(length_of(cut_lines(surface, place, half)) == about(0.5 * around + straight, 1e-6));
}

TEST_CASE("an edge that lies in the plane is a line of the cut, once") {
    observe::FrameWall wall;
    wall.vertices = {{0, -0.5, 0.2}, {0, 0.5, 0.2}, {0, 0, -0.3}, {0, 0, 0.7}};
    wall.triangles = {{0, 1, 2}, {1, 0, 3}};
    CHECK(length_of(cut_lines(make_wall_surface(wall), {}, up_to_z)) == about(1.0, 1e-12));
}

/// The pane |y|, |z| <= 0.9 m at x = 0, seen along +x, z to the right: 188 pixels a metre about (200, 200).
TEST_CASE("a clip that cuts leaves the wall within it, with a line along the cut; one that does not leaves all of it") {
    for (const double opacity : {0.4, 1.0}) {
        CAPTURE(opacity);
        auto layout = spheres({0.1});
        layout->walls = {pane(0.9, 0.9, opacity)};
        const observe::Frame frame = empty_frame(layout);
        scene::Render settings = square_view(1);
        const Picture whole = painter_for(settings, layout, bare).draw(frame);
        settings.clip = scene::Box{{-10, -10, -10}, {10, 10, 0.2}};
        CHECK(painter_for(settings, layout, bare).draw(frame).rgba == whole.rgba);
        settings.clip_cuts = true;
        const Picture cut = painter_for(settings, layout, bare).draw(frame);
        const Vector3d dark = pixel(whole, 2, 2), wall = pixel(whole, 100, 120);
        const int edge = 200 + static_cast<int>(0.2 * 188);
        CHECK(pixel(cut, 100, 120) == wall);
        CHECK(pixel(cut, edge - 6, 120) == wall);
        CHECK(pixel(cut, edge + 6, 120) == dark);
        CHECK(pixel(cut, 200 + 169, 120) == dark); // nor is the rim there
        double brightest = 0;
        for (int x = edge - 3; x <= edge + 3; ++x)
            brightest = std::max(brightest, pixel(cut, x, 120).sum());
        CHECK(brightest > wall.sum() + 5); // edges are lighter than walls
    }
}

} // namespace test_wall_cut
