#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace tumble::solver {

/// Room for at least `entries`; more than asked for, so that a list that grows is seldom moved.
template <class Entry> void make_room(std::vector<Entry>& list, std::size_t entries) {
    if (list.size() < entries)
        list.resize(2 * entries);
}

/// The k-th value becomes what stood at order[k].
template <class Array> void reorder(Array& values, const std::vector<int>& order) {
    thread_local Array sorted; // fresh memory costs more than moving what it is for
    sorted.resize(values.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        sorted[k] = values[static_cast<std::size_t>(order[k])];
    std::swap(values, sorted);
}

} // namespace tumble::solver
