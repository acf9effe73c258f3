#include "view/film_scales.h"

#include "render/color_range.h"

#include <algorithm>

namespace tumble::view {

static bool moves(const observe::Frame& frame) {
    const auto fast = [](const Eigen::Vector3d& v) { return v.norm() > render::slowest; };
    return std::any_of(frame.velocity.begin(), frame.velocity.end(), fast);
}

static bool presses(const observe::Frame& frame) {
    return frame.contacts && !render::pressing_forces(*frame.contacts).empty();
}

scene::Render FilmScales::settle(const scene::Render& look, const observe::Frame& frame, const render::Span& range,
                                 const render::MarkKey& key) {
    scene::Render fixed = look;
    const scene::Marks& wanted = look.marks;
    if (!look.range && last_ && last_->look.color == look.color && !last_->look.range)
        fixed.range = last_->fixed.range;
    if (!fixed.range && moves(frame))
        fixed.range = {range.lo, range.hi};
    if (last_ && last_->look.marks.arrows == wanted.arrows && last_->look.marks.arrow_speed == wanted.arrow_speed)
        fixed.marks.arrow_speed = last_->fixed.marks.arrow_speed;
    if (!fixed.marks.arrow_speed && key.arrow && moves(frame))
        fixed.marks.arrow_speed = key.arrow->speed;
    if (last_ && last_->look.marks.chains && last_->look.marks.chain_force == wanted.chain_force)
        fixed.marks.chain_force = last_->fixed.marks.chain_force;
    if (!fixed.marks.chain_force && key.chain && presses(frame))
        fixed.marks.chain_force = key.chain->force;
    waits_ = wanted.chains && !frame.contacts;
    last_.emplace(Settled{look, fixed});
    return fixed;
}

} // namespace tumble::view
