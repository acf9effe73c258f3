#pragma once

#include "base/column.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// What a reduction costs in accuracy, told from what chance alone does. docs/reduced-order.md, "Error and scatter".
namespace tumble::reduce {

/// What several seeds of one rung gave.
struct Sample {
    std::vector<std::vector<double>> values; // per seed, per quantity; NaN: had no meaning there
    double core_s = 0;                       // mean per run
};

/// How far a rung's mean lies from the reference's, over the size of the reference's.
struct Error {
    double relative = std::numeric_limits<double>::quiet_NaN();
    double uncertainty = std::numeric_limits<double>::infinity(); // half of the 95 % interval, its longer side
    double at_least = 0; // where the reference's own is not told apart from zero: what it is off by even so

    /// More than its scatter can make.
    [[nodiscard]] bool told_apart() const;
};

enum class Verdict {
    not_judged,   // by no quantity
    within,       // even with its uncertainty, and enough seeds to know that
    seems_within, // the error is, its uncertainty is not, or is known from too few seeds
    seems_beyond, // the error is, or some seeds have lost a quantity
    beyond        // even less its uncertainty, or all seeds have lost a quantity
};
const char* word_of(Verdict verdict);

struct Price {
    double speed_up = 1;
    std::vector<Spread> spreads; // per quantity
    std::vector<Error> errors;   // per quantity; of those that the reference does not have: the default
    double worst = 0;            // largest |relative|
    Verdict verdict = Verdict::not_judged;
};

/// From how many seeds on a rung is as uncertain as it scatters itself; with fewer, at least as the mean rung does.
constexpr int seeds_to_be_sure = 4;

/// Of every sample against that at `reference`, within `tolerance` (relative). A quantity that the reference does not
/// have in every seed judges nobody (`judged`); one that is not told apart from zero there, only rungs that surely
/// change it by more than the tolerance of the most that it may be.
struct Prices {
    std::vector<Price> rungs;
    std::vector<bool> judged;             // per quantity
    std::vector<double> reference_spread; // per quantity, 95 % half interval of the reference's mean, in its unit
    std::optional<std::size_t> cheapest;  // the fastest that is within, else the fastest that seems to be
};
Prices price(const std::vector<Sample>& samples, std::size_t reference, double tolerance);

} // namespace tumble::reduce
