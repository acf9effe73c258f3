#pragma once

#include "observe/measures.h"
#include "observe/tracer.h"
#include "render/plot_line.h"
#include "scene/scene.h"
#include "view/source.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace tumble::view {

/// Measures over time, beside the picture: energies, slope, circulation, and the height of the scene's first tracer.
class Plots {
public:
    /// Grow with every moment that is seen. `layout` finds the tracer.
    static Plots of_simulation(const scene::Scene& scene, const observe::FrameLayout& layout);
    /// From series.csv, all of it; what is not in there is left out.
    static Plots of_run(const std::filesystem::path& run, const scene::Scene& scene);

    void take(const Moment& moment);
    [[nodiscard]] const std::vector<render::PlotLine>& lines() const { return lines_; }

private:
    void thin_out();

    std::vector<observe::Measure> measures_;
    std::optional<observe::TracerReader> tracer_;
    std::vector<render::PlotLine> lines_; // parallel to the measures; that of the tracer last
    bool grows_ = false;
};

} // namespace tumble::view
