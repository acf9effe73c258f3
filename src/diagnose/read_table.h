#pragma once

#include "base/table.h"
#include "diagnose/measurement.h"
#include "diagnose/typed_tables.h"

#include <optional>

namespace tumble::diagnose {

/// One column of `cells` as a [[series.column]] or [[table.column]] asks for it, in SI. Reported: a measure that does
/// not exist, no such column, cells that are no numbers.
std::optional<Channel> channel_of(const scene::View& view, const Table& cells, const std::string& key,
                                  scene::Report& report);

/// The records of a [[table]] whose file has these cells: one for all rows that set the same, with the mean of each
/// column. Where sigma is not stated, or such rows contradict it, they tell it, all conditions together. Reported: as
/// channel_of(), no row, a {HEAD} that is no column, and a sigma that nobody can know.
std::vector<Record> records_of_table(const TypedTable& table, const Table& cells, const scene::KeyTable& column,
                                     scene::Report& report, Problems& warnings);

} // namespace tumble::diagnose
