#pragma once

#include "diagnose/model.h"

#include <optional>

namespace tumble::diagnose {

/// What would explain the data without any effect: a number of a contact that nobody gave as a nuisance, or heights
/// that are those of a ball's lowest point.
struct PlainReason {
    std::string what;      // "with pair.leather-wood.restitution = 0.78 in place of 0.8"
    std::string fix;       // what to do about it
    double chi_square = 0; // that it leaves, priors included, by the noise it was asked with
};

/// What is asked, and of what.
struct PlainQuestion {
    const SceneText& scene;
    const std::vector<Record>& records; // that are fitted
    const std::vector<Nuisance>& nuisances;
    const Simulate& simulate;
    const Settings& settings;
    const Noise& noise; // by which chi-square is told
};

/// What it took to answer.
struct Effort {
    int runs = 0;
    double simulated = 0; // s
};

/// The reason that leaves nothing but noise, by the scatter that it shows itself and that is no more than was known of
/// it, if there is one; of several the one that leaves least.
std::optional<PlainReason> plain_reason(const PlainQuestion& question, Effort& effort);

} // namespace tumble::diagnose
