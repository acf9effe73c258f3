#include "about.h"
#include "base/text.h"
#include "synthetic.h"

namespace test_record {

using namespace tumble;
using namespace tumble::excitation;
using namespace tumble::excitation::testing;
using tumble::test::about;

namespace {

/// 100 rows of a sine on ay, time in ms; `broken` may change a row's cells.
template <class Change> std::string rows(const std::string& head, Change change) {
    std::string text = head + "\n";
    for (int k = 0; k < 100; ++k) {
        std::vector<std::string> cells{std::to_string(k), shortest(std::sin(0.7 * k)), shortest(std::cos(0.7 * k))};
        change(k, cells);
        for (std::size_t c = 0; c < cells.size(); ++c)
            text += (c ? "," : "") + cells[c];
        text += "\n";
    }
    return text;
}
const auto as_it_is = [](int, std::vector<std::string>&) {};

std::string only_problem(const std::string& text) {
    const auto record = parse_record(text, "a.csv");
    REQUIRE_FALSE(record.ok());
    REQUIRE(record.problems().size() == 1);
    return to_string(record.problems()[0]);
}

std::string only_warning(const std::string& text) {
    const auto record = parse_record(text, "a.csv");
    REQUIRE_MESSAGE(record.ok(), to_string(record.problems()));
    REQUIRE_MESSAGE(record->warnings.size() == 1, to_string(record->warnings));
    return to_string(record->warnings[0]);
}

} // namespace

TEST_CASE("units in the heads are turned into SI, and the columns may stand in any order") {
    const auto record = parse_record(rows("t_ms,az_g,ay_mm_s2", as_it_is), "a.csv");
    REQUIRE_MESSAGE(record.ok(), to_string(record.problems()));
    REQUIRE(record->channels.size() == 2);
    CHECK(record->warnings.empty());
    CHECK(record->time[5] == about(5e-3));
    CHECK(record->channels[0].axis == 1);
    CHECK(record->channels[0].values[3] == about(1e-3 * std::cos(2.1)));
    CHECK(record->channels[1].values[3] == about(9.80665 * std::sin(2.1)));
}

TEST_CASE("what makes a record useless is told by line, and no record comes back") {
    CHECK(only_problem(rows("t_ms,ay_g,az_g",
                            [](int k, auto& cells) {
                                if (k == 10)
                                    cells[0] = "9";
                            })) ==
          "a.csv:12:1: time 0.009 s does not rise above 0.009 s\n    sort the rows by time, or cut the record "
          "where the clock was set back");
    CHECK(only_problem(rows("t_ms,ay_g,az_g", [](int k, auto& cells) {
              if (k == 3)
                  cells[1] = "nan";
          })).starts_with("a.csv:5:3: 'nan' is not a finite number"));
    CHECK(only_problem(rows("t_ms,ay_g,az_g", [](int, auto& cells) { cells[2] = cells[1]; })) ==
          "a.csv:2:5"
          ": column az_g is equal to column ay_g in every row\n    export the record again, each axis in its own "
          "column");
    CHECK(only_problem(rows("t_s,ay_m_s2,az_g", [](int, auto& cells) {
              cells[1] = cells[0];
          })).find("column ay_m_s2 holds the time") != std::string::npos);
    CHECK(only_problem(rows("t_ms,height_m,az_deg", as_it_is)) ==
          "a.csv:1: no column for az\n    call it az_m_s2 or az_g or az_mm_s2; there are t_ms, height_m, az_deg");
    CHECK(only_problem(rows("t_ms,height_m,width_m", as_it_is)).find("no column of acceleration") != std::string::npos);
    CHECK(only_problem(rows("sample,ay_g,az_g", as_it_is)).find("no column for t\n    call it t_s or t_ms or t_us") !=
          std::string::npos);
    CHECK(only_problem("t_s,ay_g\n0,1\n1,2\n").find("2 rows, too few") != std::string::npos);
}

TEST_CASE("what makes a record doubtful is told by line, and the record comes back") {
    CHECK(only_warning(rows("t_ms,ay_g,az_g", [](int k, auto& cells) {
              if (k > 20)
                  cells[0] = std::to_string(k + 7);
          })).starts_with("a.csv:23:1: 1 gap in time, the longest of 8 ms"));
    CHECK(only_warning(rows("t_ms,ay_g,az_g", [](int k, auto& cells) {
              if (k == 20)
                  cells[0] = "20.2";
          })).find("uneven sampling") != std::string::npos);
    // sin(0.7 k) stays above 0.6 for two or three samples at a time.
    CHECK(only_warning(rows("t_ms,ay_g,az_g", [](int k, auto& cells) {
              cells[1] = shortest(std::min(0.6, std::sin(0.7 * k)));
          })).find("ay stays at its extreme 5.88399 m/s2 for 3 samples: clipped") != std::string::npos);
    CHECK(only_warning(rows("t_ms,ay_g,az_g", [](int k, auto& cells) {
              cells[1] = shortest(std::round(10 * std::sin(0.7 * k)) / 10 + 1e-4 * (k % 2));
          })).find("coarsely quantised") != std::string::npos);
    CHECK(only_warning(rows("t_ms,ay_g,az_g", [](int, auto& cells) { cells[1] = "0"; })).find("dead channel") !=
          std::string::npos);
    CHECK(only_warning(rows("t_ms,ay_m_s2,az_m_s2", [](int k, auto& cells) {
              cells[1] = shortest(1 + std::sin(0.7 * k));
          })).find("gravity, if the numbers are in g") != std::string::npos);
    CHECK(only_warning(rows("t_ms,ay_g,az_g", [](int k, auto& cells) {
              cells[1] = shortest(9.8 + std::sin(0.7 * k));
          })).find("gravity, if the numbers are in m/s2") != std::string::npos);
}

TEST_CASE("two sensors belong together only when they were sampled at the same instants") {
    const Recorder how;
    Record first = recorded({{1, 25, 1e-3, 0}}, how), second = first;
    CHECK(together(first, second)->channels.size() == 6);
    CHECK(together(first, second)->channels[4].name == "ay2");
    second.time[7] += 2e-5;
    REQUIRE_FALSE(together(first, second).ok());
    CHECK(together(first, second).problems()[0].what == "its times are not those of made.csv");
}

TEST_CASE("a written record reads back to the same numbers") {
    const Record made = recorded({{1, 25, 1e-3, 0.4}}, {.noise = 0.1});
    const auto read = parse_record(csv_of(made), "made.csv");
    REQUIRE_MESSAGE(read.ok(), to_string(read.problems()));
    CHECK(read->time == made.time);
    CHECK(read->channels[1].values == made.channels[1].values);
}

} // namespace test_record
