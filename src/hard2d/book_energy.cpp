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

} // namespace

Books account_of(const World& world) {
    Books books;
    books.time = world.time();
    books.step = world.step;
    books.bodies = static_cast<std::int64_t>(world.bodies.size());
    discs::book_motion(bodies_of(world), world.plain_shapes, world.scene.gravity, books);
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
