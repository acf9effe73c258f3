#include "scene/check_keys.h"

#include "base/text.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>

namespace tumble::scene {
namespace {

std::string join(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "." + name;
}

std::string quoted_or(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words)
        list += fmt::format("{}\"{}\"", list.empty() ? "" : " or ", word);
    return list;
}

/// The tables that may stand directly in this one.
std::vector<const KeyTable*> tables_in(const KeyTable& parent) {
    std::vector<const KeyTable*> inside;
    for (const KeyTable& table : scene_keys()) {
        const std::string prefix = parent.path.empty() ? "" : parent.path + ".";
        const bool below = table.path.size() > prefix.size() && table.path.compare(0, prefix.size(), prefix) == 0;
        if (below && table.path.find('.', prefix.size()) == std::string::npos)
            inside.push_back(&table);
    }
    return inside;
}

std::string last_name(const KeyTable& table) {
    const auto dot = table.path.rfind('.');
    return dot == std::string::npos ? table.path : table.path.substr(dot + 1);
}

class KeyCheck {
public:
    explicit KeyCheck(Report& report) : report_(report) {}

    void table(const Node& node, const KeyTable& spec, const std::string& path) {
        const Table& entries = *node.as<Table>();
        const std::string kind = kind_word(entries, spec, report_.dimension);
        const auto inside = tables_in(spec);
        std::set<std::string> misspelt; // what unknown keys were meant to be: they are not missing as well
        for (const Entry& entry : entries.entries) {
            const std::string key_path = join(path, entry.name);
            const auto sub = std::find_if(inside.begin(), inside.end(),
                                          [&](const KeyTable* t) { return last_name(*t) == entry.name; });
            if (sub != inside.end())
                sub_table(entry.node, **sub, key_path);
            else if (const Key* key = find_key(spec, entry.name, report_.dimension))
                known_key(entry, *key, spec, kind, path);
            else if (find_key(spec, entry.name))
                misplaced_key(entry, path);
            else
                misspelt.insert(unknown_key(entry, spec, kind, path));
        }
        missing_keys(node, spec, kind, path, misspelt);
        for (const KeyTable* sub : inside)
            if (sub->required && !entries.find(last_name(*sub)) && !misspelt.count(last_name(*sub)))
                report_.add(node.place, join(path, last_name(*sub)),
                            fmt::format("{} has no {}", name_of_table(spec, path), sub->head),
                            "add one: " + sub->sentence);
    }

private:
    void sub_table(const Node& node, const KeyTable& spec, const std::string& path) {
        if (spec.repeat == Repeat::once)
            return one(node, spec, path);
        if (spec.repeat == Repeat::named)
            return named(node, spec, path);
        const Array* array = node.as<Array>();
        if (!array)
            return wrong_form(node, spec, path);
        for (std::size_t i = 0; i < array->items.size(); ++i)
            one(array->items[i], spec, join(path, label_of(array->items[i], spec, i)));
    }

    void named(const Node& node, const KeyTable& spec, const std::string& path) {
        const Table* tables = node.as<Table>();
        if (!tables)
            return wrong_form(node, spec, path);
        for (const Entry& entry : tables->entries)
            one(entry.node, spec, join(path, entry.name));
    }

    void one(const Node& node, const KeyTable& spec, const std::string& path) {
        if (node.as<Table>())
            table(node, spec, path);
        else
            wrong_form(node, spec, path);
    }

    void wrong_form(const Node& node, const KeyTable& spec, const std::string& path) {
        report_.add(node.place, path, fmt::format("'{}' is {}", excerpt(path), kind_of(node)),
                    "write it as a table " + spec.head);
        report_.distrust(node);
    }

    void misplaced_key(const Entry& entry, const std::string& path) {
        const int other = report_.dimension == 2 ? 3 : 2;
        report_.add(entry.place, join(path, entry.name),
                    fmt::format("'{}' belongs to scenes of dimension {}, and this one has {}", entry.name, other,
                                report_.dimension),
                    fmt::format("remove it, or write dimension = {} at the top", other));
        report_.distrust(entry.node);
    }

    void known_key(const Entry& entry, const Key& key, const KeyTable& spec, const std::string& kind,
                   const std::string& path) {
        if (!kind.empty() && !belongs(key, kind)) {
            report_.add(entry.place, join(path, entry.name),
                        fmt::format("'{}' does not belong to {} = \"{}\"", entry.name, spec.kind_key, kind),
                        fmt::format("remove it, or write {} = {}", spec.kind_key, quoted_or(key.only_for)));
            report_.distrust(entry.node);
            return;
        }
        check_value(entry.node, key, join(path, entry.name), report_);
    }

    /// The key or table that was probably meant; empty when none is near.
    std::string unknown_key(const Entry& entry, const KeyTable& spec, const std::string& kind,
                            const std::string& path) {
        std::vector<std::string> candidates;
        for (const Key& key : spec.keys)
            if (belongs(key, kind) && belongs_in(key, report_.dimension))
                candidates.push_back(key.name);
        for (const KeyTable* sub : tables_in(spec))
            candidates.push_back(last_name(*sub));
        const auto nearest = nearest_word(entry.name, candidates);
        const Key* meant = nearest ? find_key(spec, *nearest, report_.dimension) : nullptr;
        std::string fix;
        if (meant)
            fix = fmt::format("did you mean '{}'?  {}", *nearest, describe(*meant, report_.dimension));
        else if (nearest)
            fix = fmt::format("did you mean '{}'?", *nearest);
        else
            fix = fmt::format("its keys are {}", fmt::join(candidates, ", "));
        report_.add(entry.place, join(path, entry.name),
                    fmt::format("{} has no key '{}'", name_of_table(spec, path), excerpt(entry.name)), fix);
        return nearest.value_or("");
    }

    void missing_keys(const Node& node, const KeyTable& spec, const std::string& kind, const std::string& path,
                      const std::set<std::string>& misspelt) {
        const Table& entries = *node.as<Table>();
        std::map<std::string, std::vector<const Key*>> groups;
        for (const Key& key : spec.keys) {
            // Without its kind nobody knows what else the table needs.
            if (!belongs_in(key, report_.dimension) || !belongs(key, kind) || (kind.empty() && !key.only_for.empty()))
                continue;
            if (!key.one_of.empty())
                groups[key.one_of].push_back(&key);
            const bool implied = key.name == spec.kind_key && !kind.empty();
            if (key.required && !implied && !entries.find(key.name) && !misspelt.count(key.name))
                report_.add(node.place, join(path, key.name),
                            fmt::format("{} has no '{}'", name_of_table(spec, path), key.name),
                            fmt::format("add {}: {}", key.name, describe(key, report_.dimension)));
        }
        for (const auto& [group, keys] : groups)
            if (std::none_of(keys.begin(), keys.end(), [&](const Key* key) { return misspelt.count(key->name); }))
                exactly_one(node, keys, spec, path);
    }

    void exactly_one(const Node& node, const std::vector<const Key*>& keys, const KeyTable& spec,
                     const std::string& path) {
        std::vector<std::string> names;
        std::vector<const Entry*> given;
        for (const Key* key : keys) {
            names.push_back(key->name);
            if (const Entry* entry = node.as<Table>()->find(key->name))
                given.push_back(entry);
        }
        if (given.empty() && names.size() == 1)
            report_.add(node.place, join(path, names[0]),
                        fmt::format("{} has no '{}'", name_of_table(spec, path), names[0]),
                        fmt::format("add {}: {}", names[0], describe(*keys[0], report_.dimension)));
        else if (given.empty())
            report_.add(node.place, path,
                        fmt::format("{} has none of {}", name_of_table(spec, path), fmt::join(names, ", ")),
                        "give exactly one of them");
        for (std::size_t i = 1; i < given.size(); ++i) {
            report_.add(given[i]->place, join(path, given[i]->name),
                        fmt::format("{} has '{}' and '{}'", name_of_table(spec, path), given[0]->name, given[i]->name),
                        fmt::format("give exactly one of {}", fmt::join(names, ", ")));
            report_.distrust(given[i]->node);
        }
    }

    Report& report_;
};

} // namespace

int dimension_of(const Node& root) {
    const Table* entries = root.as<Table>();
    const Entry* entry = entries ? entries->find("dimension") : nullptr;
    const auto* number = entry ? entry->node.as<std::int64_t>() : nullptr;
    return number && *number == 2 ? 2 : 3;
}

std::string kind_word(const Table& entries, const KeyTable& table, int dimension) {
    if (table.kind_key.empty())
        return "";
    const Entry* entry = entries.find(table.kind_key);
    if (!entry)
        return table.path == "wall" && dimension == 3 && entries.find("stl") ? "mesh" : "";
    const std::string* word = entry->node.as<std::string>();
    const Key& key = *find_key(table, table.kind_key, dimension);
    return word && std::find(key.words.begin(), key.words.end(), *word) != key.words.end() ? *word : "";
}

bool belongs(const Key& key, const std::string& kind) {
    return key.only_for.empty() || kind.empty() ||
           std::find(key.only_for.begin(), key.only_for.end(), kind) != key.only_for.end();
}

std::string label_of(const Node& node, const KeyTable& table, std::size_t index) {
    const Table* entries = node.as<Table>();
    const Entry* name = entries && find_key(table, "name") ? entries->find("name") : nullptr;
    const std::string* text = name ? name->node.as<std::string>() : nullptr;
    return text && !text->empty() ? *text : fmt::format("{}", index);
}

std::string name_of_table(const KeyTable& table, const std::string& path) {
    if (table.path.empty())
        return "the scene";
    if (table.repeat != Repeat::many)
        return "[" + excerpt(path) + "]";
    const std::string last = path.substr(path.rfind('.') + 1);
    const bool numbered = last.find_first_not_of("0123456789") == std::string::npos;
    return numbered ? table.head : fmt::format("{} '{}'", table.head, excerpt(last));
}

namespace {

/// A whole number that is no dimension: what belongs into the scene cannot be told then.
const Entry* impossible_dimension(const Node& root) {
    const Table* entries = root.as<Table>();
    const Entry* entry = entries ? entries->find("dimension") : nullptr;
    const auto* number = entry ? entry->node.as<std::int64_t>() : nullptr;
    return number && *number != 2 && *number != 3 ? entry : nullptr;
}

} // namespace

void check_keys(const Node& root, Report& report) {
    report.dimension = dimension_of(root);
    if (const Entry* entry = impossible_dimension(root)) {
        report.add(entry->place, "dimension",
                   fmt::format("a scene of {} dimensions cannot be simulated", *entry->node.as<std::int64_t>()),
                   "write dimension = 2 or dimension = 3; the other keys are checked then");
        report.distrust(entry->node);
        return;
    }
    KeyCheck(report).table(root, *find_table(""), "");
}

} // namespace tumble::scene
