#include "support/media.h"

#include "scene/read_clump.h"

namespace tumble::bench {

scene::Scene media_scene() {
    scene::Scene scene;
    scene.title = "bench";
    scene.duration = 1e9;
    scene.allow_large_step = true;
    scene.materials = {{"media", 1665.71, 4.6e8, 0.2887}, {"wall", 1665.71, 2.5e7, 0.25}};
    scene.pairs.resize(4);
    for (auto& pair : scene.pairs) {
        pair.restitution = 0.159;
        pair.friction = 0.86;
    }
    scene.pairs[0].restitution = 0.67;
    scene.pairs[0].friction = 0.58;
    return scene;
}

scene::BodyTemplate read_template(const std::string& name, const std::string& file) {
    scene::BodyTemplate body;
    body.name = name;
    body.spheres = value_or_refuse(scene::read_clump(file));
    return body;
}

} // namespace tumble::bench
