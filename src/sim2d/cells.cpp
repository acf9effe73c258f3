#include "sim2d/cells.h"

namespace tumble::sim2d {

using Eigen::Vector2d;

void Cells::sort(const scene::Domain& domain, const std::vector<Vector2d>& points, double reach) {
    CellGrid::sort(
        domain, points.size(), [&](std::size_t point) { return points[point].data(); }, reach);
}

int Cells::around(const Vector2d& point, std::array<Seen, 9>& seen) const {
    const Place home = place_of(point.data());
    int n = 0;
    for (int code = 0; code < 9; ++code) {
        CellGrid::Seen cell;
        if (look({home[0] + code % 3 - 1, home[1] + code / 3 - 1}, cell))
            seen[static_cast<std::size_t>(n++)] = {order().data() + cell.begin, order().data() + cell.end,
                                                   image_index(cell.image[0], cell.image[1])};
    }
    return n;
}

} // namespace tumble::sim2d
