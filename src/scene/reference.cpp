#include "scene/reference.h"

#include "scene/keys.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace tumble::scene {
namespace {

constexpr const char* opening = R"(# What a scene file may say

Generated from the list in `src/scene/keys_*.cpp` that the reader checks against; edit there. A test tells when this page
is stale and how to write it anew.

A scene is a TOML file. Units stand in the names of keys. Relative file names start at the scene's folder. An unknown key
is an error; all problems of a file are reported at once. y is up.

With `dimension = 2` bodies are discs in the plane of x and y: points and vectors have two numbers, [x, y]. Keys marked 2D
or 3D in the second column belong to scenes of that dimension alone; a name that stands there twice means something else in
each.

Any key can be set on the command line, with the same checks: `--set time_step_s=1e-6`,
`--set material.media.density_kg_m3=1500`, `--set fill.0.count=200`, `--set wall.trough.motion.0.amplitude_m=0.001`.
Members of `[[fill]]` and `[[wall.motion]]` go by their number from 0, members of `[[wall]]` by name or number.
)";

std::string bar_escaped(const std::string& text) {
    std::string escaped;
    for (const char c : text)
        escaped += c == '|' ? "\\|" : std::string(1, c);
    return escaped;
}

std::string default_of(const Key& key) {
    if (key.required)
        return "required";
    if (!key.one_of.empty())
        return "one of its group";
    const std::string text = describe(key.standard);
    return text.empty() ? "" : "`" + text + "`";
}

std::string row(const Key& key, const KeyTable& table) {
    std::string text =
        fmt::format("| `{}` | {} | {} | {} |", key.name, mark_of(key.in), bar_escaped(describe(key)), default_of(key));
    if (!table.kind_key.empty())
        text += fmt::format(" {} |", fmt::join(key.only_for, ", "));
    return text + " " + bar_escaped(key.sentence) + " |\n";
}

/// The keys of a group that scenes of that dimension may have.
std::vector<std::string> members(const KeyTable& table, const std::string& group, Dimensions in) {
    std::vector<std::string> names;
    for (const Key& key : table.keys)
        if (key.one_of == group && (key.in == Dimensions::both || key.in == in))
            names.push_back("`" + key.name + "`");
    return names;
}

std::string give_one(const std::vector<std::string>& names) {
    return fmt::format("give {}{}", names.size() > 1 ? "exactly one of " : "", fmt::join(names, ", "));
}

/// "Give exactly one of `clump`, `radius_m`, ..." for each group of the table.
std::string groups(const KeyTable& table) {
    std::string text;
    std::vector<std::string> done;
    for (const Key& key : table.keys) {
        if (key.one_of.empty() || std::find(done.begin(), done.end(), key.one_of) != done.end())
            continue;
        done.push_back(key.one_of);
        const auto in_2d = members(table, key.one_of, Dimensions::two);
        const auto in_3d = members(table, key.one_of, Dimensions::three);
        if (in_2d == in_3d)
            text += "G" + give_one(in_3d).substr(1) + ".\n";
        else
            for (const auto& [dimension, names] : {std::pair{"3D", in_3d}, {"2D", in_2d}})
                if (!names.empty())
                    text += fmt::format("In {} {}.\n", dimension, give_one(names));
    }
    return text.empty() ? "" : "\n" + text;
}

std::string section(const KeyTable& table) {
    std::string text = fmt::format("\n## {}\n\n{}{}\n", table.head.empty() ? "Top of the file" : "`" + table.head + "`",
                                   table.sentence, table.required && !table.head.empty() ? " Required." : "");
    text += groups(table);
    if (table.kind_key.empty())
        text += "\n| key | in | takes | default | meaning |\n| --- | --- | --- | --- | --- |\n";
    else
        text += fmt::format(
            "\n| key | in | takes | default | only for `{}` | meaning |\n| --- | --- | --- | --- | --- | --- |\n",
            table.kind_key);
    for (const Key& key : table.keys)
        text += row(key, table);
    return text;
}

} // namespace

std::string scene_reference() {
    std::string text = opening;
    for (const KeyTable& table : scene_keys())
        text += section(table);
    return text;
}

} // namespace tumble::scene
