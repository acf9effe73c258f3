#pragma once

#include "cli/flag_checks.h"

namespace tumble::cli {

/// How forces on a part are spread, wherever they are turned into load cases: stress::StudyOptions::patch.
inline void add_patch_flag(CLI::App& command, double& patch) {
    command
        .add_option("--patch", patch,
                    "Radius of the circles in which bodies touch, times that of the run: (E/E')^(1/3) for media of "
                    "modulus E' run with E; 0: forces act at points; 1 without it")
        ->type_name("X")
        ->check(number_from(0, 100));
}

} // namespace tumble::cli
