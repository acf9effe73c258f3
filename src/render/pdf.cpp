#include "render/drawing_file.h"
#include "render/letters.h"
#include "render/paper.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <new>

namespace tumble::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double points_per_mm = points_per_inch / mm_per_inch;

/// Draws shape after shape; the page's scale stands in cairo's matrix, so lengths stay pixels.
struct CairoPainter {
    cairo_t* page;

    void take(const Vector3d& color, double opacity) const {
        cairo_set_source_rgba(page, color.x(), color.y(), color.z(), opacity);
    }
    /// What the path has become.
    void show(const Look& look) const {
        if (look.fill) {
            take(*look.fill, look.opacity);
            cairo_fill_preserve(page);
        }
        if (look.ink) {
            take(*look.ink, look.opacity);
            cairo_set_line_width(page, look.line);
            cairo_set_line_cap(page, look.long_ends ? CAIRO_LINE_CAP_SQUARE : CAIRO_LINE_CAP_BUTT);
            cairo_stroke_preserve(page);
        }
        cairo_new_path(page);
    }
    void add(const Arc& arc) const {
        const auto run = arc.sweep > 0 ? cairo_arc : cairo_arc_negative;
        run(page, arc.centre.x(), arc.centre.y(), arc.radius, arc.from, arc.from + arc.sweep);
    }
    void add(const Area& area) const { cairo_rectangle(page, area.left, area.top, area.width(), area.height()); }

    void operator()(const Circle& circle) const {
        add(Arc{circle.centre, circle.radius, 0, 2 * EIGEN_PI});
        cairo_close_path(page);
        show(circle.look);
    }

    void operator()(const Polygon& polygon) const {
        for (const Vector2d& point : polygon.points)
            cairo_line_to(page, point.x(), point.y());
        if (polygon.closed)
            cairo_close_path(page);
        show(polygon.look);
    }

    void operator()(const ArcLoops& shape) const {
        for (const std::vector<Arc>& loop : shape.loops) {
            cairo_new_sub_path(page);
            for (const Arc& arc : loop)
                add(arc);
            cairo_close_path(page);
        }
        show(shape.look);
    }

    void operator()(const Ramp& ramp) const {
        const Area& area = ramp.area;
        cairo_pattern_t* colors = ramp.upright ? cairo_pattern_create_linear(0, area.bottom, 0, area.top)
                                               : cairo_pattern_create_linear(area.left, 0, area.right, 0);
        const std::size_t last = ramp.map.points.size() - 1;
        for (std::size_t k = 0; k <= last; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(last);
            const Vector3d color = ramp.map.at(share);
            cairo_pattern_add_color_stop_rgb(colors, share, color.x(), color.y(), color.z());
        }
        cairo_set_source(page, colors);
        add(area);
        cairo_fill(page);
        cairo_pattern_destroy(colors);
    }

    void operator()(const Words& words) const {
        const double length = words.size * width_of_letters(words.text);
        const double before = words.align == Align::left ? 0 : words.align == Align::middle ? 0.5 * length : length;
        take(words.color, 1);
        cairo_set_font_size(page, words.size);
        cairo_move_to(page, words.at.x() - before, words.at.y());
        cairo_show_text(page, words.text.c_str());
        cairo_new_path(page);
    }

    void operator()(const GroupBegin& group) const {
        cairo_save(page);
        cairo_translate(page, group.at.x(), group.at.y());
        if (group.window) {
            add(*group.window);
            cairo_clip(page);
        }
    }

    void operator()(const GroupEnd&) const { cairo_restore(page); }
};

cairo_status_t keep(void* bytes, const unsigned char* data, unsigned int size) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
}

void set_letters(cairo_t* page) {
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF); // as widths are measured
    cairo_set_font_options(page, options);
    cairo_font_options_destroy(options);
    cairo_select_font_face(page, letter_family, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
}

} // namespace

std::string encode_pdf(const Drawing& drawing) {
    std::string bytes;
    cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(keep, &bytes, points_per_mm * drawing.width_mm,
                                                                   points_per_mm * drawing.height_mm);
    // The hour at which it was made would make two of the same drawing differ.
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "tumble");
    cairo_t* page = cairo_create(surface);
    cairo_set_source_rgb(page, drawing.background.x(), drawing.background.y(), drawing.background.z());
    cairo_paint(page);
    const double scale = points_per_mm * drawing.mm_per_pixel;
    cairo_scale(page, scale, scale);
    cairo_set_line_join(page, CAIRO_LINE_JOIN_ROUND);
    set_letters(page);
    for (const Shape& shape : drawing.shapes)
        std::visit(CairoPainter{page}, shape);
    cairo_show_page(page);
    const cairo_status_t drawn = cairo_status(page);
    cairo_destroy(page);
    cairo_surface_finish(surface);
    const cairo_status_t finished = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    if (drawn != CAIRO_STATUS_SUCCESS || finished != CAIRO_STATUS_SUCCESS)
        throw std::bad_alloc(); // its one reason: shapes are finite
    return bytes;
}

} // namespace tumble::render
