// SPDX-License-Identifier: MIT
// Writes the library's results to files. A file is written whole, or not at all.
#pragma once

#include "scene.h"

namespace viewer {

void write_png(const std::string& path, const std::vector<std::uint8_t>& rgba, Size size);

// The data for a file: the scene's surfaces, drawn with these choices and in this size.
struct Export {
    Scene scene;
    Choices choices;
    std::optional<View> view; // empty: the view that the library plans
    Size size;
};

// The ending of the name decides: .png, .svg, .pdf, .hpgl, .gcode and .dxf write a picture, .hrbf the model, .hrbm the
// marks, .json the settings.
void write_export(const Export& what, const std::string& path, Work& work);
// Writes one turn of the camera in `frames` pictures.
void write_turntable(const Export& what, const std::string& pattern, int frames, Work& work);

// Throws if the ending is none of these.
void check_ending(const std::string& path);
// Inserts a number into a pattern "frame.png" or "frame-%03d.png": "frame-007.png". Throws a Failure if the pattern is
// wrong.
std::string numbered(const std::string& pattern, int number);

} // namespace viewer
