#pragma once

#include "base/problem.h"

#include <exception>

namespace tumble {

/// An exception as a problem. Bad input never throws in the project's own code. What comes is memory that ran out,
/// threads that the system refuses, file systems that throw, and a key that the program asks for and its list lacks.
Problem problem_of(const std::exception& thrown);

} // namespace tumble
