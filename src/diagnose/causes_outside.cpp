#include "diagnose/cause_families.h"

#include <Eigen/Geometry>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

using scene::Scene;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

void tilt(Scene& scene, double degrees, const Eigen::Vector3d& axis) {
    scene.gravity = Eigen::AngleAxisd(degrees * degree, axis) * scene.gravity;
}

constexpr double sphere = 0.44; // drag coefficient where the scene has none (Clift, Grace and Weber 1978)

/// Every harmonic and rocking of every wall.
template <class Change> void excite(Scene& scene, Change change) {
    for (scene::Wall& wall : scene.walls) {
        for (scene::Harmonic& part : wall.motion.harmonics)
            change(part);
        for (scene::Rocking& part : wall.motion.rockings)
            change(part);
    }
}

/// Every harmonic of every wall that does not go up and down.
template <class Change> void shake_sideways(Scene& scene, Change change) {
    for (scene::Wall& wall : scene.walls)
        for (scene::Harmonic& part : wall.motion.harmonics)
            if (part.axis != 1)
                change(part);
}

const scene::Harmonic* largest_along(int axis, const scene::WallMotion& motion) {
    const scene::Harmonic* largest = nullptr;
    for (const scene::Harmonic& part : motion.harmonics)
        if (part.axis == axis && (!largest || part.amplitude > largest->amplitude))
            largest = &part;
    return largest;
}

/// The second harmonic of the largest harmonic along each axis of every wall, `share` as large: sin(2 angle), or what
/// is `ahead` of it (rad).
void distort(Scene& scene, double share, double ahead) {
    if (share == 0)
        return;
    for (scene::Wall& wall : scene.walls)
        for (const int axis : {0, 1, 2})
            if (const scene::Harmonic* largest = largest_along(axis, wall.motion)) {
                scene::Harmonic second = *largest;
                second.amplitude *= share;
                second.frequency *= 2;
                second.drift *= 2;
                second.phase = 2 * largest->phase + ahead;
                wall.motion.harmonics.push_back(second);
            }
}

/// Where a trough's round has its middle; else the origin.
Eigen::Vector3d middle_of(const scene::Wall& wall, int dimension) {
    const auto* trough =
        dimension == 2 ? std::get_if<scene::TroughShape>(&wall.outline) : std::get_if<scene::TroughShape>(&wall.shape);
    return trough ? Eigen::Vector3d(0, trough->floor + trough->radius, 0) : Eigen::Vector3d::Zero();
}

/// Walls that rock beside their upright shaking, so many degrees of its period ahead of it.
Cause rocking(const std::string& id, double ahead, const std::string& name, const std::string& look) {
    return {.id = id,
            .family = "excitation",
            .symbol = "rocking",
            .unit = "deg",
            .lo = -0.5,
            .hi = 0.5,
            .typical = 0.01,
            .in_beds = ahead == 0 ? 0.25 : 0.5, // out of step it takes more to do as much
            .beds = true,
            .name = name,
            .look = look,
            .keys = fmt::format("wall.motion of kind rocking, {} the largest harmonic along y, about the middle of a "
                                "trough's round, else about the origin",
                                ahead == 0 ? "in phase with" : "a quarter period ahead of"),
            .extend = [ahead](Scene& s, double d) {
                for (scene::Wall& wall : s.walls)
                    if (const scene::Harmonic* upright = largest_along(1, wall.motion))
                        wall.motion.rockings.push_back(
                            {.active = upright->active,
                             .centre = middle_of(wall, s.dimension),
                             .axis = s.dimension == 2 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX(),
                             .amplitude = d * degree,
                             .frequency = upright->frequency,
                             .phase = upright->phase + ahead * degree});
            }};
}

} // namespace

std::vector<Cause> of_the_ground() {
    return {
        {.id = "grav.g",
         .family = "gravity",
         .symbol = "dg/g",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-3,
         .name = "gravity that differs from the scene's",
         .look = "grows as t^2 within every flight; the same for heavy and light bodies; a clock that runs wrong looks "
                 "alike",
         .keys = "gravity_m_s2, its length",
         .extend = [](Scene& s, double d) { s.gravity *= 1 + d; }},
        {.id = "grav.tilt_x",
         .family = "tilt",
         .symbol = "tilt",
         .unit = "deg",
         .lo = -5,
         .hi = 5,
         .typical = 0.1,
         .name = "ground that leans sideways, about z",
         .look = "a sideways pull of g sin(tilt); changes its sign when the apparatus is turned half round",
         .keys = "gravity_m_s2, turned about z",
         .extend = [](Scene& s, double d) { tilt(s, d, Eigen::Vector3d::UnitZ()); }},
        {.id = "grav.tilt_z",
         .family = "tilt",
         .symbol = "tilt",
         .unit = "deg",
         .lo = -5,
         .hi = 5,
         .typical = 0.1,
         .name = "ground that leans sideways, about x",
         .look = "a sideways pull of g sin(tilt); changes its sign when the apparatus is turned half round",
         .keys = "gravity_m_s2, turned about x; three dimensions only",
         .extend =
             [](Scene& s, double d) {
                 if (s.dimension == 3)
                     tilt(s, d, Eigen::Vector3d::UnitX());
             }},
    };
}

std::vector<Cause> of_the_air() {
    return {
        {.id = "drag.quadratic",
         .family = "air resistance",
         .symbol = "air density",
         .unit = "kg/m3",
         .lo = 0,
         .hi = 20,
         .typical = 0.1,
         .name = "air resistance that grows with the square of speed",
         .look =
             "zero at release, then k g^2 t^4 / 12 m in the fall; the acceleration's residual follows v|v|; twice the "
             "mass, half the effect",
         .keys = "air.density_kg_m3, with air.drag_coefficient 0.44 where the scene has none",
         .extend =
             [](Scene& s, double d) {
                 s.air.density += d;
                 if (s.air.drag_coefficient == 0)
                     s.air.drag_coefficient = sphere;
             }},
        {.id = "drag.linear",
         .family = "air resistance",
         .symbol = "viscosity",
         .unit = "Pa s",
         .lo = 0,
         .hi = 2,
         .typical = 1e-3,
         .name = "a medium that drags in proportion to speed",
         .look =
             "zero at release, then b g t^3 / 6 m in the fall; the acceleration's residual follows v; twice the mass, "
             "half the effect",
         .keys = "air.viscosity_Pa_s",
         .extend = [](Scene& s, double d) { s.air.viscosity += d; }},
    };
}

std::vector<Cause> of_the_excitation() {
    return {
        {.id = "exc.gain",
         .family = "excitation",
         .symbol = "gain",
         .lo = -0.5,
         .hi = 1,
         .typical = 0.01,
         .name = "walls that shake more or less than the scene's",
         .look = "throws are higher or lower from the first on; lift-off at another acceleration",
         .keys = "wall.motion.amplitude_m and amplitude_deg, times 1 + gain",
         .extend = [](Scene& s, double d) { excite(s, [&](auto& part) { part.amplitude *= 1 + d; }); }},
        {.id = "exc.frequency",
         .family = "excitation",
         .symbol = "df/f",
         .lo = -0.05,
         .hi = 0.05,
         .typical = 1e-4,
         .name = "walls that shake faster or slower than the scene's",
         .look = "the phase runs away with time; a motor that slips",
         .keys = "wall.motion.frequency_Hz, times 1 + df/f",
         .extend = [](Scene& s, double d) { excite(s, [&](auto& part) { part.frequency *= 1 + d; }); }},
        {.id = "exc.drift",
         .family = "excitation",
         .symbol = "df/dt / f",
         .unit = "1_s",
         .lo = -0.02,
         .hi = 0.02,
         .typical = 1e-4,
         .name = "walls whose frequency drifts",
         .look = "the phase runs away with the square of time; a line that is wider than its record makes it",
         .keys = "wall.motion.drift_Hz_s, of the frequency's share in a second",
         .extend = [](Scene& s, double d) { excite(s, [&](auto& part) { part.drift += d * part.frequency; }); }},
        {.id = "exc.harmonic",
         .family = "excitation",
         .symbol = "A2/A1",
         .lo = -0.5,
         .hi = 0.5,
         .typical = 0.01,
         .name = "shaking with a second harmonic, in step with it",
         .look = "a line at twice the frequency, locked in phase; the way up is steeper or flatter than the way down",
         .keys = "wall.motion of kind harmonic: of the largest along each axis, at twice its frequency",
         .extend = [](Scene& s, double d) { distort(s, d, 0); }},
        {.id = "exc.harmonic_ahead",
         .family = "excitation",
         .symbol = "A2/A1",
         .lo = -0.5,
         .hi = 0.5,
         .typical = 0.01,
         .name = "shaking with a second harmonic, a quarter of its period ahead",
         .look = "a line at twice the frequency, locked in phase; one turning point is sharper than the other",
         .keys = "wall.motion of kind harmonic: of the largest along each axis, at twice its frequency",
         .extend = [](Scene& s, double d) { distort(s, d, 90 * degree); }},
        {.id = "exc.phase",
         .family = "excitation",
         .symbol = "phase",
         .unit = "deg",
         .lo = -180,
         .hi = 180,
         .typical = 1,
         .turns = true,
         .name = "sideways shaking that is ahead of the upright one",
         .look = "the orbit opens to an ellipse; circulation changes its sign with it",
         .keys = "wall.motion.phase_deg of harmonics along x and z",
         .extend = [](Scene& s, double d) { shake_sideways(s, [&](auto& part) { part.phase += d * degree; }); }},
        {.id = "exc.sideways",
         .family = "excitation",
         .symbol = "ln(amplitude factor)",
         .lo = -1.5,
         .hi = 1.5,
         .typical = 0.05,
         .beds = true,
         .name = "sideways shaking that is wider or narrower than the scene's",
         .look = "drives circulation the harder the wider; nothing where it is in phase with the upright shaking",
         .keys = "wall.motion.amplitude_m of harmonics along x and z, times a factor",
         .extend = [](Scene& s, double d) { shake_sideways(s, [&](auto& part) { part.amplitude *= std::exp(d); }); }},
        rocking(
            "exc.rocking", 0, "walls that rock in time with their upright shaking",
            "one side is shaken harder than the other: the bulk climbs away from it, slope and circulation together; "
            "two sensors, one on each side, show it"),
        rocking(
            "exc.rocking_ahead", 90, "walls that rock a quarter period ahead of their upright shaking",
            "one side goes up while the other comes down and the middle passes through rest: circulation, whose side "
            "is the rocking's; two sensors, one on each side, show it"),
    };
}

} // namespace tumble::diagnose
