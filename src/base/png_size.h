#pragma once

#include <string>

namespace tumble {

/// Tells text programs how large a PNG is meant: puts the chunk pHYs (PNG specification, 11.3.5.3), pixels a metre
/// across and along, right behind the header of a whole file's bytes.
void insert_png_size(std::string& png, double dots_per_metre);

} // namespace tumble
