#include "stress/study_sheet.h"

#include "base/text.h"
#include "stress/study_figures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numbers>
#include <set>

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
                      {"of cases"},
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
                             static_cast<double>(std::count_if(
                                 study.cases.begin(), study.cases.end(),
                                 [&](const Case& now) { return std::isfinite(now.slices[s].compressive_share()); })),
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
    if (impacts.hardest.empty())
        return;
    if (std::isfinite(impacts.hardest.front().peak_normal_time))
        sheet.parts.emplace_back(impact_figure(impacts));
    else
        sheet.say("There is no impact.png: touches.csv is of before the times of the peaks were kept.");
}

// Force over a facet's area is within so much of the mean pressure on the patch: no warning.
constexpr double about_a_patch = 2;

/// What force over a facet's area makes of the pressure where bodies touch.
void warn_of_facets(const Study& study, sheet::Sheet& sheet) {
    if (!(study.patch > 0 && study.facet > 0))
        return;
    const double patch = std::numbers::pi * study.patch * study.patch, facet = study.facet * study.facet; // m2
    sheet.fact("facet_areas_a_patch", patch / facet);
    if (patch > about_a_patch * facet)
        sheet.say(fmt::format("Warning: facets are narrower than the circles in which bodies touch, each of which has "
                              "{0:.3g} times a facet's area, but all of a contact's force counts on one facet: force "
                              "over area, here and in facets.csv, is {0:.3g} times a circle's mean pressure.",
                              patch / facet));
    else if (facet > about_a_patch * patch)
        sheet.say(fmt::format("Warning: facets have {0:.3g} times the area of the circles in which bodies touch: force "
                              "over area, here and in facets.csv, is {0:.3g} times less than a circle's mean pressure.",
                              facet / patch));
}

/// Means over all instants, those at which nothing touches among them.
void tell_contacts(const Study& study, sheet::Sheet& sheet) {
    std::vector<double> normal, shear, contacts, facet_normal, facet_shear, surface_normal, surface_shear;
    int touched = 0, normal_above = 0;
    for (const Case& now : study.cases) {
        contacts.push_back(now.contacts);
        facet_normal.push_back(now.facet_normal);
        facet_shear.push_back(now.facet_shear);
        surface_normal.push_back(now.surface_normal);
        surface_shear.push_back(now.surface_shear);
        normal.push_back(now.strongest ? now.strongest->normal : 0);
        shear.push_back(now.strongest ? now.strongest->shear : 0);
        touched += now.strongest ? 1 : 0;
        normal_above += now.strongest && now.facet_normal > now.facet_shear ? 1 : 0;
    }
    if (touched == 0)
        return;
    sheet.say(fmt::format(
        "Something touches the part at {} of {} instants; in the mean of all of them {:.3g} places do. The strongest "
        "presses with {} and shears with {} in that mean; spread over their facets that is {} and {} at most, along "
        "and across the facet's normal. At {} of the {} instants with contacts the largest normal stress of a facet is "
        "above its largest shear stress.",
        touched, study.cases.size(), mean_of(contacts).value, format_si(mean_of(normal).value, "N", 3),
        format_si(mean_of(shear).value, "N", 3), format_si(mean_of(facet_normal).value, "Pa", 3),
        format_si(mean_of(facet_shear).value, "Pa", 3), normal_above, touched));
    sheet.fact("contacts", mean_of(contacts).value);
    sheet.fact("touched_instants", touched);
    sheet.fact("facet_normal", mean_of(facet_normal).value, "Pa");
    sheet.fact("facet_shear", mean_of(facet_shear).value, "Pa");
    sheet.fact("surface_normal", mean_of(surface_normal).value, "Pa");
    sheet.fact("surface_shear", mean_of(surface_shear).value, "Pa");
    warn_of_facets(study, sheet);
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

std::string in_mm(const Eigen::Vector3d& place) {
    return fmt::format("({:.5g}, {:.5g}, {:.5g}) mm", 1e3 * place.x(), 1e3 * place.y(), 1e3 * place.z());
}

std::string times_of(const Study& study) {
    const Case& first = study.cases.front();
    return fmt::format("from {:.4g} to {:.4g} s", first.time - first.window, study.cases.back().time);
}

/// What of the worst stress may be an edge's. `edge`: m, Counting::edge.
void tell_edges(const Study& study, double edge, sheet::Sheet& sheet) {
    if (study.away)
        sheet.fact("von_mises_away_from_edges", study.away->von_mises, "Pa");
    if (!std::isfinite(study.worst_edge))
        return;
    sheet.fact("worst_edge_distance", study.worst_edge, "m");
    if (study.worst_edge > edge) {
        sheet.say(fmt::format("That node lies {:.3g} mm from the part's nearest edge.", 1e3 * study.worst_edge));
        return;
    }
    sheet.say(fmt::format(
        "That node lies {:.3g} mm from an edge of the part, within {:.3g} mm: there the circles in which bodies touch "
        "are clipped and the mesh has its corners, so that this stress is theirs rather than the part's. {}",
        1e3 * study.worst_edge, 1e3 * edge,
        study.away ? fmt::format("Farther from all edges the largest is {}, at {:.6g} s, at node {}, {}.",
                                 format_si(study.away->von_mises, "Pa", 3), study.away->time, study.away->node,
                                 in_mm(study.away->place))
                   : "No node lies farther from all edges."));
}

/// The worst case, where it is and what touches then.
void tell_worst(const Study& study, sheet::Sheet& sheet) {
    const Case& worst = study.cases[study.worst.index];
    const std::string when =
        worst.window > 0 ? fmt::format("in the mean of the {:.3g} ms before {:.6g} s", 1e3 * worst.window, worst.time)
                         : fmt::format("at {:.6g} s", worst.time);
    std::string touch;
    if (worst.strongest)
        touch = fmt::format(" The strongest contact of that instant is body {}'s, on face {} of element {} at {}: it "
                            "presses with {} and shears with {}.",
                            worst.strongest->body, worst.strongest->face, worst.strongest->element,
                            in_mm(worst.strongest->foot), format_si(worst.strongest->normal, "N", 3),
                            format_si(worst.strongest->shear, "N", 3));
    const std::string of = fmt::format("of the {} {}", study.cases.size(), worst.window > 0 ? "means" : "instants");
    sheet.say(fmt::format("The largest von Mises stress {0} is {1}, {2}, at node {3}, {4}.{5} The largest deflection "
                          "{0} is {6}.",
                          of, format_si(worst.von_mises, "Pa", 3), when, study.worst_node, in_mm(study.worst_place),
                          touch, format_si(largest(study, &Case::deflection), "m", 3)));
    sheet.fact("worst_time", worst.time, "s");
    sheet.fact("worst_node", study.worst_node);
    sheet.fact("worst_x", study.worst_place.x(), "m");
    sheet.fact("worst_y", study.worst_place.y(), "m");
    sheet.fact("worst_z", study.worst_place.z(), "m");
}

constexpr double most_of_it = 0.5; // of the contacts' force, on a side that no slice lies beneath

/// Beneath which sides slices lie, and whether the media press there.
void tell_sides(const Study& study, sheet::Sheet& sheet) {
    std::set<std::string> sides;
    for (const Slice& slice : study.slices)
        sides.insert(slice.side);
    double there = 0;
    std::string hint;
    for (const auto& [side, share] : study.pressed) {
        there += sides.contains(side) ? share : 0;
        if (!sides.contains(side) && share > most_of_it)
            hint = fmt::format(" Most of it, {:.3g} %, acts on '{}': `--side {}` looks beneath that.", 100 * share,
                               side, side);
    }
    sheet.say(fmt::format("Slices lie beneath '{}', where {:.3g} % of the contacts' force acts.{}",
                          fmt::join(sides, "', '"), 100 * there, hint));
    sheet.fact("force_on_sliced_sides", there);
}

} // namespace

sheet::Sheet sheet_of(const Study& study, const StudyOptions& options) {
    sheet::Sheet sheet;
    sheet.say(fmt::format(
        "{} {} of the media, {}, on {} {} hexahedra with {} nodes ({} unknowns): factorised in {:.2f} s, loads laid on "
        "in "
        "{:.2f} s, solved in {:.2f} s. "
        "Forces left over at free nodes: at most {:.1e} of the case's largest; loads and supports miss equilibrium by "
        "{:.1e} at most.",
        study.cases.size(), options.means ? "mean loads" : "instants", times_of(study), study.hexes,
        options.formulation == fem::Formulation::standard ? "standard" : "incompatible", study.nodes, study.unknowns,
        study.prepare_s, study.load_s, study.solve_s, largest(study, &Case::residual),
        largest(study, &Case::unbalance)));
    for (const std::string& warning : study.warnings)
        sheet.say("Warning: " + warning + ".");
    for (const std::string& doubt : study.doubts)
        sheet.say("Warning: " + doubt + ".");
    sheet.fact("cases", static_cast<double>(study.cases.size()));
    sheet.fact("residual", largest(study, &Case::residual));
    sheet.fact("unbalance", largest(study, &Case::unbalance));
    sheet.fact("deflection", largest(study, &Case::deflection), "m");
    sheet.fact("von_mises", largest(study, &Case::von_mises), "Pa");
    sheet.fact("prepare", study.prepare_s, "s");
    sheet.fact("load", study.load_s, "s");
    sheet.fact("solve", study.solve_s, "s");
    tell_worst(study, sheet);
    tell_edges(study, options.counting.edge, sheet);
    if (!options.means)
        tell_contacts(study, sheet);
    tell_patches(study, sheet);
    tell_impacts(study.impacts, sheet);
    sheet.head("Decay with depth (the thesis' table 7.3)");
    tell_sides(study, sheet);
    sheet.say(fmt::format("Means over all {} cases of the largest stress of each slice{}, with the standard error of "
                          "independent cases.",
                          study.cases.size(),
                          options.counting.lower < 1
                              ? fmt::format(", of the lowest {:.3g} of the part's length", options.counting.lower)
                              : ""));
    sheet.parts.emplace_back(decay(study, sheet));
    sheet.head("Compression and tension (tables 7.4 and 7.5)");
    sheet.say(fmt::format(
        "Means over all {} cases; normal stresses within {:.4g} Pa are left out, and a case without any has "
        "0. `compressive` is the share of the mean compression in both means, averaged over the cases that "
        "have either; how many stands beside it.",
        study.cases.size(), options.counting.trivial));
    sheet.parts.emplace_back(signs(study, sheet));
    sheet.head("Near the edges and elsewhere");
    sheet.say(
        fmt::format("Means over all {} cases of the normal stress' size, over the area of a slice within {:.3g} mm of "
                    "where its side ends, and over the rest.",
                    study.cases.size(), 1e3 * options.counting.edge));
    sheet.parts.emplace_back(edges(study, sheet));
    for (sheet::Figure& figure : time_figures(study, options.means))
        sheet.parts.emplace_back(std::move(figure));
    return sheet;
}

} // namespace tumble::stress
