#include "run/scene_doubts.h"

#include "run/fill_plan.h"
#include "scene/extent.h"
#include "scene/written.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace tumble::run {

namespace {

using Eigen::Vector3d;

// What lies beyond these is rare in machines, while a value typed in the wrong unit lies far beyond.
constexpr double lightest = 25;       // kg/m3, expanded polystyrene; every solid is below that in g/cm3
constexpr double heaviest = 22600;    // kg/m3, osmium
constexpr double strong_gravity = 50; // m/s2, twice Jupiter's
constexpr double fast_shaking = 10;   // m/s; electrodynamic shakers end at 2 to 3 m/s
constexpr double fast_wall = 150;     // m/s; the hammers of hammer mills reach 120 m/s
constexpr double vast_wall = 20;      // times the domain

class Doubts {
public:
    Doubts(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies) : scene_(scene), bodies_(bodies) {}

    std::vector<std::string> all() {
        densities();
        gravity();
        fills();
        crowd();
        if (scene_.solver == scene::Solver::box2d)
            keys_without_springs();
        else
            keys_of_box2d();
        bowls();
        for (const scene::Wall& wall : scene_.walls) {
            size_of(wall);
            motion_of(wall);
        }
        return std::move(found_);
    }

private:
    void say(const std::string& key, std::string what, std::string fix) {
        found_.push_back(to_string(scene::problem_about(scene_, key, std::move(what), std::move(fix))));
    }

    void densities() {
        std::set<int> seen;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const scene::BodyTemplate& body = scene_.bodies[i];
            const contact::Material& material = scene_.materials[static_cast<std::size_t>(body.material)];
            if (body.mass)
                mass_of(bodies_[i]);
            else if (material.density < lightest && seen.insert(body.material).second)
                say("material." + material.name + ".density_kg_m3",
                    fmt::format("{:.4g} kg/m3 is lighter than plastic foam", material.density),
                    fmt::format("if it is {0:.4g} g/cm3, write {1:.6g}", material.density, 1e3 * material.density));
        }
    }

    void mass_of(const SimulatedBody& shape) {
        const double density = shape.mass / shape.volume;
        if (density < lightest || density > heaviest)
            say("body." + shape.name + ".mass_kg",
                fmt::format("{:.4g} kg in the {:.4g} mm3 of body '{}' is {:.3g} kg/m3, {}", shape.mass,
                            1e9 * shape.volume, shape.name, density,
                            density < lightest ? "lighter than plastic foam" : "denser than any solid"),
                "write the mass in kg, or look at the size of its spheres");
    }

    void gravity() {
        const double g = scene_.gravity.norm();
        if (g > strong_gravity)
            say("gravity_m_s2", fmt::format("a gravity of {:.4g} m/s2 is {:.3g} times the Earth's", g, g / 9.81),
                "the Earth's is [0, -9.81, 0]; a centrifuge may ignore this");
    }

    void fills() {
        const std::vector<std::int64_t> wanted = bodies_wanted(scene_, bodies_);
        for (std::size_t f = 0; f < scene_.fills.size(); ++f) {
            const scene::Fill& fill = scene_.fills[f];
            if (fill.start >= scene_.duration)
                say(fmt::format("fill.{}.start_s", f),
                    fmt::format("{} of body '{}' come at {:.6g} s, but the run ends at {:.6g} s", wanted[f],
                                bodies_[static_cast<std::size_t>(fill.body)].name, fill.start, scene_.duration),
                    "lengthen duration_s, or give an earlier start_s");
        }
    }

    /// Discs of rotary bowls that do not fit into their bowl.
    void bowls() {
        double smallest = std::numeric_limits<double>::infinity(); // body, m
        for (const SimulatedBody& body : bodies_)
            smallest = std::min(smallest, 2 * std::cbrt(body.volume * 3 / (4 * std::numbers::pi)));
        for (const scene::Wall& outer : scene_.walls)
            for (const scene::Wall& inner : scene_.walls) {
                const auto* bowl = std::get_if<scene::BowlShape>(&outer.shape);
                const auto* disc = std::get_if<scene::BowlDiscShape>(&inner.shape);
                if (bowl && disc)
                    disc_in_bowl(outer.name, *bowl, inner.name, *disc, smallest);
            }
    }

    void disc_in_bowl(const std::string& outer, const scene::BowlShape& bowl, const std::string& inner,
                      const scene::BowlDiscShape& disc, double smallest) {
        const double gap = bowl.radius - disc.radius;
        if (gap <= 0)
            say("wall." + inner + ".radius_m",
                fmt::format("disc '{}' reaches through the wall of bowl '{}', whose radius is {:.4g} m", inner, outer,
                            bowl.radius),
                "the disc turns within the bowl: leave a gap of a few millimetres");
        else if (gap > smallest)
            say("wall." + inner + ".radius_m",
                fmt::format("between disc '{}' and bowl '{}' is a gap of {:.3g} mm, through which bodies of {:.3g} mm "
                            "fall",
                            inner, outer, 1e3 * gap, 1e3 * smallest),
                fmt::format("a radius of more than {:.4g} m", bowl.radius - smallest));
        if (disc.centre.y() + disc.rim_rise > bowl.base.y() + bowl.height)
            say("wall." + inner + ".rim_rise_m",
                fmt::format("the rim of disc '{}' ends {:.3g} mm above the wall of bowl '{}'", inner,
                            1e3 * (disc.centre.y() + disc.rim_rise - bowl.base.y() - bowl.height), outer),
                "a rim of some tens of millimetres ends well within the wall");
    }

    /// More than the domain holds; what leaves it ends the run.
    void crowd() {
        const std::vector<std::int64_t> wanted = bodies_wanted(scene_, bodies_);
        double solids = 0;
        for (std::size_t f = 0; f < scene_.fills.size(); ++f)
            solids += static_cast<double>(wanted[f]) * bodies_[static_cast<std::size_t>(scene_.fills[f].body)].volume;
        const Vector3d size = scene_.domain.box.hi - scene_.domain.box.lo;
        const double room = scene_.dimension == 2 ? size.x() * size.y() * scene_.depth : size.prod();
        if (solids > room)
            say("fill",
                fmt::format("the bodies have {:.3g} times the volume of the domain, and cannot all be in it",
                            solids / room),
                "fewer or smaller bodies, or a larger domain");
    }

    /// What was written for Box2D, which does not solve this.
    void keys_of_box2d() {
        for (const auto& [path, place] : scene_.written)
            if (path.starts_with("box2d."))
                return say(path, "solver = \"soft\" reads nothing of [box2d]",
                           "write solver = \"box2d\", or leave it away");
    }

    /// What was written for springs and dashpots, and Box2D has no use for.
    void keys_without_springs() {
        static const std::map<std::string, std::set<std::string>> unread{
            {"", {"skin_m"}},
            {"air", {"density_kg_m3", "drag_coefficient", "viscosity_Pa_s"}},
            {"contact", {"normal", "tangential", "limit_force", "rolling", "adhesion"}},
            {"material", {"youngs_modulus_Pa", "poisson_ratio"}},
            {"pair",
             {"normal_stiffness_N_per_m", "contact_time_s", "tangential_stiffness_N_per_m", "stiffness_ratio",
              "cohesion_N", "rolling_friction", "rolling_damping", "rolling_time_s", "restitution_speed_m_s",
              "restitution_most", "sticking_speed_m_s", "sliding_friction", "sliding_speed_m_s", "cohesion_energy_J_m3",
              "work_of_adhesion_J_m2"}}};
        std::set<std::string> seen;
        for (const auto& [path, place] : scene_.written) {
            const auto dot = path.find('.'), last = path.rfind('.');
            const auto table = unread.find(dot == std::string::npos ? "" : path.substr(0, dot));
            const std::string key = last == std::string::npos ? path : path.substr(last + 1);
            if (table != unread.end() && table->second.contains(key))
                seen.insert(key);
        }
        if (!seen.empty())
            say("solver",
                fmt::format("solver = \"box2d\" does not read {}: its contacts are hard, without spring or dashpot",
                            fmt::join(seen, ", ")),
                "docs/hard-contacts.md says what it goes by; solver = \"soft\" reads them");
    }

    void size_of(const scene::Wall& wall) {
        const bool can_be_vast = scene_.dimension == 2 || std::holds_alternative<scene::CylinderShape>(wall.shape) ||
                                 std::holds_alternative<scene::DiscShape>(wall.shape) ||
                                 std::holds_alternative<scene::BowlShape>(wall.shape) ||
                                 std::holds_alternative<scene::BowlDiscShape>(wall.shape) ||
                                 std::holds_alternative<scene::MeshShape>(wall.shape);
        const scene::Box extent = scene::extent_of(wall, scene_.dimension);
        const double size = (extent.hi - extent.lo).maxCoeff();
        const double room = (scene_.domain.box.hi - scene_.domain.box.lo).maxCoeff();
        if (can_be_vast && size > vast_wall * room)
            say("wall." + wall.name,
                fmt::format("wall '{}' is {:.4g} m large, {:.3g} times the domain", wall.name, size, size / room),
                std::holds_alternative<scene::MeshShape>(wall.shape) ? "an STL in millimetres wants scale = 0.001"
                                                                     : "its lengths are in metres: 60 mm are 0.06");
    }

    void motion_of(const scene::Wall& wall) {
        const scene::Box& domain = scene_.domain.box;
        Vector3d amplitude = Vector3d::Zero();
        Vector3d shaking = Vector3d::Zero();
        for (const scene::Harmonic& part : wall.motion.harmonics) {
            amplitude[part.axis] += part.amplitude;
            shaking[part.axis] += part.amplitude * 2 * std::numbers::pi * part.frequency;
        }
        const Vector3d size = domain.hi - domain.lo;
        const double speed = scene::speed_bound(wall.motion, (domain.lo + domain.hi) / 2, size.norm() / 2);
        for (int k = 0; k < scene_.dimension; ++k)
            if (!scene_.domain.periodic[static_cast<std::size_t>(k)] && amplitude[k] > size[k])
                return say("wall." + wall.name,
                           fmt::format("wall '{}' swings by {:.4g} m along {}, and the domain is {:.4g} m long",
                                       wall.name, amplitude[k], "xyz"[k], size[k]),
                           "amplitudes are in metres: 3 mm are 0.003");
        if (shaking.norm() > fast_shaking)
            return say("wall." + wall.name,
                       fmt::format("wall '{}' is shaken at up to {:.4g} m/s", wall.name, shaking.norm()),
                       "amplitudes are in metres, frequencies in Hz: 3 mm are 0.003, 1500 a minute are 25");
        if (speed > fast_wall)
            say("wall." + wall.name, fmt::format("wall '{}' moves at up to {:.4g} m/s", wall.name, speed),
                "look at the units of its motion");
    }

    const scene::Scene& scene_;
    const std::vector<SimulatedBody>& bodies_;
    std::vector<std::string> found_;
};

} // namespace

std::vector<std::string> scene_doubts(const scene::Scene& scene, const std::vector<SimulatedBody>& bodies) {
    return Doubts(scene, bodies).all();
}

} // namespace tumble::run
