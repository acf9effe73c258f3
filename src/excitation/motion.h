#pragma once

#include "excitation/lines.h"
#include "scene/motion.h"

#include <complex>

/// Displacement from acceleration, and the wall motion that makes it.
namespace tumble::excitation {

/// U with displacement = Im(U exp(i 2 pi f (t - reference))), m: -a / (2 pi f)^2. The thesis prints (5.5) as a / (2 pi
/// f), which is a speed; its own program squares.
std::complex<double> displacement(const Line& line, std::size_t channel);

/// Standard deviation of either part of it where the frequency is common, m.
double displacement_se(const Line& line, std::size_t channel);

/// An elliptic orbit in the plane of two axes.
struct Orbit {
    double half_long = 0, half_short = 0; // m
    double tilt = 0;                      // rad, of the long axis from the first axis towards the second
    double phase = 0, phase_se = 0;       // rad, of the second axis before the first
    double area = 0;                      // m2, above 0: turns from the first axis towards the second

    /// The phase differs from 0 and from 180 degrees by more than two standard errors.
    [[nodiscard]] bool is_open() const;
};
Orbit orbit_of(const Line& line, std::size_t first, std::size_t second);

/// Is this line the wall's own motion? What the mains put into the cable is not.
bool moves_wall(const Line& line);

/// One harmonic per line and channel of the first sensor that stands out of the noise, from `start` (s) of a scene on;
/// there the record begins.
scene::WallMotion motion_of(const Excitation& found, const std::vector<Channel>& channels, double start);

/// A harmonic of that displacement.
scene::Harmonic harmonic_of(std::complex<double> displacement, int axis, double frequency, double start);

} // namespace tumble::excitation
