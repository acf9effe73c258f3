#pragma once

#include "render/color_map.h"
#include "render/picture.h"
#include "render/quantity.h"
#include "render/theme.h"
#include "scene/scene.h"

/// What a picture for print has in place of a screen's: white, sized in mm, letters in points.
namespace tumble::render {

constexpr double mm_per_inch = 25.4;
constexpr double points_per_inch = 72;

/// Pixels a unit (render/layout.h) so that the numbers at scales have that many points.
double letter_unit(const scene::Paper& paper);

/// Pixels a metre of paper; 0 for pictures of a screen.
double dots_per_metre(const scene::Render& settings);

/// Problem where numbers or units had to be cut in a picture for print, with a size that is likely to do.
Result<Done> check_room(const std::vector<Crowded>& crowded, const scene::Render& settings);

/// Colours that go with the picture's background. Problem for an unknown word.
Result<Theme> theme_of(const scene::Render& settings);

/// The colours of the bodies; one for all where the quantity has no label. Problem for an unknown word.
Result<ColorMap> map_of(const scene::Render& settings, const Quantity& quantity, const Theme& theme);

/// Puts a picture into a larger one, its upper left corner at that pixel.
void paste(const Picture& part, int left, int top, Picture& whole);

} // namespace tumble::render
