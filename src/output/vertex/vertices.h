// Vertex arrays in any layout: the discs of a frame for a host that draws them itself.
#pragma once

#include "base/runtime.h"
#include "base/view.h"
#include "frame/frame.h"

#include <span>

namespace hrbfnpr::output {

// Same numbers as HRBFNPR_VERTEX_...
enum class VertexAttribute : std::uint32_t {
    position = 0,
    window = 1,
    radius = 2,
    color = 3,
    normal = 4,
    direction = 5,
    id = 6,
    mark_class = 7,
    is_paper = 8
};

struct VertexField {
    VertexAttribute attribute;
    base::Scalar scalar;
    std::uint32_t offset;
};

// Bytes that a field takes; 0 if the attribute cannot have that type.
[[nodiscard]] std::int64_t size_of(const VertexField& field) noexcept;

// destination has room for discs().size() vertices of `stride` bytes; fields were checked by the boundary.
void write_vertices(const base::Runtime& runtime, const frame::Frame& frame, std::span<const VertexField> fields,
                    std::int64_t stride, std::byte* destination);

} // namespace hrbfnpr::output
