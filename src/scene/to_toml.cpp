#include "scene/to_toml.h"

#include "scene/specimen.h"
#include "scene/toml_writer.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::scene {
namespace {

void write_box2d(const Box2dSettings& settings, TomlWriter& to) {
    to.table("box2d", "[box2d]");
    to.number("time_step_s", settings.time_step);
    to.integer("velocity_iterations", settings.velocity_iterations);
    to.integer("position_iterations", settings.position_iterations);
    to.number("rebound_above_m_s", settings.rebound_above);
}

void write_world(const Scene& scene, TomlWriter& to) {
    to.table("", "");
    to.text("title", scene.title);
    to.text("claim", scene.claim);
    to.integer("dimension", scene.dimension);
    if (scene.dimension == 2) {
        to.number("depth_m", scene.depth);
        to.text("solver", scene.solver == Solver::box2d ? "box2d" : "soft");
    }
    to.number("duration_s", scene.duration);
    to.number("time_step_s", scene.time_step);
    to.flag("allow_large_step", scene.allow_large_step);
    to.integer("seed", static_cast<long long>(scene.seed));
    to.vector("gravity_m_s2", scene.gravity);
    to.number("skin_m", scene.skin);
    if (scene.dimension == 3)
        to.flag("turn_spheres", scene.turn_spheres);

    to.table("domain", "[domain]");
    to.vector("lo_m", scene.domain.box.lo);
    to.vector("hi_m", scene.domain.box.hi);
    std::vector<std::string> periodic;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (scene.domain.periodic[axis])
            periodic.emplace_back(1, "xyz"[axis]);
    to.words("periodic", periodic);

    to.table("contact", "[contact]");
    to.text("normal", scene.contact.normal == NormalLaw::linear ? "linear" : "hertz");
    to.text("tangential", scene.contact.tangential == TangentialLaw::none     ? "none"
                          : scene.contact.tangential == TangentialLaw::linear ? "linear"
                                                                              : "mindlin");
    to.text("rolling", words_of_rolling[static_cast<std::size_t>(scene.contact.additions.rolling)]);
    if (scene.dimension == 3)
        to.text("adhesion", words_of_adhesion[static_cast<std::size_t>(scene.contact.additions.adhesion)]);
    to.flag("limit_force", scene.contact.limit_force);
    to.number("accepted_overlap", scene.contact.accepted_overlap);
    if (scene.dimension == 2)
        to.number("global_damping_per_s", scene.contact.global_damping);
    else
        to.flag("share_among_body_contacts", scene.contact.share_among_body_contacts);
    if (scene.contact.damping_shared > 0)
        to.number("damping_shared", scene.contact.damping_shared);
    if (scene.solver == Solver::box2d)
        write_box2d(scene.box2d, to);
}

void write_air(const Scene& scene, TomlWriter& to) {
    if (!scene.air.there())
        return;
    to.table("air", "[air]");
    to.number("density_kg_m3", scene.air.density);
    to.number("drag_coefficient", scene.air.drag_coefficient);
    if (scene.dimension == 3)
        to.number("viscosity_Pa_s", scene.air.viscosity);
}

void write_additions(const contact::PairProperties& pair, const contact::Additions& additions, TomlWriter& to) {
    if (additions.rolling != contact::RollingLaw::none) {
        to.number("rolling_friction", pair.rolling_friction);
        to.number("rolling_damping", pair.rolling_damping);
    }
    if (pair.rolling_time > 0)
        to.number("rolling_time_s", pair.rolling_time);
    if (additions.adhesion == contact::AdhesionLaw::sjkr)
        to.number("cohesion_energy_J_m3", pair.cohesion_energy);
    else if (additions.adhesion != contact::AdhesionLaw::none)
        to.number("work_of_adhesion_J_m2", pair.work_of_adhesion);
    if (pair.restitution_exponent > 0) {
        to.number("restitution_exponent", pair.restitution_exponent);
        to.number("restitution_speed_m_s", pair.restitution_speed);
        to.number("restitution_most", pair.restitution_most);
    }
    if (pair.sticking_speed > 0)
        to.number("sticking_speed_m_s", pair.sticking_speed);
    if (pair.sliding_speed > 0) {
        to.number("sliding_friction", pair.sliding_friction);
        to.number("sliding_speed_m_s", pair.sliding_speed);
    }
}

void write_disc_pair(const contact::PairProperties& pair, TomlWriter& to) {
    if (pair.contact_time > 0)
        to.number("contact_time_s", pair.contact_time);
    if (pair.stiffness_ratio > 0)
        to.number("stiffness_ratio", pair.stiffness_ratio);
    to.number("cohesion_N", pair.cohesion);
}

void write_materials(const Scene& scene, TomlWriter& to) {
    for (const contact::Material& material : scene.materials) {
        to.table("material", fmt::format("[material.{}]", TomlWriter::name(material.name)));
        to.number("density_kg_m3", material.density);
        if (material.youngs_modulus == 0) // not given in two dimensions
            continue;
        to.number("youngs_modulus_Pa", material.youngs_modulus);
        to.number("poisson_ratio", material.poisson_ratio);
        to.flag("allow_soft", material.youngs_modulus < 1e6);
    }
    const int n = static_cast<int>(scene.materials.size());
    for (int a = 0; a < n; ++a)
        for (int b = a; b < n; ++b) {
            const contact::PairProperties& pair = scene.pair(a, b);
            const bool springless = pair.normal_stiffness == 0 && pair.contact_time == 0;
            if (scene.solver == Solver::soft && scene.contact.normal == NormalLaw::linear && springless)
                continue; // a pair that never meets was not given
            const auto name = [&](int i) { return scene.materials[static_cast<std::size_t>(i)].name; };
            to.table("pair", fmt::format("[pair.{}]", TomlWriter::name(name(a) + "-" + name(b))));
            if (pair.damping_time > 0)
                to.number("contact_damping_s", pair.damping_time);
            else
                to.number("restitution", pair.restitution);
            to.number("friction", pair.friction);
            if (scene.dimension == 2)
                write_disc_pair(pair, to);
            if (pair.normal_stiffness > 0)
                to.number("normal_stiffness_N_per_m", pair.normal_stiffness);
            if (pair.tangential_stiffness > 0)
                to.number("tangential_stiffness_N_per_m", pair.tangential_stiffness);
            write_additions(pair, scene.contact.additions, to);
        }
}

void write_bodies(const Scene& scene, TomlWriter& to) {
    for (const BodyTemplate& body : scene.bodies) {
        to.table("body", fmt::format("[body.{}]", TomlWriter::name(body.name)));
        to.text("material", scene.materials[static_cast<std::size_t>(body.material)].name);
        if (body.mass)
            to.number("mass_kg", *body.mass);
        const bool flat = scene.dimension == 2;
        if (body.principal_inertia && flat)
            to.number("inertia_kg_m2", body.principal_inertia->z());
        else if (body.principal_inertia)
            to.vector("inertia_kg_m2", *body.principal_inertia);
        if (body.tracer_point)
            to.vector("tracer_point_m", *body.tracer_point);
        if (body.tracer_turned != Vector3d::Zero())
            to.vector("tracer_turned_deg", body.tracer_turned);
        if (body.cone) {
            to.number("cone_diameter_m", body.cone->diameter);
            to.number("cone_height_m", body.cone->height);
        }
        std::vector<std::array<double, 4>> rows;
        for (const Sphere& sphere : body.spheres)
            if (flat)
                rows.push_back({sphere.centre.x(), sphere.centre.y(), sphere.radius, 0});
            else
                rows.push_back({sphere.centre.x(), sphere.centre.y(), sphere.centre.z(), sphere.radius});
        to.rows(flat ? "discs_m" : "spheres_m", rows, flat ? 3 : 4);
    }
    for (const Fill& fill : scene.fills) {
        to.table("fill", "[[fill]]");
        to.text("body", scene.bodies[static_cast<std::size_t>(fill.body)].name);
        if (fill.count)
            to.integer("count", *fill.count);
        if (fill.mass)
            to.number("mass_kg", *fill.mass);
        if (fill.position)
            to.vector("position_m", *fill.position);
        else {
            to.vector("region_lo_m", fill.region.lo);
            to.vector("region_hi_m", fill.region.hi);
        }
        to.text("orientation", fill.orientation == Orientation::as_written ? "as_written" : "random");
        to.vector("velocity_m_s", fill.velocity);
        if (scene.dimension == 2)
            to.number("angular_velocity_rad_s", fill.angular_velocity.z());
        else
            to.vector("angular_velocity_rad_s", fill.angular_velocity);
        to.number("start_s", fill.start);
        to.number("until_s", fill.until);
        to.number("every_s", fill.every);
    }
}

struct ShapeWriter {
    TomlWriter& to;
    int dimension;
    const MeshNames& meshes;

    void operator()(const SegmentShape& segment) const {
        to.text("shape", "segment");
        to.vector("from_m", in_space(segment.from));
        to.vector("to_m", in_space(segment.to));
    }
    void operator()(const ArcShape& arc) const {
        to.text("shape", "arc");
        to.vector("centre_m", in_space(arc.centre));
        to.number("radius_m", arc.radius);
        to.number("from_deg", arc.start);
        to.number("sweep_deg", arc.sweep);
    }
    void operator()(const PolylineShape& line) const {
        to.text("shape", "polyline");
        std::vector<std::array<double, 4>> rows;
        for (const Eigen::Vector2d& point : line.points)
            rows.push_back({point.x(), point.y(), 0, 0});
        to.rows("points_m", rows, 2);
        to.flag("closed", line.closed);
    }

    void operator()(const PlaneShape& plane) const {
        to.text("shape", "plane");
        to.vector("point_m", plane.point);
        to.vector("normal", plane.normal);
    }
    void operator()(const BoxShape& box) const {
        to.text("shape", "box");
        to.vector("lo_m", box.box.lo);
        to.vector("hi_m", box.box.hi);
        std::vector<std::string> open;
        for (std::size_t face = 0; face < 2 * static_cast<std::size_t>(dimension); ++face)
            if (box.open[face])
                open.push_back(fmt::format("{}{}", "-+"[face % 2], "xyz"[face / 2]));
        to.words("open", open);
    }
    void operator()(const CylinderShape& cylinder) const {
        to.text("shape", "cylinder");
        to.vector("base_m", cylinder.base);
        to.vector("axis", cylinder.axis);
        to.number("length_m", cylinder.length);
        to.number("radius_m", cylinder.radius);
    }
    void operator()(const DiscShape& disc) const {
        to.text("shape", "disc");
        to.vector("centre_m", disc.centre);
        to.vector("normal", disc.normal);
        to.number("radius_m", disc.radius);
        to.number("hole_radius_m", disc.hole_radius);
    }
    void operator()(const TroughShape& trough) const {
        to.text("shape", "trough");
        to.number("radius_m", trough.radius);
        to.number("floor_m", trough.floor);
        to.number("rim_m", trough.rim);
        to.number("flare_deg", trough.flare);
        if (dimension == 2)
            return;
        to.number("x_lo_m", trough.x_lo);
        to.number("x_hi_m", trough.x_hi);
    }
    void operator()(const MeshShape& mesh) const {
        to.text("shape", "mesh");
        to.text("stl", name_of(mesh.file));
        to.number("scale", mesh.scale);
    }

    void operator()(const BowlShape& bowl) const {
        to.text("shape", "bowl");
        to.vector("base_m", bowl.base);
        to.number("radius_m", bowl.radius);
        to.number("height_m", bowl.height);
        to.number("rib_start", bowl.rib_start);
        write(bowl.ribs);
    }
    void operator()(const BowlDiscShape& disc) const {
        to.text("shape", "bowl-disc");
        to.vector("centre_m", disc.centre);
        to.number("radius_m", disc.radius);
        to.number("rim_width_m", disc.rim_width);
        to.number("rim_rise_m", disc.rim_rise);
        to.number("rib_start", disc.rib_start);
        write(disc.ribs);
    }

    void operator()(const SpecimenShape& specimen) const {
        std::visit([&](const auto& part) { write(part); }, specimen.part);
        to.vector("axis", specimen.place.axis);
        if (std::holds_alternative<solid::MeshFile>(specimen.part)) {
            to.text("held_set", specimen.held_set);
        } else {
            to.vector("base_m", specimen.place.base);
            to.text("held", words_of_held[static_cast<std::size_t>(specimen.held)]);
        }
        to.number("part_youngs_modulus_Pa", specimen.youngs_modulus);
        to.number("part_poisson_ratio", specimen.poisson_ratio);
    }

private:
    [[nodiscard]] std::string name_of(const std::filesystem::path& file) const {
        if (const auto named = meshes.find(file); named != meshes.end())
            return named->second;
        std::error_code error;
        const auto path = std::filesystem::absolute(file, error);
        return (error ? file : path).string();
    }
    void write(const solid::BoredCylinder& part) const {
        to.text("shape", "bored-cylinder");
        to.number("length_m", part.length);
        to.number("radius_m", part.radius);
        to.number("bore_radius_m", part.bore_radius);
        to.number("shell_m", part.shell);
        to.integer("around", part.around);
        to.integer("along", part.along);
        to.integer("shell_rings", part.shell_rings);
        to.integer("inner_rings", part.inner_rings);
    }
    void write(const solid::MeshFile& part) const {
        to.text("shape", "hexahedra");
        to.text("inp", name_of(part.file));
        to.number("scale", part.scale);
    }
    void write(const solid::Prism& part) const {
        to.text("shape", "prism");
        to.number("length_m", part.length);
        to.number("side_m", part.side);
        to.number("corner_m", part.corner);
        to.integer("corner_cells", part.corner_cells);
        to.integer("middle_cells", part.middle_cells);
        to.integer("along", part.along);
    }
    void write(const Ribs& ribs) const {
        to.integer("rib_count", ribs.count);
        to.number("rib_height_m", ribs.height);
        to.number("rib_width_m", ribs.width);
        to.number("rib_crest_m", ribs.crest);
    }
    static Vector3d in_space(const Eigen::Vector2d& point) { return {point.x(), point.y(), 0}; }
};

void begin_motion(TomlWriter& to, const char* kind, const Active& active) {
    to.table("wall.motion", "[[wall.motion]]");
    to.text("kind", kind);
    to.number("start_s", active.start);
    if (std::isfinite(active.stop))
        to.number("stop_s", active.stop);
}

template <class Part> void write_wave(const Part& part, TomlWriter& to) {
    to.number("frequency_Hz", part.frequency);
    if (part.drift != 0)
        to.number("drift_Hz_s", part.drift);
    to.number("phase_deg", part.phase);
}

void write_turns(const WallMotion& motion, int dimension, TomlWriter& to) {
    for (const Rotation& part : motion.rotations) {
        begin_motion(to, "rotation", part.active);
        to.vector("centre_m", part.centre);
        if (dimension == 3)
            to.vector("about", part.axis);
        to.number("speed_rad_s", part.angular_velocity);
    }
    for (const Rocking& part : motion.rockings) {
        begin_motion(to, "rocking", part.active);
        to.vector("centre_m", part.centre);
        if (dimension == 3)
            to.vector("about", part.axis);
        to.number("amplitude_deg", part.amplitude);
        write_wave(part, to);
    }
}

void write_motion(const WallMotion& motion, int dimension, TomlWriter& to) {
    for (const Harmonic& part : motion.harmonics) {
        begin_motion(to, "harmonic", part.active);
        to.text("axis", std::string(1, "xyz"[part.axis]));
        to.number("amplitude_m", part.amplitude);
        write_wave(part, to);
    }
    write_turns(motion, dimension, to);
    for (const Linear& part : motion.linears) {
        begin_motion(to, "linear", part.active);
        to.vector("velocity_m_s", part.velocity);
    }
    for (const MotionTable& part : motion.tables) {
        begin_motion(to, "table", part.active);
        std::vector<std::array<double, 4>> rows;
        for (std::size_t i = 0; i < part.time.size(); ++i)
            rows.push_back(
                {part.time[i], part.displacement[i].x(), part.displacement[i].y(), part.displacement[i].z()});
        to.rows("rows", rows, static_cast<std::size_t>(dimension) + 1);
    }
}

void write_marks(const Marks& marks, TomlWriter& to) {
    to.text("arrows", marks.arrows);
    if (marks.arrow_speed)
        to.number("arrow_m_s", *marks.arrow_speed);
    to.flag("force_chains", marks.chains);
    if (marks.chain_force)
        to.number("chain_N", *marks.chain_force);
    to.words("trails", marks.trails);
}

void write_size(const Render& render, TomlWriter& to) {
    if (!render.paper) {
        to.text("style", "screen");
        to.text("background", render.background);
        to.integer("width_px", render.width);
        to.integer("height_px", render.height);
        return;
    }
    to.text("style", "paper");
    to.number("width_mm", render.paper->width_mm);
    to.number("height_mm", render.paper->height_mm);
    to.number("dpi", render.paper->dpi);
    to.number("font_pt", render.paper->font_pt);
}

void write_output(const Scene& scene, TomlWriter& to) {
    to.table("observe", "[observe]");
    to.number("every_s", scene.observe.every);
    to.words("measures", scene.observe.measures);
    to.flag("contacts", scene.observe.contacts);
    if (scene.observe.axes_turned != 0)
        to.number("axes_turned_deg", scene.observe.axes_turned);
    const Render& render = scene.render;
    to.table("render", "[render]");
    if (scene.dimension == 3) {
        to.text("camera", render.camera);
        to.text("projection", render.projection);
        if (render.eye != render.target) {
            to.vector("eye_m", render.eye);
            to.vector("target_m", render.target);
        }
        to.number("field_of_view_deg", render.field_of_view_deg);
        if (render.turn_deg_s != 0)
            to.number("turn_deg_s", render.turn_deg_s);
    }
    if (render.view) {
        to.vector("view_lo_m", render.view->lo);
        to.vector("view_hi_m", render.view->hi);
    }
    if (render.clip) {
        to.vector("clip_lo_m", render.clip->lo);
        to.vector("clip_hi_m", render.clip->hi);
    }
    if (render.clip_cuts)
        to.flag("clip_cuts", true);
    write_marks(render.marks, to);
    to.text("color", render.color);
    if (render.range)
        to.span("range", (*render.range)[0], (*render.range)[1]);
    to.text("colormap", render.colormap);
    write_size(render, to);
    to.number("every_s", render.every);
    to.number("frames_per_second", render.frames_per_second);
    to.flag("plot", render.plot);
    to.text("plot_measure", render.plot_measure);
}

} // namespace

std::string to_toml(const Scene& scene, const MeshNames& meshes) {
    TomlWriter to(scene.dimension);
    write_world(scene, to);
    write_air(scene, to);
    write_materials(scene, to);
    write_bodies(scene, to);
    for (const Wall& wall : scene.walls) {
        to.table("wall", "[[wall]]");
        to.text("name", wall.name);
        to.text("material", scene.materials[static_cast<std::size_t>(wall.material)].name);
        if (scene.dimension == 2) {
            std::visit(ShapeWriter{to, 2, meshes}, wall.outline);
        } else {
            to.number("opacity", wall.opacity);
            std::visit(ShapeWriter{to, 3, meshes}, wall.shape);
        }
        write_motion(wall.motion, scene.dimension, to);
    }
    write_output(scene, to);
    return to.result();
}

std::string to_toml(const WallMotion& motion, int dimension) {
    TomlWriter to(dimension);
    write_motion(motion, dimension, to);
    return to.result();
}

} // namespace tumble::scene
