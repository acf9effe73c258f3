// A multifrontal Cholesky factorisation (I. Duff and J. Reid 1983, ACM Trans. Math. Softw. 9, 302): each supernode is
// one dense block, so that nearly all of the work is products of dense matrices. Libraries do the same, but CHOLMOD's
// supernodes are under the GPL, and MUMPS and SPOOLES of Debian bring MPI and its compilers with them.
#include "fem/factor.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>

namespace tumble::fem {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;
using Share = std::function<void(int, const std::function<void(int)>&)>;

constexpr Index panel = 96; // columns that are eliminated at once: a block's width for its products
constexpr Index strip = 96; // rows or columns that one thread takes of a product
constexpr int subtrees_wanted = 64;
constexpr int side_by_side = 32; // right sides that go through the factor at once
using Rows = Eigen::Matrix<double, Eigen::Dynamic, side_by_side, Eigen::RowMajor>;

int strips_of(Index size) {
    return static_cast<int>((size + strip - 1) / strip);
}

/// Eliminates the first `width` columns of a block, of which the lower triangle counts; false where it is not positive
/// definite.
bool eliminate(MatrixXd& block, Index width, const Share& share) {
    const Index height = block.rows();
    for (Index k = 0; k < width; k += panel) {
        const Index count = std::min(panel, width - k), end = k + count, below = height - end;
        auto corner = block.block(k, k, count, count);
        Eigen::LLT<Eigen::Ref<MatrixXd>> corner_factor(corner);
        if (corner_factor.info() != Eigen::Success)
            return false;
        share(strips_of(below), [&](int s) {
            const Index from = end + s * strip;
            auto part = block.block(from, k, std::min(strip, height - from), count);
            corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(part);
        });
        share(strips_of(below), [&](int s) {
            const Index from = end + s * strip, columns = std::min(strip, height - from);
            block.block(from, from, height - from, columns).noalias() -=
                block.block(from, k, height - from, count) * block.block(from, k, columns, count).transpose();
        });
    }
    return true;
}

/// Disjoint subtrees that hold most of the work, about as many as wanted; what is above them remains.
std::vector<int> subtrees_of(const std::vector<Supernode>& nodes) {
    std::vector<double> work(nodes.size());
    std::vector<int> roots;
    for (std::size_t s = 0; s < nodes.size(); ++s) {
        work[s] += nodes[s].width * std::pow(nodes[s].height(), 2);
        if (nodes[s].parent >= 0)
            work[at(nodes[s].parent)] += work[s];
        else
            roots.push_back(static_cast<int>(s));
    }
    const auto lighter = [&](int a, int b) { return work[at(a)] < work[at(b)]; };
    std::make_heap(roots.begin(), roots.end(), lighter);
    while (!roots.empty() && roots.size() < subtrees_wanted) {
        std::pop_heap(roots.begin(), roots.end(), lighter);
        const std::vector<int>& children = nodes[at(roots.back())].children;
        if (children.empty())
            break;
        roots.pop_back();
        for (const int child : children) {
            roots.push_back(child);
            std::push_heap(roots.begin(), roots.end(), lighter);
        }
    }
    return roots;
}

/// Goes through the supernodes, children first.
class Elimination {
public:
    Elimination(const Supernodes& plan, std::vector<MatrixXd>& columns)
        : plan_(plan), columns_(columns), updates_(plan.nodes.size()) {}

    bool run(Crew& crew) {
        const std::vector<int> roots = subtrees_of(plan_.nodes);
        std::vector<int> tree(plan_.nodes.size(), -1); // which subtree a supernode belongs to
        for (std::size_t r = 0; r < roots.size(); ++r)
            tree[at(roots[r])] = static_cast<int>(r);
        for (int s = static_cast<int>(tree.size()) - 1; s >= 0; --s)
            if (const int up = plan_.nodes[at(s)].parent; up >= 0 && tree[at(up)] >= 0)
                tree[at(s)] = tree[at(up)];
        const Share alone = [](int n, const std::function<void(int)>& task) {
            for (int i = 0; i < n; ++i)
                task(i);
        };
        std::atomic<bool> definite = true;
        crew.share(static_cast<int>(roots.size()), [&](int r) {
            std::vector<int> place(at(static_cast<int>(plan_.matrix.cols())));
            for (int s = 0; s <= roots[at(r)]; ++s)
                if (tree[at(s)] == r && definite && !take(s, place, alone))
                    definite = false; // only ever this way, so that no thread can take it back
        });
        const Share together = [&](int n, const std::function<void(int)>& task) { crew.share(n, task); };
        std::vector<int> place(at(static_cast<int>(plan_.matrix.cols())));
        for (int s = 0; s < static_cast<int>(tree.size()) && definite; ++s)
            if (tree[at(s)] < 0)
                definite = take(s, place, together);
        return definite;
    }

private:
    /// `place`: of a row in the block, filled here for the block's rows.
    bool take(int number, std::vector<int>& place, const Share& share) {
        const Supernode& node = plan_.nodes[at(number)];
        const Index height = node.height(), width = node.width;
        for (int row = 0; row < node.height(); ++row)
            place[at(node.rows[at(row)])] = row;
        MatrixXd block = MatrixXd::Zero(height, height);
        for (int column = 0; column < node.width; ++column)
            for (Sparse::InnerIterator entry(plan_.matrix, node.first + column); entry; ++entry)
                block(place[at(static_cast<int>(entry.row()))], column) = entry.value();
        for (const int child : node.children)
            add(child, place, block);
        if (!eliminate(block, width, share))
            return false;
        columns_[at(number)] = block.leftCols(width);
        updates_[at(number)] = block.bottomRightCorner(height - width, height - width);
        return true;
    }

    /// What a child's columns leave for those above.
    void add(int number, const std::vector<int>& place, MatrixXd& block) {
        const Supernode& child = plan_.nodes[at(number)];
        MatrixXd& update = updates_[at(number)];
        std::vector<int> to;
        for (int row = child.width; row < child.height(); ++row)
            to.push_back(place[at(child.rows[at(row)])]);
        for (Index column = 0; column < update.cols(); ++column)
            for (Index row = column; row < update.rows(); ++row)
                block(to[static_cast<std::size_t>(row)], to[static_cast<std::size_t>(column)]) += update(row, column);
        update.resize(0, 0);
    }

    const Supernodes& plan_;
    std::vector<MatrixXd>& columns_;
    std::vector<MatrixXd> updates_; // what is left of each block for its parent
};

} // namespace

struct Factor::Parts {
    Supernodes plan;
    std::vector<MatrixXd> columns; // per supernode: the factor's entries, by its rows
};

std::optional<Factor> Factor::of(const Sparse& lower, Crew& crew) {
    auto parts = std::make_shared<Parts>();
    parts->plan = supernodes_of(lower);
    parts->columns.resize(parts->plan.nodes.size());
    if (!Elimination(parts->plan, parts->columns).run(crew))
        return std::nullopt;
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    for (const MatrixXd& columns : parts->columns) {
        const Eigen::ArrayXd pivots = columns.diagonal().array().square();
        least = std::min(least, pivots.minCoeff());
        largest = std::max(largest, pivots.maxCoeff());
    }
    // A body that can move has a pivot of rounding size.
    if (!(least > 1e-13 * largest))
        return std::nullopt;
    Factor factor;
    factor.parts_ = std::move(parts);
    return factor;
}

void Factor::solve(Eigen::Ref<MatrixXd> sides, Crew& crew) const {
    const std::vector<Supernode>& nodes = parts_->plan.nodes;
    const auto& order = parts_->plan.order;
    const auto blocks = static_cast<int>((sides.cols() + side_by_side - 1) / side_by_side);
    crew.share(blocks, [&](int number) {
        const Index first = static_cast<Index>(number) * side_by_side;
        const Index count = std::min<Index>(side_by_side, sides.cols() - first);
        Rows x = Rows::Zero(sides.rows(), side_by_side), below;
        x.leftCols(count) = order * sides.middleCols(first, count);
        for (std::size_t s = 0; s < nodes.size(); ++s) {
            const Supernode& node = nodes[s];
            const MatrixXd& columns = parts_->columns[s];
            auto own = x.middleRows(node.first, node.width);
            columns.topRows(node.width).triangularView<Eigen::Lower>().solveInPlace(own);
            below.noalias() = columns.bottomRows(node.height() - node.width) * own;
            for (Index row = 0; row < below.rows(); ++row)
                x.row(node.rows[static_cast<std::size_t>(node.width + row)]) -= below.row(row);
        }
        for (std::size_t s = nodes.size(); s-- > 0;) {
            const Supernode& node = nodes[s];
            const MatrixXd& columns = parts_->columns[s];
            auto own = x.middleRows(node.first, node.width);
            below.resize(node.height() - node.width, side_by_side);
            for (Index row = 0; row < below.rows(); ++row)
                below.row(row) = x.row(node.rows[static_cast<std::size_t>(node.width + row)]);
            own.noalias() -= columns.bottomRows(below.rows()).transpose() * below;
            columns.topRows(node.width).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
        }
        sides.middleCols(first, count) = order.transpose() * x.leftCols(count);
    });
}

std::int64_t Factor::entries() const {
    return parts_->plan.entries();
}

double Factor::operations() const {
    return parts_->plan.operations();
}

} // namespace tumble::fem
