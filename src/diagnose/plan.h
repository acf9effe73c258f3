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

/// What a decision leaves to be told apart: the causes that it cannot; else the one that it names, and who comes
/// nearest to it by what the data could tell.
std::vector<int> rivals_in(const Decision& decision);

/// Times that an experiment must be made, for two causes so many standard errors apart, to reach 5; 0: more than 1000.
int repeats_for(double separation);

/// Every experiment of the catalogue, the most telling first. `values`: where the nuisances are; `amplitudes`: what the
/// causes, numbers of the model's, would have to be. Those that are done
/// already are left out; those that cannot be simulated, too, with a warning that says why.
std::vector<Proposal> proposals_for(const SceneText& scene, const Model& model, const std::vector<Nuisance>& nuisances,
                                    const Noise& noise, const Simulate& simulate, const VectorXd& values,
                                    const std::vector<int>& causes, const std::vector<double>& amplitudes,
                                    Problems& warnings);

} // namespace tumble::diagnose
