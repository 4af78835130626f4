// SPDX-License-Identifier: MIT
// Vertex arrays in any layout: the dots and strokes of a drawing, for a host that draws them.
#pragma once

#include "base/runtime.h"
#include "base/view.h"
#include "drawing/drawing.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::output {

// The values equal those of hrbfnpr_vertex_layout.primitive.
enum class Primitive : std::uint32_t { points = 1, line_strips = 2, triangle_strips = 3 };
// An index with this value ends a strip.
inline constexpr std::uint32_t index_restart = 0xFFFFFFFFU;

// The values equal those of hrbfnpr_vertex_attribute.attribute.
enum class VertexAttribute : std::uint32_t {
    position = 0,
    window = 1,
    radius = 2,
    color = 3,
    normal = 4,
    direction = 5,
    id = 6,
    mark_class = 7,
    is_paper = 8,
    layer = 9,
    length = 10,
    hidden_layers = 11,
    hidden_by = 12,
    line = 13
};
inline constexpr std::uint32_t last_attribute = 13;

struct VertexField {
    VertexAttribute attribute;
    base::Scalar scalar;
    std::uint32_t offset;
};

// Returns the number of bytes of a field; 0 if the attribute cannot have that type.
[[nodiscard]] std::int64_t size_of(const VertexField& field) noexcept;

struct VertexBound {
    std::int64_t vertices, indices;
};
[[nodiscard]] VertexBound vertex_bound(const drawing::Drawing& drawing, Primitive primitive) noexcept;

struct VertexLayout {
    Primitive primitive;
    std::span<const VertexField> fields; // already checked at the API boundary
    std::int64_t stride;
};

struct VertexScratch {
    explicit VertexScratch(const base::Runtime& runtime) noexcept
        : order(runtime.memory), keys(runtime.memory), shown(runtime.memory), indices(runtime.memory) {}

    drawing::DepthSort order;
    base::Array<std::uint64_t> keys; // sort keys of depth and index, for each shown dot or mark
    base::Array<std::uint8_t> shown; // one flag for each mark of a run: 1 if it is shown, else 0
    base::Array<std::uint32_t> indices;
};

// Writes exactly vertex_bound() vertices and indices. `indices` may be NULL.
void write_vertices(const base::Runtime& runtime, const drawing::Drawing& drawing, VertexScratch& scratch,
                    const VertexLayout& layout, std::byte* vertices, std::uint32_t* indices);

// ---- Results of a drawing for each mark of a point set, in the order of the set

// Each view has one element for each mark of the layer, or is empty.
struct MarkViews {
    base::OutView shown, radius, opacity;
};

// Writes the results of one run. `run` is an index into drawing.runs; a run is one layer of an item.
void write_mark_results(const drawing::Drawing& drawing, std::int64_t run, const MarkViews& views);

// Returns the indices of marks, as hrbfnpr_drawing_write_mark_indices documents. They are valid until the scratch is
// used again.
[[nodiscard]] std::span<const std::uint32_t> mark_indices(const base::Runtime& runtime, const drawing::Drawing& drawing,
                                                          std::int64_t run, drawing::MarkClass mark_class,
                                                          Primitive primitive, VertexScratch& scratch);

} // namespace hrbfnpr::output
