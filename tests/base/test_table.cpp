#include "base/table.h"
#include "base/text.h"

#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace test_table {

using namespace tumble;

namespace {

Table table_of(const std::string& text) {
    auto table = parse_table(text, "t.csv");
    REQUIRE_MESSAGE(table.ok(), to_string(table.problems()));
    return *table;
}

std::string problems_of(const std::string& text, const TableLimits& limits = {}) {
    return to_string(parse_table(text, "t.csv", limits).problems());
}

const std::vector<Unit> lengths{{"m", 1}, {"mm", 1e-3}};

} // namespace

TEST_CASE("a table is a head line and rows of as many cells") {
    const Table table = table_of("# source: nobody\n\ntime_s, name\n0,a\n  # between\n1.5 ,\tb c\r\n2,");
    CHECK(table.heads() == std::vector<std::string>{"time_s", "name"});
    CHECK(table.rows() == 3);
    CHECK(table.cell(1, 1) == "b c");
    CHECK(table.cell(2, 1).empty());
    CHECK(*table.numbers("time_s") == std::vector<double>{0, 1.5, 2});
}

TEST_CASE("quoted cells keep commas, blanks, quotes and number signs") {
    const Table table = table_of("\"a,b\",c\n\" x \",\"say \"\"no\"\"\"\n\"#1\" , \"\"\n");
    CHECK(table.heads()[0] == "a,b");
    CHECK(table.cell(0, 0) == " x ");
    CHECK(table.cell(0, 1) == "say \"no\"");
    CHECK(table.cell(1, 0) == "#1");
    CHECK(table.cell(1, 1).empty());
}

TEST_CASE("a byte order mark is no part of the first head") {
    CHECK(table_of("\xef\xbb\xbfx,y\n1,2\n").heads()[0] == "x");
}

TEST_CASE("a table without rows is a table") {
    CHECK(table_of("x,y").rows() == 0);
    CHECK(table_of("x,y").numbers("x")->empty());
}

TEST_CASE("quantities are scaled to SI by the unit in the head") {
    const Table table = table_of("depth_mm,width_m\n2,3\n");
    CHECK(table.quantity("depth", lengths)->at(0) == 2e-3);
    CHECK(table.quantity("width", lengths)->at(0) == 3.0);
    CHECK(to_string(table.quantity("height", lengths).problems()) ==
          "t.csv:1: no column for height\n    call it height_m or height_mm; there are depth_mm, width_m\n");
    CHECK(to_string(table.quantity("depth_mm", lengths).problems()) ==
          "t.csv:1: no column for depth_mm\n    leave the unit out of the name: \"depth\"\n");
    CHECK(table.quantity("dpeth", lengths).problems()[0].fix == "did you mean 'depth'?");
    const Table gap = table_of("width_m\n2\n\"\"\n");
    CHECK(to_string(gap.quantity("width", lengths).problems()) ==
          "t.csv:3:1: an empty cell is no number\n    give the number, or leave the row out\n");
    const Table written = table_of("width_m,t_s\n\"2,5\",00:00:01\n");
    CHECK(written.quantity("width", lengths).problems()[0].fix == "write a point, not a comma, before decimals");
    CHECK(written.numbers("t_s").problems()[0].fix == "write a time of day as one number of seconds");
    const auto european = parse_table("height_m;width_m\n2,5;3\n2,5;4\n", "t.csv");
    REQUIRE(!european);
    CHECK(to_string(european.problems()) == "t.csv:1: columns are separated by semicolons or tabs\n"
                                            "    separate them by commas, and write numbers with a decimal point\n");
}

TEST_CASE("a missing column is named with the one that was probably meant") {
    const Table table = table_of("# c\ntime_s,speed_m_s\n0,1\n");
    CHECK(to_string(table.numbers("sped_m_s").problems()) ==
          "t.csv:2: no column 'sped_m_s'\n    did you mean 'speed_m_s'?\n");
    CHECK(to_string(table.numbers("mass").problems()) ==
          "t.csv:2: no column 'mass'\n    the columns are time_s, speed_m_s\n");
}

TEST_CASE("every cell that is no number is named by line and column, at most twenty") {
    const Table table = table_of("x,y\n1,2\n3,four\n5,nan\n");
    CHECK(to_string(table.numbers("y").problems()) ==
          "t.csv:3:3: 'four' is not a number\n    write a decimal number such as 12, -0.5 or 2.5e-3\n"
          "t.csv:4:3: 'nan' is not a finite number\n    write a decimal number such as 12, -0.5 or 2.5e-3\n");
    CHECK(table.numbers("y").problems()[0].key == "y");
    std::string many = "x\n";
    for (int i = 0; i < 100; ++i)
        many += "?\n";
    CHECK(table_of(many).numbers("x").problems().size() == 20);
}

TEST_CASE("broken tables say where and what to do") {
    CHECK(problems_of("") ==
          "t.csv: no head line: the file is empty\n    begin with a line of column heads, such as time_s,speed_m_s\n");
    CHECK(problems_of("x,y\n1\n1,2,3\n") ==
          "t.csv:2:1: 1 cells where the head line has 2\n    give every row as many cells as the head line\n"
          "t.csv:3:5: 3 cells where the head line has 2\n    give every row as many cells as the head line\n");
    CHECK(problems_of("x,,x\n") == "t.csv:1:3: a column without a head\n    name it, unit included\n"
                                   "t.csv:1:4: two columns are called 'x'\n    give each column its own head\n");
    CHECK(problems_of("x,y\n1, \"2\n3\"\n").starts_with("t.csv:2:4: a quote that is not closed on its line\n"));
    CHECK(problems_of("x,y\n\"1\"2,3\n") == "t.csv:2:4: text behind a closed quote\n    put ',' between cells\n");
    CHECK(problems_of(std::string("x\n12\0", 5)).starts_with("t.csv:2:3: a NUL byte"));
}

TEST_CASE("more than the limits allow is refused, exactly at the limit is not") {
    CHECK(problems_of("x\n1\n2\n", {.rows = 2}).empty());
    CHECK(problems_of("x\n1\n2\n3\n4\n", {.rows = 2}) == "t.csv:4: more than 2 rows\n    leave rows out\n");
    CHECK(problems_of("x,y\n", {.columns = 2}).empty());
    CHECK(problems_of("x,y,z\n", {.columns = 2}).starts_with("t.csv:1:5: more than 2 cells in a line\n"));
    CHECK(problems_of("x\n1\n", {.bytes = 4}).empty());
    CHECK(problems_of("x\n12\n", {.bytes = 4}).starts_with("t.csv: 5 bytes are more than a table may have\n"));
}

TEST_CASE("what is written reads back the same") {
    const std::vector<std::string> heads{"plain", "with, comma", "a \"word\"", " outer ", "#first"};
    const std::vector<double> numbers{0.1, 1.0 / 3.0, -0.0, 5e-324, 1e300};
    const Table table = table_of(csv_line(heads) + csv_line(numbers));
    CHECK(table.heads() == heads);
    for (std::size_t i = 0; i < heads.size(); ++i)
        CHECK(table.numbers(heads[i])->at(0) == numbers[i]);
    CHECK(csv_line(numbers) == "0.1,0.3333333333333333,-0,5e-324,1e+300\n");
    CHECK(table_of("x\n" + csv_line(std::vector<std::string>{""})).rows() == 1);
    const std::vector<std::string> marked{"\xef\xbb\xbfx"};
    CHECK(table_of(csv_line(marked)).heads() == marked);
    const std::vector<std::string> awkward{"", "two\nlines"};
    CHECK(csv_line(awkward) == ",\"two lines\"\n");
}

} // namespace test_table
