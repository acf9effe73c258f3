#pragma once

#include "reduce/ladder.h"

/// scenes/trough-2d.toml with 50 bodies, 0.2 s of filling and 0.4 s of shaking: a run takes about a second.
namespace tumble::test {

inline reduce::SceneText small_trough() {
    return {TUMBLE_ROOT "/scenes/trough-2d.toml",
            {{"fill.0.count=25"},
             {"fill.1.count=25"},
             {"fill.0.until_s=0.1"},
             {"fill.1.until_s=0.1"},
             {"wall.trough.motion.0.start_s=0.2"},
             {"wall.trough.motion.1.start_s=0.2"},
             {"duration_s=0.6"},
             {"time_step_s=3e-5"}}};
}

} // namespace tumble::test
