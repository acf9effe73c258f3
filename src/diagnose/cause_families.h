#pragma once

#include "diagnose/cause.h"

/// The library by family; cause.cpp collects them.
namespace tumble::diagnose {

std::vector<Cause> of_the_ground();
std::vector<Cause> of_the_air();
std::vector<Cause> of_the_excitation();
std::vector<Cause> of_the_load();
std::vector<Cause> of_the_shape();
std::vector<Cause> of_the_contact();
std::vector<Cause> of_cohesion();
std::vector<Cause> of_the_friction();
std::vector<Cause> of_the_simulation();
std::vector<Cause> of_the_clock();
std::vector<Cause> of_the_sensor();
std::vector<Cause> of_the_camera();
std::vector<Cause> of_the_accelerometer();

} // namespace tumble::diagnose
