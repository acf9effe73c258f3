#include "../folder.h"
#include "base/write_all.h"
#include "through.h"

#include <cerrno>
#include <doctest/doctest.h>
#include <fcntl.h>

namespace test_write_all {

using namespace tumble;
using namespace tumble::test;

namespace {

int calls = 0;

ssize_t three_at_most(int file, const void* bytes, std::size_t count) {
    if (++calls % 2 == 0) {
        errno = EINTR; // a signal came
        return -1;
    }
    return ::write(file, bytes, count < 3 ? count : 3);
}

ssize_t full_disk(int, const void*, std::size_t) {
    errno = ENOSPC;
    return -1;
}

ssize_t nothing(int, const void*, std::size_t) {
    return 0;
}

struct Written {
    int error = 0;
    std::string content;
};

Written through(decltype(DiskCalls::write) call) {
    const Folder folder;
    const std::filesystem::path path = folder.path / "file";
    const int file = ::open(path.c_str(), O_CREAT | O_WRONLY, 0600);
    REQUIRE(file >= 0);
    const Through given({.write = call});
    const int error = write_all(file, "ten bytes.");
    ::close(file);
    return {error, content_of(path)};
}

} // namespace

TEST_CASE("short writes and signals are gone on from, and what the system says comes back") {
    CHECK(through(&::write).content == "ten bytes.");
    const Written in_pieces = through(three_at_most);
    CHECK(in_pieces.error == 0);
    CHECK(in_pieces.content == "ten bytes.");
    CHECK(calls == 7); // four pieces, a signal after each of the first three
    CHECK(through(full_disk).error == ENOSPC);
    CHECK(through(nothing).error == EIO);
}

} // namespace test_write_all
