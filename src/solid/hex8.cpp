#include "solid/hex8.h"

#include <cmath>

// Products of fixed size take the compiler long, and scenes know of specimens: in the header nearly every file paid.
namespace tumble::solid {

const Eigen::Matrix<double, 3, 8> corner_signs = (Eigen::Matrix<double, 3, 8>() << -1, 1, 1, -1, -1, 1, 1, -1, -1, -1,
                                                  1, 1, -1, -1, 1, 1, -1, -1, -1, -1, 1, 1, 1, 1)
                                                     .finished();

Eigen::Vector3d gauss_point(int point) {
    return corner_signs.col(point) / std::sqrt(3.0);
}

Eigen::Matrix<double, 8, 1> shape_at(const Eigen::Vector3d& natural) {
    Eigen::Matrix<double, 8, 1> n;
    for (int k = 0; k < 8; ++k)
        n[k] = 0.125 * (1 + corner_signs.col(k).array() * natural.array()).prod();
    return n;
}

Eigen::Matrix<double, 3, 8> slopes_at(const Eigen::Vector3d& natural) {
    Eigen::Matrix<double, 3, 8> slopes;
    for (int k = 0; k < 8; ++k) {
        const Eigen::Vector3d sign = corner_signs.col(k);
        const Eigen::Vector3d part = (1 + sign.array() * natural.array()).matrix();
        slopes.col(k) = 0.125 * Eigen::Vector3d(sign.x() * part.y() * part.z(), sign.y() * part.x() * part.z(),
                                                sign.z() * part.x() * part.y());
    }
    return slopes;
}

Eigen::Matrix3d jacobian_at(const Corners& corners, const Eigen::Vector3d& natural) {
    return corners * slopes_at(natural).transpose();
}

Eigen::Vector4d facet_shape_at(double r, double s) {
    return 0.25 * Eigen::Vector4d((1 - r) * (1 - s), (1 + r) * (1 - s), (1 + r) * (1 + s), (1 - r) * (1 + s));
}

} // namespace tumble::solid
