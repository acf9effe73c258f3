// Many load cases from contacts to tables and files: on the thesis' cylinder with contacts spread over their patches
// and with contacts at points, with ccx_cases=N the first N of them by CalculiX as well, which factorises anew for
// each; on the thesis' prism, both ways; and on cylinders of growing fineness with growing numbers of cases.
// only=NAME,... runs some of them: patches, points, prism, prism-points, grow. Each is a process of its own, so that
// its processor time and its largest memory are its own.
#include "base/child_process.h"
#include "base/rng.h"
#include "observe/whole_file.h"
#include "run/part_loads.h"
#include "scene/specimen.h"
#include "stress/recorded.h"
#include "stress/study.h"
#include "stress/study_sheet.h"
#include "support/arguments.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/core.h>
#include <functional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace tumble;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

scene::SpecimenShape meshed(scene::SpecimenShape shape) {
    shape.held = scene::Held::top;
    shape.youngs_modulus = 2e11;
    shape.poisson_ratio = 0.3;
    auto whole = scene::with_mesh(shape);
    if (!whole)
        bench::refuse(to_string(whole.problems()));
    return *whole;
}

/// `finer`: times the thesis' numbers of hexahedra along each direction.
scene::SpecimenShape cylinder(double finer) {
    const auto times = [&](int count) { return std::max(1, static_cast<int>(std::lround(finer * count))); };
    scene::SpecimenShape shape;
    shape.part = solid::BoredCylinder{.length = 0.1,
                                      .radius = 0.015,
                                      .bore_radius = 0.005,
                                      .shell = 0.0015,
                                      .around = times(60),
                                      .along = times(12),
                                      .shell_rings = times(3),
                                      .inner_rings = times(6)};
    return meshed(shape);
}

scene::SpecimenShape prism() {
    scene::SpecimenShape shape;
    shape.part = solid::Prism{
        .length = 0.1, .side = 0.015, .corner = 0.0048, .corner_cells = 6, .middle_cells = 10, .along = 60};
    return meshed(shape);
}

/// Contacts of up to 2 N at random places of the side, obliquely, on circles of so many m in radius.
run::PartLoads contacts(const solid::HexMesh& mesh, int cases, int each, double patch) {
    std::vector<int> side;
    for (const char* name : {"side", "-x", "+x", "-z", "+z"})
        if (const auto found = mesh.facet_sets.find(name); found != mesh.facet_sets.end())
            side.insert(side.end(), found->second.begin(), found->second.end());
    run::PartLoads loads;
    Rng rng(1);
    for (int c = 0; c < cases; ++c) {
        run::LoadInstant instant{c / 60.0, {}};
        for (int k = 0; k < each; ++k) {
            const int facet = side[static_cast<std::size_t>(rng.uniform() * static_cast<double>(side.size()))];
            const Eigen::Vector4d shares = solid::facet_shape_at(rng.uniform(-1, 1), rng.uniform(-1, 1));
            const auto& corners = mesh.facets[static_cast<std::size_t>(facet)].corners;
            observe::WallPush push;
            push.body = k;
            push.patch = patch;
            push.triangle = 2 * facet;
            push.normal = mesh.area_of(facet).normalized();
            for (std::size_t corner = 0; corner < 4; ++corner)
                push.foot +=
                    shares[static_cast<Eigen::Index>(corner)] * mesh.nodes[static_cast<std::size_t>(corners[corner])];
            push.force = -rng.uniform(0, 2) * push.normal + Eigen::Vector3d(0, rng.uniform(-0.5, 0.5), 0);
            instant.pushes.push_back(push);
        }
        loads.instants.push_back(std::move(instant));
    }
    return loads;
}

/// s that ccx takes for so many of the cases; 0 where it is not installed.
double by_calculix(const scene::SpecimenShape& specimen, const run::PartLoads& loads, int cases,
                   const std::filesystem::path& folder) {
    Crew crew(1);
    auto forces = stress::nodal_cases(specimen, loads, false, 1, crew).value();
    forces.resize(static_cast<std::size_t>(cases));
    stress::Recorded recorded;
    recorded.scene.walls.emplace_back().shape = specimen;
    recorded.loads = loads;
    const std::string model = stress::to_calculix(recorded, forces, fem::Formulation::standard, false);
    if (const auto written = observe::write_whole(folder / "part.inp", model); !written)
        bench::refuse(to_string(written.problems()));
    const auto begun = Clock::now();
    ChildProcess ccx({"env", "-C", folder.string(), "ccx", "-i", "part"});
    const int status = ccx.wait(std::chrono::hours(1));
    if (status == 127) // env's word for a program that is not there
        return 0;
    if (status != 0)
        bench::refuse("ccx failed: " + ccx.printed());
    return seconds_since(begun);
}

double peak_MB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

stress::Study solved(const scene::SpecimenShape& specimen, const run::PartLoads& loads,
                     const stress::StudyOptions& options) {
    auto study = stress::study({}, specimen, loads, options);
    if (!study)
        bench::refuse(to_string(study.problems()));
    return std::move(*study);
}

struct Asked {
    int cases = 0, each = 0, ccx_cases = 0;
    double patch = 0, finer = 1; // m; times the thesis' numbers of hexahedra
    stress::StudyOptions options{};
    std::filesystem::path folder{};
};

std::string said(double patch) {
    return patch > 0 ? fmt::format("patches of {:g} um", 1e6 * patch) : "points (patch_um=0)";
}

/// From the mesh to the files.
void whole(const std::string& part, const Asked& asked, double patch) {
    const auto begun = Clock::now();
    const scene::SpecimenShape specimen = part == "prism" ? prism() : cylinder(asked.finer);
    std::filesystem::create_directories(asked.folder);
    const run::PartLoads loads = contacts(*specimen.mesh, asked.cases, asked.each, patch);
    const double meshed = seconds_since(begun);
    const stress::Study study = solved(specimen, loads, asked.options);
    const auto writing = Clock::now();
    if (const auto written = stress::write_study(study, specimen, loads, asked.folder); !written)
        bench::refuse(to_string(written.problems()));
    const double written = seconds_since(writing), total = seconds_since(begun);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print("\n{}, {}: {} hexahedra, {} unknowns, {} load cases of {} contacts, {} threads\n", part, said(patch),
               study.hexes, study.unknowns, asked.cases, asked.each, asked.options.threads);
    fmt::print("mesh_s {:.3f} factorise_s {:.3f} load_s {:.3f} solve_s {:.3f} write_s {:.3f} total_s {:.3f}\n", meshed,
               study.prepare_s, study.load_s, study.solve_s, written, total);
    fmt::print("processor_s {:.3f} factor_entries {} factor_Gflop {:.2f} peak_MB {:.0f}\n",
               static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec),
               study.factor_entries, 1e-9 * study.factor_operations, peak_MB());
    if (part == "cylinder" && patch > 0 && asked.ccx_cases > 0) {
        const double ccx = by_calculix(specimen, loads, asked.ccx_cases, asked.folder);
        fmt::print("ccx_s {:.3f} for {} cases, {:.3f} a case\n", ccx, asked.ccx_cases, ccx / asked.ccx_cases);
    }
}

/// One line a mesh and number of cases; memory is what the program ever had, so meshes grow.
void grow(const Asked& asked) {
    fmt::print("\ngrowth, {}, {} threads\n", said(asked.patch), asked.options.threads);
    fmt::print("{:>10} {:>9} {:>6} {:>12} {:>10} {:>12} {:>9} {:>9} {:>8}\n", "hexahedra", "unknowns", "cases",
               "entries", "Gflop", "factorise_s", "load_s", "solve_s", "peak_MB");
    for (const double finer : {0.5, 0.75, 1.0, 1.5, 2.0}) {
        const scene::SpecimenShape specimen = cylinder(finer);
        for (const int cases : finer == 1 ? std::vector{27, 54, 108, 216, 432} : std::vector{54}) {
            const stress::Study study =
                solved(specimen, contacts(*specimen.mesh, cases, asked.each, asked.patch), asked.options);
            fmt::print("{:>10} {:>9} {:>6} {:>12} {:>10.2f} {:>12.3f} {:>9.3f} {:>9.3f} {:>8.0f}\n", study.hexes,
                       study.unknowns, cases, study.factor_entries, 1e-9 * study.factor_operations, study.prepare_s,
                       study.load_s, study.solve_s, peak_MB());
        }
    }
}

/// The work in a process of its own; it ends as that does.
template <class Work> void apart(const Work& work) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0)
        bench::refuse("no further process");
    if (child == 0) {
        work();
        std::fflush(stdout);
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0)
        std::exit(WIFEXITED(status) ? WEXITSTATUS(status) : 1);
}

} // namespace

int main(int count, char** words) {
    bench::Arguments arguments(count, words);
    Asked asked;
    asked.cases = static_cast<int>(arguments.whole("cases", 216));
    asked.each = static_cast<int>(arguments.whole("contacts", 40));
    asked.ccx_cases = static_cast<int>(arguments.whole("ccx_cases", 0));
    // Of 5 N between spheres of 9.5 mm as soft as the case studies' (docs/stress.md).
    asked.patch = 1e-6 * static_cast<double>(arguments.whole("patch_um", 820));
    asked.finer = static_cast<double>(arguments.whole("finer", 1));
    asked.options.threads = static_cast<int>(arguments.whole("threads", 2));
    asked.options.formulation =
        arguments.whole("standard", 0) != 0 ? fem::Formulation::standard : fem::Formulation::incompatible;
    asked.folder = arguments.text("folder", "out/bench-stress");
    const auto only = arguments.words("only");
    arguments.finish();
    const std::vector<std::pair<std::string, std::function<void()>>> all{
        {"patches", [&] { whole("cylinder", asked, asked.patch); }},
        {"points", [&] { whole("cylinder", asked, 0); }},
        {"prism", [&] { whole("prism", asked, asked.patch); }},
        {"prism-points", [&] { whole("prism", asked, 0); }},
        {"grow", [&] { grow(asked); }}};
    for (const std::string& name : only)
        if (std::none_of(all.begin(), all.end(), [&](const auto& one) { return one.first == name; }))
            bench::refuse("only=" + name + ": there are patches, points, prism, prism-points and grow");
    for (const auto& [name, work] : all)
        if (only.empty() || std::find(only.begin(), only.end(), name) != only.end())
            apart(work);
    return 0;
}
