// The numbers of the thesis that stand in the code, held against the files of ../shared/thesis beside the repository,
// which were copied out of it by others. Where that folder is missing nothing is compared.
#include "about.h"
#include "base/table.h"
#include "performed.h"
#include "scene/load.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace test_thesis_numbers {

using namespace tumble;
using namespace tumble::lab;
using namespace tumble::lab::testing;
using tumble::test::about;

namespace {

const std::filesystem::path folder = std::filesystem::path(TUMBLE_ROOT) / "../shared/thesis";

bool there() {
    if (std::filesystem::exists(folder))
        return true;
    MESSAGE("no folder shared/thesis beside the repository: nothing compared");
    return false;
}

std::string text_of(const char* name) {
    const auto text = scene::read_file(folder / name, std::uintmax_t{1} << 20);
    REQUIRE_MESSAGE(text, to_string(text.problems()));
    return *text;
}

Table table_of(const char* name) {
    auto table = parse_table(text_of(name), name);
    REQUIRE_MESSAGE(table, to_string(table.problems()));
    return *table;
}

double number(const scene::Node& node) {
    if (const auto* whole = node.as<std::int64_t>())
        return static_cast<double>(*whole);
    REQUIRE(node.as<double>());
    return *node.as<double>();
}

/// The numbers at "media.trough.mean_mass" of a TOML file: one, or those of a list.
std::vector<double> numbers_at(const char* file, const std::string& path) {
    CAPTURE(path);
    const auto root = scene::parse_toml(text_of(file), file);
    REQUIRE_MESSAGE(root, to_string(root.problems()));
    const scene::Node* node = &*root;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        const auto* table = node->as<scene::Table>();
        REQUIRE(table);
        const scene::Entry* entry = table->find(path.substr(begin, end - begin));
        REQUIRE(entry);
        node = &entry->node;
        begin = end + 1;
    }
    std::vector<double> all;
    if (const auto* list = node->as<scene::Array>())
        for (const scene::Node& item : list->items)
            all.push_back(number(item));
    else
        all.push_back(number(*node));
    return all;
}

double media(const std::string& path) {
    return numbers_at("materials.toml", path).front();
}

double standard(const char* experiment, const std::string& name) {
    for (const Parameter& parameter : (*find_experiment(experiment))->parameters)
        if (parameter.name == name)
            return parameter.standard;
    FAIL(name);
    return 0;
}

const Recording& recording(const Outcome& outcome, const std::string& name) {
    const auto found = std::find_if(outcome.recordings.begin(), outcome.recordings.end(),
                                    [&](const Recording& one) { return one.name == name; });
    REQUIRE(found != outcome.recordings.end());
    return *found;
}

/// Volume of a union of spheres, m3, by slices across y of squares `side` wide: nothing of the solver's.
double union_of(const Table& spheres, double side) {
    const auto x = *spheres.numbers("x"), y = *spheres.numbers("y"), z = *spheres.numbers("z"),
               radius = *spheres.numbers("radius");
    const double reach = 0.0125;
    std::size_t inside = 0;
    for (double v = 0.5 * side; v < 2 * reach; v += side)
        for (double u = 0.5 * side - reach; u < reach; u += side)
            for (double w = 0.5 * side - reach; w < reach; w += side)
                for (std::size_t k = 0; k < x.size(); ++k)
                    if (std::pow(u - x[k], 2) + std::pow(v - y[k], 2) + std::pow(w - z[k], 2) < radius[k] * radius[k]) {
                        ++inside;
                        break;
                    }
    return static_cast<double>(inside) * side * side * side;
}

} // namespace

TEST_CASE("the rebound heights in the code are those of table 4.2, and their printed averages those of table 4.4") {
    if (!there())
        return;
    const Outcome outcome = performed("thesis");
    const Table print = table_of("rebound-heights.csv");
    const Recording& ours = recording(outcome, "restitution");
    const char* names[] = {"media", "steel", "am_titanium"};
    const char* means[] = {"media_media_measured", "media_steel_measured", "media_titanium_measured"};
    for (std::size_t s = 0; s < 3; ++s) {
        std::vector<double> heights; // mm
        for (const auto& row : ours.rows)
            if (row[0] == static_cast<double>(s))
                heights.push_back(1e3 * row[1]);
        const std::vector<double> printed = *print.numbers(names[s]);
        REQUIRE(heights.size() == printed.size());
        for (std::size_t k = 0; k < printed.size(); ++k)
            CHECK(heights[k] == about(printed[k], 1e-9));
        CHECK(outcome.sheet.fact("printed_mean_" + std::to_string(s)) == media(std::string("restitution.") + means[s]));
    }
}

TEST_CASE("frictions and their deviations are those of table 4.1, in its order") {
    if (!there())
        return;
    const Outcome outcome = performed("thesis");
    const Recording& ours = recording(outcome, "friction");
    const char* pairs[] = {"media_media", "media_sensor", "media_wall", "sensor_wall"};
    REQUIRE(ours.rows.size() == std::size(pairs));
    for (std::size_t k = 0; k < std::size(pairs); ++k) {
        const auto print = numbers_at("materials.toml", std::string("friction.") + pairs[k]);
        CHECK(ours.rows[k][0] == print[0]);
        CHECK(ours.rows[k][1] == print[1]);
        CHECK(std::tan(ours.rows[k][2] / 57.29577951308232) == about(print[0], 1e-9));
    }
}

TEST_CASE("what the laboratory takes for the media is what the thesis prints of it") {
    if (!there())
        return;
    CHECK(standard("weigh", "mass_g") == about(1e3 * media("media.trough.mean_mass"), 1e-12));
    CHECK(standard("weigh", "height_mm") == about(1e3 * media("media.trough.mean_height"), 1e-12));
    CHECK(standard("weigh", "base_mm") == about(1e3 * media("media.trough.mean_base_diameter"), 1e-12));
    CHECK(standard("weigh", "density_kg_m3") == media("media.density"));
    CHECK(standard("drop", "restitution") == media("restitution.media_media"));
    CHECK(standard("drop", "youngs_modulus_Pa") == media("media.youngs_modulus_simulated"));
    CHECK(standard("slide", "poisson_ratio") == media("media.poisson_ratio"));
    CHECK(standard("roll-out", "friction") == media("friction.media_media"));
}

TEST_CASE("densities follow from printed masses and sizes, the simulated cone's from its printed spheres") {
    if (!there())
        return;
    const Outcome outcome = performed("thesis");
    const double mass = media("media.trough.mean_mass"), base = media("media.trough.mean_base_diameter"),
                 height = media("media.trough.mean_height");
    CHECK(outcome.sheet.fact("density_printed") == media("media.density"));
    CHECK(outcome.sheet.fact("density_cone") == about(12 * mass / (3.14159265358979 * base * base * height), 1e-9));
    // 0.2 mm squares: 350,000 in the union, a tenth of them at its surface, which scatter by 0.2 %.
    const double volume = union_of(table_of("cone-65-spheres.csv"), 2e-4);
    CHECK(outcome.sheet.fact("density_model") == about(mass / volume, 4e-3));
    // What its simulation says it filled in, counted by chance.
    const double counted =
        numbers_at("trough.toml", "slice.media_mass")[0] / numbers_at("trough.toml", "slice.media_count")[0];
    CHECK(outcome.sheet.fact("volume_counted") == about(1e9 * counted / media("media.density"), 1e-9));
    CHECK(std::abs(outcome.sheet.fact("volume_counted_errors")) < 3);
}

TEST_CASE("a ball's drag coefficient is the same in the laboratory and in scenes") {
    const auto scene =
        scene::load_scene(TUMBLE_ROOT "/scenes/drop.toml", std::vector<scene::Override>{{"air.density_kg_m3=1.2"}});
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    for (const char* experiment : {"drop", "roll-out"})
        CHECK(standard(experiment, "drag_coefficient") == scene->air.drag_coefficient);
}

} // namespace test_thesis_numbers
