#include "about.h"
#include "diagnose/curves.h"
#include "diagnose/verdict.h"
#include "drops.h"

#include <doctest/doctest.h>

namespace test_clipping {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;
using tumble::test::Drops;

namespace {

/// Heights that a sensor cuts at 0.9 m; of the highest drop, from 1.5 m, that is two fifths.
Measurement cut_at_nine_tenths(bool clock = false) {
    Measurement measurement =
        Drops{.clock = clock, .distort = [](double y, double) { return std::min(y, 0.9); }}.measurement();
    measurement.causes.push_back("ins.clipping");
    return measurement;
}

} // namespace

TEST_CASE("a clipping of nothing cuts nothing, however much higher than in the scene a body turns out to begin") {
    Drops drops;
    Measurement measurement = drops.measurement();
    measurement.nuisances.push_back({.key = "fill.0.position_m.1", .instrument = "", .per_record = true});
    auto model = Model::make({tumble::test::floor_and_ball, "ball.toml"}, measurement.records, measurement.nuisances,
                             *choose_causes({"ins.clipping"}), tumble::test::closed_form);
    REQUIRE_MESSAGE(model, to_string(model.problems()));
    VectorXd values = model->start();
    for (int k = 0; k < model->nuisances(); ++k)
        if (model->parameters()[static_cast<std::size_t>(k)].name.starts_with("fill.0"))
            values[k] += 0.03;
    const auto whole = model->predict(values);
    values[model->parameter_of(0)] = 1e-6; // of 1.5 m
    const auto cut = model->predict(values);
    REQUIRE((whole && cut));
    const double most = (*whole - *cut).cwiseAbs().maxCoeff();
    CHECK(most > 0);
    CHECK(most < 2e-6);
    // Whoever reads other records with that sensor has its range, whatever their bodies do.
    auto ranges = model->ranges_at(values);
    REQUIRE(ranges);
    CHECK(ranges->at({"centre_of_mass_y", ""}) == about(1.53, 1e-9));
}

TEST_CASE("a clipping is named with the limit in the reading's own unit, whichever column comes first") {
    Measurement measurement = cut_at_nine_tenths(true);
    const Diagnosis heights_first = Drops::diagnosed(measurement);
    for (Record& record : measurement.records)
        std::swap(record.channels[0], record.channels[1]);
    const Diagnosis clock_first = Drops::diagnosed(measurement);
    for (const Diagnosis* one : {&heights_first, &clock_first}) {
        REQUIRE_MESSAGE(one->decision.outcome == Outcome::named, verdict_of(*one));
        CHECK(one->causes[static_cast<std::size_t>(one->decision.causes[0])].id == "ins.clipping");
        REQUIRE(one->cuts.size() == 1);
        CHECK(one->cuts[0].limit == about(0.9, 2e-3));
        CHECK(verdict_of(*one).find("(height_m at 0.") != std::string::npos);
    }
    CHECK(clock_first.decision.best->error[0] == about(heights_first.decision.best->error[0], 0.02));
    CHECK(clock_first.decision.best->amplitude[0] == about(heights_first.decision.best->amplitude[0], 1e-3));
}

TEST_CASE("a clipping is named though no scatter was stated") {
    Measurement measurement = cut_at_nine_tenths();
    for (Record& record : measurement.records)
        record.channels[0].sigma = 0;
    const Diagnosis diagnosis = Drops::diagnosed(measurement);
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK(diagnosis.causes[static_cast<std::size_t>(diagnosis.decision.causes[0])].id == "ins.clipping");
    CHECK(diagnosis.noise.used == about(2e-3, 0.1));
}

} // namespace test_clipping
