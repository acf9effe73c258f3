#include "observe/frame_file.h"
#include "opened.h"
#include "view/viewer.h"

#include <atomic>

using namespace tumble;
using namespace tumble::view;
using namespace tumble::view::testing;

namespace test_studio {

TEST_CASE(
    "the picture is panel and scene side by side; a drag in the scene turns the camera and leaves the panel as it is") {
    Opened opened(test::pouring);
    CHECK(opened.picture.width == 1000);
    CHECK(opened.picture.height == 500);
    CHECK(!opened.studio->is_stale());
    const render::Picture before = opened.picture;
    const nlohmann::json eye = opened.state["camera"]["eye"];
    opened.drag(600, 250, 660, 230);
    CHECK(opened.state["camera"]["eye"] != eye);
    CHECK(differences(before, opened.picture, 0, panel) == 0);
    opened.settle();
    const std::size_t turned = differences(before, opened.picture, panel, 1000);
    CHECK(turned > 2000);
    // Back by the same way: the same picture, up to the roundings of the way.
    opened.drag(660, 230, 600, 250);
    opened.settle();
    const std::size_t back = differences(before, opened.picture, panel, 1000);
    CHECK(back < turned / 20);
    // A press in the panel moves no camera, even when it goes on over the scene.
    const nlohmann::json now = opened.state["camera"];
    opened.drag(150, 480, 700, 300);
    CHECK(opened.state["camera"] == now);
}

TEST_CASE("wheel, right button, two fingers and keys move the camera; R brings the scene's own back") {
    Opened opened(test::pouring);
    const nlohmann::json first = opened.state["camera"];
    nlohmann::json last = first;
    const auto moved = [&] {
        opened.draw();
        const bool is_new = opened.state["camera"] != last;
        last = opened.state["camera"];
        return is_new;
    };
    opened.studio->take(WheelTurned{700, 200, 2});
    CHECK(moved());
    opened.drag(600, 250, 620, 250, 2);
    CHECK(moved());
    opened.studio->take(Pinched{600, 250, 5, 5, 1.1});
    CHECK(moved());
    for (const char* key : {"ArrowLeft", "ArrowUp", "Equal", "Minus"}) {
        opened.studio->take(KeyChanged{key, true, false, false});
        opened.studio->take(KeyChanged{key, false, false, false});
        CHECK_MESSAGE(moved(), key);
    }
    opened.studio->take(KeyChanged{"KeyR", true, false, false});
    CHECK(moved());
    CHECK(last == first);
}

TEST_CASE("a click on play runs the scene to its end, even when press and release come within one frame") {
    Opened opened(test::pouring);
    CHECK(opened.state["time"] == 0);
    opened.click("steps");
    CHECK(opened.eventually([&] { return opened.state["step"] == 100; }));
    opened.click("play");
    CHECK(opened.eventually([&] { return opened.state["ended"] == true; }));
    CHECK(opened.eventually([&] { return opened.state["step"] == 2000; }));
    CHECK(opened.state["playing"] == false);
}

TEST_CASE("a slider that is dragged changes the scene, and the changed scene is saved as one that loads to it") {
    Opened opened(test::pouring);
    opened.click("tab Change");
    const std::string key = "pair.glass-glass.friction";
    const auto [x, y] = opened.middle_of(key);
    opened.drag(x, y, x + 160, y); // beyond its right end, in one go
    const double value = opened.state["values"][key];
    CHECK(value == 1.5);
    opened.click("save scene");
    const std::filesystem::path saved = opened.folder.path / "shaken-001.toml";
    CHECK(opened.state["saved"] == saved.string());
    const auto beside = opened.state["places"]["saved"].get<std::array<double, 4>>(); // in the tab of the button
    CHECK(beside[1] > opened.state["places"]["save scene"][3].get<double>() - 1);
    CHECK(beside[3] <= 500);
    const auto scene = scene::load_scene(saved);
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    CHECK(scene->pair(0, 0).friction == value);
    CHECK(scene->pair(0, 0).restitution == 0.6);
    CHECK(scene->claim == "none yet: shaken.toml with pair.glass-glass.friction = 1.5");
    opened.click("as in the scene");
    CHECK(opened.state["values"][key] == 0.4);
}

/// Two hands, or one with two buttons: whatever else is pressed, the panel hears of each release of what it saw
/// pressed.
TEST_CASE("a slider is let go with its button, wherever that is and whatever was pressed meanwhile") {
    Opened opened(test::pouring);
    opened.click("tab Change");
    const std::string key = "pair.glass-glass.friction";
    const auto [x, y] = opened.middle_of(key);
    const auto at = [&](double from_middle) {
        opened.studio->take(PointerMoved{x + from_middle, y});
        opened.draw();
        return opened.state["values"][key].get<double>();
    };
    const auto press = [&](int button, double to) { opened.studio->take(PointerPressed{button, to, y}); };
    const auto release = [&](int button, double to) { opened.studio->take(PointerReleased{button, to, y}); };
    at(0);
    press(0, x);
    const double held = at(20);
    CHECK(at(40) > held);
    press(2, 700);
    release(2, 700);
    release(0, 700);
    const double left = at(0);
    CHECK(at(60) == left);
    const nlohmann::json camera = opened.state["camera"]; // nor is it held
    opened.studio->take(PointerMoved{800, 300});
    opened.draw();
    CHECK(opened.state["camera"] == camera);
    // A release that was lost on its way: the next press of the button makes good for it.
    press(0, x);
    const double again = at(30);
    press(0, 700);
    opened.studio->take(PointerMoved{760, 300});
    release(0, 760);
    CHECK(at(-60) == again);
    CHECK(opened.state["camera"] != camera);
}

TEST_CASE("a scene that cannot be saved says why, where it would have said its name") {
    Opened opened(test::pouring);
    const std::filesystem::path folder = opened.folder.path;
    std::filesystem::remove_all(folder);
    test::put(folder, "a file where the folder was");
    opened.click("tab Change");
    opened.click("save scene");
    const std::string told = opened.state["saved"];
    CHECK(told.find((folder / "shaken-001.toml").string()) != std::string::npos);
    CHECK(told.find("Not a directory") != std::string::npos);
    CHECK(opened.state["places"].contains("saved"));
}

/// All bodies move at 3 m/s: the next of 1, 2, 2.5, 5 above it is 5. At 30 m/s it is 50, once a hand asks again.
TEST_CASE("the range of the colours is fitted to what moves now, and then stays") {
    Opened opened(test::pouring, 1000, 700, true);
    opened.stage->vx = 3;
    opened.draw();
    opened.click("tab Look");
    CHECK(!opened.state["places"].contains("range"));
    opened.click("fit range");
    REQUIRE(opened.state["places"].contains("range"));
    opened.click("tab Keep");
    opened.click("film"); // its range is the one that holds now
    const auto range = [&] { return opened.stage->films.back().range.value(); };
    CHECK(range() == std::array{0.0, 5.0});
    opened.stage->vx = 30;
    opened.draw();
    CHECK(range() == std::array{0.0, 5.0});
    opened.click("tab Look");
    opened.click("fit range");
    CHECK(range() == std::array{0.0, 50.0});
}

TEST_CASE("colours, their range and a section are chosen in the panel and change the picture") {
    Opened opened(test::pouring);
    opened.click("tab Look");
    CHECK(!opened.state["places"].contains("range"));
    opened.click("fixed range");
    CHECK(opened.state["places"].contains("range"));
    const auto changes = [&](const std::string& name) {
        opened.settle();
        const render::Picture before = opened.picture;
        opened.click(name);
        opened.settle();
        return differences(before, opened.picture, panel, 1000);
    };
    opened.click("color");
    CHECK(changes("color vy") > 1000); // they fall at 1 m/s: dark blue where zero is grey
    CHECK(changes("section") == 0);    // from end to end of the domain
    const auto [x, y] = opened.middle_of("section y to");
    const render::Picture whole = opened.picture;
    opened.drag(x, y, x - 200, y);
    opened.settle();
    CHECK(differences(whole, opened.picture, panel, 1000) > 1000); // no body is left
}

TEST_CASE("what colours the bodies, its range and the planes of a section say under the pointer which key they set") {
    Opened opened(test::pouring, 1000, 900);
    opened.click("tab Look");
    opened.click("fixed range");
    opened.click("section");
    for (const auto& [name, key] :
         {std::pair{"color", "render.color"}, std::pair{"colormap", "render.colormap"},
          std::pair{"fixed range", "render.range"}, std::pair{"range", "render.range"},
          std::pair{"section", "render.clip_lo_m, render.clip_hi_m"}, std::pair{"section x from", "render.clip_lo_m"},
          std::pair{"section z to", "render.clip_hi_m"}}) {
        const auto [x, y] = opened.middle_of(name);
        opened.studio->take(PointerMoved{x, y});
        opened.draw();
        CHECK_MESSAGE(opened.state["told_key"] == key, name);
    }
}

TEST_CASE("velocities, a way and force chains are switched on over the bodies, and saved with the scene as its keys") {
    Opened opened(test::pouring, 1000, 700);
    for (int i = 0; i < 15; ++i) {
        opened.click("steps");
        REQUIRE(opened.eventually([&] { return opened.state["step"] == 100 * (i + 1); }));
    }
    opened.click("tab Look");
    const auto changes = [&](const std::string& name) {
        opened.settle();
        const render::Picture before = opened.picture;
        opened.click(name);
        opened.settle();
        return differences(before, opened.picture, panel, 1000);
    };
    opened.click("arrows");
    // Dear ImGui knows the size of a list that opens in its second frame only: it has settled in the one that is seen.
    REQUIRE(opened.state["places"].contains("arrows field"));
    CHECK(opened.state["places"]["arrows field"][2].get<double>() <= panel);
    CHECK(changes("arrows bodies") > 500);
    opened.click("trail");
    CHECK(changes("trail ball") > 20);
    CHECK(changes("force chains") > 50);
    opened.click("tab Change");
    opened.click("save scene");
    const auto scene = scene::load_scene(opened.folder.path / "shaken-001.toml");
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    CHECK(scene->render.marks.arrows == "bodies");
    CHECK(scene->render.marks.trails == std::vector<std::string>{"ball"});
    CHECK(scene->render.marks.chains);
    CHECK(scene->observe.contacts);
    CHECK(scene->claim == "none"); // what only changes the picture leaves it as it was
}

TEST_CASE("the map of the colours and the scales of arrows and chains are chosen in the panel, and saved") {
    Opened opened(test::pouring, 1000, 900);
    opened.click("tab Look");
    opened.click("colormap");
    REQUIRE(opened.state["places"].contains("colormap inferno"));
    opened.settle();
    const render::Picture before = opened.picture;
    opened.click("colormap inferno");
    opened.settle();
    CHECK(differences(before, opened.picture, panel, 1000) > 100);
    CHECK(!opened.state["places"].contains("render.arrow_m_s"));
    opened.click("arrows");
    opened.click("arrows bodies");
    opened.settle();
    CHECK(!opened.state["places"].contains("render.arrow_m_s value"));
    opened.click("render.arrow_m_s"); // the fastest fall at hypot(0.3, 1) m/s, rounded up
    CHECK(opened.state["places"].contains("render.arrow_m_s value"));
    opened.click("force chains");
    opened.settle();
    opened.click("render.chain_N"); // nothing presses yet: 1
    opened.click("tab Change");
    opened.click("save scene");
    const auto scene = scene::load_scene(opened.folder.path / "shaken-001.toml");
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    CHECK(scene->render.colormap == "inferno");
    CHECK(scene->render.marks.arrow_speed == 2);
    CHECK(scene->render.marks.chain_force == 1);
}

TEST_CASE("what cannot change while it is watched is saved with the camera and the look that hands gave it") {
    Opened opened(test::pouring, 1000, 700, true);
    opened.drag(600, 250, 660, 230);
    opened.click("tab Look");
    opened.click("color");
    opened.click("color vx");
    opened.click("tab Change");
    CHECK(!opened.state["places"].contains("as in the scene"));
    opened.click("save scene");
    const auto scene = scene::load_scene(opened.folder.path / "shaken-001.toml");
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    CHECK(scene->render.camera == "free");
    CHECK(scene->render.color == "vx");
    CHECK(scene->claim == "none");
}

TEST_CASE("a window that is hidden or tiny keeps the view alive, a larger one gets a larger picture") {
    Opened opened(test::pouring);
    opened.studio->take(Resized{0, 0, 1});
    opened.draw();
    CHECK(opened.picture.width == 1000);
    opened.studio->take(Resized{1, 1, 1});
    opened.draw();
    CHECK(opened.picture.width == 320);
    CHECK(opened.picture.height == 200);
    opened.studio->take(Resized{1400, 900, 1.25});
    opened.draw();
    CHECK(opened.picture.width == 1400);
    CHECK(opened.picture.height == 900);
    opened.studio->take(PanelToggled{});
    opened.draw();
    CHECK(opened.picture.width == 1400);
}

/// Letters of 20 points at 300 dpi, in a window that may be as small as 320 x 200 pixels.
TEST_CASE("a scene in the style of print is shown white in a window of any size, and saved for print as it was") {
    const std::vector<scene::Override> print{{"render.style=\"paper\""},   {"render.width_mm=150"},
                                             {"render.height_mm=150"},     {"render.font_pt=20"},
                                             {"render.arrows=\"bodies\""}, {"render.plot=true"}};
    const std::string toml = test::pouring.substr(0, test::pouring.find("width_px")); // print has its size in mm
    Opened opened(toml, 1000, 500, false, print);
    for (const auto& [width, height] : {std::pair{320, 200}, {1, 1}, {320, 2560}, {2560, 200}, {360, 640}, {1400, 900}})
        for (const double ratio : {0.5, 1.0, 3.0}) {
            CAPTURE(width);
            CAPTURE(ratio);
            opened.resize(width, height, ratio);
            CHECK(opened.picture.width == std::max(width, 320));
            CHECK(opened.picture.height == std::max(height, 200));
        }
    opened.resize(1000, 700);
    const auto corner = static_cast<std::size_t>(4 * (1000 - 1));
    CHECK(opened.picture.rgba[corner] > 240);
    opened.click("tab Change");
    opened.click("save scene");
    const auto saved = scene::load_scene(opened.folder.path / "shaken-001.toml");
    REQUIRE_MESSAGE(saved.ok(), to_string(saved.problems()));
    REQUIRE(saved->render.paper);
    CHECK(saved->render.paper->width_mm == 150);
    CHECK(saved->render.paper->font_pt == 20);
    CHECK(saved->render.plot);
}

TEST_CASE("a click that comes with another size of the window meets what was seen, not what stands there afterwards") {
    Opened opened(test::pouring);
    const auto [x, y] = opened.middle_of("steps");
    opened.studio->take(PointerMoved{x, y});
    opened.studio->take(PointerPressed{0, x, y});
    opened.studio->take(PointerReleased{0, x, y});
    opened.studio->take(Resized{2000, 1000, 2}); // on a screen of two pixels a pixel all stands elsewhere
    CHECK(opened.eventually([&] { return opened.state["step"] == 100; }));
    CHECK(opened.picture.width == 2000);
    CHECK(opened.middle_of("steps")[0] > 1.5 * x);
}

TEST_CASE("in a window as narrow as a phone the scene comes first, and the panel takes all of it when asked for") {
    Opened opened(test::pouring);
    CHECK(opened.state["panel"] == true);
    const double wide = opened.state["places"]["play"][2].get<double>();
    opened.studio->take(Resized{780, 1688, 2}); // 390 x 844 on a screen of two pixels a pixel
    opened.draw();
    CHECK(opened.picture.width == 780);
    CHECK(opened.picture.height == 1688);
    CHECK(opened.state["panel"] == false);
    const render::Picture scene = opened.picture;
    opened.drag(300, 800, 380, 800); // where a panel of 300 would be: it turns the camera
    opened.settle();
    CHECK(differences(scene, opened.picture, 0, 780) > 500);
    opened.studio->take(PanelToggled{});
    opened.draw();
    CHECK(opened.picture.width == 780);
    CHECK(opened.state["places"]["play"][2].get<double>() > 1.5 * wide); // letters and buttons of twice the pixels
    opened.click("steps");
    CHECK(opened.eventually([&] { return opened.state["step"] == 100; }));
    // Who asked for it keeps it, whatever the window does.
    opened.studio->take(Resized{800, 1688, 2});
    opened.draw();
    CHECK(opened.state["panel"] == true);
}

TEST_CASE("what is said of the pace while a simulation plays moves nothing below it") {
    Opened opened(test::pouring, 1000, 500, true);
    const auto tabs = opened.state["places"]["tab Plots"];
    opened.stage->plays = true;
    opened.stage->steps_per_s = 2000;
    opened.draw();
    CHECK(opened.state["places"]["tab Plots"] == tabs);
}

/// A fall, of which the kinetic energy is a parabola: without points between its ends a straight line.
TEST_CASE("plots of a simulation go on where nobody looks at it") {
    Opened kept(test::pouring), left(test::pouring);
    for (Opened* each : {&kept, &left}) {
        Source& source = each->studio->source();
        for (std::int64_t step = 100; step <= 1000; step += 100) {
            source.step(100);
            while (source.newest()->frame.step < step)
                std::this_thread::yield();
            if (each == &kept)
                each->studio->keep_points();
        }
        each->draw();
        each->settle();
    }
    CHECK(differences(kept.picture, left.picture, panel, 1000) == 0);
    CHECK(differences(kept.picture, left.picture, 0, panel) > 50);
}

TEST_CASE("a viewer keeps points of a simulation that plays before nobody, and of one that stands still none") {
    for (const bool plays : {true, false}) {
        Opened opened(test::pouring, 1000, 500, true);
        Staged& stage = *opened.stage; // lives as long as the viewer
        stage.plays = plays;
        auto viewer = Viewer::open(std::move(opened.studio), std::make_shared<Bell>(), {}, [](const std::string&) {});
        REQUIRE_MESSAGE(viewer.ok(), to_string(viewer.problems()));
        const int before = stage.looks;
        std::atomic<bool> stop{false};
        std::jthread thread([&] { (void)(*viewer)->run(&stop); });
        for (int i = 0; plays && i < 6000 && stage.looks < before + 3; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        if (!plays)
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
        stop = true;
        thread.join();
        CHECK((stage.looks >= before + 3) == plays);
    }
}

TEST_CASE("what is missing of a run is said in the panel") {
    const Recorded recorded;
    Opened whole(recorded);
    whole.draw();
    CHECK(!whole.state["places"].contains("warnings"));
    const auto frames = observe::list_frames(recorded.run / "frames");
    REQUIRE(frames.size() == 5);
    std::filesystem::remove(frames[2]);
    Opened damaged(recorded);
    damaged.draw();
    CHECK(damaged.state["places"].contains("warnings"));
}

} // namespace test_studio
