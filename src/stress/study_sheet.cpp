#include "stress/study_sheet.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::stress {

namespace {

using fem::Slice;
using fem::SliceFigures;

/// Mean over the cases and its standard error as if they were independent.
struct Mean {
    double value = 0;
    double error = 0;
};

Mean mean_of(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (const double value : values)
        sum += value;
    const auto n = static_cast<double>(values.size());
    const double mean = sum / n;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return {mean, n > 1 ? std::sqrt(squares / (n - 1) / n) : 0};
}

template <class Value> Mean over_cases(const Study& study, std::size_t slice, Value value) {
    std::vector<double> values;
    for (const Case& now : study.cases)
        if (const double here = value(now.slices[slice]); std::isfinite(here))
            values.push_back(here);
    return values.empty() ? Mean{std::numeric_limits<double>::quiet_NaN(), 0} : mean_of(values);
}

std::string depth_name(const Slice& slice) {
    return fmt::format("{:.4g} mm", 1e3 * slice.depth);
}

/// "side.0.5" for facts.
std::string key_of(const Slice& slice, const char* what) {
    return fmt::format("{}_{}_{}mm", what, slice.side, fmt::format("{:.4g}", 1e3 * slice.depth));
}

double percent_less(double now, double first) {
    return first > 0 ? 100 * (1 - now / first) : std::numeric_limits<double>::quiet_NaN();
}

sheet::Grid decay(const Study& study, sheet::Sheet& sheet) {
    sheet::Grid grid{{{"side"},
                      {"depth", "mm"},
                      {"normal", "Pa"},
                      {"+-", "Pa", 2},
                      {"contour", "Pa"},
                      {"along", "Pa"},
                      {"less normal", "%", 3},
                      {"contour", "%", 3},
                      {"along", "%", 3}}};
    std::size_t first = 0; // of this side
    for (std::size_t s = 0; s < study.slices.size(); ++s) {
        const Slice& slice = study.slices[s];
        if (slice.side != study.slices[first].side)
            first = s;
        const auto normal = [](const SliceFigures& f) { return std::abs(f.normal); };
        const auto contour = [](const SliceFigures& f) { return f.contour; };
        const auto along = [](const SliceFigures& f) { return f.along; };
        const Mean n = over_cases(study, s, normal), c = over_cases(study, s, contour), a = over_cases(study, s, along);
        grid.rows.push_back({slice.side, 1e3 * slice.depth, n.value, n.error, c.value, a.value,
                             percent_less(n.value, over_cases(study, first, normal).value),
                             percent_less(c.value, over_cases(study, first, contour).value),
                             percent_less(a.value, over_cases(study, first, along).value)});
        sheet.fact(key_of(slice, "normal"), n.value, "Pa");
        sheet.fact(key_of(slice, "normal_error"), n.error, "Pa");
        sheet.fact(key_of(slice, "contour"), c.value, "Pa");
        sheet.fact(key_of(slice, "along"), a.value, "Pa");
    }
    return grid;
}

sheet::Grid signs(const Study& study, sheet::Sheet& sheet) {
    sheet::Grid grid{{{"side"},
                      {"depth", "mm"},
                      {"most compression", "Pa"},
                      {"most tension", "Pa"},
                      {"mean compression", "Pa"},
                      {"mean tension", "Pa"},
                      {"compressive", "%", 3},
                      {"points in compression", "", 3},
                      {"in tension", "", 3}}};
    for (std::size_t s = 0; s < study.slices.size(); ++s) {
        const Slice& slice = study.slices[s];
        const auto mean = [&](auto value) { return over_cases(study, s, value).value; };
        const double share = mean([](const SliceFigures& f) { return f.compressive_share(); });
        grid.rows.push_back({slice.side, 1e3 * slice.depth, mean([](const SliceFigures& f) { return f.compression; }),
                             mean([](const SliceFigures& f) { return f.tension; }),
                             mean([](const SliceFigures& f) { return f.mean_compression; }),
                             mean([](const SliceFigures& f) { return f.mean_tension; }), 100 * share,
                             mean([](const SliceFigures& f) { return static_cast<double>(f.compressed); }),
                             mean([](const SliceFigures& f) { return static_cast<double>(f.stretched); })});
        sheet.fact(key_of(slice, "compressive_share"), share);
    }
    return grid;
}

sheet::Grid edges(const Study& study, sheet::Sheet& sheet) {
    sheet::Grid grid{{{"side"},
                      {"depth", "mm"},
                      {"near edges", "Pa"},
                      {"+-", "Pa", 2},
                      {"elsewhere", "Pa"},
                      {"+-", "Pa", 2},
                      {"ratio", "", 3}}};
    for (std::size_t s = 0; s < study.slices.size(); ++s) {
        const Slice& slice = study.slices[s];
        const Mean near = over_cases(study, s, [](const SliceFigures&f) { return f.near_edges; }),
                   rest = over_cases(study, s, [](const SliceFigures&f) { return f.elsewhere; });
        grid.rows.push_back(
            {slice.side, 1e3 * slice.depth, near.value, near.error, rest.value, rest.error, near.value / rest.value});
        sheet.fact(key_of(slice, "near_edges"), near.value, "Pa");
        sheet.fact(key_of(slice, "elsewhere"), rest.value, "Pa");
    }
    return grid;
}

/// The touches of the body that pressed hardest, as the thesis' figures 7.20 to 7.23.
sheet::Figure impact_over_time(const observe::Impacts& impacts) {
    sheet::Figure figure{"impact",
                         fmt::format("Touches of body {}, that pressed hardest", impacts.hardest.front().body),
                         {"time", "s"},
                         {"largest force", "N"}};
    sheet::Curve normal{"normal", sheet::Style::points}, shear{"shear", sheet::Style::points};
    for (const observe::Touching& touch : impacts.hardest) {
        normal.add(touch.begin, touch.peak_normal);
        shear.add(touch.begin, touch.peak_shear);
    }
    figure.curves = {std::move(normal), std::move(shear)};
    return figure;
}

void tell_impacts(const observe::Impacts& impacts, sheet::Sheet& sheet) {
    if (impacts.touches == 0)
        return;
    sheet.head("Impact and sliding steps (7.5.2)");
    sheet.say(fmt::format(
        "{} touches in {} rows, an impact step and what slides after it. In {} of them the largest normal force is "
        "above the largest shear force. Impact steps press with {} at most in the mean, sliding steps with {}; of {} "
        "rows of several touches the first presses hardest in {}. All touches' shear impulse is {:.3g} of their normal "
        "one.",
        impacts.touches, impacts.rows, impacts.normal_above, format_si(impacts.impact_normal, "N", 3),
        format_si(impacts.sliding_normal, "N", 3), impacts.slid, impacts.first_strongest,
        impacts.shear_impulse / impacts.normal_impulse));
    sheet.fact("touches", impacts.touches);
    sheet.fact("rows", impacts.rows);
    sheet.fact("normal_above_shear", impacts.normal_above);
    sheet.fact("rows_of_several", impacts.slid);
    sheet.fact("first_strongest", impacts.first_strongest);
    sheet.fact("impact_normal", impacts.impact_normal, "N");
    sheet.fact("sliding_normal", impacts.sliding_normal, "N");
    sheet.fact("normal_impulse", impacts.normal_impulse, "N s");
    sheet.fact("shear_impulse", impacts.shear_impulse, "N s");
    if (!impacts.hardest.empty())
        sheet.parts.emplace_back(impact_over_time(impacts));
}

sheet::Figure over_time(const Study& study) {
    sheet::Figure figure{
        "normal-stress", "Largest normal stress of each slice", {"time", "s"}, {"normal stress", "kPa"}};
    for (std::size_t s = 0; s < study.slices.size(); ++s) {
        sheet::Curve curve{fmt::format("{}, {}", study.slices[s].side, depth_name(study.slices[s]))};
        for (const Case& now : study.cases)
            curve.add(now.time, 1e-3 * now.slices[s].normal);
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

sheet::Figure loads_over_time(const Study& study) {
    sheet::Figure figure{"loads", "Force of the media on the part", {"time", "s"}, {"force", "N"}};
    for (const auto& [axis, label] : {std::pair{0, "x"}, std::pair{1, "y"}, std::pair{2, "z"}}) {
        sheet::Curve curve{label};
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
    sheet::Curve normal{"normal"}, shear{"shear"}, both{"magnitude"};
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
        sheet::Curve curve{label};
        for (const Case& now : study.cases)
            curve.add(now.time, 1e-3 * now.*member);
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

void tell_contacts(const Study& study, sheet::Sheet& sheet) {
    std::vector<double> normal, shear, contacts, facet_normal, facet_shear, surface_normal, surface_shear;
    int normal_above = 0;
    for (const Case& now : study.cases) {
        contacts.push_back(now.contacts);
        facet_normal.push_back(now.facet_normal);
        facet_shear.push_back(now.facet_shear);
        surface_normal.push_back(now.surface_normal);
        surface_shear.push_back(now.surface_shear);
        if (!now.strongest)
            continue;
        normal.push_back(now.strongest->normal);
        shear.push_back(now.strongest->shear);
        normal_above += now.facet_normal > now.facet_shear ? 1 : 0;
    }
    if (normal.empty())
        return;
    sheet.say(fmt::format(
        "At an instant {:.3g} places touch. The strongest of them presses with {} and shears with {}, in the mean of "
        "the "
        "instants; spread over their facets that is {} and {} at most, and in {} of {} instants the largest normal "
        "stress of a facet is above its largest shear stress.",
        mean_of(contacts).value, format_si(mean_of(normal).value, "N", 3), format_si(mean_of(shear).value, "N", 3),
        format_si(mean_of(facet_normal).value, "Pa", 3), format_si(mean_of(facet_shear).value, "Pa", 3), normal_above,
        normal.size()));
    sheet.fact("contacts", mean_of(contacts).value);
    sheet.fact("facet_normal", mean_of(facet_normal).value, "Pa");
    sheet.fact("facet_shear", mean_of(facet_shear).value, "Pa");
    sheet.fact("surface_normal", mean_of(surface_normal).value, "Pa");
    sheet.fact("surface_shear", mean_of(surface_shear).value, "Pa");
}

double largest(const Study& study, double Case::*member) {
    double most = 0;
    for (const Case& now : study.cases)
        most = std::max(most, now.*member);
    return most;
}

/// How the contacts' forces were laid on the part, and what the mesh makes of it.
void tell_patches(const Study& study, sheet::Sheet& sheet) {
    sheet.fact("patch_radius", study.patch, "m");
    sheet.fact("facet_width", study.facet, "m");
    if (study.patch <= 0) {
        sheet.say("Forces act at points: a finer mesh gives larger stresses near them, without end.");
        return;
    }
    sheet.say(fmt::format(
        "Forces act as Hertz' pressure on circles of {:.3g} mm radius, on facets {:.3g} mm wide (means that the forces "
        "weigh){}",
        1e3 * study.patch, 1e3 * study.facet,
        study.facet < study.patch
            ? "."
            : ": the facets spread them wider, so that stresses nearer than a facet's width to a contact are the "
              "mesh's. `--remesh` with more of them tells."));
}

} // namespace

sheet::Sheet sheet_of(const Study& study, const StudyOptions& options) {
    sheet::Sheet sheet;
    sheet.say(fmt::format(
        "{} {} of the media on {} {} hexahedra with {} nodes ({} unknowns): factorised in {:.2f} s, loads laid on in "
        "{:.2f} s, solved in {:.2f} s. "
        "Forces left over at free nodes: at most {:.1e} of the case's largest; loads and supports miss equilibrium by "
        "{:.1e} at most.",
        study.cases.size(), options.means ? "mean loads" : "instants", study.hexes,
        options.formulation == fem::Formulation::standard ? "standard" : "incompatible", study.nodes, study.unknowns,
        study.prepare_s, study.load_s, study.solve_s, largest(study, &Case::residual),
        largest(study, &Case::unbalance)));
    for (const std::string& warning : study.warnings)
        sheet.say("Warning: " + warning + ".");
    sheet.fact("cases", static_cast<double>(study.cases.size()));
    sheet.fact("residual", largest(study, &Case::residual));
    sheet.fact("unbalance", largest(study, &Case::unbalance));
    sheet.fact("deflection", largest(study, &Case::deflection), "m");
    sheet.fact("von_mises", largest(study, &Case::von_mises), "Pa");
    sheet.fact("prepare", study.prepare_s, "s");
    sheet.fact("load", study.load_s, "s");
    sheet.fact("solve", study.solve_s, "s");
    tell_contacts(study, sheet);
    tell_patches(study, sheet);
    tell_impacts(study.impacts, sheet);
    sheet.head("Decay with depth (the thesis' table 7.3)");
    sheet.say(fmt::format("Means over the cases of the largest stress of each slice{}, with the standard error of "
                          "independent cases.",
                          options.counting.lower < 1
                              ? fmt::format(", of the lowest {:.3g} of the part's length", options.counting.lower)
                              : ""));
    sheet.parts.emplace_back(decay(study, sheet));
    sheet.head("Compression and tension (tables 7.4 and 7.5)");
    sheet.say(
        fmt::format("Means over the cases; normal stresses within {:.4g} Pa are left out, and `compressive` is the "
                    "share of the mean compression in both means.",
                    options.counting.trivial));
    sheet.parts.emplace_back(signs(study, sheet));
    sheet.head("Near the edges and elsewhere");
    sheet.say(
        fmt::format("Means over the cases of the normal stress' size, over the area of a slice within {:.3g} mm of "
                    "where its side ends, and over the rest.",
                    1e3 * options.counting.edge));
    sheet.parts.emplace_back(edges(study, sheet));
    sheet.parts.emplace_back(over_time(study));
    if (!options.means) // what touches is known of instants
        for (sheet::Figure figure : {average_over_time(study), surface_over_time(study)})
            sheet.parts.emplace_back(std::move(figure));
    sheet.parts.emplace_back(loads_over_time(study));
    return sheet;
}

} // namespace tumble::stress
