#include "lesson/packing.h"

#include "lesson/stage.h"
#include "run/simulation.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;
constexpr double period = 0.06;                    // m, along x and z, where the bed has no sides
constexpr std::array<double, 2> layer{0.02, 0.06}; // m, heights between floor and surface where voidage is measured
constexpr double cell = 1e-3;                      // m, of the points that are counted
constexpr double settled = 0.8;                    // s
constexpr double while_they_fall = 0.16;           // s, when velocities have something to tell
constexpr double dt = 2e-5;                        // s
constexpr int bodies = 60;

/// The thesis' cone, appendix B.5; also scenes/clumps/cone-65.csv.
std::vector<scene::Sphere> cone() {
    std::vector<scene::Sphere> spheres;
    for (const auto& [height, radius] :
         {std::pair{20.5e-3, 1.55e-3}, {18e-3, 2.76e-3}, {15e-3, 4.08e-3}, {12e-3, 5.33e-3}, {7.21e-3, 7.21e-3}})
        spheres.push_back({{0, height, 0}, radius});
    struct Ring {
        int count;
        double ring, radius; // m
    };
    for (const Ring& ring : {Ring{10, 3.8e-3, 4.62e-3}, Ring{20, 6.4e-3, 2.8e-3}, Ring{30, 8.15e-3, 1.53e-3}})
        for (int k = 0; k < ring.count; ++k) {
            const double angle = 2 * pi * k / ring.count;
            spheres.push_back({{ring.ring * std::cos(angle), ring.radius, ring.ring * std::sin(angle)}, ring.radius});
        }
    return spheres;
}

/// Media of tables 4.1 and 4.4, but softer: nothing is asked here about forces.
scene::Scene bed(const std::vector<scene::Sphere>& body, double friction) {
    contact::PairProperties pair;
    pair.restitution = 0.667;
    pair.friction = friction;
    scene::Scene scene = space_stage({"media", 1665.71, 1e7, 0.2887}, pair, dt);
    scene.gravity = {0, -9.81, 0};
    scene.domain.box = {{-period / 2, -0.01, -period / 2}, {period / 2, 0.3, period / 2}};
    scene.domain.periodic = {true, false, true};
    add_body(scene, body);
    add_wall(scene, scene::WallShape(scene::PlaneShape{}));
    scene::Fill& fill = scene.fills.emplace_back();
    fill.count = bodies;
    fill.region = {{-period / 2, 0, -period / 2}, {period / 2, 0.28, period / 2}};
    fill.velocity = {0, -0.5, 0};
    fill.until = 0.4;
    fill.every = 0.05;
    return scene;
}

/// The points of the layer, each inside of some body or not.
class Voxels {
public:
    void fill(const Vector3d& centre, double radius) {
        const auto from = [](double low) { return static_cast<int>(std::ceil(low / cell - 0.5)); };
        for (int y = std::max(0, from(centre.y() - radius - layer[0]));
             y < high_ && at(y) + layer[0] < centre.y() + radius; ++y)
            for (int x = from(centre.x() - radius); at(x) < centre.x() + radius; ++x)
                for (int z = from(centre.z() - radius); at(z) < centre.z() + radius; ++z)
                    if ((Vector3d(at(x), at(y) + layer[0], at(z)) - centre).squaredNorm() < radius * radius)
                        solid_[static_cast<std::size_t>((y * wide_ + wrapped(x)) * wide_ + wrapped(z))] = 1;
    }
    [[nodiscard]] double voidage() const {
        std::size_t count = 0;
        for (const char one : solid_)
            count += one ? 1 : 0;
        return 1 - static_cast<double>(count) / static_cast<double>(solid_.size());
    }

private:
    static double at(int index) { return (index + 0.5) * cell; }
    [[nodiscard]] int wrapped(int index) const { return ((index % wide_) + wide_) % wide_; }

    int wide_ = static_cast<int>(std::lround(period / cell));
    int high_ = static_cast<int>(std::lround((layer[1] - layer[0]) / cell));
    std::vector<char> solid_ = std::vector<char>(static_cast<std::size_t>(wide_ * wide_ * high_), 0);
};

double voidage_of(const observe::Frame& frame) {
    Voxels voxels;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const observe::FrameShape& shape = frame.layout->shapes[static_cast<std::size_t>(frame.shape[b])];
        for (std::size_t s = 0; s < shape.centres.size(); ++s)
            voxels.fill(frame.position[b] + frame.orientation[b] * shape.centres[s], shape.radii[s]);
    }
    return voxels.voidage();
}

/// Volume of the union, m3.
Result<double> volume_of(const std::vector<scene::Sphere>& body) {
    scene::Scene scene = bed(body, 0);
    scene.fills.clear();
    const Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    return (*world)->bodies()[0].volume;
}

} // namespace

std::optional<Problem> add_packing(Walk& walk, double friction) {
    walk.head("Do cones pack closer than spheres?");
    const Result<double> volume = volume_of(cone());
    if (!volume)
        return volume.problems().front();
    const double radius = std::cbrt(3 * *volume / (4 * pi));
    walk.say(fmt::format(
        "The thesis fills its trough with media as single spheres and as clumps of 17 and 65 spheres (figure "
        "5.2) and reads off the pictures that spheres leave a high voidage, and cones pack closer. Voidage is "
        "the share of the bulk that is empty:"));
    walk.formula("ε = V_voids / (V_solids + V_voids),   ρ_bulk = ρ (1 − ε)", "(3.1), (3.4)");
    walk.say(fmt::format(
        "Here {} cones of 65 spheres, {:.4g} cm3 each, and as many spheres of the same volume, {:.3g} mm in "
        "radius, fall on a floor without sides (periodic along x and z). What is empty between {:.0f} and "
        "{:.0f} mm of height is counted on a grid of 1 mm:",
        bodies, 1e6 * *volume, 1e3 * radius, 1e3 * layer[0], 1e3 * layer[1]));
    Film film{.name = "packing",
              .title = "Spheres and cones of the same volume",
              .reels = {},
              .every = 0.02,
              .color = "vy",
              .range = {-1, 1},
              .view = scene::Box{{-period / 2, 0, -period / 2}, {period / 2, 0.11, period / 2}},
              .poster = static_cast<std::size_t>(while_they_fall / 0.02)};
    Grid grid{{{"body"}, {"μ"}, {"voidage ε", "", 3}, {"bulk density", "kg/m3", 4}}, {}};
    for (const bool spheres : {true, false}) {
        const std::string name = spheres ? "spheres" : "cones";
        const std::vector<scene::Sphere> body =
            spheres ? std::vector<scene::Sphere>{{Vector3d::Zero(), radius}} : cone();
        for (const double mu : {0.0, friction}) {
            Result<Reel> reel = lesson::film(bed(body, mu), name, settled, film.every);
            if (!reel)
                return reel.problems().front();
            const double voidage = voidage_of(reel->frames.back());
            grid.rows.push_back({name, mu, voidage, 1665.71 * (1 - voidage)});
            walk.fact(fmt::format("voidage_{}{}", name, mu > 0 ? "" : "_smooth"), voidage);
            if (mu > 0)
                film.reels.push_back(std::move(*reel));
        }
    }
    walk.parts.emplace_back(grid);
    walk.show(std::move(film));
    walk.say(fmt::format(
        "Without friction both lie closer: {:.2f} for spheres and {:.2f} for cones, with it {:.2f} and {:.2f}. More "
        "the "
        "table cannot show: the bed is {:.1f} sphere diameters wide and lies on a flat floor, which makes layers, and "
        "it "
        "is one fill. A difference between spheres and cones of one volume would need a bed several times as "
        "large and many fills. The thesis prints no figure for its voidage.",
        walk.fact("voidage_spheres_smooth"), walk.fact("voidage_cones_smooth"), walk.fact("voidage_spheres"),
        walk.fact("voidage_cones"), period / (2 * radius)));
    return std::nullopt;
}

} // namespace tumble::lesson
