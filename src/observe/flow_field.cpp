#include "observe/flow_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace tumble::observe {

namespace {

using Eigen::Vector3d;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double surface_share = 0.95;
constexpr int height_steps = 1000; // over a grid's height: its surface does not depend on how thick layers are

/// Layer of a height, -1 outside the grid.
int layer_of(const FlowGrid& grid, double y) {
    if (!(y >= grid.lo && y < grid.hi))
        return -1;
    return std::min(static_cast<int>((y - grid.lo) / grid.layer_height()), grid.layers - 1);
}

} // namespace

double FlowGrid::volume(int ring) const {
    const double w = ring_width();
    return std::numbers::pi * w * w * (2 * ring + 1) * layer_height();
}

FlowCell& FlowCell::operator+=(const FlowCell& other) {
    mass += other.mass;
    momentum += other.momentum;
    speed += other.speed;
    return *this;
}

Vector3d FlowCell::mean_velocity() const {
    return mass > 0 ? Vector3d(momentum / mass) : Vector3d::Constant(nothing);
}

double FlowCell::mean_speed() const {
    return mass > 0 ? speed / mass : nothing;
}

FlowField::FlowField(const FlowGrid& grid)
    : grid_(grid), cells_(static_cast<std::size_t>(grid.rings) * static_cast<std::size_t>(grid.layers)),
      at_heights_(static_cast<std::size_t>(grid.rings), std::vector<double>(height_steps, 0.0)) {}

void FlowField::add(const Frame& frame) {
    ++frames_;
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        const double x = frame.position[i].x() - grid_.axis_x, z = frame.position[i].z() - grid_.axis_z;
        const double far = std::hypot(x, z);
        const int layer = layer_of(grid_, frame.position[i].y());
        const auto ring = static_cast<int>(far / grid_.ring_width());
        if (layer < 0 || ring >= grid_.rings)
            continue;
        // A positive rotation about y carries z towards x.
        const Vector3d& v = frame.velocity[i];
        const double c = far > 0 ? x / far : 1, s = far > 0 ? z / far : 0;
        const Vector3d turned(c * v.x() + s * v.z(), s * v.x() - c * v.z(), v.y());
        const double mass = frame.layout->shapes[static_cast<std::size_t>(frame.shape[i])].mass;
        cells_[static_cast<std::size_t>(ring * grid_.layers + layer)] += {mass, mass * turned, mass * v.norm()};
        const double height = (frame.position[i].y() - grid_.lo) / (grid_.hi - grid_.lo);
        at_heights_[static_cast<std::size_t>(ring)]
                   [std::min(static_cast<std::size_t>(height * height_steps), std::size_t{height_steps - 1})] += mass;
    }
}

const FlowCell& FlowField::cell(int ring, int layer) const {
    return cells_[static_cast<std::size_t>(ring * grid_.layers + layer)];
}

FlowCell FlowField::layer(int layer) const {
    FlowCell sum;
    for (int ring = 0; ring < grid_.rings; ++ring)
        sum += cell(ring, layer);
    return sum;
}

double FlowField::density(int ring, int layer) const {
    return cell(ring, layer).mass / (grid_.volume(ring) * std::max(frames_, 1));
}

std::vector<double> FlowField::surface() const {
    const double step = (grid_.hi - grid_.lo) / height_steps;
    std::vector<double> heights;
    for (const std::vector<double>& masses : at_heights_) {
        const double wanted = surface_share * std::accumulate(masses.begin(), masses.end(), 0.0);
        double below = 0, height = 0;
        for (std::size_t k = 0; k < masses.size() && below < wanted; ++k) {
            height = (static_cast<double>(k) + std::min(1.0, (wanted - below) / std::max(masses[k], 1e-300))) * step;
            below += masses[k];
        }
        heights.push_back(height / surface_share);
    }
    return heights;
}

double vortex_depth(const FlowField& field) {
    const std::vector<double> heights = field.surface();
    return *std::max_element(heights.begin(), heights.end()) - heights.front();
}

namespace {

// Of a layer's height: a body that trembles at a face neither leaves nor enters.
constexpr double beyond_a_face = 0.25;

/// Whether a body at that height has left the layer; `now`: the one that it is in.
bool has_left(const FlowGrid& grid, int layer, double y, int now) {
    if (layer < 0)
        return now >= 0;
    const double height = (y - grid.lo) / grid.layer_height() - layer; // 0 to 1 within
    return height < -beyond_a_face || height > 1 + beyond_a_face;
}

} // namespace

Residence::Residence(const FlowGrid& grid)
    : grid_(grid), stays_(static_cast<std::size_t>(grid.layers)), seconds_(static_cast<std::size_t>(grid.layers)) {}

void Residence::add(const Frame& frame) {
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        const auto id = static_cast<std::size_t>(frame.id[i]);
        const int layer = layer_of(grid_, frame.position[i].y());
        if (id >= bodies_.size())
            bodies_.resize(id + 1);
        Body& body = bodies_[id];
        if (body.layer == layer || (body.layer != -2 && !has_left(grid_, body.layer, frame.position[i].y(), layer)))
            continue;
        if (body.entered && body.layer >= 0) {
            ++stays_[static_cast<std::size_t>(body.layer)];
            seconds_[static_cast<std::size_t>(body.layer)] += frame.time - body.since;
        }
        body = {layer, frame.time, body.layer != -2};
    }
}

int Residence::stays(int layer) const {
    return stays_[static_cast<std::size_t>(layer)];
}

double Residence::mean_s(int layer) const {
    return stays(layer) > 0 ? seconds_[static_cast<std::size_t>(layer)] / stays(layer) : nothing;
}

} // namespace tumble::observe
