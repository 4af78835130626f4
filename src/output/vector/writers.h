// SPDX-License-Identifier: MIT
// The writers of pages: SVG 1.1 with Inkscape's layers; PDF 1.5 whose groups are optional content; HPGL as HP's 7400
// series of plotters reads it, or G-code [ISO 6983-1], by settings.format.
#pragma once

#include "io/stream.h"
#include "output/vector/page.h"

#include <memory>

namespace hrbfnpr::output {

// A writer refers to all that it is given, and counts its lines and dots.
using MakeWriter = std::unique_ptr<PageSink>(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                             const PageSettings& settings, PageCounts& counts);
MakeWriter svg_writer;
MakeWriter pdf_writer;
MakeWriter plotter_writer;

} // namespace hrbfnpr::output
