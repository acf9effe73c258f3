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

const std::string prefix = "tracer:";

struct Quantity {
    const char* name;
    const char* unit;
    const char* sentence; // of an axis
};

/// Three columns each.
constexpr std::array<Quantity, 9> quantities{
    {{"", "m", "{} of its centre of mass"},
     {"v", "m_s", "{} of that centre's velocity"},
     {"a", "m_s2", "{} of that centre's acceleration, the mean since the row before"},
     {"point_", "m", "{} of the point where the sensor sits (tracer_point_m)"},
     {"point_v", "m_s", "{} of that point's velocity"},
     {"point_a", "m_s2", "{} of that point's acceleration, the mean since the row before"},
     {"spin_", "rad_s", "angular velocity about the sensor's own {}"},
     {"felt_", "m_s2", "what an accelerometer at that point reads along its own {}, the mean since the row before"},
     {"summed_v", "m_s", "{} of that point's velocity as it is summed up from what the accelerometer reads"}}};

} // namespace

std::vector<TracerColumn> tracer_columns(const std::string& body) {
    std::vector<TracerColumn> columns;
    for (const Quantity& quantity : quantities)
        for (const char* axis : {"x", "y", "z"})
            columns.push_back({prefix + body + "_" + quantity.name + axis, quantity.unit,
                               fmt::format(fmt::runtime(quantity.sentence), axis)});
    return columns;
}

std::optional<Traced> traced_by(const std::string& name) {
    std::optional<Traced> found;
    std::size_t longest = 0; // "tracer:a_point_x" is the sensor's place in a, not the x of a body called a_point
    for (const TracerColumn& column : tracer_columns("")) {
        const std::string what = column.name.substr(prefix.size()); // "_felt_x"
        if (!name.starts_with(prefix) || !name.ends_with(what) || name.size() <= prefix.size() + what.size() ||
            what.size() <= longest)
            continue;
        longest = what.size();
        found = {.body = name.substr(prefix.size(), name.size() - prefix.size() - what.size()),
                 .unit = column.unit,
                 .inertial = what.starts_with("_felt_") || what.starts_with("_summed_")};
    }
    return found;
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
    const Eigen::Quaterniond turned = frame.orientation[*body] * tracer_.sensor * tracer_.turned;
    Moment now{.time = frame.time,
               .centre = frame.velocity[*body],
               .point = frame.velocity[*body] + spin.cross(arm),
               .turned = turned.coeffs()};
    now.summed = now.point;
    Vector3d acceleration = Vector3d::Constant(values[0]), of_point = acceleration, felt = acceleration;
    if (before_ && now.time > before_->time) {
        acceleration = (now.centre - before_->centre) / (now.time - before_->time);
        const Eigen::Quaterniond half_way = Eigen::Quaterniond(before_->turned).slerp(0.5, turned);
        of_point = (now.point - before_->point) / (now.time - before_->time);
        felt = half_way.conjugate() * (of_point - tracer_.gravity);
        const Eigen::Quaterniond believed = half_way * tracer_.turned.conjugate();
        now.summed = before_->summed + (believed * felt + tracer_.gravity) * (now.time - before_->time);
    }
    before_ = now;
    std::size_t at = 0;
    for (const Vector3d& vector :
         {frame.position[*body], now.centre, acceleration, Vector3d(frame.position[*body] + arm), now.point, of_point,
          Vector3d(turned.conjugate() * spin), felt, now.summed})
        for (int k = 0; k < 3; ++k)
            values[at++] = vector[k];
    return values;
}

} // namespace tumble::observe
