#include "view/grip.h"

#include <utility>

namespace tumble::view {

namespace {

constexpr std::size_t most_held_keys = 64; // more than any keyboard tells of

} // namespace

bool Grip::note(const Message& message) {
    if (const auto* pressed = std::get_if<PointerPressed>(&message))
        buttons_[pressed->button] = {pressed->button, pressed->x, pressed->y};
    else if (const auto* released = std::get_if<PointerReleased>(&message))
        buttons_.erase(released->button);
    else if (const auto* key = std::get_if<KeyChanged>(&message)) {
        if (key->down)
            keys_.insert(key->key);
        else
            keys_.erase(key->key);
    }
    return keys_.size() <= most_held_keys;
}

std::vector<Message> Grip::let_go() {
    std::vector<Message> messages;
    for (const auto& [button, release] : std::exchange(buttons_, {}))
        messages.emplace_back(release);
    for (const std::string& key : std::exchange(keys_, {}))
        messages.emplace_back(KeyChanged{key, false, false, false});
    return messages;
}

} // namespace tumble::view
