#include "base/make_folder.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/progress_line.h"
#include "cli/scene_arguments.h"
#include "cli/stop_flag.h"
#include "diagnose/bed_diagnosis.h"
#include "diagnose/verdict.h"
#include "observe/whole_file.h"
#include "report/diagnosis_json.h"
#include "report/diagnosis_page.h"
#include "report/diagnosis_pictures.h"
#include "run/record.h"
#include "run/run_report.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <system_error>
#include <unistd.h>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;

struct DiagnoseArguments {
    SceneArguments scene;
    fs::path data;
    fs::path report;
    fs::path extended;
    fs::path table; // of a bed's runs
    int seeds = 4;
    int threads = 1;
    bool plan = false;
    bool pictures = false;
    bool old_runs = false;
    bool dry = false;
    bool quiet = false;
    bool json = false;

    [[nodiscard]] diagnose::BedOptions for_beds() const {
        const fs::path beside = fs::path(scene.file).replace_extension(".response.csv");
        return {.table = table.empty() ? beside : table,
                .seeds = seeds,
                .version = run::version(),
                .any_date = old_runs,
                .plan = plan};
    }
};

/// What has to be run for a bed before anything is run.
std::string words_of(const diagnose::Budget& budget) {
    std::string text = fmt::format("{}, {:.4g} s to simulate; {} more are kept in the response table",
                                   counted(budget.runs, "run", "runs"), budget.simulated, budget.kept);
    if (budget.wall > 0)
        text += fmt::format("; about {}, as long as those took", duration(budget.wall));
    return text;
}

/// Means of a bed beside those of the simulation.
void tell_beds(const diagnose::Diagnosis& diagnosis) {
    std::vector<std::vector<std::string>> rows{{"", "condition", "number", "measured", "baseline", "extended"}};
    for (const diagnose::BedNumber& one : diagnosis.beds)
        rows.push_back({"", one.condition, one.measure + (one.unit.empty() ? "" : "_" + one.unit),
                        fmt::format("{:.3g} +- {:.2g}", one.measured, one.measured_error),
                        fmt::format("{:.3g} +- {:.2g}", one.baseline, one.baseline_error),
                        one.has_extended ? fmt::format("{:.3g} +- {:.2g}", one.extended, one.extended_error) : ""});
    say("");
    say(table(rows));
}

/// Those that show, the largest fall of chi-square first; then those that do not, by why.
void tell_causes(const diagnose::Diagnosis& diagnosis) {
    const auto& seen = diagnosis.decision.seen;
    std::vector<std::size_t> shown;
    std::map<std::string, std::vector<std::string>> others;
    for (std::size_t k = 0; k < seen.size(); ++k)
        if (seen[k].visible)
            shown.push_back(k);
        else
            others[diagnose::standing_of(diagnosis, static_cast<int>(k))].push_back(diagnosis.causes[k].id);
    std::stable_sort(shown.begin(), shown.end(),
                     [&](std::size_t a, std::size_t b) { return seen[a].gain > seen[b].gain; });
    std::vector<std::vector<std::string>> rows{{"", "cause", "fall of chi-square", "standing"}};
    for (const std::size_t k : shown) {
        const bool refused = seen[k].refit && !seen[k].refit->possible;
        rows.push_back({"", diagnosis.causes[k].id, refused ? "-" : fmt::format("{:.1f}", seen[k].gain),
                        diagnose::standing_of(diagnosis, static_cast<int>(k))});
    }
    say("");
    if (!shown.empty())
        say(table(rows));
    for (const auto& [why, causes] : others)
        say(fmt::format("  {}: {}", why, fmt::join(causes, ", ")));
}

/// Why there is no experiment to propose.
std::string no_plan_words(const diagnose::Decision& decision) {
    if (decision.outcome == diagnose::Outcome::none_known || decision.outcome == diagnose::Outcome::cannot_decide)
        return "none: no cause explains the data, so there are no two to be told apart";
    return diagnose::rivals_in(decision).size() < 2 ? "no two causes are left to be told apart"
                                                    : "no experiment of the catalogue adds to what was measured";
}

void tell_warnings(std::span<const Problem> warnings) {
    for (const Problem& warning : warnings)
        note(fmt::format("warning: {}: {}: {}\n    {}", warning.file, warning.key, warning.what, warning.fix));
}

/// `told`: how many of its warnings were, before it began.
void tell(const diagnose::Diagnosis& diagnosis, bool plan, bool quiet, std::size_t told) {
    say(diagnose::outcome_words(diagnosis));
    say(diagnose::verdict_of(diagnosis));
    say("Next: " + diagnose::next_step(diagnosis));
    if (!diagnosis.beds.empty())
        tell_beds(diagnosis);
    tell_causes(diagnosis);
    for (const diagnose::Proposal& proposal : diagnosis.proposals)
        say(fmt::format("plan  {}: {:.1f} standard errors apart, where now it is {:.1f}{}", proposal.sentence,
                        proposal.separation, proposal.before,
                        proposal.repeats > 1 ? fmt::format("; {} of them reach 5", proposal.repeats) : ""));
    if (plan && diagnosis.proposals.empty())
        say("plan  " + no_plan_words(diagnosis.decision));
    if (quiet)
        return;
    tell_warnings(std::span(diagnosis.warnings).subspan(told));
    note(fmt::format("{} runs, {:.3g} s simulated", diagnosis.runs, diagnosis.simulated));
}

/// How far a diagnosis has come, on stderr: nobody knows beforehand how many simulations it will take. A stop ends the
/// program after `leave`: half a diagnosis is none.
class Watch {
public:
    Watch(bool quiet, std::function<void()> leave) : line_(quiet), quiet_(quiet), leave_(std::move(leave)) {}

    void begins(const std::string& stage) {
        line_.end();
        if (!quiet_)
            note("now: " + stage);
    }
    /// From several threads at once.
    Result<observe::Series> run(const scene::Scene& scene) {
        {
            const std::lock_guard one_at_a_time(telling_);
            line_.working(fmt::format("     simulation {}, {:.3g} s simulated so far", ++runs_, simulated_));
            simulated_ += scene.duration;
        }
        auto series = run::record(scene, 1, stop_);
        if (!stop_wanted(stop_))
            return series;
        const std::lock_guard for_good(telling_);
        line_.end();
        leave_();
        std::_Exit(stop_code());
    }
    void end() { line_.end(); }

private:
    std::mutex telling_;
    ProgressLine line_;
    bool quiet_;
    std::function<void()> leave_;
    StopFlag stop_ = &watch_for_stop();
    int runs_ = 0;
    double simulated_ = 0; // s
};

/// By what was measured: records, or means of a bed.
Result<diagnose::Diagnosis> diagnosis_of(const DiagnoseArguments& arguments, const diagnose::SceneText& scene,
                                         const diagnose::Measurement& measurement, std::function<void()> leave) {
    Watch watch(arguments.quiet, std::move(leave));
    const diagnose::Simulate simulate([&](const scene::Scene& one) { return watch.run(one); }, arguments.threads);
    const auto begins = [&](const std::string& stage) { watch.begins(stage); };
    auto diagnosis = measurement.bulks.empty()
                         ? diagnose::diagnose(scene, measurement, simulate, arguments.plan, begins)
                         : diagnose::diagnose_beds(scene, measurement, simulate, arguments.for_beds(), begins);
    watch.end();
    return diagnosis;
}

/// What was asked for as files. Problems: a place that cannot be written.
Problems leave_files(const DiagnoseArguments& arguments, const diagnose::Diagnosis& diagnosis) {
    Problems problems;
    const auto leave = [&](const fs::path& file, const std::string& text) {
        const Result<Done> written = observe::write_whole(file, text);
        for (const Problem& problem : written.problems())
            problems.push_back(problem);
    };
    if (!arguments.report.empty()) {
        leave(arguments.report / "diagnosis.json", report::to_json(diagnosis, run::version()).dump(2) + "\n");
        leave(arguments.report / "diagnosis.html", report::page_of(diagnosis, run::version()));
        leave(arguments.report / "residuals.csv", report::residuals_csv(diagnosis));
        for (const report::PictureFile& picture :
             arguments.pictures ? report::pictures_of(diagnosis) : std::vector<report::PictureFile>{})
            leave(arguments.report / picture.name, picture.svg);
    }
    if (arguments.extended.empty())
        return problems;
    if (!diagnosis.decision.sure)
        problems.push_back(
            {.file = arguments.extended.string(),
             .what = "no extended scene was written: the name is not sure, for " + diagnosis.decision.reason,
             .fix = diagnosis.decision.remedy});
    else if (diagnosis.extended) {
        scene::Scene extended = *diagnosis.extended;
        extended.claim = diagnose::extended_claim(diagnosis);
        leave(arguments.extended, scene::to_toml(extended));
    } else
        problems.push_back(
            {.file = arguments.extended.string(),
             .what = diagnosis.decision.outcome == diagnose::Outcome::named
                         ? "no extended scene was written: what is named is the instrument's, and no scene holds it"
                         : "no extended scene was written: no cause is named",
             .fix = diagnose::next_step(diagnosis)});
    return problems;
}

/// Problem: a file cannot be written there, though its folder were made. Of no file there is none.
Result<Done> can_hold(const fs::path& file) {
    if (file.empty())
        return Done{};
    std::error_code ignored;
    fs::path folder = fs::absolute(file).parent_path(); // the nearest that is there
    while (!fs::exists(folder, ignored) && folder.has_relative_path())
        folder = folder.parent_path();
    const bool is_folder = fs::is_directory(folder, ignored), there = fs::exists(file, ignored);
    if (is_folder && !fs::is_directory(file, ignored) && ::access((there ? file : folder).c_str(), W_OK) == 0)
        return Done{};
    return Problem{.file = file.string(),
                   .what = "cannot be written: " + std::generic_category().message(!is_folder ? ENOTDIR
                                                                                   : fs::is_directory(file, ignored)
                                                                                       ? EISDIR
                                                                                       : errno),
                   .fix = "write to a folder that is there and yours"};
}

int diagnose_it(const DiagnoseArguments& arguments) {
    if (arguments.pictures && arguments.report.empty())
        return refuse({{.what = "--pictures go beside the report, and none is asked for",
                        .fix = "write --report DIR, or leave --pictures away"}},
                      arguments.json, wrong);
    const auto text = scene::read_file(arguments.scene.file, scene::largest_scene);
    if (!text)
        return refuse(text.problems(), arguments.json, wrong);
    if (const auto scene = arguments.scene.load(); !scene)
        return refuse(scene.problems(), arguments.json, wrong);
    const auto measurement = diagnose::load_measurement(arguments.data);
    if (!measurement)
        return refuse(measurement.problems(), arguments.json, wrong);
    diagnose::SceneText scene{*text, arguments.scene.file};
    for (const std::string& set : arguments.scene.sets)
        scene.sets.push_back({set});
    if (!measurement->bulks.empty()) {
        const auto budget = diagnose::budget_of_beds(scene, *measurement, arguments.for_beds());
        if (!budget)
            return refuse(budget.problems(), arguments.json, wrong);
        if (arguments.dry)
            say(words_of(*budget));
        else if (!arguments.quiet)
            note(words_of(*budget));
    }
    if (arguments.dry && measurement->bulks.empty())
        say("records are simulated as their fits ask for it: nobody knows beforehand how often");
    if (arguments.dry)
        return fine;
    if (!arguments.quiet && !arguments.json)
        tell_warnings(measurement->warnings);
    std::error_code ignored;
    if (const auto place = can_hold(arguments.extended); !place)
        return refuse(place.problems(), arguments.json, wrong);
    const bool had_report = arguments.report.empty() || fs::exists(arguments.report, ignored);
    if (!arguments.report.empty()) // a place that cannot be had is better known before the work than after it
        if (const auto made = make_folder(arguments.report); !made)
            return refuse(made.problems(), arguments.json, wrong);
    const auto leave_no_folder = [&] {
        if (!had_report)
            fs::remove(arguments.report, ignored); // it is empty
    };
    const auto diagnosis = diagnosis_of(arguments, scene, *measurement, [&] {
        leave_no_folder();
        note("stopped: no verdict, and nothing was written" +
             (measurement->bulks.empty()
                  ? std::string("; begin again")
                  : fmt::format(" but runs that had ended, in {}: begin again, and it goes on from there",
                                arguments.for_beds().table.string())));
    });
    if (!diagnosis) {
        leave_no_folder();
        return refuse(diagnosis.problems(), arguments.json, wrong);
    }
    const Problems problems = leave_files(arguments, *diagnosis);
    if (arguments.json)
        say_json(report::to_json(*diagnosis, run::version()));
    else
        tell(*diagnosis, arguments.plan, arguments.quiet, measurement->warnings.size());
    if (!arguments.json && !arguments.report.empty())
        say(fmt::format("report: {}", (arguments.report / "diagnosis.html").string()));
    if (!arguments.json && !arguments.extended.empty() && problems.empty())
        say(fmt::format("extended scene: {}", arguments.extended.string()));
    return problems.empty() ? static_cast<int>(fine) : refuse(problems, false, failed);
}

} // namespace

void add_diagnose_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "diagnose", "Example: tumble diagnose scenes/bounce.toml --data scenes/measured/bounce/measurement.toml "
                    "--report out/bounce\n\n"
                    "Holds measured data against a scene: says what the simulation gets wrong, or that the data cannot "
                    "tell.");
    const auto arguments = std::make_shared<DiagnoseArguments>();
    arguments->scene.add_to(*command);
    command->add_option("--data", arguments->data, "What was measured (TOML; docs/diagnosis.md)")
        ->required()
        ->type_name("FILE");
    command->add_option("--report", arguments->report, "Folder for diagnosis.html, diagnosis.json and residuals.csv")
        ->type_name("DIR")
        ->check(refuse_no_place);
    command->add_flag("--pictures", arguments->pictures,
                      "Of --report: the residuals, or the plot of each number of a bed, as SVG files too");
    command->add_option("--write-extended", arguments->extended, "Scene file to write, with the named cause in it")
        ->type_name("FILE")
        ->check(refuse_no_place);
    command
        ->add_option("--seeds", arguments->seeds,
                     "Of a bed: runs of it as it is and with each cause, from the scene's seed on; 4 without it")
        ->type_name("N")
        ->check(whole_number_from(2, 1000));
    command
        ->add_option(
            "--table", arguments->table,
            "Of a bed: where its runs are kept, so that none is made twice; SCENE.response.csv beside the scene "
            "without it")
        ->type_name("FILE")
        ->check(refuse_no_place);
    command->add_option("--threads", arguments->threads, "Simulations that run side by side; 1 without it")
        ->type_name("N")
        ->check(whole_number_from(1, 256));
    command->add_flag("--old-runs", arguments->old_runs,
                      "Of a bed: count kept runs of this scene whatever version of the program made them");
    command->add_flag("--dry-run", arguments->dry, "Of a bed: say what there is to run, and run nothing");
    command->add_flag("--plan", arguments->plan,
                      "Propose experiments also where the answer is not ambiguous; of a bed, run those that need runs");
    command->add_flag("--quiet", arguments->quiet, "No progress, no warnings on stderr");
    command->add_flag("--json", arguments->json, "Print the diagnosis as JSON");
    command->callback([arguments, &action] { action = [arguments] { return diagnose_it(*arguments); }; });
}

} // namespace tumble::cli
