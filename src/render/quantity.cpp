#include "render/quantity.h"

#include "base/text.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace tumble::render {

using observe::Frame;

const std::vector<Quantity>& quantities() {
    static const std::vector<Quantity> all{
        {"speed", "speed", "m/s", false, [](const Frame& f, std::size_t b) { return f.velocity[b].norm(); }},
        {"vx", "velocity x", "m/s", true, [](const Frame& f, std::size_t b) { return f.velocity[b].x(); }},
        {"vy", "velocity y", "m/s", true, [](const Frame& f, std::size_t b) { return f.velocity[b].y(); }},
        {"vz", "velocity z", "m/s", true, [](const Frame& f, std::size_t b) { return f.velocity[b].z(); }},
        {"spin", "spin", "rad/s", false, [](const Frame& f, std::size_t b) { return f.angular_velocity[b].norm(); }},
        {"none", "", "", false, [](const Frame&, std::size_t) { return 0.0; }},
    };
    return all;
}

Result<Quantity> find_quantity(const std::string& name, int dimension) {
    std::vector<std::string> names;
    for (const Quantity& quantity : quantities()) {
        if (dimension == 2 && quantity.name == "vz") {
            continue;
        }
        if (quantity.name == name) {
            return quantity;
        }
        names.push_back(quantity.name);
    }
    const std::string guess = did_you_mean(name, names);
    return Problem{.key = "render.color",
                   .what = fmt::format("there is no quantity '{}' to colour by", name),
                   .fix = (guess.empty() ? "" : guess + "  ") + fmt::format("known: {}", fmt::join(names, ", "))};
}

std::vector<double> values_of(const Quantity& quantity, const Frame& frame) {
    std::vector<double> values;
    values.reserve(frame.bodies());
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        values.push_back(quantity.of(frame, b));
    }
    return values;
}

} // namespace tumble::render
