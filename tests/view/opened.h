#pragma once

#include "../folder.h"
#include "../run/scenes.h"
#include "view/live_source.h"
#include "view/studio.h"

#include <chrono>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <thread>

/// A studio that is opened on a scene at rest, or on a stage.
namespace test_studio {

using namespace tumble;
using namespace tumble::view;

/// A simulation at rest in which bodies move and press as they are told, and what films are asked of it.
class Staged final : public Source {
public:
    explicit Staged(std::unique_ptr<Source> real) : real_(std::move(real)) {}

    double vx = 0.15;                                             // m/s, of one half of the bodies; the other's is -vx
    std::optional<std::vector<observe::FrameContact>> contacts{}; // once they are wanted
    std::vector<scene::Render> films{};                           // begun, then restyled

    MomentPtr newest() override {
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
        return state;
    }
    void film(const scene::Render& settings, const std::filesystem::path&) override { films = {settings}; }
    void restyle_film(const scene::Render& settings) override { films.push_back(settings); }
    void film_no_more() override { films.clear(); }

    std::shared_ptr<const observe::FrameLayout> layout() const override { return real_->layout(); }
    Eigen::AlignedBox3d bounds() const override { return real_->bounds(); }
    void play(bool on) override { real_->play(on); }
    void step(std::int64_t count) override { real_->step(count); }
    void set_speed(double speed) override { real_->set_speed(speed); }
    bool can_seek() const override { return false; }
    bool can_show_contacts() const override { return true; }
    bool can_change() const override { return false; }

private:
    std::unique_ptr<Source> real_;
    std::uint64_t told_ = 0;
};

/// A studio of a scene at rest, and its last picture.
struct Opened {
    test::Folder folder;
    SceneText text;
    std::unique_ptr<Studio> studio;
    Staged* stage = nullptr; // where it is staged
    render::Picture picture;
    nlohmann::json state;

    explicit Opened(const std::string& toml, int width = 1000, int height = 500, bool staged = false)
        : text{toml, "shaken.toml", {}} {
        const auto scene = text.load();
        REQUIRE(scene.ok());
        auto source = open_live(text, *scene, 1, [] {});
        REQUIRE(source.ok());
        if (staged) {
            auto on_stage = std::make_unique<Staged>(std::move(*source));
            stage = on_stage.get();
            source = std::unique_ptr<Source>(std::move(on_stage));
        }
        Plots plots = Plots::of_simulation(*scene, *(*source)->layout());
        auto opened = Studio::open(std::move(*source), text, *scene, std::move(plots), {width, height, folder.path});
        REQUIRE_MESSAGE(opened.ok(), to_string(opened.problems()));
        studio = std::move(*opened);
        draw();
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
    void drag(double x, double y, double to_x, double to_y, int button = 0) {
        studio->take(PointerMoved{x, y});
        studio->take(PointerPressed{button, x, y});
        studio->take(PointerMoved{to_x, to_y});
        studio->take(PointerReleased{button, to_x, to_y});
        draw();
    }
};

} // namespace test_studio
