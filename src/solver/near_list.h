#pragma once

#include "base/archive.h"
#include "solver/kernels.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace tumble::solver {

/// Those of a chunk's listed pairs that may touch before World::rush reaches Chunk::near_until, all of one pair of
/// materials.
template <class Memory, class Further> struct NearList {
    std::vector<NearPair> pairs; // in the order of the list of all
    std::vector<Memory> memory;
    std::vector<Further> further;       // parallel to them where World::remembers_more, else empty
    std::vector<std::uint8_t> touching; // 1 or 0, of the pairs; may be longer than they are
    std::vector<int> contacts;          // the first contact_count entries: those of pairs that touch now
    int contact_count = 0;

    void clear() {
        pairs.clear();
        memory.clear();
        further.clear();
        contact_count = 0;
    }
    /// `more` is null unless World::remembers_more.
    void add(const NearPair& pair, std::uint8_t touches, const Memory& remembered, const Further* more) {
        if (touching.size() <= pairs.size())
            touching.resize(2 * pairs.size() + 8);
        touching[pairs.size()] = touches;
        pairs.push_back(pair);
        memory.push_back(remembered);
        if (more)
            further.push_back(*more);
    }
};

template <class> inline constexpr bool is_near_list = false;
template <class Memory, class Further> inline constexpr bool is_near_list<NearList<Memory, Further>> = true;
template <class T>
concept AnyNearList = is_near_list<std::remove_const_t<T>>;

/// Makes the near lists of the listed pairs (`kind` of each: its materials) whose indices were found, in order; what a
/// pair remembers it keeps.
template <class Memory, class Further, class Listed>
void list_near(std::vector<NearList<Memory, Further>>& lists, const std::vector<Listed>& all,
               std::span<const int> found, bool remembers_more) {
    thread_local std::vector<NearList<Memory, Further>> old;
    thread_local std::vector<std::size_t> seen; // per material pair, how many of old
    old.resize(lists.size());
    std::swap(old, lists);
    seen.assign(old.size(), 0);
    for (auto& near : lists)
        near.clear();
    for (const int listed : found) {
        const Listed& pair = all[static_cast<std::size_t>(listed)];
        const auto kind = static_cast<std::size_t>(pair.kind);
        const auto& before = old[kind];
        std::size_t& k = seen[kind];
        while (k < before.pairs.size() && before.pairs[k].listed < listed)
            ++k;
        const bool known = k < before.pairs.size() && before.pairs[k].listed == listed;
        const Further nothing{};
        lists[kind].add({pair.a, pair.b, pair.image, listed}, known ? before.touching[k] : std::uint8_t{0},
                        known ? before.memory[k] : Memory{},
                        !remembers_more ? nullptr
                        : known         ? &before.further[k]
                                        : &nothing);
    }
}

// For checkpoints, base/archive.h.

template <class Archive, As<NearPair> P> void carry(Archive& archive, P& pair) {
    auto& [a, b, image, listed] = pair;
    archive(a, b, image, listed);
}

template <class Archive, AnyNearList N> void carry(Archive& archive, N& near) {
    auto& [pairs, memory, further, touching, contacts, contact_count] = near; // the last two are each step's own
    archive(pairs);
    archive(Sparse{memory, pairs.size()}, Part{touching, pairs.size()});
    carry_if_any(archive, further, pairs.size());
}

} // namespace tumble::solver
