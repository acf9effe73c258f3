#include "base/rng.h"

#include <cmath>
#include <doctest/doctest.h>

namespace test_rng {

using namespace tumble;

TEST_CASE("the same seed gives the same numbers, another seed others") {
    Rng one(7);
    Rng same(7);
    Rng other(8);
    int equal_to_other = 0;
    for (int k = 0; k < 1000; ++k) {
        const std::uint64_t bits = one.bits();
        CHECK(bits == same.bits());
        equal_to_other += bits == other.bits();
    }
    CHECK(equal_to_other == 0);
}

TEST_CASE("uniform numbers stay below 1 and have the mean and the variance of a uniform distribution") {
    Rng rng(1);
    constexpr int n = 200000;
    double sum = 0;
    double squares = 0;
    for (int k = 0; k < n; ++k) {
        const double x = rng.uniform(-2, 4);
        REQUIRE(x >= -2);
        REQUIRE(x < 4);
        sum += x;
        squares += x * x;
    }
    const double mean = sum / n;
    const double variance = squares / n - mean * mean;
    // Five standard errors: 6/sqrt(12 n) of the mean, 36 sqrt(1/180 n) of the variance.
    CHECK(std::abs(mean - 1) < 5 * 6 / std::sqrt(12.0 * n));
    CHECK(std::abs(variance - 3) < 5 * 36 / std::sqrt(180.0 * n));
}

TEST_CASE("the first numbers of xoshiro256++ seeded by splitmix64 are those of the published algorithms") {
    // splitmix64 from 0 gives e220a8397b1dcdaf, 6e789e6aa1b965f4, 06c45d188009454f, f88bb8a8724c81ec (Vigna's test
    // values); xoshiro256++ answers first with rotl(s0 + s3, 23) + s0.
    constexpr std::uint64_t s0 = 0xe220a8397b1dcdafULL;
    constexpr std::uint64_t s3 = 0xf88bb8a8724c81ecULL;
    constexpr std::uint64_t sum = s0 + s3;
    CHECK(Rng(0).bits() == ((sum << 23 | sum >> 41) + s0));
}

} // namespace test_rng
