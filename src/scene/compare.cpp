#include "scene/compare.h"

#include "base/text.h"
#include "scene/check_keys.h"
#include "scene/read_toml.h"
#include "scene/text_tree.h"
#include "scene/toml_writer.h"

#include <fmt/format.h>
#include <map>

namespace tumble::scene {
namespace {

/// Keys by path, and the paths in the order written.
struct Flat {
    std::vector<std::string> order;
    std::map<std::string, std::string> values;
};

std::string as_toml(const Node& node) {
    struct Writer {
        std::string operator()(const Moment&) const { return "a date"; }
        std::string operator()(bool value) const { return value ? "true" : "false"; }
        std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
        std::string operator()(double value) const { return shortest(value); }
        std::string operator()(const std::string& value) const { return TomlWriter::quoted(value); }
        std::string operator()(const Table&) const { return "a table"; }
        std::string operator()(const Array& array) const {
            std::string text;
            for (const Node& item : array.items)
                text += (text.empty() ? "" : ", ") + as_toml(item);
            return "[" + text + "]";
        }
    };
    return std::visit(Writer{}, node.value);
}

void flatten(const Node& node, const std::string& path, const std::string& keys, Flat& flat) {
    const Table* table = node.as<Table>();
    if (!table) {
        flat.order.push_back(path);
        flat.values[path] = as_toml(node);
        return;
    }
    const std::string dot = path.empty() ? "" : ".";
    for (const Entry& entry : table->entries) {
        const std::string inner = path + dot + entry.name;
        const std::string inner_keys = keys.empty() ? entry.name : keys + "." + entry.name;
        const KeyTable* spec = find_table(inner_keys);
        const Array* list = entry.node.as<Array>();
        if (!spec || !list)
            flatten(entry.node, inner, spec ? inner_keys : keys, flat);
        else
            for (std::size_t i = 0; i < list->items.size(); ++i)
                flatten(list->items[i], inner + "." + label_of(list->items[i], *spec, i), inner_keys, flat);
    }
}

Result<Flat> flat_of(std::string_view toml, const std::string& name) {
    const Result<Node> root = parse_toml(toml, name);
    if (!root)
        return root.problems();
    Flat flat;
    flatten(*root, "", "", flat);
    return flat;
}

} // namespace

Result<std::vector<Change>> changes_between(std::string_view before, std::string_view now) {
    Result<Flat> old = flat_of(before, "the scene before");
    Result<Flat> fresh = flat_of(now, "the scene now");
    if (!old || !fresh)
        return old ? fresh.problems() : old.problems();
    std::vector<Change> changes;
    for (const std::string& path : old->order)
        if (old->values[path] != fresh->values[path])
            changes.push_back({path, old->values[path], fresh->values[path]});
    for (const std::string& path : fresh->order)
        if (!old->values.contains(path))
            changes.push_back({path, "", fresh->values[path]});
    return changes;
}

} // namespace tumble::scene
