#include "render/letters.h"

#include <cairo.h>
#include <memory>

namespace tumble::render {

namespace {

struct Release {
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
    void operator()(cairo_font_face_t* face) const { cairo_font_face_destroy(face); }
    void operator()(cairo_scaled_font_t* font) const { cairo_scaled_font_destroy(font); }
};
template <class T> using Owned = std::unique_ptr<T, Release>;

// Large, so that nothing is rounded to the grid of the font's outlines.
constexpr double measured_size = 1000;

Owned<cairo_scaled_font_t> measured_font() {
    const Owned<cairo_font_options_t> options(cairo_font_options_create());
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    const Owned<cairo_font_face_t> face(
        cairo_toy_font_face_create(letter_family, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL));
    cairo_matrix_t size, plain;
    cairo_matrix_init_scale(&size, measured_size, measured_size);
    cairo_matrix_init_identity(&plain);
    return Owned<cairo_scaled_font_t>(cairo_scaled_font_create(face.get(), &size, &plain, options.get()));
}

} // namespace

double width_of_letters(const std::string& text) {
    static const Owned<cairo_scaled_font_t> font = measured_font();
    cairo_text_extents_t extents;
    cairo_scaled_font_text_extents(font.get(), text.c_str(), &extents);
    return extents.x_advance / measured_size;
}

} // namespace tumble::render
