// SPDX-License-Identifier: MIT
// Proves which lines of a view are visible. Rays that only evaluate the model's function go from places of each hidden
// and each visible run of pieces to the eye, or to the cutting plane. Runs that rays contradict are divided and drawn
// as the rays show them. This finds what the steps before leave: edges close behind a surface, and gaps that are too
// narrow for them.
#pragma once

#include "picture/lines.h"
#include "picture/view_layout.h"
#include "picture/view_lines.h"
#include "picture/view_order.h"

namespace hrbfnpr::picture {

// Compares the curves that have places with rays, and repairs them. Sets ViewCurve::sure of the pieces that rays agree
// with. `plane` is the cutting plane of a section, or null. `scale` is in mm per unit of the model.
[[nodiscard]] LineProof verify_curves(Vector<ViewCurve>& curves, const SheetView& view, const CutPlane* plane,
                                      const Solid& solid, double scale, hrbfnpr_operation* operation, Pool& pool);

} // namespace hrbfnpr::picture
