#include "base/make_folder.h"

#include "base/remedy.h"

namespace tumble {

Result<Done> make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return Problem{
            .file = folder.string(), .what = "cannot be made: " + error.message(), .fix = remedy(error.value())};
    return Done{};
}

} // namespace tumble
