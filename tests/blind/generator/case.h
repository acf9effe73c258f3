#pragma once

#include "experiment.h"
#include "random.h"
#include "records.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace blind {

/// What one case is to hide.
struct Order {
    std::string kind;                 // null, distractor, listed, two, unlisted
    std::vector<std::string> effects; // ids
    double wanted = 0;                // d'_sep or d'_res
    Bench bench = Bench::drop;
    bool more = false; // trials that separate better, and a clock in the picture
};

/// The mix of section 3.2 of the design: a quarter with nothing hidden, of which two fifths have noise and clocks that
/// are out of the ordinary (distractors), 45 % one listed effect, a tenth two, a fifth unlisted, sizes 2, 3.5, 5 and 8.
/// `least`: no smaller sizes are drawn; where most promises are made, most cases can be judged.
std::vector<Order> mixed_orders(int count, double least, Random& random);

/// A case as it was made: its folder's files, and what is to be found.
struct Case {
    Order order;
    Setup setup;
    Dirt dirt{};
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

/// What a laboratory can be asked to do next, by the names that `tumble diagnose` gives it.
constexpr const char* experiments[] = {"light", "clock", "longer", "again"};

/// The same with the same effect and one more experiment: all records anew beside those there were, of a body of an
/// eighth of the mass, of twice the duration or as they were; or taken again with a clock in the picture.
Case followed(const Case& plain, const std::string& experiment, Random& random);

} // namespace blind
