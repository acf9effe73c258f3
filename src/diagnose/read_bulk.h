#pragma once

#include "diagnose/measurement.h"
#include "diagnose/typed_tables.h"

namespace tumble::diagnose {

/// The [[bulk]] tables of a measurement. Reported: measures that do not exist, units that they cannot have, scatter
/// that nobody can know, what stands twice, and a single number, from which nothing can be diagnosed.
std::vector<Bulk> read_bulks(const scene::Node& root, const scene::KeyTable& bulk, const scene::KeyTable& number,
                             scene::Report& report);

/// What a reader of the verdict should know of its numbers.
void doubt_bulk(const Bulk& bulk, const std::filesystem::path& file, Problems& warnings);

} // namespace tumble::diagnose
