#include "process.h"

#include <nlohmann/json.hpp>

namespace test_reduce_command {

using namespace tumble::test;

namespace {

const std::string scene = TUMBLE_ROOT "/scenes/trough-2d.toml";

/// A trough of 40 discs and cones, shaken for 0.3 s.
std::vector<std::string> reduce(std::vector<std::string> more) {
    std::vector<std::string> words{"reduce", scene};
    for (const char* set :
         {"fill.0.count=20", "fill.1.count=20", "fill.0.until_s=0.1", "fill.1.until_s=0.1",
          "wall.trough.motion.0.start_s=0.2", "wall.trough.motion.1.start_s=0.2", "duration_s=0.5", "time_step_s=4e-5"})
        words.insert(words.end(), {"--set", set});
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

} // namespace

TEST_CASE("reduce leaves table, plot and a scene that runs like any other, and runs nothing twice") {
    const Folder folder;
    const auto words = reduce({"--try", "softening=4", "--within", "99%", "--seeds", "2", "--out", "r", "--json"});
    const Outcome outcome = tumble_in(folder, words);
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK_MESSAGE(outcome.code == 1, outcome.err); // two seeds make sure of nothing
    CHECK_FALSE(std::filesystem::exists(folder.path / "r" / "trough-2d-reduced.toml"));
    CHECK(json["reference"] == "as written");
    CHECK(json["rungs"].size() == 2);
    CHECK(json["rungs"][1]["runs"].size() == 2);
    CHECK(content_of(folder.path / "r" / "reduction.csv").starts_with("rung,"));
    CHECK(std::filesystem::file_size(folder.path / "r" / "reduction.png") > 1000);
    auto unsure = words;
    unsure.push_back("--unsure");
    CHECK(tumble_in(folder, unsure).code == (json["cheapest"].is_null() ? 1 : 0)); // so short a shake may tell nothing
    if (json["cheapest"].is_string()) {
        const Outcome check = tumble_in(folder, {"check", "r/trough-2d-reduced.toml", "--json"});
        CHECK_MESSAGE(check.code == 0, check.err);
    }
    const Outcome again = tumble_in(folder, words);
    CHECK(nlohmann::json::parse(again.out) == json);
    CHECK(contains(again.err, "run 4 of 4: as written, seed 8, done before"));
}

TEST_CASE("wrong words to reduce get exit code 2 and say all that is wrong at once") {
    const Folder folder;
    const Outcome outcome =
        tumble_in(folder, reduce({"--try", "sofening", "--within", "110%", "--measure", "mean_sped"}));
    CHECK(outcome.code == 2);
    for (const char* word :
         {"there is no reduction 'sofening'", "did you mean 'softening'?", "'110%' is no share", "mean_sped"})
        CHECK_MESSAGE(contains(outcome.err, word), outcome.err);
    CHECK_FALSE(std::filesystem::exists(folder.path / "out"));
    CHECK(tumble_in(folder, {"reduce", "none.toml"}).code == 2);
    CHECK(contains(tumble_in(folder, reduce({"--time", "2:1"})).err, "--time 2:1 ends before it begins"));
    const Outcome refused = tumble_in(folder, reduce({"--try", "spheres"}));
    CHECK(refused.code == 2);
    CHECK_MESSAGE(contains(refused.err, "reduce"), refused.err);
}

TEST_CASE("a reference that is no run, or a run of another scene, is refused with exit code 2 before anything runs") {
    const Folder folder;
    std::filesystem::create_directory(folder.path / "empty");
    const Outcome none = tumble_in(folder, reduce({"--reference", "empty"}));
    CHECK(none.code == 2);
    CHECK(contains(none.err, "empty: is not the folder of a run"));
    put(folder.path / "ball.toml", bouncing_ball(0.01));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--out", "ball", "--quiet"}).code == 0);
    const Outcome other = tumble_in(folder, reduce({"--reference", "ball"}));
    CHECK(other.code == 2);
    CHECK(contains(other.err, "it is a run of another scene: "));
    CHECK_FALSE(std::filesystem::exists(folder.path / "out"));
}

} // namespace test_reduce_command
