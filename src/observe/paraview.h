#pragma once

#include "observe/frame.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Exports that ParaView opens: VTP files per frame and a PVD file that lines them up in time.
namespace tumble::observe {

/// One point per body: id, shape, mass_kg, velocity_m_s, angular_velocity_rad_s, orientation_wxyz, speed_m_s.
std::string bodies_vtp(const Frame& frame);

/// One point per sphere of every body: radius_m for a glyph filter, body id, velocity_m_s of the sphere's centre.
std::string spheres_vtp(const Frame& frame);

/// Triangles of all walls, or lines in two dimensions, where they stand now: wall index and velocity_m_s of each
/// corner.
std::string walls_vtp(const Frame& frame);

/// Time in s and file name, relative to the PVD file.
using TimedFile = std::pair<double, std::string>;
std::string pvd(const std::vector<TimedFile>& files);

/// Writes bodies, spheres and walls of one frame after the other into a folder and keeps three PVD series (bodies.pvd,
/// spheres.pvd, walls.pvd) whole after every frame. Problems: the system's reason.
class ParaviewWriter {
public:
    explicit ParaviewWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}
    /// `number` is the frame's, in the names of its files.
    Result<Done> write(const Frame& frame, std::int64_t number);

private:
    std::filesystem::path folder_;
    std::vector<TimedFile> bodies_, spheres_, walls_;
};

} // namespace tumble::observe
