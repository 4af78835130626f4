// SPDX-License-Identifier: MIT
// Everything that the library writes, into files: written whole, or not at all.
#pragma once

#include "scene.h"

namespace viewer {

void write_png(const std::string& path, const std::vector<std::uint8_t>& rgba, Size size);

// What is written: the scene's surfaces by these choices, in this size.
struct Export {
    Scene scene;
    Choices choices;
    std::optional<View> view; // else as the library plans it
    Size size;
};

// By the ending of the name: .png, .svg, .pdf, .hpgl, .gcode a picture; .hrbf the model; .hrbm the marks; .json
// settings.
void write_export(const Export& what, const std::string& path, Work& work);
// A turn of so many pictures.
void write_turntable(const Export& what, const std::string& pattern, int frames, Work& work);

// Throws where an ending is none of these.
void check_ending(const std::string& path);
// "frame.png" or "frame-%03d.png" and a number: "frame-007.png".  A Failure if the pattern is none.
std::string numbered(const std::string& pattern, int number);

} // namespace viewer
