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

TEST_CASE("an error's interval ends where the data would just bear that ratio of two means") {
    // Fieller: a ratio R is borne while (m - R m_ref)^2 <= t^2 (s^2 / n + R^2 s_ref^2 / n). Deviations of
    // 0.2 / sqrt(2) each, pooled over two rungs of two seeds: two degrees of freedom.
    const Prices prices = price({sample({1.0, 1.2}, 8), sample({1.5, 1.7}, 2)}, 0, 0.1);
    const Error& error = prices.rungs[1].errors[0];
    CHECK(error.relative == about(0.5 / 1.1, 1e-12));
    const double end = 1 + error.relative + error.uncertainty;
    CHECK(std::pow(1.6 - end * 1.1, 2) == about(4.30265 * 4.30265 * (0.01 + end * end * 0.01), 1e-4));
    CHECK_FALSE(error.told_apart());
    CHECK(prices.rungs[1].verdict == Verdict::seems_beyond);
    CHECK(prices.rungs[1].speed_up == 4);
    CHECK_FALSE(prices.cheapest);
}

TEST_CASE("from four seeds on a rung is as uncertain as it scatters itself, whatever the others do") {
    // The reference as good as still: means of variance s^2 / 4, three degrees of freedom.
    const Prices prices =
        price({sample({1, 1, 1, 1}, 8), sample({0.99, 1.01, 0.99, 1.01}, 4), sample({0.8, 1.2, 0.8, 1.2}, 2)}, 0, 0.1);
    const auto scatter = [](double half) { return half * std::sqrt(4.0 / 3); };
    CHECK(prices.rungs[1].errors[0].uncertainty == about(3.18245 * scatter(0.01) / 2, 1e-5));
    CHECK(prices.rungs[2].errors[0].uncertainty == about(3.18245 * scatter(0.2) / 2, 1e-5));
    CHECK(prices.rungs[1].verdict == Verdict::within);
    CHECK(prices.rungs[2].verdict == Verdict::seems_within);
}

TEST_CASE("fewer seeds have the scatter of all, or their own where it is larger, and make sure of nothing") {
    const Prices prices = price({sample({1, 1}, 8), sample({1, 1}, 4), sample({0.95, 1.05}, 2)}, 0, 0.5);
    // Pooled variance 0.005 / 3 of three degrees for reference and first rung.
    const double end = 1 + prices.rungs[1].errors[0].uncertainty, mean = 0.005 / 3 / 2;
    CHECK(std::pow(1 - end, 2) == about(3.18245 * 3.18245 * mean * (1 + end * end), 1e-4));
    // The second has 0.005 of one degree: (0.0025 + mean)^2 / (0.0025^2 + mean^2 / 3) = 1.7, and t that of one.
    const double far = 1 + prices.rungs[2].errors[0].uncertainty;
    CHECK(std::pow(1 - far, 2) == about(12.7062 * 12.7062 * (0.0025 + far * far * mean), 1e-4));
    CHECK(prices.rungs[1].verdict == Verdict::seems_within);
}

TEST_CASE("the fastest of those that are surely within is taken before a faster one that only seems to be") {
    // A thousandth of scatter: 5 % is within 10 % and told apart from nothing, 20 % is beyond.
    const auto four = [](double about, double core_s) {
        return sample({about, about + 0.001, about, about + 0.001}, core_s);
    };
    const Prices prices =
        price({four(1, 8), four(1.05, 4), four(1.04, 2), four(1.2, 1), sample({0.6, 1.4, 0.6, 1.4}, 0.5)}, 0, 0.1);
    CHECK(prices.rungs[1].verdict == Verdict::within);
    CHECK(prices.rungs[1].errors[0].told_apart());
    CHECK(prices.rungs[3].verdict == Verdict::beyond);
    CHECK(prices.rungs[4].verdict == Verdict::seems_within);
    CHECK(*prices.cheapest == 2);
    CHECK(prices.rungs[2].worst == about(0.04, 1e-2));
    const Prices alone = price({four(1, 8), sample({0.6, 1.4, 0.6, 1.4}, 0.5)}, 0, 0.1);
    CHECK(*alone.cheapest == 1); // seems to be: for want of a better one
}

TEST_CASE("what the reference does not have, or has not told apart from zero, makes nobody within") {
    const double none = std::nan("");
    const Prices lost = price({sample({none, 1}, 8), sample({5, 5}, 4)}, 0, 0.1);
    CHECK_FALSE(lost.judged[0]);
    CHECK_FALSE(lost.cheapest); // nothing was judged, so that nothing is known to be within
    CHECK(lost.rungs[1].verdict == Verdict::not_judged);
    const Prices about_zero = price({sample({-1, 1.1}, 8), sample({1, 0.8}, 4)}, 0, 0.1);
    CHECK_FALSE(about_zero.judged[0]);
    CHECK(about_zero.rungs[1].verdict == Verdict::not_judged);
}

TEST_CASE("a rung that surely has what the reference hardly has is beyond") {
    // The reference: 0 +- 3.18245 x 0.1155 / 2 = 0.184. The rung: 2, as good as still, so that the two differ by at
    // least 2 - 0.184, which is 9.9 times the most that the reference may have.
    const Prices prices = price({sample({-0.1, 0.1, -0.1, 0.1}, 8), sample({2, 2, 2, 2}, 4)}, 0, 0.1);
    CHECK_FALSE(prices.judged[0]);
    const double most = 3.18245 * 0.1 * std::sqrt(4.0 / 3) / 2;
    CHECK(prices.rungs[1].errors[0].at_least == about((2 - most) / most, 1e-5));
    CHECK(prices.rungs[1].verdict == Verdict::beyond);
    CHECK_FALSE(prices.cheapest);
}

TEST_CASE("a rung that has lost what the reference has is beyond, or seems to be where only some seeds have") {
    const double none = std::nan("");
    const Prices prices = price({sample({1, 1}, 8), sample({none, none}, 4), sample({1, none}, 4)}, 0, 0.1);
    CHECK(prices.rungs[1].verdict == Verdict::beyond);
    CHECK(prices.rungs[2].verdict == Verdict::seems_beyond);
    CHECK_FALSE(prices.cheapest);
    CHECK_FALSE(prices.rungs[1].errors[0].told_apart());
}

} // namespace test_price
