#include "observe/frame_file.h"

#include "observe/frame_arrays.h"
#include "observe/whole_file.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace tumble::observe {

namespace {

constexpr std::string_view prefix = "frame_";
constexpr std::string_view suffix = ".tumble";

Problems in_file(Problems problems, const std::filesystem::path& file) {
    for (Problem& problem : problems)
        problem.file = file.string();
    return problems;
}

Result<ArrayFile> read_arrays(const std::filesystem::path& file, const std::string& kind) {
    const Result<std::string> bytes = read_whole(file);
    if (!bytes)
        return bytes.problems();
    return from_bytes(*bytes, kind, file);
}

} // namespace

Result<Done> write_layout(const std::filesystem::path& file, const FrameLayout& layout) {
    return write_whole(file, to_bytes(to_arrays(layout)));
}

Result<std::shared_ptr<const FrameLayout>> read_layout(const std::filesystem::path& file) {
    const Result<ArrayFile> content = read_arrays(file, "layout");
    if (!content)
        return content.problems();
    Result<FrameLayout> layout = layout_from(*content);
    if (!layout)
        return in_file(layout.problems(), file);
    return std::make_shared<const FrameLayout>(std::move(*layout));
}

Result<Done> write_frame(const std::filesystem::path& file, const Frame& frame) {
    return write_whole(file, to_bytes(to_arrays(frame)));
}

Result<Frame> read_frame(const std::filesystem::path& file, const std::shared_ptr<const FrameLayout>& layout) {
    const Result<ArrayFile> content = read_arrays(file, "frame");
    if (!content)
        return content.problems();
    Result<Frame> frame = frame_from(*content, layout);
    if (!frame)
        return in_file(frame.problems(), file);
    return frame;
}

Result<FrameHead> read_frame_head(const std::filesystem::path& file) {
    const auto head = read_head(file, "frame");
    if (!head)
        return head.problems();
    FrameHead frame;
    if (!take_instant(*head, frame.time, frame.step))
        return Problem{
            .file = file.string(), .what = "has no time_s and step in its head", .fix = "run the scene again"};
    for (const nlohmann::json& array : (*head)["arrays"])
        frame.contacts = frame.contacts || array["name"] == contacts_array;
    return frame;
}

std::filesystem::path frame_path(const std::filesystem::path& folder, std::int64_t number) {
    return folder / fmt::format("{}{:06}{}", prefix, number, suffix);
}

std::filesystem::path layout_path(const std::filesystem::path& folder) {
    return folder / "layout.tumble";
}

std::optional<std::int64_t> frame_number(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.size() <= prefix.size() + suffix.size() || !name.starts_with(prefix) || !name.ends_with(suffix))
        return std::nullopt;
    const std::string digits = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    if (digits.size() > 12 || !std::all_of(digits.begin(), digits.end(), is_digit))
        return std::nullopt;
    return std::stoll(digits);
}

std::vector<std::filesystem::path> list_frames(const std::filesystem::path& folder) {
    std::vector<std::pair<std::int64_t, std::filesystem::path>> numbered;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (const auto number = frame_number(entry->path()))
            numbered.emplace_back(*number, entry->path());
    std::sort(numbered.begin(), numbered.end());
    std::vector<std::filesystem::path> files;
    for (auto& [number, file] : numbered)
        files.push_back(std::move(file));
    return files;
}

std::size_t frame_bytes(std::size_t bodies, std::size_t walls) {
    const std::size_t per_body = 2 * sizeof(std::int64_t) + (3 + 4 + 3 + 3) * sizeof(double);
    const std::size_t per_wall = (9 + 3 + 3 + 3) * sizeof(double);
    return bodies * per_body + walls * per_wall;
}

} // namespace tumble::observe
