#include "observe/impacts.h"

#include <algorithm>
#include <map>

namespace tumble::observe {

namespace {

double largest_normal(const std::vector<Touching>& row) {
    double most = 0;
    for (const Touching& touch : row)
        most = std::max(most, touch.peak_normal);
    return most;
}

/// A body's touches up to where it begins a new row.
std::vector<std::vector<Touching>> rows_of(const std::vector<Touching>& touches) {
    std::vector<std::vector<Touching>> rows;
    std::map<std::int64_t, std::size_t> row_of; // by body
    for (const Touching& touch : touches) {
        const auto [row, fresh] = row_of.try_emplace(touch.body, rows.size());
        if (fresh || touch.number == 1) {
            row->second = rows.size();
            rows.emplace_back();
        }
        rows[row->second].push_back(touch);
    }
    return rows;
}

} // namespace

Impacts impacts_of(const std::vector<Touching>& touches) {
    Impacts impacts;
    impacts.touches = static_cast<int>(touches.size());
    for (const Touching& touch : touches) {
        impacts.normal_above += touch.peak_normal > touch.peak_shear ? 1 : 0;
        impacts.normal_impulse += touch.normal_impulse;
        impacts.shear_impulse += touch.shear_impulse;
    }
    for (const std::vector<Touching>& row : rows_of(touches)) {
        ++impacts.rows;
        const double most = largest_normal(row);
        impacts.slid += row.size() > 1 ? 1 : 0;
        impacts.first_strongest += row.size() > 1 && row.front().peak_normal >= most ? 1 : 0;
        impacts.impact_normal += row.front().peak_normal;
        for (std::size_t k = 1; k < row.size(); ++k)
            impacts.sliding_normal += row[k].peak_normal;
        if (most > largest_normal(impacts.hardest))
            impacts.hardest = row;
    }
    impacts.impact_normal /= std::max(1, impacts.rows);
    impacts.sliding_normal /= std::max(1, impacts.touches - impacts.rows);
    return impacts;
}

} // namespace tumble::observe
