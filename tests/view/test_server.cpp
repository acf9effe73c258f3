#include "served.h"

#include <chrono>
#include <thread>

using namespace tumble;
using namespace tumble::view;
using namespace tumble::view::testing;

namespace test_server {

TEST_CASE("the page comes for the link's token with a strict policy, and its files for the cookie") {
    const Served served;
    const int port = served.port();
    Client client(port);
    client.send(request(port, target_of(served.server->link())));
    const std::string head = client.head();
    CHECK(head.starts_with("HTTP/1.1 200 "));
    CHECK(client.body().find("<canvas") != std::string::npos);
    CHECK(client.body().find("<script>") == std::string::npos); // nothing inline, as the policy demands
    for (const char* line : {"Content-Security-Policy: default-src 'none'; script-src 'self'", "frame-ancestors 'none'",
                             "X-Content-Type-Options: nosniff", "Cross-Origin-Resource-Policy: same-origin",
                             "Referrer-Policy: no-referrer", "Cache-Control: no-store", "HttpOnly; SameSite=Strict"})
        CHECK_MESSAGE(head.find(line) != std::string::npos, line);
    CHECK(head.find("Access-Control") == std::string::npos);
    CHECK(served.links == 1);
    const std::string cookie = served.cookie();
    for (const char* path : {"/", "/view.js", "/view.css"})
        CHECK_MESSAGE(answer_to(served, request(port, path, "Cookie: " + cookie + "\r\n")) == 200, path);
}

TEST_CASE("each refusal has its status: 400, 403, 404, 405, 413, 426, 431") {
    const Served served;
    const int port = served.port();
    const std::string cookie = "Cookie: " + served.cookie() + "\r\n";
    CHECK(answer_to(served, "no such thing\r\n\r\n") == 400);
    CHECK(answer_to(served, "GET / HTTP/1.1\r\n" + cookie + "\r\n") == 400); // no host
    CHECK(answer_to(served, request(port, "/")) == 403);
    CHECK(answer_to(served, request(port, "/?token=" + std::string(32, '0'))) == 403);
    CHECK(answer_to(served, request(port, "/", cookie + "Origin: http://evil.example\r\n")) == 403);
    CHECK(answer_to(served, "GET / HTTP/1.1\r\nHost: evil.example\r\n" + cookie + "\r\n") == 403);
    CHECK(answer_to(served, request(port, "/etc/passwd", cookie)) == 404);
    CHECK(answer_to(served, "POST / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n" + cookie +
                                "Content-Length: 1\r\n\r\nx") == 405);
    CHECK(answer_to(served, request(port, "/", cookie + "Content-Length: 1000000\r\n")) == 413);
    CHECK(answer_to(served, request(port, "/frames", cookie)) == 426);
    CHECK(answer_to(served, request(port, "/", "X: " + std::string(10000, 'x') + "\r\n")) == 431);
    CHECK(answer_to(served, upgrade(port, "tumble=1", served.origin())) == 403);
    CHECK(answer_to(served, upgrade(port, served.cookie(), "http://evil.example")) == 403);
}

TEST_CASE("a watcher gets the newest frame with its number and state, and its messages are heard in order") {
    Served served;
    const auto client = served.watcher(served.cookie());
    served.server->show({0xff, 0xd8, 0x01}, "{\"time\":1}");
    const auto heard = client->hear();
    REQUIRE(heard);
    CHECK(heard->opcode == 2);
    const std::string expected{"\x01\x00\x00\x00\x0a\x00\x00\x00{\"time\":1}\xff\xd8\x01", 21};
    CHECK(heard->payload == expected);
    client->say("seen 1");
    client->say("move 1 2");
    client->say("size 0 0 1");
    REQUIRE(served.hears(2));
    CHECK(served.heard[0] == Message(PointerMoved{1, 2}));
    CHECK(served.heard[1] == Message(Resized{0, 0, 1}));
}

TEST_CASE("who does not say that he saw his frames gets two and no more, while another one gets all") {
    Served served;
    const std::string cookie = served.cookie();
    const auto slow = served.watcher(cookie);
    const auto quick = served.watcher(cookie);
    const auto number_of = [](const Client::Heard& heard) {
        return static_cast<int>(static_cast<unsigned char>(heard.payload[0]));
    };
    for (int k = 1; k <= 50; ++k) {
        served.server->show({0xff}, "");
        const auto heard = quick->hear();
        REQUIRE(heard);
        CHECK(number_of(*heard) == k);
        quick->say("seen " + std::to_string(k));
    }
    const auto first = slow->hear(), second = slow->hear();
    REQUIRE(second);
    CHECK(number_of(*first) < number_of(*second));
    CHECK(number_of(*second) < 50);
    slow->say("seen 1"); // now there is room for one more: the newest, not those between
    const auto third = slow->hear();
    REQUIRE(third);
    CHECK(number_of(*third) == 50);
}

TEST_CASE("who does not even read keeps nobody waiting, and then gets the frame that was on its way and the newest") {
    Served served;
    const std::string cookie = served.cookie();
    const auto deaf = served.watcher(cookie);
    const auto quick = served.watcher(cookie);
    const std::vector<std::uint8_t> picture(16 << 20, 0xff); // more than the system's buffers of a connection take
    const auto is_frame = [&](const std::optional<Client::Heard>& heard, char number) {
        return heard && heard->payload.size() == 8 + picture.size() && heard->payload[0] == number;
    };
    for (char k = 1; k <= 6; ++k) {
        served.server->show(picture, "");
        REQUIRE(is_frame(quick->hear(), k));
        quick->say("seen " + std::to_string(k));
    }
    CHECK(is_frame(deaf->hear(), 1));
    CHECK(is_frame(deaf->hear(), 6));
}

TEST_CASE("a watcher that says what is no message, too much or too often is sent away with 1008 or 1009") {
    Limits limits;
    limits.messages_per_s = 20;
    const Served served(limits);
    const std::string cookie = served.cookie();
    const auto rude = served.watcher(cookie);
    rude->say("format c:");
    CHECK(goodbye(*rude) == 1008);
    const auto long_winded = served.watcher(cookie);
    long_winded->say("text " + std::string(5000, 'a'));
    CHECK(goodbye(*long_winded) == 1009);
    const auto hasty = served.watcher(cookie);
    for (int i = 0; i < 2000; ++i)
        hasty->say("move 1 1");
    CHECK(goodbye(*hasty) == 1008);
    const auto liar = served.watcher(cookie);
    liar->say("seen 1"); // no frame was sent
    CHECK(goodbye(*liar) == 1008);
}

TEST_CASE("as many may watch as the limits say, and one more once one has gone") {
    Limits limits;
    limits.watchers = 2;
    const Served served(limits);
    const std::string cookie = served.cookie();
    auto first = served.watcher(cookie);
    const auto second = served.watcher(cookie);
    CHECK(served.server->watchers() == 2);
    CHECK(answer_to(served, upgrade(served.port(), cookie, served.origin())) == 503);
    first.reset();
    for (int i = 0; i < 6000 && served.server->watchers() > 1; ++i) // a minute, only so that it fails and does not hang
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    REQUIRE(served.server->watchers() == 1);
    const auto third = served.watcher(cookie);
}

TEST_CASE("strangers that say nothing fill their own seats: the next one ends the oldest, and the owner comes in") {
    Limits limits;
    limits.strangers = 4;
    limits.request_wait = std::chrono::hours(1);
    Served served(limits);
    std::vector<std::unique_ptr<Client>> silent;
    for (int i = 0; i < 20; ++i)
        silent.push_back(std::make_unique<Client>(served.port()));
    const std::string cookie = served.cookie(); // with the link
    const auto watcher = served.watcher(cookie);
    for (int i = 0; i < 20; ++i)
        silent.push_back(std::make_unique<Client>(served.port()));
    CHECK(silent.front()->is_closed());
    CHECK(answer_to(served, request(served.port(), "/view.js", "Cookie: " + cookie + "\r\n")) == 200);
    served.server->show({0xff}, "");
    CHECK(watcher->hear()); // none of them takes a watcher's place
    silent.back()->send(request(served.port(), "/"));
    CHECK(silent.back()->status() == 403); // the newest is still heard
}

TEST_CASE("more connections than may come in a second wait their turn") {
    Limits limits;
    limits.connections_per_s = 20;
    const auto begun = std::chrono::steady_clock::now();
    const Served served(limits);
    for (int i = 0; i < 40; ++i)
        CHECK(answer_to(served, request(served.port(), "/")) == 403);
    // 20 at once, the other 20 at 20 a second.
    CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count() > 0.99);
}

TEST_CASE("a watcher that goes while it holds buttons and keys lets go of them") {
    Served served;
    auto client = served.watcher(served.cookie());
    for (const char* text : {"down 0 5 6", "down 2 7 8", "up 2 7 8", "key Space 1 0 0"})
        client->say(text);
    REQUIRE(served.hears(4));
    client.reset();
    REQUIRE(served.hears(6));
    CHECK(served.heard[4] == Message(PointerReleased{0, 5, 6}));
    CHECK(served.heard[5] == Message(KeyChanged{"Space", false, false, false}));
}

/// One hand for all: who presses has it, until it lets go or another presses.
TEST_CASE("who presses takes over from a watcher that holds something, whose moves and releases count no more") {
    Served served;
    const std::string cookie = served.cookie();
    const auto first = served.watcher(cookie), second = served.watcher(cookie);
    std::size_t count = 0;
    const auto says = [&](const Client& client, const char* text, std::size_t heard = 1) {
        client.say(text);
        count += heard;
        REQUIRE(served.hears(count));
    };
    says(*first, "down 0 5 6");
    says(*first, "key ShiftLeft 1 1 0");
    second->say("move 9 9"); // meanwhile
    says(*second, "wheel 9 9 1");
    CHECK(served.heard.back() == Message(WheelTurned{9, 9, 1}));
    says(*second, "down 0 7 8", 3);
    CHECK(served.heard[3] == Message(PointerReleased{0, 5, 6}));
    CHECK(served.heard[4] == Message(KeyChanged{"ShiftLeft", false, false, false}));
    CHECK(served.heard[5] == Message(PointerPressed{0, 7, 8}));
    first->say("move 1 1");
    first->say("up 0 1 1");
    says(*first, "wheel 1 1 1");
    says(*second, "move 8 8");
    says(*second, "up 0 8 8");
    says(*first, "move 1 1");
    const std::vector<Message> last(served.heard.end() - 4, served.heard.end());
    CHECK(last ==
          std::vector<Message>{WheelTurned{1, 1, 1}, PointerMoved{8, 8}, PointerReleased{0, 8, 8}, PointerMoved{1, 1}});
}

TEST_CASE("what a listener throws ends the connection that it came by, and the server goes on") {
    Served served;
    const std::string cookie = served.cookie();
    const auto first = served.watcher(cookie);
    first->say("wheel 6 6 6");
    CHECK(first->is_closed());
    const auto second = served.watcher(cookie);
    second->say("move 1 2");
    CHECK(served.hears(1));
}

TEST_CASE("a port in use is a problem that says what to do") {
    const Served served;
    const auto second = Server::open(served.port(), {}, {});
    REQUIRE(!second.ok());
    const Problem problem = second.problems().front();
    CHECK(problem.what.find("port " + std::to_string(served.port()) + " of 127.0.0.1 cannot be opened") == 0);
    CHECK(problem.fix == "another program has it: leave --port away, or take another");
}

} // namespace test_server
