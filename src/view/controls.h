#pragma once

#include "view/scene_text.h"

#include <string>
#include <vector>

namespace tumble::view {

/// One number that may change while a scene runs.
struct Control {
    enum class Kind { key, tilt_about_z, tilt_about_x };
    Kind kind = Kind::key;
    std::string key;  // of the scene: "pair.media-lining.friction"
    std::string word; // for people: "friction"
    std::string unit; // of the key: "m", "deg", "" for a plain number
    double value = 0; // in that unit
    double lo = 0, hi = 1;
    double first = 0; // as the scene has it
};

/// All that a running scene can take up: friction, restitution and rolling friction of pairs, harmonics, rockings and
/// rotations of walls, the direction of gravity.
class Controls {
public:
    Controls() = default;
    /// `scene` is what the text loads to.
    Controls(const scene::Scene& scene, const SceneText& text);

    [[nodiscard]] const std::vector<Control>& all() const { return all_; }
    /// Kept between lo and hi.
    void set(std::size_t index, double value);
    void reset();

    /// What differs from the scene, ready to be loaded on top of it.
    [[nodiscard]] std::vector<scene::Override> changes() const;

private:
    void add(const SceneText& text, const std::string& key, const std::string& word, const std::string& unit);
    void add_pairs(const scene::Scene& scene, const SceneText& text);
    void add_motions(const scene::Scene& scene, const SceneText& text);
    void add_gravity(const scene::Scene& scene);
    [[nodiscard]] std::string gravity_value() const;

    std::vector<Control> all_;
    double gravity_ = 0; // m/s2
    bool flat_ = false;
};

} // namespace tumble::view
