#include "fem/factor.h"

#include "fem/dissection.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace tumble::fem {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
// A quarter of the time that it takes after minimum degree, for a part of 7,800 nodes (docs/stress.md).
using Ldlt = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Dissection>;

constexpr int side_by_side = 8; // right sides that go through the factor at once: one cache line a row
using Rows = Eigen::Matrix<double, Eigen::Dynamic, side_by_side, Eigen::RowMajor>;

} // namespace

struct Factor::Parts {
    Ldlt ldlt;
};

std::optional<Factor> Factor::of(const Sparse& lower) {
    auto parts = std::make_shared<Parts>();
    parts->ldlt.compute(lower);
    if (parts->ldlt.info() != Eigen::Success)
        return std::nullopt;
    const Eigen::VectorXd pivots = parts->ldlt.vectorD();
    // A body that can move has a pivot of rounding size.
    if (pivots.size() > 0 && !(pivots.minCoeff() > 1e-13 * pivots.maxCoeff()))
        return std::nullopt;
    Factor factor;
    factor.parts_ = std::move(parts);
    return factor;
}

void Factor::solve(Eigen::Ref<Eigen::MatrixXd> sides, Crew& crew) const {
    const Sparse& lower = parts_->ldlt.matrixL().nestedExpression();
    const Eigen::VectorXd pivots = parts_->ldlt.vectorD();
    const auto& order = parts_->ldlt.permutationP();
    const Eigen::Index n = lower.cols();
    const auto blocks = static_cast<int>((sides.cols() + side_by_side - 1) / side_by_side);
    crew.share(blocks, [&](int block) {
        const Eigen::Index first = static_cast<Eigen::Index>(block) * side_by_side;
        const Eigen::Index count = std::min<Eigen::Index>(side_by_side, sides.cols() - first);
        Rows x = Rows::Zero(n, side_by_side);
        x.leftCols(count) = order * sides.middleCols(first, count);
        for (Eigen::Index j = 0; j < n; ++j)
            for (Sparse::InnerIterator entry(lower, j); entry; ++entry)
                if (entry.row() > j)
                    x.row(entry.row()) -= entry.value() * x.row(j);
        x.array().colwise() /= pivots.array();
        for (Eigen::Index j = n - 1; j >= 0; --j)
            for (Sparse::InnerIterator entry(lower, j); entry; ++entry)
                if (entry.row() > j)
                    x.row(j) -= entry.value() * x.row(entry.row());
        sides.middleCols(first, count) = order.transpose() * x.leftCols(count);
    });
}

std::int64_t Factor::entries() const {
    return parts_->ldlt.matrixL().nestedExpression().nonZeros();
}

} // namespace tumble::fem
