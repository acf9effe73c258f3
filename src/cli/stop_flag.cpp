#include "cli/stop_flag.h"

#include "cli/exit_code.h"

#include <csignal>

namespace tumble::cli {

namespace {

std::atomic<bool> stop{false};
std::atomic<int> by_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "a signal handler may touch nothing that locks");

extern "C" void remember_signal(int signal) {
    by_signal.store(signal, std::memory_order_relaxed);
    stop.store(true, std::memory_order_relaxed);
}

} // namespace

const std::atomic<bool>& watch_for_stop() {
    for (const int signal : {SIGINT, SIGTERM}) {
        struct sigaction action {};
        action.sa_handler = remember_signal;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
        sigemptyset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
    return stop;
}

int stop_code() {
    return by_signal.load(std::memory_order_relaxed) == SIGTERM ? terminated : interrupted;
}

} // namespace tumble::cli
