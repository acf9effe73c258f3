#include "cli/canvas_flags.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/flag_checks.h"
#include "cli/sheet_flags.h"
#include "excitation/show.h"
#include "observe/whole_file.h"
#include "scene/read_file.h"
#include "sheet/show.h"

#include <fmt/format.h>
#include <memory>

namespace tumble::cli {

namespace {

namespace fs = std::filesystem;
namespace ex = excitation;

struct ExcitationArguments {
    fs::path file, second, folder;
    std::vector<double> at_mm, second_at_mm;
    std::string about = "x";
    double motor_rpm = 0, start_s = 0;
    ex::Settings settings;
    CanvasFlags canvas_flags;
    sheet::Canvas canvas; // what they say
    bool hammer = false, json = false;
};

int give(const ExcitationArguments& arguments, const std::string& title, const sheet::Sheet& sheet,
         const std::string& motion) {
    if (!arguments.folder.empty()) {
        if (const int code = draw_and_note(sheet, arguments.folder, arguments.json, arguments.canvas); code != fine)
            return code;
        const fs::path file = arguments.folder / "motion.toml";
        if (!motion.empty()) {
            if (const auto written = observe::write_whole(file, motion); !written)
                return refuse(written.problems(), arguments.json, failed);
            note("motion: " + file.string());
        }
    }
    if (arguments.json) {
        nlohmann::ordered_json json{{"excitation", arguments.file.string()}};
        json.update(sheet::to_json(sheet));
        if (!motion.empty())
            json["motion"] = motion;
        say_json(json);
        return fine;
    }
    say(sheet::to_text(title, sheet) + (motion.empty() ? "" : "\n" + motion));
    return fine;
}

int from_list(const ExcitationArguments& arguments, const std::string& text) {
    const auto found = ex::find_slip(text, arguments.file.string(), arguments.settings);
    if (!found)
        return refuse(found.problems(), arguments.json, wrong);
    return give(arguments, "A list of lines", ex::show(*found, arguments.file.string(), arguments.settings), "");
}

int from_knocks(const ExcitationArguments& arguments, const ex::Record& record) {
    const auto ringing = ex::find_modes(record, arguments.settings);
    if (!ringing)
        return refuse(ringing.problems(), arguments.json, wrong);
    return give(arguments, "Natural frequencies", ex::show(record, *ringing), "");
}

Eigen::Vector3d place(const std::vector<double>& mm) {
    return mm.size() == 3 ? Eigen::Vector3d(1e-3 * mm[0], 1e-3 * mm[1], 1e-3 * mm[2]) : Eigen::Vector3d::Zero();
}

int from_record(const ExcitationArguments& arguments, Result<ex::Record> record) {
    const bool two = !arguments.second.empty();
    if (record && two) {
        const auto second = ex::read_record(arguments.second);
        record = second ? ex::together(std::move(*record), *second) : second.problems();
    }
    if (!record)
        return refuse(record.problems(), arguments.json, wrong);
    const auto found = ex::find_lines(*record, arguments.settings);
    if (!found)
        return refuse(found.problems(), arguments.json, wrong);
    sheet::Sheet sheet = ex::show(*record, *found, arguments.settings);
    scene::WallMotion motion = ex::motion_of(*found, record->channels, arguments.start_s);
    if (two) {
        const ex::Places places{place(arguments.at_mm), place(arguments.second_at_mm), arguments.about[0] - 'x'};
        const auto turns = ex::turns_of(*found, record->channels, places);
        if (!turns)
            return refuse(turns.problems(), arguments.json, wrong);
        ex::show_turns(sheet, *turns, places);
        motion = ex::motion_of(*turns, places, arguments.start_s);
    }
    return give(arguments, "Excitation", sheet, ex::motion_text(motion, *record, *found));
}

int excite(ExcitationArguments arguments) {
    arguments.settings.motor = arguments.motor_rpm / 60;
    const auto canvas = canvas_of(arguments.canvas_flags);
    if (!canvas)
        return refuse(canvas.problems(), arguments.json, wrong);
    arguments.canvas = *canvas;
    constexpr std::size_t largest = std::size_t{256} << 20;
    Result<std::string> text = scene::read_file(arguments.file, largest);
    if (!text)
        return refuse(text.problems(), arguments.json, wrong);
    if (ex::is_line_list(*text))
        return from_list(arguments, *text);
    Result<ex::Record> record = ex::parse_record(std::move(*text), arguments.file.string());
    if (arguments.hammer)
        return record ? from_knocks(arguments, *record) : refuse(record.problems(), arguments.json, wrong);
    return from_record(arguments, std::move(record));
}

} // namespace

void add_excitation_command(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "excitation",
        "Example: tumble excitation accelerometer.csv --out excitation\n\n"
        "From what an accelerometer recorded to how a wall moves: fits the lines of a CSV record with the\n"
        "columns t_s, ax_m_s2, ay_m_s2, az_m_s2 (or t_ms, t_us; ax_g, ax_mm_s2), amplitude and phase, at a\n"
        "fitted fundamental; says which are orders, which mains, which neither; and prints the motion as\n"
        "scene text. A list of lines (axis,amplitude,period) is asked which fundamental its bins allow.");
    const auto arguments = std::make_shared<ExcitationArguments>();
    command->add_option("ACCEL.csv", arguments->file, "Record of an accelerometer, or a list of lines")->required();
    CLI::Option* second =
        command->add_option("--second", arguments->second, "Record of a second sensor, sampled with the first: rocking")
            ->type_name("ACCEL.csv");
    const auto at = [&](const char* name, std::vector<double>& mm, const char* sentence) {
        command->add_option(name, mm, sentence)->type_name("X,Y,Z")->delimiter(',')->expected(3)->needs(second);
    };
    at("--at_mm", arguments->at_mm, "Where the first sensor sits, mm");
    at("--second_at_mm", arguments->second_at_mm, "Where the second sensor sits, mm");
    command->add_option("--about", arguments->about, "Axis that the body rocks about (x without it)")
        ->check(one_of({"x", "y", "z"}));
    command
        ->add_option("--motor_rpm", arguments->motor_rpm,
                     "Nominal speed: the fundamental is looked for within 8 % of it (without it: the strongest line)")
        ->check(number_from(1.0, 1e6));
    command->add_option("--up_to_Hz", arguments->settings.up_to, "Highest line looked for (250 without it)")
        ->check(number_from(1.0, 1e6));
    command->add_option("--mains_Hz", arguments->settings.mains, "Frequency of the mains (50 without it)")
        ->check(number_from(1.0, 1000.0));
    command
        ->add_option("--bin_Hz", arguments->settings.bin,
                     "Width of a list's bins (without it: the widest that all lines are multiples of)")
        ->check(number_from(1e-6, 1e6));
    command->add_flag("--hammer", arguments->hammer, "Knocks on a machine at rest: natural frequencies and damping");
    command->add_option("--start_s", arguments->start_s, "When the motion begins in the scene (0 without it)")
        ->check(number_from(0.0, 1e6));
    command->add_option("--out", arguments->folder, "Folder for motion.toml and the figures (needs gnuplot)")
        ->type_name("DIR")
        ->check(refuse_no_place);
    add_canvas_flags(*command, arguments->canvas_flags);
    command->add_flag("--json", arguments->json, "Print the result as JSON");
    command->callback([arguments, &action] { action = [arguments] { return excite(*arguments); }; });
}

} // namespace tumble::cli
