#include "cli/gallery.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::cli {

namespace {

Words run_of(const std::string& scene, const Words& sets) {
    Words words{"run", "{scenes}/" + scene, "--out", "{folder}"};
    for (const std::string& set : sets)
        words.insert(words.end(), {"--set", set});
    return words;
}

/// With each plot of its page as a file.
Words diagnosis_of(const std::string& scene, const std::string& data, const Words& flags) {
    Words words{"diagnose", "{scenes}/" + scene, "--data", "{scenes}/" + data, "--report", "{folder}", "--pictures"};
    words.insert(words.end(), flags.begin(), flags.end());
    return words;
}

/// Several frames in one picture, or one without what stands beside a frame; or a drawing of the last.
Words strip_of(const std::string& run, const Words& flags) {
    Words words{"render", "{" + run + "}"};
    words.insert(words.end(), flags.begin(), flags.end());
    words.insert(words.end(), {"--out", "{file}"});
    return words;
}

/// The frames of a time, with title, time and plot; each is a file of its own.
Words frames_of(const std::string& run, const Words& flags) {
    Words words{"render", "{" + run + "}"};
    words.insert(words.end(), flags.begin(), flags.end());
    words.insert(words.end(), {"--out", "{folder}"});
    return words;
}

} // namespace

const std::vector<GalleryRun>& gallery_runs() {
    static const std::vector<GalleryRun> runs{
        {"drum", run_of("drum-2d.toml", {"duration_s=3", "observe.contacts=true", "render.every_s=0.02"})},
        {"smooth", run_of("drum-2d.toml", {"duration_s=3", "render.every_s=0.02", "pair.glass-glass.friction=0.1"})},
        {"hopper", run_of("hopper-2d.toml", {"duration_s=2", "render.every_s=0.1"})},
        {"cones", run_of("settle-cones.toml", {"observe.contacts=true", "render.every_s=0.05"})},
        // One body to run with, and nothing above the bowl's rim that would be seen.
        {"empty", run_of("bowl-quick.toml", {"duration_s=1e-5", "fill.0.count=1", "fill.0.region_hi_m.1=0.2",
                                             "wall.collar.length_m=0.001", "wall.lid.centre_m.1=0.211"})},
        {"sensor", {"lab", "sensor", "--out", "{folder}"}},
        {"trough", run_of("trough-quick.toml", {"duration_s=2.2"}), 1},
        {"bowl", run_of("bowl-quick.toml", {}), 3},
        {"specimen",
         {"stress", "{scenes}/specimen-case-2-quick.toml", "--out", "{folder}", "--set",
          "wall.specimen.base_m=[0.0875,0.04,0]", "--set", "render.width_px=800", "--set", "render.height_px=450",
          "--from", "0.8", "--pictures", "--threads", "2"},
         3},
        {"case", diagnosis_of("lane.toml", "measured/cases/1/measurement.toml", {})},
        {"phase", diagnosis_of("measured/trough/trough.toml", "measured/trough/measurement-2.toml",
                               {"--seeds", "6", "--old-runs"})},
        {"bowl-full", run_of("bowl.toml", {}), 108},
    };
    return runs;
}

const std::vector<GalleryPicture>& gallery_pictures() {
    static const std::vector<GalleryPicture> pictures{
        {"arrows.png", "velocities of bodies",
         strip_of("drum", {"--strip=1", "--arrows=bodies", "--color=none", "--background=white", "--size=640x680"})},
        {"field.png", "their mean over a second",
         strip_of("drum", {"--strip=1", "--time=2:", "--arrows=field", "--color=none", "--background=white",
                           "--size=640x680"})},
        {"chains-2d.png", "force chains between discs",
         strip_of("drum", {"--strip=1", "--force-chains", "--color=none", "--background=white", "--size=640x680"})},
        {"chains-3d.png", "force chains between clumps of spheres",
         strip_of("cones", {"--strip=1", "--force-chains", "--color=none", "--camera=side",
                            "--set=render.view_hi_m=[0.05,0.07,0.05]", "--background=white", "--size=720x560"})},
        {"arrows-3d.png", "velocities in a trough",
         strip_of("trough", {"--strip=1", "--arrows=bodies", "--color=none", "--background=white", "--size=640x600"})},
        {"field-3d.png", "their mean over a second",
         strip_of("trough", {"--strip=1", "--time=1.2:", "--arrows=field", "--color=none", "--background=white",
                             "--size=640x600"})},
        {"trails.png", "the ways of two bodies",
         strip_of("drum", {"--strip=1", "--time=1:", "--trails=0,400", "--color=none", "--background=white",
                           "--size=640x680"})},
        {"trails-3d.png", "the ways of three cones",
         strip_of("trough", {"--strip=1", "--time=0.7:", "--trails=17,500,900", "--color=none", "--background=white",
                             "--size=640x600"})},
        {"strip.png", "six instants", strip_of("hopper", {"--strip=6x1", "--time=1:2", "--size=1280x720"})},
        {"strip-white.png", "the same on white",
         strip_of("hopper", {"--strip=6x1", "--time=1:2", "--background=white", "--size=1280x720"})},
        {"sections.png", "six sections through a heap",
         strip_of("cones", {"--sections=6", "--camera=side", "--set=render.view_hi_m=[0.05,0.07,0.05]", "--time=:0.2",
                            "--size=960x540"})},
        {"cut.png", "bodies cut open",
         strip_of("cones", {"--strip=1", "--camera=side", "--cut", "--clip-lo=-1,-1,-1", "--clip-hi=1,1,0",
                            "--set=render.view_hi_m=[0.05,0.07,0.05]", "--time=:0.2", "--size=720x560"})},
        {"pair.png", "two runs side by side",
         frames_of("drum", {"--beside={smooth}", "--labels=friction 0.5,friction 0.1",
                            "--time=2.99:", "--background=white", "--size=1200x600"}),
         "{folder}/frame_000150.png"},
        {"flow.png",
         "mean flow in the reduced bowl",
         {"flow", "{bowl}", "--time", "1.0:", "--radius", "0.1665", "--heights", "0,0.16", "--rings", "10", "--layers",
          "8", "--picture", "{file}"}},
        {"paper.png", "a picture for print, 85 mm wide",
         strip_of("drum", {"--strip=1", "--size-mm=85x85", "--dpi=200", "--font-pt=8"})},
        {"lines.svg", "the same as lines", strip_of("drum", {"--size-mm=85x85", "--font-pt=8"})},
        {"trough-quick.png", "cones in a vibrating trough", frames_of("trough", {"--time=2.195:", "--size=880x495"}),
         "{folder}/frame_000220.png"},
        {"drum-2d.png", "discs in a turning drum", frames_of("drum", {"--time=2.99:"}), "{folder}/frame_000150.png"},
        {"bowl-empty.png", "bowl and disc without media",
         frames_of("empty", {"--time=:0", "--clip-lo=-1,-1,-1", "--clip-hi=1,-0.9,1", "--color=none",
                             "--background=white", "--set=title=The bowl: ribbed wall, disc with inclined rim and ribs",
                             "--set=render.projection=orthographic", "--set=render.eye_m=[0.36,0.56,0.3]",
                             "--set=render.plot=false", "--set=wall.bowl.opacity=0.5", "--set=wall.collar.opacity=0",
                             "--set=wall.lid.opacity=0", "--size=960x540"}),
         "{folder}/frame_000000.png"},
        {"excitation-orbit.png",
         "how a wall moves, from an accelerometer's record",
         {"excitation", "{sensor}/sensor-1.csv", "--out", "{folder}"},
         "{folder}/orbit-zy.png"},
        {"lab-slide.png", "sliding angles over friction", {"lab", "slide", "--out", "{folder}"}, "{folder}/slide.png"},
        {"lab-plate.png", "flights of a ball on a plate", {"lab", "plate", "--out", "{folder}"}, "{folder}/plate.png"},
        {"reduction-trough-2d.png",
         "what cheaper versions of a flat trough cost",
         {"reduce",   "{scenes}/trough-2d.toml",
          "--out",    "{folder}",
          "--set",    "wall.trough.radius_m=0.12",
          "--set",    "duration_s=2.2",
          "--set",    "fill.0.count=60",
          "--set",    "fill.0.region_lo_m.0=-0.11",
          "--set",    "fill.0.region_hi_m.0=0.11",
          "--set",    "fill.1.count=60",
          "--set",    "fill.1.region_lo_m.0=-0.11",
          "--set",    "fill.1.region_hi_m.0=0.11",
          "--try",    "softening=2,4,8",
          "--try",    "size=1.25,1.5",
          "--within", "10%",
          "--unsure"},
         "{folder}/reduction.png"},
        {"stress-part.png", "a specimen among media, coloured by stress", {}, "{specimen}/part.png"},
        {"stress-slice.png", "the stress beneath its side", {}, "{specimen}/slice-side-0.5mm.png"},
        {"diagnosis-case.svg", "residuals of four throws, before and after", {}, "{case}/residuals.svg"},
        {"thrown-away-phase-circulation-half.svg",
         "circulation, measured and simulated",
         {},
         "{phase}/half-load-circulation.svg"},
        {"thrown-away-phase-slope-quarter.svg",
         "slope, measured and simulated",
         {},
         "{phase}/quarter-load-surface-slope.svg"},
        {"view.png",
         "the view of a simulation at work",
         {"view", "{scenes}/trough-quick.toml", "--picture", "{file}", "--time", ":0.96", "--threads", "2"},
         "{file}",
         1},
        {"bowl-sections.png", "six sections through the full bowl",
         strip_of("bowl-full",
                  {"--sections=0,0.027,0.054,0.081,0.108,0.135", "--cut", "--camera=side",
                   "--set=render.projection=orthographic", "--color=vy", "--range=-0.5,0.5", "--size=1120x640"})},
        {"bowl-flow.png",
         "mean flow in the full bowl",
         {"flow", "{bowl-full}", "--time", "1.7:", "--radius", "0.1665", "--heights", "0,0.16", "--rings", "10",
          "--layers", "8", "--picture", "{file}"}},
        {"view-run.png",
         "the view of a run that is over",
         {"view", "{bowl}", "--picture", "{file}", "--time", "0.8:2", "--tab", "Look", "--trails=sensor",
          "--size=1200x675"}},
    };
    return pictures;
}

std::vector<const GalleryRun*> runs_of(const GalleryPicture& picture) {
    const std::string all = fmt::format("{} {}", fmt::join(picture.words, " "), picture.taken);
    std::vector<const GalleryRun*> found;
    for (const GalleryRun& run : gallery_runs())
        if (all.find("{" + run.name + "}") != std::string::npos)
            found.push_back(&run);
    return found;
}

int minutes_of(const GalleryPicture& picture, const GivenRuns& given) {
    int minutes = picture.minutes;
    for (const GalleryRun* run : runs_of(picture))
        minutes += given.contains(run->name) ? 0 : run->minutes;
    return minutes;
}

std::string filled_in(const std::string& text, const GalleryPlaces& places) {
    GivenRuns known = places.given;
    known.insert({{"scenes", places.scenes}, {"file", places.file}, {"folder", places.folder}});
    std::string filled;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = std::min(text.find('{', at), text.size());
        filled += text.substr(at, open - at);
        if (open == text.size())
            break;
        const std::size_t close = text.find('}', open);
        const std::string name = text.substr(open + 1, close - open - 1);
        const auto found = known.find(name);
        filled += (found != known.end() ? found->second : places.runs / name).string();
        at = close + 1;
    }
    return filled;
}

Words filled_in(const Words& words, const GalleryPlaces& places) {
    Words filled;
    for (const std::string& word : words)
        filled.push_back(filled_in(word, places));
    return filled;
}

std::string typed(const Words& words) {
    std::string line = "tumble";
    for (const std::string& word : words)
        line += word.find(' ') == std::string::npos ? " " + word : " '" + word + "'";
    return line;
}

GalleryRecipe recipe_of(const GalleryPicture& picture) {
    GalleryRecipe recipe;
    for (const GalleryRun* run : runs_of(picture))
        recipe.commands.push_back(typed(filled_in(run->words, {"scenes", "out", {}, "out/" + run->name})));
    const std::filesystem::path stem = std::filesystem::path(picture.file).stem();
    const GalleryPlaces places{"scenes", "out", picture.file, "out" / stem};
    if (!picture.words.empty())
        recipe.commands.push_back(typed(filled_in(picture.words, places)));
    recipe.result = filled_in(picture.taken, places);
    return recipe;
}

} // namespace tumble::cli
