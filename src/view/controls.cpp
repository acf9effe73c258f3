#include "view/controls.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::view {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double steepest_tilt = 60;     // degrees
constexpr double least_amplitude = 5e-3; // m that a wall at rest can be given

struct MotionKey {
    const char* name;
    const char* word;
    const char* unit;
};
// Of a [[wall.motion]]: those that are written tell its kind.
constexpr std::array<MotionKey, 5> motion_keys{{{"amplitude_m", "amplitude", "m"},
                                                {"amplitude_deg", "amplitude", "deg"},
                                                {"frequency_Hz", "frequency", "Hz"},
                                                {"speed_rpm", "speed", "rpm"},
                                                {"speed_rad_s", "speed", "rad/s"}}};

/// How far a slider of that key goes from its value.
std::array<double, 2> span_of(const std::string& word, const std::string& unit, double value) {
    if (word == "restitution")
        return {0, 1};
    if (word == "friction")
        return {0, std::max(1.5, 1.5 * value)};
    if (word == "rolling friction")
        return {0, std::clamp(2 * value, 0.5, 1.0)};
    if (word == "phase")
        return {-180, 180};
    if (word == "frequency")
        return {0.1 * value, 2.5 * value};
    if (word == "frequency factor")
        return {0.1 * value, 2.5 * value};
    if (word == "amplitude factor")
        return {0, value > 0 ? 3 * value : 1};
    if (word == "amplitude")
        return {0, value > 0 ? 3 * value : (unit == "m" ? least_amplitude : 5)};
    const double most = value != 0 ? 2 * std::abs(value) : 60; // a speed
    return {-most, most};
}

} // namespace

Controls::Controls(const scene::Scene& scene, const SceneText& text) : flat_(scene.dimension == 2) {
    add_motions(scene, text);
    add_pairs(scene, text);
    add_gravity(scene);
}

void Controls::add(const SceneText& text, const std::string& key, const std::string& word, const std::string& unit) {
    const Result<double> value = scene::number_in(text.text, text.file, text.sets, key);
    if (!value)
        return; // not a single number: no slider for it
    const auto [lo, hi] = span_of(word, unit, *value);
    all_.push_back({Control::Kind::key, key, word, unit, *value, std::min(lo, *value), std::max(hi, *value), *value});
}

void Controls::add_pairs(const scene::Scene& scene, const SceneText& text) {
    const bool rolls = scene.contact.additions.rolling != contact::RollingLaw::none;
    for (const auto& [path, where] : scene.written) {
        const auto names = split(path, '.');
        if (names.size() != 2 || names[0] != "pair")
            continue;
        for (const char* word : {"friction", "restitution"})
            if (scene.written.contains(path + "." + word))
                add(text, path + "." + word, word, "");
        if (rolls)
            add(text, path + ".rolling_friction", "rolling friction", "");
    }
}

void Controls::add_motions(const scene::Scene& scene, const SceneText& text) {
    for (const auto& [path, where] : scene.written) {
        const auto names = split(path, '.');
        if (names.size() != 4 || names[0] != "wall" || names[2] != "motion")
            continue;
        for (const MotionKey& key : motion_keys)
            if (scene.written.contains(path + "." + key.name))
                add(text, path + "." + key.name, key.word, key.unit);
        const bool from_file = scene.written.contains(path + ".file");
        if (from_file || scene.written.contains(path + ".rows")) {
            add(text, path + ".amplitude_factor", "amplitude factor", "");
            add(text, path + ".frequency_factor", "frequency factor", "");
        }
        const std::string phase = path + ".phase_deg"; // of a file's motion only harmonics have one
        if (scene.written.contains(path + ".frequency_Hz") || (from_file && text.load({{phase + "=0"}})))
            add(text, phase, "phase", "deg");
    }
}

void Controls::add_gravity(const scene::Scene& scene) {
    gravity_ = scene.gravity.norm();
    if (gravity_ == 0)
        return;
    const double about_z = degrees * std::atan2(scene.gravity.x(), -scene.gravity.y());
    const double about_x = degrees * std::asin(std::clamp(scene.gravity.z() / gravity_, -1.0, 1.0));
    const auto tilt = [&](Control::Kind kind, const char* word, double value) {
        all_.push_back({kind, "gravity_m_s2", word, "deg", value, std::min(-steepest_tilt, value),
                        std::max(steepest_tilt, value), value});
    };
    tilt(Control::Kind::tilt_about_z, "tilt towards x", about_z);
    if (!flat_)
        tilt(Control::Kind::tilt_about_x, "tilt towards z", about_x);
}

void Controls::set(std::size_t index, double value) {
    Control& control = all_.at(index);
    if (std::isfinite(value))
        control.value = std::clamp(value, control.lo, control.hi);
}

void Controls::reset() {
    for (Control& control : all_)
        control.value = control.first;
}

std::string Controls::gravity_value() const {
    double x = 0, z = 0; // rad
    for (const Control& control : all_) {
        x = control.kind == Control::Kind::tilt_about_z ? control.value / degrees : x;
        z = control.kind == Control::Kind::tilt_about_x ? control.value / degrees : z;
    }
    const double across = gravity_ * std::cos(z);
    const std::string plane = shortest(across * std::sin(x)) + ", " + shortest(-across * std::cos(x));
    return flat_ ? "[" + plane + "]" : "[" + plane + ", " + shortest(gravity_ * std::sin(z)) + "]";
}

std::vector<scene::Override> Controls::changes() const {
    std::vector<scene::Override> changes;
    bool tilted = false;
    for (const Control& control : all_) {
        if (control.value == control.first)
            continue;
        if (control.kind == Control::Kind::key)
            changes.push_back({control.key + "=" + shortest(control.value)});
        else
            tilted = true;
    }
    if (tilted)
        changes.push_back({"gravity_m_s2=" + gravity_value()});
    return changes;
}

} // namespace tumble::view
