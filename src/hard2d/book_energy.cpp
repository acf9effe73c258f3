#include "hard2d/step.h"

#include <algorithm>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_fixture.h>
#include <cmath>
#include <limits>

namespace tumble::hard2d {

namespace {

/// The radius of the smaller disc of a contact, in Box2D's units; a wall is not asked.
double smaller_radius(const b2Contact& contact) {
    const auto radius = [](const b2Fixture& fixture) { return static_cast<double>(fixture.GetShape()->m_radius); };
    const double b = radius(*contact.GetFixtureB());
    return touchable(*contact.GetFixtureA()).wall ? b : std::min(b, radius(*contact.GetFixtureA()));
}

void look_at_contacts(const World& world, Books& books) {
    for (const b2Contact* contact = world.box->GetContactList(); contact; contact = contact->GetNext()) {
        if (!contact->IsTouching() || !contact->IsEnabled())
            continue;
        ++books.contacts;
        b2WorldManifold at;
        contact->GetWorldManifold(&at);
        const double overlap = -static_cast<double>(at.separations[0]);
        books.overlap_max = std::max(books.overlap_max, overlap / world.units.length);
        books.overlap_ratio_max = std::max(books.overlap_ratio_max, overlap / smaller_radius(*contact));
    }
}

void look_at_bodies(const World& world, Books& books) {
    for (const BodyState& body : bodies_of(world)) {
        const BodyShape& shape = world.shape_of(static_cast<std::size_t>(body.id));
        books.kinetic_translation += 0.5 * shape.mass * body.velocity.squaredNorm();
        books.kinetic_rotation += 0.5 * shape.inertia * body.angular_velocity * body.angular_velocity;
        books.gravity -= shape.mass * world.scene.gravity.head<2>().dot(body.position);
        books.speed_max = std::max(books.speed_max, body.velocity.norm());
        books.angular_speed_max = std::max(books.angular_speed_max, std::abs(body.angular_velocity));
    }
}

} // namespace

Books account_of(const World& world) {
    Books books;
    books.time = world.time();
    books.step = world.step;
    books.bodies = static_cast<std::int64_t>(world.bodies.size());
    look_at_bodies(world, books);
    look_at_contacts(world, books);
    books.overlap_ratio_peak = std::max(world.overlap_ratio_peak, books.overlap_ratio_max);
    books.inserted = world.inserted;
    books.wall_work = world.contacts.wall_work() / (world.units.mass * world.units.length * world.units.length);
    books.splits_losses = false;
    books.closure = std::numeric_limits<double>::quiet_NaN(); // the sum of losses is what closes it
    books.lost_in_sum =
        books.inserted + books.wall_work - books.kinetic_translation - books.kinetic_rotation - books.gravity;
    return books;
}

void book_energy(World& world) {
    ++world.step;
    world.books = account_of(world);
    world.overlap_ratio_peak = world.books.overlap_ratio_peak;
}

} // namespace tumble::hard2d
