// SPDX-License-Identifier: MIT
#include "drawings.h"

#include "arrays.h"
#include "fields.h"
#include "scenes.h"

#include <algorithm>

namespace fuzz {
namespace {

constexpr std::initializer_list<hrbfnpr_status> refusals = {
    HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_UNSUPPORTED_STRUCT, HRBFNPR_STATUS_OUT_OF_MEMORY};

hrbfnpr_drawing_info info_of(const hrbfnpr_drawing* drawing) {
    hrbfnpr_drawing_info info;
    hrbfnpr_drawing_info_init(&info, sizeof info);
    Call call("drawing_get_info");
    call.expect(hrbfnpr_drawing_get_info(drawing, &info, call.error()));
    return info;
}

std::size_t bytes_of_pixel(std::uint32_t format) {
    if (format == HRBFNPR_FORMAT_COVERAGE8) return 1;
    return format == HRBFNPR_FORMAT_RGBA32F || format == HRBFNPR_FORMAT_RGBA32F_PREMULTIPLIED ? 16 : 4;
}

void require_colours(const std::vector<float>& pixels) {
    for (const float channel : pixels)
        require(channel >= 0.0F && channel <= 1.0F, "a channel of a picture is from 0 to 1");
}

} // namespace

void require_sound_drawing(const hrbfnpr_drawing* drawing) {
    const hrbfnpr_drawing_info info = info_of(drawing);
    require(info.marks == info.outside + info.front + info.back + info.silhouette + info.culled,
            "every mark of a drawing has a class");
    std::int64_t dots = 0;
    std::int64_t strokes = 0;
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        hrbfnpr_drawing_layer_info layer_info;
        hrbfnpr_drawing_layer_info_init(&layer_info, sizeof layer_info);
        Call call("drawing_get_layer_info");
        call.expect(hrbfnpr_drawing_get_layer_info(drawing, layer, &layer_info, call.error()));
        require(layer_info.name[63] == 0, "a name ends");
        dots += layer_info.dots;
        strokes += layer_info.strokes;
    }
    require(dots == info.dots && strokes == info.strokes, "the layers of a drawing have its dots and strokes");
}

void rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_camera& camera, Input& input) {
    const auto side = [&](double pixels) {
        return static_cast<std::int32_t>(pixels >= 1.0 && pixels <= 64.0 ? pixels : 16.0);
    };
    hrbfnpr_image image;
    hrbfnpr_image_init(&image, sizeof image);
    image.format = 1 + static_cast<std::uint32_t>(input.below(7));
    image.width = side(camera.viewport[2]);
    image.height = side(camera.viewport[3]);
    const std::int64_t pixels = std::int64_t{image.width} * image.height;
    const bool is_float = bytes_of_pixel(image.format) == 16;
    std::vector<float> memory(static_cast<std::size_t>(pixels) * 4, 0.5F);
    image.pixels = memory.data();
    Room depth(pixels, 1, HRBFNPR_SCALAR_FLOAT32);
    Room id(pixels, 1, HRBFNPR_SCALAR_UINT32);
    Room kind(pixels, 1, HRBFNPR_SCALAR_UINT8);
    const std::vector<float> host(static_cast<std::size_t>(pixels), 0.5F);
    hrbfnpr_raster_desc desc;
    hrbfnpr_raster_desc_init(&desc, sizeof desc);
    const std::size_t wanted = input.below(16);
    if ((wanted & 1U) != 0) desc.depth = depth.out;
    if ((wanted & 2U) != 0) desc.id = id.out;
    if ((wanted & 4U) != 0) desc.mark_class = kind.out;
    if ((wanted & 8U) != 0) desc.host_depth = {host.data(), pixels, 0, HRBFNPR_SCALAR_FLOAT32, 1};
    change_fields(input, "hrbfnpr_raster_desc", &desc);
    if (input.once_in(4))
        image.width = static_cast<std::int32_t>(input.below(static_cast<std::size_t>(image.width) + 1));
    Call call("drawing_rasterize");
    if (!call.expect(hrbfnpr_drawing_rasterize(drawing, &image, &desc, call.error()), refusals)) {
        require(depth.is_untouched() && id.is_untouched() && kind.is_untouched(),
                "a failed call leaves arrays untouched");
        for (const float number : memory) require(number == 0.5F, "a failed call leaves an image untouched");
        return;
    }
    if (is_float) require_colours(memory);
    if (desc.depth.count == pixels && desc.depth.data != nullptr)
        require(depth.is_finite(), "the depth of a picture is finite");
}

namespace {

// One of each attribute that a vertex can have, some left out and one changed as the input says.
std::vector<hrbfnpr_vertex_attribute> some_attributes(Input& input) {
    static constexpr std::uint32_t floats[] = {3, 3, 1, 4, 3, 3, 1, 1, 1, 1, 1, 1, 1, 1};
    std::vector<hrbfnpr_vertex_attribute> attributes;
    std::uint32_t offset = 0;
    for (std::uint32_t which = 0; which < std::size(floats); ++which) {
        if (input.once_in(4)) continue;
        hrbfnpr_vertex_attribute attribute;
        hrbfnpr_vertex_attribute_init(&attribute, sizeof attribute);
        attribute.attribute = which;
        const bool is_number = which >= HRBFNPR_VERTEX_ATTRIBUTE_ID && which != HRBFNPR_VERTEX_ATTRIBUTE_LENGTH;
        attribute.scalar = is_number ? HRBFNPR_SCALAR_UINT32 : HRBFNPR_SCALAR_FLOAT32;
        attribute.offset = offset;
        offset += 4 * floats[which];
        attributes.push_back(attribute);
    }
    if (!attributes.empty() && input.once_in(4))
        change_fields(input, "hrbfnpr_vertex_attribute", &attributes[input.below(attributes.size())], {"offset"});
    return attributes;
}

void require_finite_vertices(const std::vector<float>& vertices, std::size_t stride,
                             std::span<const hrbfnpr_vertex_attribute> attributes) {
    const auto is_cut = [](const auto& attribute) { return attribute.struct_size < sizeof attribute; };
    if (std::any_of(attributes.begin(), attributes.end(), is_cut)) return; // without an offset it overlaps another one
    for (const hrbfnpr_vertex_attribute& attribute : attributes) {
        if (attribute.scalar != HRBFNPR_SCALAR_FLOAT32) continue;
        for (std::size_t at = attribute.offset / 4; at < vertices.size(); at += stride)
            require(std::isfinite(vertices[at]), "what a vertex carries is finite");
    }
}

} // namespace

void write_vertices(const hrbfnpr_drawing* drawing, Input& input) {
    constexpr std::size_t most = 32; // floats of a vertex
    const std::vector<hrbfnpr_vertex_attribute> attributes = some_attributes(input);
    hrbfnpr_vertex_layout layout;
    hrbfnpr_vertex_layout_init(&layout, sizeof layout);
    layout.primitive = HRBFNPR_PRIMITIVE_POINTS + static_cast<std::uint32_t>(input.below(3));
    layout.attributes = attributes.data();
    layout.attribute_count = static_cast<std::int64_t>(attributes.size());
    layout.attribute_stride = sizeof(hrbfnpr_vertex_attribute);
    layout.stride = 4 * most;
    std::int64_t bound = 0;
    std::int64_t indices = 0;
    Call ask("drawing_vertex_bound");
    ask.expect(hrbfnpr_drawing_vertex_bound(drawing, layout.primitive, &bound, &indices, ask.error()));
    std::vector<float> vertices(most * static_cast<std::size_t>(bound));
    std::vector<std::uint32_t> index(static_cast<std::size_t>(indices));
    std::int64_t written = -1;
    std::int64_t listed = -1;
    Call call("drawing_write_vertices");
    if (!call.expect(hrbfnpr_drawing_write_vertices(drawing, &layout, vertices.data(), bound, &written, index.data(),
                                                    indices, &listed, call.error()),
                     refusals))
        return;
    require(written == bound && listed == indices, "the bound of vertices is their number");
    require_finite_vertices(vertices, most, attributes);
    for (const std::uint32_t i : index)
        require(i < bound || i == static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART), "an index is one of a vertex");
}

void ask_for_marks(const hrbfnpr_drawing* drawing, Input& input) {
    const auto id = static_cast<std::uint32_t>(input.below(2000));
    hrbfnpr_mark_identity identity;
    hrbfnpr_mark_identity_init(&identity, sizeof identity);
    Call call("drawing_identify");
    if (call.expect(hrbfnpr_drawing_identify(drawing, id, &identity, call.error()), refusals))
        require(identity.id == id && identity.mark >= 0 && identity.stroke >= -1, "an id is that of a mark");
    const auto item = static_cast<std::int64_t>(input.below(3));
    const auto layer = static_cast<std::int64_t>(input.below(3));
    std::int64_t count = 0;
    Call measure("drawing_write_mark_indices");
    const auto mark_class = HRBFNPR_CLASS_FRONT + 2 * static_cast<std::uint32_t>(input.below(2));
    const auto primitive = HRBFNPR_PRIMITIVE_POINTS + static_cast<std::uint32_t>(input.below(3));
    measure.expect(hrbfnpr_drawing_write_mark_indices(drawing, item, layer, mark_class, primitive, nullptr, 0, &count,
                                                      measure.error()),
                   {HRBFNPR_STATUS_BUFFER_TOO_SMALL, HRBFNPR_STATUS_INVALID_ARGUMENT});
    std::vector<std::uint32_t> index(static_cast<std::size_t>(count));
    if (count == 0) return;
    Call write("drawing_write_mark_indices");
    write.expect(hrbfnpr_drawing_write_mark_indices(drawing, item, layer, mark_class, primitive, index.data(), count,
                                                    &count, write.error()));
    require(index.size() == static_cast<std::size_t>(count), "as many indices are written as were counted");
}

std::int32_t Written::write(void* user, const void* data, std::uint64_t size) {
    auto& self = *static_cast<Written*>(user);
    self.bytes.append(static_cast<const char*>(data), size);
    return self.bytes.size() > self.fails_at ? 1 : 0;
}

void write_page(const hrbfnpr_drawing* drawing, Input& input) {
    hrbfnpr_page_item item;
    hrbfnpr_page_item_init(&item, sizeof item);
    item.drawing = drawing;
    hrbfnpr_page_desc desc;
    hrbfnpr_page_desc_init(&desc, sizeof desc);
    desc.format = static_cast<std::uint32_t>(input.below(4));
    desc.items = &item;
    desc.item_count = 1;
    hrbfnpr_page_info info;
    hrbfnpr_page_info_init(&info, sizeof info);
    Written page;
    Call call("page_write");
    if (call.expect(
            hrbfnpr_page_write(scene_context().handle, &desc, Written::write, &page, &info, nullptr, call.error()),
            refusals)) {
        require(info.bytes == static_cast<std::int64_t>(page.bytes.size()), "the bytes of a page are counted");
        require_sound_page(page.bytes, desc);
    }
}

} // namespace fuzz
