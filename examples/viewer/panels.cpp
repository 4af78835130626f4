// SPDX-License-Identifier: MIT
// The other panels: model, brush, camera, files, statistics.
#include "ui.h"

#include <algorithm>

namespace viewer {

void model_panel(App& app, Ui& ui) {
    const float width = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    for (std::size_t i = 0; i < formulas().size(); ++i) {
        if (i % 2 == 1) ImGui::SameLine();
        if (ImGui::Button(formulas()[i].c_str(), ImVec2(width, 0))) app.load_formula(formulas()[i]);
    }
    if (ImGui::Button("Stanford bunny", ImVec2(-1, 0))) app.load_bunny();
    ImGui::InputTextWithHint("##file", "file name, or drop a file", ui.file, sizeof ui.file);
    ImGui::SameLine();
    if (ImGui::Button("Open") && ui.file[0] != '\0') app.load(ui.file);
    if (app.scene() == nullptr) return;
    ImGui::TextWrapped("%s", app.scene()->name.c_str());
    for (const auto* notes : {&app.scene()->surface_notes, &app.scene()->notes})
        for (const std::string& note : *notes) ImGui::TextWrapped("- %s", note.c_str());
    if (ImGui::TreeNode("how to fit")) {
        ImGui::TextWrapped("For the next file that you open:");
        edit_fields({app, "hrbfnpr_fit_desc", "fit", &app.fit});
        ImGui::Separator();
        ImGui::TextUnformatted("For meshes only:");
        edit_fields({app, "hrbfnpr_mesh_fit_desc", "mesh_fit", &app.mesh_fit});
        ImGui::TreePop();
    }
}

void brush_panel(App& app) {
    static const char* const names[] = {"off",          "darken", "lighten", "fewer stipples", "restore stipples",
                                        "comb hatching"};
    const bool can_paint = app.scene() != nullptr && app.scene()->has_model();
    if (!can_paint) {
        ImGui::TextWrapped("Saved marks have no surface to paint on. Open a model.");
        return;
    }
    int kind = static_cast<int>(app.brush.kind);
    if (ImGui::Combo("brush", &kind, names, IM_ARRAYSIZE(names))) app.brush.kind = static_cast<Brush>(kind);
    ImGui::SliderFloat("radius", &app.brush.radius, 4, 150, "%.0f pixels");
    ImGui::SliderFloat("strength", &app.brush.strength, 0.02F, 1);
    ImGui::Text("%d dabs painted", static_cast<int>(app.choices.dabs.size()));
    ImGui::SameLine();
    if (ImGui::Button("Undo")) app.undo_stroke();
    ImGui::SameLine();
    if (ImGui::Button("Clear")) app.clear_paint();
    ImGui::TextWrapped("Paint with the left button, turn the model with the right one.");
}

void camera_panel(App& app) {
    if (ImGui::Button("See all")) app.reset_view();
    if (app.scene() == nullptr) return;
    View& view = *app.movable();
    auto degrees = static_cast<float>(view.vertical_angle * 57.29577951308232);
    if (ImGui::SliderFloat("angle of view", &degrees, 0, 90, degrees > 0 ? "%.0f degrees" : "orthographic")) {
        const double distance = length(view.eye - view.target), old = view.vertical_angle;
        const double height = old > 0 ? 2 * distance * std::tan(old / 2) : view.view_height;
        const double angle = degrees < 1 ? 0 : degrees / 57.29577951308232; // with any angle the model keeps its size
        view.view_height = height;
        if (angle > 0)
            view.eye = view.target + (height / (2 * std::tan(angle / 2)) / distance) * (view.eye - view.target);
        view.vertical_angle = angle;
        app.zoom_by(0);
    }
    static const struct {
        const char* name;
        Vec up;
    } ups[] = {{"x up", {1, 0, 0}}, {"y up", {0, 1, 0}}, {"z up", {0, 0, 1}}};
    for (const auto& each : ups) {
        if (&each != ups) ImGui::SameLine();
        if (!ImGui::Button(each.name)) continue;
        const Vec away = view.eye - view.target;
        if (length(cross(unit(away), each.up)) < 1e-3) view.eye = view.eye + 0.1 * length(away) * Vec{0.6, 0.7, 0.4};
        view.up = each.up;
        app.zoom_by(0);
    }
}

void export_panel(App& app, Ui& ui) {
    ImGui::InputTextWithHint("##target", "drawing.svg", ui.target, sizeof ui.target);
    ImGui::SameLine();
    if (ImGui::Button("Write")) app.save(ui.target);
    ImGui::TextWrapped(
        "The ending says what is written. Picture: .png .svg .pdf .hpgl .gcode .dxf; model: .hrbf; marks: .hrbm");
    if (ImGui::DragInt2("size", ui.export_size, 2, 0, 8192)) {
        const bool given = ui.export_size[0] > 0 && ui.export_size[1] > 0;
        app.choices.size = given ? Size{ui.export_size[0], ui.export_size[1]} : Size{};
    }
    if (app.choices.size.width == 0) ImGui::TextUnformatted("0 x 0: the size of the window");
    ImGui::Separator();
    ImGui::InputText("##settings", ui.settings_file, sizeof ui.settings_file);
    if (ImGui::Button("Load settings")) app.load_settings(ui.settings_file);
    ImGui::SameLine();
    if (ImGui::Button("Save settings")) app.save(ui.settings_file);
    ImGui::Separator();
    ImGui::InputText("##frames", ui.frames, sizeof ui.frames);
    ImGui::SliderInt("frames", &ui.frame_count, 2, 360);
    if (ImGui::Button("Record a turntable"))
        app.record(ui.frames, ui.frame_count, app.choices.size.width > 0 ? app.choices.size : app.canvas());
}

namespace {

void timings_table(const std::vector<Timing>& timings) {
    for (const Timing& timing : timings) {
        ImGui::Text("%s", timing.stage.c_str());
        ImGui::SameLine(0.55F * ImGui::GetWindowWidth());
        ImGui::Text("%.1f ms", timing.milliseconds);
    }
}

void row(const char* name, const char* format, double value) {
    ImGui::TextUnformatted(name);
    ImGui::SameLine(0.55F * ImGui::GetWindowWidth());
    ImGui::Text(format, value);
}

void frame_table(const App& app) {
    const Frame& frame = app.frame();
    const auto milliseconds = [](std::int64_t nanoseconds) { return 1e-6 * static_cast<double>(nanoseconds); };
    row("make the drawing", "%.1f ms", frame.draw_milliseconds);
    row("  classes and tones", "%.1f ms", milliseconds(frame.info.nanoseconds_classify));
    row("  visibility", "%.1f ms", milliseconds(frame.info.nanoseconds_visibility));
    row("  sorting", "%.1f ms", milliseconds(frame.info.nanoseconds_sort));
    row("  lines", "%.1f ms", milliseconds(frame.info.nanoseconds_lines));
    row("make the pixels", "%.1f ms", frame.raster_milliseconds);
    row("whole window", "%.1f ms", app.window_milliseconds);
    ImGui::Separator();
    row("marks shown", "%.0f", static_cast<double>(frame.info.shown));
    row("dots", "%.0f", static_cast<double>(frame.info.dots));
    row("strokes", "%.0f", static_cast<double>(frame.info.strokes));
    row("curves", "%.0f", static_cast<double>(frame.info.line_curves));
}

} // namespace

void statistics_panel(const App& app) {
    if (app.scene() == nullptr) return;
    for (const auto& layer : app.scene()->layers()) {
        char text[160];
        std::snprintf(text, sizeof text, layer.strokes > 0 ? "%%.0f in %lld strokes" : "%%.0f",
                      static_cast<long long>(layer.strokes));
        row(layer.name, text, static_cast<double>(layer.marks));
    }
    ImGui::Separator();
    timings_table(app.scene()->timings);
    ImGui::Separator();
    frame_table(app);
    row("memory", "%.1f MB", app.bytes() / 1e6);
}

} // namespace viewer
