// SPDX-License-Identifier: MIT
// The roots of f in spans of lines, counted from f and its slope along the lines.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "curves/near_spans.h"
#include "implicit/implicit.h"

namespace hrbfnpr::curves {

struct RootCount {
    std::int32_t roots = 0;
    bool certain = true;          // false: f touches 0, or is no number somewhere
    bool negative_at_end = false; // f
    bool negative_at_begin = false;
};

// A root of a span lies between these places of its line, and no other.
struct Root {
    std::int64_t span;
    double low, high;
    double at;            // about there
    bool negative_at_low; // f
};

// Of each span; count is resized.  roots: null, or where those that are certain are put.
void count_roots(const base::Runtime& runtime, const implicit::Implicit& implicit, const base::Array<Line>& lines,
                 const Spans& spans, base::Array<RootCount>& count, base::Array<Root>* roots,
                 const base::Progress& progress);

} // namespace hrbfnpr::curves
