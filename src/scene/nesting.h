#pragma once

#include <optional>
#include <string_view>

namespace tumble::scene {

/// How deep lists, inline tables and dotted names may be nested in a scene; the deepest real key needs 4.
inline constexpr int deepest_nesting = 16;

struct TextPosition {
    int line = 1;
    int column = 1;
};

/// Where TOML text first nests deeper than `deepest_nesting`; none when it never does. It is asked before the parser
/// is: the parser builds one level of C++ recursion for each level of text.
std::optional<TextPosition> too_deep_at(std::string_view toml);

} // namespace tumble::scene
