#include "run/load_recorder.h"

#include "base/archive.h"
#include "observe/frame_file.h"
#include "run/run_folder.h"
#include "solid/facet_load.h"

#include <fmt/format.h>

namespace tumble::run {

template <class Archive, As<LoadInstant> I> void carry(Archive& archive, I& instant) {
    auto& [time, pushes] = instant;
    archive(time, pushes);
}

template <class Archive, As<MeanLoad> M> void carry(Archive& archive, M& mean) {
    auto& [time, window, pushes] = mean;
    archive(time, window, pushes);
}

namespace {

// A body that was away for longer begins a new row of touches: what the thesis' dumps, 60 a second, could tell apart.
constexpr double pause = 1.0 / 60; // s

const scene::WallShape& shape_of(const scene::Scene& scene, int wall) {
    return scene.walls[static_cast<std::size_t>(wall)].shape;
}

} // namespace

LoadRecorder::LoadRecorder(const scene::Scene& scene, int wall, const LoadOptions& options,
                           std::vector<observe::Measure> measures)
    : scene_(scene), wall_(wall), mesh_(*std::get<scene::SpecimenShape>(shape_of(scene, wall)).mesh), locator_(mesh_),
      options_(options), measures_(std::move(measures)), history_(scene.time_step, pause),
      means_(solid::triangles_of(mesh_)) {
    loads_.bulk.columns = {"time_s"};
    for (const observe::Measure& measure : measures_)
        loads_.bulk.columns.push_back(measure.column());
    loads_.bulk.values.resize(loads_.bulk.columns.size());
}

void LoadRecorder::take(const Simulation& simulation) {
    const double time = simulation.books().time; // of the forces
    pushes_ = simulation.wall_pushes(wall_);
    history_.take(time, pushes_);
    means_.take(pushes_);
}

std::optional<Problem> LoadRecorder::keep(const Simulation& simulation) {
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
    if (const double window = static_cast<double>(means_.steps()) * scene_.time_step; window > 0)
        loads_.means.push_back({books.time, window, means_.finish()});
    const observe::Seen seen(frame, books, scene_.observe.axes_turned);
    std::vector<double> row{books.time};
    for (const observe::Measure& measure : measures_)
        row.push_back(measure.value(seen));
    loads_.bulk.append(row);
    return keep_frame(frame);
}

PartLoads LoadRecorder::finish() {
    loads_.touches = history_.touches();
    return std::move(loads_);
}

std::string LoadRecorder::state() const {
    ArchiveWriter writer;
    writer(options_.every, options_.from, loads_.instants, loads_.means, loads_.bulk.values, history_, means_);
    return writer.take();
}

Result<Done> LoadRecorder::recall(const std::string& state) {
    double every = 0, from = 0;
    ArchiveReader reader(state);
    reader(every, from, loads_.instants, loads_.means, loads_.bulk.values, history_, means_);
    if (!reader.whole() || !means_.fits() || loads_.bulk.values.size() != loads_.bulk.columns.size())
        return Problem{.file = options_.folder.string(),
                       .what = "holds loads that make no sense",
                       .fix = "--force runs the scene again and replaces what is there"};
    if (every != options_.every || from != options_.from)
        return Problem{.file = options_.folder.string(),
                       .what = fmt::format("was begun with --every {:.9g} --from {:.9g}", every, from),
                       .fix = "give the same again; --force begins anew"};
    return Done{};
}

std::optional<Problem> LoadRecorder::keep_frame(const observe::Frame& frame) const {
    if (options_.folder.empty())
        return std::nullopt;
    const auto number = static_cast<std::int64_t>(loads_.instants.size()) - 1;
    const auto written = observe::write_frame(observe::frame_path(RunFolder{options_.folder}.frames(), number), frame);
    return written ? std::nullopt : std::optional(written.problems()[0]);
}

std::optional<Problem> LoadRecorder::body_inside(const observe::Frame& frame) const {
    const observe::WallPlace& place = frame.walls[static_cast<std::size_t>(wall_)];
    for (std::size_t i = 0; i < frame.bodies(); ++i)
        if (locator_.find(place.rotation.transpose() * (frame.position[i] - place.translation)))
            return Problem{.file = scene_.file.string(),
                           .what = fmt::format("body {} lies inside '{}' at {:.4g} s", frame.id[i],
                                               scene_.walls[static_cast<std::size_t>(wall_)].name, frame.time),
                           .fix = "fill beside the part, not across it; or take a shorter step"};
    return std::nullopt;
}

} // namespace tumble::run
