#include "lesson/packing.h"

#include "lesson/stage.h"
#include "run/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;
constexpr double cell = 1e-3;            // m, of the points that are counted
constexpr double while_they_fall = 0.16; // s, when velocities have something to tell
constexpr double dt = 2e-5;              // s
constexpr double narrow = 10;            // sphere diameters: below it sides and floor matter
constexpr double usual_solids = 0.6;     // share of a bed; only says about how high it will lie

/// A bed without sides (periodic along x and z), and the layer of it where voidage is counted: a quarter of its height
/// above the floor, three tenths below the surface.
struct Bed {
    double width = 0; // m
    int bodies = 0;
    double volume = 0; // m3, of a body

    [[nodiscard]] double height() const { return bodies * volume / (usual_solids * width * width); }
    [[nodiscard]] double low() const { return std::floor(0.25 * height() / cell) * cell; }
    [[nodiscard]] double high() const { return std::floor(0.7 * height() / cell) * cell; }
    /// Bodies come in from so far up, and for so long.
    [[nodiscard]] double above() const { return std::max(0.28, 3.6 * height()); }
    [[nodiscard]] double poured() const { return std::max(0.4, 5.2 * height()); }
    [[nodiscard]] double settled() const { return 2 * poured(); }
};

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
scene::Scene filled(const Bed& bed, const std::vector<scene::Sphere>& body, double friction, int seed) {
    contact::PairProperties pair;
    pair.restitution = 0.667;
    pair.friction = friction;
    scene::Scene scene = space_stage({"media", 1665.71, 1e7, 0.2887}, pair, dt);
    scene.gravity = {0, -9.81, 0};
    scene.seed = static_cast<std::uint64_t>(seed);
    const double half = bed.width / 2;
    scene.domain.box = {{-half, -0.01, -half}, {half, bed.above() + 0.02, half}};
    scene.domain.periodic = {true, false, true};
    add_body(scene, body);
    add_wall(scene, scene::WallShape(scene::PlaneShape{}));
    scene::Fill& fill = scene.fills.emplace_back();
    fill.count = bed.bodies;
    fill.region = {{-half, 0, -half}, {half, bed.above(), half}};
    fill.velocity = {0, -0.5, 0};
    fill.until = bed.poured();
    fill.every = 0.05;
    return scene;
}

/// The points of the layer, each inside of some body or not.
class Voxels {
public:
    explicit Voxels(const Bed& bed)
        : low_(bed.low()), wide_(static_cast<int>(std::lround(bed.width / cell))),
          high_(static_cast<int>(std::lround((bed.high() - bed.low()) / cell))),
          solid_(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(wide_ * high_), 0) {}

    void fill(const Vector3d& centre, double radius) {
        const auto from = [](double low) { return static_cast<int>(std::ceil(low / cell - 0.5)); };
        for (int y = std::max(0, from(centre.y() - radius - low_)); y < high_ && at(y) + low_ < centre.y() + radius;
             ++y)
            for (int x = from(centre.x() - radius); at(x) < centre.x() + radius; ++x)
                for (int z = from(centre.z() - radius); at(z) < centre.z() + radius; ++z)
                    if ((Vector3d(at(x), at(y) + low_, at(z)) - centre).squaredNorm() < radius * radius)
                        solid_[static_cast<std::size_t>((y * wide_ + wrapped(x)) * wide_ + wrapped(z))] = 1;
    }
    [[nodiscard]] double voidage() const {
        return 1 -
               static_cast<double>(std::count(solid_.begin(), solid_.end(), 1)) / static_cast<double>(solid_.size());
    }

private:
    static double at(int index) { return (index + 0.5) * cell; }
    [[nodiscard]] int wrapped(int index) const { return ((index % wide_) + wide_) % wide_; }

    double low_; // m
    int wide_, high_;
    std::vector<char> solid_;
};

double voidage_of(const observe::Frame& frame, const Bed& bed) {
    Voxels voxels(bed);
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const observe::FrameShape& shape = frame.layout->shapes[static_cast<std::size_t>(frame.shape[b])];
        for (std::size_t s = 0; s < shape.centres.size(); ++s)
            voxels.fill(frame.position[b] + frame.orientation[b] * shape.centres[s], shape.radii[s]);
    }
    return voxels.voidage();
}

/// Volume of the union, m3.
Result<double> volume_of(const std::vector<scene::Sphere>& body) {
    scene::Scene scene = filled({0.06, 1, 1e-6}, body, 0, 1);
    scene.fills.clear();
    const Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    return (*world)->bodies()[0].volume;
}

/// Mean and standard deviation; of one value the latter is 0.
std::array<double, 2> spread(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double mean = 0, square = 0;
    for (const double value : values)
        mean += value / count;
    for (const double value : values)
        square += (value - mean) * (value - mean);
    return {mean, values.size() > 1 ? std::sqrt(square / (count - 1)) : 0};
}

} // namespace

std::optional<Problem> add_packing(Walk& walk, const Packing& packing) {
    walk.head("Do cones pack closer than spheres?");
    const Result<double> volume = volume_of(cone());
    if (!volume)
        return volume.problems().front();
    const Bed bed{packing.width, packing.bodies, *volume};
    const double radius = std::cbrt(3 * *volume / (4 * pi));
    walk.say(fmt::format(
        "The thesis fills its trough with media as single spheres and as clumps of 17 and 65 spheres (figure "
        "5.2) and reads off the pictures that spheres leave a high voidage, and cones pack closer. Voidage is "
        "the share of the bulk that is empty:"));
    walk.formula("ε = V_voids / (V_solids + V_voids),   ρ_bulk = ρ (1 − ε)", "(3.1), (3.4)");
    walk.say(fmt::format(
        "Here {} cones of 65 spheres, {:.4g} cm3 each, and as many spheres of the same volume, {:.3g} mm in "
        "radius, fall on a floor without sides (periodic along x and z), {:.3g} sphere diameters wide. What is empty "
        "between "
        "{:.0f} and {:.0f} mm of height is counted on a grid of 1 mm:",
        bed.bodies, 1e6 * *volume, 1e3 * radius, bed.width / (2 * radius), 1e3 * bed.low(), 1e3 * bed.high()));
    Film film{.name = "packing",
              .title = "Spheres and cones of the same volume",
              .reels = {},
              .every = 0.02,
              .color = "vy",
              .range = {-1, 1},
              .view =
                  scene::Box{{-bed.width / 2, 0, -bed.width / 2}, {bed.width / 2, 1.4 * bed.height(), bed.width / 2}},
              .poster = static_cast<std::size_t>(while_they_fall / 0.02)};
    Grid grid{{{"body"}, {"μ"}, {"voidage ε", "", 3}, {"± between fills", "", 2}, {"bulk density", "kg/m3", 4}}, {}};
    for (const bool spheres : {true, false}) {
        const std::string name = spheres ? "spheres" : "cones";
        const std::vector<scene::Sphere> body =
            spheres ? std::vector<scene::Sphere>{{Vector3d::Zero(), radius}} : cone();
        for (const double mu : {0.0, packing.friction}) {
            std::vector<double> voidages;
            for (int seed = 1; seed <= packing.fills; ++seed) {
                Result<Reel> reel = lesson::film(filled(bed, body, mu, seed), name, bed.settled(), film.every);
                if (!reel)
                    return reel.problems().front();
                voidages.push_back(voidage_of(reel->frames.back(), bed));
                if (mu > 0 && seed == 1)
                    film.reels.push_back(std::move(*reel));
            }
            const auto [voidage, scatter] = spread(voidages);
            grid.rows.push_back(
                {name, mu, voidage, packing.fills > 1 ? Cell(scatter) : Cell("-"), 1665.71 * (1 - voidage)});
            walk.fact(fmt::format("voidage_{}{}", name, mu > 0 ? "" : "_smooth"), voidage);
        }
    }
    walk.parts.emplace_back(grid);
    walk.show(std::move(film));
    walk.say(fmt::format(
        "Without friction both lie closer: {:.2f} for spheres and {:.2f} for cones, with it {:.2f} and {:.2f}.{}",
        walk.fact("voidage_spheres_smooth"), walk.fact("voidage_cones_smooth"), walk.fact("voidage_spheres"),
        walk.fact("voidage_cones"),
        bed.width < narrow * 2 * radius ? " A bed as narrow as this lies in layers on its flat floor, and is one fill: "
                                          "what it says of spheres and cones "
                                          "is not yet an answer."
                                        : ""));
    walk.say("LARGE_BED");
    return std::nullopt;
}

} // namespace tumble::lesson
