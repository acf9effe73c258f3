#include "run/checkpoint.h"

#include "base/archive.h"
#include "observe/array_file.h"
#include "run/run_report.h"

#include <fmt/format.h>

namespace tumble::run {

template <class Archive, As<Resumption> R> void carry(Archive& archive, R& resumption) {
    auto& [checkpoint, step, time, build_mark, changes] = resumption;
    archive(checkpoint, step, time, build_mark, changes);
}

template <class Archive, As<RunSummary> S> void carry(Archive& archive, S& summary) {
    auto& [state, reason, own_fault, folder, scene, title, duration, solver, time_step, seed, threads, time, steps,
           bodies, rows, frames, pictures, video, video_file, video_slowdown, wall_s, processor_s, stepping_s, frames_s,
           waited_s, body_steps, phases, books, energy_turnover, overlap_ratio_max, unfilled, warnings, checkpoint,
           checkpoints, checkpoint_bytes, checkpoints_s, resumed] = summary;
    archive(time, steps, bodies, rows, frames, pictures, wall_s, processor_s, stepping_s, frames_s, waited_s,
            body_steps, phases, books, energy_turnover, overlap_ratio_max, warnings, checkpoint, checkpoints,
            checkpoint_bytes, checkpoints_s, resumed);
    // How a run ends is its own: state, reason, own_fault, unfilled. What was asked for comes with the asking: folder,
    // scene, title, duration, solver, time_step, seed, threads, and those of the video.
}

template <class Archive, As<Outputs> O> void carry(Archive& archive, O& outputs) {
    auto& [pictures, video, paraview, text_dump, video_file] = outputs;
    archive(pictures, video, paraview, text_dump, video_file);
}

template <class Archive, As<MeshMark> M> void carry(Archive& archive, M& mark) {
    auto& [name, hash] = mark;
    archive(name, hash);
}

template <class Archive, As<Checkpoint> C> void carry(Archive& archive, C& checkpoint) {
    auto& [build_mark, scene, meshes, summary, outputs, step, time, shots, last_shot, series_size, plot_measure,
           plot_times, plot_values, tracers, world] = checkpoint;
    archive(meshes, summary, outputs, step, time, shots, last_shot, series_size, plot_measure, plot_times, plot_values,
            tracers);
    // Arrays of their own: scene, world. In the head: build_mark.
}

namespace {

std::string layout_of(Checkpoint checkpoint) {
    return fmt::format("{:016x}", archive_layout_of(checkpoint));
}

observe::Array bytes(const char* name, std::string content) {
    return {.name = name, .width = 1, .type = observe::ArrayType::byte, .bytes = std::move(content)};
}

std::string word_of(const nlohmann::json& head, const char* key) {
    return head.contains(key) && head[key].is_string() ? head[key].get<std::string>() : "";
}

} // namespace

std::string to_bytes(const Checkpoint& checkpoint) {
    ArchiveWriter writer;
    writer(checkpoint);
    observe::ArrayFile file;
    file.kind = "checkpoint";
    file.head = {{"version", version()}, {"build_mark", checkpoint.build_mark}, {"layout", layout_of({})}};
    file.head["step"] = checkpoint.step;
    file.head["time_s"] = checkpoint.time;
    file.arrays = {bytes("scene", checkpoint.scene), bytes("run", writer.take()), bytes("world", checkpoint.world)};
    return observe::to_bytes(file);
}

Result<Checkpoint> checkpoint_from(const std::string& bytes, const std::filesystem::path& file) {
    const auto problem = [&](std::string what) {
        return Problem{.file = file.string(),
                       .what = std::move(what),
                       .fix = "go on with the program that wrote it, or run the scene again"};
    };
    Result<observe::ArrayFile> read = observe::from_bytes(bytes, "checkpoint", file);
    if (!read)
        return read.problems();
    if (word_of(read->head, "layout") != layout_of({}))
        return problem(fmt::format("was written by version '{}' of the program, this is version '{}', and they keep "
                                   "different things",
                                   word_of(read->head, "version"), version()));
    Checkpoint checkpoint;
    checkpoint.build_mark = word_of(read->head, "build_mark");
    std::string run;
    for (const auto& [name, to] :
         {std::pair{"scene", &checkpoint.scene}, std::pair{"run", &run}, std::pair{"world", &checkpoint.world}}) {
        const Result<const observe::Array*> array = read->find(name, 1, observe::ArrayType::byte);
        if (!array)
            return problem(array.problems()[0].what);
        *to = (*array)->bytes;
    }
    ArchiveReader reader(run);
    reader(checkpoint);
    if (!reader.whole() || checkpoint.step < 0 || checkpoint.shots < 0)
        return problem("holds a run that makes no sense");
    return checkpoint;
}

} // namespace tumble::run
