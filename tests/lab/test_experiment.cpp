#include "performed.h"

#include <cmath>
#include <set>

namespace test_experiment {

using namespace tumble;
using namespace tumble::lab;
using namespace tumble::lab::testing;

TEST_CASE("every experiment has a name and a title, and parameters whose defaults lie in their ranges") {
    std::set<std::string> names;
    for (const Experiment& experiment : all_experiments()) {
        CAPTURE(experiment.name);
        CHECK(names.insert(experiment.name).second);
        CHECK_FALSE(experiment.title.empty());
        for (const Parameter& parameter : experiment.parameters) {
            CAPTURE(parameter.name);
            CHECK(parameter.limits.hold(parameter.standard));
            CHECK(std::isfinite(parameter.limits.lo + parameter.limits.hi));
            CHECK_FALSE(parameter.sentence.empty());
        }
    }
}

TEST_CASE(
    "a name that is no experiment gets the nearest one, a range turned round is refused with the flag to change") {
    const auto experiment = find_experiment("slid");
    REQUIRE_FALSE(experiment.ok());
    CHECK(experiment.problems()[0].fix.starts_with("did you mean 'slide'?"));
    CHECK(refused("drop", {{"lowest_mm", "300"}, {"highest_mm", "200"}}).key == "--highest_mm");
    CHECK(refused("slide", {{"lowest", "0.9"}, {"highest", "0.2"}}).key == "--highest");
    CHECK(refused("plate", {{"cycles", "10"}, {"skip_cycles", "10"}}).key == "--skip_cycles");
}

TEST_CASE("a recording is a CSV file with its heads, every number read back to the same bits") {
    const Recording recording{"one", {"t_s", "height_m"}, {{0, 0.1}, {0.5, 1.0 / 3}}};
    CHECK(recording.csv() == "t_s,height_m\n0,0.1\n0.5,0.3333333333333333\n");
}

} // namespace test_experiment
