#pragma once

#include "diagnose/bed_model.h"
#include "diagnose/diagnosis.h"

namespace tumble::diagnose {

/// Holds means of a bed against its scene: ensembles of seeds, a response table, the decision that records get, and
/// runs that confirm a name. Problems: as those of diagnose(), and a table that cannot be read or written.
Result<Diagnosis> diagnose_beds(const SceneText& scene, const Measurement& measurement, const Simulate& simulate,
                                const BedOptions& options, const TellStage& tell = {});

/// What that would run before it decides.
Result<Budget> budget_of_beds(const SceneText& scene, const Measurement& measurement, const BedOptions& options);

} // namespace tumble::diagnose
