#include "run/run_folder.h"

#include "base/growing_file.h"
#include "base/text.h"
#include "observe/frame_file.h"
#include "observe/whole_file.h"
#include "scene/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tumble::run {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t reserved_bytes = 64 * 1024;

fs::path reserve_of(const fs::path& root) {
    return root / ".reserve";
}

Problem wrong(const fs::path& place, std::string what, std::string fix) {
    return {.file = place.string(), .what = std::move(what), .fix = std::move(fix)};
}

const std::string elsewhere = "choose another folder with --out DIR";

fs::path set_aside_in(const fs::path& root) {
    return root / ".replaced";
}

/// A folder that a run or a redrawing fills, and the endings of what they put there.
struct FilledFolder {
    fs::path place;
    std::vector<std::string> endings;

    [[nodiscard]] bool made(fs::path file) const {
        if (file.extension() == ".part")
            file.replace_extension();
        return std::find(endings.begin(), endings.end(), file.extension()) != endings.end();
    }
};

std::vector<FilledFolder> folders_of(const RunFolder& run) {
    return {{run.frames(), {".tumble"}},        {run.pictures(), {".png"}}, {run.redrawn(), {".png"}},
            {run.paraview(), {".vtp", ".pvd"}}, {run.meshes(), {".stl"}},   {run.checkpoints(), {".ckpt"}}};
}

/// Everything that a run writes or a redrawing adds, files that were left half-written among it, and nothing else.
std::vector<fs::path> parts_of(const RunFolder& run) {
    std::vector<fs::path> parts;
    for (const fs::path& file : {run.scene(), run.summary(), run.series(), run.video(), run.text_dump()}) {
        parts.push_back(file);
        parts.push_back(growing_name(file));
    }
    for (const FilledFolder& folder : folders_of(run))
        parts.push_back(folder.place);
    return parts;
}

void remove_run(const RunFolder& run) {
    std::error_code ignored;
    for (const fs::path& part : parts_of(run))
        fs::remove_all(part, ignored);
}

/// An earlier run is only renamed until the new one has begun, so that a refusal costs nothing.
std::error_code set_aside(const RunFolder& run) {
    std::error_code error;
    const fs::path aside = set_aside_in(run.root);
    fs::remove_all(aside, error);
    fs::create_directory(aside, error);
    for (const fs::path& part : parts_of(run))
        if (std::error_code ignored; !error && fs::exists(part, ignored))
            fs::rename(part, aside / part.filename(), error);
    return error;
}

void put_back(const RunFolder& run) {
    std::error_code ignored;
    for (const fs::path& part : parts_of(run))
        if (const fs::path old = set_aside_in(run.root) / part.filename(); fs::exists(old, ignored))
            fs::rename(old, part, ignored);
    fs::remove(set_aside_in(run.root), ignored);
}

/// What somebody else put into the folders of the earlier run goes back to where it lay.
void bring_back_others(const RunFolder& run) {
    const fs::path aside = set_aside_in(run.root);
    for (const FilledFolder& folder : folders_of(run)) {
        std::error_code error;
        std::vector<fs::path> others;
        for (fs::recursive_directory_iterator entry(aside / folder.place.filename(), error), end;
             !error && entry != end; entry.increment(error))
            if (std::error_code ignored; !entry->is_directory(ignored) && !folder.made(entry->path()))
                others.push_back(entry->path());
        for (const fs::path& other : others) {
            const fs::path home = run.root / other.lexically_relative(aside);
            fs::create_directories(home.parent_path(), error);
            fs::rename(other, home, error);
        }
    }
}

/// The topmost folder of `root` that does not exist yet.
fs::path first_missing(const fs::path& root) {
    fs::path missing;
    std::error_code ignored;
    for (fs::path at = fs::absolute(root).lexically_normal(); !at.empty() && !fs::exists(at, ignored);
         at = at.parent_path())
        missing = at;
    return missing;
}

std::optional<Problem> check_place(const fs::path& root, bool overwrite) {
    std::error_code error;
    const fs::file_status status = fs::status(root, error);
    if (!fs::exists(status))
        return std::nullopt;
    if (!fs::is_directory(status))
        return wrong(root, "is a file, not a folder", elsewhere);
    const bool empty = fs::is_empty(root, error);
    if (error)
        return wrong(root, "cannot be read: " + error.message(), elsewhere);
    if (!empty && !overwrite)
        return wrong(root, "already holds something, and nothing is overwritten",
                     "the same command with --resume goes on with a run that ended early there, with --force replaces "
                     "it, with --out DIR writes elsewhere");
    return std::nullopt;
}

std::uintmax_t bytes_in(const fs::path& place) {
    std::error_code error;
    if (!fs::is_directory(place, error)) {
        const std::uintmax_t size = fs::file_size(place, error);
        return error ? 0 : size;
    }
    std::uintmax_t sum = 0;
    for (fs::recursive_directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error))
        if (std::error_code ignored; entry->is_regular_file(ignored))
            sum += entry->file_size(ignored);
    return sum;
}

/// Space that becomes free when an earlier run is replaced counts as free.
std::optional<Problem> check_space(const fs::path& root, std::uintmax_t bytes) {
    fs::path place = fs::absolute(root).lexically_normal();
    std::error_code ignored;
    while (!fs::exists(place, ignored) && place != place.parent_path())
        place = place.parent_path();
    struct statvfs disk {};
    if (statvfs(place.c_str(), &disk) != 0 || disk.f_blocks == 0) // no disk, such as /proc: making the folder says why
        return std::nullopt;
    std::uintmax_t available = std::uintmax_t{disk.f_bavail} * disk.f_frsize;
    for (const fs::path& old : parts_of(RunFolder{root}))
        available += bytes_in(old);
    if (available >= bytes)
        return std::nullopt;
    return wrong(root,
                 fmt::format("the run will write at least {}, but only {} are free there",
                             scene::in_words(static_cast<std::size_t>(bytes)),
                             scene::in_words(static_cast<std::size_t>(available))),
                 "free some space, " + elsewhere + ", or write fewer frames (--set render.every_s=...)");
}

std::optional<Problem> reserve_space(const fs::path& root) {
    const int file = ::open(reserve_of(root).c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0)
        return wrong(root, fmt::format("cannot be written: {}", std::strerror(errno)), elsewhere);
    const int error = posix_fallocate(file, 0, reserved_bytes);
    ::close(file);
    if (error == ENOSPC || error == EDQUOT)
        return wrong(root, fmt::format("cannot be written: {}", std::strerror(error)),
                     "free some space or " + elsewhere);
    return std::nullopt;
}

} // namespace

FolderInWork::FolderInWork(FolderInWork&& other) noexcept
    : paths_(std::move(other.paths_)), made_from_(std::move(other.made_from_)), kept_(other.kept_),
      alive_(std::exchange(other.alive_, false)), lock_(std::exchange(other.lock_, -1)) {}

FolderInWork::~FolderInWork() {
    if (lock_ >= 0)
        ::close(lock_);
    if (!alive_)
        return;
    release_reserve();
    if (kept_)
        return;
    remove_run(paths_);
    put_back(paths_);
    std::error_code ignored;
    if (!made_from_.empty())
        for (fs::path at = fs::absolute(paths_.root).lexically_normal(); fs::remove(at, ignored) && at != made_from_;)
            at = at.parent_path();
}

std::optional<Problem> FolderInWork::lock() {
    lock_ = ::open(paths_.root.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    // Disks of some networks know no locks; there the user must take care.
    if (lock_ < 0 || ::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
        return std::nullopt;
    return wrong(paths_.root, "another run is going on in this folder", "wait for it, or stop it first");
}

void FolderInWork::keep() {
    kept_ = true;
    bring_back_others(paths_);
    std::error_code ignored;
    fs::remove_all(set_aside_in(paths_.root), ignored);
}

Result<Done> FolderInWork::wait_for_names() const {
    fs::path at = fs::absolute(paths_.root).lexically_normal();
    if (!at.has_filename()) // "out/drop/"
        at = at.parent_path();
    if (Result<Done> there = observe::wait_for_disk(at); !there)
        return there;
    for (const fs::path top = made_from_.empty() ? at : made_from_;; at = at.parent_path()) {
        const fs::path above = at.parent_path();
        if (::access(above.c_str(), R_OK) == 0) // what may not be read cannot be waited for
            if (Result<Done> there = observe::wait_for_disk(above); !there)
                return there;
        if (at == top || at == above)
            return Done{};
    }
}

void FolderInWork::release_reserve() {
    std::error_code ignored;
    fs::remove(reserve_of(paths_.root), ignored);
}

Result<FolderInWork> FolderInWork::open(const fs::path& root, bool overwrite, std::uintmax_t bytes) {
    if (const auto problem = check_place(root, overwrite))
        return *problem;
    if (const auto problem = check_space(root, bytes + reserved_bytes))
        return *problem;
    FolderInWork folder(RunFolder{root});
    folder.made_from_ = first_missing(root);
    std::error_code error;
    fs::create_directories(root, error);
    if (error)
        return wrong(root, "cannot be made: " + error.message(), elsewhere);
    if (::access(root.c_str(), W_OK) != 0) {
        folder.alive_ = !folder.made_from_.empty();
        return wrong(root, fmt::format("cannot be written: {}", std::strerror(errno)), elsewhere);
    }
    if (const auto problem = folder.lock()) {
        folder.alive_ = false;
        return *problem;
    }
    if (overwrite)
        error = set_aside(folder.paths_);
    if (error) {
        put_back(folder.paths_);
        folder.alive_ = false;
        return wrong(root, "cannot be written: " + error.message(), elsewhere);
    }
    if (const auto problem = reserve_space(root))
        return *problem;
    fs::create_directory(folder.paths_.frames(), error);
    if (error)
        return wrong(folder.paths_.frames(), "cannot be made: " + error.message(), elsewhere);
    return folder;
}

std::string folder_name(const fs::path& folder) {
    const fs::path path = folder.lexically_normal();
    return (path.has_filename() ? path : path.parent_path()).filename().string();
}

Result<FolderInWork> FolderInWork::go_on(const fs::path& root) {
    FolderInWork folder(RunFolder{root});
    folder.alive_ = false; // nothing of it may be taken away
    if (::access(root.c_str(), W_OK) != 0)
        return wrong(root, fmt::format("cannot be written: {}", std::strerror(errno)), elsewhere);
    if (const auto problem = folder.lock())
        return *problem;
    folder.release_reserve(); // of the run that was killed
    if (const auto problem = reserve_space(root))
        return *problem;
    folder.alive_ = folder.kept_ = true;
    return folder;
}

std::int64_t count_pictures(const fs::path& folder) {
    std::int64_t count = 0;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        count += entry->path().extension() == ".png" ? 1 : 0;
    return count;
}

bool holds_only_a_run(const fs::path& root) {
    std::vector<fs::path> own = parts_of(RunFolder{root});
    own.push_back(reserve_of(root));
    own.push_back(set_aside_in(root));
    std::error_code error;
    for (fs::directory_iterator entry(root, error), end; !error && entry != end; entry.increment(error))
        if (std::find(own.begin(), own.end(), entry->path()) == own.end())
            return false;
    return !error;
}

bool holds_stresses(const fs::path& root) {
    std::error_code ignored;
    return fs::exists(root / "study.txt", ignored) || fs::exists(root / "part.txt", ignored);
}

Result<RunFolder> find_run(const fs::path& root) {
    const RunFolder run{root};
    std::error_code error;
    if (!fs::is_directory(root, error))
        return wrong(root, "there is no such folder", "give the folder that `tumble run` made, such as out/drop");
    for (const fs::path& needed : {run.scene(), observe::layout_path(run.frames())})
        if (!fs::exists(needed, error) && holds_stresses(root))
            return wrong(root, "holds the stresses of a part, and no frames of its own",
                         fmt::format("`tumble stress {} --pictures` draws them; frames of the bodies lie in the folder "
                                     "that was run, which study.txt names",
                                     root.string()));
        else if (!fs::exists(needed, error))
            return wrong(root, fmt::format("is not the folder of a run: {} is missing", needed.filename().string()),
                         "give the folder that `tumble run` made, such as out/drop");
    return run;
}

} // namespace tumble::run
