#include "view/studio.h"

#include "observe/whole_file.h"
#include "render/color_range.h"
#include "render/quantity.h"
#include "render/theme.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <nlohmann/json.hpp>

namespace tumble::view {

namespace {

constexpr double panel_share = 300;   // pixels of the page
constexpr double panel_letters = 0.8; // of a picture's usual letters
constexpr int least_width = 320, least_height = 200;
constexpr int most_side = 2560;                // pixels; of a phone held upright the height
constexpr std::chrono::milliseconds rest{250}; // without anything new
constexpr double zoom_per_notch = 1.15;
constexpr double key_turn = 20;    // pixels of dragging that an arrow stands for
constexpr int settling_passes = 3; // what Dear ImGui sizes by itself is right in the second frame

/// What the panel says of a source, as far as it can change without a new moment.
std::string words_of(const SourceState& s) {
    return fmt::format("{}{}{}{}{}{:.3g}{:.3g}{}{}", s.playing, s.ended, s.change_waits, s.filming, s.time, s.speed,
                       s.pace, s.trouble, s.filmed);
}

std::string stem_of(const std::filesystem::path& file) {
    const std::filesystem::path stem = file.stem() == "scene" ? file.parent_path().filename() : file.stem();
    return stem.empty() ? "view" : stem.string();
}

} // namespace

Studio::Studio(std::unique_ptr<Source> source, const SceneText& text, const scene::Scene& scene, Plots plots,
               const StudioOptions& options)
    : source_(std::move(source)), text_(text), settings_(scene.render), look_(scene.render), name_(stem_of(scene.file)),
      title_(scene.title), folder_(options.folder), controls_(scene, text), plots_(std::move(plots)),
      layout_(source_->layout()), width_(std::clamp(options.width, least_width, most_side)),
      height_(std::clamp(options.height, least_height, most_side)) {}

Result<std::unique_ptr<Studio>> Studio::open(std::unique_ptr<Source> source, const SceneText& text,
                                             const scene::Scene& scene, Plots plots, const StudioOptions& options) {
    std::unique_ptr<Studio> studio(new Studio(std::move(source), text, scene, std::move(plots), options));
    studio->look_.plot = false;   // the panel has its own
    studio->look_.turn_deg_s = 0; // hands turn it
    if (Result<Done> opened = studio->open_panel(); !opened)
        return opened.problems();
    if (Result<Done> opened = studio->open_painter(); !opened)
        return opened.problems();
    return studio;
}

/// In a narrow window the panel takes all of it while it is shown, and until a hand asks for it that is not.
Result<Done> Studio::open_panel() {
    const int wanted = static_cast<int>(std::lround(panel_share * ratio_));
    panel_width_ = width_ - wanted < least_width ? width_ : wanted;
    panel_shown_ = panel_toggled_ ? panel_shown_ : panel_width_ < width_;
    passes_left_ = settling_passes;
    const double unit = panel_letters * ratio_;
    if (panel_ && panel_->unit() == unit)
        return panel_->resize(panel_width_, height_);
    auto panel = render::PanelCanvas::open(panel_width_, height_, unit);
    if (!panel)
        return panel.problems();
    panel_ = std::move(*panel);
    return Done{};
}

Result<Done> Studio::open_painter() {
    look_.width = panel_shown_ && panel_width_ < width_ ? width_ - panel_width_ : width_;
    look_.height = height_;
    look_changed_ = true;
    if (painter_) // what it has seen, trails and scales, goes on to count
        return painter_->resize(look_.width, look_.height);
    auto painter = render::Painter::open(look_, layout_);
    if (!painter)
        return painter.problems();
    painter_ = std::move(*painter);
    painter_->fit(source_->bounds());
    return Done{};
}

Eigen::Vector2d Studio::from_middle(double x, double y) const {
    const render::Area& area = painter_->layout().scene;
    const double left = panel_shown_ && panel_width_ < width_ ? panel_width_ : 0;
    return {x - left - 0.5 * (area.left + area.right), y - 0.5 * (area.top + area.bottom)};
}

Orbit& Studio::orbit() {
    const double height = painter_->layout().scene.height();
    if (!orbit_)
        orbit_.emplace(painter_->camera(), height, look_.field_of_view_deg, layout_->dimension == 2);
    orbit_->resize(height);
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
        pointer_ = {pressed->x, pressed->y};
        panel_holds_ = !dragged_ && is_in_panel(pressed->x);
        if (panel_holds_)
            to_panel();
        else if (!dragged_)
            dragged_ = pressed->button;
    } else if (const auto* moved = std::get_if<PointerMoved>(&message)) {
        if (panel_holds_ || (!dragged_ && (is_in_panel(moved->x) || is_in_panel(pointer_.x()))))
            to_panel();
        take_pointer(*moved);
    } else if (const auto* released = std::get_if<PointerReleased>(&message)) {
        if (panel_holds_)
            to_panel();
        panel_holds_ = false;
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
        orbit().turn(way.x() / ratio_, way.y() / ratio_);
    else
        orbit().push(way.x(), way.y());
    look_changed_ = true;
}

/// Of the keyboard; docs/view.md lists them.
void Studio::take_key(const KeyChanged& change) {
    if (!change.down || types_ || change.ctrl)
        return;
    const std::string& key = change.key;
    const double turn = key_turn * ratio_;
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
    else if (key == "Comma")
        source_->step(-1);
    else if (key == "ArrowLeft")
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
}

/// A window that is hidden has no size: the picture then stays as it is.
void Studio::resize(const Resized& size) {
    if (size.width == 0 || size.height == 0)
        return;
    const int width = std::clamp(size.width, least_width, most_side);
    const int height = std::clamp(size.height, least_height, most_side);
    if (width == width_ && height == height_ && size.ratio == ratio_)
        return;
    width_ = width;
    height_ = height;
    ratio_ = std::clamp(size.ratio, 0.5, 4.0);
    resized_ = true;
}

bool Studio::is_stale() {
    name_kept();
    const SourceState state = source_->state();
    const MomentPtr now = source_->newest();
    return resized_ || look_changed_ || (sketched_ && is_at_rest()) || hands_.any() || passes_left_ > 0 ||
           (now && now->number != drawn_) || words_of(state) != told_ || notice_ != told_notice_ ||
           saved_ != told_saved_;
}

void Studio::pass_panel() {
    const auto theme = render::find_theme("dark");
    Desk desk{*source_,
              controls_,
              plots_,
              look_,
              *layout_,
              {painter_->range().lo, painter_->range().hi},
              painter_->mark_key(),
              notice_,
              saved_,
              saved_ != told_saved_,
              source_->state(),
              moment_->frame.time,
              {},
              {},
              {}};
    const auto now = std::chrono::steady_clock::now();
    const double passed = std::chrono::duration<double>(now - std::exchange(passed_, now)).count();
    panel_->pass([&] { hands_.feed(passed); },
                 [&] {
                     lay_out_panel(desk, *panel_, *theme);
                     types_ = ImGui::GetIO().WantTextInput;
                 });
    places_ = std::move(desk.places);
    told_key_ = std::move(desk.told_key);
    grant(desk.wishes);
}

void Studio::grant(const Wishes& wishes) {
    look_changed_ |= wishes.restyle;
    if (!wishes.camera.empty())
        set_camera(wishes.camera);
    if (wishes.fit_range)
        fit_range();
    if (wishes.picture)
        keep_picture();
    if (wishes.save_scene)
        save_scene();
    if (wishes.film_ends)
        source_->film_no_more();
    film_wanted_ = film_wanted_ || wishes.film;
}

/// Scales of a film of what goes on are those of the picture that was drawn last; of a run that is over the film knows
/// all frames.
scene::Render Studio::film_settings() {
    scene::Render settings = look_;
    settings.plot = settings_.plot && source_->can_seek(); // a film of what goes on knows no series
    if (source_->can_seek())
        return settings;
    return film_scales_.settle(settings, moment_->frame, painter_->range(), painter_->mark_key());
}

void Studio::begin_film() {
    film_scales_ = {};
    source_->film(film_settings(), free_name(".mp4"));
}

bool Studio::is_at_rest() const {
    return !source_->state().playing && std::chrono::steady_clock::now() - moved_ > rest;
}

/// What moves is sketched; what rests is drawn once more with smooth edges. Discs are quick enough as they are.
void Studio::draw_scene() {
    const auto now = std::chrono::steady_clock::now();
    const bool is_new = look_changed_ || moment_->number != drawn_;
    sketched_ = is_new && drawn_ != 0 && layout_->dimension == 3;
    if (is_new)
        moved_ = now;
    if (orbit_)
        orbit().write(look_);
    painter_->hold_camera(orbit_.has_value());
    for (const Result<Done>& done : {painter_->restyle(look_), painter_->set_sketching(sketched_)})
        if (!done)
            notice_ = to_string(done.problems().front());
    source_->show_contacts(look_.marks.chains);
    plots_.take(*moment_);
    scene_picture_ = painter_->draw(moment_->frame);
    if ((look_changed_ || film_scales_.waits_for_contacts()) && source_->state().filming)
        source_->restyle_film(film_settings()); // after the picture: it says what the scales are
    drawn_ = moment_->number;
    look_changed_ = false;
}

Result<Shown> Studio::draw() {
    while (resized_ && moment_ && hands_.any())
        pass_panel(); // in the picture that the hands had before them
    if (std::exchange(resized_, false))
        for (const Result<Done>& opened : {open_panel(), open_painter()})
            if (!opened)
                return opened.problems();
    name_kept();
    told_ = words_of(source_->state());
    moment_ = source_->newest();
    if (!moment_)
        return Problem{.what = "there is nothing to be seen yet", .fix = "wait for the first frame"};
    do {
        pass_panel(); // at least once, and until all that hands did has been told and has settled
        if (!hands_.any())
            passes_left_ = std::max(passes_left_ - 1, 0);
    } while (hands_.any() || passes_left_ > 0);
    const bool is_new = look_changed_ || moment_->number != drawn_;
    if (is_new || (sketched_ && is_at_rest()))
        draw_scene();
    if (std::exchange(film_wanted_, false))
        begin_film();
    if (is_new)
        pass_panel(); // with the range and the points of this picture
    told_notice_ = notice_;
    told_saved_ = saved_;
    Shown shown{panel_shown_ ? beside_panel(panel_->paint()) : scene_picture_, describe()};
    return shown;
}

render::Picture Studio::beside_panel(render::Picture panel) const {
    if (panel.width >= width_)
        return panel;
    render::Picture all{panel.width + scene_picture_.width, height_, {}};
    all.rgba.resize(static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height) * 4);
    auto to = all.rgba.begin();
    for (int row = 0; row < all.height; ++row)
        for (const render::Picture* part : {&std::as_const(panel), &scene_picture_}) {
            const auto length = static_cast<std::ptrdiff_t>(part->width) * 4;
            to = std::copy_n(part->rgba.begin() + row * length, length, to);
        }
    return all;
}

/// One that no file has; files may be written later than they are named.
std::filesystem::path Studio::free_name(const std::string& extension) {
    std::error_code ignored; // whoever writes there says what is wrong
    std::filesystem::create_directories(folder_, ignored);
    while (true) {
        std::filesystem::path file = folder_ / fmt::format("{}-{:03}{}", name_, ++kept_, extension);
        if (!std::filesystem::exists(file, ignored))
            return file;
    }
}

/// The scene's picture alone, without the panel.
void Studio::keep_picture() {
    (void)painter_->set_sketching(false); // then the rough edges stay
    const std::filesystem::path file = free_name(".png");
    if (const auto begun = png_.add(file, painter_->draw(moment_->frame)); begun)
        keeping_ = file;
    else
        notice_ = to_string(begun.problems().front());
}

/// Only what is there is named: a picture is encoded beside the drawing.
void Studio::name_kept() {
    const auto kept = keeping_.empty() ? std::nullopt : png_.outcome();
    if (!kept)
        return;
    notice_ = *kept ? keeping_.string() : to_string(kept->problems().front());
    keeping_.clear();
}

/// The colours reach over what moves now, and stay so.
void Studio::fit_range() {
    const auto quantity = render::find_quantity(look_.color, layout_->dimension);
    if (!quantity)
        return;
    const std::vector<double> values = render::values_of(*quantity, moment_->frame);
    const render::Span now = render::ColorRange({}, quantity->has_sign).next(values);
    look_.range = {now.lo, now.hi};
    look_changed_ = true;
}

/// What was saved, or why not, stands in the panel beside the button.
void Studio::save_scene() {
    const Result<std::filesystem::path> file = write_scene();
    saved_ = file ? file->string() : to_string(file.problems().front());
    passes_left_ = settling_passes; // the panel scrolls to it
}

Result<std::filesystem::path> Studio::write_scene() {
    const std::vector<scene::Override> changes = controls_.changes();
    Result<scene::Scene> scene = text_.load(changes);
    if (!scene)
        return scene.problems();
    scene->render = look_;
    scene->render.width = settings_.width;
    scene->render.height = settings_.height;
    scene->render.plot = settings_.plot;
    scene->claim = text_.claim_with(changes).value_or(scene->claim);
    scene->observe.contacts = scene->observe.contacts || look_.marks.chains; // without them no chain can be drawn
    std::filesystem::path file = free_name(".toml");
    if (const auto written = observe::write_whole(file, scene::to_toml(*scene)); !written)
        return written.problems();
    return file;
}

static std::array<double, 3> mean_velocity(const observe::Frame& frame) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& velocity : frame.velocity)
        sum += velocity;
    if (frame.bodies() > 0)
        sum /= static_cast<double>(frame.bodies());
    return {sum.x(), sum.y(), sum.z()};
}

std::string Studio::describe() const {
    const SourceState state = source_->state();
    nlohmann::json values = nlohmann::json::object();
    for (const Control& control : controls_.all())
        values[control.kind == Control::Kind::key ? control.key : control.word] = control.value;
    const render::Camera& camera = painter_->camera();
    const nlohmann::json json{{"title", title_},
                              {"time", moment_->frame.time},
                              {"step", moment_->frame.step},
                              {"bodies", moment_->frame.bodies()},
                              {"mean_velocity", mean_velocity(moment_->frame)},
                              {"last", state.last},
                              {"playing", state.playing},
                              {"ended", state.ended},
                              {"sketched", sketched_},
                              {"panel", panel_shown_},
                              {"trouble", state.trouble},
                              {"notice", notice_},
                              {"saved", saved_},
                              {"filmed", state.filmed},
                              {"change_waits", state.change_waits},
                              {"values", values},
                              {"places", places_},
                              {"told_key", told_key_},
                              {"camera",
                               {{"eye", {camera.eye.x(), camera.eye.y(), camera.eye.z()}},
                                {"target", {camera.target.x(), camera.target.y(), camera.target.z()}}}}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace tumble::view
