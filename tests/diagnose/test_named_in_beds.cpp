// Causes that only beds show, hidden in means that a formula gives, and named.
#include "about.h"
#include "beds_of_a_formula.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"

#include <array>
#include <doctest/doctest.h>

namespace test_named_in_beds {

using namespace tumble;
using namespace tumble::diagnose;

namespace {

/// Circulation in rad/s and slope in deg.
using Means = std::array<double, 2>;
using Formula = std::function<Means(const scene::Scene&)>;

/// What the formula says, and what the seed adds, for all of a run.
Simulate seeds_about(const Formula& formula) {
    return [formula](const scene::Scene& scene) -> Result<observe::Series> {
        const Means means = formula(scene);
        Rng rng(scene.seed * 7919 + static_cast<std::uint64_t>(std::llround(1e6 * (7 * means[0] + means[1] + 100))));
        const double circulation = means[0] + test::scatter_of_circulation * test::gauss(rng);
        const double slope = means[1] + test::scatter_of_slope * test::gauss(rng);
        observe::Series series;
        series.columns = {"time_s"};
        for (const std::string& name : scene.observe.measures)
            series.columns.push_back(observe::choose_measures({name})->front().column());
        series.values.resize(series.columns.size());
        for (int k = 0; k <= 200; ++k) {
            std::vector<double> row{0.01 * k};
            for (const std::string& name : scene.observe.measures)
                row.push_back(name == "circulation" ? circulation : name == "surface_slope" ? slope : 0);
            series.append(row);
        }
        return series;
    };
}

/// The means of four runs under either set, exactly; the seeds of the simulation scatter.
Measurement measured(const std::vector<std::string>& causes, const std::vector<std::string>& sets,
                     const std::vector<Means>& means) {
    Measurement all;
    all.causes = causes;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        Bulk bulk{.condition = sets[k], .sets = {sets[k]}, .from = 1.0, .until = 2.0, .runs = 4, .numbers = {}};
        bulk.numbers = {{"circulation", "rad_s", means[k][0], test::scatter_of_circulation},
                        {"surface_slope", "deg", means[k][1], test::scatter_of_slope}};
        all.bulks.push_back(std::move(bulk));
    }
    return all;
}

void check_named(const SceneText& scene, const Formula& formula, const Measurement& measurement, double amplitude) {
    const auto diagnosis = diagnose_beds(scene, measurement, seeds_about(formula), {.table = {}});
    REQUIRE_MESSAGE(diagnosis, to_string(diagnosis.problems()));
    REQUIRE_MESSAGE(diagnosis->decision.outcome == Outcome::named, verdict_of(*diagnosis));
    CHECK_MESSAGE(diagnosis->decision.sure, verdict_of(*diagnosis));
    const Refit& best = *diagnosis->decision.best;
    CHECK(diagnosis->causes[static_cast<std::size_t>(best.causes[0])].id == measurement.causes[0]);
    CHECK(std::abs(best.amplitude[0] - amplitude) < 4 * best.error[0]);
}

const std::vector<std::string> loads{"fill.0.count=100", "fill.0.count=150"};
const std::vector<std::string> two_seeds{"seed=77", "seed=1077"}; // conditions of a scene that are alike

double tilt_of(const scene::Scene& scene) {
    return 57.29577951308232 * std::atan2(scene.gravity.x(), -scene.gravity.y());
}

} // namespace

TEST_CASE("bodies that are longer than thick are named: they stand steeper and circulate less, under either load") {
    const Formula longer = [](const scene::Scene& scene) -> Means {
        const auto& spheres = scene.bodies[0].spheres;
        const double share =
            spheres.size() == 1 ? 0 : (spheres[1].centre - spheres[0].centre).norm() / (2 * spheres[0].radius);
        return {0.3 * (1 - share), 4 + 20 * share + 2 * tilt_of(scene)};
    };
    check_named({test::shaken_box, "box.toml"}, longer,
                measured({"shape.clump", "grav.tilt_x", "load.fill"}, loads, {{0.21, 10}, {0.21, 10}}), 0.3);
}

TEST_CASE("steps that are too long are named: what they add falls with them") {
    const Formula first_order = [](const scene::Scene& scene) -> Means {
        return {0.1 + 0.4 * scene.time_step / 1e-5, 4 + 20 * scene.time_step / 1e-5 + 2 * tilt_of(scene)};
    };
    check_named({test::shaken_box, "box.toml"}, first_order,
                measured({"num.dt", "grav.tilt_x", "rest.factor"}, loads, {{0.3, 14}, {0.3, 14}}), 0.5);
}

TEST_CASE("ribs that stand 2 mm higher are named in a bowl, beside friction of the wall") {
    const std::filesystem::path file = std::filesystem::path(TUMBLE_ROOT) / "scenes" / "bowl-quick.toml";
    const auto text = scene::read_file(file, scene::largest_scene);
    REQUIRE(text);
    const Formula carried = [](const scene::Scene& scene) -> Means {
        double height = 0;
        for (const scene::Wall& wall : scene.walls)
            if (const auto* bowl = std::get_if<scene::BowlShape>(&wall.shape))
                height = bowl->ribs.count > 0 ? bowl->ribs.height : 0;
        return {0.1 + 60 * height, 4 + 2000 * height};
    };
    const auto scene = scene::load_scene_text(*text, file);
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    const auto [circulation, slope] = carried(*scene);
    check_named({*text, file}, carried,
                measured({"wall.ribs", "fric.wall", "grav.tilt_x"}, two_seeds,
                         {{circulation + 0.12, slope + 4}, {circulation + 0.12, slope + 4}}),
                2);
}

TEST_CASE("clumps that damp an impact once for each of their contacts are named: with it shared they move more") {
    const std::filesystem::path file = std::filesystem::path(TUMBLE_ROOT) / "scenes" / "bowl-quick.toml";
    const auto text = scene::read_file(file, scene::largest_scene);
    REQUIRE(text);
    const Formula lively = [](const scene::Scene& scene) -> Means {
        return {0.5 + 0.4 * scene.contact.sharing(), 10 - 10 * scene.contact.sharing()};
    };
    check_named({*text, file}, lively,
                measured({"shape.multicontact", "rest.factor", "grav.tilt_x"}, two_seeds, {{0.74, 4}, {0.74, 4}}), 0.6);
}

} // namespace test_named_in_beds
