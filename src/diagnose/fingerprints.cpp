#include "diagnose/fingerprints.h"

#include <cmath>
#include <limits>

namespace tumble::diagnose {

namespace {

constexpr double twins = 1e-9; // of a share: of directions that are the same the first one counts

std::optional<Along> along(const VectorXd& own, const VectorXd& rest, double length) {
    const double left = own.norm();
    if (left < nearly_used_up)
        return std::nullopt;
    const double z = own.dot(rest) / left;
    return Along{.slope = z / (left * length), .error = 1 / (left * length), .z = z};
}

} // namespace

std::vector<Fingerprint> fingerprints_of(const Evidence& evidence, const Decision& decision) {
    const Directions& directions = evidence.directions;
    if (directions.names.empty())
        return {};
    const Projector scene(evidence.nuisances);
    const VectorXd rest = scene.out(evidence.residual);
    const std::optional<Projector> best =
        decision.best ? std::optional<Projector>(decision.best->slopes) : std::nullopt;
    const VectorXd rest_of_best = best ? best->out(decision.best->residual) : VectorXd();
    std::vector<Fingerprint> all;
    for (std::size_t k = 0; k < directions.names.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        const VectorXd print = directions.prints.col(column);
        const double length =
            column < directions.lengths.size() ? directions.lengths[column] : std::numeric_limits<double>::quiet_NaN();
        Fingerprint one{.what = directions.names[k],
                        .unit = k < directions.units.size() ? directions.units[k] : "",
                        .of_condition = k < directions.own.size() && !directions.own[k].empty(),
                        .scene = along(scene.out(print), rest, length),
                        .best = {}};
        if (best)
            one.best = along(best->out(print), rest_of_best, length);
        all.push_back(std::move(one));
    }
    return all;
}

std::optional<Likeness> likest(const Evidence& evidence, int cause, bool of_conditions) {
    const Projector scene(evidence.nuisances);
    const VectorXd effect = scene.out(VectorXd(evidence.effects.col(cause)));
    std::optional<Likeness> found;
    for (std::size_t k = 0; k < evidence.directions.names.size() && effect.norm() > 0; ++k) {
        const VectorXd own = scene.out(VectorXd(evidence.directions.prints.col(static_cast<Eigen::Index>(k))));
        const bool of_condition = k < evidence.directions.own.size() && !evidence.directions.own[k].empty();
        if (own.norm() < nearly_used_up || (of_condition && !of_conditions))
            continue;
        const double share = std::pow(own.dot(effect) / (own.norm() * effect.norm()), 2);
        if (!found || share > found->share + twins)
            found = Likeness{k, share};
    }
    return found;
}

} // namespace tumble::diagnose
