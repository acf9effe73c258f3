#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "diagnose/cause.h"
#include "observe/measures.h"
#include "observe/tracer.h"
#include "run/tracers.h"
#include "scene/keys.h"
#include "scene/load.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <set>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ListArguments {
    std::string what;
    fs::path place;
    bool json = false;
};

/// What of a member stands in a table: text as it is, a dimension as "3D", nothing where a thing has none of its own.
std::string cell(const Json& member) {
    return member.is_number() ? fmt::format("{}D", member.get<int>())
           : member.is_null() ? ""
                              : member.get<std::string>();
}

/// Rows of objects: as JSON, or the named members as columns.
int show(const Json& items, const std::vector<std::string>& members, bool json) {
    if (json) {
        say_json(items);
        return fine;
    }
    std::vector<std::vector<std::string>> rows;
    for (const Json& item : items) {
        std::vector<std::string> row;
        for (const std::string& member : members)
            row.push_back(cell(item[member]));
        rows.push_back(std::move(row));
    }
    say(table(rows));
    return fine;
}

int list_scenes(const ListArguments& arguments) {
    const fs::path folder = arguments.place.empty() ? "scenes" : arguments.place;
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == ".toml")
            files.push_back(entry->path());
    if (error)
        return refuse({{.file = folder.string(),
                        .what = "cannot be read: " + error.message(),
                        .fix = "give the folder with scene files: tumble list scenes DIR"}},
                      arguments.json, wrong);
    std::sort(files.begin(), files.end());
    Json items = Json::array();
    for (const fs::path& file : files) {
        const Result<scene::Scene> scene = scene::load_scene(file);
        items.push_back({{"file", file.string()},
                         {"dimension", scene ? Json(scene->dimension) : Json()},
                         {"title", scene ? scene->title : "(cannot be read; tumble check says why)"},
                         {"claim", scene ? scene->claim : ""}});
    }
    return show(items, {"file", "dimension", "title"}, arguments.json);
}

/// What a word of a key in [contact] selects; the words themselves come from the key list.
std::string law_sentence(const std::string& key, const std::string& word) {
    static const std::map<std::string, std::string> sentences{
        {"normal hertz", "Hertz contact with damping by restitution (Tsuji et al. 1992)"},
        {"normal linear", "spring and dashpot of constant stiffness"},
        {"tangential mindlin", "Mindlin spring with history, capped by Coulomb friction"},
        {"tangential linear", "spring of constant stiffness with history, capped by Coulomb friction"},
        {"tangential none", "no tangential force"},
        {"rolling cdt", "constant torque against the rolling (Zhou et al. 1999)"},
        {"rolling epsd", "rolling spring and dashpot, capped (Ai et al. 2011, type C)"},
        {"rolling none", "no rolling resistance"},
        {"adhesion sjkr", "pull in proportion to the area of contact, simplified JKR"},
        {"adhesion jkr", "JKR in place of Hertz, with necks that hold beyond contact (Johnson et al. 1971)"},
        {"adhesion dmt", "constant pull while in contact (Derjaguin et al. 1975)"},
        {"adhesion none", "no adhesion"}};
    const auto found = sentences.find(key + " " + word);
    return found == sentences.end() ? "" : found->second;
}

/// 2 or 3 where only such scenes take it, null where both do.
Json dimension_of(scene::Dimensions in) {
    return in == scene::Dimensions::both ? Json() : Json(in == scene::Dimensions::two ? 2 : 3);
}

/// The same of a word of a key.
Json dimension_of(const scene::KeyTable& table, const std::string& name, const std::string& word) {
    const auto taken = [&](int dimension) {
        const scene::Key* key = scene::find_key(table, name, dimension);
        return key && std::find(key->words.begin(), key->words.end(), word) != key->words.end();
    };
    return taken(2) && taken(3) ? Json() : Json(taken(2) ? 2 : 3);
}

int list_laws(const ListArguments& arguments) {
    Json items = Json::array();
    std::set<std::string> listed;
    if (const scene::KeyTable* contact = scene::find_table("contact"))
        for (const scene::Key& key : contact->keys)
            for (const std::string& word : key.words)
                if (listed.insert(key.name + " " + word).second)
                    items.push_back({{"key", "contact." + key.name},
                                     {"law", word},
                                     {"dimension", dimension_of(*contact, key.name, word)},
                                     {"sentence", law_sentence(key.name, word)}});
    return show(items, {"key", "law", "dimension", "sentence"}, arguments.json);
}

void add_column(Json& items, const std::string& name, const std::string& unit, const std::string& column,
                const std::string& sentence) {
    items.push_back({{"name", name}, {"group", ""}, {"unit", unit}, {"column", column}, {"sentence", sentence}});
}

int list_measures(const ListArguments& arguments) {
    Json items = Json::array();
    for (const observe::Measure& measure : observe::all_measures())
        items.push_back({{"name", measure.name},
                         {"group", measure.group},
                         {"unit", measure.unit},
                         {"column", measure.column()},
                         {"sentence", measure.sentence}});
    const fs::path& place = arguments.place;
    if (place.empty()) {
        add_column(items, "tracer:BODY", "", "",
                   "27 columns that follow a body; `tumble list measures SCENE` names those of a scene's");
    } else {
        std::error_code ignored;
        const auto scene = scene::load_scene(fs::is_directory(place, ignored) ? place / "scene.toml" : place);
        if (!scene)
            return refuse(scene.problems(), arguments.json, wrong);
        const std::vector<std::string> traced = run::traced_bodies(scene->observe.measures);
        for (const std::string& body : traced)
            for (const observe::TracerColumn& column : observe::tracer_columns(body))
                add_column(items, column.name, column.unit, column.column(), column.sentence);
        for (const scene::BodyTemplate& body : scene->bodies)
            if (std::find(traced.begin(), traced.end(), body.name) == traced.end())
                add_column(items, "tracer:" + body.name, "", "",
                           fmt::format("27 columns that follow the first {0}, such as tracer:{0}_x and tracer:{0}_vx: "
                                       "docs/measures.md, \"Tracers\"",
                                       body.name));
    }
    return show(items, {"name", "unit", "group", "sentence"}, arguments.json);
}

int list_keys(const ListArguments& arguments) {
    Json items = Json::array();
    for (const scene::KeyTable& keys : scene::scene_keys())
        for (const scene::Key& key : keys.keys)
            items.push_back({{"table", keys.head},
                             {"key", key.name},
                             {"dimension", dimension_of(key.in)},
                             {"type", scene::describe(key)},
                             {"unit", key.unit},
                             {"default", key.required ? "required" : scene::describe(key.standard)},
                             {"sentence", key.sentence}});
    return show(items, {"table", "key", "dimension", "default", "sentence"}, arguments.json);
}

int list_causes(const ListArguments& arguments) {
    Json items = Json::array();
    for (const diagnose::Cause& cause : diagnose::all_causes())
        items.push_back({{"id", cause.id},
                         {"family", cause.family},
                         {"parameter", cause.symbol},
                         {"unit", cause.unit},
                         {"range", fmt::format("{:g} to {:g}", cause.lo, cause.hi)},
                         {"sets", cause.keys},
                         {"name", cause.name},
                         {"fingerprint", cause.look}});
    return show(items, {"id", "family", "name", "fingerprint"}, arguments.json);
}

} // namespace

void add_list_command(CLI::App& program, Action& action) {
    CLI::App* command =
        program.add_subcommand("list", "Example: tumble list measures\n\n"
                                       "Lists what can be named: scenes, laws, measures, causes, keys.");
    const auto arguments = std::make_shared<ListArguments>();
    command->add_option("WHAT", arguments->what, "scenes, laws, measures, causes or keys")
        ->required()
        ->check(one_of({"scenes", "laws", "measures", "causes", "keys"}));
    command->add_option("PLACE", arguments->place,
                        "scenes: their folder, scenes/ without it. measures: a scene or the folder of a run, whose "
                        "tracers are listed too");
    command->add_flag("--json", arguments->json, "Print the list as JSON");
    command->callback([arguments, &action] {
        action = [arguments] {
            const std::string& what = arguments->what;
            return what == "scenes"     ? list_scenes(*arguments)
                   : what == "laws"     ? list_laws(*arguments)
                   : what == "measures" ? list_measures(*arguments)
                   : what == "causes"   ? list_causes(*arguments)
                                        : list_keys(*arguments);
        };
    });
}

} // namespace tumble::cli
