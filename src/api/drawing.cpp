// SPDX-License-Identifier: MIT
// Returns the contents of a drawing: its vertices, and the results for the marks of its point sets.
#include "api/drawing.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/lists.h"
#include "api/views.h"
#include "output/vertex/vertices.h"

#include <limits>

using namespace hrbfnpr;

static_assert(static_cast<int>(drawing::MarkClass::none) == HRBFNPR_CLASS_NONE);
static_assert(static_cast<int>(drawing::MarkClass::front) == HRBFNPR_CLASS_FRONT);
static_assert(static_cast<int>(drawing::MarkClass::back) == HRBFNPR_CLASS_BACK);
static_assert(static_cast<int>(drawing::MarkClass::silhouette) == HRBFNPR_CLASS_SILHOUETTE);
static_assert(static_cast<int>(output::Primitive::points) == HRBFNPR_PRIMITIVE_POINTS);
static_assert(static_cast<int>(output::Primitive::line_strips) == HRBFNPR_PRIMITIVE_LINE_STRIPS);
static_assert(static_cast<int>(output::Primitive::triangle_strips) == HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS);
static_assert(output::index_restart == static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART));
static_assert(static_cast<int>(output::VertexAttribute::position) == HRBFNPR_VERTEX_ATTRIBUTE_POSITION);
static_assert(static_cast<int>(output::VertexAttribute::window) == HRBFNPR_VERTEX_ATTRIBUTE_WINDOW);
static_assert(static_cast<int>(output::VertexAttribute::radius) == HRBFNPR_VERTEX_ATTRIBUTE_RADIUS);
static_assert(static_cast<int>(output::VertexAttribute::color) == HRBFNPR_VERTEX_ATTRIBUTE_COLOR);
static_assert(static_cast<int>(output::VertexAttribute::normal) == HRBFNPR_VERTEX_ATTRIBUTE_NORMAL);
static_assert(static_cast<int>(output::VertexAttribute::direction) == HRBFNPR_VERTEX_ATTRIBUTE_DIRECTION);
static_assert(static_cast<int>(output::VertexAttribute::id) == HRBFNPR_VERTEX_ATTRIBUTE_ID);
static_assert(static_cast<int>(output::VertexAttribute::mark_class) == HRBFNPR_VERTEX_ATTRIBUTE_CLASS);
static_assert(static_cast<int>(output::VertexAttribute::is_paper) == HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER);
static_assert(static_cast<int>(output::VertexAttribute::layer) == HRBFNPR_VERTEX_ATTRIBUTE_LAYER);
static_assert(static_cast<int>(output::VertexAttribute::length) == HRBFNPR_VERTEX_ATTRIBUTE_LENGTH);
static_assert(static_cast<int>(output::VertexAttribute::line) == HRBFNPR_VERTEX_ATTRIBUTE_LINE);
static_assert(static_cast<int>(output::VertexAttribute::hidden_layers) == HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_LAYERS);
static_assert(static_cast<int>(output::VertexAttribute::hidden_by) == HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_BY);

namespace hrbfnpr::api {

template <>
hrbfnpr_drawing_info defaults() noexcept {
    return {};
}

template <>
hrbfnpr_drawing_layer_info defaults() noexcept {
    return {};
}

template <>
hrbfnpr_vertex_attribute defaults() noexcept {
    hrbfnpr_vertex_attribute attribute{};
    attribute.scalar = HRBFNPR_SCALAR_FLOAT32;
    return attribute;
}

template <>
hrbfnpr_vertex_layout defaults() noexcept {
    hrbfnpr_vertex_layout layout{};
    layout.primitive = HRBFNPR_PRIMITIVE_POINTS;
    return layout;
}

template <>
hrbfnpr_mark_results defaults() noexcept {
    return {};
}

template <>
hrbfnpr_mark_identity defaults() noexcept {
    return {};
}

namespace {

constexpr std::int64_t most_attributes = 64;

hrbfnpr_drawing_info describe(const drawing::Drawing& from) noexcept {
    const drawing::Counts& counts = from.counts;
    hrbfnpr_drawing_info info{};
    info.items = from.items.size();
    info.layers = from.layers.size();
    info.dots = from.dot_count;
    info.strokes = from.strokes.size();
    info.stroke_points = from.points.size();
    info.marks = counts.marks;
    info.outside = counts.outside;
    info.front = counts.front;
    info.back = counts.back;
    info.silhouette = counts.silhouette;
    info.culled = counts.culled;
    info.shown = counts.shown;
    info.dropped_tone = counts.dropped_tone;
    info.dropped_depth = counts.dropped_depth;
    info.dropped_zoom = counts.dropped_zoom;
    info.dropped_hidden = counts.dropped_hidden;
    info.splats = counts.splats;
    info.nanoseconds_classify = counts.nanoseconds_classify;
    info.nanoseconds_visibility = counts.nanoseconds_visibility;
    info.nanoseconds_sort = counts.nanoseconds_sort;
    info.bytes = from.bytes();
    info.scratch_bytes = counts.scratch_bytes;
    info.line_curves = from.line_counts.curves;
    info.line_cusps = from.line_counts.cusps;
    info.line_crossings = from.line_counts.crossings;
    info.line_broken = from.line_counts.broken;
    info.line_settled = from.line_counts.settled;
    info.line_contradictions = from.line_counts.contradictions;
    info.nanoseconds_lines = from.line_counts.nanoseconds;
    info.line_refined = from.line_counts.refined;
    info.line_tangles = from.line_counts.tangles;
    info.line_pieces = from.line_counts.pieces;
    info.line_agreeing = from.line_counts.agreeing;
    info.line_undecided = from.line_counts.undecided;
    info.line_repaired = from.line_counts.repaired;
    return info;
}

hrbfnpr_drawing_layer_info describe_layer(const drawing::Drawing& from, std::int64_t number) {
    const std::int64_t layers = from.layers.size();
    if (number < 0 || number >= layers)
        fail(Status::invalid_argument, "number is %lld; it must be at least 0 and below the number of layers, %lld",
             static_cast<long long>(number), static_cast<long long>(layers));
    const drawing::Layer& layer = from.layers[number];
    hrbfnpr_drawing_layer_info info{};
    info.mark_class = static_cast<std::uint32_t>(layer.mark_class);
    info.item = layer.item;
    info.layer = layer.layer;
    info.shape = layer.as_hatch ? HRBFNPR_SHAPE_HATCH : layer.as_strokes ? HRBFNPR_SHAPE_STROKES : HRBFNPR_SHAPE_DOTS;
    if (layer.layer >= 0) {
        const marks::Layer& source = from.items[layer.item].set->layers[layer.layer];
        info.kind = static_cast<std::uint32_t>(source.kind);
        std::memcpy(info.name, source.name.data(), sizeof info.name);
    } else {
        info.kind = layer.line_kind;
        std::memcpy(info.name, layer.line_name.data(), sizeof info.name);
    }
    for (int i = 0; i < 4; ++i) info.ink[i] = layer.ink[i];
    info.ink_number = layer.ink_number;
    const auto is_own = [&](std::uint32_t other) { return other == static_cast<std::uint32_t>(number); };
    for (const drawing::IndexRange& piece : from.dot_ranges)
        for (std::int64_t i = piece.begin; i < piece.end; ++i)
            info.dots += is_own(from.dots[i].layer) && from.dots[i].opacity > 0.0F &&
                                 (from.dots[i].flags & drawing::dot_is_paper) == 0
                             ? 1
                             : 0;
    for (const drawing::Stroke& stroke : from.strokes) info.strokes += is_own(stroke.layer) ? 1 : 0;
    return info;
}

// ---- Vertices ------------------------------------------------------------------------------

output::Primitive checked_primitive(std::uint32_t primitive, const char* name) {
    if (primitive < HRBFNPR_PRIMITIVE_POINTS || primitive > HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS)
        fail(Status::invalid_argument, "%s is %u; it must be one of HRBFNPR_PRIMITIVE_* (1 to 3)", name, primitive);
    return static_cast<output::Primitive>(primitive);
}

output::VertexField checked(const hrbfnpr_vertex_attribute& attribute, const char* name) {
    Checks(name).one_of("attribute", attribute.attribute, output::last_attribute + 1, "HRBFNPR_VERTEX_ATTRIBUTE_*");
    const bool known = attribute.scalar >= HRBFNPR_SCALAR_FLOAT32 && attribute.scalar <= HRBFNPR_SCALAR_UINT32;
    const output::VertexField field{static_cast<output::VertexAttribute>(attribute.attribute),
                                    static_cast<base::Scalar>(attribute.scalar), attribute.offset};
    if (!known || output::size_of(field) == 0)
        fail(Status::invalid_argument,
             "%s.scalar is %u, a type that attribute %u cannot have; see HRBFNPR_VERTEX_ATTRIBUTE_* for its types",
             name, attribute.scalar, attribute.attribute);
    return field;
}

struct Fields {
    std::array<output::VertexField, most_attributes> field;
    std::size_t count = 0;
    std::int64_t stride = 0;
};

Fields checked(const hrbfnpr_vertex_layout& layout) {
    const List<hrbfnpr_vertex_attribute> list(layout.attributes, layout.attribute_count, layout.attribute_stride,
                                              most_attributes, "layout.attributes");
    if (list.count() == 0) fail(Status::invalid_argument, "layout.attributes is empty; a vertex needs at least one");
    Fields fields;
    std::int64_t end = 0;
    for (std::int64_t i = 0; i < list.count(); ++i) {
        fields.field[fields.count] = checked(list[i], list.name(i).text);
        end = std::max(end, fields.field[fields.count].offset + output::size_of(fields.field[fields.count]));
        ++fields.count;
    }
    if (layout.stride != 0 && layout.stride < end)
        fail(Status::invalid_argument,
             "layout.stride is %lld, but by offset and size the attributes end at byte %lld; it must be 0 or at least "
             "that",
             static_cast<long long>(layout.stride), static_cast<long long>(end));
    fields.stride = layout.stride != 0 ? layout.stride : end;
    return fields;
}

void check_capacity(const char* name, std::int64_t capacity, const void* destination, const char* destination_name) {
    if (capacity < 0)
        fail(Status::invalid_argument, "%s is %lld; it must be 0 or more", name, static_cast<long long>(capacity));
    if (capacity > 0) require_pointer(destination, destination_name);
}

struct VertexOut {
    void* vertices;
    std::int64_t vertex_capacity;
    std::int64_t* vertex_count;
    std::uint32_t* indices;
    std::int64_t index_capacity;
    std::int64_t* index_count;
};

void write_bound(const VertexOut& out, const output::VertexBound& bound) noexcept {
    if (out.vertex_count != nullptr) *out.vertex_count = bound.vertices;
    if (out.index_count != nullptr) *out.index_count = bound.indices;
}

void write_vertices(const hrbfnpr_drawing& handle, const hrbfnpr_vertex_layout& layout, const VertexOut& out) {
    const Fields fields = checked(layout);
    const output::Primitive primitive = checked_primitive(layout.primitive, "layout.primitive");
    check_capacity("vertex_capacity", out.vertex_capacity, out.vertices, "vertices");
    check_capacity("index_capacity", out.index_capacity, out.indices, "indices");
    const output::VertexBound bound = output::vertex_bound(handle.drawing, primitive);
    if (out.vertex_capacity < bound.vertices || (out.indices != nullptr && out.index_capacity < bound.indices)) {
        write_bound(out, bound);
        fail(Status::buffer_too_small,
             "vertex_capacity is %lld and index_capacity is %lld; they must be at least %lld and %lld",
             static_cast<long long>(out.vertex_capacity), static_cast<long long>(out.index_capacity),
             static_cast<long long>(bound.vertices), static_cast<long long>(bound.indices));
    }
    const auto room = std::numeric_limits<std::uintptr_t>::max() - reinterpret_cast<std::uintptr_t>(out.vertices);
    if (bound.vertices > 0 &&
        static_cast<std::uint64_t>(fields.stride) > room / static_cast<std::uint64_t>(bound.vertices))
        fail(Status::invalid_argument, "layout.stride: %lld vertices of %lld bytes exceed the address space",
             static_cast<long long>(bound.vertices), static_cast<long long>(fields.stride));
    const base::ScratchPool<output::VertexScratch>::Lease scratch(handle.context().drawing_scratch.vertices);
    output::write_vertices(handle.runtime(), handle.drawing, *scratch,
                           {primitive, std::span(fields.field).first(fields.count), fields.stride},
                           static_cast<std::byte*>(out.vertices), out.indices);
    write_bound(out, bound);
}

// ---- Marks ---------------------------------------------------------------------------------

// Returns the index of the run of an item's layer in the drawing. A drawing has one run for each layer of each item.
std::int64_t run_number(const drawing::Drawing& drawing, std::int64_t item, std::int64_t layer) {
    if (item < 0 || item >= drawing.items.size())
        fail(Status::invalid_argument, "item is %lld; it must be at least 0 and below the number of items, %lld",
             static_cast<long long>(item), static_cast<long long>(drawing.items.size()));
    const auto layers = drawing.items[item].set->layers.size();
    if (layer < 0 || layer >= layers)
        fail(Status::invalid_argument,
             "layer is %lld; in the point set of item %lld it must be at least 0 and below %lld",
             static_cast<long long>(layer), static_cast<long long>(item), static_cast<long long>(layers));
    std::int64_t first = 0;
    for (std::int64_t i = 0; i < item; ++i) first += drawing.items[i].set->layers.size();
    return first + layer;
}

void write_results(const drawing::Drawing& drawing, std::int64_t item, std::int64_t layer,
                   const hrbfnpr_mark_results& results) {
    Checks("mark_results").zero("reserved", results.reserved);
    const std::int64_t run = run_number(drawing, item, layer);
    const std::int64_t count = drawing.runs[run].count;
    output::write_mark_results(drawing, run,
                               {out_view(&results.shown, "mark_results.shown", {1, uint8_only}, count),
                                out_view(&results.radius, "mark_results.radius", {1, float32_only}, count),
                                out_view(&results.opacity, "mark_results.opacity", {1, float32_only}, count)});
}

struct IndexOut {
    std::uint32_t* indices;
    std::int64_t capacity;
    std::int64_t* count;
};

void write_indices(const hrbfnpr_drawing& handle, std::int64_t run, std::uint32_t mark_class, std::uint32_t primitive,
                   const IndexOut& out) {
    if (mark_class != HRBFNPR_CLASS_FRONT && mark_class != HRBFNPR_CLASS_SILHOUETTE)
        fail(Status::invalid_argument, "mark_class is %u; it must be HRBFNPR_CLASS_FRONT or _SILHOUETTE", mark_class);
    check_capacity("capacity", out.capacity, out.indices, "indices");
    require_pointer(out.count, "count");
    const base::ScratchPool<output::VertexScratch>::Lease scratch(handle.context().drawing_scratch.vertices);
    const auto found =
        output::mark_indices(handle.context().runtime, handle.drawing, run, static_cast<drawing::MarkClass>(mark_class),
                             checked_primitive(primitive, "primitive"), *scratch);
    const auto needed = static_cast<std::int64_t>(found.size());
    *out.count = needed;
    if (out.capacity < needed)
        fail(Status::buffer_too_small, "capacity is %lld; it must be at least %lld, the number of indices",
             static_cast<long long>(out.capacity), static_cast<long long>(needed));
    std::copy(found.begin(), found.end(), out.indices);
}

hrbfnpr_mark_identity identify(const drawing::Drawing& drawing, std::uint32_t id) {
    if (drawing.run_of(id) == nullptr)
        fail(Status::invalid_argument, "id is %u; the marks of this drawing have the ids 1 to %lld", id,
             drawing.runs.empty()
                 ? 0LL
                 : static_cast<long long>(drawing.runs.span().back().first_id + drawing.runs.span().back().count - 1));
    const drawing::Identity found = drawing.identify(id);
    hrbfnpr_mark_identity identity{};
    identity.id = id;
    identity.item = found.item;
    identity.layer = found.layer;
    identity.mark = found.mark;
    identity.stroke = found.stroke;
    identity.place = found.place;
    return identity;
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

void hrbfnpr_drawing_retain(const hrbfnpr_drawing* drawing) {
    if (drawing != nullptr) drawing->add_reference();
}

void hrbfnpr_drawing_release(const hrbfnpr_drawing* drawing) { api::release_handle(drawing); }

hrbfnpr_status hrbfnpr_drawing_info_init(hrbfnpr_drawing_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_drawing_get_info(const hrbfnpr_drawing* drawing, hrbfnpr_drawing_info* info,
                                        hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(drawing, "drawing");
        api::check_output_struct(info, "drawing_info");
        api::write_struct(info, api::describe(handle.drawing));
    });
}

hrbfnpr_status hrbfnpr_drawing_layer_info_init(hrbfnpr_drawing_layer_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_drawing_get_layer_info(const hrbfnpr_drawing* drawing, int64_t number,
                                              hrbfnpr_drawing_layer_info* info, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(drawing, "drawing");
        api::check_output_struct(info, "drawing_layer_info");
        api::write_struct(info, api::describe_layer(handle.drawing, number));
    });
}

hrbfnpr_status hrbfnpr_vertex_attribute_init(hrbfnpr_vertex_attribute* attribute, uint32_t struct_size) {
    return api::init_struct(attribute, struct_size);
}

hrbfnpr_status hrbfnpr_vertex_layout_init(hrbfnpr_vertex_layout* layout, uint32_t struct_size) {
    return api::init_struct(layout, struct_size);
}

hrbfnpr_status hrbfnpr_drawing_vertex_bound(const hrbfnpr_drawing* drawing, uint32_t primitive, int64_t* vertices,
                                            int64_t* indices, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(drawing, "drawing");
        const output::VertexBound bound =
            output::vertex_bound(handle.drawing, api::checked_primitive(primitive, "primitive"));
        if (vertices != nullptr) *vertices = bound.vertices;
        if (indices != nullptr) *indices = bound.indices;
    });
}

hrbfnpr_status hrbfnpr_drawing_write_vertices(const hrbfnpr_drawing* drawing, const hrbfnpr_vertex_layout* layout,
                                              void* vertices, int64_t vertex_capacity, int64_t* vertex_count,
                                              uint32_t* indices, int64_t index_capacity, int64_t* index_count,
                                              hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::write_vertices(api::deref(drawing, "drawing"), api::read_struct(layout, "layout"),
                            {vertices, vertex_capacity, vertex_count, indices, index_capacity, index_count});
    });
}

hrbfnpr_status hrbfnpr_mark_results_init(hrbfnpr_mark_results* results, uint32_t struct_size) {
    return api::init_struct(results, struct_size);
}

hrbfnpr_status hrbfnpr_drawing_mark_results(const hrbfnpr_drawing* drawing, int64_t item, int64_t layer,
                                            hrbfnpr_mark_results* results, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::write_results(api::deref(drawing, "drawing").drawing, item, layer,
                           api::read_struct(results, "mark_results"));
    });
}

hrbfnpr_status hrbfnpr_drawing_write_mark_indices(const hrbfnpr_drawing* drawing, int64_t item, int64_t layer,
                                                  uint32_t mark_class, uint32_t primitive, uint32_t* indices,
                                                  int64_t capacity, int64_t* count, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(drawing, "drawing");
        api::write_indices(handle, api::run_number(handle.drawing, item, layer), mark_class, primitive,
                           {indices, capacity, count});
    });
}

hrbfnpr_status hrbfnpr_mark_identity_init(hrbfnpr_mark_identity* identity, uint32_t struct_size) {
    return api::init_struct(identity, struct_size);
}

hrbfnpr_status hrbfnpr_drawing_identify(const hrbfnpr_drawing* drawing, uint32_t id, hrbfnpr_mark_identity* identity,
                                        hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(drawing, "drawing");
        api::check_output_struct(identity, "mark_identity");
        api::write_struct(identity, api::identify(handle.drawing, id));
    });
}

} // extern "C"
