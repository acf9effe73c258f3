#include "hard2d/world.h"

#include <algorithm>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <unordered_map>

namespace tumble::hard2d {

namespace {

Eigen::Vector3d in_space(const Eigen::Vector2d& v) {
    return {v.x(), v.y(), 0};
}

int index_of(const World& world, const Wall* wall) {
    const auto found = std::find_if(world.walls.begin(), world.walls.end(), [&](const Wall& w) { return &w == wall; });
    return static_cast<int>(found - world.walls.begin());
}

} // namespace

/// Box2D's impulses on body B of a contact; of an edge and a circle it calls the edge A.
std::vector<ContactPush> contacts_of(const World& world) {
    std::unordered_map<const b2Body*, std::int64_t> ids;
    for (std::size_t id = 0; id < world.bodies.size(); ++id)
        ids[world.bodies[id]] = static_cast<std::int64_t>(id);
    std::vector<ContactPush> pushes;
    for (b2Contact* contact = world.box->GetContactList(); contact; contact = contact->GetNext()) {
        const b2Manifold& manifold = *contact->GetManifold();
        if (!contact->IsTouching() || !contact->IsEnabled() || manifold.pointCount == 0)
            continue;
        const b2ManifoldPoint& place = manifold.points[0];
        if (place.normalImpulse == 0 && place.tangentImpulse == 0)
            continue;
        b2WorldManifold at;
        contact->GetWorldManifold(&at);
        const b2Vec2 impulse = place.normalImpulse * at.normal + place.tangentImpulse * b2Cross(at.normal, 1.0F);
        const Touchable& other = touchable(*contact->GetFixtureA());
        ContactPush push{.a = ids.at(contact->GetFixtureB()->GetBody()),
                         .point = in_space(world.units.place(at.points[0])),
                         .normal = in_space({at.normal.x, at.normal.y}),
                         .force = in_space(world.units.rate(impulse) / (world.units.mass * world.dt))};
        if (other.wall)
            push.wall = index_of(world, other.wall);
        else
            push.b = ids.at(contact->GetFixtureA()->GetBody());
        pushes.push_back(push);
    }
    return pushes;
}

} // namespace tumble::hard2d
