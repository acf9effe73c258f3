#pragma once

#include "excitation/knock.h"
#include "excitation/rocking.h"
#include "excitation/slip.h"
#include "sheet/sheet.h"

#include <string>

/// What was found, as sheets.
namespace tumble::excitation {

sheet::Sheet show(const Record& record, const Excitation& found, const Settings& settings);
/// Adds what the second sensor tells.
void show_turns(sheet::Sheet& sheet, const std::vector<Turn>& turns, const Places& places);
sheet::Sheet show(const Record& record, const Ringing& ringing);
sheet::Sheet show(const BinnedLines& found, const std::string& source, const Settings& settings);

/// "order 3/2", "mains, 2 x 50 Hz", "fits nothing".
std::string name_of(const Line& line, double mains);

/// The motion as scene text, with a line that says where it comes from; to be put below a wall.
std::string motion_text(const scene::WallMotion& motion, const Record& record, const Excitation& found);

} // namespace tumble::excitation
