#include "base/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace tumble {

constexpr int patience_ms = 60000;

ChildProcess::ChildProcess(const std::vector<std::string>& words) {
    // A socket instead of a pipe: writing to it can be told not to raise SIGPIPE, for this write only.
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        error_ = errno;
        return;
    }
    input_ = ends[0];
    // What it prints goes into memory: nobody has to read it for the program to go on.
    output_ = ::memfd_create("printed", MFD_CLOEXEC);
    std::vector<char*> arguments;
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, output_, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, output_, STDERR_FILENO);
    posix_spawnattr_t manner;
    posix_spawnattr_init(&manner);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&manner, &none);
    posix_spawnattr_setpgroup(&manner, 0);
    posix_spawnattr_setflags(&manner, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    error_ = ::posix_spawnp(&id_, arguments[0], &files, &manner, arguments.data(), environ);
    posix_spawnattr_destroy(&manner);
    posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
    if (error_ != 0) {
        id_ = -1;
    }
}

ChildProcess::~ChildProcess() {
    close_input();
    if (id_ > 0) {
        ::kill(id_, SIGKILL);
        ::waitpid(id_, nullptr, 0);
    }
    if (output_ >= 0) {
        ::close(output_);
    }
}

void ChildProcess::close_input() {
    if (input_ >= 0) {
        ::close(input_);
        input_ = -1;
    }
}

bool ChildProcess::feed(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        pollfd ready{.fd = input_, .events = POLLOUT, .revents = 0};
        const int answer = ::poll(&ready, 1, patience_ms);
        if (answer < 0 && errno == EINTR) {
            continue;
        }
        if (answer <= 0) {
            return false;
        }
        const ssize_t count = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count < 0 && errno != EINTR && errno != EAGAIN) {
            return false;
        }
        bytes = bytes.subspan(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return true;
}

int ChildProcess::wait(std::chrono::milliseconds limit) {
    close_input();
    if (id_ <= 0) {
        return -1;
    }
    const auto until = std::chrono::steady_clock::now() + limit;
    int status = 0;
    pid_t ended = 0;
    while ((ended = ::waitpid(id_, &status, WNOHANG)) == 0 && std::chrono::steady_clock::now() < until) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (ended == 0) {
        ::kill(id_, SIGKILL);
        ::waitpid(id_, &status, 0);
    }
    id_ = -1;
    return ended > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::optional<int> ChildProcess::ended() {
    int status = 0;
    if (id_ > 0 && ::waitpid(id_, &status, WNOHANG) != id_) {
        return std::nullopt;
    }
    const bool exited = std::exchange(id_, -1) > 0 && WIFEXITED(status);
    return exited ? WEXITSTATUS(status) : -1;
}

std::string ChildProcess::printed() const {
    constexpr off_t most = 256 * 1024;
    const off_t size = output_ >= 0 ? ::lseek(output_, 0, SEEK_END) : 0;
    if (size <= 0) {
        return {};
    }
    std::string text(static_cast<std::size_t>(std::min(size, most)), '\0');
    const ssize_t count = ::pread(output_, text.data(), text.size(), size - static_cast<off_t>(text.size()));
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
}

} // namespace tumble
