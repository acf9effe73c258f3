#pragma once

#include "base/distributions.h"

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

namespace tumble::diagnose {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Degrees of freedom of a covariance that is known, not estimated.
constexpr double covariance_known = std::numeric_limits<double>::infinity();

/// P(Hotelling's T squared of so many dimensions > x), the covariance estimated with so many degrees of freedom
/// (Mardia, Kent and Bibby 1979, theorem 3.5.2); chi-square where it is known. 1 where the degrees do not suffice to
/// judge.
double hotelling_tail(double x, double dimensions, double degrees);

/// Which values of a standard normal z count: an amplitude that cannot be negative has one side.
enum class Side { both, above, below };

/// The value that the largest of z_j squared stays below with probability 1 - alpha, z standard normal with this
/// correlation, and 0 on the side that does not count (`sides`, of each; empty: both of all): what the best of a
/// library of causes reaches where there is none. Student's t in place of the normal where the covariance was
/// estimated. Drawn 40,000 times.
double quantile_of_largest(const MatrixXd& correlation, const std::vector<Side>& sides, double alpha,
                           std::uint64_t seed, double degrees = covariance_known);

/// Takes a subspace out of vectors.
class Projector {
public:
    /// The span of these columns; those that depend on others (1e-7 of the largest) count once.
    explicit Projector(const MatrixXd& columns);

    [[nodiscard]] MatrixXd out(const MatrixXd& vectors) const {
        return vectors - basis_ * (basis_.transpose() * vectors);
    }
    [[nodiscard]] VectorXd out(const VectorXd& vector) const { return vector - basis_ * (basis_.transpose() * vector); }
    /// Length squared of the vector's part inside the span.
    [[nodiscard]] double inside(const VectorXd& vector) const { return (basis_.transpose() * vector).squaredNorm(); }
    /// Orthonormal columns of the span.
    [[nodiscard]] const MatrixXd& basis() const { return basis_; }
    [[nodiscard]] int rank() const { return static_cast<int>(basis_.cols()); }

private:
    MatrixXd basis_;
};

/// The columns, each of length 1; those of no length stay as they are.
MatrixXd unit_columns(MatrixXd columns);

} // namespace tumble::diagnose
