#include "observe/measures.h"

#include "base/text.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace tumble::observe {

namespace {

std::vector<Measure> energies_of_the_frame() {
    return {
        {"kinetic_energy", "", "J", "Kinetic energy of all bodies, translation and rotation.",
         [](const Seen& s) { return s.bulk.kinetic_translation + s.bulk.kinetic_rotation; }},
        {"kinetic_translation", "kinetic", "J", "Kinetic energy of the bodies' centres of mass.",
         [](const Seen& s) { return s.bulk.kinetic_translation; }},
        {"kinetic_rotation", "kinetic", "J", "Kinetic energy of the bodies' spin.",
         [](const Seen& s) { return s.bulk.kinetic_rotation; }},
    };
}

std::vector<Measure> shape_of_the_bulk() {
    return {
        {"centre_of_mass_x", "centre_of_mass", "m",
         "Centre of mass of all bodies, x (meaningless where x is periodic).",
         [](const Seen& s) { return s.bulk.centre.x(); }},
        {"centre_of_mass_y", "centre_of_mass", "m", "Centre of mass of all bodies, height.",
         [](const Seen& s) { return s.bulk.centre.y(); }},
        {"centre_of_mass_z", "centre_of_mass", "m", "Centre of mass of all bodies, z.",
         [](const Seen& s) { return s.bulk.centre.z(); }},
        {"bulk_height", "", "m", "Median height of the free surface above the lowest point of the bulk.",
         [](const Seen& s) { return bulk_height(s.surface); }},
        {"surface_slope", "", "deg",
         "Angle of the free surface to the horizontal in the y-z plane, positive where it rises with z; in two "
         "dimensions "
         "x stands for z.",
         [](const Seen& s) { return surface_slope(s.surface); }},
        {"surface_slope_left", "surface_slopes", "deg", "Slope of the half of the free surface with the smaller z.",
         [](const Seen& s) { return surface_slope_left(s.surface); }},
        {"surface_slope_right", "surface_slopes", "deg", "Slope of the half of the free surface with the larger z.",
         [](const Seen& s) { return surface_slope_right(s.surface); }},
    };
}

std::vector<Measure> motion_of_the_bulk() {
    return {
        {"circulation", "", "rad_s",
         "Rate at which the bulk turns about its centre in the y-z plane, positive from y towards z; in two dimensions "
         "positive from x towards y.",
         [](const Seen& s) { return s.bulk.circulation; }},
        {"mean_speed", "", "m_s", "Mass-weighted mean speed of the bodies' centres.",
         [](const Seen& s) { return s.bulk.mean_speed; }},
        {"rms_velocity_x", "rms_velocity", "m_s", "Root of the mass-weighted mean square velocity along x.",
         [](const Seen& s) { return s.bulk.rms_velocity.x(); }},
        {"rms_velocity_y", "rms_velocity", "m_s", "Root of the mass-weighted mean square velocity along y.",
         [](const Seen& s) { return s.bulk.rms_velocity.y(); }},
        {"rms_velocity_z", "rms_velocity", "m_s", "Root of the mass-weighted mean square velocity along z.",
         [](const Seen& s) { return s.bulk.rms_velocity.z(); }},
        {"mean_angular_speed", "", "rad_s", "Mass-weighted mean of how fast the bodies spin.",
         [](const Seen& s) { return s.bulk.mean_angular_speed; }},
        {"speed_max", "", "m_s", "Speed of the fastest body.", [](const Seen& s) { return s.books.speed_max; }},
        {"angular_speed_max", "", "rad_s", "Spin of the fastest turning body.",
         [](const Seen& s) { return s.books.angular_speed_max; }},
    };
}

std::vector<Measure> contacts_of_the_solver() {
    return {
        {"bodies", "", "", "Number of bodies.", [](const Seen& s) { return static_cast<double>(s.books.bodies); }},
        {"contacts", "", "", "Touching sphere pairs, walls included.",
         [](const Seen& s) { return static_cast<double>(s.books.contacts); }},
        {"contacts_per_body", "", "", "Touching sphere pairs, walls included, over bodies.",
         [](const Seen& s) {
             return s.books.bodies > 0 ? static_cast<double>(s.books.contacts) / static_cast<double>(s.books.bodies)
                                       : std::numeric_limits<double>::quiet_NaN();
         }},
        {"overlap_max", "", "m", "Deepest overlap of two touching surfaces.",
         [](const Seen& s) { return s.books.overlap_max; }},
        {"overlap_ratio_max", "", "", "Deepest overlap over the radius of the smaller sphere.",
         [](const Seen& s) { return s.books.overlap_ratio_max; }},
    };
}

/// Not a number where the solver cannot tell its losses apart and closes its balance with them.
double if_split(const Seen& s, double value) {
    return s.books.splits_losses ? value : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Measure> books_of_the_solver() {
    return {
        {"gravity_energy", "energies", "J", "Potential energy in gravity, relative to the origin.",
         [](const Seen& s) { return s.books.gravity; }},
        {"stored_normal", "energies", "J", "Elastic energy in contacts, normal.",
         [](const Seen& s) { return s.books.stored_normal; }},
        {"stored_tangential", "energies", "J", "Elastic energy in contacts, tangential.",
         [](const Seen& s) { return s.books.stored_tangential; }},
        {"stored_rolling", "energies", "J", "Elastic energy in contacts, rolling.",
         [](const Seen& s) { return s.books.stored_rolling; }},
        {"lost_normal_damping", "energies", "J", "Energy lost so far to damping of normal motion.",
         [](const Seen& s) { return if_split(s, s.books.lost_normal_damping); }},
        {"lost_tangential_damping", "energies", "J", "Energy lost so far to damping of tangential motion.",
         [](const Seen& s) { return if_split(s, s.books.lost_tangential_damping); }},
        {"lost_sliding", "energies", "J", "Energy lost so far to sliding friction.",
         [](const Seen& s) { return if_split(s, s.books.lost_sliding); }},
        {"lost_rolling", "energies", "J", "Energy lost so far to resistance against rolling.",
         [](const Seen& s) { return if_split(s, s.books.lost_rolling); }},
        {"lost_history", "energies", "J", "Spring energy that the law dropped so far with its contact histories.",
         [](const Seen& s) { return if_split(s, s.books.lost_history); }},
        {"lost_global_damping", "energies", "J",
         "Energy lost so far to the mass-proportional damping of bodies (two dimensions).",
         [](const Seen& s) { return if_split(s, s.books.lost_global_damping); }},
        {"lost_air_drag", "energies", "J", "Energy lost so far to the drag of air.",
         [](const Seen& s) { return if_split(s, s.books.lost_air_drag); }},
        {"lost_adhesion", "energies", "J", "Energy lost so far with necks of adhesion that tore.",
         [](const Seen& s) { return if_split(s, s.books.lost_adhesion); }},
        {"lost_energy", "", "J",
         "Energy lost so far, all losses together; with solver = \"box2d\" what the balance lacks.",
         [](const Seen& s) { return lost_of(s.books); }},
        {"wall_work", "energies", "J", "Work done so far by walls on bodies.",
         [](const Seen& s) { return s.books.wall_work; }},
        {"inserted_energy", "energies", "J", "Energy that came so far with inserted bodies.",
         [](const Seen& s) { return s.books.inserted; }},
        {"energy_closure", "", "J",
         "What the energy balance misses: everything there and lost, less everything put in.",
         [](const Seen& s) { return if_split(s, s.books.closure); }},
    };
}

std::vector<Measure> collect() {
    std::vector<Measure> all;
    for (auto part :
         {energies_of_the_frame, shape_of_the_bulk, motion_of_the_bulk, contacts_of_the_solver, books_of_the_solver}) {
        const std::vector<Measure> some = part();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

} // namespace

Seen::Seen(const Frame& frame_, const Books& books_, double axes_turned)
    : frame(frame_), books(books_), bulk(bulk_motion(frame_)), surface(free_surface(frame_)) {
    if (axes_turned != 0)
        bulk.centre = Eigen::AngleAxisd(-axes_turned, Eigen::Vector3d::UnitZ()) * bulk.centre;
}

std::string Measure::column() const {
    return unit.empty() ? name : name + "_" + unit;
}

std::string spelled_name(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string spelled_unit(const std::string& unit) {
    const std::size_t per = unit.find("_s");
    return per == std::string::npos ? unit : unit.substr(0, per) + "/" + unit.substr(per + 1);
}

const std::vector<Measure>& all_measures() {
    static const std::vector<Measure> all = collect();
    return all;
}

std::vector<std::string> measure_names() {
    std::vector<std::string> names;
    for (const Measure& measure : all_measures())
        for (const std::string& name : {measure.group, measure.name})
            if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
    return names;
}

std::vector<std::string> usual_measures() {
    return {"kinetic_energy", "kinetic",           "centre_of_mass", "circulation", "surface_slope", "surface_slopes",
            "bulk_height",    "overlap_ratio_max", "contacts",       "speed_max",   "wall_work",     "overlap_max",
            "bodies",         "energy_closure"};
}

Result<std::vector<Measure>> choose_measures(const std::vector<std::string>& names) {
    std::vector<Measure> chosen;
    Problems problems;
    const std::vector<std::string> known = measure_names();
    for (const std::string& name : names.empty() ? usual_measures() : names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            const std::string guess = did_you_mean(name, known);
            problems.push_back(
                {.key = "observe.measures",
                 .what = "there is no measure '" + name + "'",
                 .fix = (guess.empty() ? "" : guess + " ") + "`tumble list measures` names all of them"});
            continue;
        }
        for (const Measure& measure : all_measures()) {
            const bool wanted = measure.name == name || measure.group == name;
            const auto same = [&](const Measure& other) { return other.name == measure.name; };
            if (wanted && std::none_of(chosen.begin(), chosen.end(), same))
                chosen.push_back(measure);
        }
    }
    if (!problems.empty())
        return problems;
    return chosen;
}

} // namespace tumble::observe
