#include "process.h"

#include <cerrno>

namespace test_terminal {

using namespace tumble::test;

namespace {

/// What a person at a terminal sees of `tumble words...`.
std::string on_terminal(const Folder& folder, std::vector<std::string> words,
                        const std::vector<std::string>& environment = {}) {
    int terminal = -1;
    const pid_t pid = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (pid == 0) {
        unsetenv("NO_COLOR");
        setenv("TERM", "xterm", 1);
        for (const std::string& entry : environment)
            setenv(entry.substr(0, entry.find('=')).c_str(), entry.substr(entry.find('=') + 1).c_str(), 1);
        words.insert(words.begin(), TUMBLE_PROGRAM);
        std::vector<char*> all;
        for (std::string& word : words)
            all.push_back(word.data());
        all.push_back(nullptr);
        if (chdir(folder.path.c_str()) == 0)
            execv(TUMBLE_PROGRAM, all.data());
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
    const std::string seen = on_terminal(folder, {"run", "ball.toml", "--force"});
    CHECK(contains(seen, "\r\033[K"));
    CHECK(contains(seen, "\033[36m"));
    CHECK(contains(seen, "steps/s"));
    CHECK(contains(seen, "100 %"));
    const std::string plain = on_terminal(folder, {"run", "ball.toml", "--force"}, {"NO_COLOR=1"});
    CHECK(contains(plain, "100 %"));
    CHECK(plain.find("\033[36m") == std::string::npos);
    CHECK(plain.find("\033[3") == std::string::npos);
}

TEST_CASE(
    "what is done before a run starts and while spheres are fitted is counted on the line, which then goes away") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.01));
    const std::string run = on_terminal(folder, {"run", "ball.toml"});
    const std::size_t placed = run.find("1 of 1 bodies placed"), started = run.find("\r\033[Krunning 0.01 s");
    CHECK(placed != std::string::npos);
    REQUIRE(started != std::string::npos);
    CHECK(placed < started);
    CHECK(run.substr(placed, started - placed).find('\n') == std::string::npos);
    const std::vector<std::string> fit{"fit", "--cone", "10,12", "--spheres", "8"};
    CHECK(contains(on_terminal(folder, fit), "of 5 arrangements tried"));
    CHECK(contains(on_terminal(folder, {"check", "ball.toml"}), "1 of 1 bodies placed"));
    for (std::vector<std::string> words :
         std::vector<std::vector<std::string>>{fit, {"check", "ball.toml"}, {"run", "ball.toml", "--force"}}) {
        words.emplace_back("--quiet");
        const std::string quiet = on_terminal(folder, words);
        CHECK(quiet.find("tried") == std::string::npos);
        CHECK(quiet.find("placed") == std::string::npos);
    }
}

} // namespace test_terminal
