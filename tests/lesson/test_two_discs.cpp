#include "about.h"
#include "taught.h"

namespace test_two_discs {

using namespace tumble::lesson;
using namespace tumble::lesson::testing;
using tumble::test::about;

TEST_CASE("two-discs: the solver's numbers are those of (3.10) to (3.17)") {
    const double k = 2000, v = 0.05, dt = 0.008, m_x = 1.5, m_y = 3; // N/m, m/s, s, kg
    const Walk walk = taught("two-discs", {{"normal_stiffness_N_per_m", "2000"},
                                           {"wall_speed_m_s", "0.05"},
                                           {"time_step_s", "0.008"},
                                           {"mass_x_kg", "1.5"},
                                           {"mass_y_kg", "3"}});
    const double n = v * dt, f = k * n;
    const double x = f / m_x * dt, y = -f / m_y * dt;
    CHECK(walk.fact("overlap_a_t1") == about(n, 1e-10));
    CHECK(walk.fact("velocity_x_t1") == about(x, 1e-10));
    CHECK(walk.fact("growth_a_t2") == about((v - x) * dt, 1e-10));
    CHECK(walk.fact("growth_b_t2") == about((x - y) * dt, 1e-10));
    CHECK(walk.fact("growth_c_t2") == about((y + v) * dt, 1e-10));
    CHECK(walk.fact("force_x_t2") == about(k * (n + (v - x) * dt - (x - y) * dt), 1e-9));
}

TEST_CASE("two-discs: forty cycles of the loop in the walk end where the solver does") {
    CHECK(taught("two-discs").fact("loop_difference") < 1e-12);
}

TEST_CASE("two-discs: the growth at B falls with the third power of the step") {
    const Walk walk = taught("two-discs");
    CHECK(walk.fact("growth_b_t2") / walk.fact("halved_growth_b_t2") == about(8, 1e-9));
}

TEST_CASE("two-discs: the first two steps reach 3/4 of the overlap at B, four half steps 15/16") {
    // A push that grows evenly moves a mass by k v t^3 / (6 m); n steps by 1 - 1/n^2 of it. A spring this soft hardly
    // resists, and the finest run has n = 200.
    const Walk walk = taught("two-discs", {{"normal_stiffness_N_per_m", "1"}});
    const double fine = walk.fact("fine_overlap_b_t2");
    CHECK(walk.fact("growth_b_t2") / fine == about(3.0 / 4, 1e-3));
    CHECK(walk.fact("halved_overlap_b_same_moment") / fine == about(15.0 / 16, 1e-3));
}

TEST_CASE("two-discs: a step beyond 2 / omega of the faster mode is refused") {
    // Equal masses: the discs swing against each other with 3 k / m.
    const Typed equal{{"mass_x_kg", "1"}, {"mass_y_kg", "1"}, {"normal_stiffness_N_per_m", "1e5"}};
    const Lesson& lesson = **find_lesson("two-discs");
    auto typed = equal;
    typed.emplace_back("time_step_s", "0.0036"); // 2 / sqrt(3e5) = 0.00365 s
    CHECK(lesson.teach(*read_values(lesson, typed)).ok());
    typed.back().second = "0.0037";
    const auto refused = lesson.teach(*read_values(lesson, typed));
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.problems()[0].key == "--time_step_s");
}

} // namespace test_two_discs
