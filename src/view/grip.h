#pragma once

#include "view/message.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace tumble::view {

/// What one browser holds down. Several share the view's hand: what one held as it went would be held for ever.
class Grip {
public:
    /// Takes note of what a message presses or lets go. False for one key more than is ever held at once.
    bool note(const Message& message);

    [[nodiscard]] bool holds(int button) const { return buttons_.contains(button); }
    [[nodiscard]] bool holds_any_button() const { return !buttons_.empty(); }

    /// The messages that let go of all that is held: buttons where they were pressed, then keys. Then none is.
    [[nodiscard]] std::vector<Message> let_go();

private:
    std::map<int, PointerReleased> buttons_;
    std::set<std::string> keys_;
};

} // namespace tumble::view
