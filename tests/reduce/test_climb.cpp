#include "about.h"
#include "folder.h"
#include "reduce/account.h"
#include "reduce/kept_run.h"
#include "run/run_report.h"
#include "scene/load.h"
#include "small_trough.h"

#include <cmath>
#include <doctest/doctest.h>
#include <set>

namespace test_climb {

using namespace tumble;
using namespace tumble::reduce;
using tumble::test::about;

namespace {

/// What was run and what was kept, by rung; raises a flag after some steps.
struct Witness final : ClimbListener {
    std::vector<std::string> began;
    int kept = 0;
    std::atomic<bool> stop{false};
    int stop_after = -1; // runs

    void begins(const std::string& rung, std::uint64_t /*seed*/, int run, int /*of*/, bool was_kept) override {
        began.push_back(rung);
        kept += was_kept ? 1 : 0;
        at = run;
    }
    void progressed(const run::Progress& now) override {
        if (at == stop_after && now.time > 0.3)
            stop = true;
    }
    int at = 0;
};

Climb climbed(const test::Folder& folder, Witness& witness, const std::vector<Wish>& wishes,
              ClimbOptions options = {}) {
    const auto rungs = ladder(test::small_trough(), wishes);
    REQUIRE_MESSAGE(rungs, to_string(rungs.problems()));
    const auto stick = Yardstick::of(rungs->front().scene, {}, std::nullopt, std::nullopt);
    REQUIRE_MESSAGE(stick, to_string(stick.problems()));
    options.folder = folder.path;
    options.seeds = 2;
    options.stop = &witness.stop;
    auto climb = reduce::climb(*rungs, *stick, options, witness);
    REQUIRE_MESSAGE(climb, to_string(climb.problems()));
    return *climb;
}

/// Processor time of a rung's two runs.
double cost_of(const Climb& climb, std::size_t rung) {
    const std::vector<Seeded>& runs = climb.rungs[rung].runs;
    return runs[0].core_s + runs[1].core_s;
}

std::vector<double> values_of(const Climb& climb) {
    std::vector<double> all;
    for (const Climbed& rung : climb.rungs)
        for (const Seeded& run : rung.runs)
            all.insert(all.end(), run.values.begin(), run.values.end());
    return all;
}

} // namespace

TEST_CASE("a ladder is climbed from its cheapest rung, goes on where it was stopped, and keeps what is done") {
    const std::vector<Wish> wishes{*read_wish("softening=4")};
    const test::Folder whole, broken;
    Witness at_once, first, second, third;
    const Climb straight = climbed(whole, at_once, wishes);
    CHECK(at_once.began == std::vector<std::string>{"softening 4", "softening 4", "as written", "as written"});
    CHECK_FALSE(straight.stopped);
    for (const Climbed& rung : straight.rungs) {
        REQUIRE_MESSAGE(rung.standing == Standing::finished, rung.reason);
        REQUIRE(rung.runs.size() == 2);
        CHECK(rung.runs[1].seed == rung.runs[0].seed + 1);
        CHECK(rung.runs[0].values != rung.runs[1].values); // another seed, another fall
    }
    CHECK(straight.rungs[0].work == about(2 * straight.rungs[1].work, 1e-3)); // a step of sqrt(4)

    first.stop_after = 3;
    const Climb stopped = climbed(broken, first, wishes);
    CHECK(stopped.stopped);
    CHECK(stopped.rungs[0].standing == Standing::waiting);
    CHECK(stopped.rungs[1].standing == Standing::finished);
    CHECK(stopped.made == 2);
    CHECK(stopped.all == 4);
    const Account so_far = account_of("small.toml", stopped, 0.1, 2);
    CHECK(*so_far.reference == 1); // the fullest that there is
    CHECK_FALSE(so_far.reference_is_whole());

    const Climb resumed = climbed(broken, second, wishes);
    CHECK(second.kept == 2);
    CHECK(resumed.made == 4);
    CHECK(values_of(resumed) == values_of(straight)); // bit for bit
    (void)climbed(broken, third, wishes);
    CHECK(third.kept == 4);

    const Account account = account_of("small.toml", resumed, 0.1, 2);
    CHECK(*account.reference == 0);
    CHECK(account.prices.rungs.size() == 2);
    CHECK(account.prices.rungs[1].speed_up == about(cost_of(resumed, 0) / cost_of(resumed, 1), 1e-12));
    const auto json = to_json(account);
    CHECK(json["reference"] == "as written");
    CHECK(json["rungs"][1]["softening"] == 4);
    CHECK(json["rungs"][1]["quantities"].size() == 3);
    CHECK(csv_of(account).starts_with(
        "rung,standing,verdict,runs,core_s,speed_up,overlap,kinetic_energy_per_mass_mean,"));
}

TEST_CASE("runs that were made before stand for the scene as written, if they are runs of it") {
    const test::Folder folder, ladder_folder;
    const auto run_of = [&](const std::string& name, const std::vector<scene::Override>& sets) {
        SceneText text = test::small_trough();
        text.sets.insert(text.sets.end(), sets.begin(), sets.end());
        const auto scene = text.load();
        REQUIRE_MESSAGE(scene, to_string(scene.problems()));
        run::RunListener nobody;
        run::RunOptions options;
        options.folder = folder.path / name;
        const auto done = run::run_scene(*scene, options, nobody);
        REQUIRE_MESSAGE(done, to_string(done.problems()));
        REQUIRE(done->state == "finished");
        CHECK(done->processor_s > 0);
        return folder.path / name;
    };
    // What is drawn and how long it goes on makes no other run of it.
    const std::filesystem::path whole =
        run_of("whole", {{"seed=11"},
                         {"render.color=vy"},
                         {"title=mine"},
                         {R"(observe.measures=["kinetic_energy", "circulation", "surface_slope", "bodies"])"}});
    Witness witness;
    const std::vector<Wish> wishes{*read_wish("softening=4")};
    const Climb climb = climbed(ladder_folder, witness, wishes, {.references = {whole}});
    CHECK(witness.began == std::vector<std::string>{"softening 4", "softening 4"});
    REQUIRE(climb.rungs[0].runs.size() == 1);
    CHECK(climb.rungs[0].runs[0].seed == 11);
    const Account account = account_of("small.toml", climb, 0.1, 2);
    CHECK(account.reference_is_whole());
    CHECK(account.prices.rungs[1].errors[0].relative != 0);

    // The same run, made by the ladder itself.
    const auto own = test::small_trough().load();
    const auto stick = Yardstick::of(*own, {}, std::nullopt, std::nullopt);
    scene::Scene seeded = *own;
    seeded.seed = 11;
    Witness again;
    const Climb straight =
        reduce::climb({{"as written", {}, seeded}}, *stick, {.folder = ladder_folder.path, .seeds = 1}, again).value();
    CHECK(straight.rungs[0].runs[0].values == climb.rungs[0].runs[0].values);

    // Of a run of 0.9 s, 0.6 s are charged, as much as the others are run for.
    Witness for_longer;
    const std::filesystem::path longer = run_of("longer", {{"duration_s=0.9"}});
    const Climb from_longer = climbed(ladder_folder, for_longer, wishes, {.references = {longer}});
    const double whole_cost = run::read_summary(run::RunFolder{longer})["processor_s"];
    CHECK(from_longer.rungs[0].runs[0].core_s == about(whole_cost * 0.6 / 0.9, 1e-3)); // to a step

    // What makes a reference look dear is said, beside what its run warned of.
    const std::vector<std::string> warned = from_longer.rungs[0].runs[0].doubts;
    for (const std::string& doubt : warned)
        CHECK(doubt.find("processor time") == std::string::npos);
    nlohmann::json drawn = run::read_summary(run::RunFolder{longer});
    drawn["pictures"] = 3;
    drawn.erase("processor_s");
    test::put(longer / "run.json", drawn.dump());
    const Climb doubted = climbed(ladder_folder, for_longer, wishes, {.references = {longer}});
    REQUIRE(doubted.rungs[0].runs[0].doubts.size() == warned.size() + 2);
    CHECK(doubted.rungs[0].runs[0].doubts[1].find("includes pictures") != std::string::npos);

    const auto refused = [&](const std::vector<std::filesystem::path>& references) {
        Witness nobody;
        const auto tried = reduce::climb(*ladder(test::small_trough(), wishes), *stick,
                                         {.folder = ladder_folder.path, .references = references}, nobody);
        REQUIRE_FALSE(tried);
        return tried.problems().front().what;
    };
    CHECK(refused({whole, whole}) == "seed 11 is among the references already");
    CHECK(refused({run_of("other", {{"pair.media-media.friction=0.3"}})})
              .starts_with("it is a run of another scene: pair."));
    CHECK(refused({run_of("short", {{"duration_s=0.5"}})}) ==
          "it has come to t = 0.5 s, and what counts ends at 0.6 s");
    CHECK(refused({run_of("blind", {{R"(observe.measures=["bodies"])"}})}) ==
          "its series.csv has no column 'kinetic_energy'");
    CHECK(refused({folder.path}).starts_with("is not the folder of a run"));
}

TEST_CASE("a budget leaves out what would go beyond it") {
    const test::Folder folder;
    Witness witness;
    // The first run is made in any case: before it nothing is known of the pace.
    const Climb climb = climbed(folder, witness, {*read_wish("softening=4")},
                                {.folder = {}, .seeds = 2, .budget = 1e-3, .threads = 1, .stop = nullptr});
    CHECK(climb.rungs[0].standing == Standing::left_out);
    CHECK(climb.made == 1);
    CHECK(climb.all == 1);
    CHECK(climb.rungs[0].reason.find("beyond the budget") != std::string::npos);
    CHECK(witness.began == std::vector<std::string>{"softening 4"});
}

TEST_CASE("a rung that cannot be built is said to be so, with the reason") {
    const auto rungs = ladder({TUMBLE_ROOT "/scenes/trough-quick.toml", {}}, {*read_wish("slice=0.3")});
    REQUIRE_MESSAGE(rungs, to_string(rungs.problems()));
    const auto stick = Yardstick::of(rungs->front().scene, {}, std::nullopt, std::nullopt);
    const test::Folder folder;
    Witness witness;
    witness.stop = true; // before the first step
    const auto climb = reduce::climb(*rungs, *stick, {.folder = folder.path, .stop = &witness.stop}, witness);
    REQUIRE_MESSAGE(climb, to_string(climb.problems()));
    CHECK(climb->stopped);
    CHECK(climb->rungs[0].standing == Standing::waiting);
    CHECK(climb->rungs[1].standing == Standing::refused);
    CHECK(climb->rungs[1].reason.find("must never meet its own image") !=
          std::string::npos); // 15 mm for cones of 22 mm
}

TEST_CASE("the cheapest scene is a scene file that says what it was reduced by and how far it is off") {
    const auto rungs = ladder(test::small_trough(), {*read_wish("softening=4")});
    const auto stick = Yardstick::of(rungs->front().scene, {}, std::nullopt, std::nullopt);
    Climb climb{*stick, {}, false};
    for (const Rung& rung : *rungs) {
        Climbed climbed{rung, Standing::finished, "", 0, 1, 50, {}};
        const bool soft = rung.degrees.softening > 1;
        climbed.work = soft ? 1 : 2;
        for (const std::uint64_t seed : {7, 8})
            climbed.runs.push_back(
                {seed, soft ? 1.0 : 2.0, 0.1, {soft ? 1.02 : 1.0, 0.5, 8.0 + (seed == 7 ? 0.4 : 0)}, {}});
        climb.rungs.push_back(climbed);
    }
    const Account account = account_of("scenes/small.toml", climb, 0.1, 2);
    REQUIRE(account.cheapest());
    // The plot names each rung at its speed-up; its limits are two lines, not a box.
    const sheet::Sheet sheet = sheet_of(account, true);
    REQUIRE(sheet.figures().size() == 1);
    const sheet::Figure& figure = *sheet.figures().front();
    REQUIRE(figure.places.size() == 1);
    CHECK(figure.places[0].first == about(2));
    CHECK(figure.places[0].second == rungs->at(1).name);
    std::vector<double> limits;
    for (const sheet::Curve& curve : figure.curves)
        if (curve.style == sheet::Style::dashes) {
            REQUIRE(curve.y.size() == 2);
            CHECK(curve.y[0] == curve.y[1]);
            limits.push_back(curve.y[0]);
        }
    CHECK(limits == std::vector<double>{10, -10});
    const test::Folder folder;
    REQUIRE(write_account(account, folder.path, true));
    const auto scene = scene::load_scene(folder.path / "small-reduced.toml");
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    CHECK(scene->pair(0, 0).normal_stiffness == about(2e5 / 4, 1e-12));
    CHECK(scene->claim.find("softening 4), 2 times as fast") != std::string::npos);
    CHECK(scene->claim.find("kinetic energy per mass +2.0 +- 0.0 %") != std::string::npos);
    // Seeds of either rung scatter alike, 0.4 deg apart, of two degrees of freedom: t = 4.30, g = (4.30 x 0.2 / 8.2)^2
    // = 0.0110; half of the interval 4.30 / 8.2 sqrt(0.04 (1 - g) + 0.04) / (1 - g) = 0.1496, its middle 1 / (1 - g).
    CHECK(scene->claim.find("surface slope +0.0 +- 16.1 % (not told apart)") != std::string::npos);
    CHECK_FALSE(account.sure());
    // 2 (0.1607 / 0.1)^2, which is that quantity's.
    CHECK(*account.seeds_needed() == 6);
    REQUIRE(write_account(account, folder.path, false));
    CHECK_FALSE(std::filesystem::exists(folder.path / "small-reduced.toml"));
}

TEST_CASE("a run's name changes with its scene and its seed, and a damaged note of it counts as none") {
    scene::Scene scene = *test::small_trough().load();
    std::set<std::string> names{*name_of_run("softening 4, slice 0.5", scene)};
    CHECK(names.begin()->starts_with("softening-4-slice-0.5-seed-7-"));
    scene.seed = 8;
    names.insert(*name_of_run("softening 4, slice 0.5", scene));
    scene.time_step *= 1.0000001;
    names.insert(*name_of_run("softening 4, slice 0.5", scene));
    CHECK(names.size() == 3);

    const test::Folder folder;
    const KeptRun run{12.5, 0.3, "", {"deep"}};
    REQUIRE(write_kept(folder.path / "a.json", run));
    CHECK(read_kept(folder.path / "a.json")->core_s == 12.5);
    CHECK(read_kept(folder.path / "a.json")->overlap == 0.3);
    CHECK(read_kept(folder.path / "a.json")->doubts.front() == "deep");
    test::put(folder.path / "b.json", "{\"core_s\": 12.");
    CHECK_FALSE(read_kept(folder.path / "b.json"));
    CHECK_FALSE(read_kept(folder.path / "c.json"));
}

} // namespace test_climb
