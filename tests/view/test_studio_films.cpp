// Pictures and films that a studio keeps.
#include "../video.h"
#include "keeper.h"
#include "opened.h"

using namespace tumble;
using namespace tumble::view;
using namespace tumble::view::testing;

namespace test_studio_films {

/// The pictures of a film that a Keeper kept.
std::vector<render::Picture> pictures_of(const std::filesystem::path& film, int width, int height) {
    const std::string bytes = test::content_of(film);
    const std::size_t size = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    REQUIRE(!bytes.empty());
    REQUIRE(bytes.size() % size == 0);
    std::vector<render::Picture> pictures;
    for (std::size_t at = 0; at < bytes.size(); at += size)
        pictures.push_back({width,
                            height,
                            {bytes.begin() + static_cast<std::ptrdiff_t>(at),
                             bytes.begin() + static_cast<std::ptrdiff_t>(at + size)}});
    return pictures;
}

/// What is seen of the scene beside the panel, or without it where it takes all of the window.
render::Picture scene_of(const render::Picture& seen, int left) {
    render::Picture scene{seen.width - left, seen.height, {}};
    for (int y = 0; y < seen.height; ++y) {
        const auto row = seen.rgba.begin() + static_cast<std::ptrdiff_t>(4) * y * seen.width;
        scene.rgba.insert(scene.rgba.end(), row + static_cast<std::ptrdiff_t>(4) * left,
                          row + static_cast<std::ptrdiff_t>(4) * seen.width);
    }
    return scene;
}

/// Turned and zoomed by hands, then filmed from the panel: what is seen, and the film's pictures.
std::pair<render::Picture, std::vector<render::Picture>> seen_and_filmed(Opened& opened) {
    const auto [width, height] = std::pair{opened.picture.width, opened.picture.height};
    const bool beside = opened.state["panel"];
    opened.studio->take(WheelTurned{0.7 * width, 0.4 * height, 2});
    opened.drag(0.7 * width, 0.5 * height, 0.7 * width + 50, 0.5 * height - 20);
    opened.settle();
    const int left = beside ? panel : 0;
    const render::Picture seen = scene_of(opened.picture, left);
    if (!beside)
        opened.studio->take(PanelToggled{});
    opened.draw();
    opened.click("tab Keep");
    opened.click("film");
    if (!opened.studio->source().can_seek())
        opened.click("film");
    REQUIRE(opened.eventually([&] { return !opened.state["filmed"].get<std::string>().empty(); }));
    const std::string filmed = opened.state["filmed"];
    const auto end = filmed.find(" with ");
    REQUIRE_MESSAGE(end != std::string::npos, filmed);
    return {seen, pictures_of(filmed.substr(0, end), width - left, height)};
}

/// In a window narrower than 6:5 a free camera that no hand holds opens wider.
TEST_CASE("a film of what goes on begins with the picture that is seen, in windows of all shapes") {
    const Keeper keeper;
    for (const auto& [width, height] : {std::pair{480, 640}, {390, 844}, {1000, 500}, {800, 700}}) {
        CAPTURE(width);
        Opened opened(test::pouring, width, height);
        const auto [seen, filmed] = seen_and_filmed(opened);
        REQUIRE(filmed.size() == 1);
        CHECK(differences(seen, filmed[0], 0, seen.width) == 0);
    }
}

TEST_CASE("a film of a run that is over has its frames with the camera as it is held when it begins") {
    const Keeper keeper;
    Recorded recorded;
    recorded.scene.render.plot = false;
    recorded.scene.render.range = {0.0, 0.2};
    for (const auto& [width, height] : {std::pair{480, 640}, {1000, 500}}) {
        CAPTURE(width);
        Opened opened(recorded, width, height);
        opened.draw();
        const auto [seen, filmed] = seen_and_filmed(opened);
        REQUIRE(filmed.size() == 5);
        CHECK(differences(seen, filmed[0], 0, seen.width) == 0);
        CHECK(differences(seen, filmed[4], 0, seen.width) > 0); // it has fallen by 2 mm
    }
}

/// The run's film as it is asked for.
class Asked final : public Source {
public:
    explicit Asked(std::unique_ptr<Source> real) : real_(std::move(real)) {}
    std::optional<FilmLook> look{};

    void film(const FilmLook& wanted, const std::filesystem::path&) override { look = wanted; }
    void film_no_more() override {}
    std::shared_ptr<const observe::FrameLayout> layout() const override { return real_->layout(); }
    Eigen::AlignedBox3d bounds() const override { return real_->bounds(); }
    MomentPtr newest() override { return real_->newest(); }
    SourceState state() override { return real_->state(); }
    void play(bool on) override { real_->play(on); }
    void step(std::int64_t count) override { real_->step(count); }
    void set_speed(double speed) override { real_->set_speed(speed); }
    bool can_seek() const override { return true; }
    Result<Stretch> find(double from, double to) override { return real_->find(from, to); }
    bool can_show_contacts() const override { return false; }
    bool can_change() const override { return false; }

private:
    std::unique_ptr<Source> real_;
};

/// A painter that has drawn with these settings.
render::Painter painted(const scene::Render& settings, const std::optional<render::Held>& held, Source& source) {
    auto painter = render::Painter::open(settings, source.layout());
    REQUIRE_MESSAGE(painter.ok(), to_string(painter.problems()));
    painter->fit(source.bounds());
    painter->hold_camera(held);
    (void)painter->draw(source.newest()->frame);
    return std::move(*painter);
}

TEST_CASE("a film of a run that is over with its small plot shows all that was seen without it") {
    const Recorded recorded;
    REQUIRE(recorded.scene.render.plot);
    for (const auto& [width, height] : {std::pair{480, 640}, {1000, 500}, {800, 700}}) {
        CAPTURE(width);
        Opened opened(recorded, width, height);
        auto asked = std::make_unique<Asked>(recorded.again());
        Asked& source = *asked;
        opened.open(std::move(asked), Plots::of_run(recorded.run, recorded.scene), width, height);
        opened.draw();
        opened.studio->take(WheelTurned{0.7 * width, 0.4 * height, 2});
        opened.drag(0.7 * width, 0.5 * height, 0.7 * width + 50, 0.5 * height - 20);
        if (!opened.state["panel"])
            opened.studio->take(PanelToggled{});
        opened.draw();
        opened.click("tab Keep");
        opened.click("film");
        REQUIRE(source.look);
        scene::Render seen_settings = source.look->settings;
        CHECK(seen_settings.plot);
        const render::Painter film = painted(source.look->settings, source.look->held, source);
        seen_settings.plot = false;
        const render::Painter seen = painted(seen_settings, source.look->held, source);
        const render::Area& area = seen.layout().scene;
        const render::Area& room = film.layout().scene;
        CHECK(room.width() * room.height() < 0.95 * area.width() * area.height());
        const render::Camera& camera = seen.camera();
        const double metres = 1 / camera.pixels_per_metre(camera.target);
        for (const double x : {area.left, area.right})
            for (const double y : {area.top, area.bottom}) {
                const Eigen::Vector2d way = metres * (Eigen::Vector2d(x, y) - camera.centre);
                const Eigen::Vector2d at = film.camera().to_picture(
                    camera.target + camera.axes.transpose() * Eigen::Vector3d(way.x(), -way.y(), 0));
                CHECK(at.x() > room.left - 0.01);
                CHECK(at.x() < room.right + 0.01);
                CHECK(at.y() > room.top - 0.01);
                CHECK(at.y() < room.bottom + 0.01);
            }
    }
}

TEST_CASE("pictures asked for in one go are all named once they are written, and no more than wait are taken") {
    Opened opened(test::pouring);
    opened.click("tab Keep");
    const auto [x, y] = opened.middle_of("picture");
    const auto ask = [&, x = x, y = y](int times) {
        opened.studio->take(PointerMoved{x, y});
        for (int i = 0; i < times; ++i) {
            opened.studio->take(PointerPressed{0, x, y});
            opened.studio->take(PointerReleased{0, x, y});
        }
        opened.draw();
    };
    const auto file = [&](int number) {
        return (opened.folder.path / ("shaken-00" + std::to_string(number) + ".png")).string();
    };
    ask(2);
    CHECK(opened.eventually([&] { return opened.state["notice"] == file(1) + "\n" + file(2); }));
    ask(5);
    CHECK(opened.state["notice"].get<std::string>().starts_with("4 pictures are being written"));
    const std::string all = file(3) + "\n" + file(4) + "\n" + file(5) + "\n" + file(6);
    CHECK(opened.eventually([&] { return opened.state["notice"] == all; }));
    for (int number = 1; number <= 7; ++number)
        CHECK(std::filesystem::exists(file(number)) == (number < 7));
}

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
    if (test::can_check_videos())
        CHECK(test::probed(film) == "700,500,1"); // the scene beside the panel
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

} // namespace test_studio_films
