#pragma once

#include "lab/experiment.h"

/// The experiments, one file each.
namespace tumble::lab {

Experiment drop();
Experiment oblique();
Experiment slide();
Experiment roll();
Experiment roll_out();
Experiment spin_down();
Experiment plate();
Experiment press();
Experiment tension();
Experiment weigh();
Experiment repose();
Experiment sensor();
Experiment thesis();

} // namespace tumble::lab
