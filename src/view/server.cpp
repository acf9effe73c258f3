#include "view/server.h"

#include "view/allowance.h"
#include "view/guard.h"
#include "view/page.h"

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <fmt/format.h>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace tumble::view {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;
using beast::error_code;

// A second frame may be under way while the first is shown: the way there and back then costs no frame.
constexpr std::uint32_t frames_under_way = 2;
constexpr int most_answers = 100;                     // of the page's files to one connection
constexpr std::chrono::milliseconds accept_pause{50}; // when the system gives no socket, or too many come
constexpr std::size_t most_held_keys = 64;            // on no keyboard are more held at once

struct Frame {
    std::uint32_t number = 0;
    std::vector<std::uint8_t> bytes;
};
using FramePtr = std::shared_ptr<const Frame>;

/// A place among a limited number, given back when the last copy goes.
using Seat = std::shared_ptr<void>;

Seat take_seat(std::atomic<std::size_t>& taken, std::size_t most) {
    if (taken.fetch_add(1) >= most) {
        taken.fetch_sub(1);
        return nullptr;
    }
    return {&taken, [](void* count) { static_cast<std::atomic<std::size_t>*>(count)->fetch_sub(1); }};
}

std::string text_of(beast::string_view text) {
    return {text.data(), text.size()};
}

class Watcher;
class Visitor;

/// What connections share; all but the newest frame and the counts is touched by the server's thread only.
struct Shared {
    Shared(Limits limits_, Listener listener_) : limits(limits_), listener(std::move(listener_)) {}

    Limits limits;
    Listener listener;
    std::optional<Guard> guard;
    std::set<Watcher*> watching;
    std::list<Visitor*> strangers; // the oldest first
    std::atomic<std::size_t> connected{0};
    std::atomic<std::size_t> seated{0};  // watchers
    std::atomic<std::uint32_t> taken{0}; // number of the newest frame that went to one
    mutable std::mutex mutex;            // of the two below
    FramePtr newest;
    std::string link;

    [[nodiscard]] FramePtr frame() const {
        const std::lock_guard lock(mutex);
        return newest;
    }
};

/// One browser that frames go to.
class Watcher : public std::enable_shared_from_this<Watcher> {
public:
    Watcher(Shared& shared, beast::tcp_stream stream, Seat watcher)
        : shared_(shared), socket_(std::move(stream)), seat_(std::move(watcher)) {
        socket_.read_message_max(shared_.limits.message_bytes);
        socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
        socket_.binary(true);
    }
    Watcher(const Watcher&) = delete;
    Watcher& operator=(const Watcher&) = delete;
    ~Watcher() { shared_.watching.erase(this); }

    void accept(const http::request<http::string_body>& request) {
        beast::get_lowest_layer(socket_).expires_never(); // the WebSocket has its own clock
        socket_.async_accept(request, [self = shared_from_this()](error_code failed) {
            if (failed)
                return;
            self->shared_.watching.insert(self.get());
            self->shared_.listener.watcher_joined();
            self->read();
            self->offer();
        });
    }

    /// Sends the newest frame if this browser is ready for one and has not had it.
    void offer() {
        const FramePtr frame = shared_.frame();
        if (sending_ || !frame || frame->number == sent_ || under_way_ >= frames_under_way)
            return;
        sending_ = frame;
        sent_ = frame->number;
        ++under_way_;
        shared_.taken = sent_;
        shared_.listener.frame_taken();
        socket_.async_write(asio::buffer(frame->bytes),
                            [self = shared_from_this()](error_code failed, std::size_t /*bytes*/) {
                                if (failed)
                                    return;
                                self->sending_.reset();
                                self->offer();
                            });
    }

private:
    void read() {
        socket_.async_read(buffer_, [self = shared_from_this()](error_code failed, std::size_t /*bytes*/) {
            if (failed)
                return self->let_go();
            const std::string text = beast::buffers_to_string(self->buffer_.data());
            self->buffer_.consume(self->buffer_.size());
            if (self->take(text))
                self->read();
            else
                self->close();
        });
    }

    bool take(const std::string& text) {
        if (!socket_.got_text() || !allowance_.take())
            return false;
        const std::optional<Message> message = parse_message(text);
        if (!message)
            return false;
        if (!std::holds_alternative<FrameSeen>(*message)) {
            note_held(*message);
            shared_.listener.message(*message);
            return true;
        }
        if (under_way_ == 0)
            return false;
        --under_way_;
        offer();
        return true;
    }

    void note_held(const Message& message) {
        if (const auto* pressed = std::get_if<PointerPressed>(&message))
            buttons_[pressed->button] = {pressed->button, pressed->x, pressed->y};
        else if (const auto* released = std::get_if<PointerReleased>(&message))
            buttons_.erase(released->button);
        else if (const auto* key = std::get_if<KeyChanged>(&message)) {
            if (!key->down)
                keys_.erase(key->key);
            else if (keys_.size() < most_held_keys)
                keys_.insert(key->key);
        }
    }

    /// The others share this hand: what a browser held as it went would be held for ever.
    void let_go() {
        for (const auto& [button, release] : std::exchange(buttons_, {}))
            shared_.listener.message(release);
        for (const std::string& key : std::exchange(keys_, {}))
            shared_.listener.message(KeyChanged{key, false, false, false});
    }

    void close() {
        shared_.watching.erase(this);
        let_go();
        socket_.async_close(websocket::close_code::policy_error, [self = shared_from_this()](error_code) {});
    }

    Shared& shared_;
    websocket::stream<beast::tcp_stream> socket_;
    Seat seat_;
    beast::flat_buffer buffer_;
    FramePtr sending_;
    std::uint32_t sent_ = 0;
    std::uint32_t under_way_ = 0; // frames sent that were not yet shown
    Allowance allowance_{shared_.limits.messages_per_s};
    std::map<int, PointerReleased> buttons_; // that it holds, where they were pressed
    std::set<std::string> keys_;             // that it holds
};

/// One connection that asks for the page: a stranger until it has brought the cookie or the link's token.
class Visitor : public std::enable_shared_from_this<Visitor> {
public:
    Visitor(Shared& shared, tcp::socket socket)
        : shared_(shared), stream_(std::move(socket)), place_(shared_.strangers.insert(shared_.strangers.end(), this)) {
        if (shared_.strangers.size() > shared_.limits.strangers)
            shared_.strangers.front()->leave();
    }
    Visitor(const Visitor&) = delete;
    Visitor& operator=(const Visitor&) = delete;
    ~Visitor() { be_no_stranger(); }

    void read() {
        parser_.emplace();
        parser_->header_limit(static_cast<std::uint32_t>(shared_.limits.header_bytes));
        parser_->body_limit(shared_.limits.body_bytes);
        stream_.expires_after(shared_.limits.request_wait);
        http::async_read(stream_, buffer_, *parser_,
                         [self = shared_from_this()](error_code failed, std::size_t /*bytes*/) { self->hear(failed); });
    }

private:
    void be_no_stranger() {
        if (place_)
            shared_.strangers.erase(*place_);
        place_.reset();
    }

    /// Without a word.
    void leave() {
        be_no_stranger();
        error_code ignored;
        stream_.socket().close(ignored);
    }

    void hear(error_code failed) {
        if (!stream_.socket().is_open()) // made to leave
            return;
        if (failed == http::error::body_limit)
            return refuse({413, {}, {}, "a request that brings so much is not read"});
        if (failed == http::error::header_limit)
            return refuse({431, {}, {}, "a request with so long a head is not read"});
        if (failed.category() == http::make_error_code(http::error::bad_method).category() &&
            failed != http::error::end_of_stream && failed != http::error::partial_message)
            return refuse({400, {}, {}, "this is not HTTP"});
        if (failed)
            return;
        const auto& request = parser_->get();
        const Answer answer = shared_.guard->judge(
            {text_of(request.method_string()), text_of(request.target()), text_of(request[http::field::host]),
             text_of(request[http::field::origin]), text_of(request[http::field::cookie]),
             websocket::is_upgrade(request), !request.body().empty()});
        if (answer.status == 101 || answer.status == 200)
            be_no_stranger();
        if (answer.status == 101)
            return become_watcher();
        if (answer.status != 200)
            return refuse(answer);
        if (!answer.set_cookie.empty())
            tell_new_link();
        if (!seat_)
            seat_ = take_seat(shared_.connected, shared_.limits.connections);
        const PageFile* file = find_page_file(answer.file);
        respond(200, file->type, file->content, answer.set_cookie,
                request.keep_alive() && seat_ && ++answered_ < most_answers);
    }

    void tell_new_link() {
        const std::string link = shared_.guard->link();
        {
            const std::lock_guard lock(shared_.mutex);
            shared_.link = link;
        }
        shared_.listener.new_link(link);
    }

    void become_watcher() {
        Seat seat = take_seat(shared_.seated, shared_.limits.watchers);
        if (!seat)
            return refuse({503, {}, {}, "as many browsers as may watch do so already: close one of them"});
        const auto request = parser_->release();
        std::make_shared<Watcher>(shared_, std::move(stream_), std::move(seat))->accept(request);
    }

    void refuse(const Answer& answer) {
        respond(answer.status, "text/plain; charset=utf-8", answer.explanation + "\n", "", false);
    }

    void respond(int status, std::string_view type, std::string_view content, const std::string& cookie,
                 bool keep_alive) {
        auto& response = response_.emplace(static_cast<http::status>(status), 11);
        const int port = static_cast<int>(stream_.socket().local_endpoint().port());
        response.set(http::field::content_type, {type.data(), type.size()});
        response.set(
            "Content-Security-Policy",
            fmt::format("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self' "
                        "ws://127.0.0.1:{0} ws://localhost:{0}; base-uri 'none'; form-action 'none'; "
                        "frame-ancestors 'none'",
                        port));
        response.set("X-Content-Type-Options", "nosniff");
        response.set("X-Frame-Options", "DENY");
        response.set("Cross-Origin-Opener-Policy", "same-origin");
        response.set("Cross-Origin-Resource-Policy", "same-origin");
        response.set("Referrer-Policy", "no-referrer");
        response.set(http::field::cache_control, "no-store");
        if (!cookie.empty())
            response.set(http::field::set_cookie, cookie);
        response.body() = std::string(content);
        response.keep_alive(keep_alive);
        response.prepare_payload();
        http::async_write(stream_, response,
                          [self = shared_from_this(), keep_alive](error_code failed, std::size_t /*bytes*/) {
                              if (!failed && keep_alive)
                                  self->read();
                              else
                                  self->stream_.socket().shutdown(tcp::socket::shutdown_send, failed);
                          });
    }

    Shared& shared_;
    beast::tcp_stream stream_;
    std::optional<std::list<Visitor*>::iterator> place_; // among strangers
    Seat seat_;                                          // among those that are none
    int answered_ = 0;
    beast::flat_buffer buffer_;
    std::optional<http::request_parser<http::string_body>> parser_;
    std::optional<http::response<http::string_body>> response_;
};

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
