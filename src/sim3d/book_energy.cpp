#include "sim3d/step.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;

ContactSums add(const World& world) {
    ContactSums total;
    for (const Chunk& chunk : world.chunks) {
        const ContactSums& sums = chunk.sums.contacts;
        total.stored_normal += sums.stored_normal;
        total.stored_tangential += sums.stored_tangential;
        total.stored_rolling += sums.stored_rolling;
        total.lost_normal_damping += sums.lost_normal_damping;
        total.lost_tangential_damping += sums.lost_tangential_damping;
        total.lost_sliding += sums.lost_sliding;
        total.lost_rolling_damping += sums.lost_rolling_damping;
        total.lost_rolling_sliding += sums.lost_rolling_sliding;
        total.lost_adhesion += sums.lost_adhesion;
        total.lost_history += sums.lost_history;
        total.wall_work += sums.wall_work;
        total.overlap_max = std::max(total.overlap_max, sums.overlap_max);
        total.overlap_ratio_max = std::max(total.overlap_ratio_max, sums.overlap_ratio_max);
        total.contacts += sums.contacts;
    }
    return total;
}

} // namespace

void book_energy(World& world) {
    ++world.step;
    const ContactSums now = add(world);
    Ledger& ledger = world.ledger;
    double dragged = 0;
    for (const Chunk& chunk : world.chunks)
        dragged += chunk.sums.lost_air_drag;
    ledger.lost_normal_damping += now.lost_normal_damping;
    ledger.lost_tangential_damping += now.lost_tangential_damping;
    ledger.lost_sliding += now.lost_sliding;
    ledger.lost_rolling += now.lost_rolling_damping + now.lost_rolling_sliding;
    ledger.lost_air_drag += dragged;
    ledger.lost_adhesion += now.lost_adhesion;
    ledger.lost_history += now.lost_history;
    ledger.wall_work += now.wall_work;
    // Bodies that were put in overlapping bring the energy of their contacts along.
    if (world.step == 1)
        ledger.inserted += now.stored_normal + now.stored_tangential + now.stored_rolling;

    Books& books = world.books;
    books = {};
    // Forces and energies are those before the bodies moved. Force times velocity is summed as the trapezoidal rule
    // has it, so half of the last step's belongs to the next interval; slip and history are exact differences.
    books.step = world.step - 1;
    books.time = static_cast<double>(books.step) * world.dt;
    books.bodies = world.bodies();
    books.contacts = now.contacts;
    books.stored_normal = now.stored_normal;
    books.stored_tangential = now.stored_tangential;
    books.stored_rolling = now.stored_rolling;
    books.lost_normal_damping = ledger.lost_normal_damping - 0.5 * now.lost_normal_damping;
    books.lost_tangential_damping = ledger.lost_tangential_damping - 0.5 * now.lost_tangential_damping;
    books.lost_sliding = ledger.lost_sliding;
    books.lost_rolling = ledger.lost_rolling - 0.5 * now.lost_rolling_damping;
    books.lost_air_drag = ledger.lost_air_drag - 0.5 * dragged;
    books.lost_adhesion = ledger.lost_adhesion;
    books.lost_history = ledger.lost_history;
    books.wall_work = ledger.wall_work - 0.5 * now.wall_work;
    books.inserted = ledger.inserted;
    books.overlap_max = now.overlap_max;
    books.overlap_ratio_max = now.overlap_ratio_max;
    ledger.overlap_ratio_peak = std::max(ledger.overlap_ratio_peak, now.overlap_ratio_max);
    books.overlap_ratio_peak = ledger.overlap_ratio_peak;
    double speed_squared = 0;
    double spin_squared = 0;
    for (const Chunk& chunk : world.chunks) {
        const IntegrateSums& motion = chunk.sums.motion;
        books.kinetic_translation += motion.kinetic_translation;
        books.kinetic_rotation += motion.kinetic_rotation;
        books.gravity += motion.gravity;
        speed_squared = std::max(speed_squared, motion.speed_squared_max);
        spin_squared = std::max(spin_squared, motion.spin_squared_max);
    }
    books.speed_max = std::sqrt(speed_squared);
    books.angular_speed_max = std::sqrt(spin_squared);
    books.closure = closure_of(books);
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
