#pragma once

#include "hard2d/wall.h"

#include <box2d/b2_contact.h>
#include <box2d/b2_world_callbacks.h>
#include <vector>

namespace tumble::hard2d {

/// What Box2D asks about its contacts, and what it tells of them.
class Contacts final : public b2ContactListener {
public:
    /// Restitution and friction by materials; impacts below `rebound_above` (Box2D's units per s) come back with
    /// nothing.
    void answer_with(const scene::Scene& scene, double rebound_above);

    void BeginContact(b2Contact* contact) override;
    void PreSolve(b2Contact* contact, const b2Manifold* before) override;
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override;

    /// Done by walls on bodies so far, in Box2D's units of energy: impulses times the velocities of the walls'
    /// surfaces.
    [[nodiscard]] double wall_work() const { return wall_work_; }

private:
    struct Pair {
        float restitution = 0, friction = 0;
    };
    std::size_t materials_ = 0;
    std::vector<Pair> pairs_; // materials squared
    float rebound_above_ = 0;
    double wall_work_ = 0;
};

/// What the fixture is.
const Touchable& touchable(const b2Fixture& fixture);

} // namespace tumble::hard2d
