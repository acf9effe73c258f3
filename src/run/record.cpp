#include "run/record.h"

#include "observe/measures.h"
#include "run/schedule.h"
#include "run/simulation.h"

#include <algorithm>
#include <cmath>

namespace tumble::run {

namespace {

constexpr double share_of_step = 0.2; // of the scene's step, for impacts

using Measures = std::vector<observe::Measure>;

observe::Series empty_series(const Measures& measures) {
    observe::Series series;
    series.columns = {"time_s"};
    for (const observe::Measure& measure : measures)
        series.columns.push_back(measure.column());
    series.values.resize(series.columns.size());
    return series;
}

void add_row(observe::Series& series, const Measures& measures, observe::Frame frame, Books books, double began) {
    frame.time += began;
    books.time += began;
    const observe::Seen seen(frame, books);
    std::vector<double> row{frame.time};
    for (const observe::Measure& measure : measures)
        row.push_back(measure.value(seen));
    series.append(row);
}

Result<observe::Series> record_steadily(const scene::Scene& scene, const Measures& measures, int threads) {
    Result<SimulationPtr> simulation = simulate(scene, threads);
    if (!simulation)
        return simulation.problems();
    observe::Series series = empty_series(measures);
    Schedule rows(scene.observe.every, scene.time_step);
    const std::int64_t last = std::llround(scene.duration / scene.time_step);
    for (std::int64_t step = 0;; step = std::min(rows.next(), last)) {
        if (const auto problem = (*simulation)->advance(step - (*simulation)->steps()))
            return *problem;
        add_row(series, measures, (*simulation)->frame(), (*simulation)->books(), 0);
        if (step == last)
            return series;
        rows.pass(step);
    }
}

/// A sphere alone, piece by piece: a new world for every flight and every impact, which begins where the last one was
/// left.
class Flight {
public:
    Flight(const scene::Scene& scene, const Measures& measures)
        : as_written_(scene), scene_(scene), measures_(measures), series_(empty_series(measures)) {
        const scene::Fill& fill = scene.fills[0];
        now_ = {0, *fill.position, fill.velocity, fill.angular_velocity, scene.gravity};
        scene_.allow_large_step = true;
    }

    Result<observe::Series> record() {
        while (now_.time < scene_.duration) {
            if (const auto problem = fly())
                return *problem;
            if (now_.time == 0) // it touches from the beginning: no flight
                return record_steadily(as_written_, measures_, 1);
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
        return simulate(scene_, 1);
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
        const double began = now_.time;
        auto world = world_at(now_, scene_.observe.every);
        if (!world)
            return world.problems()[0];
        if (series_.rows() == 0)
            add_row(series_, measures_, (*world)->frame(), (*world)->books(), began);
        State clear = now_;
        while (now_.time < scene_.duration) {
            if (const auto problem = (*world)->advance(1))
                return problem;
            if ((*world)->books().contacts > 0) {
                now_ = clear;
                while (series_.values[0].back() > now_.time + 1e-12)
                    for (std::vector<double>& column : series_.values)
                        column.pop_back();
                return std::nullopt;
            }
            const observe::Frame frame = (*world)->frame();
            clear = now_;
            now_ = state_of(frame, began, now_);
            add_row(series_, measures_, frame, (*world)->books(), began);
        }
        return std::nullopt;
    }

    /// Fine steps until the impact is over; to the end where it never is.
    std::optional<Problem> touch() {
        const double step = share_of_step * usual_step_;
        if (const auto problem = align(step))
            return problem;
        const double began = now_.time;
        auto world = world_at(now_, step);
        if (!world)
            return world.problems()[0];
        const auto stride = std::max<std::int64_t>(1, std::llround(scene_.observe.every / step));
        int free = 0; // strides since the impact
        while (now_.time < scene_.duration) {
            if (const auto problem = (*world)->advance(stride))
                return problem;
            const observe::Frame frame = (*world)->frame();
            const Books books = (*world)->books();
            now_ = state_of(frame, began, now_);
            add_row(series_, measures_, frame, books, began);
            free = books.overlap_ratio_peak > 0 && books.contacts == 0 ? free + 1 : 0;
            if (free < 2) // the second one tells how it is slowed down in flight, which align() asks
                continue;
            if (const auto problem = (*world)->advance(1)) // whose account is of the state that was taken
                return problem;
            if ((*world)->books().contacts == 0)
                return std::nullopt;
            free = 0;
        }
        return std::nullopt;
    }

    /// Moves along the flight by less than a step, so that the impact begins in the middle of one: begun at random, it
    /// would lose more or less to the dashpot, which sets in steeply, and heights would scatter by hundredths of a
    /// millimetre from one simulation to the next.
    std::optional<Problem> align(double step) {
        auto world = world_at(now_, step);
        if (!world)
            return world.problems()[0];
        double depth = 0;
        for (double t = 0; t < 3 * scene_.observe.every && depth == 0; t += step) {
            if (const auto problem = (*world)->advance(1))
                return problem;
            depth = (*world)->books().overlap_max;
        }
        if (depth == 0)
            return std::nullopt;
        if (const auto problem = (*world)->advance(1))
            return problem;
        const double deeper = (*world)->books().overlap_max - depth; // in one step
        if (deeper <= depth / 100)                                   // it does not come from outside
            return std::nullopt;
        const double later = (0.5 - std::min(1.0, depth / deeper)) * step;
        now_.time += later;
        now_.position += later * now_.velocity + 0.5 * later * later * now_.acceleration;
        now_.velocity += later * now_.acceleration;
        return std::nullopt;
    }

    const scene::Scene& as_written_;
    scene::Scene scene_; // as it is at the moment
    const double usual_step_ = as_written_.time_step;
    const Measures& measures_;
    observe::Series series_;
    State now_;
};

} // namespace

bool flies_alone(const scene::Scene& scene) {
    const bool still = std::all_of(scene.walls.begin(), scene.walls.end(),
                                   [](const scene::Wall& wall) { return wall.motion.at_rest(); });
    return still && scene.dimension == 3 && scene.fills.size() == 1 && scene.fills[0].position &&
           scene.fills[0].start == 0 && scene.bodies[static_cast<std::size_t>(scene.fills[0].body)].spheres.size() == 1;
}

Result<observe::Series> record(const scene::Scene& scene, int threads) {
    const auto measures = observe::choose_measures(scene.observe.measures);
    if (!measures)
        return measures.problems();
    if (flies_alone(scene))
        return Flight(scene, *measures).record();
    return record_steadily(scene, *measures, threads);
}

} // namespace tumble::run
