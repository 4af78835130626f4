// SPDX-License-Identifier: MIT
// From marks to places on the screen and classes; and which of them are drawn.     [NPAR 6, 6.2]
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "frame/scene/scene.h"
#include "published/visibility.h"

namespace hrbfnpr::published {

using namespace frame; // the scene that this room classifies and paints

// Fills every array of scene.marks but `role`; tau only where the style's tone is not a callback.
void classify(const base::Parallel& parallel, Scene& scene);

// Asks the styles' tone callbacks for tau of the front marks that need one, on this thread.
void ask_tones(Scene& scene, ToneCalls& calls);

// Fills `role` from tone, depth, zoom and, if not null, visibility.  counts: one for each chunk.
void decide(const base::Parallel& parallel, Scene& scene, const VisibilityMap* visibility, base::Array<Counts>& counts);

} // namespace hrbfnpr::published
