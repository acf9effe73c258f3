#pragma once

#include "base/problem.h"
#include "stress/recorded.h"
#include "stress/study.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::stress {

struct PictureOptions {
    std::string component = "von_mises"; // of fem::components: on the surface and in cuts
    double veil = 0.2;                   // opacity of the media before the part
};

/// Pictures of the case with the largest von Mises stress, as PNG files with the scene's size, background and colours:
/// part.png, the part among the media where their frame was kept, seen from outside of the worst node; cut-along.png
/// and cut-across.png, the part cut through that node, along its axis and across it; and for each slice
/// slice-SIDE-DEPTHmm.png, its normal stress with the side rolled out flat. Part and cuts have the scale of the
/// surface, slices another one. Returns the files. Problems: no such component; those of render::paint_field; the
/// system's.
Result<std::vector<std::filesystem::path>> draw_pictures(const Recorded& recorded, const Study& study,
                                                         const PictureOptions& options,
                                                         const std::filesystem::path& folder);

} // namespace tumble::stress
