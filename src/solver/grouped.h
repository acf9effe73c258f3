#pragma once

#include "base/archive.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace tumble::solver {

/// Entries by a number that each has, its key; inside a group they stand in the order in which they were added. Keeps
/// its room from one use to the next.
template <class Entry> class Grouped {
public:
    void begin_anew() { added_.clear(); }
    void add(const Entry& entry) { added_.push_back(entry); }
    /// Groups what was added; keys are below `keys`. A counting sort, stable.
    template <class Key> void group(std::size_t keys, Key&& key) {
        begin_.assign(keys + 1, 0);
        for (const Entry& entry : added_)
            ++begin_[static_cast<std::size_t>(key(entry)) + 1];
        for (std::size_t k = 0; k < keys; ++k)
            begin_[k + 1] += begin_[k];
        next_ = begin_;
        sorted_.resize(added_.size());
        for (const Entry& entry : added_)
            sorted_[static_cast<std::size_t>(next_[static_cast<std::size_t>(key(entry))]++)] = entry;
    }
    void forget() {
        sorted_.clear();
        begin_.clear();
    }

    /// Empty of a key that was not known at the grouping.
    [[nodiscard]] std::span<const Entry> of(std::size_t key) const {
        if (key + 1 >= begin_.size())
            return {};
        return {sorted_.data() + begin_[key], static_cast<std::size_t>(begin_[key + 1] - begin_[key])};
    }

    /// Of one that was read: whether each group lies inside the whole and each entry is `good`.
    template <class Good> [[nodiscard]] bool sound(Good&& good) const {
        return (begin_.empty() || (begin_.front() == 0 && std::is_sorted(begin_.begin(), begin_.end()) &&
                                   static_cast<std::size_t>(begin_.back()) == sorted_.size())) &&
               std::all_of(sorted_.begin(), sorted_.end(), good);
    }
    template <class Archive, As<Grouped> G> friend void carry(Archive& archive, G& grouped) {
        archive(grouped.sorted_, grouped.begin_); // the others are room
    }

private:
    std::vector<Entry> added_, sorted_;
    std::vector<int> begin_; // per key, one more at the end
    std::vector<int> next_;  // per key
};

} // namespace tumble::solver
