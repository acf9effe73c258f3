#pragma once

#include "contact/air_drag.h"
#include "contact/material.h"
#include "fit/shapes.h"
#include "scene/laws.h"
#include "scene/motion.h"
#include "solid/generate.h"
#include "solid/inp.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What is wanted, resolved: SI units, defaults filled, every reference an index, every file read. Only src/scene sees
/// TOML; everything else works from these plain values. A scene of two dimensions lies in the plane z = 0: its points
/// have z = 0, its boxes reach half the depth to either side, and what turns turns about z.
namespace tumble::scene {

using Eigen::Vector3d;

struct Box {
    Vector3d lo = Vector3d::Zero(); // m
    Vector3d hi = Vector3d::Zero(); // m
};

/// Bodies that leave the box through a side that is not periodic stop the run.
struct Domain {
    Box box;
    std::array<bool, 3> periodic{false, false, false};
};

struct ContactLaws {
    NormalLaw normal = NormalLaw::hertz;
    TangentialLaw tangential = TangentialLaw::mindlin;
    bool limit_force = false;               // true: the normal force never pulls at the end of a rebound
    bool share_among_body_contacts = false; // true: n contacts of one body pair share one dashpot (docs/bodies.md)
    double damping_shared = 0;              // -, x: each of those damps n^(-x/2) as much; 1 is what the flag says
    double global_damping = 0;              // 1/s, mass-proportional; two dimensions only
    double accepted_overlap = 0.05;         // over the smaller radius; a run that goes beyond says so
    contact::Additions additions;           // docs/laws.md

    /// x of either key.
    [[nodiscard]] double sharing() const { return share_among_body_contacts ? 1 : damping_shared; }
};

using fit::Sphere;

/// A rigid set of spheres, or of discs in two dimensions. Mass comes from density and the union's volume unless given.
/// In two dimensions the third moment of inertia is the one that counts.
struct BodyTemplate {
    std::string name;
    std::vector<Sphere> spheres;
    int material = 0;                          // index into Scene::materials
    std::optional<double> mass;                // kg, given instead of density * volume
    std::optional<Vector3d> principal_inertia; // kg m2, about the principal axes, given instead of the union's
    std::optional<Vector3d> tracer_point; // m, template frame: where a tracer's sensor sits; else the centre of mass
    Vector3d tracer_turned =
        Vector3d::Zero();          // rad about its direction: how the sensor sits, against the template frame
    std::optional<fit::Cone> cone; // what the spheres stand for, in the template frame; to fit anew
};

/// How Box2D is told to work; docs/hard-contacts.md. Two dimensions only.
struct Box2dSettings {
    double time_step = 0;        // s
    int velocity_iterations = 0; // per step, over all contacts
    int position_iterations = 0; // the same, that take overlaps back
    double rebound_above = 0;    // m/s, slower impacts come back with nothing
};

enum class Orientation { random, as_written };

/// The ends of a specimen that cannot move.
enum class Held { base, top, both };

struct Fill {
    int body = 0;                      // index into Scene::bodies
    std::optional<std::int64_t> count; // exactly one of count and mass
    std::optional<double> mass;        // kg
    Box region;                        // bodies lie wholly inside
    Orientation orientation = Orientation::random;
    Vector3d velocity = Vector3d::Zero();         // m/s
    Vector3d angular_velocity = Vector3d::Zero(); // rad/s
    double start = 0;                             // s
    double until = 0;                             // s; start == until: all at once; later: tries again every `every`
    double every = 0.02;                          // s
    std::optional<Vector3d> position;             // one body's centre placed exactly (count = 1, no search)
};

struct PlaneShape {
    Vector3d point = Vector3d::Zero();
    Vector3d normal = Vector3d::UnitY(); // unit, towards the bodies
};
/// The inside of a box; faces named in `open` ("-x", "+y", ...) are left out.
struct BoxShape {
    Box box;
    std::array<bool, 6> open{}; // -x +x -y +y -z +z
};
/// Lateral surface of finite length, without lids; bodies may touch it from inside or outside.
struct CylinderShape {
    Vector3d base = Vector3d::Zero();
    Vector3d axis = Vector3d::UnitY(); // unit
    double length = 0;                 // m
    double radius = 0;                 // m
};
/// A thin round plate, touched from both sides and on its rim.
struct DiscShape {
    Vector3d centre = Vector3d::Zero();
    Vector3d normal = Vector3d::UnitY(); // unit
    double radius = 0;                   // m
    double hole_radius = 0;              // m
};
/// A U open at the top, along x: a half-cylinder bottom of `radius` about (y = floor + radius, z = 0) whose tangents go
/// up as sides that lean outwards by `flare`, to height `rim`. Touched from inside.
struct TroughShape {
    double radius = 0; // m
    double floor = 0;  // m, y of the lowest point
    double rim = 0;    // m, y of the rim
    double flare = 0;  // rad from the vertical, 0 for upright sides
    double x_lo = 0;   // m, only for drawing and export
    double x_hi = 0;   // m
};
/// Triangles of an STL file; touched from both sides.
struct MeshShape {
    std::filesystem::path file;
    std::vector<std::array<Vector3d, 3>> triangles; // m
    double scale = 1;                               // metres per unit of the file, already applied
};
/// Ribs of a bowl or its disc, one after the other at equal angles, the first towards x.
struct Ribs {
    int count = 0;
    double height = 0; // m, off the surface
    double width = 0;  // m, at the foot
    double crest = 0;  // m, width at the crest
};
/// The wall of a rotary bowl, upright about the y axis through `base`, with ribs in its upper part; as triangles, with
/// its corners on the circle (bowl_mesh.h). Touched from both sides.
struct BowlShape {
    Vector3d base = Vector3d::Zero(); // m, on the axis, at the lower edge
    double radius = 0;                // m
    double height = 0;                // m
    double rib_start = 0;             // share of the height
    Ribs ribs;
};
/// The bottom of a rotary bowl: a flat disc about the y axis whose rim rises outwards, with ribs along the radius up to
/// the rim's edge; as triangles.
struct BowlDiscShape {
    Vector3d centre = Vector3d::Zero(); // m, on top of the flat part
    double radius = 0;                  // m, of the rim's outer edge
    double rim_width = 0;               // m, along the radius
    double rim_rise = 0;                // m
    double rib_start = 0;               // share of the radius
    Ribs ribs;
};

/// A fixed part in the flow, made of hexahedra whose surface is the wall and whose inside `tumble stress` solves.
/// Touched from both sides; triangles 2f and 2f + 1 are facet f of the mesh.
struct SpecimenShape {
    std::variant<solid::BoredCylinder, solid::Prism, solid::MeshFile> part;
    solid::Place place;
    Held held = Held::top;
    std::string held_set;      // of a MeshFile, in its place: the node set that cannot move
    double youngs_modulus = 0; // Pa, of the part when it is solved; the wall's material is what bodies feel
    double poisson_ratio = 0;
    std::shared_ptr<const solid::HexMesh> mesh; // of part and place, without fault
};

struct SegmentShape {
    Eigen::Vector2d from = Eigen::Vector2d::Zero(); // m
    Eigen::Vector2d to = Eigen::Vector2d::Zero();   // m
};
struct ArcShape {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(); // m
    double radius = 0;                                // m
    double start = 0;                                 // rad, counter-clockwise from x
    double sweep = 0;                                 // rad, 2 pi: the whole circle
};
struct PolylineShape {
    std::vector<Eigen::Vector2d> points; // m
    bool closed = false;
};
/// A wall in two dimensions, touched from both sides. The box is its four sides, the trough its profile with x for z.
using Outline = std::variant<SegmentShape, ArcShape, PolylineShape, BoxShape, TroughShape>;

using WallShape = std::variant<PlaneShape, BoxShape, CylinderShape, DiscShape, TroughShape, MeshShape, BowlShape,
                               BowlDiscShape, SpecimenShape>;

struct Wall {
    std::string name;
    WallShape shape; // in three dimensions
    Outline outline; // in two
    int material = 0;
    WallMotion motion;
    double opacity = 0.25; // 0..1, for drawing
};

struct Observe {
    double every = 0.01;               // s between rows of series.csv
    std::vector<std::string> measures; // names listed by `tumble list measures`
    bool contacts = false;             // frames keep who touches whom, and with what force
    double axes_turned = 0; // rad about z, counter-clockwise, of the axes that the centre of mass is read along
};

/// Lines that pictures show over the bodies.
struct Marks {
    std::string arrows = "none";       // none, bodies (velocities), field (their mean over the frames)
    std::optional<double> arrow_speed; // m/s, of the legend's arrow; default: what occurs
    bool chains = false;               // force chains; they need Observe::contacts
    std::optional<double> chain_force; // N, of the thickest line; default: what occurs
    std::vector<std::string> trails;   // paths of bodies: templates, each for its first body, or ids

    friend bool operator==(const Marks&, const Marks&) = default;
};

/// A picture for print: white, in a size of its own, with letters that can be read there.
struct Paper {
    double width_mm = 85;
    double height_mm = 60;
    double dpi = 300;
    double font_pt = 8; // of the numbers at scales
};

struct Render {
    std::string camera = "front"; // front, top, side, free
    std::string projection = "orthographic";
    Vector3d eye = Vector3d::Zero();    // m, free camera
    Vector3d target = Vector3d::Zero(); // m, free camera
    double field_of_view_deg = 35;
    double turn_deg_s = 0;   // by the scene's time, of a free camera about what it looks at, anticlockwise from above
    std::optional<Box> view; // m, what must be in the picture; default: walls and bodies
    std::optional<Box> clip; // m, bodies whose centres lie outside are not drawn
    bool clip_cuts = false;  // the clip's faces cut bodies instead
    Marks marks;
    std::string color = "speed";
    std::optional<std::array<double, 2>> range; // in the quantity's SI unit
    std::string colormap = "auto";              // coolwarm for quantities with a sign, viridis for others
    std::string background = "dark";            // dark or white
    std::optional<Paper> paper;                 // for print; width and height follow from it, background does not count
    int width = 1280;
    int height = 720;
    double every = 0.04;           // s between frames
    double frames_per_second = 25; // of the video
    bool plot = true;              // small live plot over the picture
    std::string plot_measure = "kinetic_energy";

    /// Seconds of watching the video per second of the scene: above 1 slower than life.
    [[nodiscard]] double slowdown() const { return 1 / (every * frames_per_second); }
};

/// Where something was typed: a file with line and column from 1, or "--set KEY" without them (0).
struct WrittenAt {
    std::string source;
    int line = 0;
    int column = 0;
};

struct Scene {
    std::filesystem::path file;
    std::string title;
    std::string claim;
    int dimension = 3;
    double depth = 0;     // m, of discs and walls; two dimensions only
    double duration = 0;  // s
    double time_step = 0; // s, of the soft solvers; a run takes step()
    Solver solver = Solver::soft;
    Box2dSettings box2d;
    std::uint64_t seed = 1;
    bool allow_large_step = false; // expert: run even above the stable limit
    Vector3d gravity{0, -9.81, 0}; // m/s2
    Domain domain;
    double skin = 0;          // m, of the body neighbour list; 0: chosen by the solver
    bool turn_spheres = true; // false: bodies of one sphere keep the orientation they came with
    ContactLaws contact;
    contact::Air air;
    std::vector<contact::Material> materials;
    std::vector<contact::PairProperties> pairs; // materials.size() squared, symmetric, row-major
    std::vector<BodyTemplate> bodies;
    std::vector<Fill> fills;
    std::vector<Wall> walls;
    Observe observe;
    Render render;
    std::map<std::string, WrittenAt> written; // keys and tables by path: "time_step_s", "fill.0", "wall.plate.stl"

    /// Whether two bodies can ever touch each other: not when a single one is put in.
    [[nodiscard]] bool bodies_can_meet() const {
        std::int64_t count = 0;
        for (const Fill& fill : fills)
            count += fill.count ? *fill.count : 2;
        return fills.empty() || count > 1;
    }
    [[nodiscard]] contact::PairConstants constants(int a, int b) const {
        return contact::derive(materials[static_cast<std::size_t>(a)], materials[static_cast<std::size_t>(b)],
                               pair(a, b), contact.additions,
                               dimension == 2 ? contact::rolling_stiffness_of_discs
                                              : contact::rolling_stiffness_of_spheres);
    }
    /// Length of the steps that the scene's solver takes, s.
    [[nodiscard]] double step() const { return solver == Solver::box2d ? box2d.time_step : time_step; }
    [[nodiscard]] const contact::PairProperties& pair(int a, int b) const {
        return pairs[static_cast<std::size_t>(a) * materials.size() + static_cast<std::size_t>(b)];
    }
};

} // namespace tumble::scene
