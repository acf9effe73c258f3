#pragma once

#include "stress/study.h"

namespace tumble::stress {

/// What a study's figures do not show, a sentence each: instants that missed the impacts, cases of before the media
/// were in and the walls moved.
std::vector<std::string> doubts_of(const scene::Scene& scene, const Study& study, bool means);

} // namespace tumble::stress
