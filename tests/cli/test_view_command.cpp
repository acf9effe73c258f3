#include "process.h"

#include <netinet/in.h>
#include <sys/socket.h>

using namespace tumble;
using namespace tumble::test;

namespace test_view_command {

/// A port that is taken as long as this lives.
struct Taken {
    int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    int port = 0;
    Taken() {
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        REQUIRE(::bind(socket, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0);
        REQUIRE(::listen(socket, 1) == 0);
        socklen_t size = sizeof place;
        REQUIRE(::getsockname(socket, reinterpret_cast<sockaddr*>(&place), &size) == 0);
        port = ntohs(place.sin_port);
    }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;
    ~Taken() { ::close(socket); }
};

TEST_CASE("view prints its link and nothing else on stdout, and ends well with Ctrl-C") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.1));
    Process process(folder.path, {"view", "ball.toml", "--no-open"});
    const auto printed = [&] { return content_of(folder.path / ".stdout"); };
    REQUIRE(eventually([&] { return printed().ends_with("\n"); }));
    CHECK(printed().starts_with("http://127.0.0.1:"));
    CHECK(printed().size() <= std::string("http://127.0.0.1:65535/?token=\n").size() + 32);
    REQUIRE(eventually([&] { return process.catches(SIGINT); }));
    process.send(SIGINT);
    const Outcome outcome = process.wait();
    CHECK(outcome.code == 0);
    CHECK(outcome.err ==
          "the newest of these links opens the view in a browser on this machine, once; Ctrl-C ends it\n");
}

TEST_CASE("on a screen without a program that opens browsers the link is printed all the same, with a word about it") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.1));
    Process process(folder.path, {"view", "ball.toml"}, {"DISPLAY=:99", "PATH=/nowhere"});
    REQUIRE(eventually([&] { return content_of(folder.path / ".stderr").ends_with("open the link yourself\n"); }));
    CHECK(contains(content_of(folder.path / ".stderr"), "no browser opens by itself here (xdg-open: No such file"));
    CHECK(content_of(folder.path / ".stdout").starts_with("http://127.0.0.1:"));
    REQUIRE(eventually([&] { return process.catches(SIGINT); }));
    process.send(SIGINT);
    CHECK(process.wait().code == 0);
}

TEST_CASE("a port in use, a port that is none, a scene or run that is not there: each says what to do, with code 2") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.1));
    const Taken taken;
    const std::string port = std::to_string(taken.port);
    const Outcome used = tumble_in(folder, {"view", "ball.toml", "--no-open", "--port", port});
    CHECK(used.code == 2);
    CHECK(used.out.empty());
    CHECK(contains(used.err, "port " + port + " of 127.0.0.1 cannot be opened"));
    CHECK(contains(used.err, "another program has it: leave --port away, or take another"));
    const Outcome wrong = tumble_in(folder, {"view", "ball.toml", "--port", "70000"});
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.err, "70000"));
    const Outcome missing = tumble_in(folder, {"view", "bal.toml"});
    CHECK(missing.code == 2);
    CHECK(contains(missing.err, "bal.toml"));
    std::filesystem::create_directory(folder.path / "empty");
    const Outcome empty = tumble_in(folder, {"view", "empty"});
    CHECK(empty.code == 2);
    CHECK(contains(empty.err, "empty"));
}

TEST_CASE("view draws what a browser would show into a file, of a scene and of a run, and replaces none unasked") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.1));
    const Outcome scene =
        tumble_in(folder, {"view", "ball.toml", "--picture", "live.png", "--time", ":0.02", "--size", "1000x500"});
    CHECK_MESSAGE(scene.code == 0, scene.err);
    CHECK(scene.out == "live.png\n"); // and no link: no port was opened
    CHECK(content_of(folder.path / "live.png").substr(1, 3) == "PNG");
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    const std::vector<std::string> of_run{"view",   "out/ball", "--picture", "run.png", "--time",
                                          "0:0.05", "--tab",    "Look",      "--size",  "1000x500"};
    CHECK(tumble_in(folder, of_run).code == 0);
    CHECK(content_of(folder.path / "run.png").substr(1, 3) == "PNG");
    const Outcome again = tumble_in(folder, of_run);
    CHECK(again.code == 2);
    CHECK(contains(again.err, "run.png"));
    std::vector<std::string> forced = of_run;
    forced.emplace_back("--force");
    CHECK(tumble_in(folder, forced).code == 0);
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"view", "ball.toml", "--time", ":0.02"}, {"view", "ball.toml", "--tab", "Look"}})
        CHECK(contains(tumble_in(folder, wrong).err, "add --picture F.png"));
    CHECK(tumble_in(folder, {"view", "ball.toml", "--picture", "live.jpg"}).code == 2);
    const Outcome late = tumble_in(folder, {"view", "out/ball", "--picture", "x.png", "--time", "7:8"});
    CHECK(late.code == 2);
    CHECK(contains(late.err, "they go from 0 to 0.1 s"));
    CHECK(late.err == tumble_in(folder, {"render", "out/ball", "--out", "x", "--time", "7:8"}).err); // the same rule
    const Outcome never = tumble_in(folder, {"view", "ball.toml", "--picture", "x.png", "--time", "7:8"});
    CHECK(never.code == 2);
    CHECK(contains(never.err, "it goes from 0 to 0.1 s"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "x.png"));
    CHECK(tumble_in(folder, {"view", "ball.toml", "--picture", "x.png", "--tab", "Lock"}).code == 2);
    // Where it cannot be written is found out before anything is simulated.
    CHECK(tumble_in(folder, {"view", "out/ball", "--picture", "a/b/x.png", "--time", ":0.05"}).code == 0);
    CHECK(std::filesystem::exists(folder.path / "a/b/x.png"));
    const Outcome nowhere =
        tumble_in(folder, {"view", "ball.toml", "--picture", "/dev/full/x.png", "--set", "duration_s=1e6"});
    CHECK(nowhere.code == 2);
    CHECK(contains(nowhere.err, "/dev/full"));
}

TEST_CASE("a picture of a time after a scene's or a run's end is drawn with a word about it") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.1));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet", "--set", "render.every_s=0.03"}).code == 0);
    const auto drawn = [&](const char* what, const char* time, bool quiet = false) {
        std::vector<std::string> words{"view", what, "--picture", "x.png", "--force", "--size", "1000x500", "--time"};
        words.emplace_back(time);
        if (quiet)
            words.emplace_back("--quiet");
        const Outcome outcome = tumble_in(folder, words);
        CHECK_MESSAGE(outcome.code == 0, outcome.err);
        return outcome.err;
    };
    CHECK(drawn("ball.toml", ":9") ==
          "warning: this scene ends at t = 0.1 s, which is what the picture shows: --time asked for 9 s\n");
    CHECK(drawn("ball.toml", ":9", true).empty());
    CHECK(drawn("ball.toml", ":0.1").empty());
    CHECK(contains(drawn("out/ball", ":9"), "the frames of this run end at t = "));
    CHECK(drawn("out/ball", ":0.1").empty());
    CHECK(drawn("out/ball", ":0.05").empty());
    CHECK(drawn("out/ball", "0:").empty());
}

TEST_CASE("a size that no window of the view has is refused for a picture, with those that one can have") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.1)); // which itself says 160 x 120
    const std::vector<std::string> view{"view", "ball.toml", "--picture", "x.png", "--time", ":0.001"};
    for (const char* size : {"100x100", "319x200", "320x199", "5000x5000", "2561x200", "320x2561"}) {
        std::vector<std::string> words = view;
        words.insert(words.end(), {"--size", size});
        const Outcome refused = tumble_in(folder, words);
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, "take from 320 to 2560 pixels of width and from 200 to 2560 of height"),
                      size);
    }
    CHECK_FALSE(std::filesystem::exists(folder.path / "x.png"));
    CHECK(tumble_in(folder, view).code == 0);
}

TEST_CASE("view says what is missing of a run, and refuses the trail of a body that the run has not") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.1));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet", "--set", "render.every_s=0.02"}).code == 0);
    const std::vector<std::string> view{"view", "out/ball", "--picture", "run.png", "--force", "--size", "1000x500"};
    CHECK(tumble_in(folder, view).err.empty());
    std::vector<std::filesystem::path> frames;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path / "out/ball/frames"))
        if (entry.path().filename().string().starts_with("frame"))
            frames.push_back(entry.path());
    std::sort(frames.begin(), frames.end());
    REQUIRE(frames.size() > 3);
    std::filesystem::remove(frames[2]);
    const Outcome gap = tumble_in(folder, view);
    CHECK_MESSAGE(gap.code == 0, gap.err);
    CHECK(contains(gap.err, "warning: frames are missing between t = 0.02 and 0.06 s, 1 in all"));
    std::vector<std::string> nobody = view;
    nobody.insert(nobody.end(), {"--trails", "99999"});
    const Outcome refused = tumble_in(folder, nobody);
    CHECK(refused.code == 2);
    CHECK(contains(refused.err, "there is no body '99999' whose trail could be drawn"));
}

} // namespace test_view_command
