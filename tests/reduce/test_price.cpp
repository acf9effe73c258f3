#include "about.h"
#include "reduce/price.h"

#include <cmath>
#include <doctest/doctest.h>

namespace test_price {

using namespace tumble;
using namespace tumble::reduce;
using tumble::test::about;

namespace {

/// One quantity, a value a seed.
Sample sample(std::vector<double> values, double core_s) {
    Sample made;
    made.core_s = core_s;
    for (const double value : values)
        made.values.push_back({value});
    return made;
}

} // namespace

TEST_CASE("Student's t bounds 95 % where the tables say") {
    CHECK(student_t_95(1) == about(12.7062, 1e-5));
    CHECK(student_t_95(2) == about(4.30265, 1e-5));
    CHECK(student_t_95(3) == about(3.18245, 1e-5));
    CHECK(student_t_95(10) == about(2.22814, 1e-5));
    CHECK(student_t_95(60) == about(2.00030, 1e-5));
}

TEST_CASE("an error's uncertainty is t of all seeds times what the difference of two means scatters by") {
    // Deviations of 0.2 / sqrt(2) each, pooled over two rungs of two seeds: two degrees of freedom.
    const Prices prices = price({sample({1.0, 1.2}, 8), sample({1.5, 1.7}, 2)}, 0, 0.1);
    const Error& error = prices.rungs[1].errors[0];
    CHECK(error.relative == about(0.5 / 1.1, 1e-12));
    CHECK(error.uncertainty == about(4.30265 * std::sqrt(0.02 / 2 + 0.02 / 2) / 1.1, 1e-5));
    CHECK_FALSE(error.told_apart());
    CHECK(prices.rungs[1].verdict == Verdict::seems_beyond);
    CHECK(prices.rungs[1].speed_up == 4);
    CHECK_FALSE(prices.cheapest);
}

TEST_CASE("a rung that scatters more than the others is as uncertain as it scatters") {
    const Prices prices = price({sample({1, 1}, 8), sample({1, 1}, 4), sample({0.6, 1.4}, 2)}, 0, 0.1);
    CHECK(std::abs(prices.rungs[2].errors[0].relative) < 1e-12); // (0.6 + 1.4) / 2 against 1
    // Pooled variance 0.32 / 3 for the reference, its own 0.32 for the rung; three degrees of freedom.
    CHECK(prices.rungs[2].errors[0].uncertainty == about(3.18245 * std::sqrt(0.32 / 3 / 2 + 0.32 / 2), 1e-5));
    CHECK(prices.rungs[2].verdict == Verdict::seems_within);
}

TEST_CASE("the fastest of those that are surely within is taken before a faster one that only seems to be") {
    // A thousandth of scatter: 5 % is within 10 % and told apart from nothing, 20 % is beyond.
    const Prices prices = price({sample({1, 1.001}, 8), sample({1.05, 1.051}, 4), sample({1.04, 1.041}, 2),
                                 sample({1.2, 1.201}, 1), sample({0.6, 1.4}, 0.5)},
                                0, 0.1);
    CHECK(prices.rungs[1].verdict == Verdict::seems_within); // one rung's scatter makes all uncertain
    const Prices calm = price(
        {sample({1, 1.001}, 8), sample({1.05, 1.051}, 4), sample({1.04, 1.041}, 2), sample({1.2, 1.201}, 1)}, 0, 0.1);
    CHECK(calm.rungs[1].verdict == Verdict::within);
    CHECK(calm.rungs[1].errors[0].told_apart());
    CHECK(calm.rungs[3].verdict == Verdict::beyond);
    CHECK(*calm.cheapest == 2);
    CHECK(calm.rungs[2].worst == about(0.04, 1e-2));
}

TEST_CASE("what the reference does not have, or has not told apart from zero, judges nobody") {
    const double none = std::nan("");
    const Prices lost = price({sample({none, 1}, 8), sample({5, 5}, 4)}, 0, 0.1);
    CHECK_FALSE(lost.judged[0]);
    CHECK_FALSE(lost.cheapest); // nothing was judged, so that nothing is known to be within
    const Prices about_zero = price({sample({-1, 1.1}, 8), sample({5, 5}, 4)}, 0, 0.1);
    CHECK_FALSE(about_zero.judged[0]);
}

TEST_CASE("a rung that has lost what the reference has is beyond") {
    const Prices prices = price({sample({1, 1}, 8), sample({1, std::nan("")}, 4)}, 0, 0.1);
    CHECK(prices.rungs[1].verdict == Verdict::beyond);
    CHECK_FALSE(prices.rungs[1].errors[0].told_apart());
}

} // namespace test_price
