#pragma once

#include <cmath>
#include <random>

namespace blind {

/// Numbers that are the same on every machine: the engine's bits are fixed by the standard, its distributions are not.
class Random {
public:
    explicit Random(unsigned long long seed) : bits_(seed) {}
    double uniform(double lo = 0, double hi = 1) {
        return lo + (hi - lo) * static_cast<double>(bits_() >> 11) * 0x1.0p-53;
    }
    double normal() {
        return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * 3.14159265358979323846 * uniform());
    }
    bool chance(double probability) { return uniform() < probability; }
    int below(int n) { return static_cast<int>(uniform() * n); }
    unsigned long long bits() { return bits_(); }

private:
    std::mt19937_64 bits_;
};

} // namespace blind
