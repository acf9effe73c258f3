#include "scene/keys.h"

#include "base/text.h"
#include "scene/key_maker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::scene {
namespace {

std::string quoted(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words)
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", word);
    return list;
}

std::string noun(const Key& key, int dimension) {
    constexpr std::array<const char*, 5> counts{"no", "one", "two", "three", "four"};
    switch (key.type) {
    case KeyType::text:
        return "text";
    case KeyType::file:
        return "a file name";
    case KeyType::word:
        return "one of " + quoted(key.words);
    case KeyType::words:
        return key.words.empty() ? "a list of words" : "a list of some of " + quoted(key.words);
    case KeyType::flag:
        return "true or false";
    case KeyType::integer:
        return "a whole number";
    case KeyType::number:
        return key.unit.empty() ? "a number without unit" : "a number";
    case KeyType::vector:
        return dimension == 2 ? "a list of two numbers [x, y]" : "a list of three numbers [x, y, z]";
    case KeyType::span:
        return "a list of two numbers [low, high]";
    case KeyType::rows:
        return fmt::format("a list of rows of {} numbers", counts[key.columns]);
    }
    return "";
}

} // namespace

const std::vector<KeyTable>& scene_keys() {
    static const std::vector<KeyTable> all = [] {
        std::vector<KeyTable> tables;
        for (const auto part : {world_tables, matter_tables, wall_tables, output_tables, reduce_tables})
            for (KeyTable& table : part())
                tables.push_back(std::move(table));
        return tables;
    }();
    return all;
}

const KeyTable* find_table(std::string_view path) {
    const auto& all = scene_keys();
    const auto found = std::find_if(all.begin(), all.end(), [&](const KeyTable& t) { return t.path == path; });
    return found == all.end() ? nullptr : &*found;
}

const Key* find_key(const KeyTable& table, std::string_view name) {
    const auto found = std::find_if(table.keys.begin(), table.keys.end(), [&](const Key& k) { return k.name == name; });
    return found == table.keys.end() ? nullptr : &*found;
}

const Key* find_key(const KeyTable& table, std::string_view name, int dimension) {
    const auto found = std::find_if(table.keys.begin(), table.keys.end(),
                                    [&](const Key& k) { return k.name == name && belongs_in(k, dimension); });
    return found == table.keys.end() ? nullptr : &*found;
}

bool belongs_in(const Key& key, int dimension) {
    return key.in == Dimensions::both || (key.in == Dimensions::two) == (dimension == 2);
}

std::string plain(double value) {
    return std::abs(value) < 1e9 && value == std::floor(value) ? fmt::format("{:.0f}", value) : shortest(value);
}

std::string describe(const Limits& limits) {
    std::string text;
    const bool low = std::isfinite(limits.lo);
    const bool high = std::isfinite(limits.hi);
    if (low && high && !limits.above && !limits.below)
        return fmt::format("{} to {}", plain(limits.lo), plain(limits.hi));
    if (low)
        text = (limits.above ? "above " : "at least ") + plain(limits.lo);
    if (high)
        text += (low ? ", " : "") + std::string(limits.below ? "below " : "at most ") + plain(limits.hi);
    return text;
}

std::string describe(const Key& key) {
    return describe(key, key.in == Dimensions::two ? 2 : 3);
}

std::string describe(const Key& key, int dimension) {
    constexpr std::array<const char*, 5> places{"", "first", "second", "third", "fourth"};
    std::string text = noun(key, dimension);
    if (!key.unit.empty())
        text += " in " + key.unit;
    const std::string range = describe(key.limits);
    if (range.empty())
        return text;
    return text + ", " + (key.type == KeyType::rows ? fmt::format("the {} ", places[key.columns]) : "") + range;
}

std::string describe(const KeyDefault& standard) {
    struct Toml {
        std::string operator()(std::monostate) const { return ""; }
        std::string operator()(bool flag) const { return flag ? "true" : "false"; }
        std::string operator()(std::int64_t whole) const { return fmt::format("{}", whole); }
        std::string operator()(double number) const { return shortest(number); }
        std::string operator()(const std::string& text) const { return '"' + text + '"'; }
        std::string operator()(const std::vector<double>& numbers) const {
            std::vector<std::string> parts;
            parts.reserve(numbers.size());
            for (const double number : numbers)
                parts.push_back(shortest(number));
            return fmt::format("[{}]", fmt::join(parts, ", "));
        }
        std::string operator()(const std::vector<std::string>& words) const { return '[' + quoted(words) + ']'; }
    };
    return std::visit(Toml{}, standard);
}

} // namespace tumble::scene
