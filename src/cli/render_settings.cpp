#include "cli/render_settings.h"

#include "base/text.h"
#include "cli/scene_arguments.h"
#include "scene/keys.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::cli {

namespace {

std::string words_of(const char* key) {
    return fmt::format("{}", fmt::join(scene::find_key(*scene::find_table("render"), key)->words, ", "));
}

/// Whether a picture of a run that is over can still follow the key: what the run did and kept is what it is.
bool redrawable(const std::string& key) {
    const std::vector<std::string_view> parts = split(key, '.');
    if (parts[0] == "render")
        return parts.size() > 1 && parts[1] != "every_s";
    return key == "title" || (parts.size() == 3 && parts[0] == "wall" && parts[2] == "opacity");
}

} // namespace

Problems refuse_sets_of_the_run(const std::vector<std::string>& sets, const std::filesystem::path& scene) {
    Problems problems;
    for (const std::string& set : sets) {
        const std::string key(trimmed(set.substr(0, set.find('='))));
        if (!redrawable(key))
            problems.push_back(
                {.file = "--set " + key,
                 .key = key,
                 .what = "this run is over, and drawing it again cannot change that",
                 .fix = fmt::format(
                     "keys of [render] but every_s, title and wall.NAME.opacity can be set here; for others "
                     "run the scene anew: tumble run {} --out DIR --set {}",
                     scene.string(), set)});
    }
    return problems;
}

void add_render_settings(CLI::App& command, SceneArguments& arguments) {
    std::vector<std::string>& sets = arguments.sets;
    const auto add = [&](const char* flag, const char* type, const std::string& example, const std::string& sentence,
                         auto to_sets) {
        command
            .add_option_function<std::string>(
                flag,
                [&arguments, flag, example, to_sets](const std::string& text) {
                    const std::size_t before = arguments.sets.size();
                    to_sets(arguments.sets, text);
                    for (std::size_t k = before; k < arguments.sets.size(); ++k) {
                        const std::string& set = arguments.sets[k];
                        arguments.flags[set.substr(0, set.find('='))] = {fmt::format("{} {}", flag, text),
                                                                         fmt::format("{} {}", flag, example)};
                    }
                },
                sentence)
            ->type_name(type);
    };
    const auto word = [](const char* key) {
        return [key](std::vector<std::string>& all, const std::string& text) {
            all.push_back(std::string(key) + "=" + quoted(text));
        };
    };
    const auto list = [](const char* key) {
        return [key](std::vector<std::string>& all, const std::string& text) {
            all.push_back(std::string(key) + "=[" + text + "]");
        };
    };
    add("--camera", "front|top|side|free", "side", "Where the eye stands", word("render.camera"));
    const auto number = [](const char* key) {
        return [key](std::vector<std::string>& all, const std::string& text) {
            all.push_back(std::string(key) + "=" + text);
        };
    };
    const auto free_camera = [](auto to_sets) {
        return [to_sets](std::vector<std::string>& all, const std::string& text) {
            const bool chosen = std::any_of(all.begin(), all.end(),
                                            [](const std::string& set) { return set.starts_with("render.camera="); });
            if (!chosen)
                all.emplace_back("render.camera=\"free\"");
            to_sets(all, text);
        };
    };
    add("--eye", "X,Y,Z", "1,1,0.5 --target 0,0,0",
        "Place of the free camera, m, with --target; takes the free camera without --camera",
        free_camera(list("render.eye_m")));
    add("--target", "X,Y,Z", "0,0,0 --eye 1,1,0.5", "What the free camera looks at, m, with --eye; the same",
        free_camera(list("render.target_m")));
    add("--turn", "DEG_S", "90", "Degrees that it goes around per second of the scene; the same",
        free_camera(number("render.turn_deg_s")));
    add("--clip-lo", "X,Y,Z", "0,-1,-1 --clip-hi 1,1,1", "Lowest corner of a section: bodies outside are not drawn, m",
        list("render.clip_lo_m"));
    add("--clip-hi", "X,Y,Z", "1,1,1 --clip-lo 0,-1,-1", "Highest corner of it, m", list("render.clip_hi_m"));
    command.add_flag_callback(
        "--cut", [&sets] { sets.emplace_back("render.clip_cuts=true"); },
        "The section, or --sections, cut bodies and walls open instead of leaving out whole bodies");
    add("--color", "QUANTITY", "speed", "What colours the bodies: " + words_of("color"), word("render.color"));
    add("--range", "LO,HI", "0,0.5", "Values at the ends of the colour scale, SI", list("render.range"));
    add("--colormap", "NAME", "viridis", "Colour scale: " + words_of("colormap"), word("render.colormap"));
    add("--arrows", "none|bodies|field", "bodies", "Velocities: of bodies, or their mean over the frames on a grid",
        word("render.arrows"));
    add("--arrow", "M_S", "0.5", "Speed of the legend's arrow, m/s", number("render.arrow_m_s"));
    command.add_flag_callback(
        "--force-chains", [&sets] { sets.emplace_back("render.force_chains=true"); },
        "Lines as thick as the force between bodies (of a run with observe.contacts)");
    add("--chain", "N", "2", "Force of the thickest line, N", number("render.chain_N"));
    add("--trails", "BODY,...", "0,1", "Bodies whose way is drawn, by name or id",
        [](std::vector<std::string>& all, const std::string& text) {
            std::string names;
            for (const std::string_view name : split(text, ','))
                names += (names.empty() ? "" : ", ") + quoted(std::string(trimmed(name)));
            all.push_back("render.trails=[" + names + "]");
        });
    add("--background", "dark|white", "white", "Behind the picture", word("render.background"));
    add("--plot", "MEASURE", "kinetic_energy", "Measure in the small plot, or a column of a tracer, as tracer:sensor_y",
        [](std::vector<std::string>& all, const std::string& text) {
            const bool chosen = std::any_of(all.begin(), all.end(),
                                            [](const std::string& set) { return set.starts_with("render.plot="); });
            if (!chosen) // paper has none unless it is asked for
                all.emplace_back("render.plot=true");
            all.push_back("render.plot_measure=" + quoted(text));
        });
    const auto for_print = [](std::vector<std::string>& all) {
        const bool chosen = std::any_of(all.begin(), all.end(),
                                        [](const std::string& set) { return set.starts_with("render.style="); });
        if (!chosen)
            all.emplace_back("render.style=\"paper\"");
    };
    add("--style", "screen|paper", "paper", "paper: for print, white, sized in mm", word("render.style"));
    add("--size-mm", "WxH", "85x60",
        "Size for print, mm, such as 85x60; this flag and the next two take the style paper",
        [for_print](std::vector<std::string>& all, const std::string& text) {
            const std::size_t cross = text.find('x');
            for_print(all);
            all.push_back("render.width_mm=" + text.substr(0, cross));
            all.push_back("render.height_mm=" + (cross == std::string::npos ? "" : text.substr(cross + 1)));
        });
    const auto number_for_print = [for_print](const char* key) {
        return [for_print, key](std::vector<std::string>& all, const std::string& text) {
            for_print(all);
            all.push_back(std::string(key) + "=" + text);
        };
    };
    add("--dpi", "N", "300", "Pixels an inch of print", number_for_print("render.dpi"));
    add("--font-pt", "N", "8", "Points of the smallest letters in print", number_for_print("render.font_pt"));
    add("--size", "WxH", "1920x1080", "Pixels, such as 1920x1080",
        [](std::vector<std::string>& all, const std::string& text) {
            const std::size_t cross = text.find('x');
            all.push_back("render.width_px=" + text.substr(0, cross));
            all.push_back("render.height_px=" + (cross == std::string::npos ? "" : text.substr(cross + 1)));
        });
    command.add_flag_callback(
        "--perspective",
        [&arguments] {
            arguments.sets.emplace_back("render.projection=\"perspective\"");
            arguments.flags["render.projection"] = {"--perspective", "--perspective"};
        },
        "Vanishing points instead of parallel lines");
}

} // namespace tumble::cli
