#include "scene/view.h"

#include "scene/check_keys.h"

#include <stdexcept>

namespace tumble::scene {
namespace {

double as_double(const Node& node) {
    if (const auto* whole = node.as<std::int64_t>())
        return static_cast<double>(*whole);
    const auto* real = node.as<double>();
    return real ? *real : 0.0;
}

void collect(const Node& node, double si, std::vector<double>& into) {
    if (const Array* array = node.as<Array>())
        for (const Node& item : array->items)
            collect(item, si, into);
    else
        into.push_back(as_double(node) * si);
}

template <class T> T standard_of(const Key& key) {
    const T* value = std::get_if<T>(&key.standard);
    return value ? *value : T{};
}

} // namespace

View::View(const Node* node, const KeyTable& keys, std::string path, const Report& report)
    : node_(node), keys_(&keys), path_(std::move(path)), report_(&report) {}

std::string View::title() const {
    return name_of_table(*keys_, path_);
}

std::string View::path_of_table(const std::string& name) const {
    return keys_->path.empty() ? name : keys_->path + "." + name;
}

std::string View::path_of(const std::string& name) const {
    return path_.empty() ? name : path_ + "." + name;
}

const Key& View::key(const std::string& name) const {
    // A key of scenes of the other dimension is never given and has its default.
    const Key* found = find_key(*keys_, name, report_->dimension);
    if (!found)
        found = find_key(*keys_, name);
    if (!found)
        throw std::logic_error("no key '" + name + "' in the list for '" + keys_->path + "'");
    return *found;
}

const Node* View::value_of(const std::string& name) const {
    (void)key(name);
    const Table* table = node_ ? node_->as<Table>() : nullptr;
    const Entry* entry = table ? table->find(name) : nullptr;
    return entry && report_->trusts(entry->node) ? &entry->node : nullptr;
}

bool View::written(const std::string& name) const {
    const Table* table = node_ ? node_->as<Table>() : nullptr;
    return table && table->find(name);
}

bool View::whole() const {
    const std::string chosen = kind();
    for (const Key& one : keys_->keys) {
        if (!belongs_in(one, report_->dimension))
            continue;
        const bool needed = one.required && belongs(one, chosen) && one.name != keys_->kind_key;
        if ((written(one.name) && !given(one.name)) || (needed && !written(one.name)))
            return false;
    }
    return keys_->kind_key.empty() || !chosen.empty();
}

Place View::place(const std::string& name) const {
    const Table* table = node_ ? node_->as<Table>() : nullptr;
    const Entry* entry = table ? table->find(name) : nullptr;
    return entry ? entry->node.place : place();
}

Place View::place() const {
    return node_ ? node_->place : fallback_;
}

double View::number(const std::string& name) const {
    const Node* node = value_of(name);
    return (node ? as_double(*node) : standard_of<double>(key(name))) * key(name).si;
}

std::int64_t View::integer(const std::string& name) const {
    const Node* node = value_of(name);
    return node ? *node->as<std::int64_t>() : standard_of<std::int64_t>(key(name));
}

bool View::flag(const std::string& name) const {
    const Node* node = value_of(name);
    return node ? *node->as<bool>() : standard_of<bool>(key(name));
}

std::string View::text(const std::string& name) const {
    const Node* node = value_of(name);
    return node ? *node->as<std::string>() : standard_of<std::string>(key(name));
}

std::vector<std::string> View::words(const std::string& name) const {
    const Node* node = value_of(name);
    if (!node)
        return standard_of<std::vector<std::string>>(key(name));
    std::vector<std::string> all;
    for (const Node& item : node->as<Array>()->items)
        all.push_back(*item.as<std::string>());
    return all;
}

std::vector<double> View::numbers(const std::string& name) const {
    std::vector<double> all;
    if (const Node* node = value_of(name))
        collect(*node, key(name).si, all);
    else
        all = standard_of<std::vector<double>>(key(name));
    return all;
}

Eigen::Vector3d View::vector(const std::string& name) const {
    const auto all = numbers(name);
    const auto wanted = static_cast<std::size_t>(report_->dimension);
    if (all.size() < wanted)
        return Eigen::Vector3d::Zero();
    return {all[0], all[1], wanted == 3 ? all[2] : 0.0};
}

std::string View::kind() const {
    const Table* table = node_ ? node_->as<Table>() : nullptr;
    return table ? kind_word(*table, *keys_, report_->dimension) : "";
}

View View::child(const std::string& name) const {
    const Table* table = node_ ? node_->as<Table>() : nullptr;
    const Entry* entry = table ? table->find(name) : nullptr;
    const Node* node = entry && entry->node.as<Table>() ? &entry->node : nullptr;
    View view(node, *find_table(path_of_table(name)), path_of(name), *report_);
    view.fallback_ = place();
    return view;
}

std::vector<NamedView> View::children(const std::string& name) const {
    const KeyTable& keys = *find_table(path_of_table(name));
    const Table* table = node_ ? node_->as<Table>() : nullptr;
    const Entry* entry = table ? table->find(name) : nullptr;
    std::vector<NamedView> all;
    if (!entry)
        return all;
    if (const Table* named = entry->node.as<Table>(); named && keys.repeat == Repeat::named) {
        for (const Entry& one : named->entries)
            if (one.node.as<Table>())
                all.push_back({one.name, one.place, View(&one.node, keys, path_of(name) + "." + one.name, *report_)});
    } else if (const Array* list = entry->node.as<Array>(); list && keys.repeat == Repeat::many) {
        for (std::size_t i = 0; i < list->items.size(); ++i)
            if (list->items[i].as<Table>()) {
                const std::string path = path_of(name) + "." + label_of(list->items[i], keys, i);
                all.push_back({"", list->items[i].place, View(&list->items[i], keys, path, *report_)});
            }
    }
    return all;
}

} // namespace tumble::scene
