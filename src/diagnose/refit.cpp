#include "diagnose/refit.h"

#include "diagnose/folds.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr double next_amplitude = 2; // times the one before

/// Where a lone cause begins to be fitted if neither the baseline nor the scene leads to it: what sticks up to some
/// amplitude and slips beyond has no slope that points there.
VectorXd likeliest_start(Model& model, const Noise& noise, int cause) {
    const int index = model.parameter_of(cause);
    const Parameter& parameter = model.parameters()[static_cast<std::size_t>(index)];
    VectorXd best = model.start();
    double least = std::numeric_limits<double>::infinity();
    for (const double side : {1.0, -1.0})
        for (double size = parameter.step; size < (side > 0 ? parameter.hi : -parameter.lo); size *= next_amplitude) {
            VectorXd values = model.start();
            values[index] = side * size;
            const auto misfit = misfit_of(model, values);
            if (!misfit)
                continue;
            const double missed = noise.whiten(*misfit, model).squaredNorm();
            if (missed < least) {
                least = missed;
                best = values;
            }
        }
    return best;
}

bool ended(const Result<Fit>& fitted) {
    return fitted && fitted->converged;
}

void take_better(Result<Fit>& fitted, Result<Fit> other) {
    if (other && (!fitted || other->chi_square < fitted->chi_square))
        fitted = std::move(other);
}

} // namespace

Refit refit_of(const std::vector<int>& causes, Model& model, const Noise& noise, const Fit& baseline,
               const MatrixXd& effects, bool thorough) {
    Refit refit;
    refit.causes = causes;
    const auto count = static_cast<Eigen::Index>(causes.size());
    std::vector<int> free = baseline.free;
    MatrixXd slopes(baseline.slopes.rows(), baseline.slopes.cols() + count);
    slopes.leftCols(baseline.slopes.cols()) = baseline.slopes;
    for (Eigen::Index k = 0; k < count; ++k) {
        const int cause = causes[static_cast<std::size_t>(k)];
        free.push_back(model.parameter_of(cause));
        slopes.col(baseline.slopes.cols() + k) = effects.col(cause);
    }
    auto fitted = fit(model, noise, baseline.values, free, {.slopes = &slopes});
    if (thorough && (!ended(fitted) || astray(baseline.chi_square, baseline.residual.size())))
        take_better(fitted, fit(model, noise, model.start(), free, {.progressive = true}));
    if (thorough && !ended(fitted) && count == 1)
        take_better(fitted, fit(model, noise, likeliest_start(model, noise, causes[0]), free, {}));
    if (!fitted) {
        refit.refused = fitted.problems()[0].what;
        return refit;
    }
    refit.values = fitted->values;
    refit.residual = fitted->residual;
    refit.slopes = fitted->slopes;
    refit.gain = baseline.chi_square - fitted->chi_square;
    refit.error = errors_of(fitted->slopes).tail(count);
    refit.amplitude.resize(count);
    refit.possible = fitted->converged;
    if (!fitted->converged)
        refit.refused = fmt::format("its fit did not end ({:.2g} nats short)", fitted->decrement);
    for (Eigen::Index k = 0; k < count; ++k) {
        const int index = model.parameter_of(causes[static_cast<std::size_t>(k)]);
        const Parameter& parameter = model.parameters()[static_cast<std::size_t>(index)];
        const double amplitude = refit.amplitude[k] = fitted->values[index];
        if (amplitude <= parameter.lo || amplitude >= parameter.hi) {
            refit.possible = false;
            refit.at_end = true;
            refit.refused = fmt::format("would have to be {} {:.3g}, the end of its range",
                                        amplitude <= parameter.lo ? "below" : "above", amplitude);
        }
    }
    return refit;
}

} // namespace tumble::diagnose
