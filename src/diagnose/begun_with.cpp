#include "base/hash.h"
#include "diagnose/diagnosis.h"

namespace tumble::diagnose {

Diagnosis begun_with(const SceneText& scene, const Measurement& measurement) {
    Diagnosis diagnosis;
    diagnosis.title = measurement.title;
    diagnosis.scene = scene.file;
    diagnosis.data = measurement.file;
    diagnosis.hash = measurement.hash;
    Hash64 text;
    text.add(scene.toml);
    diagnosis.scene_hash = text.hex();
    for (const scene::Override& set : scene.sets)
        diagnosis.sets.push_back(set.text);
    diagnosis.settings = measurement.settings;
    diagnosis.warnings = measurement.warnings;
    return diagnosis;
}

} // namespace tumble::diagnose
