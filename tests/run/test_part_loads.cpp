#include "about.h"
#include "base/text.h"
#include "folder.h"
#include "specimens.h"

#include <algorithm>
#include <cmath>

namespace test_part_loads {

using namespace tumble;
using Eigen::Vector3d;
using test::about;
using test::recorded;
using test::specimen_of;

namespace {

scene::Scene loaded(const std::vector<scene::Override>& sets = {}) {
    auto scene = scene::load_scene_text(test::ball_on_prism, "ball-on-prism.toml", sets);
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    return std::move(*scene);
}

Vector3d force_of(const run::MeanLoad& mean) {
    Vector3d sum = Vector3d::Zero();
    for (const observe::WallPush& push : mean.pushes)
        sum += push.force;
    return sum;
}

bool same(const std::vector<observe::WallPush>& some, const std::vector<observe::WallPush>& others) {
    return std::equal(some.begin(), some.end(), others.begin(), others.end(), [](const auto& a, const auto& b) {
        return a.body == b.body && a.triangle == b.triangle && a.foot == b.foot && a.normal == b.normal &&
               a.force == b.force && a.velocity == b.velocity && a.patch == b.patch;
    });
}

} // namespace

TEST_CASE("a ball at rest loads its part with its weight, at an instant and in the mean, where it lies") {
    const scene::Scene scene = loaded();
    const run::PartLoads loads = recorded(scene, {.every = 0.05});
    REQUIRE(loads.instants.size() == 6);
    REQUIRE(loads.means.size() == 6);
    const run::LoadInstant& last = loads.instants.back();
    REQUIRE(last.pushes.size() == 1);
    CHECK(last.pushes[0].force.y() == about(-test::weight_of_ball, 1e-4));
    CHECK((last.pushes[0].foot - Vector3d(0.003, 0.05, 0.002)).norm() < 1e-9);
    const auto& mean = loads.means.back();
    CHECK(mean.window == about(0.05, 1e-9));
    CHECK(force_of(mean).y() == about(-test::weight_of_ball, 1e-4));
    Vector3d moment = Vector3d::Zero();
    for (const observe::WallPush& push : mean.pushes) {
        moment += push.foot.cross(push.force);
        CHECK(push.patch == about(last.pushes[0].patch, 1e-3)); // a ball at rest keeps its patch
        CHECK(push.normal == Vector3d::UnitY());
    }
    // r x F of the weight at (3, 50, 2) mm.
    CHECK(moment.x() == about(0.002 * test::weight_of_ball, 1e-4));
    CHECK(moment.z() == about(-0.003 * test::weight_of_ball, 1e-4));
    // It fell 0.2 mm: it arrives with sqrt(2 g h).
    REQUIRE_FALSE(loads.touches.empty());
    CHECK(loads.touches[0].approach == about(std::sqrt(2 * 9.81 * 0.0002), 0.01));
    CHECK(loads.touches[0].number == 1);
    CHECK(loads.bulk.rows() == 6);
}

TEST_CASE("all momentum that gravity brings in a window leaves through the part") {
    // From rest to rest: the mean force over the whole run is the weight, whatever happened in between.
    const run::PartLoads loads = recorded(loaded(), {.every = 0.3});
    REQUIRE(loads.means.size() == 1);
    CHECK(force_of(loads.means[0]).y() == about(-test::weight_of_ball, 1e-4));
    CHECK(std::abs(force_of(loads.means[0]).x()) < 1e-6 * test::weight_of_ball);
}

TEST_CASE("a run of loads that ended early goes on to the same bits, and keeps a frame an instant") {
    const test::Folder folder;
    const scene::Scene scene = loaded();
    const run::LoadOptions options{.every = 0.04, .from = 0.03, .folder = folder.path, .resume = true};
    const run::PartLoads whole = recorded(scene, {.every = 0.04, .from = 0.03});
    const run::PartLoads part = recorded(loaded({{"duration_s=0.13"}}), options); // nothing there: it begins
    CHECK(part.instants.size() == 3);
    const run::PartLoads rest = recorded(scene, options);
    REQUIRE(rest.instants.size() == whole.instants.size());
    REQUIRE(rest.means.size() == whole.means.size());
    for (std::size_t i = 0; i < whole.instants.size(); ++i) {
        CHECK(rest.instants[i].time == whole.instants[i].time);
        CHECK(same(rest.instants[i].pushes, whole.instants[i].pushes));
        CHECK(rest.means[i].window == whole.means[i].window);
        CHECK(same(rest.means[i].pushes, whole.means[i].pushes));
    }
    REQUIRE(rest.touches.size() == whole.touches.size());
    CHECK(rest.touches.back().normal_impulse == whole.touches.back().normal_impulse);
    CHECK(rest.touches.back().duration == whole.touches.back().duration);
    CHECK(rest.bulk.values == whole.bulk.values);
    CHECK(test::count_files(folder.path / "frames", ".tumble") == whole.instants.size() + 1); // and the layout

    const auto refused = [&](const scene::Scene& other, double every) {
        run::LoadOptions changed = options;
        changed.every = every;
        run::RunListener silent;
        return to_string(run::record_loads(other, 0, changed, silent).problems());
    };
    CHECK(refused(scene, 0.05).find("was begun with --every 0.04 --from 0.03") != std::string::npos);
    CHECK(refused(loaded({{"wall.part.side_m=0.02"}}), 0.04).find("wall") != std::string::npos);
    CHECK(refused(loaded({{"duration_s=0.1"}}), 0.04).find("beyond the end of the run at 0.1 s") != std::string::npos);
}

TEST_CASE("loads are written and read back to the same bits") {
    const test::Folder folder;
    const scene::Scene scene = loaded({{"duration_s=0.1"}});
    const run::PartLoads loads = recorded(scene, {.every = 0.0005, .from = 0.002});
    REQUIRE(run::write_loads(loads, specimen_of(scene), folder.path));
    const auto again = run::read_loads(folder.path, specimen_of(scene));
    REQUIRE_MESSAGE(again, to_string(again.problems()));
    REQUIRE(again->instants.size() == loads.instants.size());
    REQUIRE(again->means.size() == loads.means.size());
    std::size_t empty = 0;
    for (std::size_t k = 0; k < loads.instants.size(); ++k) {
        CHECK(again->instants[k].time == loads.instants[k].time);
        CHECK(same(again->instants[k].pushes, loads.instants[k].pushes));
        empty += loads.instants[k].pushes.empty() ? 1 : 0;
        CHECK(again->means[k].window == loads.means[k].window);
        CHECK(same(again->means[k].pushes, loads.means[k].pushes));
    }
    CHECK(empty > 0); // while it falls
    REQUIRE(again->touches.size() == loads.touches.size());
    const observe::Touching &read = again->touches.back(), &wrote = loads.touches.back();
    CHECK(read.body == wrote.body);
    CHECK(read.number == wrote.number);
    CHECK(read.begin == wrote.begin);
    CHECK(read.duration == wrote.duration);
    CHECK(read.foot == wrote.foot);
    CHECK(read.approach == wrote.approach);
    CHECK(read.slip == wrote.slip);
    CHECK(read.peak_normal == wrote.peak_normal);
    CHECK(read.peak_shear == wrote.peak_shear);
    CHECK(read.normal_impulse == wrote.normal_impulse);
    CHECK(read.shear_impulse == wrote.shear_impulse);
    CHECK(read.peak_normal_time == wrote.peak_normal_time);
    CHECK(read.peak_shear_time == wrote.peak_shear_time);
    CHECK(wrote.peak_normal_time >= wrote.begin);
    CHECK(wrote.peak_normal_time < wrote.begin + wrote.duration);
    const auto element_of = [&](const observe::Touching& touch) {
        return specimen_of(scene).mesh->facets[static_cast<std::size_t>(touch.triangle / 2)].hex;
    };
    CHECK(element_of(read) == element_of(wrote));
    CHECK(loads.instants[0].time >= 0.002 - 1.01e-5); // forces are those at a step's start

    SUBCASE("touches of before their peaks' times were kept have none") {
        const std::string whole = test::content_of(folder.path / "touches.csv");
        std::string cut;
        for (const std::string_view line : split(whole, '\n'))
            if (!line.empty())
                cut += std::string(line.substr(0, line.rfind(',', line.rfind(',') - 1))) + "\n";
        test::put(folder.path / "touches.csv", cut);
        const auto older = run::read_loads(folder.path, specimen_of(scene));
        REQUIRE_MESSAGE(older, to_string(older.problems()));
        CHECK(older->touches.back().shear_impulse == wrote.shear_impulse);
        CHECK(std::isnan(older->touches.back().peak_normal_time));
    }

    SUBCASE("loads of another part are refused at their line") {
        const scene::Scene other = loaded({{"wall.part.along=1"}, {"wall.part.middle_cells=1"}});
        const auto wrong = run::read_loads(folder.path, specimen_of(other));
        REQUIRE_FALSE(wrong);
        CHECK(wrong.problems()[0].fix == "the loads are of another part");
        CHECK(wrong.problems()[0].line > 1);
    }
}

TEST_CASE("a scene without a specimen, and a body that was put inside one, are said") {
    scene::Scene scene = loaded();
    const auto inside = loaded({{"body.ball.radius_mm=1"}, {"time_step_s=4e-6"}, {"fill.0.position_m=[0, 0.03, 0]"}});
    run::RunListener silent;
    const auto refused = run::record_loads(inside, 0, {.every = 0.01}, silent);
    REQUIRE_FALSE(refused);
    CHECK(refused.problems()[0].what == "body 0 lies inside 'part' at 0.01 s");
    // What a part of 50 mm is that was written as 50 m, in a domain of 0.3 m.
    const auto vast = loaded({{"wall.part.length_m=50"},
                              {"wall.part.side_m=15"},
                              {"wall.part.corner_m=4.8"},
                              {"duration_s=1e-4"},
                              {"fill.0.position_m=[0.09, 0.19, 0.09]"}});
    struct Heard : run::RunListener {
        std::string warnings;
        void warned(const std::string& sentence) override { warnings += sentence; }
    } heard;
    (void)run::record_loads(vast, 0, {}, heard);
    CHECK_MESSAGE(heard.warnings.find("wall 'part' is 50 m large, 167 times the domain") != std::string::npos,
                  heard.warnings);
    const auto periodic = loaded({{"domain.periodic=[\"x\"]"}});
    CHECK(run::record_loads(periodic, 0, {}, silent).problems().at(0).key == "domain.periodic");
    CHECK(*run::find_specimen(scene, "") == 0);
    CHECK(run::find_specimen(scene, "prat").problems().at(0).what == "no specimen is called 'prat'");
    scene.walls.push_back(scene.walls[0]);
    scene.walls[1].name = "second";
    CHECK(run::find_specimen(scene, "").problems().at(0).fix == "name one of part, second");
    CHECK(*run::find_specimen(scene, "second") == 1);
    scene.walls.clear();
    CHECK(run::find_specimen(scene, "").problems().at(0).what == "the scene has no specimen");
}

} // namespace test_part_loads
