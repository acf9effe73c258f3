#include "about.h"
#include "solver/books.h"

#include <doctest/doctest.h>

namespace test_books {

using namespace tumble;
using tumble::test::about;

TEST_CASE("powers are summed by the trapezoidal rule, exact differences as they are") {
    // A power of t^2 W taken at t = 0, h, 2h, ...: the rule's sum is t^3 / 3 + h^2 t / 6.
    const double h = 0.01;
    solver::Ledger ledger;
    Books books;
    for (int step = 1; step <= 101; ++step) {
        const double t = (step - 1) * h;
        solver::Sums sums;
        sums.contacts.lost_normal_damping = sums.contacts.wall_work = sums.lost_air_drag = t * t * h;
        sums.contacts.lost_sliding = 0.5;
        books = solver::book_step(ledger, sums, step, h, 3);
    }
    CHECK(books.time == about(1));
    CHECK(books.step == 100);
    CHECK(books.bodies == 3);
    for (const double sum : {books.lost_normal_damping, books.wall_work, books.lost_air_drag})
        CHECK(sum == about(1.0 / 3 + h * h / 6, 1e-12));
    CHECK(books.lost_sliding == about(101 * 0.5));
}

TEST_CASE("chunks add up to the whole, and the deepest and fastest of them count") {
    solver::Sums all;
    for (const double k : {1.0, 3.0, 2.0}) {
        solver::Sums one;
        one.contacts.stored_normal = one.motion.gravity = k;
        one.contacts.overlap_ratio_max = one.motion.speed_squared_max = k * k;
        one.contacts.contacts = 2;
        one.motion.finite = k < 3;
        all.add(one);
    }
    CHECK(!all.motion.finite);
    solver::Ledger ledger;
    const Books first = solver::book_step(ledger, all, 1, 1e-3, 1);
    CHECK(first.stored_normal == 6);
    CHECK(first.gravity == 6);
    CHECK(first.contacts == 6);
    CHECK(first.overlap_ratio_max == 9);
    CHECK(first.speed_max == 3);
    // Bodies put in overlapping bring their contacts' energy; they did not fall for it.
    CHECK(first.inserted == 6);
    CHECK(solver::book_step(ledger, {}, 2, 1e-3, 1).overlap_ratio_peak == 9);
}

} // namespace test_books
