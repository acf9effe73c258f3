#include "about.h"
#include "process.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace test_lesson_command {

using namespace tumble::test;

TEST_CASE("without a name lessons are listed, with one it is walked through, on stdout") {
    const Folder folder;
    const Outcome list = tumble_in(folder, {"lesson"});
    CHECK(list.code == 0);
    CHECK(contains(list.out, "two-discs"));
    CHECK(nlohmann::json::parse(tumble_in(folder, {"lesson", "--json"}).out)[0]["name"] == "two-discs");
    const Outcome walk = tumble_in(folder, {"lesson", "two-discs", "--wall_speed_m_s", "0.2"});
    CHECK(walk.code == 0);
    CHECK(contains(walk.out, "(3.17)"));
    CHECK(contains(walk.out, "v Δt = 0.2 m/s × 0.01 s = 0.002 m"));
    CHECK(contains(walk.out, "`tumble lesson two-discs --wall_speed_m_s 0.2 --answer`"));
    CHECK(walk.err.empty());
}

TEST_CASE("a lesson tells its answer when asked, and its help shows its parameters with their ranges") {
    const Folder folder;
    const Outcome answer = tumble_in(folder, {"lesson", "two-discs", "--answer"});
    CHECK(answer.code == 0);
    CHECK(contains(answer.out, "By 8:"));
    const Outcome help = tumble_in(folder, {"lesson", "friction", "--help"});
    CHECK(help.code == 0);
    CHECK(help.out.starts_with("Example: tumble lesson friction --friction 0.3"));
    CHECK(contains(help.out, "0.05 to 1"));
}

TEST_CASE("a name, a flag or a value that no lesson takes is told with the right one and exit code 2") {
    const Folder folder;
    const Outcome name = tumble_in(folder, {"lesson", "two-disk"});
    CHECK(name.code == 2);
    CHECK(contains(name.err, "there is no lesson 'two-disk'"));
    CHECK(contains(name.err, "did you mean 'two-discs'?"));
    const Outcome flag = tumble_in(folder, {"lesson", "friction", "--fricton", "0.2"});
    CHECK(flag.code == 2);
    CHECK(contains(flag.err, "`tumble lesson friction` has no flag '--fricton'"));
    CHECK(contains(flag.err, "did you mean '--friction'?"));
    const Outcome nowhere = tumble_in(folder, {"lesson", "friction", "--out", ""});
    CHECK(nowhere.code == 2);
    CHECK(contains(nowhere.err, "an empty name is not a place to write to"));
    const Outcome early = tumble_in(folder, {"lesson", "--answer", "friction"});
    CHECK(early.code == 2);
    CHECK(contains(early.err, "--answer stands before the name that it belongs to"));
    CHECK(contains(early.err, "write it behind: tumble lesson friction --answer"));
    const Outcome value = tumble_in(folder, {"lesson", "friction", "--friction", "7"});
    CHECK(value.code == 2);
    CHECK(contains(value.err, "--friction is 7, out of its range"));
    CHECK(contains(value.err, "0.05 to 1"));
    for (const Outcome& outcome : {name, flag, value})
        CHECK(outcome.out.empty());
}

TEST_CASE("an absurd value is one problem with the range beside it, exit code 2 and nothing on stdout") {
    const Folder folder;
    struct Absurd {
        std::vector<std::string> words;
        std::string said;
    };
    const std::vector<Absurd> all{
        {{"clumps", "--radius_mm", "-1"}, "--radius_mm is -1, out of its range\n    mm, 2 to 100\n"},
        {{"clumps", "--radius_mm=-1"}, "--radius_mm is -1, out of its range\n    mm, 2 to 100\n"},
        {{"clumps", "--radius_mm", "0"}, "--radius_mm is 0, out of its range\n    mm, 2 to 100\n"},
        {{"repose", "--count", "1e99"}, "--count is 1e+99, out of its range\n    60 to 800\n"},
        {{"friction", "--friction", "nan"}, "--friction takes a number, not 'nan'\n    0.05 to 1\n"},
        {{"friction", "--friction", "inf"}, "--friction takes a number, not 'inf'\n    0.05 to 1\n"},
        {{"friction", "--friction", "1e999"}, "--friction takes a number, not '1e999'\n    0.05 to 1\n"},
        {{"friction", "--friction", "0,3"}, "--friction takes a number, not '0,3'\n    0.05 to 1\n"},
        {{"friction", "--friction", ""}, "--friction takes a number, not ''\n    0.05 to 1\n"},
    };
    for (const Absurd& one : all) {
        CAPTURE(one.said);
        std::vector<std::string> words{"lesson"};
        words.insert(words.end(), one.words.begin(), one.words.end());
        const Outcome outcome = tumble_in(folder, words);
        CHECK(outcome.code == 2);
        CHECK(outcome.err == "error: " + one.said);
        CHECK(outcome.out.empty());
    }
}

TEST_CASE("several wrong values are told at once, each of them once, in the order of the lesson's parameters") {
    const Folder folder;
    const Outcome outcome =
        tumble_in(folder, {"lesson", "soft-and-hard", "--friction", "-1", "--speed_m_s", "fast", "--restitution", "2"});
    CHECK(outcome.code == 2);
    CHECK(outcome.err == "error: --restitution is 2, out of its range\n    0.05 to 1\n"
                         "error: --friction is -1, out of its range\n    0.05 to 1\n"
                         "error: --speed_m_s takes a number, not 'fast'\n    m/s, 0.1 to 2\n");
}

TEST_CASE("a flag that another lesson has, one without its value, or a second lesson is told, and nothing is walked") {
    const Folder folder;
    for (const auto& [words, said] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"lesson", "two-discs", "--steps", "1e99"}, "`tumble lesson two-discs` has no flag '--steps'"},
             {{"lesson", "two-discs", "--radius", "-1"}, "`tumble lesson two-discs` has no flag '--radius'"},
             {{"lesson", "friction", "--friction"}, "--friction"},
             {{"lesson", "friction", "repose"}, "repose"},
             {{"lesson", "sofd-and-hard"}, "did you mean 'soft-and-hard'?"},
             {{"lesson", "quicksort"}, "there is no lesson 'quicksort'\n    `tumble lesson` lists all there are"}}) {
        CAPTURE(said);
        const Outcome outcome = tumble_in(folder, words);
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.err, said));
        CHECK(outcome.out.empty());
    }
}

TEST_CASE("a lesson as JSON carries its facts and the data of its curves") {
    const Folder folder;
    const auto json = nlohmann::json::parse(tumble_in(folder, {"lesson", "two-discs", "--json"}).out);
    CHECK(json["facts"]["overlap_a_t1"]["value"].get<double>() == about(0.001));
    CHECK(json["facts"]["overlap_a_t1"]["unit"] == "m");
    std::size_t points = 0;
    for (const auto& part : json["parts"])
        if (part.contains("curves"))
            points += part["curves"][0]["x"].size();
    CHECK(points > 0);
}

TEST_CASE("without gnuplot --out says what to install, and the exit code is 1") {
    const Folder folder;
    const Outcome outcome = tumble_in(folder, {"lesson", "two-discs", "--out", "figures"}, {"PATH=/nowhere"});
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "apt install gnuplot-nox"));
}

} // namespace test_lesson_command
