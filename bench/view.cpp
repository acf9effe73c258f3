// The view: from a drag to the next frame while the scene stands still, and frames/s while it runs, at 1280 x 720,
// beside what docs/view.md wants of them.
#include "support/arguments.h"
#include "support/media.h"
#include "view/jpeg.h"
#include "view/live_source.h"
#include "view/studio.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fmt/format.h>
#include <thread>

using namespace tumble;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double most_drag_ms = 100, least_frames_per_s = 15; // on two cores

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// s, of all threads: what a frame costs, however busy the machine is with something else.
double cpu_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// A studio with a scene that has run for a while, its source still in hand.
struct Bench {
    view::Source* source = nullptr;
    std::unique_ptr<view::Studio> studio;
    view::JpegEncoder jpeg{80};
    std::size_t bytes = 0;            // of the last frame
    std::vector<double> drew, packed; // s, of each frame

    Bench(const std::string& file, int width, int height, int threads) {
        const auto text = bench::value_or_refuse(view::SceneText::read(file, {}));
        const auto scene = bench::value_or_refuse(text.load());
        auto opened = bench::value_or_refuse(view::open_live(text, scene, threads, [] {}));
        source = opened.get();
        view::Plots plots = view::Plots::of_simulation(scene, *opened->layout());
        studio = bench::value_or_refuse(
            view::Studio::open(std::move(opened), text, scene, std::move(plots), {width, height, "."}));
        frame();
    }
    void frame() {
        const Clock::time_point begun = Clock::now();
        const view::Shown shown = bench::value_or_refuse(studio->draw());
        drew.push_back(seconds_since(begun));
        bytes = bench::value_or_refuse(jpeg.encode(shown.picture)).size();
        packed.push_back(seconds_since(begun) - drew.back());
    }
    void run_until(double time) {
        source->play(true);
        while (source->state().playing && source->newest()->frame.time < time)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        source->play(false);
        std::this_thread::sleep_for(std::chrono::milliseconds(200)); // the last stretch
        frame();
    }
};

std::string three(std::vector<double> values, double factor) {
    std::sort(values.begin(), values.end());
    return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", factor * values.front(), factor * values[values.size() / 2],
                       factor * values.back());
}

/// By nearest rank.
double p95(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[(95 * values.size() + 99) / 100 - 1];
}

/// Seconds from each of `count` moves of a hand to the packed frame that shows it.
std::vector<double> drags(Bench& bench, int count) {
    std::vector<double> took;
    bench.studio->take(view::PointerPressed{0, 800, 300});
    for (int i = 1; i <= count; ++i) {
        const Clock::time_point begun = Clock::now();
        bench.studio->take(view::PointerMoved{800.0 + 5 * i, 300.0 + i});
        bench.frame();
        took.push_back(seconds_since(begun));
    }
    bench.studio->take(view::PointerReleased{0, 900, 300});
    return took;
}

/// Steps/s for so many seconds of playing that nobody looks at.
double steps_per_s(Bench& bench, double seconds) {
    const std::int64_t before = bench.source->newest()->frame.step;
    bench.source->play(true);
    const Clock::time_point begun = Clock::now();
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    bench.source->play(false);
    const double passed = seconds_since(begun);
    std::this_thread::sleep_for(std::chrono::milliseconds(200)); // the last stretch
    return static_cast<double>(bench.source->newest()->frame.step - before) / passed;
}

struct Rate {
    double frames = 0, steps = 0; // per s
};

/// For so many seconds of playing.
Rate watched(Bench& bench, double seconds) {
    const std::int64_t before = bench.source->newest()->frame.step;
    bench.source->play(true);
    const Clock::time_point begun = Clock::now();
    int frames = 0;
    while (seconds_since(begun) < seconds)
        if (bench.studio->is_stale()) {
            bench.frame();
            ++frames;
        } else
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    bench.source->play(false);
    const double passed = seconds_since(begun);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return {frames / passed, static_cast<double>(bench.source->newest()->frame.step - before) / passed};
}

} // namespace

/// scene=scenes/trough-quick.toml from=0.55 s width=1280 height=720 threads=1 drags=40 seconds=10. Prints
/// {"drag_ms": [least, median, most], "drag_p95_ms", of which "draw_ms" and "jpeg_ms", "drag_cpu_ms": mean over all
/// cores, "frames_per_s", "steps_per_s" meanwhile and "steps_unwatched_per_s" while nobody looks, "frame_kB",
/// "within_limits"}.
int main(int count, char** words) {
    bench::Arguments arguments(count, words);
    const std::string scene = arguments.text("scene", "scenes/trough-quick.toml");
    const double from = arguments.number("from", 0.55), seconds = arguments.number("seconds", 10);
    const auto width = static_cast<int>(arguments.whole("width", 1280));
    const auto height = static_cast<int>(arguments.whole("height", 720));
    const auto threads = static_cast<int>(arguments.whole("threads", 1));
    const auto moves = static_cast<int>(arguments.whole("drags", 40));
    arguments.finish();
    Bench bench(scene, width, height, threads);
    bench.run_until(from);
    const double unwatched = steps_per_s(bench, 0.5 * seconds);
    bench.drew.clear();
    bench.packed.clear();
    const double before = cpu_time();
    const std::vector<double> took = drags(bench, moves);
    const double cpu = (cpu_time() - before) / moves;
    const std::string drew = three(bench.drew, 1e3), packed = three(bench.packed, 1e3);
    const Rate rate = watched(bench, seconds);
    const bool within =
        1e3 * *std::max_element(took.begin(), took.end()) <= most_drag_ms && rate.frames >= least_frames_per_s;
    fmt::print(
        "{{\"scene\": \"{}\", \"bodies\": {}, \"drag_ms\": {}, \"drag_p95_ms\": {:.4g}, \"draw_ms\": {}, \"jpeg_ms\": "
        "{}, \"drag_cpu_ms\": "
        "{:.3g}, "
        "\"frames_per_s\": {:.3g}, \"steps_per_s\": {:.4g}, \"steps_unwatched_per_s\": {:.4g}, \"frame_kB\": {:.3g}, "
        "\"most_drag_ms\": {}, \"least_frames_per_s\": {}, \"within_limits\": {}}}\n",
        scene, bench.source->newest()->frame.bodies(), three(took, 1e3), 1e3 * p95(took), drew, packed, 1e3 * cpu,
        rate.frames, rate.steps, unwatched, 1e-3 * static_cast<double>(bench.bytes), most_drag_ms, least_frames_per_s,
        within);
}
