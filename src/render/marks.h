#pragma once

#include "observe/frame.h"
#include "render/area.h"
#include "render/camera.h"
#include "render/color_range.h"
#include "render/patch.h"
#include "render/strokes.h"
#include "render/theme.h"
#include "scene/scene.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Lines over the bodies: velocities, their mean field, force chains, trails. What is drawn is settled by scene::Marks;
/// docs/pictures.md says how it is to be read.
namespace tumble::render {

/// What the lines of a picture mean, for its legend. Lengths in pixels.
struct MarkKey {
    struct Arrow {
        double speed = 0; // m/s, of an arrow of this length
        double length = 0;
        bool mean = false; // of the field
        Span over{};       // s, from the first to the last of the mean's frames
    };
    struct Chain {
        double force = 0; // N, of a line of this thickness
        double thickness = 0;
        bool beyond = false; // some of the picture are thicker
    };
    struct Trail {
        std::string name;
        Eigen::Vector3d color = Eigen::Vector3d::Zero();
    };
    std::optional<Arrow> arrow;
    std::optional<Chain> chain;
    std::vector<Trail> trails;                   // those with a row of their own
    int more_trails = 0;                         // beside them, all of one colour
    std::optional<Eigen::Vector3d> more_color{}; // theirs, where none of the named ones was left out
    std::optional<double> since;                 // s, where the first of all trails begins
    std::vector<std::string> clip;               // where bodies are left out or cut open, a row each

    /// The mean has a second row for its time, trails together one for theirs.
    [[nodiscard]] int rows() const;
    /// What holds for either of two pictures that share a key.
    void join(const MarkKey& other);
    /// The same with words as long as those of the frames to come may be.
    [[nodiscard]] MarkKey with_longest_words() const;
};

/// Rows of the key of such marks, and of that of pictures with their marks and their clip.
int key_rows(const scene::Marks& marks);
int key_rows(const scene::Render& settings, const observe::FrameLayout& layout);

/// How one picture looks at them.
struct MarkView {
    const Camera& camera;
    Area window;     // pixels: marks of what lies outside are left out
    double unit = 1; // pixels, render/layout.h
    const Theme& theme;
    std::optional<Eigen::AlignedBox3d> clip; // m, bodies whose centres lie outside have no marks
    bool clip_cuts = false;                  // and bodies are cut open there
};

/// Arrows at most of this density, and the grid of the mean field: units between them.
constexpr double arrow_spacing = 26;
constexpr double field_spacing = 40;
/// Units, the length of the legend's arrow and the thickness of the legend's line.
constexpr double arrow_length = 40;
constexpr double chain_thickness = 8;

/// N, of the contacts that press; pulls make no chains.
std::vector<double> pressing_forces(const std::vector<observe::FrameContact>& contacts);

/// Index of the body that a trail is of: one of that name, the first, or of that id.
std::optional<std::size_t> body_of(const observe::Frame& frame, const std::string& trail);

/// The marks of a row of frames, given in the order of their time; one that is earlier than the one before begins the
/// trails anew.
class MarkMaker {
public:
    explicit MarkMaker(const scene::Marks& wanted = {}) : wanted_(wanted) {}

    /// The frames come every so many seconds (above 0): trails break where one is missing. Without it only where the
    /// way in time is many times as long as usual, as for somebody who looks here and there.
    void expect_pace(double every) { pace_ = every; }
    /// Other marks from now on; scales and trails that stay as they were go on.
    void restyle(const scene::Marks& wanted);
    [[nodiscard]] bool any() const;

    /// Before the first picture: a frame that the mean field is to hold. Once one was foreseen the field and its scale
    /// stay the same in all pictures; else it is the mean of the frames up to now.
    void foresee(const observe::Frame& frame, const MarkView& view);
    /// A frame whose turn has come, drawn or not.
    void take_in(const observe::Frame& frame, const MarkView& view);

    /// The marks of the frame taken in last, in the order to draw, and the same in flat pieces.
    [[nodiscard]] std::vector<Stroke> strokes(const observe::Frame& frame, const MarkView& view) const;
    [[nodiscard]] std::vector<Patch> patches(const observe::Frame& frame, const MarkView& view) const;
    [[nodiscard]] MarkKey key(const observe::FrameLayout& layout, const MarkView& view) const;

private:
    struct Cell {
        double mass = 0;                                    // kg, summed over frames
        Eigen::Vector2d moment = Eigen::Vector2d::Zero();   // kg times pixels from the picture's left and top
        Eigen::Vector2d momentum = Eigen::Vector2d::Zero(); // kg m/s, right and up in the picture
    };
    struct FieldArrow {
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();   // pixels, the centre of what the cell holds
        Eigen::Vector2d velocity = Eigen::Vector2d::Zero(); // m/s, right and up
    };
    struct Step {
        double time = 0;                                 // s
        Eigen::Vector3d place = Eigen::Vector3d::Zero(); // m
        std::int64_t id = 0;                             // of the body
        bool leapt = false;                              // nothing is known of the way from the step before
    };
    using Trail = std::vector<Step>;
    struct View {
        Camera camera;
        std::optional<Eigen::AlignedBox3d> clip;
        [[nodiscard]] bool shows_as(const MarkView& view) const;
    };

    void add_to_field(const observe::Frame& frame, const MarkView& view);
    void follow(const observe::Frame& frame);
    bool leaps_to(double time);
    [[nodiscard]] double longest_step() const;
    [[nodiscard]] Eigen::Vector3d trail_color(std::size_t trail) const;
    [[nodiscard]] std::vector<FieldArrow> means() const;
    [[nodiscard]] std::vector<double> mean_speeds() const;
    void add_arrows(const observe::Frame& frame, const MarkView& view, std::vector<Stroke>& strokes) const;
    void add_field(const MarkView& view, std::vector<Stroke>& strokes) const;
    void add_chains(const observe::Frame& frame, const MarkView& view, std::vector<Stroke>& strokes) const;
    void add_trails(const observe::Frame& frame, const MarkView& view, std::vector<Stroke>& strokes) const;

    scene::Marks wanted_;
    ColorRange speeds_{std::nullopt, false};
    ColorRange forces_{std::nullopt, false, 0};
    double speed_ = 1;                          // m/s, of the legend's arrow
    double force_ = 1;                          // N, of the legend's line
    bool beyond_ = false;                       // some line is thicker
    std::map<std::pair<int, int>, Cell> field_; // by column and row of the grid in the picture
    std::optional<View> seen_;                  // that the field was gathered for
    Span gathered_;                             // s, from the first to the last frame in the field
    bool foreseen_ = false;
    std::vector<Trail> trails_;      // parallel to wanted_.trails
    std::optional<double> followed_; // s, of the last frame
    std::optional<double> pace_;     // s, that is known to lie between frames
    double usual_ = 0;               // s, from frame to frame
    bool leapt_ = false;             // to the last frame
};

} // namespace tumble::render
