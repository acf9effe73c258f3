#include "fem/structure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::fem {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int bricks_at_once = 256;
constexpr Index cases_at_once = 128; // per walk over the elements
constexpr int cases_a_share = 16;    // that one thread adds up
// Share of a case's forces that may be lost. Rounding loses 1e-10 of them, a part on a hinge all.
constexpr double solved = 1e-7;

int parts_of(std::size_t count, int each) {
    return static_cast<int>((count + static_cast<std::size_t>(each) - 1) / static_cast<std::size_t>(each));
}

std::optional<Problem> refuse(const Elastic& material) {
    if (!(material.youngs_modulus > 0) || !std::isfinite(material.youngs_modulus))
        return Problem{.key = "youngs_modulus_Pa",
                       .what = fmt::format("a modulus of {} Pa is no solid's", material.youngs_modulus),
                       .fix = "give one above 0"};
    if (!(material.poisson_ratio > -1 && material.poisson_ratio < 0.5))
        return Problem{.key = "poisson_ratio",
                       .what = fmt::format("a Poisson ratio of {} is no elastic solid's", material.poisson_ratio),
                       .fix = "give one above -1 and below 0.5"};
    return std::nullopt;
}

} // namespace

Result<std::vector<Support>> encastre(const solid::HexMesh& mesh, const std::string& set) {
    const auto found = mesh.node_sets.find(set);
    if (found == mesh.node_sets.end()) {
        std::string names;
        for (const auto& [name, nodes] : mesh.node_sets)
            names += (names.empty() ? "" : ", ") + name;
        return Problem{.file = mesh.file,
                       .what = fmt::format("the mesh has no node set '{}'", set),
                       .fix = names.empty()
                                  ? "give the nodes that are held a name: *NSET, NSET=held, or a physical group of gmsh"
                                  : "it has " + names};
    }
    std::vector<Support> supports;
    for (const int node : found->second)
        for (int axis = 0; axis < 3; ++axis)
            supports.push_back({node, axis, 0});
    return supports;
}

Result<Structure> Structure::make(std::shared_ptr<const solid::HexMesh> mesh, const Elastic& material,
                                  Formulation formulation, const std::vector<Support>& supports, Crew& crew) {
    if (const auto problem = refuse(material))
        return *problem;
    Structure part;
    part.mesh_ = std::move(mesh);
    part.law_ = hooke(material);
    part.formulation_ = formulation;
    const auto nodes = static_cast<Index>(part.mesh_->nodes.size());
    part.held_ = VectorXd::Constant(3 * nodes, std::numeric_limits<double>::quiet_NaN());
    for (const Support& support : supports) {
        if (support.node < 0 || support.node >= nodes || support.axis < 0 || support.axis > 2)
            return Problem{
                .what = fmt::format("a support names node {} of {} and axis {}", support.node, nodes, support.axis),
                .fix = "it belongs to another mesh"};
        double& held = part.held_[3 * support.node + support.axis];
        if (!std::isnan(held) && held != support.displacement)
            return Problem{.what = fmt::format("node {} is held at {} m and at {} m along {}",
                                               part.mesh_->node_numbers[static_cast<std::size_t>(support.node)], held,
                                               support.displacement, "xyz"[support.axis]),
                           .fix = "leave one of the two out"};
        held = support.displacement;
    }
    for (Index row = 0; row < 3 * nodes; ++row) {
        const bool is_free = std::isnan(part.held_[row]);
        part.unknown_of_.push_back(is_free ? static_cast<int>(part.row_of_.size()) : -1);
        if (is_free)
            part.row_of_.push_back(static_cast<int>(row));
    }
    if (part.row_of_.empty())
        return Problem{.file = part.mesh_->file, .what = "every node is held", .fix = "leave some free to move"};
    part.held_ = part.held_.array().isNaN().select(0, part.held_);
    std::vector<int> meeting(static_cast<std::size_t>(nodes));
    for (const auto& hex : part.mesh_->hexes)
        for (const int node : hex)
            ++meeting[static_cast<std::size_t>(node)];
    for (const int count : meeting)
        part.shares_.push_back(1.0 / count);

    part.assemble(crew);
    part.held_force_ = part.stiffness_.selfadjointView<Eigen::Lower>() * part.held_;
    const auto factor = Factor::of(part.free_part(), crew);
    if (!factor)
        return Problem{.file = part.mesh_->file,
                       .what = "the part's supports leave it free to move",
                       .fix = "hold at least three of its nodes that lie on no line"};
    part.factor_ = std::make_shared<const Factor>(*factor);
    return part;
}

std::array<int, 24> Structure::rows_of(int hex) const {
    std::array<int, 24> rows{};
    for (std::size_t k = 0; k < 24; ++k)
        rows[k] = 3 * mesh_->hexes[static_cast<std::size_t>(hex)][k / 3] + static_cast<int>(k % 3);
    return rows;
}

void Structure::assemble(Crew& crew) {
    constexpr std::size_t entries = 300; // of an element's lower triangle
    const std::size_t hexes = mesh_->hexes.size();
    std::vector<Eigen::Triplet<double>> triplets(entries * hexes);
    crew.share(parts_of(hexes, bricks_at_once), [&](int part) {
        const int first = part * bricks_at_once;
        const int end = std::min(first + bricks_at_once, static_cast<int>(hexes));
        for (int hex = first; hex < end; ++hex) {
            const Brick brick = brick_of(mesh_->corners_of(hex), law_, formulation_);
            const std::array<int, 24> rows = rows_of(hex);
            auto* to = &triplets[entries * static_cast<std::size_t>(hex)];
            for (std::size_t a = 0; a < 24; ++a)
                for (std::size_t b = 0; b <= a; ++b)
                    *to++ = {std::max(rows[a], rows[b]), std::min(rows[a], rows[b]),
                             brick.stiffness(static_cast<Index>(a), static_cast<Index>(b))};
        }
    });
    const auto rows = static_cast<Index>(3 * mesh_->nodes.size());
    stiffness_.resize(rows, rows);
    stiffness_.setFromTriplets(triplets.begin(), triplets.end());
}

Sparse Structure::free_part() const {
    const auto unknowns = static_cast<Index>(row_of_.size());
    Sparse part(unknowns, unknowns);
    part.reserve(stiffness_.nonZeros());
    for (Index unknown = 0; unknown < unknowns; ++unknown) {
        part.startVec(unknown);
        for (Sparse::InnerIterator entry(stiffness_, row_of_[static_cast<std::size_t>(unknown)]); entry; ++entry)
            if (const int row = unknown_of_[static_cast<std::size_t>(entry.row())]; row >= 0)
                part.insertBack(row, unknown) = entry.value();
    }
    part.finalize();
    return part;
}

Solution Structure::solve(const MatrixXd& loads, Crew& crew) const {
    const auto unknowns = static_cast<Index>(row_of_.size());
    MatrixXd sides(unknowns, loads.cols());
    for (Index u = 0; u < unknowns; ++u) {
        const int row = row_of_[static_cast<std::size_t>(u)];
        sides.row(u) = loads.row(row).array() - held_force_[row];
    }
    factor_->solve(sides, crew);
    Solution solution;
    solution.displacement = held_.replicate(1, loads.cols());
    for (Index u = 0; u < unknowns; ++u)
        solution.displacement.row(row_of_[static_cast<std::size_t>(u)]) = sides.row(u);
    weigh(loads, solution, crew);
    find_stress(solution, crew);
    return solution;
}

void Structure::weigh(const MatrixXd& loads, Solution& solution, Crew& crew) const {
    const Index cases = loads.cols();
    solution.support_force.resize(3, cases);
    solution.residual.resize(cases);
    solution.unbalance.resize(cases);
    const Vector3d origin = mesh_->nodes.front();
    crew.share(static_cast<int>(cases), [&](int c) {
        const VectorXd left = stiffness_.selfadjointView<Eigen::Lower>() * solution.displacement.col(c) - loads.col(c);
        Vector3d support = Vector3d::Zero(), force = Vector3d::Zero(), moment = Vector3d::Zero();
        double residual = 0, largest = 0, forces = 0, moments = 0;
        for (Index node = 0; node < left.size() / 3; ++node) {
            Vector3d reaction = Vector3d::Zero();
            for (Index axis = 0; axis < 3; ++axis) {
                const Index row = 3 * node + axis;
                largest = std::max({largest, std::abs(loads(row, c)), std::abs(held_force_[row])});
                if (unknown_of_[static_cast<std::size_t>(row)] >= 0)
                    residual = std::max(residual, std::abs(left[row]));
                else
                    reaction[axis] = left[row];
            }
            const Vector3d load = loads.col(c).segment<3>(3 * node);
            const Vector3d arm = mesh_->nodes[static_cast<std::size_t>(node)] - origin;
            support += reaction;
            force += load + reaction;
            moment += arm.cross(load + reaction);
            forces += load.norm() + reaction.norm();
            moments += arm.norm() * (load.norm() + reaction.norm());
        }
        solution.support_force.col(c) = support;
        solution.residual[c] = largest > 0 ? residual / largest : 0;
        solution.unbalance[c] =
            forces > 0 ? std::max(force.norm() / forces, moments > 0 ? moment.norm() / moments : 0) : 0;
    });
}

void Structure::find_stress(Solution& solution, Crew& crew) const {
    const Index cases = solution.displacement.cols();
    const auto hexes = static_cast<int>(mesh_->hexes.size());
    solution.stress = MatrixXd::Zero(static_cast<Index>(6 * mesh_->nodes.size()), cases);
    std::vector<MatrixXd> corners(static_cast<std::size_t>(std::min(bricks_at_once, hexes))); // Pa, 48 x cases a brick
    for (Index first = 0; first < cases; first += cases_at_once) {
        const Index count = std::min(cases_at_once, cases - first);
        for (int begin = 0; begin < hexes; begin += bricks_at_once) {
            const int bricks = std::min(bricks_at_once, hexes - begin);
            crew.share(bricks, [&](int b) {
                const std::array<int, 24> rows = rows_of(begin + b);
                MatrixXd moved(24, count);
                for (std::size_t k = 0; k < 24; ++k)
                    moved.row(static_cast<Index>(k)) = solution.displacement.row(rows[k]).segment(first, count);
                corners[static_cast<std::size_t>(b)].noalias() =
                    brick_of(mesh_->corners_of(begin + b), law_, formulation_).corner_stress * moved;
            });
            // By cases, not by bricks: each node's sum keeps the order of its bricks, whoever adds it up.
            crew.share(parts_of(static_cast<std::size_t>(count), cases_a_share), [&](int part) {
                const Index from = static_cast<Index>(part) * cases_a_share;
                const Index width = std::min<Index>(cases_a_share, count - from);
                for (int b = 0; b < bricks; ++b)
                    for (int corner = 0; corner < 8; ++corner) {
                        const int node =
                            mesh_->hexes[static_cast<std::size_t>(begin + b)][static_cast<std::size_t>(corner)];
                        solution.stress.block(6 * node, first + from, 6, width) +=
                            shares_[static_cast<std::size_t>(node)] *
                            corners[static_cast<std::size_t>(b)].block(6 * corner, from, 6, width);
                    }
            });
        }
    }
}

std::optional<Problem> Structure::distrust(const Solution& solution) const {
    const double residual = solution.residual.size() > 0 ? solution.residual.maxCoeff() : 0;
    const double unbalance = solution.unbalance.size() > 0 ? solution.unbalance.maxCoeff() : 0;
    if (residual <= solved && unbalance <= solved && solution.displacement.allFinite())
        return std::nullopt;
    return Problem{.file = mesh_->file,
                   .what =
                       fmt::format("the solution cannot be trusted: {:.2g} of the largest force is left over at a "
                                   "free node, loads and supports miss equilibrium by {:.2g}, where {:.0e} is allowed",
                                   residual, unbalance, solved),
                   .fix = "hold more nodes, that lie on no line, and look for elements that hang by an edge or are "
                          "very flat"};
}

Eigen::Matrix<double, 6, 8> Structure::point_stress(int hex, const VectorXd& displacement) const {
    const std::array<int, 24> rows = rows_of(hex);
    Eigen::Matrix<double, 24, 1> moved;
    for (std::size_t k = 0; k < 24; ++k)
        moved[static_cast<Index>(k)] = displacement[rows[k]];
    const Eigen::Matrix<double, 48, 1> stress =
        brick_of(mesh_->corners_of(hex), law_, formulation_).point_stress * moved;
    return Eigen::Map<const Eigen::Matrix<double, 6, 8>>(stress.data());
}

} // namespace tumble::fem
