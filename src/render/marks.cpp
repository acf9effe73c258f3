#include "render/marks.h"

#include "render/strokes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>

namespace tumble::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Units of pixels.
constexpr double trail_thickness = 2.4;
constexpr double trail_dot = 4.5;
// Lines of the weakest contacts would only be a haze: those below this share of the thickest are left out.
constexpr double weakest_chain = 0.01;
// What a single body did that flew by is no mean: cells with less than this share of what cells hold are left out.
constexpr double emptiest_cell = 0.1;

/// Readable on both backgrounds and apart from each other for all eyes: M. Okabe and K. Ito, 2008.
constexpr std::array<std::array<double, 3>, 5> trail_colors{
    {{0.90, 0.62, 0.00}, {0.34, 0.71, 0.91}, {0.84, 0.37, 0.00}, {0.80, 0.47, 0.65}, {0.00, 0.62, 0.45}}};

static Vector3d trail_color(std::size_t trail) {
    return Vector3d(trail_colors[trail % trail_colors.size()].data());
}

static bool same_view(const Camera& a, const Camera& b) {
    return a.axes == b.axes && a.eye == b.eye && a.scale == b.scale && a.centre == b.centre &&
           a.perspective == b.perspective;
}

/// Where a point of the world (m) is seen; nothing for what is not a number or behind the eye.
static std::optional<Vector2d> seen_at(const MarkView& view, const Vector3d& point) {
    if (!point.allFinite() || (view.camera.perspective && view.camera.to_view(point).z() >= 0)) {
        return std::nullopt;
    }
    return view.camera.to_picture(point);
}

static bool inside(const Area& area, const Vector2d& p) {
    return p.x() >= area.left && p.x() < area.right && p.y() >= area.top && p.y() < area.bottom;
}

/// Of the bodies that have marks: the place in the picture.
static std::optional<Vector2d> marked_at(const MarkView& view, const Vector3d& position) {
    if (view.clip && !view.clip->contains(position)) {
        return std::nullopt;
    }
    const auto place = seen_at(view, position);
    return place && inside(view.window, *place) ? place : std::nullopt;
}

/// m/s, right and up in the picture.
static Vector2d in_picture(const Camera& camera, const Vector3d& velocity) {
    return {camera.axes.row(0).dot(velocity), camera.axes.row(1).dot(velocity)};
}

static std::pair<int, int> cell_at(const Vector2d& place, double width) {
    return {static_cast<int>(std::floor(place.x() / width)), static_cast<int>(std::floor(place.y() / width))};
}

static double mass_of(const observe::Frame& frame, std::size_t body) {
    const double mass = frame.layout->shapes[static_cast<std::size_t>(frame.shape[body])].mass;
    return mass > 0 ? mass : 1;
}

void MarkMaker::restyle(const scene::Marks& wanted) {
    if (wanted.arrows != wanted_.arrows) {
        speeds_ = ColorRange(std::nullopt, false);
        field_.clear();
        foreseen_ = false;
    }
    if (wanted.trails != wanted_.trails) {
        trails_.clear();
    }
    wanted_ = wanted;
}

bool MarkMaker::any() const {
    return wanted_.arrows != "none" || wanted_.chains || !wanted_.trails.empty();
}

void MarkMaker::foresee(const observe::Frame& frame, const MarkView& view) {
    if (wanted_.arrows == "field") {
        add_to_field(frame, view);
        foreseen_ = true;
    }
}

/// The mean of what was gathered before, with another camera or of a later time, means nothing now.
void MarkMaker::add_to_field(const observe::Frame& frame, const MarkView& view) {
    if (!seen_ || !same_view(*seen_, view.camera)) {
        field_.clear();
        seen_ = view.camera;
    } else if (frame.time < gathered_) {
        field_.clear();
    } else if (frame.time == gathered_ && !field_.empty()) {
        return;
    }
    gathered_ = frame.time;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const Vector2d velocity = in_picture(view.camera, frame.velocity[b]);
        if (const auto place = marked_at(view, frame.position[b]); place && velocity.allFinite()) {
            Cell& cell = field_[cell_at(*place, field_spacing * view.unit)];
            cell.mass += mass_of(frame, b);
            cell.momentum += mass_of(frame, b) * velocity;
        }
    }
}

std::vector<MarkMaker::FieldArrow> MarkMaker::means() const {
    double mass = 0; // kg, of all
    for (const auto& [place, cell] : field_) {
        mass += cell.mass;
    }
    std::vector<FieldArrow> arrows;
    for (const auto& [place, cell] : field_) {
        if (cell.mass >= emptiest_cell * mass / static_cast<double>(field_.size())) {
            arrows.push_back({place.first, place.second, cell.momentum / cell.mass});
        }
    }
    return arrows;
}

std::vector<double> MarkMaker::mean_speeds() const {
    std::vector<double> speeds;
    for (const FieldArrow& arrow : means()) {
        speeds.push_back(arrow.velocity.norm());
    }
    return speeds;
}

void MarkMaker::take_in(const observe::Frame& frame, const MarkView& view) {
    if (wanted_.arrows == "bodies") {
        std::vector<double> speeds;
        for (const Vector3d& velocity : frame.velocity) {
            speeds.push_back(velocity.norm());
        }
        speed_ = wanted_.arrow_speed.value_or(speeds_.next(speeds).hi);
    }
    if (wanted_.arrows == "field") {
        const bool kept = foreseen_ && seen_ && same_view(*seen_, view.camera);
        if (!kept) {
            foreseen_ = false;
            add_to_field(frame, view);
        }
        speed_ = wanted_.arrow_speed.value_or(speeds_.next(mean_speeds()).hi);
    }
    if (wanted_.chains && frame.contacts) {
        std::vector<double> forces;
        for (const observe::FrameContact& contact : *frame.contacts) {
            forces.push_back(contact.pressing());
        }
        force_ = wanted_.chain_force.value_or(forces_.next(forces).hi);
    }
    follow(frame);
}

/// Index of the body that a trail is of: one of that name, the first, or of that id.
static std::optional<std::size_t> body_of(const observe::Frame& frame, const std::string& trail) {
    const bool number = std::all_of(trail.begin(), trail.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const observe::FrameShape& shape = frame.layout->shapes[static_cast<std::size_t>(frame.shape[b])];
        if (shape.name == trail || (number && std::to_string(frame.id[b]) == trail)) {
            return b;
        }
    }
    return std::nullopt;
}

void MarkMaker::follow(const observe::Frame& frame) {
    trails_.resize(wanted_.trails.size());
    for (std::size_t t = 0; t < trails_.size(); ++t) {
        std::erase_if(trails_[t], [&](const Step& step) { return step.time >= frame.time; });
        if (const auto body = body_of(frame, wanted_.trails[t]); body && frame.position[*body].allFinite()) {
            trails_[t].push_back({frame.time, frame.position[*body]});
        }
    }
}

std::vector<Patch> MarkMaker::patches(const observe::Frame& frame, const MarkView& view) const {
    std::vector<Patch> patches;
    if (wanted_.chains) {
        add_chains(frame, view, patches);
    }
    if (wanted_.arrows == "bodies") {
        add_arrows(frame, view, patches);
    }
    if (wanted_.arrows == "field") {
        add_field(view, patches);
    }
    add_trails(frame, view, patches);
    return patches;
}

/// Of the bodies within one square of the grid one has its arrow: in space the one nearest to the eye, which hides
/// others; in the plane the one nearest to the square's middle.
void MarkMaker::add_arrows(const observe::Frame& frame, const MarkView& view, std::vector<Patch>& patches) const {
    struct Chosen {
        std::size_t body = 0;
        double merit = 0;
    };
    const double width = arrow_spacing * view.unit;
    std::map<std::pair<int, int>, Chosen> chosen;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const auto place = marked_at(view, frame.position[b]);
        if (!place || !frame.velocity[b].allFinite()) {
            continue;
        }
        const auto cell = cell_at(*place, width);
        const Vector2d middle{(cell.first + 0.5) * width, (cell.second + 0.5) * width};
        const double merit =
            frame.layout->dimension == 2 ? -(*place - middle).norm() : view.camera.to_view(frame.position[b]).z();
        const auto [found, is_new] = chosen.try_emplace(cell, Chosen{b, merit});
        if (!is_new && merit > found->second.merit) {
            found->second = {b, merit};
        }
    }
    const double pixels = arrow_length * view.unit / speed_;
    for (const auto& [cell, one] : chosen) {
        const Vector2d velocity = in_picture(view.camera, frame.velocity[one.body]);
        add_arrow(patches, *seen_at(view, frame.position[one.body]), pixels * Vector2d(velocity.x(), -velocity.y()),
                  {view.unit, view.theme.arrow, view.theme.background});
    }
}

void MarkMaker::add_field(const MarkView& view, std::vector<Patch>& patches) const {
    const double width = field_spacing * view.unit;
    const double pixels = arrow_length * view.unit / speed_;
    for (const FieldArrow& arrow : means()) {
        const Vector2d way = pixels * Vector2d(arrow.velocity.x(), -arrow.velocity.y());
        const Vector2d middle{(arrow.column + 0.5) * width, (arrow.row + 0.5) * width};
        add_arrow(patches, middle - 0.5 * way, way, {view.unit, view.theme.arrow, view.theme.background});
    }
}

namespace {

struct ChainPiece {
    Vector2d from, to;
    double thickness = 0;
};

/// Periods that lie between a body and the place where it touches.
Vector3d periods_between(const observe::FrameLayout& layout, const Vector3d& way) {
    Vector3d shift = Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        const double period = layout.domain_hi[axis] - layout.domain_lo[axis];
        if (layout.periodic[static_cast<std::size_t>(axis)] && period > 0) {
            shift[axis] = period * std::round(way[axis] / period);
        }
    }
    return shift;
}

void add_piece(std::vector<ChainPiece>& pieces, const MarkView& view, const Vector3d& from, const Vector3d& to,
               double thickness) {
    const auto a = seen_at(view, from);
    const auto b = seen_at(view, to);
    if (a && b) {
        pieces.push_back({*a, *b, thickness});
    }
}

} // namespace

/// From centre to contact and on to the other centre; across a periodic side half a line on either side. The strongest
/// lie on top.
void MarkMaker::add_chains(const observe::Frame& frame, const MarkView& view, std::vector<Patch>& patches) const {
    if (!frame.contacts) {
        return;
    }
    std::map<std::int64_t, std::size_t> index;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        index[frame.id[b]] = b;
    }
    const auto place_of = [&](std::int64_t id) -> const Vector3d* {
        const auto found = index.find(id);
        const bool shown = found != index.end() && (!view.clip || view.clip->contains(frame.position[found->second]));
        return shown ? &frame.position[found->second] : nullptr;
    };
    std::vector<ChainPiece> pieces;
    for (const observe::FrameContact& contact : *frame.contacts) {
        const double share = contact.pressing() / force_;
        const Vector3d* a = place_of(contact.a);
        const Vector3d* b = contact.b >= 0 ? place_of(contact.b) : nullptr;
        if (!(share > weakest_chain) || a == nullptr || (contact.b >= 0 && b == nullptr)) {
            continue;
        }
        const double thickness = share * chain_thickness * view.unit;
        add_piece(pieces, view, *a, contact.point, thickness);
        if (b != nullptr) {
            const Vector3d shift = periods_between(*frame.layout, *b - contact.point);
            add_piece(pieces, view, contact.point + shift, *b, thickness);
        }
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const ChainPiece& one, const ChainPiece& other) { return one.thickness < other.thickness; });
    for (const ChainPiece& piece : pieces) {
        add_line(patches, piece.from, piece.to, piece.thickness, {view.unit, view.theme.chain, view.theme.background});
    }
}

void MarkMaker::add_trails(const observe::Frame& frame, const MarkView& view, std::vector<Patch>& patches) const {
    const double thickness = trail_thickness * view.unit;
    for (std::size_t t = 0; t < trails_.size(); ++t) {
        const Ink ink{view.unit, trail_color(t), view.theme.background};
        const std::vector<Step>& steps = trails_[t];
        for (const bool halo : {true, false}) {
            for (std::size_t k = 1; k < steps.size(); ++k) {
                const auto from = seen_at(view, steps[k - 1].place);
                const auto to = seen_at(view, steps[k].place);
                // A step through a periodic side is no way across the picture.
                if (from && to && periods_between(*frame.layout, steps[k].place - steps[k - 1].place).isZero()) {
                    add_bare_line(patches, *from, *to, halo ? thickness + 2 * halo_width * view.unit : thickness,
                                  halo ? ink.halo : ink.color);
                }
            }
        }
        if (!steps.empty()) {
            if (const auto place = seen_at(view, steps.back().place)) {
                add_dot(patches, *place, trail_dot * view.unit, ink);
            }
        }
    }
}

MarkKey MarkMaker::key(const observe::FrameLayout& layout, const MarkView& view) const {
    MarkKey key;
    if (wanted_.arrows != "none") {
        key.arrow = {speed_, arrow_length * view.unit, wanted_.arrows == "field"};
    }
    if (wanted_.chains) {
        key.chain = {force_, chain_thickness * view.unit};
    }
    for (std::size_t t = 0; t < wanted_.trails.size(); ++t) {
        const auto named = [&](const observe::FrameShape& shape) { return shape.name == wanted_.trails[t]; };
        const bool name = std::any_of(layout.shapes.begin(), layout.shapes.end(), named);
        key.trails.push_back({(name ? "" : "body ") + wanted_.trails[t], trail_color(t)});
    }
    return key;
}

} // namespace tumble::render
