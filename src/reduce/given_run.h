#pragma once

#include "reduce/climb.h"

/// A run that somebody has made before, as one of the scene as written: the full run of a case may take hours, and
/// nobody wants it twice. Its folder is read and never written.
namespace tumble::reduce {

/// Reads what `stick` asks for. `mass` of all bodies, kg. Problems: no run; one of another scene (its seed, what it
/// observes and draws, and how long it is may differ), with the first thing that differs; one that ended before the
/// stretch that counts does; one that did not write what is to be read.
Result<Seeded> read_given(const std::filesystem::path& folder, const scene::Scene& scene, const Yardstick& stick,
                          double mass);

} // namespace tumble::reduce
