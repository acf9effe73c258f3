#pragma once

#include "sim3d/solver.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tumble::bench {

/// One sphere as LAMMPS and LIGGGHTS write it.
struct WrittenSphere {
    long id = 0;
    double radius = 0;                                          // m
    Eigen::Vector3d position = Eigen::Vector3d::Zero();         // m, wrapped into periodic boxes
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();         // m/s
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero(); // rad/s, zero where the file has none
};

/// Spheres of a LAMMPS data file with sections "Atoms" (id type diameter density x y z) and "Velocities" (id v w), by
/// id. Ends the program when the file cannot be read.
std::vector<WrittenSphere> read_data_file(const std::string& file);

/// Spheres of the first frame of a text dump with columns id radius x y z vx vy vz, by id. Ends the program when the
/// file cannot be read.
std::vector<WrittenSphere> read_dump(const std::string& file);

/// Writes every sphere of every body as such a frame, with ids from 1, body after body.
void write_dump(const std::string& file, const sim3d::World& world);

} // namespace tumble::bench
