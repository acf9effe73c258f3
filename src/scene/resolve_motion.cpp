#include "scene/keys.h"
#include "scene/read_table.h"
#include "scene/resolve.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::scene {
namespace {

Active active_of(const View& view, const Resolving& to) {
    Active active;
    active.start = view.number("start_s");
    if (view.given("stop_s"))
        active.stop = view.number("stop_s");
    if (active.stop <= active.start)
        to.refuse(
            view, "stop_s",
            fmt::format("the motion stops at {} s, before it starts at {} s", plain(active.stop), plain(active.start)),
            "give stop_s above start_s");
    return active;
}

/// The file's content, or its problems reported: at the key when they concern the file as a whole.
template <class Content, class Read> std::optional<Content> read(const View& view, const Resolving& to, Read reader) {
    if (!view.given("file"))
        return std::nullopt;
    Result<Content> content = reader(to.file(view.text("file")));
    if (content)
        return std::move(*content);
    for (const Problem& problem : content.problems())
        if (problem.line > 0)
            to.report.add(Problems{problem});
        else
            to.refuse(view, "file", fmt::format("motion file {}: {}", problem.file, problem.what), problem.fix);
    return std::nullopt;
}

/// Hz/s of a harmonic or a rocking that begins with that frequency.
double drift_of(const View& view, const Active& active, double frequency, const Resolving& to) {
    const double drift = view.number("drift_Hz_s");
    const double lasts = std::max(0.0, std::min(active.stop, to.scene.duration) - active.start);
    const double change = frequency > 0 ? drift * lasts / frequency : 0;
    if (change > most_drift || change <= -1)
        to.refuse(view, "drift_Hz_s",
                  fmt::format("the frequency would come from {} to {:.4g} Hz in {} s", plain(frequency),
                              (1 + change) * frequency, plain(lasts)),
                  "let it neither double nor vanish: choose a smaller drift_Hz_s, or an earlier stop_s");
    return drift;
}

void add_harmonics(const View& view, const Active& active, const Resolving& to, WallMotion& motion) {
    if (view.kind() == "harmonics") {
        auto all = read<std::vector<Harmonic>>(view, to, read_harmonics);
        for (Harmonic& one : all.value_or(std::vector<Harmonic>{})) {
            if (one.axis >= to.scene.dimension) {
                to.refuse(view, "file", "there is a harmonic along z in it, in a scene of two dimensions",
                          "name the axes x and y in the file");
                return;
            }
            one.active = active;
            one.amplitude *= view.number("amplitude_factor");
            one.frequency *= view.number("frequency_factor");
            one.phase += view.number("phase_deg");
            motion.harmonics.push_back(one);
        }
        return;
    }
    Harmonic one;
    one.active = active;
    one.axis = view.given("axis") ? view.text("axis")[0] - 'x' : 0;
    one.amplitude = view.number("amplitude_m");
    one.frequency = view.number("frequency_Hz");
    one.phase = view.number("phase_deg");
    one.drift = drift_of(view, active, one.frequency, to);
    motion.harmonics.push_back(one);
}

void add_table(const View& view, const Active& active, const Resolving& to, WallMotion& motion) {
    const bool flat = to.scene.dimension == 2;
    const auto of_dimension = [&](const std::filesystem::path& file) { return read_motion_table(file, flat ? 2 : 3); };
    MotionTable table = read<MotionTable>(view, to, of_dimension).value_or(MotionTable{});
    const std::vector<double> rows = view.numbers("rows");
    const std::size_t columns = flat ? 3 : 4;
    for (std::size_t i = 0; i + columns <= rows.size(); i += columns) {
        table.time.push_back(rows[i]);
        table.displacement.emplace_back(rows[i + 1], rows[i + 2], flat ? 0.0 : rows[i + 3]);
    }
    if (view.given("rows"))
        for (const RowFault& fault : time_faults(table.time))
            to.refuse(view, "rows", fmt::format("row {}: {}", fault.row + 1, fault.what),
                      fmt::format("write {} in each row, time from 0, rising", flat ? "[t, x, y]" : "[t, x, y, z]"));
    if (active.start > 0 && !table.displacement.empty() && !table.displacement.front().isZero(0))
        to.refuse(
            view, "start_s",
            fmt::format("at start_s = {} s the wall jumps to the first displacement of its table, which is not zero",
                        plain(active.start)),
            "take the first displacement off all of them, or let the table start at 0");
    for (double& time : table.time)
        time /= view.number("frequency_factor");
    for (Vector3d& displacement : table.displacement)
        displacement *= view.number("amplitude_factor");
    table.active = active;
    motion.tables.push_back(std::move(table));
}

} // namespace

WallMotion resolve_motion(const View& wall, const Resolving& to) {
    WallMotion motion;
    const auto axis_of = [&](const View& view) {
        return to.scene.dimension == 2 ? Vector3d(Vector3d::UnitZ()) : direction_of(view, "about", to);
    };
    for (const NamedView& named : wall.children("motion")) {
        const View& view = named.view;
        const std::string kind = view.kind();
        const Active active = active_of(view, to);
        if (kind == "harmonic" || kind == "harmonics")
            add_harmonics(view, active, to, motion);
        else if (kind == "rotation")
            motion.rotations.push_back({active, view.vector("centre_m"), axis_of(view),
                                        view.number(view.given("speed_rpm") ? "speed_rpm" : "speed_rad_s")});
        else if (kind == "rocking")
            motion.rockings.push_back({active, view.vector("centre_m"), axis_of(view), view.number("amplitude_deg"),
                                       view.number("frequency_Hz"), view.number("phase_deg"),
                                       drift_of(view, active, view.number("frequency_Hz"), to)});
        else if (kind == "linear")
            motion.linears.push_back({active, view.vector("velocity_m_s")});
        else if (kind == "table")
            add_table(view, active, to, motion);
    }
    return motion;
}

} // namespace tumble::scene
