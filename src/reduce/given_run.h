#pragma once

#include "reduce/climb.h"

/// A run that somebody has made before, as one of the scene as written: the full run of a case may take hours, and
/// nobody wants it twice. Its folder is read and never written.
namespace tumble::reduce {

/// That each can stand for the scene: it is a run; one of that scene (its seed, what it observes and draws, and how
/// long it is may differ); it has come to the end of the stretch that counts, wrote what is to be read, and has another
/// seed than those before it. The first that cannot is the problem.
std::optional<Problem> unfit_reference(const std::vector<std::filesystem::path>& folders, const scene::Scene& scene,
                                       const Yardstick& stick);

/// Reads what `stick` asks for. `mass` of all bodies, kg. Problems: as above.
Result<Seeded> read_given(const std::filesystem::path& folder, const scene::Scene& scene, const Yardstick& stick,
                          double mass);

} // namespace tumble::reduce
