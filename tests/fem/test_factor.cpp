#include "about.h"
#include "base/rng.h"
#include "fem/factor.h"

#include <doctest/doctest.h>

namespace test_factor {

using namespace tumble;
using namespace tumble::fem;
using Eigen::Index;
using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;
using tumble::test::about;

namespace {

/// Springs between the neighbours of a box of n x n x n points, of different stiffness, each point with `freedoms`
/// unknowns that pull at each other, and to the ground with `ground`.
Sparse springs(int n, int freedoms, double ground) {
    Rng rng(3);
    std::vector<Eigen::Triplet<double>> triplets;
    const auto spring = [&](int a, int b, double stiffness) {
        triplets.emplace_back(a, a, stiffness);
        triplets.emplace_back(b, b, stiffness);
        triplets.emplace_back(std::max(a, b), std::min(a, b), -stiffness);
    };
    const auto unknown = [&](int i, int j, int k, int f) { return ((k * n + j) * n + i) * freedoms + f; };
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (int f = 0; f < freedoms; ++f) {
                    const int here = unknown(i, j, k, f);
                    triplets.emplace_back(here, here, ground);
                    for (int g = 0; g < freedoms; ++g) {
                        if (i + 1 < n)
                            spring(here, unknown(i + 1, j, k, g), rng.uniform(0.5, 2));
                        if (j + 1 < n)
                            spring(here, unknown(i, j + 1, k, g), rng.uniform(0.5, 2));
                        if (k + 1 < n)
                            spring(here, unknown(i, j, k + 1, g), rng.uniform(0.5, 2));
                    }
                }
    Sparse lower(n * n * n * freedoms, n * n * n * freedoms);
    lower.setFromTriplets(triplets.begin(), triplets.end());
    return lower;
}

MatrixXd random(Index rows, Index columns) {
    Rng rng(5);
    MatrixXd values(rows, columns);
    for (Index c = 0; c < columns; ++c)
        for (Index r = 0; r < rows; ++r)
            values(r, c) = rng.uniform(-1, 1);
    return values;
}

MatrixXd solved(const Sparse& lower, MatrixXd sides, int threads) {
    Crew crew(threads);
    const auto factor = Factor::of(lower, crew);
    REQUIRE(factor);
    factor->solve(sides, crew);
    return sides;
}

} // namespace

TEST_CASE("what was multiplied by a matrix is found again, for one right side and for more than go side by side") {
    const Sparse lower = springs(9, 3, 0.1); // 2187 unknowns: blocks above a panel's and a strip's width
    for (const int sides : {1, 32, 41}) {
        CAPTURE(sides);
        const MatrixXd meant = random(lower.cols(), sides);
        const MatrixXd found = solved(lower, lower.selfadjointView<Eigen::Lower>() * meant, 1);
        CHECK((found - meant).cwiseAbs().maxCoeff() < 1e-11);
    }
}

TEST_CASE("threads change no bit of a factor or a solution") {
    const Sparse lower = springs(9, 3, 0.1);
    const MatrixXd sides = random(lower.cols(), 70);
    const MatrixXd one = solved(lower, sides, 1), two = solved(lower, sides, 2);
    CHECK((one.array() == two.array()).all());
}

TEST_CASE("a full matrix has n (n + 1) / 2 entries and takes a pyramid of squares; one apart from all has its own") {
    constexpr int n = 40;
    Sparse lower(n + 1, n + 1);
    for (int j = 0; j < n; ++j)
        for (int i = j; i < n; ++i)
            lower.insert(i, j) = i == j ? n : 1.0 / (1 + i - j);
    lower.insert(n, n) = 4;
    Crew crew(1);
    const auto factor = Factor::of(lower, crew);
    REQUIRE(factor);
    CHECK(factor->entries() == n * (n + 1) / 2 + 1);
    CHECK(factor->operations() == about(n * (n + 1.0) * (2 * n + 1) / 6 + 1, 1e-14));
    MatrixXd side = MatrixXd::Zero(n + 1, 1);
    side(n, 0) = 2;
    factor->solve(side, crew);
    CHECK(side(n, 0) == about(0.5, 1e-15));
    CHECK(side.topRows(n).isZero(0));
}

TEST_CASE("nested dissection halves the factor of a cube of points at least") {
    // A. George 1973: of n^3 points a factor of order n^4 entries; plane by plane it would be a band of n^5.
    const Sparse lower = springs(16, 1, 0.1);
    Crew crew(1);
    const auto factor = Factor::of(lower, crew);
    REQUIRE(factor);
    const double band = std::pow(16.0, 5);
    CHECK(static_cast<double>(factor->entries()) < 0.5 * band);
}

TEST_CASE("a matrix that is not positive definite is refused, one of rounding size too") {
    Crew crew(1);
    Sparse turned = springs(4, 1, 0.1);
    turned.coeffRef(20, 20) = -1;
    CHECK(!Factor::of(turned, crew));
    CHECK(!Factor::of(springs(4, 1, 0), crew)); // springs without ground: all may move alike
    CHECK(Factor::of(springs(4, 1, 1e-6), crew));
}

TEST_CASE("one block that is not positive definite is refused, however many others are found good beside it") {
    // Blocks without a spring between them are subtrees of their own; two threads take them at once.
    constexpr int blocks = 64, size = 3;
    Sparse lower(blocks * size, blocks * size);
    for (int column = 0; column < blocks * size; ++column)
        for (int row = column; row < (column / size + 1) * size; ++row)
            lower.insert(row, column) = row == column ? 3 : -1;
    Crew crew(2);
    CHECK(Factor::of(lower, crew));
    int passed = 0;
    for (int turn = 0; turn < 500; ++turn) {
        const int bad = turn % blocks * size;
        lower.coeffRef(bad, bad) = -1;
        passed += Factor::of(lower, crew) ? 1 : 0;
        lower.coeffRef(bad, bad) = 3;
    }
    CHECK(passed == 0);
}

} // namespace test_factor
