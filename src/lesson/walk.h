#pragma once

#include "observe/frame.h"
#include "scene/scene.h"
#include "sheet/sheet.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// What a lesson shows.
namespace tumble::lesson {

using sheet::at_most;
using sheet::Axis;
using sheet::Cell;
using sheet::Column;
using sheet::Curve;
using sheet::Figure;
using sheet::Formula;
using sheet::Grid;
using sheet::Heading;
using sheet::Paragraph;
using sheet::Style;

/// What a run looked like, every so often.
struct Reel {
    std::string label;
    std::vector<observe::Frame> frames; // of one layout, one or more
};
/// A short video of one run, or of two side by side.
struct Film {
    std::string name; // of its files, without extension
    std::string title;
    std::vector<Reel> reels;                          // one or two
    double every = 0.04;                              // s of the run between pictures
    std::string color = "speed";                      // what the colours tell
    std::array<double, 2> range{0, 1};                // of it, SI
    std::optional<scene::Box> view = std::nullopt;    // m, what must be seen; without: all bodies and walls
    std::optional<std::size_t> poster = std::nullopt; // the picture that stands for it; without: the last
};

struct Walk : sheet::Sheet {
    std::string question{};
    std::string answer{};
    std::vector<Film> films{};

    /// Its picture stands here on the sheet.
    void show(Film film) {
        parts.emplace_back(sheet::Picture{film.name, film.title, "the video comes with `--out DIR`"});
        films.push_back(std::move(film));
    }
};

} // namespace tumble::lesson
