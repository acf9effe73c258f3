#include "view/visitor.h"

#include "view/watcher.h"

namespace tumble::view {

namespace {

constexpr int most_answers = 100; // of the page's files to one connection

} // namespace

Visitor::Visitor(Shared& shared, tcp::socket socket)
    : shared_(shared), stream_(std::move(socket)), place_(shared_.strangers.insert(shared_.strangers.end(), this)) {
    if (shared_.strangers.size() > shared_.limits.strangers)
        shared_.strangers.front()->leave();
}

Visitor::~Visitor() {
    be_no_stranger();
}

void Visitor::read() {
    set_limits(parser_.emplace(), shared_.limits);
    stream_.expires_after(shared_.limits.request_wait);
    http::async_read_header(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](error_code failed, std::size_t /*bytes*/) { self->hear(failed); });
}

void Visitor::be_no_stranger() {
    if (place_)
        shared_.strangers.erase(*place_);
    place_.reset();
}

/// Without a word.
void Visitor::leave() {
    be_no_stranger();
    error_code ignored;
    stream_.socket().close(ignored);
}

void Visitor::hear(error_code failed) {
    if (!stream_.socket().is_open()) // made to leave
        return;
    const std::optional<Answer> answer = answer_to(*parser_, failed, *shared_.guard, shared_.limits);
    if (!answer)
        return;
    if (answer->status == 101 || answer->status == 200)
        be_no_stranger();
    if (answer->status == 101)
        become_watcher();
    else if (answer->status == 200)
        give(*answer);
    else
        respond(*answer, false);
}

void Visitor::give(const Answer& answer) {
    if (!answer.set_cookie.empty())
        tell_new_link();
    if (!seat_)
        seat_ = take_seat(shared_.connected, shared_.limits.connections);
    respond(answer, parser_->get().keep_alive() && seat_ && ++answered_ < most_answers);
}

void Visitor::tell_new_link() {
    const std::string link = shared_.guard->link();
    {
        const std::lock_guard lock(shared_.mutex);
        shared_.link = link;
    }
    shared_.listener.new_link(link);
}

void Visitor::become_watcher() {
    Seat seat = take_seat(shared_.seated, shared_.limits.watchers);
    if (!seat)
        return respond(refusal(503, "as many browsers as may watch do so already: close one of them"), false);
    const Request request = parser_->release();
    std::make_shared<Watcher>(shared_, std::move(stream_), std::move(seat))->accept(request);
}

void Visitor::respond(const Answer& answer, bool keep_alive) {
    const int port = static_cast<int>(stream_.socket().local_endpoint().port());
    response_.emplace(response_of(answer, port, keep_alive));
    http::async_write(stream_, *response_,
                      [self = shared_from_this(), keep_alive](error_code failed, std::size_t /*bytes*/) {
                          if (!failed && keep_alive)
                              self->read();
                          else
                              self->stream_.socket().shutdown(tcp::socket::shutdown_send, failed);
                      });
}

} // namespace tumble::view
