#include "cli/program.h"

#include "base/text.h"
#include "base/thrown.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/usage_problem.h"
#include "run/run_report.h"

#include <exception>
#include <fmt/format.h>

namespace tumble::cli {

namespace {

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
    std::vector<std::string> names;
    for (const CLI::App* command : commands)
        names.push_back(command->get_name());
    return names;
}

std::vector<std::string> flags_of(const CLI::App& command) {
    std::vector<std::string> flags;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            flags.push_back("--" + name);
    return flags;
}

int refuse_word(const std::string& what, const std::string& guess, const std::string& help) {
    const std::string fix = (guess.empty() ? "" : guess + " ") + "`" + help + "` names all there are";
    return refuse({{.what = what, .fix = fix}}, false, wrong);
}

/// The first word must be a command, or a flag of the program itself.
std::optional<int> check_command(const CLI::App& program, int count, char** words) {
    if (count < 2) {
        note(program.help());
        return wrong;
    }
    const std::string word = words[1];
    const std::vector<std::string> commands = names_of(program.get_subcommands({}));
    const std::vector<std::string> known = word.starts_with("-") ? flags_of(program) : commands;
    if (std::find(known.begin(), known.end(), word) != known.end() || word == "-h")
        return std::nullopt;
    const char* kind = word.starts_with("-") ? "flag" : "command";
    return refuse_word(fmt::format("there is no {} '{}'", kind, word), did_you_mean(word, known), "tumble --help");
}

/// The innermost command chosen, and the words that lead to it: "tumble lesson two-discs".
struct Chosen {
    const CLI::App* command = nullptr;
    std::string words;

    explicit Chosen(const CLI::App& program) : command(&program), words("tumble") {
        while (!command->get_subcommands().empty()) {
            command = command->get_subcommands().front();
            words += " " + command->get_name();
        }
    }
    [[nodiscard]] std::string help() const { return words + " --help"; }
};

int refuse_extras(const CLI::App& program) {
    const Chosen chosen(program);
    for (const std::string& word : program.remaining(true)) {
        if (!word.starts_with("-"))
            continue;
        const std::string flag = word.substr(0, word.find('='));
        const std::vector<std::string> own = flags_of(*chosen.command);
        if (std::find(own.begin(), own.end(), flag) != own.end()) // `tumble lesson --answer friction`
            return refuse({{.what = fmt::format("{} stands before the name that it belongs to", flag),
                            .fix = fmt::format("write it behind: {} {}", chosen.words, word)}},
                          false, wrong);
        return refuse_word(fmt::format("`{}` has no flag '{}'", chosen.words, flag), did_you_mean(flag, own),
                           chosen.help());
    }
    const std::vector<std::string> rest = program.remaining(true);
    return refuse_word(fmt::format("'{}' is one word too many", rest.empty() ? "" : rest.front()), "", chosen.help());
}

int refuse_parse(const CLI::App& program, const CLI::ParseError& error) {
    const Chosen chosen(program);
    return refuse({usage_problem(error, *chosen.command, chosen.words)}, false, wrong);
}

int act(const Action& action) {
    try {
        return action();
    } catch (const std::exception& error) {
        return refuse({problem_of(error)}, false, failed);
    }
}

} // namespace

int run_program(int count, char** words) {
    CLI::App program{"Example: tumble run scenes/drop.toml --frames\n\n"
                     "Simulates granular media: scene files in, pictures and numbers out.",
                     "tumble"};
    program.set_version_flag("--version", "tumble " + run::version(), "Print the version and leave");
    program.require_subcommand(1);
    Action action;
    for (const auto add :
         {add_run_command, add_render_command, add_check_command, add_list_command, add_lesson_command,
          add_excitation_command, add_lab_command, add_export_command, add_walls_command, add_fit_command,
          add_flow_command, add_diagnose_command, add_reveal_command, add_reduce_command, add_stress_command,
          add_view_command, add_plot_command, add_gallery_command})
        add(program, action);
    if (const auto code = check_command(program, count, words))
        return *code;
    try {
        program.parse(count, words);
    } catch (const CLI::Success& asked) { // --help, --version
        program.exit(asked);
        return fine;
    } catch (const CLI::ExtrasError&) {
        return refuse_extras(program);
    } catch (const CLI::ParseError& error) {
        return refuse_parse(program, error);
    }
    return action ? act(action) : static_cast<int>(wrong);
}

} // namespace tumble::cli
