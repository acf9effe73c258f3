#include "about.h"
#include "base/rng.h"
#include "performed.h"

#include <cmath>

namespace test_matter {

using namespace tumble;
using namespace tumble::lab;
using namespace tumble::lab::testing;
using tumble::test::about;

TEST_CASE("dead weights on a tripod give back the modulus and the ratio that were put in") {
    const Outcome outcome = performed("press", {{"loads", "4"}});
    CHECK(outcome.sheet.fact("exponent") == about(1.5, 0.005));
    CHECK(outcome.sheet.fact("youngs_modulus") == about(4.6e9, 0.02));
    CHECK(outcome.sheet.fact("poisson_ratio") == about(0.2887, 0.05));
}

TEST_CASE("the cone of 65 spheres has the volume and the mass that its union has") {
    // 2.8064e-6 m3 and 4.675 g at 1665.71 kg/m3 (design, from the thesis' table of spheres).
    const Outcome outcome = performed("weigh");
    CHECK(outcome.sheet.fact("volume_model") == about(2806.4, 5e-4));
    CHECK(outcome.sheet.fact("mass_model") == about(4.675, 5e-4));
    // pi / 12 * 20^2 * 24 mm3 = 2513.3 mm3; 4.7 g over it.
    CHECK(outcome.sheet.fact("density_cone") == about(4.7e-3 / 2513.27e-9, 1e-4));
    // 2 * 0.3 / 20, 0.3 / 24 and 0.03 / 4.7 of it: 3 %, 1.25 % and 0.64 %.
    CHECK(outcome.sheet.fact("density_cone_error") == about(0.03312 * 4.7e-3 / 2513.27e-9, 1e-3));
    CHECK(outcome.sheet.fact("density_model_error") == about(0.03e-3 / 2806.4e-9, 1e-3));
    CHECK(outcome.recordings[0].rows.size() == 2);
}

TEST_CASE("a turned cylinder's density comes from its own mass and size, and from nothing if there are none") {
    const auto density = [](const char* standard) {
        return performed("weigh", {{"turned_diameter_mm", "10"},
                                   {"turned_length_mm", "20"},
                                   {"turned_mass_g", "2"},
                                   {"density_kg_m3", standard}})
            .sheet.fact("density_turned");
    };
    // pi / 4 * 10^2 * 20 mm3 = 1570.8 mm3; what density was typed has no part in it.
    CHECK(density("1665.71") == about(2e-3 / 1570.796e-9, 1e-5));
    CHECK(density("900") == density("1665.71"));
    CHECK(refused("weigh", {{"turned_diameter_mm", "10"}, {"turned_mass_g", "2"}}).key == "--turned_length_mm");
}

TEST_CASE("the thesis' tables come out as printed, but for an average and a standard deviation") {
    const Outcome outcome = performed("thesis");
    const auto fact = [&](const char* name) { return outcome.sheet.fact(name); };
    // Computed beside, with another program (numpy): mean and sample standard deviation of sqrt(h / 200 mm).
    CHECK(fact("mean_0") == about(0.66982, 1e-4));
    CHECK(fact("mean_1") == about(0.66770, 1e-4));
    CHECK(fact("mean_2") == about(0.79462, 1e-4));
    CHECK(fact("sd_0") / 0.01930 == about(1, 1e-3));
    CHECK(fact("sd_1") / 0.02748 == about(1, 1e-3));
    CHECK(fact("sd_2") / 0.00896 == about(1, 1e-3));
    for (const char* name : {"same_0", "same_1", "same_2"})
        CHECK(fact(name) == 10);
    // e^2 h of the three readings of 0.159; gravity during the contact takes a little, 3 % of the smallest.
    CHECK(fact("lining_rebound_0") == about(5.06, 0.03));
    CHECK(fact("lining_rebound_1") == about(31.8, 0.01));
    CHECK(fact("lining_rebound_2") == about(168.2, 0.01));
}

TEST_CASE("a record of a testing machine gives modulus and ratio with errors, and says when it is no straight line") {
    // 11 mm bar of 2 GPa and 0.3; strains read to 1e-6, uniformly wrong by up to half of that: sd 2.9e-7.
    const auto evaluated = [](double bend) {
        Rng rng(3);
        Recording record{"t", {"force_kN", "strain", "strain_across"}};
        for (int k = 0; k <= 200; ++k) {
            const double strain = 1e-5 * k, stress = 2e9 * strain * (1 - bend * strain);
            record.rows.push_back({1e-3 * stress * 3.14159265358979 / 4 * 0.011 * 0.011,
                                   strain + 1e-4 + 5e-7 * rng.uniform(-1, 1),
                                   -0.3 * strain + 5e-7 * rng.uniform(-1, 1)});
        }
        const Experiment& tension = **find_experiment("tension");
        auto outcome = tension.evaluate(*parse_table(record.csv(), "t.csv"), *read_values(tension));
        REQUIRE(outcome.ok());
        return outcome->sheet;
    };
    const Sheet straight = evaluated(0);
    CHECK(std::abs(straight.fact("youngs_modulus") - 2e9) < 4.5 * straight.fact("youngs_modulus_se"));
    CHECK(straight.fact("youngs_modulus_se") < 2e9 * 1e-4);
    CHECK(std::abs(straight.fact("poisson_ratio") - 0.3) < 4.5 * straight.fact("poisson_ratio_se"));
    CHECK(straight.fact("bend_in_errors") < 4);
    CHECK(evaluated(10).fact("bend_in_errors") > 10);
    const Experiment& tension = **find_experiment("tension");
    const auto broken = tension.evaluate(*parse_table("force_N,strain\n1,2\n", "t.csv"), *read_values(tension));
    REQUIRE_FALSE(broken.ok());
    CHECK(broken.problems()[0].what == "fewer than three rows");
}

TEST_CASE("an accelerometer at the rim shows the motion of the wall there, gravity included") {
    const Outcome outcome = performed("sensor", {{"noise_m_s2", "0"},
                                                 {"mains_m_s2", "0"},
                                                 {"second_order_um", "0"},
                                                 {"half_order_um", "0"},
                                                 {"rocking_mrad", "0.5"},
                                                 {"speed_rpm", "1500"}});
    REQUIRE(outcome.recordings.size() == 2);
    // y: -A w^2 sin(w t) of the ellipse, and of rocking by theta about x: the place at z = -300 mm moves by -theta z.
    const double rate = 2 * 3.14159265358979 * 25;
    for (const std::size_t k : {0U, 7U, 501U}) {
        const double t = 1 + static_cast<double>(k) / 2000;
        const double up = 1949e-6 + 0.5e-3 * 0.3;
        CHECK(std::abs(outcome.recordings[0].rows[k][2] - (9.81 - up * rate * rate * std::sin(rate * t))) < 0.01);
    }
}

} // namespace test_matter
