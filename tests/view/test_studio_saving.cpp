// Scenes that a studio saves, and what hands may ask of it in one go.
#include "../about.h"
#include "opened.h"
#include "run/scene_check.h"

using namespace tumble;
using namespace tumble::view;
using namespace tumble::view::testing;
using test::about;

namespace test_studio_saving {

scene::Scene saved_by(Opened& opened) {
    opened.click("save scene");
    const auto scene = scene::load_scene(opened.state["saved"].get<std::string>());
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    return *scene;
}

void press(Opened& opened, const char* key, bool ctrl = false) {
    opened.studio->take(KeyChanged{key, true, false, ctrl});
}

/// Ctrl and a click, then a number and Enter.
void type_into(Opened& opened, const std::string& slider, const std::string& number) {
    press(opened, "ControlLeft", true);
    opened.click(slider);
    opened.studio->take(KeyChanged{"ControlLeft", false, false, false});
    opened.draw();
    opened.studio->take(TextTyped{number});
    opened.draw();
    press(opened, "Enter");
    opened.studio->take(KeyChanged{"Enter", false, false, false});
    opened.draw();
}

TEST_CASE("what a hand does right after R begins from the scene's own camera, drawn or not") {
    Opened apart(test::pouring), at_once(test::pouring);
    for (Opened* each : {&apart, &at_once}) {
        each->drag(600, 250, 700, 200);
        press(*each, "KeyR");
        if (each == &apart)
            each->draw();
        each->studio->take(WheelTurned{700, 200, 2});
        each->draw();
    }
    CHECK(at_once.state["camera"] == apart.state["camera"]);
}

TEST_CASE("a scene whose camera turns is saved as one, unless a hand has chosen another") {
    Opened opened(test::pouring, 1000, 700, false, {{"render.camera=\"free\""}, {"render.turn_deg_s=90"}});
    opened.click("tab Change");
    CHECK(saved_by(opened).render.turn_deg_s == 90);
    opened.drag(600, 250, 660, 230);
    CHECK(saved_by(opened).render.turn_deg_s == 0);
    press(opened, "KeyR");
    CHECK(saved_by(opened).render.turn_deg_s == 90);
    opened.click("camera top");
    CHECK(saved_by(opened).render.turn_deg_s == 0);
    press(opened, "KeyR");
    opened.draw();
    opened.click("tab Look");
    opened.click("arrows");
    opened.click("arrows field"); // belongs to a camera that stands still
    opened.click("tab Change");
    CHECK(saved_by(opened).render.turn_deg_s == 0);
}

TEST_CASE("a scene of two dimensions is saved with what is seen of it, and shows the same when it is opened") {
    Opened opened(test::raining);
    CHECK(!opened.scene.render.view);
    opened.click("tab Change");
    CHECK(!saved_by(opened).render.view); // nobody has chosen anything
    opened.drag(600, 250, 660, 230);
    opened.studio->take(WheelTurned{700, 200, 4}); // and not yet drawn when the scene is saved
    const scene::Scene saved = saved_by(opened);
    REQUIRE(saved.render.view);
    const auto check = run::check_scene(saved, 1);
    REQUIRE_MESSAGE(check.ok(), to_string(check.problems()));
    CHECK_MESSAGE(check->warnings.empty(), (check->warnings.empty() ? "" : check->warnings.front()));
    opened.settle();
    Opened again(test::content_of(opened.state["saved"].get<std::string>()));
    for (int axis = 0; axis < 2; ++axis)
        CHECK(again.state["camera"]["target"][axis].get<double>() ==
              about(opened.state["camera"]["target"][axis].get<double>(), 1e-9));
    again.settle();
    const Opened whole(test::raining);
    CHECK(differences(whole.picture, opened.picture, panel, 1000) > 2000);
    CHECK(differences(again.picture, opened.picture, panel, 1000) < 20);
}

TEST_CASE("a number typed into a slider ends where the slider does") {
    Opened opened(test::pouring, 1000, 900);
    opened.click("hold speed");
    type_into(opened, "speed", "1e20");
    CHECK(opened.studio->source().state().speed == 2);
    type_into(opened, "speed", "0.25");
    CHECK(opened.studio->source().state().speed == 0.25);
    opened.click("tab Look");
    opened.click("section");
    type_into(opened, "section y to", "1e999");
    type_into(opened, "section x from", "-1e999");
    opened.click("tab Change");
    const scene::Scene saved = saved_by(opened);
    REQUIRE(saved.render.clip);
    CHECK(saved.render.clip->hi.y() == about(0.12));
    CHECK(saved.render.clip->lo.x() == about(-0.02));
}

TEST_CASE("on a screen of more pixels a pixel the panel shows the tab that was open, with larger letters") {
    Opened opened(test::pouring);
    opened.click("tab Look");
    opened.settle();
    const render::Picture before = opened.picture;
    const auto height = [&] {
        const auto place = opened.state["places"]["color"].get<std::array<double, 4>>();
        return place[3] - place[1];
    };
    const double low = height();
    opened.resize(2000, 1000, 2);
    REQUIRE(opened.state["places"].contains("color"));
    CHECK(height() > 1.5 * low);
    opened.resize(1000, 500, 1);
    REQUIRE(opened.state["places"].contains("color"));
    CHECK(differences(before, opened.picture, 0, panel) == 0);
}

TEST_CASE("a simulation, which cannot go back, goes on when it is asked to") {
    Opened opened(test::pouring);
    press(opened, "Space");
    press(opened, "Comma");
    CHECK(opened.studio->source().state().playing);
}

} // namespace test_studio_saving
