#pragma once

#include "observe/frame.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace tumble::observe {

/// Shapes, walls and domain of a run, written once. Problems: the system's reason.
Result<Done> write_layout(const std::filesystem::path& file, const FrameLayout& layout);

/// Problems: not such a file, cut off, changed, counts that do not fit each other.
Result<std::shared_ptr<const FrameLayout>> read_layout(const std::filesystem::path& file);

/// One frame, without its layout. Problems: the system's reason.
Result<Done> write_frame(const std::filesystem::path& file, const Frame& frame);

/// Problems: as read_layout, and shapes or walls that the layout does not have.
Result<Frame> read_frame(const std::filesystem::path& file, const std::shared_ptr<const FrameLayout>& layout);

/// What the head of a frame says.
struct FrameHead {
    double time = 0; // s
    std::int64_t step = 0;
    bool contacts = false; // it has kept who touches whom
};

/// Without reading what it is the head of: whether that is whole and unchanged only read_frame knows. Problems: those
/// of read_head; no time or step.
Result<FrameHead> read_frame_head(const std::filesystem::path& file);

/// "frame_000012.tumble" in the folder.
std::filesystem::path frame_path(const std::filesystem::path& folder, std::int64_t number);
/// "layout.tumble" in the folder.
std::filesystem::path layout_path(const std::filesystem::path& folder);

/// 12 of "frame_000012.tumble", whatever its folder; nothing for files with other names.
std::optional<std::int64_t> frame_number(const std::filesystem::path& file);

/// All frames of a folder, by number. Files with other names are left out.
std::vector<std::filesystem::path> list_frames(const std::filesystem::path& folder);

/// Bytes that a frame with so many bodies and walls takes on disk, up to the head's few hundred.
std::size_t frame_bytes(std::size_t bodies, std::size_t walls);

} // namespace tumble::observe
