#pragma once

#include "scene/report.h"
#include "scene/scene.h"
#include "scene/view.h"

#include <filesystem>
#include <string>

/// From checked tables to a Scene: units, defaults, references, files. Each function adds its part to the scene and
/// what is wrong to the report; values that the key check refused are passed over in silence.
namespace tumble::scene {

/// A material softer than that says allow_soft.
inline constexpr double softest_usual = 1e6; // Pa, soft rubber

struct Resolving {
    std::filesystem::path folder; // relative file names start here
    Report& report;
    Scene& scene;

    /// A file name of the scene, as it will be opened.
    [[nodiscard]] std::filesystem::path file(const std::string& name) const;
    /// Reports a problem about a key of that table.
    void refuse(const View& view, const std::string& key, std::string what, std::string fix) const {
        report.add(view.place(key), view.path_of(key), std::move(what), std::move(fix));
    }
};

void resolve_world(const View& root, const Resolving& to);     // top level, domain, contact
void resolve_materials(const View& root, const Resolving& to); // material, pair
void resolve_bodies(const View& root, const Resolving& to);    // body
void resolve_fills(const View& root, const Resolving& to);     // fill
void resolve_walls(const View& root, const Resolving& to);     // wall, wall.motion
void resolve_output(const View& root, const Resolving& to);    // observe, render

/// Once all else is right: makes the scene cheaper as [reduce] says (docs/reduced-order.md). A reduction that is at
/// its default leaves every bit as it is.
void apply_reductions(const View& root, const Resolving& to);

/// What a pair adds to its plain law.
void resolve_additions(const View& pair, const Resolving& to, contact::PairProperties& properties);
/// A law that no pair gives a parameter for is reported at the law.
void check_additions(const View& root, const Resolving& to);
/// After all of those: what Box2D is told, with the steps that the scene's bodies and walls ask for.
void resolve_box2d(const View& root, const Resolving& to);

/// After all of them: every two materials that can meet have a pair.
void check_pairs(const View& root, const Resolving& to);

/// The index of the material that `view.material` names, or nothing with a problem reported.
std::optional<int> material_of(const View& view, const Resolving& to);

/// False for a domain that is missing or wrong: nothing can be held against it.
bool has_volume(const Box& box);

/// The unit vector along the typed one, which itself is kept when its length is 1 already, so that a resolved scene
/// loads to the same bits; y, with a problem reported, when it has no length.
Vector3d direction_of(const View& view, const std::string& key, const Resolving& to);

/// "[x, y, z]" of a point in metres, for sentences; "[x, y]" in two dimensions.
std::string in_words(const Eigen::Vector3d& point, const Resolving& to);

/// A box from two corner keys; in two dimensions it reaches half the depth to either side.
Box box_of(const View& view, const std::string& lo, const std::string& hi, const Resolving& to);

/// A wall's outline in a scene of two dimensions.
Outline resolve_outline(const View& view, const Resolving& to);
/// What keeps the outline from being a wall in its domain, reported at the wall.
void check_outline(const View& view, const Wall& wall, const Resolving& to);

/// The motion of a wall from its [[wall.motion]] tables.
WallMotion resolve_motion(const View& wall, const Resolving& to);

} // namespace tumble::scene
