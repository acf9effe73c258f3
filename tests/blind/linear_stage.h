#pragma once

#include "base/text.h"
#include "diagnose/verdict.h"
#include "laboratory.h"

#include <Eigen/QR>
#include <doctest/doctest.h>
#include <map>

/// The linear stage of blind tests: the slopes of one experiment on the solver, and thousands of cases decided on them.
namespace blind {

using namespace tumble;
using namespace tumble::diagnose;

/// One case by order, diagnosed on the solver; its verdict as a sentence.
inline std::string case_of(const Order& order, unsigned long long seed, Diagnosis& diagnosis) {
    Random random(seed);
    const Case made = make_case(order, random);
    REQUIRE(made.possible);
    auto result = diagnosed(made);
    REQUIRE_MESSAGE(result, to_string(result.problems()));
    diagnosis = std::move(*result);
    const Adequacy& winner = diagnosis.decision.winner;
    return fmt::format("{} (adequacy of the winner: blocks {:.2g}, prints {:.2g}, swings {:.2g} at {:.3g} Hz)",
                       verdict_of(diagnosis), winner.blocks, winner.prints, winner.swing ? winner.swing->p : 1,
                       winner.swing ? winner.swing->frequency : 0);
}

/// The evidence in coordinates of all its directions: every product of two of its vectors is kept, and rows are few.
/// Rows of priors stay what they are.
inline Evidence compressed(const Evidence& full) {
    const auto readings = static_cast<Eigen::Index>(std::count_if(
        full.directions.condition.begin(), full.directions.condition.end(), [](int c) { return c >= 0; }));
    const Eigen::Index priors = full.residual.size() - readings;
    MatrixXd all(readings, full.nuisances.cols() + full.effects.cols() + full.directions.blocks.cols() +
                               full.directions.prints.cols());
    all << full.nuisances.topRows(readings), full.effects.topRows(readings), full.directions.blocks.topRows(readings),
        full.directions.prints.topRows(readings);
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(unit_columns(all));
    const MatrixXd basis = qr.householderQ() * MatrixXd::Identity(readings, qr.rank());
    const auto few_rows = [&](const MatrixXd& columns) {
        MatrixXd few(basis.cols() + priors, columns.cols());
        few << basis.transpose() * columns.topRows(readings), columns.bottomRows(priors);
        return few;
    };
    Evidence few;
    few.causes = full.causes;
    few.nuisance = full.nuisance;
    few.residual = few_rows(full.residual);
    few.nuisances = few_rows(full.nuisances);
    few.effects = few_rows(full.effects);
    few.directions.blocks = few_rows(full.directions.blocks);
    few.directions.prints = few_rows(full.directions.prints);
    few.directions.condition.assign(static_cast<std::size_t>(basis.cols()), 0);
    few.directions.condition.resize(static_cast<std::size_t>(few.residual.size()), -1);
    few.directions.conditions = {"all"};
    return few;
}

struct Tally {
    int right = 0, wrong = 0, ambiguous_with = 0, ambiguous_without = 0, quiet = 0, unknown = 0, pairs = 0;
};

/// Cases with an effect of that size and noise, decided as if all were linear.
inline Tally linear_cases(const Evidence& evidence, const VectorXd& effect, int truth, int count, Random& random,
                          const Settings& settings = {}) {
    Tally tally;
    Evidence now = evidence;
    const Projector nuisances(evidence.nuisances);
    for (int k = 0; k < count; ++k) {
        VectorXd noise(evidence.residual.size());
        for (double& one : noise)
            one = random.normal();
        now.residual = nuisances.out(VectorXd(effect + noise));
        const Decision decision =
            decide(now, settings, [&](const std::vector<int>& causes) { return refit_linear(now, causes); });
        now.gate = decision.gate;
        const bool with = std::find(decision.causes.begin(), decision.causes.end(), truth) != decision.causes.end();
        if (decision.outcome == Outcome::named)
            ++(with ? tally.right : tally.wrong);
        else if (decision.outcome == Outcome::ambiguous)
            ++(with ? tally.ambiguous_with : tally.ambiguous_without);
        else if (decision.outcome == Outcome::consistent)
            ++tally.quiet;
        else
            ++(decision.outcome == Outcome::two_causes ? tally.pairs : tally.unknown);
    }
    return tally;
}

inline Eigen::Index column_of(const Evidence& evidence, const std::string& id) {
    for (std::size_t k = 0; k < evidence.causes.size(); ++k)
        if (evidence.causes[k].id == id)
            return static_cast<Eigen::Index>(k);
    FAIL(id);
    return 0;
}

/// How much of a cause's effect the nearest rival outside its class leaves.
inline double separable_length(const Evidence& evidence, int cause) {
    const VectorXd own = Projector(evidence.nuisances).out(VectorXd(evidence.effects.col(cause)));
    double least = own.norm();
    for (Eigen::Index k = 0; k < evidence.effects.cols(); ++k) {
        MatrixXd rival(evidence.residual.size(), evidence.nuisances.cols() + 1);
        rival << evidence.nuisances, evidence.effects.col(k);
        const double left = Projector(rival).out(own).norm();
        if (k != cause && left > 0.02 * own.norm())
            least = std::min(least, left);
    }
    return least;
}

/// Slopes on the solver of an experiment in which nothing is hidden, once for all cases.
inline const Evidence& evidence_of_nothing(Bench bench) {
    static std::map<Bench, Evidence> known;
    if (!known.contains(bench)) {
        Diagnosis diagnosis;
        case_of({.kind = "null", .effects = {}, .wanted = 5, .bench = bench}, 7, diagnosis);
        known[bench] = std::move(diagnosis.evidence);
    }
    return known[bench];
}

} // namespace blind
