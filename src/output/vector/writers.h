// SPDX-License-Identifier: MIT
// The writers of pages, one for each format: SVG 1.1 with Inkscape's layers; PDF 1.5 whose groups are optional content;
// HPGL as HP's 7400 series of plotters reads it; G-code [ISO 6983-1] for plotters.
#pragma once

#include "io/stream.h"
#include "output/vector/pen.h"

#include <memory>

namespace hrbfnpr::output {

struct WriterSettings {
    ShapeSettings shapes;
    PenSpeeds speeds;
    const char* pen_down = nullptr; // lines of G-code; NULL: its own
    const char* pen_up = nullptr;
};

[[nodiscard]] constexpr bool is_plotter(PageFormat format) noexcept {
    return format == PageFormat::hpgl || format == PageFormat::gcode;
}

// A writer refers to all that it is given, and counts what it writes.
[[nodiscard]] std::unique_ptr<PageSink> svg_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                                   const ShapeSettings& settings, PageCounts& counts);
[[nodiscard]] std::unique_ptr<PageSink> pdf_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                                   const ShapeSettings& settings, PageCounts& counts);
[[nodiscard]] std::unique_ptr<PageSink> plotter_writer(PageFormat format, base::Memory& memory, io::Writer& writer,
                                                       const PageInfo& page, const WriterSettings& settings,
                                                       PageCounts& counts);

} // namespace hrbfnpr::output
