#include "support/sphere_file.h"

#include "support/arguments.h"

#include <algorithm>
#include <fmt/os.h>
#include <fstream>
#include <map>
#include <sstream>

namespace tumble::bench {
namespace {

void sort_by_id(std::vector<WrittenSphere>& spheres) {
    std::sort(spheres.begin(), spheres.end(),
              [](const WrittenSphere& a, const WrittenSphere& b) { return a.id < b.id; });
}

std::istream& operator>>(std::istream& in, Eigen::Vector3d& v) {
    return in >> v.x() >> v.y() >> v.z();
}

} // namespace

std::vector<WrittenSphere> read_data_file(const std::string& file) {
    std::ifstream in(file);
    std::map<long, WrittenSphere> by_id;
    std::string line, section;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        if (line.starts_with("Atoms") || line.starts_with("Velocities"))
            section = line;
        WrittenSphere read;
        if (section.empty() || !(words >> read.id))
            continue;
        WrittenSphere& sphere = by_id[read.id];
        sphere.id = read.id;
        double type = 0, diameter = 0, density = 0;
        if (section.starts_with("Atoms")) {
            words >> type >> diameter >> density >> sphere.position;
            sphere.radius = diameter / 2;
        } else {
            words >> sphere.velocity >> sphere.angular_velocity;
        }
        if (!words)
            refuse(fmt::format("{}: cannot read '{}'", file, line));
    }
    if (by_id.empty())
        refuse(fmt::format("{}: no spheres could be read", file));
    std::vector<WrittenSphere> spheres;
    for (const auto& [id, sphere] : by_id)
        spheres.push_back(sphere);
    return spheres;
}

std::vector<WrittenSphere> read_dump(const std::string& file) {
    std::ifstream in(file);
    std::vector<WrittenSphere> spheres;
    std::string line;
    bool reading = false;
    while (std::getline(in, line)) {
        if (line.starts_with("ITEM: TIMESTEP") && !spheres.empty())
            break;
        if (line.starts_with("ITEM:")) {
            reading = line.starts_with("ITEM: ATOMS id radius x y z vx vy vz");
            continue;
        }
        if (!reading)
            continue;
        std::istringstream words(line);
        WrittenSphere sphere;
        if (!(words >> sphere.id >> sphere.radius >> sphere.position >> sphere.velocity))
            refuse(fmt::format("{}: cannot read '{}'", file, line));
        spheres.push_back(sphere);
    }
    if (spheres.empty())
        refuse(fmt::format("{}: no frame with 'id radius x y z vx vy vz' could be read", file));
    sort_by_id(spheres);
    return spheres;
}

void write_dump(const std::string& file, const sim3d::World& world) {
    const auto& shapes = sim3d::shapes_of(world);
    const auto bodies = sim3d::bodies_of(world);
    std::size_t count = 0;
    for (const auto& body : bodies)
        count += shapes[static_cast<std::size_t>(body.shape)].spheres.size();
    auto out = fmt::output_file(file);
    out.print("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", sim3d::steps_of(world), count);
    out.print("ITEM: ATOMS id radius x y z vx vy vz\n");
    long id = 0;
    for (const auto& body : bodies)
        for (const auto& sphere : shapes[static_cast<std::size_t>(body.shape)].spheres) {
            const Eigen::Vector3d arm = body.orientation * sphere.centre;
            const Eigen::Vector3d x = body.position + arm, v = body.velocity + body.angular_velocity.cross(arm);
            out.print("{} {} {:.17g} {:.17g} {:.17g} {:.9g} {:.9g} {:.9g}\n", ++id, sphere.radius, x.x(), x.y(), x.z(),
                      v.x(), v.y(), v.z());
        }
}

} // namespace tumble::bench
