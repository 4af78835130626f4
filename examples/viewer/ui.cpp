// SPDX-License-Identifier: MIT
#include "ui.h"

#include <algorithm>
#include <fstream>

namespace viewer {

namespace {

// A header that is open from the start, or only if a script opens it.
bool header(const Ui& ui, const char* name, bool open) {
    if (!ui.open_panels.empty()) {
        const bool wanted = std::find(ui.open_panels.begin(), ui.open_panels.end(), name) != ui.open_panels.end();
        ImGui::SetNextItemOpen(wanted);
    }
    return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

void panels(App& app, Ui& ui) {
    const auto panel = [&](const char* name, bool open, auto&& contents) {
        if (!header(ui, name, open)) return;
        ImGui::PushID(name);
        contents();
        ImGui::PopID();
    };
    panel("Model", true, [&] { model_panel(app, ui); });
    panel("Style", true, [&] { style_panel(app); });
    panel("Light", false, [&] { light_panel(app); });
    panel("Lines", false, [&] { lines_panel(app); });
    panel("Marks", false, [&] { marks_panel(app, ui); });
    panel("Brush", false, [&] { brush_panel(app); });
    panel("Camera", false, [&] { camera_panel(app); });
    panel("Files", false, [&] { export_panel(app, ui); });
    panel("Statistics", false, [&] { statistics_panel(app); });
    ui.open_panels.clear();
}

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                   ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings;

// Shows the job that runs, with a button that cancels it.
void progress_window(App& app, const Ui& ui) {
    if (!app.worker().is_busy()) return;
    const float width = std::min(320.0F, ui.canvas_max.x - ui.canvas_min.x - 20);
    ImGui::SetNextWindowPos(ImVec2(ui.canvas_min.x + 10, ui.canvas_max.y - 10), ImGuiCond_Always, ImVec2(0, 1));
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    ImGui::Begin("##progress", nullptr, fixed);
    const auto share = static_cast<float>(app.worker().work().share());
    char text[96];
    std::snprintf(text, sizeof text, "%s %.0f %%", app.progress().doing().c_str(), 100.0 * static_cast<double>(share));
    ImGui::ProgressBar(share, ImVec2(width - 90, 0), text);
    ImGui::SameLine();
    if (ImGui::Button("Cancel", ImVec2(-1, 0))) app.cancel();
    ImGui::End();
}

void message_window(App& app, const Ui& ui) {
    if (app.message.empty()) return;
    const float width = std::min(520.0F, ui.canvas_max.x - ui.canvas_min.x - 20);
    ImGui::SetNextWindowPos(ImVec2(ui.canvas_min.x + 10, ui.canvas_min.y + 10));
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.55F, 0.12F, 0.10F, 0.95F));
    ImGui::Begin("##message", nullptr, fixed);
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 1, 1, 1));
    ImGui::TextWrapped("%s", app.message.c_str());
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.35F, 0.05F, 0.05F, 1));
    if (ImGui::Button("Close")) app.message.clear();
    ImGui::PopStyleColor(2);
    ImGui::End();
    ImGui::PopStyleColor();
}

void picture(const App& app, const Ui& ui) {
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    if (app.scene() != nullptr && ui.texture != nullptr) {
        list->AddImage(ui.texture, ui.canvas_min, ui.canvas_max);
        return;
    }
    list->AddRectFilled(ui.canvas_min, ui.canvas_max, IM_COL32(250, 250, 247, 255));
    if (app.is_busy()) return;
    const char* const hint = "Choose a model on the left, or drop a file here";
    const ImVec2 size = ImGui::CalcTextSize(hint);
    list->AddText(
        ImVec2(0.5F * (ui.canvas_min.x + ui.canvas_max.x - size.x), 0.5F * (ui.canvas_min.y + ui.canvas_max.y)),
        IM_COL32(90, 90, 90, 255), hint);
}

// Updates the panels from the picture, unless one of them is being used.
void follow_picture(App& app, Ui& ui) {
    if (ImGui::IsAnyItemActive() || app.scene() == nullptr) return;
    app.refresh_sheet();
    const double step = app.sheet.marks.initial_step, estimate = app.scene()->patches.estimate;
    ui.step_ratio = step > 0 && estimate > 0 ? static_cast<float>(step / estimate) : 1;
}

} // namespace

void set_up_style() {
    ImGui::StyleColorsLight();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.FrameBorderSize = 1;
    style.WindowBorderSize = 0;
    style.ItemSpacing = ImVec2(6, 5);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // ImGui leaves no file on disk
    const char* const font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    if (std::ifstream(font)) io.Fonts->AddFontFromFileTTF(font, 14);
}

void draw_ui(App& app, Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float side = std::clamp(0.27F * window.x, 240.0F, 340.0F);
    ui.canvas_min = ImVec2(side, 0);
    ui.canvas_max = window;
    picture(app, ui);
    follow_picture(app, ui);
    draw_patches(app, ui);
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(side, window.y));
    ImGui::Begin("##panels", nullptr, fixed);
    ImGui::PushItemWidth(-0.44F * side); // the rest is for labels, at any indentation
    panels(app, ui);
    ImGui::PopItemWidth();
    if (!app.said.empty()) {
        ImGui::Separator();
        ImGui::TextWrapped("%s", app.said.c_str());
    }
    ImGui::End();
    light_handle(app, ui);
    mouse_on_canvas(app, ui);
    progress_window(app, ui);
    message_window(app, ui);
}

} // namespace viewer
