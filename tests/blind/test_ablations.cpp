// Tests that keep the blind tests honest: each part of the decision, taken out, must make it worse; each mistake put in
// must be seen; what must not matter must not.
#include "diagnose/folds.h"
#include "linear_stage.h"

using namespace blind;

namespace {

/// Names the cause that predicts conditions left out best, if any beats the baseline: what the decision must not do.
bool named_by_held_out_score(const Evidence& evidence) {
    double best = 0;
    for (std::size_t k = 0; k < evidence.causes.size(); ++k) {
        if (Projector(evidence.nuisances).out(VectorXd(evidence.effects.col(static_cast<Eigen::Index>(k)))).norm() == 0)
            continue;
        double better = 0;
        for (const Fold& fold : folds_of(evidence, refit_linear(evidence, {static_cast<int>(k)})))
            better += fold.score.nats();
        best = std::max(best, better);
    }
    return best > 0;
}

VectorXd noise_of(const Evidence& evidence, Random& random) {
    VectorXd noise(evidence.residual.size());
    for (double& one : noise)
        one = random.normal();
    return Projector(evidence.nuisances).out(noise);
}

/// A direction that nothing listed is: half the gain's, half an oscillation of the blocks.
VectorXd likened_to_gain(const Evidence& evidence) {
    MatrixXd known(evidence.residual.size(), evidence.nuisances.cols() + evidence.effects.cols());
    known << evidence.nuisances, evidence.effects;
    VectorXd strange = VectorXd::Zero(evidence.residual.size());
    for (Eigen::Index k = 0; k < evidence.directions.blocks.cols(); ++k)
        strange += (k % 2 ? 1.0 : -1.0) * evidence.directions.blocks.col(k);
    const VectorXd beside = Projector(known).out(strange).normalized();
    const VectorXd gain = evidence.effects.col(column_of(evidence, "ins.gain")).normalized();
    return Projector(evidence.nuisances).out(VectorXd(gain + beside)).normalized();
}

/// What cases with this effect, decided on `evidence`, say of its amplitude: mean of (found - true) / standard error.
double pull_of(const Evidence& evidence, const VectorXd& effect, int truth, double amplitude, Random& random) {
    Evidence now = evidence;
    double sum = 0;
    constexpr int cases = 40;
    for (int k = 0; k < cases; ++k) {
        now.residual = noise_of(evidence, random) + Projector(evidence.nuisances).out(VectorXd(effect * amplitude));
        const Refit refit = refit_linear(now, {truth});
        sum += (refit.amplitude[0] - amplitude) / refit.error[0];
    }
    return sum / cases;
}

} // namespace

TEST_CASE("ablation: selecting by held-out score names a cause in most cases that have none") {
    Evidence now = evidence_of_nothing(Bench::drop);
    Random random(31);
    int named = 0;
    for (int k = 0; k < 40; ++k) {
        now.residual = noise_of(now, random);
        named += named_by_held_out_score(now);
    }
    MESSAGE(named << " of 40 named");
    CHECK(named > 16); // 40 %; the decision itself stays below 1 % (test_blind)
}

TEST_CASE("ablation: without its margin the decision names the wrong one of two that are alike") {
    // At 3 standard errors from the nearest rival noise turns the order round with probability Phi(-3/2) = 7 %, and
    // leaves more than 3 nats behind with 0.6 %.
    const Evidence evidence = compressed(evidence_of_nothing(Bench::drop));
    Random random(32);
    Settings careless;
    careless.margin = 1e-6;
    int with = 0, without = 0, cases = 0;
    for (const char* id : {"drag.quadratic", "drag.linear", "rest.velocity"}) {
        const Eigen::Index k = column_of(evidence, id);
        const VectorXd effect = evidence.effects.col(k) * (3 / separable_length(evidence, static_cast<int>(k)));
        with += linear_cases(evidence, effect, static_cast<int>(k), 150, random).wrong;
        without += linear_cases(evidence, effect, static_cast<int>(k), 150, random, careless).wrong;
        cases += 150;
    }
    MESSAGE(with << " misnamed with its margin, " << without << " without, of " << cases);
    CHECK(with <= 0.02 * cases);
    CHECK(without > 0.04 * cases);
}

TEST_CASE("ablation: without its adequacy the decision names what is in no library") {
    const Evidence evidence = compressed(evidence_of_nothing(Bench::drop));
    Random random(33);
    const VectorXd effect = 15 * likened_to_gain(evidence);
    Settings careless;
    careless.alpha_adequacy = 1e-30;
    const int with = linear_cases(evidence, effect, -1, 150, random).wrong;
    const int without = linear_cases(evidence, effect, -1, 150, random, careless).wrong;
    MESSAGE(with << " named with adequacy, " << without << " without, of 150");
    CHECK(with <= 8);
    CHECK(without > 75);
}

TEST_CASE("mutations: a slope that is too large, a sign turned round, two causes exchanged are all seen") {
    const Evidence sound = compressed(evidence_of_nothing(Bench::drop));
    const Eigen::Index gain = column_of(sound, "ins.gain"), drift = column_of(sound, "ins.drift");
    const double amplitude = 10 / separable_length(sound, static_cast<int>(gain));
    const VectorXd effect = sound.effects.col(gain);
    Random random(34);
    const auto pull = [&](const Evidence& evidence) {
        return pull_of(evidence, effect, static_cast<int>(gain), amplitude, random);
    };
    CHECK(std::abs(pull(sound)) < 0.6); // 40 cases: 0.16 standard deviations of the mean
    Evidence steep = sound, turned = sound, exchanged = sound;
    steep.effects.col(gain) *= 1.3; // amplitudes come out at 1 / 1.3: 23 % of at least 10 standard errors too low
    CHECK(pull(steep) < -2);
    turned.effects.col(gain) *= -1;
    CHECK(pull(turned) < -10);
    exchanged.effects.col(gain).swap(exchanged.effects.col(drift));
    CHECK(linear_cases(exchanged, effect * amplitude, static_cast<int>(gain), 40, random).right == 0);
}

TEST_CASE("with the labels permuted hardly any name is right, so hits are no accident of counting") {
    const Evidence evidence = compressed(evidence_of_nothing(Bench::drop));
    Random random(35);
    const int gain = static_cast<int>(column_of(evidence, "ins.gain")),
              other = static_cast<int>(column_of(evidence, "ins.drift"));
    const VectorXd effect = evidence.effects.col(gain) * (8 / separable_length(evidence, gain));
    CHECK(linear_cases(evidence, effect, gain, 60, random).right > 50);
    CHECK(linear_cases(evidence, effect, other, 60, random).right < 10); // one of a dozen, and three standard errors
}

TEST_CASE("five causes that have nothing to do with it leave false alarms where they were") {
    Evidence evidence = compressed(evidence_of_nothing(Bench::drop));
    Random random(36);
    const Eigen::Index known = evidence.effects.cols();
    evidence.effects.conservativeResize(Eigen::NoChange, known + 5);
    for (Eigen::Index k = 0; k < 5; ++k) {
        evidence.causes.push_back({.id = "irrelevant", .lo = -1e3, .hi = 1e3, .typical = 1});
        for (double& one : evidence.effects.col(known + k))
            one = random.normal();
    }
    const Tally nothing = linear_cases(evidence, VectorXd::Zero(evidence.residual.size()), -1, 600, random);
    CHECK(nothing.right + nothing.wrong <= 9); // 0.5 % of 600 are 3, and four standard deviations more
    CHECK(600 - nothing.quiet <= 20);
}
