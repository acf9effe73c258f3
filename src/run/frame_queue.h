#pragma once

#include "run/frame_sink.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace tumble::run {

/// Hands frames to sinks on a thread of its own, so that drawing overlaps with stepping. At most two frames wait;
/// `push` then waits too. Every sink sees every frame, in order, so what is kept does not depend on how fast it goes.
class FrameQueue {
public:
    explicit FrameQueue(FrameSinks sinks);
    ~FrameQueue();
    FrameQueue(const FrameQueue&) = delete;
    FrameQueue& operator=(const FrameQueue&) = delete;

    /// After a problem in a sink further frames are dropped.
    void push(Shot shot);

    /// Waits until every sink has taken all that was pushed.
    void settle();

    /// What went wrong so far; empty while all is well.
    [[nodiscard]] Problems problems();

    /// Works off what waits, finishes the sinks, ends the thread. Problems: all there were.
    Problems close();

    /// Frames that every sink took for the first time.
    [[nodiscard]] std::int64_t taken();

    /// s of wall time that the sinks worked, and that push and close waited for them.
    [[nodiscard]] double worked_s();
    [[nodiscard]] double waited_s() const { return waited_s_; }

private:
    void serve();
    void hand_on(const Shot& shot);
    void remember(const Problems& more);
    void add_work(double seconds);

    FrameSinks sinks_; // touched by the thread only
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Shot> waiting_;
    Problems problems_;
    std::int64_t taken_ = 0;
    double worked_s_ = 0;
    double waited_s_ = 0; // touched by the caller only
    bool closing_ = false;
    bool at_work_ = false;
    std::jthread thread_;
};

} // namespace tumble::run
