// SPDX-License-Identifier: MIT
// Chooses a few inks for the colours of marks.
#pragma once

#include "picture/handles.h"
#include "picture/memory.h"

#include <array>

namespace hrbfnpr::picture {

// Adds the colours that marks have, but only those of an even part if there are many. Marks without a colour add none.
void add_colours(const PointSet& marks, const char* field, Vector<std::array<float, 3>>& colours);

// Returns up to three inks, straight sRGB, or up to eight if there are no more hues, as those of a few parts. Their
// hues are the middles of groups of similar hues [k-means in Oklab]. They are rather dark, because the paper between
// the marks makes them light again. There must be a colour.
[[nodiscard]] Vector<std::array<float, 4>> inks_of(const Vector<std::array<float, 3>>& colours, Pool& pool);

} // namespace hrbfnpr::picture
