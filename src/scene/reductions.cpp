#include "scene/reductions.h"

#include "fit/report.h"
#include "fit/spheres.h"
#include "fit/union_moments.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::scene {
namespace {

/// A fill that puts in one body only means that one: a sensor, a probe.
bool comes_in_numbers(const Fill& fill) {
    return !fill.position && (!fill.count || *fill.count > 1);
}

std::vector<bool> bodies_in_numbers(const Scene& scene) {
    std::vector<bool> many(scene.bodies.size(), false);
    for (const Fill& fill : scene.fills)
        if (comes_in_numbers(fill))
            many[static_cast<std::size_t>(fill.body)] = true;
    return many;
}

std::int64_t share_of(std::int64_t count, double share) {
    return std::max<std::int64_t>(1, std::llround(static_cast<double>(count) * share));
}

void scale_body(BodyTemplate& body, double factor, int dimension) {
    for (Sphere& sphere : body.spheres) {
        sphere.centre *= factor;
        sphere.radius *= factor;
    }
    if (body.mass)
        *body.mass *= std::pow(factor, dimension);
    if (body.principal_inertia)
        *body.principal_inertia *= std::pow(factor, dimension + 2);
    if (body.tracer_point)
        *body.tracer_point *= factor;
    if (body.cone)
        body.cone = {body.cone->diameter * factor, body.cone->height * factor};
}

/// So that an impact at the same speed keeps its overlap per radius: of masses that grow by factor^dimension.
void scale_springs(contact::PairProperties& pair, double factor, int dimension) {
    pair.normal_stiffness *= std::pow(factor, dimension - 2);
    pair.tangential_stiffness *= std::pow(factor, dimension - 2);
    pair.contact_time *= factor;
    pair.damping_time *= factor;
}

Problem no_common_size(const char* what) {
    return {.what = fmt::format("bodies of another size would feel {} otherwise, and nothing says which ratio of it to "
                                "other forces is to stay",
                                what),
            .fix = "scale bodies and law by hand, or leave it at 1"};
}

Result<Done> refit_body(BodyTemplate& body, int spheres) {
    const fit::UnionMoments before = fit::union_moments(body.spheres);
    const fit::Solid solid = fit::solid_of(*body.cone);
    const double filled = before.volume / solid.volume, off = (before.centre - solid.centre).norm();
    if (filled < 0.5 || filled > 1.5 || off > 0.1 * body.cone->height)
        return Problem{
            .what = fmt::format("the spheres of body '{}' do not stand for its cone: they fill {:.0f} % of it and "
                                "their centre lies {:.3g} mm from its own",
                                body.name, 100 * filled, 1e3 * off),
            .fix = "cone_diameter_m and cone_height_m are those of an upright cone with its base at y = 0"};
    const auto smallest = std::min_element(body.spheres.begin(), body.spheres.end(),
                                           [](const Sphere& a, const Sphere& b) { return a.radius < b.radius; });
    auto fewer = fit::spheres_in(*body.cone, {.spheres = spheres, .smallest = smallest->radius});
    if (!fewer)
        return fewer.problems();
    fit::scale_to_volume(*fewer, before.volume);
    body.spheres = std::move(*fewer);
    return Done{};
}

} // namespace

Result<Done> soften(Scene& scene, double factor) {
    if (scene.contact.additions.adhesion == contact::AdhesionLaw::sjkr)
        return Problem{
            .what = "softer bodies touch with larger areas, and adhesion = \"sjkr\" would pull harder by as much",
            .fix = "take adhesion = \"jkr\", whose work of adhesion follows so that the speed stays below which bodies "
                   "stick, or leave it at 1"};
    for (contact::Material& material : scene.materials)
        material.youngs_modulus /= factor;
    for (contact::PairProperties& pair : scene.pairs) {
        pair.normal_stiffness /= factor;
        pair.tangential_stiffness /= factor;
        pair.contact_time *= std::sqrt(factor);
        pair.damping_time *= std::sqrt(factor); // the same share of critical damping
        // The energy that parts a contact goes as (w^5 R^4 / E^2)^(1/3) under JKR and DMT. It stays, and with it the
        // speed below which bodies stick, where w follows E^(2/5) (Haervig et al. 2017; Chen, Liu and Li 2019).
        pair.work_of_adhesion *= std::pow(factor, -0.4);
    }
    // Impacts last as E^-2/5 (Johnson 1985, 11.24) or k^-1/2.
    scene.time_step *= scene.contact.normal == NormalLaw::hertz ? std::pow(factor, 0.4) : std::sqrt(factor);
    return Done{};
}

Result<Done> enlarge(Scene& scene, double factor) {
    const std::vector<bool> many = bodies_in_numbers(scene);
    if (std::find(many.begin(), many.end(), true) == many.end())
        return Problem{.what = "there is nothing to enlarge: no fill puts in more than one body",
                       .fix = "leave it at 1"};
    if (scene.air.there())
        return no_common_size("[air]");
    if (scene.contact.additions.adhesion != contact::AdhesionLaw::none)
        return no_common_size("adhesion");
    for (const contact::PairProperties& pair : scene.pairs)
        if (pair.cohesion > 0)
            return no_common_size("cohesion");
    const int d = scene.dimension;
    std::vector<bool> of_enlarged(scene.materials.size(), false);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (many[i]) {
            scale_body(scene.bodies[i], factor, d);
            of_enlarged[static_cast<std::size_t>(scene.bodies[i].material)] = true;
        }
    for (std::size_t a = 0, n = scene.materials.size(); a < n; ++a)
        for (std::size_t b = 0; b < n; ++b)
            if (of_enlarged[a] || of_enlarged[b])
                scale_springs(scene.pairs[a * n + b], factor, d);
    for (Fill& fill : scene.fills)
        if (fill.count && comes_in_numbers(fill))
            fill.count = share_of(*fill.count, std::pow(factor, -d));
    scene.time_step *= factor;
    return Done{};
}

Result<Done> refit(Scene& scene, int spheres) {
    bool any = false;
    for (BodyTemplate& body : scene.bodies) {
        any = any || body.cone.has_value();
        if (!body.cone || body.spheres.size() <= static_cast<std::size_t>(spheres))
            continue;
        if (Result<Done> done = refit_body(body, spheres); !done)
            return done;
    }
    if (!any)
        return Problem{.what = "there is nothing to fit anew: no body says which cone its spheres stand for",
                       .fix = "give the body cone_diameter_m and cone_height_m, or leave it at 0"};
    return Done{};
}

} // namespace tumble::scene
