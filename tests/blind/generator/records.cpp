#include "records.h"

#include <cmath>
#include <fmt/format.h>

namespace blind {

namespace {

/// One channel's errors, in sigma, reading by reading.
class Errors {
public:
    Errors(const Dirt& dirt, std::size_t readings, Random& random)
        : dirt_(dirt), walk_(dirt.wander / std::sqrt(static_cast<double>(readings))), random_(random),
          error_(random.normal()), phase_(random.uniform(0, 6.283185307179586)) {}

    double at(double time) {
        error_ = dirt_.memory * error_ + std::sqrt(1 - dirt_.memory * dirt_.memory) * random_.normal();
        double noise = error_ + dirt_.mains * std::sin(314.1592653589793 * time + phase_);
        if (random_.chance(dirt_.outliers))
            noise += (random_.chance(0.5) ? 1 : -1) * random_.uniform(8, 20);
        if (walk_ > 0)
            wandered_ += walk_ * random_.normal();
        return noise + wandered_;
    }

private:
    const Dirt& dirt_;
    double walk_;
    Random& random_;
    double error_, phase_, wandered_ = 0;
};

/// One record's readings with their errors; `clean`: all channels one after the other, then the clock's from `clock`
/// on.
std::string record_of(const Setup& setup, const Trial& trial, const double* clean, const double* clock,
                      const Dirt& dirt, Random& random) {
    const std::vector<double> times = times_of(setup, trial);
    const std::vector<Channel> channels = channels_of(setup.bench);
    std::string csv = "time_s";
    for (const Channel& channel : channels)
        csv += fmt::format(",{}_{}", channel.head, channel.unit);
    csv += setup.clock ? ",clock_ms\n" : "\n";
    const int lost = dirt.drops_a_frame ? random.below(static_cast<int>(times.size())) : -1;
    std::vector<Errors> errors;
    for (std::size_t c = 0; c < channels.size(); ++c)
        errors.emplace_back(dirt, times.size(), random);
    for (std::size_t k = 0; k < times.size(); ++k) {
        std::string row = fmt::format("{:.6f}", times[k]);
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const double steps = clean[c * times.size() + k] + errors[c].at(times[k]);
            const double reading = std::round(steps / dirt.step) * dirt.step * setup.sigma;
            row += fmt::format(",{:.4f}", channels[c].scale * reading);
        }
        if (static_cast<int>(k) == lost)
            continue;
        if (setup.clock)
            row += fmt::format(",{:.4f}", clock[k] + random.normal());
        csv += row + '\n';
    }
    return csv;
}

} // namespace

Dirt draw_dirt(Random& random) {
    Dirt dirt;
    if (random.chance(0.3))
        dirt.memory = random.uniform(0, 0.4);
    dirt.outliers = 0.005;
    dirt.step = random.chance(0.3) ? 0.3 : 0.01;
    dirt.mains = random.chance(0.2) ? 0.3 : 0;
    dirt.drops_a_frame = random.chance(0.3);
    return dirt;
}

std::vector<std::string> records_of(const Setup& setup, std::size_t first, const Eigen::VectorXd& clean,
                                    const Dirt& dirt, Random& random) {
    const std::size_t channels = channels_of(setup.bench).size();
    std::vector<std::string> records;
    std::size_t row = 0, clock = 0;
    for (const Trial& trial : setup.trials)
        clock += channels * times_of(setup, trial).size();
    for (std::size_t r = 0; r < setup.trials.size(); ++r) {
        const Trial& trial = setup.trials[r];
        if (r >= first)
            records.push_back(record_of(setup, trial, clean.data() + row, setup.clock ? clean.data() + clock : nullptr,
                                        dirt, random));
        const std::size_t count = times_of(setup, trial).size();
        row += channels * count;
        clock += count;
    }
    return records;
}

} // namespace blind
