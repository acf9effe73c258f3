#pragma once

#include "experiment.h"
#include "random.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blind {

/// What one case is to hide.
struct Order {
    std::string kind;                 // null, listed, two, unlisted
    std::vector<std::string> effects; // ids
    double wanted = 0;                // d'_sep or d'_res
    Bench bench = Bench::drop;
    bool more = false; // trials that separate better, and a clock in the picture
};

/// The mix of section 3.2 of the design: a quarter null, 45 % one listed effect, a tenth two, a fifth unlisted, sizes
/// 2, 3.5, 5 and 8.
std::vector<Order> mixed_orders(int count, Random& random);

/// A case as it was made: its folder's files, and what is to be found.
struct Case {
    Order order;
    Setup setup;
    Truth without;                  // what is innocent, but clocks and speeds
    std::vector<double> amplitudes; // of the order's effects
    std::vector<std::string> files; // names, in the order of trials
    std::vector<std::string> csv;
    std::string measurement; // TOML
    nlohmann::ordered_json answer;
    bool possible = true; // false: no amplitude gives the size wanted
};

/// Draws everything innocent, scales the effect, adds noise that is not quite as stated.
Case make_case(const Order& order, Random& random);

/// The same ball with the same effect, measured again with the trials that a plain bench lacks.
Case with_more(const Case& plain, Random& random);

/// The baseline that every case is held against: the balls of scenes/bounce.toml and scenes/lane.toml, the tripod of
/// scenes/slope.toml.
Truth baseline(Bench bench);

} // namespace blind
