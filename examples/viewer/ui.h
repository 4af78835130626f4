// SPDX-License-Identifier: MIT
// The window's contents: panels on the left, the picture with its handles on the right.
#pragma once

#include "app.h"

#include <imgui.h>

namespace viewer {

struct Ui {
    char file[512] = "";
    char target[512] = "drawing.svg";
    char settings_file[512] = "settings.json";
    char frames[512] = "turn-%03d.png";
    int frame_count = 36;
    int export_size[2] = {0, 0};
    float step_ratio = 1; // rho_0 over the library's, while it is being chosen
    // Where the picture is in the window.
    ImVec2 canvas_min{}, canvas_max{};
    bool holds = false, aims = false, paints = false; // a drag that is under way, and what it does
    std::vector<std::string> open_panels;             // to be opened in the next frame, the others closed
    ImTextureID texture = nullptr;
};

void set_up_style();
void draw_ui(App& app, Ui& ui);

// Panels, each in a file of its subject.
void model_panel(App& app, Ui& ui);
void style_panel(App& app);
void lines_panel(App& app);
void marks_panel(App& app, Ui& ui);
void light_panel(App& app);
void brush_panel(App& app);
void camera_panel(App& app);
void export_panel(App& app, Ui& ui);
void statistics_panel(const App& app);

// A struct whose fields are edited: each that is changed becomes a change of the picture.
struct Edited {
    App& app;
    const char* c_name; // "hrbfnpr_layer_style"
    std::string path;   // "style.hatch"
    void* values;
};

void edit_field(const Edited& edited, const char* field, const char* label = nullptr);
// The same for all fields that can be changed.
void edit_fields(const Edited& edited);
// A slider, which counts when it is moved, or only when it is let go.
enum class Counts { always, when_let_go };
void slide(const Edited& edited, const char* field, const char* label, double low, double high,
           Counts counts = Counts::always, const char* format = nullptr);
// Tells the picture what a field holds now.
void tell_change(const Edited& edited, const char* field);

bool edit_colour(const char* label, float* rgba);

// On the picture.
void draw_patches(const App& app, const Ui& ui);
void light_handle(App& app, Ui& ui);
void mouse_on_canvas(App& app, Ui& ui);

} // namespace viewer
