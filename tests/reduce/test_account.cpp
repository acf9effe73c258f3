#include "reduce/account.h"
#include "sheet/show.h"
#include "small_trough.h"

#include <cmath>
#include <doctest/doctest.h>

namespace test_account {

using namespace tumble;
using namespace tumble::reduce;

namespace {

/// The trough and a softer one, two seeds each, in which nobody had a circulation: energies of 1 and 1.02, slopes of 8.
Climb two_rungs() {
    const auto rungs = ladder(test::small_trough(), {*read_wish("softening=4")});
    const auto stick = Yardstick::of(rungs->front().scene, {}, std::nullopt, std::nullopt);
    Climb climb{*stick, {}};
    climb.made = climb.all = 4;
    for (const Rung& rung : *rungs) {
        const bool soft = rung.degrees.softening > 1;
        Climbed climbed{rung, Standing::finished, "", soft ? 1.0 : 2.0, 1, 50, {}};
        for (const std::uint64_t seed : {7, 8})
            climbed.runs.push_back({seed, soft ? 1.0 : 2.0, 0.1, {soft ? 1.02 : 1.0, std::nan(""), 8.0}, {}});
        climb.rungs.push_back(climbed);
    }
    return climb;
}

std::string text_of(const Climb& climb) {
    return sheet::to_text("small", sheet_of(account_of("scenes/small.toml", climb, 0.1, 2), false));
}

} // namespace

TEST_CASE("a quantity that no row has a value of is left out of the table, and stays in the files") {
    const Climb climb = two_rungs();
    const Account account = account_of("scenes/small.toml", climb, 0.1, 2);
    const auto grid = std::get<sheet::Grid>(sheet_of(account, false).parts.front());
    std::vector<std::string> heads;
    for (const sheet::Column& column : grid.columns)
        heads.push_back(sheet::head_of(column));
    CHECK(heads == std::vector<std::string>{"scene", "verdict", "bodies", "core, s", "speed-up", "overlap, %",
                                            "kinetic energy per mass, J/kg", "surface slope, deg"});
    for (const auto& row : grid.rows)
        CHECK(row.size() == heads.size());
    CHECK(text_of(climb).find("circulation judges none of the others") != std::string::npos);
    CHECK(csv_of(account).find("circulation_mean") != std::string::npos);
    CHECK(to_json(account)["rungs"][0]["quantities"].size() == 3);
}

TEST_CASE("an interrupted ladder says first of how many runs it speaks, and that the same command goes on") {
    Climb climb = two_rungs();
    CHECK(text_of(climb).find("nterrupted") == std::string::npos);
    CHECK(text_of(climb).find("So far") == std::string::npos);
    climb.rungs.front().standing = Standing::waiting;
    climb.rungs.front().runs.pop_back();
    climb.stopped = true;
    climb.made = 3;
    const std::string text = text_of(climb);
    const std::size_t told = text.find("Interrupted: 3 of 4 runs are made"), table = text.find("scene ");
    CHECK(told != std::string::npos);
    CHECK(told < table);
    CHECK(text.find("The same command goes on") != std::string::npos);
    CHECK(text.find("So far: ") != std::string::npos);
    CHECK(to_json(account_of("scenes/small.toml", climb, 0.1, 2))["runs_made"] == 3);
}

} // namespace test_account
