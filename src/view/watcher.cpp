#include "view/watcher.h"

namespace tumble::view {

namespace {

// A second frame may be under way while the first is shown: the way there and back then costs no frame.
constexpr std::uint32_t frames_under_way = 2;

} // namespace

Watcher::Watcher(Shared& shared, beast::tcp_stream stream, Seat seat)
    : shared_(shared), socket_(std::move(stream)), seat_(std::move(seat)) {
    socket_.read_message_max(shared_.limits.message_bytes);
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_.binary(true);
}

Watcher::~Watcher() {
    shared_.watching.erase(this);
}

void Watcher::accept(const Request& request) {
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

void Watcher::offer() {
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

void Watcher::read() {
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

bool Watcher::take(const std::string& text) {
    if (!socket_.got_text() || !allowance_.take())
        return false;
    const std::optional<Message> message = parse_message(text);
    if (!message)
        return false;
    if (!std::holds_alternative<FrameSeen>(*message)) {
        if (!take_hand(*message))
            return true;
        if (!grip_.note(*message))
            return false;
        shared_.listener.message(*message);
        return true;
    }
    if (under_way_ == 0)
        return false;
    --under_way_;
    offer();
    return true;
}

/// There is one hand for all browsers, which the one that pressed last has until it lets go: what the others hold is
/// let go of before, and their moves do not count meanwhile. Whether the message does.
bool Watcher::take_hand(const Message& message) {
    if (const auto* released = std::get_if<PointerReleased>(&message))
        return grip_.holds(released->button);
    const bool presses = std::holds_alternative<PointerPressed>(message);
    if (!presses && !std::holds_alternative<PointerMoved>(message))
        return true;
    for (Watcher* other : shared_.watching)
        if (other != this && other->grip_.holds_any_button()) {
            if (!presses)
                return false;
            other->let_go();
        }
    return true;
}

void Watcher::let_go() {
    for (const Message& message : grip_.let_go())
        shared_.listener.message(message);
}

void Watcher::close() {
    shared_.watching.erase(this);
    let_go();
    socket_.async_close(websocket::close_code::policy_error, [self = shared_from_this()](error_code) {});
}

} // namespace tumble::view
