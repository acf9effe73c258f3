#include "process.h"

#include <cerrno>

namespace test_terminal {

using namespace tumble::test;

namespace {

/// What a person at a terminal sees of `tumble run`.
std::string on_terminal(const Folder& folder, const std::vector<std::string>& environment) {
    int terminal = -1;
    const pid_t pid = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (pid == 0) {
        unsetenv("NO_COLOR");
        setenv("TERM", "xterm", 1);
        for (const std::string& entry : environment)
            setenv(entry.substr(0, entry.find('=')).c_str(), entry.substr(entry.find('=') + 1).c_str(), 1);
        if (chdir(folder.path.c_str()) == 0)
            execl(TUMBLE_PROGRAM, TUMBLE_PROGRAM, "run", "ball.toml", "--force", nullptr);
        _exit(99);
    }
    REQUIRE(pid > 0);
    std::string seen;
    char buffer[4096];
    while (true) {
        const ssize_t got = read(terminal, buffer, sizeof buffer);
        if (got > 0)
            seen.append(buffer, static_cast<std::size_t>(got));
        else if (got == 0 || errno != EINTR)
            break; // EIO: the other end is closed
    }
    int status = 0;
    waitpid(pid, &status, 0);
    close(terminal);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    return seen;
}

} // namespace

TEST_CASE("a terminal gets one line that is drawn over, with time, rate, time left and energy") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.1));
    const std::string seen = on_terminal(folder, {});
    CHECK(contains(seen, "\r\033[K"));
    CHECK(contains(seen, "\033[36m"));
    CHECK(contains(seen, "steps/s"));
    CHECK(contains(seen, "100 %"));
    const std::string plain = on_terminal(folder, {"NO_COLOR=1"});
    CHECK(contains(plain, "100 %"));
    CHECK(plain.find("\033[36m") == std::string::npos);
    CHECK(plain.find("\033[3") == std::string::npos);
}

} // namespace test_terminal
