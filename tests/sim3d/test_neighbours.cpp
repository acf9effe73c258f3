#include "base/rng.h"
#include "sim3d/sandbox.h"

#include <cmath>

namespace test_neighbours {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;

namespace {

struct Placed {
    int body;
    Vector3d centre;
    double radius;
};

/// Every sphere where it stands now, looked up without any list.
std::vector<Placed> spheres_of(const World& world) {
    std::vector<Placed> spheres;
    for (const BodyState& body : bodies_of(world))
        for (const scene::Sphere& sphere : shapes_of(world)[static_cast<std::size_t>(body.shape)].spheres)
            spheres.push_back(
                {static_cast<int>(body.id), body.position + body.orientation * sphere.centre, sphere.radius});
    return spheres;
}

/// Touching sphere pairs of different bodies, each with each, and spheres in a floor whose normal is y.
std::int64_t touching(const World& world, const scene::Domain& domain) {
    const std::vector<Placed> spheres = spheres_of(world);
    std::int64_t count = 0;
    for (std::size_t a = 0; a < spheres.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            if (spheres[a].body == spheres[b].body)
                continue;
            Vector3d d = spheres[a].centre - spheres[b].centre;
            for (int k = 0; k < 3; ++k)
                if (domain.periodic[static_cast<std::size_t>(k)]) {
                    const double period = domain.box.hi[k] - domain.box.lo[k];
                    d[k] -= period * std::round(d[k] / period);
                }
            const double reach = spheres[a].radius + spheres[b].radius;
            count += d.squaredNorm() < reach * reach ? 1 : 0;
        }
        for (const scene::WallPose& floor : walls_of(world))
            count += spheres[a].centre.y() - floor.translation.y() < spheres[a].radius ? 1 : 0;
    }
    return count;
}

/// Bodies on a lattice in a box that is periodic along x and z, drifting and sheared as one, each with a motion of its
/// own, a few much faster than the others.
std::vector<BodyState> storm(const std::vector<int>& shapes, double spacing, Rng& rng) {
    std::vector<BodyState> bodies;
    for (int i = 0; i < 7; ++i)
        for (int j = 0; j < 6; ++j)
            for (int k = 0; k < 7; ++k) {
                const Vector3d at = spacing * Vector3d(i + 0.5, j + 0.6, k + 0.5);
                const double own = bodies.size() % 23 == 0 ? 4.0 : 0.4;
                const Vector3d velocity = Vector3d(3.0 + 60 * at.y(), 0.3, -1.0) +
                                          own * Vector3d(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1));
                BodyState body = placed(shapes[bodies.size() % shapes.size()], at, velocity,
                                        200 * Vector3d(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)));
                body.orientation =
                    Eigen::Quaterniond(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1))
                        .normalized();
                bodies.push_back(body);
            }
    return bodies;
}

void hold_contacts_to_brute_force(Sandbox& box, int steps) {
    std::int64_t seen = 0;
    for (int k = 0; k < steps; ++k) {
        const std::int64_t expected = touching(*box.world, box.scene.domain);
        box.run(1);
        CAPTURE(k);
        REQUIRE(books_of(*box.world).contacts == expected);
        seen += expected;
    }
    CHECK(seen > 30 * steps);
}

Sandbox stormy_box() {
    Sandbox box({"media", 1666, 4.6e6, 0.2887}, {0.9, 0.4}, 1e-5);
    box.scene.gravity = {0, -9.81, 0};
    box.scene.domain = {{{0, -0.5, 0}, {0.07, 0.5, 0.07}}, {true, false, true}};
    scene::Wall& floor = box.wall(scene::PlaneShape{});
    floor.motion.harmonics = {{{}, 1, 2e-3, 40, 0.3}};
    return box;
}

} // namespace

TEST_CASE("no contact of spheres in a sheared, shaken storm is ever missed or imagined") {
    Rng rng(5);
    Sandbox box = stormy_box();
    const std::vector<int> shapes{box.ball(4e-3), box.ball(5e-3), box.ball(3.2e-3)};
    box.start(storm(shapes, 0.01, rng));
    hold_contacts_to_brute_force(box, 1500);
}

TEST_CASE("no contact of clumps and spheres in a sheared, shaken storm is ever missed or imagined") {
    Rng rng(6);
    Sandbox box = stormy_box();
    const std::vector<int> shapes{box.body({{{-2e-3, 0, 0}, 3e-3}, {{2e-3, 0, 0}, 2.5e-3}, {{0, 2e-3, 1e-3}, 2e-3}}),
                                  box.ball(4.5e-3)};
    box.start(storm(shapes, 0.01, rng));
    hold_contacts_to_brute_force(box, 700);
}

TEST_CASE("the skin changes how often lists are made and not a contact") {
    for (const double skin : {1e-4, 2e-3}) {
        Rng rng(7);
        Sandbox box = stormy_box();
        box.scene.skin = skin;
        const std::vector<int> shapes{box.ball(4e-3), box.ball(5e-3)};
        box.start(storm(shapes, 0.01, rng));
        hold_contacts_to_brute_force(box, 200);
    }
}

} // namespace test_neighbours
