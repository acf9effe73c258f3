#include "observe/frame_file.h"
#include "render/color_range.h"
#include "render/marks.h"
#include "run/replay.h"

#include <algorithm>

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

} // namespace

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
    auto marks = marks_for(recordings, settings.marks);
    if (!marks)
        return marks.problems();
    settled.marks = std::move(*marks);
    return settled;
}

} // namespace tumble::run
