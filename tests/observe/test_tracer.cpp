#include "about.h"
#include "frames.h"
#include "observe/tracer.h"

#include <cmath>
#include <doctest/doctest.h>
#include <map>

namespace test_tracer {

using namespace tumble;
using namespace tumble::test;

namespace {

constexpr double g = 9.81;

/// One row as columns by name.
std::map<std::string, double> told(observe::TracerReader& reader, const observe::Frame& frame) {
    const std::vector<std::string> heads = reader.columns();
    const std::vector<double> values = reader.row(frame);
    REQUIRE(heads.size() == values.size());
    std::map<std::string, double> row;
    for (std::size_t i = 0; i < heads.size(); ++i)
        row[heads[i].substr(std::string("tracer:sensor_").size())] = values[i];
    return row;
}

observe::Tracer sensor(const Vector3d& point) {
    return {.name = "sensor", .point = point, .gravity = {0, -g, 0}};
}

observe::Frame with_body(double time, const Vector3d& position, const Vector3d& velocity,
                         const Eigen::Quaterniond& orientation = Eigen::Quaterniond::Identity(),
                         const Vector3d& spin = Vector3d::Zero()) {
    observe::Frame frame;
    frame.layout = open_layout(ball(0.01, 0.02));
    frame.time = time;
    add_body(frame, position, velocity, spin);
    frame.orientation.back() = orientation;
    return frame;
}

} // namespace

TEST_CASE("at rest a sensor feels g upwards in its own frame, in free fall nothing") {
    observe::TracerReader lying(sensor(Vector3d::Zero()));
    // Laid on its side: the sensor's x looks down.
    const Eigen::Quaterniond side(Eigen::AngleAxisd(-M_PI / 2, Vector3d::UnitZ()));
    const auto first = told(lying, with_body(0, {0, 0.1, 0}, Vector3d::Zero(), side));
    CHECK(std::isnan(first.at("felt_x_m_s2"))); // no time has passed yet
    CHECK(first.at("y_m") == 0.1);
    const auto rest = told(lying, with_body(0.01, {0, 0.1, 0}, Vector3d::Zero(), side));
    CHECK(rest.at("felt_x_m_s2") == about(-g));
    const double rounding = 1e-14 * g;
    CHECK(std::abs(rest.at("felt_y_m_s2")) < rounding);
    CHECK(std::abs(rest.at("ay_m_s2")) < rounding);

    observe::TracerReader falling(sensor(Vector3d(0.02, 0, 0)));
    told(falling, with_body(0, {0, 1, 0}, {1, 0, 0}));
    const auto fall = told(falling, with_body(0.01, {0.01, 1, 0}, {1, -0.01 * g, 0}));
    CHECK(fall.at("ay_m_s2") == about(-g));
    for (const char* axis : {"felt_x_m_s2", "felt_y_m_s2", "felt_z_m_s2"})
        CHECK(std::abs(fall.at(axis)) < rounding);
}

TEST_CASE("of a body that turns quickly a sensor feels what its turning axes average over the interval") {
    // At rest but for its spin about z, the sensor in the centre: the upward push g, seen from axes that turn by
    // phi = omega T in an interval, averages to g sin(phi/2) / (phi/2) along the axes half-way. Turned half-way the
    // mean is too large by phi^2 / 24; at the end of the interval it would point phi / 2 beside that: 7 % of g and 40
    // %.
    for (const double phi : {0.15, 0.8}) {
        CAPTURE(phi);
        const double interval = 5e-3, rate = phi / interval;
        observe::TracerReader reader(sensor(Vector3d::Zero()));
        std::map<std::string, double> row;
        for (int i = 0; i <= 4; ++i) {
            const Eigen::Quaterniond turn(Eigen::AngleAxisd(phi * i, Vector3d::UnitZ()));
            row = told(reader, with_body(interval * i, Vector3d::Zero(), Vector3d::Zero(), turn, {0, 0, rate}));
        }
        const double mean = g * std::sin(phi / 2) / (phi / 2), half_way = 3.5 * phi;
        const double bound = 1.01 * g * phi * phi / 24;
        CHECK(std::abs(row.at("felt_x_m_s2") - mean * std::sin(half_way)) < bound);
        CHECK(std::abs(row.at("felt_y_m_s2") - mean * std::cos(half_way)) < bound);
        CHECK(std::abs(row.at("felt_z_m_s2")) < 1e-12);
        CHECK(row.at("spin_z_rad_s") == about(rate));
    }
}

TEST_CASE("carried round an axis, a sensor off its body's centre feels the centripetal acceleration of its own place") {
    // The body turns with the circle, once in 2 pi / 5 s; the sensor sits 20 mm farther out than the centre at 0.1 m.
    observe::TracerReader reader(sensor(Vector3d(0.02, 0, 0)));
    const double rate = 5, radius = 0.1;
    std::map<std::string, double> row;
    for (int i = 0; i <= 10; ++i) {
        const double angle = rate * 0.001 * i;
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Vector3d::UnitY()));
        const Vector3d place = turn * Vector3d(radius, 0, 0), spin(0, rate, 0);
        row = told(reader, with_body(0.001 * i, place, spin.cross(place), turn, spin));
    }
    CHECK(row.at("felt_x_m_s2") == about(-rate * rate * (radius + 0.02), 1e-3));
    CHECK(row.at("felt_y_m_s2") == about(g));
    CHECK(row.at("spin_y_rad_s") == about(rate));
    CHECK(std::hypot(row.at("point_vx_m_s"), row.at("point_vz_m_s")) == about(rate * (radius + 0.02)));
    CHECK(std::hypot(row.at("point_x_m"), row.at("point_z_m")) == about(radius + 0.02));
    CHECK(std::atan2(-row.at("point_z_m"), row.at("point_x_m")) == about(rate * 0.01)); // beside the centre, not behind
    CHECK(std::hypot(row.at("ax_m_s2"), row.at("az_m_s2")) == about(rate * rate * radius, 1e-3));
    CHECK(std::hypot(row.at("point_ax_m_s2"), row.at("point_az_m_s2")) == about(rate * rate * (radius + 0.02), 1e-3));
    CHECK(std::abs(row.at("point_ay_m_s2")) < 1e-12);
}

TEST_CASE("what a sensor sums up is its point's velocity, but for the gravity that leaks in where it sits askew") {
    const double askew = 0.02, interval = 0.01;
    for (const double turned : {0.0, askew}) {
        observe::Tracer tracer = sensor(Vector3d(0.02, 0, 0));
        tracer.turned = Eigen::AngleAxisd(turned, Vector3d::UnitZ());
        observe::TracerReader reader(tracer);
        std::map<std::string, double> row;
        for (int i = 0; i <= 10; ++i) // pushed along x at 3 m/s2
            row = told(reader, with_body(interval * i, Vector3d::Zero(), {3 * interval * i, 0, 0}));
        // Axes turned counter-clockwise see g lean towards their x: what is felt, (3, g), read as if they were not.
        const double time = 10 * interval, c = std::cos(turned), s = std::sin(turned);
        CHECK(row.at("point_vx_m_s") == about(3 * time));
        CHECK(row.at("summed_vx_m_s") == about((3 * c + g * s) * time));
        CHECK(std::abs(row.at("summed_vy_m_s") - (g * c - 3 * s - g) * time) < 1e-12);
        CHECK(row.at("felt_x_m_s2") == about(3 * c + g * s));
    }
    // While the body turns, the leak turns with it: after half a turn it points the other way.
    observe::Tracer tracer = sensor(Vector3d::Zero());
    tracer.turned = Eigen::AngleAxisd(askew, Vector3d::UnitZ());
    observe::TracerReader reader(tracer);
    double most = 0, last = 0;
    for (int i = 0; i <= 1000; ++i) {
        const Eigen::Quaterniond turn(Eigen::AngleAxisd(2 * M_PI * i / 1000, Vector3d::UnitY()));
        last = told(reader, with_body(1e-3 * i, Vector3d::Zero(), Vector3d::Zero(), turn, {0, 2 * M_PI, 0}))
                   .at("summed_vz_m_s");
        most = std::max(most, std::abs(last));
    }
    CHECK(most == about(g * std::sin(askew) / M_PI, 1e-3)); // of g sin(askew) sin(2 pi t), summed over half a turn
    CHECK(std::abs(last) < 1e-3 * most);
}

TEST_CASE("a tracer's columns are told apart by their longest name") {
    CHECK(observe::traced_by("tracer:ball_felt_x")->body == "ball");
    CHECK(observe::traced_by("tracer:ball_felt_x")->inertial);
    CHECK(observe::traced_by("tracer:ball_summed_vy")->unit == "m_s");
    CHECK(observe::traced_by("tracer:my_ball_point_vx")->body == "my_ball");
    CHECK_FALSE(observe::traced_by("tracer:ball_vx")->inertial);
    for (const char* none : {"tracer:ball", "tracer:_x", "ball_felt_x", "tracer:ball_vx_m_s"})
        CHECK_FALSE_MESSAGE(observe::traced_by(none), none);
}

TEST_CASE("a tracer follows the body of its shape with the lowest id, and is not a number while there is none") {
    observe::TracerReader reader(sensor(Vector3d::Zero()));
    observe::Frame frame = with_body(0, {7, 0, 0}, Vector3d::Zero());
    frame.shape[0] = 1;
    CHECK(std::isnan(told(reader, frame).at("x_m")));
    add_body(frame, {2, 0, 0});
    add_body(frame, {1, 0, 0});
    frame.id = {0, 5, 3};
    CHECK(told(reader, frame).at("x_m") == 1);
}

} // namespace test_tracer
