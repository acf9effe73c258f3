#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/progress_line.h"
#include "cli/scene_arguments.h"
#include "cli/sheet_flags.h"
#include "cli/stop_flag.h"
#include "cli/time_range.h"
#include "reduce/account.h"
#include "reduce/given_run.h"
#include "sheet/show.h"

#include <fmt/format.h>
#include <memory>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;

struct ReduceArguments {
    SceneArguments scene;
    reduce::ClimbOptions options;
    std::string within = "10%";
    std::vector<std::string> wishes;
    std::vector<std::string> measures;
    std::string time;
    bool unsure = false;
    bool quiet = false;
    bool json = false;
};

/// Names the rung before the line of each of its runs.
class ClimbLine final : public reduce::ClimbListener {
public:
    explicit ClimbLine(bool quiet) : line_(quiet), quiet_(quiet) {}

    void begins(const std::string& rung, std::uint64_t seed, int run, int of, bool kept) override {
        line_.end();
        if (!quiet_)
            note(fmt::format("run {} of {}: {}, seed {}{}", run, of, rung, seed, kept ? ", done before" : ""));
    }
    void prepares(std::string_view what, std::int64_t done, std::int64_t all) override {
        line_.prepares(what, done, all);
    }
    void progressed(const run::Progress& now) override { line_.progressed(now); }
    void end() { line_.end(); }

private:
    ProgressLine line_;
    bool quiet_;
};

/// "10%", "10 %" or "0.1".
Result<double> read_share(const std::string& text) {
    const bool percent = text.ends_with('%');
    const Result<double> number =
        parse_number(trimmed(std::string_view(text).substr(0, text.size() - (percent ? 1 : 0))));
    const double share = number ? *number / (percent ? 100 : 1) : 0;
    if (share > 0 && share < 1)
        return share;
    return Problem{.what = fmt::format("--within: '{}' is no share", excerpt(text)),
                   .fix = "give what an error may be at most, above 0 and below 100 %: --within 10%"};
}

Result<std::vector<reduce::Wish>> read_wishes(const std::vector<std::string>& texts, const scene::Scene& scene) {
    std::vector<reduce::Wish> wishes;
    Problems problems;
    for (const std::string& text : texts) {
        const auto wish = reduce::read_wish(text);
        for (const Problem& problem : wish.problems())
            problems.push_back(problem);
        if (wish)
            wishes.push_back(*wish);
    }
    if (!problems.empty())
        return problems;
    return texts.empty() ? reduce::wishes_for(scene) : wishes;
}

/// What was asked for, understood.
struct Asked {
    double within = 0;
    std::vector<reduce::Rung> ladder;
    reduce::Yardstick stick;
};

Result<Asked> understand(const ReduceArguments& arguments) {
    reduce::SceneText text{arguments.scene.file, {}};
    for (const std::string& set : arguments.scene.sets)
        text.sets.push_back({set});
    const auto scene = text.load();
    if (!scene)
        return scene.problems();
    const auto within = read_share(arguments.within);
    const auto wishes = read_wishes(arguments.wishes, *scene);
    double from = -std::numeric_limits<double>::infinity(), until = -from;
    Problems problems;
    if (const auto problem = read_time_range(arguments.time, from, until))
        return *problem;
    const auto given = [](double time) { return std::isfinite(time) ? std::optional(time) : std::nullopt; };
    auto stick = reduce::Yardstick::of(*scene, arguments.measures, given(from), given(until));
    for (const Problems& more : {within.problems(), wishes.problems(), stick.problems()})
        problems.insert(problems.end(), more.begin(), more.end());
    if (!problems.empty())
        return problems;
    auto ladder = reduce::ladder(text, *wishes);
    if (!ladder)
        return ladder.problems();
    if (const auto problem = reduce::unfit_reference(arguments.options.references, ladder->front().scene, *stick))
        return *problem;
    return Asked{*within, std::move(*ladder), std::move(*stick)};
}

int tell(const reduce::Account& account, const ReduceArguments& arguments) {
    const fs::path& folder = arguments.options.folder;
    const auto files = reduce::write_account(account, folder, arguments.unsure);
    if (!files)
        return refuse(files.problems(), arguments.json, failed);
    const sheet::Sheet sheet = reduce::sheet_of(account, arguments.unsure);
    if (arguments.json)
        say_json(reduce::to_json(account));
    else
        say(sheet::to_text(account.scene.stem().string() + ", reduced", sheet));
    if (const int code = draw_and_note(sheet, folder, false); code != fine)
        return code;
    for (const fs::path& file : *files)
        note("file: " + file.string());
    if (account.climb.stopped)
        return stop_code();
    return account.sure() || (arguments.unsure && account.cheapest()) ? fine : failed;
}

int reduce_it(ReduceArguments& arguments) {
    Result<Asked> asked = understand(arguments);
    if (!asked)
        return refuse(asked.problems(), arguments.json, wrong);
    if (arguments.options.folder.empty())
        arguments.options.folder = fs::path("out") / (arguments.scene.file.stem().string() + "-reduce");
    arguments.options.stop = &watch_for_stop();
    ClimbLine line(arguments.quiet);
    auto climb = reduce::climb(std::move(asked->ladder), asked->stick, arguments.options, line);
    line.end();
    if (!climb)
        return refuse(climb.problems(), arguments.json, failed);
    return tell(reduce::account_of(arguments.scene.file, std::move(*climb), asked->within, arguments.options.seeds),
                arguments);
}

} // namespace

void add_reduce_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "reduce",
        "Example: tumble reduce scenes/trough-2d.toml --within 10% --try softening=4,16\n\n"
        "Runs a scene and cheaper versions of it (softer contacts, fewer spheres a body, a shorter slice, larger and\n"
        "fewer bodies), says how far each is off and how much faster it is, and writes the cheapest that stays "
        "within.\n"
        "What was run is kept: the same command goes on where it was stopped. docs/reduced-order.md.");
    const auto arguments = std::make_shared<ReduceArguments>();
    reduce::ClimbOptions& options = arguments->options;
    arguments->scene.add_to(*command);
    command->add_option("--within", arguments->within, "What an error may be at most; 10% without it")->type_name("X%");
    command
        ->add_option("--try", arguments->wishes,
                     "Only reductions of this kind: softening, spheres, slice or size, with degrees or the usual ones; "
                     "may be repeated")
        ->type_name("KIND[=A,B]")
        ->expected(1)
        ->take_all();
    command
        ->add_option("--seeds", options.seeds,
                     "Runs of each, from the scene's seed on; 4 without it, the fewest that make sure of anything")
        ->type_name("N")
        ->check(whole_number_from(2, 100));
    command
        ->add_option("--reference", options.references,
                     "Folder of a run of the scene as written that is over, instead of running it; may be repeated")
        ->type_name("RUN")
        ->expected(1)
        ->take_all();
    command
        ->add_option(
            "--budget", options.budget,
            "Wall time for all runs, s: those that would go beyond are left out, the dearest first. The fullest "
            "that was run is then the reference")
        ->type_name("S")
        ->check(number_above_zero());
    command
        ->add_option("--measure", arguments->measures,
                     "Compare this mean too (`tumble list measures`); may be repeated")
        ->type_name("NAME")
        ->expected(1)
        ->take_all();
    command
        ->add_option("--time", arguments->time,
                     "What counts, s; the second half of the time in which walls move without it")
        ->type_name("A:B");
    command->add_option("--out", options.folder, "Folder; out/NAME-reduce of the scene file without it")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_option("--threads", options.threads, "Threads that step; 1 without it")
        ->type_name("N")
        ->check(whole_number_from(1, 256));
    command->add_flag("--unsure", arguments->unsure,
                      "Write the cheapest scene that seems to stay within where none surely does");
    command->add_flag("--quiet", arguments->quiet, "No progress on stderr");
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return reduce_it(*arguments); }; });
}

} // namespace tumble::cli
