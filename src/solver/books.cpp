#include "solver/books.h"

#include <algorithm>
#include <cmath>

namespace tumble::solver {

namespace {

void add_to(ContactSums& total, const ContactSums& sums) {
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

void add_to(MotionSums& total, const MotionSums& sums) {
    total.kinetic_translation += sums.kinetic_translation;
    total.kinetic_rotation += sums.kinetic_rotation;
    total.gravity += sums.gravity;
    total.lost_global_damping += sums.lost_global_damping;
    total.travel_max = std::max(total.travel_max, sums.travel_max);
    total.way_max = std::max(total.way_max, sums.way_max);
    total.speed_squared_max = std::max(total.speed_squared_max, sums.speed_squared_max);
    total.spin_squared_max = std::max(total.spin_squared_max, sums.spin_squared_max);
    total.finite = total.finite && sums.finite;
}

void add_to(Ledger& ledger, const Sums& now, bool first_step) {
    const ContactSums& contacts = now.contacts;
    ledger.lost_normal_damping += contacts.lost_normal_damping;
    ledger.lost_tangential_damping += contacts.lost_tangential_damping;
    ledger.lost_sliding += contacts.lost_sliding;
    ledger.lost_rolling += contacts.lost_rolling_damping + contacts.lost_rolling_sliding;
    ledger.lost_air_drag += now.lost_air_drag;
    ledger.lost_adhesion += contacts.lost_adhesion;
    ledger.lost_history += contacts.lost_history;
    ledger.lost_global_damping += now.motion.lost_global_damping;
    ledger.wall_work += contacts.wall_work;
    // Bodies that were put in overlapping bring the energy of their contacts along.
    if (first_step)
        ledger.inserted += contacts.stored_normal + contacts.stored_tangential + contacts.stored_rolling;
    ledger.overlap_ratio_peak = std::max(ledger.overlap_ratio_peak, contacts.overlap_ratio_max);
}

} // namespace

void Sums::add(const Sums& more) {
    add_to(contacts, more.contacts);
    lost_air_drag += more.lost_air_drag;
    add_to(motion, more.motion);
}

// Forces and energies are those before the bodies moved. Force times velocity is summed as the trapezoidal rule has it,
// so half of the last step's belongs to the next interval; slip and history are differences from the step before to
// this one.
Books book_step(Ledger& ledger, const Sums& now, std::int64_t step, double dt, std::int64_t bodies) {
    add_to(ledger, now, step == 1);
    const ContactSums& contacts = now.contacts;
    Books books;
    books.step = step - 1;
    books.time = static_cast<double>(books.step) * dt;
    books.bodies = bodies;
    books.contacts = contacts.contacts;
    books.kinetic_translation = now.motion.kinetic_translation;
    books.kinetic_rotation = now.motion.kinetic_rotation;
    books.gravity = now.motion.gravity;
    books.stored_normal = contacts.stored_normal;
    books.stored_tangential = contacts.stored_tangential;
    books.stored_rolling = contacts.stored_rolling;
    books.lost_normal_damping = ledger.lost_normal_damping - 0.5 * contacts.lost_normal_damping;
    books.lost_tangential_damping = ledger.lost_tangential_damping - 0.5 * contacts.lost_tangential_damping;
    books.lost_sliding = ledger.lost_sliding;
    books.lost_rolling = ledger.lost_rolling - 0.5 * contacts.lost_rolling_damping;
    books.lost_air_drag = ledger.lost_air_drag - 0.5 * now.lost_air_drag;
    books.lost_adhesion = ledger.lost_adhesion;
    books.lost_history = ledger.lost_history;
    books.lost_global_damping = ledger.lost_global_damping - 0.5 * now.motion.lost_global_damping;
    books.wall_work = ledger.wall_work - 0.5 * contacts.wall_work;
    books.inserted = ledger.inserted;
    books.overlap_max = contacts.overlap_max;
    books.overlap_ratio_max = contacts.overlap_ratio_max;
    books.overlap_ratio_peak = ledger.overlap_ratio_peak;
    books.speed_max = std::sqrt(now.motion.speed_squared_max);
    books.angular_speed_max = std::sqrt(now.motion.spin_squared_max);
    books.closure = closure_of(books);
    return books;
}

} // namespace tumble::solver
