#pragma once

#include "base/problem.h"
#include "scene/text_tree.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

/// One --set: "key=value". The key is a dotted path; members of [[wall]] go by name or number (from 0), members of
/// other lists by number: "wall.trough.motion.0.amplitude_m=0.001", "fill.0.count=10", "gravity_m_s2.1=-1.62". The
/// value is TOML; a word that is not TOML is taken as text.
struct Override {
    std::string text;
};

/// Puts the value at its place in the tree, making tables on the way where the scene has none. The new values carry
/// "--set KEY" as their place. Problems: no '=', an empty key, a wrong value, a list that has no such member, a
/// body, material or pair that the scene does not have (unless it is set as a whole), a path through something that
/// holds nothing. "pair.b-a" finds [pair.a-b].
Problems apply(const Override& set, Node& root);

/// The number that stands at a key's place in a scene's text after the `sets`, in the key's own unit, or the key's
/// default. Problems: wrong TOML or sets, a path as in apply() that leads nowhere, a value that is no number.
Result<double> number_in(std::string_view toml, const std::filesystem::path& file, const std::vector<Override>& sets,
                         const std::string& key);

} // namespace tumble::scene
