#pragma once

#include "discs/wall_line.h"
#include "hard2d/units.h"
#include "scene/motion.h"
#include "scene/scene.h"

#include <array>
#include <box2d/b2_world.h>
#include <vector>

namespace tumble::hard2d {

/// What a fixture is; Box2D's contacts hand it back.
struct Touchable {
    int material = 0;
    const class Wall* wall = nullptr; // null: a disc of a body
    std::size_t chord = 0;            // of the wall
};

/// A wall in Box2D: a body of straight chords that nothing can push. Round pieces are cut into chords that stay within
/// Box2D's slop of their circle.
class Wall {
public:
    Wall(const scene::Wall& wall, const scene::Domain& domain, const Units& units, b2World& box);
    Wall(const Wall&) = delete; // fixtures point into it
    Wall& operator=(const Wall&) = delete;

    [[nodiscard]] const scene::WallMotion& motion() const { return motion_; }
    [[nodiscard]] const discs::WallLine& line() const { return line_; }

    /// Sets the velocity that takes the wall to that pose in one step of `dt` (s).
    void send_to(const scene::WallPose& pose, const Units& units, double dt);

    /// Whether a disc whose centre is there (wall's frame, Box2D's units) touches the chord with the end `end` (0 or 1)
    /// in its own right. At a joint only discs do that no chord there touches with its inside, and only once: Box2D
    /// would let a disc that rolls along a straight wall stumble over every joint.
    [[nodiscard]] bool touched_at_end(std::size_t chord, int end, const b2Vec2& centre) const;

private:
    struct Chord {
        std::array<b2Vec2, 2> ends;
        std::array<int, 2> joints;
    };
    int joint_at(const b2Vec2& end);

    scene::WallMotion motion_;
    discs::WallLine line_;                             // for fills
    Eigen::Vector2d middle_ = Eigen::Vector2d::Zero(); // m, of the unmoved wall: the body's origin
    std::vector<Chord> chords_;
    std::vector<b2Vec2> joints_;
    std::vector<std::vector<std::size_t>> chords_at_; // per joint
    std::vector<Touchable> touchables_;               // per chord
    b2Body* body_ = nullptr;
};

} // namespace tumble::hard2d
