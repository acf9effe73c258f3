#include "sheet/sheet.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::sheet {

double Sheet::fact(const std::string& name) const {
    for (const Fact& fact : facts)
        if (fact.name == name)
            return fact.value;
    return std::numeric_limits<double>::quiet_NaN();
}

std::vector<const Figure*> Sheet::figures() const {
    std::vector<const Figure*> found;
    for (const Part& part : parts)
        if (const auto* figure = std::get_if<Figure>(&part))
            found.push_back(figure);
    return found;
}

std::string at_most(double size) {
    return fmt::format("{:.0e}", std::pow(10, std::ceil(std::log10(std::max(size, 1e-16)))));
}

} // namespace tumble::sheet
