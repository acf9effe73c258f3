#include "run/frame_queue.h"

#include <exception>

namespace tumble::run {

namespace {
constexpr std::size_t most_waiting = 2;

/// What a sink's work gives; an exception, as when memory runs out, becomes a problem, for nobody catches it on this
/// thread.
template <class Work> Problems problems_of(Work&& work) {
    try {
        return work().problems();
    } catch (const std::exception& error) {
        return {{.what = std::string("a frame could not be kept: ") + error.what(),
                 .fix = "keep fewer frames or smaller pictures, or free memory"}};
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
        lock.unlock();
        changed_.notify_all();
        if (well)
            hand_on(shot);
    }
    for (const auto& sink : sinks_)
        remember(problems_of([&] { return sink->finish(); }));
}

void FrameQueue::hand_on(const Shot& shot) {
    for (const auto& sink : sinks_)
        if (const Problems problems = problems_of([&] { return sink->take(shot); }); !problems.empty()) {
            remember(problems);
            return;
        }
    const std::lock_guard lock(mutex_);
    ++taken_;
}

void FrameQueue::remember(const Problems& more) {
    {
        const std::lock_guard lock(mutex_);
        problems_.insert(problems_.end(), more.begin(), more.end());
    }
    changed_.notify_all();
}

void FrameQueue::push(Shot shot) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.size() < most_waiting || !problems_.empty(); });
    if (!problems_.empty())
        return;
    waiting_.push_back(std::move(shot));
    lock.unlock();
    changed_.notify_all();
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
    if (thread_.joinable())
        thread_.join();
    return problems();
}

} // namespace tumble::run
