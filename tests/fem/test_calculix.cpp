#include "base/child_process.h"
#include "base/text.h"
#include "bricks.h"
#include "folder.h"
#include "solid/inp.h"

#include <chrono>
#include <doctest/doctest.h>

/// The same model, written for CalculiX and solved by it. Skipped where `ccx` is not installed.
namespace test_calculix {

using namespace tumble;
using namespace tumble::fem;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

const Elastic steel{2e11, 0.3};

/// What ccx printed, per step.
struct Printed {
    std::vector<MatrixXd> displacement; // m, 3 x nodes
    std::vector<MatrixXd> stress;       // Pa, 6 x (8 points an element), components and points in our order
};

/// ccx has x as the fastest of its integration points, and prints xx yy zz xy xz yz.
constexpr std::array<int, 8> our_point{0, 1, 3, 2, 4, 5, 7, 6};
constexpr std::array<int, 6> our_component{0, 1, 2, 3, 5, 4};

Printed parsed(const std::string& text, Eigen::Index nodes, Eigen::Index hexes) {
    Printed printed;
    bool stresses = false;
    for (const std::string_view line : split(text, '\n')) {
        const auto words = split_words(line);
        if (line.find("displacements") != std::string_view::npos) {
            stresses = false;
            printed.displacement.emplace_back(MatrixXd::Zero(3, nodes));
        } else if (line.find("stresses") != std::string_view::npos) {
            stresses = true;
            printed.stress.emplace_back(MatrixXd::Zero(6, 8 * hexes));
        } else if (!stresses && words.size() == 4) {
            for (int axis = 0; axis < 3; ++axis)
                printed.displacement.back()(axis, *parse_integer(words[0]) - 1) =
                    *parse_number(words[static_cast<std::size_t>(axis) + 1]);
        } else if (stresses && words.size() == 8) {
            const auto point = static_cast<std::size_t>(*parse_integer(words[1]) - 1);
            const Eigen::Index column = 8 * (*parse_integer(words[0]) - 1) + our_point[point];
            for (std::size_t c = 0; c < 6; ++c)
                printed.stress.back()(our_component[c], column) = *parse_number(words[c + 2]);
        }
    }
    return printed;
}

/// Largest difference over the largest value.
double apart(const MatrixXd& a, const MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// A box under a few forces, solved by both; false where there is no ccx. `distort`: of a brick.
bool agree(const std::string& element, Formulation formulation, double distort) {
    const test::Folder folder;
    const test::Box box{{0.04, 0.02, 0.03}, {4, 2, 3}};
    auto named = *box.mesh(distort);
    std::vector<Support> supports;
    for (int j = 0; j <= 2; ++j)
        for (int k = 0; k <= 3; ++k) {
            named.node_sets["held"].push_back(box.node(0, j, k));
            test::hold(supports, box.node(0, j, k), Vector3d::Zero());
        }
    const auto mesh = std::make_shared<const solid::HexMesh>(named);
    const auto nodes = static_cast<Eigen::Index>(mesh->nodes.size());
    const auto hexes = static_cast<Eigen::Index>(mesh->hexes.size());
    constexpr int cases = 3;
    Rng rng(21);
    MatrixXd loads = test::no_loads(*mesh, cases);
    std::vector<solid::InpStep> steps;
    for (int c = 0; c < cases; ++c) {
        for (int k = 0; k < 5; ++k)
            loads(static_cast<Eigen::Index>(rng.uniform() * static_cast<double>(3 * nodes)), c) =
                rng.uniform(-100, 100);
        steps.push_back({"case " + std::to_string(c), loads.col(c).reshaped(3, nodes)});
    }
    const auto model = folder.path / "model";
    const solid::InpModel solid{steel.youngs_modulus, steel.poisson_ratio, element, {"held"}, true};
    test::put(model.string() + ".inp", solid::to_inp(*mesh, solid, steps));
    // In that folder, where it leaves files of its own; env says 127 where there is no such program.
    ChildProcess ccx({"env", "-C", folder.path.string(), "ccx", "-i", "model"});
    REQUIRE(ccx.error() == 0);
    const int status = ccx.wait(std::chrono::seconds(60));
    if (status == 127)
        return false;
    REQUIRE_MESSAGE(status == 0, ccx.printed());
    const Printed printed = parsed(test::content_of(model.string() + ".dat"), nodes, hexes);
    REQUIRE(printed.displacement.size() == cases);
    REQUIRE(printed.stress.size() == cases);

    Crew crew(1);
    const auto part = Structure::make(mesh, steel, formulation, supports, crew);
    REQUIRE(part);
    const Solution solution = part->solve(loads, crew);
    for (int c = 0; c < cases; ++c) {
        const Eigen::VectorXd moved = solution.displacement.col(c);
        MatrixXd stress(6, 8 * hexes);
        for (int hex = 0; hex < hexes; ++hex)
            stress.middleCols<8>(8 * hex) = part->point_stress(hex, moved);
        // ccx prints seven digits.
        CHECK(apart(moved.reshaped(3, nodes), printed.displacement[static_cast<std::size_t>(c)]) < 1e-6);
        CHECK(apart(stress, printed.stress[static_cast<std::size_t>(c)]) < 1e-6);
    }
    return true;
}

} // namespace

TEST_CASE("CalculiX finds the same displacements and stresses of a distorted mesh of C3D8") {
    if (!agree("C3D8", Formulation::standard, 0.2))
        MESSAGE("skipped: ccx is not installed (Debian: calculix-ccx)");
}

TEST_CASE("and of bricks with parallel sides for C3D8I") {
    // Of others it finds something else: its C3D8I takes the Jacobian of the centre without the ratio of volumes that
    // Taylor, Beresford and Wilson need for the patch test (docs/stress.md).
    if (!agree("C3D8I", Formulation::incompatible, 0))
        MESSAGE("skipped: ccx is not installed (Debian: calculix-ccx)");
}

} // namespace test_calculix
