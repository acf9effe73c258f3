#include "diagnose/branch.h"

#include <algorithm>
#include <cmath>

namespace tumble::diagnose {

namespace {

constexpr double quarter_turn = 90; // deg
constexpr double radian = 57.29577951308232;
constexpr double too_near = 0.4; // of the other amplitude: scatter there would bend a parabola at will

} // namespace

VectorXd Branch::change(double amplitude) const {
    if (wave)
        return std::sin(amplitude / radian) * first + (1 - std::cos(amplitude / radian)) * second;
    return amplitude * first + amplitude * amplitude * second;
}

VectorXd Branch::slope(double amplitude) const {
    if (wave)
        return (std::cos(amplitude / radian) * first + std::sin(amplitude / radian) * second) / radian;
    return first + 2 * amplitude * second;
}

double Branch::far_end() const {
    return wave ? quarter_turn : hi >= -lo ? hi : lo;
}

double Branch::other_end() const {
    const double far = far_end(), other = far > 0 ? lo : hi;
    return wave ? -far : other != 0 ? other : far / 2;
}

VectorXd Branch::odd() const {
    return wave ? first : VectorXd(far_end() * first);
}

VectorXd Branch::even() const {
    return wave ? second : VectorXd(far_end() * far_end() * second);
}

VectorXd Branch::direction(bool mostly_even) const {
    return mostly_even ? VectorXd(change(far_end()) / far_end()) : slope(0);
}

Branch Branch::flat(Eigen::Index numbers, double lo, double hi) {
    return {lo, hi, VectorXd::Zero(numbers), VectorXd::Zero(numbers), false};
}

Branch Branch::through(const std::vector<double>& amplitudes, const std::vector<VectorXd>& changes, bool turns) {
    Branch branch = flat(changes[0].size(), std::min(0.0, amplitudes[0]), std::max(0.0, amplitudes[0]));
    if (amplitudes.size() == 1) {
        branch.first = changes[0] / amplitudes[0];
        return branch;
    }
    const double a = amplitudes[0], b = amplitudes[1];
    branch.lo = std::min(branch.lo, b);
    branch.hi = std::max(branch.hi, b);
    if (turns && a == quarter_turn && b == -quarter_turn) {
        branch.wave = true;
        branch.lo = -2 * quarter_turn;
        branch.hi = 2 * quarter_turn;
        branch.first = (changes[0] - changes[1]) / 2;
        branch.second = (changes[0] + changes[1]) / 2;
        return branch;
    }
    if (std::min(std::abs(a), std::abs(b)) < too_near * std::max(std::abs(a), std::abs(b))) {
        branch.first = std::abs(a) > std::abs(b) ? changes[0] / a : changes[1] / b;
        return branch;
    }
    branch.second = (changes[0] / a - changes[1] / b) / (a - b);
    branch.first = changes[0] / a - a * branch.second;
    return branch;
}

} // namespace tumble::diagnose
