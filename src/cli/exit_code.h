#pragma once

namespace tumble::cli {

/// What the shell gets.
enum ExitCode : int {
    fine = 0,
    failed = 1,        // a run or a verdict failed
    wrong = 2,         // scene, data or flags
    interrupted = 130, // Ctrl-C
    terminated = 143   // SIGTERM, as shells count
};

} // namespace tumble::cli
