#pragma once

#include "../folder.h"

#include <chrono>
#include <csignal>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <functional>
#include <pty.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

/// The program as a process, the way a shell starts it.
namespace tumble::test {

struct Outcome {
    int code = -1; // 128 + signal when a signal ended it, as shells count
    std::string out;
    std::string err;
};

class Process {
public:
    /// Starts `tumble words...` in `folder`, with "NAME=VALUE" added to the environment.
    Process(const std::filesystem::path& folder, const std::vector<std::string>& words,
            const std::vector<std::string>& environment = {})
        : out_(folder / ".stdout"), err_(folder / ".stderr") {
        std::vector<std::string> all{TUMBLE_PROGRAM};
        all.insert(all.end(), words.begin(), words.end());
        pid_ = fork();
        if (pid_ == 0 && setpgid(0, 0) == 0) // a group of its own, as a shell gives every job
            become(folder, all, environment);
        REQUIRE(pid_ > 0);
    }

    void send(int signal) const { kill(pid_, signal); }
    /// As Ctrl-C does: also to whatever the program has started.
    void send_to_all(int signal) const { kill(-pid_, signal); }

    /// Whether a handler of the program's own waits for the signal by now; before it is the program, this test's does.
    [[nodiscard]] bool catches(int signal) const {
        const std::string process = "/proc/" + std::to_string(pid_);
        std::error_code error;
        if (std::filesystem::read_symlink(process + "/exe", error) != std::filesystem::canonical(TUMBLE_PROGRAM))
            return false;
        const std::string status = content_of(process + "/status");
        const std::size_t at = status.find("SigCgt:");
        return at != std::string::npos && (std::stoull(status.substr(at + 7), nullptr, 16) >> (signal - 1) & 1) != 0;
    }

    Outcome wait() {
        int status = 0;
        waitpid(pid_, &status, 0);
        Outcome outcome;
        outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        outcome.out = content_of(out_);
        outcome.err = content_of(err_);
        return outcome;
    }

private:
    void become(const std::filesystem::path& folder, std::vector<std::string>& all,
                const std::vector<std::string>& environment) const {
        const int out = open(out_.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
        const int err = open(err_.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
        dup2(out, STDOUT_FILENO);
        dup2(err, STDERR_FILENO);
        if (chdir(folder.c_str()) != 0)
            _exit(99);
        for (const std::string& entry : environment) {
            const std::size_t equals = entry.find('=');
            setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
        }
        std::vector<char*> words;
        for (std::string& word : all)
            words.push_back(word.data());
        words.push_back(nullptr);
        execv(words[0], words.data());
        _exit(99);
    }

    std::filesystem::path out_;
    std::filesystem::path err_;
    pid_t pid_ = -1;
};

inline Outcome tumble_in(const Folder& folder, const std::vector<std::string>& words,
                         const std::vector<std::string>& environment = {}) {
    return Process(folder.path, words, environment).wait();
}

/// Waits until something is true; a minute is only there so that a broken program fails instead of hanging.
inline bool eventually(const std::function<bool()>& true_now) {
    for (int i = 0; i < 6000; ++i) {
        if (true_now())
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

inline bool contains(const std::string& text, const std::string& part) {
    const bool found = text.find(part) != std::string::npos;
    if (!found)
        MESSAGE("looked for \"" << part << "\" in: " << text);
    return found;
}

/// A ball of radius 10 mm and 2500 kg/m3 that bounces on a plate for `duration` seconds.
inline std::string bouncing_ball(double duration) {
    return "title = \"A ball that bounces\"\nclaim = \"none\"\nduration_s = " + std::to_string(duration) + R"(
time_step_s = 1e-5
[domain]
lo_m = [-0.1, -0.1, -0.1]
hi_m = [0.1, 0.6, 0.1]
[material.glass]
density_kg_m3 = 2500
youngs_modulus_Pa = 1e8
poisson_ratio = 0.25
[pair.glass-glass]
restitution = 0.8
friction = 0.3
[body.ball]
radius_mm = 10
material = "glass"
[[fill]]
body = "ball"
count = 1
position_m = [0.0, 0.05, 0.0]
[[wall]]
name = "floor"
shape = "plane"
point_m = [0, 0, 0]
normal = [0, 1, 0]
material = "glass"
[observe]
every_s = 0.001
[render]
every_s = 0.01
width_px = 160
height_px = 120
)";
}

/// One disc on a floor, quick to run for a second.
inline const std::string lying_disc = R"(
title = "A disc"
claim = "none"
dimension = 2
depth_m = 0.01
duration_s = 0.1
time_step_s = 1e-4
[domain]
lo_m = [-0.1, -0.1]
hi_m = [0.1, 0.1]
[material.glass]
density_kg_m3 = 2500
[pair.glass-glass]
restitution = 0.5
friction = 0.4
normal_stiffness_N_per_m = 1e3
stiffness_ratio = 0.7
[body.disc]
radius_mm = 10
material = "glass"
[[fill]]
body = "disc"
count = 1
position_m = [0.0, 0.02]
[[wall]]
name = "floor"
shape = "segment"
from_m = [-0.09, 0.0]
to_m = [0.09, 0.0]
material = "glass"
)";

} // namespace tumble::test
