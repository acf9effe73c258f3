#include "base/parallel_for.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <dlfcn.h>
#include <doctest/doctest.h>
#include <limits>
#include <pthread.h>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace test_parallel_for {

using namespace tumble;

namespace {

constexpr int no_end = std::numeric_limits<int>::max();
std::atomic<int> threads_left{no_end}; // that the system still grants

} // namespace

/// Stands before the system's own, through which the standard library starts its threads.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* manner, void* (*work)(void*),
                              void* argument) noexcept {
    static const auto real = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
    if (threads_left == 0)
        return EAGAIN;
    --threads_left;
    return real(thread, manner, work, argument);
}

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

TEST_CASE("what a helper throws is thrown on to the caller as it was, and does not end the program") {
    Crew crew(2);
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> thrown{false};
    const auto task = [&](int) {
        if (std::this_thread::get_id() != caller) {
            thrown = true;
            throw std::runtime_error("on a helper");
        }
        while (!thrown) // so that the other number is left to the helper
            std::this_thread::yield();
    };
    CHECK_THROWS_WITH_AS(crew.share(2, task), "on a helper", std::runtime_error);
}

TEST_CASE("when every task throws, one exception reaches the caller and none waits for the next round") {
    Crew crew(3);
    for (int round = 0; round < 100; ++round) {
        CHECK_THROWS_AS(crew.share(9, [](int k) { throw std::runtime_error(std::to_string(k)); }), std::runtime_error);
        CHECK_NOTHROW(crew.share(9, [](int) {}));
    }
}

TEST_CASE("where the system grants fewer threads than asked for, that is said, and those that had begun end") {
    for (const int granted : {0, 1, 2}) {
        threads_left = granted;
        const std::string told =
            "only " + std::to_string(granted + 1) + " of 4 threads could be started: Resource temporarily unavailable";
        CHECK_THROWS_WITH_AS(Crew(4), told.c_str(), std::system_error);
        CHECK(threads_left == 0);
        threads_left = no_end;
    }
    std::atomic<int> done{0};
    Crew(4).share(10, [&](int) { ++done; });
    CHECK(done == 10);
}

} // namespace test_parallel_for
