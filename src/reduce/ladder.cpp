#include "reduce/ladder.h"

#include "base/text.h"
#include "scene/load.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"
#include "scene/reductions.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::reduce {

namespace {

/// A factor beyond 1, or a share below it.
bool reduces_something(const Kind& kind, double degree) {
    const double nothing = Degrees{}.*kind.degree;
    const bool share = kind.usual.front() < nothing;
    return share ? degree > 0 && degree < nothing : degree > nothing;
}

std::string name_of(const Degrees& degrees) {
    std::string name;
    for (const Kind& kind : all_kinds())
        if (degrees.*kind.degree != Degrees{}.*kind.degree)
            name += fmt::format("{}{} {:.3g}", name.empty() ? "" : ", ", kind.word, degrees.*kind.degree);
    return name.empty() ? "as written" : name;
}

/// Most spheres of a body that can be fitted anew; 0: there is none.
std::size_t spheres_of(const scene::Scene& scene) {
    std::size_t most = 0;
    for (const scene::BodyTemplate& body : scene.bodies)
        if (body.cone)
            most = std::max(most, body.spheres.size());
    return most;
}

/// Of the degree's share of spheres; a flat scene is told of the key.
std::optional<Problem> too_few_spheres(const scene::Scene& whole, double degree) {
    const auto all = static_cast<double>(spheres_of(whole));
    if (whole.dimension == 2 || std::llround(degree * all) >= scene::fewest_spheres)
        return std::nullopt;
    if (all == 0)
        return Problem{.what = "--try spheres: no body says which cone its spheres stand for",
                       .fix = "give the body cone_diameter_m and cone_height_m, or try another reduction"};
    Problem problem{.what =
                        fmt::format("--try spheres={}: that share of the {:.0f} spheres of a body is {}, and a cone "
                                    "needs {}",
                                    shortest(degree), all, std::llround(degree * all), scene::fewest_spheres)};
    problem.fix = all > scene::fewest_spheres
                      ? fmt::format("give shares from {:.2g} on and below 1, the share of each body's spheres",
                                    std::ceil(100 * scene::fewest_spheres / all) / 100)
                      : "it has none to spare: try another reduction";
    return problem;
}

/// The keys of [reduce] that lead from the scene to the rung, on top of what the scene says of them itself.
Result<std::vector<scene::Override>> sets_for(const SceneText& text, const std::string& toml, const scene::Scene& whole,
                                              const Degrees& degrees) {
    std::vector<scene::Override> sets = text.sets;
    for (const Kind& kind : all_kinds()) {
        const double degree = degrees.*kind.degree;
        if (degree == Degrees{}.*kind.degree)
            continue;
        if (kind.degree == &Degrees::spheres) {
            if (const auto problem = too_few_spheres(whole, degree))
                return *problem;
            sets.push_back(
                {fmt::format("reduce.spheres={}", std::llround(degree * static_cast<double>(spheres_of(whole))))});
            continue;
        }
        const std::string key = fmt::format("reduce.{}", kind.word);
        const Result<double> own = scene::number_in(toml, text.file, text.sets, key);
        if (!own)
            return own.problems();
        sets.push_back({fmt::format("{}={}", key, shortest(*own * degree))});
    }
    return sets;
}

std::vector<Degrees> degrees_of(const std::vector<Wish>& wishes) {
    std::vector<Degrees> all{Degrees{}};
    for (const Wish& wish : wishes)
        for (const double degree : wish.degrees) {
            all.emplace_back();
            all.back().*wish.kind->degree = degree;
        }
    Degrees together;
    for (std::size_t k = 0; k < wishes.size(); ++k) {
        const std::vector<double>& degrees = wishes[k].degrees;
        together.*wishes[k].kind->degree = degrees[std::min<std::size_t>(1, degrees.size() - 1)];
        if (k > 0)
            all.push_back(together);
    }
    return all;
}

} // namespace

const std::array<Kind, 4>& all_kinds() {
    static const std::array<Kind, 4> kinds{
        Kind{"softening", &Degrees::softening, {2, 4, 8, 16}, "stiffnesses divided by it"},
        Kind{"spheres", &Degrees::spheres, {0.5, 0.3}, "share of each body's spheres, fitted anew to its cone"},
        Kind{"slice", &Degrees::slice, {0.7, 0.5}, "share of the periodic length"},
        Kind{"size", &Degrees::size, {1.25, 1.5, 2}, "bodies so many times as long"}};
    return kinds;
}

Result<Wish> read_wish(const std::string& text) {
    const std::string word = text.substr(0, text.find('='));
    std::vector<std::string> known;
    Wish wish;
    for (const Kind& kind : all_kinds()) {
        known.emplace_back(kind.word);
        if (kind.word == word)
            wish = {&kind, kind.usual};
    }
    if (!wish.kind) {
        const std::string guess = did_you_mean(word, known);
        return Problem{.what = fmt::format("there is no reduction '{}'", excerpt(word)),
                       .fix = guess.empty() ? "take softening, size, spheres or slice" : guess};
    }
    if (word.size() == text.size())
        return wish;
    wish.degrees.clear();
    for (const std::string_view part : split(std::string_view(text).substr(word.size() + 1), ',')) {
        const Result<double> degree = parse_number(trimmed(part));
        if (!degree || !reduces_something(*wish.kind, *degree))
            return Problem{
                .what = fmt::format("'{}' is no degree of {}", excerpt(part), word),
                .fix = fmt::format("give {} ({}): {}={}",
                                   wish.kind->usual.front() < 1 ? "shares above 0 and below 1" : "factors above 1",
                                   wish.kind->sentence, word, wish.kind->usual.front() < 1 ? "0.5" : "2,4")};
        wish.degrees.push_back(*degree);
    }
    return wish;
}

Result<scene::Scene> SceneText::load() const {
    return scene::load_scene(file, sets);
}

std::vector<Wish> wishes_for(const scene::Scene& scene) {
    std::vector<Wish> wishes;
    const auto& periodic = scene.domain.periodic;
    for (const Kind& kind : all_kinds()) {
        if (kind.degree == &Degrees::spheres && spheres_of(scene) < 2 * scene::fewest_spheres) // half of them
            continue;
        if (kind.degree == &Degrees::slice && std::count(periodic.begin(), periodic.end(), true) != 1)
            continue;
        wishes.push_back({&kind, kind.usual});
    }
    return wishes;
}

Result<std::vector<Rung>> ladder(const SceneText& text, const std::vector<Wish>& wishes) {
    const Result<scene::Scene> whole = text.load();
    if (!whole)
        return whole.problems();
    const Result<std::string> toml = scene::read_file(text.file, scene::largest_scene);
    if (!toml)
        return toml.problems();
    std::vector<Rung> rungs;
    for (const Degrees& degrees : degrees_of(wishes)) {
        const auto sets = sets_for(text, *toml, *whole, degrees);
        if (!sets)
            return sets.problems();
        Result<scene::Scene> reduced = scene::load_scene(text.file, *sets);
        if (!reduced)
            return reduced.problems();
        rungs.push_back({name_of(degrees), degrees, std::move(*reduced)});
    }
    return rungs;
}

} // namespace tumble::reduce
