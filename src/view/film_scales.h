#pragma once

#include "observe/frame.h"
#include "render/marks.h"
#include "render/ticks.h"
#include "scene/scene.h"

#include <optional>

namespace tumble::view {

/// The scales of a film that goes on while hands change its look. Where they are left open, colours, arrows and force
/// chains get the scale of the picture that first shows them, and keep it: a legend that jumped with the camera could
/// not be read in a video. What that picture gives no scale to, as nothing moves or presses in it yet, stays open.
class FilmScales {
public:
    /// `look` with its scales fixed; `range` and `key` are those of the picture of `frame` that was drawn with it.
    scene::Render settle(const scene::Render& look, const observe::Frame& frame, const render::Span& range,
                         const render::MarkKey& key);

    /// Force chains were wanted of a frame that has not looked for contacts: the next one may have.
    [[nodiscard]] bool waits_for_contacts() const { return waits_; }

private:
    struct Settled {
        scene::Render look, fixed;
    };
    std::optional<Settled> last_;
    bool waits_ = false;
};

} // namespace tumble::view
