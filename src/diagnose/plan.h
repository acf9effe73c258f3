#pragma once

#include "diagnose/decide.h"

namespace tumble::diagnose {

/// An experiment that could be done beside those that were, and what it would tell.
struct Proposal {
    std::string id;
    std::string sentence;  // what to do
    double separation = 0; // standard errors between the two causes that stay nearest, with the data there are
    int repeats = 0;       // of the experiment, to reach 5 standard errors; 0: it never does
};

/// Every experiment of the catalogue, the most telling first. `values`: where the nuisances are; `amplitudes`: what the
/// causes, numbers of the model's, would have to be. Experiments that cannot be simulated are left out.
std::vector<Proposal> proposals_for(const SceneText& scene, const Model& model, const std::vector<Nuisance>& nuisances,
                                    const Noise& noise, const Simulate& simulate, const VectorXd& values,
                                    const std::vector<int>& causes, const std::vector<double>& amplitudes);

} // namespace tumble::diagnose
