#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace tumble::cli {

/// What the chosen subcommand will do; returns an exit code.
using Action = std::function<int()>;

/// Each adds one subcommand and sets `action` when it is chosen. One file per command.
void add_run_command(CLI::App& program, Action& action);
void add_render_command(CLI::App& program, Action& action);
void add_check_command(CLI::App& program, Action& action);
void add_list_command(CLI::App& program, Action& action);
void add_lesson_command(CLI::App& program, Action& action);
void add_excitation_command(CLI::App& program, Action& action);
void add_lab_command(CLI::App& program, Action& action);
void add_export_command(CLI::App& program, Action& action);
void add_walls_command(CLI::App& program, Action& action);
void add_fit_command(CLI::App& program, Action& action);
void add_flow_command(CLI::App& program, Action& action);
void add_diagnose_command(CLI::App& program, Action& action);
void add_reveal_command(CLI::App& program, Action& action);
void add_reduce_command(CLI::App& program, Action& action);
void add_view_command(CLI::App& program, Action& action);
void add_stress_command(CLI::App& program, Action& action);
void add_gallery_command(CLI::App& program, Action& action);
void add_plot_command(CLI::App& program, Action& action);

} // namespace tumble::cli
