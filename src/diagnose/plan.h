#pragma once

#include "diagnose/decide.h"

namespace tumble::diagnose {

/// What another apparatus must give, in times of what there is without it.
constexpr double worth_it = 1.05;
/// Standard errors between two explanations that tell them apart.
constexpr double told_apart = 5;

/// An experiment that could be done beside those that were, and what it would tell.
struct Proposal {
    std::string id;
    std::string sentence;  // what to do
    double separation = 0; // standard errors between the two explanations that stay nearest, with the data there are
    int repeats = 0;       // of the experiment, to reach 5 standard errors; 0: it never does
    double reached = 0;    // standard errors after so many
    double before = 0;     // standard errors with what was measured already
};

/// An explanation that an experiment is to hold against others: a cause, or two of them, where they were fitted.
struct Rival {
    std::vector<int> causes;
    VectorXd amplitudes;
};

/// What a decision leaves to be told apart, causes or pairs of them: those that it cannot; else the one that it names,
/// and who comes nearest to it by what the data could tell. Fewer than two: there is nothing to tell.
std::vector<std::vector<int>> rivals_in(const Decision& decision);

/// An experiment that sets two explanations `separation` standard errors apart with all the data, `before` without it:
/// how often it must be made to reach 5, for squares add up, and what is reached then. More than 1000 times: never.
Proposal proposal_of(std::string id, std::string sentence, double separation, double before = 0);

/// Every experiment of the catalogue, the most telling first. `values`: where the nuisances are. Those that are done
/// already are left out; those that cannot be simulated, too, with a warning that says why.
std::vector<Proposal> proposals_for(const SceneText& scene, Model& model, const std::vector<Nuisance>& nuisances,
                                    const Noise& noise, const Simulate& simulate, const VectorXd& values,
                                    const std::vector<Rival>& rivals, Problems& warnings);

} // namespace tumble::diagnose
