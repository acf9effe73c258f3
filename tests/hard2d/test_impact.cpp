// One impact of hard bodies: Newton's restitution along the normal, Coulomb's friction across, the closed forms of a
// hard disc. Box2D counts in single precision: what is exact in theory holds to some 1e-5.
#include "sandbox.h"

#include <cmath>
#include <vector>

namespace test_impact {

using namespace tumble;
using namespace tumble::hard2d;
using namespace tumble::hard2d::testing;

TEST_CASE("free fall is that of Euler's rule with the new velocity: g dt^2 n (n + 1) / 2 deep after n steps") {
    const double dt = 1e-3;
    Sandbox box(0, 0, dt);
    box.gravity();
    const int disc = box.disc(0.05);
    box.put({at(disc, {0.3, 4})});
    box.step(500);
    CHECK(box.body_at(0).position.y() == about(4 - g * dt * dt * 500 * 501 / 2, 1e-5));
    CHECK(box.body_at(0).velocity.y() == about(-g * 500 * dt, 1e-5));
    CHECK(time_of(*box.world) == about(0.5));
    // Euler's fall loses m g^2 dt^2 / 2 a step, and nothing else is lost.
    const double mass = box.shape(disc).mass;
    CHECK(books_of(*box.world).lost_in_sum == about(500 * mass * g * g * dt * dt / 2, 0.05));
}

TEST_CASE("a dropped disc rebounds to e^2 of the height it fell, whatever the step") {
    for (const double dt : {1e-3, 2e-4})
        for (const double e : {0.4, 0.7, 0.9}) {
            CAPTURE(dt);
            CAPTURE(e);
            Sandbox box(e, 0.3, dt);
            box.gravity();
            const int disc = box.disc(0.05);
            box.floor();
            box.put({at(disc, {0, 0.05 + 0.5})});
            const double down = std::sqrt(2 * 0.5 / g);
            box.run_for(1.05 * down);
            double top = 0;
            while (time_of(*box.world) < down * (1 + 2 * e)) {
                box.step();
                top = std::max(top, box.body_at(0).position.y() - 0.05);
            }
            // The impact falls anywhere in a step, in which the disc goes v dt.
            CHECK(top == about(e * e * 0.5, 4 * g * down * dt / 0.5));
        }
}

TEST_CASE("each pair of materials has its own restitution and friction") {
    Sandbox box(0, 0, 1e-3);
    box.scene.materials = {{"floor", 1000, 0, 0}, {"glass", 2500, 0, 0}, {"lead", 11000, 0, 0}};
    const auto none = Sandbox::pair(0, 0), glass = Sandbox::pair(0.9, 0), lead = Sandbox::pair(0.1, 0);
    box.scene.pairs = {none, glass, lead, glass, none, none, lead, none, none};
    box.floor();
    const int first = box.disc(0.05), second = box.disc(0.05);
    box.scene.bodies[0].material = 1;
    box.scene.bodies[1].material = 2;
    box.put({at(first, {-1, 0.1}, {0, -2}), at(second, {1, 0.1}, {0, -2})});
    box.run_for(0.1);
    CHECK(box.body_at(0).velocity.y() == about(1.8, 1e-4));
    CHECK(box.body_at(1).velocity.y() == about(0.2, 1e-4));
}

TEST_CASE("an oblique impact: full sliding takes mu (1 + e) of the normal speed, sticking leaves two thirds") {
    const double e = 0.6, mu = 0.2, normal = 3;
    const auto leaves = [&](double along) {
        Sandbox box(e, mu, 5e-4);
        const int disc = box.disc(0.1);
        box.floor();
        box.put({at(disc, {0, 0.2}, {along, -normal})});
        box.run_for(0.1);
        CHECK(box.body_at(0).velocity.y() == about(e * normal, 1e-4));
        return box.body_at(0);
    };
    // Tangential impulse mu m (1 + e) v_n; the disc of inertia m R^2 / 2 is spun clockwise by twice that over m R.
    const double slip = mu * (1 + e) * normal;
    const BodyState fast = leaves(8);
    CHECK(fast.velocity.x() == about(8 - slip, 1e-3));
    // Box2D pushes in the middle of the overlap, which may be as deep as the way of a step.
    const double shorter_arm = normal * 5e-4 / 2 / 0.1;
    CHECK(fast.angular_velocity == about(-2 * slip / 0.1, shorter_arm));
    // It sticks where a third of the tangential speed is less than that: the point that touches stands still. With an
    // arm of a R the speed left is 2 a^2 / (1 + 2 a^2): two thirds for a = 1, and less by 2/3 of what the arm lacks.
    const BodyState slow = leaves(1);
    const double impulse = 1 - slow.velocity.x(); // over m, along the floor
    const double arm = -slow.angular_velocity * 0.1 / (2 * impulse);
    CHECK(arm < 1);
    CHECK(arm > 1 - shorter_arm);
    CHECK(slow.velocity.x() == about(2 * arm * arm / (1 + 2 * arm * arm), 1e-5)); // single precision
    CHECK(slow.velocity.x() == about(2.0 / 3, 2.0 / 3 * shorter_arm));
}

TEST_CASE("a clump that is struck beside its centre answers with its mass and the inertia of its union") {
    Sandbox box(1, 0, 1e-4);
    const int disc = box.disc(0.05);
    const int dumbbell = box.body({{{-0.08, 0, 0}, 0.05}, {{0, 0, 0}, 0.05}, {{0.08, 0, 0}, 0.05}});
    // From above, onto the outermost disc.
    box.put({at(disc, {0.08, 0.12}, {0, -1}), at(dumbbell, {0, 0})});
    box.run_for(0.1);
    const double m = box.shape(disc).mass, M = box.shape(dumbbell).mass, I = box.shape(dumbbell).inertia;
    // Along the line of centres: J = 2 v / (1/m + 1/M + arm^2 / I) for e = 1.
    const double push = 2 / (1 / m + 1 / M + 0.08 * 0.08 / I);
    CHECK(box.body_at(0).velocity.y() == about(-1 + push / m, 1e-3));
    CHECK(box.body_at(1).velocity.y() == about(-push / M, 1e-3));
    CHECK(box.body_at(1).angular_velocity == about(-0.08 * push / I, 1e-3));
}

TEST_CASE("among themselves bodies keep momentum and angular momentum, and lose energy unless e = 1 and mu = 0") {
    for (const bool lossless : {true, false}) {
        CAPTURE(lossless);
        Sandbox box(lossless ? 1 : 0.5, lossless ? 0 : 0.4, 1e-4);
        const int disc = box.disc(0.05), pair = box.body({{{-0.04, 0, 0}, 0.05}, {{0.04, 0, 0}, 0.05}});
        std::vector<BodyState> bodies;
        for (int k = 0; k < 24; ++k) {
            const Vector2d place(0.2 * (k % 5) - 0.4, 0.2 * (k / 5) - 0.4);
            bodies.push_back(at(k % 3 == 0 ? pair : disc, place, -3 * place + Vector2d(0.1 * (k % 7), 0), k % 4));
        }
        box.put(bodies);
        const auto sums = [&] {
            Vector3d sum = Vector3d::Zero(); // momentum x, y; angular momentum
            for (const BodyState& body : bodies_of(*box.world)) {
                const BodyShape& shape = box.shape(body.shape);
                const Vector2d p = shape.mass * body.velocity;
                sum += Vector3d(p.x(), p.y(),
                                body.position.x() * p.y() - body.position.y() * p.x() +
                                    shape.inertia * body.angular_velocity);
            }
            return sum;
        };
        const Vector3d before = sums();
        box.run_for(0.5);
        CHECK((sums() - before).norm() < 1e-3 * before.norm());
        const Books books = books_of(*box.world);
        if (lossless)
            CHECK(std::abs(books.lost_in_sum) < 5e-3 * books.inserted);
        else
            CHECK(books.lost_in_sum > 0.2 * books.inserted);
    }
}

} // namespace test_impact
