#pragma once

namespace tumble::contact {

/// Resistance against rolling: rolling_cdt.h, rolling_epsd.h.
enum class RollingLaw { none, cdt, epsd };

/// Attraction between surfaces: sjkr.h, jkr.h, dmt.h.
enum class AdhesionLaw { none, sjkr, jkr, dmt };

/// What a scene adds to the plain law of all its pairs; the pairs say how much.
struct Additions {
    RollingLaw rolling = RollingLaw::none;
    AdhesionLaw adhesion = AdhesionLaw::none;
};

} // namespace tumble::contact
