#include "run/target.h"

#include <vector>

namespace tumble::run {

namespace fs = std::filesystem;

Target::~Target() {
    std::error_code ignored;
    if (fresh_ && !place_.empty())
        fs::remove_all(place_, ignored);
}

std::optional<Problem> Target::claim(bool overwrite, const std::string& extension) {
    std::error_code error;
    if (place_.empty())
        return std::nullopt;
    const bool there = fs::exists(place_, error);
    if (there && !(fs::is_directory(place_, error) && fs::is_empty(place_, error))) {
        if (!overwrite)
            return Problem{.file = place_.string(),
                           .what = "is there already, and nothing is overwritten",
                           .fix = "--force replaces it; or name another place"};
        remove_old(extension);
    }
    fresh_ = !there;
    return std::nullopt;
}

/// Only what such an export writes: pictures of an older, longer run must not mix with new ones.
void Target::remove_old(const std::string& extension) const {
    std::error_code ignored;
    if (!fs::is_directory(place_, ignored))
        return;
    std::vector<fs::path> old;
    for (const fs::directory_entry& entry : fs::directory_iterator(place_, ignored)) {
        fs::path name = entry.path();
        if (name.extension() == ".part") // of a redrawing that was killed
            name.replace_extension();
        if (name.extension() == extension || name.extension() == ".pvd")
            old.push_back(entry.path());
    }
    for (const fs::path& file : old)
        fs::remove(file, ignored);
}

} // namespace tumble::run
