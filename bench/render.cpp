// Pictures: how long one of a dense bed takes and where the time goes, and whether drawing, encoding and stepping keep
// out of each other's way.
#include "observe/frame_file.h"
#include "render/painter.h"
#include "render/png_writer.h"
#include "render/video_writer.h"
#include "run/frame_queue.h"
#include "run/picture_sink.h"
#include "run/replay.h"
#include "run/simulation.h"
#include "run/view_box.h"
#include "scene/load.h"
#include "support/arguments.h"
#include "support/media.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <random>

using namespace tumble;
using Eigen::Vector3d;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double most_draw_ms = 250; // of 317,000 spheres at 1920 x 1080, on two cores

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// s, of all threads.
double cpu_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::string three(std::vector<double> values, double factor) {
    std::sort(values.begin(), values.end());
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", factor * values.front(), factor * values[values.size() / 2],
                       factor * values.back());
}

/// Something to draw.
struct Sight {
    scene::Render settings;
    std::shared_ptr<const observe::FrameLayout> layout;
    observe::Frame frame;
    Eigen::AlignedBox3d bounds;
};

/// Bodies of a scene's first template heaped up in its trough, as dense as a bulk: on a lattice whose cell is the
/// body's volume over 0.55, turned at random and pushed by a tenth of a cell.
Sight heap(const std::string& file, std::int64_t count) {
    const scene::Scene scene = bench::value_or_refuse(scene::load_scene(file));
    const run::SimulationPtr simulation = bench::value_or_refuse(run::simulate(scene, 1));
    Sight sight{scene.render, simulation->layout(), simulation->frame(), run::view_box(scene, *simulation->layout())};
    observe::Frame& frame = sight.frame;
    const double cell = std::cbrt(simulation->bodies().front().volume / 0.55);
    const scene::Box& box = scene.domain.box;
    std::mt19937 random(1);
    std::normal_distribution<double> any;
    frame = {};
    frame.layout = sight.layout;
    frame.walls = simulation->frame().walls;
    constexpr double radius = 0.24; // m, of the troughs
    for (double y = 0.5 * cell; y < box.hi.y(); y += cell)
        for (double z = box.lo.z(); z < box.hi.z(); z += cell)
            for (double x = box.lo.x() + 0.5 * cell; x < box.hi.x(); x += cell) {
                const bool inside = std::hypot(std::min(y - radius, 0.0), z) < radius - 0.5 * cell;
                if (!inside || static_cast<std::int64_t>(frame.bodies()) == count)
                    continue;
                frame.id.push_back(static_cast<std::int64_t>(frame.bodies()));
                frame.shape.push_back(0);
                frame.position.push_back(Vector3d(x, y, z) +
                                         0.1 * cell * Vector3d(any(random), any(random), any(random)));
                frame.orientation.push_back(
                    Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized());
                frame.velocity.push_back({any(random), any(random), any(random)});
                frame.angular_velocity.push_back(Vector3d::Zero());
            }
    return sight;
}

/// The last frame of a run.
Sight last_of(const std::string& folder) {
    const scene::Scene scene = bench::value_or_refuse(scene::load_scene(folder + "/scene.toml"));
    const run::Recording recording = bench::value_or_refuse(run::open_recording(folder, {}));
    return {scene.render, recording.layout,
            bench::value_or_refuse(observe::read_frame(recording.frames.back().file, recording.layout)),
            recording.bounds};
}

std::int64_t spheres_in(const observe::Frame& frame) {
    std::int64_t count = 0;
    for (const int shape : frame.shape)
        count += static_cast<std::int64_t>(frame.layout->shapes[static_cast<std::size_t>(shape)].radii.size());
    return count;
}

render::Painter painter_for(const Sight& sight, const render::PainterOptions& options) {
    auto painter = bench::value_or_refuse(render::Painter::open(sight.settings, sight.layout, options));
    painter.fit(sight.bounds);
    return painter;
}

/// Milliseconds of `count` pictures, and the processor time of one. Gives the longest.
double time_pictures(const char* name, const Sight& sight, int count, bool sketch) {
    render::Painter painter = painter_for(sight, {});
    if (const auto set = painter.set_sketching(sketch); !set)
        bench::refuse(to_string(set.problems()));
    painter.draw(sight.frame); // compiles shaders
    std::vector<double> took;
    const double before = cpu_time();
    for (int i = 0; i < count; ++i) {
        const Clock::time_point begun = Clock::now();
        painter.draw(sight.frame);
        took.push_back(seconds_since(begun));
    }
    fmt::print("\"{}_ms\": {}, \"{}_cpu_ms\": {:.4g}, ", name, three(took, 1e3), name,
               1e3 * (cpu_time() - before) / count);
    return 1e3 * *std::max_element(took.begin(), took.end());
}

/// With a face that cuts bodies open a tenth of the way into them, as the front camera sees it: nearly all are left.
Sight cut_open(Sight sight) {
    Vector3d lo = sight.bounds.min();
    lo.x() += 0.1 * sight.bounds.sizes().x();
    sight.settings.clip = scene::Box{lo, sight.bounds.max()};
    sight.settings.clip_cuts = true;
    return sight;
}

/// Milliseconds of each phase of a picture; their sum is a little more than the picture takes without waiting.
void time_phases(const Sight& sight, int count) {
    render::PainterOptions options;
    options.time_phases = true;
    render::Painter painter = painter_for(sight, options);
    painter.draw(sight.frame);
    const std::vector<PhaseTime> first = painter.phase_times();
    for (int i = 0; i < count; ++i)
        painter.draw(sight.frame);
    std::string text;
    for (std::size_t k = 0; k < first.size(); ++k)
        text += fmt::format("{}\"{}\": {:.3g}", k > 0 ? ", " : "", first[k].name,
                            1e3 * (painter.phase_times()[k].seconds - first[k].seconds) / count);
    fmt::print("\"phases_ms\": {{{}}}", text);
}

/// Milliseconds that a picture takes as PNG and as a frame of a video, alone.
void time_encoders(const Sight& sight, int count, const std::string& video) {
    render::Painter painter = painter_for(sight, {});
    const render::Picture picture = painter.draw(sight.frame);
    Clock::time_point begun = Clock::now();
    std::size_t bytes = 0;
    for (int i = 0; i < count; ++i)
        bytes = render::encode_png(picture).size();
    fmt::print(", \"png_ms\": {:.4g}, \"png_kB\": {}, ", 1e3 * seconds_since(begun) / count, bytes / 1000);
    auto writer = bench::value_or_refuse(
        render::VideoWriter::open(video, picture.width, picture.height, sight.settings.frames_per_second));
    begun = Clock::now();
    for (int i = 0; i < count; ++i)
        bench::value_or_refuse(writer.add(picture));
    bench::value_or_refuse(writer.finish());
    fmt::print("\"video_ms\": {:.4g}", 1e3 * seconds_since(begun) / count);
    std::filesystem::remove(video);
}

/// A scene that is stepped alone, and with a video of it: what the video costs, and how long the steps waited for it.
void time_together(const std::string& file, std::int64_t steps, int pictures, const std::string& video) {
    const scene::Scene scene = bench::value_or_refuse(scene::load_scene(file));
    const auto run = [&](run::FrameQueue* queue) {
        const run::SimulationPtr simulation = bench::value_or_refuse(run::simulate(scene, 1));
        const Clock::time_point begun = Clock::now();
        for (int i = 0; i < pictures; ++i) {
            if (const auto problem = simulation->advance(steps))
                bench::refuse(to_string(*problem));
            if (queue)
                queue->push({simulation->frame(), i, {}});
        }
        return 1e3 * seconds_since(begun) / pictures;
    };
    const double alone = run(nullptr);
    const run::SimulationPtr simulation = bench::value_or_refuse(run::simulate(scene, 1));
    run::FrameSinks sinks;
    sinks.push_back(bench::value_or_refuse(run::keep_pictures(scene.render, simulation->layout(), {{}, video},
                                                              run::view_box(scene, *simulation->layout()))));
    run::FrameQueue queue(std::move(sinks));
    const double together = run(&queue);
    const double waited = 1e3 * queue.waited_s() / pictures;
    if (const Problems problems = queue.close(); !problems.empty())
        bench::refuse(to_string(problems));
    fmt::print(", \"steps_alone_ms\": {:.4g}, \"steps_with_video_ms\": {:.4g}, \"steps_waited_ms\": {:.4g}, "
               "\"draw_and_feed_ms\": {:.4g}",
               alone, together, waited, 1e3 * queue.worked_s() / pictures);
    std::filesystem::remove(video);
}

} // namespace

/// scene=scenes/trough-slice.toml bodies=4878 (a heap of them, at once), or run=FOLDER (its last frame); camera= and
/// projection= of the scene; width=1920 height=1080 pictures=10 video=bench-render.mp4 (made and taken away again;
/// video= (nothing): no encoders); moving=scenes/trough-quick.toml steps=400 (a picture) for the film, moving=
/// (nothing) for none. Prints milliseconds a picture: [least, median, most] with everything, as a sketch, cut open,
/// of each phase, of the encoders alone, and of a film.
int main(int count, char** words) {
    bench::Arguments arguments(count, words);
    const std::string scene = arguments.text("scene", "scenes/trough-slice.toml");
    const std::string run = arguments.text("run", ""), video = arguments.text("video", "bench-render.mp4");
    const std::string moving = arguments.text("moving", "scenes/trough-quick.toml");
    const std::int64_t bodies = arguments.whole("bodies", 4878), steps = arguments.whole("steps", 400);
    const auto pictures = static_cast<int>(arguments.whole("pictures", 10));
    const std::string camera = arguments.text("camera", ""), projection = arguments.text("projection", "");
    const auto width = static_cast<int>(arguments.whole("width", 1920));
    const auto height = static_cast<int>(arguments.whole("height", 1080));
    const std::string keep = arguments.text("keep", "");
    arguments.finish();
    Sight sight = run.empty() ? heap(scene, bodies) : last_of(run);
    sight.settings.width = width;
    sight.settings.height = height;
    sight.settings.camera = camera.empty() ? sight.settings.camera : camera;
    sight.settings.projection = projection.empty() ? sight.settings.projection : projection;
    fmt::print("{{\"spheres\": {}, \"width\": {}, \"height\": {}, \"most_draw_ms\": {}, ", spheres_in(sight.frame),
               width, height, most_draw_ms);
    const double longest = time_pictures("draw", sight, pictures, false);
    time_pictures("sketch", sight, pictures, true);
    time_pictures("cut", cut_open(sight), pictures, false);
    time_phases(sight, pictures);
    if (!video.empty())
        time_encoders(sight, pictures, video);
    if (!video.empty() && !moving.empty())
        time_together(moving, steps, pictures, video);
    fmt::print(", \"within_limits\": {}}}\n", longest <= most_draw_ms);
    if (!keep.empty()) {
        render::PngWriter writer;
        bench::value_or_refuse(writer.add(keep, painter_for(sight, {}).draw(sight.frame)));
        bench::value_or_refuse(writer.finish());
    }
}
