#include "folder.h"
#include "lesson/show.h"
#include "sheet/plot.h"
#include "taught.h"

#include <filesystem>
#include <string>

namespace test_pages {

using namespace tumble;
using namespace tumble::lesson;

namespace {

const std::filesystem::path pages = std::filesystem::path(TUMBLE_ROOT) / "docs" / "lessons";
const std::string remedy = " is stale: build/dev/tumble lesson --pages docs/lessons";

} // namespace

TEST_CASE("docs/lessons says what the program teaches, and every figure shows it") {
    for (const Lesson& lesson : all_lessons()) {
        const Walk walk = testing::taught(lesson.name);
        const bool fresh =
            test::content_of(pages / (lesson.name + ".md")) == to_page(lesson, *read_values(lesson), walk);
        CHECK_MESSAGE(fresh, "docs/lessons/" << lesson.name << ".md" << remedy);
        for (const Figure* figure : walk.figures()) {
            const std::string svg = test::content_of(pages / lesson.name / (figure->name + ".svg"));
            CHECK_MESSAGE(svg.find(mark_of(*figure)) != std::string::npos,
                          lesson.name << "/" << figure->name << remedy);
        }
        for (const Film& film : walk.films)
            CHECK(std::filesystem::exists(pages / lesson.name / (film.name + ".png")));
    }
    const bool fresh = test::content_of(pages / "index.md") == contents_page();
    CHECK_MESSAGE(fresh, "docs/lessons/index.md" << remedy);
}

} // namespace test_pages
