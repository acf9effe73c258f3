#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

/// Where the entries of a sparse triangular factor lie, before any of them is computed.
namespace tumble::fem {

inline std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Neighbouring columns of the factor that have the same rows: one dense block.
struct Supernode {
    int first = 0, width = 0; // columns
    std::vector<int> rows;    // of its block, ascending; the first `width` are its columns
    std::vector<int> children;
    int parent = -1; // where its columns act next; -1: nowhere

    [[nodiscard]] int height() const { return static_cast<int>(rows.size()); }
};

/// Children stand before their parents, and the columns of a subtree lie side by side.
struct Supernodes {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order; // from the matrix' rows to the factor's
    Eigen::SparseMatrix<double> matrix;                                  // in the factor's order, lower triangle
    std::vector<Supernode> nodes;

    /// Of the factor's lower triangle, those kept as zeros included.
    [[nodiscard]] std::int64_t entries() const;
    /// Multiplications and additions of the factorisation.
    [[nodiscard]] double operations() const;
};

/// Of a symmetric matrix given by its lower triangle: METIS' nested dissection, the elimination tree (J. Liu 1990, SIAM
/// J. Matrix Anal. Appl. 11, 134) and supernodes, joined with their parents where that costs few zeros (C. Ashcraft and
/// R. Grimes 1989, ACM Trans. Math. Softw. 15, 291).
Supernodes supernodes_of(const Eigen::SparseMatrix<double>& lower);

} // namespace tumble::fem
