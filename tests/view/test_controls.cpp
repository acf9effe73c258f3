#include "../about.h"
#include "../run/scenes.h"
#include "view/controls.h"

#include <doctest/doctest.h>

using namespace tumble;
using namespace tumble::view;
using test::about;

namespace test_controls {

SceneText text_of(const std::string& toml) {
    return {toml, "test.toml", {}};
}

std::size_t find(const Controls& controls, const std::string& key, const std::string& word = "") {
    for (std::size_t i = 0; i < controls.all().size(); ++i)
        if (controls.all()[i].key == key && (word.empty() || controls.all()[i].word == word))
            return i;
    FAIL("no control of " << key << " " << word);
    return 0;
}

TEST_CASE("sliders are what the scene writes of pairs and motions, in the keys' units, and where gravity points") {
    const SceneText text = text_of(test::pouring);
    const auto scene = text.load();
    REQUIRE(scene.ok());
    const Controls controls(*scene, text);
    CHECK(controls.all().size() == 7); // amplitude, frequency, phase; friction, restitution; two tilts
    const Control& amplitude = controls.all()[find(controls, "wall.floor.motion.0.amplitude_m")];
    CHECK(amplitude.value == 0.0005);
    CHECK(amplitude.unit == "m");
    CHECK(amplitude.lo == 0);
    CHECK(amplitude.hi == about(0.0015));
    CHECK(controls.all()[find(controls, "wall.floor.motion.0.phase_deg")].value == 0); // not written: its default
    CHECK(controls.all()[find(controls, "pair.glass-glass.restitution")].value == 0.6);
    CHECK(controls.changes().empty());
}

TEST_CASE("a moved slider becomes a change that the scene loads with, and goes back with the others") {
    const SceneText text = text_of(test::pouring);
    const auto scene = text.load();
    REQUIRE(scene.ok());
    Controls controls(*scene, text);
    controls.set(find(controls, "pair.glass-glass.friction"), 0.25);
    controls.set(find(controls, "wall.floor.motion.0.frequency_Hz"), 1e9); // as far as it goes
    controls.set(find(controls, "gravity_m_s2", "tilt towards x"), 30);
    const auto changed = text.load(controls.changes());
    REQUIRE_MESSAGE(changed.ok(), to_string(changed.problems()));
    CHECK(changed->pair(0, 0).friction == 0.25);
    CHECK(changed->walls[0].motion.harmonics[0].frequency == about(125));
    // Tilting keeps its size: 9.81 m/s2, a half of it towards x.
    CHECK(changed->gravity.x() == about(9.81 * 0.5, 1e-12));
    CHECK(changed->gravity.norm() == about(9.81, 1e-12));
    CHECK(changed->gravity.z() == 0);
    controls.reset();
    CHECK(controls.changes().empty());
}

TEST_CASE("a motion from a file or from rows has sliders for its factors, and harmonics for a phase") {
    const std::filesystem::path file = std::filesystem::path(TUMBLE_ROOT) / "scenes" / "trough-slice.toml";
    const auto text = SceneText::read(file, {});
    REQUIRE(text.ok());
    const auto scene = text->load();
    REQUIRE(scene.ok());
    Controls controls(*scene, *text);
    const std::string motion = "wall." + scene->walls[0].name + ".motion.0.";
    controls.set(find(controls, motion + "amplitude_factor"), 0.25);
    controls.set(find(controls, motion + "frequency_factor"), 1.5);
    controls.set(find(controls, motion + "phase_deg"), 45);
    const auto changed = text->load(controls.changes());
    REQUIRE_MESSAGE(changed.ok(), to_string(changed.problems()));
    CHECK(changed->walls[0].motion.harmonics[9].amplitude == 0.25 * 1.949234e-3);
    CHECK(changed->walls[0].motion.harmonics[9].frequency == about(37.5, 1e-12));
    // Rows that are written out have no phase.
    std::string rows = test::pouring;
    const auto begin = rows.find("kind = \"harmonic\"");
    REQUIRE(begin != std::string::npos);
    const auto end = rows.find("[", begin);
    rows = rows.substr(0, begin) + "kind = \"table\"\nrows = [[0, 0, 0, 0], [0.1, 0, 0.001, 0]]\n" + rows.substr(end);
    const SceneText table = text_of(rows);
    const auto loaded = table.load();
    REQUIRE_MESSAGE(loaded.ok(), to_string(loaded.problems()));
    const Controls of_table(*loaded, table);
    find(of_table, "wall.floor.motion.0.amplitude_factor");
    for (const Control& control : of_table.all())
        CHECK(control.word != "phase");
}

TEST_CASE("both tilts together, and none along z in two dimensions") {
    const SceneText text = text_of(test::pouring);
    Controls controls(*text.load(), text);
    controls.set(find(controls, "gravity_m_s2", "tilt towards x"), -20);
    controls.set(find(controls, "gravity_m_s2", "tilt towards z"), 45);
    const auto changed = text.load(controls.changes());
    REQUIRE(changed.ok());
    CHECK(changed->gravity.z() == about(9.81 * std::sin(45 * std::numbers::pi / 180), 1e-12));
    CHECK(std::atan2(changed->gravity.x(), -changed->gravity.y()) == about(-20 * std::numbers::pi / 180, 1e-12));
    CHECK(changed->gravity.norm() == about(9.81, 1e-12));
    const SceneText flat = text_of(test::raining);
    Controls in_plane(*flat.load(), flat);
    for (const Control& control : in_plane.all())
        CHECK(control.kind != Control::Kind::tilt_about_x);
    in_plane.set(find(in_plane, "gravity_m_s2"), 10);
    const auto tilted = flat.load(in_plane.changes());
    REQUIRE_MESSAGE(tilted.ok(), to_string(tilted.problems()));
    CHECK(tilted->gravity.norm() == about(9.81, 1e-12));
}

} // namespace test_controls
