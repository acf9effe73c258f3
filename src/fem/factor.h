#pragma once

#include "base/parallel_for.h"
#include "fem/supernodes.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <optional>

namespace tumble::fem {

/// A symmetric positive definite matrix, factorised once for all right sides.
class Factor {
public:
    /// From the lower triangle. Nothing where the matrix is not positive definite. The bits do not depend on the crew.
    static std::optional<Factor> of(const Eigen::SparseMatrix<double>& lower, Crew& crew);

    /// Each column of `sides` becomes its solution. The bits do not depend on the crew.
    void solve(Eigen::Ref<Eigen::MatrixXd> sides, Crew& crew) const;

    /// Entries of the triangular factor that are kept.
    [[nodiscard]] std::int64_t entries() const;
    /// Multiplications and additions that it took.
    [[nodiscard]] double operations() const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

} // namespace tumble::fem
