#pragma once

#include "base/problem.h"
#include "lesson/walk.h"

#include <filesystem>

/// Films as files.
namespace tumble::lesson {

/// The picture that stands for the film, as PNG. Problems: those of drawing.
Result<Done> draw_poster(const Film& film, const std::filesystem::path& file);

/// The film as MP4. Problems: as those of drawing, and without ffmpeg.
Result<Done> shoot(const Film& film, const std::filesystem::path& file);

} // namespace tumble::lesson
