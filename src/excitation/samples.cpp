#include "excitation/samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::excitation {

double Samples::gain(double frequency) const {
    const double half = std::numbers::pi * frequency * fine;
    if (thinning == 1 || half == 0)
        return 1;
    return std::pow(std::sin(thinning * half) / (thinning * std::sin(half)), 2);
}

Samples samples_of(const Record& record, double up_to) {
    Samples samples;
    samples.fine = record.step();
    samples.thinning = std::max(1, static_cast<int>(1 / (8 * up_to * samples.fine)));
    samples.spacing = samples.thinning * samples.fine;
    const auto m = static_cast<std::size_t>(samples.thinning);
    const auto thinned = [&](const std::vector<double>& all) {
        std::vector<double> few;
        for (std::size_t centre = m - 1; centre + m <= all.size(); centre += m) {
            double sum = static_cast<double>(m) * all[centre];
            for (std::size_t k = 1; k < m; ++k)
                sum += static_cast<double>(m - k) * (all[centre - k] + all[centre + k]);
            few.push_back(sum / static_cast<double>(m * m));
        }
        return few;
    };
    const std::vector<double> time = thinned(record.time);
    for (const Channel& channel : record.channels)
        samples.signals.push_back({time, thinned(channel.values), 0.5 * (record.time.front() + record.time.back())});
    return samples;
}

} // namespace tumble::excitation
