#include "base/archive.h"
#include "base/rng.h"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

namespace test_archive {

using namespace tumble;

namespace {

struct Spring {
    double length = 0;
    double energy = 0;
};

struct Contact {
    short sphere = 0; // padding follows
    double gap = 0;
};

struct Heap {
    std::int64_t step = 0;
    bool stale = false;
    double box[3] = {};
    std::string name;
    std::filesystem::path file;
    std::vector<Contact> contacts;
    std::vector<Spring> springs; // as many as contacts
    std::vector<std::uint8_t> touching;
    std::array<Spring, 3> last{};
    int last_count = 0;
    std::vector<std::vector<int>> lists;
};

struct Grown {
    double length = 0;
    double energy = 0;
    float fresh = 0;
};

template <class Archive, As<Spring> S> void carry(Archive& archive, S& spring) {
    auto& [length, energy] = spring;
    archive(length, energy);
}

template <class Archive, As<Contact> C> void carry(Archive& archive, C& contact) {
    auto& [sphere, gap] = contact;
    archive(sphere, gap);
}

template <class Archive, As<Grown> G> void carry(Archive& archive, G& grown) {
    auto& [length, energy, fresh] = grown;
    archive(length, energy, fresh);
}

template <class Archive, As<Heap> H> void carry(Archive& archive, H& heap) {
    auto& [step, stale, box, name, file, contacts, springs, touching, last, last_count, lists] = heap;
    archive(step, stale, box, name, file, contacts);
    archive(Sparse{springs, contacts.size()}, Part{touching, contacts.size()}, last_count);
    archive(Part{last, static_cast<std::size_t>(last_count)}, lists);
}

Heap full() {
    Heap heap;
    heap.step = -7;
    heap.stale = true;
    heap.box[1] = std::numeric_limits<double>::denorm_min();
    heap.name = "a name\0with a zero";
    heap.file = "out/a b";
    heap.contacts = {{3, 0.5}, {4, -0.0}, {5, 1e300}};
    heap.springs = {{}, {-0.0, 2}, {}};
    heap.touching = {0, 1, 0, 9, 9, 9}; // room behind the three
    heap.last = {Spring{1, 2}, Spring{3, 4}, Spring{5, 6}};
    heap.last_count = 2;
    heap.lists = {{1, 2, 3}, {}, {4}};
    return heap;
}

std::string written(const Heap& heap) {
    ArchiveWriter writer;
    writer(heap);
    return writer.take();
}

} // namespace

TEST_CASE("what is written reads back to the same bits, and only that") {
    const std::string bytes = written(full());
    Heap heap;
    ArchiveReader reader(bytes);
    reader(heap);
    CHECK(reader.whole());
    CHECK(heap.step == -7);
    CHECK(heap.stale);
    CHECK(heap.box[1] == std::numeric_limits<double>::denorm_min());
    CHECK(heap.file == "out/a b");
    REQUIRE(heap.contacts.size() == 3);
    CHECK(std::signbit(heap.contacts[1].gap));
    REQUIRE(heap.springs.size() == 3);
    CHECK(std::signbit(heap.springs[1].length)); // a zero with a sign is no zero bits
    CHECK(heap.springs[1].energy == 2);
    CHECK(heap.touching == std::vector<std::uint8_t>{0, 1, 0});
    CHECK(heap.last[1].energy == 4);
    CHECK(heap.last[2].energy == 0); // beyond the part
    CHECK(heap.lists == std::vector<std::vector<int>>{{1, 2, 3}, {}, {4}});
    CHECK(written(heap) == bytes);
}

TEST_CASE("zeros of a sparse vector take no room, and padding is not written") {
    Heap heap = full();
    const std::size_t three = written(heap).size();
    heap.contacts.resize(1000);
    heap.springs.resize(1000);
    heap.touching.resize(1000);
    // 997 more of a short, a double and a byte.
    CHECK(written(heap).size() == three + 997 * (2 + 8 + 1));
}

TEST_CASE("bytes that are cut off anywhere are no whole") {
    const std::string bytes = written(full());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Heap heap;
        ArchiveReader reader(std::string_view(bytes).substr(0, size));
        reader(heap);
        CHECK_MESSAGE(!reader.whole(), size);
    }
    Heap heap;
    const std::string longer = bytes + "x";
    ArchiveReader reader(longer);
    reader(heap);
    CHECK_FALSE(reader.whole());
}

TEST_CASE("a size that the bytes cannot fill asks for no memory") {
    ArchiveWriter writer;
    writer(std::numeric_limits<std::uint64_t>::max(), 1.0);
    std::vector<Contact> contacts;
    ArchiveReader reader(writer.bytes());
    reader(contacts);
    CHECK(contacts.empty());
    CHECK_FALSE(reader.whole());

    Heap heap = full();
    heap.last_count = 4; // of three
    ArchiveWriter too_many;
    too_many(heap.last_count);
    int count = 0;
    std::array<Spring, 3> last{};
    ArchiveReader part(too_many.bytes());
    part(count);
    part(Part{last, static_cast<std::size_t>(count)});
    CHECK_FALSE(part.whole());
}

TEST_CASE("the layout tells types apart and does not depend on values") {
    Heap empty, other = full();
    CHECK(archive_layout_of(empty) == archive_layout_of(other));
    Spring spring;
    Grown grown;
    Contact contact;
    CHECK(archive_layout_of(spring) != archive_layout_of(grown));
    CHECK(archive_layout_of(spring) != archive_layout_of(contact));
    std::vector<Spring> springs;
    std::vector<Grown> growns;
    CHECK(archive_layout_of(springs) != archive_layout_of(growns));
}

TEST_CASE("random numbers go on where they were") {
    Rng rng(5);
    rng.bits();
    ArchiveWriter writer;
    writer(rng);
    Rng again(1);
    ArchiveReader reader(writer.bytes());
    reader(again);
    REQUIRE(reader.whole());
    for (int k = 0; k < 10; ++k)
        CHECK(again.bits() == rng.bits());
}

} // namespace test_archive
