#pragma once

namespace tumble::cli {

/// What the shell gets.
enum ExitCode : int {
    fine = 0,
    failed = 1,        // a run or a verdict failed
    wrong = 2,         // scene, data or flags
    hung_up = 129,     // SIGHUP: the terminal was closed; this and the next as shells count
    interrupted = 130, // Ctrl-C
    terminated = 143   // SIGTERM
};

} // namespace tumble::cli
