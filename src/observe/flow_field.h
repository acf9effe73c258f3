#pragma once

#include "observe/frame.h"

#include <Eigen/Core>
#include <vector>

/// Means over time of a flow about an upright axis, such as that in a rotary bowl; docs/measures.md, "Flow about an
/// axis".
namespace tumble::observe {

/// Rings of equal width from the axis to `radius`, cut into layers of equal height.
struct FlowGrid {
    double axis_x = 0, axis_z = 0; // m
    double radius = 0;             // m
    double lo = 0, hi = 0;         // m, heights (y)
    int rings = 1, layers = 1;

    [[nodiscard]] double ring_width() const { return radius / rings; }
    [[nodiscard]] double layer_height() const { return (hi - lo) / layers; }
    /// m3, of one cell.
    [[nodiscard]] double volume(int ring) const;
};

/// Mass-weighted sums over the bodies whose centres lay in a cell. Velocities along the radius outwards, round the axis
/// in the sense of a positive rotation about y, and upwards.
struct FlowCell {
    double mass = 0;                                    // kg, summed over frames
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero(); // kg m/s: radial, tangential, vertical
    double speed = 0;                                   // kg m/s, sum of m |v|
    FlowCell& operator+=(const FlowCell& other);

    /// Mass-weighted means, m/s; NaN where no body ever was.
    [[nodiscard]] Eigen::Vector3d mean_velocity() const;
    [[nodiscard]] double mean_speed() const;
};

class FlowField {
public:
    explicit FlowField(const FlowGrid& grid);

    /// Bodies outside the grid do not count.
    void add(const Frame& frame);

    [[nodiscard]] const FlowGrid& grid() const { return grid_; }
    [[nodiscard]] int frames() const { return frames_; }
    [[nodiscard]] const FlowCell& cell(int ring, int layer) const;
    /// Over all rings.
    [[nodiscard]] FlowCell layer(int layer) const;
    /// kg/m3 of bodies' centres in the cell's volume, mean over frames.
    [[nodiscard]] double density(int ring, int layer) const;
    /// Height of the bulk's surface in each ring, m above the grid's lower end: that of an even column whose lowest
    /// 95 % of mass end where the ring's do, so that a few bodies in flight do not raise it. To a thousandth of the
    /// grid's height, however thick layers are. 0 where nothing ever was.
    [[nodiscard]] std::vector<double> surface() const;

private:
    FlowGrid grid_;
    int frames_ = 0;
    std::vector<FlowCell> cells_;                 // ring by ring
    std::vector<std::vector<double>> at_heights_; // kg by ring, then by thin steps of height
};

/// How much lower the surface lies at the axis than where it is highest, m: its highest ring less its innermost.
double vortex_depth(const FlowField& field);

/// How long bodies stay within one layer of a grid (all rings together) before they leave it by more than a quarter of
/// its height.
class Residence {
public:
    explicit Residence(const FlowGrid& grid);
    void add(const Frame& frame);

    /// Stays whose begin and end were both seen, so that long ones count less than they should in a short run.
    [[nodiscard]] int stays(int layer) const;
    [[nodiscard]] double mean_s(int layer) const; // NaN without stays

private:
    struct Body {
        int layer = -2; // -1: outside the layers, -2: never seen
        double since = 0;
        bool entered = false; // the stay's begin was seen
    };
    FlowGrid grid_;
    std::vector<Body> bodies_; // by id
    std::vector<int> stays_;
    std::vector<double> seconds_;
};

} // namespace tumble::observe
