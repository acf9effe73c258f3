#include "expect.h"
#include "scene/load.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <vector>

namespace {

using tumble::scene::Override;

// A folder that does not exist: what a scene names cannot be read, whatever it names.
const char* const nowhere = "/nonexistent/scene.toml";

/// What stands behind a line "--set" is given as overrides, one a line.
std::vector<Override> take_sets(std::string_view& text) {
    std::vector<Override> sets;
    const auto cut = text.find("\n--set\n");
    if (cut == std::string_view::npos)
        return sets;
    std::string_view rest = text.substr(cut + 7);
    text = text.substr(0, cut);
    while (!rest.empty() && sets.size() < 8) {
        const auto end = std::min(rest.find('\n'), rest.size());
        sets.push_back({std::string(rest.substr(0, end))});
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return sets;
}

} // namespace

/// A scene that loads can be written, and what is written loads and is written the same again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = fuzz::text_of(data, size);
    const std::vector<Override> sets = take_sets(text);
    const auto scene = tumble::scene::load_scene_text(text, nowhere, sets);
    if (!scene) {
        fuzz::expect(!scene.problems().empty(), "a refusal has a problem");
        for (const tumble::Problem& problem : scene.problems())
            fuzz::expect(!problem.what.empty(), "a problem says what is wrong");
        return 0;
    }
    const std::string once = tumble::scene::to_toml(*scene);
    const auto again = tumble::scene::load_scene_text(once, nowhere);
    fuzz::expect(again.ok(), "a resolved scene loads");
    fuzz::expect(tumble::scene::to_toml(*again) == once, "a resolved scene is written the same again");
    return 0;
}
