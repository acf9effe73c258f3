#pragma once

#include "recorded.h"
#include "view/live_source.h"
#include "view/studio.h"

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

/// A studio that is opened on a scene at rest, on a stage, or on a run.
namespace tumble::view::testing {

constexpr int panel = 300; // pixels

/// Pixels that differ to the eye, in columns left .. right: by more than 12 of 255.
inline std::size_t differences(const render::Picture& a, const render::Picture& b, int left, int right) {
    REQUIRE(a.width == b.width);
    REQUIRE(a.height == b.height);
    std::size_t count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = left; x < right; ++x) {
            int most = 0;
            for (int channel = 0; channel < 3; ++channel) {
                const auto at = 4 * static_cast<std::size_t>(y * a.width + x) + static_cast<std::size_t>(channel);
                most = std::max(most, std::abs(a.rgba[at] - b.rgba[at]));
            }
            count += most > 12 ? 1 : 0;
        }
    return count;
}

/// A simulation at rest in which bodies move and press as they are told, and what films are asked of it.
class Staged final : public Source {
public:
    explicit Staged(std::unique_ptr<Source> real) : real_(std::move(real)) {}

    double vx = 0.15;                                             // m/s, of one half of the bodies; the other's is -vx
    std::optional<std::vector<observe::FrameContact>> contacts{}; // once they are wanted
    std::vector<scene::Render> films{};                           // begun, then restyled
    std::atomic<int> looks{0};                                    // at its newest moment
    bool plays = false;                                           // or says so
    double steps_per_s = 0;

    MomentPtr newest() override {
        ++looks;
        auto moment = std::make_shared<Moment>(*real_->newest());
        observe::Frame& frame = moment->frame;
        for (std::size_t b = 0; b < frame.bodies(); ++b)
            frame.velocity[b] = Eigen::Vector3d(b % 2 == 0 ? vx : -vx, 0, 0);
        frame.time = 1e-3 * static_cast<double>(told_);
        frame.contacts = contacts;
        moment->number = ++told_;
        return moment;
    }
    SourceState state() override {
        SourceState state = real_->state();
        state.filming = !films.empty();
        state.playing = state.playing || plays;
        state.steps_per_s = steps_per_s;
        return state;
    }
    void film(const FilmLook& look, const std::filesystem::path&) override { films = {look.settings}; }
    void restyle_film(const FilmLook& look) override { films.push_back(look.settings); }
    void film_no_more() override { films.clear(); }

    std::shared_ptr<const observe::FrameLayout> layout() const override { return real_->layout(); }
    Eigen::AlignedBox3d bounds() const override { return real_->bounds(); }
    void play(bool on) override { real_->play(on); }
    void step(std::int64_t count) override { real_->step(count); }
    void set_speed(double speed) override { real_->set_speed(speed); }
    bool can_seek() const override { return false; }
    Result<Stretch> find(double from, double to) override { return real_->find(from, to); }
    bool can_show_contacts() const override { return true; }
    bool can_change() const override { return false; }

private:
    std::unique_ptr<Source> real_;
    std::uint64_t told_ = 0;
};

/// A studio of a scene at rest at its beginning, and its last picture.
struct Opened {
    test::Folder folder;
    SceneText text;
    scene::Scene scene;
    std::unique_ptr<Studio> studio;
    Staged* stage = nullptr; // where it is staged
    render::Picture picture;
    nlohmann::json state;

    explicit Opened(const std::string& toml, int width = 1000, int height = 500, bool staged = false,
                    const std::vector<scene::Override>& sets = {})
        : text{toml, "shaken.toml", sets} {
        auto loaded = text.load();
        REQUIRE_MESSAGE(loaded.ok(), to_string(loaded.problems()));
        scene = std::move(*loaded);
        auto source = open_live(text, scene, 1, [] {});
        REQUIRE(source.ok());
        if (staged) {
            auto on_stage = std::make_unique<Staged>(std::move(*source));
            stage = on_stage.get();
            source = std::unique_ptr<Source>(std::move(on_stage));
        }
        Plots plots = Plots::of_simulation(scene, *(*source)->layout());
        open(std::move(*source), std::move(plots), width, height);
        draw();
    }
    /// Nothing has been drawn yet.
    explicit Opened(const Recorded& recorded, int width = 1000, int height = 500)
        : text(*SceneText::read(recorded.run / "scene.toml", {})), scene(recorded.scene) {
        open(recorded.again(), Plots::of_run(recorded.run, scene), width, height);
    }
    void open(std::unique_ptr<Source> source, Plots plots, int width, int height) {
        auto opened = Studio::open(std::move(source), text, scene, std::move(plots), {width, height, folder.path});
        REQUIRE_MESSAGE(opened.ok(), to_string(opened.problems()));
        studio = std::move(*opened);
    }
    void draw() {
        auto shown = studio->draw();
        REQUIRE_MESSAGE(shown.ok(), to_string(shown.problems()));
        picture = std::move(shown->picture);
        state = nlohmann::json::parse(shown->state);
    }
    /// Waits for the simulation; a minute is only there so that a broken program fails instead of hanging.
    bool eventually(const std::function<bool()>& holds) {
        for (int i = 0; i < 6000; ++i) {
            draw();
            if (holds())
                return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }
    /// What moved is drawn with smooth edges once it rests.
    void settle() {
        REQUIRE(eventually([&] { return state["sketched"] == false; }));
    }
    std::array<double, 2> middle_of(const std::string& name) const {
        REQUIRE_MESSAGE(state["places"].contains(name), name);
        const auto place = state["places"][name].get<std::array<double, 4>>();
        return {0.5 * (place[0] + place[2]), 0.5 * (place[1] + place[3])};
    }
    /// A press and its release in one go, as quick hands do.
    void click(const std::string& name) {
        const auto [x, y] = middle_of(name);
        studio->take(PointerMoved{x, y});
        studio->take(PointerPressed{0, x, y});
        studio->take(PointerReleased{0, x, y});
        draw();
    }
    void resize(int width, int height, double ratio = 1) {
        studio->take(Resized{width, height, ratio});
        draw();
    }
    void drag(double x, double y, double to_x, double to_y, int button = 0) {
        studio->take(PointerMoved{x, y});
        studio->take(PointerPressed{button, x, y});
        studio->take(PointerMoved{to_x, to_y});
        studio->take(PointerReleased{button, to_x, to_y});
        draw();
    }
};

} // namespace tumble::view::testing
