// Pictures and films that a studio keeps.
#include "opened.h"

namespace test_studio {

TEST_CASE("a picture is kept as PNG and a film as MP4, under names that nothing had") {
    Opened opened(test::pouring);
    test::put(opened.folder.path / "shaken-001.png", "not ours");
    opened.click("tab Keep");
    opened.click("picture");
    REQUIRE(opened.eventually([&] { return !opened.state["notice"].get<std::string>().empty(); }));
    CHECK(opened.state["notice"] == (opened.folder.path / "shaken-002.png").string());
    CHECK(std::filesystem::exists(opened.folder.path / "shaken-002.png")); // it is named when it is whole
    opened.click("film");
    opened.click("steps");
    REQUIRE(opened.eventually([&] { return opened.state["step"] == 100; }));
    opened.click("film");
    REQUIRE(opened.eventually([&] { return !opened.state["filmed"].get<std::string>().empty(); }));
    // A picture every 6 ms, 300 steps: the one at 0 alone within 100 steps.
    const std::filesystem::path film = opened.folder.path / "shaken-003.mp4";
    CHECK(opened.state["filmed"] == film.string() + " with 1 pictures");
    CHECK(std::filesystem::file_size(film) > 500);
    const auto folder = opened.folder.path;
    opened.studio.reset(); // what still waits is written
    CHECK(test::content_of(folder / "shaken-001.png") == "not ours");
    CHECK(test::content_of(folder / "shaken-002.png").substr(1, 3) == "PNG");
}

/// One sees 0.15 m/s: by speed that is a scale from 0 to 0.2 m/s, the next of 1, 2, 2.5, 5, and by a component, which
/// has a sign, one from -0.2 to 0.2.
TEST_CASE("a film's scales are those of the picture that first shows them, and stay when the camera turns") {
    using Range = std::array<double, 2>;
    Opened opened(test::pouring, 1000, 700, true);
    const std::vector<scene::Render>& films = opened.stage->films;
    opened.click("tab Keep");
    opened.click("film");
    REQUIRE(films.size() == 1);
    CHECK(films.back().range == Range{0, 0.2});
    opened.click("tab Look");
    opened.click("color");
    opened.click("color vx");
    CHECK(films.back().color == "vx");
    CHECK(films.back().range == Range{-0.2, 0.2});
    // Faster bodies, another camera: the picture's own range grows, the film's does not.
    opened.stage->vx = 3;
    opened.drag(600, 250, 660, 230);
    CHECK(films.back().eye != films.front().eye);
    CHECK(films.back().range == Range{-0.2, 0.2});
    CHECK(!films.back().marks.arrow_speed);
    opened.click("arrows");
    opened.click("arrows bodies");
    CHECK(films.back().marks.arrow_speed == 5.0); // 3 m/s
    opened.stage->vx = 30;
    opened.drag(600, 250, 660, 230);
    CHECK(films.back().marks.arrow_speed == 5.0);
    // A range that hands fix and leave open again is that of the picture then.
    opened.click("fixed range");
    const Range held = films.back().range.value();
    opened.click("fixed range");
    CHECK(films.back().range == held);
    CHECK(held == Range{-50, 50});
}

TEST_CASE("a film's force chains get their scale with the first frame that has looked for contacts") {
    Opened opened(test::pouring, 1000, 700, true);
    const std::vector<scene::Render>& films = opened.stage->films;
    opened.click("tab Keep");
    opened.click("film");
    opened.click("tab Look");
    opened.click("force chains");
    CHECK(films.back().marks.chains);
    CHECK(!films.back().marks.chain_force);
    observe::FrameContact contact;
    contact.a = 0;
    contact.normal = Eigen::Vector3d::UnitY();
    contact.force = 3 * Eigen::Vector3d::UnitY();
    opened.stage->contacts.emplace({contact});
    opened.draw();
    CHECK(films.back().marks.chain_force == 5.0); // 3 N
    opened.stage->contacts->front().force *= 10;
    opened.drag(600, 250, 660, 230);
    CHECK(films.back().marks.chain_force == 5.0);
}

TEST_CASE("a film that begins while nothing moves leaves its scales open") {
    Opened opened(test::pouring, 1000, 500, true);
    opened.stage->vx = 0;
    opened.draw();
    opened.click("tab Keep");
    opened.click("film");
    REQUIRE(opened.stage->films.size() == 1);
    CHECK(!opened.stage->films.back().range);
}

} // namespace test_studio
