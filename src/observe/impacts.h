#pragma once

#include "observe/part_loads.h"

#include <vector>

namespace tumble::observe {

/// What the touches of a run say of the thesis' impact and sliding steps (7.5.2).
struct Impacts {
    int touches = 0;
    int normal_above = 0;            // touches whose largest normal force is above their largest shear force
    int rows = 0;                    // impact steps, each with the sliding steps that follow it
    int slid = 0;                    // rows of several touches
    int first_strongest = 0;         // of these, where no later touch presses harder than the first
    double impact_normal = 0;        // N, mean of the largest normal forces of impact steps
    double sliding_normal = 0;       // N, the same of all later touches; 0: there are none
    double normal_impulse = 0;       // N s, of all touches
    double shear_impulse = 0;        // N s, the same
    std::vector<Touching> hardest{}; // the row with the largest normal force, in order
};

/// `touches`: in the order in which they began.
Impacts impacts_of(const std::vector<Touching>& touches);

} // namespace tumble::observe
