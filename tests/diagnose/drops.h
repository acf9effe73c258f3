#pragma once

#include "base/text.h"
#include "diagnose/diagnosis.h"
#include "floor_and_ball.h"
#include "gauss.h"

#include <doctest/doctest.h>

namespace tumble::test {

/// Drops of the ball of floor_and_ball from four heights, filmed, with noise and whatever else is wrong in them.
struct Drops {
    double sigma = 2e-3; // m
    double memory = 0;   // of one reading's error in the next
    bool clock = false;  // one in the picture, read to a millisecond, each reading by itself
    double offset = 0;   // s, of the first record's clock
    double restitution = 0.79;
    int rows = 150;
    std::uint64_t seed = 1;
    double (*distort)(double y, double t) = [](double y, double) { return y; };
    std::vector<double> heights{0.5, 0.8, 1.1, 1.5};

    [[nodiscard]] diagnose::Measurement measurement() const {
        Rng rng(seed);
        const auto normal = [&] { return gauss(rng); };
        diagnose::Measurement all;
        all.title = "drops";
        all.causes = {"grav.g", "clock", "sensor scale", "filter"};
        all.nuisances = {{.key = "pair.rubber-rubber.restitution", .instrument = "", .spread = 0.05},
                         {.key = "", .instrument = "clock_offset", .per_record = true, .spread = 0.005}};
        for (const double height : heights) {
            diagnose::Record record{.name = shortest(height),
                                    .condition = shortest(height),
                                    .file = "none.csv",
                                    .sets = {"fill.0.position_m.1=" + shortest(height)},
                                    .time = {},
                                    .channels = {}};
            diagnose::Channel channel{
                .head = "height_m", .measure = "centre_of_mass_y", .unit = "m", .value = {}, .sigma = sigma};
            double error = memory > 0 ? normal() : 0;
            for (int k = 0; k < rows; ++k) {
                const double t = k / 120.0;
                record.time.push_back(t);
                const double y = bouncing(height, 9.81, restitution, t - (all.records.empty() ? offset : 0));
                error = memory * error + std::sqrt(1 - memory * memory) * normal();
                channel.value.push_back(distort(y, t) + sigma * error);
            }
            record.channels.push_back(std::move(channel));
            diagnose::Channel times{.head = "clock_s", .measure = "time", .unit = "s", .value = {}, .sigma = 1e-3};
            for (int k = 0; k < rows && clock; ++k)
                times.value.push_back(record.time[static_cast<std::size_t>(k)] - (all.records.empty() ? offset : 0) +
                                      1e-3 * normal());
            if (clock)
                record.channels.push_back(std::move(times));
            all.records.push_back(std::move(record));
        }
        return all;
    }
    [[nodiscard]] diagnose::Diagnosis diagnosis() const { return diagnosed(measurement()); }
    [[nodiscard]] static diagnose::Diagnosis diagnosed(const diagnose::Measurement& measurement,
                                                       const diagnose::Simulate& simulate = closed_form) {
        auto result = diagnose::diagnose({floor_and_ball, "ball.toml"}, measurement, simulate);
        REQUIRE_MESSAGE(result, to_string(result.problems()));
        return std::move(*result);
    }
};

} // namespace tumble::test
