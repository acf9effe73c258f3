#include "about.h"
#include "diagnose/measurement.h"
#include "folder.h"

#include <cmath>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <set>

namespace test_measurement {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;

namespace {

std::string rows(const std::vector<double>& values, const std::string& head = "time_s,height_mm") {
    std::string csv = head + "\n";
    for (std::size_t k = 0; k < values.size(); ++k)
        csv += fmt::format("{},{}\n", 0.01 * static_cast<double>(k), values[k]);
    return csv;
}

const std::vector<double> falling{200, 199.5, 198, 195.5, 192.1, 187.7, 182.3, 175.9, 168.6, 160.2};

const std::string whole = R"(title = "a drop"
[[nuisance]]
key = "pair.leather-wood.restitution"
spread = 0.05
[[series]]
name = "low"
file = "low.csv"
[[series.column]]
head = "height"
measure = "centre_of_mass_y"
sigma = 1.5
)";

struct Laboratory {
    test::Folder folder;

    Result<Measurement> load(const std::string& toml, const std::string& csv) const {
        test::put(folder.path / "m.toml", toml);
        test::put(folder.path / "low.csv", csv);
        return load_measurement(folder.path / "m.toml");
    }
    /// The only problem, with the folder left out of its text.
    std::string refusal(const std::string& toml, const std::string& csv) const {
        const auto read = load(toml, csv);
        REQUIRE(!read);
        REQUIRE(read.problems().size() == 1);
        std::string text = to_string(read.problems()[0]);
        const std::string here = folder.path.string() + "/";
        for (std::size_t at; (at = text.find(here)) != std::string::npos;)
            text.erase(at, here.size());
        return text;
    }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
}

bool warns(const Measurement& measurement, const std::string& name) {
    for (const Problem& warning : measurement.warnings)
        if (warning.key == name)
            return true;
    return false;
}

} // namespace

TEST_CASE("a measurement is read into SI, its sigma with its column's unit") {
    const Laboratory laboratory;
    const auto read = laboratory.load(whole, rows(falling));
    REQUIRE(read);
    const Record& record = read->records.at(0);
    CHECK(record.condition == "low");
    CHECK(record.time[3] == about(0.03));
    CHECK(record.channels.at(0).value[1] == about(0.1995));
    CHECK(record.channels[0].sigma == about(0.0015));
    CHECK(read->nuisances.at(0).spread == 0.05);
    CHECK(read->warnings.empty());
}

TEST_CASE("what is wrong with a measurement is told with its place and what to do") {
    const Laboratory laboratory;
    const auto says = [&](const std::string& toml, const std::string& csv, const std::string& start) {
        const std::string text = laboratory.refusal(toml, csv);
        CAPTURE(text);
        CHECK(text.starts_with(start));
    };
    const std::string good = rows(falling);
    says(replaced(whole, "sigma", "sigmma"), good, "m.toml:11:1: [[series.column]] has no key 'sigmma'");
    says(replaced(whole, "low.csv", "high.csv"), good, "m.toml:7:8: high.csv");
    says(replaced(whole, "centre_of_mass_y", "centre_of_mas_y"), good,
         "m.toml:10:11: there is no measure 'centre_of_mas_y'");
    says(replaced(whole, "\"height\"", "\"depth\""), good, "low.csv:1: no column for depth");
    says(replaced(whole, "sigma = 1.5", "sigma = -1"), good, "m.toml:11:9: 'sigma' = -1 is out of range");
    says("causes = [\"ins.gian\"]\n" + whole, good, "m.toml:1:10: there is no cause and no family 'ins.gian'");
    says(replaced(whole, "key = ", "instrument = \"gain\"\nkey = "), good,
         "m.toml:2:1: [[nuisance]] has 2 of key or instrument or measure or cause");
}

TEST_CASE("time that does not rise, numbers that are none and records stored twice are refused") {
    const Laboratory laboratory;
    std::string back = rows(falling);
    back = replaced(back, "0.05,", "0.02,");
    CHECK(laboratory.refusal(whole, back).starts_with("low.csv:7:1: time does not rise: 0.02 after 0.04"));
    CHECK(laboratory.refusal(whole, replaced(rows(falling), "195.5", "nan")).starts_with("low.csv:5:"));
    CHECK(laboratory.refusal("causes = [\"drag\"]\n" + whole, rows(falling)).find("did you mean 'drag.quadratic'?") !=
          std::string::npos);
    const std::string again = whole + "[[series]]\nname = \"twin\"\nfile = \"low.csv\"\n[[series.column]]\nhead = "
                                      "\"height\"\nmeasure = \"centre_of_mass_y\"\nsigma = 1.5\n";
    CHECK(laboratory.refusal(again, rows(falling)).find("the same numbers") != std::string::npos);
}

TEST_CASE("what a reader should know is a warning: gaps, coarse steps, clipped ends, a sigma that is not stated") {
    const Laboratory laboratory;
    std::string gap = rows(falling);
    gap = replaced(gap, "0.05,187.7\n", "");
    CHECK(warns(*laboratory.load(whole, gap), "gaps"));
    CHECK(warns(*laboratory.load(replaced(whole, "sigma = 1.5\n", ""), rows(falling)), "sigma missing"));
    std::vector<double> clipped = falling;
    clipped[0] = clipped[1] = clipped[2] = 198;
    CHECK(warns(*laboratory.load(whole, rows(clipped)), "clipped"));
    // In steps of a third of sigma two readings at rest are equal in 9 % of cases: three say nothing, six do.
    std::vector<double> stepped{200, 200, 200, 199.5, 199, 197.5, 196, 193.5, 190.5, 187, 182.5, 178};
    CHECK(!warns(*laboratory.load(whole, rows(stepped)), "clipped"));
    stepped.insert(stepped.begin(), 3, 200);
    CHECK(warns(*laboratory.load(whole, rows(stepped)), "clipped"));
    // The same where steps are printed with too few digits to add up: 0.123 mm, as 0.12, 0.25, 0.37, ...
    std::vector<double> printed{1626, 1626, 1626};
    for (int k = 1; k < 56; ++k)
        printed.push_back(1626 - k * (k + 1) / 2);
    for (double& one : printed)
        one = std::round(100 * 0.123 * one) / 100;
    CHECK(!warns(*laboratory.load(replaced(whole, "sigma = 1.5", "sigma = 0.4"), rows(printed)), "clipped"));
    const std::vector<double> coarse{3, 3, 2, 2, 1, 1, 2, 2, 3, 3, 1, 2, 3, 2, 1};
    CHECK(warns(*laboratory.load(whole, rows(coarse)), "quantised"));
}

TEST_CASE("each bad input has its answer: place, what is wrong, what to do") {
    const Laboratory laboratory;
    const std::string good = rows(falling);
    CHECK(laboratory.refusal(whole, replaced(good, "0.05,", "0.02,")) ==
          "low.csv:7:1: time does not rise: 0.02 after 0.04\n    sort the rows by time and leave one of each instant");
    CHECK(laboratory.refusal(whole, replaced(good, "195.5", "nan")) ==
          "low.csv:5:6: 'nan' is not a finite number\n    write a decimal number such as 12, -0.5 or 2.5e-3");
    CHECK(laboratory.refusal(replaced(whole, "low.csv", "high.csv"), good) ==
          "m.toml:7:8: high.csv there is no such file\n    give the CSV file's name as seen from this file's folder");
    CHECK(laboratory.refusal("causes = [\"ins.gian\"]\n" + whole, good) ==
          "m.toml:1:10: there is no cause and no family 'ins.gian'\n    did you mean 'ins.gain'? `tumble list causes` "
          "names all of "
          "them");
    const std::string again = whole + "[[series]]\nname = \"twin\"\nfile = \"low.csv\"\n[[series.column]]\nhead = "
                                      "\"height\"\nmeasure = \"centre_of_mass_y\"\nsigma = 1.5\n";
    CHECK(laboratory.refusal(again, good) ==
          "low.csv: height_mm of 'twin' holds the same numbers as height_mm of 'low' (low.csv)\n    "
          "store each record once, under its own name");
    CHECK(laboratory.refusal(replaced(again, "\"twin\"", "\"low\""), good)
              .starts_with("m.toml:13:8: there are two [[series]] 'low'\n    give each its own name; of repeats the "
                           "same condition"));
    const auto warning = [&](const std::string& toml, const std::vector<double>& values) {
        const auto read = laboratory.load(toml, rows(values));
        REQUIRE(read);
        REQUIRE(read->warnings.size() == 1);
        return read->warnings[0].key + ": " + read->warnings[0].what + "; " + read->warnings[0].fix;
    };
    std::vector<double> clipped = falling;
    clipped[0] = clipped[1] = clipped[2] = 198.5;
    CHECK(warning(whole, clipped) ==
          "clipped: height_mm: 3 equal readings in a row at the end of the range; the sensor "
          "was at its limit: choose a larger range");
    CHECK(
        warning(whole, {3, 3, 2, 2, 1, 1, 2, 2, 3, 3, 1, 2, 3, 2, 1}) ==
        "quantised: height_mm: only 3 different readings, in steps of 0.001 m (ins.quant); record with more digits; a "
        "step adds a scatter of step / sqrt(12), which the scatter found contains");
    // A long fall has many levels; its steps are coarse all the same where they are above sigma, 1.5 mm.
    std::vector<double> coarse, fine;
    for (int k = 0; k < 200; ++k) {
        coarse.push_back(10 * std::round((2000 - 0.05 * k * k) / 10));
        fine.push_back(std::round(2000 - 0.05 * k * k));
    }
    const auto levels = std::set<double>(coarse.begin(), coarse.end()).size();
    CHECK(levels > 50);
    CHECK(warning(whole, coarse)
              .starts_with("quantised: height_mm: only " + std::to_string(levels) +
                           " different readings, in steps of 0.01 m (ins.quant)"));
    const auto read = laboratory.load(whole, rows(fine));
    REQUIRE(read);
    for (const Problem& told : read->warnings)
        CHECK(told.key != "quantised");
    CHECK(warning(replaced(whole, "sigma = 1.5\n", ""), falling) ==
          "sigma missing: height_mm: its scatter is not stated; give sigma; it is estimated from the residual instead");
}

TEST_CASE("lost readings that were written as a number are refused; what falls to that number is no loss") {
    const Laboratory laboratory;
    std::vector<double> lost, landed;
    for (int k = 0; k < 60; ++k) {
        const double height = 500 + 300 * std::cos(0.1 * k) + 0.3 * std::sin(7.0 * k);
        lost.push_back(k >= 20 && k < 24 ? 0 : height);
        landed.push_back(std::max(400.0, height));
    }
    CHECK(laboratory.refusal(whole, rows(lost)) ==
          "low.csv: height_mm is 0 m in 4 readings far from all others (at 0.2 to 0.23 s): lost readings?\n    leave "
          "those rows out: what was not read is no reading");
    std::vector<double> here_and_there = lost;
    for (std::size_t k = 20; k < 24; ++k)
        here_and_there[k] = landed[k];
    for (const std::size_t k : {5, 17, 31, 50})
        here_and_there[k] = -999;
    CHECK(laboratory.refusal(whole, rows(here_and_there))
              .starts_with(
                  "low.csv: height_mm is -0.999 m in 4 readings far from all others (at 0.05 s, 0.17 s, 0.31 s, ...)"));
    const auto read = laboratory.load(whole, rows(landed));
    REQUIRE_MESSAGE(read, to_string(read.problems()));
    CHECK(warns(*read, "clipped"));
    // A sensor that is cut off at a number of its own is no lost reading, and neither is a speed that ends at 0.
    std::vector<double> spikes = landed;
    for (const std::size_t k : {9, 22, 35, 48})
        spikes[k] = 1569.06;
    CHECK(laboratory.load(whole, rows(spikes)));
    std::vector<double> gone = lost;
    for (std::size_t k = 54; k < 60; ++k)
        gone[k] = 0;
    CHECK(laboratory.refusal(whole, rows(gone)).find("in 10 readings far from all others (at 0.2 to 0.23 s, 0.54 to") !=
          std::string::npos);
}

TEST_CASE("series of one set are of one condition, unless each has a number of the scene of its own") {
    const Laboratory laboratory;
    std::vector<double> again;
    for (std::size_t k = 0; k < falling.size(); ++k)
        again.push_back(falling[k] + (k % 2 ? 0.4 : -0.3));
    const auto second_condition = [&](const std::string& toml, const std::string& more = "") {
        test::put(laboratory.folder.path / "second.csv", rows(again));
        const auto read =
            laboratory.load(toml + "[[series]]\nname = \"second\"\nfile = \"second.csv\"\n" + more +
                                "[[series.column]]\nhead = \"height\"\nmeasure = \"centre_of_mass_y\"\nsigma = 1.5\n",
                            rows(falling));
        REQUIRE_MESSAGE(read, to_string(read.problems()));
        return read->records[1].condition;
    };
    CHECK(second_condition(whole) == "low");
    CHECK(second_condition(whole, "held_out = true\n") == "second");
    CHECK(second_condition(replaced(whole, "low.csv\"", "low.csv\"\nset = [\"a.b=1\"]")) == "second");
    CHECK(second_condition(replaced(whole, "spread = 0.05", "spread = 0.05\nper = \"series\"")) == "second");
}

} // namespace test_measurement
