#include "view/message.h"

#include "base/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace tumble::view {

namespace {

constexpr double farthest = 32768; // pixels
constexpr int largest_side = 16384;
constexpr double most_notches = 100;
constexpr std::size_t longest_key = 24;
constexpr std::size_t longest_text = 64;

/// Reads word after word; once one is wrong, all of it is.
class Words {
public:
    explicit Words(std::string_view text) : words_(split_words(text)) {}

    std::string_view next() {
        right_ = right_ && at_ < words_.size();
        return right_ ? words_[at_++] : std::string_view();
    }
    double number(double lo, double hi) {
        const Result<double> value = parse_number(next());
        right_ = right_ && value && *value >= lo && *value <= hi;
        return right_ ? *value : lo;
    }
    int whole(std::int64_t lo, std::int64_t hi) {
        const Result<std::int64_t> value = parse_integer(next());
        right_ = right_ && value && *value >= lo && *value <= hi;
        return static_cast<int>(right_ ? *value : lo);
    }
    double place() { return number(-farthest, farthest); }
    bool flag() { return whole(0, 1) == 1; }

    /// All words were right, and there is none left.
    [[nodiscard]] bool done() const { return right_ && at_ == words_.size(); }

private:
    std::vector<std::string_view> words_;
    std::size_t at_ = 0;
    bool right_ = true;
};

bool is_key_name(std::string_view word) {
    return !word.empty() && word.size() <= longest_key &&
           std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
}

/// Whether the bytes are UTF-8 as RFC 3629 has it, without control characters.
bool is_plain_text(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const int more = byte < 0x80 ? 0 : byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : 1;
        if (byte < 0x20 || byte == 0x7f || (byte >= 0x80 && byte < 0xc2) || byte > 0xf4)
            return false;
        std::uint32_t code = more == 0 ? byte : byte & (0x3fU >> more);
        for (int k = 1; k <= more; ++k) {
            const std::size_t at = i + static_cast<std::size_t>(k);
            if (at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xc0U) != 0x80)
                return false;
            code = code << 6 | (static_cast<unsigned char>(text[at]) & 0x3fU);
        }
        const bool overlong = (more == 2 && code < 0x800) || (more == 3 && code < 0x10000);
        if (overlong || code > 0x10ffff || (code >= 0xd800 && code < 0xe000))
            return false;
        i += 1 + static_cast<std::size_t>(more);
    }
    return true;
}

std::optional<Message> parse_text(std::string_view text) {
    if (text.empty() || text.size() > longest_text || !is_plain_text(text))
        return std::nullopt;
    return TextTyped{std::string(text)};
}

} // namespace

// In the braces below the words are read in the order written, as the language promises for initializer lists.
std::optional<Message> parse_message(std::string_view text) {
    constexpr std::string_view typed = "text ";
    if (text.starts_with(typed))
        return parse_text(text.substr(typed.size()));
    Words words(text);
    const std::string_view kind = words.next();
    std::optional<Message> message;
    if (kind == "move")
        message = PointerMoved{words.place(), words.place()};
    else if (kind == "down")
        message = PointerPressed{words.whole(0, 2), words.place(), words.place()};
    else if (kind == "up")
        message = PointerReleased{words.whole(0, 2), words.place(), words.place()};
    else if (kind == "wheel")
        message = WheelTurned{words.place(), words.place(), words.number(-most_notches, most_notches)};
    else if (kind == "pinch")
        message = Pinched{words.place(), words.place(), words.place(), words.place(), words.number(0.01, 100)};
    else if (kind == "key") {
        const std::string_view name = words.next();
        if (!is_key_name(name))
            return std::nullopt;
        message = KeyChanged{std::string(name), words.flag(), words.flag(), words.flag()};
    } else if (kind == "size")
        message = Resized{words.whole(0, largest_side), words.whole(0, largest_side), words.number(0.25, 8)};
    else if (kind == "panel")
        message = PanelToggled{};
    else if (kind == "seen")
        message = FrameSeen{static_cast<std::uint32_t>(words.whole(0, 2147483647))};
    return words.done() ? message : std::nullopt;
}

std::string to_text(const Message& message) {
    struct Writer {
        std::string operator()(const PointerMoved& m) const { return fmt::format("move {} {}", m.x, m.y); }
        std::string operator()(const PointerPressed& m) const {
            return fmt::format("down {} {} {}", m.button, m.x, m.y);
        }
        std::string operator()(const PointerReleased& m) const {
            return fmt::format("up {} {} {}", m.button, m.x, m.y);
        }
        std::string operator()(const WheelTurned& m) const {
            return fmt::format("wheel {} {} {}", m.x, m.y, m.notches);
        }
        std::string operator()(const Pinched& m) const {
            return fmt::format("pinch {} {} {} {} {}", m.x, m.y, m.dx, m.dy, m.factor);
        }
        std::string operator()(const KeyChanged& m) const {
            return fmt::format("key {} {:d} {:d} {:d}", m.key, m.down, m.shift, m.ctrl);
        }
        std::string operator()(const TextTyped& m) const { return "text " + m.text; }
        std::string operator()(const Resized& m) const {
            return fmt::format("size {} {} {}", m.width, m.height, m.ratio);
        }
        std::string operator()(const PanelToggled&) const { return "panel"; }
        std::string operator()(const FrameSeen& m) const { return fmt::format("seen {}", m.number); }
    };
    return std::visit(Writer{}, message);
}

} // namespace tumble::view
