#include "scene/override.h"

#include "base/text.h"
#include "scene/check_keys.h"
#include "scene/keys.h"
#include "scene/nesting.h"
#include "scene/read_toml.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace tumble::scene {
namespace {

constexpr const char* form_of_a_set = "write --set KEY=VALUE, for example --set material.media.density_kg_m3=1500";

/// Every place inside the value becomes the flag itself: line 1 of a value typed on a command line says nothing.
void relocate(Node& node, const Place& place) {
    node.place = place;
    if (Array* array = node.as<Array>())
        for (Node& item : array->items)
            relocate(item, place);
    if (Table* table = node.as<Table>())
        for (Entry& entry : table->entries) {
            entry.place = place;
            relocate(entry.node, place);
        }
}

Result<Node> parse_value(const std::string& value, const Place& place) {
    auto parsed = parse_toml("value = " + value, *place.source);
    const Table* root = parsed ? parsed->as<Table>() : nullptr;
    const bool single = root && root->entries.size() == 1 && root->entries[0].name == "value";
    const auto first = value.find_first_not_of(" \t");
    const bool looks_like_toml =
        first != std::string::npos && std::string_view("[{\"'").find(value[first]) != std::string::npos;
    if (!single && looks_like_toml)
        return problem_at(place, "", fmt::format("'{}' is not a TOML value", excerpt(value)),
                          "check its brackets and quotes");
    Node node = single ? root->entries[0].node : Node{place, value};
    relocate(node, place);
    return node;
}

class Walk {
public:
    Walk(const std::string& key, const Place& place, int dimension) : key_(key), place_(place), dimension_(dimension) {}

    /// The node at the path, made on the way; nullptr with a problem otherwise.
    Node* find(Node& root) {
        Node* node = &root;
        root_ = root.as<Table>();
        const auto parts = split(key_, '.');
        for (const std::string_view& part : parts) {
            node = step(*node, std::string(part), &part == &parts.back());
            if (!node)
                return nullptr;
            path_ += (path_.empty() ? "" : ".") + std::string(part);
            const std::string inner = (table_.empty() ? "" : table_ + ".") + std::string(part);
            if (find_table(inner))
                table_ = inner;
        }
        return node;
    }

    [[nodiscard]] const Problems& problems() const { return problems_; }

    /// The default of the key that find() went to, where it is a number.
    [[nodiscard]] std::optional<double> standard() const {
        const KeyTable* table = find_table(table_);
        const Key* key = table ? find_key(*table, last_part(), dimension_) : nullptr;
        const double* number = key ? std::get_if<double>(&key->standard) : nullptr;
        return number ? std::optional(*number) : std::nullopt;
    }

    /// "did you mean ...?", where find() went to a key that there is not.
    [[nodiscard]] std::string meant() const {
        const KeyTable* table = find_table(table_);
        std::vector<std::string> names;
        for (const Key& key : table ? table->keys : std::vector<Key>{})
            names.push_back(key.name);
        return std::count(names.begin(), names.end(), last_part()) > 0 ? "" : did_you_mean(last_part(), names);
    }

private:
    [[nodiscard]] std::string last_part() const { return key_.substr(key_.rfind('.') + 1); }

    Node* refuse(std::string what, std::string fix) {
        problems_.push_back(problem_at(place_, key_, std::move(what), std::move(fix)));
        return nullptr;
    }

    Node* step(Node& node, const std::string& part, bool last) {
        if (part.empty())
            return refuse("a part of the key is empty", form_of_a_set);
        if (Table* table = node.as<Table>()) {
            Entry* entry = table->find(part);
            if (!entry && path_ == "pair")
                entry = table->find(turned(part));
            if (entry)
                return &entry->node;
            if (!last && holds_names() && !table->entries.empty() && !pairs_materials(part))
                return refuse(fmt::format("there is no [{}.{}]", path_, excerpt(part)), other_name(*table, part));
            table->entries.push_back({part, place_, default_of(part)});
            return &table->entries.back().node;
        }
        if (Array* array = node.as<Array>())
            return member(*array, part);
        return refuse(fmt::format("'{}' is {}, there is no '{}' in it", path_, kind_of(node), part),
                      "shorten the key; `tumble list keys` names all of them");
    }

    /// [material], [body] and [pair] hold tables that the scene names.
    [[nodiscard]] bool holds_names() const {
        const KeyTable* table = path_ == table_ ? find_table(table_) : nullptr;
        return table && table->repeat == Repeat::named;
    }

    /// [pair.b-a] is [pair.a-b].
    static std::string turned(const std::string& pair) {
        const auto dash = pair.find('-');
        return dash == std::string::npos ? pair : pair.substr(dash + 1) + "-" + pair.substr(0, dash);
    }

    /// A pair of two materials that the scene has may come key by key.
    [[nodiscard]] bool pairs_materials(const std::string& part) const {
        const Entry* entry = path_ == "pair" ? root_->find("material") : nullptr;
        const Table* materials = entry ? entry->node.as<Table>() : nullptr;
        const auto dash = part.find('-');
        return materials && dash != std::string::npos && materials->find(part.substr(0, dash)) &&
               materials->find(part.substr(dash + 1));
    }

    /// What to do about a name that the scene does not have.
    [[nodiscard]] std::string other_name(const Table& table, const std::string& part) const {
        std::vector<std::string> names, both_ways;
        for (const Entry& entry : table.entries) {
            names.push_back(entry.name);
            both_ways.push_back(entry.name);
            if (path_ == "pair")
                both_ways.push_back(turned(entry.name));
        }
        const std::string meant = did_you_mean(part, both_ways);
        return fmt::format("{}  A new one is set as a whole: --set {}.{}={{...}}",
                           meant.empty() ? fmt::format("there are {}.", fmt::join(names, ", ")) : meant, path_,
                           excerpt(part));
    }

    /// What the list of keys has for a value that is not written: a vector whose second member is set alone keeps the
    /// others. Everything else begins as an empty table.
    Node default_of(const std::string& part) {
        const Key* key = find_key(*find_table(table_), part, dimension_);
        const auto* numbers = key ? std::get_if<std::vector<double>>(&key->standard) : nullptr;
        if (!numbers)
            return {place_, Table{}};
        Array array;
        const std::size_t count = key->type == KeyType::vector ? static_cast<std::size_t>(dimension_) : numbers->size();
        for (std::size_t i = 0; i < count; ++i)
            array.items.push_back({place_, (*numbers)[i]});
        return {place_, array};
    }

    Node* member(Array& array, const std::string& part) {
        std::vector<std::string> names;
        for (Node& item : array.items)
            if (const Table* table = item.as<Table>())
                if (const Entry* name = table->find("name"); name && name->node.as<std::string>()) {
                    names.push_back(*name->node.as<std::string>());
                    if (names.back() == part)
                        return &item;
                }
        const auto index = parse_integer(part);
        if (index && *index >= 0 && static_cast<std::size_t>(*index) < array.items.size())
            return &array.items[static_cast<std::size_t>(*index)];
        std::string fix = did_you_mean(part, names);
        if (fix.empty() && array.items.empty())
            fix = "the list is empty";
        else if (fix.empty())
            fix = fmt::format("its members are numbered 0 to {}", array.items.size() - 1);
        return refuse(fmt::format("'{}' has no member '{}'", path_, part), fix);
    }

    const std::string& key_;
    const Place& place_;
    int dimension_;
    const Table* root_ = nullptr;
    std::string path_;
    std::string table_; // path in the list of keys, without names and numbers
    Problems problems_;
};

} // namespace

Problems apply(const Override& set, Node& root) {
    const auto equals = set.text.find('=');
    const std::string key(trimmed(set.text.substr(0, equals)));
    const Place place{std::make_shared<const std::string>("--set " + key), 0, 0};
    if (equals == std::string::npos)
        return {problem_at(place, key, "there is no '=' in it", form_of_a_set)};
    if (key.empty())
        return {problem_at({std::make_shared<const std::string>("--set"), 0, 0}, "", "there is no key before '='",
                           form_of_a_set)};
    if (std::count(key.begin(), key.end(), '.') > deepest_nesting)
        return {problem_at(place, key, "the key has too many parts", form_of_a_set)};
    auto value = parse_value(set.text.substr(equals + 1), place);
    if (!value)
        return value.problems();
    Walk walk(key, place, dimension_of(root));
    Node* target = walk.find(root);
    if (!target)
        return walk.problems();
    *target = std::move(*value);
    return {};
}

Result<double> number_in(std::string_view toml, const std::filesystem::path& file, const std::vector<Override>& sets,
                         const std::string& key) {
    auto root = parse_toml(toml, file.string());
    if (!root)
        return root.problems();
    for (const Override& set : sets)
        if (const Problems problems = apply(set, *root); !problems.empty())
            return problems;
    Walk walk(key, root->place, dimension_of(*root));
    const Node* node = walk.find(*root);
    if (!node)
        return walk.problems();
    if (const double* real = node->as<double>())
        return *real;
    if (const std::int64_t* whole = node->as<std::int64_t>())
        return static_cast<double>(*whole);
    if (const auto standard = walk.standard(); standard && node->as<Table>())
        return *standard;
    const std::string meant = node->as<Table>() ? walk.meant() : "";
    return problem_at(node->place, key, fmt::format("'{}' is not a number that can be adjusted", key),
                      (meant.empty() ? "name a key that holds one number;" : meant) +
                          " `tumble list keys` names all of them");
}

} // namespace tumble::scene
