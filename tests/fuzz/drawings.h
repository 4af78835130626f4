// SPDX-License-Identifier: MIT
// What can be done with any drawing, and what holds for each.
#pragma once

#include "fuzz.h"
#include "input.h"

#include <limits>
#include <string>
#include <string_view>

namespace fuzz {

void require_sound_drawing(const hrbfnpr_drawing* drawing);
// As an image of any format, about as large as the camera's viewport, with depth, ids and classes.
void rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_camera& camera, Input& input);
void write_vertices(const hrbfnpr_drawing* drawing, Input& input);
// How marks are drawn, their indices, and which one an id stands for.
void ask_for_marks(const hrbfnpr_drawing* drawing, Input& input);
// A page of one drawing in any format.
void write_page(const hrbfnpr_drawing* drawing, Input& input);

// A page as bytes: what a writer got, and how many bytes it takes until it fails.
struct Written {
    std::string bytes;
    std::size_t fails_at = std::numeric_limits<std::size_t>::max();

    static std::int32_t write(void* user, const void* data, std::uint64_t size);
};

// What a reader of the format relies on.
void require_sound_page(std::string_view page, const hrbfnpr_page_desc& desc);

} // namespace fuzz
