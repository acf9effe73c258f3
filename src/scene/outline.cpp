#include "scene/outline.h"

#include "scene/trough_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::scene {

using Eigen::Vector2d;

namespace {

constexpr double pi = std::numbers::pi;

Vector2d on_circle(const Vector2d& centre, double radius, double angle) {
    return centre + radius * Vector2d(std::cos(angle), std::sin(angle));
}

struct Pieces {
    std::vector<OutlinePiece> operator()(const SegmentShape& shape) const { return {straight(shape.from, shape.to)}; }

    std::vector<OutlinePiece> operator()(const ArcShape& shape) const {
        return {arc(shape.centre, shape.radius, shape.start, shape.sweep)};
    }

    std::vector<OutlinePiece> operator()(const PolylineShape& shape) const {
        std::vector<OutlinePiece> pieces;
        for (std::size_t i = 1; i < shape.points.size(); ++i)
            pieces.push_back(straight(shape.points[i - 1], shape.points[i]));
        if (shape.closed && shape.points.size() > 2)
            pieces.push_back(straight(shape.points.back(), shape.points.front()));
        return pieces;
    }

    std::vector<OutlinePiece> operator()(const BoxShape& shape) const {
        const Vector2d lo = shape.box.lo.head<2>(), hi = shape.box.hi.head<2>();
        const Vector2d corners[4] = {lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}};
        constexpr std::size_t face[4] = {2, 1, 3, 0}; // -y, +x, +y, -x
        std::vector<OutlinePiece> pieces;
        for (std::size_t side = 0; side < 4; ++side)
            if (!shape.open[face[side]])
                pieces.push_back(straight(corners[side], corners[(side + 1) % 4]));
        return pieces;
    }

    /// From the rim at negative x over the bottom to the other rim; a rim below the sides' start cuts the arc.
    std::vector<OutlinePiece> operator()(const TroughShape& shape) const {
        const TroughProfile profile = profile_of(shape);
        const OutlinePiece bottom =
            arc({0, profile.centre}, shape.radius, -pi / 2 - profile.arc_end, 2 * profile.arc_end);
        if (!profile.side)
            return {bottom};
        const double lean = (shape.rim - bottom.to.y()) * std::tan(shape.flare);
        return {straight({bottom.from.x() - lean, shape.rim}, bottom.from), bottom,
                straight(bottom.to, {bottom.to.x() + lean, shape.rim})};
    }
};

} // namespace

OutlinePiece straight(const Vector2d& from, const Vector2d& to) {
    OutlinePiece piece;
    piece.from = from;
    piece.to = to;
    return piece;
}

OutlinePiece arc(const Vector2d& centre, double radius, double start, double sweep) {
    OutlinePiece piece;
    piece.round = true;
    piece.from = on_circle(centre, radius, start);
    piece.to = on_circle(centre, radius, start + sweep);
    piece.centre = centre;
    piece.radius = radius;
    piece.start = start;
    piece.sweep = sweep;
    return piece;
}

std::vector<OutlinePiece> pieces_of(const Outline& outline) {
    return std::visit(Pieces{}, outline);
}

std::vector<Vector2d> points_along(const OutlinePiece& piece, double step) {
    if (!piece.round)
        return {piece.from, piece.to};
    const int parts = std::max(1, static_cast<int>(std::ceil(piece.sweep / step - 1e-9)));
    std::vector<Vector2d> points{piece.from};
    for (int i = 1; i < parts; ++i)
        points.push_back(on_circle(piece.centre, piece.radius, piece.start + piece.sweep * i / parts));
    points.push_back(piece.to);
    return points;
}

Rectangle bounds_of(const std::vector<OutlinePiece>& pieces) {
    Rectangle box{Vector2d::Constant(1e300), Vector2d::Constant(-1e300)};
    const auto extend = [&](const Vector2d& point) {
        box.lo = box.lo.cwiseMin(point);
        box.hi = box.hi.cwiseMax(point);
    };
    for (const OutlinePiece& piece : pieces) {
        extend(piece.from);
        extend(piece.to);
        for (int quarter = -8; piece.round && quarter <= 8; ++quarter) {
            const double angle = quarter * pi / 2;
            if (angle > piece.start && angle < piece.start + piece.sweep)
                extend(on_circle(piece.centre, piece.radius, angle));
        }
    }
    return box;
}

} // namespace tumble::scene
