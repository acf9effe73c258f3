#include "excitation/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::excitation {

namespace {

constexpr double pi = std::numbers::pi;

double per_square(double frequency) {
    return 1 / std::pow(2 * pi * frequency, 2);
}

} // namespace

std::complex<double> displacement(const Line& line, std::size_t channel) {
    const Component& component = line.on[channel];
    return -std::polar(component.acceleration * per_square(line.frequency), component.phase);
}

double displacement_se(const Line& line, std::size_t channel) {
    const Component& component = line.on[channel];
    return component.acceleration * component.beside_se * per_square(line.frequency);
}

bool Orbit::is_open() const {
    return std::abs(std::remainder(phase, pi)) > 2 * phase_se;
}

Orbit orbit_of(const Line& line, std::size_t first, std::size_t second) {
    const std::complex<double> i(0, 1), p = displacement(line, first), q = displacement(line, second);
    // Two circles, against the clock and with it.
    const std::complex<double> against = (p + i * q) / (2.0 * i), with = -(std::conj(p) + i * std::conj(q)) / (2.0 * i);
    Orbit orbit;
    orbit.half_long = std::abs(against) + std::abs(with);
    orbit.half_short = std::abs(std::abs(against) - std::abs(with));
    orbit.tilt = std::remainder(0.5 * (std::arg(against) + std::arg(with)), pi);
    orbit.phase = std::remainder(std::arg(q) - std::arg(p), 2 * pi);
    orbit.phase_se = std::hypot(line.on[first].beside_se, line.on[second].beside_se);
    orbit.area = pi * (std::norm(against) - std::norm(with));
    return orbit;
}

bool moves_wall(const Line& line) {
    return line.kind != Kind::mains;
}

scene::Harmonic harmonic_of(std::complex<double> displacement, int axis, double frequency, double start) {
    scene::Harmonic harmonic;
    harmonic.active.start = start;
    harmonic.axis = axis;
    harmonic.amplitude = std::abs(displacement);
    harmonic.frequency = frequency;
    harmonic.phase = std::arg(displacement);
    return harmonic;
}

scene::WallMotion motion_of(const Excitation& found, const std::vector<Channel>& channels, double start) {
    scene::WallMotion motion;
    for (const Line& line : found.lines)
        for (std::size_t k = 0; k < channels.size(); ++k)
            if (channels[k].sensor == 0 && line.on[k].seen && moves_wall(line))
                motion.harmonics.push_back(harmonic_of(displacement(line, k), channels[k].axis, line.frequency, start));
    std::stable_sort(motion.harmonics.begin(), motion.harmonics.end(),
                     [](const scene::Harmonic& a, const scene::Harmonic& b) { return a.axis < b.axis; });
    return motion;
}

} // namespace tumble::excitation
