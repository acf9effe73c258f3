#include "about.h"
#include "process.h"

#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

namespace test_command_line {

using namespace tumble::test;

TEST_CASE("a mistyped command, flag or file gets the nearest right word and exit code 2") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.01));
    const Outcome command = tumble_in(folder, {"rnu", "ball.toml"});
    CHECK(command.code == 2);
    CHECK(contains(command.err, "there is no command 'rnu'"));
    CHECK(contains(command.err, "did you mean 'run'?"));
    const Outcome flag = tumble_in(folder, {"run", "ball.toml", "--vidoe"});
    CHECK(flag.code == 2);
    CHECK(contains(flag.err, "has no flag '--vidoe'"));
    CHECK(contains(flag.err, "did you mean '--video'?"));
    const Outcome own = tumble_in(folder, {"--verson"});
    CHECK(own.code == 2);
    CHECK(contains(own.err, "did you mean '--version'?"));
    const Outcome file = tumble_in(folder, {"run", "bal.toml"});
    CHECK(file.code == 2);
    CHECK(contains(file.err, "bal.toml"));
    const Outcome list = tumble_in(folder, {"list", "measure"});
    CHECK(list.code == 2);
    const Outcome word = tumble_in(folder, {"check", "ball.toml", "twice.toml"});
    CHECK(word.code == 2);
    CHECK(contains(word.err, "'twice.toml' is one word too many"));
    for (const Outcome& outcome : {command, flag, own, file, list, word})
        CHECK(outcome.out.empty());
}

TEST_CASE("what the command line lacks, or has too much of, is said in the words of the help") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.01));
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"list"}, "`tumble list` needs WHAT: scenes, laws, measures, causes or keys\n    for example `tumble list "},
        {{"list", "nonsense"}, "WHAT: 'nonsense' is none of scenes, laws, measures, causes, keys\n"},
        {{"list", "measure"}, "; did you mean 'measures'?"},
        {{"run"}, "`tumble run` needs SCENE: "},
        {{"render"}, "`tumble render` needs RUN|SCENE: "},
        {{"diagnose", "ball.toml"}, "`tumble diagnose` needs --data: "},
        {{"run", "ball.toml", "--threads", "0"}, "--threads: '0' is not a whole number from 1 to 256"},
        {{"run", "ball.toml", "--threads", "two"}, "--threads: 'two' is not a whole number from 1 to 256"},
        {{"run", "ball.toml", "--checkpoint-every", "-1"}, "--checkpoint-every: '-1' is not a number from 0 to 1e+06"},
        {{"run", "ball.toml", "--out"}, "--out lacks a value"},
        {{"run", "ball.toml", "--out", "a", "--out", "b"}, "--out has too many values"},
        {{"run", "ball.toml", "--resume", "--force"}, " do not go together"},
        {{"run", "ball.toml", "--accept-changes"}, "--accept-changes goes only with --resume"},
        {{"walls", "ball.toml", "--at", "noon"}, "--at: 'noon' cannot be read as a number"},
        {{"fit", "--cone", "10,-12", "--spheres", "12"}, "--cone: '-12' is not a number above 0"},
        {{"excitation", "a.csv", "--about", "w"}, "--about: 'w' is none of x, y, z"}};
    for (const auto& [words, said] : cases) {
        const Outcome outcome = tumble_in(folder, words);
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.err, said));
        CHECK(contains(outcome.err, " --help` shows how it is meant"));
    }
    CHECK_FALSE(std::filesystem::exists(folder.path / "out"));
}

TEST_CASE("nothing at all shows the help on stderr and is wrong") {
    const Folder folder;
    const Outcome outcome = tumble_in(folder, {});
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "tumble run scenes/drop.toml"));
}

TEST_CASE("every help opens with an example and goes to stdout") {
    const Folder folder;
    for (const std::string command : {"run", "render", "check", "list", "lesson", "export", "walls", "fit", "flow"}) {
        const Outcome outcome = tumble_in(folder, {command, "--help"});
        CHECK(outcome.code == 0);
        CHECK_MESSAGE(outcome.out.starts_with("Example: tumble " + command + " "), outcome.out.substr(0, 80));
        CHECK(outcome.err.empty());
    }
    CHECK(tumble_in(folder, {"--help"}).out.starts_with("Example: tumble "));
    CHECK(tumble_in(folder, {"--version"}).out.starts_with("tumble "));
}

TEST_CASE("check and run alike refuse a plot of an unknown measure, with its line") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.01) + "plot_measure = \"kinetic_enrgy\"\n");
    for (const std::string command : {"check", "run"}) {
        const Outcome outcome = tumble_in(folder, {command, "ball.toml"});
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.err, "ball.toml:34:16: there is no measure 'kinetic_enrgy'"));
        CHECK(contains(outcome.err, "did you mean 'kinetic_energy'?"));
    }
    CHECK(contains(tumble_in(folder, {"render", "--help"}).out, "speed, vx, vy, vz, spin"));
}

TEST_CASE("a mistake in a scene is told with file, line and column, on stderr and as JSON") {
    const Folder folder;
    std::string text = bouncing_ball(0.01);
    text.replace(text.find("restitution"), 11, "restitutoin");
    put(folder.path / "ball.toml", text);
    const Outcome outcome = tumble_in(folder, {"check", "ball.toml", "--json"});
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "ball.toml:13:1:"));
    CHECK(contains(outcome.err, "did you mean 'restitution'?"));
    const auto json = nlohmann::json::parse(outcome.out);
    CHECK(json["problems"][0]["line"] == 13);
    CHECK(json["problems"][0]["column"] == 1);
}

TEST_CASE("--set goes through the checks of the file") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.01));
    const Outcome wrong = tumble_in(folder, {"run", "ball.toml", "--set", "pair.glass-glass.restitution=1.5"});
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.err, "--set pair.glass-glass.restitution"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "out"));
    const Outcome right =
        tumble_in(folder, {"run", "ball.toml", "--set", "duration_s=0.002", "--set", "seed=9", "--quiet", "--json"});
    CHECK(right.code == 0);
    CHECK(right.err.empty());
    const auto json = nlohmann::json::parse(right.out);
    CHECK(json["steps"] == 200);
    CHECK(json["seed"] == 9);
}

TEST_CASE("the lists name what scenes may say") {
    const Folder folder;
    const auto measures = nlohmann::json::parse(tumble_in(folder, {"list", "measures", "--json"}).out);
    bool found = false;
    for (const auto& measure : measures)
        found = found || measure["column"] == "circulation_rad_s";
    CHECK(found);
    // A measure stands as a scene and --plot name it.
    CHECK(contains(tumble_in(folder, {"list", "measures"}).out, "\nkinetic_translation  "));
    CHECK(contains(tumble_in(folder, {"list", "measures"}).out, "\ntracer:BODY  "));
    put(folder.path / "ball.toml", bouncing_ball(0.01));
    const std::string untraced = tumble_in(folder, {"list", "measures", "ball.toml"}).out;
    CHECK(contains(untraced, "\ntracer:ball  ")); // whom a tracer could follow
    CHECK(untraced.find("\ntracer:ball_") == std::string::npos);
    std::string traced = bouncing_ball(0.01);
    traced.replace(traced.find("[observe]"), 9, "[observe]\nmeasures = [\"tracer:ball\"]");
    put(folder.path / "ball.toml", traced);
    const std::string listed = tumble_in(folder, {"list", "measures", "ball.toml"}).out;
    CHECK(contains(listed, "\nkinetic_translation  "));
    CHECK(contains(listed, "\ntracer:ball_point_vy "));
    CHECK(tumble_in(folder, {"list", "measures", "none.toml"}).code == 2);
    CHECK(contains(tumble_in(folder, {"list", "laws"}).out, "hertz"));
    CHECK(contains(tumble_in(folder, {"list", "keys"}).out, "duration_s"));
    const auto laws = nlohmann::json::parse(tumble_in(folder, {"list", "laws", "--json"}).out);
    std::set<std::pair<std::string, std::string>> once;
    for (const auto& law : laws) {
        CHECK(once.emplace(law["key"], law["law"]).second);
        CHECK_MESSAGE(!law["sentence"].get<std::string>().empty(), law["law"]);
        CHECK(law["dimension"] == (law["key"] == "contact.adhesion" ? nlohmann::json(3) : nlohmann::json()));
    }
    CHECK(once.contains({"contact.rolling", "epsd"}));
    // A name that 2D and 3D take differently is there once for each.
    std::set<std::tuple<std::string, std::string, int>> keys; // 0: of both
    for (const auto& key : nlohmann::json::parse(tumble_in(folder, {"list", "keys", "--json"}).out))
        CHECK_MESSAGE(
            keys.emplace(key["table"], key["key"], key["dimension"].is_null() ? 0 : key["dimension"].get<int>()).second,
            key["key"]);
    CHECK(keys.contains({"[contact]", "normal", 2}));
    CHECK(keys.contains({"[contact]", "normal", 3}));
    CHECK(keys.contains({"", "duration_s", 0}));
    std::filesystem::create_directory(folder.path / "scenes");
    put(folder.path / "scenes" / "ball.toml", bouncing_ball(1));
    CHECK(contains(tumble_in(folder, {"list", "scenes"}).out, "scenes/ball.toml  3D  A ball that bounces"));
    CHECK(nlohmann::json::parse(tumble_in(folder, {"list", "scenes", "--json"}).out)[0]["dimension"] == 3);
    CHECK(tumble_in(folder, {"list", "scenes", "nowhere"}).code == 2);
}

TEST_CASE("check says masses, steps and margins as theory has them, and refuses an unstable step") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.5));
    const Outcome outcome = tumble_in(folder, {"check", "ball.toml", "--json"});
    CHECK(outcome.code == 0);
    const auto json = nlohmann::json::parse(outcome.out);
    const double mass = 4.0 / 3.0 * M_PI * 1e-6 * 2500;
    CHECK(json["bodies"][0]["mass_kg"].get<double>() == about(mass));
    CHECK(json["bodies"][0]["inertia_kg_m2"][0].get<double>() == about(0.4 * mass * 1e-4));
    CHECK(json["steps"] == 50000);
    CHECK(json["rows"] == 501);
    CHECK(json["frames"] == 51);
    // pi R sqrt(rho/G) / (0.1631 nu + 0.8766) with G = E / (2 (1 + nu)) = 4e7 Pa
    const double rayleigh = M_PI * 0.01 * std::sqrt(2500 / 4e7) / (0.1631 * 0.25 + 0.8766);
    CHECK(json["time_step"]["rayleigh_s"].get<double>() == about(rayleigh));
    CHECK_FALSE(std::filesystem::exists(folder.path / "out"));
    CHECK(json["assumed_step_s"] == 5e-7);
    const std::string words = tumble_in(folder, {"check", "ball.toml"}).out;
    CHECK(contains(words, "body-steps/s and 500 ns a step at least"));
    CHECK(contains(words, "Rayleigh time"));
    CHECK(contains(words, "less than 1 s on one core")); // 50,000 steps of half a microsecond, 552 rows and frames
    // A step costs half a microsecond however few the bodies: 60 s of 1e-5 s are 6 million.
    const std::vector<std::string> longer{"check", "ball.toml", "--duration", "60", "--json"};
    CHECK(nlohmann::json::parse(tumble_in(folder, longer).out)["hours_on_one_core"] > 3.0 / 3600);
    const Outcome unstable = tumble_in(folder, {"check", "ball.toml", "--set", "time_step_s=1e-3"});
    CHECK(unstable.code == 2);
    CHECK(contains(unstable.err, "stable limit"));
}

TEST_CASE("check shows each wall's size and its warnings on stdout, where its answer stands") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.5));
    const Outcome outcome =
        tumble_in(folder, {"check", "ball.toml", "--set", "gravity_m_s2.1=-981", "--set", "time_step_s=1e-7"});
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    CHECK(contains(outcome.out, "floor  plane  glass     endless  endless  endless"));
    CHECK(contains(outcome.out, "warning: --set gravity_m_s2.1: a gravity of 981 m/s2"));
}

TEST_CASE("check has a line for each pair of materials that can meet, with its laws and their numbers") {
    const Folder folder;
    const std::string lining = "[material.lining]\ndensity_kg_m3 = 1200\nyoungs_modulus_Pa = 2e7\npoisson_ratio = 0.3\n"
                               "[pair.glass-lining]\nrestitution = 0.2\nfriction = 0.9\nrolling_friction = 0.05\n"
                               "work_of_adhesion_J_m2 = 0.04\n";
    std::string text = bouncing_ball(0.5);
    text.insert(text.find("[body.ball]"), lining + "[contact]\nrolling = \"epsd\"\nadhesion = \"jkr\"\n");
    text.insert(text.find("[observe]"), "[[wall]]\nname = \"side\"\nshape = \"plane\"\npoint_m = [-0.05, 0, 0]\n"
                                        "normal = [1, 0, 0]\nmaterial = \"lining\"\n");
    put(folder.path / "ball.toml", text);
    const Outcome outcome = tumble_in(folder, {"check", "ball.toml"});
    CHECK_MESSAGE(outcome.code == 0, outcome.err);
    // 1 / E* = 0.9375 / 1e8 + 0.91 / 2e7; glass alone: 1e8 / (2 0.9375).
    CHECK(contains(outcome.out, "glass-glass   hertz, E* 53.3 MPa; mindlin  0.8          0.3       none"));
    CHECK(contains(outcome.out,
                   "glass-lining  hertz, E* 18.2 MPa; mindlin  0.2          0.9       epsd 0.05, damping 0.3  "
                   "jkr, 0.04 J/m2"));
    CHECK(outcome.out.find("lining-lining") == std::string::npos);
    const auto pairs = nlohmann::json::parse(tumble_in(folder, {"check", "ball.toml", "--json"}).out)["pairs"];
    REQUIRE(pairs.size() == 2);
    CHECK(pairs[0]["rolling"] == "none");
    CHECK(pairs[1]["pair"] == "glass-lining");
    CHECK(pairs[1]["rolling_friction"] == 0.05);
    CHECK(pairs[1]["adhesion"] == "jkr");
}

TEST_CASE("fit and walls write what they say, and nothing twice; flow wants a run") {
    const Folder folder;
    const std::vector<std::string> fit{"fit", "--cone", "10,12", "--spheres", "12", "--out", "cone.csv"};
    const Outcome fitted = tumble_in(folder, fit);
    CHECK(fitted.code == 0);
    CHECK(contains(fitted.out, "12 spheres, radius"));
    CHECK(contains(content_of(folder.path / "cone.csv"), "# Made by: tumble fit --cone 10,12 --spheres 12"));
    const Outcome again = tumble_in(folder, fit);
    CHECK(again.code == 2);
    CHECK(contains(again.err, "--force replaces it"));
    CHECK(contains(tumble_in(folder, {"fit", "--spheres", "12"}).err, "give a mesh.stl or --cone DIAMETER,HEIGHT"));
    const Outcome judged = tumble_in(folder, {"fit", "--cone", "10,12", "--compare", "cone.csv", "--json"});
    CHECK(judged.code == 0);
    CHECK(nlohmann::json::parse(judged.out)["spheres"] == 12);

    put(folder.path / "ball.toml", bouncing_ball(0.01));
    const Outcome walls = tumble_in(folder, {"walls", "ball.toml", "--out", "stl"});
    CHECK(walls.code == 0);
    CHECK(!std::filesystem::is_empty(folder.path / "stl"));
    CHECK(tumble_in(folder, {"walls", "ball.toml", "--out", "stl"}).code == 2);
    CHECK(tumble_in(folder, {"flow", "nowhere"}).code == 2);
    CHECK(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    const Outcome flow = tumble_in(folder, {"flow", "out/ball", "--json", "--layers", "3"});
    CHECK(flow.code == 0);
    CHECK(nlohmann::json::parse(flow.out)["layers"].size() == 3);
    const Outcome between = tumble_in(folder, {"flow", "out/ball", "--json", "--layers", "2", "--heights", "0,0.3"});
    CHECK(nlohmann::json::parse(between.out)["layers"][1]["from_m"] == 0.15);
    const Outcome reversed = tumble_in(folder, {"flow", "out/ball", "--heights", "0.16,0"});
    CHECK(reversed.code == 2);
    CHECK(contains(reversed.err, "--heights: the lowest height, 0.16 m, does not lie below the highest, 0 m"));
    CHECK(contains(reversed.err, "give the lower one first, as in --heights 0,0.16"));
    const Outcome ending = tumble_in(folder, {"flow", "out/ball", "--picture", "flow.jpg"});
    CHECK(ending.code == 2);
    CHECK(contains(ending.err, "'flow.jpg' does not end in .png or .svg"));
    // What is there stays, unless it is said that it may go.
    const std::vector<std::string> tables{"flow", "out/ball", "--out", "tables", "--body", "ball"};
    CHECK(tumble_in(folder, tables).code == 0);
    CHECK(std::filesystem::exists(folder.path / "tables" / "tracer_ball.csv"));
    put(folder.path / "tables" / "tracer_ball.csv", "mine");
    put(folder.path / "flow.png", "mine");
    const Outcome kept = tumble_in(folder, tables);
    CHECK(kept.code == 2);
    CHECK(contains(kept.err, "tables/flow_field.csv: is there already, and nothing is overwritten"));
    CHECK(content_of(folder.path / "tables" / "tracer_ball.csv") == "mine");
    CHECK(tumble_in(folder, {"flow", "out/ball", "--picture", "flow.png"}).code == 2);
    CHECK(content_of(folder.path / "flow.png") == "mine");
    std::vector<std::string> forced = tables;
    forced.emplace_back("--force");
    CHECK(tumble_in(folder, forced).code == 0);
    CHECK(content_of(folder.path / "tables" / "tracer_ball.csv").starts_with("time_s,"));
}

} // namespace test_command_line
