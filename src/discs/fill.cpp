#include "discs/fill.h"

#include "discs/crowd.h"
#include "scene/period.h"
#include "scene/written.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::discs {

namespace {

using Eigen::Vector3d;

double angle_for(FillState& fill) {
    return fill.fill.orientation == scene::Orientation::random ? fill.rng.uniform(0, 2 * std::numbers::pi) : 0.0;
}

bool inside_region(const scene::Domain& domain, const scene::Box& region, const std::vector<Disc>& discs) {
    for (const Disc& disc : discs)
        for (int axis = 0; axis < 2; ++axis)
            if (!scene::spans_period(domain, region, axis) && (disc.centre[axis] - disc.radius < region.lo[axis] ||
                                                               disc.centre[axis] + disc.radius > region.hi[axis]))
                return false;
    return true;
}

BodyState state_of(const scene::Fill& fill, const Placement& body) {
    BodyState state;
    state.shape = fill.body;
    state.position = body.position;
    state.angle = body.angle;
    state.velocity = fill.velocity.head<2>();
    state.angular_velocity = fill.angular_velocity.z();
    return state;
}

const std::string& name_of(const std::vector<ShapeData>& shapes, const FillState& fill) {
    return shapes[static_cast<std::size_t>(fill.fill.body)].shape.name;
}

std::string owed(const std::vector<ShapeData>& shapes, const FillState& fill) {
    const Vector3d size = fill.fill.region.hi - fill.fill.region.lo;
    return fmt::format("asked for {} of body '{}', placed {} in the region of {:.4g} x {:.4g} m; {} did not fit",
                       fill.asked, name_of(shapes, fill), fill.placed, size.x(), size.y(), fill.asked - fill.placed);
}

Problem no_room_at(const Site& site, const FillState& fill, const std::string& key, const std::string& what_is_there) {
    const Vector3d& at = *fill.fill.position;
    return scene::problem_about(site.scene, key + ".position_m",
                                fmt::format("body '{}' at ({:.6g}, {:.6g}) m overlaps {} at t = {:.6g} s",
                                            name_of(site.shapes, fill), at.x(), at.y(), what_is_there,
                                            static_cast<double>(site.step) * site.dt),
                                "move it, or let it come at another time");
}

/// A closed wall, and whether bodies come in inside of it.
struct Side {
    const StandingWall* wall = nullptr;
    bool inside = false;
};

/// A region may reach through a closed wall, as a square about a round drum does: bodies then come in on the side on
/// which most of the region lies.
std::vector<Side> sides_for(const scene::Box& region, const std::vector<StandingWall>& walls) {
    constexpr int looks = 15; // along either axis
    std::vector<Side> sides;
    for (const StandingWall& wall : walls) {
        if (!wall.line->closed())
            continue;
        int inside = 0;
        for (int k = 0; k < looks * looks; ++k) {
            const int row = k / looks;
            const Eigen::Vector2d share((k % looks + 0.5) / looks, (row + 0.5) / looks);
            const Eigen::Vector2d point = region.lo.head<2>() + share.cwiseProduct((region.hi - region.lo).head<2>());
            inside += wall.line->encloses(wall.frame.to_wall(point)) ? 1 : -1;
        }
        sides.push_back({&wall, inside > 0});
    }
    return sides;
}

bool on_their_sides(const std::vector<Side>& sides, const Eigen::Vector2d& position) {
    return std::all_of(sides.begin(), sides.end(), [&](const Side& side) {
        return side.wall->line->encloses(side.wall->frame.to_wall(position)) == side.inside;
    });
}

class Placer {
public:
    /// `discs`: how many may come.
    Placer(const Site& site, std::int64_t discs, solver::PlacedCount count)
        : site_(site), crowd_(site.scene.domain, site.shapes, site.bodies, discs), count_(count) {}

    /// `key`: of the fill in its scene, for problems.
    std::optional<Problem> place(FillState& fill, const std::string& key) {
        const std::size_t before = placed_.size();
        if (fill.fill.position) {
            if (auto problem = at_its_position(fill, key))
                return problem;
        } else if (!at_random(fill)) {
            return std::nullopt;
        }
        fill.note(static_cast<std::int64_t>(placed_.size() - before), site_.step, site_.dt);
        if (!fill.failed())
            return std::nullopt;
        return scene::problem_about(
            site_.scene, key, owed(site_.shapes, fill),
            "enlarge the region, ask for fewer, or give until_s so that bodies come in over time");
    }

    [[nodiscard]] std::vector<BodyState> placed() && { return std::move(placed_); }

private:
    std::optional<Problem> at_its_position(FillState& fill, const std::string& key) {
        const Placement body{fill.fill.body, fill.fill.position->head<2>(), angle_for(fill)};
        const std::vector<Disc> discs = discs_of(site_.shapes, body);
        if (const auto met = wall_met(site_.walls, discs))
            return no_room_at(site_, fill, key, fmt::format("wall '{}'", site_.scene.walls[*met].name));
        if (!crowd_.leaves_room_for(discs))
            return no_room_at(site_, fill, key, "another body");
        keep(fill, body, discs);
        return std::nullopt;
    }

    /// False, and nothing has changed, where a stop ended the search.
    bool at_random(FillState& fill) {
        const Rng rng = fill.rng;
        const std::size_t before = placed_.size();
        const scene::Box& region = fill.fill.region;
        const std::vector<Side> sides = sides_for(region, site_.walls);
        std::int64_t missing = fill.asked - fill.placed;
        int misses = 0;
        while (missing > 0 && misses < solver::misses_until_full && !stop_wanted(site_.stop)) {
            Placement body{fill.fill.body, {}, 0};
            for (int axis = 0; axis < 2; ++axis)
                body.position[axis] = fill.rng.uniform(region.lo[axis], region.hi[axis]);
            body.angle = angle_for(fill);
            const std::vector<Disc> discs = discs_of(site_.shapes, body);
            if (!inside_region(site_.scene.domain, region, discs) || wall_met(site_.walls, discs) ||
                !on_their_sides(sides, body.position) || !crowd_.leaves_room_for(discs)) {
                ++misses;
                continue;
            }
            misses = 0;
            --missing;
            keep(fill, body, discs);
        }
        if (!stop_wanted(site_.stop))
            return true;
        fill.rng = rng;
        placed_.resize(before);
        return false;
    }

    void keep(const FillState& fill, const Placement& body, const std::vector<Disc>& discs) {
        crowd_.add(discs);
        placed_.push_back(state_of(fill.fill, body));
        count_.one_more();
    }

    const Site& site_;
    Crowd crowd_;
    solver::PlacedCount count_;
    std::vector<BodyState> placed_;
};

} // namespace

Result<std::vector<BodyState>> place_due(std::vector<FillState>& fills, const Site& site) {
    const auto due = [&](const FillState& fill) { return fill.due(site.step) && !stop_wanted(site.stop); };
    std::int64_t discs = 0;
    for (const FillState& fill : fills)
        if (due(fill))
            discs +=
                (fill.fill.position ? 1 : fill.asked - fill.placed) *
                static_cast<std::int64_t>(site.shapes[static_cast<std::size_t>(fill.fill.body)].exposed.size() / 3);
    Placer placer(site, discs, {fills, site.step, site.tally});
    for (std::size_t k = 0; k < fills.size(); ++k)
        if (due(fills[k]))
            if (auto problem = placer.place(fills[k], fmt::format("fill.{}", k)))
                return *problem;
    return std::move(placer).placed();
}

std::vector<std::string> owed_by(const std::vector<FillState>& fills, const std::vector<ShapeData>& shapes) {
    std::vector<std::string> reports;
    for (const FillState& fill : fills)
        if (fill.owes())
            reports.push_back(owed(shapes, fill));
    return reports;
}

} // namespace tumble::discs
