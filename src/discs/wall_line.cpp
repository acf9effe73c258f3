#include "discs/wall_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::discs {

using Eigen::Vector2d;
using scene::OutlinePiece;

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int lines_per_turn = 180; // of the rim, which is asked only about points further from the wall than a disc

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Whether a round piece, without its ends, stands in that direction from its centre.
bool spans(const OutlinePiece& arc, const Vector2d& out) {
    double angle = std::fmod(std::atan2(out.y(), out.x()) - arc.start, turn);
    angle += angle < 0 ? turn : 0.0;
    return arc.sweep >= turn * (1 - 1e-12) || (angle > 0 && angle < arc.sweep);
}

bool crosses_segment(const OutlinePiece& line, const Vector2d& from, const Vector2d& to) {
    const Vector2d along = line.to - line.from;
    const Vector2d way = to - from;
    // A point on the line itself belongs to one side, or the step before and the one after could both miss it.
    const bool changes_side = (cross(along, from - line.from) > 0) != (cross(along, to - line.from) > 0);
    return changes_side && cross(way, line.from - from) * cross(way, line.to - from) <= 0;
}

bool crosses_arc(const OutlinePiece& arc, const Vector2d& from, const Vector2d& to) {
    // |from + s way - centre| = radius at s = (-b -+ root) / a, of which those between 0 and 1 lie on the way.
    const Vector2d arm = from - arc.centre;
    const Vector2d way = to - from;
    const double a = way.squaredNorm();
    const double b = arm.dot(way);
    const double under_root = b * b - a * (arm.squaredNorm() - arc.radius * arc.radius);
    if (a == 0 || under_root < 0)
        return false;
    for (const double root : {-std::sqrt(under_root), std::sqrt(under_root)})
        if (const double s = (root - b) / a; s > 0 && s <= 1 && spans(arc, arm + s * way))
            return true;
    return false;
}

OutlinePiece moved(OutlinePiece piece, const Vector2d& by) {
    piece.from += by;
    piece.to += by;
    piece.centre += by;
    return piece;
}

/// The pieces and, along periodic directions that they do not outgrow, their copies a period to either side.
std::vector<OutlinePiece> repeated(const std::vector<OutlinePiece>& pieces, const scene::Domain& domain) {
    std::vector<OutlinePiece> all = pieces;
    const scene::Rectangle bounds = scene::bounds_of(pieces);
    for (int axis = 0; axis < 2; ++axis) {
        const double period = domain.box.hi[axis] - domain.box.lo[axis];
        if (!domain.periodic[static_cast<std::size_t>(axis)] || bounds.hi[axis] - bounds.lo[axis] > period * (1 + 1e-9))
            continue;
        const std::vector<OutlinePiece> so_far = all;
        for (const double side : {-1.0, 1.0})
            for (const OutlinePiece& piece : so_far)
                all.push_back(moved(piece, side * period * Vector2d::Unit(axis)));
    }
    return all;
}

} // namespace

WallLine::WallLine(const scene::Outline& outline, const scene::Domain& domain)
    : pieces_(repeated(scene::pieces_of(outline), domain)), grid_(pieces_) {
    const scene::Rectangle bounds = scene::bounds_of(pieces_);
    const double tolerance = 1e-9 * (bounds.hi - bounds.lo).norm();
    for (const OutlinePiece& piece : pieces_)
        joints_.push_back({joint_at(piece.from, tolerance), joint_at(piece.to, tolerance)});
    std::vector<int> ends_at(ends_.size(), 0);
    for (const auto& piece : joints_)
        for (const int joint : piece)
            ++ends_at[static_cast<std::size_t>(joint)];
    if (std::any_of(ends_at.begin(), ends_at.end(), [](int count) { return count != 2; }))
        return;
    for (const OutlinePiece& piece : pieces_) {
        const std::vector<Vector2d> points = scene::points_along(piece, turn / lines_per_turn);
        for (std::size_t k = 1; k < points.size(); ++k)
            rim_.push_back({points[k - 1], points[k]});
    }
}

/// A ray to the right leaves a closed wall once more than it enters.
bool WallLine::encloses(const Vector2d& point) const {
    bool inside = false;
    for (const auto& [a, b] : rim_)
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    return inside;
}

int WallLine::joint_at(const Vector2d& end, double tolerance) {
    for (std::size_t k = 0; k < ends_.size(); ++k)
        if ((ends_[k] - end).norm() <= tolerance)
            return static_cast<int>(k);
    ends_.push_back(end);
    return static_cast<int>(ends_.size()) - 1;
}

WallLine::Nearest WallLine::nearest(int piece, const Vector2d& point) const {
    const OutlinePiece& line = pieces_[static_cast<std::size_t>(piece)];
    const auto [from, to] = joints_[static_cast<std::size_t>(piece)];
    if (!line.round) {
        const Vector2d along = line.to - line.from;
        const double part = (point - line.from).dot(along) / along.squaredNorm();
        if (part <= 0)
            return {line.from, from};
        if (part >= 1)
            return {line.to, to};
        return {line.from + part * along, -1};
    }
    const Vector2d arm = point - line.centre;
    const double far = arm.norm();
    const Vector2d out = far > 0 ? Vector2d(arm / far) : Vector2d(Vector2d::UnitX());
    if (spans(line, out))
        return {line.centre + line.radius * out, -1};
    const bool to_start = (point - line.from).squaredNorm() < (point - line.to).squaredNorm();
    return to_start ? Nearest{line.from, from} : Nearest{line.to, to};
}

double WallLine::distance(int piece, const Vector2d& point) const {
    return (point - nearest(piece, point).point).norm();
}

void WallLine::pieces_near(const Vector2d& centre, double reach, std::vector<int>& out) const {
    grid_.near(centre, reach, out);
    const auto far = [&](int piece) { return distance(piece, centre) >= reach; };
    out.erase(std::remove_if(out.begin(), out.end(), far), out.end());
}

bool WallLine::crossed(const Vector2d& from, const Vector2d& to, std::span<const int> pieces) const {
    return std::any_of(pieces.begin(), pieces.end(), [&](int piece) {
        const OutlinePiece& line = pieces_[static_cast<std::size_t>(piece)];
        return line.round ? crosses_arc(line, from, to) : crosses_segment(line, from, to);
    });
}

int WallLine::touches(const Vector2d& centre, double radius, std::span<const int> pieces,
                      std::span<WallTouch> out) const {
    std::size_t count = 0;
    const auto add = [&](const Vector2d& point, int feature) {
        const Vector2d away = centre - point;
        const double far = away.norm();
        if (far >= radius)
            return;
        const WallTouch touch{far > 0 ? Vector2d(away / far) : Vector2d(Vector2d::UnitY()), far - radius, feature};
        if (count < out.size()) {
            out[count++] = touch;
            return;
        }
        const auto shallowest = std::max_element(out.begin(), out.end(),
                                                 [](const WallTouch& a, const WallTouch& b) { return a.gap < b.gap; });
        if (shallowest->gap > touch.gap)
            *shallowest = touch;
    };
    /// A joint is touched when it is the closest point of every piece that ends there; the first of them says so.
    const auto joint_is_closest = [&](int piece, int joint) {
        for (const int other : pieces) {
            const auto& ends = joints_[static_cast<std::size_t>(other)];
            if (other == piece || (ends[0] != joint && ends[1] != joint))
                continue;
            if (other < piece || nearest(other, centre).joint != joint)
                return false;
        }
        return true;
    };
    for (const int piece : pieces) {
        const Nearest near = nearest(piece, centre);
        if ((centre - near.point).squaredNorm() >= radius * radius)
            continue;
        if (near.joint < 0)
            add(near.point, piece);
        else if (joint_is_closest(piece, near.joint))
            add(near.point, static_cast<int>(pieces_.size()) + near.joint);
    }
    return static_cast<int>(count);
}

} // namespace tumble::discs
