#pragma once

#include "diagnose/diagnosis.h"

#include <string>
#include <vector>

namespace tumble::report {

/// What a scene leaves unexplained of one measured column, in all records that have it.
struct ColumnResiduals {
    std::string name;               // "height [m]"
    double sigma = 0;               // SI, one standard error of a reading, mean over records
    double before = 0, after = 0;   // root mean square residual, standard errors
    int readings = 0;               // lone outliers not counted
    std::vector<std::string> plots; // SVG, in standard errors; none where others show more
};

/// Every column with its residual before and after, the first three that are farthest off also against speed, reading,
/// phase of the shaking where walls vibrate, and frequency. Columns in the order of the measurement; of more than
/// twelve those nearest to noise have no plots. Records of single numbers have none.
std::vector<ColumnResiduals> residuals_by_column(const diagnose::Diagnosis& diagnosis);

/// The plots of all columns in a row.
std::vector<std::string> residual_plots(const diagnose::Diagnosis& diagnosis);

/// The column's name without its unit: "way" of "way_mm".
std::string bare_head(const diagnose::Curve& curve);

/// "way [m]": as axes and tables have it.
std::string column_name(const diagnose::Curve& curve);

/// What the second explanation in the pictures is: "with roll.coulomb", "with roll.coulomb and grav.tilt_x"; empty
/// where there is none.
std::string second_explanation(const diagnose::Diagnosis& diagnosis);

/// Whether a curve is one number that stands for a whole record.
inline bool is_number(const diagnose::Curve& curve) {
    return curve.time.size() < 2;
}

} // namespace tumble::report
