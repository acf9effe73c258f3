// Every shipped scene states a claim; here its run is held to it. A granular bed is chaotic: means are held to the
// scatter of seeds, parts of a run to a band a little wider than the scene has shown.
#include "about.h"
#include "folder.h"
#include "observe/series.h"
#include "run/part_loads.h"
#include "run/run_scene.h"
#include "scene/load.h"
#include "sim2d/solver.h"
#include "sim3d/body_shape.h"
#include "sim3d/solver.h"
#include "stress/study.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <numeric>

using namespace tumble;
using tumble::test::about;
namespace fs = std::filesystem;

namespace {

const fs::path scenes = fs::path(TUMBLE_ROOT) / "scenes";

scene::Scene loaded(const std::string& name, const std::vector<std::string>& sets = {}) {
    std::vector<scene::Override> overrides;
    for (const std::string& set : sets)
        overrides.push_back({set});
    const auto scene = scene::load_scene(scenes / name, overrides);
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    return *scene;
}

/// What a run of the scene wrote, a column per measure.
struct Ran {
    test::Folder folder;
    run::RunSummary summary;
    observe::Series series;

    explicit Ran(const scene::Scene& scene) {
        run::RunOptions options;
        options.folder = folder.path / "run";
        run::RunListener silent;
        const auto done = run::run_scene(scene, options, silent);
        REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
        summary = *done;
        REQUIRE(summary.state == "finished");
        series = observe::read_series(options.folder / "series.csv").value();
    }

    [[nodiscard]] const std::vector<double>& column(const std::string& name) const {
        const std::vector<double>* found = series.find(name);
        REQUIRE_MESSAGE(found != nullptr, name);
        return *found;
    }
    /// Between two rows, straight.
    [[nodiscard]] double at(const std::string& name, double t) const {
        const std::vector<double>&values = column(name), &time = column("time");
        const auto above = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
        REQUIRE(above > 0);
        REQUIRE(above < time.size());
        const double x = (t - time[above - 1]) / (time[above] - time[above - 1]);
        return (1 - x) * values[above - 1] + x * values[above];
    }
    [[nodiscard]] double mean(const std::string& name, double from, double to) const {
        const std::vector<double>& values = column(name);
        double sum = 0;
        int n = 0;
        for (std::size_t row = 0; row < values.size(); ++row)
            if (column("time")[row] > from - 1e-9 && column("time")[row] < to - 1e-9) {
                sum += values[row];
                ++n;
            }
        REQUIRE(n > 0);
        return sum / n;
    }
};

sim3d::WorldPtr stepped(const scene::Scene& scene) {
    auto world = sim3d::build_world(scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    const auto problem = sim3d::advance(**world, std::llround(scene.duration / scene.time_step));
    REQUIRE(!problem);
    return std::move(*world);
}

} // namespace

TEST_CASE("drop: the sphere rebounds to e^2 h less what gravity takes during the contact") {
    const Ran drop(loaded("drop.toml"));
    const std::vector<double>& time = drop.column("time");
    const std::vector<double>& height = drop.column("centre_of_mass_y");
    double top = 0;
    for (std::size_t row = 0; row < time.size(); ++row)
        if (time[row] > 0.21) // after the contact, at sqrt(2 h / g) = 0.202 s
            top = std::max(top, height[row] - 0.01275);
    const double rebound = 0.67 * 0.67 * 0.2;
    CHECK(top < rebound);
    CHECK(top > rebound * (1 - 0.005));
}

TEST_CASE(
    "bounce: every bounce reaches 0.8^2 of the height before, less some 1 % that gravity takes during the contact") {
    const Ran ran(loaded("bounce.toml", {"observe.measures=[\"centre_of_mass_y\"]"}));
    const auto highest = [&](double from, double to) {
        double most = 0;
        for (std::size_t row = 0; row < ran.series.rows(); ++row)
            if (ran.column("time")[row] > from && ran.column("time")[row] < to)
                most = std::max(most, ran.column("centre_of_mass_y")[row] - 0.12);
        return most;
    };
    // Impacts at sqrt(2 h / g) = 0.45 s, then after flights of 2 * 0.8^n * 0.45 s: 1.17 s, 1.75 s.
    const double first = highest(0.5, 1.15), second = highest(1.25, 1.72);
    CHECK(first > 0.625);
    CHECK(first < 0.64);
    CHECK(second / first > 0.625);
    CHECK(second / first < 0.64);
}

TEST_CASE("oblique: the sphere leaves as the hard-sphere result for full sliding says") {
    const sim3d::WorldPtr world = stepped(loaded("oblique.toml"));
    const sim3d::BodyState ball = sim3d::bodies_of(*world).front();
    CHECK(ball.velocity.x() / 2.50687 == about(0.7829, 0.002));
    CHECK(ball.angular_velocity.norm() == about(544.2, 0.002));
}

TEST_CASE("lane: the ball slides by mu g, then rolls with 5/7 of its speed") {
    const Ran ran(loaded("lane.toml", {"observe.measures=[\"centre_of_mass_x\"]"}));
    const auto way = [&](double t) { return ran.at("centre_of_mass_x", t); };
    // It turns on an arm that is 0.16 % short of the radius, which takes 0.1 % of the speed.
    CHECK(way(0.3) == about(2.5 * 0.3 - 0.5 * 0.2 * 9.81 * 0.3 * 0.3, 0.003));
    CHECK(way(2.9) - way(1.9) == about(5.0 / 7 * 2.5, 0.003));
}

TEST_CASE("slope: the tripod slides down with g (sin a - mu cos a)") {
    const Ran ran(loaded("slope.toml", {"observe.measures=[\"centre_of_mass_x\"]"}));
    const auto way = [&](double t) { return ran.at("centre_of_mass_x", t); };
    CHECK((way(0.99) - 2 * way(0.69) + way(0.39)) / (0.3 * 0.3) == about(0.866, 0.01));
}

TEST_CASE("plate: the ball leaves where the plate slows down by g, and flies from there") {
    const Ran ran(
        loaded("plate.toml", {"observe.measures=[\"centre_of_mass_y\"]", "duration_s=0.06", "observe.every_s=0.0005"}));
    const std::vector<double>& height = ran.column("centre_of_mass_y");
    CHECK(*std::max_element(height.begin(), height.end()) - 0.01 == about(0.00699, 0.01));
}

TEST_CASE("settle-cones: the cones come to rest and the books close") {
    const Ran settle(loaded("settle-cones.toml"));
    CHECK(settle.summary.bodies == 40);
    const std::vector<double>& kinetic = settle.column("kinetic_energy");
    CHECK(*std::max_element(kinetic.begin(), kinetic.end()) > 0.05);
    CHECK(kinetic.back() < 1e-6);
    CHECK(std::abs(settle.summary.books.closure) < 1e-3);
}

TEST_CASE("trough-quick: a trough that moves round a circle makes its load circulate") {
    const Ran circle(loaded("trough-quick.toml", {"duration_s=2.0"}));
    CHECK(circle.summary.bodies == 1000);
    CHECK(circle.summary.unfilled.empty());
    for (const double from : {1.0, 1.4}) { // ten periods of the wall each
        CAPTURE(from);
        const double part = circle.mean("circulation", from, from + 0.4);
        CHECK(part > 0.35);
        CHECK(part < 0.75);
    }
    CHECK(circle.mean("circulation", 1.0, 2.0) == about(0.55, 0.15));
    CHECK(std::abs(circle.summary.books.closure) < 2e-3 * circle.summary.energy_turnover);
}

TEST_CASE("trough-quick: in phase, on a straight line, it turns the other way and less than half as fast") {
    const Ran line(loaded("trough-quick.toml", {"duration_s=1.8", "wall.0.motion.1.phase_deg=0"}));
    for (const double from : {1.0, 1.4}) {
        CAPTURE(from);
        const double part = line.mean("circulation", from, from + 0.4);
        CHECK(part > -0.4);
        CHECK(part < -0.1);
    }
    CHECK(line.mean("circulation", 1.0, 1.8) == about(-0.22, 0.25));
}

TEST_CASE("trough-slice: the load and the drive are the thesis'") {
    const scene::Scene slice = loaded("trough-slice.toml");
    const auto world = sim3d::build_world(slice, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    const double cone = sim3d::shapes_of(**world).front().mass;
    // Table 5.2 weighs 4878 cones at 22.892 kg, with LIGGGHTS' sampling error in each (docs/peers.md).
    CHECK(4878 * cone == about(22.892, 0.005));
    CHECK(slice.time_step == about(1.0 / 350000, 1e-12));
    // Figure 5.21's strongest harmonic, 1.949 mm at 25 Hz, is a peak of 4.9 g upwards.
    double strongest = 0;
    for (const scene::Harmonic& harmonic : slice.walls.front().motion.harmonics)
        if (harmonic.axis == 1)
            strongest =
                std::max(strongest, harmonic.amplitude * std::pow(2 * std::numbers::pi * harmonic.frequency, 2));
    CHECK(strongest / 9.81 == about(4.9, 0.02));
}

TEST_CASE("bowl: load, sensor, drive and size are the thesis'") {
    const scene::Scene bowl = loaded("bowl.toml");
    const auto mass_of = [&](const scene::BodyTemplate& body) {
        return sim3d::make_body_shape(body, bowl.materials[static_cast<std::size_t>(body.material)]).value().mass;
    };
    CHECK(mass_of(bowl.bodies[0]) == about(0.000490733, 1e-5)); // appendix C.2
    CHECK(bowl.bodies[0].spheres.size() == 36);
    CHECK(*bowl.fills[0].count * mass_of(bowl.bodies[0]) == about(7.0, 0.001));
    CHECK(mass_of(bowl.bodies[1]) == 0.0277206);
    CHECK(bowl.bodies[1].spheres.size() == 43);
    CHECK(bowl.time_step == about(1.0 / 350000, 1e-12));
    const auto& wall = std::get<scene::BowlShape>(bowl.walls[0].shape);
    const auto& disc = std::get<scene::BowlDiscShape>(bowl.walls[1].shape);
    CHECK(2 * wall.radius == about(0.333));
    CHECK(wall.height == 0.21);
    CHECK(bowl.walls[1].motion.rotations[0].angular_velocity == about(200 * 2 * std::numbers::pi / 60));
    // 18 litres: the cylinder less the space behind the rim, a triangle carried round at its centroid.
    const double behind =
        2 * std::numbers::pi * (disc.radius - disc.rim_width / 3) * disc.rim_width * disc.rim_rise / 2;
    CHECK(std::numbers::pi * wall.radius * wall.radius * wall.height - behind == about(0.018, 0.02));
    const scene::Scene spheres = loaded("bowl-spheres.toml");
    CHECK(sim3d::make_body_shape(spheres.bodies[0], spheres.materials[0]).value().mass == about(0.000490733, 1e-4));
}

TEST_CASE("bowl-quick, with a ninth of its load: the disc flings the media outwards and lifts them up its rim") {
    const scene::Scene bowl =
        loaded("bowl-quick.toml", {"fill.0.count=200", "fill.1.start_s=0.05", "wall.disc.motion.0.start_s=0.15"});
    auto world = sim3d::build_world(bowl, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    struct Means {
        double away = 0, height = 0, round = 0; // m, m, m/s
    };
    const auto means_at = [&](double time) {
        REQUIRE(!sim3d::advance(**world, std::llround(time / bowl.time_step) - sim3d::steps_of(**world)));
        Means means;
        const auto bodies = sim3d::bodies_of(**world);
        for (const sim3d::BodyState& body : bodies) {
            const double away = std::hypot(body.position.x(), body.position.z());
            const auto n = static_cast<double>(bodies.size());
            means.away += away / n;
            means.height += body.position.y() / n;
            means.round += (body.position.z() * body.velocity.x() - body.position.x() * body.velocity.z()) / away / n;
        }
        return means;
    };
    const Means rest = means_at(0.15), flung = means_at(0.35);
    CHECK(sim3d::bodies_of(**world).size() == 201);
    CHECK(std::abs(rest.round) < 0.1);
    CHECK(flung.away > rest.away + 0.02);
    CHECK(flung.height > rest.height);
    // Faster than nothing, slower than the disc at the wall: 200 rpm and 0.1645 m.
    CHECK(flung.round > 0.5);
    CHECK(flung.round < 3.45);
    CHECK(std::abs(sim3d::books_of(**world).closure) < 0.05);
}

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

TEST_CASE(
    "specimen-case-3-quick, with less of its load: edges take touches about as chance gives, not more than faces") {
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
    int edges = 0;
    for (const observe::Touching& touch : loads->touches) {
        const Eigen::Vector3d off = (touch.foot - base).cwiseAbs();
        edges += off.x() > 0.0075 - 1e-6 && off.z() > 0.0075 - 1e-6 ? 1 : 0;
    }
    REQUIRE(loads->touches.size() > 20);
    // Centres of spheres that touch a square of side a lie on its outline r further out: four sides of length a and
    // four quarters of a circle. Were they spread over it evenly, edges would take pi r / (2 a + pi r), a half.
    const double even = std::numbers::pi * 0.0094966 / (2 * 0.015 + std::numbers::pi * 0.0094966);
    CHECK(even == about(0.5, 0.01));
    const double share = edges / static_cast<double>(loads->touches.size());
    CHECK(share > 0.4 * even);
    CHECK(share < 1.6 * even);
}

TEST_CASE("shaken-bed-2d: the bed flies as high as an inelastic block, and stays down below one g") {
    const auto rises = [](const Ran& bed, double from) {
        const std::vector<double>& time = bed.column("time");
        const std::vector<double>& height = bed.column("centre_of_mass_y");
        const double rest = bed.mean("centre_of_mass_y", 0.9, 1.0);
        std::vector<double> tops;
        for (double begin = from; begin + 1 / 12.0 < time.back() + 1e-3; begin += 1 / 12.0) {
            double top = -1;
            for (std::size_t row = 0; row < time.size(); ++row)
                if (time[row] >= begin && time[row] < begin + 1 / 12.0)
                    top = std::max(top, height[row] - rest);
            tops.push_back(top);
        }
        return tops;
    };
    const auto mean = [](const std::vector<double>& tops) {
        return std::accumulate(tops.begin(), tops.end(), 0.0) / static_cast<double>(tops.size());
    };
    const double a = 0.004314, w = 2 * std::numbers::pi * 12, g = 9.81;
    const double lift = g / (a * w * w); // sin of the phase at take-off
    const double block = a * lift + std::pow(a * w, 2) * (1 - lift * lift) / (2 * g);
    CHECK(block == about(0.0063, 0.01));
    double sum = 0;
    const std::array<int, 4> seeds{4, 5, 6, 7};
    for (const int seed : seeds) {
        CAPTURE(seed);
        const Ran flying(loaded("shaken-bed-2d.toml", {"duration_s=2.5", "seed=" + std::to_string(seed)}));
        const std::vector<double> tops = rises(flying, 1.5);
        CHECK(tops.size() == 12);
        for (const double top : tops) {
            CHECK(top > 0.8 * block);
            CHECK(top < 1.6 * block);
        }
        sum += mean(tops) / static_cast<double>(seeds.size());
    }
    // Means of eight seeds scatter by 0.5 mm, so those of four by 0.25.
    CHECK(sum == about(0.0069, 0.08));
    const Ran lying(loaded("shaken-bed-2d.toml", {"duration_s=1.8", "wall.plate.motion.0.amplitude_m=0.00138"}));
    CHECK(mean(rises(lying, 1.5)) == about(0.00138, 0.1));
}

TEST_CASE(
    "hopper-2d: as many discs leave the slot a second when half the filling is gone, and as Beverloo's law says") {
    const auto left_until = [](const scene::Scene& hopper, const std::vector<double>& times) {
        auto world = sim2d::build_world(hopper, 1);
        REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
        std::vector<int> left;
        for (const double time : times) {
            REQUIRE(!sim2d::advance(**world, std::llround(time / hopper.time_step) - sim2d::steps_of(**world)));
            const auto discs = sim2d::bodies_of(**world);
            left.push_back(static_cast<int>(std::count_if(
                discs.begin(), discs.end(), [](const sim2d::BodyState& disc) { return disc.position.y() < -0.01; })));
        }
        return left;
    };
    // Beverloo's law for a slot, 1.03 phi sqrt(g) (B - k d)^1.5 of area per second (Nedderman 1992), with the solid
    // fraction 0.82 of discs at rest, over the mean area of the two sizes; k lies between 1.2 and 1.6.
    const auto beverloo = [](double slot, double k) {
        const double disc = std::numbers::pi * (0.0036 * 0.0036 + 0.0044 * 0.0044) / 2;
        return 1.03 * 0.82 * std::sqrt(9.81) * std::pow(slot - k * 0.008, 1.5) / disc;
    };
    const std::vector<int> left = left_until(loaded("hopper-2d.toml"), {1.44, 2.04, 2.64});
    const double first = (left[1] - left[0]) / 0.6, second = (left[2] - left[1]) / 0.6; // 1/s
    CHECK(first > beverloo(0.07, 1.6));
    CHECK(first < beverloo(0.07, 1.2));
    CHECK(second > 0.88 * first);
    CHECK(second < 1.05 * first);
    // The exponent: through a slot of 50 mm flows 0.54 of that (0.52 to 0.55 by k); with the exponent 1 it would be
    // 0.66, with 2 0.44.
    const std::vector<int> narrow =
        left_until(loaded("hopper-2d.toml", {"wall.left.points_m=[[-0.13, 0.78], [-0.13, 0.0], [-0.025, 0.0]]",
                                             "wall.right.points_m=[[0.13, 0.78], [0.13, 0.0], [0.025, 0.0]]"}),
                   {1.44, 2.04});
    CHECK((narrow[1] - narrow[0]) / 0.6 / first == about(beverloo(0.05, 1.4) / beverloo(0.07, 1.4), 0.1));
}

TEST_CASE(
    "repose-2d: discs that roll heap up far below their angle of friction, alike on both sides and in every heap") {
    double sum = 0, skew = 0;
    const std::array<int, 3> seeds{3, 4, 5};
    for (const int seed : seeds) {
        CAPTURE(seed);
        const Ran heap(loaded("repose-2d.toml", {"duration_s=2.6", "seed=" + std::to_string(seed)})); // at rest by then
        const double left = heap.column("surface_slope_left").back(),
                     right = -heap.column("surface_slope_right").back();
        CHECK(heap.summary.unfilled.empty());
        CHECK(heap.column("kinetic_energy").back() < 1e-9);
        for (const double slope : {left, right}) {
            CHECK(slope > 13);
            CHECK(slope < 19);
        }
        sum += left + right;
        skew += left - right;
    }
    // Six slopes scatter by 1.1 degrees: their mean by 0.45, the mean difference of two sides by 0.9.
    CHECK(sum / 6 == about(15.9, 0.08));
    CHECK(std::abs(skew / 3) < 2);
}

TEST_CASE("trough-2d: moved round a circle, the trough makes its flat load circulate clockwise and its surface slope") {
    // Slopes of single seeds scatter by 2.4 degrees about 9, circulations by 0.06 about 0.51 rad/s: means of two seeds
    // lie within three standard errors, 5 and 0.13.
    double turns = 0, slope = 0;
    for (const char* seed : {"seed=7", "seed=12"}) {
        CAPTURE(seed);
        const Ran flat(loaded("trough-2d.toml", {seed}));
        CHECK(flat.summary.bodies == 500);
        CHECK(flat.summary.unfilled.empty());
        for (const double from : {1.4, 1.8, 2.2, 2.6}) {
            CAPTURE(from);
            CHECK(flat.mean("circulation", from, from + 0.4) < -0.25);
            CHECK(flat.mean("circulation", from, from + 0.4) > -0.9);
        }
        const double turned = flat.mean("circulation", 2.0, 3.0), sloped = flat.mean("surface_slope", 2.0, 3.0);
        if (turns == 0) { // the scene's own seed
            CHECK(turned == about(-0.53, 0.25));
            CHECK(sloped == about(-9.2, 0.25));
        }
        turns += 0.5 * turned;
        slope += 0.5 * sloped;
        CHECK(std::abs(flat.summary.books.closure) < 0.01 * flat.summary.energy_turnover);
    }
    CHECK(std::abs(turns + 0.51) < 0.13);
    CHECK(slope < -4);
    CHECK(slope > -14);
}

TEST_CASE("trough-2d: in phase it turns the other way and lies level; with the thesis' amplitude across it turns a "
          "quarter as fast; with both nothing is left") {
    // From 2 to 3 s as claimed, each held to what three seeds have shown and about as much again on either side.
    struct Means {
        double turns, slope; // rad/s, degrees
    };
    const auto shaken = [](const std::vector<std::string>& sets) {
        const Ran ran(loaded("trough-2d.toml", sets));
        return Means{ran.mean("circulation", 2, 3), ran.mean("surface_slope", 2, 3)};
    };
    const std::string in_phase = "wall.0.motion.1.phase_deg=0", thesis = "wall.0.motion.1.amplitude_m=0.0004038";
    const Means line = shaken({in_phase});
    CHECK(line.turns > 0.07);
    CHECK(line.turns < 0.15);
    CHECK(std::abs(line.slope) < 3.5);
    const Means ellipse = shaken({thesis});
    CHECK(ellipse.turns > -0.17);
    CHECK(ellipse.turns < -0.11);
    CHECK(ellipse.slope > -6);
    CHECK(ellipse.slope < -3);
    const Means both = shaken({in_phase, thesis});
    CHECK(both.turns > -0.03);
    CHECK(both.turns < 0.07);
    CHECK(both.slope > -5);
    CHECK(both.slope < 3);
}

TEST_CASE("drum-2d: the surface of a slowly turning drum keeps its dynamic angle") {
    // The mean of two seeds, whose single ones scatter by 0.54 degrees about 22.6: three standard errors to either
    // side.
    double mean = 0;
    for (const char* seed : {"seed=2", "seed=5"}) {
        const Ran drum(loaded("drum-2d.toml", {seed}));
        CHECK(drum.summary.unfilled.empty());
        mean += 0.5 * drum.mean("surface_slope", 2.0, 5.0);
        for (double from = 2.2; from < 4.5; from += 0.4) {
            CAPTURE(from);
            CHECK(drum.mean("surface_slope", from, from + 0.4) > 18);
            CHECK(drum.mean("surface_slope", from, from + 0.4) < 27.5);
        }
    }
    CHECK(mean == about(22.6, 0.05));
}
