#include "lab/bench.h"

#include "run/simulation.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lab {

using Eigen::Vector3d;

namespace {

/// Share of the spread of y that no straight line over x explains.
double unexplained(const std::vector<double>& x, const std::vector<double>& y) {
    const Line line = line_through(x, y);
    double mean = 0, all = 0, left = 0;
    for (const double value : y)
        mean += value / static_cast<double>(y.size());
    for (std::size_t k = 0; k < y.size(); ++k) {
        all += std::pow(y[k] - mean, 2);
        left += std::pow(y[k] - line.intercept - line.slope * x[k], 2);
    }
    return left / all;
}

} // namespace

sheet::Parameter density_parameter() {
    return {"density_kg_m3", "kg/m3", 1665.71, {.lo = 1, .hi = 30000}, "Density of the body"};
}
sheet::Parameter modulus_parameter(double standard) {
    return {"youngs_modulus_Pa", "Pa", standard, {.lo = 1e6, .hi = 1e12}, "Young's modulus of body and ground"};
}
sheet::Parameter poisson_parameter() {
    return {"poisson_ratio", "", 0.2887, {.lo = 0, .hi = 0.49}, "Poisson's ratio of both"};
}
sheet::Parameter restitution_parameter(double standard) {
    return {"restitution", "", standard, {.lo = 0.01, .hi = 1}, "Restitution that the contact law is given"};
}
sheet::Parameter friction_parameter(double standard) {
    return {"friction", "", standard, {.lo = 0, .hi = 5}, "Friction that the contact law is given"};
}
sheet::Parameter drag_parameter() {
    return {
        "drag_coefficient",
        "",
        0.44,
        {.lo = 0, .hi = 5},
        "Drag coefficient of the ball; 0.44: a sphere's at Reynolds numbers of 1e3 to 2e5 (Clift, Grace, Weber 1978)"};
}

scene::Scene bench(const contact::Material& material, const contact::PairProperties& pair, double radius,
                   double share) {
    const double shear = material.youngs_modulus / (2 * (1 + material.poisson_ratio));
    const double rayleigh =
        std::numbers::pi * radius * std::sqrt(material.density / shear) / (0.1631 * material.poisson_ratio + 0.8766);
    scene::Scene scene = scene::space_stage(material, pair, share * rayleigh);
    scene.gravity = {0, -gravity, 0};
    scene.allow_large_step = false;
    return scene;
}

scene::Wall& add_plane(scene::Scene& scene, const Vector3d& point, const Vector3d& normal) {
    return add_wall(scene, scene::WallShape(scene::PlaneShape{point, normal}));
}

std::vector<scene::Sphere> tripod(double radius) {
    std::vector<scene::Sphere> feet;
    for (const double turn : {0.0, 1.0 / 3, 2.0 / 3}) {
        const double angle = 2 * std::numbers::pi * turn;
        feet.push_back({tripod_reach * radius * Vector3d(std::cos(angle), 0, std::sin(angle)), radius});
    }
    return feet;
}

Result<Track> watch(const scene::Scene& scene, double duration, double every,
                    const std::function<bool(const Track&)>& enough) {
    Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    const auto steps = std::max<std::int64_t>(1, std::llround(every / scene.time_step));
    Track track;
    for (;;) {
        const observe::Frame frame = (*world)->frame();
        if (frame.bodies() == 0)
            return Problem{.what = "the body left the bench", .fix = "shorten the experiment, or lower its speed"};
        Seen seen{frame.time, frame.position[0], frame.velocity[0], frame.angular_velocity[0]};
        if (!frame.walls.empty()) {
            seen.wall_angle = std::atan2(frame.walls[0].rotation(1, 0), frame.walls[0].rotation(0, 0));
            seen.wall = frame.walls[0].translation;
        }
        track.push_back(seen);
        if (frame.time >= duration - 0.5 * every || (enough && enough(track)))
            return track;
        if (const auto problem = (*world)->advance(steps))
            return *problem;
    }
}

Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    const Eigen::Map<const Eigen::ArrayXd> a(x.data(), static_cast<Eigen::Index>(x.size()));
    const Eigen::Map<const Eigen::ArrayXd> b(y.data(), static_cast<Eigen::Index>(y.size()));
    const double spread = (a - a.mean()).square().sum();
    Line line;
    line.slope = ((a - a.mean()) * (b - b.mean())).sum() / spread;
    line.intercept = b.mean() - line.slope * a.mean();
    line.slope_se = n > 2 ? std::sqrt((b - line.intercept - line.slope * a).square().sum() / (n - 2) / spread) : 0.0;
    return line;
}

Slowing slowing_of(const std::vector<double>& time, const std::vector<double>& rate, const std::string& symbol) {
    struct Law {
        const char* name;
        const char* form;
        double (*straight)(double rate); // of the rate what falls along a line under this law
    };
    constexpr std::array<Law, 3> laws{{{"dry friction", "{0}' = −const", [](double one) { return one; }},
                                       {"viscous film", "{0}' ∝ −{0}", [](double one) { return std::log(one); }},
                                       {"air", "{0}' ∝ −{0}²", [](double one) { return -1 / one; }}}};
    Slowing slowing{{{{"what slows it"}, {"law"}, {"left unexplained", "", 2}}}, ""};
    double least = 2;
    for (const Law& law : laws) {
        std::vector<double> straight;
        for (const double one : rate)
            straight.push_back(law.straight(one));
        const double bend = unexplained(time, straight);
        slowing.grid.rows.push_back({law.name, fmt::format(fmt::runtime(law.form), symbol), bend});
        if (bend < least) {
            least = bend;
            slowing.best = law.name;
        }
    }
    return slowing;
}

} // namespace tumble::lab
