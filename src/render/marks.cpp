#include "render/marks.h"

#include "render/clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tumble::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Units of pixels.
constexpr double trail_thickness = 2.4;
constexpr double trail_dot = 4.5;
// Lines of the weakest contacts would only be a haze: those below this share of the legend's force are left out.
constexpr double weakest_chain = 0.01;
// What a single body did that flew by is no mean: cells with less than this share of what cells hold are left out.
constexpr double emptiest_cell = 0.1;

/// Readable on both backgrounds and apart from each other for all eyes: M. Okabe and K. Ito, 2008.
constexpr std::array<std::array<double, 3>, 5> trail_colors{
    {{0.90, 0.62, 0.00}, {0.34, 0.71, 0.91}, {0.84, 0.37, 0.00}, {0.80, 0.47, 0.65}, {0.00, 0.62, 0.45}}};

/// Of so many trails those that have a row and a colour of their own in the key; the last row of more says how many
/// they are.
static std::size_t trails_named(std::size_t trails) {
    return trails > trail_colors.size() ? trail_colors.size() - 1 : trails;
}

Vector3d MarkMaker::trail_color(std::size_t trail) const {
    constexpr double grey = 0.5; // of those that the key does not tell apart
    return trail < trails_named(wanted_.trails.size()) ? Vector3d(trail_colors.at(trail).data())
                                                       : Vector3d::Constant(grey);
}

static bool same_view(const Camera& a, const Camera& b) {
    return a.axes == b.axes && a.eye == b.eye && a.scale == b.scale && a.centre == b.centre &&
           a.perspective == b.perspective;
}

bool MarkMaker::View::shows_as(const MarkView& view) const {
    const auto same_box = [](const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
        return a.min() == b.min() && a.max() == b.max();
    };
    return same_view(camera, view.camera) && clip.has_value() == view.clip.has_value() &&
           (!clip || same_box(*clip, *view.clip));
}

std::vector<double> pressing_forces(const std::vector<observe::FrameContact>& contacts) {
    std::vector<double> forces;
    for (const observe::FrameContact& contact : contacts) {
        if (contact.pressing() > 0) {
            forces.push_back(contact.pressing());
        }
    }
    return forces;
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

/// Whether a line of that thickness (pixels) could be seen.
static bool reaches(const Area& area, const Vector2d& a, const Vector2d& b, double thickness) {
    const Vector2d lo = a.cwiseMin(b).array() - thickness;
    const Vector2d hi = a.cwiseMax(b).array() + thickness;
    return hi.x() >= area.left && lo.x() < area.right && hi.y() >= area.top && lo.y() < area.bottom;
}

static bool within_clip(const MarkView& view, const Vector3d& position) {
    return !view.clip || view.clip->contains(position);
}

/// Of the bodies that have marks: the place in the picture.
static std::optional<Vector2d> marked_at(const MarkView& view, const Vector3d& position) {
    if (!within_clip(view, position)) {
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
        seen_.reset();
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

/// The mean of what was gathered before, with another camera or clip or of a later time, means nothing now.
void MarkMaker::add_to_field(const observe::Frame& frame, const MarkView& view) {
    if (!seen_ || !seen_->shows_as(view) || frame.time < gathered_.hi) {
        field_.clear();
        seen_.emplace(View{view.camera, view.clip});
        gathered_.lo = frame.time;
    } else if (frame.time == gathered_.hi && !field_.empty()) {
        return;
    }
    gathered_.hi = frame.time;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const Vector2d velocity = in_picture(view.camera, frame.velocity[b]);
        if (const auto place = marked_at(view, frame.position[b]); place && velocity.allFinite()) {
            Cell& cell = field_[cell_at(*place, field_spacing * view.unit)];
            cell.mass += mass_of(frame, b);
            cell.moment += mass_of(frame, b) * *place;
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
            arrows.push_back({cell.moment / cell.mass, cell.momentum / cell.mass});
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
        speed_ = wanted_.arrow_speed.value_or(speeds_.next(speeds, frame.time).hi);
    }
    if (wanted_.arrows == "field") {
        const bool kept = foreseen_ && seen_ && seen_->shows_as(view);
        if (!kept) {
            foreseen_ = false;
            add_to_field(frame, view);
        }
        speed_ = wanted_.arrow_speed.value_or(speeds_.next(mean_speeds(), frame.time).hi);
    }
    if (wanted_.chains && frame.contacts) {
        const std::vector<double> forces = pressing_forces(*frame.contacts);
        force_ = wanted_.chain_force.value_or(forces_.next(forces, frame.time).hi);
        beyond_ = std::any_of(forces.begin(), forces.end(), [&](double force) { return force > force_; });
    }
    follow(frame);
}

std::vector<Stroke> MarkMaker::strokes(const observe::Frame& frame, const MarkView& view) const {
    std::vector<Stroke> strokes;
    if (wanted_.chains) {
        add_chains(frame, view, strokes);
    }
    if (wanted_.arrows == "bodies") {
        add_arrows(frame, view, strokes);
    }
    if (wanted_.arrows == "field") {
        add_field(view, strokes);
    }
    add_trails(frame, view, strokes);
    return strokes;
}

std::vector<Patch> MarkMaker::patches(const observe::Frame& frame, const MarkView& view) const {
    std::vector<Patch> patches;
    for (const Stroke& stroke : strokes(frame, view)) {
        add_patches(stroke, patches);
    }
    return patches;
}

static Stroke arrow_from(const MarkView& view, const Vector2d& tail, const Vector2d& way) {
    return {Stroke::Kind::arrow, {tail, tail + way}, 0, {view.unit, view.theme.arrow, view.theme.background}};
}

/// Of the bodies within one square of the grid one has its arrow: in space the one nearest to the eye, which hides
/// others; in the plane the one nearest to the square's middle.
void MarkMaker::add_arrows(const observe::Frame& frame, const MarkView& view, std::vector<Stroke>& strokes) const {
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
        strokes.push_back(
            arrow_from(view, *seen_at(view, frame.position[one.body]), pixels * Vector2d(velocity.x(), -velocity.y())));
    }
}

void MarkMaker::add_field(const MarkView& view, std::vector<Stroke>& strokes) const {
    const double pixels = arrow_length * view.unit / speed_;
    for (const FieldArrow& arrow : means()) {
        const Vector2d way = pixels * Vector2d(arrow.velocity.x(), -arrow.velocity.y());
        strokes.push_back(arrow_from(view, arrow.middle - 0.5 * way, way));
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
    if (a && b && reaches(view.window, *a, *b, thickness)) {
        pieces.push_back({*a, *b, thickness});
    }
}

/// Ids with the bodies' indices; most frames have them in order.
std::vector<std::pair<std::int64_t, std::size_t>> sorted_ids(const observe::Frame& frame) {
    std::vector<std::pair<std::int64_t, std::size_t>> ids;
    ids.reserve(frame.bodies());
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        ids.emplace_back(frame.id[b], b);
    }
    if (!std::is_sorted(ids.begin(), ids.end())) {
        std::sort(ids.begin(), ids.end());
    }
    return ids;
}

} // namespace

/// From centre to contact and on to the other centre; across a periodic side half a line on either side. The strongest
/// lie on top.
void MarkMaker::add_chains(const observe::Frame& frame, const MarkView& view, std::vector<Stroke>& strokes) const {
    if (!frame.contacts) {
        return;
    }
    const std::vector<std::pair<std::int64_t, std::size_t>> index = sorted_ids(frame);
    const auto place_of = [&](std::int64_t id) -> const Vector3d* {
        const auto found = std::lower_bound(index.begin(), index.end(), std::pair{id, std::size_t{0}});
        const bool shown =
            found != index.end() && found->first == id && within_clip(view, frame.position[found->second]);
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
        strokes.push_back({Stroke::Kind::line,
                           {piece.from, piece.to},
                           piece.thickness,
                           {view.unit, view.theme.chain, view.theme.background}});
    }
}

/// What of a trail is to be seen, in pixels, from each even point to the next; steps that stay within one pixel of
/// where the line stands are passed over.
template <class Step>
static std::vector<Vector2d> lines_of(const observe::FrameLayout& layout, const MarkView& view,
                                      const std::vector<Step>& steps) {
    const auto shown_at = [&](std::size_t k) {
        return within_clip(view, steps[k].place) ? seen_at(view, steps[k].place) : std::nullopt;
    };
    // A step through a periodic side is no way across the picture.
    const auto goes_on = [&](std::size_t k) {
        return k < steps.size() && !steps[k].leapt &&
               periods_between(layout, steps[k].place - steps[k - 1].place).isZero() && shown_at(k);
    };
    std::vector<Vector2d> lines;
    std::optional<Vector2d> stands = steps.empty() ? std::nullopt : shown_at(0);
    for (std::size_t k = 1; k < steps.size(); ++k) {
        const auto to = shown_at(k);
        if (!stands || !goes_on(k)) {
            stands = to;
        } else if ((*to - *stands).norm() >= 1 || !goes_on(k + 1)) {
            if (reaches(view.window, *stands, *to, trail_thickness * view.unit)) {
                lines.insert(lines.end(), {*stands, *to});
            }
            stands = to;
        }
    }
    return lines;
}

void MarkMaker::add_trails(const observe::Frame& frame, const MarkView& view, std::vector<Stroke>& strokes) const {
    const double thickness = trail_thickness * view.unit;
    for (std::size_t t = 0; t < trails_.size(); ++t) {
        const Ink ink{view.unit, trail_color(t), view.theme.background};
        const Trail& steps = trails_[t];
        strokes.push_back({Stroke::Kind::way, lines_of(*frame.layout, view, steps), thickness, ink});
        if (!steps.empty() && within_clip(view, steps.back().place)) {
            if (const auto place = seen_at(view, steps.back().place)) {
                strokes.push_back({Stroke::Kind::dot, {*place}, trail_dot * view.unit, ink});
            }
        }
    }
}

MarkKey MarkMaker::key(const observe::FrameLayout& layout, const MarkView& view) const {
    MarkKey key;
    if (wanted_.arrows != "none") {
        key.arrow = {speed_, arrow_length * view.unit, wanted_.arrows == "field", gathered_};
    }
    if (wanted_.chains) {
        key.chain = {force_, chain_thickness * view.unit, beyond_};
    }
    // Once frames were seen: of nobody, or of a body that is yet to come, there is no line.
    const auto has_line = [&](std::size_t t) { return t >= trails_.size() || !trails_[t].empty(); };
    const std::size_t named_trails = trails_named(wanted_.trails.size());
    for (std::size_t t = named_trails; t < wanted_.trails.size(); ++t) {
        key.more_trails += has_line(t) ? 1 : 0;
    }
    if (key.more_trails > 0) {
        key.more_color = trail_color(named_trails);
    }
    for (const Trail& trail : trails_) {
        if (!trail.empty()) {
            key.since = std::min(key.since.value_or(trail.front().time), trail.front().time);
        }
    }
    for (std::size_t t = 0; t < named_trails; ++t) {
        if (!has_line(t)) {
            continue;
        }
        const auto named = [&](const observe::FrameShape& shape) { return shape.name == wanted_.trails[t]; };
        const bool name = std::any_of(layout.shapes.begin(), layout.shapes.end(), named);
        key.trails.push_back({(name ? "" : "body ") + wanted_.trails[t], trail_color(t)});
    }
    if (view.clip) {
        key.clip = clip_words(*view.clip, view.clip_cuts, layout);
    }
    return key;
}

} // namespace tumble::render
