#include "run/tracers.h"

#include "base/text.h"

namespace tumble::run {

namespace {

const std::string prefix = "tracer:";

std::optional<std::size_t> body_named(const scene::Scene& scene, const std::string& name) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        if (scene.bodies[b].name == name)
            return b;
    return std::nullopt;
}

} // namespace

std::vector<std::string> without_tracers(const std::vector<std::string>& measures) {
    std::vector<std::string> others;
    for (const std::string& measure : measures)
        if (!measure.starts_with(prefix))
            others.push_back(measure);
    return others;
}

std::vector<std::string> traced_bodies(const std::vector<std::string>& measures) {
    std::vector<std::string> bodies;
    for (const std::string& measure : measures)
        if (measure.starts_with(prefix))
            bodies.push_back(measure.substr(prefix.size()));
    return bodies;
}

Problems check_tracers(const scene::Scene& scene) {
    std::vector<std::string> names;
    for (const scene::BodyTemplate& body : scene.bodies)
        names.push_back(body.name);
    Problems problems;
    for (const std::string& name : traced_bodies(scene.observe.measures)) {
        if (body_named(scene, name))
            continue;
        const std::string guess = did_you_mean(name, names);
        problems.push_back({.key = "observe.measures",
                            .what = "there is no body '" + name + "' to trace",
                            .fix = guess.empty() ? "write tracer: and the name of a [body.NAME]" : guess});
    }
    return problems;
}

Result<std::vector<observe::TracerReader>> tracers_of(const scene::Scene& scene,
                                                      const std::vector<SimulatedBody>& bodies) {
    if (Problems problems = check_tracers(scene); !problems.empty())
        return problems;
    std::vector<observe::TracerReader> readers;
    for (const std::string& name : traced_bodies(scene.observe.measures)) {
        observe::Tracer tracer;
        tracer.name = name;
        const std::size_t b = *body_named(scene, tracer.name);
        tracer.shape = static_cast<int>(b);
        tracer.gravity = scene.gravity;
        const SimulatedBody& body = bodies[b];
        tracer.sensor = body.written_from_principal.conjugate();
        if (scene.bodies[b].tracer_point)
            tracer.point = tracer.sensor * (*scene.bodies[b].tracer_point - body.written_centre);
        if (const scene::Vector3d& turned = scene.bodies[b].tracer_turned; turned.norm() > 0)
            tracer.turned = Eigen::AngleAxisd(turned.norm(), turned.normalized());
        readers.emplace_back(std::move(tracer));
    }
    return readers;
}

} // namespace tumble::run
