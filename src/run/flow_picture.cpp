#include "run/flow_report.h"
#include "sheet/gnuplot.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::run {

namespace {

/// Cells as boxes "left right low high colour", then arrows "x y dx dy", then the surface.
std::string data_of(const observe::FlowField& field, double per_speed) {
    const observe::FlowGrid& grid = field.grid();
    const double w = 1e3 * grid.ring_width(), h = 1e3 * grid.layer_height();
    std::string cells, arrows, surface;
    for (int ring = 0; ring < grid.rings; ++ring)
        for (int layer = 0; layer < grid.layers; ++layer) {
            const Eigen::Vector3d v = field.cell(ring, layer).mean_velocity();
            if (!v.allFinite())
                continue;
            const double x = (ring + 0.5) * w, y = 1e3 * grid.lo + (layer + 0.5) * h;
            cells += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", x, y, x - w / 2, x + w / 2,
                                 y - h / 2, y + h / 2, v.y());
            arrows += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", x - per_speed * v.x() / 2, y - per_speed * v.z() / 2,
                                  per_speed * v.x(), per_speed * v.z());
        }
    const std::vector<double> heights = field.surface();
    for (std::size_t ring = 0; ring < heights.size(); ++ring)
        surface +=
            fmt::format("{:.6g} {:.6g}\n", (static_cast<double>(ring) + 0.5) * w, 1e3 * (grid.lo + heights[ring]));
    return "$cells << END\n" + cells + "END\n$arrows << END\n" + arrows + "END\n$surface << END\n" + surface + "END\n";
}

/// An arrow as those of the picture, in units of its axes, and what it stands for, above the key: the sample that
/// gnuplot would draw beside a title of arrows has a length of its own.
std::string reference(double length, double speed) {
    const std::string words = fmt::format("  radial and vertical velocity, {:.3g} mm are {:.3g} m/s", length, speed);
    return fmt::format("set arrow from character 2,character 2.3 rto first {0:.6g},first 0 filled head size graph "
                       "0.008,20 lw 1.6 lc rgb '#000000'\n"
                       "set label {1} at character 2,character 2.3 offset first {0:.6g},first 0\n",
                       length, sheet::in_gnuplots_quotes(words));
}

/// The speed whose arrow is as long as 1.2 cells: the fastest mean across the axis, rounded up to 1, 2 or 5.
double arrow_speed(const observe::FlowField& field) {
    double fastest = 0;
    for (int ring = 0; ring < field.grid().rings; ++ring)
        for (int layer = 0; layer < field.grid().layers; ++layer) {
            const Eigen::Vector3d v = field.cell(ring, layer).mean_velocity();
            if (v.allFinite())
                fastest = std::max(fastest, std::hypot(v.x(), v.z()));
        }
    if (!(fastest > 0))
        return 1;
    const double decade = std::pow(10, std::floor(std::log10(fastest)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * decade >= fastest)
            return step * decade;
    return 10 * decade;
}

} // namespace

std::string flow_script(const FlowReport& report, const std::filesystem::path& file, const sheet::Canvas& canvas) {
    const observe::FlowGrid& grid = report.field.grid();
    const double speed = arrow_speed(report.field);
    const double length = 1.2e3 * std::min(grid.ring_width(), grid.layer_height());
    std::string script = sheet::open_canvas(canvas, file);
    script += fmt::format("set title {}\n",
                          sheet::in_gnuplots_quotes(fmt::format("Mean flow from {:.4g} to {:.4g} s",
                                                                report.replayed.first, report.replayed.last)));
    script += data_of(report.field, length / speed);
    script += reference(length, speed);
    script += fmt::format("set xrange [0:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset size ratio -1\n", 1e3 * grid.radius,
                          1e3 * grid.lo, 1e3 * grid.hi);
    script += "set xlabel 'distance from the axis [mm]'\nset ylabel 'height [mm]'\n"
              "set cblabel 'tangential velocity [m/s]'\nset key at character 1,character 1.1 left center Left reverse\n"
              "set bmargin 6.5\n"
              "set palette defined (0 '#440154', 0.25 '#3b528b', 0.5 '#21918c', 0.75 '#5ec962', 1 '#fde725')\n"
              "plot $cells using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid noborder lc palette notitle, "
              "$arrows using 1:2:3:4 with vectors filled head size graph 0.008,20 lw 1.6 lc rgb '#000000' "
              "notitle, $surface using 1:2 with lines lw 3 lc rgb '#D55E00' title 'surface'\nunset output\n";
    return script;
}

Result<Done> draw_flow(const FlowReport& report, const std::filesystem::path& file, const sheet::Canvas& canvas) {
    return sheet::run_gnuplot(flow_script(report, file, canvas), file, canvas,
                              "leave --picture away: the tables need no gnuplot");
}

} // namespace tumble::run
