#pragma once

#include "scene/keys.h"
#include "scene/report.h"
#include "scene/text_tree.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace tumble::scene {

struct NamedView;

/// A checked table with its part of the key list: values come out in SI, defaults filled in. Asking for a name that the
/// list does not hold is a mistake of the program, not of the scene.
class View {
public:
    /// `node` may be null (the table is not in the file): every key then has its default.
    View(const Node* node, const KeyTable& keys, std::string path, const Report& report);

    [[nodiscard]] const std::string& path() const { return path_; }
    /// "[material.media]"
    [[nodiscard]] std::string title() const;
    [[nodiscard]] std::string path_of(const std::string& name) const;

    /// Written and right.
    [[nodiscard]] bool given(const std::string& name) const { return value_of(name) != nullptr; }
    /// Written, right or wrong.
    [[nodiscard]] bool written(const std::string& name) const;
    /// All required keys of its kind are there and none of the given ones was refused.
    [[nodiscard]] bool whole() const;
    /// Of the value; of the table when the key is not written.
    [[nodiscard]] Place place(const std::string& name) const;
    [[nodiscard]] Place place() const;

    /// The value in SI; else the default; else 0, empty or false.
    [[nodiscard]] double number(const std::string& name) const;
    [[nodiscard]] std::int64_t integer(const std::string& name) const;
    [[nodiscard]] bool flag(const std::string& name) const;
    [[nodiscard]] std::string text(const std::string& name) const;
    [[nodiscard]] std::vector<std::string> words(const std::string& name) const;
    /// z is 0 in a scene of two dimensions.
    [[nodiscard]] Eigen::Vector3d vector(const std::string& name) const;
    /// The numbers of a list, of lists inside it one after the other.
    [[nodiscard]] std::vector<double> numbers(const std::string& name) const;

    /// The word that chooses this table's other keys.
    [[nodiscard]] std::string kind() const;

    /// The single table of that name in this one; every key at its default when it is not written.
    [[nodiscard]] View child(const std::string& name) const;
    /// The named or repeated tables of that name, in the order written.
    [[nodiscard]] std::vector<NamedView> children(const std::string& name) const;

private:
    [[nodiscard]] std::string path_of_table(const std::string& name) const;
    [[nodiscard]] const Key& key(const std::string& name) const;
    [[nodiscard]] const Node* value_of(const std::string& name) const;

    const Node* node_;
    const KeyTable* keys_;
    std::string path_;
    const Report* report_;
    Place fallback_; // of the table around this one, when this one is not written
};

struct NamedView {
    std::string name; // of [material.NAME]; empty for [[fill]]
    Place place;      // of the name
    View view;
};

} // namespace tumble::scene
