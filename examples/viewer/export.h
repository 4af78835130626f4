// SPDX-License-Identifier: MIT
// Everything that the library writes, into files: written whole, or not at all.
#pragma once

#include "frame.h"

namespace viewer {

void write_png(const std::string& path, const std::vector<std::uint8_t>& rgba, Size size);

// By its ending: .png, .svg, .pdf, .hpgl, .gcode a picture; .hrbf the model; .hrbm the marks; .json settings.
// Throws where the ending is none of these.
struct Export {
    const Context& context;
    const Renderer& renderer;
    const Surface& surface;
    const Ink& ink;
    const Settings& settings; // with a view
    const PaintedMap& tone;
    Size size;
};
void write_export(const Export& what, const std::string& path);

// "frame.png" or "frame-%03d.png" and a number: "frame-007.png".  A Failure if the pattern is none.
std::string numbered(const std::string& pattern, int number);

} // namespace viewer
