/*
 * hrbfnpr.h: Hermite RBF implicit surfaces, drawn in pen and ink.
 *
 * The library fits a smooth implicit surface to points with normals, places
 * marks on the surface, and draws the marks into an image of the caller or
 * hands them over as vertex arrays.  The method is that of
 *
 *   Vital Brazil, Macedo, Sousa, Velho, de Figueiredo: "A Few Good Samples:
 *   Shape & Tone Depiction for Hermite RBF Implicits", NPAR 2010,
 *
 * which the comments below cite as [NPAR] with a section number.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef HRBFNPR_H
#define HRBFNPR_H

#include <stdint.h>

/*
 * ==========================================================================
 * 0  CONTRACTS that hold for every function below
 * ==========================================================================
 *
 * Handles.  A handle is an opaque pointer.  Several threads may call functions
 *   that take `const T*` with the same handle at the same time.  A function
 *   that takes `T*` must be the only one that uses the handle.  Comments name
 *   the exceptions: _retain, _release and hrbfnpr_operation_cancel run on any
 *   thread at any time.  Several threads may use one context at the same time;
 *   its callbacks then run on all these threads.
 *
 * Ownership.  `_create`, `_fit`, `_generate` and `_load` return a handle with
 *   one reference.  `_retain` adds a reference.  `_release` removes one; the
 *   last one destroys the object.  Both ignore NULL.  A handle keeps alive
 *   whatever it needs of other handles, so handles may be released in any
 *   order.  A call reads input arrays before it returns and keeps no pointer to
 *   the caller's memory, unless its comment says so.  The caller never frees
 *   memory that the library returns.
 *
 * Descriptors.  A struct whose first field is `struct_size` must be set up with
 *   its function `_init(desc, sizeof *desc)`, which sets every field to its
 *   default.  New versions of the library add fields at the end of a struct
 *   only.  An older caller's struct is shorter: the missing fields have their
 *   defaults.  A newer caller's struct is longer: it is refused with
 *   UNSUPPORTED_STRUCT if the unknown fields are not all zero.  A struct_size
 *   below 8 or above 65536 is refused with the same status, because the struct
 *   was not set up.  `_init` of NULL returns INVALID_ARGUMENT.  Fields named
 *   `reserved` must be zero.
 *
 * Results.  Output structs (`_info`) are filled up to their struct_size.
 *   Result structs (_projection, _curvature, _ray_hits) describe arrays of the
 *   caller that a call fills; the numbers in them are written if struct_size
 *   has room for them.
 *
 * Lists.  A list of structs is a pointer, a count and a stride.  The stride is
 *   the number of bytes from one element to the next; 0 = the struct_size of
 *   the first element.  Each element is a descriptor with its own struct_size.
 *   If a list is too long, the message names the largest length.
 *
 * Failure.  A call that can fail returns a status.  Its last parameter is an
 *   hrbfnpr_error, which may be NULL.  A failed call leaves the caller's arrays
 *   and output structs untouched and sets `*out_handle` to NULL.  The message
 *   names the wrong argument, says what is wrong, and says what to do.  No C++
 *   exception, abort or signal leaves the library, and it prints nothing.  One
 *   exception: if one of the calls hrbfnpr_model_evaluate, _project, _curvature,
 *   _cast_rays and _contains, or hrbfnpr_field_evaluate, fails or is cancelled,
 *   it may already have written a part of its arrays.
 *
 * Common errors.  Comments list the errors that are special to a call.  In
 *   addition, every call may return INVALID_ARGUMENT (a needed pointer is NULL,
 *   or an argument is out of its range), UNSUPPORTED_STRUCT (see Descriptors),
 *   OUT_OF_MEMORY, CANCELLED (if it takes an operation) and CALLBACK (a custom
 *   function or run_tasks of the caller failed).
 *
 * Arrays.  Strides are in bytes.  They may be negative or larger than the
 *   element; 0 = packed.  Elements need no alignment.  Every call checks
 *   count * stride for overflow before it touches the array.  Input and output
 *   arrays of one call must not overlap, unless the comment of the call allows
 *   it.
 *
 * Geometry.  Coordinate systems are right-handed.  A matrix has 16 doubles in
 *   column-major order and acts on column vectors, as in OpenGL.  Pixel (i, j)
 *   covers [i, i+1) x [j, j+1); its centre is at (i + 0.5, j + 0.5), and j
 *   grows downward from the first row.  Lengths are in the unit of the caller's
 *   samples, unless a comment says otherwise.  Normals point outward.
 *   "Diagonal" is the length of the diagonal of the samples' bounding box; for
 *   a model without samples, that of its bounds.  The "search box" of a model
 *   is the box of its bounds, enlarged by 0.05 diagonals on every side.
 *
 * Determinism.  The same input gives the same bits for every number of threads
 *   and every thread backend, on one build and one instruction set.
 *
 * Threads.  A context starts its threads in the first call that needs them and
 *   ends them with the last reference to it.  With thread_count 1 or a
 *   `run_tasks` callback it starts none.  The library's threads take no signals
 *   of the host.  After fork() the child may go on with the parent's contexts,
 *   which start new threads in it, but the fork must not happen inside a call
 *   (in a callback).  If the library is unloaded while a context has threads, it
 *   stays in memory; on Windows until the process ends.  Callbacks run only on the thread that called the library,
 *   unless they are flagged thread-safe.  No call changes the caller's
 *   floating-point state, locale or OpenMP settings.
 *
 * Stacks.  Calls that fit a surface or find normals need a thread stack of
 *   512 KiB: hrbfnpr_model_fit, hrbfnpr_model_fit_mesh, hrbfnpr_orient,
 *   hrbfnpr_picture_create and hrbfnpr_source_inspect.  With `run_tasks` the
 *   threads that run their tasks need as much.  Every other call runs on 64 KiB;
 *   12 KiB of them are for the caller's own frames and callbacks.
 *   The stack does not grow with the number of samples or marks.
 *
 * Callbacks.  A callback must return normally: it must not throw, longjmp, or
 *   call the library with the same non-const handle.  It runs in the default
 *   floating-point state (round to nearest, no traps).
 */

#if defined(_WIN32)
#if defined(HRBFNPR_BUILD)
#define HRBFNPR_API __declspec(dllexport)
#elif defined(HRBFNPR_STATIC)
#define HRBFNPR_API
#else
#define HRBFNPR_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define HRBFNPR_API __attribute__((visibility("default")))
#else
#define HRBFNPR_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/*
 * ==========================================================================
 * 1  VERSION
 * ==========================================================================
 */

/* The version of this header.  HRBFNPR_ABI_VERSION is the number in the SONAME
 * of the shared library.  It changes only when an existing binary would break. */
enum {
    HRBFNPR_VERSION_MAJOR = 0,
    HRBFNPR_VERSION_MINOR = 1,
    HRBFNPR_VERSION_PATCH = 0,
    HRBFNPR_ABI_VERSION = 1
};

/* Returns the library's version as major * 10000 + minor * 100 + patch. */
HRBFNPR_API uint32_t hrbfnpr_version(void);

/* Returns the library's ABI version.  Compare it with HRBFNPR_ABI_VERSION. */
HRBFNPR_API uint32_t hrbfnpr_abi_version(void);

/* Returns the library's version as "major.minor.patch": static, UTF-8, never NULL. */
HRBFNPR_API const char* hrbfnpr_version_string(void);

/*
 * ==========================================================================
 * 2  STATUS AND ERRORS
 * ==========================================================================
 */

/* The result of a call.  0 is success, negative numbers are failures.  The
 * numbers never change.  Treat a number that is not in the list like INTERNAL. */
typedef int32_t hrbfnpr_status;

enum {
    HRBFNPR_STATUS_OK = 0,                  /* success */
    HRBFNPR_STATUS_INVALID_ARGUMENT = -1,   /* an argument is wrong: the message names it and says what to do */
    HRBFNPR_STATUS_OUT_OF_MEMORY = -2,      /* the allocator returned NULL */
    HRBFNPR_STATUS_BUFFER_TOO_SMALL = -3,   /* only the needed size has been written */
    HRBFNPR_STATUS_UNSUPPORTED_STRUCT = -4, /* struct_size is out of range, or unknown fields are not zero */
    HRBFNPR_STATUS_SINGULAR_SYSTEM = -5,    /* the fit has no numerically unique solution */
    HRBFNPR_STATUS_NOT_CONVERGED = -6,      /* an iteration ended before it reached its goal */
    HRBFNPR_STATUS_CANCELLED = -7,          /* hrbfnpr_operation_cancel or a progress callback ended the call */
    HRBFNPR_STATUS_IO = -8,                 /* a read or write callback failed */
    HRBFNPR_STATUS_CORRUPT_DATA = -9,       /* a stream is of another format, truncated or damaged */
    HRBFNPR_STATUS_VERSION_MISMATCH = -10,  /* a stream is newer than the library, or the header has another ABI
                                               version */
    HRBFNPR_STATUS_CALLBACK = -11,          /* a callback of the caller returned non-zero or gave invalid results */
    HRBFNPR_STATUS_INTERNAL = -99           /* a bug in the library: please report it */
};

/* Returns the name of a status, such as "INVALID_ARGUMENT", or "UNKNOWN" for a
 * number that is not in the list.  The text is static and never NULL. */
HRBFNPR_API const char* hrbfnpr_status_name(hrbfnpr_status status);

/* Describes a failure in words.  The caller owns it, sets it up once with
 * hrbfnpr_error_init, and may use it for any number of calls.  A call leaves it
 * untouched if the call succeeds or if struct_size is below 256. */
typedef struct hrbfnpr_error {
    uint32_t struct_size;  /* bytes; set by hrbfnpr_error_init */
    hrbfnpr_status status; /* the status that the failed call returned */
    char message[248];     /* UTF-8, zero-terminated; a message of more bytes is cut between two characters */
} hrbfnpr_error;

/* Sets struct_size, the status OK and an empty message.
 *
 * Errors: INVALID_ARGUMENT: `error` is NULL.  UNSUPPORTED_STRUCT: struct_size is
 * below 256. */
HRBFNPR_API hrbfnpr_status hrbfnpr_error_init(hrbfnpr_error* error, uint32_t struct_size);

/* Writes what this build of the library is, as one JSON object with the keys
 * version, abi, compiler, instruction_sets, thread_backends and dependencies.
 *
 * destination:   receives the text with a terminating zero; may be NULL if capacity is 0
 * capacity:      the size of destination in bytes, 0 or more
 * needed:        receives the bytes that the text needs, with its zero; may be NULL
 *
 * Errors: BUFFER_TOO_SMALL: capacity is below *needed; only *needed is written. */
HRBFNPR_API hrbfnpr_status hrbfnpr_build_info(char* destination, int64_t capacity, int64_t* needed);

/* Returns how this build lays out a struct, such as "hrbfnpr_fit_desc", as one
 * JSON object.  Its keys are name, size, align and fields: a list of objects with
 * name, type, offset and size (bytes), in the order of the header.  For NULL it
 * returns a list of all structs.  A binding can compare its own structs with it
 * before the first call.  The text is static and UTF-8.  The result is NULL if
 * there is no struct of that name. */
HRBFNPR_API const char* hrbfnpr_layout(const char* name);

/*
 * ==========================================================================
 * 3  VIEWS of the caller's memory
 * ==========================================================================
 */

/* The type of the numbers in an array. */
enum {
    HRBFNPR_SCALAR_FLOAT32 = 1, /* float */
    HRBFNPR_SCALAR_FLOAT64 = 2, /* double */
    HRBFNPR_SCALAR_UINT8 = 3,   /* uint8_t */
    HRBFNPR_SCALAR_UINT32 = 4,  /* uint32_t */
    HRBFNPR_SCALAR_INT32 = 5,   /* int32_t */
    HRBFNPR_SCALAR_INT64 = 6    /* int64_t */
};

/* A view of an array that a call reads: `count` elements of `components` scalars
 * each, `stride` bytes apart.  It does not own the memory.  An array with data
 * NULL and count 0 is "not given". */
typedef struct hrbfnpr_array {
    const void* data;    /* the first element */
    int64_t count;       /* number of elements */
    int64_t stride;      /* bytes from one element to the next; may be negative; 0 = packed */
    uint32_t scalar;     /* HRBFNPR_SCALAR_...: the type of each scalar */
    uint32_t components; /* number of scalars in an element, packed side by side */
} hrbfnpr_array;

/* A view of an array that a call writes.  The fields are those of hrbfnpr_array. */
typedef struct hrbfnpr_array_out {
    void* data;          /* the first element */
    int64_t count;       /* number of elements */
    int64_t stride;      /* bytes from one element to the next; may be negative; 0 = packed */
    uint32_t scalar;     /* HRBFNPR_SCALAR_...: the type of each scalar */
    uint32_t components; /* number of scalars in an element, packed side by side */
} hrbfnpr_array_out;

/* The format of an image's pixels.  The name gives the order of the channels in
 * memory.  A channel has 8 bits or is a float.  Colours are sRGB-encoded.
 * PREMULTIPLIED: colours are multiplied by alpha. */
enum {
    HRBFNPR_FORMAT_RGBA8 = 1,                 /* 4 bytes */
    HRBFNPR_FORMAT_BGRA8 = 2,                 /* 4 bytes */
    HRBFNPR_FORMAT_RGBA8_PREMULTIPLIED = 3,   /* 4 bytes */
    HRBFNPR_FORMAT_BGRA8_PREMULTIPLIED = 4,   /* 4 bytes */
    HRBFNPR_FORMAT_RGBA32F = 5,               /* 4 FLOAT32 from 0 to 1, aligned to 4 bytes */
    HRBFNPR_FORMAT_RGBA32F_PREMULTIPLIED = 6, /* 4 FLOAT32 from 0 to 1, aligned to 4 bytes */
    HRBFNPR_FORMAT_COVERAGE8 = 7              /* one byte: the share of the pixel that ink covers, of any colour */
};

/* An image of the caller.  `pixels` is the top-left pixel for either sign of
 * row_stride: for an image that is stored bottom-up, pass the address of its
 * last row and a negative row_stride. */
typedef struct hrbfnpr_image {
    uint32_t struct_size;
    uint32_t format;    /* HRBFNPR_FORMAT_...; default RGBA8 */
    int32_t width;      /* pixels; 1 to 32768 */
    int32_t height;     /* pixels; 1 to 32768 */
    void* pixels;       /* the top-left pixel */
    int64_t row_stride; /* bytes from a row to the row below; at least a row's bytes, or their negative; 0 = packed */
} hrbfnpr_image;

/* Sets every field to its default; the size and the pixels are the caller's to set. */
HRBFNPR_API hrbfnpr_status hrbfnpr_image_init(hrbfnpr_image* image, uint32_t struct_size);

/*
 * ==========================================================================
 * 4  CONTEXT: allocator, threads and log, which everything else needs
 * ==========================================================================
 */

/* A handle that holds the allocator, the threads and the log.  All other handles
 * are made from a context. */
typedef struct hrbfnpr_context hrbfnpr_context;

/* Allocates `size` bytes with an alignment of `alignment` bytes, a power of two.
 * It returns NULL if there is no memory; the call then fails with OUT_OF_MEMORY.
 * It runs on every thread that does the library's work. */
typedef void* (*hrbfnpr_allocate_fn)(void* user, uint64_t size, uint64_t alignment);
/* Frees memory that the allocate function returned.  size and alignment are
 * those of the allocation. */
typedef void (*hrbfnpr_deallocate_fn)(void* user, void* memory, uint64_t size, uint64_t alignment);

/* The level of a message in the log. */
enum {
    HRBFNPR_LOG_DEBUG = 0,  /* details for developers of the library */
    HRBFNPR_LOG_INFO = 1,   /* what a call did, with counts and times */
    HRBFNPR_LOG_WARNING = 2 /* the result may not be what the caller expects */
};

/* Receives a message of the log.  `message` is UTF-8 and valid only during the
 * callback, which runs on the thread that called the library. */
typedef void (*hrbfnpr_log_fn)(void* user, int32_t level, const char* message);

/* A task of the library, which the caller's hrbfnpr_run_tasks_fn calls once for
 * every index in [0, count). */
typedef void (*hrbfnpr_task_fn)(void* task_context, int64_t index);
/* Runs tasks on the caller's job system: it calls task(task_context, i) once for
 * every i in [0, task_count), on any threads and in any order, and returns when
 * all calls have ended.  The library may call it again on a thread that runs a
 * task.  If tasks were left out or ran twice, the library call fails with
 * CALLBACK, and the message gives their number. */
typedef void (*hrbfnpr_run_tasks_fn)(void* user, hrbfnpr_task_fn task, void* task_context,
                                     int64_t task_count);

/* Instruction sets of processors, for `highest_instruction_set` and `instruction_set`. */
enum {
    HRBFNPR_INSTRUCTION_SET_AUTO = 0,     /* the best one that both the build and the processor have */
    HRBFNPR_INSTRUCTION_SET_BASELINE = 1, /* the one that the library was compiled for */
    HRBFNPR_INSTRUCTION_SET_AVX2 = 2,     /* x86: 256 bits */
    HRBFNPR_INSTRUCTION_SET_AVX512 = 3,   /* x86: 512 bits */
    HRBFNPR_INSTRUCTION_SET_NEON = 4      /* Arm: 128 bits */
};

/* Which threads run the library's tasks.  The choice does not change the bits of
 * any result.  docs/hosts.md compares them. */
enum {
    HRBFNPR_THREAD_BACKEND_AUTO = 0,      /* RUN_TASKS if run_tasks is given, else POOL */
    HRBFNPR_THREAD_BACKEND_POOL = 1,      /* threads that the context owns.  The calling thread takes part and waits
                                             only for tasks that others have begun, so a processor that is busy with
                                             other work costs little.  Idle threads sleep */
    HRBFNPR_THREAD_BACKEND_OPENMP = 2,    /* the threads of the OpenMP runtime, shared with a host that uses it; serial
                                             in a forked child.  Use it only if no other work needs the processors.
                                             INVALID_ARGUMENT in a build without OpenMP (hrbfnpr_build_info lists
                                             thread_backends) */
    HRBFNPR_THREAD_BACKEND_RUN_TASKS = 3, /* the host's job system, through run_tasks */
    HRBFNPR_THREAD_BACKEND_SERIAL = 4     /* the calling thread alone, as with thread_count 1 */
};

/* How a context works. */
typedef struct hrbfnpr_context_desc {
    uint32_t struct_size;
    uint32_t abi_version;  /* set by _init to HRBFNPR_ABI_VERSION.  Another number is VERSION_MISMATCH */
    int32_t thread_count;  /* number of threads; 0 or more; default 0 = one for each processor; 1 = serial.  At most 256
                              are used */
    uint32_t flags;        /* must be 0 */
    uint32_t thread_backend;          /* HRBFNPR_THREAD_BACKEND_...; default AUTO */
    uint32_t highest_instruction_set; /* HRBFNPR_INSTRUCTION_SET_...; default AUTO.  A cap: better ones are not used */
    hrbfnpr_allocate_fn allocate;     /* NULL (default) = aligned operator new.  Give both functions or neither */
    hrbfnpr_deallocate_fn deallocate; /* NULL (default) = operator delete */
    void* allocator_user;             /* passed to allocate and deallocate */
    hrbfnpr_log_fn log; /* receives messages; NULL (default) = no log */
    void* log_user;     /* passed to log */
    int32_t log_level;  /* HRBFNPR_LOG_...; default DEBUG.  Messages below this level are not reported */
    uint32_t reserved;
    hrbfnpr_run_tasks_fn run_tasks; /* the host's job system; NULL (default) = none.  Needs thread_backend AUTO or
                                       RUN_TASKS */
    void* run_tasks_user;           /* passed to run_tasks */
} hrbfnpr_context_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_context_desc_init(hrbfnpr_context_desc* desc, uint32_t struct_size);

/* Creates a context.  `desc` NULL = all defaults.  The callbacks and their user
 * pointers must stay valid until the context and everything that was made from
 * it are released.
 *
 * Errors: VERSION_MISMATCH: the header and the library have different ABI
 * versions. */
HRBFNPR_API hrbfnpr_status hrbfnpr_context_create(const hrbfnpr_context_desc* desc,
                                                  hrbfnpr_context** out_context, hrbfnpr_error* error);
HRBFNPR_API void hrbfnpr_context_retain(hrbfnpr_context* context);  /* Adds a reference.  Any thread. */
HRBFNPR_API void hrbfnpr_context_release(hrbfnpr_context* context); /* Removes a reference.  Any thread. */

/* The settings that a context uses, and its memory. */
typedef struct hrbfnpr_context_info {
    uint32_t struct_size;
    int32_t thread_count;     /* number of threads that a large call uses */
    uint32_t instruction_set; /* the instruction set in use */
    uint32_t thread_backend;  /* HRBFNPR_THREAD_BACKEND_POOL, OPENMP, RUN_TASKS or SERIAL */
    int64_t bytes_now;  /* bytes that are allocated through this context now */
    int64_t bytes_peak; /* the largest number of bytes that were ever allocated at the same time */
} hrbfnpr_context_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_context_info_init(hrbfnpr_context_info* info, uint32_t struct_size);
/* Fills `info` with the settings in use and the memory of a context. */
HRBFNPR_API hrbfnpr_status hrbfnpr_context_get_info(const hrbfnpr_context* context,
                                                    hrbfnpr_context_info* info, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 5  OPERATION: progress and cancelling of one long call
 * ==========================================================================
 *
 * Pass an operation to a long call, then poll and cancel it from any thread.  An
 * operation serves one call at a time; a second call at the same time fails with
 * INVALID_ARGUMENT.  It may serve other calls afterwards: each sets the progress
 * back to 0.  A cancelled operation stays cancelled, and every later call that
 * takes it returns CANCELLED at once.
 */

/* A handle through which one long call reports its progress and is cancelled. */
typedef struct hrbfnpr_operation hrbfnpr_operation;

/* Receives the progress of a call, from 0 to 1, at irregular intervals.  The
 * progress never falls within a call.  The callback runs on the thread that made
 * the call.  Return 0 to go on; any other number cancels the call, which then
 * returns CANCELLED. */
typedef int32_t (*hrbfnpr_progress_fn)(void* user, double progress);

/* Creates an operation. */
HRBFNPR_API hrbfnpr_status hrbfnpr_operation_create(hrbfnpr_context* context,
                                                    hrbfnpr_operation** out_operation,
                                                    hrbfnpr_error* error);
HRBFNPR_API void hrbfnpr_operation_retain(hrbfnpr_operation* operation);  /* Adds a reference.  Any thread. */
HRBFNPR_API void hrbfnpr_operation_release(hrbfnpr_operation* operation); /* Removes a reference.  Any thread. */
/* Cancels the call that uses the operation, and all later ones.  Any thread, any
 * time, any number of times.  NULL is ignored. */
HRBFNPR_API void hrbfnpr_operation_cancel(hrbfnpr_operation* operation);
/* Returns 1 after a cancel, else 0.  Any thread.  NULL gives 0. */
HRBFNPR_API int32_t hrbfnpr_operation_is_cancelled(const hrbfnpr_operation* operation);
/* Returns the progress of the call, from 0 to 1.  Any thread.  NULL gives 0. */
HRBFNPR_API double hrbfnpr_operation_progress(const hrbfnpr_operation* operation);
/* Sets the function that receives the progress; `callback` NULL removes it.
 *
 * Errors: INVALID_ARGUMENT: a call uses the operation at present. */
HRBFNPR_API hrbfnpr_status hrbfnpr_operation_set_callback(hrbfnpr_operation* operation,
                                                          hrbfnpr_progress_fn callback, void* user,
                                                          hrbfnpr_error* error);

/*
 * Streams save and load models and point sets.  Both callbacks run on the thread
 * that called the library.
 */

/* Writes all `size` bytes of `data`.  Return 0 on success; any other number fails
 * the call with IO. */
typedef int32_t (*hrbfnpr_write_fn)(void* user, const void* data, uint64_t size);
/* Reads up to `size` bytes into `data`.  Return the number of bytes read, 0 at the
 * end of the stream, or a negative number, which fails the call with IO. */
typedef int64_t (*hrbfnpr_read_fn)(void* user, void* data, uint64_t size);

/*
 * ==========================================================================
 * 6  MODEL: an implicit surface f = 0, immutable          [NPAR 4]
 * ==========================================================================
 *
 * A model is a function f of the place x.  The surface is where f = 0, the inside
 * is where f < 0.  Four calls make models: hrbfnpr_model_fit from samples,
 * hrbfnpr_model_fit_mesh from triangles (such a model may consist of several
 * smooth "sheets" that meet in creases), hrbfnpr_model_create_custom from a
 * function of the caller, and hrbfnpr_model_create_csg from other models and
 * primitives.
 */

/* A handle to an implicit surface.  It never changes. */
typedef struct hrbfnpr_model hrbfnpr_model;

/* Radial functions phi(r) [NPAR 4.1]. */
enum {
    HRBFNPR_KERNEL_TRIHARMONIC = 0, /* r^3, without a parameter; the default */
    HRBFNPR_KERNEL_GAUSSIAN = 1,    /* exp(-r^2 / (2 radius^2)) */
    HRBFNPR_KERNEL_WENDLAND_C2 = 2, /* (1 - r/radius)^4 (4 r/radius + 1) for r < radius, else 0 */
    HRBFNPR_KERNEL_CUSTOM = 3,      /* not for fits: reported for a model made by _create_custom */
    HRBFNPR_KERNEL_CSG = 4          /* not for fits: reported for a model made by _create_csg */
};

/* How the linear system of a fit is solved.  docs/how-fitting-works.md explains both ways. */
enum {
    HRBFNPR_SOLVER_AUTO = 0,   /* DIRECT for few samples, ITERATIVE for many */
    HRBFNPR_SOLVER_DIRECT = 1, /* dense factorization: memory grows with N^2, time with N^3 */
    HRBFNPR_SOLVER_ITERATIVE = 2 /* preconditioned conjugate gradients: memory grows with N.  TRIHARMONIC needs
                                    polynomial_degree 1 or more [Schaefer, Katzfuss, Owhadi 2021] */
};

/* Why a fit used the solver that it used. */
enum {
    HRBFNPR_SOLVER_REASON_REQUESTED = 0,     /* the caller named it */
    HRBFNPR_SOLVER_REASON_SMALL = 1,         /* AUTO took DIRECT, which is faster for few samples */
    HRBFNPR_SOLVER_REASON_LARGE = 2,         /* AUTO took ITERATIVE: DIRECT would need too much memory or time */
    HRBFNPR_SOLVER_REASON_NOT_CONVERGED = 3, /* AUTO took DIRECT, because ITERATIVE did not reach its tolerance */
    HRBFNPR_SOLVER_REASON_NOT_DEFINITE = 4   /* AUTO took DIRECT, because ITERATIVE needs a definite system */
};

/* What a fit does with samples that look wrong.  It counts them in any case. */
enum {
    HRBFNPR_REPAIR_KEEP = 0,    /* uses them as they are */
    HRBFNPR_REPAIR_DROP = 1,    /* leaves them out */
    HRBFNPR_REPAIR_REORIENT = 2 /* turns their normals round; for flipped normals only */
};

/* Where the regularization of a fit comes from. */
enum {
    HRBFNPR_REGULARIZATION_GIVEN = 0, /* the field `regularization` */
    HRBFNPR_REGULARIZATION_AUTO = 1   /* the measured noise of the samples; 0 for samples without noise */
};

/* How far the given normals can be trusted, for a fit and for hrbfnpr_orient. */
enum {
    HRBFNPR_NORMALS_GIVEN = 0,      /* they are correct and point outward */
    HRBFNPR_NORMALS_NONE = 1,       /* there are none, or they are useless: all are made */
    HRBFNPR_NORMALS_UNORIENTED = 2, /* the directions are correct, the signs are not */
    HRBFNPR_NORMALS_MIXED = 3,      /* the directions and most signs are correct; some patches are turned */
    HRBFNPR_NORMALS_INWARD = 4,     /* they are consistent, but all point inward */
    HRBFNPR_NORMALS_AUTO = 5        /* find out which of these holds, and repair accordingly */
};

/* Whether a fitted surface ends where its samples end (see hrbfnpr_model_trim). */
enum {
    HRBFNPR_TRIM_NEVER = 0, /* the surface goes on to the end of the search box */
    HRBFNPR_TRIM_AUTO = 1   /* an open surface ends where the given samples end (all of them, not only the chosen
                               centres).  A closed surface stays whole, and so does one of fewer than ten samples.
                               hrbfnpr_model_get_trim_info says what was done */
};

/* What to fit: N points with N outward normals, and how.
 * docs/how-fitting-works.md explains the methods.
 *
 * Repairs.  The fit accepts and counts (hrbfnpr_model_info) the following.
 * Normals that are not of unit length are normalized.  Samples at the same place
 * (within 1e-9 diagonals) with the same normal (within 1 degree) are merged.  Of
 * 33 samples or more, near duplicates are merged: closer than 1e-3 of the local
 * spacing, normals within 15 degrees.  If many samples contradict each other so
 * much that the iterations break down, the fit adds a little regularization and
 * raises the solver tolerance; the log and hrbfnpr_model_info.regularization say
 * so.
 *
 * Refused samples.  INVALID_ARGUMENT: samples at the same place with different
 * normals (the message gives both indices); NaN, infinity, zero normals;
 * coordinates beyond 1e100; samples less than 1e-100 across; empty arrays, or
 * arrays of different counts.  One sample is enough: its surface is a plane.
 *
 * Outliers and flipped normals.  Of 33 samples or more, the fit counts samples
 * that do not agree with the 16 nearest others, and repairs them if `outliers`
 * or `flipped_normals` says so.  Outliers are far from their neighbours or from
 * their neighbours' tangent planes, or are the worse of two near duplicates with
 * different normals.  A flipped normal is opposite to nearly all neighbours'
 * normals on the same sheet.
 *
 * Choosing centres.  With `tolerance` or `maximum_centres` the fit chooses some
 * samples as centres: first evenly spread ones, then in rounds those that the
 * last fit missed most.  It ends when every sample is within the tolerance
 * (|f| / |grad f|) or maximum_centres is reached.  If the tolerance is not
 * reached, the call still succeeds: hrbfnpr_model_info gives what was reached,
 * and the log warns.  With regularization, the tolerance applies to means over a
 * sample and its 16 neighbours, so that centres do not follow noise.
 *
 * Normals.  With a normal_mode other than GIVEN, the fit first makes or repairs
 * the normals as hrbfnpr_orient with its defaults does.  With GIVEN, normals that
 * all point into a closed surface are fitted as they are; the log warns, and
 * hrbfnpr_model_info.normals_inward is 1. */
typedef struct hrbfnpr_fit_desc {
    uint32_t struct_size;
    uint32_t kernel;         /* HRBFNPR_KERNEL_...: the radial function; TRIHARMONIC, GAUSSIAN or WENDLAND_C2; default
                                TRIHARMONIC */
    hrbfnpr_array points;    /* N x 3, FLOAT32 or FLOAT64: the places of the samples */
    hrbfnpr_array normals;   /* N x 3, FLOAT32 or FLOAT64: outward normals of any length; normal_mode may say
                                otherwise */
    double kernel_radius;    /* radius of GAUSSIAN and WENDLAND_C2, in the unit of the points; 0 or more; default
                                0 = from the sample spacing.  A larger radius fills larger gaps, but makes the system
                                worse conditioned */
    int32_t polynomial_degree; /* degree of the polynomial that is added to the kernels; -1 (none) to 3; default 1.
                                  TRIHARMONIC is well-posed from 1 on [Duchon 1977]; below that the fit may fail with
                                  SINGULAR_SYSTEM */
    uint32_t regularization_mode; /* HRBFNPR_REGULARIZATION_...; default GIVEN.  AUTO needs regularization 0 */
    double regularization;   /* smoothing of the fit, added to the diagonal of the system in coordinates in which the
                                samples' diagonal is 1; 0 or more; default 0 = pass through every sample.  Larger values
                                give a smoother surface that keeps a distance from noisy samples */
    uint32_t outliers;        /* HRBFNPR_REPAIR_KEEP or DROP; default KEEP */
    uint32_t flipped_normals; /* HRBFNPR_REPAIR_...; default KEEP */
    double tolerance;        /* largest distance of a sample from the surface at which no more centres are chosen, in
                                the unit of the points; 0 or more; default 0 = none.  Smaller values give more
                                centres */
    int64_t maximum_centres; /* largest number of samples that are chosen as centres; 0 or more; default 0 = no limit.
                                If tolerance is 0, too, every sample is a centre */
    uint32_t solver;          /* HRBFNPR_SOLVER_...; default AUTO */
    int32_t refinement_steps; /* steps of iterative refinement after a DIRECT solve; 0 to 20; default 2.  More steps
                                 give smaller residuals */
    double solver_tolerance;  /* relative residual at which ITERATIVE ends; 0 to 0.1; default 0 = 1e-10 up to 2048
                                 centres, 1e-8 beyond, or, if rounding allows no more, up to 1e-6 with a warning in the
                                 log */
    int32_t iteration_limit;  /* largest number of iterations of ITERATIVE; 1 to 1000000; default 200 */
    uint32_t preconditioner_neighbours; /* neighbours of each sample in the preconditioner of ITERATIVE; 1 to 48;
                                           default 0 = by the kernel and the number of samples.  More neighbours give
                                           fewer iterations and a slower setup */
    uint32_t normal_mode;     /* HRBFNPR_NORMALS_...: how far `normals` can be trusted; default GIVEN.  NONE and AUTO
                                 work without normals */
    uint32_t trim;            /* HRBFNPR_TRIM_...; default AUTO */
} hrbfnpr_fit_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_fit_desc_init(hrbfnpr_fit_desc* desc, uint32_t struct_size);

/* Fits f with f(x_i) = 0 and grad f(x_i) = n_i at the samples, so that f < 0
 * inside, f > 0 outside, and |grad f| is near 1 at the surface [NPAR 4.1,
 * equations 1, 2].  The fit works in double precision and in coordinates in which
 * the mean sample spacing is 1, whatever the caller's unit.
 *
 * desc:        what to fit
 * operation:   may be NULL
 *
 * Errors: INVALID_ARGUMENT: see hrbfnpr_fit_desc.  OUT_OF_MEMORY: the message gives
 * the bytes that are needed.  SINGULAR_SYSTEM: the system has no unique solution;
 * the message says how to change it.  NOT_CONVERGED: ITERATIVE did not reach its
 * tolerance; the message gives the residual. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_fit(hrbfnpr_context* context, const hrbfnpr_fit_desc* desc,
                                             hrbfnpr_operation* operation, hrbfnpr_model** out_model,
                                             hrbfnpr_error* error);

/* The points of hrbfnpr_orient: N points without normals, or with normals that may
 * be wrong.  docs/how-fitting-works.md explains the method.
 *
 * Outward.  For a closed surface, outward is the side that it does not enclose.
 * For an open surface it is the side that the viewpoint sees, if one is given; else
 * the convex side, if the surface encloses one side more than the other; else, as for
 * a terrain, the side of `up`.  A closed surface inside another one bounds a hole: its
 * normals point into the hole.
 *
 * Points that coincide (within 1/100 of the spacing) get the same normal. */
typedef struct hrbfnpr_orient_desc {
    uint32_t struct_size;
    uint32_t mode;         /* HRBFNPR_NORMALS_...: how far `normals` can be trusted; default AUTO.  GIVEN only looks: it
                              changes no normal */
    hrbfnpr_array points;  /* N x 3, FLOAT32 or FLOAT64 */
    hrbfnpr_array normals; /* N x 3, FLOAT32 or FLOAT64, of any length; a zero normal is unknown and is made.  Not
                              needed with NONE and AUTO */
    double up[3];          /* the direction that decides for surfaces like a terrain; of any length, not 0; default
                              (0, 0, 1) */
    double viewpoint[3];   /* the place from which the points were seen; used with has_viewpoint; default (0, 0, 0) */
    uint32_t has_viewpoint; /* 1: normals of open surfaces point to the side of the viewpoint; 0: the viewpoint is
                               ignored; default 0 */
    uint32_t reserved;
} hrbfnpr_orient_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_orient_desc_init(hrbfnpr_orient_desc* desc, uint32_t struct_size);

/* How hrbfnpr_orient decided which side is outward. */
enum {
    HRBFNPR_OUTWARD_INSIDE = 0,    /* the surface encloses the other side */
    HRBFNPR_OUTWARD_UP = 1,        /* `up` points to this side */
    HRBFNPR_OUTWARD_VIEWPOINT = 2, /* the viewpoint is on this side */
    HRBFNPR_OUTWARD_AS_GIVEN = 3   /* most given normals point to this side */
};

/* What hrbfnpr_orient found and did. */
typedef struct hrbfnpr_orient_info {
    uint32_t struct_size;
    uint32_t found;         /* HRBFNPR_NORMALS_...: how far the given normals could be trusted; NONE also if they have
                               nothing to do with the points, as colours have not */
    int64_t turned;         /* number of given normals that were turned round */
    int64_t made;           /* number of normals that were made, because they were missing, zero or useless */
    int64_t merged;         /* number of points that coincide with another one */
    double direction_change; /* mean angle between the lines of the given and the resulting normals, in degrees; NaN if
                                no normals are given */
    double noise;           /* standard deviation of the points from their surface, in their unit; 0 if no noise is
                               seen */
    double spacing;         /* median distance of a point to its nearest neighbour, in the unit of the points */
    double energy;          /* bending energy of the result per degree of freedom, in spacings.  Below 0.006: the points
                               resolve the surface; 0.026: points without any order */
    double confidence;      /* how sure the result is; 0 to 1.  A heuristic, not a probability: results above 0.9 are
                               usually right; check the others */
    uint32_t closed;        /* 1: the points surround one or several solids */
    uint32_t outward_by;    /* HRBFNPR_OUTWARD_...: how the outward side was decided */
    int64_t components;     /* number of pieces that lie apart by more than their spacing */
    double seconds;         /* time of the call */
} hrbfnpr_orient_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_orient_info_init(hrbfnpr_orient_info* info, uint32_t struct_size);

/* Finds outward unit normals for points, or repairs given normals.  A low
 * confidence is no error; the log warns.  Time and memory grow with N.
 * [VIPSS: Huang, Carr, Ju, "Variational implicit point set surfaces", 2019]
 *
 * out_normals:   receives N x 3 normals, FLOAT32 or FLOAT64; may be the given normals' memory.  Given
 *                normals that stay keep their bits (if the scalar types agree); turned ones change their sign only
 * info:          may be NULL
 * operation:     may be NULL
 *
 * Errors: INVALID_ARGUMENT: fewer than 4 different points; all points are on one
 * line; NaN or infinity; no normals with a mode that needs them; `up` is 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_orient(hrbfnpr_context* context, const hrbfnpr_orient_desc* desc,
                                          hrbfnpr_operation* operation, const hrbfnpr_array_out* out_normals,
                                          hrbfnpr_orient_info* info, hrbfnpr_error* error);

/* The image of a depth camera (Kinect, RealSense, time of flight, stereo): one
 * point for each of columns x rows pixels.
 *
 * The camera is at the origin and looks along +z or -z.  x / z grows or falls with
 * the column, y / z with the row.  For an image of depths z with the focal lengths
 * f and the centre c in pixels, the points are
 * x = (column - c_x) z / f_x and y = (row - c_y) z / f_y.
 *
 * docs/how-fitting-works.md explains the method. */
typedef struct hrbfnpr_depth_image_desc {
    uint32_t struct_size;
    int32_t columns;       /* pixels in a row; 8 to 65535 */
    int32_t rows;          /* number of rows; 8 to 65535 */
    uint32_t keep_points;  /* 1: the points stay where they are and only get normals; 0: they are smoothed; default 0 */
    hrbfnpr_array points;  /* rows * columns x 3, row by row, FLOAT32 or FLOAT64.  NaN, infinity or z = 0: nothing was
                              seen at the pixel */
    double noise;          /* standard deviation of 1 / z, in 1 / (unit of the points); 0 or more; default
                              0 = measured */
    double smoothing;      /* factor of the radius over which pixels are averaged; above 0, at most 100; default 1.
                              Larger values remove more noise and more small shapes */
} hrbfnpr_depth_image_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_depth_image_desc_init(hrbfnpr_depth_image_desc* desc, uint32_t struct_size);

/* What hrbfnpr_smooth_depth_image found and did. */
typedef struct hrbfnpr_depth_image_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t seen;         /* number of pixels with a point */
    int64_t left_out;     /* number of these that are left out, because too few other pixels lie on their plane */
    double noise;         /* standard deviation of 1 / z, as given or measured */
    double focal_length;  /* mean of the focal lengths in both directions, in pixels */
    double depth;         /* median of |z| over the points */
    double radius;        /* radius of the smoothing at this depth, in pixels */
    double seconds;       /* time of the call */
} hrbfnpr_depth_image_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_depth_image_info_init(hrbfnpr_depth_image_info* info, uint32_t struct_size);

/* Removes the sensor's noise from the image of a depth camera, and finds normals.
 * To choose some of the points, evenly spread over the image, pass x / z, y / z and
 * log |z| to hrbfnpr_farthest_points.
 *
 * out_points:    receives rows * columns x 3 points, FLOAT32 or FLOAT64; NaN where nothing was seen and for points that
 *                are left out, such as those between an edge and what it hides; may be the memory of desc->points; may
 *                be NULL
 * out_normals:   receives as many unit normals, which point to the camera; 0 where out_points is NaN; may be NULL
 * info:          may be NULL
 * operation:     may be NULL
 *
 * Errors: INVALID_ARGUMENT: the points are not such an image. */
HRBFNPR_API hrbfnpr_status hrbfnpr_smooth_depth_image(hrbfnpr_context* context, const hrbfnpr_depth_image_desc* desc,
                                                      hrbfnpr_operation* operation,
                                                      const hrbfnpr_array_out* out_points,
                                                      const hrbfnpr_array_out* out_normals,
                                                      hrbfnpr_depth_image_info* info, hrbfnpr_error* error);

/* Evaluates the caller's function at `count` points.  Return 0 on success; any other
 * number fails the whole call with CALLBACK.
 *
 * points:     count x 3: x, y, z
 * value:      receives count values of f
 * gradient:   receives count x 3 derivatives; may be NULL
 * hessian:    receives count x 6 derivatives, xx xy xz yy yz zz; may be NULL */
typedef int32_t (*hrbfnpr_implicit_fn)(void* user, int64_t count, const double* points, double* value,
                                       double* gradient, double* hessian);

/* What a custom function can do.  Without a flag, the library computes the
 * derivatives by differences and passes NULL for them. */
enum {
    HRBFNPR_CUSTOM_HAS_GRADIENT = 1, /* the function fills `gradient` */
    HRBFNPR_CUSTOM_HAS_HESSIAN = 2,  /* the function fills `hessian` */
    HRBFNPR_CUSTOM_THREAD_SAFE = 4   /* the function may run on several threads at the same time; else it runs on one at
                                        a time, on the thread that called the library */
};

/* An implicit function of the caller, in place of a fit [NPAR 8].
 *
 * The function should be negative inside and have a gradient of a length near 1 at
 * the surface.  It must be finite in a box twice as wide as the bounds.  Where it is
 * not finite, or where its gradient is shorter than 1e-150 or longer than 1e150, no
 * point is projected and no mark is placed.
 *
 * The diagonal of the bounds must be from 1e-100 to 1e100.  Make the bounds fit the
 * surface closely: tolerances, differences and the cells in which marks are placed
 * are shares of the diagonal. */
typedef struct hrbfnpr_custom_desc {
    uint32_t struct_size;
    uint32_t flags; /* HRBFNPR_CUSTOM_... flags, or-ed; default 0 */
    hrbfnpr_implicit_fn function; /* the function; must be given */
    void* user;                   /* passed to function and release */
    void (*release)(void* user); /* called once, on the thread that releases the last reference; NULL
                                    (default) = nothing to do.  It is not called if the model cannot be created */
    double bounds_min[3];        /* lower corner of the box that holds the surface */
    double bounds_max[3];        /* upper corner of the box */
    double difference_step;      /* step of the differences, in the unit of the points; 0 or more; default 0 = 1e-4
                                    diagonals for gradients, 1e-3 for Hessians */
} hrbfnpr_custom_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_custom_desc_init(hrbfnpr_custom_desc* desc, uint32_t struct_size);
/* Creates a model from a function of the caller.
 *
 * Errors: INVALID_ARGUMENT: no function, or bounds that span no box. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_create_custom(hrbfnpr_context* context,
                                                       const hrbfnpr_custom_desc* desc,
                                                       hrbfnpr_model** out_model, hrbfnpr_error* error);

HRBFNPR_API void hrbfnpr_model_retain(const hrbfnpr_model* model);  /* Adds a reference.  Any thread. */
HRBFNPR_API void hrbfnpr_model_release(const hrbfnpr_model* model); /* Removes a reference.  Any thread. */

/* What a fit found and did.  Lengths are in the unit of the points.  A custom model
 * and a solid have bounds, kernel and bytes only. */
typedef struct hrbfnpr_model_info {
    uint32_t struct_size;
    uint32_t kernel;          /* HRBFNPR_KERNEL_...: the one used */
    int32_t polynomial_degree; /* the one used; -1 = none */
    int32_t choice_rounds;    /* number of fits that were made to choose the centres; 0 if all samples are centres */
    int64_t samples;          /* number of samples as given */
    int64_t centres;          /* number of centres, after merging, repairing and choosing */
    int64_t merged_samples;   /* number of samples that were merged into another one at the same place */
    int64_t near_duplicates;  /* number of samples that were merged into another one much nearer than the spacing */
    int64_t rescaled_normals; /* number of normals whose length differed from 1 by more than 1e-4 */
    int64_t outliers_found;   /* number of samples far from all others, or from the tangent planes around them */
    int64_t outliers_dropped; /* number of these that were left out */
    int64_t flipped_found;    /* number of normals that are opposite to those of their neighbours */
    int64_t flipped_repaired; /* number of these that were left out or turned round */
    double bounds_min[3];     /* lower corner of the samples' box.  For up to 20 000 samples along curves, or 100
                                 others, it also holds the surface, if that closes within a third of a diagonal */
    double bounds_max[3];     /* upper corner of the box */
    double spacing;           /* mean distance of a sample to its nearest neighbour */
    double kernel_radius;     /* the one used; 0 for TRIHARMONIC */
    double regularization;    /* the one used; with AUTO, that of the values */
    double noise_estimate;    /* standard deviation of the samples from their surface; 0 if no noise is seen, NaN with
                                 regularization GIVEN */
    double value_residual_max;    /* largest |f(x_i)| at the centres */
    double value_residual_rms;    /* root mean square of |f(x_i)| */
    double gradient_residual_max; /* largest |grad f(x_i) - n_i| at the centres */
    double gradient_residual_rms; /* root mean square of |grad f(x_i) - n_i| */
    double input_distance_max;    /* largest distance |f| / |grad f| of a sample from the surface; dropped ones do not
                                     count */
    double input_distance_rms;    /* root mean square of these distances */
    double input_share_within;    /* share of all samples that lie within the tolerance; a dropped sample counts as
                                     outside; NaN with tolerance 0 */
    uint32_t solver;              /* HRBFNPR_SOLVER_...: the one used */
    uint32_t solver_reason;       /* HRBFNPR_SOLVER_REASON_...: why it was used */
    int32_t iterations;           /* number of refinement steps of DIRECT, or of steps of ITERATIVE */
    uint32_t fallback;            /* 1: the matrix was not definite, and LU with pivoting was used */
    double solver_residual;       /* relative residual of the linear system, in the 2-norm */
    double condition_estimate;    /* condition of the matrix in the 1-norm (DIRECT), or of the preconditioned matrix in
                                     the 2-norm (ITERATIVE) */
    double seconds_clean;         /* time of finding duplicates, outliers, flipped normals and noise */
    double seconds_choose;        /* time of all rounds that chose centres, without the last fit */
    double seconds_assemble;      /* time of reading the samples and assembling the matrix */
    double seconds_precondition;  /* time of making the preconditioner */
    double seconds_solve;         /* time of solving */
    double seconds_total;         /* time of the whole fit */
    int64_t bytes;      /* memory that the model keeps */
    int64_t peak_bytes; /* largest number of bytes allocated at the same time through the context, up to the fit's
                           end */
    uint32_t normals_found;    /* hrbfnpr_orient_info.found, if the fit had a normal_mode; else GIVEN */
    uint32_t normals_inward;   /* 1: the given normals (normal_mode GIVEN) all point into a closed surface */
    int64_t normals_turned;    /* hrbfnpr_orient_info.turned */
    double normals_confidence; /* hrbfnpr_orient_info.confidence; NaN without a normal_mode */
    double seconds_orient;     /* time of making the normals */
} hrbfnpr_model_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_info_init(hrbfnpr_model_info* info, uint32_t struct_size);
/* Fills `info` with what is known of a model. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_get_info(const hrbfnpr_model* model, hrbfnpr_model_info* info,
                                                  hrbfnpr_error* error);

/* The arrays of a model that hrbfnpr_model_view shows. */
enum {
    HRBFNPR_MODEL_ATTRIBUTE_POSITION = 0, /* FLOAT64 x 3: the centres; for a model of sheets, places all over the
                                             surface */
    HRBFNPR_MODEL_ATTRIBUTE_NORMAL = 1,   /* FLOAT64 x 3: the unit normals at these places */
    HRBFNPR_MODEL_ATTRIBUTE_RESIDUAL_HISTORY = 2 /* FLOAT64: the relative residual after each iteration of ITERATIVE;
                                                    empty after DIRECT and after loading */
};

/* Gives a view of an array of the model, without a copy.  The view is valid while
 * the model lives.  It is empty for a custom model and a solid. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_view(const hrbfnpr_model* model, uint32_t attribute,
                                              hrbfnpr_array* out_view, hrbfnpr_error* error);

/* Evaluates f, its gradient and its Hessian at n points.
 *
 * points:      n x 3, FLOAT32 or FLOAT64; finite, and within 1e50 diagonals of the model's bounds
 * value:       receives n values, FLOAT32 or FLOAT64; may be NULL
 * gradient:    receives n x 3, FLOAT32 or FLOAT64; may be NULL
 * hessian:     receives n x 6, xx xy xz yy yz zz, FLOAT32 or FLOAT64; may be NULL.  At a sample it leaves out the
 *              sample's own term, which depends on the direction and has the mean 0
 * operation:   may be NULL
 *
 * The first call with many points prepares the model for faster evaluation: it
 * takes longer, and the model keeps the prepared data (docs/accuracy.md gives the
 * threshold, the times and the memory).  Prepared values of f are within 1e-9
 * diagonals of the exact sum, gradients within 1e-7.  For rough, uneven samples the
 * errors may be 200 times as large, or 5000 times where rounding allows no less;
 * otherwise the exact sum is used.  The log gives the measured errors.  The bits of
 * a result depend on n, and in the last bits on whether Hessians are asked for, but
 * not on earlier calls.  hrbfnpr_model_project, hrbfnpr_model_curvature and
 * hrbfnpr_point_set_generate prepare the model in the same way.
 *
 * Errors: INVALID_ARGUMENT: a point is not finite or too far away, or a finite
 * result does not fit into a FLOAT32 array.  Non-finite values of a custom function
 * are passed on. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_evaluate(const hrbfnpr_model* model, const hrbfnpr_array* points,
                                                  const hrbfnpr_array_out* value,
                                                  const hrbfnpr_array_out* gradient,
                                                  const hrbfnpr_array_out* hessian,
                                                  hrbfnpr_operation* operation, hrbfnpr_error* error);

/* What became of a projected point. */
enum {
    HRBFNPR_PROJECTION_CONVERGED = 0,     /* the point is on the surface, within the tolerance */
    HRBFNPR_PROJECTION_NOT_CONVERGED = 1, /* the evaluation limit was reached, or no step lowers f^2 */
    HRBFNPR_PROJECTION_ZERO_GRADIENT = 2, /* the point is stuck off the surface, where the gradient vanishes */
    HRBFNPR_PROJECTION_NOT_FINITE = 3     /* f or its gradient is not finite, or the gradient exceeds 1e150 */
};

/* How points are projected. */
typedef struct hrbfnpr_project_desc {
    uint32_t struct_size;
    int32_t evaluation_limit; /* largest number of evaluations of f for each point; 1 to 1000; default 50 */
    double tolerance;        /* largest distance |f| / |grad f| from the surface at which the projection ends, in
                                diagonals; above 0; default 1e-9 */
    double armijo_slope;     /* sigma of Armijo's rule: the share of the expected decrease that a step must reach;
                                between 0 and 0.5; default 1e-4 */
    double armijo_factor;    /* beta of Armijo's rule: the factor by which a step is shortened; between 0 and 1; default
                                0.5 */
} hrbfnpr_project_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_project_desc_init(hrbfnpr_project_desc* desc, uint32_t struct_size);

/* The results of hrbfnpr_model_project: arrays of the caller with n elements each.
 * An array that is all zero is not wanted. */
typedef struct hrbfnpr_projection {
    uint32_t struct_size;
    uint32_t reserved;
    hrbfnpr_array_out position; /* n x 3, FLOAT32 or FLOAT64: the projected points; may be the memory of the points */
    hrbfnpr_array_out normal;   /* n x 3, FLOAT32 or FLOAT64: the unit gradients; 0 where there is none */
    hrbfnpr_array_out status;   /* n x 1, UINT8 or UINT32: HRBFNPR_PROJECTION_... */
    int64_t converged;          /* receives the number of points that converged */
} hrbfnpr_projection;

/* Sets up the struct with no array given. */
HRBFNPR_API hrbfnpr_status hrbfnpr_projection_init(hrbfnpr_projection* projection, uint32_t struct_size);

/* Projects n points onto the surface, by steepest descent on f^2 with Armijo's rule
 * [NPAR 4.2].  A point that fails keeps its last place; its status says why, and the
 * call succeeds.  For models with creases, and where a bound on |grad f| is known,
 * points that descent leaves off the surface are searched for the surface around
 * them, within the search box: this takes up to 2000 more evaluations for each.
 *
 * points:       n x 3, FLOAT32 or FLOAT64; as for hrbfnpr_model_evaluate
 * desc:         NULL = all defaults
 * projection:   the arrays that receive the results
 * operation:    may be NULL */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_project(const hrbfnpr_model* model, const hrbfnpr_array* points,
                                                 const hrbfnpr_project_desc* desc, hrbfnpr_projection* projection,
                                                 hrbfnpr_operation* operation, hrbfnpr_error* error);

/* The results of hrbfnpr_model_curvature: arrays of the caller with n elements each,
 * FLOAT32 or FLOAT64.  An array that is all zero is not wanted. */
typedef struct hrbfnpr_curvature {
    uint32_t struct_size;
    uint32_t reserved;
    hrbfnpr_array_out k1; /* n x 1: the larger principal curvature, in 1 / unit of length */
    hrbfnpr_array_out k2; /* n x 1: the smaller principal curvature */
    hrbfnpr_array_out d1; /* n x 3: the direction of k1: unit, tangent, of arbitrary sign */
    hrbfnpr_array_out d2; /* n x 3: the direction of k2: unit, tangent, perpendicular to d1, of arbitrary sign */
    hrbfnpr_array_out confidence; /* n x 1: (k1 - k2) / (|k1| + |k2| + 1e-3/diagonal), from 0 to 1 */
} hrbfnpr_curvature;

/* Sets up the struct with no array given. */
HRBFNPR_API hrbfnpr_status hrbfnpr_curvature_init(hrbfnpr_curvature* curvature, uint32_t struct_size);

/* Computes the principal curvatures and directions of the level set through each of n
 * points: the tangent eigenpairs of G = -P H P / |grad f|, where P = I - n n^T
 * [NPAR 5.3; Kindlmann et al. 2003].  k1 >= k2.  A surface that bends away from its
 * normal has negative curvature: a sphere with outward normals has -1/radius.  At
 * umbilics and on planes the confidence is 0, and d1 and d2 follow a smooth field.
 * Where the gradient vanishes, all results are 0.
 *
 * points:      n x 3, FLOAT32 or FLOAT64; as for hrbfnpr_model_evaluate
 * curvature:   the arrays that receive the results
 * operation:   may be NULL */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_curvature(const hrbfnpr_model* model, const hrbfnpr_array* points,
                                                   hrbfnpr_curvature* curvature, hrbfnpr_operation* operation,
                                                   hrbfnpr_error* error);

/* What became of a ray. */
enum {
    HRBFNPR_RAY_HIT = 0,             /* it has one or several hits */
    HRBFNPR_RAY_MISS = 1,            /* it has no hit */
    HRBFNPR_RAY_TRUNCATED = 2,       /* it has more hits than maximum_hits; reported only if that is 2 or more */
    HRBFNPR_RAY_EVALUATION_LIMIT = 3, /* the search ended at the evaluation limit; earlier hits are kept */
    HRBFNPR_RAY_NOT_FINITE = 4       /* f or its gradient is not finite; earlier hits are kept */
};

/* The lines of one model, and its mesh. */
typedef struct hrbfnpr_line_set hrbfnpr_line_set;
/* A handle to triangles that have been repaired, see hrbfnpr_mesh_create.  It never changes. */
typedef struct hrbfnpr_mesh hrbfnpr_mesh;

/* How rays are cast. */
typedef struct hrbfnpr_cast_desc {
    uint32_t struct_size;
    int32_t maximum_hits;    /* largest number of hits to find on a ray; 1 to 256; default 1 = only the first one */
    int32_t evaluation_limit; /* largest number of evaluations of f for each ray; 1 to 1000000; default 20000 */
    uint32_t reserved;
    double t_min;            /* where a ray begins, in lengths of its direction; finite; default 0 */
    double t_max;            /* where a ray ends, in lengths of its direction; t_min or more; default infinity */
    double lipschitz;        /* a bound on |grad f| in the search box; 0 or more; default 0 = that of
                                hrbfnpr_model_lipschitz.  A bound that is too small may miss hits; one that is too large
                                only takes time */
    double smallest_step;    /* smallest step along a ray, in diagonals; above 0, at most 0.1; default 1e-4.  Smaller
                                steps find thinner sheets and take more time */
    double tolerance;        /* accuracy of the place of a hit along its ray, in diagonals; above 0; default 1e-9 */
    const hrbfnpr_line_set* line_set; /* a line set of this model, whose mesh the rays meet first; default NULL = rays
                                         are searched without a mesh.  It is read only during the call */
    uint32_t refine;         /* 1 = the hits on the mesh are moved along their rays to f = 0; 0 = they stay on the mesh,
                                with the mean normals of its corners.  Used with line_set; default 1 */
    uint32_t reserved2;
} hrbfnpr_cast_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_cast_desc_init(hrbfnpr_cast_desc* desc, uint32_t struct_size);

/* The results of hrbfnpr_model_cast_rays: arrays of the caller with n elements each.
 * An array that is all zero is not wanted.  h is maximum_hits; the hits of a ray are
 * in the order of t. */
typedef struct hrbfnpr_ray_hits {
    uint32_t struct_size;
    uint32_t reserved;
    hrbfnpr_array_out count;    /* n x 1, UINT32: number of hits; 0 to h */
    hrbfnpr_array_out t;        /* n x h, FLOAT32 or FLOAT64: places of the hits, in lengths of the direction; infinity
                                   after the last hit */
    hrbfnpr_array_out position; /* n x 3h, FLOAT32 or FLOAT64: x, y, z of the first hit, then of the second; 0 after the
                                   last hit.  For far origins it is more exact than t, which is rounded */
    hrbfnpr_array_out normal;   /* n x 3h, FLOAT32 or FLOAT64: the unit gradients; 0 after the last hit */
    hrbfnpr_array_out entering; /* n x h, UINT8: 1 where the ray enters the inside (f changes from + to -), else 0 */
    hrbfnpr_array_out status;   /* n x 1, UINT8 or UINT32: HRBFNPR_RAY_... */
    int64_t hit_rays;           /* receives the number of rays that have a hit */
} hrbfnpr_ray_hits;

/* Sets up the struct with no array given. */
HRBFNPR_API hrbfnpr_status hrbfnpr_ray_hits_init(hrbfnpr_ray_hits* hits, uint32_t struct_size);

/* Finds where n rays origin + t direction, t_min <= t <= t_max, meet the surface in the
 * search box, by sphere tracing [Hart 1996].
 *
 * The search may miss: two hits that are closer than smallest_step along the ray, such
 * as those of a grazing ray or a thin sheet; and a hit exactly at t_min or t_max.  A
 * ray that starts on the surface may or may not have a hit there: start beyond it, with
 * t_min.  Rays may start inside.
 *
 * A call with a few thousand rays on a fit prepares the model, as hrbfnpr_model_evaluate
 * does (docs/accuracy.md), and is 30 to 60 times as fast, unless lipschitz is given.
 * It finds the same hits within the tolerance.  The last bits depend on whether n is
 * enough for that, but not on the other rays or on earlier calls.
 *
 * With line_set, each ray first meets the mesh of the line set, whose box tree is made
 * in the first such call.  Newton's method then moves the hits to f = 0, as
 * hrbfnpr_model_evaluate computes it (refine 1).  On a fit of 5000 samples this is 5
 * times as fast as the search, and 11 times with refine 0.  If a hit does not lead
 * there within a cell of the mesh, its ray is searched as without a mesh.  Parts of the
 * surface that the mesh does not have are missed: those smaller than a cell, and those
 * where a ray passes between the surface and its mesh, near its outline.  lipschitz,
 * smallest_step and evaluation_limit are used only for the rays that are searched.
 *
 * origins:      n x 3, FLOAT32 or FLOAT64, finite
 * directions:   n x 3, FLOAT32 or FLOAT64, finite, of any length but 0
 * desc:         NULL = all defaults
 * hits:         the arrays that receive the results
 * operation:    may be NULL
 *
 * Errors: INVALID_ARGUMENT: NaN, infinity, a zero direction, different counts of
 * origins and directions, a direction so short that the t of a hit is infinite, or a
 * line_set of another model. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_cast_rays(const hrbfnpr_model* model, const hrbfnpr_array* origins,
                                                   const hrbfnpr_array* directions, const hrbfnpr_cast_desc* desc,
                                                   hrbfnpr_ray_hits* hits, hrbfnpr_operation* operation,
                                                   hrbfnpr_error* error);

/* Computes the bound on |grad f| that hrbfnpr_model_cast_rays uses if none is given.
 * For a solid of primitives it is a true bound (hrbfnpr_csg_info.lipschitz).  For other
 * models it is an estimate: 1.5 times the largest |grad f| at 24^3 points of the search
 * box.  A program that casts a few rays in each call should ask for the bound once and
 * pass it on, because each such call without it evaluates these points.
 *
 * lipschitz:   receives the bound
 * operation:   may be NULL */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_lipschitz(const hrbfnpr_model* model, double* lipschitz,
                                                   hrbfnpr_operation* operation, hrbfnpr_error* error);

/* Tells which of n points lie inside the surface: f < 0, and within the search box.
 * Points beyond the box are outside; f is not evaluated there.  A surface with a border
 * bounds nothing: the result then tells the side by the sign of f.
 *
 * points:         n x 3, FLOAT32 or FLOAT64, finite
 * inside:         receives n x 1 UINT8: 1 inside, else 0; may be NULL
 * inside_count:   receives the number of points inside; may be NULL
 * operation:      may be NULL */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_contains(const hrbfnpr_model* model, const hrbfnpr_array* points,
                                                  const hrbfnpr_array_out* inside, int64_t* inside_count,
                                                  hrbfnpr_operation* operation, hrbfnpr_error* error);

/*
 * --------------------------------------------------------------------------
 * Where a surface ends.  A fitted surface goes on where its samples end: that of
 * one view of a scan, or of a terrain, goes on to the end of the search box.  It
 * may also have sheets where there never was a sample.  Trimming leaves both out.
 *
 * A number s(x) tells how badly the samples support the surface at the place x.
 * It is near -4.7 among samples and grows away from them, and where they face
 * another way (docs/how-lines-work.md gives the formula).  Trimming looks at the connected
 * parts of the surface where s is above `limit`.  It leaves out a part that
 * reaches the end of the search box.  It also leaves out a part that is somewhere
 * farther than `hole` from all samples and has an s of 6 or more (with `closest`
 * above 0, the distance is enough).  Other parts are holes between samples, and
 * stay: the surface closes them.  Samples along curves, such as wires and cross
 * sections, have no holes between them: only parts that reach the end of the box
 * are left out.
 */

/* How a surface is trimmed. */
typedef struct hrbfnpr_trim_desc {
    uint32_t struct_size;
    uint32_t reserved;     /* must be 0 */
    double limit;          /* the surface ends where s is above this; 0.001 to 1000; default 1.5.  Larger values end it
                              later: 1.5 about 0.7 spacings beyond its last samples, 3 about 0.9 */
    double hole;           /* holes whose points are all within this distance of a sample stay closed, in diagonals; 0
                              or more; default 0.05.  Larger values keep larger holes closed */
    double closest;        /* samples closer to each other than this are treated as this far apart, in diagonals; 0 to
                              1; default 0.  Use it for samples that are much denser than the surface is accurate, such
                              as many points of a mesh: 0.01 leaves out whatever is more than about 0.01 diagonals off
                              them, and every part that is somewhere farther than `hole` from all samples */
    hrbfnpr_array points;  /* N x 3, FLOAT32 or FLOAT64, finite: the samples; not given = the model's centres.  All
                              points of a scan show better than the chosen centres where it ends */
    hrbfnpr_array normals; /* N x 3, FLOAT32 or FLOAT64, of any length but 0: one normal for each of `points`; not
                              given = those of the centres, or of the surface at the given points */
} hrbfnpr_trim_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_trim_desc_init(hrbfnpr_trim_desc* desc, uint32_t struct_size);

/* Makes the same model with a surface that ends where its samples end.  Marks, line sets
 * and rays of the new model end there.  f, projections, curvatures and
 * hrbfnpr_model_contains stay those of `model`, which the new model keeps alive.
 * Trimming a trimmed model starts from the whole model.  If nothing is to be left out,
 * the surface stays whole, and all results are bit for bit those of `model`.  Files of
 * models store the trim.
 *
 * desc:        NULL = all defaults
 * operation:   may be NULL
 *
 * Errors: INVALID_ARGUMENT: the model is not a fit, and no points are given.
 * NOT_CONVERGED: no part of the surface is near the samples, or a single sample has no
 * spacing. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_trim(const hrbfnpr_model* model, const hrbfnpr_trim_desc* desc,
                                              hrbfnpr_operation* operation, hrbfnpr_model** out_model,
                                              hrbfnpr_error* error);

/* What trimming left out. */
typedef struct hrbfnpr_trim_info {
    uint32_t struct_size;
    uint32_t is_trimmed;  /* 1: the surface ends somewhere; 0: it is whole, and all fields except samples and spacing
                             are 0 */
    int64_t samples;      /* number of samples that were looked at; 0 if trimming was not asked for, if the model is a
                             fit to a closed mesh, or if the end could not be found */
    int64_t parts;        /* number of connected parts of the surface that are left out */
    int64_t parts_to_end; /* number of these that reach the end of the search box: the samples are open there */
    double share;         /* share of the surface's area in the box that is left out; 0 to 1; accurate to some
                             percent */
    double farthest;      /* largest distance of a place that is left out from the samples, in the model's unit */
    double spacing;       /* spacing of the samples: the median distance to the sixth neighbour */
} hrbfnpr_trim_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_trim_info_init(hrbfnpr_trim_info* info, uint32_t struct_size);
/* Fills `info` with what the last trim of a model left out. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_get_trim_info(const hrbfnpr_model* model, hrbfnpr_trim_info* info,
                                                       hrbfnpr_error* error);

/*
 * --------------------------------------------------------------------------
 * Solids (constructive solid geometry).  A solid is a tree of unions,
 * intersections, differences and other operations.  Its leaves are primitives and
 * models of any kind.  Where parts meet, there is a crease or a blend.  f is
 * negative inside and has units of length:
 *
 *   union          min(a, b)
 *   intersection   max(a, b)
 *   difference     max(a, -b): the first child without all others
 *   complement     -a
 *   offset         a - distance
 *   shell          max(a, -a - distance): a wall of this thickness inside the surface
 *
 * Primitives lie around the origin and along the z axis of their own coordinates.
 * The transforms of a node and of its parents move them to their places.  For a
 * half-space, a sphere and a torus f is the signed distance to the surface.  For a
 * box, a cylinder and a cone it is the largest of the distances from their sides:
 * the distance inside, and outside where one side is nearest; less beside edges
 * and corners.
 *
 * A blend rounds the place where parts meet.  It acts where both parts are nearer
 * than the radius R to their surfaces.  Children are blended one after the other,
 * in their order.  For a union:
 *
 *   exponent 0     min(a, b) - R/6 (1 - |a - b|/R)^3 where |a - b| < R, else min(a, b)
 *   exponent p     max(R, min(a, b)) - (A^p + B^p)^(1/p), A = max(0, R - a), B = max(0, R - b)
 *
 * Exponent 0 is twice continuously differentiable everywhere; at a right angle it
 * begins at the distance R from the edge [after Barthe, Wyvill & de Groot 2004].
 * Exponent 2 gives an arc of radius R at a right angle, and larger exponents are
 * sharper [Ricci 1973].  Such a blend is smooth where f < R only, so do not offset
 * it by R or more; |grad f| may grow by the factor 2^(1/p).
 *
 * A model as a leaf ends at its search box: everything beyond is outside, whatever
 * f is there.  A leaf that is itself a solid becomes part of the new tree, and the
 * bounds that were given for it are ignored.  A trimmed model bounds no solid and is
 * refused: fit it with trim NEVER.
 *
 * The kinds of nodes are:
 */
enum {
    HRBFNPR_CSG_UNION = 0,        /* everything inside any child */
    HRBFNPR_CSG_INTERSECTION = 1, /* everything inside all children */
    HRBFNPR_CSG_DIFFERENCE = 2,   /* the first child without all others */
    HRBFNPR_CSG_COMPLEMENT = 3,  /* everything outside its child; has one child */
    HRBFNPR_CSG_OFFSET = 4,      /* its child, grown outward by `distance`, or inward if that is negative; has one
                                    child.  Exact where f is the distance */
    HRBFNPR_CSG_SHELL = 5,       /* its child as a hollow body with a wall of thickness `distance` inside the surface;
                                    has one child */
    HRBFNPR_CSG_MODEL = 6,       /* the field `model`; a leaf */
    HRBFNPR_CSG_HALF_SPACE = 7,  /* z <= 0; a leaf */
    HRBFNPR_CSG_BOX = 8,         /* a box of the sides `size`, centred at the origin; a leaf */
    HRBFNPR_CSG_SPHERE = 9,      /* a ball of `radius` around the origin; a leaf */
    HRBFNPR_CSG_CYLINDER = 10,   /* a cylinder of `radius` around the z axis, z from -height/2 to height/2; a leaf */
    HRBFNPR_CSG_CONE = 11,       /* a cone around the z axis, z from -height/2 to height/2, with `radius` at the lower
                                    end and `second_radius` at the upper end; a leaf */
    HRBFNPR_CSG_TORUS = 12       /* a tube of `second_radius` around a circle of `radius` around the z axis; a leaf */
};

/* A node of a solid's tree.  Fields that its kind does not use are ignored. */
typedef struct hrbfnpr_csg_node {
    uint32_t struct_size;
    uint32_t kind;               /* HRBFNPR_CSG_...; default UNION */
    int64_t parent;              /* index of the parent, which comes earlier in the list; default -1 = none, for the
                                    first node, which is the root.  Children have the order of the list */
    const hrbfnpr_model* model;  /* the model of MODEL, which the solid keeps alive; not trimmed */
    double transform[16];        /* affine map from the node's coordinates to the parent's; default the identity.  It
                                    applies to the node and all below, and may turn, mirror and stretch.  The largest
                                    stretch may be 1e4 times the least.  If it stretches unevenly, lengths are measured
                                    by the least stretch, so that |grad f| does not grow */
    double size[3];              /* sides of BOX; above 0; default 1 */
    double radius;               /* radius of SPHERE, CYLINDER, CONE and TORUS; above 0, but 0 or more for CONE, of
                                    which one radius must be above 0; default 1 */
    double second_radius;        /* upper radius of CONE, 0 or more; tube radius of TORUS, above 0 and below `radius`;
                                    default 0.5 */
    double height;               /* height of CYLINDER and CONE; above 0; default 1 */
    double distance;             /* growth of OFFSET, finite; wall thickness of SHELL, above 0; default 0 */
    double blend;                /* radius R of the blend of UNION, INTERSECTION and DIFFERENCE; 0 or more; default
                                    0 = a crease.  Larger values round more */
    double exponent;             /* exponent of the blend; 0, or 2 to 64; default 0.  From 2 on, larger values are
                                    sharper */
} hrbfnpr_csg_node;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_csg_node_init(hrbfnpr_csg_node* node, uint32_t struct_size);

/* A solid to make. */
typedef struct hrbfnpr_csg_desc {
    uint32_t struct_size;
    uint32_t reserved;
    const hrbfnpr_csg_node* nodes; /* the list of nodes: a tree of any depth; 1 to 65536 nodes, with those of solids
                                      that are leaves */
    int64_t node_count;            /* number of nodes in the list */
    int64_t node_stride;           /* bytes from one node to the next; 0 = the first one's struct_size */
    double bounds_min[3];          /* lower corner of the box in which the surface is looked for; both corners all 0
                                      (default) = found from the tree */
    double bounds_max[3];          /* upper corner of the box */
} hrbfnpr_csg_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_csg_desc_init(hrbfnpr_csg_desc* desc, uint32_t struct_size);

/* Makes a solid.  Every function of this section works on it.  Derivatives are those of
 * the part that is active at a place.  A solid can be saved if its leaves can.  It keeps
 * its leaves alive.  It runs on several threads if all custom functions among its leaves
 * are thread-safe.
 *
 * Errors: INVALID_ARGUMENT: a node is wrong (the message gives its index); the surface
 * may have no end (intersect it with a box, or give bounds); nothing is left of the
 * solid. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_create_csg(hrbfnpr_context* context, const hrbfnpr_csg_desc* desc,
                                                    hrbfnpr_model** out_model, hrbfnpr_error* error);

/* What a solid is made of.  All fields are 0 for a model that is not a solid. */
typedef struct hrbfnpr_csg_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t nodes;    /* number of nodes, with those of solids that became part of it */
    int64_t depth;    /* number of nodes from the root to the deepest leaf, both included */
    int64_t models;   /* number of different models among the leaves */
    int64_t sheets;   /* number of smooth functions that it consists of: sides of primitives, sides of the boxes at
                         which models end, and one for each pair of those that a blend joins */
    double lipschitz; /* a bound on |grad f| that holds everywhere; 0 if none is known, because leaves are models */
} hrbfnpr_csg_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_csg_info_init(hrbfnpr_csg_info* info, uint32_t struct_size);
/* Fills `info` with what a solid is made of. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_get_csg_info(const hrbfnpr_model* model, hrbfnpr_csg_info* info,
                                                      hrbfnpr_error* error);

/* Saves a model to a stream.  The stream is little-endian, has a version and a
 * checksum, and is described in docs/file-format.md.  A loaded model evaluates to the
 * same bits.
 *
 * Errors: INVALID_ARGUMENT: a custom model, or a solid with one among its leaves, cannot
 * be saved.  IO: `write` failed. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_save(const hrbfnpr_model* model, hrbfnpr_write_fn write,
                                              void* user, hrbfnpr_error* error);
/* Saves a model to memory.
 *
 * destination:   receives the stream; may be NULL if capacity is 0
 * capacity:      the size of destination in bytes, 0 or more
 * size:          receives the bytes that the stream needs; must be given
 *
 * Errors: those of hrbfnpr_model_save.  BUFFER_TOO_SMALL: capacity is below *size; only
 * *size is written. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_save_memory(const hrbfnpr_model* model, void* destination,
                                                     int64_t capacity, int64_t* size,
                                                     hrbfnpr_error* error);
/* Loads a model from a stream.
 *
 * Errors: IO: `read` failed.  CORRUPT_DATA: the stream is no model, truncated or
 * damaged.  VERSION_MISMATCH: a newer library wrote it. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
                                              hrbfnpr_model** out_model, hrbfnpr_error* error);
/* Loads a model from `size` bytes of memory.  Errors: those of hrbfnpr_model_load,
 * without IO. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_load_memory(hrbfnpr_context* context, const void* data,
                                                     int64_t size, hrbfnpr_model** out_model,
                                                     hrbfnpr_error* error);

/*
 * ==========================================================================
 * 7  POINT SET: layers of marks on a surface, immutable   [NPAR 4.2, 5]
 * ==========================================================================
 *
 * A point set is a list of layers.  A layer is a list of marks of one kind, which
 * are made in one way and drawn in one style.  The number of a layer is its place
 * in the list, from 0.  The marks of some layers form strokes.
 */

/* A handle to a set of marks.  It never changes. */
typedef struct hrbfnpr_point_set hrbfnpr_point_set;
/* A handle to values on a surface, see hrbfnpr_field_create.  It never changes. */
typedef struct hrbfnpr_field hrbfnpr_field;

/* The kind of a layer's marks.  Later versions may add kinds: treat an unknown one
 * like OWN. */
enum {
    HRBFNPR_LAYER_KIND_ANY = 0,       /* for styles only: layers of every kind */
    HRBFNPR_LAYER_KIND_STIPPLES = 1,  /* scattered marks */
    HRBFNPR_LAYER_KIND_HATCH = 2,     /* lines along a field of directions, which `guide` or direction_function gives.
                                         With BLUE_NOISE they are evenly spaced and nested: lines of level 0 are the
                                         coarsest, and lines of each further level lie midway between all before
                                         [Knoeppel et al. 2015].  With PUBLISHED they are strokes that grow from seeds,
                                         along the directions and across them [NPAR 5] */
    HRBFNPR_LAYER_KIND_OWN = 3        /* marks or strokes of the caller */
};

/* How marks are distributed over a surface. */
enum {
    HRBFNPR_DISTRIBUTION_BLUE_NOISE = 0, /* stipples are evenly spread in a progressive order, every prefix of which is
                                            evenly spread; lines of HATCH are evenly spaced and nested; the default.
                                            Where the surface bends within the spacing of stipples, a layer may miss its
                                            budget by some marks in a thousand (docs/quality.md) */
    HRBFNPR_DISTRIBUTION_PUBLISHED = 1   /* the published recursion: each level has 5 times as many stipples, or 3 times
                                            as many marks of strokes, and ranks are random [NPAR 5, 6.2] */
};

/* The directions that lines of HATCH follow without a direction_function.  Where the
 * directions have a low confidence, lines follow the smoothest field between.
 * PUBLISHED takes CURVATURE, COMBING or a direction_function; another guide is
 * INVALID_ARGUMENT. */
enum {
    HRBFNPR_HATCH_GUIDE_CURVATURE = 0, /* the direction in which the surface bends most.  PUBLISHED: strokes along both
                                          principal directions, d1 and d2 */
    HRBFNPR_HATCH_GUIDE_COMBING = 1,   /* Stark's combing direction r.  PUBLISHED: strokes along r and u [NPAR 5.3] */
    HRBFNPR_HATCH_GUIDE_SECTIONS = 2,  /* sections of the surface by planes perpendicular to `axis` */
    HRBFNPR_HATCH_GUIDE_LIGHT = 3,     /* the tangent part of guide_direction, which points to the light */
    HRBFNPR_HATCH_GUIDE_SILHOUETTE = 4 /* the direction conjugate to guide_direction, which points to the eye: near the
                                          silhouette, lines run along it */
};

/* The seeds from which marks start. */
enum {
    HRBFNPR_SEED_AUTO = 0,    /* the samples, if the model has them (for PUBLISHED: well-spread ones), else BOX */
    HRBFNPR_SEED_SAMPLES = 1, /* the model's samples; INVALID_ARGUMENT for a model without samples */
    HRBFNPR_SEED_BOX = 2,     /* a jittered grid in the bounds, projected onto the surface */
    HRBFNPR_SEED_POINTS = 3   /* seed_points, projected onto the surface */
};

/* Where the strokes of PUBLISHED start. */
enum {
    HRBFNPR_STROKE_START_SEEDS = 0,   /* at the seeds */
    HRBFNPR_STROKE_START_STIPPLES = 1 /* at the stipples up to level start_level */
};

/* How densely the stipples of BLUE_NOISE lie. */
enum {
    HRBFNPR_DENSITY_UNIFORM = 0,   /* the same number of stipples per area everywhere */
    HRBFNPR_DENSITY_CURVATURE = 1, /* more stipples where the surface bends: 1 - s + s c / (c + mean of c), where s is
                                      density_strength and c = sqrt((k1^2 + k2^2) / 2) */
    HRBFNPR_DENSITY_CALLBACK = 2,  /* the density of density_function */
    HRBFNPR_DENSITY_FIELD = 3      /* the density of density_field */
};

/* Gives a density on the surface: 1 where marks lie closest, 0 where there are none.
 * Larger numbers count as 1.  A negative number or NaN fails the call with CALLBACK, and
 * so does a result other than 0.  A density without any mark is INVALID_ARGUMENT.  The
 * function gets some thousand places at a time, on the thread that called _generate.
 *
 * positions:   count x 3, absolute
 * normals:     count x 3, unit
 * density:     receives count numbers */
typedef int32_t (*hrbfnpr_density_fn)(void* user, int64_t count, const double* positions,
                                      const double* normals, double* density);

/* Gives a field of directions on the surface.  Only the tangent part of a direction
 * counts; its sign and length do not.  (0, 0, 0) means no direction: lines follow the
 * smoothest field between the others.  NaN or infinity fails the call with CALLBACK, and
 * so does a result other than 0.  The function gets some thousand places at a time, on
 * the thread that called _generate.
 *
 * positions:    count x 3, absolute
 * normals:      count x 3, unit
 * directions:   receives count x 3 */
typedef int32_t (*hrbfnpr_direction_fn)(void* user, int64_t count, const double* positions,
                                        const double* normals, double* directions);

/* The tones in which layers appear, if they have no tone range of their own. */
enum {
    HRBFNPR_TONE_RANGES_FULL = 0,   /* each layer covers all tones */
    HRBFNPR_TONE_RANGES_IN_TURN = 1 /* the layers follow each other in the order of the list, each over an equal part of
                                       the tones (of PUBLISHED strokes the first direction, then the second):
                                       cross-hatching builds up from light to dark */
};

/* What else is made for a layer. */
enum {
    HRBFNPR_LAYER_WITH_CURVATURE = 1 /* fill the attribute CURVATURE; PUBLISHED strokes along CURVATURE always have
                                        it */
};

/* How one layer of marks is made.
 *
 * tone_begin is the darkness (1 - tone) at which the first mark of the layer is shown,
 * tone_end the darkness at which all are shown: the rank u becomes
 * 1 - begin - (1 - u) (end - begin), with 0 <= begin < end <= 1.  If both are 0,
 * hrbfnpr_generate_desc.tone_ranges decides. */
typedef struct hrbfnpr_layer_desc {
    uint32_t struct_size;
    uint32_t kind;       /* HRBFNPR_LAYER_KIND_STIPPLES or HATCH; default STIPPLES */
    const char* name;    /* name for styles; UTF-8, 1 to 63 bytes, copied; default NULL = "stipples" or "hatch" */
    int64_t budget;      /* largest number of marks; 0 or more, at most 100000000 for BLUE_NOISE; default 40000.  0 = no
                            limit, for PUBLISHED and for lines with a separation.  PUBLISHED thins the level that
                            exceeds the budget at random and stops there.  Lines of BLUE_NOISE have about this number of
                            marks, and ignore the budget if they have a separation.  shared_budget replaces it */
    float tone_begin;    /* darkness at which the first mark is shown; 0 to 1; default 0.  For PUBLISHED strokes, those
                            of the first direction */
    float tone_end;      /* darkness at which all marks are shown; 0 to 1; default 0 */
    float second_tone_begin; /* the same as tone_begin, for PUBLISHED strokes of the second direction; default 0 */
    float second_tone_end;   /* the same as tone_end, for PUBLISHED strokes of the second direction; default 0 */
    uint32_t flags;      /* HRBFNPR_LAYER_WITH_... flags, or-ed; default 0 */

    /* Stipples of BLUE_NOISE.  They keep their evenness: a mark is left out if its place in the uniform
     * order, divided by the density, is too high. */
    uint32_t density;        /* HRBFNPR_DENSITY_...; default UNIFORM */
    double density_strength; /* strength of CURVATURE; 0 to 1; default 0.5.  0 = uniform; larger values put more
                                stipples where the surface bends */
    hrbfnpr_density_fn density_function; /* the function of CALLBACK.  If its mean is below 1/16, the layer has fewer
                                            marks than its budget */
    void* density_user;                  /* passed to density_function */

    /* HATCH. */
    hrbfnpr_direction_fn direction_function; /* the directions that lines follow; default NULL = those of `guide` */
    void* direction_user;                    /* passed to direction_function */
    uint32_t guide;          /* HRBFNPR_HATCH_GUIDE_...; default CURVATURE */

    /* HATCH of PUBLISHED. */
    uint32_t start;          /* HRBFNPR_STROKE_START_...; default SEEDS */
    int32_t start_level;     /* last level of stipples at which strokes start, with STROKE_START_STIPPLES; 0 to 12;
                                default 0 */
    int32_t levels;          /* number of refinement steps, for stipples of PUBLISHED, too; 0 to 12; default -1 = 4 for
                                stipples, 3 for strokes.  Strokes have 3^levels marks.  Each further level makes five
                                times as many stipples, or three times as many marks in each stroke */

    /* HATCH of BLUE_NOISE. */
    double separation;       /* mean distance of neighbouring lines, in the unit of the samples; 1e-12 to 1e9 diagonals;
                                default 0 = by the budget.  Smaller values give more lines */
    double step;             /* distance between the marks of a line, in the unit of the samples; 1e-12 to 1e9
                                diagonals; default 0 = 0.4 of the separation */
    double angle;            /* angle by which lines are turned in the tangent plane, counter-clockwise as seen from
                                outside, in degrees; -360 to 360; default 0 */
    double smoothing;        /* length over which directions are smoothed, in diagonals; 1e-6 to 1; default 0.04.
                                Larger values give calmer lines that follow the form less */
    double axis[3];          /* axis around which lines run where curvature has a low confidence; not 0; default
                                (0, 1, 0) */
    double axis_weight;      /* weight of the axis against curvature; 0 to 1000; default 0.06.  Larger values make more
                                lines run around the axis */
    double guide_direction[3]; /* direction to the light (LIGHT) or to the eye (SILHOUETTE), in the model's coordinates;
                                  not 0; default (0, 0, 1) */
    double guide_weight;     /* weight of a guide other than CURVATURE; curvature has the rest; 0 to 1; default 1.
                                Directions are blended as exp(2 i angle) */

    /* All kinds. */
    double tone_smoothing;   /* length over which the attribute TONE_NORMAL is averaged, in diagonals; 0 to 0.1;
                                0 = none: tone follows NORMAL; default -1 = 0.006 for HATCH of BLUE_NOISE, 0 for others.
                                Larger values keep the grain of a rough surface out of the tone */

    /* Fields, in the coordinates of the model. */
    const hrbfnpr_field* density_field;   /* SCALAR: the density of DENSITY_FIELD, clamped to 0 .. 1; 1 where the field
                                             has no value.  A place with the weight w has 1 + w (value - 1); default
                                             NULL */
    const hrbfnpr_field* direction_field; /* DIRECTION: the directions that lines of HATCH follow.  Where its weight is
                                             below 0.5, lines follow the smoothest field between; default NULL.  It
                                             excludes direction_function */
} hrbfnpr_layer_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_layer_desc_init(hrbfnpr_layer_desc* desc, uint32_t struct_size);

/* The layers of marks to make. */
typedef struct hrbfnpr_generate_desc {
    uint32_t struct_size;
    uint32_t distribution;   /* HRBFNPR_DISTRIBUTION_...; default BLUE_NOISE */
    const hrbfnpr_layer_desc* layers; /* the list of layers; default NULL, with layer_count 0 = one layer of stipples */
    int64_t layer_count;     /* number of layers; 0 to 65536; default 0 */
    int64_t layer_stride;    /* bytes from one layer to the next; 0 = the first one's struct_size */
    int64_t shared_budget;   /* largest number of marks of all layers together, which they share in proportion to the
                                lengths of their tone ranges; 0 or more; default 0 = each layer has its own budget */
    uint32_t tone_ranges;    /* HRBFNPR_TONE_RANGES_...; default FULL */
    uint32_t seed_source;    /* HRBFNPR_SEED_...; default AUTO */
    hrbfnpr_array seed_points; /* n x 3, FLOAT32 or FLOAT64: the seeds of POINTS, within 1e4 diagonals of the bounds */
    double box_jitter;       /* alpha: largest random shift of the grid points of BOX, in cell sides; 0 to 0.5; default
                                0.25 */
    uint32_t box_resolution; /* R: number of cells of BOX on the largest side of the bounds; 1 to 256; default 8
                                [NPAR 4.2].  More cells give more seeds and miss fewer sheets.  BLUE_NOISE with
                                seed_source AUTO uses at least 16 */
    uint32_t reserved;
    double initial_step;     /* rho_0: first step of PUBLISHED, in the unit of the samples; 1e-12 to 1e9 diagonals;
                                default 0 = the diameter of a cell for BOX, the mean diameter of empty balls between the
                                seeds for others [NPAR 5.1] */
    double projection_tolerance; /* as in hrbfnpr_project_desc; above 0; default 1e-7 */
    uint64_t random_seed;    /* start of the random numbers; any number; default 1.  Another number gives other marks */
} hrbfnpr_generate_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_generate_desc_init(hrbfnpr_generate_desc* desc, uint32_t struct_size);

/* Places marks on the surface of a model.  Marks whose projection fails or lands too far
 * away are dropped and counted (hrbfnpr_placement_info).
 *
 * desc:        NULL = all defaults
 * operation:   may be NULL
 *
 * Sizes.  Marks are stored as floats, so the diagonal of the model's bounds must be from
 * 1e-33 to 1e33.  If it is outside 1e-9 to 1e9, a model that is scaled by a power of two
 * has the same marks, scaled; curvatures that do not fit into a float become the largest
 * float.
 * The bounds of a custom model may be up to 500 times as wide as its surface.
 *
 * Errors: INVALID_ARGUMENT, before any mark is placed: a size or a budget is out of its
 * range.  NOT_CONVERGED: no seed or no mark could be placed, or no stroke has room with the
 * given separation or step.  CALLBACK: a density or direction function failed. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_generate(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                      const hrbfnpr_generate_desc* desc,
                                                      hrbfnpr_operation* operation,
                                                      hrbfnpr_point_set** out_point_set,
                                                      hrbfnpr_error* error);

/* The arrays of a layer, with one element for each mark or for each of its S strokes. */
enum {
    HRBFNPR_MARK_ATTRIBUTE_POSITION = 0,  /* FLOAT32 x 3: the place, relative to hrbfnpr_point_set_info.origin */
    HRBFNPR_MARK_ATTRIBUTE_NORMAL = 1,    /* FLOAT32 x 3: the normal; unit, outward */
    HRBFNPR_MARK_ATTRIBUTE_DIRECTION = 2, /* FLOAT32 x 3: the direction along the stroke; unit, tangent.  For a mark
                                             without a stroke: the u of its basis [NPAR 5.2] */
    HRBFNPR_MARK_ATTRIBUTE_CURVATURE = 3, /* FLOAT32 x 3: k1, k2 and confidence, as hrbfnpr_model_curvature gives
                                             them */
    HRBFNPR_MARK_ATTRIBUTE_RANK = 4,      /* FLOAT32: the rank u of [NPAR 6.2], in [0, 1): a mark is shown where
                                             u >= tone.  All marks of a line of BLUE_NOISE have the same rank */
    HRBFNPR_MARK_ATTRIBUTE_LEVEL = 5,     /* UINT8: the refinement step that placed the mark; 0 = a seed.  For HATCH of
                                             BLUE_NOISE: the level of its line there (see HRBFNPR_LAYER_KIND_HATCH) */
    HRBFNPR_MARK_ATTRIBUTE_STROKE = 6,    /* UINT32 x 2: 2 * number + direction (0 or 1) of the stroke, and the mark's
                                             place along it.  PUBLISHED: the number is that of the seed, and places are
                                             0 to 3^levels - 1 with the seed in the middle.  Others: places are 0 to
                                             n - 1 from end to end.  For a mark without a stroke: 2 * its number
                                             (PUBLISHED: of its seed), and 0 */
    HRBFNPR_MARK_ATTRIBUTE_WIDTH = 7,     /* FLOAT32: the width as a factor of the style's radius, in (0, 1]; 1 in the
                                             middle of a stroke, less towards its tapered ends; for front marks.  Count
                                             0 = all 1 */
    HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST = 8, /* UINT32, S + 1 elements: stroke s has the marks order[first[s]] to
                                                order[first[s + 1] - 1] from end to end, where order is STROKE_ORDER.
                                                Count 0 = a layer without strokes */
    HRBFNPR_MARK_ATTRIBUTE_STROKE_ORDER = 9, /* UINT32: numbers of marks, stroke by stroke.  Count 0 = the marks
                                                themselves are in this order, as in every layer except those of
                                                PUBLISHED */
    HRBFNPR_MARK_ATTRIBUTE_TONE_NORMAL = 10  /* FLOAT32 x 3: the unit normal that sets the tone with DEPTH_LAYERS,
                                                averaged over hrbfnpr_layer_desc.tone_smoothing on the same sheet.
                                                NORMAL decides whether the mark faces the eye.  Count 0 = NORMAL */
};

/* A layer of N ready-made marks.  position and normal must be given; the other arrays may be
 * empty.  The scalars are those that HRBFNPR_MARK_ATTRIBUTE_... lists; FLOAT64 is accepted
 * for FLOAT32. */
typedef struct hrbfnpr_layer_arrays {
    uint32_t struct_size;
    uint32_t kind;              /* HRBFNPR_LAYER_KIND_..., except ANY; default OWN */
    const char* name;           /* name for styles; UTF-8, 1 to 63 bytes, copied; default NULL = that of the kind */
    hrbfnpr_array position;     /* absolute places, not relative to an origin; N x 3 */
    hrbfnpr_array normal;       /* outward normals of any length but 0; N x 3 */
    hrbfnpr_array stroke_first; /* UINT32, S + 1 elements that rise from 0 to N: stroke s has the marks first[s] to
                                   first[s + 1] - 1 from end to end.  Empty = no strokes */
    hrbfnpr_array stroke_direction; /* UINT8, S elements: 0 = the first direction, 1 = the second.  Empty = 0 */
    hrbfnpr_array direction;    /* directions of any length, not along the normal; N x 3.  Empty = along the stroke, or
                                   the u of the basis for a mark without a stroke */
    hrbfnpr_array curvature;    /* k1, k2 and confidence; N x 3.  Empty = not known */
    hrbfnpr_array rank;         /* ranks in [0, 1); N x 1.  Empty = random, the same for all marks of a stroke */
    hrbfnpr_array level;        /* refinement steps, UINT8; N x 1.  Empty = 0 */
    hrbfnpr_array width;        /* widths in (0, 1]; N x 1.  Empty = 1 */
} hrbfnpr_layer_arrays;

/* Sets every field to its default; no array is given. */
HRBFNPR_API hrbfnpr_status hrbfnpr_layer_arrays_init(hrbfnpr_layer_arrays* arrays, uint32_t struct_size);

/* A set of ready-made marks to make. */
typedef struct hrbfnpr_point_set_desc {
    uint32_t struct_size;
    uint32_t reserved;
    const hrbfnpr_point_set* base; /* a set whose layers come first, copied; default NULL = none */
    const hrbfnpr_layer_arrays* layers; /* the list of layers that follow */
    int64_t layer_count;  /* number of layers in the list; 0 to 65536; default 0 */
    int64_t layer_stride; /* bytes from one layer to the next; 0 = the first one's struct_size */
    uint64_t random_seed; /* start of the random numbers for ranks that are not given; any number; default 1 */
} hrbfnpr_point_set_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_desc_init(hrbfnpr_point_set_desc* desc, uint32_t struct_size);
/* Creates a point set from marks of the caller, or from the layers of another set and marks
 * of the caller.  The marks must be from 1e-33 to 1e33 across, or all at one place.  A set
 * with a base keeps the base's origin and distribution.  It keeps its spacing, too, unless
 * a new layer has more marks than each layer before: the same area then holds more marks.
 *
 * Errors: INVALID_ARGUMENT: there is no mark, or a number is wrong; the message names the
 * layer, the array and the index. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_create(hrbfnpr_context* context, const hrbfnpr_point_set_desc* desc,
                                                    hrbfnpr_point_set** out_point_set, hrbfnpr_error* error);

HRBFNPR_API void hrbfnpr_point_set_retain(const hrbfnpr_point_set* set);  /* Adds a reference.  Any thread. */
HRBFNPR_API void hrbfnpr_point_set_release(const hrbfnpr_point_set* set); /* Removes a reference.  Any thread. */

/* What a point set holds, and how long it took.  Lengths are in the unit of the samples. */
typedef struct hrbfnpr_point_set_info {
    uint32_t struct_size;
    uint32_t distribution;  /* HRBFNPR_DISTRIBUTION_...: the one used */
    uint32_t seed_source;   /* the seed source used */
    uint32_t reserved;
    int64_t layers;         /* number of layers */
    int64_t marks;          /* number of marks in all layers */
    double origin[3];       /* add it to the attribute POSITION to get absolute places */
    double bounds_min[3];   /* lower corner of the box around all marks, absolute */
    double bounds_max[3];   /* upper corner of the box */
    double spacing;         /* square root of the area per mark of the largest layer, estimated.  A frame takes it as
                               the size of a mark's piece of surface */
    double seconds_seeds;   /* time of finding the seeds */
    double seconds_total;   /* time of the whole call */
    int64_t bytes;          /* memory that the set keeps, with what it shares with other sets */
    int64_t field_count;    /* number of fields whose values the set holds */
} hrbfnpr_point_set_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_info_init(hrbfnpr_point_set_info* info, uint32_t struct_size);
/* Fills `info` with what a point set holds. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_get_info(const hrbfnpr_point_set* set,
                                                      hrbfnpr_point_set_info* info, hrbfnpr_error* error);

/* What a layer holds. */
typedef struct hrbfnpr_layer_info {
    uint32_t struct_size;
    uint32_t kind;         /* HRBFNPR_LAYER_KIND_... */
    char name[64];         /* the layer's name; UTF-8, zero-terminated */
    int64_t marks;         /* number of marks */
    int64_t strokes;       /* number of strokes that the marks form; 0 = none */
    int64_t full_count;    /* number of marks that there would be if none had been dropped */
    int32_t levels;        /* number of refinement steps taken; for HATCH of BLUE_NOISE the highest level */
    uint32_t reserved;
    double step;           /* initial step rho_0 used, in the unit of the samples; for HATCH of BLUE_NOISE the
                              separation */
    double seconds;        /* time of making the layer */
} hrbfnpr_layer_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_layer_info_init(hrbfnpr_layer_info* info, uint32_t struct_size);
/* Fills `info` with what a layer holds.  layer: 0 to hrbfnpr_point_set_info.layers - 1. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_get_layer_info(const hrbfnpr_point_set* set, int64_t layer,
                                                            hrbfnpr_layer_info* info, hrbfnpr_error* error);

/* What became of the candidates for marks: attempted = placed + all dropped. */
typedef struct hrbfnpr_placement_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t attempted;             /* number of candidates */
    int64_t placed;                /* number of candidates that became marks */
    int64_t dropped_not_converged; /* number of candidates whose projection did not reach the tolerance */
    int64_t dropped_strayed;       /* number of candidates that landed farther away than a cell's diagonal or the step,
                                      lie beyond the end of a trimmed model, or lost the connection to their stroke
                                      because a mark between was dropped */
    int64_t dropped_degenerate;    /* number of candidates where the gradient is 0 or not finite */
    int64_t dropped_budget;        /* number of candidates over the layer's budget */
} hrbfnpr_placement_info;

/* Clears the struct before its first use. */
HRBFNPR_API hrbfnpr_status hrbfnpr_placement_info_init(hrbfnpr_placement_info* info, uint32_t struct_size);
/* Fills `info` with what became of the seeds. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_get_seed_placement(const hrbfnpr_point_set* set,
                                                                hrbfnpr_placement_info* info,
                                                                hrbfnpr_error* error);
/* Fills `info` with what became of the candidates of one level of one layer.
 * level: 0 to hrbfnpr_layer_info.levels. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_get_placement(const hrbfnpr_point_set* set, int64_t layer,
                                                           int32_t level, hrbfnpr_placement_info* info,
                                                           hrbfnpr_error* error);

/* Gives a view of one attribute (HRBFNPR_MARK_ATTRIBUTE_...) of one layer, without a copy.
 * The view is valid while the set lives.  Its count is 0 for an empty layer, and for an
 * attribute that the layer does not have. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_view(const hrbfnpr_point_set* set, int64_t layer,
                                                  uint32_t attribute, hrbfnpr_array* out_view,
                                                  hrbfnpr_error* error);

/* A field whose values marks get. */
typedef struct hrbfnpr_mark_field {
    uint32_t struct_size;
    uint32_t reserved;
    const char* name;           /* name for styles; UTF-8, 1 to 63 bytes, copied; not NULL */
    const hrbfnpr_field* field; /* where the values come from; default NULL = the set gets none of this name, and loses
                                   those that it has */
    const double* transform;    /* 16 doubles: object to field, column-major, affine and invertible; default NULL = the
                                   identity */
} hrbfnpr_mark_field;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mark_field_init(hrbfnpr_mark_field* field, uint32_t struct_size);
/* Creates a point set that has the same marks as `set`, and values of fields for them.  Values that `set` has stay,
 * except those of a name in the list.  The marks are shared, not copied, and the fields may be released.  Values are
 * saved and loaded with the set.  A hrbfnpr_shading of `set` is one of the new set, too.
 *
 * fields:      a list; no name occurs twice
 * operation:   may be NULL
 *
 * Errors: INVALID_ARGUMENT (the set would have more than 64 fields).  CALLBACK (the function of a field failed). */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_with_fields(hrbfnpr_context* context, const hrbfnpr_point_set* set,
                                                         const hrbfnpr_mark_field* fields, int64_t field_count,
                                                         int64_t field_stride, hrbfnpr_operation* operation,
                                                         hrbfnpr_point_set** out_point_set, hrbfnpr_error* error);
/* Gets the name and the kind (HRBFNPR_FIELD_KIND_...) of a field of a set.  `number` is 0 ..
 * hrbfnpr_point_set_info.field_count - 1.  `name` and `kind` may be NULL.  The name is valid while the set lives. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_get_field(const hrbfnpr_point_set* set, int64_t number, const char** name,
                                                       uint32_t* kind, hrbfnpr_error* error);
/* Gives views of the values that a field has at the marks of one layer, without a copy.  They are valid while the set
 * lives.
 *
 * values:      FLOAT32: one number for SCALAR, three for COLOUR and DIRECTION.  Count 0 = the layer has none
 * weights:     FLOAT32: 0 .. 1 for each mark; count 0 = all are 1.  It may be NULL
 *
 * Errors: INVALID_ARGUMENT (no layer of the set has a field of this name). */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_view_field(const hrbfnpr_point_set* set, int64_t layer, const char* name,
                                                        hrbfnpr_array* values, hrbfnpr_array* weights,
                                                        hrbfnpr_error* error);

/* Makes squares that show how large the initial step of PUBLISHED is [NPAR 5.1, Figure 5].
 * Each square has sides of 2 * initial_step and lies in the tangent plane of a random seed.
 * The seeds, and the estimate if initial_step is 0, are those that
 * hrbfnpr_point_set_generate uses with the same desc.
 *
 * desc:        NULL = all defaults
 * corners:     receives n x 12, FLOAT32 or FLOAT64: four corners for each square, absolute, counter-clockwise as seen
 *              from outside
 * step:        receives the initial step; may be NULL
 * operation:   may be NULL */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_step_patches(hrbfnpr_context* context,
                                                          const hrbfnpr_model* model,
                                                          const hrbfnpr_generate_desc* desc,
                                                          const hrbfnpr_array_out* corners, double* step,
                                                          hrbfnpr_operation* operation,
                                                          hrbfnpr_error* error);

/* Saves a point set to a stream, like hrbfnpr_model_save.
 *
 * Errors: IO: `write` failed. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_save(const hrbfnpr_point_set* set, hrbfnpr_write_fn write,
                                                  void* user, hrbfnpr_error* error);
/* Saves a point set to memory, like hrbfnpr_model_save_memory.
 *
 * Errors: BUFFER_TOO_SMALL: capacity is below *size; only *size is written. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_save_memory(const hrbfnpr_point_set* set, void* destination,
                                                         int64_t capacity, int64_t* size,
                                                         hrbfnpr_error* error);
/* Loads a point set from a stream.
 *
 * Errors: IO: `read` failed.  CORRUPT_DATA: the stream is no point set, truncated or
 * damaged.  VERSION_MISMATCH: a newer library wrote it. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_load(hrbfnpr_context* context, hrbfnpr_read_fn read,
                                                  void* user, hrbfnpr_point_set** out_point_set,
                                                  hrbfnpr_error* error);
/* Loads a point set from `size` bytes of memory.  Errors: those of
 * hrbfnpr_point_set_load, without IO. */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_load_memory(hrbfnpr_context* context, const void* data,
                                                         int64_t size, hrbfnpr_point_set** out_point_set,
                                                         hrbfnpr_error* error);

/*
 * ==========================================================================
 * 8  LINE SET: the lines of a model's surface; immutable
 * ==========================================================================
 *
 * A line set holds what the lines of one model are drawn from, for every camera.  Contours are traced as curves on the
 * surface itself.  Their visibility is counted and checked (Appel 1967, quantitative invisibility; Benard & Hertzmann
 * 2019).  Make a line set once for a model and give it to hrbfnpr_item.line_set.  An item that has a line set, and a
 * style that lists `lines`, is drawn with curves.  The method is described in docs/how-lines-work.md.
 */

/* Kinds of lines.  Kinds marked "once" are found when the line set is made, for each element of
 * hrbfnpr_line_set_desc.lines.  BORDER and CREASE are found then, too, without an element.  All others are found for
 * every drawing, except SHADOW and TERMINATOR, which are found with a shading.  The strength says how marked a line is
 * at a place.  It has no unit, because lengths are measured in diagonals of the model.  Kinds marked WITH_CURVATURE
 * need a line set with that flag. */
enum {
    HRBFNPR_LINE_KIND_CONTOUR = 1,            /* occluding contours: the line of sight is tangent to the surface
                                                 there */
    HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR = 2, /* curves that become contours in a nearby view; WITH_CURVATURE.
                                                 Strength: the derivative of the radial curvature towards the eye
                                                 [DeCarlo et al. 2003] */
    HRBFNPR_LINE_KIND_RIDGE = 3,              /* convex ridges; once.  Strength: the curvature across the ridge minus
                                                 the absolute value of the one along it [Ohtake, Belyaev & Seidel
                                                 2004] */
    HRBFNPR_LINE_KIND_VALLEY = 4,             /* concave valleys; once.  The strength is that of ridges */
    HRBFNPR_LINE_KIND_APPARENT_RIDGE = 5,     /* extrema of the view-dependent curvature, which is also the strength;
                                                 WITH_CURVATURE [Judd, Durand & Adelson 2007] */
    HRBFNPR_LINE_KIND_PARABOLIC = 6,          /* curves of Gaussian curvature 0; once */
    HRBFNPR_LINE_KIND_ISOPHOTE = 7,           /* curves on which n . l is one of the line style's `levels`, n the normal
                                                 and l the direction to the style's light; WITH_CURVATURE */
    HRBFNPR_LINE_KIND_SECTION = 8,            /* cuts of the surface by parallel planes; once */
    HRBFNPR_LINE_KIND_BORDER = 9,             /* curves where the surface ends: at the search box, or beyond the last
                                                 samples (hrbfnpr_line_set_desc.support) */
    HRBFNPR_LINE_KIND_OWN = 10,               /* polylines of the caller, such as creases of a mesh; once */
    HRBFNPR_LINE_KIND_CREASE = 11,            /* edges and grooves in which smooth sheets of the surface meet, in models
                                                 that have them.  Strength: the angle between the normals of both
                                                 sheets, in degrees.  Where one sheet faces the eye and the other faces
                                                 away, the crease is part of the CONTOUR and is drawn as CONTOUR */
    HRBFNPR_LINE_KIND_SHADOW = 12,            /* borders of the shadows that fall on the item, of lights with a shadow;
                                                 for items whose shading has HRBFNPR_SHADING_WITH_LINES.  Strength: the
                                                 light's `shadow` */
    HRBFNPR_LINE_KIND_TERMINATOR = 13,        /* borders between light and shade where the item turns away from a light
                                                 with a shadow, n . l = 0, and nothing else shades the place; as SHADOW
                                                 */
    HRBFNPR_LINE_KIND_SOFT_EDGE = 14,         /* edges and folds that are round, such as the worn rim of a base; once.
                                                 Strength: the angle by which the surface turns within a few cells of
                                                 the line, less the turns beside that, in degrees.  Organic bumps,
                                                 limbs and noise have none.  `fade` of a line style makes the line
                                                 narrower and not paler */
    HRBFNPR_LINE_KIND_INTERSECTION = 15,      /* curves in which the surface of the item crosses that of another item
                                                 with a line set.  If both items draw them, they are lines of the item
                                                 with the smaller mesh cells.  Parts of one model meet in CREASEs.
                                                 Strength: the mean angle between both surfaces along a curve, in
                                                 degrees; `upper` and `fade` have no effect */
    HRBFNPR_LINE_KIND_TANGENT_EDGE = 16       /* edges of a part along which two surfaces touch without a kink, such as
                                                 those of a fillet; once.  The caller gives them as polylines, as OWN.
                                                 hrbfnpr_mesh_edges finds them in a mesh */
};

/* Lines to find once, when the line set is made. */
typedef struct hrbfnpr_line_desc {
    uint32_t struct_size;
    uint32_t kind;     /* HRBFNPR_LINE_KIND_RIDGE, VALLEY, PARABOLIC, SECTION, OWN, SOFT_EDGE or TANGENT_EDGE; default
                          RIDGE */
    const char* name;  /* name by which hrbfnpr_line_style.name selects these lines; UTF-8, up to 63 bytes; default NULL
                          = "" */
    double lower;      /* least strength at which a line goes on; 0 or more; default 0.  If `lower` and `upper` are 0,
                          it is 6 for ridges and valleys, 15 (degrees) for soft edges, and 0 for other kinds */
    double upper;      /* strength that a line must reach somewhere, or it is dropped; not below `lower`; default 0.  If
                          `lower` and `upper` are 0, it is 15 for ridges and valleys, 35 (degrees) for soft edges, and 0
                          for other kinds */
    double shortest;   /* length below which a line is dropped, in diagonals; 0 or more; default 0.01 */
    double plane[3];   /* SECTION: normal of the planes, of any length but 0; default (0, 0, 1) */
    hrbfnpr_array levels; /* SECTION: places of the planes along the unit normal, in units of the model; n x 1, FLOAT32
                             or FLOAT64; at least one */
    hrbfnpr_array position; /* OWN, TANGENT_EDGE: points of all lines, on the surface or near it; n x 3, FLOAT32 or
                               FLOAT64 */
    hrbfnpr_array line_first; /* OWN, TANGENT_EDGE: number of the first position of each line, ascending, then the end
                                 of the last line; n x 1, UINT32.  A line whose last position equals its first is
                                 closed */
} hrbfnpr_line_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_line_desc_init(hrbfnpr_line_desc* desc, uint32_t struct_size);

/* What a line set measures. */
enum {
    HRBFNPR_LINE_SET_WITH_CURVATURE = 1 /* measures curvatures and their derivatives, which suggestive contours,
                                           apparent ridges and isophotes need */
};

/* How a line set is made. */
typedef struct hrbfnpr_line_set_desc {
    uint32_t struct_size;
    uint32_t flags; /* HRBFNPR_LINE_SET_WITH_...; default 0 */
    double cell_size; /* side of the cells in which curves are searched, in units of the model; 0 or more; default 0 =
                         half the samples' spacing, and finer where walls are thin.  Loops smaller than a cell and walls
                         thinner than 1.75 cells may be missed */
    hrbfnpr_array seed_points; /* points near each part of the surface, where the search begins; n x 3, FLOAT32 or
                                  FLOAT64; not given = the samples, or places found within the bounds of a custom
                                  model */
    const hrbfnpr_line_desc* lines; /* a list of lines to find once; default NULL */
    int64_t line_count; /* number of `lines`; default 0 */
    int64_t line_stride; /* bytes from one element of `lines` to the next; default 0 = struct_size */
    double support; /* limit of s(x), as in hrbfnpr_trim_desc, beyond which the surface ends because samples are
                       missing, as in an open scan or a terrain; 0 or more; default 0 = the surface ends where its model
                       does: trimmed, or at the search box.  The mesh and all curves end there, what lies beyond hides
                       nothing, and the end is a BORDER.  1.5 ends the surface about 0.7 sample spacings beyond the last
                       samples; 3 ends it about 0.9 spacings beyond them, and leaves larger holes closed */
    hrbfnpr_array support_points; /* samples that `support` is measured from; n x 3, FLOAT32 or FLOAT64; not given = the
                                     model's centres.  All points of a scan show where it ends better than the centres
                                     chosen from them */
    hrbfnpr_array support_normals; /* normals of support_points, as many, of any length but 0; n x 3, FLOAT32 or
                                      FLOAT64; not given = normals of the surface there */
    const hrbfnpr_mesh* mesh; /* the mesh that the model was fitted to; default NULL.  Its triangles find lines where
                                 walls are thinner than cells.  The line set does not keep it.  Ignored with a
                                 cell_size, and if it has edges that are not manifold or whose faces do not agree */
} hrbfnpr_line_set_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_line_set_desc_init(hrbfnpr_line_set_desc* desc, uint32_t struct_size);

/* Makes the line set of a model.  The line set keeps the model alive.  `desc` may be NULL for the defaults, and
 * `operation` may be NULL.
 * Errors: INVALID_ARGUMENT (a field of `desc`; more than 4 000 000 triangles: give a larger cell_size; a support
 * without samples), NOT_CONVERGED (no surface was found, or none near its samples), OUT_OF_MEMORY, CANCELLED,
 * CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_line_set_create(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                   const hrbfnpr_line_set_desc* desc, hrbfnpr_operation* operation,
                                                   hrbfnpr_line_set** out_line_set, hrbfnpr_error* error);
/* Adds a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_line_set_retain(const hrbfnpr_line_set* line_set);
/* Releases a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_line_set_release(const hrbfnpr_line_set* line_set);

/* What making a line set found. */
typedef struct hrbfnpr_line_set_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t triangles;    /* triangles of the mesh on which curves are searched */
    int64_t turned;       /* triangles of that mesh that face away from the surface.  The surface is finer than the
                             cells there, and curves may be missed */
    int64_t missed_seeds; /* seeds that no triangle is near.  A part of the surface is too thin for the cells there */
    int64_t lines;        /* lines that were found once, for all elements of the list */
    int64_t borders;      /* curves where the surface ends */
    double cell_size;     /* side of the cells as used, in units of the model */
    double seconds;       /* time that it took to make the line set */
    int64_t bytes;        /* memory that the line set keeps */
    double left_out;      /* share of the examined area that lies beyond the samples, 0 .. 1; 0 without a support.
                             Little is examined beyond the end of a trimmed model: see its trim info */
    int64_t creases;      /* creases at any angle, each from corner to corner or closed */
} hrbfnpr_line_set_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_line_set_info_init(hrbfnpr_line_set_info* info, uint32_t struct_size);
/* Gets what making a line set found. */
HRBFNPR_API hrbfnpr_status hrbfnpr_line_set_get_info(const hrbfnpr_line_set* line_set, hrbfnpr_line_set_info* info,
                                                     hrbfnpr_error* error);

/*
 * ==========================================================================
 * 9  CAMERA AND STYLE: plain data
 * ==========================================================================
 */

/* How depth runs from the near plane to the far plane. */
enum {
    HRBFNPR_DEPTH_NEGATIVE_ONE_TO_ONE = 0, /* clip depth from -1 to 1, as in OpenGL; window depth from 0 to 1 */
    HRBFNPR_DEPTH_ZERO_TO_ONE = 1,         /* clip and window depth from 0 to 1, as in Direct3D, Vulkan and Metal */
    HRBFNPR_DEPTH_REVERSED = 2             /* clip and window depth from 1 at the near plane to 0 at the far plane */
};

/* A camera: two matrices and a viewport. */
typedef struct hrbfnpr_camera {
    uint32_t struct_size;
    uint32_t depth_convention; /* depth of `projection` and of depth buffers, HRBFNPR_DEPTH_...; default
                                  NEGATIVE_ONE_TO_ONE */
    double view[16];           /* world to eye, column-major, invertible; the eye looks along -z; default the
                                  identity */
    double projection[16];     /* eye to clip, column-major, invertible; default the identity */
    double viewport[4];        /* x and y of the top-left corner, width and height, in pixels; up to 1048576 each;
                                  default 0 x 0, which drawing refuses */
} hrbfnpr_camera;

/* Sets struct_size, identity matrices and a viewport of 0 x 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_init(hrbfnpr_camera* camera, uint32_t struct_size);
/* Sets `view` so that the camera looks from `eye` towards `target`, with `up` roughly upward in the picture; 3 doubles
 * each.
 * Errors: INVALID_ARGUMENT (eye and target are the same; `up` is 0 or parallel to the view; a number is not finite). */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_look_at(hrbfnpr_camera* camera, const double* eye,
                                                  const double* target, const double* up,
                                                  hrbfnpr_error* error);
/* Sets a perspective `projection`, and the viewport's width and height in pixels.  `vertical_angle` is the vertical
 * angle of view in radians, in (0, pi).  The planes are distances from the eye, 0 < near_plane < far_plane.
 * Errors: INVALID_ARGUMENT (an argument is out of range). */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_perspective(hrbfnpr_camera* camera, double vertical_angle,
                                                      double width, double height, double near_plane,
                                                      double far_plane, hrbfnpr_error* error);
/* Sets an orthographic `projection`, and the viewport's width and height in pixels.  `view_height` is the height of
 * what is seen, in world units, above 0. near_plane < far_plane; either may be negative.
 * Errors: INVALID_ARGUMENT (an argument is out of range). */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_orthographic(hrbfnpr_camera* camera, double view_height,
                                                       double width, double height, double near_plane,
                                                       double far_plane, hrbfnpr_error* error);
/* Sets view, projection and viewport so that a box fills the picture.  `direction` points from the eye into the scene,
 * `up` roughly upward in the picture; 3 doubles each.  `vertical_angle` is in radians, in [0, pi); 0 = orthographic.
 * `width` and `height` are in pixels.  `margin` is the share of the picture that stays free on each side, 0 .. 0.45.
 * Errors: INVALID_ARGUMENT (an argument is out of range; `up` is parallel to the direction). */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_fit_bounds(hrbfnpr_camera* camera, const double* bounds_min,
                                                     const double* bounds_max, const double* direction,
                                                     const double* up, double vertical_angle,
                                                     double width, double height, double margin,
                                                     hrbfnpr_error* error);

/* Sets view, projection and viewport so that points fill the picture, and lie in its middle.  It fits the points
 * themselves, not the corners of their box.  `points` is n x 3, FLOAT32 or FLOAT64, n >= 1.  `origin` (3 doubles, NULL
 * = 0) is added to each point: with a point set's POSITION give the origin of its info.  The other arguments are those
 * of hrbfnpr_camera_fit_bounds.
 * Errors: INVALID_ARGUMENT (no points; a number is not finite; as for hrbfnpr_camera_fit_bounds). */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_fit_points(hrbfnpr_camera* camera, const hrbfnpr_array* points,
                                                     const double* origin, const double* direction, const double* up,
                                                     double vertical_angle, double width, double height,
                                                     double margin, hrbfnpr_error* error);

/* How ink is drawn that lies behind a depth layer of surface. */
enum {
    HRBFNPR_HIDDEN_LINES_ATTENUATE = 0, /* ink is seen faintly through the surface in front of it [NPAR 6.1] */
    HRBFNPR_HIDDEN_LINES_HIDE = 1,      /* ink behind a nearer depth layer is not drawn */
    HRBFNPR_HIDDEN_LINES_SHOW = 2       /* ink is drawn as if nothing were in front of it: lambda is 0 */
};

/* How the marks that a surface hides are found. */
enum {
    /* Depth layers of surface are found from the marks.  The ink of each mark is multiplied by the transmittance of the
     * layers in front of it.  A depth layer never dims its own ink.  The picture does not depend on the number of
     * marks. */
    HRBFNPR_VISIBILITY_DEPTH_LAYERS = 0,
    /* Marks paint discs of paper and of ink from far to near, as published [NPAR 6.1]. */
    HRBFNPR_VISIBILITY_PUBLISHED = 1
};

/* How many marks a tone shows. */
enum {
    /* The ink covers the share 1 - tau of the paper.  The number of marks follows from their size, their density in the
     * picture and their overlap, so that the tone stays when the zoom or the budget changes.  If all marks together
     * cover less than 0.6, all of them are shown where 0.6 is asked for, and fewer in proportion where less is asked
     * for. */
    HRBFNPR_TONE_CURVE_COVERAGE = 0,
    HRBFNPR_TONE_CURVE_LINEAR = 1 /* the share of marks that is shown is 1 - tau [NPAR 6.2] */
};

/* Where stipples are evenly spread, with TONE_RULE_SHARE, TONE_CURVE_COVERAGE and DEPTH_LAYERS.  It has an effect on
 * stipples of DISTRIBUTION_BLUE_NOISE. */
enum {
    /* In the picture.  Where the surface turns away, marks that are even on it would form rows.  So more marks than the
     * tone wants are considered there, in their order, and each gets smaller as far as earlier ones are too near in
     * the picture.  Marks keep their places on the surface, change smoothly as the camera moves, and never get smaller
     * by a zoom in.  docs/how-marks-work.md */
    HRBFNPR_EVENNESS_PICTURE = 0,
    /* On the surface: the first marks of the order are shown.  For drawings that show the same marks by other means,
     * such as the prefixes of a vertex buffer. */
    HRBFNPR_EVENNESS_SURFACE = 1
};

/* What the tone tau of a front mark comes from: 1 = light, 0 = dark. */
enum {
    HRBFNPR_TONE_NONE = 0,    /* tau = 0: all front marks are shown */
    HRBFNPR_TONE_LIGHT = 1,   /* tau = max(0, n . l)^tone_exponent [NPAR 6.2], and fill_light on the unlit side */
    HRBFNPR_TONE_CALLBACK = 2 /* tau is what tone_function returns */
};

/* Which front marks are shown. u is the rank of a mark, tau its tone, tau_d the tone of its distance (depth_min,
 * depth_max), scale that of its zoom (zoom_reference), and share that of the layer style. */
enum {
    /* A mark is shown if u >= 1 - (1 - tau) * tau_d * scale * share.  All effects thin the same order of marks, so that
     * a blue-noise order stays one. */
    HRBFNPR_TONE_RULE_SHARE = 0,
    /* A mark is shown if it passes each test, as published: u >= tau, u < tau_d, u < scale, u < share [NPAR 6.2]. */
    HRBFNPR_TONE_RULE_PUBLISHED = 1
};

/* The space in which the direction to the light, or its place, is given. */
enum {
    HRBFNPR_LIGHT_WORLD = 0,  /* world space: the light stays where it is when the camera moves */
    HRBFNPR_LIGHT_CAMERA = 1, /* eye space: the light moves with the camera */
    HRBFNPR_LIGHT_ITEM = 2    /* object space: the light moves with the item */
};

/* Where a light comes from. */
enum {
    HRBFNPR_LIGHT_KIND_DIRECTIONAL = 0, /* from far away, everywhere from the same direction */
    HRBFNPR_LIGHT_KIND_PLACE = 1        /* from a place; its strength does not fall with the distance */
};

/* A light of a style.  It adds intensity * max(0, n . l)^tone_exponent to the light of a mark, where l is the unit
 * vector to the light. */
typedef struct hrbfnpr_light {
    uint32_t struct_size;
    uint32_t kind;    /* where it comes from, HRBFNPR_LIGHT_KIND_...; default DIRECTIONAL */
    uint32_t space;   /* space of `place`, HRBFNPR_LIGHT_...; default CAMERA */
    float intensity;  /* 0 .. 16; default 1 = a surface that faces the light is white */
    float shadow;     /* share of its light that cast shadows take away, 0 .. 1; default 0 = it casts none.  It has an
                         effect on items with a shading */
    float softness;   /* radius of the light as it is seen from the surface, in radians, 0 .. 0.5; default 0 = shadows
                         with sharp borders; the sun has 0.0047 */
    double place[3];  /* DIRECTIONAL: the direction to the light, of any length but 0; PLACE: the place; default (-0.4,
                         0.6, 0.7) */
} hrbfnpr_light;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_light_init(hrbfnpr_light* light, uint32_t struct_size);

/* Computes the tone of many places, by any illumination model.  It fills `tau` (count floats, 1 = light, 0 = dark) from
 * world positions and unit normals (count x 3 floats each).  The normals are TONE_NORMAL if the layer has them.  Values
 * are clamped to [0, 1].  It runs on the thread that called _draw.  A result other than 0, or a NaN in `tau`, makes
 * that call fail with CALLBACK. */
typedef int32_t (*hrbfnpr_tone_fn)(void* user, int64_t count, const float* positions,
                                   const float* normals, float* tau);

/* How the front marks of a layer of strokes are drawn.  Layers without strokes are always dots, and so is everything
 * with VISIBILITY_PUBLISHED. */
enum {
    HRBFNPR_SHAPE_DOTS = 0,    /* each mark is a dot */
    HRBFNPR_SHAPE_STROKES = 1, /* consecutive marks of a stroke that are shown form one line, with their width and
                                  opacity.  A single mark is a dot */
    HRBFNPR_SHAPE_HATCH = 2    /* strokes are curves that are drawn where the tone is dark enough, and their width makes
                                  the tone.  The hatch_ fields of hrbfnpr_layer_style apply.  Lines are nested: those of
                                  level k lie midway between those of lower levels.  As many levels are drawn as the
                                  picture has room for, so that the tone does not depend on the zoom.  Points of a line
                                  have the id of the nearest mark.  A stroke whose ends meet is closed [Winkenbach &
                                  Salesin 1994; Praun et al. 2001] */
};

/* What tone_field does to the tone. */
enum {
    HRBFNPR_FIELD_RULE_REPLACE = 0, /* the tone becomes the value */
    HRBFNPR_FIELD_RULE_SCALE = 1    /* the tone is multiplied by the value */
};

/* Which inks of a palette the marks of an ink_field take. */
enum {
    HRBFNPR_PALETTE_NEAREST = 0, /* each mark takes the ink that is nearest to its colour [Oklab, Ottosson 2020] */
    HRBFNPR_PALETTE_MIXED = 1    /* neighbouring marks take the two or three inks whose mean has the colour's hue */
};

/* How layers of marks are drawn.  Colours are straight RGBA in [0, 1], sRGB-encoded.  Lengths in pixels are those of
 * the picture. */
typedef struct hrbfnpr_layer_style {
    uint32_t struct_size;
    uint32_t kind;      /* kind of the layers that this style is for, HRBFNPR_LAYER_KIND_...; default ANY */
    const char* name;   /* name of the layers that this style is for; default NULL = any name.  It is read during _draw
                           only */
    uint32_t shown;     /* 1 or 0: whether front marks are drawn; default 1 */
    uint32_t contours;  /* 1 or 0, with VISIBILITY_PUBLISHED: whether marks near a contour draw it; default 1.  Strokes
                           of kind OWN never do, as they may be few.  If `shown` is 0 and this is 1, the layer still
                           hides what lies behind its surface; if both are 0, it takes no part */
    uint32_t directions; /* which strokes are drawn: bit 0 the first direction, bit 1 the second; default 3 */
    uint32_t shape;     /* shape of front marks, HRBFNPR_SHAPE_...; default DOTS */
    float share;        /* share of the layer's marks that is used at all, 0 .. 1; default 1.  Less makes the layer
                           paler */
    float radius;       /* radius of a mark, and half the width of a stroke, in pixels; above 0, up to 16384; default
                           1 */
    float radius_zoom;  /* how the radius follows the zoom, relative to zoom_reference of the style; 0 .. 1; default 0 =
                           the radius stays the same in pixels; 1 = it grows with the zoom */
    uint32_t reserved;
    float ink[4];       /* colour of the ink, straight RGBA; default black */
    /* SHAPE_HATCH.  Lines cover a share of the paper that grows with the darkness, 1 - tau. */
    float hatch_tone_begin;     /* darkness, 1 - tau, at which lines begin; 0 .. 1; default 0.15.  Larger: lights are
                                   emptier.  See also hatch_fade */
    float hatch_tone_end;       /* darkness, 1 - tau, from which on lines get no wider; above hatch_tone_begin, up to 1;
                                   default 0.95 */
    float hatch_coverage_begin; /* share of the paper that lines cover at hatch_tone_begin, times `share`; above 0, up
                                   to 1; default 0.1 */
    float hatch_coverage_end;   /* share of the paper that lines cover at hatch_tone_end, times `share`; above 0, up to
                                   1; default 0.82.  Lines of unknown separation have the width 2 * radius there */
    float hatch_spacing;        /* least distance from line to line, in pixels; above 0, up to 16384; default 4.6.
                                   Larger: fewer, wider lines */
    float hatch_pen;            /* least width of a line, in pixels; above 0, up to 16384; default 0.6.  Lines are
                                   thinner only where they fade in or end, or are closer together than hatch_spacing */
    float hatch_white;          /* least width of the paper between lines, in pixels; 0 .. 16384; default 1.2 */
    float hatch_taper;          /* length over which a line narrows where its tone ends, in pixels; 0 .. 16384; default
                                   20.  Where it ends for another reason, it narrows over a shorter length */
    float hatch_shortest;       /* length below which a piece of a line is not drawn, in pixels; 0 .. 16384; default 10.
                                   Pieces up to twice this length are thinner */
    uint32_t reserved2;
    float hatch_wobble;         /* how far a line strays to either side, as if drawn by an unsteady hand, in multiples
                                   of hatch_pen; 0 .. 16; default 0.  A swing covers about 60 hatch_pen */
    float hatch_overshoot;      /* greatest length by which a line runs on past the end of its tone, in pixels;
                                   0 .. 16384; default 0.  Each end has another length */
    uint32_t hatch_seed;        /* seed of hatch_wobble, hatch_overshoot and hatch_fade; any number; default 0 */
    uint32_t reserved3;
    /* Fields of the point set, by name (hrbfnpr_point_set_with_fields).  They are read during _draw only; default
     * NULL = none.  A value v with the weight w changes what it acts on from x to x + w (v' - x), where v' is what v
     * alone gives.  Layers without values of a field are drawn without it.  If no layer of a set has it, drawing fails
     * with INVALID_ARGUMENT.  Fields have no effect with VISIBILITY_PUBLISHED. */
    const char* density_field; /* SCALAR: the share of marks that is shown is multiplied by the value, clamped to
                                  0 .. 1.  With SHAPE_HATCH, the darkness is multiplied */
    const char* tone_field;    /* SCALAR: changes the tone tau, 1 = light, 0 = dark, as tone_field_rule says.  REPLACE
                                  clamps the value to 0 .. 1, SCALE to 0 .. 16, and the result is clamped to 0 .. 1 */
    const char* width_field;   /* SCALAR: radii and widths are multiplied by the value, clamped to 0 .. 16; 0 leaves
                                  marks out */
    const char* ink_field;     /* COLOUR: each mark takes an ink of the style's palette, as palette_rule says.  Marks
                                  with a weight below 0.5 take `ink`.  Strokes are cut where their ink changes, except
                                  that parts shorter than twice their width take the ink of the part before */
    const char* mask_field;    /* SCALAR: marks with a value below 0.5 are left out, and strokes end there */
    uint32_t tone_field_rule;  /* HRBFNPR_FIELD_RULE_...; default REPLACE */
    uint32_t palette_rule;     /* HRBFNPR_PALETTE_...; default NEAREST */
    /* SHAPE_HATCH */
    float hatch_fade; /* range of darkness below hatch_tone_begin over which lines end one after the other; 0 .. 1,
                         counted up to hatch_tone_begin; default 0 = all lines end at hatch_tone_begin.  Over this range
                         the share of the paper that lines cover falls evenly to 0: lines become fewer, and break
                         before they end.  Places with a darkness of 0 stay empty.  Larger: lights are less empty */
    uint32_t reserved4;
} hrbfnpr_layer_style;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_layer_style_init(hrbfnpr_layer_style* style, uint32_t struct_size);

/* How the parts of a line that surface hides are drawn.  A layer of surface is two sheets. */
enum {
    HRBFNPR_HIDDEN_PARTS_NONE = 0,       /* hidden parts are not drawn */
    HRBFNPR_HIDDEN_PARTS_ATTENUATED = 1, /* hidden parts get paler with each layer of surface in front of them */
    HRBFNPR_HIDDEN_PARTS_DASHED = 2,     /* hidden parts are dashed; the more layers lie in front, the shorter the
                                            dashes */
    HRBFNPR_HIDDEN_PARTS_SHOWN = 3       /* hidden parts are drawn like visible ones */
};

/* The shape of a free end of a line: one that meets no other line in the picture, such as a cusp, where a contour turns
 * behind its own surface. */
enum {
    HRBFNPR_CAP_ROUND = 0,  /* half a disc beyond the end */
    HRBFNPR_CAP_FLAT = 1,   /* cut off straight at the end */
    HRBFNPR_CAP_POINTED = 2 /* a tip, whose length is twice the width of the line there */
};

/* Which creases are drawn. */
enum {
    HRBFNPR_CREASES_ALL = 0,    /* all creases */
    HRBFNPR_CREASES_CONVEX = 1, /* convex creases: edges */
    HRBFNPR_CREASES_CONCAVE = 2 /* concave creases: grooves, and where something stands on a face */
};

/* How the lines of one kind are drawn, for items that have a line set.  Lengths are in pixels unless a field says
 * otherwise.  Of two contours, borders, creases, intersections, ridges, valleys, suggestive contours, apparent ridges
 * or tangent edges of one ink that run side by side, nearer than a pen, only one keeps its width, and the other narrows
 * and ends: the one of the later kind in this list, or the thinner, or the shorter.  Items whose halo_width is 0 keep
 * all their lines. */
typedef struct hrbfnpr_line_style {
    uint32_t struct_size;
    uint32_t kind;        /* kind of lines that this style is for, HRBFNPR_LINE_KIND_...; default CONTOUR */
    const char* name;     /* name (hrbfnpr_line_desc.name) of the lines found once that this style is for; default NULL
                             = any name.  It is read during _draw only */
    uint32_t hidden;      /* how hidden parts are drawn, HRBFNPR_HIDDEN_PARTS_...; default NONE */
    uint32_t cap;         /* shape of free ends, HRBFNPR_CAP_...; default ROUND */
    float width;          /* width of a line, in pixels; above 0, up to 16384; default 2 */
    float taper;          /* length over which a line narrows to a free end, as half an ellipse, in pixels; 0 .. 16384;
                             default 12; 0 = it does not narrow.  A part with a free end that is shorter than two tapers
                             is thinner the shorter it is */
    float hidden_width;   /* width of ATTENUATED and DASHED parts, in pixels; above 0, up to 16384; default 1.2 */
    float hidden_opacity; /* factor of the opacity of ATTENUATED parts for each layer in front, 0 .. 1; default 0.35 */
    float dash;           /* length of a dash of DASHED parts, in hidden_widths; above 0, up to 16384; default 5 */
    float gap;            /* length of a gap between dashes, in hidden_widths; above 0, up to 16384; default 3 */
    float shortest;       /* length below which parts with a free end, and hidden parts, are not drawn, in pixels;
                             0 .. 16384; default 2.  Feature lines that are found for every drawing have a length of at
                             least 0.01 diagonals in any case */
    float fade;           /* how much paler a line is where its strength is `lower` than where it is `upper`, 0 .. 1;
                             default 1; 0 = it does not fade */
    double lower;         /* least strength at which a line goes on, as in hrbfnpr_line_desc; 0 or more; default 0.  If
                             `lower` and `upper` are 0, it is 10 for suggestive contours, 12 for apparent ridges, 15
                             (degrees) for creases, 15 (degrees) for soft edges, 2 (degrees) for intersections, and 0
                             for other kinds */
    double upper;         /* strength that a line must reach somewhere to be drawn; 0 or more; default 0.  If `lower`
                             and `upper` are 0, it is 30 for suggestive contours, 25 for apparent ridges, 30 (degrees)
                             for creases, 35 (degrees) for soft edges, and 0 for other kinds */
    hrbfnpr_array levels; /* values of n . l at which an ISOPHOTE lies; n x 1, FLOAT64, packed, -1 .. 1; at least one
                             for ISOPHOTE.  It is read during _draw only */
    float ink[4];         /* colour of the ink, straight RGBA; default black */

    /* Laws of the width: factors of `width`, 0 .. 16; 1 = no effect.  All that apply to a place are multiplied.  They
     * follow the distance in the picture between a contour and an isophote [Goodwin et al. 2007]. */
    float outline_factor;   /* factor of the width of CONTOUR and BORDER where nothing lies beside the line on its outer
                               side: on the outline of all items that have lines; 0 .. 16; default 1.  Beyond the ends
                               of the outline it changes to 1 over 6 widths.  All factors that apply to a place are
                               multiplied */
    float far_factor;       /* factor of the width at the farthest place of the surfaces of all items that have lines,
                               in the viewport; 0 .. 16; default 1.  It is 1 at the nearest place, and changes evenly
                               with depth.  If the surfaces reach less deep than half of their extent across the line
                               of sight, it changes as if they reached so deep */
    float lit_factor;       /* factor of the width where the surface faces the style's light, whatever its tone;
                               0 .. 16; default 1.  It is 1 where the surface faces away, and changes evenly with
                               n . l */
    float curvature_factor; /* factor of the width where the surface bends sharply; 0 .. 16; default 1.  It is 1 where
                               the radius of curvature is curvature_radius or more, and changes evenly with the radius.
                               For CONTOUR it is the radial curvature, along the line of sight; for other kinds it is
                               the normal curvature across the line */
    float curvature_radius; /* radius of curvature from which on curvature_factor has no effect, in diagonals; above 0;
                               default 0.1 */

    /* An unsteady hand.  It is the same in each drawing and, as lengths are in widths, at each size of the picture. */
    float wobble;         /* how far a line strays to either side, in widths; 0 .. 16; default 0 */
    float wobble_width;   /* share by which the width of a line varies; 0 .. 1; default 0 */
    float wobble_length;  /* approximate length from swing to swing, in widths; 1 .. 16384; default 40 */
    uint32_t wobble_seed; /* seed of the wobble; any number; default 0 */
    uint32_t creases;     /* which lines of the kinds CREASE and SOFT_EDGE are drawn, HRBFNPR_CREASES_...; default
                             ALL */
} hrbfnpr_line_style;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_line_style_init(hrbfnpr_line_style* style, uint32_t struct_size);

/* How an item is drawn. docs/presets.md shows named styles, and docs/how-marks-work.md explains the method. */
typedef struct hrbfnpr_style {
    uint32_t struct_size;
    uint32_t tone;               /* source of the tone, HRBFNPR_TONE_...; default LIGHT */
    float paper[4];              /* colour of the paper, straight RGBA; default white; alpha 0 = transparent.  It must
                                    be the same in all styles of a drawing */
    const hrbfnpr_layer_style* layers; /* a list of layer styles; default NULL.  A layer of marks takes the first that
                                          is for it, or else the defaults of hrbfnpr_layer_style_init */
    int64_t layer_count;               /* number of `layers`; default 0 */
    int64_t layer_stride;              /* bytes from one element of `layers` to the next; default 0 = struct_size */

    /* Tone. */
    uint32_t tone_rule;          /* which marks are shown, HRBFNPR_TONE_RULE_...; default SHARE */
    uint32_t tone_curve;         /* how many marks a tone shows, HRBFNPR_TONE_CURVE_...; default COVERAGE.  Only for
                                    TONE_RULE_SHARE */
    double light[3];             /* direction to the light, of any length but 0 where a light is used; default (-0.4,
                                    0.6, 0.7) */
    double tone_exponent;        /* lambda, the exponent of the tone law; above 0; default 1.  Larger: the picture gets
                                    darker */
    hrbfnpr_tone_fn tone_function; /* tone of TONE_CALLBACK; default NULL */
    void* tone_user;             /* passed to tone_function; default NULL */
    uint32_t light_space;        /* space of `light`, HRBFNPR_LIGHT_...; default CAMERA */
    float tone_fade;             /* share of the shown marks over which a mark grows from nothing to its full area,
                                    0 .. 1; default 0.25; 0 = marks pop in.  With DEPTH_LAYERS only */

    /* Contours made of marks, with VISIBILITY_PUBLISHED.  With DEPTH_LAYERS contours are lines of an item's line
     * set. */
    double silhouette_threshold; /* delta, which separates classes with PUBLISHED, in (0, 1); default 0.2.  A mark is
                                    front if n . v < -delta, back if n . v > delta, else silhouette, where v points from
                                    the camera to the mark [NPAR 6].  Larger: wider contours */
    float silhouette_radius;     /* radius of a silhouette mark, in pixels, with PUBLISHED; above 0, up to 16384;
                                    default 1 */
    float silhouette_radius_zoom; /* how silhouette_radius follows the zoom, as radius_zoom of hrbfnpr_layer_style;
                                     0 .. 1; default 0 */
    float silhouette_ink[4];     /* colour of silhouette marks, straight RGBA, with PUBLISHED; default black */

    /* Hidden lines. */
    uint32_t visibility;         /* how hidden marks are found, HRBFNPR_VISIBILITY_...; default DEPTH_LAYERS.  It must
                                    be the same in all styles of a drawing */
    uint32_t hidden_lines;       /* how hidden ink is drawn, HRBFNPR_HIDDEN_LINES_...; default ATTENUATE */
    double attenuation_front;    /* lambda of alpha_f = nu^2 lambda, the opacity of surface that faces the eye, nu =
                                    n . v; 0 or more; default 1.  Larger: hidden ink is paler */
    double attenuation_back;     /* lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda, the opacity of surface that
                                    faces away; 0 or more; default 1.  Larger: hidden ink is paler */
    float splat_radius;          /* radius of the splat, the disc of surface around a mark, in pixels; 0 .. 16384;
                                    default 0 = from the marks' spacing in the picture */
    float splat_overlap;         /* number n of splats that overlap in a depth layer, whose opacity is 1 - (1 - alpha)^n
                                    whatever the marks' density and the zoom; 0 .. 1e6; default 8; 0 = each mark paints
                                    with alpha itself, as published.  Larger: hidden ink is paler */
    float halo_width;            /* width of the halo, in pixels at any zoom; 0 .. 16384; default 2.  With DEPTH_LAYERS
                                    a surface hides what lies behind it up to this far beyond its contour; if it is
                                    above 0, lines that run beside others, nearer than a pen, are thinned
                                    (docs/lines.md).  With PUBLISHED it is added to the radius of the paper of back
                                    marks */
    uint32_t verify_lines;       /* 1 or 0; default 0.  1: rays from the eye are compared with all parts of the item's
                                    lines, and wrong parts are repaired; hrbfnpr_drawing_info has the counts
                                    (docs/lines.md) */

    /* Distance and zoom. */
    double depth_min;      /* distance from the camera at which marks begin to vanish, in world units; default 0.
                              Either 0 < depth_min < depth_max, or both are 0 and distance has no effect.  Between the
                              two the share of marks falls with the logarithm of the distance */
    double depth_max;      /* distance from the camera from which on nothing is shown, in world units; above depth_min;
                              default 0 = no effect */
    double zoom_reference; /* pixels per world unit from which on all marks are shown; 0 or more; default 0 = no effect.
                              Below it the share zoom^zoom_exponent of the marks is shown, where zoom is the pixels per
                              world unit at a mark divided by this.  The area of the paper of back marks scales alike
                              [NPAR 6.2] */
    double zoom_exponent;  /* exponent of the zoom, 0 or more; default 2, which keeps the ink per area */

    /* Lines of items that have a line set, with DEPTH_LAYERS. */
    const hrbfnpr_line_style* lines; /* a list of line styles; default NULL = no lines */
    int64_t line_count;              /* number of `lines`; default 0 */
    int64_t line_stride;             /* bytes from one element of `lines` to the next; default 0 = struct_size */

    float fill_light;   /* strength of a light from the side opposite to `light`, which lets the unlit side keep its
                           form: tau = fill_light * (n . l)^2 where n . l < 0; 0 .. 1; default 0.25.  The lit side stays
                           as it is.  For TONE_LIGHT with DEPTH_LAYERS and TONE_RULE_SHARE.  With `lights` it comes
                           from the side opposite to the first one */
    uint32_t reserved2;

    /* Lights, for TONE_LIGHT with DEPTH_LAYERS and TONE_RULE_SHARE.  Their sum is the light s of a mark, and the tone
     * law makes tau of it: tau = t^tone_gamma, where t = (s - tone_black) / (tone_white - tone_black), clamped to 0 ..
     * 1. */
    float light_intensity;       /* as in hrbfnpr_light; default 1 */
    float light_shadow;          /* as in hrbfnpr_light; default 0 */
    float light_softness;        /* as in hrbfnpr_light; default 0 */
    uint32_t evenness;           /* where stipples are evenly spread, HRBFNPR_EVENNESS_...; default PICTURE */
    const hrbfnpr_light* lights; /* a list of up to 8 lights; default NULL = one directional light, with the fields
                                    `light` and light_, which a list replaces.  The first one is the light of isophotes
                                    and of lit_factor */
    int64_t light_count;         /* number of `lights`; default 0 */
    int64_t light_stride;        /* bytes from one element of `lights` to the next; default 0 = struct_size */
    double ambient_up[3];        /* direction to the sky, in world space, of any length but 0; default (0, 1, 0) */
    float ambient_sky;           /* light where the surface faces the sky; 0 .. 16; default 0.  Ambient light is a mean
                                    of the light from the sky, weighted by (1 + n . up) / 2, and that from the ground */
    float ambient_ground;        /* light where the surface faces the ground; 0 .. 16; default 0 */
    float occlusion;             /* share of the ambient light that is lost where no sky is seen, 0 .. 1; default 1.  It
                                    has an effect on items with a shading */
    float occlusion_exponent;    /* ambient light is multiplied by the share of sky that is seen to this power; above
                                    0, up to 16; default 1.5.  Larger: hollows are darker */
    float rim_light;             /* adds rim_light * (1 - |n . v|)^rim_exponent, where v points to the eye: contours are
                                    lighter; 0 .. 16; default 0 */
    float rim_exponent;          /* above 0, up to 64; default 3.  Larger: the light rim is narrower */
    float tone_black;            /* light that is drawn as black; -16 .. 16; default 0 */
    float tone_white;            /* light that is drawn as white; above tone_black, up to 16; default 1 */
    float tone_gamma;            /* exponent of the tone law; above 0, up to 16; default 1.  Larger: darker mid-tones */
    uint32_t tone_steps;         /* number of flat tones, from black to white, 2 .. 6; default 0 = continuous tones.
                                    The steps of t have the same size */
    float curvature_contrast;    /* light that ridges and hills add, and that hollows take away: it is multiplied by a
                                    number from -1 to 1, tanh(3 H scale) less its mean over the surface, where H is the
                                    mean curvature; 0 .. 16; default 0.  It has an effect on items whose shading was
                                    made with it (hrbfnpr_shading_desc.curvature_scale) */
    float occlusion_lights;      /* share of the light of all lights and of the fill light that is lost where no sky is
                                    seen, 0 .. 1; default 0.  Hollows get darker, and the rest stays as it is.  It has
                                    an effect on items with a shading */
    const float* palette;        /* inks for ink_field, palette_count x 4, straight RGBA in [0, 1], sRGB-encoded;
                                    default NULL.  It is read during _draw only */
    int64_t palette_count;       /* number of inks; 0 .. 8; default 0.  An ink_field needs at least one */
} hrbfnpr_style;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_style_init(hrbfnpr_style* style, uint32_t struct_size);

/* Named styles, each with a picture in docs/presets.md. bindings/generate writes this list from bindings/presets.py. */
enum {
    HRBFNPR_PRESET_STIPPLE = 0,             /* stipples, denser where it is darker, without contours */
    HRBFNPR_PRESET_HATCH = 1,               /* lines of one width, denser where it is darker, and contours */
    HRBFNPR_PRESET_CROSS_HATCH = 2,         /* up to three sets of lines of one width, at 0, 35 and -30 degrees, each
                                               for a darker tone, and contours */
    HRBFNPR_PRESET_COMBING = 3,             /* lines along Stark's combing direction, with a second set in the darks,
                                               and contours */
    HRBFNPR_PRESET_SILHOUETTE = 4,          /* contours only; hidden ones are paler */
    HRBFNPR_PRESET_CONTOUR_AND_STIPPLE = 5, /* contours and stipples */
    HRBFNPR_PRESET_XRAY = 6,                /* contours only; hidden ones are dashed */
    HRBFNPR_PRESET_FULL = 7,                /* stipples, cross hatching in the darks, contours and halos [NPAR, Figure 1
                                               (e)] */
    HRBFNPR_PRESET_ENGRAVING = 8,           /* one set of lines that swell with the tone, and contours; lights have a
                                               few broken lines */
    HRBFNPR_PRESET_ETCHING = 9,             /* up to three sets of thin lines, at 0, 50 and -40 degrees, each for a
                                               darker tone, and contours */
    HRBFNPR_PRESET_WOODCUT = 10,            /* few wide lines, which close up to black, and heavy contours */
    HRBFNPR_PRESET_SCIENTIFIC_STIPPLE = 11, /* fine stipples lit from the upper left, and outlines that swell in the
                                               shade; lights stay empty */
    HRBFNPR_PRESET_SKETCH = 12,             /* pencil on warm paper: two sets of lines that stray and run past their
                                               ends, and contours drawn twice */
    HRBFNPR_PRESET_BLUEPRINT = 13,          /* pale lines on blue without tone: contours, borders, creases and lines
                                               called "crease"; hidden ones are dashed */
    HRBFNPR_PRESET_ARCHAEOLOGICAL = 14      /* short lines along the curvature that taper to the light from the upper
                                               left, heavy outlines, and the RIDGE lines of a line set */
};

/* Sets all fields of a style to those of a preset. style->layers and style->lines point to constants of the library:
 * copy an element to change it.
 * Errors: INVALID_ARGUMENT (no such preset). */
HRBFNPR_API hrbfnpr_status hrbfnpr_style_init_preset(hrbfnpr_style* style, uint32_t struct_size,
                                                     uint32_t preset, hrbfnpr_error* error);
/* Gets the layers of marks that a preset draws, with their defaults: a list of constants for
 * hrbfnpr_generate_desc.layers, with layer_stride 0. *count gets their number.  The result is NULL, with a count of 0,
 * for a number that no preset has. */
HRBFNPR_API const hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint32_t preset, int64_t* count);
/* Gets the name of a preset, such as "cross-hatch"; static.  The result is NULL for a number that no preset has.
 * Presets are numbered from 0 without gaps. */
HRBFNPR_API const char* hrbfnpr_preset_name(uint32_t preset);

/*
 * ==========================================================================
 * 10  FIELDS: values on a surface; immutable
 * ==========================================================================
 *
 * A field gives each place of a surface a value and a weight.  The value is a number, a colour or a direction.  The
 * weight is 0 where the field says nothing, and up to 1.  Values come from points or a mesh, from a function, from dabs
 * of a brush, or from an image that is projected along a camera.
 *
 * A field sets where marks are made (hrbfnpr_layer_desc).  hrbfnpr_point_set_with_fields keeps its values at the marks
 * of a set, and a layer's style says what they change.
 */

/* The surfaces that cast shadows and hide the sky, see hrbfnpr_occluders_create.  It does not change, so any threads
 * may use it. */
typedef struct hrbfnpr_occluders hrbfnpr_occluders;

/* The values of a field. */
enum {
    HRBFNPR_FIELD_KIND_SCALAR = 0,   /* one number */
    HRBFNPR_FIELD_KIND_COLOUR = 1,   /* three numbers: r, g, b; sRGB-encoded, 0 .. 1 */
    HRBFNPR_FIELD_KIND_DIRECTION = 2 /* three numbers: x, y, z.  Only the tangent part counts; its sign does not */
};

/* Where the values of a field come from. */
enum {
    HRBFNPR_FIELD_SOURCE_POINTS = 0,   /* from values at points, or at the vertices of triangles */
    HRBFNPR_FIELD_SOURCE_FUNCTION = 1, /* from a function */
    HRBFNPR_FIELD_SOURCE_DABS = 2,     /* from dabs of a brush */
    HRBFNPR_FIELD_SOURCE_IMAGE = 3     /* from an image, which is projected onto the surface along a camera */
};

/* What a dab paints. */
enum {
    HRBFNPR_DAB_TONE = 0,     /* the tone: 1 = light, 0 = dark */
    HRBFNPR_DAB_DENSITY = 1,  /* the density of stipples: 1 = all, 0 = none */
    HRBFNPR_DAB_DIRECTION = 2 /* the direction of hatching */
};

/* A dab of a brush: a ball on the surface in which what is painted moves towards a value.  Dabs act one after the
 * other. */
typedef struct hrbfnpr_dab {
    uint32_t struct_size;
    uint32_t map;        /* what it paints in a picture, HRBFNPR_DAB_...; default TONE.  Fields ignore it */
    double position[3];  /* middle of the ball, in coordinates of the source or of the field */
    double normal[3];    /* unit normal of the surface there; surface that faces away from it is not painted */
    double radius;       /* radius of the ball, in the unit of `position`; above 0 */
    double strength;     /* strength s in the middle, 0 .. 1; default 1.  At the distance d from there it is
                            s (1 - d^2 / radius^2)^2 */
    double value;        /* value of TONE and DENSITY, 0 .. 1, or of a SCALAR field, any number; default 0 */
    double direction[3]; /* direction of DIRECTION, which hatching follows; the value of a field of three numbers */
} hrbfnpr_dab;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_dab_init(hrbfnpr_dab* dab, uint32_t struct_size);

/* Gives values on a surface.  A value that is not finite, a weight outside 0 .. 1, or a result other than 0 fails the
 * call with CALLBACK.  Where the weight is 0, the value is not read.  The function gets some thousand places at a time,
 * on the thread that called the library.
 *
 * positions:   count x 3, absolute
 * normals:     count x 3, unit
 * values:      receives count x 1 (SCALAR) or count x 3 numbers
 * weights:     receives count numbers; they are 1 before the call */
typedef int32_t (*hrbfnpr_field_fn)(void* user, int64_t count, const double* positions, const double* normals,
                                    double* values, double* weights);

/* What a field is made from. */
typedef struct hrbfnpr_field_desc {
    uint32_t struct_size;
    uint32_t kind;       /* HRBFNPR_FIELD_KIND_...; default SCALAR */
    uint32_t source;     /* HRBFNPR_FIELD_SOURCE_...; default POINTS */
    uint32_t flags;      /* reserved; 0 */
    double range[2];     /* SCALAR: range[0] becomes 0, range[1] becomes 1, and values are clamped; range[0] may be the
                            larger one.  Default 0, 0 = values stay as they are */

    /* POINTS. */
    hrbfnpr_array points;    /* n x 3, FLOAT32 or FLOAT64; 1 or more */
    hrbfnpr_array triangles; /* m x 3, INT32, INT64 or UINT32: numbers of points.  Not given: a place has the value of
                                the nearest point.  Given: it has the value of the nearest place of the triangles,
                                interpolated between their corners */
    hrbfnpr_array values;    /* n x 1 (SCALAR) or n x 3, FLOAT32, FLOAT64 or UINT8; UINT8 colours are 0 .. 255.
                                Directions are interpolated as lines without a sign.  Colours are clamped to 0 .. 1 */
    double reach;            /* distance from the points or triangles beyond which a place has no value; 0 or more;
                                default 0 = there is no such distance */

    /* FUNCTION. */
    hrbfnpr_field_fn function; /* gives the values */
    void* user;                /* passed to `function`; it must stay valid while the field lives */

    /* DABS. */
    const hrbfnpr_dab* dabs; /* a list, copied.  All act, one after the other, whatever their `map`.  SCALAR takes
                                `value`, DIRECTION takes `direction`, COLOUR takes `direction` as r, g, b */
    int64_t dab_count;       /* number of dabs; 0 .. 1000000; default 0 */
    int64_t dab_stride;      /* bytes from one dab to the next; 0 = the first one's struct_size */

    /* IMAGE.  A place outside the image, one that faces away from the camera, and one that is hidden has no value. */
    const hrbfnpr_image* image;   /* the image, copied.  COLOUR takes its colour, SCALAR its luminance Y' = 0.2126 R' +
                                     0.7152 G' + 0.0722 B'.  Alpha is the weight; COVERAGE8 and DIRECTION are refused */
    const hrbfnpr_camera* camera; /* the camera along which it is projected, in the coordinates of the field.  The image
                                     fills its viewport */
    const hrbfnpr_occluders* occluders; /* surfaces that hide places from the camera, in the coordinates of the field;
                                           default NULL = none */
} hrbfnpr_field_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_field_desc_init(hrbfnpr_field_desc* desc, uint32_t struct_size);
/* Creates a field.
 *
 * operation:   may be NULL
 *
 * Errors: INVALID_ARGUMENT (an array is missing or has a wrong shape; the message names it). */
HRBFNPR_API hrbfnpr_status hrbfnpr_field_create(hrbfnpr_context* context, const hrbfnpr_field_desc* desc,
                                                hrbfnpr_operation* operation, hrbfnpr_field** out_field,
                                                hrbfnpr_error* error);
HRBFNPR_API void hrbfnpr_field_retain(const hrbfnpr_field* field);  /* Adds a reference.  Any thread. */
HRBFNPR_API void hrbfnpr_field_release(const hrbfnpr_field* field); /* Removes a reference.  Any thread. */

/* Evaluates a field at places on a surface.
 *
 * positions:   n x 3, FLOAT32 or FLOAT64, absolute
 * normals:     n x 3, FLOAT32 or FLOAT64, unit; may be NULL for POINTS
 * values:      receives n x 1 (SCALAR) or n x 3, FLOAT32 or FLOAT64; 0 where the weight is 0; may be NULL
 * weights:     receives n x 1, FLOAT32 or FLOAT64, 0 .. 1; 0 also where numbers overflow; may be NULL
 * operation:   may be NULL
 *
 * Errors: CALLBACK (the field's function failed). */
HRBFNPR_API hrbfnpr_status hrbfnpr_field_evaluate(const hrbfnpr_field* field, const hrbfnpr_array* positions,
                                                  const hrbfnpr_array* normals, const hrbfnpr_array_out* values,
                                                  const hrbfnpr_array_out* weights, hrbfnpr_operation* operation,
                                                  hrbfnpr_error* error);

/*
 * ==========================================================================
 * 11  RENDERER: from items and a camera to a drawing        [NPAR 6]
 * ==========================================================================
 *
 * A renderer is the scratch memory of one thread.  It keeps a few of its last drawings, and makes the next one in the
 * memory of a drawing that no one else holds.  So a program that releases each drawing before it makes the next but one
 * allocates nothing after a few frames, unless lines are drawn.  The point sets of the last drawing stay alive until
 * the next one is made or the renderer is released.
 */

/* The scratch memory of one thread, for drawing. */
typedef struct hrbfnpr_renderer hrbfnpr_renderer;
/* A picture as a value: dots and strokes in window coordinates. */
typedef struct hrbfnpr_drawing hrbfnpr_drawing;

/* Makes a renderer.
 * Errors: INVALID_ARGUMENT (a NULL argument), OUT_OF_MEMORY. */
HRBFNPR_API hrbfnpr_status hrbfnpr_renderer_create(hrbfnpr_context* context, hrbfnpr_renderer** out_renderer,
                                                   hrbfnpr_error* error);
/* Adds a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_renderer_retain(hrbfnpr_renderer* renderer);
/* Releases a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_renderer_release(hrbfnpr_renderer* renderer);

/* The marks of one layer as they are in this drawing, for an animated surface. */
typedef struct hrbfnpr_layer_pose {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t layer;           /* number of the layer in the item's point set; each layer has one pose at most */
    hrbfnpr_array position;  /* absolute positions, in the order of the layer's n marks; n x 3, FLOAT32 or FLOAT64 */
    hrbfnpr_array normal;    /* outward unit normals; n x 3, FLOAT32 or FLOAT64 */
    hrbfnpr_array direction; /* unit directions; n x 3, FLOAT32 or FLOAT64; empty = the directions of the set */
} hrbfnpr_layer_pose;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_layer_pose_init(hrbfnpr_layer_pose* pose, uint32_t struct_size);

/* The sides of an item's surface on which its marks are drawn.  Lines are seen from both sides in any case. */
enum {
    HRBFNPR_SIDES_FRONT = 0, /* the side that the normals point to; for a solid, whose inside is never seen */
    HRBFNPR_SIDES_BOTH = 1   /* both sides; for a surface that ends, such as a bowl or a leaf.  Where the other side
                                faces the camera, marks are drawn with opposite normals.  Such marks keep their ids,
                                count as front and as back in hrbfnpr_drawing_info, and are in separate layers after
                                those of all items.  With ATTENUATE a depth layer of such an item is as opaque as two,
                                one that faces the camera and one that faces away */
};

/* How much light reaches the marks of an item past the surfaces of all items; see hrbfnpr_shading_create. */
typedef struct hrbfnpr_shading hrbfnpr_shading;

/* One thing to draw.  What it points to is read during _draw only, except that the drawing retains the point set. */
typedef struct hrbfnpr_item {
    uint32_t struct_size;
    uint32_t sides;             /* sides on which marks are drawn, HRBFNPR_SIDES_...; default FRONT */
    const hrbfnpr_point_set* point_set; /* marks to draw; not NULL */
    const hrbfnpr_style* style; /* how they are drawn; default NULL = the defaults of hrbfnpr_style_init */
    const hrbfnpr_model* model; /* surface that the marks lie on; default NULL.  With it, and DEPTH_LAYERS, a ray from
                                   each mark to the eye finds what hides the mark: exact, but slow.  It must be NULL if
                                   there are poses */
    double transform[16];       /* object to world, column-major, affine and invertible; default the identity */
    const hrbfnpr_layer_pose* poses; /* a list of layers whose marks have moved; default NULL */
    int64_t pose_count;              /* number of `poses`; default 0 */
    int64_t pose_stride;             /* bytes from one element of `poses` to the next; default 0 = struct_size */
    const hrbfnpr_line_set* line_set; /* what the style's lines are drawn from; default NULL = no lines.  All items of a
                                         drawing that have one hide each other's lines; other items hide no lines.  It
                                         must be NULL if there are poses */
    const hrbfnpr_shading* shading; /* how much light reaches the marks; default NULL = all.  It must be that of
                                       `point_set`, and NULL if there are poses */
} hrbfnpr_item;

/* Sets struct_size, NULL pointers and the identity transform. */
HRBFNPR_API hrbfnpr_status hrbfnpr_item_init(hrbfnpr_item* item, uint32_t struct_size);

/* Gathers the surfaces of all items that have a line set, at their transforms: the triangles on which lines are found.
 * Walls thinner than a cell of the line set may let light through.  The occluders keep the line sets alive.
 *
 * items:       a list, of which line_set and transform are read; an item needs no point set
 * operation:   may be NULL
 *
 * Errors: INVALID_ARGUMENT (no item has a line set). */
HRBFNPR_API hrbfnpr_status hrbfnpr_occluders_create(hrbfnpr_context* context, const hrbfnpr_item* items,
                                                    int64_t item_count, int64_t item_stride,
                                                    hrbfnpr_operation* operation, hrbfnpr_occluders** out_occluders,
                                                    hrbfnpr_error* error);
/* Adds a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_occluders_retain(const hrbfnpr_occluders* occluders);
/* Releases a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_occluders_release(const hrbfnpr_occluders* occluders);

/* Flags of hrbfnpr_shading_desc. */
enum {
    HRBFNPR_SHADING_WITH_LINES = 1 /* lines of the kinds SHADOW and TERMINATOR are found, for items with a line_set */
};

/* How a shading is computed. */
typedef struct hrbfnpr_shading_desc {
    uint32_t struct_size;
    int32_t sky_rays;       /* number of rays by which a mark sees the sky; 1 .. 4096; default 64; larger: less noise */
    int32_t shadow_rays;    /* number of rays by which a mark in a penumbra sees a light; 1 .. 4096; default 32 */
    uint32_t flags;         /* HRBFNPR_SHADING_...; default 0 */
    double occlusion_reach; /* distance beyond which nothing hides the sky, in diagonals of the box of all occluders;
                               0 .. 100; default 0.35; 0 = the whole sky is seen everywhere.  What is nearer hides the
                               more, the nearer it is: 1 - distance / reach */
    const hrbfnpr_shading* previous; /* a shading of the same item and the same occluders, but for other lights, whose
                                        occlusion is taken; default NULL = occlusion is computed.  sky_rays and
                                        occlusion_reach then have no effect.  Curvature is taken, too, if it has any */
    double curvature_scale; /* distance over which curvature is measured, in diagonals of the box around the item's
                               surface; 0 .. 1; default 0.02; 0 = it is not measured.  It is measured if the item's
                               style has a curvature_contrast, over at least about a cell of the item's line set */
} hrbfnpr_shading_desc;

/* Sets every field to its default. */
HRBFNPR_API hrbfnpr_status hrbfnpr_shading_desc_init(hrbfnpr_shading_desc* desc, uint32_t struct_size);

/* Computes how much of the sky [Zhukov, Iones & Kronin 1998] and of each light with a shadow the marks of an item see.
 * The result holds for the item's point set, its transform, the lights of its style, and the occluders.  It stays valid
 * while these stay, for any camera, except that lights in camera space move with the camera.
 *
 * With HRBFNPR_SHADING_WITH_LINES it also finds the borders of shadows on the item, as exact curves: outlines that a
 * light sees of the occluders, carried along its rays to the first surface.  Borders inside another shadow, and those
 * shorter than 0.01 diagonals of all occluders, are left out.  Soft lights have the borders of their middle.  An item
 * shows the lines if its style has line styles of the kinds SHADOW and TERMINATOR.
 *
 * occluders:   the surfaces, in world space
 * item:        point_set, style and transform are read, and line_set with HRBFNPR_SHADING_WITH_LINES or if the style
 *              has a curvature_contrast.  It need not be one of the occluders; then it casts no shadow itself
 * camera:      the camera of lights in camera space that cast shadows; may be NULL without such lights
 * desc:        NULL = all defaults
 *
 * operation:   may be NULL
 *
 * Errors: INVALID_ARGUMENT (for example WITH_LINES without a line_set). */
HRBFNPR_API hrbfnpr_status hrbfnpr_shading_create(hrbfnpr_context* context, const hrbfnpr_occluders* occluders,
                                                  const hrbfnpr_item* item, const hrbfnpr_camera* camera,
                                                  const hrbfnpr_shading_desc* desc, hrbfnpr_operation* operation,
                                                  hrbfnpr_shading** out_shading, hrbfnpr_error* error);
/* Gets what the marks of a layer see, without a copy: FLOAT32, n x 1, in the order of the marks.  1 = all, 0 = nothing.
 * `light` is the number of a light of the style, from 0, that casts shadows; -1 = the openness, the share of the sky.
 * The view is valid as long as the shading.
 *
 * Errors: INVALID_ARGUMENT (there is no such layer; the light casts no shadow; the occlusion was not computed). */
HRBFNPR_API hrbfnpr_status hrbfnpr_shading_view(const hrbfnpr_shading* shading, int64_t layer, int64_t light,
                                                hrbfnpr_array* out_view, hrbfnpr_error* error);
/* Adds a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_shading_retain(const hrbfnpr_shading* shading);
/* Releases a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_shading_release(const hrbfnpr_shading* shading);

/* Draws a list of items for one camera: it classifies, shades and orders their marks, and traces their lines.
 * item_stride is the number of bytes from one item to the next; 0 = struct_size.  All styles must have the same paper
 * and visibility.  All items together have at most 2147483647 marks.
 *
 * Where the camera moved little, contours begin with those of the renderer's last drawing, and are proven complete
 * again.  So a picture of lines depends on the drawings before it: in its last digits, and by the wobble of its lines.
 *
 * Errors: INVALID_ARGUMENT (an item, a style or the camera; lines that need curvatures from a line set without
 * WITH_CURVATURE), OUT_OF_MEMORY, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_renderer_draw(hrbfnpr_renderer* renderer, const hrbfnpr_item* items,
                                                 int64_t item_count, int64_t item_stride,
                                                 const hrbfnpr_camera* camera, hrbfnpr_drawing** out_drawing,
                                                 hrbfnpr_error* error);

/* Draws like hrbfnpr_renderer_draw, with an operation (NULL = none).  Use it for frames that take long: lines of a fine
 * surface, millions of marks, rays of an item's model, tone callbacks.  After a cancel there is no drawing.  The
 * renderer then goes on as if the call had not been made, except that contours are not continued from the last drawing.
 * Errors: those of hrbfnpr_renderer_draw, and CANCELLED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_renderer_draw_with_operation(hrbfnpr_renderer* renderer, const hrbfnpr_item* items,
                                                                int64_t item_count, int64_t item_stride,
                                                                const hrbfnpr_camera* camera,
                                                                hrbfnpr_operation* operation,
                                                                hrbfnpr_drawing** out_drawing, hrbfnpr_error* error);

/* Places the marks of a still picture: like hrbfnpr_point_set_generate, but BLUE_NOISE leaves out marks that a drawing
 * of `item` by `camera` does not need.  These are marks outside the picture, on a side that is not drawn, and in tones
 * that are too light for them.  The other marks keep their density, ranks and tones; a few lie elsewhere.  Marks of a
 * layer with a range of tones, of PUBLISHED, and of a style with VISIBILITY_PUBLISHED are all placed.
 *
 * item:        style, sides and transform of the drawing.  Its point_set may be NULL, and is not read
 * desc:        NULL = all defaults
 * operation:   may be NULL
 *
 * Another camera, transform or style would show gaps, so drawing with them fails.  Styles may differ in inks, lines and
 * paper.  The set cannot be saved.
 * Errors: those of hrbfnpr_point_set_generate; INVALID_ARGUMENT (the item, its style or the camera). */
HRBFNPR_API hrbfnpr_status hrbfnpr_point_set_generate_still(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                            const hrbfnpr_generate_desc* desc,
                                                            const hrbfnpr_item* item, const hrbfnpr_camera* camera,
                                                            hrbfnpr_operation* operation,
                                                            hrbfnpr_point_set** out_point_set, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 12  DRAWING: a picture as a value; immutable
 * ==========================================================================
 *
 * A drawing holds dots and strokes in window coordinates.  They are in layers of one ink and one class each.  The id of
 * a mark is 1 + its number, counted over items and their layers in order.  All functions that read a drawing may run on
 * several threads at the same time.  The context keeps the memory that they need, for the next call.
 */

/* Adds a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_drawing_retain(const hrbfnpr_drawing* drawing);
/* Releases a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_drawing_release(const hrbfnpr_drawing* drawing);

/* How a mark faces the camera [NPAR 6]. */
enum {
    HRBFNPR_CLASS_NONE = 0,      /* no mark, or a mark that is not drawn */
    HRBFNPR_CLASS_FRONT = 1,     /* a mark whose normal points towards the eye */
    HRBFNPR_CLASS_BACK = 2,      /* a mark whose normal points away from the eye */
    HRBFNPR_CLASS_SILHOUETTE = 3 /* a mark near a contour, with VISIBILITY_PUBLISHED */
};

/* What a drawing holds, and what making it did.  The counts of marks are over the layers that the styles use, in all
 * items: marks = outside + front + back + silhouette + culled. */
typedef struct hrbfnpr_drawing_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t items;         /* items that were drawn */
    int64_t layers;        /* layers of the drawing, for hrbfnpr_drawing_get_layer_info */
    int64_t dots;          /* dots of ink */
    int64_t strokes;       /* strokes of marks and of lines */
    int64_t stroke_points; /* points of all strokes */
    int64_t marks;       /* marks of the layers that the styles use, in all items */
    int64_t outside;     /* marks outside the view frustum */
    int64_t front;       /* marks of class front inside the frustum */
    int64_t back;        /* marks of class back inside the frustum */
    int64_t silhouette;  /* marks of class silhouette inside the frustum; PUBLISHED only */
    int64_t culled;        /* marks without a class, because no tone could show them and they were skipped; DEPTH_LAYERS
                              only */
    int64_t shown;         /* marks drawn as ink */
    int64_t dropped_tone;  /* front marks not shown because of light or share */
    int64_t dropped_depth; /* front and silhouette marks not shown because of their distance */
    int64_t dropped_zoom;  /* front marks not shown because of the zoom */
    int64_t dropped_hidden; /* marks not drawn because the surface in front of them lets nothing of them through */
    int64_t splats;        /* with PUBLISHED, discs of paper; with DEPTH_LAYERS, marks from which depth layers were
                              found */
    int64_t nanoseconds_classify;   /* time for transforms, classes and tones */
    int64_t nanoseconds_visibility; /* time for finding what hides marks */
    int64_t nanoseconds_sort;       /* time for ordering ink */
    int64_t bytes;         /* memory that the drawing keeps */
    int64_t scratch_bytes; /* memory that its renderer keeps, without drawings */
    int64_t line_curves;         /* curves that lines were drawn from */
    int64_t line_cusps;          /* cusps of these curves */
    int64_t line_crossings;      /* crossings of their images at which the farther curve changes its visibility */
    int64_t line_broken;         /* curves that end inside the surface, and places where a curve was missed */
    int64_t line_settled;        /* curves whose visibility did not add up.  A ray decided for each of their parts */
    int64_t line_contradictions; /* curves among these with a part whose ray was not certain */
    int64_t nanoseconds_lines;   /* time for lines */
    int64_t line_refined; /* curves whose visibility did not add up at first.  They, and those that cross them, were
                             refined */
    int64_t line_tangles; /* cells of the image, four pixels wide or more, with so many crossings that none was used.
                             Lines run to and fro over each other there, as on a flat face seen edge-on */
    int64_t line_pieces;    /* visible and hidden parts of lines that rays were compared with (`verify_lines`) */
    int64_t line_agreeing;  /* parts whose decided rays all agree with the drawing */
    int64_t line_undecided; /* parts without a decided ray: they are within 0.4 pixels of an edge, in the image or in
                               depth */
    int64_t line_repaired;  /* parts that were divided, or drawn otherwise than counted, because rays disagreed */
} hrbfnpr_drawing_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_info_init(hrbfnpr_drawing_info* info, uint32_t struct_size);
/* Gets what a drawing holds, and what making it did. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_get_info(const hrbfnpr_drawing* drawing, hrbfnpr_drawing_info* info,
                                                    hrbfnpr_error* error);

/* A layer of a drawing: the ink of one layer of marks, for front marks or (with PUBLISHED) for contours; or the ink of
 * lines. */
typedef struct hrbfnpr_drawing_layer_info {
    uint32_t struct_size;
    uint32_t mark_class; /* class of its marks: HRBFNPR_CLASS_FRONT or SILHOUETTE */
    int64_t item;        /* number of the item */
    int64_t layer;       /* number of the layer in the item's point set; -1 = lines */
    uint32_t kind;       /* kind of that layer, HRBFNPR_LAYER_KIND_...; for lines HRBFNPR_LINE_KIND_... */
    uint32_t shape;      /* shape of the ink, HRBFNPR_SHAPE_... */
    char name[64];       /* name of that layer; for lines that of their style, or empty */
    float ink[4];        /* colour of the ink, straight RGBA */
    int64_t dots;        /* dots of the layer */
    int64_t strokes;     /* strokes of the layer */
    int32_t ink_number;  /* number of the ink in the style's palette; -1 = the layer's own ink.  Each ink that marks of
                            a layer take is a layer of the drawing of its own */
    uint32_t reserved;
} hrbfnpr_drawing_layer_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_layer_info_init(hrbfnpr_drawing_layer_info* info, uint32_t struct_size);
/* Gets what a layer of a drawing holds.  `number` is 0 .. hrbfnpr_drawing_info.layers - 1.
 * Errors: INVALID_ARGUMENT (no such layer). */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_get_layer_info(const hrbfnpr_drawing* drawing, int64_t number,
                                                          hrbfnpr_drawing_layer_info* info, hrbfnpr_error* error);

/* ---- As an image ---------------------------------------------------------- */

/* Options of rasterizing. */
enum {
    HRBFNPR_RASTER_OVER = 1, /* lays the drawing over the image instead of replacing the image inside the viewport.  Use
                                it with transparent paper */
    HRBFNPR_RASTER_LINEAR_LIGHT = 2 /* blends in linear light (sRGB decoded) instead of in encoded values */
};

/* Optional inputs and outputs of rasterizing.  Each array has width * height elements of one component, row by row from
 * the top-left pixel of the image.  An array with data NULL and count 0 is not wanted. */
typedef struct hrbfnpr_raster_desc {
    uint32_t struct_size;
    uint32_t flags;           /* HRBFNPR_RASTER_...; default 0 */
    hrbfnpr_array host_depth; /* depth of the host's scene, FLOAT32 in the camera's depth convention; ink behind it is
                                 not drawn */
    hrbfnpr_array_out depth;  /* gets the depth of the nearest surface, FLOAT32 in the camera's depth convention; the
                                 far plane where there is no surface */
    hrbfnpr_array_out id;     /* gets the id of the nearest drawn mark, UINT32; 0 = none */
    hrbfnpr_array_out mark_class; /* gets the class of that mark, HRBFNPR_CLASS_...; UINT8 or UINT32 */
} hrbfnpr_raster_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_raster_desc_init(hrbfnpr_raster_desc* desc, uint32_t struct_size);

/* Draws into an image.  It fills the viewport, clipped to the image, with paper and ink, and leaves other pixels as
 * they are.  `desc` may be NULL for the defaults.
 * Errors: INVALID_ARGUMENT (a field of the image or of `desc`), OUT_OF_MEMORY. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_image* image,
                                                     const hrbfnpr_raster_desc* desc, hrbfnpr_error* error);

/* ---- As vertices ---------------------------------------------------------- */

/* What vertices are written for. */
enum {
    HRBFNPR_PRIMITIVE_POINTS = 1,         /* dots, with one vertex each */
    HRBFNPR_PRIMITIVE_LINE_STRIPS = 2,    /* strokes, with one vertex for each of their points */
    HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS = 3 /* strokes, with two vertices for each point, on its left and right side */
};

/* The index that ends a strip: 0xFFFFFFFF as UINT32. */
enum { HRBFNPR_INDEX_RESTART = -1 };

/* What a vertex can carry, and the types it can have. */
enum {
    HRBFNPR_VERTEX_ATTRIBUTE_POSITION = 0,  /* world position; FLOAT32 x 3.  For marks and their line strips it is the
                                               place of the mark.  For lines, hatching and triangles it is the drawn
                                               place, as exact as the window depth */
    HRBFNPR_VERTEX_ATTRIBUTE_WINDOW = 1,    /* pixel x, pixel y and depth; FLOAT32 x 3 */
    HRBFNPR_VERTEX_ATTRIBUTE_RADIUS = 2,    /* radius of a dot or half the width of a stroke, in pixels; FLOAT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_COLOR = 3,     /* colour, straight RGBA; FLOAT32 x 4 or UINT8 x 4 */
    HRBFNPR_VERTEX_ATTRIBUTE_NORMAL = 4,    /* unit normal in the world, 0 for lines; FLOAT32 x 3 */
    HRBFNPR_VERTEX_ATTRIBUTE_DIRECTION = 5, /* unit direction in the world, 0 for lines; FLOAT32 x 3 */
    HRBFNPR_VERTEX_ATTRIBUTE_ID = 6,        /* id of the mark, 0 for lines; UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_CLASS = 7,     /* class of the mark, HRBFNPR_CLASS_...; UINT8 or UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER = 8,  /* 1 = a disc of paper, 0 = ink; UINT8 or UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_LAYER = 9,     /* number of the layer in the drawing; UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_LENGTH = 10,   /* length along the stroke from its first point, in pixels, 0 for a dot;
                                               FLOAT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_LAYERS = 11, /* number of layers of surface in front of this part of a line, 0 if it
                                                    is visible or a mark; UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_BY = 12, /* number of the item whose surface is nearest in front of this part of a
                                                line, HRBFNPR_INDEX_RESTART if it is visible or a mark; UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_LINE = 13      /* number of the line, 0 for all else; UINT32.  A line keeps it from one
                                               drawing of a renderer to the next where the camera moves little */
};

/* One attribute of a vertex. */
typedef struct hrbfnpr_vertex_attribute {
    uint32_t struct_size;
    uint32_t attribute; /* what it holds, HRBFNPR_VERTEX_ATTRIBUTE_...; default POSITION */
    uint32_t scalar;    /* type of its numbers, HRBFNPR_SCALAR_...; default FLOAT32 */
    uint32_t offset;    /* bytes from the start of the vertex; default 0 */
} hrbfnpr_vertex_attribute;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_vertex_attribute_init(hrbfnpr_vertex_attribute* attribute, uint32_t struct_size);

/* What vertices are written for, and what each holds. */
typedef struct hrbfnpr_vertex_layout {
    uint32_t struct_size;
    uint32_t primitive;       /* what vertices are written for, HRBFNPR_PRIMITIVE_...; default POINTS */
    const hrbfnpr_vertex_attribute* attributes; /* a list of 1 to 64 attributes */
    int64_t attribute_count;  /* number of `attributes` */
    int64_t attribute_stride; /* bytes from one element of `attributes` to the next; default 0 = struct_size */
    int64_t stride;           /* bytes from one vertex to the next; default 0 = up to the end of the last attribute */
} hrbfnpr_vertex_layout;

/* Sets struct_size, POINTS and no attributes. */
HRBFNPR_API hrbfnpr_status hrbfnpr_vertex_layout_init(hrbfnpr_vertex_layout* layout, uint32_t struct_size);

/* Gets the numbers of vertices and indices that hrbfnpr_drawing_write_vertices writes for a primitive
 * (HRBFNPR_PRIMITIVE_...).  `vertices` and `indices` may be NULL.
 * Errors: INVALID_ARGUMENT (no such primitive). */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_vertex_bound(const hrbfnpr_drawing* drawing, uint32_t primitive,
                                                        int64_t* vertices, int64_t* indices, hrbfnpr_error* error);

/* Writes the vertices of a drawing's dots or strokes, from far to near.
 *
 * POINTS: discs of paper and of ink.  A host gets the dots of hrbfnpr_drawing_rasterize if it paints them in this
 * order, as round anti-aliased points with "source over" blending; only host_depth has no effect.  A dot with a radius
 * r below half a pixel is written with half a pixel, and its alpha times (2 r)^2.  With transparent paper the discs of
 * paper must erase: destination times (1 - alpha).
 *
 * Strips: `indices` (UINT32, may be NULL) gets the vertices of one stroke after the other, each stroke ended by
 * HRBFNPR_INDEX_RESTART.  A triangle strip has two vertices for each point, on its left and right, and two at the tip
 * of a pointed end.  Round ends are cut off flat.  For POINTS `indices` gets 0, 1, 2 and so on.
 *
 * Capacities are numbers of vertices and of indices. *vertex_count and *index_count (may be NULL) get the numbers that
 * were written, or that are needed with BUFFER_TOO_SMALL.
 * Errors: INVALID_ARGUMENT (a field of the layout; a negative capacity), BUFFER_TOO_SMALL (a capacity is too small;
 * nothing is written), OUT_OF_MEMORY. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_write_vertices(const hrbfnpr_drawing* drawing,
                                                          const hrbfnpr_vertex_layout* layout, void* vertices,
                                                          int64_t vertex_capacity, int64_t* vertex_count,
                                                          uint32_t* indices, int64_t index_capacity,
                                                          int64_t* index_count, hrbfnpr_error* error);

/* ---- As numbers for the marks of a set ------------------------------------- */

/* How each mark of a layer is drawn, in the set's own order.  A host keeps the set's arrays on the graphics card and
 * uploads only these.  Each array of the caller's has as many elements as the layer has marks, or is not given. */
typedef struct hrbfnpr_mark_results {
    uint32_t struct_size;
    uint32_t reserved;
    hrbfnpr_array_out shown;   /* gets the class as which the mark is drawn, HRBFNPR_CLASS_FRONT or SILHOUETTE, or NONE
                                  if it is not drawn; n x 1, UINT8 */
    hrbfnpr_array_out radius;  /* gets the radius of the mark in pixels, 0 if it is not drawn; n x 1, FLOAT32 */
    hrbfnpr_array_out opacity; /* gets the ink's alpha times the transmittance of what lies in front, 0 if the mark is
                                  not drawn; n x 1, FLOAT32 */
} hrbfnpr_mark_results;

/* Sets struct_size; no array is given. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mark_results_init(hrbfnpr_mark_results* results, uint32_t struct_size);
/* Gets how each mark of one layer of one item's point set is drawn.  The layer need not be drawn.
 * Errors: INVALID_ARGUMENT (no such item or layer; an array of another size or type). */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_mark_results(const hrbfnpr_drawing* drawing, int64_t item,
                                                        int64_t layer, hrbfnpr_mark_results* results,
                                                        hrbfnpr_error* error);

/* Writes which marks of a layer are drawn as one class: the numbers of these marks, UINT32.  `mark_class` is
 * HRBFNPR_CLASS_FRONT or SILHOUETTE.  With POINTS they are the marks that are shown, from far to near.  With
 * LINE_STRIPS they are runs of shown marks along strokes, each ended by HRBFNPR_INDEX_RESTART.  With TRIANGLE_STRIPS
 * they are the same runs, with 2 * number and 2 * number + 1 for each mark.
 *
 * *count (not NULL) gets the number of indices written, or needed with BUFFER_TOO_SMALL.  `indices` may be NULL if
 * capacity is 0.
 * Errors: INVALID_ARGUMENT (no such item, layer, class or primitive), BUFFER_TOO_SMALL (nothing is written),
 * OUT_OF_MEMORY. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_write_mark_indices(const hrbfnpr_drawing* drawing, int64_t item,
                                                              int64_t layer, uint32_t mark_class,
                                                              uint32_t primitive, uint32_t* indices,
                                                              int64_t capacity, int64_t* count,
                                                              hrbfnpr_error* error);

/* ---- Picking --------------------------------------------------------------- */

/* The mark that an id belongs to. */
typedef struct hrbfnpr_mark_identity {
    uint32_t struct_size;
    uint32_t id;    /* the id itself */
    int64_t item;   /* number of the item */
    int64_t layer;  /* number of the layer in the item's point set */
    int64_t mark;   /* number of the mark in the layer */
    int64_t stroke; /* number of its stroke in the layer; -1 = it is in no stroke */
    int64_t place;  /* its place along the stroke, from 0 */
} hrbfnpr_mark_identity;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mark_identity_init(hrbfnpr_mark_identity* identity, uint32_t struct_size);
/* Finds the mark that has an id.
 * Errors: INVALID_ARGUMENT (no mark has the id). */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_identify(const hrbfnpr_drawing* drawing, uint32_t id,
                                                    hrbfnpr_mark_identity* identity, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 13  MESH: triangles, repaired; samples, fits and comparisons
 * ==========================================================================
 *
 * A mesh is immutable.  Making one repairs what can be repaired, and counts the repairs: vertices at exactly the same
 * place are joined; triangles without area and repeated triangles are left out; unused vertices are dropped; the faces
 * of each component are turned to agree; and a closed component that is inside out is turned as a whole.
 */

/* Which components of a mesh are kept.  Faces that share vertices belong to one component.
 * With ALL and SOLIDS, a closed component inside an odd number of closed ones is the wall of a cavity, and its faces
 * are turned into the cavity.  One inside an even number is a solid. */
enum {
    HRBFNPR_PARTS_OUTER = 0,   /* keeps all components except those inside a closed one, such as eyes in a head or
                                  inner shells */
    HRBFNPR_PARTS_ALL = 1,     /* keeps all components */
    HRBFNPR_PARTS_LARGEST = 2, /* keeps the component of the largest area */
    HRBFNPR_PARTS_SOLIDS = 3,  /* keeps all components except open ones inside a closed one */
    HRBFNPR_PARTS_AUTO = 4     /* in a picture SOLIDS if hidden parts of lines or a section are drawn, or with
                                  SURFACE_ONLY; else OUTER */
};

/* Whether the order of a face's corners may change. */
enum {
    HRBFNPR_FACES_TURN = 0, /* faces are turned to agree with their component, and closed components to face outward */
    HRBFNPR_FACES_KEEP = 1  /* faces stay as they are */
};

/* A mesh as it is given: triangles.  The caller cuts quadrilaterals and polygons into triangles. */
typedef struct hrbfnpr_mesh_desc {
    uint32_t struct_size;
    uint32_t parts;          /* components that are kept, HRBFNPR_PARTS_...; default OUTER */
    hrbfnpr_array vertices;  /* positions; n x 3, FLOAT32 or FLOAT64, n < 2^31 - 1; coordinates up to 1e60 */
    hrbfnpr_array triangles; /* numbers of vertices from 0, counter-clockwise as seen from outside; m x 3, INT32, INT64
                                or UINT32, m < 2^29 */
    double crease_angle;     /* angle between the normals of two faces, in degrees, above which they do not share corner
                                normals; 0 .. 180; default 60 */
    uint32_t faces;          /* whether faces are turned, HRBFNPR_FACES_...; default TURN */
    uint32_t reserved;
} hrbfnpr_mesh_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_desc_init(hrbfnpr_mesh_desc* desc, uint32_t struct_size);

/* Makes a mesh from triangles, and repairs it.  `operation` may be NULL.
 * Errors: INVALID_ARGUMENT (a corner that is not the number of a vertex, or whose vertex is not finite: the message
 * names the face and the index; coordinates beyond 1e60; a mesh less than 1e-60 across; a mesh that has no face left),
 * OUT_OF_MEMORY, CANCELLED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_create(hrbfnpr_context* context, const hrbfnpr_mesh_desc* desc,
                                               hrbfnpr_operation* operation, hrbfnpr_mesh** out_mesh,
                                               hrbfnpr_error* error);
/* Adds a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_mesh_retain(const hrbfnpr_mesh* mesh);
/* Releases a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_mesh_release(const hrbfnpr_mesh* mesh);

/* What making a mesh found, and did.  Facts such as the numbers of vertices, faces and edges are those of the mesh that
 * is kept; numbers of repairs are those of the mesh that was given.  An edge is at the boundary if it has one face, and
 * not manifold if it has more than two. */
typedef struct hrbfnpr_mesh_info {
    uint32_t struct_size;
    uint32_t closed;              /* 1: no edge is at the boundary or not manifold, and all faces agree */
    int64_t given_vertices;       /* vertices that were given */
    int64_t given_faces;          /* faces that were given */
    int64_t vertices;             /* vertices that are kept.  They are more than were given where solids that touch in
                                     an edge are parted, at most three for each face */
    int64_t faces;                /* faces that are kept */
    int64_t welded_vertices;      /* vertices at the place of another, joined with it; on borders also those within 1e-6
                                     diagonals of another */
    int64_t degenerate_faces;     /* faces left out because they have no area beyond the rounding of single precision.
                                     The face across the largest side is cut in two at the corner on it, so that no slit
                                     stays */
    int64_t repeated_faces;       /* faces left out because another has the same corners; both where two solids share a
                                     wall */
    int64_t turned_faces;         /* faces turned to agree with those beside them */
    int64_t components;           /* components of the given faces */
    int64_t turned_components;    /* closed components turned because they were inside out */
    int64_t nested_components;    /* components inside a closed one */
    int64_t left_out_components;  /* components left out, by `parts` */
    int64_t left_out_faces;       /* faces of the components left out */
    int64_t boundary_edges;       /* edges with one face */
    int64_t boundary_loops;       /* loops that these edges form */
    int64_t nonmanifold_edges;    /* edges with more than two faces */
    int64_t contrary_edges;       /* edges whose two faces do not agree, because the mesh cannot be oriented or was not
                                     to be */
    int64_t euler_characteristic; /* vertices - edges + faces */
    int64_t genus;                /* number of handles of all components; -1 if the mesh is not closed */
    double area;                  /* area, in squared units of the mesh */
    double volume;                /* enclosed volume, in cubed units of the mesh; NaN if the mesh is not closed */
    double bounds_min[3];         /* least coordinates of the vertices */
    double bounds_max[3];         /* greatest coordinates of the vertices */
    double seconds;               /* time that making it took */
    int64_t bytes;                /* memory that the mesh keeps */
    double crease_length;         /* length of the edges that bend by more than 30 degrees, in diagonals of the
                                     bounds */
    uint32_t creases;             /* 1: the mesh has edges that stand out, as those of machine parts do.
                                     hrbfnpr_model_fit_mesh keeps them sharp with edges AUTO and the default
                                     crease_angle */
    uint32_t cavities;            /* components that are kept and are walls of cavities */
} hrbfnpr_mesh_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_info_init(hrbfnpr_mesh_info* info, uint32_t struct_size);
/* Gets what making a mesh found, and did. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_get_info(const hrbfnpr_mesh* mesh, hrbfnpr_mesh_info* info,
                                                 hrbfnpr_error* error);

/* Arrays of a mesh. */
enum {
    HRBFNPR_MESH_ATTRIBUTE_VERTEX = 0,       /* positions of the vertices; FLOAT64 x 3 */
    HRBFNPR_MESH_ATTRIBUTE_TRIANGLE = 1,     /* numbers of the vertices of each face; INT32 x 3 */
    HRBFNPR_MESH_ATTRIBUTE_COMPONENT = 2,    /* number of the component of each face, from 0; INT32 x 1 */
    HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE = 3,   /* number of each face among the given ones; INT32 x 1 */
    HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL = 4 /* unit normals of the three corners of each face; FLOAT64 x 9 */
};

/* Gets a view of an array of the mesh, HRBFNPR_MESH_ATTRIBUTE_..., without a copy.  It is valid while the mesh lives.
 * Errors: INVALID_ARGUMENT (no such attribute). */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_view(const hrbfnpr_mesh* mesh, uint32_t attribute,
                                             hrbfnpr_array* out_view, hrbfnpr_error* error);

/* How a mesh is sampled. */
typedef struct hrbfnpr_sample_desc {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t candidates;   /* random places to choose from, 0 .. 1000000; default 0 = 40 for each sample, up to 1000000.
                             More: more even samples, in more time.  There are never fewer than samples; with as many,
                             the samples are all of them in random order */
    uint64_t random_seed; /* seed of the places, any number; default 1 */
} hrbfnpr_sample_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_sample_desc_init(hrbfnpr_sample_desc* desc, uint32_t struct_size);

/* Samples a mesh evenly, with as many samples as `points` has elements, 1 .. 10000000.  Each sample is the candidate
 * farthest from those before, so that every prefix is even.  `points` and `normals` are n x 3, FLOAT32 or FLOAT64.
 * `normals` may be NULL.  They are unit, and interpolated between the normals of the corners.  A corner's normal takes
 * in the faces around its vertex within the crease angle, weighted by their angles there.  `desc` and `operation` may
 * be NULL.
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_sample(const hrbfnpr_mesh* mesh, const hrbfnpr_sample_desc* desc,
                                               const hrbfnpr_array_out* points, const hrbfnpr_array_out* normals,
                                               hrbfnpr_operation* operation, hrbfnpr_error* error);

/* Which edges of a mesh are sharp. */
enum {
    HRBFNPR_EDGES_AUTO = 0,   /* edges are sharp if they stand out from the faces beside them, as those of machine parts
                                 do.  Noise and coarse faces of round shapes do not stand out.  Closed parts that cross
                                 are fitted separately, and meet in creases */
    HRBFNPR_EDGES_SMOOTH = 1, /* no edge is sharp: a fit is one smooth surface, which rounds all edges */
    HRBFNPR_EDGES_SHARP = 2   /* all edges are sharp whose faces meet at more than crease_angle */
};

/* How sharp edges are found. */
typedef struct hrbfnpr_mesh_edges_desc {
    uint32_t struct_size;
    uint32_t edges;      /* which edges are sharp, HRBFNPR_EDGES_...; default AUTO */
    double crease_angle; /* angle between the normals of two faces, in degrees, above which their edge is sharp;
                            1 .. 179; default 30 */
    double far;          /* distance, in units of the mesh, that decides about coarse faces; 0 or more; default 0 = 0.01
                            diagonals.  Faces stay flat, with sharp edges, if a round surface would leave them by more
                            than four fifths of it.  With a large number, such as the diagonal, the angle alone
                            decides */
    uint32_t tangent;    /* 1 also finds tangent edges, along which two surfaces of a part touch without a kink but bend
                            differently, such as a fillet and a plane; default 0.  They are found where the bends of the
                            mesh agree with two different curvatures.  Scans, noise and subdivided shapes have none */
    uint32_t reserved;
} hrbfnpr_mesh_edges_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_edges_desc_init(hrbfnpr_mesh_edges_desc* desc, uint32_t struct_size);

/* The sharp edges of a mesh as a whole.  Lengths are in units of the mesh. */
typedef struct hrbfnpr_mesh_edges_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t edges;     /* number of sharp edges */
    int64_t patches;   /* number of smooth patches between them; 1 if no edge is sharp */
    double length;     /* length of the sharp edges */
    double fading;     /* length of those sharp edges that have the same patch on both sides, as where a crease fades
                          out */
    double doubtful;   /* with AUTO, length of edges that bend more than crease_angle but do not stand out; 0 if the
                          mesh has sharp edges */
    double seconds;    /* time that the search took */
} hrbfnpr_mesh_edges_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_edges_info_init(hrbfnpr_mesh_edges_info* info, uint32_t struct_size);

/* Finds the sharp edges of a mesh and the smooth patches between them, as hrbfnpr_model_fit_mesh does with the same
 * edges, crease_angle and far.  A sharp edge that ends within a patch goes on along edges that keep its direction and
 * bend by 8 degrees or more.  Short sharp edges that separate nothing are dropped as noise.  Edges with one face, or
 * with more than two, end patches but are not sharp.
 *
 * `patch` is m x 1 for the m faces of the mesh, INT64, INT32 or UINT32: it gets the number of each face's patch, from 0
 * in the order of their first faces.  `sharp` is m x 3, of the same types: it gets 1 if the edge from corner k of the
 * face to the next corner is sharp, 2 if it is a tangent edge, else 0.  `patch`, `sharp`, `desc`, `info` and
 * `operation` may be NULL.  The call only reads the mesh, so several threads may make it at the same time.
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_edges(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_edges_desc* desc,
                                              const hrbfnpr_array_out* patch, const hrbfnpr_array_out* sharp,
                                              hrbfnpr_mesh_edges_info* info, hrbfnpr_operation* operation,
                                              hrbfnpr_error* error);

/* Orders points so that each is the farthest from those before it (farthest-point order), so that every prefix is an
 * even choice [Gonzalez 1985].  The first is the point nearest to the middle of the bounding box.  If two points are
 * equally far, the one with the lower number comes first.
 *
 * `points` is n x 3, FLOAT32 or FLOAT64, finite, up to 1e100.  `indices` is k x 1, INT64, INT32 or UINT32, 1 <= k <= n:
 * it gets the numbers of the points.  `distance` is k x 1, FLOAT32 or FLOAT64, or NULL: it gets the distance of each
 * from those before; infinite for the first.  `operation` may be NULL.
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_farthest_points(hrbfnpr_context* context, const hrbfnpr_array* points,
                                                   const hrbfnpr_array_out* indices,
                                                   const hrbfnpr_array_out* distance,
                                                   hrbfnpr_operation* operation, hrbfnpr_error* error);

/* How a surface is compared with a mesh.  The surface is that of the model within the box of the mesh, grown by 0.05
 * diagonals.  Diagonals are those of the mesh.  Parts of the surface whose nearest place on the mesh is on its border
 * lie beyond the mesh, and are left out.  Where closed components overlap, what lies inside another is no part of the
 * mesh. */
typedef struct hrbfnpr_compare_desc {
    uint32_t struct_size;
    uint32_t reserved;
    double tolerance;     /* distance within which shares are counted, in units of the mesh; 0 or more; default 0 =
                             0.002 diagonals */
    double far;           /* distance, in units of the mesh, beyond which surface is invented and mesh is missed; 0 or
                             more; default 0 = 0.01 diagonals */
    double support;       /* limit of the support of the model's samples, beyond which surface is left out, as in
                             hrbfnpr_line_set_desc; 0 or more; default 0 = nothing is left out.  A custom model has no
                             samples: give 0 */
    int64_t points;       /* places to measure at, on the surface and on the mesh each, 100 .. 10000000; default 0 =
                             20000 */
    double cell_size;     /* side of the cells in which the surface is searched, in units of the mesh, at least 0.001
                             diagonals; default 0 = 1/128 diagonal, and finer where the surface is thin.  What is
                             thinner or smaller may be missed */
    uint64_t random_seed; /* seed of the places, any number; default 1 */
} hrbfnpr_compare_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_compare_desc_init(hrbfnpr_compare_desc* desc, uint32_t struct_size);

/* How near a surface and a mesh are to each other.  Distances are in units of the mesh.  99 % of the distances are not
 * above p99.  Figures without any place to measure at are NaN. */
typedef struct hrbfnpr_comparison {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t surface_points;  /* places on the surface, even over its area */
    double surface_mean;     /* mean of their distances from the mesh */
    double surface_p99;      /* 99th percentile of these distances */
    double surface_max;      /* greatest of these distances */
    double surface_share;    /* share of the surface within the tolerance of the mesh, 0 .. 1 */
    double invented_share;   /* share of the surface farther than `far` from the mesh, 0 .. 1 */
    double left_out_share;   /* share of the surface left out, beyond the mesh's border or by `support`, 0 .. 1; no
                                other figure includes it */
    int64_t mesh_points;     /* places on the mesh, even over its area */
    double mesh_mean;        /* mean of their distances from the surface */
    double mesh_p99;         /* 99th percentile of these distances */
    double mesh_max;         /* greatest of these distances */
    double mesh_share;       /* share of the mesh within the tolerance of the surface, 0 .. 1 */
    double missed_share;     /* share of the mesh farther than `far` from the surface, 0 .. 1 */
    double normal_mean;      /* mean angle between the mesh's normals and those of the surface beside them, in
                                degrees */
    double normal_p99;       /* 99th percentile of these angles, in degrees */
    int64_t components;      /* components of the surface */
    int64_t genus;           /* genus of the surface, summed over its components; -1 if it has a border in the box */
    double tolerance;        /* tolerance as used */
    double diagonal;         /* diagonal of the mesh */
    double seconds;          /* time that the comparison took */
} hrbfnpr_comparison;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_comparison_init(hrbfnpr_comparison* comparison, uint32_t struct_size);

/* Measures how near the surface of any model and a mesh are to each other, both ways.  Both are in the same
 * coordinates.  The search for the surface starts from places on the mesh and from a lattice of 16^3 places in the box.
 * A small part of the surface that is near none of these is missed.  `desc` and `operation` may be NULL.
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_compare_mesh(const hrbfnpr_model* model, const hrbfnpr_mesh* mesh,
                                                      const hrbfnpr_compare_desc* desc,
                                                      hrbfnpr_comparison* comparison,
                                                      hrbfnpr_operation* operation, hrbfnpr_error* error);

/* How a mesh is fitted. */
typedef struct hrbfnpr_mesh_fit_desc {
    uint32_t struct_size;
    uint32_t reserved;
    double tolerance;        /* distance within which surface and mesh shall be of each other, in units of the mesh;
                                1e-6 diagonals or more; default 0 = 0.002 diagonals.  Smaller: more samples and time */
    double share;            /* share of both that must be within the tolerance; above 0, up to 1; default 0.99 */
    double far;              /* distance that no part may exceed, in units of the mesh; not below the tolerance; default
                                0 = five times the tolerance */
    int64_t maximum_centres; /* the most centres of the fit, 16 .. 1000000; default 8000.  A fit with sharp edges may
                                have 32 for each of its sheets, if that is more, as each sheet is solved alone */
    int64_t candidates;      /* places on the mesh to choose samples from, 1000 .. 10000000; default 0 = by its area and
                                its details */
    uint64_t random_seed;    /* seed of the places, any number; default 1 */
    double crease_angle;     /* angle between the normals of two faces, in degrees, above which their edge is sharp;
                                5 .. 175; default 30.  Edges of coarse faces are sharp, too, if rounding would move the
                                surface off the mesh by four fifths of `far` */
    uint32_t edges;          /* which edges are sharp, HRBFNPR_EDGES_...; default AUTO */
    uint32_t reserved2;
} hrbfnpr_mesh_fit_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_fit_desc_init(hrbfnpr_mesh_fit_desc* desc, uint32_t struct_size);

/* The result of a fit to a mesh.  Distances are in units of the mesh.  They come from the fit's last measurement, at
 * places that it did not use before. hrbfnpr_model_compare_mesh measures again, and more. */
typedef struct hrbfnpr_mesh_fit_info {
    uint32_t struct_size;
    uint32_t reached;            /* 1: surface and mesh keep the tolerance, the share and `far`, both ways */
    double tolerance;            /* tolerance as used */
    double far;                  /* `far` as used */
    int64_t candidates;          /* places on the mesh that samples were chosen from */
    int64_t centres;             /* all centres */
    int64_t off_surface_centres; /* centres off the surface, at which f is held to the distance from the mesh.  They are
                                    the last ones */
    int32_t rounds;              /* number of fits */
    uint32_t supported;          /* 1: the mesh has a border, and the surface beyond it was not counted */
    double surface_share;        /* share of the surface within the tolerance of the mesh, 0 .. 1 */
    double surface_p99;          /* 99th percentile of the surface's distances from the mesh */
    double surface_max;          /* greatest distance of the surface from the mesh */
    double mesh_share;           /* share of the mesh within the tolerance of the surface, 0 .. 1 */
    double mesh_p99;             /* 99th percentile of the mesh's distances from the surface */
    double mesh_max;             /* greatest distance of the mesh from the surface */
    double seconds_sample;       /* time for choosing samples */
    double seconds_fit;          /* time for the fits of all rounds */
    double seconds_measure;      /* time for measuring distances */
    double seconds_total;        /* time of the whole call */
    int32_t sheets;              /* smooth sheets that the surface consists of; 1 if it has no sharp edges */
    uint32_t reserved;
    double crease_length;        /* length of the mesh's edges that are sharp, in units of the mesh */
    double smooth_length;        /* length of edges that stay smooth because the mesh could not be cut there, in units
                                    of the mesh */
    int64_t cells;               /* cells of space, in each of which a few sheets make the surface */
    int64_t poor_cells;          /* cells in which no maximum and minimum of sheets follows the mesh everywhere */
    int32_t touching_parts[2];   /* numbers of two parts of the mesh, from 0, that are nearer to each other than the
                                    tolerance, so that the surface may join them; -1, -1 if none were found */
    double touching_place[3];    /* place where these parts are near each other */
    uint32_t parts_may_cross;    /* 1: these parts may go through each other there; 0 if they are near each other
                                    only */
    uint32_t reserved2;
} hrbfnpr_mesh_fit_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_fit_info_init(hrbfnpr_mesh_fit_info* info, uint32_t struct_size);

/* Fits a surface to a mesh, with as many samples as the tolerance takes.  It begins with some hundred even samples.  In
 * rounds it adds samples where surface and mesh are far from each other.  Where the surface goes on far from the mesh,
 * f is held to the signed distance from the mesh at a few places off it.  These places are the last centres of the
 * model.  Their normals point to the mesh or away from it.
 *
 * A fit that ends short of the tolerance is no error: `reached` is 0, and the log warns.  It ends at maximum_centres,
 * or when more centres gain nothing.  A smooth fit rounds edges by some tenths of the samples' spacing there.
 *
 * A mesh with sharp edges, as `edges` says, is cut along them into smooth patches.  Each patch gets its own fit, a
 * sheet.  The surface is a maximum and minimum of sheets, which changes from cell to cell of space [Ohtake et al.
 * 2003].  The points and normals of such a model are places all over the mesh, not its centres.
 * docs/how-fitting-works.md explains how edges are kept.
 *
 * The model is trimmed by places on the mesh if the mesh is open, or if the fit did not reach the tolerance, unless the
 * trim of `fit` is NEVER.
 *
 * `fit` (may be NULL) gives kernel, solver, regularization and trim.  Its points and normals must be empty, and its
 * tolerance and maximum_centres 0.  With a smooth fit, a solver_tolerance of 0 is the tolerance / 200 diagonals, within
 * 1e-8 .. 1e-5.  `desc`, `info` and `operation` may be NULL.  The call needs the stack of hrbfnpr_model_fit.
 * Errors: those of hrbfnpr_model_fit. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_fit_mesh(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_fit_desc* desc,
                                                  const hrbfnpr_fit_desc* fit, hrbfnpr_mesh_fit_info* info,
                                                  hrbfnpr_operation* operation, hrbfnpr_model** out_model,
                                                  hrbfnpr_error* error);

/*
 * ==========================================================================
 * 14  PAGE: drawings as vectors: SVG, PDF, HPGL, G-code, DXF
 * ==========================================================================
 *
 * A page holds drawings, each at its place and scale, and texts and lines beside them.  Its unit is the millimetre,
 * from the top-left corner, y down.  Strokes become cubic Bezier curves within a tolerance of the drawing's lines
 * [Schneider 1990], or arcs of circles where they are such arcs.  For plotters they become arcs and straight lines
 * within that tolerance.
 *
 * Ink is in named groups, the layers of a file.  The group of a layer of marks has that layer's name, such as
 * "stipples" or "hatch-2".  Groups of lines are called "contour", "suggestive", "ridge", "valley", "apparent ridge",
 * "parabolic", "isophote", "section", "border", "crease", "shadow", "terminator", "soft edge", "intersection",
 * "tangent edge", or have the name of lines of kind OWN.  Ink behind n layers of surface has " hidden n" at the end of
 * its name.  A second layer of the same name has " 2".
 *
 * Groups follow the layers of the drawing, hidden ones first.  In a group strokes are in order from far to near.  Where
 * inks of several colours lie on each other, groups begin anew with ", run 2" at the end of their names, up to 32 runs,
 * so that all ink is painted from far to near there.  In plot order there is one run, so that each pen is taken up
 * once.  Names of pens do not include the run.
 *
 * The bytes of a page are the same for every thread count and locale.
 */

/* The format of a file. */
enum {
    HRBFNPR_PAGE_FORMAT_SVG = 0,  /* SVG 1.1, with groups as layers of Inkscape */
    HRBFNPR_PAGE_FORMAT_PDF = 1,  /* PDF 1.5, with groups as optional content, which viewers list as layers */
    HRBFNPR_PAGE_FORMAT_HPGL = 2, /* HPGL for plotters: absolute coordinates, 40 units per mm, y up from the lower left
                                     corner */
    HRBFNPR_PAGE_FORMAT_GCODE = 3, /* G-code for plotters: G0 to G3 in mm, y up from the lower left corner */
    HRBFNPR_PAGE_FORMAT_DXF = 4   /* DXF of AutoCAD 2004 (AC1018) in mm, y up from the lower left corner, with groups as
                                     layers.  There is no paper, and ink is cut off at the edges of drawings.  Strokes
                                     of varying width become polylines with a width at each point, and their outlines
                                     are not written.  Dots become circles or, as LINES, points */
};

/* How strokes are written whose width varies. */
enum {
    HRBFNPR_WIDTHS_OUTLINES = 0, /* filled outlines, in SVG and PDF */
    HRBFNPR_WIDTHS_CLASSES = 1   /* lines of even widths, whose ratios are powers of `width_step` */
};

/* How dots are written. */
enum {
    HRBFNPR_DOT_SHAPE_CIRCLES = 0, /* circles.  Plotters fill them, or with SINGLE_PASS draw their outline */
    HRBFNPR_DOT_SHAPE_LINES = 1,   /* lines of length 0 with round ends, at which a plotter touches the paper */
    HRBFNPR_DOT_SHAPE_SPIRALS = 2  /* spirals with which a pen fills the dot, if the dot is wider than the pen */
};

/* How the curves of lines of one width are written.  HPGL has straight lines only. */
enum {
    HRBFNPR_CURVES_ARCS = 0,    /* arcs of circles where lines consist of them: A in SVG, ARC, CIRCLE and bulges in DXF.
                                   Other curves are as with SPLINES.  GCODE has arcs (G2, G3) and straight lines only,
                                   and PDF has no arcs */
    HRBFNPR_CURVES_SPLINES = 1, /* cubic Bezier curves: SPLINE in DXF, G5 in GCODE */
    HRBFNPR_CURVES_LINES = 2    /* straight lines, for programs and machines that have neither arcs nor splines */
};

/* Options of a page. */
enum {
    HRBFNPR_PAGE_IN_PLOT_ORDER = 1, /* sorts each group so that a pen travels little.  HPGL and GCODE are always sorted.
                                       Lines may be turned round, closed lines may begin elsewhere, and lines whose ends
                                       are nearer than `join` become one */
    HRBFNPR_PAGE_SINGLE_PASS = 4,   /* draws a line that is wider than its pen once, along its centre.  Without this
                                       flag, HPGL, GCODE and pens in plot order fill such a line by several passes, side
                                       by side.  A line up to 1.2 times as wide as its pen takes one pass in any case */
    HRBFNPR_PAGE_WITHOUT_PAPER = 2  /* leaves out the paper.  Without this flag the page has the paper of its first
                                       drawing, or white, and drawings with another paper have theirs.  Plotters never
                                       draw paper */
};

/* Types of lines, by the numbers of ISO 128-2.  Lengths in line widths: a dot is 0.5, dashes of the three kinds are 6,
 * 12 and 24, a gap is 3, a space is 18.  They are stretched a little, so that each line begins and ends with a dash. */
enum {
    HRBFNPR_LINE_TYPE_AS_DRAWN = 0,                       /* lines as the drawing has them */
    HRBFNPR_LINE_TYPE_CONTINUOUS = 1,                     /* a continuous line */
    HRBFNPR_LINE_TYPE_DASHED = 2,                         /* dashes, for hidden edges */
    HRBFNPR_LINE_TYPE_DASHED_SPACED = 3,                  /* dashes with spaces between */
    HRBFNPR_LINE_TYPE_LONG_DASHED_DOTTED = 4,             /* a long dash, then a dot; for axes */
    HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_DOTTED = 5,      /* a long dash, then two dots */
    HRBFNPR_LINE_TYPE_LONG_DASHED_TRIPLE_DOTTED = 6,      /* a long dash, then three dots */
    HRBFNPR_LINE_TYPE_DOTTED = 7,                         /* dots */
    HRBFNPR_LINE_TYPE_LONG_DASHED_SHORT_DASHED = 8,       /* a long dash, then a short dash */
    HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_SHORT_DASHED = 9, /* a long dash, then two short dashes */
    HRBFNPR_LINE_TYPE_DASHED_DOTTED = 10,                 /* a dash, then a dot */
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOTTED = 11,          /* two dashes, then a dot */
    HRBFNPR_LINE_TYPE_DASHED_DOUBLE_DOTTED = 12,          /* a dash, then two dots */
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOUBLE_DOTTED = 13,   /* two dashes, then two dots */
    HRBFNPR_LINE_TYPE_DASHED_TRIPLE_DOTTED = 14,          /* a dash, then three dots */
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_TRIPLE_DOTTED = 15    /* two dashes, then three dots */
};

/* A drawing on a page. */
typedef struct hrbfnpr_page_item {
    uint32_t struct_size;
    uint32_t reserved;              /* must be 0 */
    const hrbfnpr_drawing* drawing; /* the drawing, not NULL; what lies beyond its viewport is cut off */
    double x;                       /* place of the viewport's left edge, in mm; -1e6 .. 1e6; default 0 */
    double y;                       /* place of the viewport's top edge, in mm; -1e6 .. 1e6; default 0 */
    double scale;                   /* mm of a pixel; above 0, up to 1e6; default 25.4 / 96 */
    const char* name;               /* name of the group around the drawing, UTF-8; default NULL = no name */
} hrbfnpr_page_item;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_page_item_init(hrbfnpr_page_item* item, uint32_t struct_size);

/* A pen that draws some groups. */
typedef struct hrbfnpr_pen {
    uint32_t struct_size;
    uint32_t line_type; /* type of the lines, HRBFNPR_LINE_TYPE_...; default AS_DRAWN */
    const char* groups; /* the groups: a name, or the beginning of names and a '*'; default NULL = all groups.  The last
                           pen that fits a group draws it */
    double width;       /* width of all lines, in mm; 0 .. 1e6; default 0 = as drawn.  For plotters it is the width of
                           the pen, 0.3 if it is 0 */
    float ink[4];       /* colour of the ink, straight RGBA; default alpha 0 = as drawn */
    uint32_t number;    /* number of a plotter's pen, 1 .. 255; default 1.  If it is for several groups, each ink of
                           a style's palette has a pen of its own: the group "stipples ink 1" has number + 1, and so on.
                           Without any pen, the numbers begin at 1 */
    uint32_t reserved;  /* must be 0 */
} hrbfnpr_pen;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_pen_init(hrbfnpr_pen* pen, uint32_t struct_size);

/* A line or a text beside the drawings. */
typedef struct hrbfnpr_annotation {
    uint32_t struct_size;
    uint32_t line_type;   /* type of the line, HRBFNPR_LINE_TYPE_...; default CONTINUOUS */
    const char* group;    /* name of its group, UTF-8, 1 to 95 bytes; default "annotations".  Consecutive annotations of
                             one group share its layer and pen, and the ink and line type of the first of them */
    const char* text;     /* a text, UTF-8; default NULL = the points are a line.  HPGL writes texts as labels, GCODE
                             leaves them out */
    hrbfnpr_array points; /* points of the line, two at least, or the start of the text's baseline, in mm; n x 2,
                             FLOAT32 or FLOAT64 */
    double width;         /* width of the line, or height of the text's capitals, in mm; above 0, up to 1e6; default
                             0.35 */
    float ink[4];         /* colour of the ink, straight RGBA; default black */
} hrbfnpr_annotation;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_annotation_init(hrbfnpr_annotation* annotation, uint32_t struct_size);

/* A page to write. */
typedef struct hrbfnpr_page_desc {
    uint32_t struct_size;
    uint32_t format; /* format of the file, HRBFNPR_PAGE_FORMAT_...; default SVG */
    uint32_t flags;  /* HRBFNPR_PAGE_IN_PLOT_ORDER and others; default 0 */
    uint32_t widths; /* how strokes of varying width are written, HRBFNPR_WIDTHS_...; default OUTLINES */
    uint32_t dots;   /* how dots are written, HRBFNPR_DOT_SHAPE_...; default CIRCLES */
    uint32_t curves; /* how the curves of lines of one width are written, HRBFNPR_CURVES_...; default ARCS */
    double width;              /* width of the page, in mm; 0 .. 1e6; default 0 = as far as the drawings reach */
    double height;             /* height of the page, in mm; 0 .. 1e6; default 0 = as far as the drawings reach */
    double tolerance;          /* greatest distance between drawn and written lines, in mm; 0.001 .. 10; default 0.05.
                                  Larger: smaller files, rougher curves */
    double width_step;         /* ratio of the widths of two consecutive classes (WIDTHS_CLASSES); 1.01 .. 4; default
                                  1.25 */
    double join;               /* in plot order, distance between the ends of two lines below which they become one, in
                                  mm; 0 .. 1e6; default 0 = the pen's width */
    double shortest;           /* in plot order, length below which lines are dropped, in mm; 0 .. 1e6; default 0 = half
                                  the pen's width */
    double dot_distance;       /* in plot order, distance from a dot that stays below which other dots are dropped, in
                                  mm; 0 .. 1e6; default 0 = half the pen's width */
    double draw_speed;         /* speed of a plotter's pen on the paper, in mm/s; above 0, up to 1e6; default 30 */
    double travel_speed;       /* speed of a plotter's pen above the paper, in mm/s; above 0, up to 1e6; default 80 */
    double pen_seconds;        /* seconds that it takes to lower or to raise the pen; 0 .. 3600; default 0.15 */
    const char* pen_down;      /* GCODE: lines that lower the pen; default NULL = "G1 Z0" */
    const char* pen_up;        /* GCODE: lines that raise the pen; default NULL = "G0 Z5" */
    const char* title;         /* title of the file, UTF-8; default NULL = none */
    const char* description;   /* description of the file, UTF-8; default NULL = none */
    const char* metadata;      /* text about the model, the camera or the style, UTF-8; default NULL = none.  The
                                  library's version is added */
    const hrbfnpr_page_item* items; /* a list of drawings; default NULL */
    int64_t item_count;             /* number of `items`, 0 .. 4096; default 0 */
    int64_t item_stride;            /* bytes from one element of `items` to the next; default 0 = struct_size */
    const hrbfnpr_pen* pens; /* a list of pens; default NULL */
    int64_t pen_count;       /* number of `pens`, 0 .. 4096; default 0 */
    int64_t pen_stride;      /* bytes from one element of `pens` to the next; default 0 = struct_size */
    const hrbfnpr_annotation* annotations; /* a list of annotations; default NULL */
    int64_t annotation_count;              /* number of `annotations`, 0 .. 10000000; default 0 */
    int64_t annotation_stride;             /* bytes from one element of `annotations` to the next; default 0 =
                                              struct_size */
    double longest;            /* in plot order, length that the pen draws at most before it is raised, in mm; 1 .. 1e6,
                                  or 0 = no limit; default 0.  A longer line is cut into equal parts */
} hrbfnpr_page_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_page_desc_init(hrbfnpr_page_desc* desc, uint32_t struct_size);

/* What was written. */
typedef struct hrbfnpr_page_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t bytes;          /* bytes of the file */
    int64_t groups;         /* groups of ink */
    int64_t paths;          /* lines and outlines */
    int64_t segments;       /* curves or straight lines of all paths */
    int64_t dots;           /* dots */
    int64_t joined;         /* in plot order, pairs of ends that became one line */
    int64_t dropped_paths;  /* lines dropped because they are too short for the pen */
    int64_t dropped_dots;   /* dots dropped because they are too near to others for the pen */
    double width;           /* width of the page, in mm */
    double height;          /* height of the page, in mm */
    double drawn;           /* length that a pen draws, in mm; in plot order, else 0 */
    double travelled;       /* length that a pen travels above the paper, in mm; in plot order, else 0 */
    double seconds;         /* time that a plotter takes at the given speeds, in seconds; in plot order, else 0 */
    int64_t filled_paths;   /* lines wider than their pen, drawn in several passes */
    int64_t cut_paths;      /* lines longer than `longest`, cut into parts */
} hrbfnpr_page_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_page_info_init(hrbfnpr_page_info* info, uint32_t struct_size);

/* Writes a page, one buffer at a time.  Memory grows with the drawing's largest stroke; in plot order it grows with the
 * largest group.  `info` and `operation` may be NULL.
 * Errors: INVALID_ARGUMENT (no drawing and no annotation; an empty page; a text that is not UTF-8; a drawing with
 * VISIBILITY_PUBLISHED, which has discs of paper, for plotters, in DXF or in plot order), IO (`write` failed),
 * OUT_OF_MEMORY, CANCELLED, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_page_write(hrbfnpr_context* context, const hrbfnpr_page_desc* desc,
                                              hrbfnpr_write_fn write, void* user, hrbfnpr_page_info* info,
                                              hrbfnpr_operation* operation, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 15  PICTURE: from any source to a drawing in one call
 * ==========================================================================
 *
 * A picture chooses what a user leaves open: repairs, samples, the fit, where the surface ends, which way is up, the
 * camera, the size of the pen, the number of marks, and the lines.  It is made by the calls of the sections above, and
 * each of its parts can be taken out for these calls.
 *
 * Each choice that a user may want to know is a note: a code, its figures and a sentence.  A picture keeps its notes,
 * and the seconds of its stages. docs/pictures.md shows how to make pictures.
 */

/* A picture: what was chosen for sources, and made of them. */
typedef struct hrbfnpr_picture hrbfnpr_picture;
/* Settings of a picture, read from a file. */
typedef struct hrbfnpr_settings hrbfnpr_settings;

/* ---- What is drawn ---------------------------------------------------------- */

/* What is known about a source. */
enum {
    HRBFNPR_SOURCE_HAS_SHARP_EDGES = 1, /* says that `sharp_edges` is known, even if it is empty */
    HRBFNPR_SOURCE_HAS_VIEWPOINT = 2,   /* says that `viewpoint` is known */
    HRBFNPR_SOURCE_IS_PHOTO = 4         /* says that the points are one image of a depth camera that stood at
                                           `viewpoint` */
};

/* Values of a source's points, such as the colours or a quality that a file has at its vertices. */
typedef struct hrbfnpr_source_field {
    uint32_t struct_size;
    uint32_t kind;        /* HRBFNPR_FIELD_KIND_...; default SCALAR */
    const char* name;     /* name for styles; UTF-8, 1 to 63 bytes, copied; not NULL */
    hrbfnpr_array values; /* values, one for each point; n x 1 (SCALAR) or n x 3, FLOAT32, FLOAT64 or UINT8.  Colours of
                             UINT8 are 0 .. 255.  A point with a value that is not finite has none */
} hrbfnpr_source_field;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_source_field_init(hrbfnpr_source_field* field, uint32_t struct_size);

/* What is drawn, of one of four kinds: points (with or without normals), a mesh (points and triangles), a model, or a
 * point set.  A model and a point set together are a model with its marks, which are used as they are. */
typedef struct hrbfnpr_picture_source {
    uint32_t struct_size;
    uint32_t flags;            /* HRBFNPR_SOURCE_...; default 0 */
    hrbfnpr_array points;      /* points, or the vertices of the triangles; n x 3, FLOAT32 or FLOAT64.  Points that are
                                  not finite are left out */
    hrbfnpr_array normals;     /* normals of the points, of any length; n x 3, FLOAT32 or FLOAT64; not given, or all
                                  zero = no normals.  They are not read for a mesh */
    hrbfnpr_array triangles;   /* triangles of a mesh, as numbers of points from 0; m x 3, INT32, INT64 or UINT32; not
                                  given = points */
    hrbfnpr_array sharp_edges; /* edges of a mesh, as pairs of vertices, whose faces have separate normals in the file;
                                  k x 2, INT32, INT64 or UINT32; read with HAS_SHARP_EDGES */
    const hrbfnpr_model* model;         /* a model, which the picture keeps; default NULL */
    const hrbfnpr_point_set* point_set; /* a point set, which the picture keeps; default NULL.  It must be the only
                                           source, unless it comes with a model */
    double up[3];              /* direction that is up by the convention of the file's format; default 0, 0, 0 = not
                                  known */
    const char* up_by;         /* reason for `up` in notes, such as "PLY files"; default NULL = "files of this kind" */
    double viewpoint[3];       /* place where the scanner stood; read with HAS_VIEWPOINT */
    int64_t columns;           /* number of columns of a depth camera's image, whose points are given row by row;
                                  default 0 = the points are no image */
    int64_t rows;              /* number of rows of that image; default 0 */
    const char* name;          /* name of the file, for titles and metadata, UTF-8; default NULL */
    const hrbfnpr_source_field* fields; /* a list of values of the points or vertices, copied; default NULL.  Places on
                                           the surface have those of the nearest place of the mesh, or of the nearest
                                           point.  A layer style that names one gets it, see hrbfnpr_picture_create */
    int64_t field_count;       /* number of `fields`; 0 .. 1000; default 0 */
    int64_t field_stride;      /* bytes from one element of `fields` to the next; default 0 = struct_size */
} hrbfnpr_picture_source;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_source_init(hrbfnpr_picture_source* source, uint32_t struct_size);

/* ---- How it is drawn --------------------------------------------------------- */

/* Options of a picture. */
enum {
    HRBFNPR_PICTURE_ALLOW_BLANK = 1,   /* allows a drawing in which hardly anything can be seen */
    HRBFNPR_PICTURE_FLIP = 2,          /* turns all normals, whatever they look like */
    HRBFNPR_PICTURE_CLOSE = 4,         /* lets the surface go on beyond open data, as the fit has it */
    HRBFNPR_PICTURE_TOGETHER = 8,      /* fits an open mesh as one surface, even where its parts cross */
    HRBFNPR_PICTURE_TRANSPARENT = 16,  /* makes the paper transparent */
    HRBFNPR_PICTURE_KEEP_MARKS = 32,   /* gives all layers all their marks, even if the style draws lines only, and even
                                          those that the planned camera does not need; for marks that are saved, or
                                          drawn by a renderer of the caller */
    HRBFNPR_PICTURE_SURFACE_ONLY = 64, /* makes the model only: chooses no camera, places no marks, looks for no
                                          lines */
    HRBFNPR_PICTURE_IS_SOLID = 128,    /* says that the source is a part of a solid, so that up is y */
    HRBFNPR_PICTURE_VERIFY = 256       /* compares all lines with rays, and repairs wrong parts (verify_lines of the
                                          style); a note has the counts */
};

/* Which edges of a mesh are sharp. */
enum {
    HRBFNPR_PICTURE_EDGES_AS_GIVEN = 0, /* edges are found as with AUTO.  Where faces are coarse, the normals of the
                                           file decide if they say anything about edges */
    HRBFNPR_PICTURE_EDGES_AUTO = 1,     /* edges are found by HRBFNPR_EDGES_AUTO */
    HRBFNPR_PICTURE_EDGES_SMOOTH = 2,   /* no edge is sharp (HRBFNPR_EDGES_SMOOTH) */
    HRBFNPR_PICTURE_EDGES_SHARP = 3     /* edges are sharp that bend by more than `edge_angle` (HRBFNPR_EDGES_SHARP) */
};

/* Whether an upright section through the middle is drawn beside the drawing. */
enum {
    HRBFNPR_PROFILE_AUTO = 0, /* a section is drawn in the style archaeological only */
    HRBFNPR_PROFILE_YES = 1,  /* a section is drawn */
    HRBFNPR_PROFILE_NO = 2    /* no section is drawn */
};

/* The sides of a surface on which marks are drawn. */
enum {
    HRBFNPR_PICTURE_SIDES_AUTO = 0,  /* both sides of a surface that ends, and the front of other surfaces */
    HRBFNPR_PICTURE_SIDES_FRONT = 1, /* the front (HRBFNPR_SIDES_FRONT) */
    HRBFNPR_PICTURE_SIDES_BOTH = 2   /* both sides (HRBFNPR_SIDES_BOTH) */
};

/* The ground of a picture: a plane under the object, on which only what darkens it is drawn, which is cast shadows and
 * the sky that the object hides.  Its marks are a layer named "ground", of stipples or hatching as the style draws.
 * Open ground is white.  It casts no shadow and hides nothing.  If no light of the style casts shadows, the first one
 * casts them on the ground, and only there.  The ground is not drawn by cameras below it. */
enum {
    HRBFNPR_PICTURE_GROUND_NONE = 0,   /* no ground */
    HRBFNPR_PICTURE_GROUND_LOWEST = 1, /* at the lowest place of the object along the up direction */
    HRBFNPR_PICTURE_GROUND_HEIGHT = 2  /* at ground_height along the up direction */
};

/* How notes and errors write the options that they name. */
enum {
    HRBFNPR_WORDING_FIELDS = 0,   /* as fields of a descriptor: samples 400 */
    HRBFNPR_WORDING_OPTIONS = 1,  /* as options of a command line: --samples 400 */
    HRBFNPR_WORDING_ARGUMENTS = 2 /* as arguments of a call in Python: samples=400 */
};

/* A field to change after everything was chosen.  `field` is the path of the field:
 *
 *    style.F            a field of hrbfnpr_style; style.ink is the ink of all layers, lines and contours
 *    style.KIND.F       a field of hrbfnpr_layer_style, for one kind of layers: style.hatch.ink
 *    style.layers.F     the same for all layers of the style; share is multiplied
 *    style.lines.F      a field of hrbfnpr_line_style, for all lines
 *    style.LINE.F       the same for one kind of lines: style.ridge.width
 *    style.palette      inks for ink fields, #rrggbb with commas between; empty = up to three, from the colours
 *    style.field        what fields of the source change, as USE=NAME with commas between: "tone=quality,ink=rgb".  USE
 *                       is tone, density, width, ink, mask or direction.  The first five set style.layers.tone_field
 *                       and so on, the last sets marks.direction_field.  Without a NAME, the use ends
 *    marks.direction_field  name of a DIRECTION field of the source, which hatching follows
 *    fit.F              a field of hrbfnpr_fit_desc
 *    mesh_fit.F         a field of hrbfnpr_mesh_fit_desc
 *    marks.F            a field of hrbfnpr_generate_desc
 *    marks.KIND.F       a field of hrbfnpr_layer_desc, for one kind of layers; marks.layers.F for all layers
 *    line_set.F         a field of hrbfnpr_line_set_desc
 *
 * Lengths in pixels are those of this picture: they are not scaled by the pen.  The last change of a field counts. */
typedef struct hrbfnpr_change {
    uint32_t struct_size;
    uint32_t reserved;
    const char* field; /* path of the field, UTF-8 */
    const char* value; /* new value: a number, several numbers with commas between, a colour as #rrggbb or #rrggbbaa, or
                          the name of a constant without its prefix, such as "blue-noise" */
} hrbfnpr_change;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_change_init(hrbfnpr_change* change, uint32_t struct_size);

/* The stages of the work. */
enum {
    HRBFNPR_STAGE_MESH = 1,    /* looks at a mesh: joins vertices, turns faces */
    HRBFNPR_STAGE_SAMPLE = 2,  /* chooses samples */
    HRBFNPR_STAGE_ORIENT = 3,  /* finds normals */
    HRBFNPR_STAGE_SMOOTH = 4,  /* smooths the image of a depth camera */
    HRBFNPR_STAGE_FIT = 5,     /* fits the surface */
    HRBFNPR_STAGE_COMPARE = 6, /* compares the surface with the mesh */
    HRBFNPR_STAGE_END = 7,     /* finds the end of the surface */
    HRBFNPR_STAGE_MARKS = 8,   /* places marks */
    HRBFNPR_STAGE_LINES = 9,   /* finds lines */
    HRBFNPR_STAGE_FRAME = 10,  /* draws */
    HRBFNPR_STAGE_VIEWS = 11,  /* draws the views of a sheet */
    HRBFNPR_STAGE_SHADE = 12   /* finds occlusion and cast shadows */
};

/* How much a note matters. */
enum {
    HRBFNPR_SEVERITY_INFO = 0,    /* a measurement */
    HRBFNPR_SEVERITY_NOTE = 1,    /* something was chosen, repaired or left out */
    HRBFNPR_SEVERITY_WARNING = 2, /* the result may be wrong in some place */
    HRBFNPR_SEVERITY_FAILURE = 3  /* there is no result: the text is the error of the call, in full length */
};

/* Codes of notes.  Each line says when a note is given, with its figures in brackets; [] = no figures.  Figures are
 * counts unless a line says otherwise.  Shares are 0 .. 1. */
enum {
    HRBFNPR_NOTE_FACES_NOT_FINITE = 1,        /* faces with a corner that is not finite are left out [faces] */
    HRBFNPR_NOTE_NO_DATA = 2,                 /* points at a value that means "no data" are left out [points, the
                                                 value] */
    HRBFNPR_NOTE_STRAYS = 3,                  /* points far from all others are left out [points] */
    HRBFNPR_NOTE_SOME_ORIENTED = 4,           /* only some of the points get normals, because there are many [points,
                                                 points with normals] */
    HRBFNPR_NOTE_NORMALS_MADE = 5,            /* the points have no normals, and get some [points] */
    HRBFNPR_NOTE_NORMALS_NOT_SURE = 6,        /* normals that were found are not certain [confidence, 0 .. 1] */
    HRBFNPR_NOTE_FRONT_NOT_TOLD = 7,          /* the surface is open, and nothing tells which side is its front [] */
    HRBFNPR_NOTE_SAMPLES_CHOSEN = 8,          /* only some points are used as samples [points, points used] */
    HRBFNPR_NOTE_POINTS_NOT_USABLE = 9,       /* points without a usable position or normal are left out [points] */
    HRBFNPR_NOTE_NORMALS_JOINED = 10,         /* places with several normals get the mean of these [places] */
    HRBFNPR_NOTE_NORMALS_OPPOSITE = 11,       /* places with opposite normals are left out [places] */
    HRBFNPR_NOTE_TERRAIN_TURNED = 12,         /* a terrain looked down, and its normals are turned [axis: 1 = y, 2 =
                                                 z] */
    HRBFNPR_NOTE_NORMALS_TURNED = 13,         /* all normals looked inward, and are turned [] */
    HRBFNPR_NOTE_NORMALS_REPAIRED = 14,       /* given normals are repaired [normals turned, normals made, what they
                                                 were: HRBFNPR_NORMALS_...] */
    HRBFNPR_NOTE_NORMALS_AGAINST = 15,        /* some normals look against those around them [these normals, all
                                                 normals] */
    HRBFNPR_NOTE_NORMALS_MIXED = 16,          /* some parts have outward normals and others inward ones [share that
                                                 looks inward] */
    HRBFNPR_NOTE_NORMALS_INWARD = 17,         /* most of an open surface looks inward [] */
    HRBFNPR_NOTE_VIEWPOINT_NOT_USED = 18,     /* `viewpoint` is given, but the source needs none [] */
    HRBFNPR_NOTE_PIXELS_LEFT_OUT = 19,        /* pixels of a depth camera that lie on no surface are left out
                                                 [pixels] */
    HRBFNPR_NOTE_DEPTH_NOISE = 20,            /* the noise of a depth camera was measured [standard deviation, depth
                                                 where it holds; units of the source] */
    HRBFNPR_NOTE_SMOOTHED = 21,               /* the samples have noise, and the surface does not pass through all of
                                                 them [] */
    HRBFNPR_NOTE_SAMPLES_MERGED = 22,         /* samples at the same place are merged [samples] */
    HRBFNPR_NOTE_SAMPLES_NEAR = 23,           /* samples very near to another are merged with it [samples] */
    HRBFNPR_NOTE_SAMPLES_DROPPED = 24,        /* samples are dropped as strays [samples] */
    HRBFNPR_NOTE_SAMPLES_FLIPPED = 25,        /* flipped normals of samples are repaired [samples] */
    HRBFNPR_NOTE_LIKE_STRAYS = 26,            /* samples that look like strays are kept [samples] */
    HRBFNPR_NOTE_LIKE_FLIPPED = 27,           /* samples whose normals look flipped are kept [samples] */
    HRBFNPR_NOTE_FEW_POINTS = 28,             /* the surface is a guess, because there are few points [points] */
    HRBFNPR_NOTE_ON_A_LINE = 29,              /* all points are on a line [] */
    HRBFNPR_NOTE_IN_A_PLANE = 30,             /* all points are in a plane [] */
    HRBFNPR_NOTE_ALONG_CURVES = 31,           /* the points lie along curves, and the surface between these is drawn,
                                                 too [] */
    HRBFNPR_NOTE_END_NOT_FOUND = 32,          /* the end of the surface was not found, and the surface goes on to the
                                                 end of its box [] */
    HRBFNPR_NOTE_UP = 33,                     /* another direction than y is chosen as up [x, y, z] */
    HRBFNPR_NOTE_FACES_TURNED = 34,           /* faces that looked to the other side than those beside them are turned
                                                 [faces] */
    HRBFNPR_NOTE_INSIDE_OUT = 35,             /* a mesh, or some of its parts, is inside out, and is turned [parts] */
    HRBFNPR_NOTE_FACES_LEFT_OUT = 36,         /* faces without area, and repeated faces, are left out [faces] */
    HRBFNPR_NOTE_PARTS_INSIDE = 37,           /* parts of a mesh inside others are left out [parts, their faces] */
    HRBFNPR_NOTE_CONTRARY_EDGES = 38,         /* faces beside each other look to opposite sides and cannot be turned:
                                                 the surface has one side, or crosses itself [edges] */
    HRBFNPR_NOTE_PARTS_FAR = 39,              /* parts of a mesh far from all others are left out [parts, their
                                                 faces] */
    HRBFNPR_NOTE_FLAPS = 40,                  /* faces that hang on an edge of two others are left out [faces] */
    HRBFNPR_NOTE_ALL_FLAT = 41,               /* all faces stay flat, because the normals of the file say so [] */
    HRBFNPR_NOTE_EDGES_BY_NORMALS = 42,       /* some edges are sharp, because the normals of the file say so [] */
    HRBFNPR_NOTE_DIVIDED = 43,                /* coarse faces are divided towards a round surface [rounds; how far
                                                 vertices moved; how far places between them were raised; how far the
                                                 faces were off a round surface, if they are coarse; shares of the
                                                 diagonal] */
    HRBFNPR_NOTE_COARSE_FLAT = 44,            /* coarse faces stay flat, because no round surface goes through them
                                                 [] */
    HRBFNPR_NOTE_GROUPS = 45,                 /* parts of a mesh that cross or are close are fitted in groups, each as a
                                                 separate surface [parts, groups] */
    HRBFNPR_NOTE_NOT_REACHED = 46,            /* the fit did not reach its tolerance everywhere [tolerance in diagonals,
                                                 share of the mesh within it, share of the surface within it, greatest
                                                 distance in diagonals] */
    HRBFNPR_NOTE_EDGES_STAY_SMOOTH = 47,      /* some sharp edges of a mesh stay smooth [their length in diagonals] */
    HRBFNPR_NOTE_OFF_MESH = 48,               /* the surface is far from the mesh in some places [share of the mesh,
                                                 greatest distance in diagonals] */
    HRBFNPR_NOTE_MADE_BY_FIT = 49,            /* the fit made parts of surface that the mesh does not have, and they are
                                                 left out [parts] */
    HRBFNPR_NOTE_PARTS_TOO_THIN = 50,         /* two parts of a mesh are nearer to each other than the tolerance, so
                                                 that the surface may join them [numbers of both parts, from 0; x, y and
                                                 z of the place] */
    HRBFNPR_NOTE_MARKS_LIMITED = 51,          /* a layer has fewer marks than fill the darkest tone [marks wanted, marks
                                                 made] */
    HRBFNPR_NOTE_LEVELS_LIMITED = 52,         /* the published method makes fewer refinement steps than fill the picture
                                                 [steps wanted, steps made] */
    HRBFNPR_NOTE_SEEN_FROM_CAMERA = 53,       /* the image of a depth camera is seen from where the camera stood
                                                 [azimuth in degrees] */
    HRBFNPR_NOTE_SEEN_FROM_FRONT = 54,        /* an open surface is seen from its front [azimuth in degrees] */
    HRBFNPR_NOTE_NO_LINES_OF_MARKS = 55,      /* no lines are drawn, because the source is a point set without a model
                                                 [] */
    HRBFNPR_NOTE_LINES_THIN = 56,             /* the surface is thinner than the cells in which lines are searched, so
                                                 that lines may be missing [triangles that look away, all triangles,
                                                 samples missed] */
    HRBFNPR_NOTE_LINES_END = 57,              /* lines end where the surface ends beyond its samples [borders, support,
                                                 share of the area left out] */
    HRBFNPR_NOTE_LINES_BROKEN = 58,           /* some curves end inside the surface, or were missed [curves] */
    HRBFNPR_NOTE_LINES_DOUBTED = 59,          /* the visibility of some lines contradicts itself [lines] */
    HRBFNPR_NOTE_LINES_TANGLED = 60,          /* lines cross so often in some places of the picture that no crossing was
                                                 used [places] */
    HRBFNPR_NOTE_BLANK = 61,                  /* hardly anything can be seen [marks shown, all marks, share of the
                                                 picture that ink covers] */
    HRBFNPR_NOTE_PENS = 62,                   /* pens are chosen by the widths at hand [] */
    HRBFNPR_NOTE_PLOTTED = 63,                /* a plotter's file is written [metres drawn, metres travelled,
                                                 seconds] */
    HRBFNPR_NOTE_NOT_IN_SETTINGS = 64,        /* something that the picture was made with is not in its settings [] */
    HRBFNPR_NOTE_UNIT_IS_METRE = 65,          /* the unit of the source is taken as a metre, because its format says so
                                                 [] */
    HRBFNPR_NOTE_NO_SYMMETRY = 66,            /* centre lines are asked for, but no plane of symmetry was found [] */
    HRBFNPR_NOTE_SECTION_OPEN = 67,           /* outlines of a cut are not closed, and are not hatched [outlines] */
    HRBFNPR_NOTE_NORMALS_NOT_UNIT = 68,       /* normals get the length 1 [normals] */
    HRBFNPR_NOTE_AT_ONE_PLACE = 69,           /* all points are at one place [] */
    HRBFNPR_NOTE_FAR_FROM_ORIGIN = 70,        /* the source is so far from the origin that single precision loses its
                                                 details [] */
    HRBFNPR_NOTE_VERTICES_JOINED = 71,        /* vertices at the place of another are joined with it [vertices] */
    HRBFNPR_NOTE_VERTICES_UNUSED = 72,        /* vertices of no face are left out [vertices] */
    HRBFNPR_NOTE_NONMANIFOLD_EDGES = 73,      /* edges have more than two faces [edges] */
    HRBFNPR_NOTE_MESH_OPEN = 74,              /* a mesh is open [borders, their edges] */
    HRBFNPR_NOTE_SEVERAL_PARTS = 75,          /* a mesh has several parts [parts] */
    HRBFNPR_NOTE_NOT_USABLE = 76,             /* a source cannot be drawn; the text says why [] */
    HRBFNPR_NOTE_NO_GROUND = 77,              /* no ground is drawn; the text says why [] */
    HRBFNPR_NOTE_PALETTE_CHOSEN = 78,         /* inks are chosen from the colours of the source [inks] */
    HRBFNPR_NOTE_NO_SHADOWS = 79,             /* borders of shadows are to be drawn, and no light casts shadows [] */
    HRBFNPR_NOTE_LINES_VERIFIED = 95          /* rays were compared with all parts of lines [decided parts, those that
                                                 agree, undecided parts, repaired parts] */
};

/* A note: something that was chosen, repaired, left out or measured, or that may be wrong. */
typedef struct hrbfnpr_note {
    uint32_t struct_size;
    uint32_t code;       /* what it is about, HRBFNPR_NOTE_... */
    uint32_t severity;   /* how much it matters, HRBFNPR_SEVERITY_... */
    uint32_t figure_count; /* number of `figures` that are set, 0 .. 8 */
    double figures[8];   /* figures of the code, in the order of its brackets */
    const char* text;    /* a short sentence without a full stop, UTF-8, in the words of `wording`; at most 100 bytes
                            for notes and warnings */
    const char* advice;  /* what to do about it, in the same words; NULL if the text says it or nothing needs doing */
    const char* detail;  /* one or two more sentences that explain the text, in the same words; NULL if none */
} hrbfnpr_note;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_note_init(hrbfnpr_note* note, uint32_t struct_size);

/* What happens while a picture is made: a new note, or the progress of a stage. */
typedef struct hrbfnpr_picture_event {
    uint32_t struct_size;
    uint32_t stage;      /* stage that runs, HRBFNPR_STAGE_...; 0 = none runs */
    double fraction;     /* progress of the stage: 0 when it begins, 1 when it ends; 0 with a note */
    double seconds;      /* time that the stage took, when it ends; else 0 */
    const char* name;    /* name of the stage, such as "place marks"; NULL with a note */
    const char* doing;   /* the same for a progress bar, such as "placing marks"; NULL with a note */
    const char* says;    /* result of the stage in words, when it ends; else NULL */
    const hrbfnpr_note* note; /* a new note; NULL = the event is about the stage */
} hrbfnpr_picture_event;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_event_init(hrbfnpr_picture_event* event, uint32_t struct_size);
/* Gets an event.  It runs on the thread that entered the library.  The event lives during the call only. */
typedef void (*hrbfnpr_picture_event_fn)(void* user, const hrbfnpr_picture_event* event);

/* How a picture is made.  Each field has a default that makes a good picture.  A source is enough, and a style if
 * wanted.  A default of NaN, 0 or NULL is chosen by the picture, as its line says. */
typedef struct hrbfnpr_picture_desc {
    uint32_t struct_size;
    uint32_t flags;                        /* HRBFNPR_PICTURE_...; default 0 */
    const hrbfnpr_picture_source* sources; /* a list of 1 to 10000 sources, each a separate surface; NULL for
                                              hrbfnpr_picture_restyle */
    int64_t source_count;                  /* number of `sources`; default 0 */
    int64_t source_stride;                 /* bytes from one element of `sources` to the next; default 0 =
                                              struct_size */

    /* Style. */
    uint32_t preset;               /* named style, HRBFNPR_PRESET_...; default CONTOUR_AND_STIPPLE */
    uint32_t wording;              /* how notes and errors write options, HRBFNPR_WORDING_...; default FIELDS */
    const char* style_name;        /* name of a preset, in place of its number; default NULL */
    const hrbfnpr_style* style;    /* a style to use as it is, with lengths in pixels of this picture; default NULL.
                                      `preset` then says which layers of marks there are */
    const hrbfnpr_settings* settings; /* settings for what this descriptor leaves at its defaults; the picture keeps
                                         them; default NULL */
    const hrbfnpr_change* changes; /* a list of fields to change; default NULL */
    int64_t change_count;          /* number of `changes`; default 0 */
    int64_t change_stride;         /* bytes from one element of `changes` to the next; default 0 = struct_size */
    const hrbfnpr_dab* dabs;       /* a list of dabs that paint the surface; default NULL */
    int64_t dab_count;             /* number of `dabs`, 0 .. 1000000; default 0 */
    int64_t dab_stride;            /* bytes from one element of `dabs` to the next; default 0 = struct_size */

    /* Size, in pixels. */
    int32_t width;     /* width of the drawing, in pixels, 1 .. 32768, given with `height`; default 0 = from `size` */
    int32_t height;    /* height of the drawing, in pixels, 1 .. 32768, given with `width`; default 0 = from `size` */
    int32_t size;      /* longer side of the drawing, in pixels, 1 .. 32768; the shorter side is as the object needs it;
                          default 0 = 1600 */
    uint32_t sides;    /* sides on which marks are drawn, HRBFNPR_PICTURE_SIDES_...; default AUTO */
    double pen;        /* radius of the pen in pixels, which styles vary a little; 1e-6 .. 1e6; default 0 = an 800th of
                          the longer side, at least 0.75 */
    double line_width; /* width of contours, in pixels; other lines are finer; 1e-6 .. 1e6; default 0 = that of the
                          style */

    /* Camera. */
    const hrbfnpr_camera* camera; /* a camera to use as it is, with its viewport as the size; default NULL */
    double up[3];        /* direction that is up; default 0, 0, 0 = by the format and the shape, or y where neither
                            tells */
    double azimuth;      /* azimuth of the camera about the up axis, from the front to the right, in degrees; default
                            NaN = 30, and another where that sees the back of an open surface */
    double elevation;    /* elevation of the camera above the horizon, in degrees; default NaN = 20 */
    double direction[3]; /* direction from the eye into the scene, in place of azimuth and elevation; default 0, 0, 0 =
                            not given */
    double eye[3];       /* place of the eye, which looks at `target`; default NaN = not given */
    double target[3];    /* place that the eye looks at; default NaN = the middle of the model */
    double fov;          /* vertical angle of view, in degrees, 0.01 .. 179; 0 = orthographic; default NaN = 30, or 0 in
                            the style archaeological */
    double margin;       /* share of the picture that is free on each side, 0 .. 0.45; default NaN = 0.05 */
    double turn;         /* angle of an orbit that starts here, in degrees; the picture has room for all of it; default
                            0 = a still picture */
    int32_t turn_frames; /* number of frames of that orbit, 1 .. 1000000; default 36 */

    /* From the source to a surface. */
    uint32_t normals;        /* what is known of the normals of points, HRBFNPR_NORMALS_...; default AUTO */
    int64_t samples;         /* number of samples of a mesh, or chosen from points, 0 .. 1e9; default 0 = as many as a
                                mesh needs, and of points all up to 4096 */
    double tolerance;        /* samples are chosen until the surface is this near to the mesh, or to all points, in
                                units of the source; 0 or more; default 0 = 0.002 diagonals for a mesh, and no such end
                                for points */
    int64_t maximum_centres; /* the most samples that are chosen, 0 or more; default 0 = 8000 for a mesh, and no limit
                                for points */
    uint32_t parts;          /* parts of a mesh that are kept, HRBFNPR_PARTS_...; default AUTO */
    uint32_t edges;          /* edges of a mesh that are sharp, HRBFNPR_PICTURE_EDGES_...; default AS_GIVEN */
    double edge_angle;       /* angle between the normals of two faces, in degrees, above which their edge is sharp,
                                with EDGES_SHARP; 5 .. 175; default 30 */
    double crease_angle;     /* angle between the normals of two faces, in degrees, above which they do not share corner
                                normals; 0 .. 180; default NaN = 60 */
    int32_t subdivide;       /* how often faces are divided into four towards a round surface, 0 .. 6; default -1 =
                                where faces are coarse and no edges stand out */
    uint32_t profile;        /* whether a section is drawn beside the drawing, HRBFNPR_PROFILE_...; default AUTO */
    double viewpoint[3];     /* place where the scanner stood, to which open surfaces without normals look; default NaN
                                = as the source says */
    double depth_smoothing;  /* factor of the width over which the image of a depth camera is smoothed, 0 .. 100; 0
                                leaves its points where they are; default NaN = 1 */
    uint64_t random_seed;    /* seed of all random numbers; default 1 */

    /* Marks, lines, and what stands beside the drawing. */
    const char* mark_kinds;    /* kinds of layers of marks with commas between, such as "stipples,hatch"; default NULL =
                                  those of the style */
    hrbfnpr_array seed_points; /* points where marks of the published method start; n x 3, FLOAT32 or FLOAT64; not given
                                  = by seed_source of hrbfnpr_generate_desc */
    double hatch_angle;        /* angle by which all lines of hatching are turned, in degrees, -360 .. 360; default 0 */
    const char* lines;         /* kinds of lines with commas between: contour, suggestive, ridges, valleys, apparent,
                                  parabolic, isophotes=0.3:0.6, section=z:20, border, crease, shadow, terminator, soft,
                                  tangent;
                                  "none" = no lines, so that contours are drawn by marks with VISIBILITY_PUBLISHED
                                  only; default NULL = those of the style */
    const char* scale_bar;     /* unit of a scale bar below the drawing; "none" = no bar; default NULL = "units" in the
                                  style archaeological, else "none" */

    hrbfnpr_picture_event_fn on_event; /* gets events for as long as the picture lives; default NULL */
    void* event_user;                  /* passed to on_event; it must outlive the picture */

    /* Ground. */
    uint32_t ground;     /* whether the picture has a ground, and where, HRBFNPR_PICTURE_GROUND_...; default NONE */
    uint32_t reserved;
    double ground_height; /* height of the ground with GROUND_HEIGHT along the unit vector of the up direction, in units
                             of the source; default 0 */
} hrbfnpr_picture_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_desc_init(hrbfnpr_picture_desc* desc, uint32_t struct_size);

/* ---- What a source holds ------------------------------------------------------ */

/* The kind of a source. */
enum {
    HRBFNPR_SOURCE_KIND_POINTS = 1,   /* points, with or without normals */
    HRBFNPR_SOURCE_KIND_MESH = 2,     /* a mesh */
    HRBFNPR_SOURCE_KIND_MODEL = 3,    /* a model, with or without marks */
    HRBFNPR_SOURCE_KIND_POINT_SET = 4 /* a point set without a model */
};

/* Which way normals look. */
enum {
    HRBFNPR_NORMALS_LOOK_UNKNOWN = 0, /* there are no normals, or the source cannot be drawn */
    HRBFNPR_NORMALS_LOOK_OUTWARD = 1, /* all look outward */
    HRBFNPR_NORMALS_LOOK_INWARD = 2,  /* all look inward */
    HRBFNPR_NORMALS_LOOK_MIXED = 3,   /* some look outward, others inward */
    HRBFNPR_NORMALS_LOOK_OPEN = 4,    /* they agree, and the surface encloses nothing */
    HRBFNPR_NORMALS_LOOK_FOREIGN = 5  /* they belong to other points; found for points along curves only */
};

/* What a source holds.  A field that does not apply to the kind of source is 0.  If the source cannot be drawn, fields
 * that were not examined any more are 0. */
typedef struct hrbfnpr_source_info {
    uint32_t struct_size;
    uint32_t kind;            /* kind of the source, HRBFNPR_SOURCE_KIND_... */
    uint32_t severity;        /* severity of the worst finding, HRBFNPR_SEVERITY_...: INFO = no finding; NOTE = a
                                 picture repairs it; WARNING = something is wrong; FAILURE = it cannot be drawn */
    uint32_t normals_look;    /* which way the normals of points or faces look, HRBFNPR_NORMALS_LOOK_... */
    int64_t points;           /* points as given: points, vertices of a mesh, centres of a model, marks of a point
                                 set */
    int64_t triangles;        /* triangles as given */
    int64_t no_data;          /* points at a value that means "no data"; all fields below leave them out */
    int64_t strays;           /* points far from all others; all fields below leave them out */
    int64_t points_not_finite; /* points without a finite position */
    int64_t duplicates;       /* points, or vertices of faces, at the place of another */
    double bounds_min[3];     /* least coordinates of the finite points */
    double bounds_max[3];     /* greatest coordinates of the finite points */
    double diagonal;          /* diagonal of these bounds */
    double up[3];             /* direction that a picture chooses as up, for points and meshes; up_reason says why */

    /* Normals of points. looks_down, normals_closed and normals_flipped_share are set for faces, too. */
    uint32_t has_normals;         /* 1: some normals are given that are not zero */
    uint32_t along_curves;        /* 1: the points lie along curves, such as wires or cross sections */
    uint32_t looks_down;          /* axis along which a terrain looks down: 1 = y, 2 = z; 0 = it does not, or is no
                                     terrain */
    uint32_t reserved;
    int64_t normals_zero;         /* normals that are zero */
    int64_t normals_not_finite;   /* normals that are not finite */
    double normals_unit_share;    /* share of the usable normals that have length 1, 0 .. 1 */
    double normals_closed;        /* median over the samples of the sum of the winding numbers on both sides: 1 = closed
                                     and outward, -1 = inward, 0 = a flat sheet; 0 for points along curves */
    double normals_flipped_share; /* share of the normals that look flipped beside their neighbours, 0 .. 1; 0 for
                                     points along curves */

    /* The image of a depth camera, if it has no normals. */
    int64_t image_seen;    /* pixels that have a point */
    int64_t image_dropped; /* pixels among these that lie on no surface */
    double image_depth;    /* median depth of the pixels that have a point */
    double image_noise;    /* standard deviation of the depth, at that depth */

    /* A mesh as it was given, except that vertices at the same place are joined. */
    uint32_t closed;               /* 1: each edge has two faces, which run along it in opposite directions */
    uint32_t inside_out;           /* 1: the mesh is closed, and its faces look inward */
    int64_t components;            /* parts that share no vertex */
    int64_t components_inside_out; /* parts without a border whose faces look inward; inside another part it is a
                                      cavity */
    int64_t boundary_edges;        /* edges with one face */
    int64_t boundary_loops;        /* borders */
    int64_t nonmanifold_edges;     /* edges with more than two faces */
    int64_t nonmanifold_left;      /* edges among these that hrbfnpr_mesh_create cannot mend */
    int64_t contrary_edges;        /* edges with two faces, one of which is turned over */
    int64_t faces_not_finite;      /* faces with a corner that is not finite */
    int64_t degenerate_faces;      /* faces without area */
    int64_t repeated_faces;        /* faces with the same corners as another */
    int64_t unused_vertices;       /* vertices of no face */
    double area;                   /* area, in squared units of the source */
    double volume;                 /* enclosed volume, in cubed units of the source; 0 if the mesh is not closed */

    char up_reason[128];           /* reason for `up`, such as "as in PLY files"; "" = up is not known */
} hrbfnpr_source_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_source_info_init(hrbfnpr_source_info* info, uint32_t struct_size);

/* Looks at a source without drawing it.  It puts facts into `info`, and passes findings to on_event as notes.  A NOTE
 * is something that a picture repairs.  A WARNING is something that is wrong, with advice.  One matter may give both.
 * A FAILURE, with the code NOT_USABLE, says why the source cannot be drawn; the call succeeds all the same.  `wording`
 * is HRBFNPR_WORDING_...; on_event and `operation` may be NULL.
 * Errors: INVALID_ARGUMENT (fields of the source), OUT_OF_MEMORY, CANCELLED, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_source_inspect(hrbfnpr_context* context, const hrbfnpr_picture_source* source,
                                                  uint32_t wording, hrbfnpr_picture_event_fn on_event,
                                                  void* event_user, hrbfnpr_operation* operation,
                                                  hrbfnpr_source_info* info, hrbfnpr_error* error);

/* ---- Making and drawing ------------------------------------------------------ */

/* Makes a picture: fits surfaces, places marks and finds lines.  It draws nothing yet.  `operation` may be NULL.  The
 * call needs the stack of hrbfnpr_model_fit.
 *
 * A field of a layer style (tone_field and so on) names values of the source (hrbfnpr_source_field), or a field of its
 * point set.  For numbers of a source, the name may say which value becomes 0 and which becomes 1, as in
 * "quality:0.2..0.9"; else they are the least and the greatest value that is finite.  Outliers do not count for this:
 * values farther from the inner 96 % than a quarter of the range of these.  "-quality" turns this round.
 * A colour in place of a number is its luminance, as in HRBFNPR_FIELD_SOURCE_IMAGE.  An ink_field without a palette
 * gets one of three inks, or of up to eight if there are no more hues; a note names them.
 *
 * Errors: INVALID_ARGUMENT (a field of `desc`; a source that cannot be drawn), SINGULAR_SYSTEM, NOT_CONVERGED,
 * OUT_OF_MEMORY, CANCELLED, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_create(hrbfnpr_context* context, const hrbfnpr_picture_desc* desc,
                                                  hrbfnpr_operation* operation, hrbfnpr_picture** out_picture,
                                                  hrbfnpr_error* error);
/* Makes a picture of the same surfaces in another style, size or view.  `desc` has no sources.  Marks and lines that
 * fit are used again; others are made anew.  `operation` may be NULL.
 * Errors: those of hrbfnpr_picture_create; INVALID_ARGUMENT, too, if the picture was made with SURFACE_ONLY. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_restyle(const hrbfnpr_picture* picture, const hrbfnpr_picture_desc* desc,
                                                   hrbfnpr_operation* operation, hrbfnpr_picture** out_picture,
                                                   hrbfnpr_error* error);
/* Adds a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_picture_retain(hrbfnpr_picture* picture);
/* Releases a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_picture_release(hrbfnpr_picture* picture);

/* Draws a picture.  `camera` NULL is the planned camera.  Lines keep their numbers from one drawing to the next.
 * Without KEEP_MARKS and without a turn, the picture has only the marks that the planned camera needs.  The first
 * drawing by another camera then places all marks, and takes longer.
 * `operation` may be NULL.
 * Errors: INVALID_ARGUMENT (the camera; a picture made with SURFACE_ONLY; with the planned camera, a drawing in which
 * hardly anything can be seen, unless ALLOW_BLANK is set: a note BLANK says more), OUT_OF_MEMORY, CANCELLED,
 * CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_draw(hrbfnpr_picture* picture, const hrbfnpr_camera* camera,
                                                hrbfnpr_operation* operation, hrbfnpr_drawing** out_drawing,
                                                hrbfnpr_error* error);

/* What a picture is made of. */
typedef struct hrbfnpr_picture_info {
    uint32_t struct_size;
    uint32_t preset;      /* named style as used, HRBFNPR_PRESET_... */
    int64_t parts;        /* number of surfaces; 1 for a point set */
    int64_t marks;        /* marks of all parts */
    int64_t notes;        /* number of notes, for hrbfnpr_picture_get_note */
    int64_t stages;       /* number of stages that have ended, for hrbfnpr_picture_get_stage */
    int32_t width;        /* width of the drawing, in pixels; 0 with SURFACE_ONLY */
    int32_t height;       /* height of the drawing, in pixels; 0 with SURFACE_ONLY */
    double bounds_min[3]; /* least coordinates of all parts */
    double bounds_max[3]; /* greatest coordinates of all parts */
    double up[3];         /* direction that is up, as used */
    double pen;           /* radius of the pen as used, in pixels */
    double seconds;       /* time that it took to make the picture */
} hrbfnpr_picture_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_info_init(hrbfnpr_picture_info* info, uint32_t struct_size);
/* Gets what a picture is made of. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_info(const hrbfnpr_picture* picture, hrbfnpr_picture_info* info,
                                                    hrbfnpr_error* error);

/* One surface of a picture.  Its handles are valid while the picture lives; the caller retains those that it keeps
 * longer. */
typedef struct hrbfnpr_picture_part {
    uint32_t struct_size;
    uint32_t sides;                     /* sides on which marks are drawn, as used, HRBFNPR_SIDES_... */
    const hrbfnpr_model* model;         /* its model; NULL for a point set */
    const hrbfnpr_point_set* point_set; /* the marks that the planned camera draws: all marks with KEEP_MARKS, else a
                                           set of hrbfnpr_point_set_generate_still; NULL with SURFACE_ONLY */
    const hrbfnpr_line_set* line_set;   /* its lines; NULL without lines */
    const hrbfnpr_mesh* mesh;           /* the mesh that it was fitted to; NULL for other sources */
} hrbfnpr_picture_part;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_part_init(hrbfnpr_picture_part* part, uint32_t struct_size);
/* Gets one surface of a picture.  `number` is 0 .. hrbfnpr_picture_info.parts - 1; the largest surface is 0.  The last
 * one is the ground, if the picture has one.
 * Errors: INVALID_ARGUMENT (no such part). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_part(const hrbfnpr_picture* picture, int64_t number,
                                                    hrbfnpr_picture_part* part, hrbfnpr_error* error);
/* Gets the style that was chosen for hrbfnpr_renderer_draw.  It is valid while the picture lives.
 * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_style(const hrbfnpr_picture* picture, const hrbfnpr_style** style,
                                                     hrbfnpr_error* error);
/* Gets the descriptor with which hrbfnpr_point_set_generate made the marks.  It is valid while the picture lives. *desc
 * is NULL where the caller gave the marks.
 * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_marks(const hrbfnpr_picture* picture,
                                                     const hrbfnpr_generate_desc** desc, hrbfnpr_error* error);
/* Gets a note.  `number` is 0 .. hrbfnpr_picture_info.notes - 1.  Its texts are valid while the picture lives.
 * Errors: INVALID_ARGUMENT (no such note). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_note(const hrbfnpr_picture* picture, int64_t number,
                                                    hrbfnpr_note* note, hrbfnpr_error* error);
/* Gets the last event of a stage that has ended.  `number` is 0 .. hrbfnpr_picture_info.stages - 1.
 * Errors: INVALID_ARGUMENT (no such stage). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_stage(const hrbfnpr_picture* picture, int64_t number,
                                                     hrbfnpr_picture_event* stage, hrbfnpr_error* error);

/* ---- Cameras ------------------------------------------------------------------ */

/* Gets the planned camera.
 * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_camera(const hrbfnpr_picture* picture, hrbfnpr_camera* camera,
                                                      hrbfnpr_error* error);
/* Gets a camera that looks from another side, with the size, the lens and the margin of the picture.  It looks along
 * `direction` (3 doubles, from the eye into the scene).  If that is NULL, it looks from `azimuth` and `elevation`, in
 * degrees; NaN = as planned.
 * Errors: INVALID_ARGUMENT (a number is not finite; a picture made with SURFACE_ONLY). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_look(const hrbfnpr_picture* picture, const double* direction,
                                                double azimuth, double elevation, hrbfnpr_camera* camera,
                                                hrbfnpr_error* error);
/* Gets the planned camera, turned by an angle in degrees about the up axis through the middle of the model.  If the
 * descriptor gave an eye, the axis goes through its target.
 * Errors: INVALID_ARGUMENT (the angle is not finite; a picture made with SURFACE_ONLY). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_orbit(const hrbfnpr_picture* picture, double degrees,
                                                 hrbfnpr_camera* camera, hrbfnpr_error* error);

/* ---- As an image and as vectors ------------------------------------------------ */

/* Gets the size of a picture's plate, in pixels.  A plate is a drawing with the section and the scale bar beside it.
 * Without these it is the drawing alone.  `camera` is the camera that the drawing was made with; NULL = the planned
 * camera.
 * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_plate_size(const hrbfnpr_picture* picture, const hrbfnpr_camera* camera,
                                                      int32_t* width, int32_t* height, hrbfnpr_error* error);
/* Draws the plate of a picture into an image, from the top-left corner on.  The image has at least the size that
 * hrbfnpr_picture_plate_size gives.  `camera` is the camera that the drawing was made with; NULL = the planned camera.
 * Errors: those of hrbfnpr_drawing_rasterize; INVALID_ARGUMENT, too, if the image is too small. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_rasterize(const hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing,
                                                     const hrbfnpr_camera* camera, const hrbfnpr_image* image,
                                                     hrbfnpr_error* error);

/* The paper and the pens with which a drawing is written. */
typedef struct hrbfnpr_picture_page_desc {
    uint32_t struct_size;
    uint32_t reserved;
    const hrbfnpr_page_desc* page; /* format, flags, tolerance, speeds, pens and the like; default NULL = its defaults.
                                      The call sets items, annotations and size, and title, description and metadata
                                      where they are NULL */
    const char* paper;             /* paper that the drawing fills, turned as it fits better: "a0" .. "a6", "letter",
                                      "legal", "tabloid", or width and height in mm, such as "210x297"; default NULL = a
                                      pixel is 25.4 / 96 mm */
    double paper_margin;           /* free margin on each side of the paper, in mm; 0 or more; default 10 */
    hrbfnpr_array pen_widths;      /* widths of the pens at hand, in mm, ascending; n x 1, FLOAT64; not given = `page`
                                      says.  Each group gets the pen nearest to the median width of its lines */
} hrbfnpr_picture_page_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_page_desc_init(hrbfnpr_picture_page_desc* desc, uint32_t struct_size);
/* Writes the plate of a picture as vectors.  `camera` is the camera that the drawing was made with; NULL = the planned
 * camera.  `desc`, `info` and `operation` may be NULL.  The picture gets notes PENS and PLOTTED.
 * Errors: those of hrbfnpr_page_write; INVALID_ARGUMENT, too, for a paper that is not known or has no room. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_write(hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing,
                                                 const hrbfnpr_camera* camera,
                                                 const hrbfnpr_picture_page_desc* desc, hrbfnpr_write_fn write,
                                                 void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation,
                                                 hrbfnpr_error* error);

/* ---- Settings: a descriptor as JSON --------------------------------------------- */

/* Reads settings that hrbfnpr_picture_write_settings or the viewer wrote. docs/settings.md describes the format.
 * Errors: IO (`read` failed), INVALID_ARGUMENT (the message names the key and says what would be right),
 * OUT_OF_MEMORY. */
HRBFNPR_API hrbfnpr_status hrbfnpr_settings_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
                                                 hrbfnpr_settings** out_settings, hrbfnpr_error* error);
/* Adds a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_settings_retain(const hrbfnpr_settings* settings);
/* Releases a reference.  Any thread may call it; NULL is ignored. */
HRBFNPR_API void hrbfnpr_settings_release(const hrbfnpr_settings* settings);
/* Writes what a picture was made with.  The picture gets a note NOT_IN_SETTINGS about what settings do not hold.
 * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY), IO (`write` failed), OUT_OF_MEMORY. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_write_settings(hrbfnpr_picture* picture, hrbfnpr_write_fn write,
                                                          void* user, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 16  SHEETS: technical drawings in several views, to scale
 * ==========================================================================
 *
 * A sheet has orthographic views and sections of a model, with the line conventions of ISO 128: outlines are thick,
 * hidden edges are thin and dashed, cut faces are hatched.  Views stand around the front view [ISO 5456-2].  Sections
 * follow at the right, or below if they are seen from above.  Where lines coincide, the first in this order is drawn:
 * outlines of cuts, visible edges, hidden edges, smooth edges [ISO 128-2].  The sheet has a frame [ISO 5457], a title
 * block [ISO 7200] without a date, a scale bar, and arrows and letters at each cutting plane [ISO 128-3].
 *
 * The model stands along the up axis of its picture.  Its front is +z, or -y where z is up.  Contours and outlines of
 * cuts are curves of the surface.  Sharp edges are those of the model, or of the mesh that it was fitted to.
 *
 * Layers of the page have the name of their kind of lines and of their view, such as "outlines front", "hidden top" or
 * "hatching A-A".  For plotters, pen 1 is the wide pen and pen 2 the fine one. docs/technical.md shows sheets.
 */

/* Options of a sheet. */
enum {
    HRBFNPR_VIEWS_CENTRE_LINES = 1, /* draws a centre line for each plane of symmetry through the middle, in each view
                                       that sees the plane as a line.  A note NO_SYMMETRY says that there is no such
                                       plane */
    HRBFNPR_VIEWS_LABELS = 2,       /* writes the name of each view above it.  Sections always have their names */
    HRBFNPR_VIEWS_UNIT_IS_METRE = 4, /* says that the format of the source is in metres, as glTF is.  A unit_mm of 0
                                        then means 1000, and a note UNIT_IS_METRE says so */
    HRBFNPR_VIEWS_VERIFY = 8         /* compares all drawn lines with rays, and repairs wrong pieces.
                                        hrbfnpr_views_info, a note LINES_VERIFIED and, unless `page` has one, the page's
                                        description have the counts */
};

/* Where views stand [ISO 5456-2]. */
enum {
    HRBFNPR_VIEWS_ANGLE_FIRST = 0, /* first angle: the left view stands at the right, the top view below */
    HRBFNPR_VIEWS_ANGLE_THIRD = 1  /* third angle: the left view stands at the left, the top view above */
};

/* How hidden edges are drawn.  Sections never have hidden edges [ISO 128-3]. */
enum {
    HRBFNPR_VIEWS_HIDDEN_DASHED = 0, /* hidden edges are dashed thin lines */
    HRBFNPR_VIEWS_HIDDEN_NONE = 1,   /* hidden edges are not drawn */
    HRBFNPR_VIEWS_HIDDEN_SHOWN = 2   /* hidden edges are continuous thin lines */
};

/* How tangent edges are drawn, along which two surfaces of a part touch without a kink, such as those of a fillet.
 * They are continuous thin lines; hidden ones are not drawn. */
enum {
    HRBFNPR_VIEWS_TANGENT_SHORT = 0, /* tangent edges end three widths of an outline before the lines that they would
                                        touch, as ISO 128-3 asks of the lines of rounded edges; short ones end a quarter
                                        of their length before */
    HRBFNPR_VIEWS_TANGENT_THIN = 1,  /* tangent edges go up to the lines that they touch */
    HRBFNPR_VIEWS_TANGENT_NONE = 2   /* tangent edges are not drawn */
};

/* A sheet of views.  Texts are UTF-8, and are read during the call only. */
typedef struct hrbfnpr_views_desc {
    uint32_t struct_size;
    uint32_t flags;       /* HRBFNPR_VIEWS_...; default 0 */
    uint32_t projection;  /* where views stand, HRBFNPR_VIEWS_ANGLE_...; default FIRST */
    uint32_t hidden;      /* how hidden edges are drawn, HRBFNPR_VIEWS_HIDDEN_...; default DASHED */
    const char* views;    /* names of views with commas between: front, back, left, right, top, bottom, iso; each is
                             drawn once; default NULL = "front,left,top,iso", or "front,right,top,iso" with
                             ANGLE_THIRD */
    const char* sections; /* cutting planes with semicolons between: "z:20" cuts at z = 20, "z" through the middle,
                             "1:1:0:5" at x + y = 5; default NULL = none. "+z:20" is seen from above and "-z:20" from
                             below.  An axis without a sign is seen from the front, from above, or from the side that is
                             drawn.  Sections are called A-A, B-B and so on */
    const char* paper;    /* paper: "a0" .. "a6", "letter", "legal" or "tabloid", in landscape format, or width and
                             height in mm, such as "297x210"; default NULL = "auto" = the smallest of a4 to a0 that has
                             room at the scale, or a3 if the scale is "auto", too */
    const char* scale;    /* scale, such as "1:2" for half the size; default NULL = "auto" = the largest of 1, 2 and 5
                             times a power of ten that has room on the paper [ISO 5455] */
    const char* smooth;   /* thin lines where the surface bends without an edge, as kinds with commas between: ridges,
                             valleys, suggestive; default NULL = "none" */
    const char* title;    /* title in the title block; default NULL; NULL and "" = `model` without the ending of its
                             name */
    const char* model;    /* name of the file in the title block; default NULL; NULL and "" = the name of the picture's
                             source */
    double unit_mm;       /* mm of a unit of the model, above 0, up to 1e9; default 0 = 1, or 1000 with UNIT_IS_METRE */
    double crease_angle;  /* angle between two faces of a mesh, in degrees, above which their edge is sharp; above 0, up
                             to 1e9; default 30.  Larger: fewer edges */
    double line_width;    /* width of outlines, in mm; thin lines are half as wide; 0.01 .. 1000; default 0.5 */
    double hatch_spacing; /* distance between the lines in cut faces, in mm; 0.01 .. 1000; default 3 */
    double spacing;       /* free space between views, in mm; above 0, up to 1e9; default 15 */
    const hrbfnpr_page_desc* page; /* format, flags, tolerance, speeds and the like; default NULL = its defaults with a
                                      tolerance of 0.02.  The call sets items, annotations, pens and size, and title and
                                      description where they are NULL */
    uint32_t tangent;     /* how tangent edges are drawn, HRBFNPR_VIEWS_TANGENT_...; default SHORT */
    uint32_t reserved;
} hrbfnpr_views_desc;

/* Sets struct_size and all defaults. */
HRBFNPR_API hrbfnpr_status hrbfnpr_views_desc_init(hrbfnpr_views_desc* desc, uint32_t struct_size);

/* The sheet that was written. */
typedef struct hrbfnpr_views_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t views;       /* number of views and sections */
    int64_t bytes;       /* bytes that were written */
    double width;        /* width of the page, in mm */
    double height;       /* height of the page, in mm */
    double scale;        /* scale as a number: 0.5 for 1:2 */
    double unit_mm;      /* mm of a unit of the model, as used */
    char scale_text[64]; /* scale in words, such as "1:2" */
    char paper[64];      /* paper, such as "a3" or "297 x 210" */
    int64_t pieces;      /* with VERIFY, drawn pieces of lines that rays were compared with */
    int64_t agreeing;    /* pieces whose decided rays all agree with the drawing */
    int64_t undecided;   /* pieces without a decided ray: they are within 0.05 mm of an edge, in the view or in depth */
    int64_t repaired;    /* pieces that were divided, or drawn otherwise, because rays disagreed */
} hrbfnpr_views_info;

/* Sets struct_size; all other fields are 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_views_info_init(hrbfnpr_views_info* info, uint32_t struct_size);

/* Writes a sheet of views of a picture's parts, which must have models.  A picture made with SURFACE_ONLY is enough,
 * and its models have the cavities of meshes; others may need SOLIDS as `parts`.  `desc`, `info` and `operation` may be
 * NULL.  The picture gets stages LINES and VIEWS, and notes UNIT_IS_METRE, NO_SYMMETRY, SECTION_OPEN and
 * LINES_VERIFIED.
 * Errors: INVALID_ARGUMENT (a picture of a point set; a text that is not understood; a plane that misses the model;
 * views that have no room on the paper at the scale: the message names a scale or paper with room), and those of
 * hrbfnpr_line_set_create, hrbfnpr_renderer_draw and hrbfnpr_page_write. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_write_views(hrbfnpr_picture* picture, const hrbfnpr_views_desc* desc,
                                                       hrbfnpr_write_fn write, void* user, hrbfnpr_views_info* info,
                                                       hrbfnpr_operation* operation, hrbfnpr_error* error);

#ifdef __cplusplus
}
#endif

#endif /* HRBFNPR_H */
