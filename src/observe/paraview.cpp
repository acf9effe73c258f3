#include "observe/paraview.h"

#include "observe/whole_file.h"
#include "observe/xml_arrays.h"

#include <fmt/format.h>
#include <numeric>

namespace tumble::observe {

namespace {

using Eigen::Vector3d;

void push(std::vector<float>& values, const Vector3d& vector) {
    for (int axis = 0; axis < 3; ++axis)
        values.push_back(static_cast<float>(vector[axis]));
}

/// Every point its own vertex, so that ParaView shows points without a filter.
std::string vertex_cells(std::size_t count) {
    std::vector<std::int64_t> connectivity(count), offsets(count);
    std::iota(connectivity.begin(), connectivity.end(), 0);
    std::iota(offsets.begin(), offsets.end(), 1);
    return "<Verts>\n" + data_array("connectivity", connectivity, 1) + data_array("offsets", offsets, 1) + "</Verts>\n";
}

std::string points(const std::vector<float>& positions) {
    return "<Points>\n" + data_array("Points", positions, 3) + "</Points>\n";
}

std::string cloud(const std::vector<float>& positions, const std::string& data, double time) {
    const std::size_t count = positions.size() / 3;
    return poly_data_file(fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" "
                                      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
                                      "<PointData>\n{1}</PointData>\n{2}{3}</Piece>\n",
                                      count, data, points(positions), vertex_cells(count)),
                          time);
}

const FrameShape& shape_of(const Frame& frame, std::size_t body) {
    return frame.layout->shapes[static_cast<std::size_t>(frame.shape[body])];
}

} // namespace

std::string bodies_vtp(const Frame& frame) {
    std::vector<float> positions, velocity, spin, orientation, speed, mass;
    std::vector<std::int64_t> shape(frame.shape.begin(), frame.shape.end());
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        push(positions, frame.position[i]);
        push(velocity, frame.velocity[i]);
        push(spin, frame.angular_velocity[i]);
        const Eigen::Quaterniond& q = frame.orientation[i];
        for (const double part : {q.w(), q.x(), q.y(), q.z()})
            orientation.push_back(static_cast<float>(part));
        speed.push_back(static_cast<float>(frame.velocity[i].norm()));
        mass.push_back(static_cast<float>(shape_of(frame, i).mass));
    }
    const std::string data = data_array("id", frame.id, 1) + data_array("shape", shape, 1) +
                             data_array("mass_kg", mass, 1) + data_array("velocity_m_s", velocity, 3) +
                             data_array("speed_m_s", speed, 1) + data_array("angular_velocity_rad_s", spin, 3) +
                             data_array("orientation_wxyz", orientation, 4);
    return cloud(positions, data, frame.time);
}

std::string spheres_vtp(const Frame& frame) {
    std::vector<float> positions, velocity, radius, speed;
    std::vector<std::int64_t> body;
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        const FrameShape& shape = shape_of(frame, i);
        for (std::size_t k = 0; k < shape.radii.size(); ++k) {
            const Vector3d arm = frame.orientation[i] * shape.centres[k];
            push(positions, frame.position[i] + arm);
            const Vector3d flow = frame.velocity[i] + frame.angular_velocity[i].cross(arm);
            push(velocity, flow);
            speed.push_back(static_cast<float>(flow.norm()));
            radius.push_back(static_cast<float>(shape.radii[k]));
            body.push_back(frame.id[i]);
        }
    }
    const std::string data = data_array("body", body, 1) + data_array("radius_m", radius, 1) +
                             data_array("velocity_m_s", velocity, 3) + data_array("speed_m_s", speed, 1);
    return cloud(positions, data, frame.time);
}

std::string walls_vtp(const Frame& frame) {
    std::vector<float> positions, velocity;
    std::vector<std::int64_t> connectivity, offsets, wall;
    std::vector<std::int64_t> line_connectivity, line_offsets, line_wall;
    std::int64_t base = 0;
    for (std::size_t w = 0; w < frame.walls.size(); ++w) {
        const FrameWall& surface = frame.layout->walls[w];
        const WallPlace& place = frame.walls[w];
        for (const Vector3d& vertex : surface.vertices) {
            const Vector3d arm = place.rotation * vertex;
            push(positions, place.translation + arm);
            push(velocity, place.velocity + place.angular_velocity.cross(arm));
        }
        for (const std::array<int, 3>& corners : surface.triangles) {
            for (const int corner : corners)
                connectivity.push_back(base + corner);
            offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
            wall.push_back(static_cast<std::int64_t>(w));
        }
        for (const std::array<int, 2>& ends : surface.lines) {
            line_connectivity.insert(line_connectivity.end(), {base + ends[0], base + ends[1]});
            line_offsets.push_back(static_cast<std::int64_t>(line_connectivity.size()));
            line_wall.push_back(static_cast<std::int64_t>(w));
        }
        base += static_cast<std::int64_t>(surface.vertices.size());
    }
    // Cells are numbered lines first, as VTK has it.
    wall.insert(wall.begin(), line_wall.begin(), line_wall.end());
    const std::string lines =
        line_offsets.empty() ? ""
                             : fmt::format("<Lines>\n{}{}</Lines>\n", data_array("connectivity", line_connectivity, 1),
                                           data_array("offsets", line_offsets, 1));
    return poly_data_file(
        fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
                    "NumberOfPolys=\"{}\">\n<PointData>\n{}</PointData>\n<CellData>\n{}</CellData>\n{}{}"
                    "<Polys>\n{}{}</Polys>\n</Piece>\n",
                    positions.size() / 3, line_offsets.size(), offsets.size(), data_array("velocity_m_s", velocity, 3),
                    data_array("wall", wall, 1), points(positions), lines, data_array("connectivity", connectivity, 1),
                    data_array("offsets", offsets, 1)),
        frame.time);
}

std::string pvd(const std::vector<TimedFile>& files) {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                       "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const auto& [time, name] : files)
        text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, escaped(name));
    return text + "</Collection>\n</VTKFile>\n";
}

Result<Done> ParaviewWriter::write(const Frame& frame, std::int64_t number) {
    struct Kind {
        const char* name;
        std::string (*content)(const Frame&);
        std::vector<TimedFile>& files;
    };
    for (const Kind& kind : {Kind{"bodies", bodies_vtp, bodies_}, Kind{"spheres", spheres_vtp, spheres_},
                             Kind{"walls", walls_vtp, walls_}}) {
        const std::string name = fmt::format("{}_{:06}.vtp", kind.name, number);
        if (const auto written = write_whole(folder_ / name, kind.content(frame)); !written)
            return written;
        kind.files.emplace_back(frame.time, name);
        const std::string series = fmt::format("{}.pvd", kind.name);
        if (const auto written = write_whole(folder_ / series, pvd(kind.files)); !written)
            return written;
    }
    return Done{};
}

} // namespace tumble::observe
