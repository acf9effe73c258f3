#include "render/marks.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace tumble::render {

using Eigen::Vector3d;

// A trail of more steps is thinned out; a plot, too, has no more points.
constexpr std::size_t most_steps = 4000;
// A step of so many usual ones is a jump of whoever looks, not the way of a body.
constexpr double leap = 8;
// Of frames whose pace is known: where one is missing.
constexpr double longest_pace = 1.5;

std::optional<std::size_t> body_of(const observe::Frame& frame, const std::string& trail) {
    const bool number = std::all_of(trail.begin(), trail.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const observe::FrameShape& shape = frame.layout->shapes[static_cast<std::size_t>(frame.shape[b])];
        if (shape.name == trail || (number && std::to_string(frame.id[b]) == trail)) {
            return b;
        }
    }
    return std::nullopt;
}

/// s, from a frame to the next.
double MarkMaker::longest_step() const {
    return pace_ ? longest_pace * *pace_ : leap * usual_;
}

/// Whether the way to a frame of that time is that of somebody who moves about in time. What seemed to be a leap and
/// comes again is the new pace.
bool MarkMaker::leaps_to(double time) {
    const double way = time - std::exchange(followed_, time).value_or(time);
    if (!(way > 0)) {
        return false; // back or the same frame again: what lies after it goes
    }
    const bool far = (pace_ || usual_ > 0) && way > longest_step();
    if (!far || leapt_) {
        usual_ = usual_ > 0 && !far ? usual_ + 0.1 * (way - usual_) : way;
    }
    leapt_ = far;
    return far;
}

/// m, of a step from the straight line between its neighbours.
static double distance_from_line(const Vector3d& place, const Vector3d& from, const Vector3d& to) {
    const Vector3d way = to - from;
    const double length = way.squaredNorm();
    const double along = length > 0 ? std::clamp((place - from).dot(way) / length, 0.0, 1.0) : 0;
    return (place - from - along * way).norm();
}

/// Takes out a few of the steps, of no two neighbours both: those that lie closest to the straight line past them.
/// False where there are none.
template <class Step> static bool thin_out(std::vector<Step>& trail) {
    constexpr std::size_t share =
        16; // fewer at once keep the shape better: those that are left get new lines to lie on
    std::vector<std::pair<double, std::size_t>> offset;
    for (std::size_t k = 1; k + 1 < trail.size(); k += 2) {
        if (!trail[k].leapt && !trail[k + 1].leapt) {
            offset.emplace_back(distance_from_line(trail[k].place, trail[k - 1].place, trail[k + 1].place), k);
        }
    }
    const auto kept = offset.begin() + static_cast<std::ptrdiff_t>((offset.size() + share - 1) / share);
    if (kept != offset.end()) {
        std::nth_element(offset.begin(), kept, offset.end());
    }
    std::vector<bool> goes(trail.size());
    for (auto one = offset.begin(); one != kept; ++one) {
        goes[one->second] = true;
    }
    std::size_t k = 0;
    return std::erase_if(trail, [&](const Step&) { return goes[k++]; }) > 0;
}

void MarkMaker::follow(const observe::Frame& frame) {
    trails_.resize(wanted_.trails.size());
    const bool back = followed_ && frame.time < *followed_;
    const bool leapt = leaps_to(frame.time);
    for (std::size_t t = 0; t < trails_.size(); ++t) {
        Trail& trail = trails_[t];
        while (!trail.empty() && trail.back().time >= frame.time) {
            trail.pop_back();
        }
        if (const auto body = body_of(frame, wanted_.trails[t]); body && frame.position[*body].allFinite()) {
            // Whoever goes back may land where a leap went over; a body may have been away, or another of its name now.
            const bool amid = (back || pace_) && !trail.empty() && frame.time - trail.back().time > longest_step();
            const bool other = !trail.empty() && trail.back().id != frame.id[*body];
            trail.push_back({frame.time, frame.position[*body], frame.id[*body], leapt || amid || other});
        }
        for (bool full = trail.size() > most_steps; full && trail.size() > most_steps / 4 * 3;) {
            full = thin_out(trail);
        }
    }
}

} // namespace tumble::render
