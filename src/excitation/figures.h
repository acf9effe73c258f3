#pragma once

#include "excitation/knock.h"
#include "excitation/motion.h"
#include "sheet/sheet.h"

#include <utility>
#include <vector>

namespace tumble::excitation {

/// Pairs of channels of the first sensor whose plane is worth a picture: the one drawn across, the one drawn upwards (y
/// where it is one of them).
std::vector<std::pair<std::size_t, std::size_t>> planes_of(const std::vector<Channel>& channels);

/// The closed orbit of all orders, and that of order 1 alone.
sheet::Figure orbit_figure(const Record& record, const Excitation& found, std::size_t across, std::size_t up);
/// Acceleration of every line, a colour for each kind.
sheet::Figure spectrum_figure(const Record& record, const Excitation& found);
/// The first periods of the strongest channel, as recorded and as fitted.
sheet::Figure record_figure(const Record& record, const Excitation& found);
/// What followed the first knock.
sheet::Figure ringing_figure(const Record& record, const Ringing& rings);

} // namespace tumble::excitation
