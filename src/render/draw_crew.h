#pragma once

#include "base/parallel_for.h"
#include "base/problem.h"

#include <memory>

namespace tumble::render {

/// Threads that draw spheres and shade beside the graphics library, as many as there are cores, up to eight. Problems:
/// the system refuses one.
Result<std::unique_ptr<Crew>> gather_draw_crew();

} // namespace tumble::render
