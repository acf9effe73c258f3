#include "view/still.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace tumble::view {

namespace {

constexpr std::chrono::milliseconds between_looks{2};

/// Why the source goes no further.
Result<Done> check_on(Source& source, StopFlag stop) {
    if (stop_wanted(stop))
        return Problem{.what = "stopped before the picture was drawn", .fix = "nothing was written"};
    if (const SourceState state = source.state(); !state.trouble.empty())
        return Problem{.what = state.trouble, .fix = "take an earlier time with --time :B"};
    return Done{};
}

Result<Done> see(Studio& studio) {
    const Result<Shown> shown = studio.draw();
    return shown ? Result<Done>(Done{}) : shown.problems();
}

void tell(const StillWishes& wishes, double time) {
    if (wishes.reached)
        wishes.reached(time);
}

/// As a hand does it, which then goes out of the way: what lies under a pointer tells its key.
Result<Done> open_tab(Studio& studio, const std::string& tab) {
    const Result<Shown> shown = studio.draw();
    if (!shown)
        return shown.problems();
    const auto state = nlohmann::json::parse(shown->state);
    const auto place = state["places"].find("tab " + tab);
    if (!state["panel"].get<bool>() || place == state["places"].end())
        return Problem{.what = fmt::format("the panel shows no tab '{}'", tab),
                       .fix = "take Plots, Change, Look or Keep, and a window that is not too small: --size 1280x720"};
    const auto [left, top, right, bottom] = place->get<std::array<double, 4>>();
    const double x = 0.5 * (left + right), y = 0.5 * (top + bottom);
    studio.take(PointerMoved{x, y});
    studio.take(PointerPressed{0, x, y});
    studio.take(PointerReleased{0, x, y});
    studio.take(PointerMoved{0, 0});
    return see(studio);
}

/// Frame by frame, so that a trail passes none over.
Result<Done> go_through_run(Studio& studio, const Stretch& seen, const StillWishes& wishes, StopFlag stop) {
    Source& source = studio.source();
    while (true) {
        if (Result<Done> drawn = see(studio); !drawn)
            return drawn;
        const SourceState state = source.state();
        tell(wishes, state.time);
        const Result<Done> goes = check_on(source, stop);
        if (!goes || state.ended || state.time >= seen.to)
            return goes;
        source.step(1);
    }
}

Result<Done> simulate(Studio& studio, const Stretch& shown, const StillWishes& wishes, StopFlag stop) {
    Source& source = studio.source();
    const auto steps_to = [&](double time) { return std::llround(std::min(time, shown.to) / wishes.step); };
    for (std::int64_t shot = 0;; ++shot) {
        const double time = shown.from + static_cast<double>(shot) * wishes.every;
        const std::int64_t target = steps_to(time);
        source.step(target - source.newest()->frame.step);
        while (source.newest()->frame.step < target) {
            if (Result<Done> goes = check_on(source, stop); !goes)
                return goes;
            std::this_thread::sleep_for(between_looks);
        }
        if (Result<Done> seen = see(studio); !seen)
            return seen;
        tell(wishes, time);
        if (time >= shown.to)
            return Done{};
    }
}

} // namespace

Result<render::Picture> take_still(Studio& studio, const StillWishes& wishes, StopFlag stop) {
    const Result<Stretch> stretch = studio.source().find(wishes.from, wishes.to);
    if (!stretch)
        return stretch.problems();
    studio.source().seek(stretch->from); // before anything is drawn: what was seen leaves its trail
    if (!wishes.tab.empty())
        if (const Result<Done> opened = open_tab(studio, wishes.tab); !opened)
            return opened.problems();
    const Result<Done> there = studio.source().can_seek() ? go_through_run(studio, *stretch, wishes, stop)
                                                          : simulate(studio, *stretch, wishes, stop);
    if (!there)
        return there.problems();
    while (true) { // until what moved has been drawn once more as what rests
        Result<Shown> shown = studio.draw();
        if (!shown)
            return shown.problems();
        if (!nlohmann::json::parse(shown->state)["sketched"].get<bool>())
            return std::move(shown->picture);
        std::this_thread::sleep_for(between_looks);
    }
}

} // namespace tumble::view
