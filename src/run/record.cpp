#include "run/record.h"

#include "observe/measures.h"
#include "run/schedule.h"
#include "run/simulation.h"
#include "run/tracers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble::run {

namespace {

constexpr int most_parts = 1024;           // of a stride
constexpr double share_of_step = 0.25;     // of the scene's step, for impacts
constexpr double steps_of_trial = 4;       // of those, one step of the trial that finds an impact's beginning and end
constexpr double share_of_rub = 1.0 / 256; // of those again, for impacts that friction turns
constexpr double steps_of_row = 4;         // of the scene, between two rows of a sphere that is shaken
constexpr double rows_of_impact = 24;      // of those: spins and ways along a wall that change within are read between

/// What is read of every row, and along which axes.
struct Watched {
    std::vector<observe::Measure> measures;
    double axes_turned = 0;
};

observe::Series empty_series(const Watched& watched) {
    observe::Series series;
    series.columns = {"time_s"};
    for (const observe::Measure& measure : watched.measures)
        series.columns.push_back(measure.column());
    series.values.resize(series.columns.size());
    return series;
}

std::vector<double> row_of(const Watched& watched, const observe::Frame& frame, const Books& books) {
    const observe::Seen seen(frame, books, watched.axes_turned);
    std::vector<double> row{frame.time};
    for (const observe::Measure& measure : watched.measures)
        row.push_back(measure.value(seen));
    return row;
}

void add_row(observe::Series& series, const Watched& watched, observe::Frame frame, Books books, double began) {
    frame.time += began;
    books.time += began;
    series.append(row_of(watched, frame, books));
}

Problem stopped() {
    return {.what = "the simulation was stopped"};
}

Result<observe::Series> record_steadily(const scene::Scene& scene, const Watched& watched, int threads,
                                        StopFlag stop = nullptr) {
    Result<SimulationPtr> simulation = simulate(scene, threads, stop);
    if (!simulation)
        return simulation.problems();
    auto tracers = tracers_of(scene, (*simulation)->bodies());
    if (!tracers)
        return tracers.problems();
    observe::Series series = empty_series(watched);
    for (const observe::TracerReader& tracer : *tracers)
        for (std::string& head : tracer.columns())
            series.columns.push_back(std::move(head));
    Schedule rows(scene.observe.every, scene.time_step);
    const std::int64_t last = std::llround(scene.duration / scene.time_step);
    for (std::int64_t step = 0;; step = std::min(rows.next(), last)) {
        if (const auto problem = (*simulation)->advance(step - (*simulation)->steps()))
            return *problem;
        if (stop_wanted(stop))
            return stopped();
        const observe::Frame frame = (*simulation)->frame();
        std::vector<double> row = row_of(watched, frame, (*simulation)->books());
        for (observe::TracerReader& tracer : *tracers)
            for (const double value : tracer.row(frame))
                row.push_back(value);
        series.append(row);
        if (step == last)
            return series;
        rows.pass(step);
    }
}

/// A sphere alone on walls that move: fine steps throughout, and rows that draw its impacts.
Result<observe::Series> record_shaken(scene::Scene scene, const Watched& watched, StopFlag stop) {
    scene.observe.every = std::min(scene.observe.every, steps_of_row * scene.time_step);
    scene.time_step *= share_of_step;
    return record_steadily(scene, watched, 1, stop);
}

/// A sphere alone, piece by piece: a new world for every flight and every impact, which begins where the last one was
/// left.
class Flight {
public:
    Flight(const scene::Scene& scene, const Watched& watched, StopFlag stop)
        : as_written_(scene), scene_(scene), watched_(watched), stop_(stop), series_(empty_series(watched)) {
        const scene::Fill& fill = scene.fills[0];
        now_ = {0, *fill.position, fill.velocity, fill.angular_velocity, scene.gravity};
        scene_.allow_large_step = true;
    }

    Result<observe::Series> record() {
        while (now_.time < scene_.duration) {
            if (const auto problem = fly())
                return *problem;
            if (now_.time == 0) // it touches from the beginning: no flight
                return record_steadily(as_written_, watched_, 1, stop_);
            if (now_.time < scene_.duration)
                if (const auto problem = touch())
                    return *problem;
        }
        return std::move(series_);
    }

private:
    struct State {
        double time = 0; // s
        Eigen::Vector3d position, velocity, spin, acceleration;
    };

    /// The world at a state, with steps of that length; its first step is half a kick, so that velocities are those of
    /// the same instant.
    Result<SimulationPtr> world_at(const State& state, double step) {
        scene_.time_step = step;
        scene::Fill& fill = scene_.fills[0];
        fill.position = state.position;
        fill.velocity = state.velocity;
        fill.angular_velocity = state.spin;
        return simulate(scene_, 1, stop_);
    }

    [[nodiscard]] static State state_of(const observe::Frame& frame, double began, const State& before) {
        State state{began + frame.time, frame.position[0], frame.velocity[0], frame.angular_velocity[0],
                    before.acceleration};
        if (state.time > before.time)
            state.acceleration = (state.velocity - before.velocity) / (state.time - before.time);
        return state;
    }

    /// Strides until one meets a wall; then back to the last state that is surely clear of it: a step's account is that
    /// of its start.
    std::optional<Problem> fly() {
        double began = now_.time;
        int parts = 1; // of a stride: so long a one that a body went farther than its radius is cut
        auto world = world_at(now_, scene_.observe.every);
        if (!world)
            return world.problems()[0];
        if (series_.rows() == 0)
            add_row(series_, watched_, (*world)->frame(), (*world)->books(), began);
        State clear = now_;
        while (now_.time < scene_.duration) {
            if (stop_wanted(stop_))
                return stopped();
            const auto problem = (*world)->advance(parts);
            if (problem && (*world)->books().contacts == 0) {
                if (parts >= most_parts)
                    return problem;
                parts *= 4;
                began = now_.time;
                world = world_at(now_, scene_.observe.every / parts);
                if (!world)
                    return world.problems()[0];
                continue;
            }
            if ((*world)->books().contacts > 0) { // what so long a step made of the contact does not count
                now_ = clear;
                while (series_.values[0].back() > now_.time + 1e-12)
                    for (std::vector<double>& column : series_.values)
                        column.pop_back();
                return std::nullopt;
            }
            const observe::Frame frame = (*world)->frame();
            clear = now_;
            now_ = state_of(frame, began, now_);
            add_row(series_, watched_, frame, (*world)->books(), began);
        }
        return std::nullopt;
    }

    /// Fine steps until the impact is over; to the end where it never is.
    std::optional<Problem> touch() {
        double step = steps_of_trial * share_of_step * usual_step_, row = scene_.observe.every;
        for (const bool to_its_end : {false, true}) {
            const auto impact = try_impact(step, to_its_end);
            if (!impact)
                return impact.problems()[0];
            if (to_its_end) {
                step /= steps_of_trial;
                if (impact->lasts > 0) {
                    step *= impact->rubs ? share_of_rub : 1;
                    step = impact->lasts / std::max(1.0, std::round(impact->lasts / step));
                    row = impact->rubs ? std::min(row, impact->lasts / rows_of_impact) : row;
                }
            }
            if (impact->begins > 0) { // in the middle of a step, unless the wall is there already
                const State seen = now_;
                go_on(impact->begins - (std::floor(impact->begins / step) + 0.5) * step);
                if (!world_at(now_, step))
                    now_ = seen;
            }
        }
        const double began = now_.time;
        auto world = world_at(now_, step);
        if (!world)
            return world.problems()[0];
        const auto stride = std::max<std::int64_t>(1, std::llround(row / step));
        int free = 0; // strides since the impact
        while (now_.time < scene_.duration) {
            if (stop_wanted(stop_))
                return stopped();
            if (const auto problem = (*world)->advance(stride))
                return problem;
            const observe::Frame frame = (*world)->frame();
            const Books books = (*world)->books();
            now_ = state_of(frame, began, now_);
            add_row(series_, watched_, frame, books, began);
            free = books.overlap_ratio_peak > 0 && books.contacts == 0 ? free + 1 : 0;
            if (free < 2) // the second one tells how it is slowed down in flight, which go_on() asks
                continue;
            if (const auto problem = (*world)->advance(1)) // whose account is of the state that was taken
                return problem;
            if ((*world)->books().contacts == 0)
                return std::nullopt;
            free = 0;
        }
        return std::nullopt;
    }

    struct Impact {
        double begins = 0; // s from now; 0: none that comes from outside
        double lasts = 0;  // s; 0: it does not end soon
        bool rubs = false; // it changes the spin
    };

    /// When the impact ahead begins and ends, by steps of that length. Dashpots set in and end steeply: an impact that
    /// began or ended somewhere in a step would lose more or less, and heights would scatter by hundredths of a
    /// millimetre from one simulation to the next. Cut into a whole number of steps from the middle of one to the
    /// middle of another, it loses the same as its neighbours do. Across the wall the law's dashpot is silent in every
    /// step that slides: one step more or less of it leaves a trace as long as the step is, a millimetre on the way of
    /// a ball that sticks and slips, unless steps are much shorter.
    Result<Impact> try_impact(double step, bool to_its_end) {
        auto world = world_at(now_, step);
        if (!world)
            return world.problems();
        std::array<double, 3> depth{}; // m, of the last three instants
        Impact impact;
        bool rises = true;
        const double patience = 3 * scene_.observe.every, left = scene_.duration - now_.time;
        for (std::int64_t k = 0; static_cast<double>(k) * step < (impact.begins > 0 ? left : patience); ++k) {
            if (const auto problem = (*world)->advance(1))
                return *problem;
            depth = {depth[1], depth[2], (*world)->books().overlap_max};
            const auto [before, last, now] = depth;
            if (impact.begins == 0 && last > 0) {
                if (now - last <= last / 100 || k < 2) // it does not come from outside
                    return impact;
                impact.begins = (static_cast<double>(k - 1) - std::min(1.0, last / (now - last))) * step;
                if (!to_its_end)
                    return impact;
            }
            if (impact.begins > 0 && now == 0) {
                const double ends = static_cast<double>(k - 1) + std::min(1.0, last / (before - last));
                impact.lasts = ends * step - impact.begins;
                impact.rubs = (*world)->frame().angular_velocity[0] != now_.spin;
                return impact;
            }
            if (impact.begins > 0 && !rises && now > last) // back again before it has left
                return impact;
            rises = now > last;
        }
        return impact;
    }

    /// Moves along the flight by less than a step.
    void go_on(double later) {
        now_.time += later;
        now_.position += later * now_.velocity + 0.5 * later * later * now_.acceleration;
        now_.velocity += later * now_.acceleration;
    }

    const scene::Scene& as_written_;
    scene::Scene scene_; // as it is at the moment
    const double usual_step_ = as_written_.time_step;
    const Watched& watched_;
    StopFlag stop_;
    observe::Series series_;
    State now_;
};

bool is_one_sphere(const scene::Scene& scene) {
    return scene.dimension == 3 && scene.fills.size() == 1 && scene.fills[0].position && scene.fills[0].start == 0 &&
           scene.bodies[static_cast<std::size_t>(scene.fills[0].body)].spheres.size() == 1;
}

} // namespace

bool flies_alone(const scene::Scene& scene) {
    const bool still = std::all_of(scene.walls.begin(), scene.walls.end(),
                                   [](const scene::Wall& wall) { return wall.motion.at_rest(); });
    return still && is_one_sphere(scene);
}

Result<observe::Series> record(const scene::Scene& scene, int threads, StopFlag stop) {
    const auto measures = observe::choose_measures(without_tracers(scene.observe.measures));
    if (!measures)
        return measures.problems();
    const Watched watched{*measures, scene.observe.axes_turned};
    if (!traced_bodies(scene.observe.measures).empty())
        return record_steadily(scene, watched, threads, stop);
    if (flies_alone(scene))
        return Flight(scene, watched, stop).record();
    if (is_one_sphere(scene))
        return record_shaken(scene, watched, stop);
    return record_steadily(scene, watched, threads, stop);
}

} // namespace tumble::run
