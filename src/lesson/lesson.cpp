#include "lesson/lesson.h"

#include "base/text.h"
#include "lesson/each.h"

#include <fmt/format.h>

namespace tumble::lesson {

const std::vector<Lesson>& all_lessons() {
    static const std::vector<Lesson> lessons{two_discs(), force_law(),    time_step(),          restitution(),
                                             energy(),    friction(),     rolling_resistance(), clumps(),
                                             repose(),    soft_and_hard()};
    return lessons;
}

Result<const Lesson*> find_lesson(std::string_view name) {
    std::vector<std::string> names;
    for (const Lesson& lesson : all_lessons()) {
        if (lesson.name == name)
            return &lesson;
        names.push_back(lesson.name);
    }
    const std::string guess = did_you_mean(name, names);
    return Problem{.what = fmt::format("there is no lesson '{}'", excerpt(name)),
                   .fix = (guess.empty() ? "" : guess + " ") + "`tumble lesson` lists all there are"};
}

Result<Values> read_values(const Lesson& lesson, const sheet::Typed& typed) {
    return sheet::read_values("lesson " + lesson.name, lesson.parameters, typed);
}

} // namespace tumble::lesson
