#include "diagnose/instrument.h"

#include <algorithm>

namespace tumble::diagnose {

namespace {

double truth_time(const Instrument& instrument, double time) {
    return (time - instrument.clock_offset) / (1 + instrument.clock_rate);
}

} // namespace

std::vector<double> seen_through(const Instrument& instrument, const Signal& truth, std::span<const double> times,
                                 double largest) {
    Signal signal = instrument.low_pass > 0 ? truth.low_passed(instrument.low_pass, truth.value.front()) : truth;
    if (instrument.high_pass > 0) {
        const Signal slow = signal.low_passed(1 / instrument.high_pass, 0);
        for (std::size_t k = 0; k < signal.value.size(); ++k)
            signal.value[k] -= slow.value[k];
    }
    const double limit = (1 - instrument.clipping) * largest;
    std::vector<double> seen;
    seen.reserve(times.size());
    for (const double time : times) {
        const double t = truth_time(instrument, time);
        const double value = signal.at(t);
        const double clipped = instrument.clipping > 0 ? std::clamp(value, -limit, limit) : value;
        seen.push_back((1 + instrument.gain) * clipped + instrument.bias + instrument.drift * t);
    }
    return seen;
}

std::vector<double> clock_seen_through(const Instrument& instrument, std::span<const double> times) {
    std::vector<double> seen;
    for (const double time : times)
        seen.push_back(truth_time(instrument, time));
    return seen;
}

} // namespace tumble::diagnose
