#include "diagnose/decide.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr std::size_t most_followed = 6;
constexpr double followed_by_chance = 0.0027; // P(|z| > 3), shared by all directions that are tried

/// How far a residual goes along each direction of no particular cause, in standard errors; without those that the fit
/// has nearly used up.
std::vector<Followed> along_prints(const Directions& directions, const Projector& fitted, const VectorXd& rest) {
    std::vector<Followed> all;
    for (Eigen::Index k = 0; k < directions.prints.cols(); ++k) {
        const VectorXd own = fitted.out(VectorXd(directions.prints.col(k)));
        if (own.norm() >= nearly_used_up)
            all.push_back({k < static_cast<Eigen::Index>(directions.names.size())
                               ? directions.names[static_cast<std::size_t>(k)]
                               : "",
                           own.dot(rest) / own.norm()});
    }
    return all;
}

} // namespace

Adequacy adequacy_of(const VectorXd& residual, const MatrixXd& slopes, const Directions& directions, double degrees) {
    const Projector fitted(slopes);
    const VectorXd rest = fitted.out(residual);
    const auto tail = [&](const MatrixXd& columns) {
        // Columns that the fit has nearly used up would bring rounding errors back to full length.
        MatrixXd left = fitted.out(columns);
        for (Eigen::Index k = 0; k < left.cols(); ++k)
            if (left.col(k).norm() < nearly_used_up)
                left.col(k).setZero();
        const Projector generic(left);
        return hotelling_tail(generic.inside(rest), generic.rank(), degrees);
    };
    double strongest = 1;
    const std::vector<Followed> prints = along_prints(directions, fitted, rest);
    for (const Followed& one : prints)
        strongest = std::min(strongest, static_cast<double>(prints.size()) * hotelling_tail(one.z * one.z, 1, degrees));
    return {tail(directions.blocks), tail(directions.prints), strongest, strongest_swing(rest, directions.courses)};
}

Following followed_by(const Evidence& evidence, const Decision& decision) {
    const Projector fitted(decision.best ? decision.best->slopes : evidence.nuisances);
    const VectorXd rest = fitted.out(decision.best ? decision.best->residual : evidence.residual);
    Following following;
    following.all = along_prints(evidence.directions, fitted, rest);
    const auto swing = strongest_swing(rest, evidence.directions.courses);
    following.tried = static_cast<int>(following.all.size()) + (swing ? 1 : 0);
    if (following.tried == 0)
        return following;
    following.gate = student_quantile(followed_by_chance / 2 / following.tried, evidence.degrees);
    if (swing) // as many standard errors as its probability is those of a direction
        following.all.push_back({fmt::format("a swing at {:.3g} Hz ({})", swing->frequency, swing->measure),
                                 normal_quantile(std::max(1e-300, swing->p / 2 / following.tried))});
    std::erase_if(following.all, [&](const Followed& one) { return std::abs(one.z) < following.gate; });
    std::sort(following.all.begin(), following.all.end(),
              [](const auto& a, const auto& b) { return std::abs(a.z) > std::abs(b.z); });
    following.all.resize(std::min(following.all.size(), most_followed));
    return following;
}

} // namespace tumble::diagnose
