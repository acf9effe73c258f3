#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What a lesson, an experiment or an evaluation shows, as data. Text is UTF-8; whoever shows it breaks its lines.
namespace tumble::sheet {

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
    double of = 0;      // what its numbers are parts of: below 1e-12 of it they are rounding, and read 0
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
enum class Style { line, dashes, points, bars };
struct Curve {
    std::string label; // empty: not in the legend
    Style style = Style::line;
    std::vector<double> x{}, y{};       // in the axes' units
    std::optional<std::size_t> color{}; // curves of one number share a colour; else each has its own
    std::vector<double> spread{};       // of points, up and down, in y's unit; empty: none is drawn

    void add(double at, double value) {
        x.push_back(at);
        y.push_back(value);
    }
};
constexpr std::size_t colors = 6;        // that curves get in turn
constexpr std::size_t dash_patterns = 5; // the first is a solid line
struct Figure {
    std::string name; // of its files, without extension
    std::string title;
    Axis x, y;
    std::vector<Curve> curves{};
    std::vector<std::pair<double, std::string>> places{}; // of x, named at the upper edge
    double stretch = 0; // a unit of y is drawn so many times as long as one of x; 0: each axis fills the picture
};

/// A picture that is drawn elsewhere, NAME.png among the sheet's figures.
struct Picture {
    std::string name;
    std::string title;
    std::string note; // what else there is of it
};

using Part = std::variant<Heading, Paragraph, Formula, Grid, Figure, Picture>;

/// A number that the sheet rests on, under a name that stays.
struct Fact {
    std::string name;
    double value = 0;
    std::string unit; // empty: none
};

struct Sheet {
    std::vector<Part> parts{};
    std::vector<Fact> facts{};

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
};

/// The power of ten above a size that is only rounding: "1e-13"; at least 1e-16.
std::string at_most(double size);

} // namespace tumble::sheet
