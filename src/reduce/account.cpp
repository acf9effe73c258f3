#include "reduce/account.h"

#include "base/table.h"
#include "base/text.h"
#include "observe/whole_file.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::reduce {

using Json = nlohmann::ordered_json;

namespace {

std::optional<std::size_t> find_reference(const std::vector<Climbed>& rungs) {
    std::optional<std::size_t> most;
    for (std::size_t i = 0; i < rungs.size(); ++i)
        if (rungs[i].standing == Standing::finished && (!most || rungs[i].work > rungs[*most].work))
            most = i;
    return !rungs.empty() && rungs.front().standing == Standing::finished ? std::size_t{0} : most;
}

Sample sample_of(const Climbed& rung) {
    Sample sample{{}, rung.core_s()};
    for (const Seeded& run : rung.runs)
        sample.values.push_back(run.values);
    return sample;
}

/// JSON has no number that is none.
Json number_or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

const Price* price_of(const Account& account, std::size_t rung) {
    const auto found = std::find(account.priced.begin(), account.priced.end(), rung);
    return found == account.priced.end()
               ? nullptr
               : &account.prices.rungs[static_cast<std::size_t>(found - account.priced.begin())];
}

std::string standing_word(Standing standing) {
    constexpr const char* words[] = {"waiting", "finished", "refused", "failed", "left out"};
    return words[static_cast<int>(standing)];
}

Json quantities_of(const Account& account, const Price& price, std::size_t runs) {
    Json all = Json::array();
    const auto& quantities = account.climb.stick.quantities();
    for (std::size_t q = 0; q < quantities.size(); ++q) {
        const Error& error = price.errors[q];
        all.push_back({{"name", quantities[q].name},
                       {"unit", quantities[q].unit},
                       {"mean", number_or_null(price.spreads[q].mean)},
                       {"deviation", number_or_null(runs > 1 ? price.spreads[q].deviation : std::nan(""))},
                       {"error", number_or_null(error.relative)},
                       {"uncertainty", number_or_null(error.uncertainty)},
                       {"at_least", error.at_least},
                       {"judged", static_cast<bool>(account.prices.judged[q])},
                       {"told_apart", error.told_apart()}});
    }
    return all;
}

/// "kinetic_energy_per_mass" for columns.
std::string column_of(const Quantity& quantity) {
    std::string name = quantity.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

bool judged_and_finite(const Prices& prices, const Price& price, std::size_t quantity) {
    return prices.judged[quantity] && std::isfinite(price.errors[quantity].uncertainty);
}

std::string reduced_name(const Account& account) {
    return account.scene.stem().string() + "-reduced.toml";
}

} // namespace

std::optional<std::size_t> Account::cheapest() const {
    return prices.cheapest ? std::optional(priced[*prices.cheapest]) : std::nullopt;
}

bool Account::sure() const {
    return prices.cheapest && prices.rungs[*prices.cheapest].verdict == Verdict::within;
}

std::optional<int> Account::seeds_needed() const {
    if (!prices.cheapest || sure() || static_cast<int>(climb.rungs[*reference].runs.size()) != seeds)
        return std::nullopt;
    const Price& price = prices.rungs[*prices.cheapest];
    double needed = seeds_to_be_sure;
    for (std::size_t q = 0; q < price.errors.size(); ++q)
        if (judged_and_finite(prices, price, q))
            needed = std::max(
                needed,
                seeds * std::pow(price.errors[q].uncertainty / (tolerance - std::abs(price.errors[q].relative)), 2));
    return needed < 1e4 ? std::optional(static_cast<int>(std::ceil(needed))) : std::nullopt;
}

Account account_of(const std::filesystem::path& scene, Climb climb, double tolerance, int seeds) {
    Account account{scene, tolerance, seeds, std::move(climb), {}, {}, {}};
    const std::vector<Climbed>& rungs = account.climb.rungs;
    account.reference = find_reference(rungs);
    if (!account.reference)
        return account;
    std::vector<Sample> samples;
    std::size_t reference = 0;
    for (std::size_t i = 0; i < rungs.size(); ++i) {
        if (rungs[i].standing != Standing::finished ||
            !rungs[i].rung.degrees.reduces(rungs[*account.reference].rung.degrees))
            continue;
        if (i == *account.reference)
            reference = samples.size();
        account.priced.push_back(i);
        samples.push_back(sample_of(rungs[i]));
    }
    account.prices = price(samples, reference, tolerance);
    return account;
}

Json to_json(const Account& account) {
    const std::vector<Climbed>& rungs = account.climb.rungs;
    Json all = Json::array();
    for (std::size_t i = 0; i < rungs.size(); ++i) {
        const Climbed& climbed = rungs[i];
        Json one{{"name", climbed.rung.name}};
        for (const Kind& kind : all_kinds())
            one[std::string(kind.word)] = climbed.rung.degrees.*kind.degree;
        one["bodies"] = climbed.bodies;
        one["standing"] = standing_word(climbed.standing);
        one["reason"] = climbed.reason;
        Json runs = Json::array();
        for (const Seeded& run : climbed.runs)
            runs.push_back(
                {{"seed", run.seed}, {"core_s", run.core_s}, {"overlap", run.overlap}, {"doubts", run.doubts}});
        one["runs"] = runs;
        if (const Price* price = price_of(account, i)) {
            one["speed_up"] = price->speed_up;
            one["verdict"] = i == account.reference ? "reference" : word_of(price->verdict);
            one["quantities"] = quantities_of(account, *price, climbed.runs.size());
        }
        all.push_back(one);
    }
    const auto name = [&](std::optional<std::size_t> rung) {
        return rung ? Json(rungs[*rung].rung.name) : Json(nullptr);
    };
    return {{"scene", account.scene.string()},
            {"tolerance", account.tolerance},
            {"seeds", account.seeds},
            {"from_s", account.climb.stick.from()},
            {"until_s", account.climb.stick.until()},
            {"stopped", account.climb.stopped},
            {"runs_made", account.climb.made},
            {"runs_in_all", account.climb.all},
            {"reference", name(account.reference)},
            {"cheapest", name(account.cheapest())},
            {"sure", account.sure()},
            {"seeds_needed", account.seeds_needed() ? Json(*account.seeds_needed()) : Json(nullptr)},
            {"rungs", all}};
}

std::string csv_of(const Account& account) {
    std::vector<std::string> heads{"rung", "standing", "verdict", "runs", "core_s", "speed_up", "overlap"};
    for (const Quantity& quantity : account.climb.stick.quantities())
        for (const char* what : {"mean", "deviation", "error", "uncertainty"})
            heads.push_back(column_of(quantity) + "_" + what);
    std::string text = csv_line(heads);
    const auto cell = [](double value) { return std::isfinite(value) ? shortest(value) : std::string("nan"); };
    for (std::size_t i = 0; i < account.climb.rungs.size(); ++i) {
        const Climbed& climbed = account.climb.rungs[i];
        const Price* price = price_of(account, i);
        std::vector<std::string> row{climbed.rung.name,
                                     standing_word(climbed.standing),
                                     !price                   ? ""
                                     : i == account.reference ? "reference"
                                                              : word_of(price->verdict),
                                     std::to_string(climbed.runs.size()),
                                     cell(climbed.core_s()),
                                     price ? cell(price->speed_up) : "nan",
                                     cell(climbed.overlap())};
        for (std::size_t q = 0; q < account.climb.stick.quantities().size(); ++q)
            for (const double value : price ? std::array{price->spreads[q].mean, price->spreads[q].deviation,
                                                         price->errors[q].relative, price->errors[q].uncertainty}
                                            : std::array{std::nan(""), std::nan(""), std::nan(""), std::nan("")})
                row.push_back(cell(value));
        text += csv_line(row);
    }
    return text;
}

std::string cheapest_scene(const Account& account) {
    scene::Scene scene = account.climb.rungs[*account.cheapest()].rung.scene;
    const Price& price = account.prices.rungs[*account.prices.cheapest];
    const Climbed& reference = account.climb.rungs[*account.reference];
    scene.title += ", reduced";
    std::string claim =
        fmt::format("{} reduced by `tumble reduce` ({}), {:.3g} times as fast as the reference ({}). ",
                    account.scene.filename().string(), account.climb.rungs[*account.cheapest()].rung.name,
                    price.speed_up, reference.rung.name);
    claim += fmt::format("Off by, over {} seeds, from {:.4g} to {:.4g} s:", account.seeds, account.climb.stick.from(),
                         account.climb.stick.until());
    const auto& quantities = account.climb.stick.quantities();
    for (std::size_t q = 0; q < quantities.size(); ++q)
        if (account.prices.judged[q])
            claim +=
                fmt::format(" {} {:+.1f} +- {:.1f} %{};", quantities[q].name, 100 * price.errors[q].relative,
                            100 * price.errors[q].uncertainty, price.errors[q].told_apart() ? "" : " (not told apart)");
    claim.back() = '.';
    std::string unjudged;
    for (std::size_t q = 0; q < quantities.size(); ++q)
        if (!account.prices.judged[q])
            unjudged += (unjudged.empty() ? "" : ", ") + quantities[q].name;
    if (!unjudged.empty())
        claim += fmt::format(" Not judged, as the reference itself does not tell them: {}.", unjudged);
    if (!account.sure())
        claim += " It only seems to stay within: more seeds would tell.";
    scene.claim = claim + " What it was before: " + scene.claim;
    return scene::to_toml(scene);
}

Result<std::vector<std::filesystem::path>> write_account(const Account& account, const std::filesystem::path& folder,
                                                         bool unsure) {
    std::vector<std::pair<std::string, std::string>> files{{"reduction.csv", csv_of(account)},
                                                           {"reduction.json", to_json(account).dump(2) + "\n"}};
    std::error_code error;
    if (account.sure() || (unsure && account.cheapest()))
        files.emplace_back(reduced_name(account), cheapest_scene(account));
    else
        std::filesystem::remove(folder / reduced_name(account), error);
    std::vector<std::filesystem::path> written;
    for (const auto& [name, text] : files) {
        if (const auto done = observe::write_whole(folder / name, text); !done)
            return done.problems();
        written.push_back(folder / name);
    }
    return written;
}

} // namespace tumble::reduce
