/* SPDX-License-Identifier: MIT */
/* hrbfnpr as a class of scripts for Godot 3: samples in, each frame as pixels and as points of a mesh out.
 *
 *   fit(points: PoolVector3Array, normals: PoolVector3Array) -> bool
 *   mark(style: String, budget: int) -> bool          names as hrbfnpr_preset_name; budget 0 is the default
 *   look(direction: Vector3, up: Vector3, zoom: float, width: int, height: int) -> bool     draws a frame
 *   eye() -> Vector3, angle() -> float                where the frame is seen from, vertical angle in degrees
 *   pixels() -> PoolByteArray                         the frame, RGBA8
 *   points() -> Array                                 the same frame for ArrayMesh.add_surface_from_arrays, far to
 *                                                     near: position, colour, and in UV.x the radius in pixels
 *   strokes() -> Array                                its strokes as triangles, far to near: position, colour, in UV.x
 *                                                     how far along the stroke, in pixels, and indices
 *
 * What fails prints the library's message as an error of the engine, and returns false or null. */
#include "gdnative_few.h"
#include <hrbfnpr.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const gd_core* core;

typedef struct drawing {
    hrbfnpr_context* context;
    hrbfnpr_model* model;
    hrbfnpr_point_set* marks;
    hrbfnpr_renderer* renderer;
    hrbfnpr_drawing* frame;
    hrbfnpr_style style;
    hrbfnpr_camera camera;
    hrbfnpr_error error;
} drawing;

/* ---- values of the engine's ---- */

static gd_variant nil(void) {
    gd_variant result;
    GD_CALL(core, GD_VARIANT_NEW_NIL, void (*)(gd_variant*))(&result);
    return result;
}

static gd_variant boolean(bool value) {
    gd_variant result;
    GD_CALL(core, GD_VARIANT_NEW_BOOL, void (*)(gd_variant*, bool))(&result, value);
    return result;
}

static int32_t as_int(const gd_variant* value) {
    return (int32_t)GD_CALL(core, GD_VARIANT_AS_INT, int64_t(*)(const gd_variant*))(value);
}

static double as_real(const gd_variant* value) {
    return GD_CALL(core, GD_VARIANT_AS_REAL, double (*)(const gd_variant*))(value);
}

static void as_vector(const gd_variant* value, double* out) {
    const gd_vector3 vector = GD_CALL(core, GD_VARIANT_AS_VECTOR3, gd_vector3(*)(const gd_variant*))(value);
    float part[3];
    memcpy(part, vector.bytes, sizeof part);
    for (int i = 0; i < 3; ++i) out[i] = part[i];
}

static gd_variant from_vector(const double* value) {
    const float part[3] = {(float)value[0], (float)value[1], (float)value[2]};
    gd_vector3 vector;
    gd_variant result;
    memcpy(vector.bytes, part, sizeof part);
    GD_CALL(core, GD_VARIANT_NEW_VECTOR3, void (*)(gd_variant*, const gd_vector3*))(&result, &vector);
    return result;
}

/* A pool of `count` elements to write to.  Its memory is `*data` until pool_written. */
static void* pool_new(const gd_pool_kind* kind, int64_t count, gd_pool* pool, void** data) {
    GD_CALL(core, kind->create, void (*)(gd_pool*))(pool);
    GD_CALL(core, kind->resize, void (*)(gd_pool*, int))(pool, (int)count);
    void* access = GD_CALL(core, kind->write, void* (*)(gd_pool*))(pool);
    *data = GD_CALL(core, kind->write_data, void* (*)(const void*))(access);
    return access;
}

static gd_variant pool_written(const gd_pool_kind* kind, gd_pool* pool, void* access) {
    gd_variant result;
    GD_CALL(core, kind->write_end, void (*)(void*))(access);
    GD_CALL(core, kind->to_variant, void (*)(gd_variant*, const gd_pool*))(&result, pool);
    GD_CALL(core, kind->destroy, void (*)(gd_pool*))(pool);
    return result;
}

/* ---- calls of the library ---- */

static bool succeeded(const drawing* self, hrbfnpr_status status, const char* method) {
    if (status == HRBFNPR_STATUS_OK) return true;
    GD_CALL(core, GD_PRINT_ERROR, void (*)(const char*, const char*, const char*, int))
    (self->error.message, method, "hrbfnpr", 0);
    return false;
}

/* The engine's array of vectors as one of the library's, until vectors_end. */
typedef struct vectors {
    gd_pool pool;
    void* access;
    hrbfnpr_array array;
} vectors;

static vectors vectors_begin(const gd_variant* value) {
    vectors v;
    v.pool = GD_CALL(core, GD_VARIANT_AS_VECTORS3, gd_pool(*)(const gd_variant*))(value);
    v.access = GD_CALL(core, GD_VECTORS3.read, void* (*)(const gd_pool*))(&v.pool);
    v.array.data = GD_CALL(core, GD_VECTORS3.read_data, const void* (*)(const void*))(v.access);
    v.array.count = GD_CALL(core, GD_VECTORS3.size, int (*)(const gd_pool*))(&v.pool);
    v.array.stride = 0;
    v.array.scalar = HRBFNPR_SCALAR_FLOAT32;
    v.array.components = 3;
    return v;
}

static void vectors_end(vectors* v) {
    GD_CALL(core, GD_VECTORS3.read_end, void (*)(void*))(v->access);
    GD_CALL(core, GD_VECTORS3.destroy, void (*)(gd_pool*))(&v->pool);
}

static gd_variant fit(drawing* self, gd_variant** arguments) {
    hrbfnpr_fit_desc desc;
    vectors points = vectors_begin(arguments[0]), normals = vectors_begin(arguments[1]);
    hrbfnpr_fit_desc_init(&desc, sizeof desc);
    desc.points = points.array;
    desc.normals = normals.array;
    hrbfnpr_model_release(self->model);
    const hrbfnpr_status status = hrbfnpr_model_fit(self->context, &desc, NULL, &self->model, &self->error);
    vectors_end(&points);
    vectors_end(&normals);
    return boolean(succeeded(self, status, "fit"));
}

static uint32_t preset_of(const gd_variant* value) {
    gd_string string = GD_CALL(core, GD_VARIANT_AS_STRING, gd_string(*)(const gd_variant*))(value);
    gd_char_string utf8 = GD_CALL(core, GD_STRING_UTF8, gd_char_string(*)(const gd_string*))(&string);
    const char* name = GD_CALL(core, GD_CHAR_STRING_DATA, const char* (*)(const gd_char_string*))(&utf8);
    uint32_t preset = 0;
    while (hrbfnpr_preset_name(preset) != NULL && strcmp(name, hrbfnpr_preset_name(preset)) != 0) ++preset;
    GD_CALL(core, GD_CHAR_STRING_DESTROY, void (*)(gd_char_string*))(&utf8);
    GD_CALL(core, GD_STRING_DESTROY, void (*)(gd_string*))(&string);
    return preset;
}

static gd_variant mark(drawing* self, gd_variant** arguments) {
    enum { MOST_LAYERS = 16 }; /* of a named style */
    hrbfnpr_generate_desc desc;
    hrbfnpr_generate_desc_init(&desc, sizeof desc);
    const uint32_t preset = preset_of(arguments[0]);
    hrbfnpr_layer_desc layers[MOST_LAYERS];
    const hrbfnpr_layer_desc* of_preset = hrbfnpr_preset_layers(preset, &desc.layer_count);
    hrbfnpr_status status = hrbfnpr_style_init_preset(&self->style, sizeof self->style, preset, &self->error);
    if (desc.layer_count > MOST_LAYERS) desc.layer_count = MOST_LAYERS;
    for (int64_t i = 0; i < desc.layer_count; ++i) {
        layers[i] = of_preset[i];
        if (as_int(arguments[1]) > 0) layers[i].budget = as_int(arguments[1]);
    }
    desc.layers = layers;
    hrbfnpr_point_set_release(self->marks);
    self->marks = NULL;
    if (status == HRBFNPR_STATUS_OK) {
        status = hrbfnpr_point_set_generate(self->context, self->model, &desc, NULL, &self->marks, &self->error);
    }
    return boolean(succeeded(self, status, "mark"));
}

static hrbfnpr_status draw(drawing* self, gd_variant** arguments) {
    const double vertical_angle = 0.5, margin = 0.02;
    double direction[3], up[3];
    hrbfnpr_model_info info;
    hrbfnpr_item item;
    as_vector(arguments[0], direction);
    as_vector(arguments[1], up);
    hrbfnpr_model_info_init(&info, sizeof info);
    hrbfnpr_status status = hrbfnpr_model_get_info(self->model, &info, &self->error);
    if (status != HRBFNPR_STATUS_OK) return status;
    status = hrbfnpr_camera_fit_bounds(&self->camera, info.bounds_min, info.bounds_max, direction, up, vertical_angle,
                                       as_int(arguments[3]), as_int(arguments[4]), margin, &self->error);
    if (status != HRBFNPR_STATUS_OK) return status;
    self->camera.projection[0] *= as_real(arguments[2]);
    self->camera.projection[5] *= as_real(arguments[2]);
    hrbfnpr_item_init(&item, sizeof item);
    item.point_set = self->marks;
    item.style = &self->style;
    hrbfnpr_drawing_release(self->frame);
    return hrbfnpr_renderer_draw(self->renderer, &item, 1, 0, &self->camera, &self->frame, &self->error);
}

static gd_variant look(drawing* self, gd_variant** arguments) {
    return boolean(succeeded(self, draw(self, arguments), "look"));
}

static gd_variant eye(drawing* self, gd_variant** arguments) {
    const double* view = self->camera.view;
    double place[3];
    (void)arguments;
    for (int i = 0; i < 3; ++i) { /* the inverse of a rotation is its transpose */
        place[i] = -(view[4 * i] * view[12] + view[4 * i + 1] * view[13] + view[4 * i + 2] * view[14]);
    }
    return from_vector(place);
}

static gd_variant angle(drawing* self, gd_variant** arguments) {
    const double degrees = 360.0 / 3.14159265358979323846 * atan(1.0 / self->camera.projection[5]);
    gd_variant result;
    (void)arguments;
    GD_CALL(core, GD_VARIANT_NEW_REAL, void (*)(gd_variant*, double))(&result, degrees);
    return result;
}

static gd_variant pixels(drawing* self, gd_variant** arguments) {
    hrbfnpr_image image;
    gd_pool pool;
    (void)arguments;
    hrbfnpr_image_init(&image, sizeof image);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = (int32_t)self->camera.viewport[2];
    image.height = (int32_t)self->camera.viewport[3];
    void* access = pool_new(&GD_BYTES, (int64_t)image.width * image.height * 4, &pool, &image.pixels);
    const hrbfnpr_status status = hrbfnpr_drawing_rasterize(self->frame, &image, NULL, &self->error);
    gd_variant result = pool_written(&GD_BYTES, &pool, access);
    if (succeeded(self, status, "pixels")) return result;
    GD_CALL(core, GD_VARIANT_DESTROY, void (*)(gd_variant*))(&result);
    return nil();
}

/* One attribute of all vertices as an array of the engine's; nil after a failure. */
static gd_variant attribute(drawing* self, uint32_t primitive, const gd_pool_kind* kind, int64_t count, uint32_t which,
                            int64_t stride) {
    hrbfnpr_vertex_attribute part;
    hrbfnpr_vertex_layout layout;
    gd_pool pool;
    void* data;
    hrbfnpr_vertex_attribute_init(&part, sizeof part);
    part.attribute = which;
    part.scalar = HRBFNPR_SCALAR_FLOAT32;
    hrbfnpr_vertex_layout_init(&layout, sizeof layout);
    layout.primitive = primitive;
    layout.attributes = &part;
    layout.attribute_count = 1;
    layout.stride = stride;
    void* access = pool_new(kind, count, &pool, &data);
    memset(data, 0, (size_t)(count * stride));
    const hrbfnpr_status status =
        hrbfnpr_drawing_write_vertices(self->frame, &layout, data, count, NULL, NULL, 0, NULL, &self->error);
    gd_variant result = pool_written(kind, &pool, access);
    if (succeeded(self, status, "vertices")) return result;
    GD_CALL(core, GD_VARIANT_DESTROY, void (*)(gd_variant*))(&result);
    return nil();
}

/* Strips of vertices as triangles: their vertices' numbers, three of each. */
static gd_variant triangles_of(const uint32_t* strips, int64_t count) {
    gd_pool pool;
    void* data;
    int64_t triangles = 0;
    for (int pass = 0; pass < 2; ++pass) { /* the second one writes */
        void* access = pass == 0 ? NULL : pool_new(&GD_INTS, 3 * triangles, &pool, &data);
        int32_t* to = pass == 0 ? NULL : data;
        int64_t length = 0; /* of the strip so far */
        triangles = 0;
        for (int64_t i = 0; i < count; ++i) {
            length = strips[i] == (uint32_t)HRBFNPR_INDEX_RESTART ? 0 : length + 1;
            if (length < 3) continue;
            for (int64_t k = 0; to != NULL && k < 3; ++k) *to++ = (int32_t)strips[i - 2 + k];
            ++triangles;
        }
        if (pass == 1) return pool_written(&GD_INTS, &pool, access);
    }
    return nil();
}

/* The indices of all strokes' triangles; nil after a failure. */
static gd_variant indices(drawing* self, int64_t vertices, int64_t count) {
    hrbfnpr_vertex_attribute part;
    hrbfnpr_vertex_layout layout;
    hrbfnpr_vertex_attribute_init(&part, sizeof part);
    part.attribute = HRBFNPR_VERTEX_ATTRIBUTE_RADIUS; /* a layout has one at least */
    hrbfnpr_vertex_layout_init(&layout, sizeof layout);
    layout.primitive = HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS;
    layout.attributes = &part;
    layout.attribute_count = 1;
    float* radius = malloc((size_t)(vertices + 1) * sizeof *radius);
    uint32_t* strips = malloc((size_t)(count + 1) * sizeof *strips);
    if (radius == NULL || strips == NULL) abort();
    const hrbfnpr_status status =
        hrbfnpr_drawing_write_vertices(self->frame, &layout, radius, vertices, NULL, strips, count, NULL, &self->error);
    gd_variant result = succeeded(self, status, "strokes") ? triangles_of(strips, count) : nil();
    free(radius);
    free(strips);
    return result;
}

/* Arrays for ArrayMesh; in UV.x what `in_uv` says. */
static gd_variant mesh(drawing* self, uint32_t primitive, uint32_t in_uv) {
    enum { ARRAY_VERTEX = 0, ARRAY_COLOR = 3, ARRAY_TEX_UV = 4, ARRAY_INDEX = 8, ARRAY_MAX = 9 }; /* of ArrayMesh */
    int64_t count, index_count;
    gd_array arrays;
    gd_variant result;
    const hrbfnpr_status status =
        hrbfnpr_drawing_vertex_bound(self->frame, primitive, &count, &index_count, &self->error);
    if (!succeeded(self, status, "vertices")) return nil();
    const int place[4] = {ARRAY_VERTEX, ARRAY_COLOR, ARRAY_TEX_UV, ARRAY_INDEX};
    gd_variant part[4] = {
        attribute(self, primitive, &GD_VECTORS3, count, HRBFNPR_VERTEX_ATTRIBUTE_POSITION, 3 * sizeof(float)),
        attribute(self, primitive, &GD_COLORS, count, HRBFNPR_VERTEX_ATTRIBUTE_COLOR, 4 * sizeof(float)),
        attribute(self, primitive, &GD_VECTORS2, count, in_uv, 2 * sizeof(float)),
        primitive == HRBFNPR_PRIMITIVE_POINTS ? nil() : indices(self, count, index_count)};
    GD_CALL(core, GD_ARRAY_NEW, void (*)(gd_array*))(&arrays);
    GD_CALL(core, GD_ARRAY_RESIZE, void (*)(gd_array*, int))(&arrays, ARRAY_MAX);
    for (int i = 0; i < 4; ++i) {
        GD_CALL(core, GD_ARRAY_SET, void (*)(gd_array*, int, const gd_variant*))(&arrays, place[i], &part[i]);
        GD_CALL(core, GD_VARIANT_DESTROY, void (*)(gd_variant*))(&part[i]);
    }
    GD_CALL(core, GD_VARIANT_NEW_ARRAY, void (*)(gd_variant*, const gd_array*))(&result, &arrays);
    GD_CALL(core, GD_ARRAY_DESTROY, void (*)(gd_array*))(&arrays);
    return result;
}

static gd_variant points(drawing* self, gd_variant** arguments) {
    (void)arguments;
    return mesh(self, HRBFNPR_PRIMITIVE_POINTS, HRBFNPR_VERTEX_ATTRIBUTE_RADIUS);
}

static gd_variant strokes(drawing* self, gd_variant** arguments) {
    (void)arguments;
    return mesh(self, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS, HRBFNPR_VERTEX_ATTRIBUTE_LENGTH);
}

/* ---- the class ---- */

typedef struct method {
    const char* name;
    int count; /* of arguments */
    gd_variant (*call)(drawing* self, gd_variant** arguments);
} method;

static const method METHODS[] = {{"fit", 2, fit},       {"mark", 2, mark},      {"look", 5, look},
                                 {"eye", 0, eye},       {"angle", 0, angle},    {"pixels", 0, pixels},
                                 {"points", 0, points}, {"strokes", 0, strokes}};

static gd_variant call(gd_object* instance, void* data, void* self, int count, gd_variant** arguments) {
    const method* m = data;
    (void)instance;
    if (count == m->count) return m->call(self, arguments);
    GD_CALL(core, GD_PRINT_ERROR, void (*)(const char*, const char*, const char*, int))
    ("wrong number of arguments: see drawing.c", m->name, "hrbfnpr", 0);
    return nil();
}

/* Calls with what could not be made here fail with the library's message. */
static void* create(gd_object* instance, void* data) {
    drawing* self = calloc(1, sizeof *self);
    (void)instance;
    (void)data;
    if (self == NULL) abort();
    hrbfnpr_error_init(&self->error, sizeof self->error);
    hrbfnpr_camera_init(&self->camera, sizeof self->camera);
    if (succeeded(self, hrbfnpr_context_create(NULL, &self->context, &self->error), "new")) {
        succeeded(self, hrbfnpr_renderer_create(self->context, &self->renderer, &self->error), "new");
    }
    return self;
}

static void destroy(gd_object* instance, void* data, void* user) {
    drawing* self = user;
    (void)instance;
    (void)data;
    hrbfnpr_drawing_release(self->frame);
    hrbfnpr_renderer_release(self->renderer);
    hrbfnpr_point_set_release(self->marks);
    hrbfnpr_model_release(self->model);
    hrbfnpr_context_release(self->context);
    free(self);
}

GD_EXPORT void godot_gdnative_init(const gd_init_options* options) { core = options->core; }

GD_EXPORT void godot_gdnative_terminate(const void* options) { (void)options; }

GD_EXPORT void godot_nativescript_init(void* library) {
    const gd_extension* script = NULL;
    for (unsigned i = 0; i < core->extension_count; ++i) {
        if (core->extensions[i]->type == GD_EXTENSION_NATIVESCRIPT) script = core->extensions[i];
    }
    if (script == NULL) return;
    GD_CALL(script, GD_REGISTER_CLASS, void (*)(void*, const char*, const char*, gd_create, gd_destroy))
    (library, "Drawing", "Reference", (gd_create){create, NULL, NULL}, (gd_destroy){destroy, NULL, NULL});
    for (size_t i = 0; i < sizeof METHODS / sizeof *METHODS; ++i) {
        const gd_method entry = {call, (void*)&METHODS[i], NULL};
        GD_CALL(script, GD_REGISTER_METHOD, void (*)(void*, const char*, const char*, int, gd_method))
        (library, "Drawing", METHODS[i].name, 0, entry);
    }
}
