#include "view/server.h"

#include "view/allowance.h"
#include "view/beast.h"
#include "view/shared.h"
#include "view/visitor.h"
#include "view/watcher.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>
#include <thread>

namespace tumble::view {

namespace {

constexpr std::chrono::milliseconds accept_pause{50}; // when the system gives no socket, or too many come

Problem cannot_listen(int port, const error_code& failed) {
    Problem problem{.what = fmt::format("port {} of 127.0.0.1 cannot be opened: {}", port, failed.message()),
                    .fix = {}};
    problem.fix = failed == asio::error::address_in_use ? "another program has it: leave --port away, or take another"
                                                        : "leave --port away, or take one from 1024 to 65535";
    return problem;
}

} // namespace

std::vector<std::uint8_t> pack_frame(std::uint32_t number, const std::string& state,
                                     const std::vector<std::uint8_t>& jpeg) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(8 + state.size() + jpeg.size());
    for (const std::uint32_t value : {number, static_cast<std::uint32_t>(state.size())})
        for (int shift = 0; shift < 32; shift += 8)
            bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    bytes.insert(bytes.end(), state.begin(), state.end());
    bytes.insert(bytes.end(), jpeg.begin(), jpeg.end());
    return bytes;
}

struct Server::Inside {
    Shared shared; // outlives what still hangs on the loop
    asio::io_context loop{1};
    tcp::acceptor acceptor{loop};
    asio::steady_timer pause{loop};
    Allowance arrivals;
    std::atomic<std::uint32_t> shown{0};
    std::jthread thread;

    Inside(const Limits& limits, Listener listener)
        : shared(limits, std::move(listener)), arrivals(limits.connections_per_s) {}
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() {
        loop.stop();
        if (thread.joinable())
            thread.join();
    }

    error_code listen(int port) {
        error_code failed;
        const tcp::endpoint place(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port));
        acceptor.open(place.protocol(), failed);
        if (!failed)
            acceptor.set_option(asio::socket_base::reuse_address(true), failed); // of connections that just ended
        if (!failed)
            acceptor.bind(place, failed);
        if (!failed)
            acceptor.listen(asio::socket_base::max_listen_connections, failed);
        return failed;
    }

    void accept() {
        if (!arrivals.take())
            return rest();
        acceptor.async_accept([this](error_code failed, tcp::socket socket) {
            if (failed)
                rest();
            else
                accept();
            if (failed)
                return;
            socket.set_option(tcp::no_delay(true), failed);
            std::make_shared<Visitor>(shared, std::move(socket))->read();
        });
    }

    /// When too many come. And without sockets left an accept fails at once, and would again and again.
    void rest() {
        pause.expires_after(accept_pause);
        pause.async_wait([this](error_code stopped) {
            if (!stopped && acceptor.is_open())
                accept();
        });
    }

    /// What a handler throws, memory that ran out or a listener's trouble, ends its connection alone.
    void work() {
        for (bool goes_on = true; goes_on;)
            try {
                loop.run();
                goes_on = false;
            } catch (const std::exception&) {
                goes_on = !loop.stopped();
            }
    }
};

Server::Server(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Server::Server(Server&&) noexcept = default;
Server::~Server() = default;

Result<Server> Server::open(int port, const Limits& limits, Listener listener) {
    auto inside = std::make_unique<Inside>(limits, std::move(listener));
    if (const error_code failed = inside->listen(port))
        return cannot_listen(port, failed);
    const int taken = inside->acceptor.local_endpoint().port();
    inside->shared.guard.emplace(taken);
    inside->shared.link = inside->shared.guard->link();
    inside->accept();
    inside->thread = std::jthread([raw = inside.get()] { raw->work(); });
    return Server(std::move(inside));
}

int Server::port() const {
    return inside_->acceptor.local_endpoint().port();
}

std::string Server::link() const {
    const std::lock_guard lock(inside_->shared.mutex);
    return inside_->shared.link;
}

std::size_t Server::watchers() const {
    return inside_->shared.seated;
}

bool Server::wants_frame() const {
    return inside_->shared.seated > 0 && inside_->shared.taken == inside_->shown;
}

void Server::show(std::vector<std::uint8_t> jpeg, const std::string& state) {
    auto frame = std::make_shared<Frame>();
    frame->number = ++inside_->shown;
    frame->bytes = pack_frame(frame->number, state, jpeg);
    {
        const std::lock_guard lock(inside_->shared.mutex);
        inside_->shared.newest = std::move(frame);
    }
    asio::post(inside_->loop, [&shared = inside_->shared] {
        for (Watcher* watcher : shared.watching)
            watcher->offer();
    });
}

} // namespace tumble::view
