// SPDX-License-Identifier: MIT
// An SDL window with OpenGL 2 and Dear ImGui in it.
#pragma once

#include "ui.h"

#include <SDL.h>

namespace viewer {

// A mouse that a script moves, in the window's pixels.
struct ScriptedMouse {
    float x = 0, y = 0;
    bool down[3] = {false, false, false}; // left, right, middle
    float wheel = 0;
};

class Window {
public:
    explicit Window(Size size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Waits for an event if nothing moves, and hands all pending events to ImGui. Returns false if the window was
    // closed.
    bool take_events(App& app, bool moves);
    void show(App& app, Ui& ui);
    void resize(Size size);
    // Saves the next picture that is shown to this path.
    void take_screenshot(const std::string& path) { screenshot_ = path; }

    std::optional<ScriptedMouse> mouse; // in place of the real one

private:
    void upload(const Frame& frame);
    void save_screenshot();

    SDL_Window* window_ = nullptr;
    SDL_GLContext gl_ = nullptr;
    unsigned texture_ = 0;
    std::string screenshot_;
};

} // namespace viewer
