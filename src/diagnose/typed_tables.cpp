#include "diagnose/typed_tables.h"

#include "base/text.h"
#include "scene/check_keys.h"

#include <fmt/format.h>
#include <map>

namespace tumble::diagnose {

using namespace scene;

namespace {

const KeyTable* table_inside(const std::vector<KeyTable>& list, const KeyTable& outer, const std::string& name) {
    const std::string path = outer.path.empty() ? name : outer.path + "." + name;
    for (const KeyTable& table : list)
        if (table.path == path)
            return &table;
    return nullptr;
}

std::string where(const KeyTable& table) {
    return table.head.empty() ? "the measurement" : table.head;
}

class Check {
public:
    Check(const std::vector<KeyTable>& list, Report& report) : list_(list), report_(report) {}

    void table(const Node& node, const KeyTable& keys, const std::string& path) {
        const scene::Table* entries = node.as<scene::Table>();
        if (!entries)
            return report_.add(node.place, path, fmt::format("'{}' is {}", path, kind_of(node)),
                               "write it as a table " + keys.head);
        for (const Entry& entry : entries->entries)
            known(entry, keys, path.empty() ? entry.name : path + "." + entry.name);
        missing(node, *entries, keys, path);
    }

private:
    void known(const Entry& entry, const KeyTable& keys, const std::string& path) {
        if (const KeyTable* inner = table_inside(list_, keys, entry.name)) {
            const Array* list = entry.node.as<Array>();
            if (!list)
                return report_.add(entry.place, path, fmt::format("'{}' is {}", path, kind_of(entry.node)),
                                   "write it as " + inner->head);
            for (std::size_t i = 0; i < list->items.size(); ++i)
                table(list->items[i], *inner, fmt::format("{}.{}", path, i));
        } else if (const Key* key = find_key(keys, entry.name)) {
            if (!check_value(entry.node, *key, path, report_))
                report_.distrust(entry.node);
        } else {
            unknown(entry, keys, path);
        }
    }

    void unknown(const Entry& entry, const KeyTable& keys, const std::string& path) {
        std::vector<std::string> names;
        for (const Key& key : keys.keys)
            names.push_back(key.name);
        for (const KeyTable& table : list_)
            if (!table.path.empty() &&
                table_inside(list_, keys, table.path.substr(table.path.rfind('.') + 1)) == &table)
                names.push_back(table.path.substr(table.path.rfind('.') + 1));
        std::string all;
        for (const std::string& name : names)
            all += (all.empty() ? "" : ", ") + name;
        const std::string guess = did_you_mean(entry.name, names);
        report_.add(entry.place, path, fmt::format("{} has no key '{}'", where(keys), excerpt(entry.name)),
                    guess.empty() ? "it may have " + all : guess);
    }

    void missing(const Node& node, const scene::Table& entries, const KeyTable& keys, const std::string& path) {
        std::map<std::string, std::vector<std::string>> groups;
        for (const Key& key : keys.keys) {
            if (key.required && !entries.find(key.name))
                report_.add(node.place, path, fmt::format("{} has no '{}'", where(keys), key.name),
                            "add it: " + key.sentence);
            if (!key.one_of.empty())
                groups[key.one_of].push_back(key.name);
        }
        for (const auto& [group, names] : groups) {
            std::size_t given = 0;
            std::string all;
            for (const std::string& name : names) {
                given += entries.find(name) ? 1 : 0;
                all += (all.empty() ? "" : " or ") + name;
            }
            if (given != 1)
                report_.add(node.place, path, fmt::format("{} has {} of {}", where(keys), given, all),
                            "write exactly one of them");
        }
        for (const KeyTable& inner : list_)
            if (inner.required && &inner != &keys && !entries.find(inner.path.substr(inner.path.rfind('.') + 1)) &&
                table_inside(list_, keys, inner.path.substr(inner.path.rfind('.') + 1)) == &inner)
                report_.add(node.place, path, fmt::format("{} has no {}", where(keys), inner.head),
                            "add one: " + inner.sentence);
    }

    const std::vector<KeyTable>& list_;
    Report& report_;
};

} // namespace

void check_tables(const Node& root, const std::vector<KeyTable>& list, Report& report) {
    Check(list, report).table(root, list.front(), "");
}

std::vector<TypedTable> tables_of(const Node& node, const std::string& name, const KeyTable& keys,
                                  const Report& report) {
    std::vector<TypedTable> all;
    const scene::Table* table = node.as<scene::Table>();
    const Entry* entry = table ? table->find(name) : nullptr;
    const Array* list = entry ? entry->node.as<Array>() : nullptr;
    for (std::size_t i = 0; list && i < list->items.size(); ++i)
        if (list->items[i].as<scene::Table>())
            all.push_back({&list->items[i], View(&list->items[i], keys, fmt::format("{}.{}", name, i), report)});
    return all;
}

} // namespace tumble::diagnose
