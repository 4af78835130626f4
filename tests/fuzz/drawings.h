// SPDX-License-Identifier: MIT
// Everything that can be done with any drawing, and the conditions that each drawing must meet.
#pragma once

#include "fuzz.h"
#include "input.h"

#include <limits>
#include <string>
#include <string_view>

namespace fuzz {

void require_sound_drawing(const hrbfnpr_drawing* drawing);
// Rasterizes to an image of any format, about as large as the camera's viewport, with depth, ids and classes.
void rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_camera& camera, Input& input);
void write_vertices(const hrbfnpr_drawing* drawing, Input& input);
// Asks how marks are drawn, for their indices, and which mark an id identifies.
void ask_for_marks(const hrbfnpr_drawing* drawing, Input& input);
// Writes a page of one drawing in any format.
void write_page(const hrbfnpr_drawing* drawing, Input& input);

// A page as bytes, with the number of bytes after which the writer fails.
struct Written {
    std::string bytes;
    std::size_t fails_at = std::numeric_limits<std::size_t>::max();

    static std::int32_t write(void* user, const void* data, std::uint64_t size);
};

// Checks the properties of a page on which a reader of the format relies.
void require_sound_page(std::string_view page, const hrbfnpr_page_desc& desc);

} // namespace fuzz
