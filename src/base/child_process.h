#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

namespace tumble {

/// A program that was started without a shell, its input fed from here, what it prints kept. It has a process group of
/// its own: a Ctrl-C meant for this program lets it finish what it has.
class ChildProcess {
public:
    /// words: the program, looked for in PATH, and its arguments. Afterwards error() is 0, or the system's reason why
    /// it could not be started (ENOENT: there is no such program).
    explicit ChildProcess(const std::vector<std::string>& words);
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    /// Kills it if it still runs.
    ~ChildProcess();

    [[nodiscard]] int error() const { return error_; }

    /// False when the program stopped reading, or took none for a minute; a broken pipe raises no signal.
    bool feed(std::span<const std::uint8_t> bytes);

    /// Ends its input and waits. Its exit status; -1 when it was killed by a signal or did not end in time.
    int wait(std::chrono::milliseconds limit);

    /// Whether it has ended by itself: its exit status, -1 when a signal killed it; nothing while it runs.
    std::optional<int> ended();

    /// What it printed to either stream so far; of very much the last 256 KiB.
    [[nodiscard]] std::string printed() const;

private:
    void close_input();

    pid_t id_ = -1;
    int input_ = -1;
    int output_ = -1;
    int error_ = 0;
};

} // namespace tumble
