#pragma once

#include <utility>
#include <vector>

/// The generator's own physics: one ball above a plate, in one dimension. It shares no line with src/, so that a test
/// that finds what it hid does not find a mistake of its own.
namespace blind {

/// What is true of an experiment, the hidden effects among it. Null values are those of the baseline.
struct Ball {
    double radius = 0;      // m
    double mass = 0;        // kg
    double modulus = 0;     // Pa, effective: 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2
    double shear = 0;       // Pa, effective: 1/G* = (2-nu1)/G1 + (2-nu2)/G2; of balls that strike obliquely
    double restitution = 0; // at 1 m/s
    double gravity = 9.81;  // m/s2
    double shaken = 0;      // m, amplitude of its plate, which begins at rest at its lowest: a (1 - cos 2 pi f t)
    double shaken_at = 0;   // Hz
    // Listed effects.
    double exponent = 0;  // restitution (v / 1 m/s)^-exponent
    double linear = 0;    // N s/m
    double quadratic = 0; // N s2/m2
    double adhesion = 0;  // J/m2, work of adhesion
    // Effects that no library has.
    double by_impact = 0;          // restitution changes by this share from impact to impact (warms up)
    double plate_amplitude = 0;    // m/s, speed of a plate that swings
    double plate_frequency = 0;    // Hz
    double plate_phase = 0;        // rad
    double sticks = 0;             // s, held at every impact
    double rough = 0;              // share by which restitution scatters from impact to impact
    unsigned long long throws = 0; // which scatter it is
    double magnus = 0;             // what turns a flight per unit of spin; a = magnus spin x v
};

/// Restitution of an impact, the `impact`th from 0, that begins at `t` with speed `v` upwards (m/s, negative).
/// Scatter is two-sided exponential, as of rough spheres (Montaine et al. 2011).
double rebound_of(const Ball& ball, double v, double t, int impact);

struct State {
    double t = 0, y = 0, v = 0; // s, m, m/s
};

/// Where the ball was: its steps, read between them by Hermite's cubic (exact in a fall without air).
class Path {
public:
    explicit Path(std::vector<State> steps) : steps_(std::move(steps)) {}
    [[nodiscard]] double at(double t) const;
    [[nodiscard]] double end() const { return steps_.back().t; }

private:
    std::vector<State> steps_;
};

/// The height of the ball's centre above the plate until `duration`, released at rest at `height` at time 0.
/// Flights: exact where nothing drags, else Runge and Kutta's fourth order. Contacts: the same, of Hertz's spring with
/// Tsuji's dashpot (Tsuji, Tanaka, Ishida 1992), at a seventh of the solver's step; 2 pi w R holds back as long as they
/// touch (Derjaguin, Muller and Toporov 1975).
Path path_of(const Ball& ball, double height, double duration);

} // namespace blind
