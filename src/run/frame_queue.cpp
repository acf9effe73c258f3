#include "run/frame_queue.h"

namespace tumble::run {

namespace {
constexpr std::size_t most_waiting = 2;
}

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
        remember(sink->finish().problems());
}

void FrameQueue::hand_on(const Shot& shot) {
    for (const auto& sink : sinks_)
        if (const Result<Done> done = sink->take(shot); !done) {
            remember(done.problems());
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
