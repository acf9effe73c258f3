#include "report/measured_words.h"

#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::report {

namespace {

constexpr int most_digits_behind = 6; // a point; beyond them powers of ten are easier to read
constexpr double most_plain = 1e6;

bool is_nothing(const std::string& number) {
    return number.find_first_not_of("+-.0") == std::string::npos;
}

} // namespace

std::string with_minus(std::string number) {
    if (number.starts_with('-'))
        return is_nothing(number) ? number.substr(1) : "\u2212" + number.substr(1);
    if (number.starts_with('+') && is_nothing(number))
        return number.substr(1);
    return number;
}

std::string with_error(double value, double error) {
    if (!(error > 0) || !std::isfinite(error))
        return with_minus(fmt::format("{:.4g}", value));
    const int power = static_cast<int>(std::floor(std::log10(error)));
    const int behind = std::max(0, 1 - power);
    if (behind <= most_digits_behind && std::abs(value) < most_plain && error < most_plain)
        return with_minus(fmt::format("{:.{}f}", value, behind)) + fmt::format(" &plusmn; {:.{}f}", error, behind);
    const double larger = std::max(std::abs(value), error);
    const int common = static_cast<int>(std::floor(std::log10(larger)));
    const double unit = std::pow(10, common);
    const int digits = std::max(0, 1 - power + common);
    return fmt::format("({} &plusmn; {:.{}f})&middot;10<sup>{}</sup>",
                       with_minus(fmt::format("{:.{}f}", value / unit, digits)), error / unit, digits,
                       common < 0 ? fmt::format("\u2212{}", -common) : std::to_string(common));
}

std::string scene_words(const diagnose::Diagnosis& diagnosis) {
    std::string text = fmt::format("{} ({})", escaped(diagnosis.scene.string()), diagnosis.scene_hash);
    for (const std::string& set : diagnosis.sets)
        text += (&set == &diagnosis.sets.front() ? " with " : ", ") + escaped(set);
    return text;
}

} // namespace tumble::report
