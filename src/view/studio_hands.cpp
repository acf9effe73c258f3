// What hands do to the picture: the camera follows them, the rest is for the panel.
#include "view/studio.h"

#include <algorithm>
#include <cmath>

namespace tumble::view {

namespace {

constexpr double zoom_per_notch = 1.15;
constexpr double key_turn = 20; // pixels of dragging that an arrow stands for

} // namespace

Eigen::Vector2d Studio::from_middle(double x, double y) const {
    const render::Area& area = painter_->layout().scene;
    const double left = panel_shown_ && panel_width_ < window_.width ? panel_width_ : 0;
    return {x - left - 0.5 * (area.left + area.right), y - 0.5 * (area.top + area.bottom)};
}

Orbit& Studio::orbit() {
    const render::Area& area = painter_->layout().scene;
    if (!orbit_) {
        held_.shape = area.width() / area.height();
        orbit_.emplace(painter_->camera(), area.height(), look_.field_of_view_deg, layout_->dimension == 2);
    }
    orbit_->resize(render::view_height(area, held_));
    return *orbit_;
}

void Studio::take(const Message& message) {
    if (!moment_ && !std::holds_alternative<Resized>(message))
        return; // there is nothing to take hold of yet
    const auto to_panel = [&] {
        hands_.add(message);
        passes_left_ = settling_passes;
    };
    if (const auto* pressed = std::get_if<PointerPressed>(&message)) {
        if (dragged_ == pressed->button || panel_holds_.contains(pressed->button))
            take(PointerReleased{pressed->button, pointer_.x(), pointer_.y()}); // that nobody told of
        pointer_ = {pressed->x, pressed->y};
        if (!dragged_ && (!panel_holds_.empty() || is_in_panel(pressed->x))) {
            panel_holds_.insert(pressed->button);
            to_panel();
        } else if (!dragged_)
            dragged_ = pressed->button;
    } else if (const auto* moved = std::get_if<PointerMoved>(&message)) {
        if (!panel_holds_.empty() || (!dragged_ && (is_in_panel(moved->x) || is_in_panel(pointer_.x()))))
            to_panel();
        take_pointer(*moved);
    } else if (const auto* released = std::get_if<PointerReleased>(&message)) {
        if (panel_holds_.erase(released->button) > 0)
            to_panel();
        if (dragged_ == released->button)
            dragged_.reset();
    } else if (const auto* wheel = std::get_if<WheelTurned>(&message)) {
        if (is_in_panel(wheel->x))
            return to_panel();
        const Eigen::Vector2d at = from_middle(wheel->x, wheel->y);
        orbit().zoom(std::pow(zoom_per_notch, wheel->notches), at.x(), at.y());
        look_changed_ = true;
    } else if (const auto* pinch = std::get_if<Pinched>(&message)) {
        dragged_.reset();
        const Eigen::Vector2d at = from_middle(pinch->x, pinch->y);
        orbit().push(pinch->dx, pinch->dy);
        orbit().zoom(pinch->factor, at.x(), at.y());
        look_changed_ = true;
    } else if (const auto* key = std::get_if<KeyChanged>(&message)) {
        to_panel();
        take_key(*key);
    } else if (std::holds_alternative<TextTyped>(message)) {
        if (types_)
            to_panel();
    } else if (const auto* size = std::get_if<Resized>(&message)) {
        resize(*size);
    } else if (std::holds_alternative<PanelToggled>(message)) {
        panel_shown_ = !panel_shown_;
        panel_toggled_ = true;
        resized_ = true;
    }
}

void Studio::take_pointer(const PointerMoved& moved) {
    const Eigen::Vector2d to(moved.x, moved.y);
    const Eigen::Vector2d way = to - pointer_;
    pointer_ = to;
    if (!dragged_ || way.isZero())
        return;
    if (*dragged_ == 0)
        orbit().turn(way.x() / window_.ratio, way.y() / window_.ratio);
    else
        orbit().push(way.x(), way.y());
    look_changed_ = true;
}

/// Of the keyboard; docs/view.md lists them.
void Studio::take_key(const KeyChanged& change) {
    if (!change.down || types_ || change.ctrl)
        return;
    const std::string& key = change.key;
    const double turn = key_turn * window_.ratio;
    const auto move = [&](double right, double down) {
        change.shift ? orbit().push(right, down) : orbit().turn(right, down);
        look_changed_ = true;
    };
    const auto zoom = [&](double factor) {
        orbit().zoom(factor, 0, 0);
        look_changed_ = true;
    };
    if (key == "Space")
        source_->play(!source_->state().playing);
    else if (key == "Period")
        source_->step(1);
    else if (key == "Comma") {
        if (source_->can_seek()) // a simulation goes on: it cannot go back
            source_->step(-1);
    } else if (key == "ArrowLeft")
        move(-turn, 0);
    else if (key == "ArrowRight")
        move(turn, 0);
    else if (key == "ArrowUp")
        move(0, -turn);
    else if (key == "ArrowDown")
        move(0, turn);
    else if (key == "Equal" || key == "NumpadAdd")
        zoom(zoom_per_notch);
    else if (key == "Minus" || key == "NumpadSubtract")
        zoom(1 / zoom_per_notch);
    else if (key == "KeyR")
        set_camera("fit");
    else if (key == "KeyH")
        take(PanelToggled{});
}

/// "fit" is the scene's own camera.
void Studio::set_camera(const std::string& name) {
    orbit_.reset();
    look_.camera = name == "fit" ? settings_.camera : name;
    look_.eye = settings_.eye;
    look_.target = settings_.target;
    look_changed_ = true;
    aim(); // what a hand does next begins from this camera
}

/// The painter's camera is the one that was asked for last, before anything is drawn with it.
void Studio::aim() {
    if (orbit_)
        orbit().write(look_);
    painter_->hold_camera(orbit_ ? std::optional(held_) : std::nullopt);
    if (const auto done = painter_->restyle(look_); !done)
        notice_ = to_string(done.problems().front());
}

/// A window that is hidden has no size: the picture then stays as it is.
void Studio::resize(const Resized& size) {
    if (size.width == 0 || size.height == 0)
        return;
    const int width = std::clamp(size.width, least_width, most_side);
    const int height = std::clamp(size.height, least_height, most_side);
    const Resized wanted{width, height, std::clamp(size.ratio, 0.5, 4.0)};
    resized_ = resized_ || wanted != window_;
    window_ = wanted;
}

} // namespace tumble::view
