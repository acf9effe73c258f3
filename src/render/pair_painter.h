#pragma once

#include "render/sheet.h"

#include <array>
#include <string>

namespace tumble::render {

/// Draws frames of two runs side by side, or one above the other where a wide flat scene is larger so: a label over
/// each, one view, one scale, one legend and one clock for both. Of pixels or of lines.
template <class Medium> class PairPainterOf {
public:
    using Layouts = std::array<std::shared_ptr<const observe::FrameLayout>, 2>;

    /// Problems: those of the medium's artist, settings without a range (both need the same colours), a picture too
    /// small for lettering.
    static Result<PairPainterOf> open(const scene::Render& settings, const Layouts& layouts,
                                      const std::array<std::string, 2>& labels);

    /// Makes sure that a box (m) is in both halves.
    void fit(const Eigen::AlignedBox3d& box);

    /// As those of Painter, for the left (0) or the right (1).
    void foresee(std::size_t side, const observe::Frame& frame);
    void expect_pace(double every);
    void pass_over(std::size_t side, const observe::Frame& frame);

    /// The time shown is the left frame's.
    typename Medium::Work draw(const observe::Frame& left, const observe::Frame& right);

    /// Where the halves lie, pixels.
    [[nodiscard]] const std::array<Area, 2>& halves() const;

private:
    struct Inside;
    explicit PairPainterOf(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}
    std::shared_ptr<Inside> inside_;
};

using PairPainter = PairPainterOf<Pixels>;
using PairDrafter = PairPainterOf<Lines>;

} // namespace tumble::render
