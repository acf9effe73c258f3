#include "hard2d/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble::hard2d {

Units Units::of(const scene::Scene& scene, const std::vector<discs::ShapeData>& shapes) {
    double radius = std::numeric_limits<double>::infinity(), mass = radius;
    for (const discs::ShapeData& data : shapes) {
        mass = std::min(mass, data.shape.mass);
        for (std::size_t k = 2; k < data.exposed.size(); k += 3)
            radius = std::min(radius, data.exposed[k]);
    }
    Units units;
    units.origin = (scene.domain.box.lo + scene.domain.box.hi).head<2>() / 2;
    if (std::isfinite(radius)) {
        units.length = 1 / radius;
        units.mass = 1 / mass;
    }
    return units;
}

} // namespace tumble::hard2d
