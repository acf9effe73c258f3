#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/scene_arguments.h"
#include "run/wall_files.h"

#include <fmt/format.h>
#include <memory>

namespace tumble::cli {

namespace {

struct WallsArguments {
    SceneArguments scene;
    std::vector<std::string> names;
    std::filesystem::path out = "walls";
    double time = 0;
    bool force = false;
    bool quiet = false;
    bool json = false;
};

int write_walls(const WallsArguments& arguments) {
    const Result<scene::Scene> scene = arguments.scene.load();
    if (!scene)
        return refuse(scene.problems(), arguments.json, wrong);
    const auto files = run::write_wall_files(*scene, arguments.names, arguments.time, arguments.out, arguments.force);
    if (!files)
        return refuse(files.problems(), arguments.json, wrong);
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    for (const run::WallFile& wall : *files) {
        items.push_back({{"file", wall.file.string()}, {"triangles", wall.triangles}});
        if (!arguments.json && !arguments.quiet)
            say(fmt::format("{}: {} triangles", wall.file.string(), wall.triangles));
    }
    if (arguments.json)
        say_json(items);
    return fine;
}

} // namespace

void add_walls_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("walls", "Example: tumble walls scenes/bowl.toml --out bowl-stl\n\n"
                                                        "Writes the walls of a scene as STL files, in metres, for CAD "
                                                        "and other programs.");
    const auto arguments = std::make_shared<WallsArguments>();
    arguments->scene.add_to(*command);
    command->add_option("--wall", arguments->names, "Only the wall of that name; may be repeated")
        ->type_name("NAME")
        ->expected(1)
        ->take_all();
    command->add_option("--at", arguments->time, "Where they stand at this time of the scene, s")->type_name("T");
    command->add_option("--out", arguments->out, "Folder for the files; walls/ without it")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_flag("--force", arguments->force, "Replace what is there");
    command->add_flag("--quiet", arguments->quiet, "Print nothing");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return write_walls(*arguments); }; });
}

} // namespace tumble::cli
