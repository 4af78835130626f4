// SPDX-License-Identifier: MIT
// Panels for the look of the drawing: style, lines, marks, light.
#include "fields.h"
#include "ui.h"

#include <algorithm>
#include <cmath>

namespace viewer {

namespace {

const char* const style_name = "hrbfnpr_style";
const char* const layer_name = "hrbfnpr_layer_style";
const char* const line_name = "hrbfnpr_line_style";
const char* const mark_layer_name = "hrbfnpr_layer_desc";

// Returns the word for a kind that paths of changes use.
std::string kind_word(const char* c_name, std::uint32_t kind) {
    const Field& field = field_of(c_name, "kind");
    const std::size_t place = kind - field.first_choice;
    return place < field.choices.size() ? field.choices[place] : "?";
}

std::string layer_label(std::uint32_t kind) {
    return kind == HRBFNPR_LAYER_KIND_ANY     ? "all others"
           : kind == HRBFNPR_LAYER_KIND_HATCH ? "hatching"
                                              : kind_word(layer_name, kind);
}

// Tells whether the picture has marks that the style is for.
bool is_drawn(const App& app, const hrbfnpr_layer_style& style) {
    const auto& layers = app.sheet.mark_layers;
    return layers.empty() || std::any_of(layers.begin(), layers.end(), [&](const auto& layer) {
               return style.kind == HRBFNPR_LAYER_KIND_ANY || style.kind == layer.kind;
           });
}

void edit_range(const Edited& edited, const char* label, const char* begin, const char* end, float low) {
    auto* const from =
        reinterpret_cast<float*>(static_cast<char*>(edited.values) + field_of(edited.c_name, begin).offset);
    auto* const to = reinterpret_cast<float*>(static_cast<char*>(edited.values) + field_of(edited.c_name, end).offset);
    if (!ImGui::DragFloatRange2(label, from, to, 0.005F, low, 1)) return;
    tell_change(edited, begin);
    tell_change(edited, end);
}

void edit_layer(App& app, hrbfnpr_layer_style& layer) {
    const Edited edited{app, layer_name, "style." + kind_word(layer_name, layer.kind), &layer};
    edit_field(edited, "shown");
    slide(edited, "share", "share", 0, 1);
    if (layer.shape == HRBFNPR_SHAPE_HATCH) {
        slide(edited, "hatch_spacing", "spacing", 1, 20);
        slide(edited, "hatch_pen", "pen", 0.1, 4);
        edit_range(edited, "darkness", "hatch_tone_begin", "hatch_tone_end", 0);
        edit_range(edited, "coverage", "hatch_coverage_begin", "hatch_coverage_end", 0.01F);
        slide(edited, "hatch_wobble", "wobble", 0, 8);
    } else {
        slide(edited, "radius", "radius", 0.2, 6, Counts::when_let_go); // the number of marks depends on their size
    }
    edit_field(edited, "ink");
    if (ImGui::TreeNode("all fields")) {
        edit_fields(edited);
        ImGui::TreePop();
    }
}

// Edits all sets of hatching together. A set, such as "hatch-2", has a name.
void edit_sets(App& app) {
    auto& layers = app.sheet.layers;
    const auto set = std::find_if(layers.begin(), layers.end(), [](const auto& layer) {
        return layer.name != nullptr && layer.shape == HRBFNPR_SHAPE_HATCH && layer.shown != 0;
    });
    if (set == layers.end() || !ImGui::TreeNode("sets of hatching")) return;
    const Edited edited{app, layer_name, "style.layers", &*set};
    slide(edited, "hatch_spacing", "spacing", 1, 20);
    slide(edited, "hatch_pen", "pen", 0.1, 4);
    slide(edited, "hatch_wobble", "wobble", 0, 8);
    ImGui::TreePop();
}

void choose_style(App& app) {
    const std::string now = app.scene() != nullptr ? preset_name(app.scene()->info.preset) : app.choices.style;
    if (!ImGui::BeginCombo("style", now.c_str(), ImGuiComboFlags_HeightLargest)) return;
    for (std::uint32_t preset = 0; !preset_name(preset).empty(); ++preset)
        if (ImGui::Selectable(preset_name(preset).c_str(), preset_name(preset) == now))
            app.use_style(preset_name(preset));
    ImGui::EndCombo();
}

// A slider for a choice. At 0 the library chooses.
bool slide_choice(const char* label, double& choice, double high, const char* unset) {
    const double low = 0;
    ImGui::SliderScalar(label, ImGuiDataType_Double, &choice, &low, &high, choice > 0 ? "%.2f pixels" : unset);
    return ImGui::IsItemDeactivatedAfterEdit();
}

} // namespace

void style_panel(App& app) {
    hrbfnpr_style& style = app.sheet.style;
    choose_style(app);
    if (app.scene() == nullptr) return;
    const Edited edited{app, style_name, "style", &style};
    if (slide_choice("pen", app.choices.pen, 5, "automatic")) app.restyle();
    edit_field(edited, "paper");
    if (edit_colour("ink of everything", style.silhouette_ink))
        app.change("style.ink", text_of(field_of(style_name, "silhouette_ink"), &style));
    edit_field(edited, "hidden_lines");
    slide(edited, "halo_width", "halo", 0, 12);
    for (std::size_t i = 0; i < app.sheet.layers.size(); ++i) {
        hrbfnpr_layer_style& layer = app.sheet.layers[i];
        if (layer.name != nullptr || !is_drawn(app, layer)) continue;
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::TreeNode(layer_label(layer.kind).c_str())) {
            edit_layer(app, layer);
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    edit_sets(app);
    if (ImGui::TreeNode("all fields of the style")) {
        edit_fields(edited);
        ImGui::TreePop();
    }
}

namespace {

// The caller's own lines cannot be chosen, and creases only if the model has any.
bool is_choice(std::uint32_t kind, bool has_edges) {
    return kind != HRBFNPR_LINE_KIND_OWN && (kind != HRBFNPR_LINE_KIND_CREASE || has_edges);
}

// Lists kinds of lines with commas between them, as in hrbfnpr_picture_desc.lines.
std::string listed_kinds(const std::vector<hrbfnpr_line_style>& lines, bool has_edges) {
    std::string kinds;
    for (const hrbfnpr_line_style& line : lines) {
        const std::string kind = kind_word(line_name, line.kind);
        const bool is_first =
            std::none_of(lines.data(), &line, [&](const auto& other) { return other.kind == line.kind; });
        if (is_choice(line.kind, has_edges) && is_first) kinds += (kinds.empty() ? "" : ",") + kind;
    }
    return kinds.empty() ? "none" : kinds;
}

void choose_kinds(App& app) {
    auto& lines = app.sheet.lines;
    const Field& kinds = field_of(line_name, "kind");
    const bool has_edges = app.scene()->has_edges();
    int shown = 0;
    for (std::size_t i = 0; i < kinds.choices.size(); ++i) {
        const auto kind = kinds.first_choice + static_cast<std::uint32_t>(i);
        if (!is_choice(kind, has_edges)) continue;
        const auto is_same = [&](const auto& line) { return line.kind == kind; };
        bool on = std::any_of(lines.begin(), lines.end(), is_same);
        if (shown++ % 2 == 1) ImGui::SameLine(0.5F * ImGui::GetContentRegionAvail().x + 8);
        const std::string label = kinds.choices[i].substr(0, kinds.choices[i].find('_'));
        if (!ImGui::Checkbox(label.c_str(), &on)) continue;
        lines.erase(std::remove_if(lines.begin(), lines.end(), is_same), lines.end());
        if (on) {
            lines.push_back(defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init));
            lines.back().kind = kind;
        }
        app.choices.lines = listed_kinds(lines, has_edges);
        app.restyle();
    }
}

} // namespace

void lines_panel(App& app) {
    if (app.scene() == nullptr) return;
    choose_kinds(app);
    if (slide_choice("width of contours", app.choices.line_width, 10, "as in the style")) app.restyle();
    for (std::size_t i = 0; i < app.sheet.lines.size(); ++i) {
        hrbfnpr_line_style& line = app.sheet.lines[i];
        if (!is_choice(line.kind, app.scene()->has_edges())) continue;
        const std::string kind = kind_word(line_name, line.kind);
        const Edited edited{app, line_name, "style." + kind, &line};
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::TreeNode("line", "%s", kind.c_str())) {
            slide(edited, "width", "width", 0.2, 10);
            edit_field(edited, "hidden");
            slide(edited, "outline_factor", "outline", 0.2, 4);
            slide(edited, "wobble", "wobble", 0, 4);
            if (ImGui::TreeNode("all fields")) {
                edit_fields(edited);
                ImGui::TreePop();
            }
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
}

namespace {

// Figure 5: the squares follow the slider at once; the marks follow when the mouse lets go.
void choose_step(App& app, Ui& ui) {
    bool shown = app.patches_shown();
    if (ImGui::Checkbox("show squares of side 2 rho_0", &shown)) app.show_patches(shown);
    const Patches* const patches = app.scene() != nullptr ? &app.scene()->patches : nullptr;
    if (!shown || patches == nullptr || patches->estimate <= 0) return;
    const bool is_given = app.sheet.marks.initial_step > 0;
    ImGui::SliderFloat("rho_0", &ui.step_ratio, 0.1F, 4, "%.2f x estimate", ImGuiSliderFlags_Logarithmic);
    if (ImGui::IsItemDeactivatedAfterEdit()) app.set_step(static_cast<double>(ui.step_ratio) * patches->estimate);
    ImGui::Text("= %.4g (estimate %.4g)", static_cast<double>(ui.step_ratio) * patches->estimate, patches->estimate);
    if (is_given && ImGui::Button("Use the estimate")) app.set_step(0);
}

// Edits all layers of a kind.
void edit_mark_layers(App& app, hrbfnpr_layer_desc& layer, bool published) {
    const Edited edited{app, mark_layer_name, "marks." + kind_word(mark_layer_name, layer.kind), &layer};
    if (published) return slide(edited, "levels", "steps", 0, 7, Counts::when_let_go);
    if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES) {
        slide(edited, "budget", "marks", 100, 400000, Counts::when_let_go);
        edit_field(edited, "density");
    }
    if (layer.kind == HRBFNPR_LAYER_KIND_HATCH) {
        edit_field(edited, "guide");
        const double low = -90, high = 90;
        ImGui::SliderScalar("turned by", ImGuiDataType_Double, &app.choices.hatch_angle, &low, &high, "%.0f degrees");
        if (ImGui::IsItemDeactivatedAfterEdit()) app.restyle();
    }
    if (ImGui::TreeNode("all fields")) {
        edit_fields(edited);
        ImGui::TreePop();
    }
}

} // namespace

void marks_panel(App& app, Ui& ui) {
    auto& marks = app.sheet.marks;
    auto& layers = app.sheet.mark_layers;
    if (app.scene() == nullptr || layers.empty()) return;
    const Edited edited{app, "hrbfnpr_generate_desc", "marks", &marks};
    const bool published = marks.distribution == HRBFNPR_DISTRIBUTION_PUBLISHED;
    const auto& distributions = field_of("hrbfnpr_generate_desc", "distribution").choices;
    if (ImGui::BeginCombo("distribution", distributions[marks.distribution].c_str())) {
        for (const std::string& name : distributions)
            if (ImGui::Selectable(name.c_str())) app.set_distribution(name.c_str());
        ImGui::EndCombo();
    }
    if (published) {
        edit_field(edited, "seed_source", "seeds");
        edit_field(edited, "box_resolution", "cells along the box");
        choose_step(app, ui);
    }
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const auto is_same = [&](const auto& other) { return other.kind == layers[i].kind; };
        if (std::any_of(layers.begin(), layers.begin() + static_cast<std::ptrdiff_t>(i), is_same)) continue;
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::TreeNodeEx("layer", ImGuiTreeNodeFlags_DefaultOpen, "%s", layer_label(layers[i].kind).c_str())) {
            edit_mark_layers(app, layers[i], published);
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
    if (ImGui::Button("Automatic: as the style needs")) app.forget_marks();
}

void light_panel(App& app) {
    if (app.scene() == nullptr) return;
    const Edited edited{app, style_name, "style", &app.sheet.style};
    edit_field(edited, "tone");
    slide(edited, "occlusion_lights", "occlusion", 0, 1, Counts::when_let_go);
    slide(edited, "light_shadow", "cast shadows", 0, 1, Counts::when_let_go);
    slide(edited, "light_softness", "softness of shadows", 0, 0.3, Counts::when_let_go);
    slide(edited, "fill_light", "fill light", 0, 1);
    slide(edited, "rim_light", "rim light", 0, 1);
    edit_field(edited, "light", "direction to the light");
    edit_field(edited, "light_space");
    ImGui::TextWrapped("Drag the ball in the corner of the picture to turn the light.");
    if (!ImGui::TreeNode("tone law")) return;
    slide(edited, "tone_exponent", "tone exponent", 0.1, 4);
    slide(edited, "tone_black", "black point", 0, 0.9);
    slide(edited, "tone_white", "white point", 0.1, 2);
    slide(edited, "tone_gamma", "gamma", 0.2, 4);
    slide(edited, "tone_steps", "flat tones", 0, 6);
    ImGui::TreePop();
}

} // namespace viewer
