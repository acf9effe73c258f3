#include "lesson/show.h"
#include "taught.h"

#include <cmath>
#include <set>

namespace test_lesson {

using namespace tumble;
using namespace tumble::lesson;

TEST_CASE("every lesson has a name, a title, a question and an answer, and its defaults lie in their ranges") {
    std::set<std::string> names;
    for (const Lesson& lesson : all_lessons()) {
        CAPTURE(lesson.name);
        CHECK(names.insert(lesson.name).second);
        CHECK_FALSE(lesson.title.empty());
        for (const Parameter& parameter : lesson.parameters) {
            CAPTURE(parameter.name);
            CHECK(parameter.limits.hold(parameter.standard));
            CHECK(std::isfinite(parameter.limits.lo + parameter.limits.hi));
            CHECK_FALSE(parameter.sentence.empty());
        }
        const Walk walk = testing::taught(lesson.name);
        CHECK_FALSE(walk.question.empty());
        CHECK_FALSE(walk.answer.empty());
        CHECK_FALSE(walk.figures().empty());
    }
}

TEST_CASE("figures have units or names on their axes, and curves of as many x as y, all finite") {
    for (const Lesson& lesson : all_lessons())
        for (const Walk walk = testing::taught(lesson.name); const Figure* figure : walk.figures()) {
            CAPTURE(lesson.name + " " + figure->name);
            CHECK_FALSE(figure->x.label.empty());
            CHECK_FALSE(figure->y.label.empty());
            for (const Curve& curve : figure->curves) {
                CHECK(curve.x.size() == curve.y.size());
                CHECK_FALSE(curve.x.empty());
                for (std::size_t k = 0; k < curve.x.size(); ++k)
                    CHECK(std::isfinite(curve.x[k] + curve.y[k]));
            }
        }
}

TEST_CASE("the text fits into 100 columns and does not tell the answer") {
    for (const Lesson& lesson : all_lessons()) {
        const auto values = read_values(lesson);
        const Walk walk = testing::taught(lesson.name);
        const std::string text = to_text(lesson, *values, walk);
        std::size_t from = 0;
        while (from < text.size()) {
            const std::size_t to = text.find('\n', from);
            const std::string line = text.substr(from, to - from);
            CHECK_MESSAGE(sheet::letters(line) <= 100, lesson.name << ": " << line);
            from = to + 1;
        }
        CHECK(text.find(walk.answer.substr(0, 30)) == std::string::npos);
    }
}

TEST_CASE("a name that is no lesson gets the nearest one") {
    const auto lesson = find_lesson("two-disks");
    REQUIRE_FALSE(lesson.ok());
    CHECK(lesson.problems()[0].what == "there is no lesson 'two-disks'");
    CHECK(lesson.problems()[0].fix.starts_with("did you mean 'two-discs'?"));
}

TEST_CASE("values are taken in their range, and every wrong one is told with what it may be") {
    const Lesson& lesson = **find_lesson("friction");
    CHECK((*read_values(lesson, {{"friction", "0.25"}}))["friction"] == 0.25);
    const auto values = read_values(lesson, {{"friction", "-1"}, {"speed_m_s", "fast"}, {"fricton", "0.3"}});
    REQUIRE_FALSE(values.ok());
    REQUIRE(values.problems().size() == 3);
    CHECK(values.problems()[0].what == "--friction is -1, out of its range");
    CHECK(values.problems()[0].fix == "0.05 to 1");
    CHECK(values.problems()[1].what == "--speed_m_s takes a number, not 'fast'");
    CHECK(values.problems()[2].fix == "did you mean 'friction'?");
}

} // namespace test_lesson
