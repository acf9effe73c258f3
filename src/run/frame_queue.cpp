#include "run/frame_queue.h"

#include "base/thrown.h"

#include <chrono>

namespace tumble::run {

namespace {
using Clock = std::chrono::steady_clock;

constexpr std::size_t most_waiting = 2;

double since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// What a sink's work gives; an exception becomes a problem, for nobody catches it on this thread.
template <class Work> Problems problems_of(Work&& work) {
    try {
        return work().problems();
    } catch (const std::exception& error) {
        Problem problem = problem_of(error);
        problem.what = "a frame could not be kept: " + problem.what;
        return {problem};
    }
}

} // namespace

FrameQueue::FrameQueue(FrameSinks sinks) : sinks_(std::move(sinks)), thread_([this] { serve(); }) {}

FrameQueue::~FrameQueue() {
    close();
}

void FrameQueue::serve() {
    while (true) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return closing_ || !waiting_.empty(); });
        if (waiting_.empty())
            break;
        const Shot shot = std::move(waiting_.front());
        waiting_.pop_front();
        const bool well = problems_.empty();
        at_work_ = true;
        lock.unlock();
        changed_.notify_all();
        const Clock::time_point begun = Clock::now();
        if (well)
            hand_on(shot);
        add_work(since(begun));
        lock.lock();
        at_work_ = false;
        lock.unlock();
        changed_.notify_all();
    }
    const Clock::time_point begun = Clock::now();
    for (const auto& sink : sinks_)
        remember(problems_of([&] { return sink->finish(); }));
    add_work(since(begun));
}

void FrameQueue::hand_on(const Shot& shot) {
    for (const auto& sink : sinks_) {
        if (const Problems problems = problems_of([&] { return sink->take(shot); }); !problems.empty()) {
            remember(problems);
            return;
        }
    }
    const std::lock_guard lock(mutex_);
    taken_ += shot.again ? 0 : 1;
}

void FrameQueue::remember(const Problems& more) {
    {
        const std::lock_guard lock(mutex_);
        problems_.insert(problems_.end(), more.begin(), more.end());
    }
    changed_.notify_all();
}

void FrameQueue::add_work(double seconds) {
    const std::lock_guard lock(mutex_);
    worked_s_ += seconds;
}

double FrameQueue::worked_s() {
    const std::lock_guard lock(mutex_);
    return worked_s_;
}

void FrameQueue::push(Shot shot) {
    const Clock::time_point begun = Clock::now();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.size() < most_waiting || !problems_.empty(); });
    waited_s_ += since(begun);
    if (!problems_.empty())
        return;
    waiting_.push_back(std::move(shot));
    lock.unlock();
    changed_.notify_all();
}

void FrameQueue::settle() {
    const Clock::time_point begun = Clock::now();
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.empty() && !at_work_; });
    waited_s_ += since(begun);
}

Problems FrameQueue::problems() {
    const std::lock_guard lock(mutex_);
    return problems_;
}

std::int64_t FrameQueue::taken() {
    const std::lock_guard lock(mutex_);
    return taken_;
}

Problems FrameQueue::close() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
    const Clock::time_point begun = Clock::now();
    if (thread_.joinable())
        thread_.join();
    waited_s_ += since(begun);
    return problems();
}

} // namespace tumble::run
