#include "stress/pictures.h"

#include "observe/frame_file.h"
#include "render/field_painter.h"
#include "render/png_writer.h"
#include "scene/specimen.h"
#include "stress/fields.h"

#include <Eigen/Geometry>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::stress {

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr double lifted = 25 * std::numbers::pi / 180; // the eye above the horizon
constexpr double room = 1.25;                          // what is seen, times the part

/// A free camera that looks at a box from a direction, and sees `height` m at its middle.
void look_at(scene::Render& settings, const Vector3d& target, const Vector3d& from, double height) {
    settings.camera = "free";
    settings.target = target;
    settings.eye =
        target + from.normalized() * 0.5 * height / std::tan(settings.field_of_view_deg * std::numbers::pi / 360);
    settings.view.reset();
}

class Album {
public:
    Album(const Recorded& recorded, const Study& study, const PictureOptions& options, fs::path folder)
        : recorded_(recorded), study_(study), options_(options), mesh_(*recorded.specimen().mesh),
          folder_(std::move(folder)), settings_(recorded.scene.render) {
        settings_.range.reset();
        for (const Vector3d& node : mesh_.nodes)
            bounds_.extend(node);
        axis_ = recorded.specimen().place.axis;
    }

    Result<std::vector<fs::path>> draw() {
        const auto component = fem::find_component(options_.component);
        if (!component)
            return component.problems();
        component_ = *component;
        values_ = at_nodes(component_, study_.worst.stress);
        if (const auto problems = find_frame())
            return *problems;
        find_worst_node();
        const Vector3d across = axis_.cross(outward_);
        for (const auto& problems : {draw_part(), draw_cut("cut-along", across, "along the axis"),
                                     draw_cut("cut-across", axis_, "across the axis"), draw_slices()})
            if (problems)
                return *problems;
        if (const auto written = png_.finish(); !written)
            return written.problems();
        return files_;
    }

private:
    using Failure = std::optional<Problems>;

    /// The frame nearest to the case, where frames were kept.
    Failure find_frame() {
        const fs::path frames = recorded_.frames;
        if (frames.empty())
            return std::nullopt;
        const auto layout = observe::read_layout(observe::layout_path(frames));
        if (!layout)
            return layout.problems();
        const double time = study_.cases[study_.worst.index].time;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < recorded_.loads.instants.size(); ++i) {
            const double off = std::abs(recorded_.loads.instants[i].time - time);
            if (off >= nearest)
                continue;
            nearest = off;
            frame_number_ = static_cast<std::int64_t>(i);
        }
        auto frame = observe::read_frame(observe::frame_path(frames, frame_number_), *layout);
        if (!frame)
            return frame.problems();
        frame_ = std::move(*frame);
        place_ = frame_->walls[static_cast<std::size_t>(recorded_.wall)];
        return std::nullopt;
    }

    /// Where von Mises' stress is largest on the surface, and which way is outwards there, across the axis.
    void find_worst_node() {
        double most = -1;
        const Vector3d base = recorded_.specimen().place.base;
        for (const solid::Facet& facet : mesh_.facets)
            for (const int node : facet.corners)
                if (const double here = fem::von_mises(study_.worst.stress.segment<6>(6 * node)); here > most) {
                    most = here;
                    worst_ = mesh_.nodes[static_cast<std::size_t>(node)];
                }
        const Vector3d middle = bounds_.center();
        Vector3d arm = worst_ - (std::holds_alternative<solid::MeshFile>(recorded_.specimen().part) ? middle : base);
        arm -= axis_.dot(arm) * axis_;
        outward_ = arm.norm() > 0 ? Vector3d(arm.normalized()) : axis_.unitOrthogonal();
    }

    Failure paint(const std::string& name, const scene::Render& settings, render::Field field,
                  const render::FieldLook& look, const observe::Frame* around) {
        const auto painted = render::paint_field(settings, field, look, around);
        if (!painted)
            return painted.problems();
        files_.push_back(folder_ / (name + ".png"));
        if (const auto added = png_.add(files_.back(), painted->picture); !added)
            return added.problems();
        return std::nullopt;
    }

    [[nodiscard]] std::string time() const {
        return fmt::format("t = {:.4f} s", study_.cases[study_.worst.index].time);
    }

    void name(render::Field& field) const {
        field.label = component_.label;
        field.unit = "Pa";
        field.has_sign = component_.has_sign;
    }

    Failure draw_part() {
        render::Field field = surface_field(mesh_, place_, values_);
        name(field);
        scene::Render settings = settings_;
        settings.projection = "perspective";
        const Vector3d up = Vector3d::UnitY();
        Vector3d from = place_.rotation * outward_;
        from = (from - up.dot(from) * up).normalized() * std::cos(lifted) + up * std::sin(lifted);
        look_at(settings, place_.rotation * bounds_.center() + place_.translation, from,
                room * bounds_.diagonal().norm());
        render::FieldLook look{.title = recorded_.scene.title + ": stress on " + recorded_.name(), .note = time()};
        look.part = recorded_.wall;
        look.veil = options_.veil;
        return paint("part", settings, std::move(field), look, frame_ ? &*frame_ : nullptr);
    }

    Failure draw_cut(const std::string& file, const Vector3d& normal, const std::string& how) {
        // A little towards the middle, where the worst node is the part's last.
        const Vector3d through = worst_ + 1e-3 * (bounds_.center() - worst_);
        const solid::Section section = solid::section_of(mesh_, through, normal);
        if (section.triangles.empty())
            return std::nullopt; // a part that bends back from there
        render::Field field = section_field(mesh_, section, place_, values_);
        name(field);
        Eigen::AlignedBox3d box;
        for (const Vector3d& point : field.points)
            box.extend(point);
        scene::Render settings = settings_;
        settings.projection = "orthographic";
        look_at(settings, box.center(), place_.rotation * normal, 1.1 * box.diagonal().norm());
        const render::FieldLook look{
            .title = fmt::format("{}, stress in a cut {} through the worst node", recorded_.name(), how),
            .note = time(),
            .lit = false};
        return paint(file, settings, std::move(field), look, nullptr);
    }

    Failure draw_slices() {
        for (const fem::Slice& slice : study_.slices) {
            const Eigen::VectorXd normal = fem::components_on(slice, mesh_, study_.worst.stress).row(0);
            render::Field field = unrolled_field(mesh_, slice, recorded_.specimen().place.base, axis_, outward_,
                                                 std::vector<double>(normal.data(), normal.data() + normal.size()));
            field.label = "normal";
            scene::Render settings = settings_;
            settings.camera = "side";
            settings.projection = "orthographic";
            settings.view.reset();
            const double depth = 1e3 * slice.depth; // mm
            const render::FieldLook look{.title = fmt::format("{}, normal stress {:.4g} mm beneath '{}', rolled out",
                                                              recorded_.name(), depth, slice.side),
                                         .note = time(),
                                         .caption = "to the right: around the part, anticlockwise; up: along its axis",
                                         .lit = false,
                                         .axes = false};
            if (auto failure = paint(fmt::format("slice-{}-{:.4g}mm", slice.side, depth), settings, std::move(field),
                                     look, nullptr))
                return failure;
        }
        return std::nullopt;
    }

    const Recorded& recorded_;
    const Study& study_;
    const PictureOptions& options_;
    const solid::HexMesh& mesh_;
    fs::path folder_;
    scene::Render settings_;
    Eigen::AlignedBox3d bounds_; // of the part, in its own frame
    Vector3d axis_, worst_, outward_;
    fem::Component component_;
    std::vector<double> values_;
    std::int64_t frame_number_ = 0;
    std::optional<observe::Frame> frame_;
    observe::WallPlace place_;
    render::PngWriter png_;
    std::vector<fs::path> files_;
};

} // namespace

Result<std::vector<fs::path>> draw_pictures(const Recorded& recorded, const Study& study, const PictureOptions& options,
                                            const fs::path& folder) {
    return Album(recorded, study, options, folder).draw();
}

} // namespace tumble::stress
