#pragma once

#include "scene/text_tree.h"

#include <set>
#include <string>

namespace tumble::scene {

/// Everything found wrong so far, and which values are not worth a second complaint.
class Report {
public:
    int dimension = 3; // of the scene, 2 or 3: which keys there are and how many numbers a point has

    void add(const Place& place, std::string key, std::string what, std::string fix) {
        problems_.push_back(problem_at(place, std::move(key), std::move(what), std::move(fix)));
    }
    void add(const Problems& problems) { problems_.insert(problems_.end(), problems.begin(), problems.end()); }

    /// The value failed its own check: whoever reads it gets the default, and no further check is made of it.
    void distrust(const Node& node) { distrusted_.insert(&node); }
    [[nodiscard]] bool trusts(const Node& node) const { return distrusted_.count(&node) == 0; }

    [[nodiscard]] bool clean() const { return problems_.empty(); }

    /// Those of the scene file first, by line; then those of --set and of other files, in the order they were found.
    [[nodiscard]] Problems sorted(const std::string& scene_file) const;

private:
    Problems problems_;
    std::set<const Node*> distrusted_;
};

} // namespace tumble::scene
