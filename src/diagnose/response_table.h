#pragma once

#include "base/problem.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tumble::diagnose {

/// One run of a bed: what it was, and the means it gave.
struct BedRun {
    std::string run;                     // hash of the resolved scene, the stretch and the program: its date
    std::string condition;               // as the measurement calls it
    std::string cause;                   // empty: the baseline
    std::string amplitude;               // of the cause
    std::uint64_t seed = 0;              //
    double from = 0, until = 0;          // s, averaged over
    double wall = 0;                     // s that it took
    std::string scene{};                 // hash of the scene's file, what was set and the stretch: whatever program ran
    std::map<std::string, double> means; // by column, SI; NaN: no meaning there, or the run broke down
};

/// Runs that are over, in a CSV file that a person can read. Each run is written as soon as it is over, in a whole
/// file, so that a killed program loses those it was at.
class ResponseTable {
public:
    /// A file that is not there is an empty table; without a name nothing is kept. `columns`: the numbers that a run
    /// must have, heads with their units. Problems: a file that is no such table.
    static Result<ResponseTable> open(const std::filesystem::path& file, std::vector<std::string> columns);

    /// The run with this date and all columns, or null.
    [[nodiscard]] const BedRun* find(const std::string& run) const;
    /// The same by what it was, of the same scene, whatever program made it.
    [[nodiscard]] const BedRun* find(const BedRun& like) const;
    /// There is one that is called so, but of another scene, or of a table that does not say of which.
    [[nodiscard]] bool has_of_another_scene(const BedRun& like) const;

    /// Problems: the file cannot be written.
    Result<Done> add(BedRun run);

    [[nodiscard]] const std::vector<BedRun>& runs() const { return runs_; }

private:
    [[nodiscard]] bool whole(const BedRun& run) const;
    Result<Done> read();

    std::filesystem::path file_;
    std::vector<std::string> columns_; // required, then those that only the file has
    std::size_t required_ = 0;
    std::vector<BedRun> runs_;
};

} // namespace tumble::diagnose
