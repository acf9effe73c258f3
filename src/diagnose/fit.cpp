#include "diagnose/fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace tumble::diagnose {

namespace {

// Steps of difference quotients, in standard errors of all readings together: small against what is curved and kinked,
// large against what a simulation rounds.
constexpr double visible_step = 2;
constexpr double exact_step = 0.01; // where no simulation is run
constexpr int tunings = 4;
constexpr int most_finer = 2;
constexpr double shorter = 8; // times, each time

/// Parameters with a prior have a row of their own.
std::vector<int> with_prior(const Model& model) {
    std::vector<int> parameters;
    for (std::size_t k = 0; k < model.parameters().size(); ++k)
        if (model.parameters()[k].spread > 0)
            parameters.push_back(static_cast<int>(k));
    return parameters;
}

/// Slopes of the residual's negative by a difference over the step, or a share of it, inside the bounds.
Result<VectorXd> difference(Model& model, const Noise& noise, const VectorXd& values, int index, double horizon,
                            double share = 1) {
    const Parameter& parameter = model.parameters()[static_cast<std::size_t>(index)];
    VectorXd above = values, below = values;
    above[index] = std::min(values[index] + share * parameter.step, parameter.hi);
    below[index] = std::max(values[index] - share * parameter.step, parameter.lo);
    model.run_ahead({above, below}, horizon);
    Problems why;
    const auto inside = [&](VectorXd& side) {
        auto residual = residual_at(model, noise, side, horizon);
        if (residual)
            return residual;
        why = residual.problems(); // no such simulation on that side
        side = values;
        return residual_at(model, noise, side, horizon);
    };
    const auto high = inside(above), low = inside(below);
    if (!high || !low || above[index] == below[index])
        return why.empty() ? Problems{{.key = parameter.name, .what = "its bounds leave no room"}} : why;
    return VectorXd((*low - *high) / (above[index] - below[index]));
}

Result<MatrixXd> slopes_at(Model& model, const Noise& noise, const VectorXd& values, const std::vector<int>& free,
                           double horizon, double share) {
    const auto rows = model.readings().size() + static_cast<Eigen::Index>(with_prior(model).size());
    MatrixXd slopes(rows, 0);
    for (std::size_t k = 0; k < free.size(); ++k) {
        const auto column = difference(model, noise, values, free[k], horizon, share);
        if (!column)
            return column.problems();
        slopes.conservativeResize(rows, static_cast<Eigen::Index>(k) + 1);
        slopes.col(static_cast<Eigen::Index>(k)) = *column;
    }
    return slopes;
}

/// One horizon of a fit: the state of Levenberg and Marquardt's method.
class Descent {
public:
    Descent(Model& model, const Noise& noise, Fit& fit, double horizon)
        : model_(model), noise_(noise), fit_(fit), horizon_(horizon) {}

    Problems run(const FitOptions& options, bool slopes_known) {
        auto residual = residual_at(model_, noise_, fit_.values, horizon_);
        if (!residual)
            return residual.problems();
        take(std::move(*residual));
        bool fresh = false;
        if (!slopes_known) {
            if (const Problems problems = renew(); !problems.empty())
                return problems;
            fresh = true;
        }
        for (int step = 0; step < options.most_steps; ++step) {
            fit_.decrement = decrement();
            fit_.converged = fit_.decrement < options.tolerance;
            if (fit_.converged && fresh)
                return {};
            const bool went = !fit_.converged && advance();
            if (went) {
                fresh = false;
                continue;
            }
            if (fresh) { // kinks at impacts keep the last of it out of reach
                fit_.converged = fit_.decrement < options.short_enough;
                if (fit_.converged || finer_ == most_finer)
                    return {};
                ++finer_; // slopes over shorter ways cross fewer of them
            }
            if (const Problems problems = renew(); !problems.empty())
                return problems;
            fresh = true;
        }
        if (!fresh)
            if (const Problems problems = renew(); !problems.empty())
                return problems;
        fit_.decrement = decrement();
        fit_.converged = fit_.decrement < options.short_enough;
        return {};
    }

private:
    void take(VectorXd residual) {
        fit_.residual = std::move(residual);
        fit_.chi_square = fit_.residual.squaredNorm();
    }

    Problems renew() {
        auto slopes = slopes_at(model_, noise_, fit_.values, fit_.free, horizon_, std::pow(shorter, -finer_));
        if (!slopes)
            return slopes.problems();
        fit_.slopes = std::move(*slopes);
        damping_ = std::min(damping_, 1e-3);
        return {};
    }

    /// The damped step inside the bounds: parameters that it would take beyond stop there, and the others make up for
    /// it.
    [[nodiscard]] VectorXd bounded_step(double damping) const {
        const auto count = static_cast<Eigen::Index>(fit_.free.size());
        VectorXd step = VectorXd::Zero(count);
        std::vector<Eigen::Index> moving(fit_.free.size());
        std::iota(moving.begin(), moving.end(), 0);
        while (!moving.empty()) {
            step(moving) = damped_step(fit_.slopes(Eigen::all, moving), fit_.residual - fit_.slopes * step, damping);
            const auto beyond = std::partition(moving.begin(), moving.end(),
                                               [&](Eigen::Index k) { return inside(k, step[k]) == step[k]; });
            if (beyond == moving.end())
                break;
            for (auto k = beyond; k != moving.end(); ++k)
                step[*k] = inside(*k, step[*k]);
            moving.erase(beyond, moving.end());
            for (const Eigen::Index k : moving)
                step[k] = 0;
        }
        return step;
    }

    static VectorXd damped_step(const MatrixXd& slopes, const VectorXd& residual, double damping) {
        const VectorXd scale = slopes.colwise().norm().cwiseMax(1e-12).transpose();
        const MatrixXd unit = slopes * scale.cwiseInverse().asDiagonal();
        MatrixXd normal = unit.transpose() * unit;
        normal.diagonal().array() += damping + 1e-12;
        return normal.ldlt().solve(unit.transpose() * residual).cwiseQuotient(scale);
    }

    /// What a linear step inside the bounds would gain.
    [[nodiscard]] double decrement() const {
        if (fit_.free.empty())
            return 0;
        return 0.5 * (fit_.residual.squaredNorm() - (fit_.residual - fit_.slopes * bounded_step(0)).squaredNorm());
    }

    /// A step of the k-th free parameter, cut where it would leave its bounds.
    [[nodiscard]] double inside(Eigen::Index k, double step) const {
        const Parameter& parameter =
            model_.parameters()[static_cast<std::size_t>(fit_.free[static_cast<std::size_t>(k)])];
        const double from = fit_.values[fit_.free[static_cast<std::size_t>(k)]];
        return from + step < parameter.lo   ? parameter.lo - from
               : from + step > parameter.hi ? parameter.hi - from
                                            : step;
    }

    /// Broyden 1965: the least change of the slopes, each in units of its own effect, that explains what was missed.
    void learn(const VectorXd& step, const VectorXd& missed) {
        const VectorXd scale = fit_.slopes.colwise().norm().cwiseMax(1e-12).transpose();
        const VectorXd effect = scale.cwiseProduct(step);
        fit_.slopes += missed * effect.cwiseProduct(scale).transpose() / std::max(1e-300, effect.squaredNorm());
    }

    bool advance() {
        for (int attempt = 0; attempt < 6; ++attempt) {
            const VectorXd step = bounded_step(damping_);
            VectorXd values = fit_.values;
            for (std::size_t k = 0; k < fit_.free.size(); ++k)
                values[fit_.free[k]] += step[static_cast<Eigen::Index>(k)];
            auto residual = residual_at(model_, noise_, values, horizon_);
            if (residual && residual->squaredNorm() < fit_.chi_square) {
                learn(step, fit_.residual - fit_.slopes * step - *residual);
                fit_.values = values;
                take(std::move(*residual));
                damping_ = damping_ < 1e-6 ? 0 : damping_ / 10;
                return true;
            }
            damping_ = std::max(10 * damping_, 1e-3);
        }
        return false;
    }

    Model& model_;
    const Noise& noise_;
    Fit& fit_;
    double horizon_;
    double damping_ = 1e-4;
    int finer_ = 0; // how often steps of slopes were made shorter
};

} // namespace

Result<Fit> fit(Model& model, const Noise& noise, const VectorXd& start, const std::vector<int>& free,
                const FitOptions& options) {
    Fit result;
    result.values = start;
    result.free = free;
    std::vector<double> horizons{1.0};
    if (options.progressive)
        horizons = {0.3, 0.5, 0.7, 1.0};
    bool known = options.slopes != nullptr;
    if (known)
        result.slopes = *options.slopes;
    const auto known_by = [&](double horizon) {
        return std::any_of(model.rows().begin(), model.rows().end(),
                           [&](const Row& row) { return row.time <= horizon * model.record_of(row).time.back(); });
    };
    for (const double horizon : horizons) {
        if (horizon < 1 && !known_by(horizon)) // single numbers
            continue;
        const Problems problems = Descent(model, noise, result, horizon).run(options, known);
        if (!problems.empty())
            return problems;
        known = false;
    }
    return result;
}

Result<VectorXd> slope_of(Model& model, const Noise& noise, const VectorXd& values, int index, bool tune,
                          double horizon) {
    Parameter& parameter = model.parameters()[static_cast<std::size_t>(index)];
    const double usual = parameter.step;
    for (int k = 0;; ++k) {
        auto slope = difference(model, noise, values, index, horizon);
        if (!slope && k > 0) { // so far away there is no such simulation
            parameter.step = usual;
            return difference(model, noise, values, index, horizon);
        }
        if (!slope || !tune || k == tunings)
            return slope;
        const double seen = slope->head(model.readings().size()).norm() * parameter.step;
        const double wanted = parameter.exact ? exact_step : visible_step;
        const double most = (parameter.hi - parameter.lo) / 4;
        if ((seen > wanted / 3 && seen < wanted * 3) || (parameter.step >= most && seen < wanted))
            return slope;
        const double factor = seen < 1e-6 * wanted ? most / parameter.step : std::clamp(wanted / seen, 1e-3, 1e3);
        parameter.step = std::min(most, parameter.step * factor);
    }
}

Result<VectorXd> residual_at(Model& model, const Noise& noise, const VectorXd& values, double horizon) {
    const auto predicted = model.predict(values, horizon);
    if (!predicted)
        return predicted.problems();
    const std::vector<int> priors = with_prior(model);
    const Eigen::Index rows = model.readings().size();
    VectorXd residual(rows + static_cast<Eigen::Index>(priors.size()));
    residual.head(rows) = noise.whiten(model.readings() - *predicted, model, horizon);
    for (std::size_t k = 0; k < priors.size(); ++k) {
        const Parameter& parameter = model.parameters()[static_cast<std::size_t>(priors[k])];
        residual[rows + static_cast<Eigen::Index>(k)] = (parameter.start - values[priors[k]]) / parameter.spread;
    }
    return residual;
}

Result<VectorXd> misfit_of(Model& model, const VectorXd& values) {
    const auto predicted = model.predict(values);
    if (!predicted)
        return predicted.problems();
    return VectorXd(model.readings() - *predicted);
}

} // namespace tumble::diagnose
