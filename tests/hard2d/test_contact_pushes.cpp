#include "sandbox.h"

namespace test_contact_pushes {

using namespace tumble;
using namespace tumble::hard2d;
using namespace tumble::hard2d::testing;

TEST_CASE("of two blocks that lie on each other the floor bears both weights, and the lower block the upper one's") {
    Sandbox box(0, 0.5, 5e-4);
    box.gravity();
    const int block = box.block(0.05);
    box.floor();
    box.put({at(block, {0, 0.05}), at(block, {0, 0.15})});
    box.run_for(0.5);
    const double weight = box.shape(block).mass * g;
    double floor = 0, between = 0;
    for (const ContactPush& push : contacts_of(*box.world)) {
        CHECK(push.normal.y() * push.force.y() > 0);
        if (push.wall == 0) {
            CHECK(push.a == 0);
            floor += push.force.y();
        } else {
            CHECK(push.a + push.b == 1);
            between += push.a == 1 ? push.force.y() : -push.force.y();
        }
    }
    // Box2D counts in single precision and solves for a number of rounds.
    CHECK(floor == about(2 * weight, 1e-2));
    CHECK(between == about(weight, 1e-2));
}

} // namespace test_contact_pushes
