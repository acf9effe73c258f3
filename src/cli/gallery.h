#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// What `tumble gallery` makes: a table, so that a picture in the docs is never older than the program.
namespace tumble::cli {

/// The words of a command behind `tumble`. In braces stands what differs from place to place: {scenes}, {file} (the
/// picture), {folder} (one that the command fills), {NAME} (the one that the run NAME filled).
using Words = std::vector<std::string>;

/// A command whose folder pictures are made from.
struct GalleryRun {
    std::string name;
    Words words;
    int minutes = 0; // on two idle cores; 0: less than one
};

struct GalleryPicture {
    std::string file;
    std::string shows;            // in a few words
    Words words;                  // of the command that draws it; none: a run does
    std::string taken = "{file}"; // where the picture lies then
    int minutes = 0;              // of the command, on two idle cores; 0: less than one
};

const std::vector<GalleryRun>& gallery_runs();
const std::vector<GalleryPicture>& gallery_pictures();

/// The runs that a picture is made from, in the order of the table.
std::vector<const GalleryRun*> runs_of(const GalleryPicture& picture);

/// Folders of runs that are there already, by the runs' names.
using GivenRuns = std::map<std::string, std::filesystem::path>;

/// On two idle cores, with its runs that are not given; 0: less than one.
int minutes_of(const GalleryPicture& picture, const GivenRuns& given = {});

/// What stands in the place of the braces; {NAME} is `runs / NAME`, or the folder that is given for it.
struct GalleryPlaces {
    std::filesystem::path scenes, runs, file, folder;
    GivenRuns given{};
};
std::string filled_in(const std::string& text, const GalleryPlaces& places);
Words filled_in(const Words& words, const GalleryPlaces& places);

/// "tumble ..." as it is typed in a shell.
std::string typed(const Words& words);

/// The commands that make a picture as a reader types them, from the folder that `scenes` lies in: runs go to out/NAME.
/// The last entry is where the picture lies then.
struct GalleryRecipe {
    std::vector<std::string> commands;
    std::string result;
};
GalleryRecipe recipe_of(const GalleryPicture& picture);

} // namespace tumble::cli
