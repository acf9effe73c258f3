#include "report/spectrum_plot.h"

#include "report/residual_plots.h"
#include "report/svg_plot.h"

#include <algorithm>

namespace tumble::report {

using namespace diagnose;

namespace {

constexpr std::size_t most_bins = 380; // px between the axes

/// A line through the largest of every few frequencies, so that no swing is lost where there are more than pixels.
Trace line_of(const Spectrum& spectrum, const std::string& label, std::size_t colour, bool dashed) {
    Trace trace{.label = label, .x = {}, .y = {}, .color = color_of(colour), .line = true, .dashed = dashed};
    const std::size_t stride = 1 + spectrum.frequency.size() / most_bins;
    for (std::size_t k = 0; k < spectrum.frequency.size(); k += stride) {
        const std::size_t end = std::min(k + stride, spectrum.frequency.size());
        const auto highest = std::max_element(spectrum.amplitude.begin() + static_cast<std::ptrdiff_t>(k),
                                              spectrum.amplitude.begin() + static_cast<std::ptrdiff_t>(end));
        trace.x.push_back(spectrum.frequency[static_cast<std::size_t>(highest - spectrum.amplitude.begin())]);
        trace.y.push_back(*highest);
    }
    return trace;
}

/// Nothing where the measure has none.
std::vector<Spectrum> spectrum_of(const VectorXd& residual, const Diagnosis& diagnosis, const std::string& measure) {
    std::vector<Course> courses;
    for (const Course& course : diagnosis.evidence.directions.courses)
        if (course.measure == measure)
            courses.push_back(course);
    return spectra_of(residual, courses);
}

} // namespace

std::vector<std::string> spectrum_plots(const Diagnosis& diagnosis, const std::string& measure,
                                        const std::string& head) {
    const Evidence& evidence = diagnosis.evidence;
    const auto before = spectrum_of(evidence.residual, diagnosis, measure);
    if (before.empty())
        return {};
    Plot plot{.title = head + ": against frequency",
              .x_label = "frequency [Hz]",
              .y_label = "swing [standard errors]",
              .traces = {line_of(before[0], "baseline", 1, false)},
              .levels = {{before[0].gate, "noise gets here in 0.27 % of cases"}},
              .band = {},
              .y_range = {}};
    if (const auto& best = diagnosis.decision.best; best && best->residual.size() == evidence.residual.size())
        plot.traces.push_back(
            line_of(spectrum_of(best->residual, diagnosis, measure)[0], second_explanation(diagnosis), 0, true));
    double most = before[0].gate;
    for (const Trace& trace : plot.traces)
        for (const double y : trace.y)
            most = std::max(most, y);
    plot.y_range = std::array{0.0, 1.1 * most};
    return {svg_of(plot)};
}

} // namespace tumble::report
