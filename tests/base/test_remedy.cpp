#include "base/remedy.h"

#include <cerrno>
#include <doctest/doctest.h>
#include <string>

namespace test_remedy {

using tumble::remedy;

TEST_CASE("the remedy fits what the system said, and none is made up where only the system knows") {
    for (const int error : {ENOSPC, EDQUOT})
        CHECK(std::string(remedy(error)) == "free some space, or write to another disk");
    for (const int error : {ENOENT, EACCES, EPERM, EROFS})
        CHECK(std::string(remedy(error)) == "name a place in a folder that is there and where you may write");
    for (const int error : {ENOTDIR, EEXIST})
        CHECK(std::string(remedy(error)) == "a file is in the way: move it, or name another place");
    CHECK(std::string(remedy(EISDIR)) == "a folder has this name: name another place");
    for (const int error : {0, EIO, EBADF})
        CHECK(std::string(remedy(error)).empty());
}

} // namespace test_remedy
