#include "run/run_verdict.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::run {

namespace {

// A percent of energy is more than the step should cost.
constexpr double closure_worth_a_word = 0.01;

/// What the sums of the books may miss by rounding alone: n terms, n roundings.
double rounding_of(const Books& books) {
    return std::numeric_limits<double>::epsilon() * static_cast<double>(books.bodies) *
           (std::abs(books.gravity) + std::abs(books.inserted));
}

} // namespace

double turned_over(const Books& books) {
    return books.kinetic_translation + books.kinetic_rotation + books.stored_normal + books.stored_tangential +
           books.stored_rolling + lost_of(books);
}

std::vector<std::string> verdict(const RunSummary& summary, const scene::Scene& scene) {
    std::vector<std::string> sentences;
    const bool early =
        !scene.fills.empty() && std::all_of(scene.fills.begin(), scene.fills.end(),
                                            [&](const scene::Fill& fill) { return fill.until > summary.time; });
    for (const std::string& sentence : summary.unfilled)
        sentences.push_back(
            (early ? "the run ended while bodies were still coming in: " : "not all bodies found room: ") + sentence);
    if (summary.overlap_ratio_max > scene.contact.accepted_overlap)
        sentences.push_back(fmt::format(
            "bodies overlapped by up to {:.1f} % of the smaller {}'s radius, and the scene expects at "
            "most {:.3g} %: {}, or say contact.accepted_overlap",
            100 * summary.overlap_ratio_max, scene.dimension == 2 ? "disc" : "sphere",
            100 * scene.contact.accepted_overlap,
            scene.solver == scene::Solver::box2d ? "Box2D finds impacts at the end of a step, shorten box2d.time_step_s"
                                                 : "take stiffer materials or slower impacts"));
    const double missed = std::abs(summary.books.closure);
    if (missed > closure_worth_a_word * summary.energy_turnover && missed > rounding_of(summary.books))
        sentences.push_back(fmt::format("the energy balance misses {:.3g} J of {:.3g} J: try a smaller time step",
                                        missed, summary.energy_turnover));
    return sentences;
}

} // namespace tumble::run
