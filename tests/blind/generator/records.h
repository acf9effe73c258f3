#pragma once

#include "experiment.h"
#include "random.h"

namespace blind {

/// Noise of the kind that laboratories have: mostly white, sometimes with memory, a slip here and there, rounded.
struct Dirt {
    double memory = 0;
    double outliers = 0;
    double step = 0;   // of the reading, in sigma
    double mains = 0;  // in sigma, 50 Hz
    double wander = 0; // in sigma, over a record
    bool drops_a_frame = false;
};

Dirt draw_dirt(Random& random);

/// All of it at once, and a zero that goes where it likes.
constexpr Dirt distracting{
    .memory = 0.4, .outliers = 0.01, .step = 0.3, .mains = 0.3, .wander = 0.3, .drops_a_frame = true};

/// CSV of every record from the `first` on; `clean`: readings_of the setup.
std::vector<std::string> records_of(const Setup& setup, std::size_t first, const Eigen::VectorXd& clean,
                                    const Dirt& dirt, Random& random);

} // namespace blind
