#include "base/text.h"
#include "scene/check_keys.h"
#include "scene/keys.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::scene {
namespace {

class ValueCheck {
public:
    ValueCheck(const Key& key, const std::string& path, Report& report) : key_(key), path_(path), report_(report) {}

    bool run(const Node& node) {
        switch (key_.type) {
        case KeyType::text:
            return is<std::string>(node);
        case KeyType::file:
            return is<std::string>(node) && has_text(node);
        case KeyType::word:
            return is<std::string>(node) && is_allowed(node);
        case KeyType::words:
            return list_of_words(node);
        case KeyType::flag:
            return is<bool>(node);
        case KeyType::integer:
            return is_whole(node) && in_range(node, static_cast<double>(*node.as<std::int64_t>()), key_.limits);
        case KeyType::number:
            return number(node, key_.limits);
        case KeyType::vector:
            return numbers(node, static_cast<std::size_t>(report_.dimension));
        case KeyType::span:
            return span(node);
        case KeyType::rows:
            return rows(node);
        }
        return false;
    }

private:
    bool refuse(const Node& at, std::string what) {
        report_.add(at.place, path_, std::move(what), "write " + describe(key_, report_.dimension));
        return false;
    }

    bool wrong_type(const Node& at) { return refuse(at, fmt::format("'{}' is {}", key_.name, kind_of(at))); }

    template <class T> bool is(const Node& node) { return node.as<T>() ? true : wrong_type(node); }

    bool is_whole(const Node& node) {
        if (const double* real = node.as<double>())
            return refuse(node, fmt::format("'{}' = {} is not a whole number", key_.name, plain(*real)));
        return is<std::int64_t>(node);
    }

    bool has_text(const Node& node) {
        return !node.as<std::string>()->empty() || refuse(node, fmt::format("'{}' is empty", key_.name));
    }

    bool is_allowed(const Node& node) {
        const std::string& word = *node.as<std::string>();
        if (key_.words.empty() || std::find(key_.words.begin(), key_.words.end(), word) != key_.words.end())
            return true;
        std::string fix = did_you_mean(word, key_.words);
        fix += fix.empty() ? "" : "  ";
        report_.add(node.place, path_, fmt::format("'{}' cannot be \"{}\"", key_.name, excerpt(word)),
                    fix + "write " + describe(key_, report_.dimension));
        return false;
    }

    bool list_of_words(const Node& node) {
        const Array* array = node.as<Array>();
        if (!array)
            return wrong_type(node);
        bool right = true;
        for (const Node& item : array->items)
            right = (item.as<std::string>() ? is_allowed(item) : wrong_type(item)) && right;
        return right;
    }

    bool in_range(const Node& at, double value, const Limits& limits) {
        if (!std::isfinite(value))
            return refuse(at, fmt::format("'{}' is not a finite number", key_.name));
        if (!limits.hold(value))
            return refuse(at, fmt::format("'{}' = {} is out of range", key_.name, plain(value)));
        return true;
    }

    bool number(const Node& node, const Limits& limits) {
        if (const auto* whole = node.as<std::int64_t>())
            return in_range(node, static_cast<double>(*whole), limits);
        if (const auto* real = node.as<double>())
            return in_range(node, *real, limits);
        return wrong_type(node);
    }

    bool numbers(const Node& node, std::size_t wanted) {
        const Array* array = node.as<Array>();
        if (!array)
            return wrong_type(node);
        if (array->items.size() != wanted)
            return refuse(node, fmt::format("'{}' has {} of {} numbers", key_.name, array->items.size(), wanted));
        bool right = true;
        for (const Node& item : array->items)
            right = number(item, key_.limits) && right;
        return right;
    }

    bool span(const Node& node) {
        if (!numbers(node, 2))
            return false;
        const auto value = [](const Node& n) {
            return n.as<double>() ? *n.as<double>() : static_cast<double>(*n.as<std::int64_t>());
        };
        const Array& array = *node.as<Array>();
        return value(array.items[0]) < value(array.items[1]) ||
               refuse(node, fmt::format("'{}' does not rise", key_.name));
    }

    bool rows(const Node& node) {
        const Array* array = node.as<Array>();
        if (!array)
            return wrong_type(node);
        if (array->items.empty())
            return refuse(node, fmt::format("'{}' is empty", key_.name));
        // A list that is not nested at all is one mistake, not one per number.
        bool right = true;
        for (const Node& item : array->items) {
            if (!item.as<Array>())
                return wrong_type(item);
            right = row(item) && right;
        }
        return right;
    }

    bool row(const Node& node) {
        const Array* line = node.as<Array>();
        if (line->items.size() != key_.columns)
            return refuse(
                node, fmt::format("a row of '{}' has {} of {} numbers", key_.name, line->items.size(), key_.columns));
        bool right = true;
        for (std::size_t i = 0; i < key_.columns; ++i)
            right = number(line->items[i], i + 1 == key_.columns ? key_.limits : Limits{}) && right;
        return right;
    }

    const Key& key_;
    const std::string& path_;
    Report& report_;
};

} // namespace

bool check_value(const Node& node, const Key& key, const std::string& path, Report& report) {
    const bool right = ValueCheck(key, path, report).run(node);
    if (!right)
        report.distrust(node);
    return right;
}

} // namespace tumble::scene
