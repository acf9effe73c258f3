#include "observe/tracer.h"

#include <limits>

namespace tumble::observe {

namespace {

using Eigen::Vector3d;

std::optional<std::size_t> first_of(const Frame& frame, int shape) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < frame.bodies(); ++i)
        if (frame.shape[i] == shape && (!first || frame.id[i] < frame.id[*first]))
            first = i;
    return first;
}

struct Quantity {
    const char* name;
    const char* unit;
};

/// Three columns each.
constexpr std::array<Quantity, 8> quantities{{{"", "m"},
                                              {"v", "m_s"},
                                              {"a", "m_s2"},
                                              {"point_", "m"},
                                              {"point_v", "m_s"},
                                              {"point_a", "m_s2"},
                                              {"spin_", "rad_s"},
                                              {"felt_", "m_s2"}}};

} // namespace

std::vector<std::string> TracerReader::columns() const {
    std::vector<std::string> heads;
    for (const Quantity& quantity : quantities)
        for (const char* axis : {"x", "y", "z"})
            heads.push_back("tracer:" + tracer_.name + "_" + quantity.name + axis + "_" + quantity.unit);
    return heads;
}

std::vector<double> TracerReader::row(const Frame& frame) {
    const auto body = first_of(frame, tracer_.shape);
    std::vector<double> values(3 * quantities.size(), std::numeric_limits<double>::quiet_NaN());
    if (!body)
        return values;
    const Vector3d& spin = frame.angular_velocity[*body];
    const Vector3d arm = frame.orientation[*body] * tracer_.point;
    const Eigen::Quaterniond turned = frame.orientation[*body] * tracer_.sensor;
    const Moment now{frame.time, frame.velocity[*body], frame.velocity[*body] + spin.cross(arm), turned.coeffs()};
    Vector3d acceleration = Vector3d::Constant(values[0]), of_point = acceleration, felt = acceleration;
    if (before_ && now.time > before_->time) {
        acceleration = (now.centre - before_->centre) / (now.time - before_->time);
        const Eigen::Quaterniond half_way = Eigen::Quaterniond(before_->turned).slerp(0.5, turned);
        of_point = (now.point - before_->point) / (now.time - before_->time);
        felt = half_way.conjugate() * (of_point - tracer_.gravity);
    }
    before_ = now;
    std::size_t at = 0;
    for (const Vector3d& vector :
         {frame.position[*body], now.centre, acceleration, Vector3d(frame.position[*body] + arm), now.point, of_point,
          Vector3d(turned.conjugate() * spin), felt})
        for (int k = 0; k < 3; ++k)
            values[at++] = vector[k];
    return values;
}

} // namespace tumble::observe
