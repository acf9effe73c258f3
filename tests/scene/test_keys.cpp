#include "scene/keys.h"
#include "scene/reference.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <set>
#include <sstream>

namespace test_keys {

using namespace tumble::scene;

TEST_CASE("every key has a sentence, a name of its own, and a default within its range") {
    for (const KeyTable& table : scene_keys()) {
        std::set<std::string> names;
        CHECK(!table.sentence.empty());
        for (const Key& key : table.keys) {
            CAPTURE(table.path);
            CAPTURE(key.name);
            for (const int dimension : {2, 3})
                if (belongs_in(key, dimension))
                    CHECK(names.insert(key.name + (dimension == 2 ? " in 2D" : " in 3D")).second);
            REQUIRE(!key.sentence.empty());
            CHECK(key.sentence.back() == '.');
            CHECK(!(key.required && !key.one_of.empty()));
            if (const double* standard = std::get_if<double>(&key.standard))
                CHECK(key.limits.hold(*standard));
            if (const auto* standard = std::get_if<std::int64_t>(&key.standard))
                CHECK(key.limits.hold(static_cast<double>(*standard)));
        }
    }
}

TEST_CASE("a key with a unit carries it in its name") {
    for (const KeyTable& table : scene_keys())
        for (const Key& key : table.keys) {
            CAPTURE(key.name);
            const bool has_unit = !key.unit.empty() && key.unit != "1/s" && key.type != KeyType::rows;
            if (has_unit)
                CHECK(key.name.find('_') != std::string::npos);
        }
}

TEST_CASE("kinds that keys are meant for exist") {
    for (const KeyTable& table : scene_keys())
        for (const Key& key : table.keys)
            for (const std::string& kind : key.only_for) {
                CAPTURE(key.name);
                const Key* chooser = find_key(table, table.kind_key, key.in == Dimensions::two ? 2 : 3);
                REQUIRE(chooser);
                CHECK(std::count(chooser->words.begin(), chooser->words.end(), kind) == 1);
            }
}

TEST_CASE("docs/scene_reference.md is what the list of keys says") {
    const std::string path = TUMBLE_ROOT "/docs/scene_reference.md";
    if (std::getenv("TUMBLE_WRITE_REFERENCE"))
        std::ofstream(path) << scene_reference();
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    CHECK_MESSAGE(text.str() == scene_reference(),
                  "the page is stale: run TUMBLE_WRITE_REFERENCE=1 test_scene -tc='docs/scene_reference*'");
}

} // namespace test_keys
