#pragma once

#include "diagnose/bed_model.h"
#include "diagnose/plan.h"

namespace tumble::diagnose {

/// What would tell the causes apart that a decision about beds left, or hold a name against its nearest rival: the same
/// numbers from more runs, or one more number of those that the table has; with `run_more` also what other conditions
/// would tell, which are run for it. The most telling first.
std::vector<Proposal> bed_proposals(Beds& beds, const BedModel& model, const Evidence& evidence,
                                    const Decision& decision, bool run_more);

} // namespace tumble::diagnose
