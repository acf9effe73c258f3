#pragma once

#include "base/problem.h"
#include "base/table.h"

#include <string>
#include <vector>

namespace tumble::diagnose {

/// Units that a number of this SI unit may be given in.
std::vector<Unit> units_for(const std::string& si);

/// The SI unit of a measure, or of "time"; a problem where there is none of that name, with the nearest.
Result<std::string> unit_of(const std::string& measure);

} // namespace tumble::diagnose
