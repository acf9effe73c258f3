#include "scene/faults.h"
#include "scene/keys.h"
#include "scene/resolve.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::scene {

std::filesystem::path Resolving::file(const std::string& name) const {
    const std::filesystem::path path(name);
    return (path.is_absolute() ? path : folder / path).lexically_normal();
}

bool has_volume(const Box& box) {
    return (box.lo.array() < box.hi.array()).all();
}

Vector3d direction_of(const View& view, const std::string& key, const Resolving& to) {
    const Vector3d typed = view.vector(key);
    const double length = typed.norm();
    if (std::abs(length - 1) < 1e-15)
        return typed;
    if (length > 0)
        return typed / length;
    if (view.given(key))
        to.refuse(view, key, fmt::format("'{}' has no direction", key), "give at least one value that is not 0");
    return Vector3d::UnitY();
}

Box box_of(const View& view, const std::string& lo, const std::string& hi, const Resolving& to) {
    Box box{view.vector(lo), view.vector(hi)};
    if (to.scene.dimension == 2) {
        box.lo.z() = -to.scene.depth / 2;
        box.hi.z() = to.scene.depth / 2;
    }
    return box;
}

std::string in_words(const Eigen::Vector3d& point, const Resolving& to) {
    if (to.scene.dimension == 2)
        return fmt::format("[{}, {}]", plain(point.x()), plain(point.y()));
    return fmt::format("[{}, {}, {}]", plain(point.x()), plain(point.y()), plain(point.z()));
}

namespace {

void resolve_top(const View& root, const Resolving& to) {
    Scene& scene = to.scene;
    scene.title = root.text("title");
    if (scene.title.empty())
        scene.title = scene.file.stem().string();
    scene.claim = root.text("claim");
    scene.dimension = static_cast<int>(root.integer("dimension"));
    if (scene.dimension == 2)
        scene.depth = root.given("depth_m") ? root.number("depth_m") : 1.0;
    scene.solver = root.text("solver") == "box2d" ? Solver::box2d : Solver::soft;
    scene.duration = root.number("duration_s");
    scene.time_step = root.number("time_step_s");
    if (root.given("duration_s") && root.given("time_step_s") && scene.time_step > scene.duration)
        to.refuse(root, "time_step_s",
                  fmt::format("the step of {} s is longer than the whole run of {} s", plain(scene.time_step),
                              plain(scene.duration)),
                  "shorten time_step_s or lengthen duration_s");
    scene.allow_large_step = root.flag("allow_large_step");
    scene.seed = static_cast<std::uint64_t>(root.integer("seed"));
    scene.gravity = root.vector("gravity_m_s2");
    scene.skin = root.number("skin_m");
    scene.turn_spheres = scene.dimension == 2 || root.flag("turn_spheres");
}

void resolve_domain(const View& view, const Resolving& to) {
    Domain& domain = to.scene.domain;
    if (view.given("lo_m") && view.given("hi_m"))
        domain.box = box_of(view, "lo_m", "hi_m", to);
    for (const std::string& axis : view.words("periodic"))
        domain.periodic[static_cast<std::size_t>(axis[0] - 'x')] = true;
    if (view.given("lo_m") && view.given("hi_m") && !has_volume(domain.box))
        to.refuse(view, "hi_m",
                  fmt::format("the domain from {} to {} has no volume", in_words(domain.box.lo, to),
                              in_words(domain.box.hi, to)),
                  "each value of hi_m must be above that of lo_m");
}

void resolve_contact(const View& view, const Resolving& to) {
    ContactLaws& laws = to.scene.contact;
    const std::string normal = view.text("normal");
    const std::string tangential = view.text("tangential");
    laws.normal = normal == "linear" ? NormalLaw::linear : NormalLaw::hertz;
    laws.tangential = tangential == "none"     ? TangentialLaw::none
                      : tangential == "linear" ? TangentialLaw::linear
                                               : TangentialLaw::mindlin;
    const auto rolling = std::find(words_of_rolling.begin(), words_of_rolling.end(), view.text("rolling"));
    if (rolling != words_of_rolling.end())
        laws.additions.rolling = static_cast<contact::RollingLaw>(rolling - words_of_rolling.begin());
    if (to.scene.dimension == 3) {
        const auto adhesion = std::find(words_of_adhesion.begin(), words_of_adhesion.end(), view.text("adhesion"));
        if (adhesion != words_of_adhesion.end())
            laws.additions.adhesion = static_cast<contact::AdhesionLaw>(adhesion - words_of_adhesion.begin());
    }
    laws.limit_force = view.flag("limit_force");
    laws.share_among_body_contacts = view.flag("share_among_body_contacts");
    laws.damping_shared = view.number("damping_shared");
    if (laws.share_among_body_contacts && view.written("damping_shared"))
        to.refuse(view, "damping_shared", "share_among_body_contacts = true shares all of the damping already",
                  "write one of the two");
    laws.global_damping = view.number("global_damping_per_s");
    laws.accepted_overlap = view.number("accepted_overlap");
    for (const Problem& fault : faults_of(laws, to.scene.dimension))
        to.refuse(view, view.written(fault.key) ? fault.key : "normal", fault.what, fault.fix);
}

void resolve_air(const View& root, const Resolving& to) {
    const View view = root.child("air");
    contact::Air& air = to.scene.air;
    air.density = view.number("density_kg_m3");
    air.drag_coefficient = view.number("drag_coefficient");
    const bool flat = to.scene.dimension == 2;
    if (!flat)
        air.viscosity = view.number("viscosity_Pa_s");
    if (to.scene.written.contains("air") && !view.written("density_kg_m3") && (flat || !view.written("viscosity_Pa_s")))
        to.refuse(view, "density_kg_m3",
                  flat ? "[air] drags on nothing without 'density_kg_m3'"
                       : "[air] drags on nothing without 'density_kg_m3' or 'viscosity_Pa_s'",
                  "give it, or remove [air]");
}

} // namespace

void resolve_world(const View& root, const Resolving& to) {
    resolve_top(root, to);
    resolve_domain(root.child("domain"), to);
    resolve_contact(root.child("contact"), to);
    resolve_air(root, to);
}

} // namespace tumble::scene
