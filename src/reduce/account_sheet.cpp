#include "reduce/account.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::reduce {

namespace {

std::string error_words(const Error& error, bool judged) {
    if (!judged)
        return error.at_least > 0 ? fmt::format("at least {:.0f} %", 100 * error.at_least) : "-";
    if (!std::isfinite(error.relative))
        return "lost";
    const int digits = error.uncertainty < 0.1 || !std::isfinite(error.uncertainty) ? 1 : 0;
    const std::string size =
        std::isfinite(error.uncertainty)
            ? fmt::format("{:+.{}f} ± {:.{}f} %", 100 * error.relative, digits, 100 * error.uncertainty, digits)
            : fmt::format("{:+.1f} %", 100 * error.relative);
    return error.told_apart() ? size : "(" + size + ")";
}

std::string value_words(const Spread& spread, double uncertainty) {
    return std::isfinite(uncertainty) ? fmt::format("{:.3g} ± {:.2g}", spread.mean, uncertainty)
                                      : fmt::format("{:.3g}", spread.mean);
}

/// Whether any row has a value of it; what no row has is left to the files.
bool shows(const Account& account, std::size_t quantity) {
    for (std::size_t k = 0; k < account.priced.size(); ++k) {
        const Price& price = account.prices.rungs[k];
        if (account.priced[k] == account.reference ? std::isfinite(price.spreads[quantity].mean)
                                                   : price.errors[quantity].at_least > 0)
            return true;
    }
    return account.prices.judged[quantity];
}

sheet::Grid table_of(const Account& account) {
    sheet::Grid grid;
    grid.columns = {{"scene"}, {"verdict"}, {"bodies"}, {"core", "s", 3}, {"speed-up", "", 3}, {"overlap", "%", 2}};
    const auto& quantities = account.climb.stick.quantities();
    std::vector<std::size_t> shown;
    for (std::size_t q = 0; q < quantities.size(); ++q)
        if (shows(account, q)) {
            shown.push_back(q);
            grid.columns.push_back({quantities[q].name, quantities[q].unit});
        }
    for (std::size_t k = 0; k < account.priced.size(); ++k) {
        const Climbed& climbed = account.climb.rungs[account.priced[k]];
        const Price& price = account.prices.rungs[k];
        const bool reference = account.priced[k] == account.reference;
        std::vector<sheet::Cell> row{climbed.rung.name,
                                     reference ? "reference" : word_of(price.verdict),
                                     fmt::format("{:.0f}", climbed.bodies),
                                     climbed.core_s(),
                                     price.speed_up,
                                     100 * climbed.overlap()};
        for (const std::size_t q : shown)
            row.emplace_back(reference ? value_words(price.spreads[q], account.prices.reference_spread[q])
                                       : error_words(price.errors[q], account.prices.judged[q]));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

/// Error against speed-up, a curve per quantity, and the limits.
sheet::Figure figure_of(const Account& account) {
    sheet::Figure figure;
    figure.name = "reduction";
    figure.title = account.scene.stem().string() + ": what a reduction costs";
    figure.x = {"speed-up"};
    figure.y = {"error", "%"};
    const auto& quantities = account.climb.stick.quantities();
    double most = 1;
    for (const Price& price : account.prices.rungs)
        most = std::max(most, price.speed_up);
    // Side by side: errors of one rung would hide each other. All of them together take 3 % of the axis.
    const double apart = 0.03 * std::max(most - 1, 0.1) / static_cast<double>(quantities.size());
    for (std::size_t q = 0; q < quantities.size(); ++q) {
        if (!account.prices.judged[q])
            continue;
        sheet::Curve curve{.label = quantities[q].name, .style = sheet::Style::points};
        for (const Price& price : account.prices.rungs)
            if (price.errors[q].uncertainty > 0 && std::isfinite(price.errors[q].uncertainty)) { // not the reference
                const double aside =
                    apart * (static_cast<double>(q) - 0.5 * static_cast<double>(quantities.size() - 1));
                curve.add(price.speed_up + aside, 100 * price.errors[q].relative);
                curve.spread.push_back(100 * price.errors[q].uncertainty);
            }
        figure.curves.push_back(std::move(curve));
    }
    const double beyond = 0.05 * std::max(most - 1, 0.1);
    for (const double limit : {100 * account.tolerance, -100 * account.tolerance})
        figure.curves.push_back({.label = limit > 0 ? fmt::format("limits, {:.3g} %", limit) : "",
                                 .style = sheet::Style::dashes,
                                 .x = {1 - beyond, most + beyond},
                                 .y = {limit, limit},
                                 .color = 5});
    for (std::size_t k = 0; k < account.priced.size(); ++k)
        if (account.priced[k] != account.reference) // whose errors are none
            figure.places.emplace_back(account.prices.rungs[k].speed_up,
                                       account.climb.rungs[account.priced[k]].rung.name);
    return figure;
}

void say_what_was_not_priced(const Account& account, sheet::Sheet& sheet) {
    for (std::size_t i = 0; i < account.climb.rungs.size(); ++i) {
        const Climbed& climbed = account.climb.rungs[i];
        if (std::find(account.priced.begin(), account.priced.end(), i) != account.priced.end())
            continue;
        const std::string& name = climbed.rung.name;
        if (climbed.standing == Standing::waiting)
            sheet.say(fmt::format("{}: not run to its end yet; the same command goes on from here.", name));
        else if (climbed.standing == Standing::finished)
            sheet.say(fmt::format("{}: was run, but it is no reduction of the reference.", name));
        else
            sheet.say(fmt::format("{}: {}: {}.", name,
                                  climbed.standing == Standing::refused    ? "cannot be run"
                                  : climbed.standing == Standing::left_out ? "left out"
                                                                           : "failed",
                                  climbed.reason));
    }
}

void say_what_judges(const Account& account, sheet::Sheet& sheet) {
    const auto& quantities = account.climb.stick.quantities();
    for (std::size_t q = 0; q < quantities.size(); ++q)
        if (!account.prices.judged[q])
            sheet.say(fmt::format("{} judges none of the others: {}.", quantities[q].name,
                                  std::isfinite(account.prices.reference_spread[q])
                                      ? "the reference's own is not told apart from zero, so that only a scene that "
                                        "surely has more of it is beyond"
                                      : "the reference does not have it in this stretch of time"));
}

std::string conclusion(const Account& account, bool unsure) {
    const auto cheapest = account.cheapest();
    if (!cheapest)
        return fmt::format("No reduction tried stays within {:.3g} %.", 100 * account.tolerance);
    const Price& price = account.prices.rungs[*account.prices.cheapest];
    const std::string what =
        fmt::format("{}, {:.3g} times as fast", account.climb.rungs[*cheapest].rung.name, price.speed_up);
    if (account.sure())
        return fmt::format("The cheapest that stays within {:.3g} %, its uncertainty included: {}.",
                           100 * account.tolerance, what);
    const auto needed = account.seeds_needed();
    const std::string more =
        needed ? fmt::format("--seeds {} would tell, if errors and scatter stay as they are", *needed)
               : fmt::format("many more seeds, of the reference too (at least {}), or a longer --time would tell",
                             seeds_to_be_sure);
    return fmt::format(
        "The cheapest that seems to stay within {:.3g} %: {}. Its errors are below that, but not surely: "
        "{}. {}",
        100 * account.tolerance, what, more,
        unsure ? "It is written even so." : "--unsure writes it as a scene even so.");
}

} // namespace

sheet::Sheet sheet_of(const Account& account, bool unsure) {
    sheet::Sheet sheet;
    const Climb& climb = account.climb;
    if (climb.stopped)
        sheet.say(
            fmt::format("Interrupted: {} of {} runs are made, and this is what they say. The same command goes on "
                        "from here.",
                        climb.made, climb.all));
    if (!account.reference) {
        sheet.say("Nothing is finished yet, so there is nothing to compare.");
        say_what_was_not_priced(account, sheet);
        return sheet;
    }
    sheet.parts.emplace_back(table_of(account));
    const std::size_t references = climb.rungs[*account.reference].runs.size();
    const std::string aside =
        static_cast<int>(references) == account.seeds ? "" : fmt::format(" ({} of the reference)", references);
    sheet.say(
        fmt::format("Means from {:.4g} to {:.4g} s over {} seeds{}. Errors are those against the reference, ± half of "
                    "a 95 % interval; one in brackets is not told apart from chance.",
                    climb.stick.from(), climb.stick.until(), account.seeds, aside));
    if (!account.reference_is_whole())
        sheet.say(
            fmt::format("The scene as written was not run to its end: errors are against \"{}\", the fullest that "
                        "was, and how far that is off is not known.",
                        climb.rungs[*account.reference].rung.name));
    say_what_judges(account, sheet);
    say_what_was_not_priced(account, sheet);
    sheet.say((climb.stopped ? "So far: " : "") + conclusion(account, unsure));
    const auto& judged = account.prices.judged;
    if (account.priced.size() > 1 && std::find(judged.begin(), judged.end(), true) != judged.end())
        sheet.parts.emplace_back(figure_of(account));
    return sheet;
}

} // namespace tumble::reduce
