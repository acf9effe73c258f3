#include "hard2d/wall.h"

#include <algorithm>
#include <box2d/b2_body.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <cmath>
#include <numbers>

namespace tumble::hard2d {

namespace {

using Eigen::Vector2d;

constexpr float joint_tolerance = 1e-4F; // of the smallest radius

/// Angle between points on a circle of that radius (Box2D's units) whose chord stays within the slop of it: its height
/// is r (1 - cos(angle / 2)).
double chord_angle(double radius) {
    return 2 * std::acos(std::clamp(1 - b2_linearSlop / radius, 0.0, 1.0));
}

double angle_of(const scene::WallPose& pose) {
    return std::atan2(pose.rotation(1, 0), pose.rotation(0, 0));
}

b2Vec2 origin_of(const scene::WallPose& pose, const Vector2d& middle, const Units& units) {
    return units.place(pose.rotation.topLeftCorner<2, 2>() * middle + pose.translation.head<2>());
}

} // namespace

Wall::Wall(const scene::Wall& wall, const scene::Domain& domain, const Units& units, b2World& box)
    : motion_(wall.motion), line_(wall.outline, domain) {
    const std::vector<scene::OutlinePiece> pieces = scene::pieces_of(wall.outline);
    const scene::Rectangle bounds = scene::bounds_of(pieces);
    middle_ = (bounds.lo + bounds.hi) / 2;
    for (const scene::OutlinePiece& piece : pieces) {
        const std::vector<Vector2d> points = scene::points_along(piece, chord_angle(piece.radius * units.length));
        for (std::size_t k = 1; k < points.size(); ++k) {
            const b2Vec2 from = units.rate(points[k - 1] - middle_), to = units.rate(points[k] - middle_);
            chords_.push_back({{from, to}, {joint_at(from), joint_at(to)}});
        }
    }
    chords_at_.resize(joints_.size());
    for (std::size_t k = 0; k < chords_.size(); ++k) {
        touchables_.push_back({wall.material, this, k});
        for (const int joint : chords_[k].joints)
            chords_at_[static_cast<std::size_t>(joint)].push_back(k);
    }

    const scene::WallPose pose = scene::pose_at(motion_, 0);
    b2BodyDef definition;
    definition.type = motion_.at_rest() ? b2_staticBody : b2_kinematicBody;
    definition.position = origin_of(pose, middle_, units);
    definition.angle = static_cast<float>(angle_of(pose));
    body_ = box.CreateBody(&definition);
    for (std::size_t k = 0; k < chords_.size(); ++k) {
        b2EdgeShape edge;
        edge.SetTwoSided(chords_[k].ends[0], chords_[k].ends[1]);
        edge.m_radius = 0; // Box2D's skin is for polygons; discs have their own radius
        b2FixtureDef fixture;
        fixture.shape = &edge;
        fixture.userData.pointer = reinterpret_cast<std::uintptr_t>(&touchables_[k]);
        body_->CreateFixture(&fixture);
    }
}

int Wall::joint_at(const b2Vec2& end) {
    for (std::size_t k = 0; k < joints_.size(); ++k)
        if (b2Distance(joints_[k], end) < joint_tolerance)
            return static_cast<int>(k);
    joints_.push_back(end);
    return static_cast<int>(joints_.size()) - 1;
}

void Wall::send_to(const scene::WallPose& pose, const Units& units, double dt) {
    if (body_->GetType() == b2_staticBody)
        return;
    // From where rounding has left it, so that no error adds up.
    const b2Vec2 way = origin_of(pose, middle_, units) - body_->GetPosition();
    const double turn = static_cast<float>(angle_of(pose)) - static_cast<double>(body_->GetAngle());
    const auto per_step = static_cast<float>(1 / dt);
    body_->SetLinearVelocity(per_step * way);
    body_->SetAngularVelocity(static_cast<float>(std::remainder(turn, 2 * std::numbers::pi) / dt));
}

bool Wall::touched_at_end(std::size_t chord, int end, const b2Vec2& centre) const {
    const int joint = chords_[chord].joints[static_cast<std::size_t>(end)];
    for (const std::size_t other : chords_at_[static_cast<std::size_t>(joint)]) {
        if (other == chord)
            continue;
        const Chord& line = chords_[other];
        const std::size_t near = line.joints[0] == joint ? 0 : 1;
        const b2Vec2 along = line.ends[1 - near] - line.ends[near];
        if (other < chord || b2Dot(centre - line.ends[near], along) > 0)
            return false;
    }
    return true;
}

} // namespace tumble::hard2d
