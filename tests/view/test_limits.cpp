// The limits that docs/view.md tells of: what is just within is heard, one more is not.
#include "served.h"
#include "view/allowance.h"

using namespace tumble;
using namespace tumble::view;
using namespace tumble::view::testing;

namespace test_limits {

using Clients = std::vector<std::unique_ptr<Client>>;

Clients silent(const Served& served, int count) {
    Clients clients;
    for (int i = 0; i < count; ++i)
        clients.push_back(std::make_unique<Client>(served.port()));
    return clients;
}

int answer_of(Client& client, const std::string& bytes) {
    client.send(bytes);
    return client.status();
}

TEST_CASE("a request may have 8 KiB of head and 1 KiB of body") {
    const Served served;
    const auto with_head = [&](std::size_t bytes) {
        const std::size_t rest = request(served.port(), "/", "X: \r\n").size();
        return answer_to(served, request(served.port(), "/", "X: " + std::string(bytes - rest, 'x') + "\r\n"));
    };
    CHECK(with_head(8192) == 403); // it has brought no cookie
    CHECK(with_head(8193) == 431);
    const auto with_body = [&](std::size_t bytes) {
        const std::string length = "Content-Length: " + std::to_string(bytes) + "\r\n";
        return answer_to(served, request(served.port(), "/", length) + std::string(bytes, 'x'));
    };
    CHECK(with_body(1024) == 400); // read, but no browser sends one
    CHECK(with_body(1025) == 413);
}

TEST_CASE("a message may have 256 bytes") {
    Served served;
    const auto watcher = served.watcher(served.cookie());
    const std::string said = "move 1 2";
    watcher->say(said + std::string(256 - said.size(), ' '));
    REQUIRE(served.hears(1));
    CHECK(served.heard[0] == Message(PointerMoved{1, 2}));
    watcher->say(said + std::string(257 - said.size(), ' '));
    CHECK(goodbye(*watcher) == 1009);
}

TEST_CASE("500 messages of a watcher and 500 connections may come at once, and then one every 2 ms") {
    const Limits limits;
    for (const double per_s : {limits.messages_per_s, limits.connections_per_s}) {
        const Allowance::Clock::time_point begun;
        Allowance allowance(per_s, begun);
        for (int i = 0; i < 500; ++i)
            CHECK(allowance.take(begun));
        CHECK(!allowance.take(begun));
        CHECK(!allowance.take(begun + std::chrono::microseconds(1999)));
        CHECK(allowance.take(begun + std::chrono::microseconds(2001)));
    }
    Served served;
    const auto watcher = served.watcher(served.cookie());
    for (int i = 0; i < 500; ++i)
        watcher->say("wheel 1 1 1");
    CHECK(served.hears(500));
}

/// Connections are taken in the order in which they come: one that is answered comes after all before it.
TEST_CASE("24 connections that have brought no cookie are kept, and the 25th ends the oldest of them") {
    Limits limits;
    limits.request_wait = std::chrono::hours(1);
    const Served served(limits);
    const Clients within = silent(served, 23);
    CHECK(answer_to(served, request(served.port(), "/")) == 403); // the 24th
    CHECK(answer_of(*within.front(), request(served.port(), "/")) == 403);
    const Served other(limits);
    const Clients beyond = silent(other, 24);
    CHECK(answer_to(other, request(other.port(), "/")) == 403); // the 25th
    CHECK(beyond[0]->is_closed());
    CHECK(answer_of(*beyond[1], request(other.port(), "/")) == 403);
}

TEST_CASE("24 connections with the cookie are kept open for further files, and one more is answered and closed") {
    const Served served;
    const std::string asks = request(served.port(), "/view.css", "Cookie: " + served.cookie() + "\r\n");
    Clients clients;
    for (std::size_t i = 0; i < 25; ++i) {
        CAPTURE(i);
        clients.push_back(std::make_unique<Client>(served.port()));
        clients[i]->send(asks);
        const std::string head = clients[i]->head();
        CHECK(head.starts_with("HTTP/1.1 200 "));
        CHECK((head.find("Connection: close") == std::string::npos) == (i < 24));
    }
    CHECK(clients[24]->is_closed());
    CHECK(answer_of(*clients[23], asks) == 200);
}

TEST_CASE("eight may watch, and the ninth is refused") {
    const Served served;
    const std::string cookie = served.cookie();
    Clients watching;
    for (int i = 0; i < 8; ++i)
        watching.push_back(served.watcher(cookie));
    CHECK(answer_to(served, upgrade(served.port(), cookie, served.origin())) == 503);
    CHECK(served.server->watchers() == 8);
}

} // namespace test_limits
