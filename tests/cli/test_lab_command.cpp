#include "about.h"
#include "process.h"

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace test_lab_command {

using namespace tumble::test;

TEST_CASE("without a name experiments are listed, with one it is performed, on stdout") {
    const Folder folder;
    const Outcome list = tumble_in(folder, {"lab"});
    CHECK(list.code == 0);
    CHECK(contains(list.out, "spin-down"));
    CHECK(nlohmann::json::parse(tumble_in(folder, {"lab", "--json"}).out)[0]["name"] == "drop");
    const Outcome weighed = tumble_in(folder, {"lab", "weigh", "--json", "--mass_g", "9.4"});
    CHECK(weighed.code == 0);
    const auto json = nlohmann::json::parse(weighed.out);
    CHECK(json["experiment"] == "weigh");
    CHECK(json["parameters"]["mass_g"] == 9.4);
    CHECK(json["facts"]["density_cone"]["value"].get<double>() == about(2 * 1870.1, 1e-4));
}

TEST_CASE("records are written as CSV that another command takes") {
    const Folder folder;
    const Outcome made = tumble_in(folder, {"lab", "sensor", "--duration_s", "1.5", "--out", "made"});
    CHECK_MESSAGE(made.code == 0, made.err);
    CHECK(content_of(folder.path / "made" / "sensor-1.csv").starts_with("t_s,ax_m_s2,ay_m_s2,az_m_s2\n"));
    const Outcome found = tumble_in(folder, {"excitation", "made/sensor-1.csv", "--second", "made/sensor-2.csv",
                                             "--at_mm", "0,700,-300", "--second_at_mm", "0,700,300", "--json"});
    CHECK_MESSAGE(found.code == 0, found.err);
    const auto facts = nlohmann::json::parse(found.out)["facts"];
    // What the sensor experiment puts in without flags: 1478.2 rpm and 0.5 mrad.
    CHECK(facts["fundamental"]["value"].get<double>() == about(1478.2 / 60, 1e-5));
    CHECK(facts["rocking_angle"]["value"].get<double>() == about(0.5, 0.02));
}

TEST_CASE("figures have the size for print that is asked for, and then no title" *
          doctest::skip(std::system("gnuplot --version >/dev/null 2>&1") != 0)) {
    const Folder folder;
    REQUIRE(tumble_in(folder, {"lab", "sensor", "--duration_s", "1.5", "--out", "usual"}).code == 0);
    for (const auto& words : {std::vector<std::string>{"lab", "sensor", "--duration_s", "1.5"},
                              std::vector<std::string>{"excitation", "usual/sensor-1.csv"}}) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--size-mm", "85x60", "--dpi", "200", "--out", "made"});
        const Outcome made = tumble_in(folder, all);
        REQUIRE_MESSAGE(made.code == 0, made.err);
        int figures = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path / "made"))
            if (entry.path().extension() == ".svg") {
                const std::string svg = content_of(entry.path());
                CHECK_MESSAGE(contains(svg, "width=\"321\""), svg.substr(0, 400)); // 85 mm at 96 an inch
                ++figures;
            }
        CHECK(figures > 0);
        std::filesystem::remove_all(folder.path / "made");
    }
    const Outcome refused = tumble_in(folder, {"lab", "sensor", "--size-mm", "85", "--out", "made"});
    CHECK(refused.code == 2);
    CHECK(contains(refused.err, "write width x height"));
}

TEST_CASE("a record of a testing machine is evaluated, and a wrong name, flag or value gets exit code 2") {
    const Folder folder;
    put(folder.path / "t.csv", "force_N,strain,strain_across\n0,0,0\n100,0.001,-0.0003\n200,0.002,-0.0006\n");
    const Outcome outcome = tumble_in(folder, {"lab", "tension", "--record", "t.csv", "--json"});
    CHECK_MESSAGE(outcome.code == 0, outcome.err);
    CHECK(nlohmann::json::parse(outcome.out)["facts"]["poisson_ratio"]["value"].get<double>() == about(0.3));
    put(folder.path / "w.csv", "weight_N,strain\n0,0\n");
    const Outcome wrong = tumble_in(folder, {"lab", "tension", "--record", "w.csv"});
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.err, "w.csv:1: no column for force"));
    const Outcome name = tumble_in(folder, {"lab", "dropp"});
    CHECK(name.code == 2);
    CHECK(contains(name.err, "did you mean 'drop'?"));
    const Outcome value = tumble_in(folder, {"lab", "drop", "--restitution", "2"});
    CHECK(value.code == 2);
    CHECK(contains(value.err, "--restitution is 2, out of its range"));
}

} // namespace test_lab_command
