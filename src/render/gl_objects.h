#pragma once

#include "base/problem.h"
#include "render/area.h"
#include "render/gl.h"
#include "render/picture.h"

#include <string>
#include <utility>

namespace tumble::render {

/// Owns one name that GL gave out. Must die while its context is current.
class GlObject {
public:
    using Release = void (*)(GLuint);
    GlObject() = default;
    GlObject(GLuint name, Release release) : name_(name), release_(release) {}
    GlObject(GlObject&& other) noexcept
        : name_(std::exchange(other.name_, 0)), release_(std::exchange(other.release_, nullptr)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        std::swap(release_, other.release_);
        return *this;
    }
    ~GlObject() {
        if (name_ != 0) {
            release_(name_);
        }
    }
    [[nodiscard]] GLuint name() const { return name_; }

private:
    GLuint name_ = 0;
    Release release_ = nullptr;
};

GlObject make_buffer();
GlObject make_vertex_array();
GlObject make_framebuffer();
GlObject make_texture();
GlObject make_renderbuffer();

/// Problem holds the compiler's words: the source is ours, so it tells of a driver that is too old.
Result<GlObject> make_program(const std::string& vertex_source, const std::string& fragment_source);

/// A texture without mipmaps that is read texel by texel.
GlObject make_plain_texture(GLenum format, int width, int height);

/// A picture of several samples a pixel that is only drawn into.
GlObject make_sample_buffer(GLenum format, int width, int height, int samples);

/// Replaces the content of an array buffer.
void upload(const GlObject& buffer, const void* data, std::size_t bytes);

/// Where pictures are drawn: several samples a pixel, and one-sample textures that they are resolved into.
struct Canvas {
    int width = 0;
    int height = 0;
    int samples_per_pixel = 1;
    GlObject sample_color;
    GlObject sample_depth;
    GlObject samples; // framebuffer of the two above
    GlObject color;
    GlObject depth;
    GlObject resolved; // framebuffer of the two above
};

/// Problem when the size is beyond what the context can draw.
Result<Canvas> make_canvas(int width, int height, int samples);

/// What is drawn from here on stays in that window, until the scissor test ends.
void keep_to_window(const Canvas& canvas, const Area& window);

/// Takes the samples of each pixel together, of colours the mean; the whole picture, whatever the scissor.
void resolve_samples(const Canvas& canvas, GLbitfield what);

/// What has been resolved, rows from the top and without translucent pixels.
Picture read_picture(const Canvas& canvas);

} // namespace tumble::render
