#include "solver/leashes.h"

namespace tumble::solver {

namespace {

constexpr double spare_leash = 0.6; // share of the mean leash that bodies at rest get

} // namespace

void start_odometers(std::vector<double>& travel, double skin) {
    double mean_speed = 0;
    for (const double speed : travel)
        mean_speed += speed / static_cast<double>(travel.size());
    const double half = 0.5 * skin;
    const double time = mean_speed > 0 ? (1 - spare_leash) * half / mean_speed : 0;
    for (double& odometer : travel)
        odometer = -std::min(spare_leash * half + time * odometer, longest_leash * half);
}

} // namespace tumble::solver
