#include "base/parallel_for.h"

#include <fmt/format.h>
#include <system_error>
#include <utility>

namespace tumble {

namespace {

// A step shares work several times a millisecond; sleeping that often would cost more than the work. After about a
// millisecond of idling the helper sleeps.
constexpr int spins_before_sleep = 20000;

// A number that no part has.
constexpr std::uint64_t closed = 0xffffffffU;

void breathe() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

} // namespace

Crew::Crew(int threads) : parts_(static_cast<std::size_t>(threads)) {
    try {
        for (int member = 1; member < threads; ++member)
            helpers_.emplace_back([this, member] { help(member); });
    } catch (const std::system_error& refused) {
        dismiss();
        throw std::system_error(refused.code(),
                                fmt::format("only {} of {} threads could be started", helpers_.size() + 1, threads));
    } catch (...) {
        dismiss();
        throw;
    }
}

Crew::~Crew() {
    dismiss();
}

/// Without this the helpers would never end, and whoever joins them would wait for ever.
void Crew::dismiss() {
    stop_.store(true, std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
}

void Crew::call(int number) {
    try {
        (*task_.load(std::memory_order_relaxed))(number);
    } catch (...) {
        const std::lock_guard lock(thrown_mutex_);
        if (!thrown_)
            thrown_ = std::current_exception();
    }
}

void Crew::work(int member, std::uint64_t round) {
    const std::uint64_t tag = (round & 0xffffffffU) << 32;
    for (int turn = 0; turn < threads(); ++turn) {
        const int owner = (member + turn) % threads();
        std::atomic<std::uint64_t>& next = parts_[static_cast<std::size_t>(owner)].next;
        for (;;) {
            std::uint64_t ticket = next.load(std::memory_order_acquire);
            if ((ticket & ~0xffffffffULL) != tag)
                return;
            // Of a later round's count, share() has closed the part before, and the exchange below fails.
            if (static_cast<int>(ticket & 0xffffffffU) >=
                begin_of_part(owner + 1, count_.load(std::memory_order_acquire)))
                break;
            if (!next.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel))
                continue;
            call(static_cast<int>(ticket & 0xffffffffU));
            done_.fetch_add(1, std::memory_order_release);
        }
    }
}

void Crew::help(int member) {
    std::uint64_t seen = 0;
    for (;;) {
        int spins = 0;
        while (round_.load(std::memory_order_acquire) == seen) {
            if (++spins < spins_before_sleep)
                breathe();
            else
                round_.wait(seen, std::memory_order_acquire);
        }
        seen = round_.load(std::memory_order_acquire);
        if (stop_.load(std::memory_order_relaxed))
            return;
        work(member, seen);
    }
}

void Crew::share(int n, const std::function<void(int)>& task) {
    if (helpers_.empty() || n <= 1) {
        for (int k = 0; k < n; ++k)
            task(k);
        return;
    }
    const std::uint64_t round = round_.load(std::memory_order_relaxed) + 1;
    const std::uint64_t tag = (round & 0xffffffffU) << 32;
    // A helper may still look for numbers of the last round: no part gives any while count and task change.
    for (Part& part : parts_)
        part.next.store(tag | closed, std::memory_order_relaxed);
    task_.store(&task, std::memory_order_relaxed);
    done_.store(0, std::memory_order_relaxed);
    count_.store(n, std::memory_order_release);
    for (int member = 0; member < threads(); ++member)
        parts_[static_cast<std::size_t>(member)].next.store(tag | static_cast<std::uint64_t>(begin_of_part(member, n)),
                                                            std::memory_order_release);
    round_.store(round, std::memory_order_release);
    round_.notify_all();
    work(0, round);
    while (done_.load(std::memory_order_acquire) < n)
        breathe();
    if (thrown_)
        std::rethrow_exception(std::exchange(thrown_, nullptr));
}

} // namespace tumble
