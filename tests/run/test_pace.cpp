#include "about.h"
#include "run/pace.h"

#include <thread>

namespace test_pace {

using tumble::run::Pace;
using tumble::run::SteadyRate;
using tumble::test::about;

TEST_CASE("the time left is said after two seconds, and is then the mean's") {
    SteadyRate rate;
    rate.add(1000, 1.5);
    CHECK(!rate.seconds_for(1000));
    rate.add(500, 1.5);
    REQUIRE(rate.seconds_for(1000));
    CHECK(*rate.seconds_for(1000) == about(2)); // 1500 in 3 s
}

TEST_CASE("what is slow every second hardly moves the time left") {
    SteadyRate rate;
    for (int k = 0; k < 600; ++k) { // 100 steps in a tenth of a second, a tenth of a second lost every second
        const bool frame = k % 10 == 9;
        rate.add(100, frame ? 0.2 : 0.1);
        if (k < 100)
            continue;
        // 1000 steps take 1.1 s; in ten seconds' memory a tenth that is lost weighs a hundredth.
        CHECK(*rate.seconds_for(1e4) == about(11, 0.012));
    }
}

TEST_CASE("a rate that changes for good is followed within the memory of the last quarter") {
    SteadyRate rate;
    for (int k = 0; k < 400; ++k)
        rate.add(100, 0.1); // 1000/s for 40 s: ten seconds are remembered
    for (int k = 0; k < 400; ++k)
        rate.add(50, 0.1); // half of it for as long
    // Memory grows from 10 s at 40 s to 20 s at 80 s as t / 4: what is left of the old rate is (40 / 80)^4.
    CHECK(*rate.seconds_for(1000) == about(1000 / (500 + 500.0 / 16), 0.01));
}

TEST_CASE("a round longer than the memory counts as all that is remembered, and no more") {
    SteadyRate one;
    one.add(3000, 30); // ten seconds are remembered
    CHECK(*one.seconds_for(1000) == about(10));
    SteadyRate stalled;
    for (int k = 0; k < 200; ++k)
        stalled.add(100, 0.1); // 1000/s for 20 s
    stalled.add(100, 30);      // of 50 s a quarter is remembered, 12.5 s
    REQUIRE(stalled.seconds_for(1000));
    CHECK(*stalled.seconds_for(1000) == about(300)); // 100 in 30 s
}

TEST_CASE("the pace counts from the first start: what goes before it is no time of steps") {
    const auto rest = [] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); };
    Pace pace;
    rest();
    pace.start();
    rest();
    pace.stop(1000);
    // However long the rests were: the first round lasts as long as its steps.
    CHECK(pace.steps_per_s() == about(1000 / pace.seconds()));
    CHECK(pace.since_made() > pace.seconds());
}

} // namespace test_pace
