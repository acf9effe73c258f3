#include "sim3d/kept_memory.h"

#include "sim3d/world.h"

namespace tumble::sim3d {

namespace {

KeptPair canonical(std::int64_t a, std::int64_t b, int sphere_a, int sphere_b, int image, const MemoryLanes& memory) {
    if (a < b)
        return {a, b, sphere_a, sphere_b, image, -1, memory};
    return {b, a, sphere_b, sphere_a, mirrored(image), -1, mirrored(memory)};
}

/// The image of b seen from a, after both were moved back into the box.
int image_after(int image, int a, int b, const std::vector<std::array<int, 3>>& wraps) {
    if (wraps.empty())
        return image;
    const auto& of_a = wraps[static_cast<std::size_t>(a)];
    const auto& of_b = wraps[static_cast<std::size_t>(b)];
    return image + (of_b[0] - of_a[0]) + 3 * (of_b[1] - of_a[1]) + 9 * (of_b[2] - of_a[2]);
}

} // namespace

void KeptMemory::take(const World& world, const std::vector<std::array<int, 3>>& wraps) {
    const auto keep_further = [&](const FurtherLanes& further) {
        further_.push_back(further);
        return static_cast<int>(further_.size()) - 1;
    };
    const auto keep = [&](int a, int b, int sphere_a, int sphere_b, int image, const MemoryLanes& memory,
                          const FurtherLanes* further) {
        const auto id_a = world.id[static_cast<std::size_t>(a)], id_b = world.id[static_cast<std::size_t>(b)];
        KeptPair kept = canonical(id_a, id_b, sphere_a, sphere_b, image_after(image, a, b, wraps), memory);
        if (further)
            kept.further = keep_further(id_a < id_b ? *further : mirrored(*further));
        pairs_.add(kept);
    };
    further_.clear();
    pairs_.begin_anew();
    walls_.begin_anew();
    for (const Chunk& chunk : world.chunks) {
        for (const NearSpheres& near : chunk.near_spheres)
            for (std::size_t k = 0; k < near.pairs.size(); ++k)
                if (near.touching[k] != 0)
                    keep(near.pairs[k].a, near.pairs[k].b, 0, 0, near.pairs[k].image, near.memory[k],
                         world.remembers_more ? &near.further[k] : nullptr);
        for (const BodyPair& pair : chunk.body_pairs)
            for (auto k = static_cast<std::size_t>(pair.begin); k < static_cast<std::size_t>(pair.begin + pair.count);
                 ++k)
                if (chunk.candidates.touching[k] != 0)
                    keep(pair.a, pair.b, chunk.candidates.spheres[k].a, chunk.candidates.spheres[k].b, pair.image,
                         chunk.candidates.memory[k], world.remembers_more ? &chunk.candidates.further[k] : nullptr);
        for (const BodyWall& near : chunk.body_walls)
            for (int k = near.begin; k < near.begin + near.count; ++k) {
                const WallCandidate& candidate = chunk.wall_candidates[static_cast<std::size_t>(k)];
                for (int t = 0; t < candidate.touches; ++t)
                    walls_.add(
                        {world.id[static_cast<std::size_t>(near.body)], near.wall, candidate.sphere,
                         world.remembers_more
                             ? keep_further(chunk.wall_further[static_cast<std::size_t>(max_wall_touches * k + t)])
                             : -1,
                         candidate.memory[static_cast<std::size_t>(t)]});
            }
    }
    const std::size_t ids = world.slot_of.size();
    pairs_.group(ids, [](const KeptPair& kept) { return kept.first; });
    walls_.group(ids, [](const KeptWall& kept) { return kept.body; });
}

std::span<const KeptWall> KeptMemory::of_wall(std::int64_t body) const {
    return walls_.of(static_cast<std::size_t>(body));
}

} // namespace tumble::sim3d
