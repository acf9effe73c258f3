#include "view/message.h"

#include <doctest/doctest.h>
#include <string>
#include <vector>

using namespace tumble::view;

namespace test_message {

TEST_CASE("every kind of message is read back from the line that it is written as") {
    const std::vector<Message> all{PointerMoved{1.5, -2},
                                   PointerPressed{2, 1279, 719},
                                   PointerReleased{0, 0, 0.25},
                                   WheelTurned{640, 360, -1.5},
                                   Pinched{10, 20, -3, 4.5, 1.25},
                                   KeyChanged{"ArrowLeft", true, false, true},
                                   TextTyped{"a b"},
                                   TextTyped{"\xc3\xbc"},
                                   Resized{1280, 720, 1.5},
                                   Resized{0, 0, 1},
                                   PanelToggled{},
                                   FrameSeen{4711}};
    for (const Message& message : all) {
        CAPTURE(to_text(message));
        const auto read = parse_message(to_text(message));
        REQUIRE(read);
        CHECK(*read == message);
    }
}

TEST_CASE("whatever is no message is refused: kinds, counts of words, numbers beyond any screen, letters of keys") {
    const std::vector<std::string> wrong{"",
                                         " ",
                                         "jump 1 2",
                                         "move",
                                         "move 1",
                                         "move 1 2 3",
                                         "move nan 1",
                                         "move 1 inf",
                                         "move 1e9 1",
                                         "move 0x10 1",
                                         "down 3 1 1",
                                         "down -1 1 1",
                                         "down 1.5 1 1",
                                         "wheel 1 1 1000",
                                         "pinch 1 1 1 1 0",
                                         "pinch 1 1 1 1 -1",
                                         "key <script> 1 0 0",
                                         "key ABCDEFGHIJKLMNOPQRSTUVWXYZ 1 0 0",
                                         "key KeyA 2 0 0",
                                         "size -1 720 1",
                                         "size 99999 720 1",
                                         "size 1280 720 0",
                                         "seen -1",
                                         "seen 99999999999",
                                         "panel now",
                                         "text ",
                                         "text \x07",
                                         "text " + std::string(65, 'a')};
    for (const std::string& text : wrong)
        CHECK_MESSAGE(!parse_message(text), text);
}

TEST_CASE("text is UTF-8 as RFC 3629 has it: cut, overlong and surrogate sequences are refused") {
    CHECK(parse_message("text \xf0\x9f\x98\x80")); // U+1F600
    for (const char* text : {"text \xc3", "text \xc0\xaf", "text \xe0\x80\xaf", "text \xed\xa0\x80", "text \x80",
                             "text \xf5\x80\x80\x80", "text \xf4\x90\x80\x80"})
        CHECK_MESSAGE(!parse_message(text), text);
}

} // namespace test_message
