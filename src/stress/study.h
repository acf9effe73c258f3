#pragma once

#include "base/parallel_for.h"
#include "base/problem.h"
#include "fem/brick.h"
#include "fem/slice.h"
#include "observe/impacts.h"
#include "run/part_loads.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// From the loads of a run to the stress inside its specimen; docs/stress.md.
namespace tumble::stress {

struct StudyOptions {
    fem::Formulation formulation = fem::Formulation::incompatible;
    std::vector<double> depths{0.0005, 0.001, 0.0015}; // m, of the slices; the thesis'
    std::vector<std::string> sides{};                  // facet sets; empty: all along the axis that face outwards
    bool means = false;                                // solve the means over the windows, else the instants
    double patch = 1; // radius of the circles in which bodies touch, times that of the run; 0: forces act at points
    fem::Counting counting{.trivial = 500, .edge = 0.003};
    int threads = 1;
};

/// The contact with the largest force at an instant.
struct Strongest {
    std::int64_t body = 0;
    int element = 0;                                // its number
    int face = 0;                                   // of the element, CalculiX' number
    Eigen::Vector3d foot = Eigen::Vector3d::Zero(); // m
    double normal = 0;                              // N, along the contact's own normal
    double shear = 0;                               // N, across it
};

/// Of a mean, what only an instant's contacts tell is NaN: facet_normal to surface_shear.
struct Case {
    double time = 0;                                         // s
    double window = 0;                                       // s, of a mean, that ends at `time`; 0: an instant
    int contacts = 0;                                        // of an instant
    std::optional<Strongest> strongest;                      // the same
    Eigen::Vector3d force = Eigen::Vector3d::Zero();         // N, on the part
    Eigen::Vector3d support_force = Eigen::Vector3d::Zero(); // N, what its supports bear
    double facet_normal = 0;   // Pa, largest of all facets: force over area, by the facet's own normal
    double facet_shear = 0;    // Pa, the same
    double surface_normal = 0; // Pa, mean over the part's whole surface: what presses over all its area
    double surface_shear = 0;  // Pa, the same of what shears, facet by facet
    double deflection = 0;     // m, the largest of all nodes
    double von_mises = 0;      // Pa, the same
    double away = 0;           // Pa, largest von Mises stress farther than Counting::edge from the part's edges
    int away_node = -1;        // where that is, into HexMesh::nodes; below 0: no node lies so far away
    double residual = 0;       // fem::Solution
    double unbalance = 0;
    std::vector<fem::SliceFigures> slices; // parallel to Study::slices
};

/// The largest of Case::away.
struct Away {
    double von_mises = 0;                            // Pa
    double time = 0;                                 // s
    int node = 0;                                    // its number
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); // m
};

/// A case with all that a picture needs.
struct Field {
    std::size_t index = 0; // into Study::cases
    Eigen::VectorXd load, displacement, stress;
};

struct Study {
    std::string settings; // settings_of what was solved
    std::vector<fem::Slice> slices;
    std::vector<Case> cases;
    Field worst;                                                 // the case with the largest von Mises stress
    int worst_node = 0;                                          // where it is, of all nodes: its number
    Eigen::Vector3d worst_place = Eigen::Vector3d::Zero();       // m
    double worst_edge = std::numeric_limits<double>::infinity(); // m, from there to the part's nearest edge
    std::optional<Away> away;
    std::map<std::string, double> pressed; // by side of the part: its share of all contacts' forces, as sizes
    double patch = 0; // m, mean radius of the circles in which bodies touch, as the forces weigh it; 0: none
    double facet = 0; // m, mean width of the facets beneath them, the root of their area, as the forces weigh it
    std::size_t nodes = 0, hexes = 0, unknowns = 0;
    std::int64_t factor_entries = 0;
    double factor_operations = 0; // multiplications and additions
    double prepare_s = 0;         // s, of wall time: assembly and factorisation
    double load_s = 0;            // s, all cases: contacts spread over their patches, forces on nodes
    double solve_s = 0;           // s, all cases: displacements, stresses, slices
    observe::Impacts impacts;     // of the run's touches
    std::vector<std::string> warnings;
    std::vector<std::string> doubts; // doubts_of()
};

/// What is solved and how, a line each: "element = standard". New ones come last: study.txt of older folders is
/// compared line by line.
std::string settings_of(const scene::SpecimenShape& specimen, const StudyOptions& options);

/// Where stresses are looked at. Problems: those of fem::slice_of, a side that the part has not or a depth that it does
/// not reach; a slice without a point in the share of the part that counts (`counting.lower`).
Result<std::vector<fem::Slice>> slices_of(const scene::SpecimenShape& specimen, const StudyOptions& options);

/// Problems: no load case; those of fem::Structure, of its solutions too, slices_of() and solid::nodal_loads.
Result<Study> study(const scene::Scene& scene, const scene::SpecimenShape& specimen, const run::PartLoads& loads,
                    const StudyOptions& options);

/// Nodal forces of every case that is solved, N, spread over patches (`patch`: as StudyOptions). The crew's threads
/// change no bit. Problems: there is no case; those of solid::nodal_loads; forces whose sum or moment is not that of
/// the contacts (solid::imbalance).
Result<std::vector<Eigen::Matrix3Xd>> nodal_cases(const scene::SpecimenShape& specimen, const run::PartLoads& loads,
                                                  bool means, double patch, Crew& crew);

} // namespace tumble::stress
