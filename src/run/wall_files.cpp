#include "run/wall_files.h"

#include "base/make_folder.h"
#include "base/text.h"
#include "observe/stl.h"
#include "observe/whole_file.h"
#include "run/wall_triangles.h"

#include <algorithm>

namespace tumble::run {

namespace {

Problems unknown(const scene::Scene& scene, const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const scene::Wall& wall : scene.walls)
        known.push_back(wall.name);
    Problems problems;
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            const std::string guess = did_you_mean(name, known);
            problems.push_back({.file = scene.file.string(),
                                .what = "there is no wall '" + name + "'",
                                .fix = guess.empty() ? "`tumble check` names them" : guess});
        }
    return problems;
}

} // namespace

Result<std::vector<WallFile>> write_wall_files(const scene::Scene& scene, const std::vector<std::string>& names,
                                               double time, const std::filesystem::path& folder, bool overwrite) {
    if (scene.dimension == 2)
        return Problem{.file = scene.file.string(),
                       .what = "walls in two dimensions are lines, and STL files hold triangles",
                       .fix = "take a scene of three dimensions"};
    if (Problems problems = unknown(scene, names); !problems.empty())
        return problems;
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    std::error_code error;
    std::vector<WallFile> files;
    for (const scene::Wall& wall : scene.walls) {
        if (!names.empty() && std::find(names.begin(), names.end(), wall.name) == names.end())
            continue;
        const std::filesystem::path file = folder / (wall.name + ".stl");
        if (!overwrite && std::filesystem::exists(file, error))
            return Problem{.file = file.string(),
                           .what = "is there already, and nothing is overwritten",
                           .fix = "--force replaces it"};
        const observe::FrameWall surface = wall_triangles(wall, scene.domain);
        const scene::WallPose pose = scene::pose_at(wall.motion, time);
        const auto written = observe::write_whole(
            file, observe::stl_bytes(surface, {pose.rotation, pose.translation, pose.velocity, pose.angular_velocity}));
        if (!written)
            return written.problems();
        files.push_back({file, surface.triangles.size()});
    }
    return files;
}

} // namespace tumble::run
