#pragma once

#include "render/sheet.h"

#include <memory>
#include <string>
#include <vector>

namespace tumble::render {

/// Cells of a strip: so many, in rows of so many; 0: as many as show the scene largest.
struct StripPlan {
    int cells = 1;
    int columns = 0;
    std::string note{};                  // above them, in a few words: what they have in common
    std::vector<std::string> captions{}; // that are to come under them, as far as they are known
};

/// Draws several pictures of one run into one: a view, a scale and a legend for all, a few words under each. Of pixels
/// or of lines.
template <class Medium> class StripPainterOf {
public:
    /// `box` (m) must be in each cell. The picture is as wide as the settings say, and no higher than it needs to be.
    /// Problems: those of the medium's artist, settings without a range (all cells need the same colours), cells too
    /// small to be told apart.
    static Result<StripPainterOf> open(const scene::Render& settings,
                                       std::shared_ptr<const observe::FrameLayout> layout,
                                       const Eigen::AlignedBox3d& box, const StripPlan& plan);

    /// As those of Painter, for frames in between.
    void foresee(const observe::Frame& frame);
    void expect_pace(double every);
    void pass_over(const observe::Frame& frame);

    /// Another clip from the next cell on, and another mean field. Problems: those of Painter::restyle.
    Result<Done> cut(const scene::Box& clip);
    /// The next cell, from the left, then from the top.
    void add(const observe::Frame& frame, const std::string& words);

    /// All cells with the lettering.
    typename Medium::Work finish();

    /// Where the cells lie, pixels.
    [[nodiscard]] const std::vector<Area>& cells() const;

private:
    struct Inside;
    explicit StripPainterOf(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}
    std::shared_ptr<Inside> inside_;
};

using StripPainter = StripPainterOf<Pixels>;
using StripDrafter = StripPainterOf<Lines>;

} // namespace tumble::render
