#include "frames.h"
#include "observe/series.h"

#include <doctest/doctest.h>
#include <limits>

namespace test_series {

using namespace tumble;
using namespace tumble::test;

TEST_CASE("a series reads back to the same bits, with its heads") {
    const Folder folder;
    const auto file = folder.path / "series.csv";
    {
        auto writer = observe::SeriesWriter::create(file, {"time_s", "kinetic_energy_J", "contacts"});
        REQUIRE(writer.ok());
        REQUIRE(writer->write({0, 1.0 / 3, 12}).ok());
        REQUIRE(writer->write({0.1, std::numeric_limits<double>::quiet_NaN(), -5e-324}).ok());
    }
    CHECK(content_of(file).starts_with("time_s,kinetic_energy_J,contacts\n0,0.3333333333333333,12\n0.1,nan,"));
    const auto series = observe::read_series(file);
    REQUIRE(series.ok());
    REQUIRE(series->rows() == 2);
    CHECK(series->values[1][0] == 1.0 / 3);
    CHECK(std::isnan(series->values[1][1]));
    CHECK(series->values[2][1] == -5e-324);
    REQUIRE(series->find("kinetic_energy") != nullptr);
    CHECK(series->find("kinetic_energy") == series->find("kinetic_energy_J"));
    CHECK(series->find("kinetic") == nullptr);
}

TEST_CASE("rows are on the disk before the writer is closed") {
    const Folder folder;
    auto writer = observe::SeriesWriter::create(folder.path / "s.csv", {"time_s", "x_m"});
    REQUIRE(writer.ok());
    REQUIRE(writer->write({0, 1}).ok());
    REQUIRE(writer->write({1, -0.0}).ok());
    CHECK(content_of(folder.path / "s.csv") == "time_s,x_m\n0,1\n1,0\n"); // no "-0"
}

TEST_CASE("a line torn by a kill is left out") {
    const Folder folder;
    put(folder.path / "s.csv", "time_s,x_m\n0,1\n0.1,2\n0.2,3.1");
    const auto series = observe::read_series(folder.path / "s.csv");
    REQUIRE(series.ok());
    CHECK(series->rows() == 2);
}

TEST_CASE("every broken row is reported with its line") {
    const Folder folder;
    put(folder.path / "s.csv", "time_s,x_m\n0,1\n0.1\n0.2,abc\n");
    const auto series = observe::read_series(folder.path / "s.csv");
    REQUIRE_FALSE(series.ok());
    const Problems problems = series.problems();
    REQUIRE(problems.size() == 2);
    CHECK(problems[0].line == 3);
    CHECK(problems[0].what == "1 numbers for 2 columns");
    CHECK(problems[1].line == 4);
    CHECK(problems[1].what == "'abc' in column x_m is no number");
}

TEST_CASE("a full disk, a missing folder and a wrong row are problems") {
    const Folder folder;
    CHECK_FALSE(observe::SeriesWriter::create(folder.path / "none" / "s.csv", {"time_s"}).ok());
    auto writer = observe::SeriesWriter::create(folder.path / "s.csv", {"time_s"});
    REQUIRE(writer.ok());
    CHECK_FALSE(writer->write({1, 2}).ok());
    const auto full = observe::SeriesWriter::create("/dev/full", {"time_s"});
    REQUIRE_FALSE(full.ok());
    CHECK(full.problems()[0].what == "cannot be written: No space left on device");
    CHECK_FALSE(observe::read_series(folder.path / "none.csv").ok());
}

TEST_CASE("a series goes on behind the rows that it is said to have, and only under its own head") {
    const Folder folder;
    const auto file = folder.path / "s.csv";
    put(file, "time_s,x_m\n0,1\n0.1,2\n0.2,3\n0.3,");
    {
        auto writer = observe::SeriesWriter::go_on(file, {"time_s", "x_m"}, 21);
        REQUIRE(writer.ok());
        REQUIRE(writer->write({0.5, 7}).ok());
        CHECK(writer->size() == 27);
    }
    CHECK(content_of(file) == "time_s,x_m\n0,1\n0.1,2\n0.5,7\n");
    CHECK_FALSE(observe::SeriesWriter::go_on(file, {"time_s", "x_m"}, 100).ok()); // shorter than that
    CHECK_FALSE(observe::SeriesWriter::go_on(file, {"time_s", "y_m"}, 15).ok());
    CHECK_FALSE(observe::SeriesWriter::go_on(folder.path / "none.csv", {"time_s"}, 7).ok());
    CHECK(content_of(file).size() == 27);
}

} // namespace test_series
