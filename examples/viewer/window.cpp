// SPDX-License-Identifier: MIT
#include "window.h"

#include <SDL_opengl.h>
#include <algorithm>
#include <backends/imgui_impl_opengl2.h>
#include <backends/imgui_impl_sdl.h>

namespace viewer {

namespace {

void check_sdl(bool fine) {
    if (!fine) throw Failure(std::string("SDL: ") + SDL_GetError());
}

void press_key(App& app, SDL_Keycode key) {
    if (ImGui::GetIO().WantTextInput) return;
    if (key == SDLK_ESCAPE) app.cancel();
    if (key == SDLK_f) app.reset_view();
    if (key == SDLK_z && (SDL_GetModState() & KMOD_CTRL) != 0) app.undo_stroke();
    const double step = 20; // same effect as a mouse move of this many pixels
    if (key == SDLK_LEFT) app.orbit_by(-step, 0);
    if (key == SDLK_RIGHT) app.orbit_by(step, 0);
    if (key == SDLK_UP) app.orbit_by(0, -step);
    if (key == SDLK_DOWN) app.orbit_by(0, step);
    if (key == SDLK_PLUS || key == SDLK_KP_PLUS) app.zoom_by(1);
    if (key == SDLK_MINUS || key == SDLK_KP_MINUS) app.zoom_by(-1);
}

bool ends_in_json(const std::string& path) { return path.size() > 5 && path.compare(path.size() - 5, 5, ".json") == 0; }

// Returns false when the window shall close.
bool handle(App& app, const SDL_Event& event) {
    ImGui_ImplSDL2_ProcessEvent(&event);
    if (event.type == SDL_KEYDOWN) press_key(app, event.key.keysym.sym);
    if (event.type == SDL_DROPFILE) {
        const std::string path = event.drop.file;
        SDL_free(event.drop.file);
        if (ends_in_json(path))
            app.load_settings(path);
        else
            app.load(path);
    }
    return event.type != SDL_QUIT;
}

} // namespace

Window::Window(Size size) {
    check_sdl(SDL_Init(SDL_INIT_VIDEO) == 0);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 2);
    window_ = SDL_CreateWindow("hrbfnpr-view", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width, size.height,
                               SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
    check_sdl(window_ != nullptr);
    gl_ = SDL_GL_CreateContext(window_);
    check_sdl(gl_ != nullptr);
    SDL_GL_SetSwapInterval(1);
    SDL_SetWindowMinimumSize(window_, 480, 360);
    SDL_EventState(SDL_DROPFILE, SDL_ENABLE);
    ImGui::CreateContext();
    set_up_style();
    ImGui_ImplSDL2_InitForOpenGL(window_, gl_);
    ImGui_ImplOpenGL2_Init();
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

Window::~Window() {
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
    SDL_GL_DeleteContext(gl_);
    SDL_DestroyWindow(window_);
    SDL_Quit();
}

bool Window::take_events(App& app, bool moves) {
    SDL_Event event;
    // ImGui needs a few frames after the last event, such as a click.
    bool goes_on = true;
    if (!moves && SDL_WaitEventTimeout(&event, 100) != 0) goes_on = handle(app, event);
    while (SDL_PollEvent(&event) != 0) goes_on = handle(app, event) && goes_on;
    return goes_on;
}

void Window::upload(const Frame& frame) {
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, frame.size.width, frame.size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 frame.pixels.data());
}

void Window::show(App& app, Ui& ui) {
    const Uint64 start = SDL_GetPerformanceCounter();
    ImGui_ImplOpenGL2_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    if (mouse) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = ImVec2(mouse->x, mouse->y);
        std::copy(mouse->down, mouse->down + 3, io.MouseDown);
        io.MouseWheel = mouse->wheel;
    }
    ImGui::NewFrame();
    ui.texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_));
    draw_ui(app, ui);
    app.set_canvas({std::max(16, static_cast<int>(ui.canvas_max.x - ui.canvas_min.x)),
                    std::max(16, static_cast<int>(ui.canvas_max.y - ui.canvas_min.y))});
    const bool is_new = app.draw();
    if (is_new) upload(app.frame());
    ImGui::Render();
    glViewport(0, 0, static_cast<int>(ImGui::GetIO().DisplaySize.x), static_cast<int>(ImGui::GetIO().DisplaySize.y));
    // The background behind transparent paper is grey.
    glClearColor(0.8F, 0.8F, 0.8F, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
    if (!screenshot_.empty()) save_screenshot();
    glFinish(); // the measured time includes the drawing
    if (is_new)
        app.window_milliseconds = 1e3 * static_cast<double>(SDL_GetPerformanceCounter() - start) /
                                  static_cast<double>(SDL_GetPerformanceFrequency());
    SDL_GL_SwapWindow(window_);
}

void Window::resize(Size size) { SDL_SetWindowSize(window_, size.width, size.height); }

void Window::save_screenshot() {
    Size size;
    SDL_GL_GetDrawableSize(window_, &size.width, &size.height);
    const auto row = 4 * static_cast<std::size_t>(size.width);
    std::vector<std::uint8_t> bottom_up(row * static_cast<std::size_t>(size.height)), pixels(bottom_up.size());
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, bottom_up.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.height); ++y)
        std::copy_n(bottom_up.end() - static_cast<std::ptrdiff_t>((y + 1) * row), row,
                    pixels.begin() + static_cast<std::ptrdiff_t>(y * row));
    for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
    const std::string path = std::move(screenshot_);
    screenshot_.clear();
    write_png(path, pixels, size);
}

} // namespace viewer
