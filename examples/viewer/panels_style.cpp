// SPDX-License-Identifier: MIT
// What the drawing looks like: style, lines, marks, light.
#include "ui.h"

#include <algorithm>
#include <cmath>

namespace viewer {

namespace {

const char* const style_name = "hrbfnpr_style";
const char* const layer_name = "hrbfnpr_layer_style";
const char* const line_name = "hrbfnpr_line_style";

std::string label_of(const hrbfnpr_layer_style& layer) {
    static const char* const kinds[] = {"all others", "stipples", "principal", "combing", "field", "own", "hatching"};
    return layer.name != nullptr ? layer.name : layer.kind < 7 ? kinds[layer.kind] : "?";
}

// Whether there are marks that it is for.
bool is_drawn(const App& app, const hrbfnpr_layer_style& style) {
    if (app.ink() == nullptr) return false;
    const auto& infos = app.ink()->infos;
    return std::any_of(infos.begin(), infos.end(), [&](const auto& info) {
        const bool kind = style.kind == HRBFNPR_LAYER_KIND_ANY || style.kind == info.kind;
        return kind && (style.name == nullptr || style.name == std::string(info.name));
    });
}

bool edit_layer(hrbfnpr_layer_style& layer) {
    bool changed = edit_field(layer_name, "shown", &layer);
    changed |= ImGui::SliderFloat("share", &layer.share, 0, 1);
    if (layer.shape == HRBFNPR_SHAPE_HATCH) {
        changed |= ImGui::SliderFloat("spacing", &layer.hatch_spacing, 1, 20);
        changed |= ImGui::SliderFloat("pen", &layer.hatch_pen, 0.1F, 4);
        changed |= ImGui::DragFloatRange2("darkness", &layer.hatch_tone_begin, &layer.hatch_tone_end, 0.005F, 0, 1);
        changed |= ImGui::DragFloatRange2("coverage", &layer.hatch_coverage_begin, &layer.hatch_coverage_end, 0.005F,
                                          0.01F, 1);
        changed |= ImGui::SliderFloat("wobble", &layer.hatch_wobble, 0, 8);
    } else {
        changed |= ImGui::SliderFloat("radius", &layer.radius, 0.2F, 6);
    }
    changed |= edit_field(layer_name, "ink", &layer);
    if (ImGui::TreeNode("all fields")) {
        changed |= edit_fields(layer_name, &layer);
        ImGui::TreePop();
    }
    return changed;
}

void set_ink(Style& style, const float* ink) {
    for (auto& layer : style.layers) std::copy(ink, ink + 4, layer.ink);
    for (auto& line : style.lines) std::copy(ink, ink + 4, line.ink);
    std::copy(ink, ink + 4, style.fields.silhouette_ink);
}

} // namespace

void style_panel(App& app) {
    Settings& settings = app.settings;
    Style& style = settings.style;
    if (ImGui::BeginCombo("style", preset_name(settings.preset).c_str(), ImGuiComboFlags_HeightLargest)) {
        for (std::uint32_t preset = 0; !preset_name(preset).empty(); ++preset)
            if (ImGui::Selectable(preset_name(preset).c_str(), preset == settings.preset)) app.use_preset(preset);
        ImGui::EndCombo();
    }
    bool changed = false;
    auto pen = static_cast<float>(settings.pen);
    if (ImGui::SliderFloat("pen", &pen, 0, 5, pen > 0 ? "%.2f pixels" : "by the size")) {
        settings.pen = std::max(pen, 0.0F);
        changed = true;
    }
    changed |= edit_field(style_name, "paper", &style.fields);
    float ink[4];
    std::copy(style.fields.silhouette_ink, style.fields.silhouette_ink + 4, ink);
    if (edit_colour("ink of all", ink)) {
        set_ink(style, ink);
        changed = true;
    }
    changed |= edit_field(style_name, "hidden_lines", &style.fields);
    changed |= ImGui::SliderFloat("halo", &style.fields.halo_width, 0, 12);
    for (std::size_t i = 0; i < style.layers.size(); ++i) {
        if (!is_drawn(app, style.layers[i])) continue;
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::TreeNode(label_of(style.layers[i]).c_str())) {
            changed |= edit_layer(style.layers[i]);
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    if (ImGui::TreeNode("all fields of the style")) {
        const auto visibility = style.fields.visibility;
        changed |= edit_fields(style_name, &style.fields);
        if (visibility != style.fields.visibility) app.place_marks(); // lines are drawn with one of them only
        ImGui::TreePop();
    }
    if (changed) app.redraw();
}

void lines_panel(App& app) {
    auto& lines = app.settings.style.lines;
    for (const Field& field : fields_of(line_name)) {
        if (field.name != "kind") continue;
        for (std::size_t i = 0; i < field.choices.size(); ++i) {
            const auto kind = field.first_choice + static_cast<std::uint32_t>(i);
            const auto here = std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l.kind == kind; });
            bool on = here != lines.end();
            if (kind == HRBFNPR_LINE_KIND_OWN && !on) continue; // there are none to draw
            if (i % 2 == 1) ImGui::SameLine(0.5F * ImGui::GetContentRegionAvail().x + 8);
            const std::string label = field.choices[i].substr(0, field.choices[i].find('_'));
            if (!ImGui::Checkbox(label.c_str(), &on)) continue;
            if (on) {
                lines.push_back(defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init));
                lines.back().kind = kind;
                if (kind != HRBFNPR_LINE_KIND_CONTOUR) lines.back().width = 1.3F; // finer
                if (kind == HRBFNPR_LINE_KIND_ISOPHOTE)
                    lines.back().levels = kept(std::vector<double>{0.25, 0.5, 0.75});
            } else {
                lines.erase(here);
            }
            app.place_marks();
            return; // the list has changed
        }
    }
    bool changed = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const Field* kind = nullptr;
        for (const Field& field : fields_of(line_name))
            if (field.name == "kind") kind = &field;
        const std::size_t place = lines[i].kind - kind->first_choice;
        if (ImGui::TreeNode("line", "%s", place < kind->choices.size() ? kind->choices[place].c_str() : "?")) {
            changed |= ImGui::SliderFloat("width", &lines[i].width, 0.2F, 10);
            changed |= edit_field(line_name, "hidden", &lines[i]);
            changed |= ImGui::SliderFloat("outline", &lines[i].outline_factor, 0.2F, 4);
            changed |= ImGui::SliderFloat("wobble", &lines[i].wobble, 0, 4);
            if (ImGui::TreeNode("all fields")) {
                changed |= edit_fields(line_name, &lines[i]);
                ImGui::TreePop();
            }
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    if (changed) app.redraw();
}

namespace {

// Figure 5: the squares are shown for any step at once; marks follow when the mouse lets go.
void choose_step(App& app, Ui& ui) {
    bool shown = app.patches_shown();
    if (ImGui::Checkbox("squares of side 2 rho_0", &shown)) app.show_patches(shown);
    const Patches* const patches = app.ink() != nullptr ? &app.ink()->patches : nullptr;
    if (!shown || patches == nullptr || patches->estimate <= 0) return;
    const bool is_given = app.settings.marks.initial_step > 0;
    ImGui::SliderFloat("rho_0", &ui.step_ratio, 0.1F, 4, "%.2f estimates", ImGuiSliderFlags_Logarithmic);
    if (ImGui::IsItemDeactivatedAfterEdit()) app.set_step(ui.step_ratio * patches->estimate);
    ImGui::Text("= %.4g (estimate %.4g)", ui.step_ratio * patches->estimate, patches->estimate);
    if (is_given && ImGui::Button("Take the estimate")) app.set_step(0);
}

bool edit_levels(hrbfnpr_layer_desc& layer) {
    ImGui::SliderInt("steps", &layer.levels, 0, 7);
    return ImGui::IsItemDeactivatedAfterEdit();
}

bool edit_made_layer(hrbfnpr_layer_desc& layer, bool published) {
    bool changed = false;
    if (published) return edit_levels(layer);
    if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES) {
        auto count = static_cast<int>(layer.budget);
        ImGui::SliderInt("marks", &count, 100, 400000, "%d", ImGuiSliderFlags_Logarithmic);
        layer.budget = count;
        changed |= ImGui::IsItemDeactivatedAfterEdit();
        changed |= edit_field("hrbfnpr_layer_desc", "density", &layer);
    }
    if (layer.kind == HRBFNPR_LAYER_KIND_HATCH) {
        changed |= edit_field("hrbfnpr_layer_desc", "guide", &layer);
        auto angle = static_cast<float>(layer.angle);
        ImGui::SliderFloat("angle", &angle, -90, 90, "%.0f degrees");
        layer.angle = angle;
        changed |= ImGui::IsItemDeactivatedAfterEdit();
    }
    if (ImGui::TreeNode("all fields")) {
        edit_fields("hrbfnpr_layer_desc", &layer);
        changed |= ImGui::Button("Place the marks");
        ImGui::TreePop();
    }
    return changed;
}

} // namespace

void marks_panel(App& app, Ui& ui) {
    auto& marks = app.settings.marks;
    auto distribution = marks.distribution;
    if (edit_field("hrbfnpr_generate_desc", "distribution", &marks)) {
        std::swap(distribution, marks.distribution);
        app.set_distribution(distribution);
    }
    const bool published = marks.distribution == HRBFNPR_DISTRIBUTION_PUBLISHED;
    if (published) {
        bool changed = edit_field("hrbfnpr_generate_desc", "seed_source", &marks, "seeds");
        auto cells = static_cast<int>(marks.box_resolution);
        ImGui::SliderInt("cells of a box", &cells, 1, 32);
        marks.box_resolution = static_cast<std::uint32_t>(std::clamp(cells, 1, 256));
        changed |= ImGui::IsItemDeactivatedAfterEdit();
        if (changed) app.place_marks();
        choose_step(app, ui);
    }
    auto& layers = app.own_layers();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        static const char* const kinds[] = {"any", "stipples", "principal", "combing", "field", "own", "hatching"};
        const char* const name = layers[i].name != nullptr ? layers[i].name : kinds[std::min(layers[i].kind, 6U)];
        if (ImGui::TreeNodeEx("layer", ImGuiTreeNodeFlags_DefaultOpen, "%s", name)) {
            if (edit_made_layer(layers[i], published)) app.place_marks();
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    if (ImGui::Button("As the style and the picture need")) {
        layers.clear();
        app.place_marks();
    }
}

void light_panel(App& app) {
    auto& fields = app.settings.style.fields;
    bool changed = edit_field(style_name, "tone", &fields);
    auto exponent = static_cast<float>(fields.tone_exponent);
    if (ImGui::SliderFloat("tone exponent", &exponent, 0.1F, 4)) {
        fields.tone_exponent = exponent;
        changed = true;
    }
    changed |= ImGui::SliderFloat("fill light", &fields.fill_light, 0, 1);
    changed |= edit_field(style_name, "light", &fields, "towards the light");
    changed |= edit_field(style_name, "light_space", &fields);
    ImGui::TextWrapped("The ball on the picture turns the light.");
    if (changed) app.redraw();
}

} // namespace viewer
