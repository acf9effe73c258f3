#pragma once

#include "base/problem.h"
#include "observe/flow_field.h"
#include "observe/series.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The numbers that a reduction may spoil, and how they are read from a run that is over.
namespace tumble::reduce {

/// One number of a run: a mean over the stretch that counts, or what a body's path in it is like.
struct Quantity {
    enum class From { column, energy_per_mass, layer_speed, vortex_depth, fall_at_axis, cycle, peak_to_peak };
    std::string name; // "circulation", "speed 0 to 42 mm"
    std::string unit;
    From from = From::column;
    std::string column{}; // of series.csv; none of what is read from frames
    int layer = 0;
};

/// What is read of every rung alike. docs/reduced-order.md, "What is measured".
class Yardstick {
public:
    /// The measures that matter for that scene, and the means of those of `more` (names of `tumble list measures`).
    /// The stretch: from the middle between the last start of a wall's motion and its end, in whole pairs of periods
    /// where it vibrates, and for cycles from the first quarter; or from and until what is given (s). Problems: a
    /// measure that does not exist; a stretch that holds fewer than two rows.
    static Result<Yardstick> of(const scene::Scene& scene, const std::vector<std::string>& more,
                                std::optional<double> from, std::optional<double> until);

    /// Has the scene write what will be read, and nothing more.
    void prepare(scene::Scene& scene) const;

    /// A value per quantity, NaN where it has no meaning there, such as a cycle of a body that has not come down again.
    /// `mass` of all bodies, kg. Problems: a file of the run that cannot be read.
    [[nodiscard]] Result<std::vector<double>> read(const std::filesystem::path& run, double mass) const;

    [[nodiscard]] const std::vector<Quantity>& quantities() const { return quantities_; }
    [[nodiscard]] double from() const { return from_; }   // s
    [[nodiscard]] double until() const { return until_; } // s

private:
    /// NaN where the series has no such column.
    [[nodiscard]] double of_series(const Quantity& quantity, const observe::Series& series, double mass) const;

    std::vector<Quantity> quantities_;
    std::vector<std::string> measures_;
    std::optional<observe::FlowGrid> layers_;
    double from_ = 0, until_ = 0; // s
    double paths_from_ = 0;       // s, of cycles: a stretch holds few of them
    double every_ = 0;            // s, between rows
};

} // namespace tumble::reduce
