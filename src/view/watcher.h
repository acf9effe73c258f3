#pragma once

#include "view/allowance.h"
#include "view/beast.h"
#include "view/grip.h"
#include "view/request.h"
#include "view/shared.h"

namespace tumble::view {

/// One browser that frames go to, and that says what its hands do.
class Watcher : public std::enable_shared_from_this<Watcher> {
public:
    Watcher(Shared& shared, beast::tcp_stream stream, Seat seat);
    Watcher(const Watcher&) = delete;
    Watcher& operator=(const Watcher&) = delete;
    ~Watcher();

    /// Becomes one by the request that asked for it.
    void accept(const Request& request);

    /// Sends the newest frame if this browser is ready for one and has not had it.
    void offer();

private:
    void read();
    bool take(const std::string& text);
    bool take_hand(const Message& message);
    void let_go();
    void close();

    Shared& shared_;
    websocket::stream<beast::tcp_stream> socket_;
    Seat seat_;
    beast::flat_buffer buffer_;
    FramePtr sending_;
    std::uint32_t sent_ = 0;
    std::uint32_t under_way_ = 0; // frames sent that were not yet shown
    Allowance allowance_{shared_.limits.messages_per_s};
    Grip grip_;
};

} // namespace tumble::view
