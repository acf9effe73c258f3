#pragma once

#include "observe/array_file.h"
#include "observe/frame.h"

/// Frames and layouts as named arrays, in memory.
namespace tumble::observe {

ArrayFile to_arrays(const FrameLayout& layout);
ArrayFile to_arrays(const Frame& frame);

/// Array that frames have where their run has kept contacts.
constexpr const char* contacts_array = "contact_bodies";

/// Time (s) and step in the head of a frame; false where they are not there.
bool take_instant(const nlohmann::json& head, double& time, std::int64_t& step);

/// Problems name no file; the caller adds it.
Result<FrameLayout> layout_from(const ArrayFile& content);
Result<Frame> frame_from(const ArrayFile& content, const std::shared_ptr<const FrameLayout>& layout);

} // namespace tumble::observe
