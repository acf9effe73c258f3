#include "about.h"
#include "excitation/rocking.h"
#include "synthetic.h"

namespace test_rocking {

using namespace tumble;
using namespace tumble::excitation;
using namespace tumble::excitation::testing;
using tumble::test::about;

namespace {

using Eigen::Vector3d;

constexpr double f = 24.6, angle = 1.2e-3, angle_phase = 0.8; // Hz, rad, rad
const Vector3d pivot(0, 0.4, 0.05), left(0, 0.7, -0.3), right(0, 0.65, 0.28);

/// A body that rocks about x through the pivot, which itself moves up and down: displacement of one of its points is
/// translation + angle (x cross arm), to first order.
std::vector<Tone> tones_at(const Vector3d& place) {
    const Vector3d arm = Vector3d::UnitX().cross(place - pivot);
    return {{1, f, 1e-3, 0.2}, {1, f, angle * arm.y(), angle_phase}, {2, f, angle * arm.z(), angle_phase}};
}

Record two_sensors(double noise) {
    const Recorder how{.duration = 2.3, .noise = noise};
    Recorder again = how;
    again.seed = 2;
    return *together(recorded(tones_at(left), how), recorded(tones_at(right), again));
}

} // namespace

TEST_CASE("two sensors give the angle, its phase and the pivot that the body was given") {
    const Record record = two_sensors(0.02);
    const auto found = find_lines(record, {});
    REQUIRE_MESSAGE(found.ok(), to_string(found.problems()));
    const auto turns = turns_of(*found, record.channels, {left, right, 0});
    REQUIRE_MESSAGE(turns.ok(), to_string(turns.problems()));
    REQUIRE(turns->size() == 1);
    const Turn& turn = turns->front();
    CHECK(turn.seen());
    CHECK(std::abs(std::abs(turn.angle) - angle) < 4.5 * turn.angle_se);
    CHECK(between(std::arg(turn.angle), angle_phase) < 4.5 * turn.angle_se / angle + 1e-3);
    CHECK(turn.misfit < 4.5 * turn.misfit_se);
    // Where the motion is least: the pivot's own 1 mm has a part in phase with the turn, which moves that point
    // sideways by 1 mm cos(0.2 - 0.8) / 1.2 mrad = 0.688 m; what is left is the part a quarter period away.
    const double in_phase = 1e-3 * std::cos(0.2 - angle_phase) / angle;
    CHECK(std::abs(turn.pivot.y() - pivot.y()) < 4.5 * turn.pivot_se);
    CHECK(std::abs(turn.pivot.z() - (pivot.z() + in_phase)) < 4.5 * turn.pivot_se);
    CHECK(std::abs(turn.pivot_motion[1]) / (1e-3 * std::abs(std::sin(0.2 - angle_phase))) == about(1, 0.01));
}

TEST_CASE("the motion that is written moves both places as they were measured") {
    const Record record = two_sensors(0);
    const auto found = find_lines(record, {});
    REQUIRE(found.ok());
    const Places places{left, right, 0};
    const scene::WallMotion motion = motion_of(*turns_of(*found, record.channels, places), places, 0);
    REQUIRE(motion.rockings.size() == 1);
    for (const Vector3d& place : {left, right}) {
        const auto moved = [&](double t) {
            const scene::WallPose pose = scene::pose_at(motion, t);
            return Vector3d(pose.rotation * place + pose.translation);
        };
        for (double t = 0; t < 0.08; t += 0.007) {
            Vector3d truth = Vector3d::Zero();
            for (const Tone& tone : tones_at(place))
                truth[tone.axis] += tone.amplitude * (std::sin(2 * pi * f * t + tone.phase) - std::sin(tone.phase));
            // Second order in the angle: (1.2e-3 * 2)^2 / 2 of arms below 1 m.
            CHECK((moved(t) - moved(0) - truth).norm() < 3e-6);
        }
    }
}

TEST_CASE("a body that does not rock is not said to, and sensors in line with the axis are refused") {
    Record record = recorded({{1, f, 1e-3, 0.2}}, {.noise = 0.05});
    const Record second = recorded({{1, f, 1e-3, 0.2}}, {.noise = 0.05, .seed = 2});
    record = *together(record, second);
    const auto found = find_lines(record, {});
    REQUIRE(found.ok());
    CHECK_FALSE(turns_of(*found, record.channels, {left, right, 0})->front().seen());
    const auto blind = turns_of(*found, record.channels, {left, left + Vector3d(0.5, 0, 0), 0});
    REQUIRE_FALSE(blind.ok());
    CHECK(blind.problems()[0].what.starts_with("the two sensors cannot see a turn about x"));
}

} // namespace test_rocking
