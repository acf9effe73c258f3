#include "process.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace test_diagnose_command {

using namespace tumble::test;

namespace {

const std::string scene = std::string(TUMBLE_ROOT) + "/scenes/bounce.toml";
const std::string data = std::string(TUMBLE_ROOT) + "/scenes/measured/bounce/measurement.toml";

} // namespace

TEST_CASE("the measured bounce is diagnosed through files alone: a scale that reads a quarter of a per cent too much") {
    const Folder folder;
    const Outcome told =
        tumble_in(folder, {"diagnose", scene, "--data", data, "--json", "--quiet", "--report", "report"});
    REQUIRE(told.code == 0);
    const auto found = nlohmann::json::parse(told.out);
    CHECK(found["outcome"] == "NAMED");
    CHECK(found["causes"] == nlohmann::json{"ins.gain"});
    // Hidden by the generator of blind cases: 0.00255, 12 standard errors away from any other cause.
    const double amplitude = found["fitted"][0]["amplitude"], error = found["fitted"][0]["standard_error"];
    CHECK(std::abs(amplitude - 0.00255) < 4 * error);
    CHECK(error < 0.00255 / 8);
    CHECK(found["gain"]["shown"] == true);
    const std::string page = content_of(folder.path / "report/diagnosis.html");
    CHECK(contains(page, "ins.gain"));
    CHECK(contains(page, "</html>"));
    CHECK(!contains(page, "src=")); // nothing is fetched from elsewhere
    CHECK(!contains(page, "nan"));
    CHECK(contains(content_of(folder.path / "report/residuals.csv"), "record,column,time_s"));
}

TEST_CASE("the page that walks one case through has the figures that its command gives") {
    const Folder folder;
    const std::string page = content_of(std::string(TUMBLE_ROOT) + "/docs/diagnosis-case.md");
    const Outcome told = tumble_in(folder, {"diagnose", std::string(TUMBLE_ROOT) + "/scenes/lane.toml", "--data",
                                            std::string(TUMBLE_ROOT) + "/scenes/measured/cases/1/measurement.toml",
                                            "--json", "--quiet"});
    REQUIRE(told.code == 0);
    const auto found = nlohmann::json::parse(told.out);
    const auto says = [&](const std::string& words) { CHECK_MESSAGE(contains(page, words), words); };
    const auto fall_of = [&](const std::string& id) {
        for (const auto& one : found["library"])
            if (one["id"] == id)
                return one["chi_square_gain"].get<double>();
        return 0.0;
    };
    says(fmt::format("takes {:.0f} from chi-square, air that drags in proportion to speed {:.0f}, rolling resistance "
                     "that grows with speed {:.0f}, a high pass in the instrument {:.0f}.",
                     fall_of("roll.coulomb"), fall_of("drag.linear"), fall_of("roll.viscous"),
                     fall_of("ins.high_pass")));
    says(fmt::format("beyond {:.1f} (the gate)", found["gate"].get<double>()));
    says(fmt::format("(p = {:.2f})", found["adequacy_winner"]["p"].get<double>()));
    says(fmt::format("by {:.0f} nats", found["gain"]["nats"].get<double>()));
    says(fmt::format("`mu_r = {:.5f} +- {:.5f}`", found["fitted"][0]["amplitude"].get<double>(),
                     found["fitted"][0]["standard_error"].get<double>()));
    says(fmt::format("up to {:.1f} standard errors", found["second_effect_up_to"]["standard_errors"].get<double>()));
    for (const char* key : {"value", "with_the_cause"})
        says(fmt::format(" {:.3f}", found["nuisances"][0][key].get<double>()));
}

TEST_CASE("data that cannot be read end with exit code 2, place and remedy") {
    const Folder folder;
    const Outcome none = tumble_in(folder, {"diagnose", scene, "--data", "nowhere.toml"});
    CHECK(none.code == 2);
    CHECK(contains(none.err, "nowhere.toml"));
    put(folder.path / "m.toml",
        "[[series]]\nname = \"a\"\nfile = \"a.csv\"\n[[series.column]]\nhead = \"height\"\nmeasure = "
        "\"centre_of_mass_y\"\n");
    const Outcome missing = tumble_in(folder, {"diagnose", scene, "--data", "m.toml"});
    CHECK(missing.code == 2);
    CHECK(contains(missing.err, "m.toml:3:8:"));
    CHECK(contains(missing.err, "a.csv"));
}

TEST_CASE("a misspelt key of the scene is found where the measurement has it") {
    const Folder folder;
    std::string text = content_of(data);
    const std::string key = "pair.leather-wood.restitution";
    text.replace(text.find(key), key.size(), "pair.leather-wood.restitutoin");
    std::filesystem::copy(std::filesystem::path(data).parent_path(), folder.path / "bounce");
    put(folder.path / "bounce/measurement.toml", text);
    const Outcome slip = tumble_in(folder, {"diagnose", scene, "--data", "bounce/measurement.toml"});
    CHECK(slip.code == 2);
    CHECK(contains(slip.err, "bounce/measurement.toml:4:7: nuisance 'pair.leather-wood.restitutoin': "));
    CHECK(contains(slip.err, "did you mean 'restitution'?"));
}

TEST_CASE("a diagnosis that is stopped says so and leaves no folder") {
    const Folder folder;
    Process process(folder.path, {"diagnose", scene, "--data", data, "--report", "report"});
    REQUIRE(eventually([&] { return process.catches(SIGINT); }));
    process.send(SIGINT);
    const Outcome stopped = process.wait();
    CHECK(stopped.code == 130);
    CHECK(contains(stopped.err, "stopped: no verdict, and nothing was written; begin again"));
    CHECK(stopped.out.empty());
    CHECK_FALSE(std::filesystem::exists(folder.path / "report"));
}

TEST_CASE("millimetres that are read as metres are a slip, not a cause") {
    const Folder folder;
    std::string csv = "time_s,height_m\n";
    for (int k = 0; k < 60; ++k) {
        const double t = 0.008 * k;
        csv += std::to_string(t) + "," + std::to_string(1120 - 4905 * t * t) + "\n";
    }
    put(folder.path / "a.csv", csv);
    put(folder.path / "m.toml",
        "[[series]]\nname = \"a\"\nfile = \"a.csv\"\n[[series.column]]\nhead = \"height\"\nmeasure = "
        "\"centre_of_mass_y\"\nsigma = 0.002\n");
    const Outcome slip = tumble_in(folder, {"diagnose", scene, "--data", "m.toml", "--report", "report"});
    CHECK(slip.code == 2);
    CHECK_FALSE(std::filesystem::exists(folder.path / "report")); // made before, and empty
    CHECK(contains(slip.err, "times what the simulation does"));
    CHECK(contains(slip.err, "now: fits the baseline")); // in a pipe, too
    CHECK(!contains(slip.err, "sigma missing"));
    const Outcome quiet = tumble_in(folder, {"diagnose", scene, "--data", "m.toml", "--quiet"});
    CHECK(quiet.err.find("now: ") == std::string::npos);
    std::string unsaid = content_of((folder.path / "m.toml").string());
    unsaid.erase(unsaid.find("sigma = 0.002"));
    put(folder.path / "unsaid.toml", unsaid);
    const Outcome warned = tumble_in(folder, {"diagnose", scene, "--data", "unsaid.toml"});
    CHECK(warned.code == 2); // what is known of the data is told before the work, and stands though it fails
    CHECK(contains(warned.err, "a.csv: sigma missing: height_m: its scatter is not stated"));
    const Outcome place =
        tumble_in(folder, {"diagnose", scene, "--data", "m.toml", "--write-extended", "a.csv/there/extended.toml"});
    CHECK(place.code == 2);
    CHECK(contains(place.err, "a.csv/there/extended.toml: cannot be written: Not a directory"));
    CHECK(!contains(place.err, "now: "));
}

TEST_CASE("every cause of the library can be listed, with what its residual looks like") {
    const Folder folder;
    const Outcome list = tumble_in(folder, {"list", "causes", "--json"});
    CHECK(list.code == 0);
    const auto causes = nlohmann::json::parse(list.out);
    CHECK(causes.size() >= 10);
    for (const auto& cause : causes)
        CHECK(!cause["fingerprint"].get<std::string>().empty());
}

TEST_CASE("a sealed case is revealed, and a folder without one is refused") {
    const Folder folder;
    const std::string cases = std::string(TUMBLE_ROOT) + "/scenes/measured/cases/";
    for (const char* number : {"1", "2", "3", "4", "5", "6"}) {
        const Outcome told = tumble_in(folder, {"reveal", cases + number});
        CHECK(told.code == 0);
        CHECK((contains(told.out, "Hidden: ") || contains(told.out, "Nothing was hidden.")));
        const std::string toml = content_of(std::filesystem::path(cases) / number / "measurement.toml");
        CHECK(!contains(toml, "hidden")); // what a student reads gives nothing away
    }
    const Outcome none = tumble_in(folder, {"reveal", "nowhere"});
    CHECK(none.code == 2);
    CHECK(contains(none.err, "nowhere/sealed.txt: there is no such file"));
    put(folder.path / "sealed.txt", "00ff\n");
    const Outcome broken = tumble_in(folder, {"reveal", "."});
    CHECK(broken.code == 2);
    CHECK(contains(broken.err, "holds no sealed answer"));
}

TEST_CASE("a bed is run by seeds, each run kept beside the scene: the same question again runs nothing") {
    const Folder folder;
    const std::string trough = content_of(std::string(TUMBLE_ROOT) + "/scenes/measured/trough/trough.toml");
    put(folder.path / "bed.toml", trough);
    // Ten discs before anything shakes; told to lie as ten do, and as fifteen.
    put(folder.path / "m.toml", R"(title = "few discs"
causes = ["load.fill"]
[[bulk]]
name = "ten"
set = ["fill.0.count=5", "fill.1.count=5"]
from_s = 0.7
until_s = 0.9
runs = 2
[[bulk.number]]
measure = "centre_of_mass_y"
value = 0.03
unit = "m"
[[bulk.number]]
measure = "bulk_height"
value = 40
unit = "mm"
sigma = 4
)");
    const Outcome asked = tumble_in(folder, {"diagnose", "bed.toml", "--data", "m.toml", "--seeds", "3", "--dry-run"});
    CHECK(asked.code == 0);
    CHECK(contains(asked.out, "9 runs, 8.1 s to simulate; 0 more are kept"));
    CHECK(!std::filesystem::exists(folder.path / "bed.response.csv"));
    const auto diagnose = [&] {
        const Outcome told = tumble_in(folder, {"diagnose", "bed.toml", "--data", "m.toml", "--seeds", "3", "--json",
                                                "--quiet", "--report", "report"});
        REQUIRE(told.code == 0);
        return nlohmann::json::parse(told.out);
    };
    const auto first = diagnose(), second = diagnose();
    CHECK(first["runs"] >= 9);
    CHECK(second["runs"] == 0);
    CHECK(first["beds"] == second["beds"]);
    CHECK(first["beds"].size() == 2);
    CHECK(first["degrees_of_freedom"] == 6); // three beds of three seeds
    CHECK(contains(content_of(folder.path / "bed.response.csv"), "ten,load.fill,0.25,2,"));
    const std::string page = content_of(folder.path / "report/diagnosis.html");
    CHECK(contains(page, "centre of mass y"));
    CHECK(!contains(page, "nan"));
    CHECK(contains(content_of(folder.path / "report/residuals.csv"), "condition,measure,unit"));

    // Killed in the midst of its runs, it has lost the one that it was at.
    const std::vector<std::string> words{"diagnose", "bed.toml", "--data",     "m.toml",  "--seeds",
                                         "3",        "--table",  "killed.csv", "--quiet", "--json"};
    Process process(folder.path, words);
    REQUIRE(eventually([&] {
        const std::string table = content_of(folder.path / "killed.csv"); // two lines stand above the runs
        return std::count(table.begin(), table.end(), '\n') >= 4;
    }));
    process.send(SIGKILL);
    CHECK(process.wait().code == 137);
    auto dry = words;
    dry.emplace_back("--dry-run");
    const std::string left = tumble_in(folder, dry).out;
    const auto at = left.find("; ");
    REQUIRE(at != std::string::npos);
    const int kept = std::stoi(left.substr(at + 2));
    CHECK(kept >= 1);
    CHECK(kept < 9);
    const auto last = nlohmann::json::parse(tumble_in(folder, words).out);
    CHECK(last["runs"] == first["runs"].get<int>() - kept);
    CHECK(last["beds"] == first["beds"]);
}

} // namespace test_diagnose_command
