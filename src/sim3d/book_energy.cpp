#include "sim3d/step.h"

#include <Eigen/Core>
#include <algorithm>

namespace tumble::sim3d {

using Eigen::Vector3d;

void book_energy(World& world) {
    solver::book_step(world);
}

Books opening_books(const World& world) {
    Books books;
    books.bodies = world.bodies();
    books.inserted = world.ledger.inserted;
    for (std::size_t slot = 0; slot < world.id.size(); ++slot) {
        const BodyMotion& motion = world.motion[slot];
        const Vector3d velocity(motion.velocity);
        const Vector3d spin(motion.spin);
        books.kinetic_translation += 0.5 * motion.mass * velocity.squaredNorm();
        books.kinetic_rotation += 0.5 * Vector3d(world.turn[slot].momentum).dot(spin);
        books.gravity -= motion.mass * world.scene.gravity.dot(Vector3d(motion.position));
        books.speed_max = std::max(books.speed_max, velocity.norm());
        books.angular_speed_max = std::max(books.angular_speed_max, spin.norm());
    }
    books.closure = closure_of(books);
    return books;
}

} // namespace tumble::sim3d
