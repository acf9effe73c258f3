#pragma once

#include "diagnose/diagnosis.h"

#include <string>
#include <vector>

namespace tumble::diagnose {

/// The fixed words of an outcome: "NAMED", "NONE OF THE KNOWN CAUSES", ...
std::string outcome_words(const Diagnosis& diagnosis);

/// One or two sentences: what is wrong, by how much, how sure.
std::string verdict_of(const Diagnosis& diagnosis);

/// What to do next, one sentence.
std::string next_step(const Diagnosis& diagnosis);

/// What the extended scene claims in place of what the scene did: which scene it is, with what in it and from which
/// data.
std::string extended_claim(const Diagnosis& diagnosis);

/// "0.0123 +- 0.0004 s": an amplitude with its standard error and unit.
std::string amplitude_words(const Cause& cause, double amplitude, double error);

/// Why a cause is not the answer, or that it is: "amplitude below ...", "worse by 12 nats", "does not show in these
/// data".
std::string standing_of(const Diagnosis& diagnosis, int cause);

} // namespace tumble::diagnose
