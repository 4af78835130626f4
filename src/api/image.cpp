// SPDX-License-Identifier: MIT
// Checks the caller's images, and draws drawings into them.
#include "api/image.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/drawing.h"
#include "api/views.h"

#include <limits>

using namespace hrbfnpr;

static_assert(static_cast<int>(output::Format::rgba8) == HRBFNPR_FORMAT_RGBA8);
static_assert(static_cast<int>(output::Format::bgra8) == HRBFNPR_FORMAT_BGRA8);
static_assert(static_cast<int>(output::Format::rgba8_premultiplied) == HRBFNPR_FORMAT_RGBA8_PREMULTIPLIED);
static_assert(static_cast<int>(output::Format::bgra8_premultiplied) == HRBFNPR_FORMAT_BGRA8_PREMULTIPLIED);
static_assert(static_cast<int>(output::Format::rgba32f) == HRBFNPR_FORMAT_RGBA32F);
static_assert(static_cast<int>(output::Format::rgba32f_premultiplied) == HRBFNPR_FORMAT_RGBA32F_PREMULTIPLIED);
static_assert(static_cast<int>(output::Format::coverage8) == HRBFNPR_FORMAT_COVERAGE8);

namespace hrbfnpr::api {

template <>
hrbfnpr_image defaults() noexcept {
    hrbfnpr_image image{};
    image.format = HRBFNPR_FORMAT_RGBA8;
    return image;
}

template <>
hrbfnpr_raster_desc defaults() noexcept {
    return {};
}

namespace {

constexpr std::int32_t largest_side = 32768;

// Returns the row stride in bytes. Checks that all rows are inside the address space.
std::int64_t checked_row_stride(const hrbfnpr_image& image, std::int64_t pixel, const char* name) {
    const std::int64_t row = pixel * image.width;
    if (image.row_stride == 0) return row;
    constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max() / largest_side;
    if (image.row_stride > largest || image.row_stride < -largest ||
        (image.row_stride < row && image.row_stride > -row))
        fail(Status::invalid_argument,
             "%s.row_stride is %lld; pixels of %lld bytes make rows of %lld: it must be 0, at least that, or at "
             "most its negative",
             name, static_cast<long long>(image.row_stride), static_cast<long long>(pixel),
             static_cast<long long>(row));
    const auto address = reinterpret_cast<std::uintptr_t>(image.pixels);
    const auto reach = static_cast<std::uint64_t>(image.height - 1) *
                       static_cast<std::uint64_t>(image.row_stride < 0 ? -image.row_stride : image.row_stride);
    const std::uint64_t room = image.row_stride < 0 ? address : std::numeric_limits<std::uintptr_t>::max() - address;
    if (reach > room)
        fail(Status::invalid_argument, "%s: height %d times row_stride %lld exceeds the address space", name,
             static_cast<int>(image.height), static_cast<long long>(image.row_stride));
    return image.row_stride;
}

output::DrawSettings checked(const hrbfnpr_raster_desc& desc, const output::Image& image) {
    Checks("raster_desc").flags("flags", desc.flags, HRBFNPR_RASTER_OVER | HRBFNPR_RASTER_LINEAR_LIGHT);
    const std::int64_t count = std::int64_t{image.width} * image.height;
    output::DrawSettings settings;
    settings.over = (desc.flags & HRBFNPR_RASTER_OVER) != 0;
    settings.linear_light = (desc.flags & HRBFNPR_RASTER_LINEAR_LIGHT) != 0;
    settings.host_depth = in_view(desc.host_depth, "raster_desc.host_depth", {1, float32_only}, count);
    settings.depth = out_view(&desc.depth, "raster_desc.depth", {1, float32_only}, count);
    settings.id = out_view(&desc.id, "raster_desc.id", {1, uint32_only}, count);
    settings.mark_class = out_view(&desc.mark_class, "raster_desc.mark_class", {1, uint8_or_uint32}, count);
    return settings;
}

} // namespace

output::Image checked_image(const hrbfnpr_image& image, const char* name) {
    const Checks checks(name);
    if (image.format < HRBFNPR_FORMAT_RGBA8 || image.format > HRBFNPR_FORMAT_COVERAGE8)
        fail(Status::invalid_argument, "%s.format is %u; it must be one of HRBFNPR_FORMAT_* (1 to 7)", name,
             image.format);
    const auto format = static_cast<output::Format>(image.format);
    checks.between("width", image.width, 1, largest_side);
    checks.between("height", image.height, 1, largest_side);
    checks.not_null("pixels", image.pixels != nullptr);
    return {format, image.width, image.height, static_cast<std::byte*>(image.pixels),
            checked_row_stride(image, output::bytes_of_pixel(format), name)};
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_image_init(hrbfnpr_image* image, uint32_t struct_size) {
    return api::init_struct(image, struct_size);
}

hrbfnpr_status hrbfnpr_raster_desc_init(hrbfnpr_raster_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_drawing_rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_image* image,
                                         const hrbfnpr_raster_desc* desc, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(drawing, "drawing");
        const output::Image target = api::checked_image(api::read_struct(image, "image"), "image");
        const output::DrawSettings settings = api::checked(api::read_optional_struct(desc, "raster_desc"), target);
        const base::ScratchPool<output::Raster>::Lease raster(handle.context().drawing_scratch.rasters);
        raster->draw(handle.drawing, target, settings);
    });
}

} // extern "C"
