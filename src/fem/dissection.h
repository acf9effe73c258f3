#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <metis.h>
#include <numeric>
#include <vector>

namespace tumble::fem {

/// METIS' nested dissection as an ordering of Eigen's factorisations. (Eigen/MetisSupport does the same, but does not
/// compile by itself in Debian 12.)
struct Dissection {
    using PermutationType = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

    /// `matrix`: symmetric, both triangles; row i of the ordered matrix is row order.indices()[i] of this one.
    template <class Matrix> void operator()(const Matrix& matrix, PermutationType& order) const {
        static_assert(sizeof(idx_t) == sizeof(int));
        idx_t size = static_cast<idx_t>(matrix.cols());
        std::vector<idx_t> begins{0}, neighbours;
        neighbours.reserve(static_cast<std::size_t>(matrix.nonZeros()));
        for (int column = 0; column < size; ++column) {
            for (typename Matrix::InnerIterator entry(matrix, column); entry; ++entry)
                if (entry.index() != column)
                    neighbours.push_back(static_cast<idx_t>(entry.index()));
            begins.push_back(static_cast<idx_t>(neighbours.size()));
        }
        std::vector<idx_t> place(static_cast<std::size_t>(size));
        order.resize(size);
        if (neighbours.empty() || METIS_NodeND(&size, begins.data(), neighbours.data(), nullptr, nullptr,
                                               order.indices().data(), place.data()) != METIS_OK)
            std::iota(order.indices().data(), order.indices().data() + size, 0);
    }
};

} // namespace tumble::fem
