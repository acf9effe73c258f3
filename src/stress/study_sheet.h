#pragma once

#include "scene/scene.h"
#include "sheet/sheet.h"
#include "stress/study.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::stress {

/// The study as text, tables like the thesis' 7.3 to 7.5 and figures; facts under names that stay.
sheet::Sheet sheet_of(const Study& study, const StudyOptions& options);

/// cases.csv (a line a case), slices.csv (a line a case and slice), worst.vtu (the case with the largest von Mises
/// stress); docs/stress.md has the columns. Returns what was written. Problems: the system's.
Result<std::vector<std::filesystem::path>> write_study(const Study& study, const scene::SpecimenShape& specimen,
                                                       const std::filesystem::path& folder);

} // namespace tumble::stress
