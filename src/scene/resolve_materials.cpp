#include "base/text.h"
#include "scene/keys.h"
#include "scene/resolve.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>

namespace tumble::scene {
namespace {

bool is_plain_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
}

std::vector<std::string> material_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const contact::Material& material : scene.materials)
        names.push_back(material.name);
    return names;
}

std::optional<int> index_of(const Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (scene.materials[i].name == name)
            return static_cast<int>(i);
    return std::nullopt;
}

/// "did you mean 'lining'?", or the names there are.
std::string suggest_material(const std::string& name, const Scene& scene) {
    const auto names = material_names(scene);
    const std::string meant = did_you_mean(name, names);
    return meant.empty() ? fmt::format("the materials are {}", fmt::join(names, ", ")) : meant;
}

/// One of two keys, and not both; neither only when no law asks for it.
void check_either(const View& view, const Resolving& to, const std::string& one, const std::string& other,
                  const std::string& needed_by) {
    if (view.written(one) && view.written(other))
        to.refuse(view, other, fmt::format("{} has '{}' and '{}'", view.title(), one, other), "give one of them");
    else if (!needed_by.empty() && !view.written(one) && !view.written(other))
        to.refuse(view, one,
                  fmt::format("{} has neither '{}' nor '{}', and {} needs one", view.title(), one, other, needed_by),
                  "add one of them");
}

/// The linear law's keys in two dimensions; docs/theory-2d.md.
void resolve_disc_pair(const View& view, const Resolving& to, contact::PairProperties& pair) {
    const ContactLaws& laws = to.scene.contact;
    const bool springs = to.scene.solver == Solver::soft;
    if (view.given("contact_damping_s"))
        pair.restitution = 1;
    pair.contact_time = view.number("contact_time_s");
    pair.stiffness_ratio = view.number("stiffness_ratio");
    pair.damping_time = view.number("contact_damping_s");
    pair.cohesion = view.number("cohesion_N");
    check_either(view, to, "normal_stiffness_N_per_m", "contact_time_s",
                 springs && laws.normal == NormalLaw::linear ? "normal = \"linear\"" : "");
    check_either(view, to, "tangential_stiffness_N_per_m", "stiffness_ratio",
                 springs && laws.tangential == TangentialLaw::linear ? "tangential = \"linear\"" : "");
    if (!springs && view.written("contact_damping_s"))
        to.refuse(view, "contact_damping_s",
                  "'contact_damping_s' is a share of a spring, and the contacts of solver = \"box2d\" have none",
                  "give restitution, or write solver = \"soft\"");
    if (view.written("contact_damping_s") && view.written("contact_time_s"))
        to.refuse(view, "contact_time_s", "'contact_time_s' follows from restitution, not from 'contact_damping_s'",
                  "give normal_stiffness_N_per_m, or restitution in place of contact_damping_s");
    if (laws.normal == NormalLaw::linear)
        return;
    for (const char* key : {"contact_damping_s", "cohesion_N"})
        if (view.written(key))
            to.refuse(view, key, fmt::format("'{}' belongs to the linear law", key),
                      "remove it, or write normal = \"linear\" in [contact]");
}

void resolve_pair(const NamedView& named, const Resolving& to, std::map<std::pair<int, int>, std::string>& seen) {
    Scene& scene = to.scene;
    const View& view = named.view;
    const auto dash = named.name.find('-');
    if (dash == std::string::npos) {
        to.report.add(named.place, view.path(),
                      fmt::format("'{}' names one material, a pair needs two", excerpt(named.name)),
                      fmt::format("write [pair.{0}-{0}], or another second name", named.name));
        return;
    }
    const std::string names[2] = {named.name.substr(0, dash), named.name.substr(dash + 1)};
    std::optional<int> index[2];
    for (int i = 0; i < 2; ++i) {
        index[i] = index_of(scene, names[i]);
        if (!index[i])
            to.report.add(named.place, view.path(), fmt::format("{} names no material '{}'", view.title(), names[i]),
                          suggest_material(names[i], scene));
    }
    if (!index[0] || !index[1])
        return;
    const auto [first, second] = std::minmax(*index[0], *index[1]);
    const auto [other, is_new] = seen.insert({{first, second}, named.name});
    if (!is_new)
        to.report.add(named.place, view.path(), fmt::format("{} repeats [pair.{}]", view.title(), other->second),
                      "the order of the names does not matter; keep one of them");

    contact::PairProperties pair;
    pair.restitution = view.number("restitution");
    pair.friction =
        view.given("friction_angle_deg") ? std::tan(view.number("friction_angle_deg")) : view.number("friction");
    pair.normal_stiffness = view.number("normal_stiffness_N_per_m");
    pair.tangential_stiffness = view.number("tangential_stiffness_N_per_m");
    if (scene.dimension == 2)
        resolve_disc_pair(view, to, pair);
    else if (scene.contact.normal == NormalLaw::linear && !view.written("normal_stiffness_N_per_m"))
        to.refuse(view, "normal_stiffness_N_per_m",
                  fmt::format("{} has no 'normal_stiffness_N_per_m', which normal = \"linear\" needs", view.title()),
                  "add it, a number in N/m above 0");
    if (scene.dimension == 3 && scene.contact.tangential == TangentialLaw::linear &&
        !view.written("tangential_stiffness_N_per_m"))
        to.refuse(
            view, "tangential_stiffness_N_per_m",
            fmt::format("{} has no 'tangential_stiffness_N_per_m', which tangential = \"linear\" needs", view.title()),
            "add it, a number in N/m above 0");
    resolve_additions(view, to, pair);
    const std::size_t n = scene.materials.size();
    scene.pairs[static_cast<std::size_t>(first) * n + static_cast<std::size_t>(second)] = pair;
    scene.pairs[static_cast<std::size_t>(second) * n + static_cast<std::size_t>(first)] = pair;
}

class PairCheck {
public:
    PairCheck(const View& root, const Resolving& to) : to_(to) {
        for (const NamedView& pair : root.children("pair"))
            if (const auto dash = pair.name.find('-'); dash != std::string::npos)
                given_.insert(std::minmax(pair.name.substr(0, dash), pair.name.substr(dash + 1)));
    }

    /// At the material of the table that brings the second of the two together with the first.
    void need(const View& at, const std::string& a, const std::string& b, const std::string& because) {
        if (!given_.insert(std::minmax(a, b)).second)
            return;
        to_.refuse(at, "material", fmt::format("{}, but there is no [pair.{}-{}]", because, a, b),
                   fmt::format("add [pair.{}-{}] with restitution and friction", a, b));
    }

private:
    const Resolving& to_;
    std::set<std::pair<std::string, std::string>> given_;
};

} // namespace

std::optional<int> material_of(const View& view, const Resolving& to) {
    if (!view.given("material"))
        return std::nullopt;
    const std::string name = view.text("material");
    const auto index = index_of(to.scene, name);
    if (!index)
        to.refuse(view, "material", fmt::format("there is no material '{}'", excerpt(name)),
                  suggest_material(name, to.scene));
    return index;
}

void resolve_materials(const View& root, const Resolving& to) {
    Scene& scene = to.scene;
    for (const NamedView& named : root.children("material")) {
        const View& view = named.view;
        if (!is_plain_name(named.name))
            to.report.add(named.place, view.path(),
                          fmt::format("a material cannot be called '{}'", excerpt(named.name)),
                          "use letters, digits and _ only; '-' stands between the two names of a pair");
        contact::Material material;
        material.name = named.name;
        material.density = view.number("density_kg_m3");
        material.youngs_modulus = view.number("youngs_modulus_Pa");
        material.poisson_ratio = view.number("poisson_ratio");
        if (scene.dimension == 2 && scene.solver == Solver::soft && scene.contact.normal == NormalLaw::hertz)
            for (const char* key : {"youngs_modulus_Pa", "poisson_ratio"})
                if (!view.written(key))
                    to.refuse(view, key,
                              fmt::format("{} has no '{}', which normal = \"hertz\" needs", view.title(), key),
                              fmt::format("add {}", key));
        if (view.given("youngs_modulus_Pa") && material.youngs_modulus < softest_usual && !view.flag("allow_soft"))
            to.refuse(view, "youngs_modulus_Pa",
                      fmt::format("{} Pa is softer than rubber, grains will sink into each other",
                                  plain(material.youngs_modulus)),
                      "write allow_soft = true next to it if that is meant");
        scene.materials.push_back(material);
    }
    scene.pairs.assign(scene.materials.size() * scene.materials.size(), {});
    std::map<std::pair<int, int>, std::string> seen;
    for (const NamedView& named : root.children("pair"))
        resolve_pair(named, to, seen);
    check_additions(root, to);
}

void check_pairs(const View& root, const Resolving& to) {
    PairCheck check(root, to);
    std::vector<std::pair<const NamedView*, std::string>> bodies; // with a known material
    const auto body_views = root.children("body");
    for (const NamedView& body : body_views)
        if (body.view.given("material") && index_of(to.scene, body.view.text("material")))
            bodies.emplace_back(&body, body.view.text("material"));
    if (to.scene.bodies_can_meet())
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j)
                check.need(bodies[i].first->view, bodies[j].second, bodies[i].second,
                           i == j ? fmt::format("bodies '{}' can meet each other", bodies[i].first->name)
                                  : fmt::format("bodies '{}' and '{}' can meet", bodies[j].first->name,
                                                bodies[i].first->name));
    for (const NamedView& wall : root.children("wall")) {
        if (!wall.view.given("material") || !index_of(to.scene, wall.view.text("material")))
            continue;
        for (const auto& [body, material] : bodies)
            check.need(wall.view, material, wall.view.text("material"),
                       fmt::format("body '{}' can meet this wall", body->name));
    }
}

} // namespace tumble::scene
