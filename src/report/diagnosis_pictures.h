#pragma once

#include "diagnose/diagnosis.h"

#include <string>
#include <vector>

namespace tumble::report {

/// A picture of its own beside the page.
struct PictureFile {
    std::string name; // of the file
    std::string svg;
};

/// Of records their residuals in one picture, residuals.svg; of a bed a picture a number, such as
/// half-load-circulation.svg.
std::vector<PictureFile> pictures_of(const diagnose::Diagnosis& diagnosis);

} // namespace tumble::report
