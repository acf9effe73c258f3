#pragma once

#include "view/guard.h"
#include "view/server.h"

#include <atomic>
#include <list>
#include <mutex>
#include <optional>
#include <set>

/// What the connections of one server share.
namespace tumble::view {

class Watcher;
class Visitor;

struct Frame {
    std::uint32_t number = 0;
    std::vector<std::uint8_t> bytes;
};
using FramePtr = std::shared_ptr<const Frame>;

/// All but the newest frame and the counts is touched by the server's thread only.
struct Shared {
    Shared(const Limits& limits_, Listener listener_) : limits(limits_), listener(std::move(listener_)) {}

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

/// A place among a limited number, given back when the last copy goes.
using Seat = std::shared_ptr<void>;

/// Null when all are taken.
inline Seat take_seat(std::atomic<std::size_t>& taken, std::size_t most) {
    if (taken.fetch_add(1) >= most) {
        taken.fetch_sub(1);
        return nullptr;
    }
    return {&taken, [](void* count) { static_cast<std::atomic<std::size_t>*>(count)->fetch_sub(1); }};
}

} // namespace tumble::view
