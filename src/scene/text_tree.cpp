#include "scene/text_tree.h"

#include <algorithm>

namespace tumble::scene {

const Entry* Table::find(std::string_view name) const {
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name; });
    return found == entries.end() ? nullptr : &*found;
}

Entry* Table::find(std::string_view name) {
    return const_cast<Entry*>(std::as_const(*this).find(name));
}

std::string kind_of(const Node& node) {
    struct Name {
        std::string operator()(const Moment&) const { return "a date or time"; }
        std::string operator()(bool) const { return "true or false"; }
        std::string operator()(std::int64_t) const { return "a whole number"; }
        std::string operator()(double) const { return "a number"; }
        std::string operator()(const std::string&) const { return "text"; }
        std::string operator()(const Array&) const { return "a list"; }
        std::string operator()(const Table&) const { return "a table"; }
    };
    return std::visit(Name{}, node.value);
}

Problem problem_at(const Place& place, std::string key, std::string what, std::string fix) {
    return {
        place.source ? *place.source : "", place.line, place.column, std::move(key), std::move(what), std::move(fix)};
}

} // namespace tumble::scene
