#pragma once

#include "view/beast.h"
#include "view/request.h"
#include "view/response.h"
#include "view/shared.h"

namespace tumble::view {

/// One connection that asks for the page: a stranger until it has brought the cookie or the link's token.
class Visitor : public std::enable_shared_from_this<Visitor> {
public:
    /// One stranger too many makes the oldest leave.
    Visitor(Shared& shared, tcp::socket socket);
    Visitor(const Visitor&) = delete;
    Visitor& operator=(const Visitor&) = delete;
    ~Visitor();

    /// Waits for the next request, and answers it.
    void read();

private:
    void be_no_stranger();
    void leave();
    void hear(error_code failed);
    void give(const Answer& answer);
    void tell_new_link();
    void become_watcher();
    void respond(const Answer& answer, bool keep_alive);

    Shared& shared_;
    beast::tcp_stream stream_;
    std::optional<std::list<Visitor*>::iterator> place_; // among strangers
    Seat seat_;                                          // among those that are none
    int answered_ = 0;
    beast::flat_buffer buffer_;
    std::optional<RequestParser> parser_;
    std::optional<Response> response_;
};

} // namespace tumble::view
