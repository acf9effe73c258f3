#include "about.h"
#include "discs/body_shape.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_body_shape {

using namespace tumble;
using namespace tumble::discs;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;
const contact::Material stone{"stone", 2000, 0, 0};

BodyShape shape_of(const std::vector<scene::Sphere>& discs, double depth = 0.5) {
    scene::BodyTemplate body;
    body.name = "clump";
    body.spheres = discs;
    const auto shape = make_body_shape(body, stone, depth);
    REQUIRE_MESSAGE(shape.ok(), to_string(shape.problems()));
    return *shape;
}

} // namespace

TEST_CASE("a disc weighs density times area times depth and turns with half m r^2") {
    const BodyShape disc = shape_of({{{0.3, -0.2, 0}, 0.1}});
    CHECK(disc.mass == about(2000 * pi * 0.01 * 0.5, 1e-14));
    CHECK(disc.inertia == about(0.5 * disc.mass * 0.01, 1e-14));
    CHECK(disc.written_centre.x() == 0.3);
}

TEST_CASE("discs that do not overlap add up by Steiner's rule") {
    const BodyShape pair = shape_of({{{0, 0, 0}, 0.1}, {{0.4, 0.3, 0}, 0.2}});
    const double one = 2000 * pi * 0.01 * 0.5, other = 4 * one;
    const double apart = 0.5, reduced = one * other / (one + other);
    CHECK(pair.mass == about(one + other, 1e-12));
    CHECK(pair.written_centre.x() == about(0.4 * 0.8, 1e-12));
    CHECK(pair.inertia == about(0.5 * one * 0.01 + 0.5 * other * 0.04 + reduced * apart * apart, 1e-12));
}

TEST_CASE("two equal discs that overlap: their lens is counted once, in area and in inertia") {
    const double r = 0.1, apart = 0.12;
    const BodyShape pair = shape_of({{{5, 7, 0}, r}, {{5 + apart, 7, 0}, r}});
    // The union is twice the part of a disc on its side of the chord at h from its centre, which is the disc less a
    // segment: area r^2 (a - sin a cos a) with cos a = h / r.
    const double h = apart / 2, a = std::acos(h / r), s = std::sin(a);
    const double area = 2 * (pi * r * r - r * r * (a - s * h / r));
    CHECK(pair.area == about(area, 1e-12));
    CHECK(pair.written_centre.x() == about(5 + h, 1e-12));
    // The segment's moments about the disc's centre: polar by thin strips, first moment 2/3 (r sin a)^3.
    double polar = 0;
    const int strips = 200000;
    for (int k = 0; k < strips; ++k) {
        const double x = h + (r - h) * (k + 0.5) / strips, half = std::sqrt(r * r - x * x);
        polar += (2 * half * x * x + 2.0 / 3 * half * half * half) * (r - h) / strips;
    }
    const double first = 2.0 / 3 * std::pow(r * s, 3);
    const double part_polar = pi * std::pow(r, 4) / 2 - polar;
    // Shift from the disc's centre to the middle: x' = x - h, with the first moment of the part -first.
    const double about_middle = 2 * (part_polar + 2 * h * first + h * h * area / 2);
    CHECK(pair.inertia == about(2000 * 0.5 * about_middle, 1e-6));
}

TEST_CASE("discs inside others change nothing, and only those that show can touch") {
    const BodyShape plain = shape_of({{{0, 0, 0}, 0.1}, {{0.1, 0, 0}, 0.1}});
    const BodyShape more = shape_of({{{0, 0, 0}, 0.1}, {{0.05, 0, 0}, 0.02}, {{0.1, 0, 0}, 0.1}, {{0.1, 0, 0}, 0.1}});
    CHECK(more.mass == about(plain.mass, 1e-12));
    CHECK(more.inertia == about(plain.inertia, 1e-12));
    CHECK(contact_discs(more) == std::vector<int>{0, 2});
}

TEST_CASE("a ring of discs closed around a hole keeps the hole") {
    std::vector<scene::Sphere> ring;
    for (int k = 0; k < 12; ++k)
        ring.push_back({{std::cos(pi * k / 6), std::sin(pi * k / 6), 0}, 0.3});
    const BodyShape shape = shape_of(ring);
    // Twelve discs, each less the lens it shares with the next.
    const double h = std::sin(pi / 12), a = std::acos(h / 0.3);
    const double lens = 2 * 0.09 * (a - std::sin(a) * h / 0.3);
    CHECK(shape.area == about(12 * (pi * 0.09 - lens), 1e-12));
    CHECK(contact_discs(shape).size() == 12);
}

TEST_CASE("a given mass scales the inertia, a given inertia replaces it") {
    scene::BodyTemplate body;
    body.spheres = {{{0, 0, 0}, 0.1}};
    body.mass = 3;
    CHECK(make_body_shape(body, stone, 1)->inertia == about(0.5 * 3 * 0.01));
    body.principal_inertia = Eigen::Vector3d::Constant(0.7);
    CHECK(make_body_shape(body, stone, 1)->inertia == 0.7);
}

} // namespace test_body_shape
