#pragma once

#include "base/problem.h"
#include "observe/cycle.h"
#include "observe/flow_field.h"
#include "run/replay.h"
#include "sheet/canvas.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The flow in a run that is over, from its frames: about an upright axis, and of single bodies.
namespace tumble::run {

struct FlowOptions {
    observe::FlowGrid grid;
    bool fit_radius = false, fit_heights = false; // of the grid: to what the bodies reach in these frames
    std::vector<std::string> bodies;              // names; the first body of each is followed
    ReplayOptions when;
};

/// One body over the frames; rows parallel to times.
struct Path {
    std::string name;
    std::vector<double> times;                       // s
    std::vector<Eigen::Vector3d> position, velocity; // m, m/s

    [[nodiscard]] std::vector<double> heights() const;
    /// Of its vertical motion.
    [[nodiscard]] observe::Cycle cycle() const;
};

struct FlowReport {
    observe::FlowField field;
    observe::Residence residence;
    std::vector<Path> paths;
    std::vector<double> kinetic; // J, translation of all bodies, per frame
    Replayed replayed;
};

/// Problems: as open_recording; a run of two dimensions; a name that no body has.
Result<FlowReport> read_flow(const std::filesystem::path& run, const FlowOptions& options, const TellFrames& tell);

/// What write_flow makes in the folder where these bodies are followed.
std::vector<std::filesystem::path> flow_files(const std::filesystem::path& folder,
                                              const std::vector<std::string>& bodies);

/// flow_field.csv (a row a cell), flow_layers.csv, flow_surface.csv and tracer_NAME.csv in the folder. Problems: the
/// system's reason.
Result<std::vector<std::filesystem::path>> write_flow(const FlowReport& report, const std::filesystem::path& folder);

/// As large as its cells and words are read well on a screen.
inline const sheet::Canvas flow_canvas{.width_mm = 238, .height_mm = 169};

/// What draw_flow tells gnuplot.
std::string flow_script(const FlowReport& report, const std::filesystem::path& file, const sheet::Canvas& canvas);

/// The mean field in the plane of radius and height: coloured by the tangential velocity, arrows of radial and vertical
/// velocity, the surface as a line; through gnuplot, of the kind that the file's name says (sheet/canvas.h).
/// Problems: gnuplot is missing or failed.
Result<Done> draw_flow(const FlowReport& report, const std::filesystem::path& file,
                       const sheet::Canvas& canvas = flow_canvas);

} // namespace tumble::run
