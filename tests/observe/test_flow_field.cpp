#include "about.h"
#include "frames.h"
#include "observe/flow_field.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_flow_field {

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double pi = std::numbers::pi;

const observe::FlowGrid grid{0.01, -0.02, 0.1, 0, 0.08, 5, 4};

/// Bodies on a fine cylindrical raster about the grid's axis, so that each has the same share of the volume: as many a
/// ring as its radius says. Velocities as a field of radius and height gives them: radial, tangential, vertical.
template <class Velocity> observe::Frame filled(double height, Velocity velocity) {
    observe::Frame frame;
    frame.layout = open_layout(ball(0.001, 2e-3));
    const double pitch = 0.004;
    for (int j = 0; (j + 0.5) * pitch < height; ++j)
        for (int i = 0; i < 25; ++i) {
            const double r = (i + 0.5) * pitch, y = (j + 0.5) * pitch;
            const int around = 4 * (2 * i + 1);
            for (int k = 0; k < around; ++k) {
                const double angle = 2 * pi * (k + 0.3) / around, c = std::cos(angle), s = std::sin(angle);
                const Vector3d v = velocity(r, y);
                // A positive rotation about y carries z towards x: its direction at (c, s) is (s, -c).
                add_body(frame, {0.01 + r * c, y, -0.02 + r * s},
                         v[0] * Vector3d(c, 0, s) + v[1] * Vector3d(s, 0, -c) + v[2] * Vector3d::UnitY());
            }
        }
    return frame;
}

} // namespace

TEST_CASE("a vortex ring over a rigid rotation comes out cell by cell as it was put in") {
    const auto field_at = [](double r, double y) { return Vector3d(2 * r - y, 20 * r, 0.3 - 5 * r); };
    observe::FlowField field(grid);
    for (int frame = 0; frame < 2; ++frame)
        field.add(filled(0.08, field_at));
    CHECK(field.frames() == 2);
    for (int ring = 0; ring < 5; ++ring)
        for (int layer = 0; layer < 4; ++layer) {
            CAPTURE(ring);
            CAPTURE(layer);
            // Over a ring of radii a to b the area-weighted mean radius is 2/3 (b3 - a3) / (b2 - a2).
            const double a = 0.02 * ring, b = a + 0.02;
            const double r = 2.0 / 3 * (b * b * b - a * a * a) / (b * b - a * a), y = 0.02 * (layer + 0.5);
            const Vector3d mean = field.cell(ring, layer).mean_velocity();
            CHECK(std::abs(mean[0] - (2 * r - y)) < 0.02 * std::max(2 * r, y)); // as well as each part is sampled
            CHECK(mean[1] == about(20 * r, 0.015));
            CHECK(mean[2] == about(0.3 - 5 * r, 0.02));
            // 4 bodies of 2 g stand in each pi (4 mm)2 x 4 mm.
            CHECK(field.density(ring, layer) == about(4 * 2e-3 / (pi * 0.004 * 0.004 * 0.004)));
        }
    // A whole layer: the mean radius of a disc is two thirds of its own.
    CHECK(field.layer(2).mean_velocity()[1] == about(20 * 0.1 * 2 / 3, 0.01));
}

TEST_CASE("a positive rotation about y gives positive tangential velocities") {
    observe::FlowField field(observe::FlowGrid{0, 0, 1, 0, 1, 1, 1});
    observe::Frame frame;
    frame.layout = open_layout(ball(0.01, 1));
    const Vector3d at(0.3, 0.5, 0.4), spin(0, 3, 0);
    add_body(frame, at, spin.cross(at));
    field.add(frame);
    CHECK(field.cell(0, 0).mean_velocity()[1] == about(1.5));
    CHECK(std::abs(field.cell(0, 0).mean_velocity()[0]) < 1e-15); // rounding of 1.5 m/s
    CHECK(field.cell(0, 0).mean_speed() == about(1.5));
}

TEST_CASE(
    "the surface of an even column is its height, a funnel's depth is its own, and bodies in flight do not matter") {
    const auto still = [](double, double) { return Vector3d(0, 0, 0); };
    // Columns that end within the layers of 20 mm as well as between them: known to a thousandth of the grid's 80 mm
    // and to half of the 0.05 mm at which bodies stand above each other.
    for (const double top : {0.005, 0.03, 0.06, 0.071}) {
        observe::FlowField flat(grid);
        observe::Frame column;
        column.layout = open_layout(ball(0.001, 2e-3));
        for (int ring = 0; ring < 5; ++ring)
            for (double y = 0.025e-3; y < top; y += 0.05e-3)
                add_body(column, {0.01 + 0.02 * (ring + 0.5), y, -0.02});
        flat.add(column);
        for (const double height : flat.surface())
            CHECK(std::abs(height - top) < 0.08e-3 + 0.025e-3);
        CHECK(std::abs(observe::vortex_depth(flat)) < 1e-12);
    }

    // A cone-shaped funnel: the surface rises from 20 mm at the axis to 70 mm at the wall.
    observe::FlowField funnel(observe::FlowGrid{0.01, -0.02, 0.1, 0, 0.08, 5, 40});
    observe::Frame frame = filled(0.08, still), cut;
    cut.layout = frame.layout;
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        const double r = std::hypot(frame.position[i].x() - 0.01, frame.position[i].z() + 0.02);
        if (frame.position[i].y() < 0.02 + 0.5 * r)
            add_body(cut, frame.position[i]);
    }
    const std::size_t lying = cut.bodies();
    funnel.add(cut);
    // From the innermost ring (mean radius 13 mm) to the outermost (91 mm) it rises by 0.5 x 78 mm.
    const double depth = observe::vortex_depth(funnel);
    CHECK(depth == about(0.039, 0.1));
    for (std::size_t i = 0; i < lying / 100; ++i)
        add_body(cut, {0.01 + 0.001 * static_cast<double>(i % 90), 0.0795, -0.02});
    observe::FlowField flying(funnel.grid());
    flying.add(cut);
    CHECK(std::abs(flying.surface()[4] - funnel.surface()[4]) < 0.004);
}

TEST_CASE("a body that trembles at the face between two layers stays, however often one looks") {
    // It swings slowly through both layers, 0.8 s a period, and trembles by 0.05 of a layer's 0.5 m meanwhile.
    for (const double every : {0.01, 0.0025}) {
        CAPTURE(every);
        observe::Residence residence(observe::FlowGrid{0, 0, 1, 0, 1, 1, 2});
        for (int i = 0; i * every < 10; ++i) {
            observe::Frame frame;
            frame.layout = open_layout(ball(0.01, 1));
            frame.time = every * i;
            add_body(frame, {0, 0.5 + 0.4 * std::sin(2 * pi * frame.time / 0.8 + 0.5) + (i % 2 ? 0.025 : -0.025), 0});
            residence.add(frame);
        }
        CHECK(residence.stays(0) >= 12);
        CHECK(residence.stays(0) <= 13);
        CHECK(residence.mean_s(0) == about(0.4, 0.03));
    }
}

TEST_CASE(
    "a body that circles through two layers stays half a period in each; the cut-off first and last do not count") {
    const observe::FlowGrid two{0, 0, 1, 0, 1, 1, 2};
    observe::Residence residence(two);
    for (int i = 0; i <= 1000; ++i) {
        observe::Frame frame;
        frame.layout = open_layout(ball(0.01, 1));
        frame.time = 0.01 * i;
        add_body(frame, {0, 0.5 + 0.4 * std::sin(2 * pi * frame.time / 0.8 + 0.5), 0});
        residence.add(frame);
    }
    // 10 s are 12.5 periods of 0.8 s.
    CHECK(residence.stays(0) >= 12);
    CHECK(residence.stays(0) <= 13);
    CHECK(residence.mean_s(0) == about(0.4, 0.03));
    CHECK(residence.mean_s(1) == about(0.4, 0.03));
}

} // namespace test_flow_field
