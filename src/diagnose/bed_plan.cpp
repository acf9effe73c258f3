#include "diagnose/bed_plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::diagnose {

namespace {

constexpr double told_apart = 5; // standard errors, of two causes from each other

/// A cause, or two of them, where they were fitted.
struct Rival {
    std::vector<int> causes;
    std::vector<double> amplitudes;
};

VectorXd change_of(const BedCondition& now, const Rival& rival) {
    VectorXd sum = VectorXd::Zero(now.mean.size());
    for (std::size_t k = 0; k < rival.causes.size(); ++k)
        sum += now.branches[static_cast<std::size_t>(rival.causes[k])].change(rival.amplitudes[k]);
    return sum;
}

/// Standard errors between two rivals, were these columns measured under all conditions in as many runs.
double apart(const BedModel& model, int seeds, const Rival& a, const Rival& b, int more) {
    double sum = 0;
    for (const BedCondition& now : model.conditions()) {
        if (now.measured.held_out)
            continue;
        BedCondition with = now;
        if (more >= 0 && std::find(now.columns.begin(), now.columns.end(), more) == now.columns.end()) {
            with.columns.push_back(more);
            with.measured.numbers.push_back({});
        }
        const VectorXd difference = with.measured_of(change_of(now, a) - change_of(now, b));
        if (!difference.allFinite())
            return 0;
        sum += whitened(with.covariance(seeds), difference).squaredNorm();
    }
    return std::sqrt(sum);
}

double least_apart(const BedModel& model, int seeds, const std::vector<Rival>& rivals, int more) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < rivals.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, apart(model, seeds, rivals[i], rivals[j], more));
    return least;
}

int repeats_for(double separation) {
    const double needed = std::ceil((told_apart / separation) * (told_apart / separation));
    return needed < 1000 ? std::max(1, static_cast<int>(needed)) : 0;
}

} // namespace

std::vector<Proposal> bed_proposals(const Beds& beds, const BedModel& model, const Decision& decision) {
    std::vector<Rival> rivals;
    for (const int k : decision.pairs.empty() ? decision.causes : std::vector<int>{})
        if (const Seen& seen = decision.seen[static_cast<std::size_t>(k)]; seen.refit)
            rivals.push_back({{k}, {seen.refit->amplitude[0]}});
    if (rivals.size() < 2)
        return {};
    const double now = least_apart(model, beds.seeds(), rivals, -1);
    std::vector<Proposal> proposals{
        {"more-runs", "measure the same numbers again, and simulate as many more seeds", now, repeats_for(now)}};
    for (std::size_t m = 0; m < beds.measures().size(); ++m) {
        const auto column = static_cast<int>(m);
        const double with = least_apart(model, beds.seeds(), rivals, column);
        if (with > 1.05 * now)
            proposals.push_back({beds.measures()[m], fmt::format("measure {} of the bed, too", beds.measures()[m]),
                                 with, repeats_for(with)});
    }
    std::stable_sort(proposals.begin(), proposals.end(),
                     [](const Proposal& a, const Proposal& b) { return a.separation > b.separation; });
    return proposals;
}

} // namespace tumble::diagnose
