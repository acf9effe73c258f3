#pragma once

#include "observe/frame.h"
#include "scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a lesson shows, as data. Text is UTF-8; whoever shows it breaks its lines.
namespace tumble::lesson {

struct Heading {
    std::string text;
};

struct Paragraph {
    std::string text;
};

/// One line of mathematics and where it stands: "(3.11)", "Johnson 1985".
struct Formula {
    std::string text;
    std::string source;
};

struct Column {
    std::string head;
    std::string unit{}; // empty: none
    int digits = 4;     // significant, of numbers
};
using Cell = std::variant<double, std::string>; // numbers in the column's unit
struct Grid {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows{};
};

struct Axis {
    std::string label;
    std::string unit{}; // empty: none
    bool logarithmic = false;
    std::optional<std::array<double, 2>> range{};
};
enum class Style { line, dashes, points };
struct Curve {
    std::string label;
    Style style = Style::line;
    std::vector<double> x{}, y{};       // in the axes' units
    std::optional<std::size_t> color{}; // curves of one number share a colour; else each has its own

    void add(double at, double value) {
        x.push_back(at);
        y.push_back(value);
    }
};
struct Figure {
    std::string name; // of its files, without extension
    std::string title;
    Axis x, y;
    std::vector<Curve> curves{};
};

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

using Part = std::variant<Heading, Paragraph, Formula, Grid, Figure, Film>;

/// A number that the walk rests on, under a name that stays.
struct Fact {
    std::string name;
    double value = 0;
    std::string unit; // empty: none
};

struct Walk {
    std::vector<Part> parts;
    std::vector<Fact> facts;
    std::string question;
    std::string answer;

    void head(std::string text) { parts.emplace_back(Heading{std::move(text)}); }
    void say(std::string text) { parts.emplace_back(Paragraph{std::move(text)}); }
    void formula(std::string text, std::string source = "") {
        parts.emplace_back(Formula{std::move(text), std::move(source)});
    }
    void fact(std::string name, double value, std::string unit = "") {
        facts.push_back({std::move(name), value, std::move(unit)});
    }
    /// The fact of that name; NaN when there is none.
    [[nodiscard]] double fact(const std::string& name) const;
    [[nodiscard]] std::vector<const Figure*> figures() const;
    [[nodiscard]] std::vector<const Film*> films() const;
};

/// The power of ten above a size that is only rounding: "1e-13"; at least 1e-16.
std::string at_most(double size);

} // namespace tumble::lesson
