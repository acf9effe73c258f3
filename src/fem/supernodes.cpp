#include "fem/supernodes.h"

#include "fem/dissection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tumble::fem {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
using Numbers = std::vector<int>;

// Supernodes so narrow are joined whatever it costs; wider ones where no more than this share of the block are zeros.
constexpr int narrow_width = 12;
constexpr double zeros_allowed = 0.15;

/// The upper triangle of the matrix in another order: column j holds the entries of row j of the lower one.
Sparse upper_in(const Sparse& lower, const Order& order) {
    Sparse upper(lower.rows(), lower.cols());
    upper.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order);
    return upper;
}

/// Per column the next one that it acts on; -1: none.
Numbers elimination_tree(const Sparse& upper) {
    const int size = static_cast<int>(upper.cols());
    Numbers parent(at(size), -1), ancestor(at(size), -1);
    for (int j = 0; j < size; ++j)
        for (Sparse::InnerIterator entry(upper, j); entry; ++entry)
            for (int i = static_cast<int>(entry.row()); i != -1 && i < j;) {
                const int next = ancestor[at(i)];
                ancestor[at(i)] = j; // shortens the way for those who come later
                if (next == -1)
                    parent[at(i)] = j;
                i = next;
            }
    return parent;
}

/// Place of each column when the columns of every subtree lie side by side, children first.
Order postorder(const Numbers& parent) {
    const int size = static_cast<int>(parent.size());
    Numbers first_child(at(size), -1), next_sibling(at(size), -1), stack;
    for (int j = size - 1; j >= 0; --j) {
        const int up = parent[at(j)];
        if (up == -1) {
            stack.push_back(j);
            continue;
        }
        next_sibling[at(j)] = first_child[at(up)];
        first_child[at(up)] = j;
    }
    Order order(size);
    int place = 0;
    while (!stack.empty()) {
        const int j = stack.back();
        if (const int child = first_child[at(j)]; child != -1) {
            first_child[at(j)] = next_sibling[at(child)];
            stack.push_back(child);
            continue;
        }
        order.indices()[j] = place++;
        stack.pop_back();
    }
    return order;
}

/// Entries of each column of the factor, its diagonal included: row i reaches from each of its entries up the tree.
Numbers column_counts(const Sparse& upper, const Numbers& parent) {
    const int size = static_cast<int>(upper.cols());
    Numbers counts(at(size), 1), seen(at(size), -1);
    for (int i = 0; i < size; ++i) {
        seen[at(i)] = i;
        for (Sparse::InnerIterator entry(upper, i); entry; ++entry)
            for (int j = static_cast<int>(entry.row()); j < i && seen[at(j)] != i; j = parent[at(j)]) {
                seen[at(j)] = i;
                ++counts[at(j)];
            }
    }
    return counts;
}

/// A run of columns that may still grow downwards by a child that ends where it begins.
struct Run {
    int first = 0, width = 0;
    std::int64_t height = 0; // rows of the block
    std::int64_t zeros = 0;  // in it, kept as if they were entries

    [[nodiscard]] std::int64_t entries() const { return width * height - std::int64_t{width} * (width - 1) / 2; }
};

Run joined(const Run& child, const Run& above) {
    Run both{child.first, child.width + above.width, child.width + above.height, 0};
    both.zeros = both.entries() - (child.entries() - child.zeros) - (above.entries() - above.zeros);
    return both;
}

/// Supernodes by their columns alone.
std::vector<Run> runs_of(const Numbers& parent, const Numbers& counts) {
    const int size = static_cast<int>(parent.size());
    std::vector<Run> runs;
    for (int j = 0; j < size; ++j) {
        if (j > 0 && parent[at(j - 1)] == j && counts[at(j - 1)] == counts[at(j)] + 1)
            ++runs.back().width;
        else
            runs.push_back({j, 1, counts[at(j)], 0});
    }
    std::vector<Run> kept;
    for (Run run : runs) {
        while (!kept.empty()) {
            const int up = parent[at(kept.back().first + kept.back().width - 1)];
            if (up < run.first || up >= run.first + run.width)
                break;
            const Run both = joined(kept.back(), run);
            if (both.width > narrow_width &&
                static_cast<double>(both.zeros) > zeros_allowed * static_cast<double>(both.entries()))
                break;
            run = both;
            kept.pop_back();
        }
        kept.push_back(run);
    }
    return kept;
}

/// Rows of each block: those of the matrix and those that children hand up.
void find_rows(Supernodes& factor, const Numbers& parent) {
    Numbers owner(at(static_cast<int>(factor.matrix.cols())));
    for (int s = 0; s < static_cast<int>(factor.nodes.size()); ++s) {
        const Supernode& node = factor.nodes[at(s)];
        std::fill_n(owner.begin() + node.first, node.width, s);
    }
    Numbers seen(owner.size(), -1);
    for (int s = 0; s < static_cast<int>(factor.nodes.size()); ++s) {
        Supernode& node = factor.nodes[at(s)];
        const int end = node.first + node.width;
        const auto take = [&](int row) {
            if (row >= end && seen[at(row)] != s) {
                seen[at(row)] = s;
                node.rows.push_back(row);
            }
        };
        for (int column = node.first; column < end; ++column)
            for (Sparse::InnerIterator entry(factor.matrix, column); entry; ++entry)
                take(static_cast<int>(entry.row()));
        for (const int child : node.children)
            for (const int row : factor.nodes[at(child)].rows)
                take(row);
        std::sort(node.rows.begin(), node.rows.end());
        Numbers columns(at(node.width));
        std::iota(columns.begin(), columns.end(), node.first);
        node.rows.insert(node.rows.begin(), columns.begin(), columns.end());
        if (const int up = parent[at(end - 1)]; up != -1) {
            node.parent = owner[at(up)];
            factor.nodes[at(node.parent)].children.push_back(s);
        }
    }
}

} // namespace

std::int64_t Supernodes::entries() const {
    std::int64_t sum = 0;
    for (const Supernode& node : nodes)
        sum += std::int64_t{node.width} * node.height() - std::int64_t{node.width} * (node.width - 1) / 2;
    return sum;
}

double Supernodes::operations() const {
    double sum = 0;
    for (const Supernode& node : nodes) // columns of h, h - 1, ... entries, the square of each
        for (int column = 0; column < node.width; ++column)
            sum += std::pow(node.height() - column, 2);
    return sum;
}

Supernodes supernodes_of(const Sparse& lower) {
    Order dissected;
    const Sparse whole = lower.selfadjointView<Eigen::Lower>();
    Dissection()(whole, dissected); // gives the way back
    Order order = dissected.inverse();
    order = postorder(elimination_tree(upper_in(lower, order))) * order;

    Supernodes factor;
    const Sparse upper = upper_in(lower, order);
    const Numbers parent = elimination_tree(upper);
    factor.order = order;
    factor.matrix = upper.transpose();
    for (const Run& run : runs_of(parent, column_counts(upper, parent)))
        factor.nodes.push_back({run.first, run.width, {}, {}, -1});
    find_rows(factor, parent);
    return factor;
}

} // namespace tumble::fem
