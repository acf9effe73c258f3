#pragma once

#include "view/inbox.h"

namespace tumble::view {

/// What hands did to the panel, on its way into Dear ImGui. That asks once a frame how everything stands, and would
/// miss a press and its release between two frames: each frame takes up to one change of a button or key.
class Hands {
public:
    void add(const Message& message) { waiting_.add(message); }
    [[nodiscard]] bool any() const { return !waiting_.empty(); }

    /// Tells the current IO of Dear ImGui; `seconds` have passed since the frame before.
    void feed(double seconds);

private:
    Inbox waiting_;
};

} // namespace tumble::view
