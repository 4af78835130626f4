/* SPDX-License-Identifier: MIT */
/* The declarations of Godot 3's GDNative interface that drawing.c needs (core 1.0, NativeScript 1.0: frozen since
 * Godot 3.0). They are written by hand, so that no header of the engine is needed.
 *
 * An interface is a struct with a table of functions in the order of the engine's gdnative_api.json. The numbers below
 * are indices into that table. */
#ifndef GDNATIVE_FEW_H
#define GDNATIVE_FEW_H

#include <stdbool.h>
#include <stdint.h>

#if defined(_WIN32)
#define GD_EXPORT __declspec(dllexport)
#else
#define GD_EXPORT __attribute__((visibility("default")))
#endif

/* Values of the engine. Only their sizes on 64-bit systems matter here. */
typedef struct gd_variant {
    uint64_t data[3];
} gd_variant;
typedef struct gd_array {
    uint64_t data;
} gd_array;
typedef struct gd_pool { /* a PoolByteArray, PoolIntArray, PoolVector2Array, PoolVector3Array or PoolColorArray */
    uint64_t data;
} gd_pool;
typedef struct gd_string {
    uint64_t data;
} gd_string;
typedef struct gd_char_string {
    uint64_t data;
} gd_char_string;
typedef struct gd_vector3 { /* three floats, as bytes because the engine's functions return them so */
    unsigned char bytes[12];
} gd_vector3;
typedef void gd_object;

typedef void (*gd_function)(void);

typedef struct gd_version {
    unsigned major, minor;
} gd_version;

typedef struct gd_extension {
    unsigned type;
    gd_version version;
    const struct gd_extension* next;
    gd_function functions[];
} gd_extension;

typedef struct gd_core {
    unsigned type;
    gd_version version;
    const void* next;
    unsigned extension_count;
    const gd_extension** extensions;
    gd_function functions[];
} gd_core;

enum { GD_EXTENSION_NATIVESCRIPT = 1 };

/* The argument of godot_gdnative_init(). */
typedef struct gd_init_options {
    bool in_editor;
    uint64_t core_hash, editor_hash, no_hash;
    gd_function report_version_mismatch;
    void (*report_loading_error)(const gd_object* library, const char* what);
    gd_object* library;
    const gd_core* core;
    const gd_string* library_path;
} gd_init_options;

/* A class that scripts can use. */
typedef struct gd_create {
    void* (*create)(gd_object* instance, void* data);
    void* data;
    void (*free_data)(void* data);
} gd_create;
typedef struct gd_destroy {
    void (*destroy)(gd_object* instance, void* data, void* self);
    void* data;
    void (*free_data)(void* data);
} gd_destroy;
typedef struct gd_method {
    gd_variant (*call)(gd_object* instance, void* data, void* self, int count, gd_variant** arguments);
    void* data;
    void (*free_data)(void* data);
} gd_method;

/* Gets function NUMBER of an interface as a pointer of the given type. */
#define GD_CALL(interface, number, type) ((type)(interface)->functions[number])

enum { /* NativeScript */
       GD_REGISTER_CLASS = 0,
       GD_REGISTER_METHOD = 2
};

enum { /* core: arrays */
       GD_ARRAY_NEW = 323,
       GD_ARRAY_SET = 332,
       GD_ARRAY_PUSH_BACK = 351,
       GD_ARRAY_RESIZE = 354,
       GD_ARRAY_DESTROY = 361
};

/* core: each kind of pool has the same functions, at its own indices */
typedef struct gd_pool_kind {
    int create, resize, size, read, write, destroy, read_data, read_end, write_data, write_end, to_variant,
        from_variant;
} gd_pool_kind;

static const gd_pool_kind GD_BYTES = {155, 164, 169, 165, 166, 170, 268, 270, 296, 298, 530, 557};
static const gd_pool_kind GD_INTS = {171, 180, 185, 181, 182, 186, 272, 274, 300, 302, 531, 558};
static const gd_pool_kind GD_VECTORS2 = {219, 228, 233, 229, 230, 234, 284, 286, 312, 314, 534, 561};
static const gd_pool_kind GD_VECTORS3 = {235, 244, 249, 245, 246, 250, 288, 290, 316, 318, 535, 562};
static const gd_pool_kind GD_COLORS = {251, 260, 265, 261, 262, 266, 292, 294, 320, 322, 536, 563};

enum { /* core: variants, strings, errors */
       GD_VARIANT_NEW_NIL = 509,
       GD_VARIANT_NEW_BOOL = 510,
       GD_VARIANT_NEW_STRING = 514,
       GD_VARIANT_NEW_VECTOR3 = 517,
       GD_VARIANT_NEW_ARRAY = 529,
       GD_VARIANT_AS_INT = 539,
       GD_VARIANT_AS_REAL = 540,
       GD_VARIANT_AS_STRING = 541,
       GD_VARIANT_AS_VECTOR3 = 544,
       GD_VARIANT_DESTROY = 570,
       GD_CHAR_STRING_DATA = 572,
       GD_CHAR_STRING_DESTROY = 573,
       GD_STRING_UTF8 = 678,
       GD_STRING_FROM_UTF8 = 681,
       GD_STRING_DESTROY = 721,
       GD_PRINT_ERROR = 741
};

#endif
