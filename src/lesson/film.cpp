#include "lesson/film.h"

#include "observe/whole_file.h"
#include "render/pair_painter.h"
#include "render/png_writer.h"
#include "render/video_writer.h"

#include <algorithm>
#include <functional>

namespace tumble::lesson {

namespace {

constexpr double pictures_per_second = 25;

scene::Render settings_of(const Film& film) {
    scene::Render settings;
    settings.camera = film.reels.front().frames.front().layout->dimension == 2 ? "side" : "free";
    settings.projection = settings.camera == "free" ? "perspective" : "orthographic";
    settings.color = film.color;
    settings.range = film.range;
    settings.view = film.view;
    settings.background = "white";
    settings.plot = false;
    settings.frames_per_second = pictures_per_second;
    settings.every = film.every;
    return settings;
}

/// A reel that is over stands still at its last frame.
const observe::Frame& frame_of(const Reel& reel, std::size_t number) {
    return reel.frames[std::min(number, reel.frames.size() - 1)];
}

std::size_t length_of(const Film& film) {
    std::size_t longest = 0;
    for (const Reel& reel : film.reels)
        longest = std::max(longest, reel.frames.size());
    return longest;
}

Eigen::AlignedBox3d bounds_of(const Film& film) {
    Eigen::AlignedBox3d box;
    for (const Reel& reel : film.reels) {
        box.extend(render::bounds_of(reel.frames.front()));
        box.extend(render::bounds_of(reel.frames.back()));
    }
    return box;
}

using Draw = std::function<render::Picture(std::size_t number)>;

Result<Draw> one_painter(const Film& film, const scene::Render& settings) {
    const Reel& reel = film.reels.front();
    auto titled = *reel.frames.front().layout;
    titled.title = film.title;
    auto opened = render::Painter::open(settings, std::make_shared<const observe::FrameLayout>(std::move(titled)));
    if (!opened)
        return opened.problems();
    const auto painter = std::make_shared<render::Painter>(std::move(*opened));
    painter->fit(bounds_of(film));
    return Draw([painter, &reel](std::size_t number) { return painter->draw(frame_of(reel, number)); });
}

Result<Draw> two_painters(const Film& film, const scene::Render& settings) {
    const Reel &left = film.reels[0], &right = film.reels[1];
    auto opened = render::PairPainter::open(settings, {left.frames.front().layout, right.frames.front().layout},
                                            {left.label, right.label});
    if (!opened)
        return opened.problems();
    const auto painter = std::make_shared<render::PairPainter>(std::move(*opened));
    painter->fit(bounds_of(film));
    return Draw([painter, &left, &right](std::size_t number) {
        return painter->draw(frame_of(left, number), frame_of(right, number));
    });
}

Result<Draw> painter_of(const Film& film) {
    const scene::Render settings = settings_of(film);
    return film.reels.size() == 1 ? one_painter(film, settings) : two_painters(film, settings);
}

} // namespace

Result<Done> draw_poster(const Film& film, const std::filesystem::path& file) {
    const Result<Draw> draw = painter_of(film);
    if (!draw)
        return draw.problems();
    const auto bytes = render::encode_png((*draw)(film.poster.value_or(length_of(film) - 1)));
    return observe::write_whole(file, std::string(bytes.begin(), bytes.end()));
}

Result<Done> shoot(const Film& film, const std::filesystem::path& file) {
    const Result<Draw> draw = painter_of(film);
    if (!draw)
        return draw.problems();
    const scene::Render settings = settings_of(film);
    auto video = render::VideoWriter::open(file, settings.width, settings.height, settings.frames_per_second);
    if (!video)
        return video.problems();
    for (std::size_t number = 0; number < length_of(film); ++number)
        if (Result<Done> added = video->add((*draw)(number)); !added)
            return added;
    return video->finish();
}

} // namespace tumble::lesson
