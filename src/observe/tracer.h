#pragma once

#include "base/carried.h"
#include "observe/frame.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tumble::observe {

/// Follows one body as a sensor inside it would be carried: the first body (lowest id) of its shape.
struct Tracer {
    std::string name;
    int shape = 0; // index into FrameLayout::shapes
    Eigen::Vector3d point =
        Eigen::Vector3d::Zero(); // m, where the sensor sits, from the centre of mass, principal frame
    Eigen::Quaterniond sensor = Eigen::Quaterniond::Identity(); // sensor frame to principal frame
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();          // m/s2
    Eigen::Quaterniond turned = Eigen::Quaterniond::Identity(); // frame in which it sits to that in which it should
};

/// A number per row of what a tracer tells; docs/measures.md, "Tracers".
struct TracerColumn {
    std::string name;     // "tracer:sensor_vy"
    std::string unit;     // as in column heads
    std::string sentence; // what it is, for people

    /// "tracer:sensor_vy_m_s": the name with its unit.
    [[nodiscard]] std::string column() const { return name + "_" + unit; }
};

/// Those of the tracer of that body, in the order of its rows.
std::vector<TracerColumn> tracer_columns(const std::string& body);

/// Whom a tracer's column follows, and what it tells.
struct Traced {
    std::string body;
    std::string unit;
    bool inertial = false; // read, or summed up from what was read, by an accelerometer
};

/// Of a column's name without its unit, "tracer:ball_felt_x"; nothing where it is no tracer's.
std::optional<Traced> traced_by(const std::string& name);

/// What happened to it between two rows; docs/measures.md, "Tracers".
class TracerReader {
public:
    explicit TracerReader(Tracer tracer) : tracer_(std::move(tracer)) {}

    /// Heads of its columns, units included.
    [[nodiscard]] std::vector<std::string> columns() const;

    /// Parallel to columns(); NaN while there is no such body, and for accelerations in its first row.
    std::vector<double> row(const Frame& frame);

    /// The row before, for checkpoints; whom it follows is the scene's.
    template <class Archive, As<TracerReader> R> friend void carry(Archive& archive, R& reader) {
        bool seen = reader.before_.has_value();
        Moment moment = reader.before_.value_or(Moment{});
        auto& [time, centre, point, turned, summed] = moment;
        archive(seen, time, centre, point, turned, summed);
        if constexpr (!std::is_const_v<R>)
            reader.before_ = seen ? std::optional(moment) : std::nullopt;
    }

private:
    struct Moment {
        double time = 0;
        Eigen::Vector3d centre = Eigen::Vector3d::Zero(), point = Eigen::Vector3d::Zero(); // m/s, velocities
        Eigen::Vector4d turned = Eigen::Quaterniond::Identity().coeffs();                  // sensor frame to world
        Eigen::Vector3d summed = Eigen::Vector3d::Zero(); // m/s, the point's velocity as the sensor sums it up
    };
    Tracer tracer_;
    std::optional<Moment> before_;
};

} // namespace tumble::observe
