#include "diagnose/measure_units.h"

#include "base/text.h"
#include "observe/measures.h"
#include "observe/tracer.h"

#include <fmt/format.h>

namespace tumble::diagnose {

std::vector<Unit> units_for(const std::string& si) {
    if (si == "m")
        return {{"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}};
    if (si == "s")
        return {{"s", 1}, {"ms", 1e-3}};
    if (si == "m_s")
        return {{"m_s", 1}, {"mm_s", 1e-3}};
    if (si == "deg")
        return {{"deg", 1}, {"rad", 57.29577951308232}};
    if (si == "rad_s")
        return {{"rad_s", 1}, {"deg_s", 1 / 57.29577951308232}};
    if (si == "J")
        return {{"J", 1}, {"mJ", 1e-3}};
    return {{si, 1}};
}

Result<std::string> unit_of(const std::string& measure) {
    if (measure == "time")
        return std::string("s");
    if (const auto traced = observe::traced_by(measure))
        return traced->unit;
    std::vector<std::string> names{"time"};
    for (const observe::Measure& known : observe::all_measures()) {
        if (known.name == measure)
            return known.unit;
        names.push_back(known.name);
    }
    const std::string guess = did_you_mean(measure, names);
    if (measure.starts_with("tracer:"))
        return Problem{.what = fmt::format("there is no column '{}' of a tracer", excerpt(measure)),
                       .fix = "write tracer:, a body's name and one of the columns that docs/measures.md lists, as in "
                              "tracer:ball_felt_x; `tumble list measures SCENE` names those of a scene's"};
    return Problem{.what = fmt::format("there is no measure '{}'", excerpt(measure)),
                   .fix = (guess.empty() ? "" : guess + " ") + "`tumble list measures` names all of them"};
}

} // namespace tumble::diagnose
