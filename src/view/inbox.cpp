#include "view/inbox.h"

namespace tumble::view {

namespace {

constexpr std::size_t most_keys = 64; // on no keyboard are more held at once

template <class Same> bool follows(const std::deque<Message>& waiting, const Message& message) {
    return std::holds_alternative<Same>(message) && !waiting.empty() && std::holds_alternative<Same>(waiting.back());
}

} // namespace

void Inbox::add(const Message& message) {
    if (follows<PointerMoved>(waiting_, message) || follows<Resized>(waiting_, message)) {
        waiting_.back() = message;
        return;
    }
    bool lets_go = false;
    if (const auto* released = std::get_if<PointerReleased>(&message))
        lets_go = buttons_.erase(released->button) > 0;
    else if (const auto* key = std::get_if<KeyChanged>(&message); key != nullptr && !key->down)
        lets_go = keys_.erase(key->key) > 0;
    if (waiting_.size() >= most && !lets_go)
        return;
    if (const auto* pressed = std::get_if<PointerPressed>(&message))
        buttons_.insert(pressed->button);
    else if (const auto* key = std::get_if<KeyChanged>(&message); key != nullptr && key->down) {
        if (keys_.size() >= most_keys)
            keys_.clear();
        keys_.insert(key->key);
    }
    waiting_.push_back(message);
}

} // namespace tumble::view
