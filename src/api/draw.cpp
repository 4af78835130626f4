// What a renderer makes of its prepared frame: an image, or vertices.
#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/renderer.h"
#include "api/views.h"
#include "base/clock.h"
#include "output/vertex/vertices.h"

#include <array>
#include <cstdio>
#include <limits>

using namespace hrbfnpr;

static_assert(static_cast<int>(output::Format::rgba8) == HRBFNPR_FORMAT_RGBA8);
static_assert(static_cast<int>(output::Format::bgra8) == HRBFNPR_FORMAT_BGRA8);
static_assert(static_cast<int>(output::Format::rgba8_premultiplied) == HRBFNPR_FORMAT_RGBA8_PREMULTIPLIED);
static_assert(static_cast<int>(output::Format::bgra8_premultiplied) == HRBFNPR_FORMAT_BGRA8_PREMULTIPLIED);
static_assert(static_cast<int>(output::VertexAttribute::position) == HRBFNPR_VERTEX_POSITION);
static_assert(static_cast<int>(output::VertexAttribute::window) == HRBFNPR_VERTEX_WINDOW);
static_assert(static_cast<int>(output::VertexAttribute::radius) == HRBFNPR_VERTEX_RADIUS);
static_assert(static_cast<int>(output::VertexAttribute::color) == HRBFNPR_VERTEX_COLOR);
static_assert(static_cast<int>(output::VertexAttribute::normal) == HRBFNPR_VERTEX_NORMAL);
static_assert(static_cast<int>(output::VertexAttribute::direction) == HRBFNPR_VERTEX_DIRECTION);
static_assert(static_cast<int>(output::VertexAttribute::id) == HRBFNPR_VERTEX_ID);
static_assert(static_cast<int>(output::VertexAttribute::mark_class) == HRBFNPR_VERTEX_CLASS);
static_assert(static_cast<int>(output::VertexAttribute::is_paper) == HRBFNPR_VERTEX_IS_PAPER);

namespace hrbfnpr::api {

template <>
hrbfnpr_image defaults() noexcept {
    hrbfnpr_image image{};
    image.format = HRBFNPR_FORMAT_RGBA8;
    return image;
}

template <>
hrbfnpr_draw_desc defaults() noexcept {
    return {};
}

template <>
hrbfnpr_vertex_layout defaults() noexcept {
    return {};
}

namespace {

constexpr std::int32_t largest_side = 32768;
constexpr std::uint32_t most_attributes = 16;
using Fields = std::array<output::VertexField, most_attributes>;

const hrbfnpr_renderer& prepared(const hrbfnpr_renderer* renderer) {
    const auto& handle = deref(renderer, "renderer");
    if (!handle.frame.prepared())
        fail(Status::invalid_argument, "renderer has no prepared frame; call hrbfnpr_renderer_prepare first");
    return handle;
}

// The row stride in bytes, once it is sure that all rows lie in the address space.
std::int64_t checked_row_stride(const hrbfnpr_image& image) {
    const std::int64_t row = std::int64_t{4} * image.width;
    if (image.row_stride == 0) return row;
    constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max() / largest_side;
    if (image.row_stride > largest || image.row_stride < -largest ||
        (image.row_stride < row && image.row_stride > -row))
        fail(Status::invalid_argument,
             "image.row_stride is %lld; it must be 0, or at least 4 * width = %lld, forward or backward",
             static_cast<long long>(image.row_stride), static_cast<long long>(row));
    const auto address = reinterpret_cast<std::uintptr_t>(image.pixels);
    const auto reach = static_cast<std::uint64_t>(image.height - 1) *
                       static_cast<std::uint64_t>(image.row_stride < 0 ? -image.row_stride : image.row_stride);
    const std::uint64_t room = image.row_stride < 0 ? address : std::numeric_limits<std::uintptr_t>::max() - address;
    if (reach > room)
        fail(Status::invalid_argument, "image: height %d times row_stride %lld is beyond the address space",
             static_cast<int>(image.height), static_cast<long long>(image.row_stride));
    return image.row_stride;
}

output::Image checked(const hrbfnpr_image& image) {
    const Checks checks("image");
    if (image.format < HRBFNPR_FORMAT_RGBA8 || image.format > HRBFNPR_FORMAT_BGRA8_PREMULTIPLIED)
        fail(Status::invalid_argument, "image.format is %u; it must be one of HRBFNPR_FORMAT_... (1 to 4)",
             image.format);
    checks.between("width", image.width, 1, largest_side);
    checks.between("height", image.height, 1, largest_side);
    checks.given("pixels", image.pixels != nullptr);
    return {static_cast<output::Format>(image.format), image.width, image.height, static_cast<std::byte*>(image.pixels),
            checked_row_stride(image)};
}

output::DrawSettings checked(const hrbfnpr_draw_desc& desc, const output::Image& image) {
    Checks("draw_desc").flags("flags", desc.flags, HRBFNPR_DRAW_OVER | HRBFNPR_DRAW_LINEAR_LIGHT);
    const std::int64_t count = std::int64_t{image.width} * image.height;
    output::DrawSettings settings;
    settings.over = (desc.flags & HRBFNPR_DRAW_OVER) != 0;
    settings.linear_light = (desc.flags & HRBFNPR_DRAW_LINEAR_LIGHT) != 0;
    settings.host_depth = in_view(desc.host_depth, "draw_desc.host_depth", {1, float32_only}, count);
    settings.depth = out_view(&desc.depth, "draw_desc.depth", {1, float32_only}, count);
    settings.id = out_view(&desc.id, "draw_desc.id", {1, uint32_only}, count);
    settings.mark_class = out_view(&desc.class_, "draw_desc.class_", {1, uint8_or_uint32}, count);
    return settings;
}

void draw(hrbfnpr_renderer& renderer, const output::Image& image, const output::DrawSettings& settings) {
    const base::Stopwatch watch;
    renderer.raster.draw(renderer.frame, image, settings);
    renderer.nanoseconds_draw = watch.nanoseconds();
}

output::VertexField checked(const hrbfnpr_vertex_attribute& attribute, std::uint32_t number) {
    char name[48];
    std::snprintf(name, sizeof name, "layout.attributes[%u]", number);
    const Checks checks(name);
    checks.one_of("attribute", attribute.attribute, HRBFNPR_VERTEX_ATTRIBUTE_COUNT, "HRBFNPR_VERTEX_...");
    checks.zero("reserved", attribute.reserved);
    const bool known = attribute.scalar >= HRBFNPR_SCALAR_FLOAT32 && attribute.scalar <= HRBFNPR_SCALAR_UINT32;
    const output::VertexField field{static_cast<output::VertexAttribute>(attribute.attribute),
                                    static_cast<base::Scalar>(attribute.scalar), attribute.offset};
    if (!known || output::size_of(field) == 0)
        fail(Status::invalid_argument, "%s.scalar is %u; attribute %u cannot have that type: see HRBFNPR_VERTEX_...",
             name, attribute.scalar, attribute.attribute);
    return field;
}

// Fills `fields` and returns the bytes of a vertex.
std::int64_t checked(const hrbfnpr_vertex_layout& layout, Fields& fields) {
    const Checks checks("layout");
    checks.between("attribute_count", layout.attribute_count, 1, most_attributes);
    std::int64_t end = 0;
    for (std::uint32_t i = 0; i < layout.attribute_count; ++i) {
        fields[i] = checked(layout.attributes[i], i);
        end = std::max(end, fields[i].offset + output::size_of(fields[i]));
    }
    if (layout.stride != 0 && layout.stride < end)
        fail(Status::invalid_argument,
             "layout.stride is %lld; the attributes end at %lld: it must be 0 or that at least",
             static_cast<long long>(layout.stride), static_cast<long long>(end));
    return layout.stride != 0 ? layout.stride : end;
}

void write_vertices(const hrbfnpr_renderer& renderer, const hrbfnpr_vertex_layout& layout, void* destination,
                    std::int64_t capacity, std::int64_t* count) {
    Fields fields;
    const std::int64_t stride = checked(layout, fields);
    require_pointer(count, "count");
    if (capacity < 0)
        fail(Status::invalid_argument, "capacity is %lld; it must be 0 or more", static_cast<long long>(capacity));
    if (capacity > 0) require_pointer(destination, "destination");
    const auto needed = static_cast<std::int64_t>(renderer.frame.discs().size());
    if (capacity < needed) {
        *count = needed;
        fail(Status::buffer_too_small, "capacity is %lld; %lld vertices are needed", static_cast<long long>(capacity),
             static_cast<long long>(needed));
    }
    const auto room = std::numeric_limits<std::uintptr_t>::max() - reinterpret_cast<std::uintptr_t>(destination);
    if (needed > 0 && static_cast<std::uint64_t>(stride) > room / static_cast<std::uint64_t>(needed))
        fail(Status::invalid_argument, "layout.stride: %lld vertices of %lld bytes are beyond the address space",
             static_cast<long long>(needed), static_cast<long long>(stride));
    if (needed > 0)
        output::write_vertices(renderer.runtime(), renderer.frame, std::span(fields).first(layout.attribute_count),
                               stride, static_cast<std::byte*>(destination));
    *count = needed;
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_image_init(hrbfnpr_image* image, uint32_t struct_size) {
    return api::init_struct(image, struct_size);
}

hrbfnpr_status hrbfnpr_draw_desc_init(hrbfnpr_draw_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_renderer_draw_image(hrbfnpr_renderer* renderer, const hrbfnpr_image* image,
                                           const hrbfnpr_draw_desc* desc, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::prepared(renderer);
        const output::Image target = api::checked(api::read_struct(image, "image"));
        api::draw(*renderer, target, api::checked(api::read_optional_struct(desc, "draw_desc"), target));
    });
}

hrbfnpr_status hrbfnpr_vertex_layout_init(hrbfnpr_vertex_layout* layout, uint32_t struct_size) {
    return api::init_struct(layout, struct_size);
}

hrbfnpr_status hrbfnpr_renderer_vertex_bound(const hrbfnpr_renderer* renderer, int64_t* count, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::prepared(renderer);
        api::require_pointer(count, "count");
        *count = static_cast<std::int64_t>(handle.frame.discs().size());
    });
}

hrbfnpr_status hrbfnpr_renderer_write_vertices(const hrbfnpr_renderer* renderer, const hrbfnpr_vertex_layout* layout,
                                               void* destination, int64_t capacity, int64_t* count,
                                               hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::write_vertices(api::prepared(renderer), api::read_struct(layout, "layout"), destination, capacity, count);
    });
}

} // extern "C"
