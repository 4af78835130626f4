// SPDX-License-Identifier: MIT
// What a drawing is made with, and its file (docs/settings.md).
#pragma once

#include "camera.h"
#include "fields.h"
#include "paint.h"

namespace viewer {

struct Style {
    hrbfnpr_style fields;
    std::vector<hrbfnpr_layer_style> layers;
    std::vector<hrbfnpr_line_style> lines;
};

Style preset_style(std::uint32_t preset);
// For a pen of this radius in place of one pixel.
Style sized(const Style& style, double pen);
// With its lists in their places: valid while the style stays where it is.
hrbfnpr_style pointed(const Style& style);
std::vector<hrbfnpr_layer_desc> preset_layers(std::uint32_t preset, std::uint32_t distribution);

struct Settings {
    Settings();

    std::uint32_t preset = HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    Size size;                // 0: that of the window
    double pen = 0;           // pixels; 0 = by the picture's size
    std::optional<View> view; // else the model fills the picture
    Style style;
    hrbfnpr_generate_desc marks;
    std::vector<hrbfnpr_layer_desc> layers; // empty: those of the style, filled for the picture
    hrbfnpr_fit_desc fit;
    hrbfnpr_mesh_fit_desc mesh_fit;
    hrbfnpr_line_set_desc line_set;
    std::vector<hrbfnpr_line_desc> lines; // empty: those that the style draws
    std::vector<Dab> paint;
};

void set_preset(Settings& settings, std::uint32_t preset);

Json to_json(const Settings& settings);
Settings settings_from_json(const Json& json);

Settings read_settings(const std::string& path);
void write_settings(const Settings& settings, const std::string& path);

std::string preset_name(std::uint32_t preset);
std::uint32_t preset_of(const std::string& name, const std::string& where);

std::string settings_text(const Settings& settings); // on one line
// Every section, its fields, and the words that they can be: what the Python package agrees with.
std::string schema_text();

} // namespace viewer
