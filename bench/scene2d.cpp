// A scene of two dimensions under either solver: simulated seconds per second of processor time, and the mean of one
// measure, by which a step is seen to be short enough.
#include "observe/measures.h"
#include "run/simulation.h"
#include "scene/load.h"
#include "support/arguments.h"

#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <sys/resource.h>

using namespace tumble;

namespace {

scene::Scene load(const std::string& file, const std::vector<std::string>& sets) {
    std::vector<scene::Override> overrides;
    for (const std::string& set : sets)
        overrides.push_back({set});
    const auto scene = scene::load_scene(file, overrides);
    if (!scene)
        bench::refuse(to_string(scene.problems()));
    return *scene;
}

/// Of this process, which has one thread: what others do meanwhile does not count.
double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void advance_to(run::Simulation& simulation, double time, double step) {
    if (const auto problem = simulation.advance(std::llround(time / step) - simulation.steps()))
        bench::refuse(to_string(*problem));
}

/// A number of JSON, which knows no NaN.
std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{:.5g}", value) : "null";
}

/// What a step's phases took so far, s: all of them, and the books, which Box2D by itself does not keep.
struct Spent {
    double all = 0, books = 0;

    explicit Spent(const run::Simulation& simulation) {
        for (const PhaseTime& phase : simulation.phase_times()) {
            all += phase.seconds;
            books += phase.name == "book_energy" ? phase.seconds : 0;
        }
    }
};

observe::Measure measure_named(const std::string& name) {
    const auto found = observe::choose_measures({name});
    if (!found)
        bench::refuse(to_string(found.problems()));
    return found->front();
}

} // namespace

/// scene=scenes/drum-2d.toml sets=KEY=VALUE,... from=0 until=(the scene's duration), which is timed;
/// measure=surface_slope measured_from=(from)
int main(int count, char** words) {
    bench::Arguments arguments(count, words);
    const scene::Scene scene = load(arguments.text("scene", "scenes/drum-2d.toml"), arguments.words("sets"));
    const double from = arguments.number("from", 0), until = arguments.number("until", scene.duration);
    const observe::Measure measure = measure_named(arguments.text("measure", "surface_slope"));
    const double measured_from = arguments.number("measured_from", from);
    arguments.finish();
    const auto built = run::simulate(scene, 1);
    if (!built)
        bench::refuse(to_string(built.problems()));
    run::Simulation& simulation = **built;
    advance_to(simulation, from, scene.step());
    const Spent before(simulation);
    constexpr double every = 0.02; // s, between looks
    double seconds = 0, sum = 0, overlap = 0;
    int looks = 0;
    for (double time = from + every; time < until + 0.01 * every; time += every) {
        const double start = processor_seconds();
        advance_to(simulation, time, scene.step());
        seconds += processor_seconds() - start;
        if (time < measured_from + 0.01 * every)
            continue;
        const observe::Frame frame = simulation.frame();
        const Books books = simulation.books();
        sum += measure.value(observe::Seen(frame, books));
        overlap += books.overlap_ratio_max;
        ++looks;
    }
    const Spent after(simulation);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print(R"({{"step_s": {:.6g}, "bodies": {}, "contacts": {}, "seconds": {:.6g}, "rate": {:.6g}, )"
               R"("{}": {}, "overlap_ratio_max": {}, "books_share": {:.4g}, "peak_rss_MB": {:.1f}}})"
               "\n",
               scene.step(), simulation.books().bodies, simulation.books().contacts, seconds, (until - from) / seconds,
               measure.column(), number(sum / looks), number(overlap / looks),
               (after.books - before.books) / (after.all - before.all), static_cast<double>(usage.ru_maxrss) / 1024);
}
