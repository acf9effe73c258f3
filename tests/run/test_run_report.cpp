#include "../folder.h"
#include "run/run_report.h"

#include <doctest/doctest.h>

namespace test_run_report {

using namespace tumble;

TEST_CASE("docs/run-folder.md explains every key of run.json") {
    const std::string page = test::content_of(std::filesystem::path(TUMBLE_ROOT) / "docs" / "run-folder.md");
    const nlohmann::ordered_json json = run::to_json(run::RunSummary{});
    for (const auto& [key, value] : json.items())
        CHECK_MESSAGE(page.find("`" + key + "`") != std::string::npos, key);
}

TEST_CASE("reasons come as one line with what to do, and numbers that are none as null") {
    run::RunSummary summary;
    summary.state = "failed";
    summary.reason = {{.what = "body 7 left the domain", .fix = "make it larger"}, {.what = "and more"}};
    summary.books.closure = std::numeric_limits<double>::quiet_NaN();
    const nlohmann::ordered_json json = run::to_json(summary);
    CHECK(json["reason"] == "body 7 left the domain (make it larger); and more");
    CHECK(json["energy_closure_J"].is_null());
    CHECK(json["steps_per_s"] == 0);
}

} // namespace test_run_report
