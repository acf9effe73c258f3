#pragma once

#include "scene/keys.h"
#include "scene/report.h"
#include "scene/text_tree.h"

#include <string>

namespace tumble::scene {

/// 2 where the scene says so, else 3.
int dimension_of(const Node& root);

/// Holds the typed scene against the list of keys: unknown names, wrong types, values out of range, what is missing or
/// given twice. Values that fail are distrusted; what refers to what is checked later, by who resolves it.
void check_keys(const Node& root, Report& report);

/// One value against its key; says nothing and returns true when it is right.
bool check_value(const Node& node, const Key& key, const std::string& path, Report& report);

/// The word that `table.kind_key` has in these entries; a wall with `stl` is a mesh without saying so. Empty when the
/// table has no kinds or the word is missing or unknown.
std::string kind_word(const Table& entries, const KeyTable& table, int dimension);

/// Whether the key belongs to entries of that kind.
bool belongs(const Key& key, const std::string& kind);

/// What a member of a list of tables is called in paths: its `name` where it has one, else its number from 0.
std::string label_of(const Node& node, const KeyTable& table, std::size_t index);

/// "[material.media]", "[[wall]] 'trough'", "[[fill]]", "the scene": the table at this path, for sentences.
std::string name_of_table(const KeyTable& table, const std::string& path);

} // namespace tumble::scene
