#include "folder.h"
#include "lesson/show.h"
#include "render/color_map.h"
#include "render/quantity.h"
#include "sheet/plot.h"
#include "taught.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <stb/stb_image.h>
#include <string>

namespace test_pages {

using namespace tumble;
using namespace tumble::lesson;

namespace {

const std::filesystem::path pages = std::filesystem::path(TUMBLE_ROOT) / "docs" / "lessons";
const std::string remedy = " is stale: build/dev/tumble lesson --pages docs/lessons";

/// A PNG as its size, its colours, and the share of its pixels that are not white.
struct Seen {
    int width = 0, height = 0;
    std::set<std::array<int, 3>> colors;
    double inked = 0;

    explicit Seen(const std::filesystem::path& file) {
        int channels = 0;
        stbi_uc* pixels = stbi_load(file.c_str(), &width, &height, &channels, 3);
        REQUIRE_MESSAGE(pixels != nullptr, file.string());
        const int count = width * height;
        for (int k = 0; k < count; ++k) {
            const std::array<int, 3> color{pixels[3 * k], pixels[3 * k + 1], pixels[3 * k + 2]};
            colors.insert(color);
            inked += color == std::array{255, 255, 255} ? 0 : 1.0 / count;
        }
        stbi_image_free(pixels);
    }
    /// To within 2 of 255 in each channel.
    [[nodiscard]] bool has(const Eigen::Vector3d& color) const {
        const std::array<int, 3> near{static_cast<int>(255 * color.x()), static_cast<int>(255 * color.y()),
                                      static_cast<int>(255 * color.z())};
        for (int red = -2; red <= 2; ++red)
            for (int green = -2; green <= 2; ++green)
                for (int blue = -2; blue <= 2; ++blue)
                    if (colors.contains({near[0] + red, near[1] + green, near[2] + blue}))
                        return true;
        return false;
    }
};

/// Share of the bodies in a film's poster whose colour the picture has.
double share_of_bodies(const Film& film, const Seen& picture, const render::ColorMap& map) {
    std::size_t last = 0;
    for (const Reel& reel : film.reels)
        last = std::max(last, reel.frames.size() - 1);
    double bodies = 0, found = 0;
    for (const Reel& reel : film.reels) {
        const observe::Frame& frame = reel.frames[std::min(film.poster.value_or(last), reel.frames.size() - 1)];
        const auto quantity = render::find_quantity(film.color, frame.layout->dimension);
        REQUIRE(quantity.ok());
        for (const double value : render::values_of(*quantity, frame)) {
            found += picture.has(map.at((value - film.range[0]) / (film.range[1] - film.range[0]))) ? 1 : 0;
            ++bodies;
        }
    }
    return found / bodies;
}

} // namespace

TEST_CASE("docs/lessons says what the program teaches, and every figure shows it") {
    for (const Lesson& lesson : all_lessons()) {
        const Walk walk = testing::taught(lesson.name);
        const bool fresh =
            test::content_of(pages / (lesson.name + ".md")) == to_page(lesson, *read_values(lesson), walk);
        CHECK_MESSAGE(fresh, "docs/lessons/" << lesson.name << ".md" << remedy);
        for (const Figure* figure : walk.figures()) {
            const std::string svg = test::content_of(pages / lesson.name / (figure->name + ".svg"));
            CHECK_MESSAGE(svg.find(mark_of(*figure)) != std::string::npos,
                          lesson.name << "/" << figure->name << remedy);
        }
    }
    const bool fresh = test::content_of(pages / "index.md") == contents_page();
    CHECK_MESSAGE(fresh, "docs/lessons/index.md" << remedy);
}

TEST_CASE(
    "the picture that stands for a film shows the legend's colours, and in two dimensions those of its bodies now") {
    for (const Lesson& lesson : all_lessons())
        for (const Film& film : testing::taught(lesson.name).films) {
            CAPTURE(film.name);
            const Seen picture(pages / lesson.name / (film.name + ".png"));
            CHECK(picture.width == 1280);
            CHECK(picture.height == 720);
            CHECK(picture.inked > 0.03);
            CHECK(picture.inked < 0.9);
            const observe::Frame& first = film.reels.front().frames.front();
            const auto quantity = render::find_quantity(film.color, first.layout->dimension);
            REQUIRE(quantity.ok());
            const auto map = render::find_color_map("auto", quantity->has_sign);
            REQUIRE(map.ok());
            for (int k = 0; k <= 10; ++k)
                CHECK_MESSAGE(picture.has(map->at(0.1 * k)), film.name << remedy);
            // Discs are flat and wear the legend's colour; a few may be out of sight. Spheres are shaded.
            if (first.layout->dimension == 2)
                CHECK_MESSAGE(share_of_bodies(film, picture, *map) > 0.9, film.name << remedy);
        }
}

} // namespace test_pages
