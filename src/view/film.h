#pragma once

#include "base/problem.h"
#include "observe/frame.h"
#include "run/schedule.h"
#include "view/source.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace tumble::view {

/// A video of a simulation that goes on. It is drawn and encoded beside the steps, which wait for it when it falls
/// behind: a film with holes would show another motion. One thread uses it.
class Film {
public:
    /// `bounds` (m) is what must be in the picture, `step` the length of the simulation's steps, s. Problems: those of
    /// the painter, a video that cannot be made.
    static Result<std::unique_ptr<Film>> open(const FilmLook& look, std::shared_ptr<const observe::FrameLayout> layout,
                                              const std::filesystem::path& file, const Eigen::AlignedBox3d& bounds,
                                              double step);
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;
    ~Film();

    /// The step that the next picture is of.
    [[nodiscard]] std::int64_t next() const { return schedule_.next(); }
    [[nodiscard]] bool due(std::int64_t step) const { return schedule_.due(step); }

    /// From the next picture on with another camera and other colours; size and rate stay.
    void restyle(const FilmLook& look);
    [[nodiscard]] bool shows_contacts() const { return look_.settings.marks.chains; }

    /// False when the video has failed; close() says why.
    bool shoot(std::int64_t step, observe::Frame frame);

    /// Ends it; a sentence about what has become of it.
    std::string close();

private:
    struct Inside;
    Film(std::unique_ptr<Inside> inside, const FilmLook& look, run::Schedule schedule, std::filesystem::path file);

    std::unique_ptr<Inside> inside_;
    FilmLook look_;
    run::Schedule schedule_;
    std::filesystem::path file_;
    std::int64_t shots_ = 0;
};

} // namespace tumble::view
