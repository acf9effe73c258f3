#include "report/cause_section.h"

#include "diagnose/verdict.h"
#include "report/bar_chart.h"
#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace tumble::report {

using namespace diagnose;

namespace {

constexpr double least_fall = 1;      // of chi-square, what one number that is free takes of noise
constexpr double least_drawn = 0.005; // of the scale: 2.5 px

/// In whole numbers from a hundred on.
std::string of_chi_square(double value) {
    return value < 100 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

/// Of causes that show in these data, the largest fall of chi-square first.
std::vector<int> by_fall(const Decision& decision) {
    std::vector<int> causes;
    for (std::size_t k = 0; k < decision.seen.size(); ++k)
        if (decision.seen[k].visible)
            causes.push_back(static_cast<int>(k));
    std::stable_sort(causes.begin(), causes.end(), [&](int a, int b) {
        return decision.seen[static_cast<std::size_t>(a)].gain > decision.seen[static_cast<std::size_t>(b)].gain;
    });
    return causes;
}

bool suspected(const Decision& decision, int cause) {
    return std::find(decision.causes.begin(), decision.causes.end(), cause) != decision.causes.end();
}

/// "tilt_x, tilt_z: do not act here." for each reason.
std::string invisible_words(const Diagnosis& diagnosis) {
    std::map<std::string, std::string> of_reason;
    for (std::size_t k = 0; k < diagnosis.decision.seen.size(); ++k) {
        if (diagnosis.decision.seen[k].visible)
            continue;
        std::string& ids = of_reason[standing_of(diagnosis, static_cast<int>(k))];
        ids += (ids.empty() ? "" : ", ") + diagnosis.causes[k].id;
    }
    std::string words;
    for (const auto& [why, ids] : of_reason)
        words += fmt::format(" {}: {}.", escaped(ids), escaped(why));
    return words;
}

/// What is too short to be drawn, each with the standing that tells more than that it is far behind.
std::string short_words(const Diagnosis& diagnosis, const std::vector<int>& causes, double least) {
    std::string words;
    for (const int k : causes) {
        const std::string standing = standing_of(diagnosis, k);
        const bool tells = standing.find(" nats behind") == std::string::npos;
        words += (words.empty() ? "" : "; ") + escaped(diagnosis.causes[static_cast<std::size_t>(k)].id) +
                 (tells ? " (" + escaped(standing) + ")" : "");
    }
    return words.empty() ? "" : fmt::format(" Chi-square falls by less than {} with: {}.", of_chi_square(least), words);
}

/// The gate; beside it, where one cause is enough, the margin of the best, and where two are, how far both go.
std::pair<std::vector<Mark>, std::string> limits_of(const Diagnosis& diagnosis, double best) {
    const Decision& decision = diagnosis.decision;
    std::vector<Mark> marks{{decision.gate, "gate " + of_chi_square(decision.gate)}};
    if (decision.best && decision.best->causes.size() == 2) {
        marks.push_back({decision.best->gain, "both " + of_chi_square(decision.best->gain)});
        return {marks, " No single cause leaves nothing but noise."};
    }
    if (decision.outcome == Outcome::none_known && best > decision.gate)
        return {marks, " No cause, nor two together, leaves nothing but noise."};
    if (best <= decision.gate)
        return {marks, ""};
    const double margin = std::max(0.0, gain_behind(diagnosis.evidence, best, diagnosis.settings.margin));
    marks.push_back({margin, "margin " + of_chi_square(margin)});
    return {marks, fmt::format(" Whoever reaches the margin, {:g} nats behind the best, cannot be told from it.",
                               diagnosis.settings.margin)};
}

std::string shade(double left) {
    const int grey = static_cast<int>(255 - 110 * (1 - std::clamp(left, 0.0, 1.0)));
    return fmt::format("background:rgb(255,{0},{0})", grey);
}

} // namespace

std::string cause_section(const Diagnosis& diagnosis) {
    const Decision& decision = diagnosis.decision;
    if (decision.seen.empty())
        return "";
    const std::vector<int> causes = by_fall(decision);
    const double best = causes.empty() ? 0 : decision.seen[static_cast<std::size_t>(causes[0])].gain;
    const double least = std::max(least_fall, least_drawn * std::max(best, decision.gate));
    std::vector<Bar> bars;
    std::vector<int> left_over;
    for (const int k : causes) {
        const double fall = decision.seen[static_cast<std::size_t>(k)].gain;
        if (fall < least && !suspected(decision, k))
            left_over.push_back(k);
        else
            bars.push_back({diagnosis.causes[static_cast<std::size_t>(k)].id, standing_of(diagnosis, k),
                            suspected(decision, k) ? color_of(1) : "#9db4c4", fall});
    }
    const auto [marks, behind] = limits_of(diagnosis, best);
    const std::string chart =
        bars.empty()
            ? ""
            : svg_of(bars, marks, "fall of chi-square when the cause is added") +
                  fmt::format("<p class=\"small\">Noise alone drives the best of all causes beyond the gate in "
                              "{:g} % of cases.{}</p>",
                              100 * diagnosis.settings.alpha_gate, behind);
    return fmt::format("<h2>How far each cause of the library explains it</h2>{}<p class=\"small\">{}{}</p>", chart,
                       short_words(diagnosis, left_over, least), invisible_words(diagnosis));
}

std::string isolability_section(const Diagnosis& diagnosis) {
    const MatrixXd& left = diagnosis.decision.isolability;
    std::string head, body;
    int shown = 0;
    for (Eigen::Index i = 0; i < left.rows(); ++i) {
        if (std::isnan(left(i, i)))
            continue;
        const std::string id = diagnosis.causes[static_cast<std::size_t>(i)].id;
        ++shown;
        head += fmt::format("<th class=\"r\">{}</th>", id);
        body += fmt::format("<tr><th>{}</th>", id);
        for (Eigen::Index j = 0; j < left.cols(); ++j)
            if (!std::isnan(left(j, j)))
                body += i == j ? "<td></td>"
                               : fmt::format("<td class=\"n\" style=\"{}\">{:.2f}</td>", shade(left(i, j)), left(i, j));
        body += "</tr>";
    }
    if (shown < 2)
        return "";
    return fmt::format("<h2>What these data can tell apart</h2><p>Share of the row's effect that is left when the "
                       "column's cause is fitted in its place: 0 is the same answer, 1 cannot be mistaken. Below {:g} "
                       "two causes are one answer. Causes that these data do not show are not listed.</p><div "
                       "class=\"wide\"><table><tr><th></th>{}</tr>{}</table></div>",
                       diagnosis.settings.same_class, head, body);
}

} // namespace tumble::report
