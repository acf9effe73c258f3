#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

/// What a page sends back: one line of text a message, words between blanks. Places are pixels of the picture from its
/// left and top.
namespace tumble::view {

struct PointerMoved {
    double x = 0, y = 0;
    friend bool operator==(const PointerMoved&, const PointerMoved&) = default;
};
struct PointerPressed {
    int button = 0; // 0 left, 1 middle, 2 right
    double x = 0, y = 0;
    friend bool operator==(const PointerPressed&, const PointerPressed&) = default;
};
struct PointerReleased {
    int button = 0;
    double x = 0, y = 0;
    friend bool operator==(const PointerReleased&, const PointerReleased&) = default;
};
struct WheelTurned {
    double x = 0, y = 0;
    double notches = 0; // above 0: away from the user
    friend bool operator==(const WheelTurned&, const WheelTurned&) = default;
};
/// Two fingers: their middle, how far it went, and what their distance was multiplied by.
struct Pinched {
    double x = 0, y = 0, dx = 0, dy = 0;
    double factor = 1;
    friend bool operator==(const Pinched&, const Pinched&) = default;
};
struct KeyChanged {
    std::string key; // as KeyboardEvent.code of a browser names it: "Space", "ArrowLeft", "KeyA"
    bool down = false;
    bool shift = false, ctrl = false;
    friend bool operator==(const KeyChanged&, const KeyChanged&) = default;
};
struct TextTyped {
    std::string text; // UTF-8
    friend bool operator==(const TextTyped&, const TextTyped&) = default;
};
struct Resized {
    int width = 0, height = 0; // pixels; 0 where the window is hidden
    double ratio = 1;          // pixels of the screen a pixel of the page
    friend bool operator==(const Resized&, const Resized&) = default;
};
struct PanelToggled {
    friend bool operator==(const PanelToggled&, const PanelToggled&) = default;
};
struct FrameSeen {
    std::uint32_t number = 0;
    friend bool operator==(const FrameSeen&, const FrameSeen&) = default;
};

using Message = std::variant<PointerMoved, PointerPressed, PointerReleased, WheelTurned, Pinched, KeyChanged, TextTyped,
                             Resized, PanelToggled, FrameSeen>;

/// Nothing for whatever is no message: wrong words, numbers that are not finite or beyond any screen, more than a key
/// name's letters.
std::optional<Message> parse_message(std::string_view text);

/// The line that parse_message reads as this message.
std::string to_text(const Message& message);

} // namespace tumble::view
