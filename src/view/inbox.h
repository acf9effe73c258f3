#pragma once

#include "view/message.h"

#include <cstddef>
#include <deque>
#include <set>
#include <string>

namespace tumble::view {

/// Messages that wait to be taken, in order. Of moves that follow each other the last counts. When it is full nothing
/// comes in but what lets go of a button or key that is held: a lost press does nothing, a lost release holds for ever.
class Inbox {
public:
    static constexpr std::size_t most = 256; // that can be full of anything; releases come on top

    void add(const Message& message);
    [[nodiscard]] bool empty() const { return waiting_.empty(); }
    [[nodiscard]] std::size_t size() const { return waiting_.size(); }
    [[nodiscard]] const Message& front() const { return waiting_.front(); }
    void pop_front() { waiting_.pop_front(); }

private:
    std::deque<Message> waiting_;
    std::set<int> buttons_;      // held once all that waits has been taken
    std::set<std::string> keys_; // the same
};

} // namespace tumble::view
