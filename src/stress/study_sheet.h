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

/// cases.csv (a line a case), slices.csv (a line a case and slice), facets.csv (a line an instant and facet touched),
/// worst.vtu (the case with the largest von Mises stress); docs/stress.md has the columns; and study.txt, the settings.
/// Returns what was written. Problems: the system's.
Result<std::vector<std::filesystem::path>> write_study(const Study& study, const scene::SpecimenShape& specimen,
                                                       const run::PartLoads& loads,
                                                       const std::filesystem::path& folder);

/// Study::settings of the study that write_study left in a folder; empty where there is none.
std::string kept_settings(const std::filesystem::path& folder);
/// "element = standard, now incompatible; ...".
std::string what_differs(const std::string& kept, const std::string& settings);

} // namespace tumble::stress
