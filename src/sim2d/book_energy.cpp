#include "sim2d/step.h"

#include <algorithm>
#include <cmath>

namespace tumble::sim2d {

namespace {

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
        total.lost_history += sums.lost_history;
        total.wall_work += sums.wall_work;
        total.overlap_max = std::max(total.overlap_max, sums.overlap_max);
        total.overlap_ratio_max = std::max(total.overlap_ratio_max, sums.overlap_ratio_max);
        total.contacts += sums.contacts;
    }
    return total;
}

/// What moves: kinetic energies at the step, extremes; returns what global damping took in the step, J.
double book_motion(const World& world, Books& books) {
    double speed_squared = 0;
    double spin_squared = 0;
    double damped = 0;
    for (const Chunk& chunk : world.chunks) {
        const MotionSums& motion = chunk.sums.motion;
        books.kinetic_translation += motion.kinetic_translation;
        books.kinetic_rotation += motion.kinetic_rotation;
        books.gravity += motion.gravity;
        damped += motion.lost_global_damping;
        speed_squared = std::max(speed_squared, motion.speed_squared_max);
        spin_squared = std::max(spin_squared, motion.spin_squared_max);
    }
    books.speed_max = std::sqrt(speed_squared);
    books.angular_speed_max = std::sqrt(spin_squared);
    return damped;
}

} // namespace

void book_energy(World& world) {
    ++world.step;
    const ContactSums now = add(world);
    Books& books = world.books;
    books = {};
    const double damped = book_motion(world, books);
    Ledger& ledger = world.ledger;
    double dragged = 0;
    for (const Chunk& chunk : world.chunks)
        dragged += chunk.sums.lost_air_drag;
    ledger.lost_normal_damping += now.lost_normal_damping;
    ledger.lost_tangential_damping += now.lost_tangential_damping;
    ledger.lost_sliding += now.lost_sliding;
    ledger.lost_rolling += now.lost_rolling_damping + now.lost_rolling_sliding;
    ledger.lost_air_drag += dragged;
    ledger.lost_history += now.lost_history;
    ledger.lost_global_damping += damped;
    ledger.wall_work += now.wall_work;
    // Bodies that were put in overlapping bring the energy of their contacts along.
    if (world.step == 1)
        ledger.inserted += now.stored_normal + now.stored_tangential + now.stored_rolling;

    // Forces and energies are those before the bodies moved. Force times velocity is summed as the trapezoidal rule
    // has it, so half of the last step's belongs to the next interval; slip and history are differences from the step
    // before to this one.
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
    books.lost_history = ledger.lost_history;
    books.lost_global_damping = ledger.lost_global_damping - 0.5 * damped;
    books.wall_work = ledger.wall_work - 0.5 * now.wall_work;
    books.inserted = ledger.inserted;
    books.overlap_max = now.overlap_max;
    books.overlap_ratio_max = now.overlap_ratio_max;
    ledger.overlap_ratio_peak = std::max(ledger.overlap_ratio_peak, now.overlap_ratio_max);
    books.overlap_ratio_peak = ledger.overlap_ratio_peak;
    books.closure = closure_of(books);
}

Books opening_books(const World& world) {
    Books books;
    books.bodies = world.bodies();
    books.inserted = world.ledger.inserted;
    for (const BodyState& body : bodies_of(world)) {
        const ShapeConstants& shape = world.shape_constants[static_cast<std::size_t>(body.shape)];
        books.kinetic_translation += 0.5 * shape.mass * body.velocity.squaredNorm();
        books.kinetic_rotation += 0.5 * shape.inertia * body.angular_velocity * body.angular_velocity;
        books.gravity -= shape.mass * world.scene.gravity.head<2>().dot(body.position);
        books.speed_max = std::max(books.speed_max, body.velocity.norm());
        books.angular_speed_max = std::max(books.angular_speed_max, std::abs(body.angular_velocity));
    }
    books.closure = closure_of(books);
    return books;
}

} // namespace tumble::sim2d
