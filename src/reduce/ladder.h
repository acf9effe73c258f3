#pragma once

#include "base/problem.h"
#include "scene/override.h"
#include "scene/scene.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Which reductions of a scene are tried.
namespace tumble::reduce {

/// How far a scene is reduced, beyond what it says itself; the keys of [reduce].
struct Degrees {
    double softening = 1;
    double size = 1;
    double spheres = 1; // share of those that the bodies with a cone have
    double slice = 1;

    /// Whether this goes at least as far as the other in every direction.
    [[nodiscard]] bool reduces(const Degrees& other) const {
        return softening >= other.softening && size >= other.size && spheres <= other.spheres && slice <= other.slice;
    }
    bool operator==(const Degrees&) const = default;
};

/// A kind of reduction: its word, what a number of it means, and the degrees that are tried when none are asked for.
struct Kind {
    std::string_view word; // also its key in [reduce]
    double Degrees::*degree;
    std::vector<double> usual; // mild first; the second is the one that goes into combinations
    std::string_view sentence;
};
const std::array<Kind, 4>& all_kinds();

/// What to try of one kind, as typed: "softening", "softening=4,16".
struct Wish {
    const Kind* kind = nullptr;
    std::vector<double> degrees;
};
/// Problems: no such kind; not a number; a degree that reduces nothing.
Result<Wish> read_wish(const std::string& text);

/// A scene file with what was set on the command line.
struct SceneText {
    std::filesystem::path file;
    std::vector<scene::Override> sets;

    [[nodiscard]] Result<scene::Scene> load() const;
};

/// One way to run the scene.
struct Rung {
    std::string name; // "as written", "softening 4, slice 0.5"
    Degrees degrees;
    scene::Scene scene;
};

/// What a scene can be reduced by: all kinds that it takes, at their usual degrees, without wishes.
std::vector<Wish> wishes_for(const scene::Scene& scene);

/// The scene as written, then each wish alone, then the wishes together: the second degree (or the only one) of the
/// first two, of the first three, and so on. Problems: the scene is wrong, or cannot be reduced as asked.
Result<std::vector<Rung>> ladder(const SceneText& text, const std::vector<Wish>& wishes);

} // namespace tumble::reduce
