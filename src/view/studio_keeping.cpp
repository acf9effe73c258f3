// Pictures, films and scenes that a studio keeps.
#include "observe/whole_file.h"
#include "scene/to_toml.h"
#include "view/studio.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace tumble::view {

namespace {

constexpr std::size_t most_kept_at_once = 4; // as many as wait beside the drawing without holding it up
constexpr double farthest_corner = 1e4;      // m, that a scene's view takes

} // namespace

/// Scales of a film of what goes on are those of the picture that was drawn last; of a run that is over the film knows
/// all frames.
FilmLook Studio::film_look() {
    FilmLook film{look_, orbit_ ? std::optional(held_) : std::nullopt};
    film.settings.plot = settings_.plot && source_->can_seek(); // a film of what goes on knows no series
    if (!source_->can_seek())
        film.settings = film_scales_.settle(film.settings, moment_->frame, painter_->range(), painter_->mark_key());
    return film;
}

void Studio::begin_film() {
    film_scales_ = {};
    source_->film(film_look(), free_name(".mp4"));
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
    if (keeping_.size() >= most_kept_at_once) {
        notice_ = fmt::format("{} pictures are being written: this one is not kept; ask again once they are named",
                              keeping_.size());
        return;
    }
    (void)painter_->set_sketching(false); // then the rough edges stay
    const std::filesystem::path file = free_name(".png");
    if (const auto begun = png_.add(file, painter_->draw(moment_->frame)); begun)
        keeping_.push_back(file);
    else
        notice_ = to_string(begun.problems().front());
}

/// Only what is there is named: a picture is encoded beside the drawing.
void Studio::name_kept() {
    const auto kept = keeping_.empty() ? std::nullopt : png_.outcome();
    if (!kept)
        return;
    const std::vector<std::filesystem::path> files = std::exchange(keeping_, {});
    notice_ = *kept ? files.front().string() : to_string(kept->problems().front());
    for (std::size_t k = 1; *kept && k < files.size(); ++k)
        notice_ += "\n" + files[k].string();
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
    if (orbit_)
        aim(); // hands may have moved it since the last picture
    scene->render = look_;
    if (orbit_ && layout_->dimension == 2)
        scene->render.view = seen_box(); // its camera has no keys
    // One that hands have chosen stands still, and so does what a mean field is drawn for.
    if (!orbit_ && look_.camera == settings_.camera && look_.marks.arrows != "field")
        scene->render.turn_deg_s = settings_.turn_deg_s;
    scene->render.width = settings_.width;
    scene->render.height = settings_.height;
    scene->render.plot = settings_.plot;
    scene->render.paper = settings_.paper;
    scene->claim = text_.claim_with(changes).value_or(scene->claim);
    scene->observe.contacts = scene->observe.contacts || look_.marks.chains; // without them no chain can be drawn
    std::filesystem::path file = free_name(".toml");
    if (const auto written = observe::write_whole(file, scene::to_toml(*scene)); !written)
        return written.problems();
    return file;
}

/// In two dimensions: what a camera must fit so that it shows what is seen now.
scene::Box Studio::seen_box() const {
    const render::Camera& camera = painter_->camera();
    const render::Area& area = painter_->layout().scene;
    const double metres = (0.5 - render::camera_margin) / camera.pixels_per_metre(camera.target); // per pixel
    const Eigen::Vector3d half(metres * area.width(), metres * area.height(), 0);
    return {(camera.target - half).cwiseMax(-farthest_corner), (camera.target + half).cwiseMin(farthest_corner)};
}

} // namespace tumble::view
