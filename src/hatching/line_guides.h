// SPDX-License-Identifier: MIT
// Lines by other laws than curvature.
#pragma once

#include "hatching/line_field.h"

namespace hrbfnpr::hatching {

// Mixes the named guide into that by curvature: as exp(2 i angle), by guide_weight.
void mix_named_guide(const SampleGraph& graph, const base::Array<Bend>& bend, const FieldSettings& settings,
                     base::Array<Complex>& guide);

} // namespace hrbfnpr::hatching
