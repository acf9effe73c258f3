#include "about.h"
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_air {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

TEST_CASE("a disc falls through air as v_t tanh(g t / v_t), and the books close") {
    const double g = 9.81, r = 0.05, dt = 1e-4;
    Sandbox box(springs(1e6, 1, 0.5, 0.3), dt);
    box.scene.materials[0].density = 30;
    box.scene.gravity = {0, -g, 0};
    box.scene.air = {1.2, 0, 1.1};
    const int disc = box.disc(r);
    box.put({at(disc, {0, 0})});
    // m g = rho C_d / 2 (2 r depth) v_t^2
    const double terminal = std::sqrt(30 * std::numbers::pi * r * r * g / (0.5 * 1.2 * 1.1 * 2 * r));
    for (const double time : {0.2, 1.0, 2.0}) {
        box.step(std::llround(time / dt) - steps_of(*box.world));
        CHECK(-box.body_at(0).velocity.y() == about(terminal * std::tanh(g * time / terminal), 1e-3));
    }
    const Books books = books_of(*box.world);
    CHECK(books.lost_air_drag > 0.3 * -books.gravity);
    CHECK(std::abs(books.closure) < 1e-4 * books.lost_air_drag);
}

} // namespace test_air
