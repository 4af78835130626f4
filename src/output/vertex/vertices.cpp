// SPDX-License-Identifier: MIT
#include "output/vertex/vertices.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hrbfnpr::output {
namespace {

constexpr std::int64_t grain = 4096;

using base::Scalar;
using drawing::Dot;
using drawing::Drawing;
using drawing::Stroke;
using drawing::StrokePoint;

template <class T>
void put(std::byte*& to, T value) noexcept {
    std::memcpy(to, &value, sizeof value); // a layout need not be aligned
    to += sizeof value;
}

void put_vector(std::byte* to, const glm::vec3& v) noexcept {
    for (int i = 0; i < 3; ++i) put(to, v[i]);
}

void put_integer(std::byte* to, Scalar scalar, std::uint32_t value) noexcept {
    if (scalar == Scalar::uint8)
        put(to, static_cast<std::uint8_t>(value));
    else
        put(to, value);
}

void put_color(std::byte* to, Scalar scalar, const glm::vec4& color) noexcept {
    for (int i = 0; i < 4; ++i) {
        if (scalar == Scalar::uint8)
            put(to, static_cast<std::uint8_t>(std::clamp(color[i], 0.0F, 1.0F) * 255.0F + 0.5F));
        else
            put(to, color[i]);
    }
}

// All that a vertex can carry; what is known of its mark is asked for once, if any field wants it.
struct Vertex {
    glm::vec3 window;
    float radius, length;
    glm::vec4 color;
    std::uint32_t id, layer;
    drawing::MarkClass mark_class;
    bool is_paper;
    drawing::MarkSource source;
};

void put_field(std::byte* to, const VertexField& field, const Vertex& vertex) noexcept {
    switch (field.attribute) {
    case VertexAttribute::position: put_vector(to, vertex.source.position); break;
    case VertexAttribute::window: put_vector(to, vertex.window); break;
    case VertexAttribute::radius: put(to, vertex.radius); break;
    case VertexAttribute::color: put_color(to, field.scalar, vertex.color); break;
    case VertexAttribute::normal: put_vector(to, vertex.source.normal); break;
    case VertexAttribute::direction: put_vector(to, vertex.source.direction); break;
    case VertexAttribute::id: put(to, vertex.id); break;
    case VertexAttribute::mark_class:
        put_integer(to, field.scalar, static_cast<std::uint32_t>(vertex.mark_class));
        break;
    case VertexAttribute::is_paper: put_integer(to, field.scalar, vertex.is_paper ? 1U : 0U); break;
    case VertexAttribute::layer: put(to, vertex.layer); break;
    case VertexAttribute::length: put(to, vertex.length); break;
    }
}

[[nodiscard]] bool wants_source(std::span<const VertexField> fields) noexcept {
    return std::any_of(fields.begin(), fields.end(), [](const VertexField& field) {
        return field.attribute == VertexAttribute::position || field.attribute == VertexAttribute::normal ||
               field.attribute == VertexAttribute::direction;
    });
}

class Writer {
public:
    Writer(const Drawing& drawing, const VertexLayout& layout, std::byte* vertices) noexcept
        : drawing_(drawing), layout_(layout), vertices_(vertices), sources_(wants_source(layout.fields)) {}

    void dot(std::int64_t number, const Dot& dot) const noexcept {
        const bool is_paper = (dot.flags & drawing::dot_is_paper) != 0;
        Vertex vertex{
            {dot.x, dot.y, dot.window}, dot.radius, 0.0F, {}, dot.id, dot.layer, dot.mark_class, is_paper, {}};
        vertex.color = is_paper ? drawing_.paper : drawing_.layers[dot.layer].ink;
        vertex.color.w = is_paper ? dot.opacity : vertex.color.w * dot.opacity;
        store(number, vertex);
    }

    // side: from the stroke's centre line.
    void point(std::int64_t number, const Stroke& stroke, const StrokePoint& p, const glm::vec2& side) const noexcept {
        const drawing::Layer& layer = drawing_.layers[stroke.layer];
        Vertex vertex{{p.x + side.x, p.y + side.y, p.window},
                      p.radius,
                      p.length,
                      layer.ink,
                      p.id,
                      stroke.layer,
                      layer.mark_class,
                      false,
                      {}};
        vertex.color.w *= p.opacity;
        store(number, vertex);
    }

private:
    void store(std::int64_t number, Vertex& vertex) const noexcept {
        if (sources_) vertex.source = drawing_.source(vertex.id);
        for (const VertexField& field : layout_.fields)
            put_field(vertices_ + number * layout_.stride + field.offset, field, vertex);
    }

    const Drawing& drawing_;
    const VertexLayout& layout_;
    std::byte* vertices_;
    bool sources_;
};

// Half the width of a stroke across its direction at a point: half way between those of the two segments, and so much
// wider that both keep their width, but at most twice.
[[nodiscard]] glm::vec2 side_at(std::span<const StrokePoint> points, std::size_t i) noexcept {
    const auto across = [&](std::size_t a, std::size_t b) {
        const glm::vec2 along(points[b].x - points[a].x, points[b].y - points[a].y);
        const float length = glm::length(along);
        return length > 0.0F ? glm::vec2(along.y, -along.x) / length : glm::vec2(0.0F);
    };
    const glm::vec2 before = across(i == 0 ? 0 : i - 1, i == 0 ? 1 : i);
    const glm::vec2 after = i + 1 < points.size() ? across(i, i + 1) : before;
    const glm::vec2 sum = before + after;
    const float square = glm::dot(sum, sum);
    const glm::vec2 miter = square > 1e-12F ? sum * (2.0F / std::max(square, 1.0F)) : before;
    return miter * points[i].radius;
}

void write_dots(const base::Runtime& runtime, const Drawing& drawing, VertexScratch& scratch, const Writer& writer) {
    if (drawing.painting == drawing::Painting::published) {
        runtime.parallel.for_chunks(drawing.dots.size(), grain, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) writer.dot(i, drawing.dots[i]);
        });
        return;
    }
    scratch.keys.clear();
    scratch.keys.reserve(drawing.dot_count);
    for (const drawing::Piece& piece : drawing.dot_pieces)
        for (std::int64_t i = piece.begin; i < piece.end; ++i)
            if (const Dot& dot = drawing.dots[i]; dot.opacity > 0.0F)
                scratch.keys.push_back(drawing::far_first_key(dot.depth, static_cast<std::uint32_t>(i)));
    scratch.order.sort(runtime.parallel, scratch.keys);
    runtime.parallel.for_chunks(scratch.keys.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            writer.dot(i, drawing.dots[static_cast<std::uint32_t>(scratch.keys[i])]);
    });
}

// Strokes stand far to near already.  `sides` vertices for each point, after those of the strokes before.
void write_strokes(const base::Runtime& runtime, const Drawing& drawing, std::int64_t sides, const Writer& writer) {
    constexpr std::int64_t strokes_at_a_time = 64;
    runtime.parallel.for_chunks(drawing.strokes.size(), strokes_at_a_time, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t s = begin; s < end; ++s) {
            const Stroke& stroke = drawing.strokes[s];
            const auto points = drawing.points.span().subspan(static_cast<std::size_t>(stroke.first),
                                                              static_cast<std::size_t>(stroke.count));
            for (std::size_t i = 0; i < points.size(); ++i) {
                const std::int64_t at = sides * (stroke.first + static_cast<std::int64_t>(i));
                if (sides == 1) {
                    writer.point(at, stroke, points[i], glm::vec2(0.0F));
                    continue;
                }
                const glm::vec2 side = side_at(points, i);
                writer.point(at, stroke, points[i], side);
                writer.point(at + 1, stroke, points[i], -side);
            }
        }
    });
}

void write_indices(const Drawing& drawing, Primitive primitive, std::uint32_t* to) noexcept {
    if (primitive == Primitive::points) {
        const std::int64_t count = vertex_bound(drawing, primitive).vertices;
        for (std::int64_t i = 0; i < count; ++i) *to++ = static_cast<std::uint32_t>(i);
        return;
    }
    const std::int64_t sides = primitive == Primitive::triangle_strips ? 2 : 1;
    for (const Stroke& stroke : drawing.strokes) {
        for (std::int64_t i = sides * stroke.first; i < sides * (stroke.first + stroke.count); ++i)
            *to++ = static_cast<std::uint32_t>(i);
        *to++ = index_restart;
    }
}

} // namespace

std::int64_t size_of(const VertexField& field) noexcept {
    const bool is_float = field.scalar == Scalar::float32;
    const bool is_byte = field.scalar == Scalar::uint8;
    const bool is_integer = field.scalar == Scalar::uint32;
    switch (field.attribute) {
    case VertexAttribute::position:
    case VertexAttribute::window:
    case VertexAttribute::normal:
    case VertexAttribute::direction: return is_float ? 12 : 0;
    case VertexAttribute::radius:
    case VertexAttribute::length: return is_float ? 4 : 0;
    case VertexAttribute::color: return is_float ? 16 : is_byte ? 4 : 0;
    case VertexAttribute::id:
    case VertexAttribute::layer: return is_integer ? 4 : 0;
    case VertexAttribute::mark_class:
    case VertexAttribute::is_paper: return is_byte ? 1 : is_integer ? 4 : 0;
    }
    return 0;
}

VertexBound vertex_bound(const Drawing& drawing, Primitive primitive) noexcept {
    if (primitive == Primitive::points) {
        const std::int64_t dots =
            drawing.painting == drawing::Painting::published ? drawing.dots.size() : drawing.dot_count;
        return {dots, dots};
    }
    const std::int64_t sides = primitive == Primitive::triangle_strips ? 2 : 1;
    const std::int64_t vertices = sides * drawing.points.size();
    return {vertices, vertices + drawing.strokes.size()};
}

void write_vertices(const base::Runtime& runtime, const Drawing& drawing, VertexScratch& scratch,
                    const VertexLayout& layout, std::byte* vertices, std::uint32_t* indices) {
    const Writer writer(drawing, layout, vertices);
    if (layout.primitive == Primitive::points)
        write_dots(runtime, drawing, scratch, writer);
    else
        write_strokes(runtime, drawing, layout.primitive == Primitive::triangle_strips ? 2 : 1, writer);
    if (indices != nullptr) write_indices(drawing, layout.primitive, indices);
}

} // namespace hrbfnpr::output
