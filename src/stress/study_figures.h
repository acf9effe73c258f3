#pragma once

#include "observe/impacts.h"
#include "sheet/sheet.h"
#include "stress/study.h"

#include <vector>

namespace tumble::stress {

/// The touches of the body that pressed hardest, as the thesis' figures 7.20 to 7.23.
sheet::Figure impact_figure(const observe::Impacts& impacts);

/// Stresses and loads over time; those of contacts for instants alone.
std::vector<sheet::Figure> time_figures(const Study& study, bool means);

} // namespace tumble::stress
