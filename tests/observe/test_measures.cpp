#include "about.h"
#include "frames.h"
#include "observe/measures.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <set>

namespace test_measures {

using namespace tumble;
using namespace tumble::test;

namespace {

double measured(const std::string& name, const observe::Seen& seen) {
    const auto chosen = observe::choose_measures({name});
    REQUIRE(chosen.ok());
    REQUIRE(chosen->size() == 1);
    return chosen->front().value(seen);
}

} // namespace

TEST_CASE("every measure has its own name and column, a sentence and a value") {
    std::set<std::string> names;
    std::set<std::string> columns;
    observe::Frame frame;
    frame.layout = open_layout(ball(0.01, 1));
    add_body(frame, {0, 0, 0});
    const Books books;
    const observe::Seen seen(frame, books);
    for (const observe::Measure& measure : observe::all_measures()) {
        CHECK_MESSAGE(names.insert(measure.name).second, measure.name);
        CHECK_MESSAGE(columns.insert(measure.column()).second, measure.column());
        CHECK_MESSAGE(measure.sentence.ends_with("."), measure.name);
        const bool callable = measure.value != nullptr;
        REQUIRE_MESSAGE(callable, measure.name);
        CHECK_NOTHROW(measure.value(seen));
    }
    for (const observe::Measure& measure : observe::all_measures())
        CHECK_MESSAGE(names.count(measure.group) == 0, "a group must not be named like a measure: " << measure.group);
}

TEST_CASE("the solver's books come through under their names") {
    observe::Frame frame;
    frame.layout = open_layout(ball(0.01, 1));
    add_body(frame, {0, 0, 0}, {0, 3, 0});
    Books books;
    books.bodies = 4;
    books.contacts = 10;
    books.overlap_max = 1e-6;
    books.closure = -2e-12;
    books.wall_work = 7;
    books.speed_max = 3;
    const observe::Seen seen(frame, books);
    CHECK(measured("contacts_per_body", seen) == 2.5);
    CHECK(measured("overlap_max", seen) == 1e-6);
    CHECK(measured("energy_closure", seen) == -2e-12);
    CHECK(measured("wall_work", seen) == 7);
    CHECK(measured("speed_max", seen) == 3);
    CHECK(measured("kinetic_energy", seen) == about(4.5));
}

TEST_CASE("read along axes that are turned, a centre of mass keeps its distance and its height gives some to x") {
    observe::Frame frame;
    frame.layout = open_layout(ball(0.01, 1));
    add_body(frame, {3, 4, 0.5});
    const Books books;
    const double turned = 0.1;
    const observe::Seen upright(frame, books), leaning(frame, books, turned);
    CHECK(measured("centre_of_mass_x", upright) == 3);
    CHECK(measured("centre_of_mass_x", leaning) == about(3 * std::cos(turned) + 4 * std::sin(turned)));
    CHECK(measured("centre_of_mass_y", leaning) == about(4 * std::cos(turned) - 3 * std::sin(turned)));
    CHECK(measured("centre_of_mass_z", leaning) == 0.5);
    CHECK(measured("kinetic_energy", leaning) == measured("kinetic_energy", upright));
}

TEST_CASE("a group brings all its measures, and none comes twice") {
    const auto chosen = observe::choose_measures({"centre_of_mass_y", "centre_of_mass", "centre_of_mass_z"});
    REQUIRE(chosen.ok());
    std::vector<std::string> columns;
    for (const observe::Measure& measure : *chosen)
        columns.push_back(measure.column());
    CHECK(columns == std::vector<std::string>{"centre_of_mass_y_m", "centre_of_mass_x_m", "centre_of_mass_z_m"});
}

TEST_CASE("no names mean the usual measures, which exist and hold what the energy balance needs") {
    const auto chosen = observe::choose_measures({});
    REQUIRE(chosen.ok());
    std::set<std::string> columns;
    for (const observe::Measure& measure : *chosen)
        columns.insert(measure.column());
    for (const char* needed : {"kinetic_translation_J", "kinetic_rotation_J", "circulation_rad_s", "surface_slope_deg",
                               "overlap_max_m", "contacts", "energy_closure_J", "centre_of_mass_y_m"})
        CHECK_MESSAGE(columns.count(needed) == 1, needed);
}

TEST_CASE("every unknown measure is reported, with the nearest that exists") {
    const auto chosen = observe::choose_measures({"circulaton", "mean_speed", "xyzzy"});
    REQUIRE_FALSE(chosen.ok());
    const Problems problems = chosen.problems();
    REQUIRE(problems.size() == 2);
    CHECK(problems[0].what == "there is no measure 'circulaton'");
    CHECK(problems[0].key == "observe.measures");
    CHECK(problems[0].fix == "did you mean 'circulation'? `tumble list measures` names all of them");
    CHECK(problems[1].fix == "`tumble list measures` names all of them");
}

TEST_CASE("names and units are spelled for people") {
    CHECK(observe::spelled_name("kinetic_energy") == "kinetic energy");
    CHECK(observe::spelled_unit("rad_s") == "rad/s");
    CHECK(observe::spelled_unit("m_s") == "m/s");
    CHECK(observe::spelled_unit("m_s2") == "m/s2");
    CHECK(observe::spelled_unit("deg") == "deg");
    CHECK(observe::spelled_unit("").empty());
}

TEST_CASE("docs/measures.md defines every measure and names its group") {
    const std::string page = content_of(std::filesystem::path(TUMBLE_ROOT) / "docs" / "measures.md");
    for (const observe::Measure& measure : observe::all_measures()) {
        CHECK_MESSAGE(page.find("`" + measure.name + "`") != std::string::npos, measure.name);
        if (!measure.group.empty())
            CHECK_MESSAGE(page.find("`" + measure.group + "`") != std::string::npos, measure.group);
    }
}

TEST_CASE("docs/measures.md names the usual measures in the order they are written") {
    std::string list;
    for (const std::string& name : observe::usual_measures())
        list += (list.empty() ? "`" : ", `") + name + "`";
    std::string page = content_of(TUMBLE_ROOT "/docs/measures.md");
    std::replace(page.begin(), page.end(), '\n', ' ');
    CHECK(page.find(list) != std::string::npos);
}

} // namespace test_measures
