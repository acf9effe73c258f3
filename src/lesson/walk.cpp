#include "lesson/walk.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::lesson {

double Walk::fact(const std::string& name) const {
    for (const Fact& fact : facts)
        if (fact.name == name)
            return fact.value;
    return std::numeric_limits<double>::quiet_NaN();
}

namespace {

template <class Kind> std::vector<const Kind*> all_of_kind(const std::vector<Part>& parts) {
    std::vector<const Kind*> found;
    for (const Part& part : parts)
        if (const auto* one = std::get_if<Kind>(&part))
            found.push_back(one);
    return found;
}

} // namespace

std::vector<const Figure*> Walk::figures() const {
    return all_of_kind<Figure>(parts);
}

std::vector<const Film*> Walk::films() const {
    return all_of_kind<Film>(parts);
}

std::string at_most(double size) {
    return fmt::format("{:.0e}", std::pow(10, std::ceil(std::log10(std::max(size, 1e-16)))));
}

} // namespace tumble::lesson
