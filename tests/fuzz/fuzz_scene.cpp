#include "scene/load.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

/// Any text gives a scene or problems; a scene can be written and loads again to what is written the same. What stands
/// behind a line "--set" is given as overrides, one a line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text(reinterpret_cast<const char*>(data), size);
    std::vector<tumble::scene::Override> sets;
    if (const auto cut = text.find("\n--set\n"); cut != std::string_view::npos) {
        std::string_view rest = text.substr(cut + 7);
        text = text.substr(0, cut);
        while (!rest.empty() && sets.size() < 8) {
            const auto end = std::min(rest.find('\n'), rest.size());
            sets.push_back({std::string(rest.substr(0, end))});
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    // A folder that does not exist: what a scene names cannot be read, whatever it names.
    const auto scene = tumble::scene::load_scene_text(text, "/nonexistent/fuzz.toml", sets);
    if (!scene) {
        if (scene.problems().empty())
            std::abort();
        return 0;
    }
    const std::string once = tumble::scene::to_toml(*scene);
    const auto again = tumble::scene::load_scene_text(once, "/nonexistent/fuzz.toml");
    if (!again || tumble::scene::to_toml(*again) != once)
        std::abort();
    return 0;
}
