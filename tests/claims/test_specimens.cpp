#include "about.h"
#include "claims.h"
#include "run/part_loads.h"
#include "sim3d/body_shape.h"
#include "stress/study.h"

#include <cmath>
#include <numbers>

namespace test_specimens {

using namespace tumble;
using namespace tumble::test;

TEST_CASE("specimen-quick, with a quarter of its load: Coulomb's law bounds the shear, and stress falls with depth") {
    const scene::Scene bowl =
        loaded("specimen-quick.toml", {"fill.0.count=450", "duration_s=0.45", "wall.disc.motion.0.start_s=0.15",
                                       "wall.specimen.base_m=[0.11, 0.035, 0]", "wall.specimen.around=24",
                                       "wall.specimen.along=6", "wall.specimen.inner_rings=2"});
    const int wall = *run::find_specimen(bowl, "");
    run::RunListener silent;
    const auto loads = run::record_loads(bowl, wall, {.every = 0.005, .from = 0.2}, silent);
    REQUIRE_MESSAGE(loads.ok(), to_string(loads.problems()));
    CHECK(loads->touches.size() > 20);
    const auto& specimen = std::get<scene::SpecimenShape>(bowl.walls[static_cast<std::size_t>(wall)].shape);
    stress::StudyOptions options;
    options.means = true; // so short a run has more of them than instants with contacts
    const auto study = stress::study(bowl, specimen, *loads, options);
    REQUIRE_MESSAGE(study.ok(), to_string(study.problems()));
    double pressed = 0, sheared = 0;
    for (const observe::Touching& touch : loads->touches) {
        pressed += touch.normal_impulse;
        sheared += touch.shear_impulse;
    }
    CHECK(pressed > 0);
    CHECK(sheared <
          0.34 * pressed * 1.05); // Coulomb; the dashpot pulls at the end of a rebound, which counts less here
    double shallow = 0, deep = 0; // Pa, sums of the largest of 0.5 and 1.5 mm
    for (const stress::Case& now : study->cases) {
        CHECK(now.unbalance < 1e-10);
        shallow += std::abs(now.slices[0].normal);
        deep += std::abs(now.slices[2].normal);
    }
    CHECK(deep < shallow);
}

TEST_CASE("the case studies' media weigh what tables 7.1 and 7.2 say, and inclined specimens keep their middle") {
    const auto load_of = [&](const scene::Scene& scene) {
        const scene::BodyTemplate& body = scene.bodies[0];
        const auto shape = sim3d::make_body_shape(body, scene.materials[static_cast<std::size_t>(body.material)]);
        return *scene.fills[0].count * shape.value().mass;
    };
    CHECK(load_of(loaded("specimen-case-1.toml")) == about(7.643192, 0.001));
    CHECK(load_of(loaded("specimen-case-2.toml")) == about(7.6304944, 0.001));
    CHECK(load_of(loaded("specimen-case-3.toml")) == about(7.6304944, 0.001));
    for (const char* name : {"specimen-case-1-quick.toml", "specimen-case-2-quick.toml", "specimen-case-3-quick.toml"})
        CHECK(load_of(loaded(name)) == about(7.6304944, 0.001));
    const auto place_of = [](const scene::Scene& scene) {
        return std::get<scene::SpecimenShape>(scene.walls.back().shape).place;
    };
    const std::vector<std::vector<std::string>> inclined{
        {"wall.specimen.axis=[-0.5, 0.8660254, 0]", "wall.specimen.base_m=[0.1125, 0.0467, 0]"},
        {"wall.specimen.axis=[0.5, 0.8660254, 0]", "wall.specimen.base_m=[0.0625, 0.0467, 0]"}};
    for (const auto& sets : inclined)
        for (const char* name : {"specimen-case-1.toml", "specimen-case-1-quick.toml"}) {
            const solid::Place upright = place_of(loaded(name)), leaning = place_of(loaded(name, sets));
            CHECK(leaning.axis.dot(upright.axis) == about(std::cos(std::numbers::pi / 6), 1e-7));
            CHECK((leaning.base + 0.05 * leaning.axis - upright.base - 0.05 * upright.axis).norm() < 1e-4);
        }
}

TEST_CASE("specimen-case-3-quick, with less of its load: edges are touched, and no more often than chance gives") {
    const scene::Scene bowl =
        loaded("specimen-case-3-quick.toml",
               {"fill.0.count=500", "duration_s=0.45", "wall.disc.motion.0.start_s=0.15",
                "wall.disc.motion.0.speed_rpm=200", "wall.specimen.base_m=[0.08, 0.012, 0]", "wall.specimen.along=4",
                "wall.specimen.corner_cells=1", "wall.specimen.middle_cells=1"});
    const int wall = *run::find_specimen(bowl, "");
    run::RunListener silent;
    const auto loads = run::record_loads(bowl, wall, {.every = 0.005, .from = 0.2}, silent);
    REQUIRE_MESSAGE(loads.ok(), to_string(loads.problems()));
    const Eigen::Vector3d base = std::get<scene::SpecimenShape>(bowl.walls.back().shape).place.base;
    int rows = 0, edges = 0;
    for (const observe::Touching& touch : loads->touches) {
        if (touch.number > 1)
            continue; // a body that slides on does not choose its place anew
        ++rows;
        const Eigen::Vector3d off = (touch.foot - base).cwiseAbs();
        edges += off.x() > 0.0075 - 1e-6 && off.z() > 0.0075 - 1e-6 ? 1 : 0;
    }
    REQUIRE(rows > 20);
    // Centres of spheres that touch a square of side a lie on its outline r further out: four sides of length a and
    // four quarters of a circle. Were they spread over it evenly, edges would take pi r / (2 a + pi r), a half.
    const double even = std::numbers::pi * 0.0094966 / (2 * 0.015 + std::numbers::pi * 0.0094966);
    CHECK(even == about(0.5, 0.01));
    // Of n that come independently the share scatters by sqrt(p (1 - p) / n): three times that is beyond chance. So few
    // (about 25, +- 0.29) tell that edges do not take most; that they take a third, as here, is not beyond chance.
    CHECK(edges > 0);
    CHECK(edges / static_cast<double>(rows) < even + 3 * std::sqrt(even * (1 - even) / rows));
}

} // namespace test_specimens
