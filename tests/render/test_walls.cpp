#include "about.h"
#include "fixtures.h"
#include "render/color_map.h"
#include "render/theme.h"
#include "render/wall_surface.h"

#include <numbers>

namespace test_walls {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

namespace {

/// The bare colour of a wall seen face-on: 0.72 + 0.28 times the lamp's share along the view, which is 1 there.
Vector3d wall_color() {
    return 255 * find_theme("dark")->wall;
}
Vector3d dark() {
    return (255 * find_theme("dark")->background).array().round();
}

double color_distance(const Vector3d& a, const Vector3d& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

} // namespace

TEST_CASE("a translucent wall blends by its opacity with the background and leaves bodies their colours") {
    auto layout = spheres({0.3});
    layout->walls = {pane(0.95, 0.95, 0.4)};
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0.5, 0, -0.5}, {1, 0, 0}); // behind the pane, on the left
    add_body(frame, 0, {-0.5, 0, 0.5}, {1, 0, 0}); // before it
    add_body(frame, 0, {0.2, 0.6, 0}, {1, 0, 0});  // and one that comes through it
    const Picture picture = painter_for(square_view(1), layout, bare).draw(frame);
    const Vector3d body = 255 * find_color_map("viridis", false)->at(1);
    CHECK(color_distance(pixel(picture, 200, 200), 0.4 * wall_color() + 0.6 * dark()) <= 2);
    CHECK(color_distance(pixel(picture, 200 - 94, 200), body) <= 1);
    CHECK(color_distance(pixel(picture, 200 + 94, 200), body) <= 1);
    for (const int beside : {0, 20, 50})
        CHECK(color_distance(pixel(picture, 200 + beside, 200 - 113), body) <= 1);
}

TEST_CASE("an opaque wall hides what is behind it") {
    auto layout = spheres({0.3});
    layout->walls = {pane(0.9, 0.9, 1)};
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0.5, 0, 0}, {1, 0, 0});
    const Picture picture = painter_for(square_view(1), layout, bare).draw(frame);
    CHECK(color_distance(pixel(picture, 200, 200), wall_color()) <= 2);
}

TEST_CASE("two panes let through the product of what each lets through, in whichever order they are given") {
    auto layout = spheres({0.3});
    layout->walls = {pane(0.9, 0.9, 0.3), pane(0.9, 0.9, 0.5)};
    observe::Frame frame = empty_frame(layout);
    for (const double shift : {-0.3, 0.3}) {
        frame.walls[0].translation = {shift, 0, 0};
        frame.walls[1].translation = {-shift, 0, 0};
        const Picture picture = painter_for(square_view(1), layout, bare).draw(frame);
        // Both panes have one colour, so their mixture has it too.
        CHECK(color_distance(pixel(picture, 200, 100), 0.65 * wall_color() + 0.35 * dark()) <= 2);
    }
}

TEST_CASE("walls are drawn where they have moved to, with their rim as a line") {
    auto layout = spheres({0.3});
    layout->walls = {pane(0.25, 0.25, 0.5)};
    observe::Frame frame = empty_frame(layout);
    frame.walls[0].translation = {0, 0.5, 0};
    const Picture picture = painter_for(square_view(1), layout, bare).draw(frame);
    CHECK(color_distance(pixel(picture, 200, 200 - 94), 0.5 * wall_color() + 0.5 * dark()) <= 2);
    CHECK(color_distance(pixel(picture, 200, 200), dark()) <= 1);
    const Vector3d rim = pixel(picture, 200, 200 - 47);
    const Vector3d other = pixel(picture, 200, 200 - 48);
    CHECK(std::max(rim.y(), other.y()) > wall_color().y() * 0.7);
    // Turned by a quarter about y the pane is seen from its edge: only the line is left.
    frame.walls[0].rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()).toRotationMatrix();
    const Picture turned = painter_for(square_view(1), layout, bare).draw(frame);
    CHECK(color_distance(pixel(turned, 200 + 20, 200 - 94), dark()) <= 1);
    CHECK(color_distance(pixel(turned, 200, 200 - 94), dark()) > 40);
}

TEST_CASE("a soup of triangles gets the smooth normals and edges of the surface it stands for") {
    // A quarter of a cylinder about z in 9 facets of 10 degrees, every triangle with corners of its own.
    observe::FrameWall wall;
    const auto rim_point = [](int i, double z) {
        const double angle = i * 10 * std::numbers::pi / 180;
        return Vector3d(std::cos(angle), std::sin(angle), z);
    };
    for (int i = 0; i < 9; ++i) {
        for (const auto& corners :
             {std::array<Vector3d, 3>{rim_point(i, 0), rim_point(i + 1, 0), rim_point(i, 1)},
              std::array<Vector3d, 3>{rim_point(i + 1, 0), rim_point(i + 1, 1), rim_point(i, 1)}}) {
            const int first = static_cast<int>(wall.vertices.size());
            wall.vertices.insert(wall.vertices.end(), corners.begin(), corners.end());
            wall.triangles.push_back({first, first + 1, first + 2});
        }
    }
    const WallSurface surface = make_wall_surface(wall);
    CHECK(surface.triangles.size() == 18);
    for (const auto& triangle : surface.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector3d radial = Vector3d(triangle.corners[k].x(), triangle.corners[k].y(), 0);
            // At the rim only one facet remains: 5 degrees off; inside less.
            CHECK(std::abs(triangle.normals[k].dot(radial)) > std::cos(5.01 * std::numbers::pi / 180));
        }
    }
    // 18 pieces of the two arcs and 2 straight ends are rims; 8 seams and 9 diagonals are not.
    const auto sharp = std::count_if(surface.edges.begin(), surface.edges.end(), [](const auto& e) { return e.sharp; });
    CHECK(sharp == 20);
    CHECK(surface.edges.size() == 37);
}

TEST_CASE("the edges of a box are sharp, the diagonals of its faces are not") {
    observe::FrameWall wall;
    for (int i = 0; i < 8; ++i) {
        wall.vertices.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    }
    wall.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}, {0, 5, 1}, {0, 4, 5},
                      {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    const WallSurface surface = make_wall_surface(wall);
    const auto sharp = std::count_if(surface.edges.begin(), surface.edges.end(), [](const auto& e) { return e.sharp; });
    CHECK(sharp == 12);
    CHECK(surface.edges.size() == 18);
}

TEST_CASE(
    "lines of a wall go on beyond a bend just as far as their outer sides do, and a round wall's lie end to end") {
    // Outer sides of two lines that bend by an angle meet tan(angle / 2) of half the thickness beyond the corner.
    observe::FrameWall wall;
    const double bend = 10 * std::numbers::pi / 180;
    wall.vertices = {{0, 0, 0}, {1, 0, 0}, {1 + std::cos(bend), std::sin(bend), 0}, {1, 5, 0}, {1, 5, 0},
                     {1, 4, 0}, {0, 4, 0}};
    wall.lines = {{0, 1}, {1, 2}, {3, 2}, {4, 5}, {5, 6}};
    const WallSurface surface = make_wall_surface(wall);
    REQUIRE(surface.edges.size() == 5);
    CHECK(surface.edges[0].beyond[0] == 0.5); // a free end
    CHECK(surface.edges[0].beyond[1] == about(std::tan(bend / 2)));
    CHECK(surface.edges[1].beyond[0] == about(std::tan(bend / 2)));
    CHECK(surface.edges[3].beyond[1] == about(1)); // a right angle
    CHECK(surface.edges[4].beyond[0] == about(1));
    CHECK(surface.edges[4].beyond[1] == 0.5);
    CHECK(surface.edges[2].beyond[0] == 1); // sharper than a right angle: back the way it came
}

TEST_CASE("triangles without area and with corners that do not exist are left out") {
    observe::FrameWall wall = pane(1, 1, 1);
    wall.triangles.push_back({0, 0, 1});
    wall.triangles.push_back({0, 1, 99});
    CHECK(make_wall_surface(wall).triangles.size() == 2);
}

} // namespace test_walls
