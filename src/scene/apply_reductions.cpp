#include "scene/keys.h"
#include "scene/reductions.h"
#include "scene/resolve.h"

#include <fmt/format.h>

namespace tumble::scene {
namespace {

void check_softness(const View& root, const View& reduce, const Resolving& to) {
    const auto written = root.children("material");
    for (std::size_t i = 0; i < to.scene.materials.size(); ++i) {
        const contact::Material& material = to.scene.materials[i];
        if (material.youngs_modulus > 0 && material.youngs_modulus < softest_usual &&
            !written[i].view.flag("allow_soft"))
            to.refuse(reduce, "softening",
                      fmt::format("it leaves material '{}' {} Pa, softer than rubber: grains will sink into each other",
                                  material.name, plain(material.youngs_modulus)),
                      "take less of it, or write allow_soft = true in the material if that is meant");
    }
}

} // namespace

void apply_reductions(const View& root, const Resolving& to) {
    const View reduce = root.child("reduce");
    const auto apply = [&](const char* key, const Result<Done>& done) {
        for (const Problem& problem : done.problems())
            to.refuse(reduce, key, problem.what, problem.fix);
    };
    Scene& scene = to.scene;
    const double step = scene.time_step;
    if (const std::int64_t spheres = scene.dimension == 3 ? reduce.integer("spheres") : 0; spheres > 0)
        apply("spheres", refit(scene, static_cast<int>(spheres)));
    if (const double size = reduce.number("size"); size != 1)
        apply("size", enlarge(scene, size));
    if (const double softening = reduce.number("softening"); softening != 1) {
        apply("softening", soften(scene, softening));
        check_softness(root, reduce, to);
    }
    if (const double slice = reduce.number("slice"); slice != 1)
        apply("slice", cut_slice(scene, slice));
    if (scene.time_step != step && scene.time_step > scene.duration)
        to.refuse(root, "time_step_s",
                  fmt::format("reduced, the step of {} s is longer than the whole run of {} s", plain(scene.time_step),
                              plain(scene.duration)),
                  "shorten time_step_s, lengthen duration_s, or reduce less");
}

} // namespace tumble::scene
