// SPDX-License-Identifier: MIT
// The overlay of the picture: Figure 5's squares, the light's handle and the brush, and how they react to the mouse.
#include "ui.h"

#include <algorithm>

namespace viewer {

namespace {

constexpr float handle_radius = 34;

ImVec2 handle_centre(const Ui& ui) {
    return ImVec2(ui.canvas_max.x - handle_radius - 12, ui.canvas_max.y - handle_radius - 12);
}

bool is_inside(const ImVec2& point, const ImVec2& centre, float radius) {
    const float x = point.x - centre.x, y = point.y - centre.y;
    return x * x + y * y <= radius * radius;
}

bool is_over_canvas(const Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantCaptureMouse && io.MousePos.x >= ui.canvas_min.x && io.MousePos.x < ui.canvas_max.x &&
           io.MousePos.y >= ui.canvas_min.y && io.MousePos.y < ui.canvas_max.y;
}

// Tells whether a place is visible: the drawn surface is in front of it by at most `slack` at its pixel.
bool is_seen(const Frame& frame, const Vec& window, double slack) {
    if (frame.depth.empty()) return true; // this frame has no depth
    const int x = static_cast<int>(window[0]), y = static_cast<int>(window[1]);
    if (x < 0 || y < 0 || x >= frame.size.width || y >= frame.size.height) return false;
    const double depth =
        static_cast<double>(frame.depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.size.width) +
                                        static_cast<std::size_t>(x)]);
    const double* const p = frame.camera.projection;
    const double clip = 2 * depth - 1;
    // The distance in front of the eye at this depth.
    const double distance = p[15] != 0 ? (p[14] - clip) / p[10] : p[14] / (clip + p[10]);
    return window[2] <= distance + slack;
}

} // namespace

void draw_patches(const App& app, const Ui& ui) {
    if (!app.patches_shown() || app.scene() == nullptr || !app.frame().drawing) return;
    const Patches& patches = app.scene()->patches;
    if (patches.estimate <= 0) return;
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const Frame& frame = app.frame();
    const Vec eye = ray_of(frame.camera, 0.5 * frame.size.width, 0.5 * frame.size.height).first;
    for (const auto& corners : patches.corners) {
        const Vec middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
        const Vec normal = unit(cross(corners[1] - corners[0], corners[3] - corners[0]));
        const Vec window = window_of(frame.camera, middle);
        const Vec to_eye = frame.camera.projection[15] != 0 ? to_world(frame.camera, {0, 0, 1}) : eye - middle;
        if (window[2] <= 0 || dot(normal, to_eye) <= 0) continue;
        if (!is_seen(frame, window, 0.01 * app.scene()->diagonal())) continue;
        ImVec2 quad[4];
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec at = window_of(frame.camera, middle + static_cast<double>(ui.step_ratio) * (corners[k] - middle));
            quad[k] = ImVec2(ui.canvas_min.x + static_cast<float>(at[0]), ui.canvas_min.y + static_cast<float>(at[1]));
        }
        list->AddQuadFilled(quad[0], quad[1], quad[2], quad[3], IM_COL32(200, 60, 30, 70));
        list->AddQuad(quad[0], quad[1], quad[2], quad[3], IM_COL32(150, 40, 20, 220), 1.5F);
    }
}

void light_handle(App& app, Ui& ui) {
    if (app.scene() == nullptr) return;
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const ImVec2 centre = handle_centre(ui), mouse = ImGui::GetIO().MousePos;
    if (ui.aims) {
        if (!ImGui::IsMouseDown(0)) ui.aims = false;
        const double x = static_cast<double>((mouse.x - centre.x) / handle_radius);
        const double y = static_cast<double>((centre.y - mouse.y) / handle_radius);
        const double square = x * x + y * y;
        if (ui.aims) app.aim_light(square < 1 ? Vec{x, y, std::sqrt(1 - square)} : Vec{x, y, 0});
    }
    const Vec light = app.light_in_camera();
    list->AddCircleFilled(centre, handle_radius, IM_COL32(255, 255, 255, 210), 48);
    list->AddCircle(centre, handle_radius, IM_COL32(110, 110, 110, 255), 48, 1.5F);
    const ImVec2 at(centre.x + handle_radius * static_cast<float>(light[0]),
                    centre.y - handle_radius * static_cast<float>(light[1]));
    list->AddLine(centre, at, IM_COL32(150, 150, 150, 255), 1.5F);
    const bool behind = light[2] < 0; // drawn hollow: the light comes from behind the model
    list->AddCircleFilled(at, 7, behind ? IM_COL32(255, 255, 255, 255) : IM_COL32(245, 175, 20, 255), 24);
    list->AddCircle(at, 7, IM_COL32(120, 80, 0, 255), 24, 1.5F);
}

void mouse_on_canvas(App& app, Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool over = is_over_canvas(ui);
    const double x = static_cast<double>(io.MousePos.x - ui.canvas_min.x),
                 y = static_cast<double>(io.MousePos.y - ui.canvas_min.y);
    const bool brushes = app.brush.kind != Brush::off;
    const bool is_down = ImGui::IsMouseDown(0) || ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2);
    if (!is_down) ui.holds = false;
    if (over && !ui.holds && is_down) { // a drag begins here and continues wherever the mouse moves
        ui.holds = true;
        ui.aims = ImGui::IsMouseDown(0) && app.scene() != nullptr &&
                  is_inside(io.MousePos, handle_centre(ui), handle_radius + 8);
        ui.paints = brushes && ImGui::IsMouseDown(0) && !ui.aims;
        if (ui.paints) app.begin_stroke();
    }
    if (ui.paints) {
        app.paint_at(x, y);
        if (!ImGui::IsMouseDown(0)) ui.paints = false, app.end_stroke();
    }
    if (over && brushes)
        ImGui::GetBackgroundDrawList()->AddCircle(io.MousePos, app.brush.radius, IM_COL32(0, 90, 200, 200), 48, 1.5F);
    if (over && io.MouseWheel != 0) app.zoom_by(static_cast<double>(io.MouseWheel));
    if (!ui.holds || ui.aims || ui.paints || (io.MouseDelta.x == 0 && io.MouseDelta.y == 0)) return;
    const double dx = static_cast<double>(io.MouseDelta.x), dy = static_cast<double>(io.MouseDelta.y);
    if (ImGui::IsMouseDown(2) || io.KeyShift)
        app.pan_by(dx, dy);
    else
        app.orbit_by(dx, dy);
}

} // namespace viewer
