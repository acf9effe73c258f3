#pragma once

#include "reduce/climb.h"
#include "reduce/price.h"
#include "sheet/sheet.h"

#include <nlohmann/json.hpp>

/// What a climb found, in the forms in which it leaves the program.
namespace tumble::reduce {

/// A climb with its prices: those of the rungs that were finished and reduce the reference.
struct Account {
    std::filesystem::path scene; // the file it is about
    double tolerance = 0.1;
    int seeds = 0;
    Climb climb;
    std::optional<std::size_t> reference; // rung; nothing: none was finished
    std::vector<std::size_t> priced;      // rungs, parallel to prices.rungs
    Prices prices;

    [[nodiscard]] bool reference_is_whole() const { return reference == std::size_t{0}; }
    /// Rung of the cheapest scene.
    [[nodiscard]] std::optional<std::size_t> cheapest() const;
    [[nodiscard]] bool sure() const;
    /// With how many seeds of each the cheapest would surely be within, if its errors and scatter stay as they are.
    /// Nothing where it is, where there is none, and where the reference has other runs than the rungs.
    [[nodiscard]] std::optional<int> seeds_needed() const;
};

/// The reference is the scene as written, or else, where that was not finished, the rung that took the most work.
Account account_of(const std::filesystem::path& scene, Climb climb, double tolerance, int seeds);

/// Table, what it means, and the plot of error against speed-up. `unsure` as for write_account.
sheet::Sheet sheet_of(const Account& account, bool unsure);

/// Stable keys, units in the names.
nlohmann::ordered_json to_json(const Account& account);

/// A row a rung.
std::string csv_of(const Account& account);

/// The cheapest scene as a scene file, its claim being what it was reduced by and how far it is off.
std::string cheapest_scene(const Account& account);

/// reduction.csv, reduction.json, and NAME-reduced.toml where a scene surely stays within, or (with `unsure`) seems to;
/// a scene that an earlier call left is taken away where none does. Returns the files. Problems: the system's reason.
Result<std::vector<std::filesystem::path>> write_account(const Account& account, const std::filesystem::path& folder,
                                                         bool unsure);

} // namespace tumble::reduce
