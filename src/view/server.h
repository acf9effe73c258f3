#pragma once

#include "base/problem.h"
#include "view/limits.h"
#include "view/message.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tumble::view {

/// Told what comes in, from the server's own thread; must not wait. A watcher that goes lets go of what it held. What
/// a listener throws ends the connection it was about.
struct Listener {
    std::function<void(const Message&)> message = [](const Message&) {};
    std::function<void()> watcher_joined = [] {};
    std::function<void()> frame_taken = [] {}; // the newest is on its way to a watcher
    std::function<void(const std::string& link)> new_link = [](const std::string&) {}; // the one before was used
};

/// Serves the page and its frames on 127.0.0.1, on a thread of its own. Every watcher gets the newest frame as soon as
/// it has shown the one before: who is slow misses frames, and nobody waits for him.
class Server {
public:
    /// `port` 0: any that is free. Problems: the port is in use, or not ours to take.
    static Result<Server> open(int port, const Limits& limits, Listener listener);
    Server(Server&&) noexcept;
    Server& operator=(Server&&) = delete;
    ~Server();

    [[nodiscard]] int port() const;
    /// For the next browser; each is good for one.
    [[nodiscard]] std::string link() const;
    [[nodiscard]] std::size_t watchers() const;

    /// Whether a watcher has room for a newer frame than the last.
    [[nodiscard]] bool wants_frame() const;

    /// The frame that is now the newest: a JPEG, and a JSON text of what can be seen in it. Never waits.
    void show(std::vector<std::uint8_t> jpeg, const std::string& state);

private:
    struct Inside;
    explicit Server(std::unique_ptr<Inside> inside);
    std::unique_ptr<Inside> inside_;
};

/// How a frame travels: its number, the size of the state text, the text, the JPEG; numbers of 4 bytes, lowest first.
std::vector<std::uint8_t> pack_frame(std::uint32_t number, const std::string& state,
                                     const std::vector<std::uint8_t>& jpeg);

} // namespace tumble::view
