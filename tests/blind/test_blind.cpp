// The fast stage of the blind tests: some cases on the real solver, thousands on its slopes. tests/blind/judge.py is
// the large one.
#include "base/text.h"
#include "diagnose/verdict.h"
#include "laboratory.h"

#include <Eigen/QR>
#include <doctest/doctest.h>
#include <regex>

using namespace tumble;
using namespace tumble::diagnose;

namespace {

std::string case_of(const std::string& kind, const std::string& effect, double size, bool light,
                    unsigned long long seed, Diagnosis& diagnosis) {
    blind::Random random(seed);
    blind::Order order{.kind = kind, .effects = {}, .wanted = size, .light = light};
    if (!effect.empty())
        order.effects = {effect};
    const blind::Case made = blind::make_case(order, random);
    REQUIRE(made.possible);
    auto result = blind::diagnosed(made);
    REQUIRE_MESSAGE(result, to_string(result.problems()));
    diagnosis = std::move(*result);
    return verdict_of(diagnosis);
}

bool holds(const Diagnosis& diagnosis, const std::string& id) {
    for (const int k : diagnosis.decision.causes)
        if (diagnosis.causes[static_cast<std::size_t>(k)].id == id)
            return true;
    return false;
}

/// The evidence in coordinates of all its directions: every product of two of its vectors is kept, and rows are few.
/// Rows of priors stay what they are.
Evidence compressed(const Evidence& full) {
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
    few.residual = few_rows(full.residual);
    few.nuisances = few_rows(full.nuisances);
    few.effects = few_rows(full.effects);
    few.directions.blocks = few_rows(full.directions.blocks);
    few.directions.prints = few_rows(full.directions.prints);
    few.directions.condition.assign(static_cast<std::size_t>(basis.cols()), 0);
    few.directions.condition.resize(static_cast<std::size_t>(few.residual.size()), -1);
    few.directions.early.assign(static_cast<std::size_t>(few.residual.size()), false);
    few.directions.conditions = {"all"};
    return few;
}

struct Tally {
    int right = 0, wrong = 0, ambiguous_with = 0, ambiguous_without = 0, quiet = 0, unknown = 0, pairs = 0;
};

/// Cases with an effect of that size and noise, decided as if all were linear.
Tally linear_cases(const Evidence& evidence, const VectorXd& effect, int truth, int count, blind::Random& random,
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

Eigen::Index column_of(const Evidence& evidence, const std::string& id) {
    for (std::size_t k = 0; k < evidence.causes.size(); ++k)
        if (evidence.causes[k].id == id)
            return static_cast<Eigen::Index>(k);
    FAIL(id);
    return 0;
}

/// How much of a cause's effect the nearest rival outside its class leaves.
double separable_length(const Evidence& evidence, int cause) {
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

/// Slopes on the solver, once for all cases.
const Evidence& evidence_of_nothing() {
    static const Evidence evidence = [] {
        Diagnosis diagnosis;
        case_of("null", "", 5, false, 7, diagnosis);
        return compressed(diagnosis.evidence);
    }();
    return evidence;
}

} // namespace

TEST_CASE("the generator of blind cases shares no line with the program it tests") {
    const std::regex include(R"re(#\s*include\s*"([^"]+)")re");
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(TUMBLE_ROOT) / "tests/blind/generator")) {
        std::ifstream stream(entry.path());
        for (std::string line; std::getline(stream, line);) {
            std::smatch match;
            if (std::regex_search(line, match, include))
                CHECK_MESSAGE(std::filesystem::exists(entry.path().parent_path() / match[1].str()),
                              entry.path().string() << " includes " << match[1].str());
        }
    }
}

TEST_CASE("on the solver: nothing hidden is nothing found") {
    for (unsigned long long seed = 1; seed <= 4; ++seed) {
        Diagnosis diagnosis;
        const std::string verdict = case_of("null", "", 5, seed % 2 == 0, seed, diagnosis);
        CHECK_MESSAGE(diagnosis.decision.outcome == Outcome::consistent, seed << ": " << verdict);
    }
}

TEST_CASE("on the solver: what is hidden at 8 standard errors from every rival is named, with its amplitude") {
    // Naming fails at d_sep = 8 with probability Phi(-(8/2 - 3/8)) = 0.02 %.
    for (const char* effect : {"ins.gain", "ins.bias", "ins.low_pass"}) {
        Diagnosis diagnosis;
        const std::string verdict = case_of("listed", effect, 8, false, 21, diagnosis);
        CHECK_MESSAGE(diagnosis.decision.outcome == Outcome::named, effect << ": " << verdict);
        CHECK_MESSAGE(holds(diagnosis, effect), effect << ": " << verdict);
    }
}

TEST_CASE("on slopes: thousands of cases keep the promised rates") {
    const Evidence& evidence = evidence_of_nothing();
    blind::Random random(99);
    // Nothing hidden: the gate and the two tests of adequacy alarm in 0.5 % each; 1,500 cases, so at most 30 with 99.9
    // %.
    const Tally nothing = linear_cases(evidence, VectorXd::Zero(evidence.residual.size()), -1, 1500, random);
    CHECK(nothing.right + nothing.wrong <= 15);
    CHECK(1500 - nothing.quiet <= 30);
    int right = 0, wrong = 0, lost = 0, cases = 0;
    for (Eigen::Index k = 0; k < evidence.effects.cols(); ++k) {
        const double length = separable_length(evidence, static_cast<int>(k));
        const Cause& cause = evidence.causes[static_cast<std::size_t>(k)];
        const double amplitude = 5 / length;
        if (!(amplitude < cause.hi)) // these data do not show it, or only beyond what is plausible
            continue;
        const Tally tally =
            linear_cases(evidence, evidence.effects.col(k) * amplitude, static_cast<int>(k), 100, random);
        right += tally.right;
        wrong += tally.wrong;
        lost += tally.ambiguous_without;
        cases += 100;
        MESSAGE(cause.id << ": " << tally.right << " right, " << tally.wrong << " wrong, " << tally.ambiguous_with
                         << " + " << tally.ambiguous_without << " ambiguous with and without, " << tally.quiet
                         << " quiet, " << tally.unknown << " unknown");
    }
    REQUIRE(cases >= 300);
    // Phi(5/2 - 3/5) = 97 %, less the false alarms of adequacy.
    CHECK(right >= 0.93 * cases);
    CHECK(wrong <= 0.01 * cases);
    CHECK(lost <= 0.02 * cases);
}

TEST_CASE("ablations: without its margin or its adequacy the decision is worse, so both do something") {
    const Evidence& evidence = evidence_of_nothing();
    blind::Random random(5);
    // A direction that nothing listed resembles: an oscillation of the blocks, free of nuisances and causes.
    MatrixXd known(evidence.residual.size(), evidence.nuisances.cols() + evidence.effects.cols());
    known << evidence.nuisances, evidence.effects;
    VectorXd strange = VectorXd::Zero(evidence.residual.size());
    for (Eigen::Index k = 0; k < evidence.directions.blocks.cols(); ++k)
        strange += (k % 2 ? 1.0 : -1.0) * evidence.directions.blocks.col(k);
    const VectorXd beside = Projector(known).out(strange).normalized();
    const VectorXd likened =
        (0.5 * unit_columns(evidence.effects).col(column_of(evidence, "ins.gain")) + beside).normalized();
    Settings careless;
    careless.alpha_adequacy = 1e-12;
    const VectorXd effect = 10 * Projector(evidence.nuisances).out(likened);
    const Tally with = linear_cases(evidence, effect, -1, 150, random);
    const Tally without = linear_cases(evidence, effect, -1, 150, random, careless);
    CHECK(with.wrong <= 15);
    CHECK(without.wrong > 2 * with.wrong + 20);
}
