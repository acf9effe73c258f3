#include "discs/bodies.h"

#include "solver/sanity.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::discs {

std::optional<Problem> refusal_of(const std::vector<BodyState>& bodies, const scene::Scene& scene) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const BodyState& body = bodies[k];
        const bool finite = body.position.allFinite() && body.velocity.allFinite() &&
                            std::isfinite(body.angular_velocity) && std::isfinite(body.angle);
        const double at[] = {body.position.x(), body.position.y()};
        if (auto problem =
                solver::refusal_of(k, body.shape, finite ? nullptr : "has a number that is not finite", at, scene))
            return problem;
    }
    return std::nullopt;
}

double energy_of(const BodyState& body, const BodyShape& shape, const Eigen::Vector3d& gravity) {
    return 0.5 * shape.mass * body.velocity.squaredNorm() +
           0.5 * shape.inertia * body.angular_velocity * body.angular_velocity -
           shape.mass * gravity.head<2>().dot(body.position);
}

void book_motion(const std::vector<BodyState>& bodies, const std::vector<BodyShape>& shapes,
                 const Eigen::Vector3d& gravity, Books& books) {
    for (const BodyState& body : bodies) {
        const BodyShape& shape = shapes[static_cast<std::size_t>(body.shape)];
        books.kinetic_translation += 0.5 * shape.mass * body.velocity.squaredNorm();
        books.kinetic_rotation += 0.5 * shape.inertia * body.angular_velocity * body.angular_velocity;
        books.gravity -= shape.mass * gravity.head<2>().dot(body.position);
        books.speed_max = std::max(books.speed_max, body.velocity.norm());
        books.angular_speed_max = std::max(books.angular_speed_max, std::abs(body.angular_velocity));
    }
}

} // namespace tumble::discs
