// SPDX-License-Identifier: MIT
// Makes pictures of any points and triangles with any descriptors and changes; draws, reads and writes them.
#include "arrays.h"
#include "fields.h"
#include "limits.h"
#include "samples.h"

#include <optional>

namespace {

using namespace fuzz;

constexpr std::initializer_list<hrbfnpr_status> failures = {
    HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_OUT_OF_MEMORY,      HRBFNPR_STATUS_SINGULAR_SYSTEM,
    HRBFNPR_STATUS_NOT_CONVERGED,    HRBFNPR_STATUS_UNSUPPORTED_STRUCT, HRBFNPR_STATUS_CANCELLED};
constexpr std::int32_t side = 40; // pixels

// The fields that an input may change. It changes a few of them, to values that fit or do not.
constexpr const char* paths[] = {
    "style.tone",         "style.halo_width",       "style.ink",         "style.hatch.radius",
    "style.layers.share", "style.lines.hidden",     "fit.kernel",        "fit.regularization",
    "mesh_fit.edges",     "marks.hatch.separation", "marks.tone_ranges", "line_set.cell_size",
    "style.visibility",   "marks.distribution",     "fit.normal_mode",   "nothing.at_all"};
constexpr const char* values[] = {"1",         "0",       "-1",       "1e300",          "nan",   "#ff8000", "auto",
                                  "published", "in-turn", "gaussian", "stipples,hatch", "1,2,3", "",        "sharp",
                                  "dashed",    "0.5"};

// Holds the sources of a picture while the picture is made.
struct Source {
    explicit Source(Input& input) : samples(some_samples(input, 40)) {
        points.emplace(samples.points, 3, input);
        hrbfnpr_picture_source_init(&desc, sizeof desc);
        desc.points = points->view;
        if (input.once_in(3)) {
            for (std::int64_t i = 0; i + 2 < samples.count(); ++i) corners.insert(corners.end(), {i, i + 1, i + 2});
            desc.triangles = {corners.data(), static_cast<std::int64_t>(corners.size() / 3), 0, HRBFNPR_SCALAR_INT64,
                              3};
        } else if (!input.once_in(3)) {
            normals.emplace(samples.normals, 3, input);
            desc.normals = normals->view;
        }
        desc.name = odd_words(input);
        change_fields(input, "hrbfnpr_picture_source", &desc, {"columns", "rows"});
    }

    Samples samples;
    std::optional<Array> points, normals;
    std::vector<std::int64_t> corners;
    hrbfnpr_picture_source desc;
};

std::int32_t swallow(void* /*user*/, const void* /*data*/, std::uint64_t /*size*/) { return 0; }

void on_event(void* user, const hrbfnpr_picture_event* event) {
    require(event->fraction >= 0.0 && event->fraction <= 1.0, "a fraction is from 0 to 1");
    require(event->note == nullptr || event->note->text[0] != 0, "a note has a text");
    if (user != nullptr) ++*static_cast<int*>(user); // NULL if the descriptor is too short to hold it
}

void require_sound(hrbfnpr_picture* picture) {
    hrbfnpr_picture_info info;
    hrbfnpr_picture_info_init(&info, sizeof info);
    Call call("picture_get_info");
    call.expect(hrbfnpr_picture_get_info(picture, &info, call.error()));
    require(info.parts >= 1 && info.marks >= 0, "a picture has parts");
    for (std::int64_t i = 0; i < info.notes; ++i) {
        hrbfnpr_note note;
        hrbfnpr_note_init(&note, sizeof note);
        Call ask("picture_get_note");
        ask.expect(hrbfnpr_picture_get_note(picture, i, &note, ask.error()));
        require(note.figure_count <= 8, "a note has eight figures at most");
    }
}

void draw(Context& context, hrbfnpr_picture* picture, Input& input) {
    hrbfnpr_drawing* drawing = nullptr;
    const Operation operation(context, input);
    Call call("picture_draw");
    const hrbfnpr_status status = hrbfnpr_picture_draw(picture, nullptr, operation.handle, &drawing, call.error());
    operation.check(status);
    require(call.expect(status, failures) == (drawing != nullptr), "a handle comes with success only");
    if (drawing == nullptr) return;
    std::vector<std::uint8_t> pixels(std::size_t{4} * side * side);
    hrbfnpr_image image;
    hrbfnpr_image_init(&image, sizeof image);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = image.height = side;
    image.pixels = pixels.data();
    Call raster("picture_rasterize");
    raster.expect(hrbfnpr_picture_rasterize(picture, drawing, nullptr, &image, raster.error()), failures);
    hrbfnpr_picture_page_desc page;
    hrbfnpr_picture_page_desc_init(&page, sizeof page);
    page.paper = input.once_in(3) ? odd_words(input) : nullptr;
    change_fields(input, "hrbfnpr_picture_page_desc", &page);
    Call write("picture_write");
    write.expect(
        hrbfnpr_picture_write(picture, drawing, nullptr, &page, swallow, nullptr, nullptr, nullptr, write.error()),
        failures);
    Call settings("picture_write_settings");
    settings.expect(hrbfnpr_picture_write_settings(picture, swallow, nullptr, settings.error()), failures);
    hrbfnpr_drawing_release(drawing);
}

void make(Context& context, Input& input) {
    const Source source(input);
    std::vector<hrbfnpr_change> changes(input.below(4));
    for (hrbfnpr_change& change : changes) {
        hrbfnpr_change_init(&change, sizeof change);
        change.field = input.one_of(paths);
        change.value = input.one_of(values);
    }
    hrbfnpr_change few;
    hrbfnpr_change_init(&few, sizeof few);
    few.field = "marks.layers.budget";
    few.value = "40";
    changes.push_back(few);
    int events = 0;
    hrbfnpr_picture_desc desc;
    hrbfnpr_picture_desc_init(&desc, sizeof desc);
    desc.preset = static_cast<std::uint32_t>(input.below(15));
    if (input.below(2) == 0) desc.flags = HRBFNPR_PICTURE_ALLOW_BLANK;
    desc.lines = input.once_in(4) ? "contour,ridges,section=z:2,border" : nullptr;
    change_fields(input, "hrbfnpr_picture_desc", &desc, {"width", "height", "size", "turn_frames"});
    desc.sources = &source.desc;
    desc.source_count = 1;
    desc.source_stride = 0;
    desc.changes = changes.data();
    desc.change_count = static_cast<std::int64_t>(changes.size());
    desc.change_stride = 0;
    desc.width = desc.height = side;
    desc.on_event = on_event;
    desc.event_user = &events;
    hrbfnpr_picture* picture = nullptr;
    const Operation operation(context, input);
    const ShortMemory memory(context, input);
    Call call("picture_create");
    const hrbfnpr_status status =
        hrbfnpr_picture_create(context.handle, &desc, operation.handle, &picture, call.error());
    operation.check(status);
    require(call.expect(status, failures) == (picture != nullptr), "a handle comes with success only");
    if (picture == nullptr) return;
    require_sound(picture);
    if ((desc.flags & HRBFNPR_PICTURE_SURFACE_ONLY) == 0) draw(context, picture, input);
    hrbfnpr_picture_release(picture);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input input(data, size);
    fuzz::Context context;
    make(context, input);
    return 0;
}
