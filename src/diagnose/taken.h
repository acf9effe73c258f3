#pragma once

#include "diagnose/instrument.h"
#include "diagnose/measurement.h"

namespace tumble::diagnose {

/// The number that a channel takes of a stretch, from its `from` (s) to `until` (s) on the instrument's clock, of what
/// such an instrument shows of this signal. Extremes are those of a parabola through the highest three of 400 instants,
/// so that they move smoothly with the signal. A rebound where nothing comes down first is the last value.
double number_taken(const Channel& channel, double until, const Instrument& instrument, const Signal& truth,
                    double largest);

/// Of freedom of the scatter, where all that was measured are single numbers; infinite where any are readings over
/// time, whose scatter is as good as known.
double degrees_of_numbers(const std::vector<Record>& records);

/// The extreme that is taken lies at an end of the stretch, where no extreme need be, or nothing comes down and up
/// again of which a rebound could be taken.
bool at_an_end(const Channel& channel, double until, const Signal& truth);

} // namespace tumble::diagnose
