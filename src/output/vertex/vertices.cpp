// SPDX-License-Identifier: MIT
#include "output/vertex/vertices.h"

#include "base/assert.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace hrbfnpr::output {
namespace {

constexpr std::int64_t dots_a_task = 4096;
constexpr std::int64_t strokes_a_task = 64;

using base::Scalar;
using drawing::Dot;
using drawing::Drawing;
using drawing::Stroke;
using drawing::StrokePoint;

template <class T>
void put(std::byte*& to, T value) noexcept {
    std::memcpy(to, &value, sizeof value); // memcpy, because the fields of a layout may be unaligned
    to += sizeof value;
}

void put_vector(std::byte* to, const glm::vec3& v) noexcept {
    for (int i = 0; i < 3; ++i) put(to, v[i]);
}

void put_integer(std::byte* to, Scalar scalar, std::uint32_t value) noexcept {
    scalar == Scalar::uint8 ? put(to, static_cast<std::uint8_t>(value)) : put(to, value);
}

void put_color(std::byte* to, Scalar scalar, const glm::vec4& color) noexcept {
    for (int i = 0; i < 4; ++i) {
        const float value = color[i];
        scalar == Scalar::uint8 ? put(to, static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F))
                                : put(to, value);
    }
}

// The scalar types that an attribute may have.
struct AttributeType {
    std::int64_t components;
    bool as_float, as_byte, as_word;
};
constexpr AttributeType vector3{3, true, false, false}, scalar{1, true, false, false}, color4{4, true, true, false},
    word{1, false, false, true}, small{1, false, true, true};
constexpr std::array<AttributeType, last_attribute + 1> attribute_types{
    vector3, vector3, scalar, color4, vector3, vector3, word, small, small, word, scalar, word, word, word};

// All attributes of a vertex. `source` is filled only if a field needs data of the vertex's mark.
struct Vertex {
    glm::vec3 window;
    float radius, length;
    glm::vec4 color;
    std::uint32_t id, layer, line;
    drawing::MarkClass mark_class;
    bool is_paper;
    drawing::MarkSource source;
    bool off_mark = false; // whether the vertex is not at the place of its mark
    std::uint32_t hidden_layers = 0;
    std::uint32_t hidden_by = index_restart; // index_restart: no layer hides the vertex
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
    case VertexAttribute::hidden_layers: put(to, vertex.hidden_layers); break;
    case VertexAttribute::hidden_by: put(to, vertex.hidden_by); break;
    case VertexAttribute::line: put(to, vertex.line); break;
    }
}

class Writer {
public:
    Writer(const Drawing& drawing, const VertexLayout& layout, std::byte* vertices) noexcept
        : drawing_(drawing), layout_(layout), vertices_(vertices),
          sources_(std::any_of(layout.fields.begin(), layout.fields.end(), [](const VertexField& field) {
              return field.attribute == VertexAttribute::position || field.attribute == VertexAttribute::normal ||
                     field.attribute == VertexAttribute::direction;
          })) {}

    void dot(std::int64_t number, const Dot& dot) const noexcept {
        const bool is_paper = (dot.flags & drawing::dot_is_paper) != 0;
        Vertex vertex{
            {dot.x, dot.y, dot.window}, dot.radius, 0.0F, {}, dot.id, dot.layer, 0, dot.mark_class, is_paper, {}};
        vertex.color = is_paper ? drawing_.paper : drawing_.layers[dot.layer].ink;
        vertex.color.w = is_paper ? dot.opacity : vertex.color.w * dot.opacity;
        store(number, vertex);
    }

    // Writes a vertex. `side` is its offset from the stroke's centre line.
    void point(std::int64_t number, const Stroke& stroke, const StrokePoint& p, const glm::vec2& side) const noexcept {
        const drawing::Layer& layer = drawing_.layers[stroke.layer];
        Vertex vertex{{p.x + side.x, p.y + side.y, p.window},
                      p.radius,
                      p.length,
                      layer.ink,
                      p.id,
                      stroke.layer,
                      stroke.line,
                      layer.mark_class,
                      false,
                      {}};
        vertex.color.w *= p.opacity;
        vertex.hidden_layers = static_cast<std::uint32_t>(stroke.hidden_layers);
        if (stroke.hidden_by >= 0) vertex.hidden_by = static_cast<std::uint32_t>(stroke.hidden_by);
        vertex.off_mark = layer.as_hatch || side != glm::vec2(0.0F);
        store(number, vertex);
    }

private:
    void store(std::int64_t number, Vertex& vertex) const noexcept {
        if (sources_) {
            const bool has_mark = vertex.id != 0;
            if (has_mark) vertex.source = drawing_.source(vertex.id);
            if (!has_mark || vertex.off_mark) vertex.source.position = drawing_.world(vertex.window);
        }
        for (const VertexField& field : layout_.fields)
            put_field(vertices_ + number * layout_.stride + field.offset, field, vertex);
    }

    const Drawing& drawing_;
    const VertexLayout& layout_;
    std::byte* vertices_;
    bool sources_;
};

// A stroke's points, and whether it is closed.
struct Line {
    std::span<const StrokePoint> points;
    bool closed;

    // Returns the unit vector that points to the left of a segment near point i. If `behind` is true, it is the first
    // segment of positive length after the point, else the last one before the point. Returns 0 if there is no such
    // segment.
    [[nodiscard]] glm::vec2 across(std::size_t i, bool behind) const noexcept {
        HRBFNPR_ASSERT(i < points.size());
        const std::size_t segments = points.size() - 1;
        for (std::size_t k = 0; k < segments; ++k) {
            if (!closed && (behind ? i + k >= segments : i < k + 1)) break;
            const std::size_t from = (behind ? i + k : i + 2 * segments - 1 - k) % segments;
            const glm::vec2 along(points[from + 1].x - points[from].x, points[from + 1].y - points[from].y);
            const float length = glm::length(along);
            if (length > 0.0F) return glm::vec2(along.y, -along.x) / length;
        }
        return glm::vec2(0.0F);
    }

    // Returns the offset from point i to the left side. The offset lies on the bisector of the angle between the two
    // segments at the point. It is longer than the radius where the stroke turns, so that both segments keep their
    // width, but at most twice as long.
    [[nodiscard]] glm::vec2 side(std::size_t i) const noexcept {
        glm::vec2 before = across(i, false);
        glm::vec2 after = across(i, true);
        if (before == glm::vec2(0.0F)) before = after;
        if (after == glm::vec2(0.0F)) after = before;
        const glm::vec2 sum = before + after;
        const float square = glm::dot(sum, sum);
        const glm::vec2 miter = square > 1e-12F ? sum * (2.0F / std::max(square, 1.0F)) : before;
        return miter * points[i].radius;
    }

    // Returns the vector from an end of the line to the end's tip.
    [[nodiscard]] glm::vec2 tip(bool end) const noexcept {
        const glm::vec2 left = across(end ? points.size() - 1 : 0, !end);
        const float far = 2.0F * drawing::point_length * (end ? points.back() : points.front()).radius;
        return glm::vec2(-left.y, left.x) * (end ? far : -far);
    }
};

// Returns whether an end is pointed. Then it has two additional vertices, both at its tip.
[[nodiscard]] bool has_tip(const Stroke& stroke, bool end) noexcept {
    return !stroke.closed && (end ? stroke.cap_end : stroke.cap_begin) == drawing::Cap::pointed;
}
[[nodiscard]] std::int64_t tips(const Stroke& stroke) noexcept {
    return (has_tip(stroke, false) ? 1 : 0) + (has_tip(stroke, true) ? 1 : 0);
}

void write_dots(const base::Runtime& runtime, const Drawing& drawing, VertexScratch& scratch, const Writer& writer) {
    if (drawing.painting == drawing::Painting::published) {
        runtime.parallel.for_chunks(drawing.dots.size(), dots_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) writer.dot(i, drawing.dots[i]);
        });
        return;
    }
    scratch.keys.clear();
    scratch.keys.reserve(drawing.dot_count);
    for (const drawing::IndexRange& piece : drawing.dot_ranges)
        for (std::int64_t i = piece.begin; i < piece.end; ++i)
            if (const Dot& dot = drawing.dots[i]; dot.opacity > 0.0F)
                scratch.keys.push_back(drawing::far_first_key(dot.depth, static_cast<std::uint32_t>(i)));
    scratch.order.sort(runtime.parallel, scratch.keys);
    runtime.parallel.for_chunks(scratch.keys.size(), dots_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            writer.dot(i, drawing.dots[static_cast<std::uint32_t>(scratch.keys[i])]);
    });
}

// Writes line strips. Strokes are already sorted from far to near, and each vertex has the index of its point.
void write_lines(const base::Runtime& runtime, const Drawing& drawing, const Writer& writer) {
    runtime.parallel.for_chunks(drawing.strokes.size(), strokes_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t s = begin; s < end; ++s) {
            const Stroke& stroke = drawing.strokes[s];
            for (std::int64_t i = stroke.first; i < stroke.first + stroke.count; ++i)
                writer.point(i, stroke, drawing.points[i], glm::vec2(0.0F));
        }
    });
}

// Writes a triangle strip. `number` is the index of its first vertex: twice the number of points and tips before it.
void write_strip(const Drawing& drawing, const Stroke& stroke, std::int64_t number, const Writer& writer) {
    const Line line{
        drawing.points.span().subspan(static_cast<std::size_t>(stroke.first), static_cast<std::size_t>(stroke.count)),
        stroke.closed};
    const auto put_pair = [&](const StrokePoint& point, const glm::vec2& left, const glm::vec2& right) {
        writer.point(number++, stroke, point, left);
        writer.point(number++, stroke, point, right);
    };
    if (has_tip(stroke, false)) put_pair(line.points.front(), line.tip(false), line.tip(false));
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const glm::vec2 side = line.side(i);
        put_pair(line.points[i], side, -side);
    }
    if (has_tip(stroke, true)) put_pair(line.points.back(), line.tip(true), line.tip(true));
}

void write_strips(const base::Runtime& runtime, const Drawing& drawing, VertexScratch& scratch, const Writer& writer) {
    scratch.keys.clear();
    scratch.keys.reserve(drawing.strokes.size());
    std::int64_t before = 0;
    for (const Stroke& stroke : drawing.strokes) {
        scratch.keys.push_back(static_cast<std::uint64_t>(before));
        before += tips(stroke);
    }
    runtime.parallel.for_chunks(drawing.strokes.size(), strokes_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t s = begin; s < end; ++s) {
            const Stroke& stroke = drawing.strokes[s];
            write_strip(drawing, stroke, 2 * (stroke.first + static_cast<std::int64_t>(scratch.keys[s])), writer);
        }
    });
}

void write_indices(const Drawing& drawing, Primitive primitive, std::uint32_t* to) noexcept {
    if (primitive == Primitive::points) {
        const std::int64_t count = vertex_bound(drawing, primitive).vertices;
        for (std::int64_t i = 0; i < count; ++i) *to++ = static_cast<std::uint32_t>(i);
        return;
    }
    const bool strips = primitive == Primitive::triangle_strips;
    std::uint32_t number = 0;
    for (const Stroke& stroke : drawing.strokes) {
        const std::int64_t count = strips ? 2 * (stroke.count + tips(stroke)) : stroke.count;
        for (std::int64_t i = 0; i < count; ++i) *to++ = number++;
        *to++ = index_restart;
    }
}

// ---- Results for each mark of a point set

// A mark of a run that is drawn.
struct Drawn {
    std::int64_t mark;
    std::uint32_t layer; // index into the drawing's layers
    float radius, opacity, depth;
};

// Calls f for each mark of the run that is drawn as a dot or as points of a stroke. A mark may be passed twice if its
// hatching stroke is cut or closed.
template <class F>
void for_each_drawn(const Drawing& drawing, const drawing::Run& run, const F& f) {
    const auto is_own = [&](std::uint32_t layer) {
        return drawing.layers[layer].item == run.item && drawing.layers[layer].layer == run.layer;
    };
    for (const drawing::IndexRange& piece : drawing.dot_ranges) {
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            const Dot& dot = drawing.dots[i];
            if (!(dot.opacity > 0.0F) || (dot.flags & drawing::dot_is_paper) != 0 || !is_own(dot.layer)) continue;
            f(Drawn{std::int64_t{dot.id - run.first_id}, dot.layer, dot.radius, dot.opacity, dot.depth});
        }
    }
    for (const Stroke& stroke : drawing.strokes) {
        if (!is_own(stroke.layer)) continue;
        const std::int64_t end = stroke.first + stroke.count;
        for (std::int64_t i = stroke.first; i < end;) {
            const StrokePoint& p = drawing.points[i];
            Drawn drawn{std::int64_t{p.id - run.first_id}, stroke.layer, p.radius, p.opacity, p.depth};
            // Several consecutive points of hatching may belong to one mark.
            for (++i; i < end && drawing.points[i].id == p.id; ++i)
                drawn.radius = std::max(drawn.radius, drawing.points[i].radius);
            f(drawn);
        }
    }
}

} // namespace

std::int64_t size_of(const VertexField& field) noexcept {
    HRBFNPR_ASSERT(static_cast<std::uint32_t>(field.attribute) <= last_attribute);
    const AttributeType& type = attribute_types[static_cast<std::size_t>(field.attribute)];
    switch (field.scalar) {
    case Scalar::float32: return type.as_float ? 4 * type.components : 0;
    case Scalar::uint8: return type.as_byte ? type.components : 0;
    case Scalar::uint32: return type.as_word ? 4 * type.components : 0;
    default: return 0;
    }
}

VertexBound vertex_bound(const Drawing& drawing, Primitive primitive) noexcept {
    if (primitive == Primitive::points) {
        const std::int64_t dots =
            drawing.painting == drawing::Painting::published ? drawing.dots.size() : drawing.dot_count;
        return {dots, dots};
    }
    std::int64_t vertices = drawing.points.size();
    if (primitive == Primitive::triangle_strips) {
        for (const Stroke& stroke : drawing.strokes) vertices += tips(stroke);
        vertices *= 2;
    }
    return {vertices, vertices + drawing.strokes.size()};
}

void write_vertices(const base::Runtime& runtime, const Drawing& drawing, VertexScratch& scratch,
                    const VertexLayout& layout, std::byte* vertices, std::uint32_t* indices) {
    const Writer writer(drawing, layout, vertices);
    if (layout.primitive == Primitive::points)
        write_dots(runtime, drawing, scratch, writer);
    else if (layout.primitive == Primitive::line_strips)
        write_lines(runtime, drawing, writer);
    else
        write_strips(runtime, drawing, scratch, writer);
    if (indices != nullptr) write_indices(drawing, layout.primitive, indices);
}

void write_mark_results(const Drawing& drawing, std::int64_t number, const MarkViews& views) {
    HRBFNPR_ASSERT(number >= 0 && number < drawing.runs.size());
    const drawing::Run& run = drawing.runs[number];
    for (const base::OutView* view : {&views.shown, &views.radius, &views.opacity})
        if (*view)
            for (std::int64_t i = 0; i < run.count; ++i) view->set(i, 0, 0.0);
    for_each_drawn(drawing, run, [&](const Drawn& drawn) {
        const drawing::Layer& layer = drawing.layers[drawn.layer];
        if (views.shown) views.shown.set(drawn.mark, 0, static_cast<double>(layer.mark_class));
        if (views.radius) views.radius.set(drawn.mark, 0, static_cast<double>(drawn.radius));
        if (views.opacity) views.opacity.set(drawn.mark, 0, static_cast<double>(drawn.opacity * layer.ink.w));
    });
}

std::span<const std::uint32_t> mark_indices(const base::Runtime& runtime, const Drawing& drawing, std::int64_t number,
                                            drawing::MarkClass mark_class, Primitive primitive,
                                            VertexScratch& scratch) {
    HRBFNPR_ASSERT(number >= 0 && number < drawing.runs.size());
    const drawing::Run& run = drawing.runs[number];
    scratch.keys.clear();
    scratch.indices.clear();
    scratch.shown.clear();
    scratch.shown.resize(run.count);
    for_each_drawn(drawing, run, [&](const Drawn& drawn) {
        if (drawing.layers[drawn.layer].mark_class != mark_class || std::exchange(scratch.shown[drawn.mark], 1) != 0)
            return;
        scratch.keys.push_back(drawing::far_first_key(drawn.depth, static_cast<std::uint32_t>(drawn.mark)));
    });
    if (primitive == Primitive::points) {
        scratch.order.sort(runtime.parallel, scratch.keys);
        for (const std::uint64_t key : scratch.keys) scratch.indices.push_back(static_cast<std::uint32_t>(key));
        return scratch.indices.span();
    }
    const marks::Layer& layer = drawing.items[run.item].set->layers[run.layer];
    const std::uint32_t sides = primitive == Primitive::triangle_strips ? 2 : 1;
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        const std::int64_t end = layer.stroke_first[s + 1];
        for (std::int64_t i = layer.stroke_first[s]; i < end;) {
            std::int64_t stop = i;
            // Find the end of the sequence of shown marks; a line needs at least two.
            while (stop < end && scratch.shown[layer.mark_of(stop)] != 0) ++stop;
            for (std::int64_t k = i; stop - i > 1 && k < stop; ++k)
                for (std::uint32_t side = 0; side < sides; ++side)
                    scratch.indices.push_back(sides * static_cast<std::uint32_t>(layer.mark_of(k)) + side);
            if (stop - i > 1) scratch.indices.push_back(index_restart);
            i = std::max(stop, i + 1);
        }
    }
    return scratch.indices.span();
}

} // namespace hrbfnpr::output
