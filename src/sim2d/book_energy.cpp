#include "sim2d/step.h"

namespace tumble::sim2d {

void book_energy(World& world) {
    solver::book_step(world);
}

Books opening_books(const World& world) {
    Books books;
    books.bodies = world.bodies();
    books.inserted = world.ledger.inserted;
    discs::book_motion(bodies_of(world), world.plain_shapes, world.scene.gravity, books);
    books.closure = closure_of(books);
    return books;
}

} // namespace tumble::sim2d
