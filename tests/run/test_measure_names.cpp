#include "about.h"
#include "observe/series.h"
#include "resumed.h"
#include "run/measure_names.h"
#include "run/redraw.h"
#include "scenes.h"

namespace test_measure_names {

using namespace tumble;
using namespace tumble::test;

namespace {

Result<run::Plotted> plotted(const std::string& name, const std::vector<std::string>& traced) {
    scene::Render settings;
    settings.plot_measure = name;
    return run::find_plotted(settings, traced);
}

} // namespace

TEST_CASE("the small plot takes a measure and a tracer's column by name, and by the head they have in series.csv") {
    for (const std::string name : {"tracer:sensor_point_vy", "tracer:sensor_point_vy_m_s"}) {
        const auto found = plotted(name, {"cone", "sensor"});
        REQUIRE(found.ok());
        CHECK(found->column == "tracer:sensor_point_vy_m_s");
        CHECK(found->label == "sensor point vy");
        CHECK(found->unit == "m/s");
        CHECK_FALSE(found->measure);
    }
    for (const std::string name : {"circulation", "circulation_rad_s"}) {
        const auto found = plotted(name, {});
        REQUIRE(found.ok());
        CHECK(found->column == "circulation_rad_s");
        CHECK(found->unit == "rad/s");
        CHECK(found->measure->name == "circulation");
    }
}

TEST_CASE("a column that no tracer has is refused with those close by, and one of no tracer with how to get one") {
    const Problems wrong = plotted("tracer:sensor_high", {"sensor"}).problems();
    REQUIRE(wrong.size() == 1);
    CHECK(wrong[0].key == "render.plot_measure");
    CHECK(wrong[0].what == "there is no column 'tracer:sensor_high' of a body that is traced");
    const Problems twisted = plotted("tracer:sensor_pint_vy", {"sensor"}).problems();
    REQUIRE(twisted.size() == 1);
    CHECK(twisted[0].fix.starts_with("close by are tracer:sensor_point_vy, "));
    CHECK(twisted[0].fix.ends_with("; `tumble list measures SCENE` names all of them"));
    const Problems none = plotted("tracer:sensor_y", {}).problems();
    REQUIRE(none.size() == 1);
    CHECK(none[0].what ==
          "there is no column 'tracer:sensor_y' of a body that is traced: observe.measures traces none");
    CHECK(none[0].fix == "add \"tracer:BODY\" to observe.measures, with the name of a [body.NAME]");
}

TEST_CASE("a run plots the column that it writes, and a redrawing finds it there") {
    const Folder folder;
    const auto scene =
        loaded(falling_ball, {"observe.measures=[\"kinetic\", \"tracer:ball\"]", "render.plot_measure=tracer:ball_y"});
    REQUIRE(ran(scene, in(folder.path / "ball")).problems.empty());
    const std::filesystem::path last = newest(folder.path / "ball");
    const auto checkpoint = run::checkpoint_from(content_of(last), last);
    REQUIRE(checkpoint.ok());
    const auto series = observe::read_series(folder.path / "ball" / "series.csv").value();
    CHECK(checkpoint->plot_times == *series.find("time_s"));
    CHECK(checkpoint->plot_values == *series.find("tracer:ball_y_m"));
    CHECK(checkpoint->plot_values.front() == about(0.5));
    run::RedrawOptions options;
    options.settings = scene.render;
    options.traced = {"ball"};
    options.targets.folder = folder.path / "drawn";
    const auto drawn = run::redraw(folder.path / "ball", options, [](std::int64_t, std::int64_t) {});
    REQUIRE_MESSAGE(drawn.ok(), to_string(drawn.problems()));
    CHECK(drawn->warnings.empty());
    options.settings.plot_measure = "tracer:bal_y";
    options.overwrite = true;
    CHECK_FALSE(run::redraw(folder.path / "ball", options, [](std::int64_t, std::int64_t) {}).ok());
}

} // namespace test_measure_names
