#include "about.h"
#include "fem/cauchy.h"
#include "half_space.h"
#include "solid/hertz_patch.h"

#include <doctest/doctest.h>

namespace test_structure {

using namespace tumble;
using namespace tumble::fem;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using tumble::test::about;
using tumble::test::Box;
using tumble::test::MeshPtr;
using tumble::test::solved;
using tumble::test::steel;

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array both{Formulation::standard, Formulation::incompatible};

/// Deflection of the free end (x = length) along z, and a box clamped at x = 0 under a force along z spread over the
/// end as the bricks' faces take it.
double deflection(const Box& box, const Elastic& material, Formulation formulation, double force) {
    const MeshPtr mesh = box.mesh();
    std::vector<Support> supports;
    MatrixXd loads = test::no_loads(*mesh);
    const double share = force / (box.bricks[1] * box.bricks[2] * 4);
    for (int k = 0; k <= box.bricks[2]; ++k)
        for (int j = 0; j <= box.bricks[1]; ++j) {
            test::hold(supports, box.node(0, j, k), Vector3d::Zero());
            const int faces = (j > 0 && j < box.bricks[1] ? 2 : 1) * (k > 0 && k < box.bricks[2] ? 2 : 1);
            loads(3 * box.node(box.bricks[0], j, k) + 2, 0) = share * faces;
        }
    const Solution solution = solved(mesh, material, formulation, supports, loads);
    return solution.displacement(3 * box.node(box.bricks[0], 0, 0) + 2, 0);
}

/// A block of n x n x n / 2 bricks, 20 mm wide, in the half space z >= 0, whose sides and bottom follow Boussinesq's
/// displacements for 100 N.
struct HalfSpace {
    static constexpr double side = 0.02, force = 100;
    Box box;
    MeshPtr mesh;
    Vector3d origin = Vector3d(side / 2, side / 2, 0);
    std::vector<Support> supports{};

    explicit HalfSpace(int n) : box{{side, side, side / 2}, {n, n, n / 2}}, mesh(box.mesh()) {
        for (int node = 0; node < static_cast<int>(mesh->nodes.size()); ++node) {
            const Vector3d at = mesh->nodes[static_cast<std::size_t>(node)] - origin;
            if (std::max(std::abs(at.x()), std::abs(at.y())) < 0.499 * side && at.z() < 0.499 * side)
                continue;
            test::hold(supports, node, test::boussinesq(at, force, steel));
        }
    }

    /// sigma_zz on the axis, so many bricks beneath the surface.
    [[nodiscard]] double beneath(const Solution& solution, int bricks) const {
        return test::stress_at(solution, box.node(box.bricks[0] / 2, box.bricks[1] / 2, bricks))[2];
    }
};

/// The force as Hertz' pressure on a circle, solved.
Solution under_patch(const HalfSpace& space, double radius) {
    const auto push =
        solid::moved_to(*space.mesh, {0, space.origin, {0, 0, HalfSpace::force}}, -Vector3d::UnitZ()).value();
    const auto points = solid::PatchSpreader(*space.mesh).spread(push, -Vector3d::UnitZ(), radius);
    const Eigen::Matrix3Xd forces = solid::nodal_loads(*space.mesh, points).value();
    return solved(space.mesh, steel, Formulation::incompatible, space.supports, forces.reshaped(), 2);
}

} // namespace

TEST_CASE("patch test: on a distorted mesh a linear displacement of the surface is followed exactly inside") {
    const Box box{{0.03, 0.03, 0.03}, {3, 3, 3}};
    const MeshPtr mesh = box.mesh(0.25);
    Eigen::Matrix3d gradient;
    gradient << 1e-3, 2e-4, -3e-4, 4e-4, -2e-3, 5e-4, 1e-4, -6e-4, 7e-4;
    std::vector<Support> supports;
    for (const int node : box.surface())
        test::hold(supports, node, gradient * mesh->nodes[static_cast<std::size_t>(node)]);
    Stress strain;
    strain << gradient(0, 0), gradient(1, 1), gradient(2, 2), gradient(0, 1) + gradient(1, 0),
        gradient(1, 2) + gradient(2, 1), gradient(2, 0) + gradient(0, 2);
    const Stress expected = hooke(steel) * strain;
    for (const Formulation formulation : both) {
        const Solution solution = solved(mesh, steel, formulation, supports, test::no_loads(*mesh));
        for (int node = 0; node < 64; ++node) {
            const Vector3d moved = solution.displacement.col(0).segment<3>(3 * node);
            CHECK((moved - gradient * mesh->nodes[static_cast<std::size_t>(node)]).norm() < 1e-16);
            CHECK((test::stress_at(solution, node) - expected).norm() < 1e-10 * expected.norm());
        }
    }
}

TEST_CASE("a rigid motion of the supports moves the part and stresses nothing") {
    const Box box{{0.03, 0.02, 0.01}, {3, 3, 3}};
    const MeshPtr mesh = box.mesh(0.2);
    std::vector<Support> supports;
    const auto motion = [](const Vector3d& x) {
        return Vector3d(Vector3d(1e-3, 2e-3, 0) + Vector3d(0, 0.01, 0.02).cross(x));
    };
    for (int j = 0; j <= 3; ++j)
        for (int k = 0; k <= 3; ++k)
            test::hold(supports, box.node(0, j, k), motion(mesh->nodes[static_cast<std::size_t>(box.node(0, j, k))]));
    for (const Formulation formulation : both) {
        const Solution solution = solved(mesh, steel, formulation, supports, test::no_loads(*mesh));
        // A strain of the motion's own size, 0.02, would stress it by 4e9 Pa.
        CHECK(solution.stress.cwiseAbs().maxCoeff() < 1e-10 * 4e9);
        CHECK((solution.displacement.col(0).tail<3>() - motion(mesh->nodes.back())).norm() < 1e-13);
    }
}

TEST_CASE("a cantilever bends as Timoshenko's beam does, with incompatible bricks") {
    // Force P at the end of a beam of length L, height h, width w: P L^3 / (3 E I) + P L / (5/6 G A), the second term
    // for shear (rectangle: 5/6 of the area). Without lateral strain (nu = 0) the clamped end is the beam's.
    const double length = 0.1, height = 0.01, width = 0.006, force = 2, modulus = 2e11;
    const double area = height * width, inertia = area * height * height / 12;
    const double theory =
        force * length * length * length / (3 * modulus * inertia) + force * length / (5.0 / 6 * modulus / 2 * area);
    const Box box{{length, width, height}, {10, 1, 2}};
    CHECK(deflection(box, {modulus, 0}, Formulation::incompatible, force) == about(theory, 0.005));
    // The standard brick is stiffer by about 1 + (a/b)^2 / 2 = 3 per brick of length a and height b (test_brick.cpp),
    // less as several share the height: n of them bend each by 1/n^2 of the whole and leave 1 + (a/h)^2 / 2.
    const double stiffer = theory / deflection(box, {modulus, 0}, Formulation::standard, force);
    CHECK(stiffer == about(1 + 0.5 * (0.01 / 0.01) * (0.01 / 0.01), 0.02));
}

TEST_CASE("a thick tube under pressure widens as Lame says, and the error falls with the square of the brick") {
    // Plane strain: u(r) = (1 + nu) / E p a^2 / (b^2 - a^2) ((1 - 2 nu) r + b^2 / r), sigma_theta at the bore
    // p (a^2 + b^2) / (b^2 - a^2).
    const double a = 0.005, b = 0.015, pressure = 1e6;
    const double widening = 1.3 / 2e11 * pressure * a * a / (b * b - a * a) * (0.4 * a + b * b / a);
    for (const Formulation formulation : both) {
        std::vector<double> errors, hoops;
        for (const int refined : {1, 2, 4}) {
            const solid::BoredCylinder tube{.length = 0.004,
                                            .radius = b,
                                            .bore_radius = a,
                                            .shell = 0.005,
                                            .around = 16 * refined,
                                            .along = 1,
                                            .shell_rings = 2 * refined,
                                            .inner_rings = 2 * refined};
            const auto mesh = std::make_shared<const solid::HexMesh>(solid::mesh_of(tube, {}).value());
            MatrixXd loads = test::no_loads(*mesh);
            for (const int facet : mesh->facet_sets.at("bore"))
                for (const int node : mesh->facets[static_cast<std::size_t>(facet)].corners)
                    loads.col(0).segment<3>(3 * node) -= pressure / 4 * mesh->area_of(facet);
            std::vector<Support> supports;
            for (int node = 0; node < static_cast<int>(mesh->nodes.size()); ++node) {
                const Vector3d& at = mesh->nodes[static_cast<std::size_t>(node)];
                supports.push_back({node, 1, 0});
                if (std::abs(at.x()) < 1e-9) // by symmetry nothing there goes sideways
                    supports.push_back({node, 0, 0});
                if (std::abs(at.z()) < 1e-9)
                    supports.push_back({node, 2, 0});
            }
            const Solution solution = solved(mesh, steel, formulation, supports, loads);
            // Node 0 stands at the bore, at angle 0: its way along z is the widening, its hoop direction x.
            errors.push_back(std::abs(solution.displacement(2, 0) / widening - 1));
            hoops.push_back(
                std::abs(test::stress_at(solution, 0)[0] / (pressure * (a * a + b * b) / (b * b - a * a)) - 1));
        }
        CHECK(errors[2] < 0.004);
        CHECK(std::log2(errors[0] / errors[1]) == about(2, 0.1));
        CHECK(std::log2(errors[1] / errors[2]) == about(2, 0.1));
        CHECK(hoops[2] < 0.08);
        // Stresses extrapolated to a surface: first order at least. The incompatible brick's, off by 3.6 and 3.2 %, are
        // not yet in their order.
        CHECK(hoops[2] < (formulation == Formulation::standard ? 0.7 : 1) * hoops[1]);
    }
}

TEST_CASE("beneath a point load the stress falls off as Boussinesq says") {
    // sigma_zz = -3 P z^3 / (2 pi R^5).
    const HalfSpace space(16);
    MatrixXd loads = test::no_loads(*space.mesh);
    loads(3 * space.box.node(8, 8, 0) + 2, 0) = HalfSpace::force;
    for (const Formulation formulation : both) {
        const Solution solution = solved(space.mesh, steel, formulation, space.supports, loads);
        for (const int k : {5, 6}) { // bricks beneath it
            const double z = k * HalfSpace::side / 16;
            const double theory = -3 * HalfSpace::force / (2 * pi * z * z);
            CHECK(space.beneath(solution, k) == about(theory, 0.06));
        }
    }
}

TEST_CASE("beneath Hertz' pressure the stress is Hertz', whatever the mesh, where that of a point is the mesh's") {
    // On the axis sigma_zz = -3 F / (2 pi a^2) / (1 + z^2 / a^2) (Johnson, 3.4). At four radii, where the block ends,
    // the patch's displacements differ from the point's by 0.3 (a / R)^2, 2 %.
    const double a = 0.0025, peak = 3 * HalfSpace::force / (2 * pi * a * a);
    const HalfSpace coarse(16), fine(24);
    const Solution on_coarse = under_patch(coarse, a), on_fine = under_patch(fine, a);
    const auto off = [&](const HalfSpace& space, const Solution& solution, double z) {
        const int deep = static_cast<int>(std::lround(z / HalfSpace::side * space.box.bricks[0]));
        return std::abs(space.beneath(solution, deep) * (1 + z * z / (a * a)) / -peak - 1);
    };
    // Bricks are a half and a third of the patch's radius. Where the stress is smooth its error falls with the square
    // of the brick at least, so that 0.08 at a half leaves 0.08 / 2.25 at a third.
    const double off_coarse = off(coarse, on_coarse, a), off_fine = off(fine, on_fine, a);
    CHECK(off_fine < 0.08 / 2.25);
    CHECK(off_coarse / off_fine > 2.25);
    CHECK(off_coarse / off_fine < 1.5 * 2.25); // no more than a third order's
    CHECK(off(coarse, on_coarse, 2 * a) < 0.01);
    CHECK(off(fine, on_fine, 2 * a) < 0.01);
    const double point_coarse = coarse.beneath(under_patch(coarse, 0), 0), // at the surface itself
        point_fine = fine.beneath(under_patch(fine, 0), 0);
    CHECK(point_fine / point_coarse > 1.8); // (24 / 16)^2 = 2.25 and less: without end
}

TEST_CASE("every load case is in equilibrium, and its residual is rounding") {
    const Box box{{0.03, 0.02, 0.02}, {4, 3, 3}};
    const MeshPtr mesh = box.mesh(0.2);
    std::vector<Support> supports;
    for (int j = 0; j <= 3; ++j)
        for (int k = 0; k <= 3; ++k)
            test::hold(supports, box.node(0, j, k), Vector3d::Zero());
    Rng rng(9);
    MatrixXd loads = test::no_loads(*mesh, 19);
    for (Eigen::Index c = 0; c < 19; ++c)
        for (Eigen::Index row = 0; row < loads.rows(); ++row)
            loads(row, c) = rng.uniform(-1, 1);
    const Solution solution = solved(mesh, steel, Formulation::incompatible, supports, loads);
    for (Eigen::Index c = 0; c < 19; ++c) {
        CHECK(solution.residual[c] < 1e-10);
        CHECK(solution.unbalance[c] < 1e-11);
        Vector3d sum = solution.support_force.col(c);
        for (Eigen::Index node = 0; node < loads.rows() / 3; ++node)
            sum += loads.col(c).segment<3>(3 * node);
        CHECK(sum.norm() < 1e-10);
    }
    SUBCASE("one thread and two give the same bits, and so does each case alone") {
        const Solution again = solved(mesh, steel, Formulation::incompatible, supports, loads, 2);
        CHECK(again.displacement == solution.displacement);
        CHECK(again.stress == solution.stress);
        const Solution many = solved(mesh, steel, Formulation::incompatible, supports, loads.replicate(1, 8), 2);
        for (Eigen::Index c = 0; c < 19 * 8; ++c) // past the 128 of one walk over the elements
            CHECK((many.stress.col(c) - solution.stress.col(c % 19)).norm() <=
                  1e-13 * solution.stress.col(c % 19).norm());
        const Solution alone = solved(mesh, steel, Formulation::incompatible, supports, loads.col(11));
        CHECK(alone.displacement.col(0) == solution.displacement.col(11));
    }
}

TEST_CASE("what cannot be solved is refused: loose parts, wrong sets, contradictions, odd solids") {
    const MeshPtr mesh = Box{}.mesh();
    Crew crew(1);
    const auto refused = [&](const Elastic& material, const std::vector<Support>& supports) {
        const auto part = Structure::make(mesh, material, Formulation::standard, supports, crew);
        return part ? "nothing" : part.problems()[0].what;
    };
    CHECK(refused(steel, {}) == "the part's supports leave it free to move");
    CHECK(refused(steel, {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}) == "the part's supports leave it free to move");
    CHECK(refused(steel, {{0, 0, 0}, {0, 0, 1e-3}}) == "node 1 is held at 0 m and at 0.001 m along x");
    CHECK(refused(steel, {{8, 0, 0}}) == "a support names node 8 of 8 and axis 0");
    std::vector<Support> everywhere;
    for (int node = 0; node < 8; ++node)
        test::hold(everywhere, node, Vector3d::Zero());
    CHECK(refused(steel, everywhere) == "every node is held");
    CHECK(refused({-1, 0.3}, {}) == "a modulus of -1 Pa is no solid's");
    CHECK(refused({2e11, 0.5}, {}) == "a Poisson ratio of 0.5 is no elastic solid's");
    CHECK(encastre(*mesh, "top").problems().at(0).what == "the mesh has no node set 'top'");
}

TEST_CASE("a part on a hinge, or with a loose body beside it, is refused before or after it is solved, at any size") {
    Crew crew(2);
    const auto refused = [&](const MeshPtr& mesh, const std::vector<Support>& supports) {
        const auto part = Structure::make(mesh, steel, Formulation::incompatible, supports, crew);
        MatrixXd loads = test::no_loads(*mesh);
        loads(loads.rows() - 3, 0) = 1; // x of the last node, about a hinge along z
        return !part || part->distrust(part->solve(loads, crew)).has_value();
    };
    for (const int n : {1, 3, 8}) {
        CAPTURE(n);
        const Box box{{0.03, 0.03, 0.03}, {n, n, n}};
        std::vector<Support> supports;
        test::hold(supports, box.node(0, 0, 0), Vector3d::Zero());
        test::hold(supports, box.node(0, 0, n), Vector3d::Zero());
        CHECK(refused(box.mesh(0.2), supports));
        test::hold(supports, box.node(n, 0, 0), Vector3d::Zero());
        CHECK_FALSE(refused(box.mesh(0.2), supports));

        solid::HexMesh two = *box.mesh(); // such a mesh does not pass solid::finished() either
        const auto count = static_cast<int>(two.nodes.size());
        for (int node = 0; node < count; ++node) {
            two.nodes.emplace_back(two.nodes[static_cast<std::size_t>(node)] + Vector3d(0.1, 0, 0));
            two.node_numbers.push_back(count + node + 1);
        }
        for (std::size_t hex = 0, hexes = two.hexes.size(); hex < hexes; ++hex) {
            auto moved = two.hexes[hex];
            for (int& node : moved)
                node += count;
            two.hexes.push_back(moved);
            two.hex_numbers.push_back(static_cast<int>(hexes + hex + 1));
        }
        CHECK(refused(std::make_shared<const solid::HexMesh>(std::move(two)), supports));
    }
}

TEST_CASE("a solution that leaves forces over is refused with the numbers") {
    const Box box;
    const MeshPtr mesh = box.mesh();
    std::vector<Support> supports;
    for (int node = 0; node < 4; ++node)
        test::hold(supports, node, Vector3d::Zero());
    Crew crew(1);
    const auto part = Structure::make(mesh, steel, Formulation::standard, supports, crew);
    REQUIRE(part);
    MatrixXd loads = test::no_loads(*mesh);
    loads(14, 0) = 1;
    Solution solution = part->solve(loads, crew);
    CHECK_FALSE(part->distrust(solution));
    solution.residual[0] = 2e-3;
    CHECK(part->distrust(solution).value().what.starts_with(
        "the solution cannot be trusted: 0.002 of the largest force is left over at a free node, loads and supports"));
    solution.residual[0] = std::numeric_limits<double>::quiet_NaN();
    CHECK(part->distrust(solution));
}

TEST_CASE("the stress vector on a plane has Cauchy's components") {
    // Uniaxial stress S along x on a plane whose normal leans by the angle c: S cos^2 c across, S sin c cos c along it.
    const double lean = 0.4;
    Stress stress = Stress::Zero();
    stress[0] = -3e5;
    const Directions at = directions_of(Vector3d(std::cos(lean), 0, std::sin(lean)), Vector3d::UnitY());
    CHECK((at.contour - Vector3d(std::sin(lean), 0, -std::cos(lean))).norm() < 1e-15);
    CHECK((at.along - Vector3d::UnitY()).norm() < 1e-15);
    const Vector3d parts = components(stress, at);
    CHECK(parts[0] == about(-3e5 * std::cos(lean) * std::cos(lean), 1e-12));
    CHECK(parts[1] == about(-3e5 * std::cos(lean) * std::sin(lean), 1e-12));
    CHECK(std::abs(parts[2]) < 1e-9);
    CHECK(von_mises(stress) == about(3e5, 1e-12));
}

} // namespace test_structure
