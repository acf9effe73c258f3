#include "diagnose/conditions_differ.h"

#include <cmath>
#include <set>

namespace tumble::diagnose {

namespace {

constexpr double same_readings = 0.005; // of an effect that a nuisance leaves: less is rounding of the slopes

/// Of every kind of column the one that explains most, with all nuisances; `columns(what)` are those of a kind.
template <class Columns>
std::optional<Besides> best_of(const Evidence& evidence, const Settings& settings, std::set<std::string> kinds,
                               Columns columns) {
    kinds.erase("");
    const Projector nuisances(evidence.nuisances);
    std::optional<Besides> best;
    for (const std::string& what : kinds) {
        const MatrixXd more = columns(what);
        MatrixXd slopes(evidence.nuisances.rows(), evidence.nuisances.cols() + more.cols());
        slopes << evidence.nuisances, more;
        const Projector fitted(slopes);
        Besides one{.what = what,
                    .gain = fitted.inside(evidence.residual) - nuisances.inside(evidence.residual),
                    .numbers = fitted.rank() - nuisances.rank()};
        one.p = adequacy_of(evidence.residual, slopes, evidence.directions, evidence.degrees).p();
        const bool more_than_chance =
            one.numbers > 0 &&
            static_cast<double>(kinds.size()) * hotelling_tail(one.gain, one.numbers, evidence.degrees) <
                settings.alpha_gate;
        if (more_than_chance && one.p > settings.alpha_adequacy && (!best || one.gain > best->gain))
            best = one;
    }
    return best;
}

std::set<std::string> distinct(const std::vector<std::string>& words) {
    return {words.begin(), words.end()};
}

Eigen::Index readings_of(const Evidence& evidence) {
    return evidence.residual.size() - static_cast<Eigen::Index>(evidence.beforehand.size());
}

} // namespace

std::optional<Besides> differing_in(const Evidence& evidence, const Settings& settings) {
    const auto& own = evidence.directions.own;
    auto best = best_of(evidence, settings, distinct(own), [&](const std::string& what) {
        MatrixXd columns(evidence.residual.size(), 0);
        for (std::size_t k = 0; k < own.size(); ++k)
            if (own[k] == what) {
                columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
                columns.rightCols(1) = evidence.directions.prints.col(static_cast<Eigen::Index>(k));
            }
        return columns;
    });
    const Projector nuisances(evidence.nuisances);
    const VectorXd residual = nuisances.out(evidence.residual);
    double most = 0;
    for (std::size_t k = 0; best && k < own.size() && k < evidence.directions.names.size(); ++k)
        if (own[k] == best->what) {
            const VectorXd left = nuisances.out(VectorXd(evidence.directions.prints.col(static_cast<Eigen::Index>(k))));
            const double z = std::abs(left.dot(residual)) / std::max(left.norm(), 1e-300);
            if (left.norm() > nearly_used_up && z > most) {
                most = z;
                best->most = evidence.directions.names[k];
            }
        }
    return best;
}

std::optional<Besides> overstated_in(const Evidence& evidence, const Settings& settings) {
    const auto& known = evidence.beforehand;
    return best_of(evidence, settings, distinct(known), [&](const std::string& what) {
        MatrixXd columns(evidence.residual.size(), 0);
        for (std::size_t k = 0; k < known.size(); ++k)
            if (known[k] == what) { // what was said of it weighs nothing
                columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
                columns.rightCols(1) =
                    VectorXd::Unit(columns.rows(), readings_of(evidence) + static_cast<Eigen::Index>(k));
            }
        return columns;
    });
}

std::vector<std::string> alike_to(const Evidence& evidence, const std::string& nuisance) {
    MatrixXd slopes(readings_of(evidence), 0);
    for (std::size_t k = 0; k < evidence.beforehand.size(); ++k)
        if (evidence.beforehand[k] == nuisance)
            for (Eigen::Index column = 0; column < evidence.nuisances.cols(); ++column)
                if (evidence.nuisances(readings_of(evidence) + static_cast<Eigen::Index>(k), column) != 0) {
                    slopes.conservativeResize(Eigen::NoChange, slopes.cols() + 1);
                    slopes.rightCols(1) = evidence.nuisances.col(column).head(slopes.rows());
                }
    const Projector one(slopes);
    std::vector<std::string> alike;
    for (std::size_t k = 0; k < evidence.causes.size(); ++k) {
        const VectorXd effect = evidence.effects.col(static_cast<Eigen::Index>(k)).head(slopes.rows());
        const Cause& cause = evidence.causes[k];
        const double most = effect.norm() * std::max(std::abs(cause.lo), std::abs(cause.hi));
        if (most > least_visible && one.out(effect).norm() < same_readings * effect.norm())
            alike.push_back(cause.id);
    }
    return alike;
}

} // namespace tumble::diagnose
