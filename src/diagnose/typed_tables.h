#pragma once

#include "scene/report.h"
#include "scene/text_tree.h"
#include "scene/view.h"

#include <string>
#include <vector>

namespace tumble::diagnose {

/// A measurement as typed, held against its list of keys; used by the reader of measurements only.
struct TypedTable {
    const scene::Node* node = nullptr; // null: not written
    scene::View view;
};

using TypedTables = std::vector<TypedTable>;

/// Unknown keys with the nearest right one, wrong values, missing keys, and of keys that exclude each other not exactly
/// one: all reported. `list` holds the table's keys and those of the tables inside it.
void check_tables(const scene::Node& root, const std::vector<scene::KeyTable>& list, scene::Report& report);

/// The tables `name` ("series") inside this node, in the order written.
TypedTables tables_of(const scene::Node& node, const std::string& name, const scene::KeyTable& keys,
                      const scene::Report& report);

} // namespace tumble::diagnose
