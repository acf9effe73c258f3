#include "run/resume.h"

#include "base/text.h"
#include "observe/frame_file.h"
#include "observe/series.h"
#include "observe/whole_file.h"
#include "run/build_mark.h"
#include "run/checkpoint_files.h"
#include "run/scene_changes.h"

#include <fmt/format.h>
#include <functional>

namespace tumble::run {

namespace fs = std::filesystem;

namespace {

Result<Resumable> resumable_from(const fs::path& file, const scene::Scene& scene, const RunFolder& folder,
                                 const RunOptions& options, Checkpoint checkpoint) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(folder.series(), error);
    if (checkpoint.series_size > 0 && (error || size < checkpoint.series_size))
        return Problem{.file = file.string(),
                       .what = "counts on rows of series.csv that are not there",
                       .fix = "put series.csv back as the run left it, or run the scene again"};
    Result<SimulationPtr> simulation = restore(scene, options.threads, checkpoint.world, options.stop);
    if (!simulation)
        return simulation.problems();
    checkpoint.world = {}; // as large as all the rest, and the simulation has it
    return Resumable{
        std::move(checkpoint), std::move(*simulation), file.lexically_relative(folder.root).string(), {}, {}};
}

/// frame_000012.png, bodies_000012.vtp: 12.
std::optional<std::int64_t> number_in(const fs::path& file) {
    const std::string stem = file.stem().string();
    const std::size_t line = stem.rfind('_');
    const auto number = line == std::string::npos ? Result<std::int64_t>(Problem{})
                                                  : parse_integer(std::string_view(stem).substr(line + 1));
    return number ? std::optional(*number) : std::nullopt;
}

/// What a run keeps per frame, by the endings of the names.
bool is_beyond(const fs::path& file, std::int64_t shots) {
    const std::string ending = file.extension().string();
    if (ending != ".tumble" && ending != ".png" && ending != ".vtp")
        return false;
    const auto number = number_in(file);
    return number && *number >= shots;
}

std::error_code remove_if(const fs::path& folder, const std::function<bool(const fs::path&)>& goes) {
    std::error_code error;
    std::vector<fs::path> going;
    if (!fs::is_directory(folder, error))
        return {};
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (goes(entry->path()))
            going.push_back(entry->path());
    for (const fs::path& file : going)
        if (!error)
            fs::remove(file, error);
    return error;
}

} // namespace

Found look_into(const fs::path& root) {
    const RunFolder folder{root};
    std::error_code error;
    if (!fs::exists(root, error) || (fs::is_directory(root, error) && fs::is_empty(root, error)))
        return Found::nothing;
    if (!list_checkpoints(folder.checkpoints()).empty())
        return Found::run;
    // The first checkpoint follows the first row and the first frame.
    const auto series = observe::read_series(folder.series());
    const bool a_run = fs::exists(folder.scene(), error) || holds_only_a_run(root);
    const bool begun = (!series || series->rows() <= 1) && observe::list_frames(folder.frames()).size() <= 1;
    return a_run && begun ? Found::beginning : Found::run;
}

Result<Resumable> find_checkpoint(const scene::Scene& scene, const std::string& toml,
                                  const std::vector<MeshMark>& meshes, const RunFolder& folder,
                                  const RunOptions& options) {
    Problems useless;
    for (const fs::path& file : list_checkpoints(folder.checkpoints())) {
        const Result<std::string> bytes = observe::read_whole(file);
        Result<Checkpoint> checkpoint = bytes ? checkpoint_from(*bytes, file) : Result<Checkpoint>(bytes.problems());
        Problems problems = checkpoint.problems();
        if (checkpoint) {
            const auto changes = judge_changes(*checkpoint, toml, meshes, options.accept_changes, scene.file);
            if (!changes)
                return changes.problems();
            Result<Resumable> found = resumable_from(file, scene, folder, options, std::move(*checkpoint));
            if (found && found->simulation->time() > scene.duration + scene.time_step)
                return Problem{.file = file.string(),
                               .what = fmt::format("stands at t = {:.6g} s, beyond the end of the run at {:.6g} s",
                                                   found->simulation->time(), scene.duration),
                               .fix = "give a longer --duration"};
            if (found) {
                found->changes = *changes;
                for (const std::string& change : *changes)
                    found->warnings.push_back("accepted: from here on " + change);
                if (found->from.build_mark != build_mark())
                    found->warnings.push_back(fmt::format("the checkpoint was written by another build of the program "
                                                          "({}, this is {}): the run goes on from it, but need not end "
                                                          "in the bits of one that never stopped",
                                                          excerpt(found->from.build_mark), build_mark()));
                for (const Problem& problem : useless)
                    found->warnings.push_back(fmt::format("a newer checkpoint was left out: {}: {}",
                                                          fs::path(problem.file).filename().string(), problem.what));
                return found;
            }
            problems = found.problems();
        }
        if (stop_wanted(options.stop))
            return stopped_before_it_began();
        for (Problem& problem : problems)
            problem.file = file.string();
        useless.insert(useless.end(), problems.begin(), problems.end());
    }
    if (useless.empty())
        useless.push_back({.file = folder.root.string(),
                           .what = "holds no checkpoint to go on from",
                           .fix = "--force runs the scene again and replaces what is there"});
    return useless;
}

Result<std::vector<std::int64_t>> cut_back(const RunFolder& folder, const Checkpoint& to) {
    const auto half_written = [](const fs::path& file) { return file.extension() == ".part"; };
    for (const fs::path& place : {folder.frames(), folder.pictures(), folder.paraview()}) {
        const std::error_code error =
            remove_if(place, [&](const fs::path& file) { return half_written(file) || is_beyond(file, to.shots); });
        if (error)
            return Problem{.file = place.string(), .what = "cannot be written: " + error.message()};
    }
    const fs::path own = checkpoint_path(folder.checkpoints(), to.step);
    for (const fs::path& file : list_checkpoints(folder.checkpoints())) {
        if (file == own)
            break;
        std::error_code ignored;
        fs::remove(file, ignored);
    }
    (void)remove_if(folder.checkpoints(), half_written);
    std::vector<std::int64_t> missing;
    std::error_code ignored;
    for (std::int64_t number = 0; number < to.shots; ++number)
        if (!fs::exists(observe::frame_path(folder.frames(), number), ignored))
            missing.push_back(number);
    return missing;
}

std::string frames_in_words(const std::vector<std::int64_t>& numbers) {
    if (numbers.empty())
        return "no frames";
    if (numbers.size() == 1)
        return fmt::format("frame {}", numbers[0]);
    if (numbers.size() > 5)
        return fmt::format("{} frames from {} to {}", numbers.size(), numbers.front(), numbers.back());
    return fmt::format("frames {}", fmt::join(numbers, ", "));
}

} // namespace tumble::run
