#pragma once

#include "base/parallel_for.h"
#include "base/problem.h"
#include "fem/brick.h"
#include "fem/factor.h"
#include "solid/hex_mesh.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <optional>
#include <vector>

/// A part under load: linear elastic, small displacements, many load cases on one factorisation.
namespace tumble::fem {

/// A node that may not move along an axis, or by so much.
struct Support {
    int node = 0;
    int axis = 0;
    double displacement = 0; // m
};

/// Every node of the set held in all three directions. Problem: no such set; names those there are.
Result<std::vector<Support>> encastre(const solid::HexMesh& mesh, const std::string& set);

/// Load cases solved together: one column each.
struct Solution {
    Eigen::MatrixXd displacement;   // m, rows 3 * node + axis
    Eigen::MatrixXd stress;         // Pa, rows 6 * node + component; means over the elements that meet at the node
    Eigen::Matrix3Xd support_force; // N, what all supports together bear
    Eigen::VectorXd residual;       // largest force left over at a free node, over the largest force of the case
    Eigen::VectorXd unbalance; // loads and support forces together, as force and as moment, over what they add up to
};

class Structure {
public:
    /// Problems: a support that names no node or is there twice with different displacements; a part that its supports
    /// leave free to move; elastic constants that no solid has.
    static Result<Structure> make(std::shared_ptr<const solid::HexMesh> mesh, const Elastic& material,
                                  Formulation formulation, const std::vector<Support>& supports, Crew& crew);

    /// `loads`: N, rows 3 * node + axis, a column a case. What acts on a held node goes into its support.
    [[nodiscard]] Solution solve(const Eigen::MatrixXd& loads, Crew& crew) const;

    /// What is wrong with a solution whose residual or unbalance is more than rounding; NaN is.
    [[nodiscard]] std::optional<Problem> distrust(const Solution& solution) const;

    /// Stresses at the integration points of one element, Pa, for one case's displacements.
    [[nodiscard]] Eigen::Matrix<double, 6, 8> point_stress(int hex, const Eigen::VectorXd& displacement) const;

    [[nodiscard]] const solid::HexMesh& mesh() const { return *mesh_; }
    [[nodiscard]] const Factor& factor() const { return *factor_; }

private:
    Structure() = default;
    void assemble(Crew& crew);
    [[nodiscard]] Eigen::SparseMatrix<double> free_part() const;
    void weigh(const Eigen::MatrixXd& loads, Solution& solution, Crew& crew) const;
    void find_stress(Solution& solution, Crew& crew) const;
    [[nodiscard]] std::array<int, 24> rows_of(int hex) const;

    std::shared_ptr<const solid::HexMesh> mesh_;
    Eigen::Matrix<double, 6, 6> law_;
    Formulation formulation_ = Formulation::standard;
    std::vector<int> unknown_of_;           // per row of the displacements, or -1: held
    std::vector<int> row_of_;               // per unknown
    Eigen::VectorXd held_;                  // m, displacements of the supports, 0 elsewhere; by rows
    Eigen::VectorXd held_force_;            // N, by rows: what they take
    std::vector<double> shares_;            // per node: 1 / hexahedra that meet there
    Eigen::SparseMatrix<double> stiffness_; // lower triangle, all rows
    std::shared_ptr<const Factor> factor_;
};

} // namespace tumble::fem
