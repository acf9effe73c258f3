#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace tumble {

/// A fixed crew of threads that shares out the numbers 0..n-1. Which thread takes which number is open; callers get the
/// same bits for any crew by letting each number own its data. One caller at a time.
class Crew {
public:
    /// `threads` >= 1, the calling thread included.
    explicit Crew(int threads);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// Calls task(0) ... task(n-1) and returns when all have returned.
    void share(int n, const std::function<void(int)>& task);

    [[nodiscard]] int threads() const { return static_cast<int>(helpers_.size()) + 1; }

private:
    void work(std::uint64_t round);
    void help(int member);

    std::atomic<const std::function<void(int)>*> task_{nullptr};
    std::atomic<int> count_{0};
    std::atomic<std::uint64_t> round_{0};
    std::atomic<std::uint64_t> next_{0}; // low 32 bits: next number; high 32 bits: the round it belongs to
    std::atomic<int> done_{0};
    std::atomic<bool> stop_{false};
    std::vector<std::jthread> helpers_;
};

} // namespace tumble
