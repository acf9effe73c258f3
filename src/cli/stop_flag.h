#pragma once

#include <atomic>

namespace tumble::cli {

/// From now on Ctrl-C, SIGTERM and SIGHUP (unless nohup ignores it) set the flag instead of ending the program; a
/// second one ends it at once.
const std::atomic<bool>& watch_for_stop();

/// The exit code of whatever was stopped: interrupted, terminated or hung_up.
int stop_code();

} // namespace tumble::cli
