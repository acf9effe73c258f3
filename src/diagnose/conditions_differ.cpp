#include "diagnose/conditions_differ.h"

#include <set>

namespace tumble::diagnose {

namespace {

/// Slopes of all nuisances, and of this one in every condition by itself.
MatrixXd with_its_own(const Evidence& evidence, const std::string& what) {
    MatrixXd slopes = evidence.nuisances;
    for (std::size_t k = 0; k < evidence.directions.own.size(); ++k)
        if (evidence.directions.own[k] == what) {
            slopes.conservativeResize(Eigen::NoChange, slopes.cols() + 1);
            slopes.rightCols(1) = evidence.directions.prints.col(static_cast<Eigen::Index>(k));
        }
    return slopes;
}

} // namespace

std::optional<Differing> differing_in(const Evidence& evidence, const Settings& settings) {
    const std::set<std::string> all(evidence.directions.own.begin(), evidence.directions.own.end());
    const Projector nuisances(evidence.nuisances);
    const double tries = static_cast<double>(all.size());
    std::optional<Differing> best;
    for (const std::string& what : all) {
        if (what.empty())
            continue;
        const MatrixXd slopes = with_its_own(evidence, what);
        const Projector fitted(slopes);
        Differing one{.what = what,
                      .gain = fitted.inside(evidence.residual) - nuisances.inside(evidence.residual),
                      .numbers = fitted.rank() - nuisances.rank()};
        one.p = adequacy_of(evidence.residual, slopes, evidence.directions, evidence.degrees).p();
        const bool more_than_chance =
            one.numbers > 0 && tries * hotelling_tail(one.gain, one.numbers, evidence.degrees) < settings.alpha_gate;
        if (more_than_chance && one.p > settings.alpha_adequacy && (!best || one.gain > best->gain))
            best = one;
    }
    return best;
}

} // namespace tumble::diagnose
