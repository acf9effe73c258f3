#include "../observe/frames.h"
#include "about.h"
#include "folder.h"
#include "observe/frame_file.h"
#include "reduce/yardstick.h"
#include "small_trough.h"

#include <cmath>
#include <doctest/doctest.h>

namespace test_yardstick {

using namespace tumble;
using namespace tumble::reduce;
using tumble::test::about;

namespace {

scene::Scene loaded(const std::string& name) {
    return *SceneText{TUMBLE_ROOT "/scenes/" + name, {}}.load();
}

std::vector<std::string> names_of(const Yardstick& stick) {
    std::vector<std::string> names;
    for (const Quantity& quantity : stick.quantities())
        names.push_back(quantity.name);
    return names;
}

} // namespace

TEST_CASE("a vibrating trough is measured over whole pairs of periods of the second half of its shaking") {
    const auto stick = Yardstick::of(loaded("trough-quick.toml"), {"mean_speed"}, std::nullopt, std::nullopt);
    REQUIRE_MESSAGE(stick, to_string(stick.problems()));
    CHECK(stick->until() == 2.6);
    CHECK(stick->from() == about(2.6 - 12 * 0.08, 1e-12)); // 1 s holds twelve pairs of periods of 25 Hz
    CHECK(names_of(*stick) ==
          std::vector<std::string>{"kinetic energy per mass", "circulation", "surface slope", "mean speed"});
}

TEST_CASE("a bowl is measured by layers over its wall and by its sensor") {
    const auto stick = Yardstick::of(loaded("bowl-quick.toml"), {}, std::nullopt, std::nullopt);
    REQUIRE_MESSAGE(stick, to_string(stick.problems()));
    CHECK(stick->from() == about(1.2, 1e-12)); // it turns from 0.4 to 2 s
    CHECK(names_of(*stick) == std::vector<std::string>{"kinetic energy per mass", "rms velocity y", "speed 0 to 42 mm",
                                                       "speed 42 to 84 mm", "speed 84 to 126 mm", "speed 126 to 168 mm",
                                                       "speed 168 to 210 mm", "vortex depth", "fall at the axis",
                                                       "sensor cycle", "sensor peak to peak"});
}

TEST_CASE("the mean over a stretch takes each phase of a period once, and what is no number not at all") {
    scene::Scene scene = *test::small_trough().load(); // rows every 0.01 s, shaken at 25 Hz from 0.2 to 0.6 s
    const auto stick = Yardstick::of(scene, {}, std::nullopt, std::nullopt);
    REQUIRE_MESSAGE(stick, to_string(stick.problems()));
    CHECK(stick->from() == about(0.44, 1e-12)); // two pairs of periods
    stick->prepare(scene);
    CHECK(scene.observe.measures == std::vector<std::string>{"kinetic_energy", "circulation", "surface_slope"});
    const test::Folder folder;
    std::string rows = "time_s,kinetic_energy_J,circulation_rad_s,surface_slope_deg\n";
    for (int row = 0; row <= 60; ++row) {
        const double time = 0.01 * row + 1e-6; // a step late
        rows += std::to_string(time) + "," + (row > 44 ? "6" : "1000") + "," +
                std::to_string(0.5 + std::sin(2 * M_PI * 25 * time)) + "," + (row % 5 == 0 ? "nan" : "8") + "\n";
    }
    test::put(folder.path / "series.csv", rows);
    const auto values = stick->read(folder.path, 2.0);
    REQUIRE_MESSAGE(values, to_string(values.problems()));
    CHECK((*values)[0] == about(3, 1e-12));  // 6 J of 2 kg
    CHECK((*values)[1] == about(0.5, 1e-5)); // the sine is gone, to the digits written
    CHECK((*values)[2] == 8);
}

TEST_CASE("a bowl's layers, vortex and sensor are read as they were put in") {
    const auto stick = Yardstick::of(loaded("bowl-quick.toml"), {}, std::nullopt, std::nullopt); // from 1.2 to 2 s
    REQUIRE_MESSAGE(stick, to_string(stick.problems()));
    const test::Folder folder;
    std::string rows = "time_s,kinetic_energy_J,rms_velocity_y_m_s,tracer:sensor_y_m\n";
    for (int row = 0; row <= 600; ++row) { // a second longer than the scene: what comes then is another motion
        const double time = 0.005 * row + 1e-6;
        const bool counts = time > 1.2 && time<2.003, path_counts = time> 0.8 && time < 2.003;
        rows +=
            std::to_string(time) + (counts ? ",14,0.25," : ",900,900,") +
            std::to_string(0.08 + (path_counts ? 0.03 : 0.9) * std::cos(2 * M_PI * time / (path_counts ? 0.4 : 0.1))) +
            "\n";
    }
    test::put(folder.path / "series.csv", rows);
    test::put(folder.path / "scene.toml", "");
    // Columns of bodies: at the axis 40 mm high and falling at 0.3 m/s, elsewhere 90 mm high and rising at 0.1 m/s, all
    // of them going round at 1 m/s below 42 mm and at 0.5 m/s above. What stands before 1.2 s is another flow.
    std::filesystem::create_directories(folder.path / "frames");
    const auto layout = test::open_layout(test::ball(0.001, 2e-3));
    REQUIRE(observe::write_layout(observe::layout_path(folder.path / "frames"), *layout));
    for (int number = 0; number < 3; ++number) {
        observe::Frame frame;
        frame.layout = layout;
        frame.time = 0.8 + 0.6 * number;
        for (int ring = 0; ring < 5; ++ring)
            for (double y = 0.1e-3; y < (ring == 0 ? 0.04 : 0.09); y += 0.2e-3)
                test::add_body(frame, {0.0333 * (ring + 0.5), y, 0},
                               number == 0 ? Eigen::Vector3d(9, 9, 9)
                                           : Eigen::Vector3d(0, ring == 0 ? -0.3 : 0.1, y < 0.042 ? -1 : -0.5));
        REQUIRE(observe::write_frame(observe::frame_path(folder.path / "frames", number), frame));
    }
    const auto values = stick->read(folder.path, 7.0);
    REQUIRE_MESSAGE(values, to_string(values.problems()));
    const auto value = [&](const std::string& name) {
        const auto names = names_of(*stick);
        return (*values)[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
    };
    CHECK(value("kinetic energy per mass") == about(2, 1e-12)); // 14 J of 7 kg
    CHECK(value("rms velocity y") == about(0.25, 1e-12));
    // 200 bodies of the innermost ring and 4 x 210 of the others.
    CHECK(value("speed 0 to 42 mm") == about((200 * std::hypot(1, 0.3) + 840 * std::hypot(1, 0.1)) / 1040, 1e-9));
    CHECK(value("speed 42 to 84 mm") == about(std::hypot(0.5, 0.1), 1e-9));
    CHECK(std::isnan(value("speed 126 to 168 mm")));
    CHECK(value("vortex depth") == about(0.05, 0.01)); // to a thousandth of the wall's 210 mm
    CHECK(value("fall at the axis") == about(0.3, 1e-9));
    CHECK(value("sensor cycle") == about(0.4, 0.02)); // to a row
    CHECK(value("sensor peak to peak") == about(0.06, 1e-3));
}

TEST_CASE("a stretch without rows and a measure that does not exist are refused") {
    const scene::Scene scene = *test::small_trough().load();
    CHECK(to_string(Yardstick::of(scene, {}, 0.595, std::nullopt).problems()) ==
          "from 0.595 to 0.6 s there are fewer than two rows of series.csv\n"
          "    give a longer --time, a longer duration_s or a smaller observe.every_s\n");
    CHECK_FALSE(Yardstick::of(scene, {"mean_sped"}, std::nullopt, std::nullopt));
}

} // namespace test_yardstick
