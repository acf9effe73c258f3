#include "base/hash.h"

#include <doctest/doctest.h>

namespace test_hash {

using namespace tumble;

TEST_CASE("the hash gives the published values of FNV-1a") {
    CHECK(Hash64{}.value() == 0xcbf29ce484222325u);
    CHECK(Hash64{}.add("a").value() == 0xaf63dc4c8601ec8cu);
    CHECK(Hash64{}.add("foobar").value() == 0x85944171f73967e8u);
    CHECK(Hash64{}.add("foobar").hex() == "85944171f73967e8");
}

TEST_CASE("how the bytes are cut does not matter") {
    CHECK(Hash64{}.add("foo").add("").add("bar").value() == Hash64{}.add("foobar").value());
}

TEST_CASE("numbers are hashed as eight bytes, lowest first, whatever their type") {
    const std::string_view one("\x01\0\0\0\0\0\0\0", 8), minus_one("\xff\xff\xff\xff\xff\xff\xff\xff", 8);
    CHECK(Hash64{}.add(1).value() == Hash64{}.add(one).value());
    CHECK(Hash64{}.add(std::int64_t{1}).value() == Hash64{}.add(std::uint8_t{1}).value());
    CHECK(Hash64{}.add(-1).value() == Hash64{}.add(minus_one).value());
    CHECK(Hash64{}.add(1.0).value() == Hash64{}.add(std::string_view("\0\0\0\0\0\0\xf0\x3f", 8)).value());
}

TEST_CASE("one bit changes the hash") {
    CHECK(Hash64{}.add(0.0).value() != Hash64{}.add(-0.0).value());
    CHECK(Hash64{}.add(1).add(2).value() != Hash64{}.add(2).add(1).value());
}

} // namespace test_hash
