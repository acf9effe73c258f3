#pragma once

#include "base/problem.h"

#include <memory>

namespace tumble::render {

/// An OpenGL core context (3.3 or newer, in practice 4.5) that needs no display. Its .cpp is the only file that knows
/// which library makes it, so that another one can take its place.
class GlContext {
public:
    /// Problem when the library gives no context, or one too old for sample shading (4.0).
    static Result<GlContext> open();

    /// While it lives, GL calls of this thread go to the context; afterwards another thread may take it.
    class Current {
    public:
        explicit Current(const GlContext& context);
        ~Current();
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;
    };

private:
    struct Surface;
    std::shared_ptr<Surface> surface_;
};

} // namespace tumble::render
