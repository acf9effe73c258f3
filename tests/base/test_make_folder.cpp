#include "base/make_folder.h"
#include "folder.h"

#include <doctest/doctest.h>

namespace test_make_folder {

using namespace tumble;
using namespace tumble::test;

TEST_CASE("a folder is made with those above it, may be there already, and where there is no place it is named") {
    const Folder folder;
    CHECK(make_folder(folder.path / "a/b").ok());
    CHECK(make_folder(folder.path / "a/b").ok());
    CHECK(std::filesystem::is_directory(folder.path / "a/b"));
    put(folder.path / "file", "x");
    const std::string move = "a file is in the way: move it, or name another place";
    const std::string elsewhere = "name a place in a folder that is there and where you may write";
    for (const auto& [place, fix] :
         {std::pair{folder.path / "file", move}, {folder.path / "file/below", move}, {"/proc/tumble", elsewhere}}) {
        const Problems problems = make_folder(place).problems();
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].file == place.string());
        CHECK(problems[0].what.starts_with("cannot be made: "));
        CHECK(problems[0].fix == fix);
    }
}

} // namespace test_make_folder
