#include "base/text.h"
#include "scene/faults.h"
#include "scene/keys.h"
#include "scene/period.h"
#include "scene/read_clump.h"
#include "scene/resolve.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::scene {
namespace {

std::vector<Sphere> resolve_spheres(const View& view, const Resolving& to) {
    std::vector<Sphere> spheres;
    if (view.given("radius_m") || view.given("radius_mm"))
        return {{Vector3d::Zero(), view.number(view.given("radius_m") ? "radius_m" : "radius_mm")}};
    const int dimension = to.scene.dimension;
    if (view.given("clump")) {
        auto read = read_clump(to.file(view.text("clump")), dimension);
        if (read)
            spheres = std::move(*read);
        else if (const Problems problems = read.problems(); problems.front().line == 0)
            to.refuse(view, "clump", fmt::format("clump file {}: {}", problems.front().file, problems.front().what),
                      problems.front().fix);
        else
            to.report.add(problems);
    }
    const char* const written = dimension == 2 ? "discs_m" : "spheres_m";
    const char* const parts = dimension == 2 ? "discs" : "spheres";
    const auto columns = static_cast<std::size_t>(dimension) + 1;
    const std::vector<double> numbers = view.numbers(written);
    if (numbers.size() / columns > most_spheres)
        to.refuse(view, written, fmt::format("more than {} {}", most_spheres, parts),
                  fmt::format("use fewer, larger {}", parts));
    for (std::size_t i = 0; i + columns <= numbers.size(); i += columns)
        spheres.push_back(
            {{numbers[i], numbers[i + 1], dimension == 2 ? 0.0 : numbers[i + 2]}, numbers[i + columns - 1]});
    const double scale = view.number("scale");
    for (Sphere& sphere : spheres) {
        sphere.centre *= scale;
        sphere.radius *= scale;
    }
    return spheres;
}

std::optional<fit::Cone> resolve_cone(const View& view, const Resolving& to) {
    const char* const keys[] = {"cone_diameter_m", "cone_height_m"};
    for (const int k : {0, 1})
        if (view.written(keys[k]) && !view.written(keys[1 - k]))
            to.refuse(view, keys[k], "a cone has a diameter and a height", fmt::format("give {} as well", keys[1 - k]));
    if (!view.given(keys[0]) || !view.given(keys[1]))
        return std::nullopt;
    const double scale = view.number("scale");
    return fit::Cone{view.number(keys[0]) * scale, view.number(keys[1]) * scale};
}

std::optional<int> body_named(const Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].name == name)
            return static_cast<int>(i);
    return std::nullopt;
}

std::string suggest_body(const std::string& name, const Scene& scene) {
    std::vector<std::string> names;
    for (const BodyTemplate& body : scene.bodies)
        names.push_back(body.name);
    if (names.empty())
        return "add a table [body.NAME]";
    const std::string meant = did_you_mean(name, names);
    return meant.empty() ? fmt::format("the bodies are {}", fmt::join(names, ", ")) : meant;
}

bool inside(const Vector3d& point, const Box& box) {
    return (point.array() >= box.lo.array()).all() && (point.array() <= box.hi.array()).all();
}

/// A body with a sphere wider than the region never fits, however it is turned.
void check_width(const View& view, const Fill& fill, const Resolving& to) {
    if (to.scene.bodies.empty())
        return;
    double radius = 0;
    for (const Sphere& sphere : to.scene.bodies[static_cast<std::size_t>(fill.body)].spheres)
        radius = std::max(radius, sphere.radius);
    for (int axis = 0; axis < to.scene.dimension; ++axis)
        if (const double width = fill.region.hi[axis] - fill.region.lo[axis];
            2 * radius > width && !spans_period(to.scene.domain, fill.region, axis))
            return to.refuse(
                view, "region_hi_m",
                fmt::format("the region is {:.4g} m wide along {}, and one {} of body '{}' alone is {:.4g} m wide",
                            width, "xyz"[axis], to.scene.dimension == 2 ? "disc" : "sphere",
                            to.scene.bodies[static_cast<std::size_t>(fill.body)].name, 2 * radius),
                "look at the unit of its size, or enlarge the region");
}

void check_region(const View& view, const Fill& fill, const Resolving& to) {
    if (view.written("region_lo_m") != view.written("region_hi_m") && !view.written("position_m")) {
        to.refuse(view, view.written("region_hi_m") ? "region_hi_m" : "region_lo_m",
                  "a region needs both of its corners", "give region_lo_m and region_hi_m");
        return;
    }
    if (!view.given("region_lo_m") || !view.given("region_hi_m"))
        return;
    if (!has_volume(fill.region)) {
        to.refuse(view, "region_hi_m",
                  fmt::format("the region from {} to {} has no volume", in_words(fill.region.lo, to),
                              in_words(fill.region.hi, to)),
                  "each value of region_hi_m must be above that of region_lo_m");
        return;
    }
    check_width(view, fill, to);
    const Box& domain = to.scene.domain.box;
    for (const char* key : {"region_lo_m", "region_hi_m"})
        if (has_volume(domain) && !inside(view.vector(key), domain))
            to.refuse(view, key,
                      fmt::format("the corner {} lies outside the domain from {} to {}", in_words(view.vector(key), to),
                                  in_words(domain.lo, to), in_words(domain.hi, to)),
                      "move it inside, or enlarge the domain");
}

void check_position(const View& view, const Fill& fill, const Resolving& to) {
    if (!fill.position)
        return;
    const Box& domain = to.scene.domain.box;
    if (has_volume(domain) && !inside(*fill.position, domain))
        to.refuse(view, "position_m",
                  fmt::format("{} lies outside the domain from {} to {}", in_words(*fill.position, to),
                              in_words(domain.lo, to), in_words(domain.hi, to)),
                  "move it inside, or enlarge the domain");
    if (view.given("count") && *fill.count != 1)
        to.refuse(view, "count", fmt::format("{} bodies cannot all be at one position", *fill.count),
                  "write count = 1, or give a region instead of position_m");
    if (view.given("mass_kg"))
        to.refuse(view, "mass_kg", "a position holds a single body, not a mass of them", "write count = 1 instead");
    if (view.given("region_hi_m"))
        to.refuse(view, "region_hi_m", "a body at a position needs no region", "remove region_hi_m");
}

} // namespace

void resolve_bodies(const View& root, const Resolving& to) {
    for (const NamedView& named : root.children("body")) {
        const View& view = named.view;
        BodyTemplate body;
        body.name = named.name;
        if (named.name.empty() || named.name.find('.') != std::string::npos)
            to.report.add(named.place, view.path(), fmt::format("a body cannot be called '{}'", excerpt(named.name)),
                          "use a name without dots");
        body.material = material_of(view, to).value_or(0);
        body.spheres = resolve_spheres(view, to);
        const std::string radius = view.written("radius_m") ? "radius_m" : "radius_mm";
        if (view.written("scale") && view.written(radius))
            to.refuse(view, "scale", fmt::format("'scale' does not belong to a body with '{}'", radius),
                      fmt::format("remove it, and write {} as large as it should be", radius));
        if (view.given("mass_kg"))
            body.mass = view.number("mass_kg");
        if (view.given("inertia_kg_m2") && to.scene.dimension == 2)
            body.principal_inertia = Vector3d::Constant(view.number("inertia_kg_m2"));
        else if (view.given("inertia_kg_m2")) {
            const Vector3d i = view.vector("inertia_kg_m2");
            body.principal_inertia = i;
            if (const auto fault = fault_of_inertia(i))
                to.refuse(view, fault->key, fault->what, fault->fix);
        }
        if (view.given("tracer_point_m"))
            body.tracer_point = view.vector("tracer_point_m") * (view.given("scale") ? view.number("scale") : 1.0);
        if (view.given("tracer_turned_deg"))
            body.tracer_turned = view.vector("tracer_turned_deg");
        body.cone = resolve_cone(view, to);
        to.scene.bodies.push_back(std::move(body));
    }
}

void resolve_fills(const View& root, const Resolving& to) {
    for (const NamedView& named : root.children("fill")) {
        const View& view = named.view;
        Fill fill;
        if (view.given("body")) {
            const auto body = body_named(to.scene, view.text("body"));
            if (!body)
                to.refuse(view, "body", fmt::format("there is no body '{}'", excerpt(view.text("body"))),
                          suggest_body(view.text("body"), to.scene));
            fill.body = body.value_or(0);
        }
        if (view.given("count"))
            fill.count = view.integer("count");
        if (view.given("mass_kg"))
            fill.mass = view.number("mass_kg");
        fill.region = box_of(view, "region_lo_m", "region_hi_m", to);
        if (view.given("position_m"))
            fill.position = view.vector("position_m");
        fill.orientation = view.text("orientation") == "as_written" ? Orientation::as_written : Orientation::random;
        fill.velocity = view.vector("velocity_m_s");
        fill.angular_velocity = to.scene.dimension == 2
                                    ? Vector3d(view.number("angular_velocity_rad_s") * Vector3d::UnitZ())
                                    : view.vector("angular_velocity_rad_s");
        fill.start = view.number("start_s");
        fill.until = view.given("until_s") ? view.number("until_s") : fill.start;
        fill.every = view.number("every_s");
        if (fill.until < fill.start)
            to.refuse(
                view, "until_s",
                fmt::format("the last try at {} s is before the first at {} s", plain(fill.until), plain(fill.start)),
                "give until_s >= start_s");
        check_region(view, fill, to);
        check_position(view, fill, to);
        to.scene.fills.push_back(fill);
    }
}

} // namespace tumble::scene
