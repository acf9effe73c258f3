#include "run/frame_queue.h"

#include <atomic>
#include <chrono>
#include <doctest/doctest.h>
#include <new>
#include <thread>

namespace test_frame_queue {

using namespace tumble;

namespace {

struct Seen {
    std::vector<std::int64_t> numbers;
    std::atomic<int> most_waiting{0};
    std::atomic<int> given{0};
    bool finished = false;
};

class SlowSink final : public run::FrameSink {
public:
    SlowSink(Seen& seen, std::int64_t breaks_at) : seen_(seen), breaks_at_(breaks_at) {}
    Result<Done> take(const run::Shot& shot) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        seen_.most_waiting = std::max(seen_.most_waiting.load(), seen_.given - static_cast<int>(shot.number));
        if (shot.number == breaks_at_)
            return Problem{.what = "the disk is full"};
        seen_.numbers.push_back(shot.number);
        return Done{};
    }
    Result<Done> finish() override {
        seen_.finished = true;
        return Done{};
    }

private:
    Seen& seen_;
    std::int64_t breaks_at_;
};

run::FrameSinks slow(Seen& seen, std::int64_t breaks_at = -1) {
    run::FrameSinks sinks;
    sinks.push_back(std::make_unique<SlowSink>(seen, breaks_at));
    return sinks;
}

class ThrowingSink final : public run::FrameSink {
public:
    Result<Done> take(const run::Shot&) override { throw std::bad_alloc(); }
    Result<Done> finish() override { throw std::bad_alloc(); }
};

} // namespace

TEST_CASE("every frame arrives once and in order, and no more than a few wait") {
    Seen seen;
    run::FrameQueue queue(slow(seen));
    for (std::int64_t i = 0; i < 30; ++i) {
        run::Shot shot;
        shot.number = i;
        queue.push(std::move(shot));
        ++seen.given;
    }
    CHECK(queue.close().empty());
    CHECK(seen.finished);
    CHECK(queue.taken() == 30);
    REQUIRE(seen.numbers.size() == 30);
    for (std::int64_t i = 0; i < 30; ++i)
        CHECK(seen.numbers[static_cast<std::size_t>(i)] == i);
    CHECK(seen.most_waiting <= 4); // the one being taken, two in the queue, one just pushed
}

TEST_CASE("after a problem frames are dropped, nothing blocks, and the problem comes back") {
    Seen seen;
    run::FrameQueue queue(slow(seen, 3));
    for (std::int64_t i = 0; i < 50; ++i) {
        run::Shot shot;
        shot.number = i;
        queue.push(std::move(shot));
    }
    const Problems problems = queue.close();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].what == "the disk is full");
    CHECK(queue.taken() == 3);
    CHECK(seen.finished);
}

TEST_CASE("an exception in a sink, as when memory runs out, becomes a problem and ends nothing else") {
    run::FrameSinks sinks;
    sinks.push_back(std::make_unique<ThrowingSink>());
    run::FrameQueue queue(std::move(sinks));
    queue.push({});
    const Problems problems = queue.close();
    REQUIRE(problems.size() == 2);
    CHECK(problems[0].what == "a frame could not be kept: there is not enough memory");
    CHECK(problems[1].what == problems[0].what);
}

} // namespace test_frame_queue
