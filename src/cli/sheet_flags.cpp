#include "cli/sheet_flags.h"

#include "cli/console.h"
#include "cli/exit_code.h"
#include "sheet/plot.h"

#include <fmt/format.h>

namespace tumble::cli {

std::string example_of(const std::vector<sheet::Parameter>& parameters) {
    if (parameters.empty())
        return "";
    return fmt::format(" --{} {}", parameters.front().name, scene::plain(parameters.front().standard));
}

void add_parameters(CLI::App& command, const std::vector<sheet::Parameter>& parameters, sheet::Typed& typed) {
    for (const sheet::Parameter& parameter : parameters)
        command
            .add_option_function<std::string>(
                "--" + parameter.name,
                [&typed, name = parameter.name](const std::string& text) { typed.emplace_back(name, text); },
                fmt::format("{} ({}; {} without it)", parameter.sentence, describe(parameter),
                            scene::plain(parameter.standard)))
            ->type_name("X");
}

int draw_and_note(const sheet::Sheet& sheet, const std::filesystem::path& folder, bool json,
                  const sheet::Canvas& canvas) {
    const auto files = sheet::draw_all(sheet, folder, {".png", ".svg"}, canvas);
    if (!files)
        return refuse(files.problems(), json, failed);
    for (const std::filesystem::path& file : *files)
        note("figure: " + file.string());
    return fine;
}

} // namespace tumble::cli
