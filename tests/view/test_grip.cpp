#include "view/grip.h"

#include <doctest/doctest.h>

using namespace tumble::view;

namespace test_grip {

TEST_CASE("what is pressed and not released is let go, once: buttons where they were pressed, then keys") {
    Grip grip;
    for (const Message& message : std::vector<Message>{
             PointerPressed{2, 7, 8}, KeyChanged{"Space", true, false, false}, PointerPressed{0, 1, 2},
             PointerMoved{9, 9}, PointerReleased{2, 3, 3}, KeyChanged{"KeyA", true, true, false},
             KeyChanged{"KeyA", false, true, false}, KeyChanged{"Space", true, false, false}}) // a key that repeats
        CHECK(grip.note(message));
    const std::vector<Message> released{PointerReleased{0, 1, 2}, KeyChanged{"Space", false, false, false}};
    CHECK(grip.let_go() == released);
    CHECK(grip.let_go().empty());
}

TEST_CASE("the 65th key at once is one too many, and is let go with the others") {
    Grip grip;
    const auto press = [&](int number) {
        return grip.note(KeyChanged{"Key" + std::to_string(number), true, false, false});
    };
    for (int number = 1; number <= 64; ++number)
        CHECK(press(number));
    CHECK(!press(65));
    CHECK(grip.let_go().size() == 65);
    CHECK(press(66));
}

} // namespace test_grip
