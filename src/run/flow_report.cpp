#include "run/flow_report.h"

#include "base/make_folder.h"
#include "base/table.h"
#include "base/text.h"
#include "observe/bulk.h"
#include "observe/whole_file.h"

#include <algorithm>
#include <cmath>

namespace tumble::run {

namespace {

using Eigen::Vector3d;

/// Feeds frames to what is wanted of them.
class FlowSink final : public FrameSink {
public:
    FlowSink(FlowReport& report, std::vector<int> shapes) : report_(report), shapes_(std::move(shapes)) {}

    Result<Done> take(const Shot& shot) override {
        const observe::Frame& frame = shot.frame;
        report_.field.add(frame);
        report_.residence.add(frame);
        report_.kinetic.push_back(observe::bulk_motion(frame).kinetic_translation);
        for (std::size_t p = 0; p < shapes_.size(); ++p)
            for (std::size_t i = 0; i < frame.bodies(); ++i)
                if (frame.shape[i] == shapes_[p]) { // frames hold bodies by rising id
                    Path& path = report_.paths[p];
                    path.times.push_back(frame.time);
                    path.position.push_back(frame.position[i]);
                    path.velocity.push_back(frame.velocity[i]);
                    break;
                }
        return Done{};
    }

private:
    FlowReport& report_;
    std::vector<int> shapes_;
};

Result<std::vector<int>> shapes_named(const std::vector<std::string>& names, const observe::FrameLayout& layout) {
    std::vector<std::string> known;
    for (const observe::FrameShape& shape : layout.shapes)
        known.push_back(shape.name);
    std::vector<int> shapes;
    Problems problems;
    for (const std::string& name : names) {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end()) {
            const std::string guess = did_you_mean(name, known);
            problems.push_back({.what = "the run has no body '" + name + "'",
                                .fix = guess.empty() ? "give the name of one of its bodies" : guess});
        } else {
            shapes.push_back(static_cast<int>(found - known.begin()));
        }
    }
    if (!problems.empty())
        return problems;
    return shapes;
}

observe::FlowGrid fitted(const FlowOptions& options, const Eigen::AlignedBox3d& bounds) {
    observe::FlowGrid grid = options.grid;
    if (options.fit_radius) {
        const Vector3d axis(grid.axis_x, 0, grid.axis_z);
        const Vector3d lo = (bounds.min() - axis).cwiseAbs(), hi = (bounds.max() - axis).cwiseAbs();
        grid.radius = std::max({lo.x(), lo.z(), hi.x(), hi.z()});
    }
    if (options.fit_heights) {
        grid.lo = bounds.min().y();
        grid.hi = bounds.max().y();
    }
    return grid;
}

std::string head(std::initializer_list<const char*> words) {
    return csv_line(std::vector<std::string>(words.begin(), words.end()));
}

std::string line(std::initializer_list<double> numbers) {
    return csv_line(std::span<const double>(numbers.begin(), numbers.size()));
}

std::string field_table(const observe::FlowField& field) {
    const observe::FlowGrid& grid = field.grid();
    std::string text = head(
        {"radius_m", "height_m", "v_radial_m_s", "v_tangential_m_s", "v_vertical_m_s", "speed_m_s", "density_kg_m3"});
    for (int ring = 0; ring < grid.rings; ++ring)
        for (int layer = 0; layer < grid.layers; ++layer) {
            const observe::FlowCell& cell = field.cell(ring, layer);
            const Vector3d v = cell.mean_velocity();
            text += line({(ring + 0.5) * grid.ring_width(), grid.lo + (layer + 0.5) * grid.layer_height(), v.x(), v.y(),
                          v.z(), cell.mean_speed(), field.density(ring, layer)});
        }
    return text;
}

std::string layers_table(const FlowReport& report) {
    const observe::FlowGrid& grid = report.field.grid();
    std::string text = head({"from_m", "to_m", "mass_kg", "v_radial_m_s", "v_tangential_m_s", "v_vertical_m_s",
                             "speed_m_s", "residence_s", "stays"});
    for (int layer = 0; layer < grid.layers; ++layer) {
        const observe::FlowCell cell = report.field.layer(layer);
        const Vector3d v = cell.mean_velocity();
        text += line({grid.lo + layer * grid.layer_height(), grid.lo + (layer + 1) * grid.layer_height(),
                      cell.mass / std::max(report.field.frames(), 1), v.x(), v.y(), v.z(), cell.mean_speed(),
                      report.residence.mean_s(layer), static_cast<double>(report.residence.stays(layer))});
    }
    return text;
}

std::string surface_table(const observe::FlowField& field) {
    std::string text = head({"radius_m", "height_m"});
    const std::vector<double> heights = field.surface();
    for (std::size_t ring = 0; ring < heights.size(); ++ring)
        text += line({(static_cast<double>(ring) + 0.5) * field.grid().ring_width(), field.grid().lo + heights[ring]});
    return text;
}

std::string path_table(const Path& path) {
    std::string text = head({"time_s", "x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s"});
    for (std::size_t i = 0; i < path.times.size(); ++i) {
        const Vector3d &p = path.position[i], &v = path.velocity[i];
        text += line({path.times[i], p.x(), p.y(), p.z(), v.x(), v.y(), v.z()});
    }
    return text;
}

} // namespace

std::vector<double> Path::heights() const {
    std::vector<double> heights;
    for (const Vector3d& p : position)
        heights.push_back(p.y());
    return heights;
}

observe::Cycle Path::cycle() const {
    return observe::find_cycle(times, heights());
}

Result<FlowReport> read_flow(const std::filesystem::path& run, const FlowOptions& options, const TellFrames& tell) {
    // A grid that is given needs no bounds: each frame is then read once.
    const bool fits = options.fit_radius || options.fit_heights;
    const Result<Recording> recording = open_recording(run, options.when, fits ? Reading::whole : Reading::heads);
    if (!recording)
        return recording.problems();
    if (recording->layout->dimension == 2)
        return Problem{.file = run.string(),
                       .what = "this run has two dimensions, and a flow about an upright axis has three",
                       .fix = "give a run of three dimensions"};
    const auto shapes = shapes_named(options.bodies, *recording->layout);
    if (!shapes)
        return shapes.problems();
    const observe::FlowGrid grid = fitted(options, recording->bounds);
    FlowReport report{observe::FlowField(grid), observe::Residence(grid), {}, {}, {}};
    for (const std::string& name : options.bodies)
        report.paths.push_back({name, {}, {}, {}});
    FrameSinks sinks;
    sinks.push_back(std::make_unique<FlowSink>(report, *shapes));
    report.replayed = replay(*recording, options.when, sinks, tell);
    if (report.replayed.frames == 0 && !report.replayed.stopped)
        return Problem{.file = run.string(),
                       .what = "no frame in this time can be read",
                       .fix =
                           report.replayed.warnings.empty() ? "run the scene again" : report.replayed.warnings.back()};
    double mass = 0;
    for (int layer = 0; layer < grid.layers; ++layer)
        mass += report.field.layer(layer).mass;
    if (report.replayed.frames > 0 && mass == 0)
        return Problem{.file = run.string(),
                       .what = fmt::format("no body came within {:.4g} m of the axis x = {:.4g} m, z = {:.4g} m at "
                                           "heights of {:.4g} to {:.4g} m",
                                           grid.radius, grid.axis_x, grid.axis_z, grid.lo, grid.hi),
                       .fix = "look at --axis, --radius and --heights: all in m"};
    return report;
}

std::vector<std::filesystem::path> flow_files(const std::filesystem::path& folder,
                                              const std::vector<std::string>& bodies) {
    std::vector<std::filesystem::path> files{folder / "flow_field.csv", folder / "flow_layers.csv",
                                             folder / "flow_surface.csv"};
    for (const std::string& body : bodies)
        files.push_back(folder / ("tracer_" + body + ".csv"));
    return files;
}

Result<std::vector<std::filesystem::path>> write_flow(const FlowReport& report, const std::filesystem::path& folder) {
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    std::vector<std::string> bodies,
        tables{field_table(report.field), layers_table(report), surface_table(report.field)};
    for (const Path& path : report.paths) {
        bodies.push_back(path.name);
        tables.push_back(path_table(path));
    }
    const std::vector<std::filesystem::path> files = flow_files(folder, bodies);
    for (std::size_t k = 0; k < files.size(); ++k)
        if (const auto done = observe::write_whole(files[k], tables[k]); !done)
            return done.problems();
    return files;
}

} // namespace tumble::run
