#include "stress/study_figures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace tumble::stress {

namespace {

std::string depth_name(const fem::Slice& slice) {
    return fmt::format("{:.4g} mm", 1e3 * slice.depth);
}

/// Instants are samples, far apart for contacts of a millisecond: a line would make a signal of them. Means follow on
/// one another.
sheet::Style style_of(const Study& study) {
    return study.cases.front().window > 0 ? sheet::Style::line : sheet::Style::points;
}

/// Titles of means say so.
std::string titled(const std::string& words, const Study& study) {
    double window = 0; // s; the first may be shorter
    for (const Case& now : study.cases)
        window = std::max(window, now.window);
    return window > 0 ? fmt::format("{}: mean loads of {:.3g} ms", words, 1e3 * window) : words;
}

/// More slices than there are colours would be a thicket: then the shallowest of each side stands for it. Those of one
/// side go on in dashes.
sheet::Figure over_time(const Study& study) {
    std::map<std::string, double> shallowest; // m, by side
    for (const fem::Slice& slice : study.slices) {
        const auto side = shallowest.try_emplace(slice.side, slice.depth).first;
        side->second = std::min(side->second, slice.depth);
    }
    const bool all = study.slices.size() <= sheet::colors || shallowest.size() == 1;
    sheet::Figure figure{"normal-stress",
                         titled(all ? "Largest normal stress of each slice"
                                    : "Largest normal stress of each side's shallowest slice (slices.csv has all)",
                                study),
                         {"time", "s"},
                         {"normal stress", "kPa"}};
    for (std::size_t s = 0; s < study.slices.size(); ++s) {
        const fem::Slice& slice = study.slices[s];
        if (!all && slice.depth > shallowest.at(slice.side))
            continue;
        const sheet::Style style = style_of(study);
        sheet::Curve curve{
            fmt::format("{}, {}", slice.side, depth_name(slice)),
            style == sheet::Style::points || figure.curves.size() < sheet::colors ? style : sheet::Style::dashes};
        for (const Case& now : study.cases)
            curve.add(now.time, 1e-3 * now.slices[s].normal);
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

sheet::Figure loads_over_time(const Study& study) {
    sheet::Figure figure{"loads", titled("Force of the media on the part", study), {"time", "s"}, {"force", "N"}};
    for (const auto& [axis, label] : {std::pair{0, "x"}, std::pair{1, "y"}, std::pair{2, "z"}}) {
        sheet::Curve curve{label, style_of(study)};
        for (const Case& now : study.cases)
            curve.add(now.time, now.force[axis]);
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

/// As the thesis' figures 7.15 and 7.19 show them.
sheet::Figure average_over_time(const Study& study) {
    sheet::Figure figure{
        "surface-average", "Mean stresses of the part's surface", {"time", "s"}, {"force over all area", "kPa"}};
    const sheet::Style style = style_of(study);
    sheet::Curve normal{"normal", style}, shear{"shear", style}, both{"magnitude", style};
    for (const Case& now : study.cases) {
        normal.add(now.time, 1e-3 * now.surface_normal);
        shear.add(now.time, 1e-3 * now.surface_shear);
        both.add(now.time, 1e-3 * std::hypot(now.surface_normal, now.surface_shear));
    }
    figure.curves = {std::move(normal), std::move(shear), std::move(both)};
    return figure;
}

sheet::Figure surface_over_time(const Study& study) {
    sheet::Figure figure{
        "surface-stress", "Largest stresses of a facet, and inside the part", {"time", "s"}, {"stress", "kPa"}};
    for (const auto& [member, label] : {std::pair{&Case::facet_normal, "normal, force over area"},
                                        std::pair{&Case::facet_shear, "shear, force over area"},
                                        std::pair{&Case::von_mises, "von Mises, of all nodes"}}) {
        sheet::Curve curve{label, style_of(study)};
        for (const Case& now : study.cases)
            curve.add(now.time, 1e-3 * now.*member);
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

} // namespace

sheet::Figure impact_figure(const observe::Impacts& impacts) {
    sheet::Figure figure{
        "impact",
        fmt::format("Touches of body {}, that pressed hardest, at their peaks", impacts.hardest.front().body),
        {"time", "s"},
        {"largest force", "N"}};
    sheet::Curve normal{"normal", sheet::Style::points}, shear{"shear", sheet::Style::points};
    for (const observe::Touching& touch : impacts.hardest) {
        normal.add(touch.peak_normal_time, touch.peak_normal);
        shear.add(touch.peak_shear_time, touch.peak_shear);
    }
    figure.curves = {std::move(normal), std::move(shear)};
    return figure;
}

std::vector<sheet::Figure> time_figures(const Study& study, bool means) {
    std::vector<sheet::Figure> figures{over_time(study)};
    if (!means) { // what touches is known of instants
        figures.push_back(average_over_time(study));
        figures.push_back(surface_over_time(study));
    }
    figures.push_back(loads_over_time(study));
    return figures;
}

} // namespace tumble::stress
