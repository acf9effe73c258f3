#include "about.h"
#include "fixtures.h"
#include "render/color_map.h"
#include "render/sphere_raster.h"

#include <bit>
#include <numbers>
#include <random>

namespace test_sphere_raster {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

namespace {

/// Four samples a pixel where Mesa takes them.
Sampling four_samples() {
    Sampling sampling;
    sampling.samples = 4;
    const std::array<std::array<float, 2>, 4> places{
        {{0.375F, 0.125F}, {0.875F, 0.375F}, {0.125F, 0.625F}, {0.625F, 0.875F}}};
    for (int lane = 0; lane < samples_at_once; ++lane) {
        sampling.across[lane] = places[static_cast<std::size_t>(lane % 4)][0] + static_cast<float>(lane / 4);
        sampling.up[lane] = places[static_cast<std::size_t>(lane % 4)][1];
    }
    return sampling;
}

Camera looking_at_origin(bool perspective, int width, int height) {
    scene::Render settings;
    settings.camera = "free";
    settings.projection = perspective ? "perspective" : "orthographic";
    settings.eye = {0.2, 0.3, 4};
    const Eigen::AlignedBox3d box(Vector3d::Constant(-1), Vector3d::Constant(1));
    auto camera = make_camera(settings, box, {0, 0, static_cast<double>(width), static_cast<double>(height)});
    REQUIRE(camera.ok());
    return *camera;
}

std::vector<SphereMark> cloud(const Camera& camera, int count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-0.9, 0.9), radius(0.01, 0.1);
    std::vector<SphereMark> marks;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3f at = camera.to_view({place(random), place(random), place(random)}).cast<float>();
        marks.push_back({at.x(), at.y(), at.z(), static_cast<float>(radius(random)),
                         0xff000000U | static_cast<unsigned>(random())});
    }
    return marks;
}

struct Drawn {
    std::vector<std::uint32_t> colors;
    std::vector<float> depths;
    friend bool operator==(const Drawn&, const Drawn&) = default;
};

Drawn draw(int threads, const std::vector<SphereMark>& marks, const Camera& camera, int width, int height,
           bool skip_hidden, const std::optional<Eigen::AlignedBox3d>& cut = {}) {
    Crew crew(threads);
    SphereRaster raster;
    const Area window{0, 0, static_cast<double>(width), static_cast<double>(height)};
    raster.take(marks, camera, width, height, window, four_samples(), skip_hidden, cut);
    const std::size_t samples = raster.row_length() * static_cast<std::size_t>(raster.tile_height() * raster.rows());
    Drawn drawn{std::vector<std::uint32_t>(samples), std::vector<float>(samples, 1)};
    raster.draw(0, raster.rows(), {true, 0.1F}, drawn.colors.data(), drawn.depths.data(), crew);
    return drawn;
}

} // namespace

TEST_CASE("any number of threads draws the same bits, and so does drawing what is hidden too") {
    for (const bool perspective : {false, true}) {
        const Camera camera = looking_at_origin(perspective, 230, 170);
        const std::vector<SphereMark> marks = cloud(camera, 3000);
        const Drawn one = draw(1, marks, camera, 230, 170, true);
        CHECK(draw(2, marks, camera, 230, 170, true) == one);
        CHECK(draw(3, marks, camera, 230, 170, true) == one);
        CHECK(draw(2, marks, camera, 230, 170, false) == one);
        const Eigen::AlignedBox3d box(Vector3d(-0.5, -0.3, -0.4), Vector3d(0.6, 0.5, 0.3));
        const Drawn cut = draw(1, marks, camera, 230, 170, true, box);
        CHECK(draw(3, marks, camera, 230, 170, true, box) == cut);
        CHECK(draw(2, marks, camera, 230, 170, false, box) == cut);
        CHECK(cut.depths != one.depths);
        CHECK(std::count(one.depths.begin(), one.depths.end(), 1.0F) < static_cast<std::ptrdiff_t>(one.depths.size()));
    }
}

TEST_CASE("every instruction set draws the same bits") {
    REQUIRE(kernels_named("baseline") != nullptr);
    CHECK(kernels_named("68000") == nullptr);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-5, 40), depth(-3, -1), radius(0.01F, 0.2F);
    std::vector<Ball> balls(200);
    std::vector<ListedBall> listed;
    for (Ball& ball : balls) {
        ball = {place(random),
                place(random),
                depth(random),
                radius(random),
                0,
                static_cast<std::uint32_t>(random()),
                -100,
                100,
                -100,
                100};
        ball.nearest = ball.z + 1.001F * ball.radius;
        listed.push_back({static_cast<std::uint32_t>(listed.size()), ball.nearest, 0, 31, 0, 15});
    }
    const std::array<CutPlane, planes_of_cut> planes{{{0, 0, 1, -1.8F},
                                                      {0, 0, -1, 2.6F},
                                                      {1, 0, 0, 0.1F},
                                                      {-1, 0, 0, 0.3F},
                                                      {0, 0.6F, 0.8F, -1.4F},
                                                      {0, -1, 0, 0.2F}}};
    for (const auto& [perspective, cut] :
         {std::pair{false, false}, std::pair{true, false}, std::pair{false, true}, std::pair{true, true}}) {
        TileJob job;
        job.cut = cut ? planes.data() : nullptr;
        job.sampling = four_samples();
        job.sight = {perspective, perspective ? 200.0F : 90.0F, 17.3F, 4.1F, 0.2F, perspective ? 0.5F : -0.2F};
        job.light = {true, 0.1F};
        job.balls = balls.data();
        job.listed = listed.data();
        job.count = static_cast<int>(balls.size());
        job.disorder = 10; // they are in no order
        job.row = job.sampling.tile_width() * job.sampling.samples;
        std::vector<Drawn> all;
        for (const char* name : {"baseline", "x86-64-v3", "x86-64-v4"})
            if (const Kernels* kernels = kernels_named(name)) {
                Drawn& drawn = all.emplace_back(
                    Drawn{std::vector<std::uint32_t>(samples_in_tile), std::vector<float>(samples_in_tile)});
                job.colors = drawn.colors.data();
                job.depths = drawn.depths.data();
                kernels->draw_tile(job);
            }
        for (const Drawn& drawn : all) {
            CHECK(drawn.colors == all.front().colors);
            CHECK(
                std::equal(drawn.depths.begin(), drawn.depths.end(), all.front().depths.begin(), [](float a, float b) {
                    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
                }));
        }
    }
}

TEST_CASE("a picture larger than what travels at once holds a sphere whole") {
    auto layout = spheres({0.5});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0.1, 0}, {1, 0, 0});
    scene::Render settings = square_view(1);
    settings.width = 1200;
    settings.height = 1100; // 5.3 million samples
    Painter painter = painter_for(settings, layout, bare);
    const Picture picture = painter.draw(frame);
    const double radius = 0.5 * painter.camera().scale;
    const Vector3d inside = pixel(picture, 600, 550), outside = pixel(picture, 3, 3);
    CHECK(covered_pixels(picture, inside, outside) == about(std::numbers::pi * radius * radius, 0.0005));
}

TEST_CASE("an opaque wall through a sphere leaves the cap before it, in parallel and in perspective") {
    // The pane x = -0.3 cuts the ball of 0.5 m about the origin in a circle of sqrt(0.5^2 - 0.3^2) = 0.4 m across the
    // axis, which the eye at x = -4 sees from 3.7 m. The cap's outline is that circle: the rest of the ball is behind.
    for (const bool perspective : {false, true}) {
        CAPTURE(perspective);
        auto layout = spheres({0.5});
        layout->walls = {pane(0.9, 0.9, 1)};
        observe::Frame frame = empty_frame(layout);
        frame.walls[0].translation = {-0.3, 0, 0};
        add_body(frame, 0, Vector3d::Zero(), {1, 0, 0});
        scene::Render settings = square_view(1);
        settings.camera = "free";
        settings.projection = perspective ? "perspective" : "orthographic";
        settings.eye = {-4, 0, 0};
        Painter painter = painter_for(settings, layout, bare);
        const Picture picture = painter.draw(frame);
        const double scale = perspective ? painter.camera().scale / 3.7 : painter.camera().scale;
        const Vector3d ball = pixel(picture, 200, 200), wall = pixel(picture, 200 + static_cast<int>(0.6 * scale), 200);
        double sum = 0; // of pixels between the two colours; the pane's rim lies farther out
        const int reach = static_cast<int>(0.5 * scale);
        for (int y = 200 - reach; y < 200 + reach; ++y)
            for (int x = 200 - reach; x < 200 + reach; ++x)
                sum +=
                    std::clamp((pixel(picture, x, y) - wall).dot(ball - wall) / (ball - wall).squaredNorm(), 0.0, 1.0);
        CHECK(sum == about(std::numbers::pi * 0.16 * scale * scale, 0.004));
    }
}

} // namespace test_sphere_raster
