#pragma once

#include <string>
#include <vector>

/// What `tumble gallery` makes: a table, so that a picture in the docs is never older than the program.
namespace tumble::cli {

/// A run that pictures are drawn from.
struct GalleryRun {
    std::string name;
    std::string scene;             // of the folder of scenes
    std::vector<std::string> sets; // what makes it short
};

struct GalleryPicture {
    std::string file;
    std::string shows;              // in a few words
    std::string run;                // name of a GalleryRun
    std::vector<std::string> flags; // of `tumble render`
};

const std::vector<GalleryRun>& gallery_runs();
const std::vector<GalleryPicture>& gallery_pictures();

} // namespace tumble::cli
