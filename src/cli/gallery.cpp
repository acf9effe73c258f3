#include "cli/gallery.h"

namespace tumble::cli {

const std::vector<GalleryRun>& gallery_runs() {
    static const std::vector<GalleryRun> runs{
        {"drum", "drum-2d.toml", {"duration_s=3", "observe.contacts=true", "render.every_s=0.02"}},
        {"hopper", "hopper-2d.toml", {"duration_s=2", "render.every_s=0.1"}},
        {"cones", "settle-cones.toml", {"observe.contacts=true", "render.every_s=0.05"}},
    };
    return runs;
}

const std::vector<GalleryPicture>& gallery_pictures() {
    static const std::vector<GalleryPicture> pictures{
        {"arrows.png",
         "velocities of bodies",
         "drum",
         {"--strip=1", "--arrows=bodies", "--color=none", "--background=white", "--size=640x680"}},
        {"field.png",
         "their mean over a second",
         "drum",
         {"--strip=1", "--time=2:", "--arrows=field", "--color=none", "--background=white", "--size=640x680"}},
        {"chains-2d.png",
         "force chains between discs",
         "drum",
         {"--strip=1", "--force-chains", "--color=none", "--background=white", "--size=640x680"}},
        {"chains-3d.png",
         "force chains between clumps of spheres",
         "cones",
         {"--strip=1", "--force-chains", "--color=none", "--camera=side", "--set=render.view_hi_m=[0.05,0.07,0.05]",
          "--background=white", "--size=720x560"}},
        {"trails.png",
         "the ways of two bodies",
         "drum",
         {"--strip=1", "--time=1:", "--trails=0,400", "--color=none", "--background=white", "--size=640x680"}},
        {"strip.png", "six instants", "hopper", {"--strip=6x1", "--time=1:2", "--size=1280x720"}},
        {"sections.png",
         "six sections through a heap",
         "cones",
         {"--sections=6", "--camera=side", "--set=render.view_hi_m=[0.05,0.07,0.05]", "--time=:0.2", "--size=960x540"}},
        {"paper.png",
         "a picture for print, 85 mm wide",
         "drum",
         {"--strip=1", "--size-mm=85x85", "--dpi=200", "--font-pt=8"}},
        {"lines.svg", "the same as lines", "drum", {"--size-mm=85x85", "--font-pt=8"}},
    };
    return pictures;
}

} // namespace tumble::cli
