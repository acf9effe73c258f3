#include "sim3d/cells.h"

namespace tumble::sim3d {

void Cells::sort(const scene::Domain& domain, const Lines<Bounds>& bodies, double reach) {
    CellGrid::sort(
        domain, bodies.size(), [&](std::size_t body) { return bodies[body].centre; }, reach);
}

int Cells::around(const double* centre, std::array<Seen, 27>& seen) const {
    const Place home = place_of(centre);
    const auto slow = static_cast<std::size_t>(axes()[0]);
    const auto mid = static_cast<std::size_t>(axes()[1]);
    const auto fast = static_cast<std::size_t>(axes()[2]);
    int n = 0;
    for (int code = 0; code < 27; ++code) {
        Place place = home;
        place[slow] += code / 9 - 1;
        place[mid] += code / 3 % 3 - 1;
        place[fast] += code % 3 - 1;
        CellGrid::Seen cell;
        if (!look(place, cell))
            continue;
        const Seen here{cell.begin, cell.end, image_index(cell.image[0], cell.image[1], cell.image[2])};
        if (n > 0 && seen[static_cast<std::size_t>(n - 1)].end == here.begin &&
            seen[static_cast<std::size_t>(n - 1)].image == here.image)
            seen[static_cast<std::size_t>(n - 1)].end = here.end;
        else
            seen[static_cast<std::size_t>(n++)] = here;
    }
    return n;
}

} // namespace tumble::sim3d
