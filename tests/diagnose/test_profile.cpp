#include "about.h"
#include "base/rng.h"
#include "diagnose/profile.h"
#include "diagnose/refit.h"
#include "drops.h"

#include <doctest/doctest.h>

namespace test_profile {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;
using tumble::test::Drops;

namespace {

Model model_of(std::vector<Record> records, const std::vector<std::string>& ids) {
    auto causes = choose_causes(ids);
    REQUIRE(causes);
    auto model = Model::make({tumble::test::floor_and_ball, "ball.toml"}, std::move(records),
                             Drops{}.measurement().nuisances, *causes, tumble::test::closed_form);
    REQUIRE_MESSAGE(model, to_string(model.problems()));
    return std::move(*model);
}

/// Drops with that amplitude of the first cause in their readings, and noise.
Model measured(const std::vector<std::string>& causes, double amplitude, std::uint64_t seed) {
    std::vector<Record> records = Drops{}.measurement().records;
    Model clean = model_of(records, causes);
    VectorXd values = clean.start();
    values[clean.parameter_of(0)] = amplitude;
    const auto readings = clean.predict(values);
    REQUIRE(readings);
    Rng rng(seed);
    Eigen::Index row = 0;
    for (Record& record : records)
        for (double& value : record.channels[0].value)
            value = (*readings)[row++] + record.channels[0].sigma * tumble::test::gauss(rng);
    return model_of(std::move(records), causes);
}

struct Found {
    Refit best;
    Limits limits;
    double rise_low = 0, rise_high = 0; // of chi-square, all else fitted there
};

Found found_in(Model& model) {
    const Noise noise = first_noise(model);
    std::vector<int> free;
    for (int k = 0; k < model.nuisances(); ++k)
        free.push_back(k);
    const auto baseline = diagnose::fit(model, noise, model.start(), free);
    REQUIRE(baseline);
    std::vector<int> causes;
    MatrixXd slopes(baseline->residual.size(), 0);
    for (int k = 0; k < static_cast<int>(model.causes().size()); ++k) {
        const auto slope = slope_of(model, noise, baseline->values, model.parameter_of(k), true);
        REQUIRE(slope);
        slopes.conservativeResize(Eigen::NoChange, k + 1);
        slopes.col(k) = *slope;
        causes.push_back(k);
    }
    Found found;
    found.best = refit_of(causes, model, noise, *baseline, slopes);
    REQUIRE_MESSAGE(found.best.possible, found.best.refused);
    found.limits = profile_of(found.best, *baseline, model, noise, 1.96)[0];
    const auto rise = [&](double amplitude) {
        VectorXd values = found.best.values;
        values[model.parameter_of(0)] = amplitude;
        std::vector<int> others = free;
        for (std::size_t k = 1; k < causes.size(); ++k)
            others.push_back(model.parameter_of(causes[k]));
        const auto there = diagnose::fit(model, noise, values, others);
        REQUIRE(there);
        return there->chi_square - found.best.residual.squaredNorm();
    };
    found.rise_low = rise(found.limits.low);
    found.rise_high = rise(found.limits.high);
    return found;
}

} // namespace

TEST_CASE("limits of an amplitude are where chi-square has risen, everything innocent fitted anew") {
    // A filter that is quicker than the readings lags as a late clock does; what is left grows with the square of it.
    for (const double tau : {4e-3, 15e-3}) {
        Model model = measured({"ins.low_pass"}, tau, 3);
        const Found found = found_in(model);
        CAPTURE(tau);
        CHECK(found.rise_low == about(1.96 * 1.96, 0.05));
        CHECK(found.rise_high == about(1.96 * 1.96, 0.05));
    }
}

TEST_CASE("limits of what is in proportion to its amplitude are the linear ones, of two causes as of one") {
    Model one = measured({"ins.gain"}, 0.02, 5), two = measured({"ins.gain", "ins.drift"}, 0.02, 5);
    for (Model* model : {&one, &two}) {
        const Found gain = found_in(*model);
        const double at = gain.best.amplitude[0], reach = 1.96 * gain.best.error[0];
        CHECK(gain.limits.low - at == about(-reach, 0.02));
        CHECK(gain.limits.high - at == about(reach, 0.02));
        CHECK(!gain.limits.linear);
        CHECK(gain.rise_high == about(1.96 * 1.96, 0.05));
    }
}

TEST_CASE("the limit of an amplitude that nearly nothing speaks for is the end of its range") {
    Model model = measured({"ins.low_pass"}, 1e-3, 4);
    const Found found = found_in(model);
    CHECK(found.best.amplitude[0] > 0);
    CHECK(found.limits.low == 0);
    CHECK(found.rise_low < 1.96 * 1.96);
    CHECK(found.rise_high == about(1.96 * 1.96, 0.05));
}

} // namespace test_profile
