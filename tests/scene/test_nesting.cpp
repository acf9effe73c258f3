#include "scene/nesting.h"
#include "scene/read_toml.h"

#include <doctest/doctest.h>
#include <string>

namespace test_nesting {

using namespace tumble::scene;

TEST_CASE("brackets, inline tables and dotted names count towards the depth") {
    CHECK(!too_deep_at("a = [[[1]]]\n[b.c.d]\ne = {f = {g = 1}}\n"));
    CHECK(too_deep_at("a = " + std::string(17, '[')));
    CHECK(!too_deep_at("a = " + std::string(16, '[')));
    std::string dotted = "a";
    for (int i = 0; i < 17; ++i)
        dotted += ".a";
    CHECK(too_deep_at(dotted + " = 1"));
    CHECK(too_deep_at("[" + dotted + "]"));
    CHECK(too_deep_at("x = {" + dotted + " = 1}"));
}

TEST_CASE("dots and brackets in text and comments do not count") {
    const std::string many = std::string(50, '[') + std::string(50, '.');
    CHECK(!too_deep_at("a = \"" + many + "\" # " + many + "\nb = '" + many + "'\nc = \"\"\"\n" + many +
                       "\"\"\"\nd = '''" + many + "'''\ne = \"\\\"" + many + "\"\n"));
    CHECK(
        !too_deep_at("a = [" + std::string("0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, "
                                           "1.6, 1.7, 1.8]")));
}

TEST_CASE("a name of half a million parts is refused before it is parsed") {
    std::string bomb;
    for (int i = 0; i < 500000; ++i)
        bomb += "a.";
    const auto root = parse_toml(bomb + "a = 1", "bomb.toml");
    REQUIRE(!root);
    CHECK(root.problems()[0].line == 1);
    CHECK(root.problems()[0].what == "nested more than 16 deep");
}

} // namespace test_nesting
