#include "cli/render_settings.h"

#include "cli/scene_arguments.h"

namespace tumble::cli {

void add_render_settings(CLI::App& command, std::vector<std::string>& sets) {
    const auto add = [&](const char* flag, const char* type, const char* sentence, auto to_sets) {
        command
            .add_option_function<std::string>(
                flag, [&sets, to_sets](const std::string& text) { to_sets(sets, text); }, sentence)
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
    add("--camera", "front|top|side|free", "Where the eye stands", word("render.camera"));
    add("--eye", "X,Y,Z", "Place of the free camera, m", list("render.eye_m"));
    add("--target", "X,Y,Z", "What the free camera looks at, m", list("render.target_m"));
    add("--color", "QUANTITY", "What colours the bodies: speed, vx, vy, vz, ...", word("render.color"));
    add("--range", "LO,HI", "Values at the ends of the colour scale, SI", list("render.range"));
    add("--colormap", "NAME", "Colour scale: viridis, cividis, inferno, coolwarm, ...", word("render.colormap"));
    add("--background", "dark|white", "Behind the picture", word("render.background"));
    add("--plot", "MEASURE", "Measure in the small plot", word("render.plot_measure"));
    add("--size", "WxH", "Pixels, such as 1920x1080", [](std::vector<std::string>& all, const std::string& text) {
        const std::size_t cross = text.find('x');
        all.push_back("render.width_px=" + text.substr(0, cross));
        all.push_back("render.height_px=" + (cross == std::string::npos ? "" : text.substr(cross + 1)));
    });
    command.add_flag_callback(
        "--perspective", [&sets] { sets.emplace_back("render.projection=\"perspective\""); },
        "Vanishing points instead of parallel lines");
}

} // namespace tumble::cli
