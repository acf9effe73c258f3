#pragma once

#include "discs/fill.h"
#include "hard2d/contacts.h"
#include "hard2d/solver.h"
#include "hard2d/units.h"
#include "hard2d/wall.h"

#include <array>
#include <box2d/b2_body.h>
#include <box2d/b2_world.h>
#include <deque>
#include <memory>
#include <vector>

namespace tumble::hard2d {

/// The step's verbs, for the account of where the time goes.
enum class Phase { move_walls, solve, book_energy };
constexpr std::array<const char*, 3> phase_names{"move_walls", "solve", "book_energy"};

struct World {
    scene::Scene scene;
    double dt = 0; // s
    std::int64_t step = 0;
    std::vector<discs::ShapeData> shapes;
    std::vector<BodyShape> plain_shapes;
    Units units;
    Contacts contacts; // before the box, which calls it until its end
    std::unique_ptr<b2World> box;
    std::deque<Wall> walls;
    std::vector<Touchable> parts; // one per shape, what fixtures of its bodies say they are
    std::vector<solver::FillState> fills;
    std::int64_t next_fill_step = 0;

    // Per id.
    std::vector<b2Body*> bodies;
    std::vector<int> shape;

    double inserted = 0;           // J
    double overlap_ratio_peak = 0; // -
    Books books;
    StopFlag stop = nullptr;
    std::array<double, phase_names.size()> seconds{};

    [[nodiscard]] double time() const { return static_cast<double>(step) * dt; }
    [[nodiscard]] const BodyShape& shape_of(std::size_t id) const {
        return plain_shapes[static_cast<std::size_t>(shape[id])];
    }
};

} // namespace tumble::hard2d
