#include "about.h"
#include "diagnose/measurement.h"
#include "folder.h"

#include <doctest/doctest.h>

namespace test_read_bulk {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;

namespace {

const std::string whole = R"(title = "a trough"
causes = ["exc.phase"]
[[bulk]]
name = "quarter load"
set = ["fill.0.count=126"]
from_s = 1
runs = 3
[[bulk.number]]
measure = "circulation"
value = -6
unit = "deg_s"
sigma = 1.5
[[bulk.number]]
measure = "contacts_per_body"
value = 3.1
)";

Result<Measurement> load(const std::string& toml) {
    const test::Folder folder;
    test::put(folder.path / "m.toml", toml);
    return load_measurement(folder.path / "m.toml");
}

/// The only problem, with the folder left out of its text.
std::string refusal(const std::string& toml) {
    const auto read = load(toml);
    REQUIRE(!read);
    CAPTURE(to_string(read.problems()));
    REQUIRE(read.problems().size() == 1);
    const std::string text = to_string(read.problems()[0]);
    return text.substr(text.find("m.toml"));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("numbers of a bed are read into SI, with the stretch and the runs that they are means of") {
    const auto read = load(whole);
    REQUIRE_MESSAGE(read, to_string(read.problems()));
    const Bulk& bulk = read->bulks.at(0);
    CHECK(bulk.condition == "quarter load");
    CHECK(bulk.sets.at(0) == "fill.0.count=126");
    CHECK(bulk.from == 1);
    CHECK(!bulk.until);
    CHECK(bulk.runs == 3);
    CHECK(bulk.numbers.at(0).value == about(-6 / 57.29577951308232));
    CHECK(bulk.numbers[0].sigma == about(1.5 / 57.29577951308232));
    CHECK(bulk.numbers[0].unit == "rad_s");
    CHECK(bulk.numbers.at(1).unit.empty());
    REQUIRE(read->warnings.size() == 1); // contacts have no sigma, three runs have one
    CHECK(read->warnings[0].key == "sigma missing");
}

TEST_CASE("what is wrong with the numbers of a bed is told with its place and what to do") {
    CHECK(refusal(replaced(whole, "deg_s", "mm")) ==
          "m.toml:11:8: 'mm' is no unit of circulation\n    write unit = \"rad_s\" or unit = \"deg_s\"");
    CHECK(refusal(replaced(whole, "unit = \"deg_s\"\n", "")) ==
          "m.toml:10:9: circulation has no unit here\n    add unit = \"rad_s\" or unit = \"deg_s\"");
    CHECK(refusal(whole + "unit = \"m\"\n") == "m.toml:16:8: contacts_per_body is a plain number\n    leave unit out");
    CHECK(refusal(replaced(whole, "circulation", "circulaton")) ==
          "m.toml:9:11: there is no measure 'circulaton'\n    did you mean 'circulation'? `tumble list measures` names "
          "all of them");
    CHECK(refusal(replaced(whole, "runs = 3\n", "")) ==
          "m.toml:14:9: contacts_per_body has no sigma, and one run shows none\n    give sigma, the standard deviation "
          "between runs (parts of one long run will do), or measure more runs and give their number (runs)");
    CHECK(
        refusal(replaced(whole, "contacts_per_body", "circulation") + "unit = \"rad_s\"\n") ==
        "m.toml:14:11: circulation stands twice in 'quarter load'\n    give the mean of what repeats each other once, "
        "with the number of runs");
    CHECK(refusal(replaced(whole, "runs = 3", "until_s = 0.5\nruns = 3")) ==
          "m.toml:7:11: averaging ends at 0.5 s, before it begins at 1 s\n    let until_s be later than from_s");
    CHECK(refusal(replaced(whole, "sigma = 1.5", "sigma = 0")).starts_with("m.toml:12:9: 'sigma' = 0 is out of range"));
    CHECK(refusal(replaced(whole, "sigma", "sigmma")).starts_with("m.toml:12:1: [[bulk.number]] has no key 'sigmma'"));
}

TEST_CASE("one number under one condition bears no diagnosis, nor does what is held out") {
    const std::string one = whole.substr(0, whole.find("[[bulk.number]]\nmeasure = \"contacts"));
    CHECK(refusal(one) == "m.toml:3:1: there is one number to learn from: nothing can be diagnosed from it, for every "
                          "cause could explain it\n    measure a second number of the bed, or it under a second "
                          "condition");
    CHECK(
        refusal(replaced(whole, "runs = 3", "runs = 3\nheld_out = true")) ==
        "m.toml:3:1: every bed is held out, so there is no number to learn from: nothing can be diagnosed from none\n  "
        "  hold out fewer");
    CHECK(load(one +
               "[[bulk]]\nname = \"full\"\nruns = 3\n[[bulk.number]]\nmeasure = \"circulation\"\nvalue = 0.1\nunit "
               "= \"rad_s\"\n"));
}

TEST_CASE("what is innocent of a bed is the zero of a number measured, or one cause of the library") {
    const auto innocent = [](const std::string& rest) { return whole + "[[nuisance]]\n" + rest; };
    const auto read =
        load(innocent("measure = \"circulation\"\nspread = 0.1\n[[nuisance]]\ncause = \"fric.factor\"\n"));
    REQUIRE_MESSAGE(read, to_string(read.problems()));
    CHECK(read->nuisances.at(0).measure == "circulation");
    CHECK(read->nuisances[0].spread == 0.1);
    CHECK(read->nuisances.at(1).cause == "fric.factor");
    CHECK(read->nuisances[1].spread == 0);
    CHECK(refusal(innocent("key = \"pair.media-lining.friction\"\nspread = 0.1\n")) ==
          "m.toml:17:7: 'key' is a nuisance of records\n    of a bed write measure, a number whose zero is not well "
          "known, or cause, one of the library that is innocent here, such as fric.factor");
    CHECK(refusal(innocent("measure = \"bulk_height\"\n")) ==
          "m.toml:17:11: no [[bulk.number]] is of 'bulk_height'\n    write the measure of a number that is given");
    CHECK(refusal(innocent("cause = \"friction\"\n")) ==
          "m.toml:17:9: 'friction' is a family of causes\n    name one of it, such as fric.factor");
    CHECK(refusal(innocent("cause = \"ins.gain\"\n")) ==
          "m.toml:17:9: ins.gain acts on readings over time, and means of a bed are none\n    leave it out");
    CHECK(refusal(innocent("cause = \"fric.factor\"\nper = \"series\"\n")) ==
          "m.toml:18:7: a cause acts under all conditions alike\n    leave per out");
}

TEST_CASE("records and beds are two measurements, and a bed has no instrument over time") {
    CHECK(refusal("title = \"nothing\"\n") ==
          "m.toml:1:1: the measurement has neither [[series]], [[table]] nor [[bulk]]\n    add [[series]] for what was "
          "read over time, [[table]] for single numbers such as heights of rebounds, or [[bulk]] for means of a bed");
    CHECK(refusal(replaced(whole, "exc.phase", "ins.gain")) ==
          "m.toml:2:10: ins.gain acts on readings over time, and means of a bed are none\n    leave it out");
    CHECK(refusal(whole + "[[bulk]]\nname = \"quarter load\"\nruns = 2\n[[bulk.number]]\nmeasure = \"bodies\"\nvalue = "
                          "7\n") == "m.toml:17:8: there are two [[bulk]] 'quarter load'\n    give each condition its "
                                    "own name, and the mean of runs "
                                    "that repeat each other once, with how many they were (runs)");
}

} // namespace test_read_bulk
