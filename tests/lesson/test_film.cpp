#include "about.h"
#include "folder.h"
#include "lesson/film.h"
#include "lesson/stage.h"
#include "taught.h"
#include "video.h"

#include <algorithm>

namespace test_film {

using namespace tumble;
using tumble::test::about;
using namespace tumble::lesson;
using namespace tumble::lesson::testing;

namespace {

/// A disc that flies, and one that a step far too long throws out of its cage.
Film flights() {
    scene::Scene free = plane_stage(linear_pair(1e5, 0.5, 1, 0), 1e-3);
    put(free, add_round(free, 0.1, 1), {0, 0}, {1, 0});
    scene::Scene caged = plane_stage(linear_pair(1e9, 0.5, 1, 0), 1e-3);
    put(caged, add_round(caged, 0.1, 1), {0, 0}, {1, 0});
    add_wall(caged, scene::Outline(scene::SegmentShape{{0.12, -1}, {0.12, 1}}));
    Film film_of_both{.name = "flights", .title = "Flights", .reels = {}, .every = 0.02};
    for (const scene::Scene& scene : {free, caged}) {
        auto reel = film(scene, "flight", 0.2, film_of_both.every);
        REQUIRE_MESSAGE(reel.ok(), to_string(reel.problems()));
        film_of_both.reels.push_back(std::move(*reel));
    }
    return film_of_both;
}

} // namespace

TEST_CASE("a reel has a frame at every instant asked for, until the solver stops") {
    const Film film = flights();
    REQUIRE(film.reels[0].frames.size() == 11);
    for (std::size_t k = 0; k < 11; ++k) {
        CHECK(film.reels[0].frames[k].time == about(0.02 * static_cast<double>(k)));
        CHECK(film.reels[0].frames[k].position[0].x() == about(0.02 * static_cast<double>(k)));
    }
    CHECK(film.reels[1].frames.size() >= 2); // the wall is reached after 0.02 s
    CHECK(film.reels[1].frames.size() < 11);
}

TEST_CASE("a film leaves its picture, and its video where ffmpeg is") {
    const test::Folder folder;
    const Film film = flights();
    const auto drawn = draw_poster(film, folder.path / "flights.png");
    REQUIRE_MESSAGE(drawn.ok(), to_string(drawn.problems()));
    CHECK(test::content_of(folder.path / "flights.png").substr(1, 3) == "PNG");
    const auto shot = shoot(film, folder.path / "flights.mp4");
    REQUIRE_MESSAGE(shot.ok(), to_string(shot.problems()));
    CHECK(test::content_of(folder.path / "flights.mp4").substr(4, 4) == "ftyp");
    if (test::can_check_videos())
        CHECK(test::probed(folder.path / "flights.mp4", "nb_read_frames") == "11"); // from 0 to 0.2 s every 20 ms
}

TEST_CASE("lessons where motion teaches something have a film") {
    for (const char* name : {"time-step", "friction", "repose", "soft-and-hard", "clumps"}) {
        CAPTURE(name);
        const Walk walk = taught(name);
        REQUIRE(walk.films.size() == 1);
        for (const Reel& reel : walk.films[0].reels)
            CHECK(!reel.frames.empty());
    }
}

TEST_CASE("time-step: at 0.7 of its limit a heap stays at rest, at 2.8 times the limit it makes energy from nothing "
          "and boils") {
    const Walk walk = taught("time-step");
    const auto fastest = [&](std::size_t side) {
        double most = 0;
        for (const Eigen::Vector3d& velocity : walk.films[0].reels[side].frames.back().velocity)
            most = std::max(most, velocity.norm());
        return most;
    };
    // Gravity, 1e-3 R k / m over the six rows, reaches a swing of 1e-3 R about the overlap that it makes: w times that.
    const double w = std::sqrt(2 * 1e5 / 1.0);
    CHECK(fastest(0) < 10 * 1e-3 * 0.1 * w);
    CHECK(fastest(1) > 0.1 * 0.1 * w);
}

} // namespace test_film
