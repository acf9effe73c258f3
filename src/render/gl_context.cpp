#include "render/gl_context.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <array>
#include <cstdint>

#ifdef __SANITIZE_ADDRESS__
// OSMesa 22 keeps some 160 bytes of each context for good; the leak checker asks this function what is not ours.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa";
}
#endif
#ifdef __SANITIZE_THREAD__
// The threads of its rasteriser were compiled without the race checker, which cannot see how they wait for each other.
extern "C" const char* __tsan_default_suppressions() {
    return "race:libOSMesa";
}
#endif

namespace tumble::render {

// Everything is drawn into framebuffer objects; the context only wants some buffer to be made current with.
constexpr int buffer_side = 16;

struct GlContext::Surface {
    OSMesaContext context = nullptr;
    std::array<std::uint8_t, 4 * buffer_side * buffer_side> buffer{};

    Surface() = default;
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    ~Surface() {
        if (context != nullptr) {
            OSMesaDestroyContext(context);
        }
    }
    bool make_current() {
        return OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, buffer_side, buffer_side) == GL_TRUE;
    }
};

Result<GlContext> GlContext::open() {
    constexpr std::array<int, 13> wanted{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         0,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         3,
                                         0,
                                         0,
                                         0};
    const Problem none{.what = "no OpenGL context for drawing pictures",
                       .fix = "install libosmesa6 (Mesa 22 to 24), or run without pictures"};
    GlContext result;
    result.surface_ = std::make_shared<Surface>();
    result.surface_->context = OSMesaCreateContextAttribs(wanted.data(), nullptr);
    if (result.surface_->context == nullptr || !result.surface_->make_current()) {
        return none;
    }
    GLint major = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    if (major < 4) {
        return none;
    }
    return result;
}

GlContext::Current::Current(const GlContext& context) {
    context.surface_->make_current();
}

GlContext::Current::~Current() {
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
}

} // namespace tumble::render
