#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "diagnose/cause.h"
#include "scene/read_file.h"

#include <filesystem>
#include <fmt/format.h>
#include <memory>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::size_t largest_seal = 65536; // bytes

/// The last line of a seal, two hexadecimal digits a byte: kept from eyes that only pass by.
std::string opened(const std::string& seal) {
    const std::size_t end = seal.find_last_not_of("\r\n") + 1;
    const std::size_t begin = seal.rfind('\n', end - 1) + 1;
    std::string text;
    for (std::size_t k = begin; k + 1 < end; k += 2)
        text += static_cast<char>(std::strtol(seal.substr(k, 2).c_str(), nullptr, 16));
    return text;
}

/// "ins.gain, 0.0025: a scale that reads too much or too little"; effects that the library must not have keep their
/// name only.
std::string sentence_of(const ordered_json& hidden) {
    const std::string id = hidden.at("id");
    for (const diagnose::Cause& cause : diagnose::all_causes())
        if (cause.id == id)
            return fmt::format("{}, {} = {:.4g}{}: {}", id, cause.symbol, hidden.at("amplitude").get<double>(),
                               cause.unit.empty() ? "" : " " + cause.unit, cause.name);
    return fmt::format("{}, {:.4g}: no cause of the library", id, hidden.at("amplitude").get<double>());
}

int reveal(const fs::path& folder, bool json) {
    const fs::path file = folder / "sealed.txt";
    const auto seal = scene::read_file(file, largest_seal);
    if (!seal)
        return refuse(seal.problems(), json, wrong);
    const ordered_json answer = ordered_json::parse(opened(*seal), nullptr, false);
    if (!answer.is_object() || !answer.contains("hidden"))
        return refuse({{.file = file.string(),
                        .what = "holds no sealed answer",
                        .fix = "give the folder of a case, such as scenes/measured/cases/1"}},
                      json, wrong);
    if (json) {
        say_json(answer);
        return fine;
    }
    if (answer["hidden"].empty())
        say("Nothing was hidden.");
    for (const ordered_json& hidden : answer["hidden"])
        say("Hidden: " + sentence_of(hidden));
    if (const double d = answer.value("d_sep", 0.0); d > 0)
        say(fmt::format("It lies {:.1f} standard errors from the best other explanation{}.", d,
                        answer.value("nearest", "").empty() ? "" : ", " + answer.value("nearest", "")));
    return fine;
}

} // namespace

void add_reveal_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand("reveal", "Example: tumble reveal scenes/measured/cases/1\n\n"
                                                         "Tells what was hidden in a sealed case: diagnose it first.");
    const auto folder = std::make_shared<fs::path>();
    const auto json = std::make_shared<bool>(false);
    command->add_option("CASE", *folder, "Folder of the case")->required();
    command->add_flag("--json", *json, "Print the answer as JSON");
    command->callback([folder, json, &action] { action = [folder, json] { return reveal(*folder, *json); }; });
}

} // namespace tumble::cli
