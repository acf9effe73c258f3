#pragma once

#include "diagnose/bed_model.h"
#include "diagnose/plan.h"

namespace tumble::diagnose {

/// What would tell the causes apart that a decision about beds left: the same numbers from more runs, or one more
/// number of those that the table has. The most telling first.
std::vector<Proposal> bed_proposals(const Beds& beds, const BedModel& model, const Decision& decision);

} // namespace tumble::diagnose
