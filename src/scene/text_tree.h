#pragma once

#include "base/problem.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// A scene as it was typed: every value with the place it stands at, nothing checked yet.
namespace tumble::scene {

/// Where something was written. `source` is a file name or "--set KEY"; line and column count from 1, 0 is unknown.
struct Place {
    std::shared_ptr<const std::string> source;
    int line = 0;
    int column = 0;
};

struct Node;
struct Entry;

struct Array {
    std::vector<Node> items;
};

struct Table {
    std::vector<Entry> entries; // in the order written

    [[nodiscard]] const Entry* find(std::string_view name) const;
    [[nodiscard]] Entry* find(std::string_view name);
};

/// A date or a time: TOML knows them, a scene has no use for them.
struct Moment {};

struct Node {
    Place place;
    std::variant<Moment, bool, std::int64_t, double, std::string, Array, Table> value;

    template <class T> [[nodiscard]] const T* as() const { return std::get_if<T>(&value); }
    template <class T> [[nodiscard]] T* as() { return std::get_if<T>(&value); }
};

struct Entry {
    std::string name;
    Place place; // of the name
    Node node;
};

/// "text", "a whole number", "a table", ... for sentences.
std::string kind_of(const Node& node);

/// A problem at a place; `key` is the dotted path of what it is about.
Problem problem_at(const Place& place, std::string key, std::string what, std::string fix);

} // namespace tumble::scene
