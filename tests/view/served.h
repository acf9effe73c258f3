#pragma once

#include "client.h"
#include "view/server.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace tumble::view::testing {

/// A server, and what it heard.
struct Served {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<Message> heard;
    std::atomic<int> links{0};
    std::optional<Server> server;

    explicit Served(Limits limits = {}) {
        Listener listener;
        listener.message = [this](const Message& message) {
            if (message == Message(WheelTurned{6, 6, 6}))
                throw std::runtime_error("a listener in trouble");
            {
                const std::lock_guard lock(mutex);
                heard.push_back(message);
            }
            changed.notify_all();
        };
        listener.new_link = [this](const std::string&) { ++links; };
        auto opened = Server::open(0, limits, std::move(listener));
        REQUIRE_MESSAGE(opened.ok(), to_string(opened.problems()));
        server.emplace(std::move(*opened));
    }
    int port() const { return server->port(); }
    std::string origin() const { return "http://127.0.0.1:" + std::to_string(port()); }
    std::string cookie() const { return cookie_for(port(), server->link()); }

    std::unique_ptr<Client> watcher(const std::string& cookie) const {
        auto client = std::make_unique<Client>(port());
        client->send(upgrade(port(), cookie, origin()));
        REQUIRE(client->status() == 101);
        return client;
    }
    bool hears(std::size_t count) {
        std::unique_lock lock(mutex);
        return changed.wait_for(lock, std::chrono::seconds(60), [&] { return heard.size() >= count; });
    }
};

inline int answer_to(const Served& served, const std::string& bytes) {
    Client client(served.port());
    client.send(bytes);
    return client.status();
}

/// The status that a watcher is sent away with.
inline int goodbye(Client& client) {
    auto heard = client.hear();
    while (heard && heard->opcode != 8)
        heard = client.hear();
    REQUIRE(heard);
    return static_cast<unsigned char>(heard->payload[0]) << 8 | static_cast<unsigned char>(heard->payload[1]);
}

} // namespace tumble::view::testing
