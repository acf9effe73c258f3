#pragma once

#include <chrono>
#include <cstddef>

namespace tumble::view {

/// What one browser, or somebody who is none, may take of the program.
struct Limits {
    std::size_t strangers = 24;            // connections that brought no cookie yet; the next one ends the oldest
    std::size_t connections = 24;          // that brought it, kept open for more files
    std::size_t watchers = 8;              // that frames go to
    double connections_per_s = 500;        // new ones; as many may come at once
    std::size_t header_bytes = 8192;       // of a request
    std::size_t body_bytes = 1024;         // of a request
    std::size_t message_bytes = 256;       // of a message
    double messages_per_s = 500;           // from one watcher; as many may come at once
    std::chrono::seconds request_wait{10}; // for a whole request
};

} // namespace tumble::view
