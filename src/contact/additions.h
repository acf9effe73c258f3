#pragma once

namespace tumble::contact {

/// Resistance against rolling: rolling_cdt.h, rolling_epsd.h.
enum class RollingLaw { none, cdt, epsd };

/// What a scene adds to the plain law of all its pairs; the pairs say how much.
struct Additions {
    RollingLaw rolling = RollingLaw::none;
};

} // namespace tumble::contact
