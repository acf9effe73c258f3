#include "run/part_loads.h"

#include "base/make_folder.h"
#include "observe/frame_file.h"
#include "observe/measures.h"
#include "run/schedule.h"
#include "run/simulation.h"
#include "solid/facet_load.h"
#include "solid/locate.h"

#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace tumble::run {

namespace {

// A body that was away for longer begins a new row of touches: what the thesis' dumps, 60 a second, could tell apart.
constexpr double pause = 1.0 / 60; // s

/// A step of a run and what it shows, gathered.
class LoadRecorder {
public:
    LoadRecorder(const scene::Scene& scene, int wall, const LoadOptions& options,
                 std::vector<observe::Measure> measures)
        : scene_(scene), wall_(wall), mesh_(*std::get<scene::SpecimenShape>(wall_shape()).mesh), locator_(mesh_),
          options_(options), measures_(std::move(measures)), history_(scene.time_step, pause) {
        loads_.bulk.columns = {"time_s"};
        for (const observe::Measure& measure : measures_)
            loads_.bulk.columns.push_back(measure.column());
        loads_.bulk.values.resize(loads_.bulk.columns.size());
        sum_.setZero(3, static_cast<Eigen::Index>(mesh_.nodes.size()));
    }

    /// After one step.
    void take(const Simulation& simulation) {
        const double time = simulation.books().time; // of the forces
        pushes_ = simulation.wall_pushes(wall_);
        history_.take(time, pushes_);
        for (const observe::WallPush& push : pushes_) {
            const Eigen::Vector4d shares = solid::shares_at(mesh_, push.triangle / 2, push.foot);
            const auto& corners = mesh_.facets[static_cast<std::size_t>(push.triangle / 2)].corners;
            for (std::size_t k = 0; k < 4; ++k)
                sum_.col(corners[k]) += shares[static_cast<Eigen::Index>(k)] * push.force;
        }
        ++summed_;
    }

    /// At an instant, after its step was taken.
    std::optional<Problem> keep(const Simulation& simulation) {
        const observe::Frame frame = simulation.frame();
        const Books books = simulation.books();
        if (auto problem = body_inside(frame))
            return problem;
        std::vector<solid::Push> pushes;
        for (const observe::WallPush& push : pushes_)
            pushes.push_back({push.triangle / 2, push.foot, push.force});
        if (const auto balanced = solid::nodal_loads(mesh_, pushes); !balanced)
            return balanced.problems()[0];
        loads_.instants.push_back({books.time, pushes_});
        if (summed_ > 0)
            loads_.means.push_back(
                {books.time, static_cast<double>(summed_) * scene_.time_step, sum_ / static_cast<double>(summed_)});
        sum_.setZero();
        summed_ = 0;
        const observe::Seen seen(frame, books);
        std::vector<double> row{books.time};
        for (const observe::Measure& measure : measures_)
            row.push_back(measure.value(seen));
        loads_.bulk.append(row);
        return keep_frame(frame);
    }

    PartLoads finish() {
        loads_.touches = history_.touches();
        return std::move(loads_);
    }

private:
    [[nodiscard]] const scene::WallShape& wall_shape() const {
        return scene_.walls[static_cast<std::size_t>(wall_)].shape;
    }

    [[nodiscard]] std::optional<Problem> keep_frame(const observe::Frame& frame) const {
        if (options_.frames.empty())
            return std::nullopt;
        const auto number = static_cast<std::int64_t>(loads_.instants.size()) - 1;
        const auto written = observe::write_frame(observe::frame_path(options_.frames, number), frame);
        return written ? std::nullopt : std::optional(written.problems()[0]);
    }

    [[nodiscard]] std::optional<Problem> body_inside(const observe::Frame& frame) const {
        const observe::WallPlace& place = frame.walls[static_cast<std::size_t>(wall_)];
        for (std::size_t i = 0; i < frame.bodies(); ++i)
            if (locator_.find(place.rotation.transpose() * (frame.position[i] - place.translation)))
                return Problem{.file = scene_.file.string(),
                               .what = fmt::format("body {} lies inside '{}' at {:.4g} s", frame.id[i],
                                                   scene_.walls[static_cast<std::size_t>(wall_)].name, frame.time),
                               .fix = "fill beside the part, not across it; or take a shorter step"};
        return std::nullopt;
    }

    const scene::Scene& scene_;
    int wall_;
    const solid::HexMesh& mesh_;
    solid::Locator locator_;
    LoadOptions options_;
    std::vector<observe::Measure> measures_;
    observe::TouchHistory history_;
    std::vector<observe::WallPush> pushes_;
    Eigen::Matrix3Xd sum_; // N, over `summed_` steps
    std::int64_t summed_ = 0;
    PartLoads loads_;
};

Progress progress_of(const Simulation& simulation, const scene::Scene& scene, std::int64_t last, double steps_per_s) {
    Progress now;
    now.time = simulation.time();
    now.duration = scene.duration;
    now.step = simulation.steps();
    now.steps = last;
    now.steps_per_s = steps_per_s;
    if (steps_per_s > 0)
        now.left_s = static_cast<double>(last - now.step) / steps_per_s;
    now.books = simulation.books();
    return now;
}

/// Frames of an earlier run are taken away.
std::optional<Problems> begin_frames(const std::filesystem::path& folder, const observe::FrameLayout& layout) {
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    std::error_code failed;
    for (const std::filesystem::path& old : observe::list_frames(folder))
        std::filesystem::remove(old, failed);
    if (const auto written = observe::write_layout(observe::layout_path(folder), layout); !written)
        return written.problems();
    return std::nullopt;
}

double seconds_since(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

} // namespace

Result<int> find_specimen(const scene::Scene& scene, const std::string& name) {
    std::vector<int> found;
    std::string names;
    for (int w = 0; w < static_cast<int>(scene.walls.size()); ++w) {
        const scene::Wall& wall = scene.walls[static_cast<std::size_t>(w)];
        if (scene.dimension == 2 || !std::holds_alternative<scene::SpecimenShape>(wall.shape))
            continue;
        names += (names.empty() ? "" : ", ") + wall.name;
        if (name.empty() || wall.name == name)
            found.push_back(w);
    }
    if (found.size() == 1)
        return found[0];
    if (names.empty())
        return Problem{.file = scene.file.string(),
                       .what = "the scene has no specimen",
                       .fix = "add a [[wall]] with shape = \"bored-cylinder\" or \"prism\""};
    return Problem{.file = scene.file.string(),
                   .what = found.empty() ? fmt::format("no specimen is called '{}'", name)
                                         : fmt::format("the scene has {} specimens", found.size()),
                   .fix = "name one of " + names};
}

Result<PartLoads> record_loads(const scene::Scene& scene, int wall, const LoadOptions& options, RunListener& listener) {
    const auto begun = std::chrono::steady_clock::now();
    for (const bool periodic : scene.domain.periodic)
        if (periodic)
            return Problem{
                .file = scene.file.string(),
                .key = "domain.periodic",
                .what = "loads on a specimen are not kept in a periodic domain, where its facets are there twice",
                .fix = "close the domain, or let `tumble run` run it"};
    auto measures = observe::choose_measures(scene.observe.measures);
    if (!measures)
        return measures.problems();
    auto simulation = simulate(scene, options.threads, options.stop);
    if (!simulation)
        return simulation.problems();
    if (!options.frames.empty())
        if (const auto problems = begin_frames(options.frames, *(*simulation)->layout()))
            return *problems;
    LoadRecorder recorder(scene, wall, options, std::move(*measures));
    Schedule instants(options.every, scene.time_step);
    const std::int64_t last = std::llround(scene.duration / scene.time_step);
    const std::int64_t first = std::max<std::int64_t>(1, std::llround(options.from / scene.time_step));
    bool stopped = false;
    double told = 0;
    instants.pass(first - 1);
    while ((*simulation)->steps() < last && !stopped) {
        // Until then nobody looks, and what comes is forgotten.
        const std::int64_t ahead =
            (*simulation)->steps() < first - 1 ? std::min<std::int64_t>(first - 1 - (*simulation)->steps(), 1000) : 1;
        if (const auto problem = (*simulation)->advance(ahead))
            return *problem;
        stopped = stop_wanted(options.stop);
        if ((*simulation)->steps() >= first)
            recorder.take(**simulation);
        if (instants.due((*simulation)->steps())) {
            if (const auto problem = recorder.keep(**simulation))
                return *problem;
            instants.pass((*simulation)->steps());
        }
        if (const double now = seconds_since(begun); now > told + 0.2) {
            told = now;
            listener.progressed(
                progress_of(**simulation, scene, last, static_cast<double>((*simulation)->steps()) / now));
        }
    }
    PartLoads loads = recorder.finish();
    loads.stopped = stopped;
    loads.wall_s = seconds_since(begun);
    return loads;
}

} // namespace tumble::run
