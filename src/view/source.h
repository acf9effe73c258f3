#pragma once

#include "base/books.h"
#include "base/problem.h"
#include "observe/frame.h"
#include "render/camera.h"
#include "scene/override.h"
#include "scene/scene.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tumble::view {

/// What is to be seen at one instant.
struct Moment {
    observe::Frame frame;
    std::optional<Books> books; // of a simulation; a recorded run has them in its series
    std::uint64_t number = 0;   // differs from moment to moment
};
using MomentPtr = std::shared_ptr<const Moment>;

struct SourceState {
    bool playing = false;
    bool ended = false; // nothing comes after this moment
    double time = 0;    // s
    double first = 0;   // s
    double last = 0;    // s
    double speed = 0;   // s of the scene per s of watching that is wanted; 0: as fast as it goes
    double pace = 0;    // the same as it is; 0 while unknown
    double steps_per_s = 0;
    bool change_waits = false; // for the end of a wall's period
    bool filming = false;      // a video is being made
    std::string trouble;       // why it does not go on, or what was refused; empty while all is well
    std::string filmed;        // sentence about the last video
};

/// How a film's pictures are to look.
struct FilmLook {
    scene::Render settings;
    std::optional<render::Held> held{}; // the camera, by a hand
};

/// Of time, s; of a recorded run the times of its first and last frame.
struct Stretch {
    double from = 0, to = 0;
};

/// What a view shows: a simulation at work, or a run that is over. None of these calls waits for a step.
class Source {
public:
    virtual ~Source() = default;

    /// Of all its frames.
    [[nodiscard]] virtual std::shared_ptr<const observe::FrameLayout> layout() const = 0;
    /// What must be in the picture, m.
    [[nodiscard]] virtual Eigen::AlignedBox3d bounds() const = 0;
    /// Sentences about what is missing or was left out, known since it was opened.
    [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
    /// The moment to be shown now; null while there is none.
    virtual MomentPtr newest() = 0;
    [[nodiscard]] virtual SourceState state() = 0;

    virtual void play(bool on) = 0;
    /// So many steps, or frames of a recorded run, which may go back.
    virtual void step(std::int64_t count) = 0;
    virtual void set_speed(double speed) = 0;

    /// Recorded runs: to the frame nearest to a time, s.
    [[nodiscard]] virtual bool can_seek() const = 0;
    virtual void seek(double /*time*/) {}

    /// What can be shown of a stretch of time, s. Problem: nothing; says from when to when there is something.
    [[nodiscard]] virtual Result<Stretch> find(double from, double to) = 0;

    /// Whether moments can say who touches whom, and whether they are wanted to.
    [[nodiscard]] virtual bool can_show_contacts() const = 0;
    virtual void show_contacts(bool /*on*/) {}

    /// Simulations: the scene with other values on top, from now on; whatever was changed before is replaced.
    [[nodiscard]] virtual bool can_change() const = 0;
    virtual void change(std::vector<scene::Override> /*changes*/) {}

    /// Films from here on (a recorded run: all of it) with this look, until film_no_more.
    virtual void film(const FilmLook& look, const std::filesystem::path& file) = 0;
    /// A film of a simulation goes on with another camera and other colours.
    virtual void restyle_film(const FilmLook& /*look*/) {}
    virtual void film_no_more() = 0;
};

} // namespace tumble::view
