#pragma once

#include "cli/gallery.h"

#include <map>

namespace tumble::cli {

/// Makes pictures of the gallery. Runs lie in `out/.runs` until all is made: a call after one that was stopped or
/// killed takes up those that are over and goes on with the one that is not. Each picture gets its name when it is
/// whole.
class Workshop {
public:
    /// Runs that are given are taken as they are.
    Workshop(std::filesystem::path out, std::filesystem::path scenes, GivenRuns given = {});

    /// Each that can be made; one that fails does not keep the others. Returns an exit code: fine, failed, or that of
    /// the signal that stopped it.
    int make(const std::vector<const GalleryPicture*>& pictures);

private:
    enum class End { done, failed, stopped };

    void clear_out_other_programs();
    End have_run(const GalleryRun& run);
    End make(const GalleryPicture& picture);
    bool keep(const std::filesystem::path& made, const std::string& file);

    std::filesystem::path out_, scenes_, runs_;
    GivenRuns given_;
    std::map<std::string, End> runs_had_;
};

} // namespace tumble::cli
