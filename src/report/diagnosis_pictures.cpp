#include "report/diagnosis_pictures.h"

#include "report/bed_section.h"
#include "report/residual_plots.h"
#include "report/svg_plot.h"

#include <cctype>

namespace tumble::report {

constexpr int in_a_row = 2;

/// Words of a measurement as part of a file's name.
static std::string as_name(const std::string& words) {
    std::string name;
    for (const char c : words) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = std::isalnum(byte) != 0;
        if (plain || (!name.empty() && name.back() != '-')) {
            name += plain ? static_cast<char>(std::tolower(byte)) : '-';
        }
    }
    return name;
}

std::vector<PictureFile> pictures_of(const diagnose::Diagnosis& diagnosis) {
    if (diagnosis.beds.empty()) {
        return {{"residuals.svg", svg_file(residual_plots(diagnosis), in_a_row)}};
    }
    std::vector<PictureFile> pictures;
    for (const diagnose::BedNumber& one : diagnosis.beds) {
        pictures.push_back({as_name(one.condition + " " + one.measure) + ".svg", svg_file({plot_of(one)}, 1)});
    }
    return pictures;
}

} // namespace tumble::report
