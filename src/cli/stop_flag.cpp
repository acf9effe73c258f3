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

bool is_ignored(int signal) {
    struct sigaction now {};
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

} // namespace

const std::atomic<bool>& watch_for_stop() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        if (signal == SIGHUP && is_ignored(signal)) // of nohup
            continue;
        struct sigaction action {};
        action.sa_handler = remember_signal;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
        sigemptyset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
    return stop;
}

int stop_code() {
    const int signal = by_signal.load(std::memory_order_relaxed);
    return signal == SIGTERM ? terminated : (signal == SIGHUP ? hung_up : interrupted);
}

} // namespace tumble::cli
