#pragma once

#include "diagnose/decide.h"
#include "diagnose/model.h"
#include "diagnose/noise.h"
#include "diagnose/warning_key.h"

namespace tumble::diagnose {

/// A nuisance that a fit took as far as it may go is warned of.
void doubt_bounds(const Model& model, const VectorXd& values, const std::filesystem::path& file, Problems& warnings);

/// A number that is the last value of its stretch, or no rebound at all, is warned of.
void doubt_numbers(Model& model, const VectorXd& values, Problems& warnings);

/// Sensors that contradict each other, or what the scene can do at all, are mended before anything else: no name is
/// sure then, and the remedy says so.
void doubt_sensors(Decision& decision, const Problems& warnings);

/// The same; and what a sensor did not show cannot bear a name, unless it is the name.
void doubt_name(Decision& decision, const std::vector<Cause>& causes, const Problems& warnings);

constexpr double much_wider = 3; // times the scatter known before: what is missed was taken for it

/// No agreement where what is missed was taken for scatter and is none: most of it comes of few readings, or neighbours
/// miss alike. `residual`: whitened.
void doubt_agreement(Decision& decision, const NoiseReport& noise, const VectorXd& residual, const Model& model);

} // namespace tumble::diagnose
