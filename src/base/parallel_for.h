#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tumble {

/// A fixed crew of threads that shares out the numbers 0..n-1: each takes its own part in order, round after round the
/// same, so that what belongs to a number stays in one core's cache, and then helps the others. Which thread takes
/// which number is open all the same; callers get the same bits for any crew by letting each number own its data. One
/// caller at a time.
class Crew {
public:
    /// `threads` >= 1, the calling thread included. Throws std::system_error where the system refuses one of them.
    explicit Crew(int threads);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// Calls task(0) ... task(n-1) and returns when all have returned. An exception of a task is thrown on here,
    /// whichever thread it was on.
    void share(int n, const std::function<void(int)>& task);

    [[nodiscard]] int threads() const { return static_cast<int>(parts_.size()); }

private:
    /// Numbers of one member's part that are not taken yet.
    struct alignas(64) Part {
        std::atomic<std::uint64_t> next{0}; // low 32 bits: next number; high 32 bits: the round it belongs to
    };

    void dismiss();
    void call(int number);
    void work(int member, std::uint64_t round);
    void help(int member);
    [[nodiscard]] int begin_of_part(int member, int n) const {
        return static_cast<int>(std::int64_t{n} * member / threads());
    }

    std::atomic<const std::function<void(int)>*> task_{nullptr};
    std::atomic<int> count_{0};
    std::atomic<std::uint64_t> round_{0};
    std::vector<Part> parts_; // one per member
    std::atomic<int> done_{0};
    std::atomic<bool> stop_{false};
    std::mutex thrown_mutex_;
    std::exception_ptr thrown_;
    std::vector<std::jthread> helpers_;
};

} // namespace tumble
