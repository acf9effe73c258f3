#include "excitation/fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::excitation {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double turn = 2 * std::numbers::pi;
constexpr double least_noise = 1e-12; // of the signals' size: noise that rounding alone would leave

/// Drift and waves at every sample, a column each.
MatrixXd basis_of(const Signal& signal, const std::vector<Wave>& waves, const std::vector<double>& parameters) {
    const auto rows = static_cast<Index>(signal.time.size());
    MatrixXd basis(rows, FittedSignal::index(waves.size()));
    const double middle = 0.5 * (signal.time.front() + signal.time.back());
    const double half = std::max(0.5 * (signal.time.back() - signal.time.front()), 1e-300);
    for (Index k = 0; k < rows; ++k) {
        const double x = (signal.time[static_cast<std::size_t>(k)] - middle) / half;
        basis(k, 0) = 1;
        basis(k, 1) = x;
        basis(k, 2) = x * x - 1.0 / 3;
    }
    for (std::size_t w = 0; w < waves.size(); ++w) {
        const double rate = turn * waves[w].factor * parameters[static_cast<std::size_t>(waves[w].frequency)];
        const double decay = waves[w].decay < 0 ? 0 : parameters[static_cast<std::size_t>(waves[w].decay)];
        const Index column = FittedSignal::index(w);
        for (Index k = 0; k < rows; ++k) {
            const double t = signal.time[static_cast<std::size_t>(k)] - signal.origin;
            const double size = decay == 0 ? 1 : std::exp(-decay * t);
            basis(k, column) = size * std::cos(rate * t);
            basis(k, column + 1) = size * std::sin(rate * t);
        }
    }
    return basis;
}

/// How the fitted signal changes with each parameter while the coefficients stay.
MatrixXd slopes_of(const Signal& signal, const std::vector<Wave>& waves, const MatrixXd& basis, const VectorXd& fitted,
                   std::size_t parameters) {
    const Index rows = basis.rows();
    MatrixXd slopes = MatrixXd::Zero(rows, static_cast<Index>(parameters));
    const VectorXd t = Eigen::Map<const VectorXd>(signal.time.data(), rows).array() - signal.origin;
    for (std::size_t w = 0; w < waves.size(); ++w) {
        const Index column = FittedSignal::index(w);
        const double c = fitted[column], s = fitted[column + 1];
        slopes.col(waves[w].frequency).array() +=
            turn * waves[w].factor * t.array() * (s * basis.col(column) - c * basis.col(column + 1)).array();
        if (waves[w].decay >= 0)
            slopes.col(waves[w].decay).array() -=
                t.array() * (c * basis.col(column) + s * basis.col(column + 1)).array();
    }
    return slopes;
}

/// One signal with the parameters held: its coefficients, and what they leave.
struct Held {
    MatrixXd basis;
    Eigen::LDLT<MatrixXd> normal; // of basis^T basis
    FittedSignal fitted;
};

Held hold(const Signal& signal, const std::vector<Wave>& waves, const std::vector<double>& parameters) {
    Held held;
    held.basis = basis_of(signal, waves, parameters);
    const Eigen::Map<const VectorXd> y(signal.value.data(), held.basis.rows());
    MatrixXd gram = MatrixXd::Zero(held.basis.cols(), held.basis.cols());
    gram.selfadjointView<Eigen::Lower>().rankUpdate(held.basis.transpose());
    held.normal.compute(gram.selfadjointView<Eigen::Lower>());
    held.fitted.coefficients = held.normal.solve(held.basis.transpose() * y);
    held.fitted.rest = y - held.basis * held.fitted.coefficients;
    const auto free = std::max<Index>(1, held.basis.rows() - held.basis.cols());
    held.fitted.noise = std::sqrt(held.fitted.rest.squaredNorm() / static_cast<double>(free));
    return held;
}

std::vector<Held> hold_all(const std::vector<Signal>& signals, const std::vector<Wave>& waves,
                           const std::vector<double>& parameters, double floor) {
    std::vector<Held> all;
    for (const Signal& signal : signals) {
        all.push_back(hold(signal, waves, parameters));
        all.back().fitted.noise = std::max(all.back().fitted.noise, floor);
    }
    return all;
}

/// Minus the logarithm of the likelihood, with each signal's noise at its best.
double cost_of(const std::vector<Held>& all) {
    double cost = 0;
    for (const Held& held : all)
        cost += static_cast<double>(held.basis.rows()) * std::log(held.fitted.noise);
    return cost;
}

/// The normal equations of the parameters, and how each signal's coefficients follow them.
struct Step {
    MatrixXd curvature;
    VectorXd slope;
    std::vector<MatrixXd> shifts;
};

Step step_from(const std::vector<Signal>& signals, const std::vector<Wave>& waves, const std::vector<Held>& all,
               std::size_t parameters) {
    const auto size = static_cast<Index>(parameters);
    Step step{MatrixXd::Zero(size, size), VectorXd::Zero(size), {}};
    for (std::size_t k = 0; k < signals.size(); ++k) {
        const Held& held = all[k];
        MatrixXd slopes = slopes_of(signals[k], waves, held.basis, held.fitted.coefficients, parameters);
        step.shifts.emplace_back(-held.normal.solve(held.basis.transpose() * slopes));
        slopes += held.basis * step.shifts.back();
        const double weight = 1 / (held.fitted.noise * held.fitted.noise);
        step.curvature += weight * slopes.transpose() * slopes;
        step.slope += weight * slopes.transpose() * held.fitted.rest;
    }
    return step;
}

double size_of(const std::vector<Signal>& signals) {
    double size = 0;
    for (const Signal& signal : signals)
        for (const double value : signal.value)
            size = std::max(size, std::abs(value));
    return std::max(size, 1e-290);
}

} // namespace

Fit fit_waves(const std::vector<Signal>& signals, const std::vector<Wave>& waves, std::vector<double> start,
              int rounds) {
    const double floor = least_noise * size_of(signals);
    Fit fit{.parameters = std::move(start), .covariance = {}, .signals = {}};
    std::vector<Held> all = hold_all(signals, waves, fit.parameters, floor);
    Step step = step_from(signals, waves, all, fit.parameters.size());
    for (int round = 0; round < rounds && !fit.settled; ++round) {
        const Eigen::LDLT<MatrixXd> curvature(step.curvature);
        VectorXd change = curvature.solve(step.slope);
        const VectorXd errors =
            curvature.solve(MatrixXd::Identity(change.size(), change.size())).diagonal().cwiseMax(0).cwiseSqrt();
        if (!change.allFinite())
            break;
        fit.settled = true;
        for (Index k = 0; k < change.size(); ++k)
            fit.settled &= std::abs(change[k]) <
                           std::max(1e-3 * errors[k], 1e-11 * std::abs(fit.parameters[static_cast<std::size_t>(k)]));
        const double before = cost_of(all);
        bool moved = false;
        for (int halving = 0; halving < 8 && !moved; ++halving, change *= 0.5) {
            std::vector<double> tried = fit.parameters;
            for (std::size_t k = 0; k < tried.size(); ++k)
                tried[k] += change[static_cast<Index>(k)];
            std::vector<Held> there = hold_all(signals, waves, tried, floor);
            if (cost_of(there) > before && !fit.settled)
                continue;
            fit.parameters = std::move(tried);
            all = std::move(there);
            moved = true;
        }
        if (!moved)
            break;
        step = step_from(signals, waves, all, fit.parameters.size());
    }
    const auto size = static_cast<Index>(fit.parameters.size());
    fit.covariance = Eigen::LDLT<MatrixXd>(step.curvature).solve(MatrixXd::Identity(size, size));
    for (std::size_t k = 0; k < all.size(); ++k) {
        FittedSignal& fitted = all[k].fitted;
        const Index columns = all[k].basis.cols();
        fitted.covariance = fitted.noise * fitted.noise * all[k].normal.solve(MatrixXd::Identity(columns, columns));
        fitted.shift = std::move(step.shifts[k]);
        fit.signals.push_back(std::move(fitted));
    }
    return fit;
}

} // namespace tumble::excitation
