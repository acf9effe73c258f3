#pragma once

#include "discs/piece_grid.h"
#include "scene/motion.h"
#include "scene/outline.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace tumble::discs {

/// Where a disc touches a wall, in the wall's own frame.
struct WallTouch {
    Eigen::Vector2d normal = Eigen::Vector2d::Zero(); // unit, from the wall's closest point to the disc's centre
    double gap = 0;                                   // m, distance - radius; negative: overlap
    int feature = 0; // the same while the disc stays on one piece or joint; a history belongs to it
};

/// A wall's pose in the plane, from its pose in space.
struct WallFrame {
    Eigen::Matrix2d rotation = Eigen::Matrix2d::Identity();
    Eigen::Vector2d translation = Eigen::Vector2d::Zero(); // m
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();    // m/s, of the point that was the local origin
    double spin = 0;                                       // rad/s

    WallFrame() = default;
    explicit WallFrame(const scene::WallPose& pose)
        : rotation(pose.rotation.topLeftCorner<2, 2>()), translation(pose.translation.head<2>()),
          velocity(pose.velocity.head<2>()), spin(pose.angular_velocity.z()) {}

    [[nodiscard]] Eigen::Vector2d to_wall(const Eigen::Vector2d& world) const {
        return rotation.transpose() * (world - translation);
    }
    [[nodiscard]] Eigen::Vector2d to_world(const Eigen::Vector2d& local) const {
        return rotation * local + translation;
    }
    /// Velocity of the wall's material point now at `world`, m/s.
    [[nodiscard]] Eigen::Vector2d velocity_at(const Eigen::Vector2d& world) const {
        const Eigen::Vector2d arm = world - translation;
        return velocity + spin * Eigen::Vector2d(-arm.y(), arm.x());
    }
};

/// The geometry of a wall in its own, unmoved frame: straight and round pieces, touched from both sides. Where pieces
/// meet, the joint counts as one feature, and only for discs that none of its pieces touches with its inside. Along
/// periodic directions a wall that is no longer than the period stands in three copies.
class WallLine {
public:
    WallLine() = default;
    WallLine(const scene::Outline& outline, const scene::Domain& domain);

    [[nodiscard]] int pieces() const { return static_cast<int>(pieces_.size()); }
    /// All pieces nearer to `centre` than `reach` (m), ascending; `out` is emptied first.
    void pieces_near(const Eigen::Vector2d& centre, double reach, std::vector<int>& out) const;
    /// Distance from the piece to the point, m.
    [[nodiscard]] double distance(int piece, const Eigen::Vector2d& point) const;
    /// Whether the straight way from one point to another (m) passes through one of the pieces.
    [[nodiscard]] bool crossed(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                               std::span<const int> pieces) const;
    /// Touching features (gap < 0), each once, the deepest first if there are more than `out` holds; returns how many.
    /// `pieces` must hold, in ascending order, all that are nearer than `radius`.
    int touches(const Eigen::Vector2d& centre, double radius, std::span<const int> pieces,
                std::span<WallTouch> out) const;

    /// Whether the wall comes back to its beginning everywhere, so that it has an inside: a circle, a box, ...
    [[nodiscard]] bool closed() const { return !rim_.empty(); }
    /// Whether the point lies inside of a closed wall.
    [[nodiscard]] bool encloses(const Eigen::Vector2d& point) const;

private:
    /// The closest point of a piece; `joint` is where it is an end, else -1.
    struct Nearest {
        Eigen::Vector2d point;
        int joint = -1;
    };
    [[nodiscard]] Nearest nearest(int piece, const Eigen::Vector2d& point) const;
    int joint_at(const Eigen::Vector2d& end, double tolerance);

    std::vector<scene::OutlinePiece> pieces_;
    PieceGrid grid_;
    std::vector<std::array<int, 2>> joints_;          // per piece, of its two ends; equal for a whole circle
    std::vector<Eigen::Vector2d> ends_;               // per joint, m
    std::vector<std::array<Eigen::Vector2d, 2>> rim_; // straight lines along a closed wall; empty for an open one
};

} // namespace tumble::discs
