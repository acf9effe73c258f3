#pragma once

#include "diagnose/model.h"
#include "diagnose/noise.h"

namespace tumble::diagnose {

/// Where a fit ended. Rows: the model's readings, whitened, then one for each parameter with a prior.
struct Fit {
    VectorXd values;       // of all parameters
    std::vector<int> free; // those that were adjusted
    VectorXd residual;     // readings less prediction; priors: start less value, over spread
    MatrixXd slopes;       // of the prediction, per unit of each free parameter
    double chi_square = 0;
    double decrement = 0; // nats that a linear step would still gain
    bool converged = false;
};

struct FitOptions {
    bool progressive = false; // begin with 30 % of every record, then 50, 70, 100 %
    double tolerance = 0.01;  // nats
    /// Nats that a fit may lack where kinks end it: a tenth of what parts two names, of which one is then wrong with a
    /// probability below that of the normal's tail beyond sqrt(5.4), 1 %.
    double short_enough = 0.3;
    int most_steps = 12;              // per horizon; half of them at those before the last
    const MatrixXd* slopes = nullptr; // known at the start, for the free parameters
};

/// Least squares by Levenberg and Marquardt's method, slopes by central differences and, from step to step, Broyden's
/// update. Problems: a start that cannot be simulated. A value that cannot be simulated is a step too far.
Result<Fit> fit(Model& model, const Noise& noise, const VectorXd& start, const std::vector<int>& free,
                const FitOptions& options = {});

/// Change of the whitened prediction (and priors) per unit of a parameter, by central differences; at a bound to one
/// side. With `tune` the parameter's step is first brought to where it changes the readings by about one standard
/// error, or by a hundredth where it is exact.
Result<VectorXd> slope_of(Model& model, const Noise& noise, const VectorXd& values, int index, bool tune,
                          double horizon = 1);

/// Rows as those of Fit::residual; those of readings beyond the horizon are 0. Problems: values that cannot be
/// simulated.
Result<VectorXd> residual_at(Model& model, const Noise& noise, const VectorXd& values, double horizon = 1);

/// Readings less prediction, in the unit of each channel.
Result<VectorXd> misfit_of(Model& model, const VectorXd& values);

} // namespace tumble::diagnose
