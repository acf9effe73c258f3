#include "scene/keys.h"
#include "scene/resolve.h"

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

std::string in_words(const Eigen::Vector3d& point) {
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
    if (root.given("dimension") && scene.dimension == 2)
        to.refuse(root, "dimension", "scenes in two dimensions cannot be run yet",
                  "write dimension = 3, or remove the key; spheres with all centres in one plane move like discs");
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
}

void resolve_domain(const View& view, const Resolving& to) {
    Domain& domain = to.scene.domain;
    domain.box = {view.vector("lo_m"), view.vector("hi_m")};
    for (const std::string& axis : view.words("periodic"))
        domain.periodic[static_cast<std::size_t>(axis[0] - 'x')] = true;
    if (view.given("lo_m") && view.given("hi_m") && !has_volume(domain.box))
        to.refuse(
            view, "hi_m",
            fmt::format("the domain from {} to {} has no volume", in_words(domain.box.lo), in_words(domain.box.hi)),
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
    laws.limit_force = view.flag("limit_force");
    laws.share_among_body_contacts = view.flag("share_among_body_contacts");
    laws.accepted_overlap = view.number("accepted_overlap");
    if (laws.normal == NormalLaw::linear && laws.tangential == TangentialLaw::mindlin)
        to.refuse(view, view.written("tangential") ? "tangential" : "normal",
                  "normal = \"linear\" does not go with tangential = \"mindlin\", whose stiffness is Hertz'",
                  "write tangential = \"linear\" or \"none\", or normal = \"hertz\"");
}

} // namespace

void resolve_world(const View& root, const Resolving& to) {
    resolve_top(root, to);
    resolve_domain(root.child("domain"), to);
    resolve_contact(root.child("contact"), to);
}

} // namespace tumble::scene
