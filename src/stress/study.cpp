#include "stress/study.h"

#include "fem/first_wall.h"
#include "fem/structure.h"
#include "scene/specimen.h"
#include "solid/hertz_patch.h"
#include "solid/locate.h"
#include "stress/doubts.h"
#include "stress/edges.h"
#include "stress/facet_loads.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace tumble::stress {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr std::size_t cases_at_once = 128; // bounds memory, whatever the run's length
// From this share of the smallest sphere on the part gives way as a contact does; the media did not see it move.
constexpr double visible_deflection = 0.01;
constexpr double untold = std::numeric_limits<double>::quiet_NaN();

double seconds_since(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

double smallest_radius(const scene::Scene& scene) {
    double radius = std::numeric_limits<double>::infinity();
    for (const scene::Fill& fill : scene.fills)
        for (const scene::Sphere& sphere : scene.bodies[static_cast<std::size_t>(fill.body)].spheres)
            radius = std::min(radius, sphere.radius);
    return radius;
}

std::vector<std::string> outward_sides(const scene::SpecimenShape& specimen) {
    if (std::holds_alternative<solid::Prism>(specimen.part))
        return {"-x", "+x", "-z", "+z"};
    return {"side"};
}

/// What is solved as one case; `window`: as Case.
struct CaseLoad {
    double time = 0, window = 0; // s
    const std::vector<observe::WallPush>& pushes;
};
std::vector<CaseLoad> case_loads(const run::PartLoads& loads, bool means) {
    std::vector<CaseLoad> cases;
    if (means)
        for (const run::MeanLoad& mean : loads.means)
            cases.push_back({mean.time, mean.window, mean.pushes});
    else
        for (const run::LoadInstant& instant : loads.instants)
            cases.push_back({instant.time, 0, instant.pushes});
    return cases;
}

/// Patches, facets beneath them and sides that they are on, weighed with the contacts' forces.
void measure_patches(const std::vector<CaseLoad>& cases, const FacetFinder& finder, double times, Study& study) {
    const solid::HexMesh& mesh = finder.mesh();
    std::vector<double*> side_of(mesh.facets.size()); // its share
    for (const auto& [side, facets] : mesh.facet_sets)
        for (const int facet : facets)
            side_of[static_cast<std::size_t>(facet)] = &study.pressed[side];
    double weight = 0;
    for (const CaseLoad& load : cases)
        for (const observe::WallPush& push : load.pushes) {
            const int facet = finder.facet_of(push);
            const double force = push.force.norm();
            weight += force;
            study.patch += force * times * push.patch;
            study.facet += force * std::sqrt(mesh.area_of(facet).norm());
            if (double* share = side_of[static_cast<std::size_t>(facet)])
                *share += force;
        }
    if (!(weight > 0))
        return;
    study.patch /= weight;
    study.facet /= weight;
    for (auto& [side, share] : study.pressed)
        share /= weight;
}

/// What an instant's contacts say of a case by themselves. `surface`: m2, of the part.
void look_at(const run::LoadInstant& instant, const FacetFinder& finder, double surface, Case& now) {
    const solid::HexMesh& mesh = finder.mesh();
    now.contacts = static_cast<int>(instant.pushes.size());
    for (const observe::WallPush& push : instant.pushes) {
        const solid::Facet& facet = mesh.facets[static_cast<std::size_t>(finder.facet_of(push))];
        const Strongest here{push.body,       mesh.hex_numbers[static_cast<std::size_t>(facet.hex)],
                             facet.face + 1,  push.foot,
                             push.pressing(), push.shearing().norm()};
        if (!now.strongest ||
            std::hypot(here.normal, here.shear) > std::hypot(now.strongest->normal, now.strongest->shear))
            now.strongest = here;
    }
    for (const auto& [facet, sum] : facet_loads(instant.pushes, finder)) {
        const double area = mesh.area_of(facet).norm();
        now.facet_normal = std::max(now.facet_normal, sum.pressing / area);
        now.facet_shear = std::max(now.facet_shear, sum.shearing.norm() / area);
        now.surface_normal += sum.pressing / surface;
        now.surface_shear += sum.shearing.norm() / surface;
    }
}

void find_worst_node(const solid::HexMesh& mesh, Study& study) {
    std::size_t worst = 0;
    double most = -1; // Pa
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
        const double here = fem::von_mises(study.worst.stress.segment<6>(6 * static_cast<Index>(node)));
        if (here > most) {
            most = here;
            worst = node;
        }
    }
    study.worst_node = mesh.node_numbers[worst];
    study.worst_place = mesh.nodes[worst];
}

/// What is said of edges, once the worst node is known.
void measure_edges(const solid::HexMesh& mesh, Study& study) {
    study.worst_edge = Edges(mesh).distance(study.worst_place);
    for (const Case& now : study.cases)
        if (now.away_node >= 0 && (!study.away || now.away > study.away->von_mises)) {
            const auto node = static_cast<std::size_t>(now.away_node);
            study.away = {now.away, now.time, mesh.node_numbers[node], mesh.nodes[node]};
        }
}

class Solver {
public:
    Solver(const scene::SpecimenShape& specimen, const StudyOptions& options, Crew& crew)
        : mesh_(specimen.mesh), crew_(crew), options_(options) {}

    std::optional<Problems> prepare(const scene::SpecimenShape& specimen, Study& study) {
        auto slices = slices_of(specimen, options_);
        if (!slices)
            return slices.problems();
        study.slices = std::move(*slices);
        const Edges edges(*mesh_);
        for (const Vector3d& node : mesh_->nodes)
            away_.push_back(edges.distance(node) > options_.counting.edge);
        std::vector<fem::Support> supports;
        for (const std::string& set : scene::held_sets(specimen)) {
            auto held = fem::encastre(*mesh_, set);
            if (!held)
                return held.problems();
            supports.insert(supports.end(), held->begin(), held->end());
        }
        auto part = fem::Structure::make(mesh_, {specimen.youngs_modulus, specimen.poisson_ratio}, options_.formulation,
                                         supports, crew_);
        if (!part)
            return part.problems();
        part_ = std::make_unique<fem::Structure>(std::move(*part));
        study.nodes = mesh_->nodes.size();
        study.hexes = mesh_->hexes.size();
        study.unknowns = 3 * study.nodes - supports.size();
        study.factor_entries = part_->factor().entries();
        study.factor_operations = part_->factor().operations();
        return std::nullopt;
    }

    std::optional<Problem> solve(const std::vector<Eigen::Matrix3Xd>& forces, Study& study) {
        for (std::size_t first = 0; first < forces.size(); first += cases_at_once) {
            const std::size_t count = std::min(cases_at_once, forces.size() - first);
            MatrixXd loads(3 * static_cast<Index>(study.nodes), static_cast<Index>(count));
            for (std::size_t c = 0; c < count; ++c)
                loads.col(static_cast<Index>(c)) = forces[first + c].reshaped();
            const fem::Solution solution = part_->solve(loads, crew_);
            if (auto problem = part_->distrust(solution))
                return problem;
            crew_.share(static_cast<int>(count), [&](int c) {
                weigh(solution, c, study.slices, study.cases[first + static_cast<std::size_t>(c)]);
            });
            for (std::size_t c = 0; c < count; ++c) {
                const Case& now = study.cases[first + c];
                if (study.worst.load.size() > 0 && now.von_mises <= study.cases[study.worst.index].von_mises)
                    continue;
                const auto column = static_cast<Index>(c);
                study.worst = {first + c, loads.col(column), solution.displacement.col(column),
                               solution.stress.col(column)};
            }
        }
        return std::nullopt;
    }

private:
    void weigh(const fem::Solution& solution, int column, const std::vector<fem::Slice>& slices, Case& now) const {
        now.residual = solution.residual[column];
        now.unbalance = solution.unbalance[column];
        now.support_force = solution.support_force.col(column);
        const Eigen::VectorXd stress = solution.stress.col(column);
        for (Index node = 0; node < static_cast<Index>(mesh_->nodes.size()); ++node) {
            now.deflection = std::max(now.deflection, solution.displacement.col(column).segment<3>(3 * node).norm());
            const double here = fem::von_mises(stress.segment<6>(6 * node));
            now.von_mises = std::max(now.von_mises, here);
            if (away_[static_cast<std::size_t>(node)] && (now.away_node < 0 || here > now.away)) {
                now.away = here;
                now.away_node = static_cast<int>(node);
            }
        }
        for (const fem::Slice& slice : slices)
            now.slices.push_back(fem::figures_of(slice, fem::components_on(slice, *mesh_, stress), options_.counting));
    }

    std::shared_ptr<const solid::HexMesh> mesh_;
    Crew& crew_;
    const StudyOptions& options_;
    std::unique_ptr<fem::Structure> part_;
    std::vector<bool> away_; // by node: farther than Counting::edge from the part's edges
};

/// Shape, sizes in m and counts, by the scene's keys.
std::string part_of(const scene::SpecimenShape& specimen) {
    struct {
        std::string operator()(const solid::BoredCylinder& part) const {
            return fmt::format(
                "bored-cylinder: length_m {:.9g}, radius_m {:.9g}, bore_radius_m {:.9g}, shell_m {:.9g}, "
                "around {}, along {}, shell_rings {}, inner_rings {}",
                part.length, part.radius, part.bore_radius, part.shell, part.around, part.along, part.shell_rings,
                part.inner_rings);
        }
        std::string operator()(const solid::Prism& part) const {
            return fmt::format("prism: length_m {:.9g}, side_m {:.9g}, corner_m {:.9g}, corner_cells {}, middle_cells "
                               "{}, along {}",
                               part.length, part.side, part.corner, part.corner_cells, part.middle_cells, part.along);
        }
        // Not the file's name: beside the loads it has another.
        std::string operator()(const solid::MeshFile& part) const {
            return fmt::format("hexahedra: scale {:.9g}", part.scale);
        }
    } const words;
    return std::visit(words, specimen.part);
}

} // namespace

std::string settings_of(const scene::SpecimenShape& specimen, const StudyOptions& options) {
    const std::vector<std::string> sides = options.sides.empty() ? outward_sides(specimen) : options.sides;
    std::vector<double> depths; // mm
    for (const double depth : options.depths)
        depths.push_back(1e3 * depth);
    return fmt::format("loads = {}\nelement = {}\nhexahedra = {}\nsides = {}\ndepths_mm = {:.9g}\nlower = {:.9g}\n"
                       "edge_mm = {:.9g}\npatch = {:.9g}\npart = {}\nnodes = {}\nheld = {}\n"
                       "part_youngs_modulus_Pa = {:.9g}\npart_poisson_ratio = {:.9g}\n",
                       options.means ? "means" : "instants",
                       options.formulation == fem::Formulation::standard ? "standard" : "incompatible",
                       specimen.mesh->hexes.size(), fmt::join(sides, ", "), fmt::join(depths, ", "),
                       options.counting.lower, 1e3 * options.counting.edge, options.patch, part_of(specimen),
                       specimen.mesh->nodes.size(), fmt::join(scene::held_sets(specimen), ", "),
                       specimen.youngs_modulus, specimen.poisson_ratio);
}

Result<std::vector<fem::Slice>> slices_of(const scene::SpecimenShape& specimen, const StudyOptions& options) {
    std::vector<fem::Slice> slices;
    const solid::Locator locator(*specimen.mesh);
    for (const std::string& side : options.sides.empty() ? outward_sides(specimen) : options.sides)
        for (const double depth : options.depths) {
            auto slice = fem::slice_of(*specimen.mesh, locator, side, specimen.place.axis, depth);
            if (!slice)
                return slice.problems();
            if (std::none_of(slice->points.begin(), slice->points.end(),
                             [&](const fem::SlicePoint& point) { return options.counting.takes(point); }))
                return Problem{.what = fmt::format("beneath side '{}' no point lies in the lower {:.3g} of the part's "
                                                   "length (--lower)",
                                                   side, options.counting.lower),
                               .fix = "take more of it, or another side"};
            if (const auto beyond = fem::beyond_first_wall(*slice, *specimen.mesh, locator))
                return *beyond;
            for (const fem::Slice& other : slices)
                if (other.side == side && other.depth == depth)
                    return Problem{
                        .what = fmt::format("a slice {:.4g} mm beneath '{}' is asked for twice", 1e3 * depth, side),
                        .fix = "give each depth and each side once"};
            slices.push_back(std::move(*slice));
        }
    return slices;
}

Result<std::vector<Eigen::Matrix3Xd>> nodal_cases(const scene::SpecimenShape& specimen, const run::PartLoads& loads,
                                                  bool means, double patch, Crew& crew) {
    const std::vector<CaseLoad> cases = case_loads(loads, means);
    if (cases.empty())
        return Problem{.what = "there is no load case",
                       .fix = "begin earlier (--from), look more often (--every) or run longer (--duration)"};
    const solid::PatchSpreader spreader(*specimen.mesh);
    std::vector<Eigen::Matrix3Xd> forces(cases.size());
    std::vector<Problems> problems(cases.size());
    crew.share(static_cast<int>(cases.size()), [&](int number) {
        const auto c = static_cast<std::size_t>(number);
        std::vector<solid::Push> contacts, points;
        for (const observe::WallPush& push : cases[c].pushes) {
            contacts.push_back({push.triangle / 2, push.foot, push.force});
            const auto spread = spreader.spread(contacts.back(), push.normal, patch * push.patch);
            points.insert(points.end(), spread.begin(), spread.end());
        }
        auto force = solid::nodal_loads(*specimen.mesh, points);
        if (!force)
            problems[c] = force.problems();
        else if (const auto problem = solid::imbalance(*specimen.mesh, *force, contacts))
            problems[c] = {*problem};
        else
            forces[c] = std::move(*force);
        for (Problem& problem : problems[c])
            problem.what = fmt::format("load case at {:.6g} s: {}", cases[c].time, problem.what);
    });
    for (const Problems& wrong : problems)
        if (!wrong.empty())
            return wrong;
    return forces;
}

Result<Study> study(const scene::Scene& scene, const scene::SpecimenShape& specimen, const run::PartLoads& loads,
                    const StudyOptions& options) {
    Study study;
    study.settings = settings_of(specimen, options);
    const auto begun = std::chrono::steady_clock::now();
    Crew crew(options.threads);
    Solver solver(specimen, options, crew);
    if (const auto problems = solver.prepare(specimen, study))
        return *problems;
    study.prepare_s = seconds_since(begun);

    const auto loading = std::chrono::steady_clock::now();
    const auto forces = nodal_cases(specimen, loads, options.means, options.patch, crew);
    if (!forces)
        return forces.problems();
    double surface = 0; // m2
    for (std::size_t f = 0; f < specimen.mesh->facets.size(); ++f)
        surface += specimen.mesh->area_of(static_cast<int>(f)).norm();
    const std::vector<CaseLoad> cases = case_loads(loads, options.means);
    const FacetFinder finder(*specimen.mesh);
    for (std::size_t c = 0; c < cases.size(); ++c) {
        Case now;
        now.time = cases[c].time;
        now.window = cases[c].window;
        now.force = (*forces)[c].rowwise().sum();
        if (options.means)
            now.facet_normal = now.facet_shear = now.surface_normal = now.surface_shear = untold;
        else
            look_at(loads.instants[c], finder, surface, now);
        study.cases.push_back(std::move(now));
    }
    measure_patches(cases, finder, options.patch, study);
    study.impacts = observe::impacts_of(loads.touches);
    study.load_s = seconds_since(loading);

    const auto solving = std::chrono::steady_clock::now();
    if (const auto problem = solver.solve(*forces, study))
        return *problem;
    study.solve_s = seconds_since(solving);
    find_worst_node(*specimen.mesh, study);
    measure_edges(*specimen.mesh, study);
    study.doubts = doubts_of(scene, study, options.means);

    const auto most = std::max_element(study.cases.begin(), study.cases.end(),
                                       [](const Case& a, const Case& b) { return a.deflection < b.deflection; });
    if (const double radius = smallest_radius(scene); most->deflection > visible_deflection * radius)
        study.warnings.push_back(fmt::format("the part gives way by {:.3g} m, {:.2g} of the smallest sphere's radius, "
                                             "and the media did not see it move: "
                                             "loads and stresses are those of a part that stands still",
                                             most->deflection, most->deflection / radius));
    return study;
}

} // namespace tumble::stress
