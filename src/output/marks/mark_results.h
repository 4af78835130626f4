// SPDX-License-Identifier: MIT
// A drawing as numbers for the marks of a point set, in the set's own order.
#pragma once

#include "base/runtime.h"
#include "base/view.h"
#include "output/vertex/vertices.h"

#include <cstdint>

namespace hrbfnpr::output {

// Views of as many elements as the layer has marks, or empty.
struct MarkViews {
    base::OutView shown, radius, opacity;
};

// run: a layer of an item, by its number in drawing.runs.
void write_mark_results(const drawing::Drawing& drawing, std::int64_t run, const MarkViews& views);

// Numbers of marks, as hrbfnpr_drawing_write_mark_indices says.
class MarkIndices {
public:
    explicit MarkIndices(const base::Runtime& runtime) noexcept
        : runtime_(runtime), order_(runtime.memory), keys_(runtime.memory), shown_(runtime.memory),
          indices_(runtime.memory) {}

    // Valid until the next call.
    [[nodiscard]] std::span<const std::uint32_t> of(const drawing::Drawing& drawing, std::int64_t run,
                                                    drawing::MarkClass mark_class, Primitive primitive);

private:
    const base::Runtime& runtime_;
    drawing::FarToNear order_;
    base::Array<std::uint64_t> keys_; // one for each mark that is shown: its depth and its number
    base::Array<std::uint8_t> shown_; // one for each mark of the layer: 1 if it is shown, else 0
    base::Array<std::uint32_t> indices_;
};

} // namespace hrbfnpr::output
