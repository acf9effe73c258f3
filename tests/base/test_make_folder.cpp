#include "base/make_folder.h"
#include "folder.h"

#include <doctest/doctest.h>

using namespace tumble;
using namespace tumble::test;

TEST_CASE("a folder is made with those above it, may be there already, and where there is no place it is named") {
    const Folder folder;
    CHECK(make_folder(folder.path / "a/b").ok());
    CHECK(make_folder(folder.path / "a/b").ok());
    CHECK(std::filesystem::is_directory(folder.path / "a/b"));
    put(folder.path / "file", "x");
    for (const std::filesystem::path& place :
         {folder.path / "file", folder.path / "file/below", std::filesystem::path("/proc/tumble")}) {
        const Problems problems = make_folder(place).problems();
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].file == place.string());
        CHECK(problems[0].what.starts_with("cannot be made: "));
        CHECK(problems[0].fix == "name a folder in a place where you may write");
    }
}
