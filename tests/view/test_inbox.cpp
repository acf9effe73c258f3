#include "view/inbox.h"

#include <doctest/doctest.h>
#include <vector>

using namespace tumble::view;

namespace test_inbox {

std::vector<Message> all_of(Inbox& inbox) {
    std::vector<Message> all;
    for (; !inbox.empty(); inbox.pop_front())
        all.push_back(inbox.front());
    return all;
}

TEST_CASE("of moves that follow each other the last waits, before and after a press in their order") {
    Inbox inbox;
    for (int i = 0; i <= 1000; ++i)
        inbox.add(PointerMoved{1.0 * i, 1});
    inbox.add(PointerPressed{0, 1000, 1});
    for (int i = 0; i <= 1000; ++i)
        inbox.add(PointerMoved{1.0 * i, 2});
    inbox.add(PointerReleased{0, 1000, 2});
    CHECK(all_of(inbox) == std::vector<Message>{PointerMoved{1000, 1}, PointerPressed{0, 1000, 1},
                                                PointerMoved{1000, 2}, PointerReleased{0, 1000, 2}});
}

TEST_CASE("a full inbox takes what lets go of a held button or key once, and nothing else") {
    Inbox inbox;
    inbox.add(PointerPressed{2, 5, 5});
    inbox.add(KeyChanged{"Space", true, false, false});
    for (int i = 0; i < 5000; ++i)
        inbox.add(WheelTurned{1, 1, 1});
    CHECK(inbox.size() == Inbox::most);
    for (int i = 0; i < 5000; ++i) {
        inbox.add(PointerPressed{0, 5, 5});
        inbox.add(PointerReleased{0, 5, 5}); // its press did not come in either
        inbox.add(PointerReleased{2, 6, 6});
        inbox.add(KeyChanged{"Space", false, false, false});
    }
    CHECK(inbox.size() == Inbox::most + 2);
    const std::vector<Message> all = all_of(inbox);
    CHECK(all[Inbox::most] == Message(PointerReleased{2, 6, 6}));
    CHECK(all[Inbox::most + 1] == Message(KeyChanged{"Space", false, false, false}));
}

} // namespace test_inbox
