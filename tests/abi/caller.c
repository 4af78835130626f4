/* SPDX-License-Identifier: MIT
 * A caller from samples to pictures that any header of this ABI version can be built with: callers.py builds it with
 * headers of the past and of a future, whose structs are longer.  It prints hashes of what it got, which must not
 * depend on the header.  CALLER_TAIL is given for a future header: it sets what an older library does not know of. */
#include <hrbfnpr.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(call) check((call), #call)

static hrbfnpr_error error;

static void check(hrbfnpr_status status, const char* call) {
    if (status == HRBFNPR_STATUS_OK) return;
    printf("%s: %s: %s\n", call, hrbfnpr_status_name(status), error.message);
    exit(1);
}

static unsigned hash(const void* data, size_t size) { /* FNV-1a */
    const unsigned char* bytes = (const unsigned char*)data;
    unsigned h = 2166136261u;
    size_t i;
    for (i = 0; i < size; ++i) h = (h ^ bytes[i]) * 16777619u;
    return h;
}

static void print_hash(const char* name, const void* data, size_t size) { printf("%s %08x\n", name, hash(data, size)); }

static hrbfnpr_context* make_context(void) {
    hrbfnpr_context_desc desc;
    hrbfnpr_context* context = NULL;
    CHECK(hrbfnpr_context_desc_init(&desc, sizeof desc));
    desc.thread_count = 1;
    CHECK(hrbfnpr_context_create(&desc, &context, &error));
    return context;
}

static hrbfnpr_model* fit(hrbfnpr_context* context) {
    static const double corners[18] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    hrbfnpr_fit_desc desc;
    hrbfnpr_model* model = NULL;
    hrbfnpr_model_info info;
    CHECK(hrbfnpr_fit_desc_init(&desc, sizeof desc));
    desc.points.data = desc.normals.data = corners;
    desc.points.count = desc.normals.count = 6;
    desc.points.scalar = desc.normals.scalar = HRBFNPR_SCALAR_FLOAT64;
    desc.points.components = desc.normals.components = 3;
#ifdef CALLER_TAIL
    memset((char*)&desc + sizeof desc - sizeof desc.of_the_future, 1, sizeof desc.of_the_future);
    if (hrbfnpr_model_fit(context, &desc, NULL, &model, &error) != HRBFNPR_STATUS_UNSUPPORTED_STRUCT) {
        printf("a field of the future was passed over: %s\n", error.message);
        exit(1);
    }
    memset((char*)&desc + sizeof desc - sizeof desc.of_the_future, 0, sizeof desc.of_the_future);
#endif
    CHECK(hrbfnpr_model_fit(context, &desc, NULL, &model, &error));
    memset(&info, 0x55, sizeof info);
    CHECK(hrbfnpr_model_info_init(&info, sizeof info));
    CHECK(hrbfnpr_model_get_info(model, &info, &error));
    if (info.samples != 6 || info.centres != 6) {
        printf("samples %d, centres %d\n", (int)info.samples, (int)info.centres);
        exit(1);
    }
    return model;
}

static hrbfnpr_point_set* generate(hrbfnpr_context* context, const hrbfnpr_model* model) {
    hrbfnpr_layer_desc layer[2];
    hrbfnpr_generate_desc desc;
    hrbfnpr_point_set* set = NULL;
    CHECK(hrbfnpr_layer_desc_init(&layer[0], sizeof layer[0]));
    CHECK(hrbfnpr_layer_desc_init(&layer[1], sizeof layer[1]));
    layer[0].budget = layer[1].budget = 2000;
    layer[1].kind = HRBFNPR_LAYER_KIND_HATCH;
    CHECK(hrbfnpr_generate_desc_init(&desc, sizeof desc));
    desc.layers = layer;
    desc.layer_count = 2;
    CHECK(hrbfnpr_point_set_generate(context, model, &desc, NULL, &set, &error));
    return set;
}

static hrbfnpr_drawing* draw(hrbfnpr_context* context, const hrbfnpr_point_set* set) {
    static const double low[3] = {-1.2, -1.2, -1.2}, high[3] = {1.2, 1.2, 1.2};
    static const double direction[3] = {0.2, 0.3, -1.0}, up[3] = {0.0, 1.0, 0.0};
    hrbfnpr_renderer* renderer = NULL;
    hrbfnpr_drawing* drawing = NULL;
    hrbfnpr_camera camera;
    hrbfnpr_style style;
    hrbfnpr_item item;
    CHECK(hrbfnpr_camera_init(&camera, sizeof camera));
    CHECK(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.6, 64.0, 64.0, 0.05, &error));
    print_hash("view", camera.view, sizeof camera.view);
    CHECK(hrbfnpr_style_init(&style, sizeof style));
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
    CHECK(hrbfnpr_item_init(&item, sizeof item));
    item.point_set = set;
    item.style = &style;
    CHECK(hrbfnpr_renderer_create(context, &renderer, &error));
    CHECK(hrbfnpr_renderer_draw(renderer, &item, 1, 0, &camera, &drawing, &error));
    hrbfnpr_renderer_release(renderer);
    return drawing;
}

static void read(const hrbfnpr_drawing* drawing) {
    static unsigned char pixels[64 * 64 * 4];
    static float vertices[3 * 20000];
    hrbfnpr_vertex_attribute attribute;
    hrbfnpr_vertex_layout layout;
    hrbfnpr_image image;
    int64_t count = 0;
    CHECK(hrbfnpr_image_init(&image, sizeof image));
    image.width = image.height = 64;
    image.pixels = pixels;
    CHECK(hrbfnpr_drawing_rasterize(drawing, &image, NULL, &error));
    print_hash("pixels", pixels, sizeof pixels);
    CHECK(hrbfnpr_vertex_attribute_init(&attribute, sizeof attribute));
    attribute.attribute = HRBFNPR_VERTEX_ATTRIBUTE_WINDOW;
    attribute.scalar = HRBFNPR_SCALAR_FLOAT32;
    CHECK(hrbfnpr_vertex_layout_init(&layout, sizeof layout));
    layout.attributes = &attribute;
    layout.attribute_count = 1;
    CHECK(hrbfnpr_drawing_write_vertices(drawing, &layout, vertices, 20000, &count, NULL, 0, NULL, &error));
    print_hash("vertices", vertices, (size_t)count * 3 * sizeof *vertices);
}

/* Files contain run times, so only their sizes are compared. */
static void save(const hrbfnpr_model* model, const hrbfnpr_point_set* set) {
    static unsigned char bytes[1 << 20];
    int64_t size = 0;
    CHECK(hrbfnpr_model_save_memory(model, bytes, sizeof bytes, &size, &error));
    print_hash("model", &size, sizeof size);
    CHECK(hrbfnpr_point_set_save_memory(set, bytes, sizeof bytes, &size, &error));
    print_hash("point_set", &size, sizeof size);
}

int main(void) {
    hrbfnpr_context* context;
    hrbfnpr_model* model;
    hrbfnpr_point_set* set;
    hrbfnpr_drawing* drawing;
    check(hrbfnpr_error_init(&error, sizeof error), "hrbfnpr_error_init");
    if (hrbfnpr_abi_version() != HRBFNPR_ABI_VERSION) return 1;
    context = make_context();
    model = fit(context);
    set = generate(context, model);
    drawing = draw(context, set);
    read(drawing);
    save(model, set);
    hrbfnpr_drawing_release(drawing);
    hrbfnpr_point_set_release(set);
    hrbfnpr_model_release(model);
    hrbfnpr_context_release(context);
    return 0;
}
