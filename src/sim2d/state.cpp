#include "sim2d/state.h"

#include "base/archive.h"
#include "sim2d/state_flaw.h"
#include "sim2d/state_members.h"

namespace tumble::sim2d {

namespace {

/// What does not follow from the members that were read one by one.
void complete(World& world) {
    std::vector<int> slot_of(world.id.size());
    for (std::size_t slot = 0; slot < world.id.size(); ++slot)
        slot_of[static_cast<std::size_t>(world.id[slot])] = static_cast<int>(slot);
    for (const int slot : slot_of) {
        world.first_tag.push_back(world.tags);
        world.tags += world.shape_at(slot).exposed_count;
    }
    for (Chunk& chunk : world.chunks) {
        chunk.wall_contacts.resize(world.pairs.size());
    }
}

Problem unusable(const World& world, const std::string& what) {
    return {.file = world.scene.file.string(), .what = what, .fix = "go on from another state, or run the scene again"};
}

} // namespace

std::string state_of(const World& world) {
    ArchiveWriter writer;
    writer(archive_layout_of(world), world);
    return writer.take();
}

std::optional<Problem> restore(World& world, std::string_view state) {
    std::uint64_t layout = 0;
    ArchiveReader reader(state);
    reader(layout);
    if (layout != archive_layout_of(world))
        return unusable(world, "the state was saved by another version of the program or by the other solver");
    reader(world);
    if (!reader.whole())
        return unusable(world, "the saved state does not fit the scene: it has other walls or fills, or is damaged");
    if (const std::string flaw = flaw_of(world); !flaw.empty())
        return unusable(world, "the saved state does not fit the scene: " + flaw);
    complete(world);
    return std::nullopt;
}

} // namespace tumble::sim2d
