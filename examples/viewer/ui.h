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
    float step_ratio = 1; // rho_0 over the library's estimate, as the slider has it
    // The rectangle of the picture in the window.
    ImVec2 canvas_min{}, canvas_max{};
    bool holds = false, aims = false, paints = false; // the drag that is under way, and what it does
    std::vector<std::string> open_panels;             // the panels to open in the next frame; all others are closed
    ImTextureID texture = nullptr;
};

void set_up_style();
void draw_ui(App& app, Ui& ui);

// Each panel is in a file named after its subject.
void model_panel(App& app, Ui& ui);
void style_panel(App& app);
void lines_panel(App& app);
void marks_panel(App& app, Ui& ui);
void light_panel(App& app);
void brush_panel(App& app);
void camera_panel(App& app);
void export_panel(App& app, Ui& ui);
void statistics_panel(const App& app);

// A struct whose fields are edited. Each field that the user changes becomes a change of the picture.
struct Edited {
    App& app;
    const char* c_name; // "hrbfnpr_layer_style"
    std::string path;   // "style.hatch"
    void* values;
};

void edit_field(const Edited& edited, const char* field, const char* label = nullptr);
// Edits all fields that can be changed.
void edit_fields(const Edited& edited);
// Says whether a slider counts when it is moved, or only when it is let go.
enum class Counts { always, when_let_go };
void slide(const Edited& edited, const char* field, const char* label, double low, double high,
           Counts counts = Counts::always, const char* format = nullptr);
// Sends the present value of a field to the picture.
void tell_change(const Edited& edited, const char* field);

bool edit_colour(const char* label, float* rgba);

// These draw on the picture.
void draw_patches(const App& app, const Ui& ui);
void light_handle(App& app, Ui& ui);
void mouse_on_canvas(App& app, Ui& ui);

} // namespace viewer
