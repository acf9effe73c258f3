#pragma once

namespace tumble::cli {

/// Reads the command line, does what it says, returns the exit code (exit_code.h).
int run_program(int count, char** words);

} // namespace tumble::cli
