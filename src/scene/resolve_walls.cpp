#include "base/text.h"
#include "scene/bowl_mesh.h"
#include "scene/extent.h"
#include "scene/faults.h"
#include "scene/keys.h"
#include "scene/read_stl.h"
#include "scene/resolve.h"
#include "scene/specimen.h"
#include "solid/msh.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <set>

namespace tumble::scene {
namespace {

PlaneShape plane(const View& view, const Resolving& to) {
    return {view.vector("point_m"), direction_of(view, "normal", to)};
}

BoxShape box(const View& view, const Resolving& to) {
    BoxShape shape;
    shape.box = box_of(view, "lo_m", "hi_m", to);
    for (const std::string& face : view.words("open"))
        shape.open[static_cast<std::size_t>(2 * (face[1] - 'x') + (face[0] == '+'))] = true;
    return without_fault(shape, view, to);
}

DiscShape disc(const View& view, const Resolving& to) {
    return without_fault(DiscShape{view.vector("centre_m"), direction_of(view, "normal", to), view.number("radius_m"),
                                   view.number("hole_radius_m")},
                         view, to);
}

TroughShape trough(const View& view, const Resolving& to) {
    TroughShape shape;
    shape.radius = view.number("radius_m");
    shape.floor = view.number("floor_m");
    shape.rim = view.number("rim_m");
    shape.flare = view.number("flare_deg");
    shape.x_lo = view.given("x_lo_m") ? view.number("x_lo_m") : to.scene.domain.box.lo.x();
    shape.x_hi = view.given("x_hi_m") ? view.number("x_hi_m") : to.scene.domain.box.hi.x();
    if (shape.x_lo >= shape.x_hi)
        to.refuse(view, view.written("x_lo_m") ? "x_lo_m" : "x_hi_m", "the trough has no length along x",
                  "give x_lo_m below x_hi_m");
    return without_fault(shape, view, to);
}

MeshShape mesh(const View& view, const Resolving& to) {
    MeshShape shape;
    if (!view.given("stl"))
        return shape;
    shape.file = to.file(view.text("stl"));
    auto read = read_stl(shape.file);
    if (!read) {
        for (const Problem& problem : read.problems())
            if (problem.line > 0)
                to.report.add(Problems{problem});
            else
                to.refuse(view, "stl", fmt::format("STL file {}: {}", problem.file, problem.what), problem.fix);
        return shape;
    }
    shape.triangles = std::move(*read);
    shape.scale = view.number("scale");
    for (auto& triangle : shape.triangles)
        for (Vector3d& corner : triangle)
            corner *= shape.scale;
    return shape;
}

Ribs ribs(const View& view) {
    return {static_cast<int>(view.integer("rib_count")), view.number("rib_height_m"), view.number("rib_width_m"),
            view.number("rib_crest_m")};
}

/// As the names of an .inp file are kept.
std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

int count_of(const View& view, const char* key) {
    return static_cast<int>(view.integer(key));
}

SpecimenShape specimen(const View& view, const Resolving& to) {
    SpecimenShape shape;
    shape.place.axis = direction_of(view, "axis", to);
    shape.youngs_modulus = view.number("part_youngs_modulus_Pa");
    shape.poisson_ratio = view.number("part_poisson_ratio");
    if (view.kind() == "hexahedra") {
        shape.part = solid::MeshFile{to.file(view.text("inp")), view.number("scale")};
        shape.held_set = solid::is_gmsh(std::get<solid::MeshFile>(shape.part).file) ? view.text("held_set")
                                                                                    : upper(view.text("held_set"));
    } else if (view.kind() == "prism")
        shape.part = solid::Prism{.length = view.number("length_m"),
                                  .side = view.number("side_m"),
                                  .corner = view.number("corner_m"),
                                  .corner_cells = count_of(view, "corner_cells"),
                                  .middle_cells = count_of(view, "middle_cells"),
                                  .along = count_of(view, "along")};
    else
        shape.part = solid::BoredCylinder{.length = view.number("length_m"),
                                          .radius = view.number("radius_m"),
                                          .bore_radius = view.number("bore_radius_m"),
                                          .shell = view.number("shell_m"),
                                          .around = count_of(view, "around"),
                                          .along = count_of(view, "along"),
                                          .shell_rings = count_of(view, "shell_rings"),
                                          .inner_rings = count_of(view, "inner_rings")};
    if (view.kind() != "hexahedra") {
        shape.place.base = view.vector("base_m");
        const std::string held = view.text("held");
        shape.held = held == "base" ? Held::base : held == "both" ? Held::both : Held::top;
    }
    Result<SpecimenShape> whole = view.whole() ? with_mesh(shape) : Problems{};
    if (whole)
        return *whole;
    for (const Problem& problem : whole.problems())
        if (problem.key.empty()) // of a file
            to.report.add(Problems{problem});
        else
            to.refuse(view, problem.key, problem.what, problem.fix);
    shape.mesh = std::make_shared<const solid::HexMesh>(); // a wall that is already wrong
    return shape;
}

WallShape resolve_shape(const View& view, const Resolving& to) {
    const std::string kind = view.kind();
    if (kind == "box")
        return box(view, to);
    if (kind == "cylinder")
        return CylinderShape{view.vector("base_m"), direction_of(view, "axis", to), view.number("length_m"),
                             view.number("radius_m")};
    if (kind == "disc")
        return disc(view, to);
    if (kind == "trough")
        return trough(view, to);
    if (kind == "mesh")
        return mesh(view, to);
    if (kind == "bowl")
        return without_fault(BowlShape{view.vector("base_m"), view.number("radius_m"), view.number("height_m"),
                                       view.number("rib_start"), ribs(view)},
                             view, to);
    if (kind == "bowl-disc")
        return without_fault(BowlDiscShape{view.vector("centre_m"), view.number("radius_m"), view.number("rim_width_m"),
                                           view.number("rim_rise_m"), view.number("rib_start"), ribs(view)},
                             view, to);
    if (kind == "bored-cylinder" || kind == "prism" || kind == "hexahedra")
        return specimen(view, to);
    return plane(view, to);
}

/// Whether any of the plane lies in the box: its corners are not all on one side.
bool crosses(const PlaneShape& plane, const Box& box) {
    const Vector3d middle = (box.lo + box.hi) / 2;
    const double reach = plane.normal.cwiseAbs().dot((box.hi - box.lo) / 2);
    return std::abs(plane.normal.dot(middle - plane.point)) <= reach * (1 + 1e-9);
}

/// Centres of bodies stay in the domain, their surfaces reach out of it by this at most, m.
double reach_of_bodies(const Scene& scene) {
    double reach = 0;
    for (const BodyTemplate& body : scene.bodies) {
        Eigen::AlignedBox3d centres;
        double radius = 0;
        for (const Sphere& sphere : body.spheres) {
            centres.extend(sphere.centre);
            radius = std::max(radius, sphere.radius);
        }
        reach = std::max(reach, body.spheres.empty() ? 0 : centres.diagonal().norm() + radius);
    }
    return reach;
}

bool touches(const MeshShape& mesh, double scale, const Box& box) {
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
        return overlap({scale * triangle[0], scale * triangle[1], scale * triangle[2]}, box);
    });
}

bool overlap(const Box& a, const Box& b) {
    return (a.lo.array() <= b.hi.array()).all() && (a.hi.array() >= b.lo.array()).all();
}

/// Whether the wall is ever in the domain, of which `reached` is reached_domain(). Of a mesh its
/// triangles count: around a small domain a large one has none inside.
bool in_domain(const Wall& wall, const Scene& scene, const Box& reached) {
    if (const auto* flat = std::get_if<PlaneShape>(&wall.shape))
        return crosses(*flat, reached);
    const auto* mesh = std::get_if<MeshShape>(&wall.shape);
    return overlap(extent_of(wall.shape), reached) &&
           (!mesh || touches(*mesh, 1, widened(reached, reach_of_bodies(scene))));
}

std::string size_in_words(const Box& box) {
    const Vector3d size = box.hi - box.lo;
    return fmt::format("it is {:.4g} x {:.4g} x {:.4g} m, and no triangle of it comes in", size.x(), size.y(),
                       size.z());
}

/// The unit that an STL file is probably in: one in which the mesh would lie in the domain and be about as large.
std::string other_scale(const MeshShape& mesh, const Box& domain) {
    const Box extent = extent_of(mesh);
    const double size = (extent.hi - extent.lo).maxCoeff();
    const double room = (domain.hi - domain.lo).maxCoeff();
    for (const auto& [scale, unit] : {std::pair{1e-3, "millimetres"}, {1e-2, "centimetres"}, {0.0254, "inches"}})
        if (const double factor = scale / mesh.scale;
            size * factor < 2 * room && size * factor > 0.05 * room && touches(mesh, factor, domain))
            return fmt::format("did you mean scale = {}, an STL in {}?", plain(scale), unit);
    return "";
}

/// A closed face of a box wall that no body can reach.
std::string lost_face(const WallShape& shape, const Box& reached) {
    const auto* box = std::get_if<BoxShape>(&shape);
    const char* names[6] = {"-x", "+x", "-y", "+y", "-z", "+z"};
    for (std::size_t face = 0; box && face < 6; ++face) {
        const auto axis = static_cast<Eigen::Index>(face / 2);
        const double at = face % 2 ? box->box.hi[axis] : box->box.lo[axis];
        if (!box->open[face] && (at < reached.lo[axis] || at > reached.hi[axis]))
            return names[face];
    }
    return "";
}

void check_place(const View& view, const Wall& wall, const Resolving& to) {
    const Box& domain = to.scene.domain.box;
    const auto* mesh = std::get_if<MeshShape>(&wall.shape);
    const auto* specimen = std::get_if<SpecimenShape>(&wall.shape);
    if (!has_volume(domain) || (mesh && mesh->triangles.empty()) || (specimen && specimen->mesh->nodes.empty()) ||
        !view.whole())
        return; // a wall or a domain that is already wrong is in no place
    const Box reached = reached_domain(wall, to.scene);
    if (!in_domain(wall, to.scene, reached)) {
        const bool around = mesh && overlap(extent_of(*mesh), domain);
        std::string fix = mesh ? other_scale(*mesh, domain) : "";
        if (fix.empty())
            fix = fmt::format("no body can ever touch it: move it into {} to {}, or enlarge the domain",
                              in_words(domain.lo, to), in_words(domain.hi, to));
        to.report.add(view.place(), view.path(),
                      fmt::format("wall '{}' lies outside the domain{}", view.text("name"),
                                  around ? ": " + size_in_words(extent_of(*mesh)) : ""),
                      fix);
    } else if (const std::string face = lost_face(wall.shape, reached); !face.empty())
        to.report.add(view.place(), view.path(),
                      fmt::format("face {} of wall '{}' lies outside the domain", face, view.text("name")),
                      fmt::format("no body can ever touch it: add \"{}\" to open, or enlarge the domain", face));
}

} // namespace

void resolve_walls(const View& root, const Resolving& to) {
    std::set<std::string> names;
    for (const NamedView& named : root.children("wall")) {
        const View& view = named.view;
        Wall wall;
        wall.name = view.text("name");
        if (view.given("name") && (wall.name.empty() || wall.name.find('.') != std::string::npos))
            to.refuse(view, "name", fmt::format("a wall cannot be called '{}'", excerpt(wall.name)),
                      "use a name without dots");
        else if (view.given("name") && !names.insert(wall.name).second)
            to.refuse(view, "name", fmt::format("there are two walls '{}'", excerpt(wall.name)),
                      "give each its own name");
        wall.material = material_of(view, to).value_or(0);
        wall.opacity = view.number("opacity");
        wall.motion = resolve_motion(view, to);
        if (to.scene.dimension == 2) {
            wall.outline = resolve_outline(view, to);
            check_outline(view, wall, to);
        } else {
            wall.shape = resolve_shape(view, to);
            check_place(view, wall, to);
        }
        to.scene.walls.push_back(std::move(wall));
    }
}

} // namespace tumble::scene
