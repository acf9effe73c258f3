#pragma once

#include "base/problem.h"

#include <exception>

namespace tumble {

/// An exception as a problem. The project's own code throws none; what comes is memory that ran out, threads that the
/// system refuses, file systems that throw.
Problem problem_of(const std::exception& thrown);

} // namespace tumble
