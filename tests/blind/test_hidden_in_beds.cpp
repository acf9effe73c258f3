// Something hidden in beds of discs, found through response tables that are kept in the repository: no test runs a bed.
// tests/blind/beds/README.md tells how the cases and the tables were made.
#include "base/table.h"
#include "diagnose/bed_diagnosis.h"
#include "diagnose/verdict.h"
#include "scene/read_file.h"

#include <doctest/doctest.h>

namespace {

using namespace tumble;
using namespace tumble::diagnose;

Diagnosis diagnosed(const std::string& scene, const std::string& data) {
    const std::filesystem::path root(TUMBLE_ROOT), file = root / scene;
    const auto text = scene::read_file(file, std::uintmax_t{1} << 20);
    REQUIRE(text);
    const auto measurement = load_measurement(root / data);
    REQUIRE_MESSAGE(measurement, to_string(measurement.problems()));
    const Simulate nothing = [](const scene::Scene& missing) -> Result<observe::Series> {
        return Problem{.what = "the stored table lacks a run of seed " + std::to_string(missing.seed)};
    };
    // A copy: a run that is missing would be noted down as one that breaks down.
    const std::filesystem::path copy =
        std::filesystem::temp_directory_path() / ("tumble-" + std::to_string(::getpid()) + ".response.csv");
    std::filesystem::path table = file;
    std::filesystem::copy_file(table.replace_extension(".response.csv"), copy,
                               std::filesystem::copy_options::overwrite_existing);
    auto diagnosis = diagnose_beds({*text, file}, *measurement, nothing, {.table = copy, .any_date = true});
    std::filesystem::remove(copy);
    REQUIRE_MESSAGE(diagnosis, to_string(diagnosis.problems()));
    CHECK(diagnosis->runs == 0);
    return std::move(*diagnosis);
}

std::string named(const Diagnosis& diagnosis) {
    return diagnosis.decision.causes.empty()
               ? ""
               : diagnosis.causes[static_cast<std::size_t>(diagnosis.decision.causes[0])].id;
}

constexpr const char* trough = "scenes/measured/trough/trough.toml";

} // namespace
