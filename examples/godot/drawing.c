/* SPDX-License-Identifier: MIT */
/* A script class for Godot 3 that draws samples or a mesh, and returns each frame as pixels and as parts of a mesh.
 *
 *   draw(points: PoolVector3Array, normals: PoolVector3Array, VIEW...) -> bool
 *   draw_mesh(vertices: PoolVector3Array, indices: PoolIntArray, VIEW...) -> bool
 *       make a picture and draw its first frame. If normals is empty, the library finds them; vertices and indices are
 *       those of Mesh.surface_get_arrays.
 *   restyle(VIEW...) -> bool                          the same surface in another style or size, and its first frame
 *   look(direction: Vector3, zoom: float) -> bool     draws a frame of the picture from another side
 *   notes() -> Array of String                        the library's choices, repairs and omissions
 *   eye() -> Vector3                                  the position of the eye
 *   frustum() -> Vector3                              the view at distance 1: offset to the right, upwards, height
 *   pixels() -> PoolByteArray                         the frame, RGBA8
 *   points() -> Array                                 the dots of the frame for ArrayMesh.add_surface_from_arrays, far
 *                                                     to near: position, colour, and in UV.x the radius in pixels
 *   strokes() -> Array                                its strokes and lines as triangles, far to near: position,
 *                                                     colour, in UV.x how far along the stroke, in pixels, and indices
 *
 * VIEW is style: String (a name from hrbfnpr_preset_name), direction: Vector3 (into the scene), up: Vector3,
 * width: int, height: int. If a vector is zero, the library chooses it. It also chooses the pen, the marks, the lines
 * and everything else, as in hrbfnpr_picture_create.
 *
 * A call that fails prints the library's message as an error of the engine, and returns false or null. */
#include "gdnative_few.h"
#include <hrbfnpr.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const gd_core* core;

typedef struct drawing {
    hrbfnpr_context* context;
    hrbfnpr_picture* picture;
    hrbfnpr_drawing* frame;
    hrbfnpr_camera camera; /* camera of the frame */
    hrbfnpr_error error;
} drawing;

/* ---- Values of the engine ---- */

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

/* Makes a pool of `count` elements to write to. Its memory is `*data` until pool_written(). */
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

/* ---- Calls of the library ---- */

static bool succeeded(const drawing* self, hrbfnpr_status status, const char* method) {
    if (status == HRBFNPR_STATUS_OK) return true;
    GD_CALL(core, GD_PRINT_ERROR, void (*)(const char*, const char*, const char*, int))
    (self->error.message, method, "hrbfnpr", 0);
    return false;
}

/* An engine's pool as a library's array with three components per element. It is valid until pool_end(). */
typedef struct pool_reader {
    const gd_pool_kind* kind;
    gd_pool pool;
    void* access;
    hrbfnpr_array array;
} pool_reader;

static pool_reader pool_begin(const gd_pool_kind* kind, const gd_variant* value) {
    const bool is_vectors = kind == &GD_VECTORS3;
    pool_reader reader = {.kind = kind};
    reader.pool = GD_CALL(core, kind->from_variant, gd_pool(*)(const gd_variant*))(value);
    reader.access = GD_CALL(core, kind->read, void* (*)(const gd_pool*))(&reader.pool);
    reader.array.data = GD_CALL(core, kind->read_data, const void* (*)(const void*))(reader.access);
    reader.array.count = GD_CALL(core, kind->size, int (*)(const gd_pool*))(&reader.pool) / (is_vectors ? 1 : 3);
    reader.array.scalar = is_vectors ? HRBFNPR_SCALAR_FLOAT32 : HRBFNPR_SCALAR_INT32;
    reader.array.components = 3;
    return reader;
}

static void pool_end(pool_reader* reader) {
    GD_CALL(core, reader->kind->read_end, void (*)(void*))(reader->access);
    GD_CALL(core, reader->kind->destroy, void (*)(gd_pool*))(&reader->pool);
}

/* Draws the picture with a camera, or with the planned one if that is NULL. After a failure the last frame stays. */
static hrbfnpr_status draw_frame(drawing* self, const hrbfnpr_camera* camera) {
    hrbfnpr_drawing* frame;
    const hrbfnpr_status status = hrbfnpr_picture_draw(self->picture, camera, NULL, &frame, &self->error);
    if (status != HRBFNPR_STATUS_OK) return status;
    hrbfnpr_drawing_release(self->frame);
    self->frame = frame;
    if (camera == NULL) return hrbfnpr_picture_get_camera(self->picture, &self->camera, &self->error);
    self->camera = *camera;
    return status;
}

/* Makes a picture of the source, or restyles the last picture if that is NULL. VIEW is described at the top. */
static hrbfnpr_status make_picture(drawing* self, const hrbfnpr_picture_source* source, gd_variant** view) {
    hrbfnpr_picture_desc desc;
    hrbfnpr_picture* picture;
    hrbfnpr_status status;
    gd_string string = GD_CALL(core, GD_VARIANT_AS_STRING, gd_string(*)(const gd_variant*))(view[0]);
    gd_char_string style = GD_CALL(core, GD_STRING_UTF8, gd_char_string(*)(const gd_string*))(&string);
    hrbfnpr_picture_desc_init(&desc, sizeof desc);
    desc.style_name = GD_CALL(core, GD_CHAR_STRING_DATA, const char* (*)(const gd_char_string*))(&style);
    as_vector(view[1], desc.direction);
    as_vector(view[2], desc.up);
    desc.width = as_int(view[3]);
    desc.height = as_int(view[4]);
    desc.sources = source;
    desc.source_count = source != NULL;
    status = source == NULL ? hrbfnpr_picture_restyle(self->picture, &desc, NULL, &picture, &self->error)
                            : hrbfnpr_picture_create(self->context, &desc, NULL, &picture, &self->error);
    GD_CALL(core, GD_CHAR_STRING_DESTROY, void (*)(gd_char_string*))(&style);
    GD_CALL(core, GD_STRING_DESTROY, void (*)(gd_string*))(&string);
    if (status != HRBFNPR_STATUS_OK) return status;
    hrbfnpr_picture_release(self->picture);
    self->picture = picture;
    return draw_frame(self, NULL);
}

static gd_variant draw(drawing* self, gd_variant** arguments) {
    hrbfnpr_picture_source source;
    pool_reader points = pool_begin(&GD_VECTORS3, arguments[0]), normals = pool_begin(&GD_VECTORS3, arguments[1]);
    hrbfnpr_picture_source_init(&source, sizeof source);
    source.points = points.array;
    if (normals.array.count > 0) source.normals = normals.array;
    const hrbfnpr_status status = make_picture(self, &source, arguments + 2);
    pool_end(&points);
    pool_end(&normals);
    return boolean(succeeded(self, status, "draw"));
}

/* Seen from outside, the engine's faces are clockwise and the library's counter-clockwise. */
static int32_t* turned_faces(const hrbfnpr_array* faces) {
    const int32_t* from = faces->data;
    int32_t* turned = malloc((size_t)(3 * faces->count + 1) * sizeof *turned);
    if (turned == NULL) abort();
    for (int64_t i = 0; i < 3 * faces->count; ++i) turned[i] = from[i - i % 3 + 2 - i % 3];
    return turned;
}

static gd_variant draw_mesh(drawing* self, gd_variant** arguments) {
    hrbfnpr_picture_source source;
    pool_reader vertices = pool_begin(&GD_VECTORS3, arguments[0]), faces = pool_begin(&GD_INTS, arguments[1]);
    int32_t* turned = turned_faces(&faces.array);
    hrbfnpr_picture_source_init(&source, sizeof source);
    source.points = vertices.array;
    source.triangles = faces.array;
    source.triangles.data = turned;
    const hrbfnpr_status status = make_picture(self, &source, arguments + 2);
    free(turned);
    pool_end(&vertices);
    pool_end(&faces);
    return boolean(succeeded(self, status, "draw_mesh"));
}

static gd_variant restyle(drawing* self, gd_variant** arguments) {
    return boolean(succeeded(self, make_picture(self, NULL, arguments), "restyle"));
}

static gd_variant look(drawing* self, gd_variant** arguments) {
    double direction[3];
    hrbfnpr_camera camera;
    as_vector(arguments[0], direction);
    hrbfnpr_camera_init(&camera, sizeof camera);
    hrbfnpr_status status = hrbfnpr_picture_look(self->picture, direction, NAN, NAN, &camera, &self->error);
    camera.projection[0] *= as_real(arguments[1]);
    camera.projection[5] *= as_real(arguments[1]);
    if (status == HRBFNPR_STATUS_OK) status = draw_frame(self, &camera);
    return boolean(succeeded(self, status, "look"));
}

static void append_text(gd_array* array, const char* text) {
    gd_variant value;
    gd_string string = GD_CALL(core, GD_STRING_FROM_UTF8, gd_string(*)(const char*))(text);
    GD_CALL(core, GD_VARIANT_NEW_STRING, void (*)(gd_variant*, const gd_string*))(&value, &string);
    GD_CALL(core, GD_ARRAY_PUSH_BACK, void (*)(gd_array*, const gd_variant*))(array, &value);
    GD_CALL(core, GD_VARIANT_DESTROY, void (*)(gd_variant*))(&value);
    GD_CALL(core, GD_STRING_DESTROY, void (*)(gd_string*))(&string);
}

static gd_variant notes(drawing* self, gd_variant** arguments) {
    gd_array texts;
    gd_variant result;
    hrbfnpr_note note;
    hrbfnpr_picture_info info;
    (void)arguments;
    hrbfnpr_note_init(&note, sizeof note);
    hrbfnpr_picture_info_init(&info, sizeof info);
    if (!succeeded(self, hrbfnpr_picture_get_info(self->picture, &info, &self->error), "notes")) return nil();
    GD_CALL(core, GD_ARRAY_NEW, void (*)(gd_array*))(&texts);
    for (int64_t i = 0; i < info.notes; ++i) {
        if (!succeeded(self, hrbfnpr_picture_get_note(self->picture, i, &note, &self->error), "notes")) break;
        append_text(&texts, note.text);
    }
    GD_CALL(core, GD_VARIANT_NEW_ARRAY, void (*)(gd_variant*, const gd_array*))(&result, &texts);
    GD_CALL(core, GD_ARRAY_DESTROY, void (*)(gd_array*))(&texts);
    return result;
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

static gd_variant frustum(drawing* self, gd_variant** arguments) {
    const double* projection = self->camera.projection;
    const double value[3] = {projection[8] / projection[0], projection[9] / projection[5], 2 / projection[5]};
    (void)arguments;
    return from_vector(value);
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

/* Returns one attribute of all vertices as an engine's array; nil after a failure. */
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

/* Turns strips into triangles, each with three vertex numbers. */
static gd_variant triangles_of(const uint32_t* strips, int64_t count) {
    gd_pool pool;
    void* data;
    int64_t triangles = 0;
    for (int pass = 0; pass < 2; ++pass) { /* the first pass counts, the second one writes */
        void* access = pass == 0 ? NULL : pool_new(&GD_INTS, 3 * triangles, &pool, &data);
        int32_t* to = pass == 0 ? NULL : data;
        int64_t length = 0; /* vertices of the present strip */
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

/* Returns the indices of all strokes' triangles; nil after a failure. */
static gd_variant indices(drawing* self, int64_t vertices, int64_t count) {
    hrbfnpr_vertex_attribute part;
    hrbfnpr_vertex_layout layout;
    hrbfnpr_vertex_attribute_init(&part, sizeof part);
    part.attribute = HRBFNPR_VERTEX_ATTRIBUTE_RADIUS; /* a layout needs at least one attribute */
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

/* Returns arrays for ArrayMesh. UV.x has the attribute `in_uv`. */
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

/* ---- The class ---- */

typedef struct method {
    const char* name;
    int count; /* number of arguments */
    gd_variant (*call)(drawing* self, gd_variant** arguments);
} method;

static const method METHODS[] = {{"draw", 7, draw},       {"draw_mesh", 7, draw_mesh}, {"restyle", 5, restyle},
                                 {"look", 2, look},       {"notes", 0, notes},         {"eye", 0, eye},
                                 {"frustum", 0, frustum}, {"pixels", 0, pixels},       {"points", 0, points},
                                 {"strokes", 0, strokes}};

static gd_variant call(gd_object* instance, void* data, void* self, int count, gd_variant** arguments) {
    const method* m = data;
    (void)instance;
    if (count == m->count) return m->call(self, arguments);
    GD_CALL(core, GD_PRINT_ERROR, void (*)(const char*, const char*, const char*, int))
    ("wrong number of arguments; drawing.c lists the methods", m->name, "hrbfnpr", 0);
    return nil();
}

/* If there is no context, later calls fail with the library's message. */
static void* create(gd_object* instance, void* data) {
    drawing* self = calloc(1, sizeof *self);
    (void)instance;
    (void)data;
    if (self == NULL) abort();
    hrbfnpr_error_init(&self->error, sizeof self->error);
    hrbfnpr_camera_init(&self->camera, sizeof self->camera);
    succeeded(self, hrbfnpr_context_create(NULL, &self->context, &self->error), "new");
    return self;
}

static void destroy(gd_object* instance, void* data, void* user) {
    drawing* self = user;
    (void)instance;
    (void)data;
    hrbfnpr_drawing_release(self->frame);
    hrbfnpr_picture_release(self->picture);
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
