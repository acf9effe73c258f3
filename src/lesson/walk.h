#pragma once

#include "sheet/sheet.h"

#include <string>

/// What a lesson shows.
namespace tumble::lesson {

using sheet::at_most;
using sheet::Axis;
using sheet::Cell;
using sheet::Column;
using sheet::Curve;
using sheet::Figure;
using sheet::Formula;
using sheet::Grid;
using sheet::Heading;
using sheet::Paragraph;
using sheet::Style;

struct Walk : sheet::Sheet {
    std::string question{};
    std::string answer{};
};

} // namespace tumble::lesson
