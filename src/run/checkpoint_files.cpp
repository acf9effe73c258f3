#include "run/checkpoint_files.h"

#include "base/make_folder.h"
#include "base/text.h"
#include "observe/whole_file.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::run {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view before_step = "step_";
constexpr std::string_view behind_step = ".ckpt";
constexpr std::size_t kept = 2;

std::optional<std::int64_t> step_of(const fs::path& file) {
    const std::string name = file.filename().string();
    if (name.size() <= before_step.size() + behind_step.size() || !name.starts_with(before_step) ||
        !name.ends_with(behind_step))
        return std::nullopt;
    const auto step = parse_integer(
        std::string_view(name).substr(before_step.size(), name.size() - before_step.size() - behind_step.size()));
    return step && *step >= 0 ? std::optional(*step) : std::nullopt;
}

} // namespace

fs::path checkpoint_path(const fs::path& folder, std::int64_t step) {
    return folder / fmt::format("{}{:012}{}", before_step, step, behind_step);
}

std::vector<fs::path> list_checkpoints(const fs::path& folder) {
    std::vector<std::pair<std::int64_t, fs::path>> numbered;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (const auto step = step_of(entry->path()))
            numbered.emplace_back(*step, entry->path());
    std::sort(numbered.rbegin(), numbered.rend());
    std::vector<fs::path> files;
    for (auto& [step, file] : numbered)
        files.push_back(std::move(file));
    return files;
}

Result<std::int64_t> keep_checkpoint(const fs::path& folder, const Checkpoint& checkpoint) {
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    const std::string bytes = to_bytes(checkpoint);
    const Result<Done> written =
        observe::write_whole(checkpoint_path(folder, checkpoint.step), bytes, observe::Writing::lasting);
    if (!written)
        return written.problems();
    const std::vector<fs::path> files = list_checkpoints(folder);
    std::error_code ignored;
    for (std::size_t k = kept; k < files.size(); ++k)
        fs::remove(files[k], ignored);
    return static_cast<std::int64_t>(bytes.size());
}

} // namespace tumble::run
