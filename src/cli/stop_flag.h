#pragma once

#include <atomic>

namespace tumble::cli {

/// From now on Ctrl-C and SIGTERM set the flag instead of ending the program; a second one ends it at once.
const std::atomic<bool>& watch_for_stop();

/// The exit code of whatever was stopped: interrupted or terminated.
int stop_code();

} // namespace tumble::cli
