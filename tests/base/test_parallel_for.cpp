#include "base/parallel_for.h"

#include <array>
#include <atomic>
#include <doctest/doctest.h>
#include <stdexcept>
#include <vector>

namespace test_parallel_for {

using namespace tumble;

TEST_CASE("every number is taken exactly once, by crews of any size, round after round") {
    for (const int threads : {1, 2, 3, 5}) {
        Crew crew(threads);
        CHECK(crew.threads() == threads);
        for (const int n : {0, 1, 2, 7, 64, 1000}) {
            std::vector<std::atomic<int>> taken(static_cast<std::size_t>(n));
            for (int round = 0; round < 20; ++round)
                crew.share(n, [&](int k) { ++taken[static_cast<std::size_t>(k)]; });
            for (const auto& times : taken)
                CHECK(times == 20);
        }
    }
}

TEST_CASE("a helper that comes late from a round takes nothing of a larger one that follows") {
    Crew crew(4);
    std::vector<std::atomic<int>> taken(64);
    for (int round = 0; round < 5000; ++round) {
        const int n = 4 + 60 * (round % 2);
        crew.share(n, [&](int k) { ++taken[static_cast<std::size_t>(k)]; });
    }
    for (std::size_t k = 0; k < taken.size(); ++k)
        CHECK(taken[k] == (k < 4 ? 5000 : 2500));
}

TEST_CASE("what a task writes is there when share returns") {
    Crew crew(2);
    std::array<int, 100> squares{};
    crew.share(100, [&](int k) { squares[static_cast<std::size_t>(k)] = k * k; });
    int sum = 0;
    for (const int square : squares)
        sum += square;
    CHECK(sum == 99 * 100 * 199 / 6);
}

TEST_CASE("an exception in a task ends the round and reaches the caller, whichever thread threw; the crew works on") {
    for (const int threads : {1, 2, 3}) {
        Crew crew(threads);
        for (const int bad : {0, 13, 39}) {
            CHECK_THROWS_AS(crew.share(40,
                                       [&](int k) {
                                           if (k == bad)
                                               throw std::runtime_error("task");
                                       }),
                            std::runtime_error);
            std::atomic<int> done{0};
            crew.share(40, [&](int) { ++done; });
            CHECK(done == 40);
        }
    }
}

} // namespace test_parallel_for
