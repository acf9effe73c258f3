#include "process.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace test_excitation_command {

using namespace tumble::test;

namespace {

/// Two seconds of an open orbit at 24.6 Hz, 1 mm up and 0.5 mm across, y a quarter period before z.
std::string record() {
    std::string text = "t_s,ay_m_s2,az_m_s2\n";
    const double rate = 2 * 3.14159265358979 * 24.6;
    for (int k = 0; k < 1600; ++k) {
        const double t = k / 800.0;
        text += std::to_string(t) + "," + std::to_string(-1e-3 * rate * rate * std::cos(rate * t)) + "," +
                std::to_string(-5e-4 * rate * rate * std::sin(rate * t)) + "\n";
    }
    return text;
}

} // namespace

TEST_CASE("a record becomes lines, an orbit and a motion that a scene takes") {
    const Folder folder;
    put(folder.path / "a.csv", record());
    const Outcome text = tumble_in(folder, {"excitation", "a.csv", "--out", "found"});
    CHECK_MESSAGE(text.code == 0, text.err);
    CHECK(contains(text.out, "The fundamental is 24.6 Hz"));
    CHECK(contains(text.out, "[[wall.motion]]"));
    CHECK(std::filesystem::exists(folder.path / "found" / "orbit-zy.png"));
    const std::string ball = bouncing_ball(0.001);
    const auto wall = ball.find("[observe]");
    put(folder.path / "moving.toml",
        ball.substr(0, wall) + content_of(folder.path / "found" / "motion.toml") + ball.substr(wall));
    const Outcome check = tumble_in(folder, {"check", "moving.toml"});
    CHECK_MESSAGE(check.code == 0, check.err);
    const Outcome json = tumble_in(folder, {"excitation", "a.csv", "--json"});
    const auto facts = nlohmann::json::parse(json.out)["facts"];
    CHECK(std::abs(facts["fundamental"]["value"].get<double>() - 24.6) < 1e-4);
    CHECK(std::abs(facts["orbit_phase_zy"]["value"].get<double>() - 90) < 0.01);
}

TEST_CASE("a list of printed lines is asked which fundamental its bins allow") {
    const Folder folder;
    const std::filesystem::path list = std::filesystem::path(TUMBLE_ROOT) / "scenes/excitation/trough-vm375y.csv";
    const Outcome outcome = tumble_in(folder, {"excitation", list.string()});
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.out, "from 24.609 to 24.665 Hz"));
    CHECK(contains(outcome.out, "mains, 2 x 50 Hz"));
}

TEST_CASE("data that are wrong get exit code 2 and the place") {
    const Folder folder;
    put(folder.path / "a.csv", "t_s,ay_g\n0,1\n1,x\n");
    const Outcome broken = tumble_in(folder, {"excitation", "a.csv"});
    CHECK(broken.code == 2);
    CHECK(contains(broken.err, "a.csv:3:3: 'x' is not a number"));
    CHECK(tumble_in(folder, {"excitation", "none.csv"}).code == 2);
    CHECK(tumble_in(folder, {"excitation", "a.csv", "--at_mm", "1,2,3"}).code == 2);
}

} // namespace test_excitation_command
