#include "base/text.h"
#include "observe/frame_file.h"
#include "render/color_range.h"
#include "render/marks.h"
#include "run/replay.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>

namespace tumble::run {

namespace {

struct Widest {
    render::WidestRange speeds, forces{0};
    bool touched = false; // some frame has contacts

    void take_in(const observe::Frame& frame) {
        std::vector<double> values;
        for (const Eigen::Vector3d& velocity : frame.velocity)
            values.push_back(velocity.norm());
        speeds.take_in(std::move(values));
        if (!frame.contacts)
            return;
        touched = true;
        forces.take_in(render::pressing_forces(*frame.contacts));
    }
};

/// Of a recording's last frame, which has all bodies that those before it have.
struct LastBodies {
    observe::Frame frame;
    std::map<std::size_t, std::string> followed; // by what trail

    [[nodiscard]] bool has_name(const std::string& name) const {
        return std::any_of(frame.layout->shapes.begin(), frame.layout->shapes.end(),
                           [&](const observe::FrameShape& shape) { return shape.name == name; });
    }
};

Problem twice(const std::string& one, const std::string& other) {
    return {.key = "render.trails",
            .what = one == other ? fmt::format("the trail of '{}' is asked for twice", one)
                                 : fmt::format("the trails of '{}' and '{}' are those of one body", one, other),
            .fix = "name each body once"};
}

Problem nobody(const std::string& trail, const observe::Frame& frame) {
    std::set<std::string> names;
    for (const int shape : frame.shape)
        names.insert(frame.layout->shapes[static_cast<std::size_t>(shape)].name);
    std::string known = "there are no bodies in this time";
    if (frame.bodies() > 0) {
        const auto [lo, hi] = std::minmax_element(frame.id.begin(), frame.id.end());
        known = fmt::format("take an id from {} to {}, or {} for the first of that name", *lo, *hi,
                            fmt::join(names, " or "));
    }
    return {.key = "render.trails",
            .what = fmt::format("there is no body '{}' whose trail could be drawn, up to t = {:.6g} s", excerpt(trail),
                                frame.time),
            .fix = known};
}

} // namespace

Result<Done> check_trails(std::span<const Recording> recordings, const std::vector<std::string>& trails) {
    if (trails.empty())
        return Done{};
    std::vector<LastBodies> last;
    for (const Recording& recording : recordings)
        if (const auto frame = observe::read_frame(recording.frames.back().file, recording.layout))
            last.push_back({*frame, {}});
    Problems problems;
    for (const std::string& trail : trails) {
        // A body whose name the scene has may come later; a frame that cannot be read is told of elsewhere.
        bool found = last.empty();
        for (LastBodies& bodies : last)
            if (const auto body = render::body_of(bodies.frame, trail)) {
                const auto [same, fresh] = bodies.followed.emplace(*body, trail);
                if (!fresh && !found)
                    problems.push_back(twice(same->second, trail));
                found = true;
            }
        if (!found && !last.front().has_name(trail))
            problems.push_back(nobody(trail, last.front().frame));
    }
    if (!problems.empty())
        return problems;
    return Done{};
}

Result<scene::Marks> marks_for(std::span<const Recording> recordings, const scene::Marks& marks) {
    scene::Marks settled = marks;
    if (marks.arrows != "bodies" && !marks.chains)
        return settled;
    Widest widest;
    for (const Recording& recording : recordings)
        for (const RecordedFrame& recorded : recording.frames)
            if (const Result<observe::Frame> frame = observe::read_frame(recorded.file, recording.layout))
                widest.take_in(*frame);
    if (marks.chains && !widest.touched)
        return Problem{.file = recordings.front().folder.root.string(),
                       .key = "render.force_chains",
                       .what = "the frames of this run have no contacts to draw force chains from",
                       .fix = "run the scene again with observe.contacts = true"};
    if (marks.arrows == "bodies" && !marks.arrow_speed)
        settled.arrow_speed = widest.speeds.span(false).hi;
    if (marks.chains && !marks.chain_force)
        settled.chain_force = widest.forces.span(false).hi;
    return settled;
}

Result<scene::Render> settle_scales(std::span<const Recording> recordings, const scene::Render& settings) {
    scene::Render settled = settings;
    if (!settled.range) {
        const auto colors = colors_for(recordings, settings.color);
        if (!colors)
            return colors.problems();
        settled.range = *colors;
    }
    if (const auto found = check_trails(recordings, settings.marks.trails); !found)
        return found.problems();
    auto marks = marks_for(recordings, settings.marks);
    if (!marks)
        return marks.problems();
    settled.marks = std::move(*marks);
    return settled;
}

} // namespace tumble::run
