// SPDX-License-Identifier: MIT
// Editors for the fields of descriptors.
#include "fields.h"
#include "ui.h"

#include <algorithm>
#include <cctype>

namespace viewer {

namespace {

char* at(void* values, const Field& field) { return static_cast<char*>(values) + field.offset; }

bool edit_choice(const Field& field, void* value, const char* label) {
    auto& number = *static_cast<std::uint32_t*>(value);
    const std::size_t now = number - field.first_choice;
    bool changed = false;
    if (!ImGui::BeginCombo(label, now < field.choices.size() ? field.choices[now].c_str() : "?")) return false;
    for (std::size_t i = 0; i < field.choices.size(); ++i)
        if (ImGui::Selectable(field.choices[i].c_str(), i == now)) {
            number = field.first_choice + static_cast<std::uint32_t>(i);
            changed = true;
        }
    ImGui::EndCombo();
    return changed;
}

template <class Number>
bool edit_number(ImGuiDataType type, void* value, int count, const char* label, const char* format) {
    const double size = std::abs(static_cast<double>(*static_cast<Number*>(value)));
    const bool whole = type != ImGuiDataType_Float && type != ImGuiDataType_Double;
    const float speed =
        whole ? static_cast<float>(std::max(0.2, 0.01 * size)) : static_cast<float>(std::max(0.002, 0.01 * size));
    return ImGui::DragScalarN(label, type, value, count, speed, nullptr, nullptr, format);
}

bool is_switch(const Field& field) { return field.name == "shown" || field.name == "contours"; }

bool edit(const Field& field, void* values, const char* label) {
    void* const value = at(values, field);
    const int count = static_cast<int>(field.count);
    if (!field.choices.empty()) return edit_choice(field, value, label);
    if (field.type == "float" && count == 4) return edit_colour(label, static_cast<float*>(value));
    if (field.type == "float") return edit_number<float>(ImGuiDataType_Float, value, count, label, "%.3g");
    if (field.type == "double") return edit_number<double>(ImGuiDataType_Double, value, count, label, "%.4g");
    if (field.type == "int32_t") return edit_number<std::int32_t>(ImGuiDataType_S32, value, count, label, nullptr);
    if (field.type == "int64_t") return edit_number<std::int64_t>(ImGuiDataType_S64, value, count, label, nullptr);
    if (field.type == "uint64_t") return edit_number<std::uint64_t>(ImGuiDataType_U64, value, count, label, nullptr);
    if (field.type == "const char*") return false; // names are not edited
    if (is_switch(field)) {
        bool on = *static_cast<std::uint32_t*>(value) != 0;
        const bool changed = ImGui::Checkbox(label, &on);
        *static_cast<std::uint32_t*>(value) = on ? 1 : 0;
        return changed;
    }
    return edit_number<std::uint32_t>(ImGuiDataType_U32, value, count, label, nullptr);
}

// Writes "tone_exponent" as "tone exponent".
std::string in_words(const std::string& name) {
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

} // namespace

bool edit_colour(const char* label, float* rgba) {
    return ImGui::ColorEdit4(label, rgba, ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_AlphaPreviewHalf);
}

void tell_change(const Edited& edited, const char* field) {
    edited.app.change(edited.path + "." + field, text_of(field_of(edited.c_name, field), edited.values));
}

void edit_field(const Edited& edited, const char* field, const char* label) {
    const std::string words = label != nullptr ? label : in_words(field);
    if (edit(field_of(edited.c_name, field), edited.values, words.c_str())) tell_change(edited, field);
}

void edit_fields(const Edited& edited) {
    for (const Field& field : fields_of(edited.c_name))
        if (field.name != "kind" && edit(field, edited.values, in_words(field.name).c_str()))
            tell_change(edited, field.name.c_str());
}

void slide(const Edited& edited, const char* field_name, const char* label, double low, double high, Counts counts,
           const char* format) {
    const Field& field = field_of(edited.c_name, field_name);
    void* const value = at(edited.values, field);
    bool moved = false;
    if (field.type == "float") {
        moved = ImGui::SliderFloat(label, static_cast<float*>(value), static_cast<float>(low), static_cast<float>(high),
                                   format != nullptr ? format : "%.3f");
    } else if (field.type == "double") {
        moved = ImGui::SliderScalar(label, ImGuiDataType_Double, value, &low, &high, format);
    } else if (field.type == "int64_t") {
        const auto first = static_cast<std::int64_t>(low), last = static_cast<std::int64_t>(high);
        moved =
            ImGui::SliderScalar(label, ImGuiDataType_S64, value, &first, &last, format, ImGuiSliderFlags_Logarithmic);
    } else {
        const auto first = static_cast<std::int32_t>(low), last = static_cast<std::int32_t>(high);
        moved = ImGui::SliderScalar(label, ImGuiDataType_S32, value, &first, &last, format);
    }
    if (counts == Counts::always ? moved : ImGui::IsItemDeactivatedAfterEdit()) tell_change(edited, field_name);
}

} // namespace viewer
