// SPDX-License-Identifier: MIT
// Draws a drawing's marks as point sprites of an OpenGL that runs on the processor: Mesa's llvmpipe, off screen.
#pragma once

#include "orbit.h"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(HRBFNPR_BENCH_EGL)
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#endif

namespace bench {

#if defined(HRBFNPR_BENCH_EGL)

// Draws every mark as a blended round point with a smooth rim, without depth test and order, which would take more
// time.
class Llvmpipe {
public:
    // Throws std::runtime_error if there is no such OpenGL.
    Llvmpipe(const hrbfnpr_point_set* set, float radius, int width, int height) : width_(width), height_(height) {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        make_context();
        make_target();
        program_ = make_program();
        upload(set);
        glUseProgram(program_);
        glUniform1f(glGetUniformLocation(program_, "radius"), radius);
        matrix_ = glGetUniformLocation(program_, "matrix");
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glViewport(0, 0, width, height);
        glClearColor(1.0F, 1.0F, 1.0F, 1.0F);
        pixels_.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }
    ~Llvmpipe() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }
    Llvmpipe(const Llvmpipe&) = delete;
    Llvmpipe& operator=(const Llvmpipe&) = delete;

    [[nodiscard]] static std::string renderer() {
        return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); // NOLINT: GLubyte
    }
    void draw(const hrbfnpr_camera& camera) {
        const glm::mat4 matrix(Lens(camera).to_clip * glm::translate(glm::dmat4(1.0), origin_));
        glUniformMatrix4fv(matrix_, 1, GL_FALSE, glm::value_ptr(matrix));
        glClear(GL_COLOR_BUFFER_BIT);
        glDrawArrays(GL_POINTS, 0, count_);
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
        if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL failed to draw");
    }
    [[nodiscard]] const std::vector<unsigned char>& pixels() const { return pixels_; } // bottom row first

private:
    static void need(bool good, const char* what) {
        if (!good) throw std::runtime_error(std::string("no ") + what);
    }
    void make_context() {
        const auto display_of =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        need(display_of != nullptr, "eglGetPlatformDisplayEXT");
        display_ = display_of(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        need(display_ != EGL_NO_DISPLAY && eglInitialize(display_, nullptr, nullptr) == EGL_TRUE,
             "surfaceless EGL display");
        eglBindAPI(EGL_OPENGL_ES_API);
        const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint number = 0;
        need(eglChooseConfig(display_, wanted, &config, 1, &number) == EGL_TRUE && number == 1, "EGL configuration");
        const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
        need(context_ != EGL_NO_CONTEXT &&
                 eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE,
             "OpenGL ES 3 context");
    }
    void make_target() const {
        GLuint buffer = 0;
        GLuint target = 0;
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
        glGenFramebuffers(1, &target);
        glBindFramebuffer(GL_FRAMEBUFFER, target);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
        need(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "framebuffer");
    }
    [[nodiscard]] static GLuint shader(GLenum kind, const char* text) {
        const GLuint shader = glCreateShader(kind);
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        GLint good = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
        need(good != 0, "shader");
        return shader;
    }
    [[nodiscard]] static GLuint make_program() {
        const GLuint program = glCreateProgram();
        glAttachShader(program, shader(GL_VERTEX_SHADER, R"(#version 300 es
            layout(location = 0) in vec3 position;
            uniform mat4 matrix;
            uniform float radius;
            void main() {
                gl_Position = matrix * vec4(position, 1.0);
                gl_PointSize = 2.0 * radius + 1.0;
            })"));
        glAttachShader(program, shader(GL_FRAGMENT_SHADER, R"(#version 300 es
            precision highp float;
            uniform float radius;
            out vec4 color;
            void main() {
                float distance = length(gl_PointCoord - 0.5) * (2.0 * radius + 1.0);
                color = vec4(0.0, 0.0, 0.0, clamp(radius + 0.5 - distance, 0.0, 1.0));
            })"));
        glLinkProgram(program);
        GLint good = 0;
        glGetProgramiv(program, GL_LINK_STATUS, &good);
        need(good != 0, "program");
        return program;
    }
    void upload(const hrbfnpr_point_set* set) {
        const hrbfnpr_point_set_info info = info_of(set);
        origin_ = glm::make_vec3(info.origin);
        std::vector<float> places;
        for (std::int64_t layer = 0; layer < info.layers; ++layer) {
            std::int64_t count = 0;
            const float* position = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
            places.insert(places.end(), position, position + 3 * count);
        }
        count_ = static_cast<GLsizei>(places.size() / 3);
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(float)), places.data(),
                     GL_STATIC_DRAW);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        glEnableVertexAttribArray(0);
    }

    int width_, height_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    GLuint program_ = 0;
    GLint matrix_ = 0;
    GLsizei count_ = 0;
    glm::dvec3 origin_{0.0};
    std::vector<unsigned char> pixels_;
};

#else

class Llvmpipe {
public:
    Llvmpipe(const hrbfnpr_point_set*, float, int, int) {
        throw std::runtime_error("built without EGL and OpenGL ES 3");
    }
    [[nodiscard]] static std::string renderer() { return {}; }
    void draw(const hrbfnpr_camera&) {}
};

#endif

} // namespace bench
