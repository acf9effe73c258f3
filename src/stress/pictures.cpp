#include "stress/pictures.h"

#include "base/text.h"
#include "observe/frame_file.h"
#include "render/color_range.h"
#include "render/field_painter.h"
#include "render/png_writer.h"
#include "scene/specimen.h"
#include "stress/fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <utility>

namespace tumble::stress {

namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr double lifted = 25 * std::numbers::pi / 180; // the eye above the horizon
constexpr double rounding = 1e-6;                      // of the part's length
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
          folder_(std::move(folder)), settings_(recorded.scene.render), worst_(study.worst_place) {
        settings_.range.reset();
        for (const Vector3d& node : mesh_.nodes)
            bounds_.extend(node);
        axis_ = recorded.specimen().place.axis;
        // The place of a part from a file says nothing but its axis.
        base_ = std::holds_alternative<solid::MeshFile>(recorded.specimen().part) ? Vector3d(bounds_.center())
                                                                                  : recorded.specimen().place.base;
    }

    Result<std::vector<fs::path>> draw() {
        const auto component = fem::find_component(options_.component);
        if (!component)
            return component.problems();
        component_ = *component;
        values_ = at_nodes(component_, study_.worst.stress);
        if (const auto problems = find_frame())
            return *problems;
        look_outwards();
        surface_ = surface_field(mesh_, place_, values_);
        name(surface_);
        // A little towards the middle, where the worst node is the part's last.
        cut("cut-along", axis_.cross(outward_), worst_ + 1e-3 * (bounds_.center() - worst_), "along the axis");
        cut("cut-across", axis_, inside_the_ends(), "across the axis");
        // One scale, the surface's: that of a cut through the strongest contact would leave the rest of the part dark.
        render::WidestRange range;
        range.take_in(surface_.values);
        span_ = range.span(component_.has_sign);
        for (const auto& problems : {draw_part(), draw_cuts(), draw_slices()})
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
            frame_number_ = recorded_.first_frame + static_cast<std::int64_t>(i);
        }
        auto frame = observe::read_frame(observe::frame_path(frames, frame_number_), *layout);
        if (!frame)
            return frame.problems();
        frame_ = std::move(*frame);
        place_ = frame_->walls[static_cast<std::size_t>(recorded_.wall)];
        return std::nullopt;
    }

    /// Which way is outwards at the worst node, across the axis.
    void look_outwards() {
        Vector3d arm = worst_ - base_;
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

    [[nodiscard]] const Case& worst_case() const { return study_.cases[study_.worst.index]; }
    [[nodiscard]] std::string time() const { return fmt::format("t = {:.4f} s", worst_case().time); }
    /// A mean is of the time before the one that stands in the picture.
    [[nodiscard]] std::string titled(const std::string& words) const {
        return worst_case().window > 0
                   ? fmt::format("Mean load of the {:.3g} ms before t: {}", 1e3 * worst_case().window, words)
                   : words;
    }

    void name(render::Field& field) const {
        field.label = component_.label;
        field.unit = "Pa";
        field.has_sign = component_.has_sign;
    }

    Failure draw_part() {
        scene::Render settings = settings_;
        settings.projection = "perspective";
        const Vector3d up = Vector3d::UnitY();
        Vector3d from = place_.rotation * outward_;
        from = (from - up.dot(from) * up).normalized() * std::cos(lifted) + up * std::sin(lifted);
        look_at(settings, place_.rotation * bounds_.center() + place_.translation, from,
                room * bounds_.diagonal().norm());
        const std::string part = "stress on " + recorded_.name();
        render::FieldLook look{.title = worst_case().window > 0 ? titled(part) : recorded_.scene.title + ": " + part,
                               .note = time(),
                               .key = extremes_of(surface_),
                               .span = span_};
        look.part = recorded_.wall;
        look.veil = options_.veil;
        return paint("part", settings, std::move(surface_), look, frame_ ? &*frame_ : nullptr);
    }

    /// The worst node, from an end face half a layer of nodes inwards: on the face itself a cut shows no inside.
    [[nodiscard]] Vector3d inside_the_ends() const {
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest; // m, along the axis
        for (const Vector3d& node : mesh_.nodes) {
            lowest = std::min(lowest, node.dot(axis_));
            highest = std::max(highest, node.dot(axis_));
        }
        const double at = worst_.dot(axis_), apart = rounding * (highest - lowest);
        if (at - lowest > apart && highest - at > apart)
            return worst_;
        double layer = highest - lowest; // m, to the nearest node that is not on this end
        for (const Vector3d& node : mesh_.nodes)
            if (const double off = std::abs(node.dot(axis_) - at); off > apart)
                layer = std::min(layer, off);
        return worst_ + (at - lowest > apart ? -0.5 : 0.5) * layer * axis_;
    }

    /// "at y = 60 mm" of a plane across an axis of the scene, else a point that it goes through.
    [[nodiscard]] static std::string where(const Vector3d& through, const Vector3d& normal) {
        for (const auto& [axis, letter] : {std::pair{0, 'x'}, std::pair{1, 'y'}, std::pair{2, 'z'}})
            if (std::abs(normal[axis]) > 1 - rounding)
                return fmt::format("at {} = {:.4g} mm", letter, 1e3 * through[axis]);
        return fmt::format("through ({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * through.x(), 1e3 * through.y(),
                           1e3 * through.z());
    }

    /// For the key of colours, whose ends may lie below.
    [[nodiscard]] static std::string extremes_of(const render::Field& field) {
        const auto [least, largest] = std::minmax_element(field.values.begin(), field.values.end());
        return field.has_sign
                   ? fmt::format("{} to {}", format_si(*least, field.unit, 2), format_si(*largest, field.unit, 2))
                   : "largest " + format_si(*largest, field.unit, 2);
    }

    void cut(const std::string& file, const Vector3d& normal, const Vector3d& through, const std::string& how) {
        const solid::Section section = solid::section_of(mesh_, through, normal);
        if (section.triangles.empty())
            return; // a part that bends back from there
        cuts_.push_back(
            {file, how + " " + where(through, normal), normal, section_field(mesh_, section, place_, values_)});
        name(cuts_.back().field);
    }

    Failure draw_cuts() {
        for (Cut& cut : cuts_) {
            Eigen::AlignedBox3d box;
            for (const Vector3d& point : cut.field.points)
                box.extend(point);
            scene::Render settings = settings_;
            settings.projection = "orthographic";
            look_at(settings, box.center(), place_.rotation * cut.normal, 1.1 * box.diagonal().norm());
            const render::FieldLook look{.title =
                                             titled(fmt::format("{}, stress in a cut {}", recorded_.name(), cut.how)),
                                         .note = time(),
                                         .key = extremes_of(cut.field),
                                         .span = span_,
                                         .lit = false};
            if (auto failure = paint(cut.file, settings, std::move(cut.field), look, nullptr))
                return failure;
        }
        return std::nullopt;
    }

    Failure draw_slices() {
        std::vector<render::Field> fields;
        render::WidestRange range;
        for (const fem::Slice& slice : study_.slices) {
            const Eigen::VectorXd normal = fem::components_on(slice, mesh_, study_.worst.stress).row(0);
            fields.push_back(unrolled_field(mesh_, slice, base_, outward_,
                                            std::vector<double>(normal.data(), normal.data() + normal.size())));
            fields.back().label = "normal";
            range.take_in(fields.back().values);
        }
        for (std::size_t s = 0; s < fields.size(); ++s)
            if (auto failure = draw_slice(study_.slices[s], std::move(fields[s]), range.span(true)))
                return failure;
        return std::nullopt;
    }

    Failure draw_slice(const fem::Slice& slice, render::Field field, const render::Span& span) {
        scene::Render settings = settings_;
        settings.camera = "side";
        settings.projection = "orthographic";
        settings.view.reset();
        const double depth = 1e3 * slice.depth; // mm
        const bool end = slice.beneath_end(axis_);
        const render::FieldLook look{
            .title = titled(fmt::format("{}, normal stress {:.4g} mm beneath '{}'{}", recorded_.name(), depth,
                                        slice.side, end ? "" : ", rolled out")),
            .note = time(),
            .caption = end ? "the end, seen from outside"
                           : "to the right: around the part, as seen from outside; up: along its axis",
            .key = extremes_of(field),
            .span = span,
            .lit = false,
            .axes = false};
        return paint(fmt::format("slice-{}-{:.4g}mm", slice.side, depth), settings, std::move(field), look, nullptr);
    }

    const Recorded& recorded_;
    const Study& study_;
    const PictureOptions& options_;
    const solid::HexMesh& mesh_;
    fs::path folder_;
    scene::Render settings_;
    Eigen::AlignedBox3d bounds_; // of the part, in its own frame
    Vector3d axis_, base_, outward_;
    const Vector3d& worst_; // where von Mises' stress is largest, of all nodes
    fem::Component component_;
    std::vector<double> values_;
    struct Cut {
        std::string file, how;
        Vector3d normal;
        render::Field field;
    };
    render::Field surface_;
    std::vector<Cut> cuts_;
    render::Span span_; // of the part and its cuts, Pa
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
