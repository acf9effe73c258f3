#include "hard2d/contacts.h"

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_fixture.h>

namespace tumble::hard2d {

const Touchable& touchable(const b2Fixture& fixture) {
    return *reinterpret_cast<const Touchable*>(const_cast<b2Fixture&>(fixture).GetUserData().pointer);
}

void Contacts::answer_with(const scene::Scene& scene, double rebound_above) {
    materials_ = scene.materials.size();
    for (const contact::PairProperties& pair : scene.pairs)
        pairs_.push_back({static_cast<float>(pair.restitution), static_cast<float>(pair.friction)});
    rebound_above_ = static_cast<float>(rebound_above);
}

void Contacts::BeginContact(b2Contact* contact) {
    const auto material = [](const b2Fixture* fixture) {
        return static_cast<std::size_t>(touchable(*fixture).material);
    };
    const Pair& pair = pairs_[material(contact->GetFixtureA()) * materials_ + material(contact->GetFixtureB())];
    contact->SetRestitution(pair.restitution);
    contact->SetFriction(pair.friction);
    contact->SetRestitutionThreshold(rebound_above_);
}

/// Of an edge and a circle Box2D calls the edge A.
void Contacts::PreSolve(b2Contact* contact, const b2Manifold* /*before*/) {
    const Touchable& a = touchable(*contact->GetFixtureA());
    const b2ContactFeature& feature = contact->GetManifold()->points[0].id.cf;
    if (!a.wall || feature.typeA != b2ContactFeature::e_vertex)
        return;
    const auto* circle = static_cast<const b2CircleShape*>(contact->GetFixtureB()->GetShape());
    const b2Vec2 centre = b2MulT(contact->GetFixtureA()->GetBody()->GetTransform(),
                                 b2Mul(contact->GetFixtureB()->GetBody()->GetTransform(), circle->m_p));
    if (!a.wall->touched_at_end(a.chord, feature.indexA, centre))
        contact->SetEnabled(false);
}

void Contacts::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) {
    const b2Body& wall = *contact->GetFixtureA()->GetBody();
    if (wall.GetType() != b2_kinematicBody)
        return;
    b2WorldManifold at;
    contact->GetWorldManifold(&at);
    const b2Vec2 velocity = wall.GetLinearVelocityFromWorldPoint(at.points[0]);
    const b2Vec2 push =
        impulse->normalImpulses[0] * at.normal + impulse->tangentImpulses[0] * b2Cross(at.normal, 1.0F); // on body B
    wall_work_ += static_cast<double>(b2Dot(push, velocity));
}

} // namespace tumble::hard2d
