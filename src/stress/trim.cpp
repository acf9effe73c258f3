#include "stress/trim.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::stress {

Result<Done> trim(Recorded& recorded, double from, double to) {
    run::PartLoads& loads = recorded.loads;
    if (loads.instants.empty())
        return Problem{.what = "there is no instant", .fix = "run the scene longer"};
    // s; an instant is of its step's forces, whose time is that of the step's beginning.
    const double slack = 1.5 * recorded.scene.time_step;
    const double begin = loads.instants.front().time, end = loads.instants.back().time;
    recorded.first_frame += std::count_if(loads.instants.begin(), loads.instants.end(),
                                          [&](const run::LoadInstant& instant) { return instant.time < from - slack; });
    keep_within(loads, from - slack, to + slack);
    std::erase_if(loads.touches, [&](const observe::Touching& touch) {
        return touch.begin < from - slack || touch.begin > to + slack;
    });
    if (!loads.instants.empty())
        return Done{};
    return Problem{.what = fmt::format("no instant is left between {:.6g} and {:.6g} s", from, to),
                   .fix = fmt::format("the run has some from {:.3g} to {:.3g} s: --from, --until", begin, end)};
}

} // namespace tumble::stress
