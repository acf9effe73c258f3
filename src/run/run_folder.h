#pragma once

#include "base/problem.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace tumble::run {

/// Names inside a run's folder.
struct RunFolder {
    std::filesystem::path root;

    [[nodiscard]] std::filesystem::path scene() const { return root / "scene.toml"; }
    [[nodiscard]] std::filesystem::path summary() const { return root / "run.json"; }
    [[nodiscard]] std::filesystem::path series() const { return root / "series.csv"; }
    [[nodiscard]] std::filesystem::path frames() const { return root / "frames"; }
    [[nodiscard]] std::filesystem::path pictures() const { return root / "pictures"; }
    [[nodiscard]] std::filesystem::path video() const { return root / "video.mp4"; }
    [[nodiscard]] std::filesystem::path redrawn() const { return root / "redrawn"; }
    [[nodiscard]] std::filesystem::path meshes() const { return root / "meshes"; }
    [[nodiscard]] std::filesystem::path paraview() const { return root / "paraview"; }
    [[nodiscard]] std::filesystem::path text_dump() const { return root / "spheres.dump"; }
    [[nodiscard]] std::filesystem::path checkpoints() const { return root / "state"; }
};

/// A folder being filled. Keeps a little space in reserve so that run.json can be written on a disk that ran full;
/// unless `keep` is called everything that it made is removed again.
class FolderInWork {
public:
    /// Makes the folder, or takes an empty one; with `overwrite` keep() will remove what an earlier run and its
    /// redrawings left there, and only that. `bytes` is what the run will write at least. Problems: it holds something,
    /// cannot be made or written, too little space, another run is going on in it.
    static Result<FolderInWork> open(const std::filesystem::path& root, bool overwrite, std::uintmax_t bytes);

    /// Takes the folder of a run that is to go on and keeps it, whatever happens. Problems: cannot be written, another
    /// run is going on in it.
    static Result<FolderInWork> go_on(const std::filesystem::path& root);

    FolderInWork(FolderInWork&& other) noexcept;
    FolderInWork& operator=(FolderInWork&&) = delete;
    ~FolderInWork();

    [[nodiscard]] const RunFolder& paths() const { return paths_; }
    /// From now on the folder is worth keeping, whatever happens.
    void keep();
    /// Waits until the disk has the names of what lies in the folder, and those of the folder and of all that were made
    /// on the way to it. Problems: the system's reason.
    [[nodiscard]] Result<Done> wait_for_names() const;
    /// Gives the reserved space free, for the last things to be written.
    void release_reserve();

private:
    explicit FolderInWork(RunFolder paths) : paths_(std::move(paths)) {}

    RunFolder paths_;
    std::filesystem::path made_from_; // topmost folder that was not there before, or empty
    bool kept_ = false;
    bool alive_ = true;
    int lock_ = -1; // the folder, held against other runs; the system lets go of it however the program ends

    std::optional<Problem> lock();
};

/// Its own name, without the way to it: "a" of "out/a" and of "out/a/".
std::string folder_name(const std::filesystem::path& folder);

/// How many pictures lie in a folder.
std::int64_t count_pictures(const std::filesystem::path& folder);

/// Whether all that lies in the folder is of the kinds that a run puts there.
bool holds_only_a_run(const std::filesystem::path& root);

/// Whether `tumble stress` has filled the folder.
bool holds_stresses(const std::filesystem::path& root);

/// Whether the folder holds what a run leaves (scene and frames). Problems name what is missing.
Result<RunFolder> find_run(const std::filesystem::path& root);

} // namespace tumble::run
