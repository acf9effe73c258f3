#pragma once

#include "render/painter.h"
#include "render/panel_canvas.h"
#include "render/png_writer.h"
#include "view/controls.h"
#include "view/film_scales.h"
#include "view/hands.h"
#include "view/message.h"
#include "view/orbit.h"
#include "view/panels.h"
#include "view/plots.h"
#include "view/scene_text.h"
#include "view/source.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

namespace tumble::view {

struct StudioOptions {
    int width = 1280; // pixels, until a browser says its own
    int height = 720;
    std::filesystem::path folder; // where pictures, films and scenes are kept
};

/// A picture for all watchers and what can be seen in it, as JSON.
struct Shown {
    render::Picture picture;
    std::string state;
};

/// Draws what a source shows beside a panel, and takes what hands do. One thread uses it.
class Studio {
public:
    // Of a window; what is beyond is taken as the end.
    static constexpr int least_width = 320, least_height = 200; // pixels
    static constexpr int most_side = 2560;                      // of a phone held upright the height

    /// Problems: settings that cannot be drawn, a system without OpenGL.
    static Result<std::unique_ptr<Studio>> open(std::unique_ptr<Source> source, const SceneText& text,
                                                const scene::Scene& scene, Plots plots, const StudioOptions& options);

    /// Presses and keys go to the panel where they began in it, else they move the camera.
    void take(const Message& message);

    /// Whether draw() would show something else than it did last.
    [[nodiscard]] bool is_stale();

    /// Problems: the window's size cannot be drawn.
    Result<Shown> draw();

    /// What the plots show of this moment of a simulation, though nobody looks on.
    void keep_points();

    /// For a source whose time goes on between two pictures.
    [[nodiscard]] bool is_playing() { return source_->state().playing; }
    [[nodiscard]] Source& source() { return *source_; }

private:
    static constexpr int settling_passes = 3; // what Dear ImGui sizes by itself is right in the second frame

    Studio(std::unique_ptr<Source> source, const SceneText& text, const scene::Scene& scene, Plots plots,
           const StudioOptions& options);

    void take_pointer(const PointerMoved& moved);
    void take_key(const KeyChanged& change);
    void resize(const Resized& size);
    [[nodiscard]] bool is_in_panel(double x) const { return panel_shown_ && x < panel_width_; }
    [[nodiscard]] Eigen::Vector2d from_middle(double x, double y) const;
    Orbit& orbit();
    void set_camera(const std::string& name);
    void aim();
    Result<Done> open_painter();
    Result<Done> open_panel();
    Result<Done> open_window();
    Result<Done> take_size();
    void pass_panel();
    void draw_scene();
    [[nodiscard]] bool is_at_rest() const;
    void grant(const Wishes& wishes);
    [[nodiscard]] FilmLook film_look();
    void begin_film();
    void keep_picture();
    void name_kept();
    void fit_range();
    void save_scene();
    Result<std::filesystem::path> write_scene();
    [[nodiscard]] scene::Box seen_box() const;
    [[nodiscard]] std::filesystem::path free_name(const std::string& extension);
    [[nodiscard]] render::Picture beside_panel(render::Picture panel) const;
    [[nodiscard]] std::string describe() const;

    std::unique_ptr<Source> source_;
    SceneText text_;
    scene::Render settings_; // of the scene
    scene::Render look_;     // as hands have changed it
    std::string name_;       // of files that are kept
    std::string title_;
    std::filesystem::path folder_;
    Controls controls_;
    Plots plots_;
    std::shared_ptr<const observe::FrameLayout> layout_;
    Resized window_;       // panel included
    Resized drawn_window_; // as it could be drawn last

    std::optional<render::Painter> painter_;
    std::optional<render::PanelCanvas> panel_;
    bool panel_shown_ = true;
    bool panel_toggled_ = false; // by a hand
    int panel_width_ = 0;        // pixels
    bool resized_ = false;       // and not yet drawn so
    Hands hands_;
    std::optional<Orbit> orbit_;
    render::Held held_;          // where there is an orbit
    std::optional<int> dragged_; // button that holds the camera
    std::set<int> panel_holds_;  // buttons pressed in the panel
    Eigen::Vector2d pointer_ = Eigen::Vector2d::Zero();
    bool types_ = false; // a field of the panel takes letters

    MomentPtr moment_;
    render::Picture scene_picture_;
    std::uint64_t drawn_ = 0; // number of the moment in it
    bool look_changed_ = true;
    bool film_wanted_ = false;
    FilmScales film_scales_;                                                         // of the film that goes on
    bool sketched_ = false;                                                          // the picture has rough edges
    std::chrono::steady_clock::time_point moved_ = std::chrono::steady_clock::now(); // when it last had to be new
    int passes_left_ = 0; // of the panel until it has settled
    render::PngWriter png_;
    int kept_ = 0;                               // number of the last file
    std::vector<std::filesystem::path> keeping_; // pictures that are being written
    std::string notice_, told_notice_;           // of what was kept; as it was last drawn
    std::string saved_, told_saved_;             // the same of the scene
    std::string warnings_;                       // of the source, the first of them
    std::string told_;                           // of the source when last drawn
    std::map<std::string, std::array<double, 4>> places_;
    std::string told_key_; // of the widget under the pointer
    std::chrono::steady_clock::time_point passed_ = std::chrono::steady_clock::now();
};

} // namespace tumble::view
