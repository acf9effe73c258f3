#include "scene/nesting.h"

#include <cstddef>

namespace tumble::scene {
namespace {

class Scan {
public:
    explicit Scan(std::string_view text) : text_(text) {}

    std::optional<TextPosition> run() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '#')
                skip_to_line_end();
            else if (c == '"' || c == '\'')
                skip_string(c);
            else
                count(c);
            if (brackets_ > deepest_nesting || dots_ > deepest_nesting)
                return position();
        }
        return std::nullopt;
    }

private:
    /// Dots of one chain of names or of one number; blanks around a dot do not end the chain, anything else does.
    void count(char c) {
        if (c == '[' || c == '{')
            ++brackets_;
        if ((c == ']' || c == '}') && brackets_ > 0)
            --brackets_;
        if (c == '.')
            ++dots_;
        else if (c == '\n' || c == ',' || c == '=' || c == '[' || c == ']' || c == '{' || c == '}')
            dots_ = 0;
        ++at_;
    }

    void skip_to_line_end() {
        while (at_ < text_.size() && text_[at_] != '\n')
            ++at_;
    }

    void skip_string(char quote) {
        const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
        const bool long_form = text_.substr(at_, 3) == triple;
        at_ += long_form ? 3 : 1;
        while (at_ < text_.size()) {
            if (quote == '"' && text_[at_] == '\\')
                at_ += 2;
            else if (long_form && text_.substr(at_, 3) == triple)
                return end_long_string(quote);
            else if (!long_form && (text_[at_] == quote || text_[at_] == '\n')) {
                ++at_;
                return;
            } else
                ++at_;
        }
    }

    /// Up to two more quotes directly before the closing three belong to the text.
    void end_long_string(char quote) {
        at_ += 3;
        for (int extra = 0; extra < 2 && at_ < text_.size() && text_[at_] == quote; ++extra)
            ++at_;
    }

    [[nodiscard]] TextPosition position() const {
        TextPosition where;
        for (std::size_t i = 0; i + 1 < at_ && i < text_.size(); ++i) {
            ++where.column;
            if (text_[i] == '\n') {
                ++where.line;
                where.column = 1;
            }
        }
        return where;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int brackets_ = 0;
    int dots_ = 0;
};

} // namespace

std::optional<TextPosition> too_deep_at(std::string_view toml) {
    return Scan(toml).run();
}

} // namespace tumble::scene
