#include "run/schedule.h"

#include <doctest/doctest.h>

namespace test_schedule {

using tumble::run::Schedule;

TEST_CASE("events stand at the steps nearest to exact multiples, also after a million of them") {
    Schedule schedule(0.04, 1.0 / 350000); // 14000 steps
    schedule.pass(13999);
    CHECK(schedule.next() == 14000);
    schedule.pass(14000LL * 1000000);
    CHECK(schedule.next() == 14000LL * 1000001);
    Schedule uneven(0.001, 3e-4); // 3.33 steps: 0, 3, 7, 10, 13, ...
    for (const std::int64_t step : {0, 3, 7, 10, 13, 17, 20}) {
        CHECK(uneven.next() == step);
        CHECK(uneven.due(step));
        uneven.pass(step);
        CHECK_FALSE(uneven.due(step));
    }
}

TEST_CASE("events closer together than steps fall on every step") {
    Schedule schedule(1e-6, 1e-5);
    for (const std::int64_t step : {0, 1, 2, 3}) {
        CHECK(schedule.next() == step);
        schedule.pass(step);
    }
    CHECK(Schedule(1e-6, 1e-5).count(100) == 101);
}

TEST_CASE("the count is what passing them one by one gives") {
    for (const double every : {1e-5, 3.3e-5, 0.001, 0.0123})
        for (const std::int64_t last : {0, 1, 99, 1000, 12345}) {
            Schedule schedule(every, 1e-5);
            std::int64_t seen = 0;
            for (; schedule.next() <= last; schedule.pass(schedule.next()))
                ++seen;
            CHECK(Schedule(every, 1e-5).count(last) == seen);
        }
}

TEST_CASE("the last step counts once more only where no event falls on it") {
    CHECK(Schedule(0.001, 1e-5).count_with_last(1000) == 11);
    CHECK(Schedule(0.001, 1e-5).count_with_last(1050) == 12);
    CHECK(Schedule(1e-6, 1e-5).count_with_last(100) == 101);
    CHECK(Schedule(1, 1e-5).count_with_last(0) == 1);
}

} // namespace test_schedule
