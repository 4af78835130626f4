// SPDX-License-Identifier: MIT
// Writes pages of a few drawings with any descriptors, pens and annotations, and checks the pages.
#include "arrays.h"
#include "drawings.h"
#include "fields.h"
#include "limits.h"
#include "scenes.h"

#include <optional>

namespace {

using namespace fuzz;

constexpr std::initializer_list<hrbfnpr_status> failures = {HRBFNPR_STATUS_INVALID_ARGUMENT,
                                                            HRBFNPR_STATUS_OUT_OF_MEMORY,
                                                            HRBFNPR_STATUS_CANCELLED,
                                                            HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                                                            HRBFNPR_STATUS_IO,
                                                            HRBFNPR_STATUS_CALLBACK};

constexpr std::size_t drawing_count = 6;

// Makes drawings with marks as dots and as hatching, with lines and hidden lines, with the published visibility, and
// with a single mark.
const hrbfnpr_drawing* make_drawing(std::size_t which) {
    static constexpr std::uint32_t presets[drawing_count] = {HRBFNPR_PRESET_CONTOUR_AND_STIPPLE,
                                                             HRBFNPR_PRESET_CROSS_HATCH,
                                                             HRBFNPR_PRESET_BLUEPRINT,
                                                             HRBFNPR_PRESET_SKETCH,
                                                             HRBFNPR_PRESET_STIPPLE,
                                                             HRBFNPR_PRESET_STIPPLE};
    static constexpr std::size_t sets[drawing_count] = {0, 0, 0, 1, 2, 4};
    hrbfnpr_style style;
    Call preset("style_init_preset");
    preset.expect(hrbfnpr_style_init_preset(&style, sizeof style, presets[which], preset.error()));
    if (which == 4) style.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    hrbfnpr_item item;
    hrbfnpr_item_init(&item, sizeof item);
    item.point_set = scene_set(sets[which]);
    item.style = &style;
    item.line_set = which < 4 ? scene_lines(which % line_set_count) : nullptr;
    const double low[3] = {-1.4, -1.4, -1.0};
    const double high[3] = {1.4, 1.4, 1.0};
    const double direction[3] = {0.3, 0.7, -0.6};
    const double up[3] = {0.0, 0.0, 1.0};
    hrbfnpr_camera camera;
    hrbfnpr_camera_init(&camera, sizeof camera);
    Call look("camera_fit_bounds");
    look.expect(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.5, 200, 160, 0.02, look.error()));
    hrbfnpr_renderer* renderer = nullptr;
    Call create("renderer_create");
    create.expect(hrbfnpr_renderer_create(scene_context().handle, &renderer, create.error()));
    hrbfnpr_drawing* drawing = nullptr;
    Call draw("renderer_draw");
    draw.expect(hrbfnpr_renderer_draw(renderer, &item, 1, 0, &camera, &drawing, draw.error()));
    hrbfnpr_renderer_release(renderer);
    return drawing;
}

const hrbfnpr_drawing* drawing_of(std::size_t which) {
    static Once<drawing_count, hrbfnpr_drawing> made;
    return made(which, make_drawing);
}

// A page descriptor and everything that it refers to.
struct Page {
    explicit Page(Input& input) {
        for (std::size_t i = 0; i < std::size(places); ++i) places[i] = 20.0 * input.unit();
        if (input.once_in(8)) places[input.below(std::size(places))] = odd_float(1.0, 2.0, input);
        for (std::size_t count = 1 + (input.once_in(3) ? input.below(3) : 0); count > 0; --count) add_item(input);
        for (std::size_t count = input.once_in(2) ? input.below(4) : 0; count > 0; --count) add_pen(input);
        points.emplace(std::span(places), 2, input);
        for (std::size_t count = input.once_in(2) ? input.below(5) : 0; count > 0; --count) add_annotation(input);
        hrbfnpr_page_desc_init(&desc, sizeof desc);
        desc.format = static_cast<std::uint32_t>(input.below(5));
        desc.flags = static_cast<std::uint32_t>(input.below(8));
        // Plotters do not support outlines.
        const bool is_plotted = desc.format == HRBFNPR_PAGE_FORMAT_HPGL || desc.format == HRBFNPR_PAGE_FORMAT_GCODE;
        desc.widths = static_cast<std::uint32_t>(is_plotted ? 1 : input.below(2));
        desc.dots = static_cast<std::uint32_t>(input.below(3));
        desc.curves = static_cast<std::uint32_t>(input.below(3));
        desc.longest = input.once_in(4) ? input.between(1.0, 40.0) : 0.0;
        desc.items = items.data();
        desc.item_count = static_cast<std::int64_t>(items.size());
        desc.item_stride = sizeof(hrbfnpr_page_item);
        desc.pens = pens.data();
        desc.pen_count = static_cast<std::int64_t>(pens.size());
        desc.pen_stride = sizeof(hrbfnpr_pen);
        desc.annotations = annotations.data();
        desc.annotation_count = static_cast<std::int64_t>(annotations.size());
        desc.annotation_stride = sizeof(hrbfnpr_annotation);
        change_fields(input, "hrbfnpr_page_desc", &desc);
    }
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;

    hrbfnpr_page_desc desc;

private:
    void add_item(Input& input) {
        hrbfnpr_page_item item;
        hrbfnpr_page_item_init(&item, sizeof item);
        item.drawing = input.once_in(32) ? nullptr : drawing_of(input.below(drawing_count));
        item.x = input.between(-10.0, 60.0);
        item.scale = input.between(0.05, 0.6);
        change_fields(input, "hrbfnpr_page_item", &item);
        items.push_back(item);
    }
    void add_pen(Input& input) {
        hrbfnpr_pen pen;
        hrbfnpr_pen_init(&pen, sizeof pen);
        pen.groups = input.once_in(2) ? odd_words(input) : nullptr;
        pen.line_type = static_cast<std::uint32_t>(input.below(16));
        pen.width = input.unit();
        pen.number = 1 + static_cast<std::uint32_t>(input.below(4));
        change_fields(input, "hrbfnpr_pen", &pen);
        pens.push_back(pen);
    }
    void add_annotation(Input& input) {
        hrbfnpr_annotation annotation;
        hrbfnpr_annotation_init(&annotation, sizeof annotation);
        annotation.text = input.once_in(2) ? odd_words(input) : nullptr;
        annotation.points = points->view;
        annotation.line_type = 1 + static_cast<std::uint32_t>(input.below(15));
        change_fields(input, "hrbfnpr_annotation", &annotation);
        annotations.push_back(annotation);
    }

    double places[8];
    std::optional<Array> points;
    std::vector<hrbfnpr_page_item> items;
    std::vector<hrbfnpr_pen> pens;
    std::vector<hrbfnpr_annotation> annotations;
};

void require_sound_info(const hrbfnpr_page_info& info, const Written& page) {
    require(info.bytes == static_cast<std::int64_t>(page.bytes.size()), "the bytes of a page are counted");
    const double lengths[] = {info.width, info.height, info.drawn, info.travelled};
    for (const double length : lengths) require(std::isfinite(length) && length >= 0.0, "a page tells lengths");
    require(info.seconds >= 0.0, "a page tells a time"); // infinite at the lowest speeds
    require(info.paths >= 0 && info.segments >= 0 && info.dropped_paths >= 0, "paths are counted");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input input(data, size);
    Context context;
    const Page page(input);
    Written written;
    if (input.once_in(16)) written.fails_at = input.below(5000);
    hrbfnpr_page_info info;
    hrbfnpr_page_info_init(&info, sizeof info);
    const Operation operation(context, input);
    const ShortMemory memory(context, input);
    Call call("page_write");
    const hrbfnpr_status status =
        hrbfnpr_page_write(context.handle, &page.desc, Written::write, &written, &info, operation.handle, call.error());
    operation.check(status);
    if (!call.expect(status, failures)) {
        require(info.bytes == 0 && info.groups == 0, "a failed call leaves its info untouched");
        return 0;
    }
    require(written.bytes.size() <= written.fails_at, "a writer that fails ends the call");
    require_sound_info(info, written);
    require_sound_page(written.bytes, page.desc);
    return 0;
}
