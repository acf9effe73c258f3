#include "view/studio.h"

#include "render/color_range.h"
#include "render/quantity.h"
#include "render/theme.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <nlohmann/json.hpp>

namespace tumble::view {

namespace {

constexpr double panel_share = 300;            // pixels of the page
constexpr double panel_letters = 0.8;          // of a picture's usual letters
constexpr std::chrono::milliseconds rest{250}; // without anything new

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
      layout_(source_->layout()) {
    if (const std::vector<std::string> warnings = source_->warnings(); !warnings.empty())
        warnings_ = warnings.front();
    window_.width = std::clamp(options.width, least_width, most_side);
    window_.height = std::clamp(options.height, least_height, most_side);
}

Result<std::unique_ptr<Studio>> Studio::open(std::unique_ptr<Source> source, const SceneText& text,
                                             const scene::Scene& scene, Plots plots, const StudioOptions& options) {
    std::unique_ptr<Studio> studio(new Studio(std::move(source), text, scene, std::move(plots), options));
    studio->look_.plot = false;   // the panel has its own
    studio->look_.turn_deg_s = 0; // hands turn it
    studio->look_.paper.reset();  // the window says how large it is, and its letters
    studio->drawn_window_ = studio->window_;
    if (Result<Done> opened = studio->open_window(); !opened)
        return opened.problems();
    return studio;
}

Result<Done> Studio::open_window() {
    Result<Done> panel = open_panel();
    return panel ? open_painter() : panel;
}

/// A window that cannot be drawn, as where memory ends, leaves the picture as large as it was.
Result<Done> Studio::take_size() {
    const Result<Done> opened = open_window();
    if (!opened) {
        notice_ = to_string(opened.problems().front());
        window_ = drawn_window_;
        return open_window();
    }
    drawn_window_ = window_;
    return opened;
}

/// In a narrow window the panel takes all of it while it is shown, and until a hand asks for it that is not.
Result<Done> Studio::open_panel() {
    const int wanted = static_cast<int>(std::lround(panel_share * window_.ratio));
    panel_width_ = window_.width - wanted < least_width ? window_.width : wanted;
    panel_shown_ = panel_toggled_ ? panel_shown_ : panel_width_ < window_.width;
    passes_left_ = settling_passes;
    const double unit = panel_letters * window_.ratio;
    if (panel_) { // the open tab, and what a hand is about in it, stay
        const Result<Done> scaled = panel_->rescale(unit);
        return scaled ? panel_->resize(panel_width_, window_.height) : scaled;
    }
    auto panel = render::PanelCanvas::open(panel_width_, window_.height, unit);
    if (!panel)
        return panel.problems();
    panel_ = std::move(*panel);
    return Done{};
}

Result<Done> Studio::open_painter() {
    look_.width = panel_shown_ && panel_width_ < window_.width ? window_.width - panel_width_ : window_.width;
    look_.height = window_.height;
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
              warnings_,
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
    aim();
    if (const auto done = painter_->set_sketching(sketched_); !done)
        notice_ = to_string(done.problems().front());
    source_->show_contacts(look_.marks.chains);
    plots_.take(*moment_);
    scene_picture_ = painter_->draw(moment_->frame);
    if ((look_changed_ || film_scales_.waits_for_contacts()) && source_->state().filming)
        source_->restyle_film(film_look()); // after the picture: it says what the scales are
    drawn_ = moment_->number;
    look_changed_ = false;
}

Result<Shown> Studio::draw() {
    while (resized_ && moment_ && hands_.any())
        pass_panel(); // in the picture that the hands had before them
    if (std::exchange(resized_, false))
        if (const Result<Done> sized = take_size(); !sized)
            return sized.problems();
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

void Studio::keep_points() {
    if (source_->can_seek()) // it has all of them
        return;
    if (const MomentPtr now = source_->newest())
        plots_.take(*now);
}

render::Picture Studio::beside_panel(render::Picture panel) const {
    if (panel.width >= window_.width)
        return panel;
    render::Picture all{panel.width + scene_picture_.width, window_.height, {}};
    all.rgba.resize(static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height) * 4);
    auto to = all.rgba.begin();
    for (int row = 0; row < all.height; ++row)
        for (const render::Picture* part : {&std::as_const(panel), &scene_picture_}) {
            const auto length = static_cast<std::ptrdiff_t>(part->width) * 4;
            to = std::copy_n(part->rgba.begin() + row * length, length, to);
        }
    return all;
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
