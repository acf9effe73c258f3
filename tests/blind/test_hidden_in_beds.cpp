// Something hidden in beds of discs and of spheres, found through response tables that are kept in the repository: no
// test runs a bed.
// tests/blind/beds/README.md tells how the cases and the tables were made.
#include "base/table.h"
#include "diagnose/bed_diagnosis.h"
#include "diagnose/verdict.h"
#include "scene/read_file.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <unistd.h>

namespace {

using namespace tumble;
using namespace tumble::diagnose;

/// `confirming`: a file with more runs of the table, of sealed cases' names; empty: there are none.
Diagnosis diagnosed(const std::string& scene, const std::string& data, int seeds = 4,
                    const std::string& confirming = "") {
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
    if (!confirming.empty()) {
        const auto more = scene::read_file(root / confirming, std::uintmax_t{1} << 20);
        REQUIRE(more);
        std::ofstream(copy, std::ios::app) << *more;
    }
    auto diagnosis =
        diagnose_beds({*text, file}, *measurement, nothing, {.table = copy, .seeds = seeds, .any_date = true});
    std::filesystem::remove(copy);
    REQUIRE_MESSAGE(diagnosis, to_string(diagnosis.problems()));
    CHECK(diagnosis->runs == 0);
    return std::move(*diagnosis);
}

std::set<std::string> ids_of(const Diagnosis& diagnosis) {
    std::set<std::string> ids;
    for (const int k : diagnosis.decision.causes)
        ids.insert(diagnosis.causes[static_cast<std::size_t>(k)].id);
    return ids;
}

constexpr const char* trough = "scenes/measured/trough/trough.toml";

/// What a sealed case's last line holds, two hexadecimal digits a byte.
nlohmann::json answer_of(const std::string& folder) {
    const auto seal = scene::read_file(std::filesystem::path(TUMBLE_ROOT) / folder / "sealed.txt", 65536);
    REQUIRE(seal);
    std::string text;
    for (std::size_t k = seal->find('\n') + 1; k + 1 < seal->size(); k += 2)
        text += static_cast<char>(std::stoi(seal->substr(k, 2), nullptr, 16));
    return nlohmann::json::parse(text);
}

/// The cause's amplitude is the one hidden, within four of its errors.
void check_amplitude(const Diagnosis& diagnosis, const std::set<std::string>& found, const nlohmann::json& hidden) {
    const Refit& best = *diagnosis.decision.best;
    REQUIRE(found == ids_of(diagnosis));
    for (const auto& one : hidden)
        for (std::size_t k = 0; k < best.causes.size(); ++k)
            if (diagnosis.causes[static_cast<std::size_t>(best.causes[k])].id == one.at("id").get<std::string>()) {
                const auto i = static_cast<Eigen::Index>(k);
                CHECK(std::abs(best.amplitude[i] - one.at("amplitude").get<double>()) < 4 * best.error[i]);
            }
}

/// Nothing is said that the seal denies: no name where nothing is hidden, or what no library has; one cause by its name
/// and amplitude; of two the pair, a set that holds it, or one of them and that the other is not excluded.
void check_sealed_bed(const std::string& number, const std::string& scene, int seeds, const std::string& confirming) {
    CAPTURE(number);
    const std::string folder = "tests/blind/beds/sealed/" + number;
    const Diagnosis diagnosis = diagnosed(scene, folder + "/measurement.toml", seeds, confirming);
    CAPTURE(verdict_of(diagnosis));
    const auto answer = answer_of(folder);
    const Decision& decision = diagnosis.decision;
    std::set<std::string> hidden;
    for (const auto& one : answer.at("hidden"))
        hidden.insert(one.at("id").get<std::string>());
    if (answer.at("kind") == "null") {
        CHECK(decision.outcome == Outcome::consistent);
    } else if (answer.at("kind") == "unlisted") {
        CHECK((decision.outcome == Outcome::none_known || decision.outcome == Outcome::consistent));
    } else if (decision.outcome == Outcome::ambiguous) {
        CHECK(std::any_of(decision.pairs.begin(), decision.pairs.end(), [&](const std::vector<int>& pair) {
            return std::all_of(pair.begin(), pair.end(), [&](int k) {
                return hidden.contains(diagnosis.causes[static_cast<std::size_t>(k)].id);
            });
        }));
    } else {
        REQUIRE((decision.outcome == Outcome::named || decision.outcome == Outcome::two_causes));
        CHECK(decision.sure);
        std::set<std::string> found = ids_of(diagnosis);
        check_amplitude(diagnosis, found, answer.at("hidden"));
        if (found.size() < hidden.size()) {
            REQUIRE(decision.second_cause >= 0);
            found.insert(diagnosis.causes[static_cast<std::size_t>(decision.second_cause)].id);
        }
        CHECK(found == hidden);
    }
}

} // namespace

TEST_CASE("sealed beds come to nothing that their seals deny, and to most of what they say") {
    const std::string more = "tests/blind/beds/sealed/";
    for (const char* number : {"1", "2", "3", "6", "7"})
        check_sealed_bed(number, trough, 3, more + "trough.confirming.csv");
    for (const char* number : {"4", "5", "8", "9"})
        check_sealed_bed(number, "tests/blind/beds/heap.toml", 4, more + "heap.confirming.csv");
}

TEST_CASE("rolling resistance in a heap of discs is named, with its amplitude, and borne out by runs of other seeds") {
    const Diagnosis diagnosis = diagnosed("tests/blind/beds/heap.toml", "tests/blind/beds/rolling.toml");
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK_MESSAGE(diagnosis.decision.sure, verdict_of(diagnosis));
    CHECK(ids_of(diagnosis) == std::set<std::string>{"roll.coulomb"});
    const Refit& best = *diagnosis.decision.best;
    CHECK(std::abs(best.amplitude[0] - 0.15) < 4 * best.error[0]);
    CHECK(best.error[0] < 0.15 / 5);
    CHECK(diagnosis.confirmation->p > 0.005);
    CHECK(diagnosis.extended->pair(0, 0).rolling_friction > 0.1);
}

TEST_CASE("a phase dropped from the trough's excitation: it or rocking, and the table tells what would part them") {
    const Diagnosis diagnosis = diagnosed(trough, "scenes/measured/trough/measurement.toml", 6);
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::ambiguous, verdict_of(diagnosis));
    CHECK(ids_of(diagnosis) == std::set<std::string>{"exc.phase", "exc.rocking", "exc.rocking_ahead"});
    REQUIRE(!diagnosis.proposals.empty());
    CHECK(diagnosis.proposals[0].sentence == "measure the same again, and contacts_per_body of the bed, too");
    CHECK(diagnosis.proposals[0].repeats > 1); // the bed alone hardly tells
    CHECK(diagnosis.proposals[0].reached > 5);
}

TEST_CASE("where a second sensor saw that nothing rocks, the phase is named") {
    const Diagnosis diagnosis = diagnosed(trough, "scenes/measured/trough/measurement-2.toml", 6);
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK_MESSAGE(diagnosis.decision.sure, verdict_of(diagnosis));
    CHECK(ids_of(diagnosis) == std::set<std::string>{"exc.phase"});
    const Refit& best = *diagnosis.decision.best;
    CHECK(std::abs(best.amplitude[0] - 90) < 4 * best.error[0]);
    CHECK(diagnosis.confirmation->p > 0.005);
}

TEST_CASE("in space, too: a phase dropped from a trough of spheres is named, far from rocking and tilt") {
    const Diagnosis diagnosis = diagnosed("tests/blind/beds/trough-3d.toml", "tests/blind/beds/phase-3d.toml");
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK_MESSAGE(diagnosis.decision.sure, verdict_of(diagnosis));
    CHECK(ids_of(diagnosis) == std::set<std::string>{"exc.phase"});
    const Refit& best = *diagnosis.decision.best;
    CHECK(std::abs(best.amplitude[0] - 90) < 4 * best.error[0]);
    CHECK(best.error[0] < 90.0 / 20);
    CHECK(diagnosis.confirmation->p > 0.005);
}

TEST_CASE("a load that differs from the record is found") {
    const Diagnosis diagnosis = diagnosed(trough, "tests/blind/beds/fill.toml", 3);
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK(ids_of(diagnosis) == std::set<std::string>{"load.fill"});
    const Refit& best = *diagnosis.decision.best;
    CHECK(std::abs(best.amplitude[0] + 1.0 / 6) < 4 * best.error[0] + 0.01); // discs come in whole numbers
}

TEST_CASE("a trough in which nothing is hidden agrees with its record, though seeds, step and sizes are others") {
    const Diagnosis diagnosis = diagnosed(trough, "tests/blind/beds/nothing.toml", 3);
    CHECK_MESSAGE(diagnosis.decision.outcome == Outcome::consistent, verdict_of(diagnosis));
}

TEST_CASE("a diagnosis that may not look at the table's causes cannot name them") {
    // The power of the tests above: without runs of rolling resistance its heap is none of the known causes.
    const std::filesystem::path root(TUMBLE_ROOT);
    auto measurement = *load_measurement(root / "tests/blind/beds/rolling.toml");
    measurement.causes = {"rest.factor", "grav.tilt_x"};
    const auto text = scene::read_file(root / "tests/blind/beds/heap.toml", std::uintmax_t{1} << 20);
    const auto without = diagnose_beds({*text, root / "tests/blind/beds/heap.toml"}, measurement, {},
                                       {.table = root / "tests/blind/beds/heap.response.csv", .any_date = true});
    REQUIRE(without);
    CHECK_MESSAGE(without->decision.outcome == Outcome::none_known, verdict_of(*without));
}
