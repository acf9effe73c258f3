#pragma once

#include "stress/recorded.h"

namespace tumble::stress {

/// Leaves what was recorded from `from` to `to`, s: instants, means whose window ends there, touches that begin there.
/// A step counts as no difference. Problems: no instant is left.
Result<Done> trim(Recorded& recorded, double from, double to);

} // namespace tumble::stress
