#include "observe/tracer.h"

#include <fmt/format.h>
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
    const char* sentence; // of an axis
};

/// Three columns each.
constexpr std::array<Quantity, 8> quantities{
    {{"", "m", "{} of its centre of mass"},
     {"v", "m_s", "{} of that centre's velocity"},
     {"a", "m_s2", "{} of that centre's acceleration, the mean since the row before"},
     {"point_", "m", "{} of the point where the sensor sits (tracer_point_m)"},
     {"point_v", "m_s", "{} of that point's velocity"},
     {"point_a", "m_s2", "{} of that point's acceleration, the mean since the row before"},
     {"spin_", "rad_s", "angular velocity about the sensor's own {}"},
     {"felt_", "m_s2", "what an accelerometer at that point reads along its own {}, the mean since the row before"}}};

} // namespace

std::vector<TracerColumn> tracer_columns(const std::string& body) {
    std::vector<TracerColumn> columns;
    for (const Quantity& quantity : quantities)
        for (const char* axis : {"x", "y", "z"})
            columns.push_back({"tracer:" + body + "_" + quantity.name + axis, quantity.unit,
                               fmt::format(fmt::runtime(quantity.sentence), axis)});
    return columns;
}

std::vector<std::string> TracerReader::columns() const {
    std::vector<std::string> heads;
    for (const TracerColumn& column : tracer_columns(tracer_.name))
        heads.push_back(column.column());
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
