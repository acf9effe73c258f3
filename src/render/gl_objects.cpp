#include "render/gl_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>

namespace tumble::render {

GlObject make_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return {name, [](GLuint gone) { glDeleteBuffers(1, &gone); }};
}

GlObject make_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return {name, [](GLuint gone) { glDeleteVertexArrays(1, &gone); }};
}

GlObject make_framebuffer() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return {name, [](GLuint gone) { glDeleteFramebuffers(1, &gone); }};
}

GlObject make_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return {name, [](GLuint gone) { glDeleteTextures(1, &gone); }};
}

GlObject make_renderbuffer() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return {name, [](GLuint gone) { glDeleteRenderbuffers(1, &gone); }};
}

static Problem refused(const std::string& words) {
    return {.what = "the OpenGL library refuses a shader: " + words,
            .fix = "install a current libosmesa6 (Mesa 22 or newer)"};
}

static Result<GlObject> compile(GLenum kind, const std::string& source) {
    GlObject shader{glCreateShader(kind), [](GLuint gone) { glDeleteShader(gone); }};
    const char* text = source.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint fine = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &fine);
    if (fine == GL_TRUE) {
        return shader;
    }
    std::array<char, 1024> words{};
    glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(words.size()), nullptr, words.data());
    return refused(words.data());
}

Result<GlObject> make_program(const std::string& vertex_source, const std::string& fragment_source) {
    auto vertex = compile(GL_VERTEX_SHADER, vertex_source);
    if (!vertex) {
        return vertex.problems();
    }
    auto fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
    if (!fragment) {
        return fragment.problems();
    }
    GlObject program{glCreateProgram(), [](GLuint gone) { glDeleteProgram(gone); }};
    glAttachShader(program.name(), vertex->name());
    glAttachShader(program.name(), fragment->name());
    glLinkProgram(program.name());
    GLint fine = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &fine);
    if (fine == GL_TRUE) {
        return program;
    }
    std::array<char, 1024> words{};
    glGetProgramInfoLog(program.name(), static_cast<GLsizei>(words.size()), nullptr, words.data());
    return refused(words.data());
}

GlObject make_plain_texture(GLenum format, int width, int height) {
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

void upload(const GlObject& buffer, const void* data, std::size_t bytes) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

GlObject make_sample_buffer(GLenum format, int width, int height, int samples) {
    GlObject buffer = make_renderbuffer();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return buffer;
}

Result<Canvas> make_canvas(int width, int height, int samples) {
    GLint most = 0;
    GLint most_samples = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
    if (width < 1 || height < 1 || width > most || height > most) {
        return Problem{.key = "render.width_px",
                       .what = fmt::format("a picture of {} x {} pixels cannot be drawn", width, height),
                       .fix = fmt::format("keep both sides between 1 and {} pixels", most)};
    }
    samples = std::min(samples, static_cast<int>(most_samples));
    Canvas canvas;
    canvas.width = width;
    canvas.height = height;
    canvas.samples_per_pixel = samples;
    canvas.sample_color = make_sample_buffer(GL_RGBA8, width, height, samples);
    canvas.sample_depth = make_sample_buffer(GL_DEPTH_COMPONENT32F, width, height, samples);
    canvas.samples = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.samples.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, canvas.sample_color.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, canvas.sample_depth.name());
    const bool drawn = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    canvas.color = make_plain_texture(GL_RGBA8, width, height);
    canvas.depth = make_plain_texture(GL_DEPTH_COMPONENT32F, width, height);
    canvas.resolved = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.resolved.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, canvas.color.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, canvas.depth.name(), 0);
    const bool kept = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (!drawn || !kept || glGetError() != GL_NO_ERROR) {
        return Problem{.what = fmt::format("the OpenGL library cannot make a canvas of {} x {} pixels", width, height),
                       .fix = "ask for a smaller picture"};
    }
    return canvas;
}

void keep_to_window(const Canvas& canvas, const Area& window) {
    const auto pixel = [](double place) { return static_cast<GLint>(std::lround(place)); };
    glEnable(GL_SCISSOR_TEST);
    glScissor(pixel(window.left), canvas.height - pixel(window.bottom), pixel(window.right) - pixel(window.left),
              pixel(window.bottom) - pixel(window.top));
}

void resolve_samples(const Canvas& canvas, GLbitfield what) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas.samples.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, canvas.resolved.name());
    const GLboolean cut = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, canvas.width, canvas.height, 0, 0, canvas.width, canvas.height, what, GL_NEAREST);
    if (cut == GL_TRUE) {
        glEnable(GL_SCISSOR_TEST);
    }
}

Picture read_picture(const Canvas& canvas) {
    Picture picture{canvas.width, canvas.height, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(canvas.width);
    picture.rgba.resize(row * static_cast<std::size_t>(canvas.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas.resolved.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, canvas.width, canvas.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    const auto begin = picture.rgba.begin();
    for (int y = 0; y < canvas.height / 2; ++y) {
        const auto top = begin + static_cast<std::ptrdiff_t>(row) * y;
        const auto bottom = begin + static_cast<std::ptrdiff_t>(row) * (canvas.height - 1 - y);
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
    }
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
        picture.rgba[i] = 255;
    }
    return picture;
}

} // namespace tumble::render
