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
 *   exception: if one of the calls evaluate, project, curvature, cast_rays and
 *   contains fails or is cancelled, it may already have written a part of its
 *   arrays.
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
 *   stays in memory.  Callbacks run only on the thread that called the library,
 *   unless they are flagged thread-safe.  No call changes the caller's
 *   floating-point state, locale or OpenMP settings.
 *
 * Stacks.  Every call except hrbfnpr_model_fit, hrbfnpr_model_fit_mesh and
 *   hrbfnpr_orient runs on a thread stack of 64 KiB; 12 KiB of them are for the
 *   caller's own frames and callbacks.  These three calls need 512 KiB on the
 *   calling thread and, with `run_tasks`, on the threads that run their tasks.
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
    char message[248];     /* UTF-8, zero-terminated; a longer message is cut between two characters */
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

/* How the linear system of a fit is solved.  docs/fitting.md gives times and memory. */
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

/* What to fit: N points with N outward normals, and how.  docs/fitting.md
 * explains the methods.
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
                                           fewer iterations and a longer setup */
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
 * be wrong.  docs/fitting.md explains the method.
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
 * docs/fitting.md explains the method. */
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
    double bounds_min[3];     /* lower corner of the samples' box.  For up to 20 000 samples along curves, the box also
                                 holds the surface, if that closes within a third of a diagonal around the samples */
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
    HRBFNPR_PROJECTION_NOT_FINITE = 3     /* f or its gradient is not finite, or the gradient is longer than 1e150 */
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
 * origins:      n x 3, FLOAT32 or FLOAT64, finite
 * directions:   n x 3, FLOAT32 or FLOAT64, finite, of any length but 0
 * desc:         NULL = all defaults
 * hits:         the arrays that receive the results
 * operation:    may be NULL
 *
 * Errors: INVALID_ARGUMENT: NaN, infinity, a zero direction, different counts of
 * origins and directions, or a direction so short that the t of a hit is infinite. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_cast_rays(const hrbfnpr_model* model, const hrbfnpr_array* origins,
                                                   const hrbfnpr_array* directions, const hrbfnpr_cast_desc* desc,
                                                   hrbfnpr_ray_hits* hits, hrbfnpr_operation* operation,
                                                   hrbfnpr_error* error);

/* Computes the bound on |grad f| that hrbfnpr_model_cast_rays uses if none is given.
 * For a solid of primitives it is a true bound (hrbfnpr_csg_info.lipschitz).  For other
 * models it is an estimate: 1.5 times the largest |grad f| at 24^3 points of the search
 * box.  A program that casts few rays in each call should ask for the bound once and
 * pass it on, because each call without it evaluates these points.
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
 * another way (docs/lines.md gives the formula).  Trimming looks at the connected
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
    HRBFNPR_DENSITY_CALLBACK = 2   /* the density of density_function */
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
    uint32_t box_resolution; /* R: number of cells of BOX along the longest side of the bounds; 1 to 256; default 8
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
    int64_t bytes;          /* memory that the set keeps */
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
 * 8  LINE SET: what the lines of a surface are drawn from, immutable
 * ==========================================================================
 *
 * Contours as curves, traced on the surface itself for every camera, with a
 * visibility that is counted and checked (Appel 1967, quantitative
 * invisibility; Benard & Hertzmann 2019).  A line set is made once for a model;
 * an item that has one, and a style with lines, is drawn with curves in the
 * place of contour marks.
 */

typedef struct hrbfnpr_line_set hrbfnpr_line_set;

/* Kinds of lines.  Those marked "once" are found when a line set is made, for each element of its list; the others
 * with every drawing.  Strengths have no unit: lengths are in diagonals of the model. */
enum {
    HRBFNPR_LINE_KIND_CONTOUR = 1,            /* occluding contours: the line of sight is tangent to the surface */
    HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR = 2, /* where a contour would appear soon; strength: the derivative of the
                                                 radial curvature towards the eye; WITH_CURVATURE [DeCarlo 2003] */
    HRBFNPR_LINE_KIND_RIDGE = 3,              /* once; strength: curvature across the ridge less that along it
                                                 [Ohtake, Belyaev & Seidel 2004] */
    HRBFNPR_LINE_KIND_VALLEY = 4,             /* once; the same */
    HRBFNPR_LINE_KIND_APPARENT_RIDGE = 5,     /* strength: view-dependent curvature; WITH_CURVATURE [Judd 2007] */
    HRBFNPR_LINE_KIND_PARABOLIC = 6,          /* once; Gaussian curvature 0 */
    HRBFNPR_LINE_KIND_ISOPHOTE = 7,           /* n . l = the levels of the style, l its light; WITH_CURVATURE */
    HRBFNPR_LINE_KIND_SECTION = 8,            /* once; parallel planes */
    HRBFNPR_LINE_KIND_BORDER = 9,             /* where the surface ends: at the search box, or beyond the last samples
                                                 (hrbfnpr_line_set_desc.support) */
    HRBFNPR_LINE_KIND_OWN = 10,               /* once; polylines of the caller, such as creases of a mesh */
    HRBFNPR_LINE_KIND_CREASE = 11             /* where smooth sheets of the surface meet, of models that have such edges;
                                                 found with the line set, in no list.  Strength: the angle between the
                                                 sheets' normals, degrees.  Where one of them faces the eye and the
                                                 other does not, a crease is a part of the CONTOUR and drawn as that */
};

/* Lines to find once. */
typedef struct hrbfnpr_line_desc {
    uint32_t struct_size;
    uint32_t kind;     /* HRBFNPR_LINE_KIND_RIDGE, VALLEY, PARABOLIC, SECTION or OWN; RIDGE */
    const char* name;  /* up to 63 bytes of UTF-8, for styles; NULL = "" */
    double lower;      /* lines go on while their strength is at least `lower` ... */
    double upper;      /* ... and are kept if it is `upper` somewhere; 0 and 0 = those of the kind: 6 and 15 of ridges
                          and valleys, 0 and 0 else */
    double shortest;   /* shorter ones are dropped, in diagonals; 0.01 */
    double plane[3];   /* of SECTION: normal of the planes, of any length; (0, 0, 1) */
    hrbfnpr_array levels; /* of SECTION: FLOAT64, 1: where the planes are, along the unit normal */
    hrbfnpr_array position; /* of OWN: FLOAT32 or FLOAT64, 3: on the surface or near it */
    hrbfnpr_array line_first; /* of OWN: UINT32, 1: the first position of each line, ascending, and the end; one whose
                                 last position is its first is closed */
} hrbfnpr_line_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_line_desc_init(hrbfnpr_line_desc* desc, uint32_t struct_size);

enum {
    HRBFNPR_LINE_SET_WITH_CURVATURE = 1 /* measure curvatures and their derivatives, for kinds that need them with
                                           every drawing */
};

typedef struct hrbfnpr_line_set_desc {
    uint32_t struct_size;
    uint32_t flags; /* HRBFNPR_LINE_SET_WITH_...; 0 */
    double cell_size; /* of the mesh on which curves are looked for, units of the model; 0 = half the samples'
                         spacing, and finer where walls are thin.  Loops that are smaller, and walls that are
                         thinner than 1.75 cells, may be missed */
    hrbfnpr_array seed_points; /* FLOAT32 or FLOAT64, 3: near each part of the surface; not given = the samples,
                                  or places found in the bounds of a custom model */
    const hrbfnpr_line_desc* lines; /* a list; NULL and 0 */
    int64_t line_count;
    int64_t line_stride;
    double support; /* where the surface ends for want of samples, as an open scan or a terrain does: where s(x),
                       as of hrbfnpr_trim_desc, exceeds this.  Mesh, curves, and what hides them end there, and the
                       end is a border.  1.5 ends it some 0.7 spacings beyond the last samples, 3 some 0.9, and leaves
                       larger holes closed.  0 = it ends at the search box only; 0 or more, 0 */
    hrbfnpr_array support_points; /* FLOAT32 or FLOAT64, 3: those samples; not given = the model's centres.  All
                                     points of a scan tell better where it ends than the centres chosen from them */
    hrbfnpr_array support_normals; /* FLOAT32 or FLOAT64, 3: of support_points, as many, of any length; not given =
                                      the surface's own there */
} hrbfnpr_line_set_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_line_set_desc_init(hrbfnpr_line_set_desc* desc, uint32_t struct_size);

/* The line set keeps the model.  desc NULL = defaults.
 * Errors: INVALID_ARGUMENT (more than 4 000 000 triangles: a larger cell_size; a support without samples),
 * NOT_CONVERGED (no surface was found, or none near its samples), OUT_OF_MEMORY, CANCELLED, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_line_set_create(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                   const hrbfnpr_line_set_desc* desc, hrbfnpr_operation* operation,
                                                   hrbfnpr_line_set** out_line_set, hrbfnpr_error* error);
HRBFNPR_API void hrbfnpr_line_set_retain(const hrbfnpr_line_set* line_set);  /* any thread; NULL is ignored */
HRBFNPR_API void hrbfnpr_line_set_release(const hrbfnpr_line_set* line_set); /* any thread; NULL is ignored */

typedef struct hrbfnpr_line_set_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t triangles;    /* of the mesh */
    int64_t turned;       /* of these, triangles that look away from the surface: it is finer than the cells there,
                             and curves may be missed */
    int64_t missed_seeds; /* seeds that no triangle is near: a part of the surface is too thin for the cells */
    int64_t lines;        /* that were found once, of all elements of the list */
    int64_t borders;      /* curves where the surface ends */
    double cell_size;     /* as used */
    double seconds;       /* that it took to make */
    int64_t bytes;        /* kept */
    double left_out;      /* the share of the area that was looked at that lies beyond the samples, 0 to 1; 0 without
                             support.  Of a trimmed model little beyond its end is looked at: see its trim info */
    int64_t creases;      /* curves where sheets of the surface meet, at any angle: from corner to corner, or closed */
} hrbfnpr_line_set_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_line_set_info_init(hrbfnpr_line_set_info* info, uint32_t struct_size);
HRBFNPR_API hrbfnpr_status hrbfnpr_line_set_get_info(const hrbfnpr_line_set* line_set, hrbfnpr_line_set_info* info,
                                                     hrbfnpr_error* error);

/*
 * ==========================================================================
 * 9  CAMERA AND STYLE: plain data
 * ==========================================================================
 */

/* Range of window depth from near to far plane. */
enum {
    HRBFNPR_DEPTH_NEGATIVE_ONE_TO_ONE = 0, /* clip space of OpenGL; written depth is 0 .. 1 */
    HRBFNPR_DEPTH_ZERO_TO_ONE = 1,         /* Direct3D, Vulkan, Metal */
    HRBFNPR_DEPTH_REVERSED = 2             /* 1 at the near plane, 0 at the far plane */
};

typedef struct hrbfnpr_camera {
    uint32_t struct_size;
    uint32_t depth_convention; /* HRBFNPR_DEPTH_...; of `projection` and of depth buffers */
    double view[16];           /* world to eye, column-major; the eye looks along -z */
    double projection[16];     /* eye to clip */
    double viewport[4];        /* x, y of the top-left corner, width, height, in pixels */
} hrbfnpr_camera;

/* Identity matrices, viewport 0 x 0 (which _draw refuses). */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_init(hrbfnpr_camera* camera, uint32_t struct_size);
/* Sets `view`: from eye towards target, up roughly along `up`; 3 doubles each.
 * INVALID_ARGUMENT if eye = target or up is parallel to the view. */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_look_at(hrbfnpr_camera* camera, const double* eye,
                                                  const double* target, const double* up,
                                                  hrbfnpr_error* error);
/* Sets `projection` and the viewport's size.  vertical_angle in radians, in
 * (0, pi); 0 < near_plane < far_plane. */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_perspective(hrbfnpr_camera* camera, double vertical_angle,
                                                      double width, double height, double near_plane,
                                                      double far_plane, hrbfnpr_error* error);
/* Sets `projection` and the viewport's size; `view_height` is the height of
 * the visible slab in world units; near_plane < far_plane, either sign. */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_orthographic(hrbfnpr_camera* camera, double view_height,
                                                       double width, double height, double near_plane,
                                                       double far_plane, hrbfnpr_error* error);
/* Sets view, projection and viewport so that the box fills the picture but for
 * `margin` (share of the picture on each side, 0 .. 0.45), seen along
 * `direction` (from the eye into the scene).  vertical_angle 0 = orthographic. */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_fit_bounds(hrbfnpr_camera* camera, const double* bounds_min,
                                                     const double* bounds_max, const double* direction,
                                                     const double* up, double vertical_angle,
                                                     double width, double height, double margin,
                                                     hrbfnpr_error* error);

/* The same for n x 3 points, FLOAT32 or FLOAT64, n >= 1: the points themselves
 * fill the picture, not the corners of their box, and lie in its middle.
 * `origin` (3 doubles, NULL = 0) is added to each: with a point set's POSITION
 * give its info's origin. */
HRBFNPR_API hrbfnpr_status hrbfnpr_camera_fit_points(hrbfnpr_camera* camera, const hrbfnpr_array* points,
                                                     const double* origin, const double* direction, const double* up,
                                                     double vertical_angle, double width, double height,
                                                     double margin, hrbfnpr_error* error);

enum {
    HRBFNPR_HIDDEN_LINES_ATTENUATE = 0, /* seen faintly through the surface in front [NPAR 6.1] */
    HRBFNPR_HIDDEN_LINES_HIDE = 1,      /* marks behind a nearer depth layer are not drawn */
    HRBFNPR_HIDDEN_LINES_SHOW = 2       /* as if nothing were in front (lambda = 0) */
};

enum {
    /* Each mark of ink is seen through the depth layers of surface in front of it, which are found
     * from the marks: its opacity is multiplied by their transmittance.  A depth layer never dims its
     * own ink, and the picture does not depend on the number of marks. */
    HRBFNPR_VISIBILITY_DEPTH_LAYERS = 0,
    /* As published: marks paint discs of paper and of ink, from far to near [NPAR 6.1]. */
    HRBFNPR_VISIBILITY_PUBLISHED = 1
};

enum {
    /* The coverage of the drawing is the tone that was asked for, 1 - tau: the number of marks
     * follows from their size, their density on the screen and how they overlap, so that the
     * tone stays when the zoom or the budget changes.  Where all marks together cover less than
     * 0.6, the tone 0.6 shows all of them and the others are paler alike. */
    HRBFNPR_TONE_CURVE_COVERAGE = 0,
    HRBFNPR_TONE_CURVE_LINEAR = 1 /* the share of marks is 1 - tau [NPAR 6.2] */
};

enum {
    HRBFNPR_TONE_NONE = 0,    /* tau = 0: all front marks are shown */
    HRBFNPR_TONE_LIGHT = 1,   /* tau = max(0, n . l)^tone_exponent [NPAR 6.2], and fill_light */
    HRBFNPR_TONE_CALLBACK = 2 /* tau from tone_function */
};

enum {
    /* A front mark is shown if u >= 1 - (1 - tau) * tau_d * scale * share: all effects thin
     * one and the same order of marks, so that a blue-noise order stays one. */
    HRBFNPR_TONE_RULE_SHARE = 0,
    /* As published, test by test: u >= tau, u < tau_d, u < scale, u < share. */
    HRBFNPR_TONE_RULE_PUBLISHED = 1
};

enum { HRBFNPR_LIGHT_WORLD = 0, HRBFNPR_LIGHT_CAMERA = 1 };

/* Any illumination model: fills tau (count, 1 = light, 0 = dark; clamped to
 * [0,1], NaN is CALLBACK) from world positions and unit normals (count x 3
 * each; TONE_NORMAL where there are any).  Runs on the thread that called _draw.  Non-zero fails it. */
typedef int32_t (*hrbfnpr_tone_fn)(void* user, int64_t count, const float* positions,
                                   const float* normals, float* tau);

/* How the front marks of a layer of strokes are drawn.  Layers without strokes are dots; so is everything with
 * VISIBILITY_PUBLISHED. */
enum {
    HRBFNPR_SHAPE_DOTS = 0,    /* each mark is a dot */
    HRBFNPR_SHAPE_STROKES = 1, /* marks that follow each other along a stroke, and are shown, are one line whose width
                                  and opacity are theirs; a single one is a dot */
    HRBFNPR_SHAPE_HATCH = 2    /* strokes are curves, drawn where the tone is dark enough, and their width makes the
                                  tone: hatch_... of hrbfnpr_layer_style.  Of nested lines (those of level k midway
                                  between those of lower levels) as many levels are drawn as the picture has room for,
                                  so that the tone does not depend on the zoom.  Points of lines have the id of the
                                  nearest mark; a stroke whose ends meet is closed.
                                  [Winkenbach & Salesin 1994; Praun et al. 2001] */
};

/* How layers are drawn.  Colours are straight RGBA in [0,1], sRGB-encoded. */
typedef struct hrbfnpr_layer_style {
    uint32_t struct_size;
    uint32_t kind;      /* the layers that this is for: HRBFNPR_LAYER_KIND_...; ANY */
    const char* name;   /* ... and are called so; NULL = any name.  Read during _draw only */
    uint32_t shown;     /* 1 or 0: whether front marks are drawn; 1 */
    uint32_t contours;  /* 1 or 0, with VISIBILITY_PUBLISHED: whether marks near a contour draw it; 1.  Not of OWN
                           strokes, which may be few */
    uint32_t directions; /* of strokes: bit 0 the first direction, bit 1 the second; 3 */
    uint32_t shape;     /* HRBFNPR_SHAPE_...; DOTS */
    float share;        /* 0 .. 1: share of the layer's marks that is used at all; 1 */
    float radius;       /* of a mark, half the width of a stroke, pixels, > 0; 1 */
    float radius_zoom;  /* 0: radius is in pixels at any zoom; 1: grows with the zoom; between; 0 */
    uint32_t reserved;
    float ink[4];       /* black */
    /* Of SHAPE_HATCH.  Darkness is 1 - tau, 0 .. 1; the share of the paper that the lines cover grows with it, times
       `share`.  Lines whose separation is not known have the width 2 * radius where that share is the greatest. */
    float hatch_tone_begin;     /* darkness from which on there are lines, 0 .. 1; 0.15 */
    float hatch_tone_end;       /* darkness from which on they get no wider, > hatch_tone_begin, to 1; 0.95 */
    float hatch_coverage_begin; /* > 0, to 1: share covered at hatch_tone_begin; 0.1 */
    float hatch_coverage_end;   /* > 0, to 1: share covered at hatch_tone_end; 0.82 */
    float hatch_spacing;        /* least from line to line, pixels, > 0; 4.6 */
    float hatch_pen;            /* least width of a line, pixels, > 0; 0.6.  Less only where lines fade in or end, or are
                                   closer together than hatch_spacing */
    float hatch_white;          /* left between lines at least, pixels, 0 or more; 1.2 */
    float hatch_taper;          /* over which a line narrows where it ends by its tone, pixels, 0 or more; 20.  Where it
                                   ends for another reason it is shorter */
    float hatch_shortest;       /* pieces below this are not drawn, those up to twice of it are thinner; pixels, 0 or
                                   more; 10 */
    uint32_t reserved2;
    float hatch_wobble;         /* how far a line may stray to either side, as of an unsteady hand, in hatch_pens, 0 ..
                                   16; 0.  From swing to swing it is about 60 hatch_pens */
    float hatch_overshoot;      /* lines run on past the tone that they end at by up to this, each by another length;
                                   pixels, 0 or more; 0 */
    uint32_t hatch_seed;        /* of the two above: any number; 0 */
    uint32_t reserved3;
} hrbfnpr_layer_style;

HRBFNPR_API hrbfnpr_status hrbfnpr_layer_style_init(hrbfnpr_layer_style* style, uint32_t struct_size);

/* What is drawn of the parts of a line that surface hides. */
enum {
    HRBFNPR_HIDDEN_PARTS_NONE = 0,
    HRBFNPR_HIDDEN_PARTS_ATTENUATED = 1, /* paler with each layer of surface (two sheets) before them */
    HRBFNPR_HIDDEN_PARTS_DASHED = 2,     /* dashes, the shorter the more layers lie before them */
    HRBFNPR_HIDDEN_PARTS_SHOWN = 3       /* like what is visible */
};

/* How a line ends where it ends in the picture without meeting another: at a cusp, where it turns behind its own
 * surface. */
enum {
    HRBFNPR_CAP_ROUND = 0,
    HRBFNPR_CAP_FLAT = 1,
    HRBFNPR_CAP_POINTED = 2 /* narrowing to a tip; the tip's length is twice the width there */
};

/* Creases by the way that the surface bends there. */
enum {
    HRBFNPR_CREASES_ALL = 0,
    HRBFNPR_CREASES_CONVEX = 1, /* edges */
    HRBFNPR_CREASES_CONCAVE = 2 /* grooves, and where something stands on a face */
};

/* How the lines of one kind are drawn, of items that have a line set.  Lengths are in pixels. */
typedef struct hrbfnpr_line_style {
    uint32_t struct_size;
    uint32_t kind;        /* HRBFNPR_LINE_KIND_...; CONTOUR */
    const char* name;     /* of lines found once: those that are called so; NULL = any name.  Read during _draw only */
    uint32_t hidden;      /* HRBFNPR_HIDDEN_PARTS_...; NONE */
    uint32_t cap;         /* HRBFNPR_CAP_...: of free ends; ROUND */
    float width;          /* > 0; 2 */
    float taper;          /* over which a line narrows to a free end, half an ellipse; 0 = not at all; 12.  A part with
                             a free end that is shorter than two tapers is the thinner, the shorter it is */
    float hidden_width;   /* of ATTENUATED and DASHED, > 0; 1.2 */
    float hidden_opacity; /* 0 .. 1: of ATTENUATED, for each layer; 0.35 */
    float dash;           /* of DASHED, in hidden_widths, > 0; 5 */
    float gap;            /* between dashes, in hidden_widths, > 0; 3 */
    float shortest;       /* parts with a free end, and hidden ones, that are shorter are not drawn; 2.  Feature lines
                             that are found with every drawing measure 0.01 diagonals or more */
    float fade;           /* 0 .. 1: how much paler a line is where its strength is `lower` than where it is `upper`; 1 */
    double lower;         /* strengths as in hrbfnpr_line_desc; 0 and 0 = those of the kind: 10 and 30 of suggestive
                             contours, 12 and 25 of apparent ridges, 15 and 30 (degrees) of creases */
    double upper;
    hrbfnpr_array levels; /* of ISOPHOTE: FLOAT64, 1: -1 .. 1.  Read during _draw only */
    float ink[4];         /* straight RGBA; black */

    /* Laws of the width: factors, 0 .. 16, of which all that apply to a place are multiplied; 1 = no effect.  By depth,
     * light and radial curvature goes the distance between a contour and an isophote [Goodwin et al. 2007]. */
    float outline_factor;   /* of CONTOUR and BORDER, where nothing lies beside the line on its outer side: the outline of
                               all items that have lines.  Falls to 1 over 6 widths beyond its ends; 1 */
    float far_factor;       /* at the farthest place in the viewport of lines that are drawn, hidden ones too; 1 at the
                               nearest, evenly by depth between; 1 */
    float lit_factor;       /* where the surface faces the style's light, whatever its tone; 1 where it faces away,
                               evenly by n . l between; 1 */
    float curvature_factor; /* where the surface bends sharply; 1 where its radius of curvature is curvature_radius or
                               more, evenly by the radius between.  Of CONTOUR the radial curvature, along the line of
                               sight; of others the normal curvature across the line; 1 */
    float curvature_radius; /* diagonals, > 0; 0.1 */

    /* An unsteady hand, the same in each drawing and, as the lengths are in widths, at each size of the picture. */
    float wobble;         /* how far a line may stray to either side, widths, 0 .. 16; 0 */
    float wobble_width;   /* 0 .. 1: the share by which its width may vary; 0 */
    float wobble_length;  /* from swing to swing, about, widths, >= 1; 40 */
    uint32_t wobble_seed; /* 0 */
    uint32_t creases;     /* of CREASE: HRBFNPR_CREASES_...; ALL */
} hrbfnpr_line_style;

HRBFNPR_API hrbfnpr_status hrbfnpr_line_style_init(hrbfnpr_line_style* style, uint32_t struct_size);

typedef struct hrbfnpr_style {
    uint32_t struct_size;
    uint32_t tone;               /* HRBFNPR_TONE_...; LIGHT */
    float paper[4];              /* straight RGBA; alpha 0 = transparent; white.  One for all styles of a drawing */
    const hrbfnpr_layer_style* layers; /* a list: a layer of marks takes the first that is for it, or the
                                          defaults of _layer_style_init; NULL and 0 */
    int64_t layer_count;
    int64_t layer_stride;

    /* Tone. */
    uint32_t tone_rule;          /* HRBFNPR_TONE_RULE_...; SHARE */
    uint32_t tone_curve;         /* HRBFNPR_TONE_CURVE_...; COVERAGE.  For TONE_RULE_SHARE */
    double light[3];             /* towards the light, normalised on use; (-0.4, 0.6, 0.7) */
    double tone_exponent;        /* lambda of the tone law, > 0; 1 */
    hrbfnpr_tone_fn tone_function; /* for CALLBACK */
    void* tone_user;
    uint32_t light_space;        /* HRBFNPR_LIGHT_...; CAMERA */
    float tone_fade;             /* 0 .. 1, DEPTH_LAYERS: a mark grows from nothing to its full area over this
                                    share of the marks shown, instead of popping; 0 = it pops; 0.25 */

    /* Contours that marks draw, with VISIBILITY_PUBLISHED only.  With DEPTH_LAYERS contours are lines of an item's
     * line set. */
    double silhouette_threshold; /* delta in (0,1): front n.v < -delta, back n.v > delta, else
                                    silhouette, v from the camera to the mark [NPAR 6]; 0.2 */
    float silhouette_radius;     /* of a mark, pixels; 1 */
    float silhouette_radius_zoom; /* as radius_zoom; 0 */
    float silhouette_ink[4];     /* black */

    /* Hidden lines. */
    uint32_t visibility;         /* HRBFNPR_VISIBILITY_...; DEPTH_LAYERS.  One for all styles of a drawing */
    uint32_t hidden_lines;       /* HRBFNPR_HIDDEN_LINES_...; ATTENUATE */
    double attenuation_front;    /* lambda of alpha_f = nu^2 lambda; 1 */
    double attenuation_back;     /* lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda; 1 */
    float splat_radius;          /* of the piece of surface that a mark stands for, pixels; 0 = from the
                                    marks' spacing on the screen */
    float splat_overlap;         /* n > 0: a depth layer is as opaque as n overlapping splats of opacity alpha,
                                    1 - (1 - alpha)^n, whatever the marks' density and the zoom; 0: each
                                    mark paints with alpha itself, as published; 8 */
    float halo_width;            /* DEPTH_LAYERS: how far beyond its contour a surface hides what lies
                                    behind, pixels at any zoom.  PUBLISHED: how much wider the paper of
                                    back marks is, pixels; 2 */
    uint32_t reserved;

    /* Distance and zoom. */
    double depth_min;      /* distance from the camera where depth attenuation starts, > 0 */
    double depth_max;      /* ... and where nothing is shown any more; 0 and 0 = off (default) */
    double zoom_reference; /* pixels per world unit at which marks are shown in full; 0 = off.
                              Below it the chance to be shown is scale = zoom^zoom_exponent,
                              exponential in the zoom level ln zoom; the area of the paper
                              of back marks scales alike [NPAR 6.2] */
    double zoom_exponent;  /* >= 0; 2 keeps the ink per area */

    /* Lines, with DEPTH_LAYERS, of items that have a line set. */
    const hrbfnpr_line_style* lines; /* a list; NULL and 0 */
    int64_t line_count;
    int64_t line_stride;

    /* Of TONE_LIGHT, DEPTH_LAYERS and TONE_RULE_SHARE: 0 .. 1, light from the side opposite to `light`, so that what
     * is turned away keeps its form: tau = fill_light * (n . l)^2 where n . l < 0.  The lit side stays as it is;
     * 0.25 */
    float fill_light;
    uint32_t reserved2;
} hrbfnpr_style;

HRBFNPR_API hrbfnpr_status hrbfnpr_style_init(hrbfnpr_style* style, uint32_t struct_size);

/* Named styles, each with a picture in docs/presets.md.  bindings/generate writes this list from bindings/presets.py. */
enum {
    HRBFNPR_PRESET_STIPPLE = 0,             /* stipples by light, no contours */
    HRBFNPR_PRESET_HATCH = 1,               /* lines of one width, more of them where it is darker, and contours */
    HRBFNPR_PRESET_CROSS_HATCH = 2,         /* up to three sets of such lines, at 0, 35 and -30 degrees, a darker tone
                                               each, and contours */
    HRBFNPR_PRESET_COMBING = 3,             /* lines along Stark's combing direction, a second set in the darks, and
                                               contours */
    HRBFNPR_PRESET_SILHOUETTE = 4,          /* contours only, hidden ones attenuated */
    HRBFNPR_PRESET_CONTOUR_AND_STIPPLE = 5, /* contours and stipples */
    HRBFNPR_PRESET_XRAY = 6,                /* contours only, hidden ones shown */
    HRBFNPR_PRESET_FULL = 7,                /* stipples, cross hatching in the darks, contours and halo: Figure 1 (e) */
    HRBFNPR_PRESET_ENGRAVING = 8,           /* one set of lines that swell with the tone, and contours; lights are
                                               empty */
    HRBFNPR_PRESET_ETCHING = 9,             /* up to three sets of thin lines, at 0, 50 and -40 degrees, a darker tone
                                               each, and contours */
    HRBFNPR_PRESET_WOODCUT = 10,            /* few wide lines, which close up to black, and heavy contours */
    HRBFNPR_PRESET_SCIENTIFIC_STIPPLE = 11, /* fine stipples lit from the upper left, empty lights; outlines swell in
                                               the shade */
    HRBFNPR_PRESET_SKETCH = 12,             /* pencil on warm paper: two sets of lines that stray and run past their
                                               ends, contours drawn twice */
    HRBFNPR_PRESET_BLUEPRINT = 13,          /* pale lines on blue without tone: contours, borders, creases and lines
                                               called "crease", hidden ones dashed */
    HRBFNPR_PRESET_ARCHAEOLOGICAL = 14      /* lit from the upper left: short lines along curvature that taper to the
                                               light, heavy outlines, and the RIDGE lines of a line set */
};

/* A full set of fields that a caller goes on changing.  style->layers and style->lines
 * point to constants of the library: copy an element to change it. */
HRBFNPR_API hrbfnpr_status hrbfnpr_style_init_preset(hrbfnpr_style* style, uint32_t struct_size,
                                                     uint32_t preset, hrbfnpr_error* error);
/* The layers that a preset draws, with defaults: a list of constants for
 * hrbfnpr_generate_desc.layers (with layer_stride 0).  *count gets their number.
 * NULL and 0 for a number that is no preset's. */
HRBFNPR_API const hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint32_t preset, int64_t* count);
/* "stipple", "hatch", "cross-hatch", ...; NULL for a number that is no preset's:
 * presets are numbered from 0 without gaps. */
HRBFNPR_API const char* hrbfnpr_preset_name(uint32_t preset);

/*
 * ==========================================================================
 * 10  RENDERER: from items and a camera to a drawing        [NPAR 6]
 * ==========================================================================
 *
 * A renderer is the scratch of one thread.  It keeps a few of its last drawings
 * and makes the next one in the memory of one that nobody else holds: a program
 * that releases each drawing before it asks for the next but one allocates
 * nothing once warm.  The last drawing's point sets live until the next is made,
 * or the renderer is released.
 */

typedef struct hrbfnpr_renderer hrbfnpr_renderer;
typedef struct hrbfnpr_drawing hrbfnpr_drawing;

HRBFNPR_API hrbfnpr_status hrbfnpr_renderer_create(hrbfnpr_context* context, hrbfnpr_renderer** out_renderer,
                                                   hrbfnpr_error* error);
HRBFNPR_API void hrbfnpr_renderer_retain(hrbfnpr_renderer* renderer);  /* any thread; NULL is ignored */
HRBFNPR_API void hrbfnpr_renderer_release(hrbfnpr_renderer* renderer); /* any thread; NULL is ignored */

/* Where the marks of one layer are in this drawing: of an animated surface. */
typedef struct hrbfnpr_layer_pose {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t layer;           /* of the item's point set */
    hrbfnpr_array position;  /* n x 3, FLOAT32 or FLOAT64, absolute, in the order of the layer's n marks */
    hrbfnpr_array normal;    /* n x 3, FLOAT32 or FLOAT64, unit, outward */
    hrbfnpr_array direction; /* n x 3, FLOAT32 or FLOAT64, unit; empty = those of the set */
} hrbfnpr_layer_pose;

HRBFNPR_API hrbfnpr_status hrbfnpr_layer_pose_init(hrbfnpr_layer_pose* pose, uint32_t struct_size);

/* Which sides of an item's surface its marks are drawn on. */
enum {
    HRBFNPR_SIDES_FRONT = 0, /* that which the normals look to: a solid's inside is never seen */
    HRBFNPR_SIDES_BOTH = 1   /* of a surface that ends, such as a bowl or a leaf, the other one, too, where it looks to
                                the camera: with opposite normals for tone.  Such marks count twice in
                                hrbfnpr_drawing_info, as of the front and of the back, their ids are the same, and the
                                drawing has their layers once more, behind those of all items.  Lines are seen from
                                both sides anyway.  With ATTENUATE a depth layer is as opaque as two, one that faces
                                the camera and one that faces away, as those of a solid before what it hides */
};

/* One thing to draw.  Everything it points to is read during _draw only, but
 * the drawing retains the point set. */
typedef struct hrbfnpr_item {
    uint32_t struct_size;
    uint32_t sides;             /* HRBFNPR_SIDES_...; FRONT */
    const hrbfnpr_point_set* point_set;
    const hrbfnpr_style* style; /* NULL = default style */
    const hrbfnpr_model* model; /* NULL, or the surface that the marks lie on: with DEPTH_LAYERS, what
                                   hides a mark is then found by casting a ray from it to the
                                   eye, exact but slow */
    double transform[16];       /* object to world, column-major, affine, invertible */
    const hrbfnpr_layer_pose* poses; /* a list: layers whose marks have moved; NULL and 0 */
    int64_t pose_count;
    int64_t pose_stride;
    const hrbfnpr_line_set* line_set; /* NULL, or what the style's lines are drawn from.  All items of a drawing that
                                         have one hide each other's lines; others hide none */
} hrbfnpr_item;

/* NULL pointers and the identity transform. */
HRBFNPR_API hrbfnpr_status hrbfnpr_item_init(hrbfnpr_item* item, uint32_t struct_size);

/* Classifies, shades and orders the marks of a list of items for one camera.
 * Styles of one drawing must have the same paper and visibility.
 * Contours of line sets begin with those of the renderer's last drawing where the
 * camera moved little, and are proven complete again: in their last digits, and by
 * `wobble`, a picture of lines depends on the drawings before it.
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_renderer_draw(hrbfnpr_renderer* renderer, const hrbfnpr_item* items,
                                                 int64_t item_count, int64_t item_stride,
                                                 const hrbfnpr_camera* camera, hrbfnpr_drawing** out_drawing,
                                                 hrbfnpr_error* error);

/* The same with an operation (NULL = none), for frames that take long: lines of
 * a fine surface, millions of marks, rays of an item's model, callbacks of tone.
 * After a cancel there is no drawing, and the renderer goes on as if the call
 * had not been made, but that contours of line sets are traced from nothing.
 * Errors: also CANCELLED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_renderer_draw_with_operation(hrbfnpr_renderer* renderer, const hrbfnpr_item* items,
                                                                int64_t item_count, int64_t item_stride,
                                                                const hrbfnpr_camera* camera,
                                                                hrbfnpr_operation* operation,
                                                                hrbfnpr_drawing** out_drawing, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 11  DRAWING: a picture as a value, immutable
 * ==========================================================================
 *
 * A drawing is dots and strokes in window coordinates, in layers of one ink and
 * one class each.  A mark's id is 1 + its running number, counted over items
 * and layers in order.  All that reads a drawing may run on several threads at
 * the same time; what memory it needs for that, the context keeps for the next.
 */

HRBFNPR_API void hrbfnpr_drawing_retain(const hrbfnpr_drawing* drawing);  /* any thread; NULL is ignored */
HRBFNPR_API void hrbfnpr_drawing_release(const hrbfnpr_drawing* drawing); /* any thread; NULL is ignored */

/* What a mark is for the camera. */
enum {
    HRBFNPR_CLASS_NONE = 0,
    HRBFNPR_CLASS_FRONT = 1,
    HRBFNPR_CLASS_BACK = 2,
    HRBFNPR_CLASS_SILHOUETTE = 3
};

typedef struct hrbfnpr_drawing_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t items;
    int64_t layers;        /* for hrbfnpr_drawing_get_layer_info */
    int64_t dots;          /* of ink */
    int64_t strokes;
    int64_t stroke_points; /* of all strokes */
    int64_t marks;       /* in all items, of the layers that the styles use: outside + front + back +
                            silhouette + culled */
    int64_t outside;     /* outside the frustum */
    int64_t front;       /* of those inside: by class */
    int64_t back;
    int64_t silhouette;  /* PUBLISHED */
    int64_t culled;        /* DEPTH_LAYERS: marks that are of no class, since no tone could show them: they
                              were not looked at one by one */
    int64_t shown;         /* drawn as ink */
    int64_t dropped_tone;  /* front marks not shown because of light or share */
    int64_t dropped_depth; /* front and silhouette marks not shown because of depth attenuation */
    int64_t dropped_zoom;  /* front marks not shown because of tone scaling */
    int64_t dropped_hidden; /* marks not drawn because nothing of them is seen through what is in front */
    int64_t splats;        /* PUBLISHED: discs of paper; DEPTH_LAYERS: marks that depth layers were found from */
    int64_t nanoseconds_classify; /* transform, classify, tone */
    int64_t nanoseconds_visibility;
    int64_t nanoseconds_sort;
    int64_t bytes;         /* kept by the drawing */
    int64_t scratch_bytes; /* kept by its renderer, drawings left out */
    int64_t line_curves;         /* curves that lines were drawn from */
    int64_t line_cusps;          /* of these */
    int64_t line_crossings;      /* of their images, where the farther one changes its visibility */
    int64_t line_broken;         /* curves that end inside the surface, and places where one was missed */
    int64_t line_settled;        /* curves whose visibility did not add up: each part is as a ray of its own says */
    int64_t line_contradictions; /* of these, curves with a part whose ray was not certain */
    int64_t nanoseconds_lines;
    int64_t line_refined; /* curves whose visibility did not add up at first: they, and those that cross them, were made
                             finer */
    int64_t line_tangles; /* cells of the image, four pixels wide or more, with so many crossings that none was taken:
                             lines run to and fro over one another there, as on a flat face seen edge-on */
} hrbfnpr_drawing_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_info_init(hrbfnpr_drawing_info* info, uint32_t struct_size);
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_get_info(const hrbfnpr_drawing* drawing, hrbfnpr_drawing_info* info,
                                                    hrbfnpr_error* error);

/* A layer of a drawing: ink of one layer of marks, of the front or (PUBLISHED) of contours; or lines. */
typedef struct hrbfnpr_drawing_layer_info {
    uint32_t struct_size;
    uint32_t mark_class; /* HRBFNPR_CLASS_FRONT or SILHOUETTE */
    int64_t item;
    int64_t layer;       /* of the item's point set; -1: of lines */
    uint32_t kind;       /* HRBFNPR_LAYER_KIND_...; of lines HRBFNPR_LINE_KIND_... */
    uint32_t shape;      /* HRBFNPR_SHAPE_... */
    char name[64];       /* of that layer; of lines the style's, or empty */
    float ink[4];        /* straight RGBA */
    int64_t dots;
    int64_t strokes;
} hrbfnpr_drawing_layer_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_layer_info_init(hrbfnpr_drawing_layer_info* info, uint32_t struct_size);
/* number: 0 .. hrbfnpr_drawing_info.layers - 1. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_get_layer_info(const hrbfnpr_drawing* drawing, int64_t number,
                                                          hrbfnpr_drawing_layer_info* info, hrbfnpr_error* error);

/* ---- As an image ---------------------------------------------------------- */

enum {
    HRBFNPR_RASTER_OVER = 1, /* lay the drawing over the image's contents instead of replacing them
                                inside the viewport; wants a style with transparent paper */
    HRBFNPR_RASTER_LINEAR_LIGHT = 2 /* blend in linear light (sRGB decoded), not in encoded values */
};

/* Optional inputs and outputs: width * height elements of one component each,
 * row by row from the top-left pixel of the image, stride between elements as
 * in every array.  Data NULL and count 0 = not wanted. */
typedef struct hrbfnpr_raster_desc {
    uint32_t struct_size;
    uint32_t flags;           /* HRBFNPR_RASTER_...; 0 */
    hrbfnpr_array host_depth; /* FLOAT32, camera's convention: ink behind it is not drawn */
    hrbfnpr_array_out depth;  /* FLOAT32, camera's convention: the nearest surface, the far plane
                                 where there is none */
    hrbfnpr_array_out id;     /* UINT32: id of the nearest drawn mark; 0 = none */
    hrbfnpr_array_out mark_class; /* UINT8 or UINT32: HRBFNPR_CLASS_... of that mark */
} hrbfnpr_raster_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_raster_desc_init(hrbfnpr_raster_desc* desc, uint32_t struct_size);

/* Draws into an image.  The viewport (clipped to the image) is filled with
 * paper and ink; pixels outside it are not touched.  desc may be NULL. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_image* image,
                                                     const hrbfnpr_raster_desc* desc, hrbfnpr_error* error);

/* ---- As vertices ---------------------------------------------------------- */

enum {
    HRBFNPR_PRIMITIVE_POINTS = 1,         /* the dots: one vertex each */
    HRBFNPR_PRIMITIVE_LINE_STRIPS = 2,    /* the strokes: one vertex for each of their points */
    HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS = 3 /* the strokes: two for each point, on their left and right side */
};

/* Ends a strip in an array of indices. */
enum { HRBFNPR_INDEX_RESTART = -1 };

/* What a vertex can carry, and the types it can have. */
enum {
    HRBFNPR_VERTEX_ATTRIBUTE_POSITION = 0,  /* world, FLOAT32 x 3.  Of marks and their line strips that of the mark; of
                                               lines, of hatching and of triangles what is drawn, as exact as the
                                               window depth */
    HRBFNPR_VERTEX_ATTRIBUTE_WINDOW = 1,    /* pixel x, pixel y, depth; FLOAT32 x 3 */
    HRBFNPR_VERTEX_ATTRIBUTE_RADIUS = 2,    /* pixels; FLOAT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_COLOR = 3,     /* straight RGBA; FLOAT32 x 4, or UINT8 x 4 */
    HRBFNPR_VERTEX_ATTRIBUTE_NORMAL = 4,    /* world, unit; of lines 0; FLOAT32 x 3 */
    HRBFNPR_VERTEX_ATTRIBUTE_DIRECTION = 5, /* world, unit; of lines 0; FLOAT32 x 3 */
    HRBFNPR_VERTEX_ATTRIBUTE_ID = 6,        /* of the mark; 0 of lines; UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_CLASS = 7,     /* HRBFNPR_CLASS_...; UINT8 or UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER = 8,  /* 1 = a disc of paper, 0 = ink; UINT8 or UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_LAYER = 9,     /* of the drawing; UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_LENGTH = 10,   /* along its stroke, pixels from its first point; 0 for a dot; FLOAT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_LAYERS = 11, /* layers of surface before that part of a line, 0 = it is visible; 0
                                                    of marks; UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_BY = 12, /* item of the nearest surface before that part of a line;
                                               HRBFNPR_INDEX_RESTART = it is visible, or a mark; UINT32 */
    HRBFNPR_VERTEX_ATTRIBUTE_LINE = 13      /* of lines: a number that a line keeps from one drawing of a renderer to
                                               the next, where the camera moves little; 0 of all else; UINT32 */
};

typedef struct hrbfnpr_vertex_attribute {
    uint32_t struct_size;
    uint32_t attribute; /* HRBFNPR_VERTEX_ATTRIBUTE_... */
    uint32_t scalar;    /* HRBFNPR_SCALAR_... */
    uint32_t offset;    /* bytes from the start of the vertex */
} hrbfnpr_vertex_attribute;

HRBFNPR_API hrbfnpr_status hrbfnpr_vertex_attribute_init(hrbfnpr_vertex_attribute* attribute, uint32_t struct_size);

typedef struct hrbfnpr_vertex_layout {
    uint32_t struct_size;
    uint32_t primitive;       /* HRBFNPR_PRIMITIVE_...; POINTS */
    const hrbfnpr_vertex_attribute* attributes; /* a list, 1 and more */
    int64_t attribute_count;
    int64_t attribute_stride;
    int64_t stride;           /* bytes of a vertex; 0 = up to the end of its last attribute */
} hrbfnpr_vertex_layout;

/* Points, and no attributes. */
HRBFNPR_API hrbfnpr_status hrbfnpr_vertex_layout_init(hrbfnpr_vertex_layout* layout, uint32_t struct_size);

/* How many vertices and indices a primitive has; each may be NULL. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_vertex_bound(const hrbfnpr_drawing* drawing, uint32_t primitive,
                                                        int64_t* vertices, int64_t* indices, hrbfnpr_error* error);

/* Writes the drawing's dots or strokes, far to near.
 *
 * POINTS: discs of paper and of ink.  A host that paints them in this order as
 * round anti-aliased points with ordinary "source over" blending gets the
 * dots of _rasterize (without its host_depth; a dot of a radius r below half a
 * pixel is painted with half a pixel, its alpha times (2 r)^2).  With transparent paper, the
 * discs of paper must erase: destination times (1 - alpha).
 * Strips: `indices` (UINT32, nullable) lists, far to near, the vertices of one stroke after
 * the other, each ended by HRBFNPR_INDEX_RESTART (0xFFFFFFFF); of points it is
 * 0, 1, 2 ...  A triangle strip has two vertices for each point, left and right of it, and two at the tip of a
 * pointed end; round ends are cut off flat.
 * Capacities are in vertices and in indices; *vertex_count and *index_count
 * (nullable) get the numbers written, or needed with BUFFER_TOO_SMALL. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_write_vertices(const hrbfnpr_drawing* drawing,
                                                          const hrbfnpr_vertex_layout* layout, void* vertices,
                                                          int64_t vertex_capacity, int64_t* vertex_count,
                                                          uint32_t* indices, int64_t index_capacity,
                                                          int64_t* index_count, hrbfnpr_error* error);

/* ---- As numbers for the marks of a set ------------------------------------- */

/* How each mark of a layer is drawn, in the set's own order: a host keeps the
 * set's arrays on the graphics card and uploads only these.  Arrays of the
 * caller's, each of as many elements as the layer has marks, or not given. */
typedef struct hrbfnpr_mark_results {
    uint32_t struct_size;
    uint32_t reserved;
    hrbfnpr_array_out shown;   /* UINT8: the class that it is drawn as, HRBFNPR_CLASS_FRONT or SILHOUETTE; NONE = it
                                  is not drawn */
    hrbfnpr_array_out radius;  /* FLOAT32, pixels; 0 = not drawn */
    hrbfnpr_array_out opacity; /* FLOAT32: the ink's alpha times what is let through; 0 = not drawn */
} hrbfnpr_mark_results;

HRBFNPR_API hrbfnpr_status hrbfnpr_mark_results_init(hrbfnpr_mark_results* results, uint32_t struct_size);
/* Of one layer of one item's point set; also of a layer that is not drawn. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_mark_results(const hrbfnpr_drawing* drawing, int64_t item,
                                                        int64_t layer, hrbfnpr_mark_results* results,
                                                        hrbfnpr_error* error);

/* Which marks of a layer are drawn: numbers of marks, UINT32.
 * POINTS: those that are shown, far to near.  LINE_STRIPS: along strokes, a run
 * of shown marks each, ended by HRBFNPR_INDEX_RESTART.  TRIANGLE_STRIPS: the
 * same, 2 * number and 2 * number + 1 for each mark.
 * mark_class: HRBFNPR_CLASS_FRONT or SILHOUETTE.  *count gets the number written, or needed
 * with BUFFER_TOO_SMALL; indices may be NULL when capacity is 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_write_mark_indices(const hrbfnpr_drawing* drawing, int64_t item,
                                                              int64_t layer, uint32_t mark_class,
                                                              uint32_t primitive, uint32_t* indices,
                                                              int64_t capacity, int64_t* count,
                                                              hrbfnpr_error* error);

/* ---- Picking --------------------------------------------------------------- */

typedef struct hrbfnpr_mark_identity {
    uint32_t struct_size;
    uint32_t id;
    int64_t item;
    int64_t layer;  /* of the item's point set */
    int64_t mark;   /* of the layer */
    int64_t stroke; /* of the layer; -1 = of none */
    int64_t place;  /* along the stroke */
} hrbfnpr_mark_identity;

HRBFNPR_API hrbfnpr_status hrbfnpr_mark_identity_init(hrbfnpr_mark_identity* identity, uint32_t struct_size);
/* What an id stands for.  INVALID_ARGUMENT for one that is no mark's. */
HRBFNPR_API hrbfnpr_status hrbfnpr_drawing_identify(const hrbfnpr_drawing* drawing, uint32_t id,
                                                    hrbfnpr_mark_identity* identity, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 12  MESH: triangles as they come, made usable; samples, fits and errors by it
 * ==========================================================================
 *
 * A mesh is immutable.  Making one repairs what can be repaired, and counts it:
 * vertices in exactly the same place are joined, triangles without area and
 * repeated ones left out, unused vertices dropped; of each component the faces
 * are turned to agree, and a closed one that is inside out is turned whole.
 */

typedef struct hrbfnpr_mesh hrbfnpr_mesh;

/* Which components are kept.  A component is what hangs together by shared
 * vertices. */
enum {
    HRBFNPR_PARTS_OUTER = 0,  /* all but those that lie inside a closed one: eyes in a head, inner shells */
    HRBFNPR_PARTS_ALL = 1,    /* all; one that lies inside an odd number of closed ones is a cavity if its faces say so,
                                 and is not turned */
    HRBFNPR_PARTS_LARGEST = 2 /* that of the largest area */
};

/* What becomes of the order of a face's corners. */
enum {
    HRBFNPR_FACES_TURN = 0, /* faces are turned to agree with their component, and closed components outward */
    HRBFNPR_FACES_KEEP = 1  /* as they are */
};

/* Triangles; quadrilaterals and polygons are cut into them by the caller.
 * A corner that is no number of a vertex, or that a vertex which is not finite
 * belongs to, is INVALID_ARGUMENT, and the message names the face and the
 * index; so are coordinates beyond 1e60, a mesh less than 1e-60 across, and one that has no
 * face left. */
typedef struct hrbfnpr_mesh_desc {
    uint32_t struct_size;
    uint32_t parts;          /* HRBFNPR_PARTS_...; OUTER */
    hrbfnpr_array vertices;  /* n x 3, FLOAT32 or FLOAT64; n < 2^31 */
    hrbfnpr_array triangles; /* m x 3, INT32, INT64 or UINT32: numbers of vertices, from 0, counter-clockwise as seen
                                from outside; m < 2^29 */
    double crease_angle;     /* degrees, 0 .. 180: faces that meet at a sharper angle do not share their normals; 60 */
    uint32_t faces;          /* HRBFNPR_FACES_...; TURN */
    uint32_t reserved;
} hrbfnpr_mesh_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_desc_init(hrbfnpr_mesh_desc* desc, uint32_t struct_size);

/* operation may be NULL.  Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_create(hrbfnpr_context* context, const hrbfnpr_mesh_desc* desc,
                                               hrbfnpr_operation* operation, hrbfnpr_mesh** out_mesh,
                                               hrbfnpr_error* error);
HRBFNPR_API void hrbfnpr_mesh_retain(const hrbfnpr_mesh* mesh);  /* any thread; NULL is ignored */
HRBFNPR_API void hrbfnpr_mesh_release(const hrbfnpr_mesh* mesh); /* any thread; NULL is ignored */

/* Of what is kept, but for the numbers of what was found on the way.  An edge is
 * at the boundary if one face has it, and not manifold if more than two have. */
typedef struct hrbfnpr_mesh_info {
    uint32_t struct_size;
    uint32_t closed;              /* 1: no edge is at the boundary or not manifold, and all faces agree */
    int64_t given_vertices;
    int64_t given_faces;
    int64_t vertices;             /* kept; more than were given where solids that touch in an edge are parted there, at
                                     most three for each face */
    int64_t faces;
    int64_t welded_vertices;      /* in the place of another, and joined with it; on borders also within 1e-6 of the
                                     diagonal from another */
    int64_t degenerate_faces;     /* without area but for the rounding of single precision, left out; the face across the
                                     largest side is cut in two at the corner that lies within it, so that no slit stays */
    int64_t repeated_faces;       /* with the corners of another, left out; both where two solids share a wall */
    int64_t turned_faces;         /* against those beside them, turned */
    int64_t components;           /* of the given faces */
    int64_t turned_components;    /* closed and inside out, turned */
    int64_t nested_components;    /* inside a closed one */
    int64_t left_out_components;
    int64_t left_out_faces;       /* of these */
    int64_t boundary_edges;
    int64_t boundary_loops;
    int64_t nonmanifold_edges;
    int64_t contrary_edges;       /* whose two faces do not agree: the mesh cannot be oriented, or was not to be */
    int64_t euler_characteristic; /* vertices - edges + faces */
    int64_t genus;                /* sum of the handles of all components; -1 where the mesh is not closed */
    double area;
    double volume;                /* enclosed; NaN where the mesh is not closed */
    double bounds_min[3];
    double bounds_max[3];
    double seconds;               /* that making it took */
    int64_t bytes;                /* kept by the mesh */
    double crease_length;         /* of the edges that bend by more than 30 degrees, in diagonals of the bounds */
    uint32_t creases;             /* 1: these stand out, as those of machine parts; hrbfnpr_model_fit_mesh with edges
                                     AUTO and the default crease angle keeps them sharp */
    uint32_t reserved;
} hrbfnpr_mesh_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_info_init(hrbfnpr_mesh_info* info, uint32_t struct_size);
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_get_info(const hrbfnpr_mesh* mesh, hrbfnpr_mesh_info* info,
                                                 hrbfnpr_error* error);

enum {
    HRBFNPR_MESH_ATTRIBUTE_VERTEX = 0,       /* places, FLOAT64 x 3 */
    HRBFNPR_MESH_ATTRIBUTE_TRIANGLE = 1,     /* numbers of vertices, INT32 x 3, of each face */
    HRBFNPR_MESH_ATTRIBUTE_COMPONENT = 2,    /* from 0, INT32 x 1, of each face */
    HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE = 3,   /* the number that the face was given by, INT32 x 1 */
    HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL = 4 /* unit normals of the three corners, FLOAT64 x 9, of each face */
};

/* A zero-copy view of what is kept, valid while the mesh lives. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_view(const hrbfnpr_mesh* mesh, uint32_t attribute,
                                             hrbfnpr_array* out_view, hrbfnpr_error* error);

typedef struct hrbfnpr_sample_desc {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t candidates;   /* random places to choose from, 0 = 40 for each sample, 1000000 at most; never fewer than
                             samples; as many as samples: all of them, in random order */
    uint64_t random_seed; /* any number; 1 */
} hrbfnpr_sample_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_sample_desc_init(hrbfnpr_sample_desc* desc, uint32_t struct_size);

/* As many samples of the mesh as `points` has elements (at least 1, 10000000 at
 * most): random places, even over its area, of which each next one that is
 * taken is the farthest from those before, so that every prefix is even.
 * points, normals: n x 3, FLOAT32 or FLOAT64; normals (may be NULL) are unit,
 * interpolated between those of the corners, which take in the faces about
 * their vertex within the crease angle, by their angles there.
 * desc may be NULL; operation too. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_sample(const hrbfnpr_mesh* mesh, const hrbfnpr_sample_desc* desc,
                                               const hrbfnpr_array_out* points, const hrbfnpr_array_out* normals,
                                               hrbfnpr_operation* operation, hrbfnpr_error* error);

/* Which edges of a mesh are sharp. */
enum {
    HRBFNPR_EDGES_AUTO = 0,   /* sharp where the mesh has edges: they stand out, as those of machine parts do, from what
                                 is beside them; noise and coarse faces of round shapes do not.  Closed parts that
                                 cross are fitted apart, and meet in creases */
    HRBFNPR_EDGES_SMOOTH = 1, /* no edge is: a fit is one smooth surface, which rounds them */
    HRBFNPR_EDGES_SHARP = 2   /* sharp wherever faces meet at more than crease_angle */
};

/* How sharp edges are found. */
typedef struct hrbfnpr_mesh_edges_desc {
    uint32_t struct_size;
    uint32_t edges;      /* HRBFNPR_EDGES_...; AUTO */
    double crease_angle; /* degrees between the normals of two faces, 1 .. 179: an edge that bends more is sharp; 30 */
    double far;          /* coarse faces that a round surface would leave by four fifths of this stay flat, with sharp
                            edges; in units of the mesh; 0 = 0.01 diagonals.  A large number, such as the diagonal:
                            only the angle counts */
} hrbfnpr_mesh_edges_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_edges_desc_init(hrbfnpr_mesh_edges_desc* desc, uint32_t struct_size);

typedef struct hrbfnpr_mesh_edges_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t edges;     /* the number of sharp edges */
    int64_t patches;   /* the number of smooth patches between them; 1 where no edge is sharp */
    double length;     /* of the sharp edges, in units of the mesh */
    double fading;     /* of those among them that have the same patch on both sides, as where a crease fades out */
    double doubtful;   /* with AUTO: of edges that bend more than crease_angle but do not stand out, in units of the mesh;
                          0 where edges are sharp */
    double seconds;
} hrbfnpr_mesh_edges_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_edges_info_init(hrbfnpr_mesh_edges_info* info, uint32_t struct_size);

/* Finds the sharp edges of a mesh and the smooth patches between them, as
 * hrbfnpr_model_fit_mesh does with the same edges, crease_angle and far.  Edges
 * that bend by more than crease_angle are sharp; where one ends, it goes on along
 * edges that bend by 8 degrees or more and keep its direction; short sharp edges
 * that part nothing are dropped as noise.  Edges of one face, and of more than
 * two, end patches, but are not sharp.
 * patch: m x 1, INT64, INT32 or UINT32 for the m faces of the mesh: the number of
 *        each face's patch, from 0 in the order of their first faces.  NULL: not
 *        wanted.
 * sharp: m x 3, the same types: 1 where the edge from corner k of the face to the
 *        next corner is sharp, else 0.  NULL: not wanted.
 * desc, info and operation may be NULL.  The call is thread-safe: it only reads
 * the mesh.  Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_edges(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_edges_desc* desc,
                                              const hrbfnpr_array_out* patch, const hrbfnpr_array_out* sharp,
                                              hrbfnpr_mesh_edges_info* info, hrbfnpr_operation* operation,
                                              hrbfnpr_error* error);

/* Farthest-point order: each is the point farthest from those before it, the
 * first the one nearest to the middle of the bounding box; of equals the one of
 * lower number.  Every prefix is an even choice [Gonzalez 1985].
 * points:   n x 3, FLOAT32 or FLOAT64, finite, below 1e100.
 * indices:  k x 1, INT64, INT32 or UINT32, k <= n: numbers of points.
 * distance: k x 1, FLOAT32 or FLOAT64, or NULL: from those before; infinite for
 *           the first.
 * 20 000 of a million take half a second.  operation may be NULL. */
HRBFNPR_API hrbfnpr_status hrbfnpr_farthest_points(hrbfnpr_context* context, const hrbfnpr_array* points,
                                                   const hrbfnpr_array_out* indices,
                                                   const hrbfnpr_array_out* distance,
                                                   hrbfnpr_operation* operation, hrbfnpr_error* error);

/* How near a surface is to a mesh.  "Surface": of the model, within the box of
 * the mesh, grown by 0.05 diagonals; "diagonal" is the mesh's.  What of it is
 * nearest to the mesh's border goes on beyond that, and is left out.  Where
 * closed components overlap, what lies inside is no part of the mesh. */
typedef struct hrbfnpr_compare_desc {
    uint32_t struct_size;
    uint32_t reserved;
    double tolerance;     /* that shares are counted for, in units of the mesh; 0 = 0.002 diagonals */
    double far;           /* beyond it a part of the surface is an invention, and a part of the mesh missed; 0 = 0.01
                             diagonals */
    double support;       /* > 0: what the samples of the model do not bear out by this limit is left out, as a line set
                             with the same `support` does; a custom model has none; 0 = nothing is left out */
    int64_t points;       /* on each side, 100 .. 10000000; 0 = 20000 */
    double cell_size;     /* of the cells that the surface is looked for in; 0 = 1/128 of the diagonal, and finer where
                             it is thin.  What is thinner or smaller may be missed */
    uint64_t random_seed; /* any number; 1 */
} hrbfnpr_compare_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_compare_desc_init(hrbfnpr_compare_desc* desc, uint32_t struct_size);

/* Distances in units of the mesh.  p99: 99 % are not farther.  Of no points: NaN. */
typedef struct hrbfnpr_comparison {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t surface_points;  /* places on the surface, even over its area */
    double surface_mean;     /* of their distances from the mesh */
    double surface_p99;
    double surface_max;
    double surface_share;    /* within the tolerance */
    double invented_share;   /* of the surface, beyond `far` */
    double left_out_share;   /* of the surface: beyond the mesh's border, or by `support`; in none of the above */
    int64_t mesh_points;     /* places on the mesh, even over its area */
    double mesh_mean;        /* of their distances from the surface */
    double mesh_p99;
    double mesh_max;
    double mesh_share;       /* within the tolerance */
    double missed_share;     /* of the mesh, beyond `far` */
    double normal_mean;      /* degrees between the mesh's normals and the surface's beside them */
    double normal_p99;
    int64_t components;      /* of the surface */
    int64_t genus;           /* of the surface, sum over its components; -1 if it has a border in the box */
    double tolerance;        /* as used */
    double diagonal;
    double seconds;
} hrbfnpr_comparison;

HRBFNPR_API hrbfnpr_status hrbfnpr_comparison_init(hrbfnpr_comparison* comparison, uint32_t struct_size);

/* Measures both ways, for any model, in the same coordinates as the mesh.  The
 * surface is found from places on the mesh and from 16^3 places of the box: a
 * small part of it that neither leads to is missed.
 * desc may be NULL; operation too. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_compare_mesh(const hrbfnpr_model* model, const hrbfnpr_mesh* mesh,
                                                      const hrbfnpr_compare_desc* desc,
                                                      hrbfnpr_comparison* comparison,
                                                      hrbfnpr_operation* operation, hrbfnpr_error* error);

/* How a mesh is fitted. */
typedef struct hrbfnpr_mesh_fit_desc {
    uint32_t struct_size;
    uint32_t reserved;
    double tolerance;        /* how near the surface and the mesh are to be to each other, in units of the mesh; 0 =
                                0.002 diagonals; not below 1e-6 diagonals */
    double share;            /* of both that has to be within the tolerance, above 0, at most 1; 0.99 */
    double far;              /* what no part may be beyond; 0 = five times the tolerance */
    int64_t maximum_centres; /* 16 .. 1000000; 8000.  A fit with sharp edges may have 32 for each of its sheets, if that
                                is more: each is solved alone */
    int64_t candidates;      /* places on the mesh to choose from, 1000 .. 10000000; 0 = by its area and its details */
    uint64_t random_seed;    /* any number; 1 */
    double crease_angle;     /* degrees between the normals of two faces, 5 .. 175: what bends more is an edge, and what
                                rounding would take four fifths of `far` off the mesh; 30 */
    uint32_t edges;          /* HRBFNPR_EDGES_...; AUTO */
    uint32_t reserved2;
} hrbfnpr_mesh_fit_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_fit_desc_init(hrbfnpr_mesh_fit_desc* desc, uint32_t struct_size);

/* What a fit to a mesh came to: the last of the measurements that it went by,
 * at places of their own.  hrbfnpr_model_compare_mesh measures again, and more. */
typedef struct hrbfnpr_mesh_fit_info {
    uint32_t struct_size;
    uint32_t reached;            /* 1: tolerance, share and far are kept, both ways */
    double tolerance;            /* as used */
    double far;
    int64_t candidates;
    int64_t centres;             /* all */
    int64_t off_surface_centres; /* of these, the last ones: where f is held to the distance from the mesh */
    int32_t rounds;              /* fits */
    uint32_t supported;          /* 1: the mesh has a border, and the surface beyond it was not counted */
    double surface_share;        /* of the surface, within the tolerance of the mesh */
    double surface_p99;
    double surface_max;
    double mesh_share;           /* of the mesh, within the tolerance of the surface */
    double mesh_p99;
    double mesh_max;
    double seconds_sample;
    double seconds_fit;          /* of all rounds */
    double seconds_measure;
    double seconds_total;
    int32_t sheets;              /* smooth pieces that the surface is made of; 1: it has no edges */
    uint32_t reserved;
    double crease_length;        /* of the mesh's edges that are sharp */
    double smooth_length;        /* of those that are not, as the mesh could not be cut there */
    int64_t cells;               /* of space, in each of which a few sheets rule */
    int64_t poor_cells;          /* in which no maximum and minimum of its sheets does all that the mesh does */
    int32_t touching_parts[2];   /* of the mesh, from 0: two that are nearer to each other than the tolerance, so that the
                                    surface may join them; -1, -1: none were found */
    double touching_place[3];    /* where they are */
    uint32_t parts_may_cross;    /* 1: they may go through each other there; 0: they are near to each other */
    uint32_t reserved2;
} hrbfnpr_mesh_fit_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_mesh_fit_info_init(hrbfnpr_mesh_fit_info* info, uint32_t struct_size);

/* Fits a surface to a mesh with as many samples as that takes: some hundred
 * even ones, then, in rounds, more where the surface is off the mesh or the mesh
 * off the surface.  Where the surface goes on far from the mesh, f is held to
 * the signed distance from the mesh at a few places off it, if it is clear on
 * which side of the mesh they lie, whatever small holes it has: these are the
 * last centres of the model, whose normal is the way to the mesh or from it.
 *
 * An end short of the tolerance is no error: `reached` is 0, and the log warns.
 * It comes with maximum_centres, or where more centres gain nothing.  Of a smooth
 * fit edges are rounded by some tenths of the samples' spacing there, and coarse
 * faces with smooth normals contradict these: both take many centres.
 *
 * A mesh with edges, as `edges` says, is cut along them into smooth patches.  Each
 * gets a fit of its own, a sheet, and cells of space say which maximum and minimum
 * of their sheets the surface is there [Ohtake et al. 2003, whose pieces are local];
 * away from the surface they have the mesh's signs.  Sheets are held to a fortieth
 * of the tolerance at edges, and to a quarter of it far from them.  An edge that ends
 * within a patch is made to go on, smoothly.  The points and normals of such a model
 * are places all over the mesh, not centres.
 * Trimmed by places on the mesh is what was fitted to an open one, or not reached.
 * desc may be NULL.  fit (may be NULL): kernel, solver, regularization and trim of
 * the fits; its points and normals must be empty, its tolerance and maximum_centres
 * 0; a solver_tolerance of 0 is, of a smooth fit, the tolerance / 200 diagonals,
 * from 1e-8 to 1e-5: what a distance shows is a hundred times as much.
 * info and operation may be NULL.  Errors as of hrbfnpr_model_fit, whose
 * stack it needs as well. */
HRBFNPR_API hrbfnpr_status hrbfnpr_model_fit_mesh(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_fit_desc* desc,
                                                  const hrbfnpr_fit_desc* fit, hrbfnpr_mesh_fit_info* info,
                                                  hrbfnpr_operation* operation, hrbfnpr_model** out_model,
                                                  hrbfnpr_error* error);

/*
 * ==========================================================================
 * 13  PAGE: drawings as vectors: SVG, PDF, HPGL, G-code
 * ==========================================================================
 *
 * A page holds drawings, each at its place and scale, and texts and lines beside
 * them.  Its unit is the millimetre, from the top-left corner, y down.  Strokes are
 * cubic Bezier curves within a tolerance of the drawing's [Schneider 1990], or for
 * plotters straight lines within it.
 *
 * Ink stands in named groups, the layers of a file: of marks the layer's name in
 * its point set, such as "stipples" or "hatch-2"; of lines "contour", "suggestive",
 * "ridge", "valley", "apparent ridge", "parabolic", "isophote", "section", "border",
 * or the name of own ones.  What is behind n layers of surface has " hidden n" at its end, a second
 * layer of the same name " 2".  Groups follow the layers of the drawing, hidden ones
 * before the others; in a group strokes stand far to near.  Where inks of several
 * colours lie upon each other groups begin anew, with ", run 2" behind their names,
 * and so on up to 32, so that all is painted far to near there, as the raster does;
 * not in plot order, where each pen is taken up once.  Pens go by names without that.
 * The bytes are the same for every thread count and locale.
 */

enum {
    HRBFNPR_PAGE_FORMAT_SVG = 0,  /* 1.1; groups are layers of Inkscape */
    HRBFNPR_PAGE_FORMAT_PDF = 1,  /* 1.5; groups are optional content, which viewers list as layers */
    HRBFNPR_PAGE_FORMAT_HPGL = 2, /* for plotters: absolute, 40 units a millimetre, y up from the lower left corner */
    HRBFNPR_PAGE_FORMAT_GCODE = 3 /* for plotters: G0 and G1, millimetres, y up from the lower left corner */
};

/* How strokes are written whose width varies. */
enum {
    HRBFNPR_WIDTHS_OUTLINES = 0, /* filled outlines; SVG and PDF */
    HRBFNPR_WIDTHS_CLASSES = 1   /* lines of even widths, `width_step` apart */
};

/* How dots are written. */
enum {
    HRBFNPR_DOT_SHAPE_CIRCLES = 0, /* circles; plotters fill them, with SINGLE_PASS draw round them */
    HRBFNPR_DOT_SHAPE_LINES = 1,   /* lines of no length with round ends; plotters touch the paper */
    HRBFNPR_DOT_SHAPE_SPIRALS = 2  /* spirals that a pen fills the disc with, if it is wider than the pen */
};

enum {
    HRBFNPR_PAGE_IN_PLOT_ORDER = 1, /* groups are sorted so that a pen travels little, as HPGL and GCODE always are:
                                       greedily, then by 2-opt and Or-opt; lines may be turned round, closed ones begin
                                       elsewhere, and lines whose ends are nearer than `join` become one */
    HRBFNPR_PAGE_SINGLE_PASS = 4,   /* a line that is wider than its pen is drawn once, along its centre; else, with
                                       HPGL and GCODE and with pens in plot order, it is filled: by passes side by
                                       side, 0.8 of the pen's width apart or a little less, each only where the line is
                                       so wide.  A line up to 1.2 times as wide as the pen takes one */
    HRBFNPR_PAGE_WITHOUT_PAPER = 2  /* else the page has the paper of its first drawing, white without one, and other
                                       drawings with another paper theirs; plotters draw none */
};

/* Kinds of lines by the numbers of ISO 128-2.  In line widths a dot is 0.5, the three kinds of dashes 6, 12 and 24,
 * a gap 3, a space 18; a little more or less, so that lines begin and end with a dash. */
enum {
    HRBFNPR_LINE_TYPE_AS_DRAWN = 0,
    HRBFNPR_LINE_TYPE_CONTINUOUS = 1,
    HRBFNPR_LINE_TYPE_DASHED = 2, /* hidden edges */
    HRBFNPR_LINE_TYPE_DASHED_SPACED = 3,
    HRBFNPR_LINE_TYPE_LONG_DASHED_DOTTED = 4, /* axes */
    HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_DOTTED = 5,
    HRBFNPR_LINE_TYPE_LONG_DASHED_TRIPLE_DOTTED = 6,
    HRBFNPR_LINE_TYPE_DOTTED = 7,
    HRBFNPR_LINE_TYPE_LONG_DASHED_SHORT_DASHED = 8,
    HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_SHORT_DASHED = 9,
    HRBFNPR_LINE_TYPE_DASHED_DOTTED = 10,
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOTTED = 11,
    HRBFNPR_LINE_TYPE_DASHED_DOUBLE_DOTTED = 12,
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOUBLE_DOTTED = 13,
    HRBFNPR_LINE_TYPE_DASHED_TRIPLE_DOTTED = 14,
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_TRIPLE_DOTTED = 15
};

/* A drawing on a page. */
typedef struct hrbfnpr_page_item {
    uint32_t struct_size;
    uint32_t reserved;              /* 0 */
    const hrbfnpr_drawing* drawing; /* what lies beyond its viewport is cut off */
    double x;                       /* mm: the viewport's left edge; 0 */
    double y;                       /* mm: its top edge; 0 */
    double scale;                   /* mm of a pixel, > 0; 25.4 / 96 */
    const char* name;               /* UTF-8, of the group around it; NULL = none */
} hrbfnpr_page_item;

HRBFNPR_API hrbfnpr_status hrbfnpr_page_item_init(hrbfnpr_page_item* item, uint32_t struct_size);

/* What some groups are drawn with. */
typedef struct hrbfnpr_pen {
    uint32_t struct_size;
    uint32_t line_type; /* HRBFNPR_LINE_TYPE_...; AS_DRAWN */
    const char* groups; /* a group's name, or the beginning of names and a '*'; NULL = all.  Of pens that fit a group
                           the last one is taken */
    double width;       /* mm, >= 0; 0 = as drawn.  Plotters: of the pen; 0 = 0.3 */
    float ink[4];       /* straight RGBA; alpha 0 = as drawn, the default */
    uint32_t number;    /* 1 to 255, of a plotter's; 1 */
    uint32_t reserved;  /* 0 */
} hrbfnpr_pen;

HRBFNPR_API hrbfnpr_status hrbfnpr_pen_init(hrbfnpr_pen* pen, uint32_t struct_size);

/* A line, a filled shape or a text beside the drawings. */
typedef struct hrbfnpr_annotation {
    uint32_t struct_size;
    uint32_t line_type;   /* HRBFNPR_LINE_TYPE_...; CONTINUOUS */
    const char* group;    /* UTF-8, of 1 to 95 bytes; "annotations".  Those of one group that follow each other share
                             its layer and pen; their inks and types are those of its first */
    const char* text;     /* UTF-8; NULL = the points are a line.  Plotters: HPGL writes labels, GCODE none */
    hrbfnpr_array points; /* FLOAT32 or FLOAT64, 2, mm: the line, or where the text's baseline begins */
    double width;         /* mm, > 0: of the line, or the height of the text's capitals; 0.35 */
    float ink[4];         /* straight RGBA; black */
} hrbfnpr_annotation;

HRBFNPR_API hrbfnpr_status hrbfnpr_annotation_init(hrbfnpr_annotation* annotation, uint32_t struct_size);

typedef struct hrbfnpr_page_desc {
    uint32_t struct_size;
    uint32_t format; /* HRBFNPR_PAGE_FORMAT_...; SVG */
    uint32_t flags;  /* HRBFNPR_PAGE_IN_PLOT_ORDER and others; 0 */
    uint32_t widths; /* HRBFNPR_WIDTHS_...; OUTLINES */
    uint32_t dots;   /* HRBFNPR_DOT_SHAPE_...; CIRCLES */
    uint32_t reserved;
    double width;              /* mm, >= 0; 0 = as far as the drawings reach */
    double height;             /* mm, >= 0; 0 = as far as the drawings reach */
    double tolerance;          /* mm, 0.001 to 10: between what is drawn and what is written; 0.05 */
    double width_step;         /* 1.01 to 4: ratio of neighbouring classes of widths; 1.25 */
    double join;               /* mm, >= 0: in plot order, see there; 0 = the pen's width */
    double shortest;           /* mm, >= 0: in plot order shorter lines are dropped; 0 = half the pen's width */
    double dot_distance;       /* mm, >= 0: in plot order dots nearer to one that stays are dropped; 0 = half the pen's
                                  width */
    double draw_speed;         /* mm/s, > 0; 30 */
    double travel_speed;       /* mm/s, > 0; 80 */
    double pen_seconds;        /* >= 0: to lower or to raise the pen; 0.15 */
    const char* pen_down;      /* GCODE: lines that lower it; NULL = "G1 Z0" */
    const char* pen_up;        /* GCODE: lines that raise it; NULL = "G0 Z5" */
    const char* title;         /* UTF-8, or NULL */
    const char* description;   /* UTF-8, or NULL */
    const char* metadata;      /* UTF-8, or NULL: text on the model, the camera, the style; the version is added */
    const hrbfnpr_page_item* items; /* a list */
    int64_t item_count;
    int64_t item_stride;
    const hrbfnpr_pen* pens; /* a list; NULL and 0 */
    int64_t pen_count;
    int64_t pen_stride;
    const hrbfnpr_annotation* annotations; /* a list; NULL and 0 */
    int64_t annotation_count;
    int64_t annotation_stride;
} hrbfnpr_page_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_page_desc_init(hrbfnpr_page_desc* desc, uint32_t struct_size);

/* What was written. */
typedef struct hrbfnpr_page_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t bytes;
    int64_t groups;
    int64_t paths;          /* lines and outlines */
    int64_t segments;       /* curves or straight lines of all paths */
    int64_t dots;
    int64_t joined;         /* in plot order: pairs of ends that became one line */
    int64_t dropped_paths;  /* too short for the pen */
    int64_t dropped_dots;   /* too near to others for the pen */
    double width;           /* mm, of the page */
    double height;          /* mm, of the page */
    double drawn;           /* mm that a pen draws; in plot order, else 0, as are the next two */
    double travelled;       /* mm between */
    double seconds;         /* that a plotter takes at the given speeds */
    int64_t filled_paths;   /* lines wider than their pen, drawn in several passes */
} hrbfnpr_page_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_page_info_init(hrbfnpr_page_info* info, uint32_t struct_size);

/* Writes a page, a buffer at a time; memory grows with the drawing's largest stroke,
 * in plot order with its largest group.  info and operation may be NULL.
 * Errors: INVALID_ARGUMENT (no drawing and no annotation; an empty page; text that
 * is not UTF-8; discs of paper, which PUBLISHED frames have, for plotters or in plot
 * order), IO (write failed), OUT_OF_MEMORY, CANCELLED, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_page_write(hrbfnpr_context* context, const hrbfnpr_page_desc* desc,
                                              hrbfnpr_write_fn write, void* user, hrbfnpr_page_info* info,
                                              hrbfnpr_operation* operation, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 14  PICTURE: from any source to a drawing in one call
 * ==========================================================================
 *
 * A picture chooses what a user leaves open: repairs, samples, the fit, where the
 * surface ends, which way is up, the camera, the size of the pen, how many marks
 * there are, and which lines are drawn.  It is made of the calls of the sections
 * above, and each part of it can be taken out and used by them.
 *
 * Every choice that a user may want to know is a note: a code, its figures and a
 * sentence.  A picture keeps its notes and the seconds of its stages.
 */

typedef struct hrbfnpr_picture hrbfnpr_picture;
typedef struct hrbfnpr_settings hrbfnpr_settings;

/* ---- What is drawn ---------------------------------------------------------- */

enum {
    HRBFNPR_SOURCE_HAS_SHARP_EDGES = 1, /* `sharp_edges` is known, even if it is empty */
    HRBFNPR_SOURCE_HAS_VIEWPOINT = 2,   /* `viewpoint` is known */
    HRBFNPR_SOURCE_IS_PHOTO = 4         /* the points are one picture of a depth camera that stood at `viewpoint` */
};

/* One of four kinds: points (with or without normals), a mesh (points and triangles), a
 * model, or a point set.  A model and a point set together are a model with its marks,
 * which are then used as they are. */
typedef struct hrbfnpr_picture_source {
    uint32_t struct_size;
    uint32_t flags;            /* HRBFNPR_SOURCE_...; 0 */
    hrbfnpr_array points;      /* n x 3, FLOAT32 or FLOAT64: points, or the vertices of the triangles.  Points that are
                                  not finite are left out */
    hrbfnpr_array normals;     /* n x 3, FLOAT32 or FLOAT64, of any length; not given or all zero = none.  Not read of a
                                  mesh */
    hrbfnpr_array triangles;   /* m x 3, INT32, INT64 or UINT32: a mesh; not given = points */
    hrbfnpr_array sharp_edges; /* k x 2, INT32, INT64 or UINT32: of a mesh, the pairs of vertices whose faces have normals
                                  of their own in its file; with HAS_SHARP_EDGES */
    const hrbfnpr_model* model;         /* kept; NULL */
    const hrbfnpr_point_set* point_set; /* kept; NULL */
    double up[3];              /* which way is up by the convention of the file's format; 0, 0, 0 = not known */
    const char* up_by;         /* why, for the note: "PLY files"; NULL = "files of this kind" */
    double viewpoint[3];       /* where the scanner stood, with HAS_VIEWPOINT */
    int64_t columns;           /* of a depth camera's image, whose points stand row by row; 0 = it is none */
    int64_t rows;
    const char* name;          /* UTF-8: of the file, for titles and metadata; NULL */
} hrbfnpr_picture_source;

HRBFNPR_API hrbfnpr_status hrbfnpr_picture_source_init(hrbfnpr_picture_source* source, uint32_t struct_size);

/* ---- How it is drawn --------------------------------------------------------- */

enum {
    HRBFNPR_PICTURE_ALLOW_BLANK = 1,   /* drawing what can hardly be seen is no error */
    HRBFNPR_PICTURE_FLIP = 2,          /* all normals are turned, whatever they look like */
    HRBFNPR_PICTURE_CLOSE = 4,         /* the surface goes on beyond open data, as the fit has it */
    HRBFNPR_PICTURE_TOGETHER = 8,      /* an open mesh is one surface, also where its parts cross */
    HRBFNPR_PICTURE_TRANSPARENT = 16,  /* the paper lets all through */
    HRBFNPR_PICTURE_KEEP_MARKS = 32,   /* layers have all their marks, also where the style draws lines alone: for marks
                                          that are saved */
    HRBFNPR_PICTURE_SURFACE_ONLY = 64, /* no camera is chosen, no marks are placed, no lines are looked for: for the model
                                          alone */
    HRBFNPR_PICTURE_IS_SOLID = 128     /* nothing is said of a source that is a part of a solid, and no up is looked for */
};

/* The edges of a mesh. */
enum {
    HRBFNPR_PICTURE_EDGES_AS_GIVEN = 0, /* as AUTO; where faces are coarse as the normals of the file tell, if they do */
    HRBFNPR_PICTURE_EDGES_AUTO = 1,     /* HRBFNPR_EDGES_AUTO */
    HRBFNPR_PICTURE_EDGES_SMOOTH = 2,   /* HRBFNPR_EDGES_SMOOTH */
    HRBFNPR_PICTURE_EDGES_SHARP = 3     /* HRBFNPR_EDGES_SHARP, with `edge_angle` */
};

enum {
    HRBFNPR_PROFILE_AUTO = 0, /* YES of the style archaeological, else NO */
    HRBFNPR_PROFILE_YES = 1,  /* an upright section through the middle stands beside the drawing */
    HRBFNPR_PROFILE_NO = 2
};

enum {
    HRBFNPR_PICTURE_SIDES_AUTO = 0,  /* both of a surface that ends, else the front */
    HRBFNPR_PICTURE_SIDES_FRONT = 1, /* HRBFNPR_SIDES_FRONT */
    HRBFNPR_PICTURE_SIDES_BOTH = 2   /* HRBFNPR_SIDES_BOTH */
};

/* How notes and errors name the options that they speak of. */
enum {
    HRBFNPR_WORDING_FIELDS = 0,   /* samples 400 */
    HRBFNPR_WORDING_OPTIONS = 1,  /* --samples 400, of a command line */
    HRBFNPR_WORDING_ARGUMENTS = 2 /* samples=400, of a call in Python */
};

/* One field that is changed on top of all that was chosen.  `field` is the path of a field:
 *   style.F            of hrbfnpr_style; style.ink is that of all layers, lines and contours
 *   style.KIND.F       of hrbfnpr_layer_style, of a kind of layers: style.hatch.ink
 *   style.layers.F     of all layers of the style; share is multiplied
 *   style.lines.F      of hrbfnpr_line_style, of all lines
 *   style.LINE.F       the same, of a kind of lines: style.ridge.width
 *   fit.F              of hrbfnpr_fit_desc
 *   mesh_fit.F         of hrbfnpr_mesh_fit_desc
 *   marks.F            of hrbfnpr_generate_desc
 *   marks.KIND.F       of hrbfnpr_layer_desc, of a kind of layers; marks.layers.F of all
 *   line_set.F         of hrbfnpr_line_set_desc
 * Lengths in pixels are those of this picture: they are not scaled by the pen. */
typedef struct hrbfnpr_change {
    uint32_t struct_size;
    uint32_t reserved;
    const char* field;
    const char* value; /* a number, several with commas between, #rrggbb or #rrggbbaa of a colour, or the name of a
                          constant without its prefix: "blue-noise" */
} hrbfnpr_change;

HRBFNPR_API hrbfnpr_status hrbfnpr_change_init(hrbfnpr_change* change, uint32_t struct_size);

/* A stroke of a brush on the surface: within its radius what is painted goes towards a value. */
enum { HRBFNPR_DAB_TONE = 0, HRBFNPR_DAB_DENSITY = 1, HRBFNPR_DAB_DIRECTION = 2 };

typedef struct hrbfnpr_dab {
    uint32_t struct_size;
    uint32_t map;        /* HRBFNPR_DAB_...; TONE: 1 = light, 0 = dark */
    double position[3];
    double normal[3];    /* unit: what faces away from it is not painted */
    double radius;       /* > 0 */
    double strength;     /* 0 .. 1 in the middle; it falls to 0 at the radius; 1 */
    double value;        /* of TONE and DENSITY, 0 .. 1 */
    double direction[3]; /* of DIRECTION: that of hatching */
} hrbfnpr_dab;

HRBFNPR_API hrbfnpr_status hrbfnpr_dab_init(hrbfnpr_dab* dab, uint32_t struct_size);

/* The parts of the work. */
enum {
    HRBFNPR_STAGE_MESH = 1,    /* looking at a mesh: welding, turning faces */
    HRBFNPR_STAGE_SAMPLE = 2,  /* choosing samples */
    HRBFNPR_STAGE_ORIENT = 3,  /* looking for normals */
    HRBFNPR_STAGE_SMOOTH = 4,  /* the image of a depth camera */
    HRBFNPR_STAGE_FIT = 5,
    HRBFNPR_STAGE_COMPARE = 6, /* the surface with the mesh */
    HRBFNPR_STAGE_END = 7,     /* looking for the end of the surface */
    HRBFNPR_STAGE_MARKS = 8,   /* placing marks */
    HRBFNPR_STAGE_LINES = 9,   /* looking for lines */
    HRBFNPR_STAGE_FRAME = 10,  /* drawing */
    HRBFNPR_STAGE_VIEWS = 11   /* drawing the views of a sheet */
};

enum {
    HRBFNPR_SEVERITY_INFO = 0,    /* a measurement */
    HRBFNPR_SEVERITY_NOTE = 1,    /* what was chosen, repaired or left out */
    HRBFNPR_SEVERITY_WARNING = 2, /* the result may be wrong there */
    HRBFNPR_SEVERITY_FAILURE = 3  /* there is no result: the error of the call, in full length */
};

/* Notes.  In brackets the figures of each. */
enum {
    HRBFNPR_NOTE_FACES_NOT_FINITE = 1,        /* left out [faces] */
    HRBFNPR_NOTE_NO_DATA = 2,                 /* points at a value that stands for none, left out [points, value] */
    HRBFNPR_NOTE_STRAYS = 3,                  /* points far from all others, left out [points] */
    HRBFNPR_NOTE_SOME_ORIENTED = 4,           /* so many that only some get normals [points, used] */
    HRBFNPR_NOTE_NORMALS_MADE = 5,            /* there were none [points] */
    HRBFNPR_NOTE_NORMALS_NOT_SURE = 6,        /* [confidence] */
    HRBFNPR_NOTE_FRONT_NOT_TOLD = 7,          /* which side of an open surface is its front */
    HRBFNPR_NOTE_SAMPLES_CHOSEN = 8,          /* [points, used] */
    HRBFNPR_NOTE_POINTS_NOT_USABLE = 9,       /* without a position or normal, left out [points] */
    HRBFNPR_NOTE_NORMALS_JOINED = 10,         /* several at one place: their mean [places] */
    HRBFNPR_NOTE_NORMALS_OPPOSITE = 11,       /* opposite ones at one place, left out [places] */
    HRBFNPR_NOTE_TERRAIN_TURNED = 12,         /* it looked down [axis] */
    HRBFNPR_NOTE_NORMALS_TURNED = 13,         /* all looked inward */
    HRBFNPR_NOTE_NORMALS_REPAIRED = 14,       /* [turned, made, what they were: HRBFNPR_NORMALS_...] */
    HRBFNPR_NOTE_NORMALS_AGAINST = 15,        /* those around them [normals, of] */
    HRBFNPR_NOTE_NORMALS_MIXED = 16,          /* some parts outward, others inward [share] */
    HRBFNPR_NOTE_NORMALS_INWARD = 17,         /* most of an open surface */
    HRBFNPR_NOTE_VIEWPOINT_NOT_USED = 18,
    HRBFNPR_NOTE_PIXELS_LEFT_OUT = 19,        /* of a depth camera, on no surface [pixels] */
    HRBFNPR_NOTE_DEPTH_NOISE = 20,            /* [noise, depth] */
    HRBFNPR_NOTE_SMOOTHED = 21,               /* the samples have noise, and the surface does not go through all */
    HRBFNPR_NOTE_SAMPLES_MERGED = 22,         /* at the same place [samples] */
    HRBFNPR_NOTE_SAMPLES_NEAR = 23,           /* merged with another very near [samples] */
    HRBFNPR_NOTE_SAMPLES_DROPPED = 24,        /* as strays [samples] */
    HRBFNPR_NOTE_SAMPLES_FLIPPED = 25,        /* with a flipped normal, repaired [samples] */
    HRBFNPR_NOTE_LIKE_STRAYS = 26,            /* samples that look so, and stay [samples] */
    HRBFNPR_NOTE_LIKE_FLIPPED = 27,           /* samples that look so, and stay [samples] */
    HRBFNPR_NOTE_FEW_POINTS = 28,             /* the surface is a guess [points] */
    HRBFNPR_NOTE_ON_A_LINE = 29,              /* all points */
    HRBFNPR_NOTE_IN_A_PLANE = 30,             /* all points */
    HRBFNPR_NOTE_ALONG_CURVES = 31,           /* the points: the surface between them is drawn, too */
    HRBFNPR_NOTE_END_NOT_FOUND = 32,          /* where the surface ends */
    HRBFNPR_NOTE_UP = 33,                     /* another direction than y [x, y, z] */
    HRBFNPR_NOTE_FACES_TURNED = 34,           /* against those beside them [faces] */
    HRBFNPR_NOTE_INSIDE_OUT = 35,             /* a mesh, or parts of it, turned [parts] */
    HRBFNPR_NOTE_FACES_LEFT_OUT = 36,         /* without area, or twice there [faces] */
    HRBFNPR_NOTE_PARTS_INSIDE = 37,           /* others, left out [parts, faces] */
    HRBFNPR_NOTE_CONTRARY_EDGES = 38,         /* a surface of one side, or one that crosses itself [edges] */
    HRBFNPR_NOTE_PARTS_FAR = 39,              /* from all others, left out [parts, faces] */
    HRBFNPR_NOTE_FLAPS = 40,                  /* faces on an edge of two others, left out [faces] */
    HRBFNPR_NOTE_ALL_FLAT = 41,               /* by the normals of the file */
    HRBFNPR_NOTE_EDGES_BY_NORMALS = 42,       /* some edges are sharp by the normals of the file */
    HRBFNPR_NOTE_DIVIDED = 43,                /* faces [times, vertices moved, places between them raised, off a round
                                                 surface; shares of the diagonal] */
    HRBFNPR_NOTE_COARSE_FLAT = 44,            /* faces are coarse, but nothing round goes through them */
    HRBFNPR_NOTE_GROUPS = 45,                 /* parts that cross are surfaces of their own [parts, groups] */
    HRBFNPR_NOTE_NOT_REACHED = 46,            /* the tolerance [tolerance, share of the mesh, share of the surface, farthest;
                                                 of the diagonal] */
    HRBFNPR_NOTE_EDGES_STAY_SMOOTH = 47,      /* [their length in diagonals] */
    HRBFNPR_NOTE_OFF_MESH = 48,               /* the surface, at a share of the mesh [share, farthest] */
    HRBFNPR_NOTE_MADE_BY_FIT = 49,            /* parts of surface that the mesh does not have, left out [parts] */
    HRBFNPR_NOTE_PARTS_TOO_THIN = 50,         /* parts of a mesh that the tolerance is too large for */
    HRBFNPR_NOTE_MARKS_LIMITED = 51,          /* fewer than fill the darkest tone [wanted, made] */
    HRBFNPR_NOTE_LEVELS_LIMITED = 52,         /* of the published recursion [wanted, taken] */
    HRBFNPR_NOTE_SEEN_FROM_CAMERA = 53,       /* the depth camera's [azimuth] */
    HRBFNPR_NOTE_SEEN_FROM_FRONT = 54,        /* of an open surface [azimuth] */
    HRBFNPR_NOTE_NO_LINES_OF_MARKS = 55,      /* lines want a model, and the source is a point set */
    HRBFNPR_NOTE_LINES_THIN = 56,             /* the surface is thinner than the cells that lines are looked for in
                                                 [triangles turned, of, samples missed] */
    HRBFNPR_NOTE_LINES_END = 57,              /* where the surface ends beyond its samples [borders, support, share] */
    HRBFNPR_NOTE_LINES_BROKEN = 58,           /* curves that end inside the surface [curves] */
    HRBFNPR_NOTE_LINES_DOUBTED = 59,          /* lines whose visibility contradicts itself [lines] */
    HRBFNPR_NOTE_LINES_TANGLED = 60,          /* places with too many crossings of lines [places] */
    HRBFNPR_NOTE_BLANK = 61,                  /* hardly anything can be seen [shown, marks, share of ink] */
    HRBFNPR_NOTE_PENS = 62,                   /* that were chosen by the widths at hand */
    HRBFNPR_NOTE_PLOTTED = 63,                /* [metres drawn, metres travelled, seconds] */
    HRBFNPR_NOTE_NOT_IN_SETTINGS = 64,        /* what settings do not hold */
    HRBFNPR_NOTE_UNIT_IS_METRE = 65,          /* of the format */
    HRBFNPR_NOTE_NO_SYMMETRY = 66,            /* for centre lines */
    HRBFNPR_NOTE_SECTION_OPEN = 67,           /* outlines of a cut that are not closed [outlines] */
    HRBFNPR_NOTE_NORMALS_NOT_UNIT = 68,       /* made of length 1 [normals] */
    HRBFNPR_NOTE_AT_ONE_PLACE = 69,           /* all points */
    HRBFNPR_NOTE_FAR_FROM_ORIGIN = 70,        /* for the source's size */
    HRBFNPR_NOTE_VERTICES_JOINED = 71,        /* at the place of another [vertices] */
    HRBFNPR_NOTE_VERTICES_UNUSED = 72,        /* of no face, left out [vertices] */
    HRBFNPR_NOTE_NONMANIFOLD_EDGES = 73,      /* of more than two faces [edges] */
    HRBFNPR_NOTE_MESH_OPEN = 74,              /* [borders, their edges] */
    HRBFNPR_NOTE_SEVERAL_PARTS = 75,          /* of a mesh [parts] */
    HRBFNPR_NOTE_NOT_USABLE = 76              /* why a source cannot be drawn */
};

typedef struct hrbfnpr_note {
    uint32_t struct_size;
    uint32_t code;       /* HRBFNPR_NOTE_... */
    uint32_t severity;   /* HRBFNPR_SEVERITY_... */
    uint32_t figure_count;
    double figures[8];   /* as above, in that order */
    const char* text;    /* one sentence without a full stop, UTF-8, in the words of `wording` */
    const char* advice;  /* what to do about it, in the same words; NULL where the text says it, or there is nothing to
                            say */
} hrbfnpr_note;

HRBFNPR_API hrbfnpr_status hrbfnpr_note_init(hrbfnpr_note* note, uint32_t struct_size);

/* What happens while a picture is made. */
typedef struct hrbfnpr_picture_event {
    uint32_t struct_size;
    uint32_t stage;      /* HRBFNPR_STAGE_... that runs; 0 = between two */
    double fraction;     /* of the stage, 0 when it begins, 1 when it is over */
    double seconds;      /* of the stage, when it is over */
    const char* name;    /* of the stage: "place marks" */
    const char* doing;   /* the same for a progress bar: "placing marks" */
    const char* says;    /* what the stage came to, when it is over; else NULL */
    const hrbfnpr_note* note; /* a new one; NULL = this is about the stage */
} hrbfnpr_picture_event;

HRBFNPR_API hrbfnpr_status hrbfnpr_picture_event_init(hrbfnpr_picture_event* event, uint32_t struct_size);
/* Runs on the thread that entered; what it is given lives during the call only. */
typedef void (*hrbfnpr_picture_event_fn)(void* user, const hrbfnpr_picture_event* event);

/* Every field has a default that makes a good picture; a source and, if wanted, a style are enough.
 * NaN (or 0 or NULL, where a line says so) stands for what is chosen. */
typedef struct hrbfnpr_picture_desc {
    uint32_t struct_size;
    uint32_t flags;                        /* HRBFNPR_PICTURE_...; 0 */
    const hrbfnpr_picture_source* sources; /* a list, 1 and more: each is a surface of its own */
    int64_t source_count;
    int64_t source_stride;

    /* Style. */
    uint32_t preset;               /* HRBFNPR_PRESET_...; CONTOUR_AND_STIPPLE */
    uint32_t wording;              /* HRBFNPR_WORDING_...; FIELDS */
    const char* style_name;        /* the name of a preset, in place of its number; NULL */
    const hrbfnpr_style* style;    /* used as it is, with lengths in pixels of this picture; NULL.  `preset` then says
                                      which layers of marks there are */
    const hrbfnpr_settings* settings; /* what this descriptor leaves at its defaults; kept; NULL */
    const hrbfnpr_change* changes; /* a list; NULL and 0 */
    int64_t change_count;
    int64_t change_stride;
    const hrbfnpr_dab* dabs;       /* what is painted, a list; NULL and 0 */
    int64_t dab_count;
    int64_t dab_stride;

    /* Size, in pixels. */
    int32_t width;     /* 1 .. 32768, with `height`; 0 = from `size` */
    int32_t height;
    int32_t size;      /* of the longer side, 1 .. 32768; the shorter one is as the object needs it; 0 = 1600 */
    uint32_t sides;    /* HRBFNPR_PICTURE_SIDES_...; AUTO */
    double pen;        /* radius of the pen, which styles vary a little; 0 = an 800th of the longer side, at least 0.75 */
    double line_width; /* of contours; others are finer; 0 = that of the style */

    /* Camera. */
    const hrbfnpr_camera* camera; /* used as it is, with its viewport as size; NULL */
    double up[3];        /* 0, 0, 0 = by the format and the shape, y where neither tells */
    double azimuth;      /* degrees, of the camera about the up axis; NaN = 30, and another where that sees the back of
                            an open surface */
    double elevation;    /* degrees, of the camera above the horizon; NaN = 20 */
    double direction[3]; /* from the eye into the scene, in place of these two; 0, 0, 0 = not given */
    double eye[3];       /* place of the eye, which looks at `target`; NaN = not given */
    double target[3];    /* NaN = the middle of the model */
    double fov;          /* degrees, vertical angle of view, 0 = orthographic; NaN = 30, 0 of the style archaeological */
    double margin;       /* share that is free on each side, 0 .. 0.45; NaN = 0.05 */
    double turn;         /* degrees, of an orbit that starts here: the picture has room for all of it; 0 = a still */
    int32_t turn_frames; /* of that orbit, 1 and more; 36 */

    /* From the source to a surface. */
    uint32_t normals;        /* HRBFNPR_NORMALS_...: what is known of those of points; AUTO */
    int64_t samples;         /* of a mesh, or chosen from points; 0 = as many as a mesh needs, of points all up to 4096 */
    double tolerance;        /* units of the source: samples are chosen until all is this near; 0 = 0.002 diagonals of a
                                mesh, none of points */
    int64_t maximum_centres; /* the most samples that are chosen; 0 = 8000 of a mesh, no limit of points */
    uint32_t parts;          /* HRBFNPR_PARTS_...: of a mesh; OUTER */
    uint32_t edges;          /* HRBFNPR_PICTURE_EDGES_...: of a mesh; AS_GIVEN */
    double edge_angle;       /* degrees, 5 .. 175: of EDGES_SHARP; 30 */
    double crease_angle;     /* degrees, 0 .. 180: faces that meet at a sharper angle do not share their normals; NaN = 60 */
    int32_t subdivide;       /* how often faces are divided into four towards something round, 0 .. 6; -1 = where they
                                are coarse and no edges stand out */
    uint32_t profile;        /* HRBFNPR_PROFILE_...; AUTO */
    double viewpoint[3];     /* where the scanner stood: open surfaces without normals look to it; NaN = as the source
                                tells */
    double depth_smoothing;  /* factor of the width over which the image of a depth camera is smoothed; 0 leaves its
                                points where they are; NaN = 1 */
    uint64_t random_seed;    /* of all that is random; 1 */

    /* Marks, lines, and what stands beside the drawing. */
    const char* mark_kinds;    /* kinds of layers with commas between, "stipples,hatch"; NULL = those of the style */
    hrbfnpr_array seed_points; /* n x 3: where marks of PUBLISHED start; not given */
    double hatch_angle;        /* degrees by which all lines of hatching are turned; 0 */
    const char* lines;         /* kinds with commas between: contour, suggestive, ridges, valleys, apparent, parabolic,
                                  isophotes=0.3:0.6, section=z:20, border, crease; "none": contours by marks; NULL =
                                  those of the style */
    const char* scale_bar;     /* the unit of a scale bar below the drawing; "none": no bar; NULL = "units" of the style
                                  archaeological, else "none" */

    hrbfnpr_picture_event_fn on_event; /* NULL; called for as long as the picture lives */
    void* event_user;                  /* outlives the picture */
} hrbfnpr_picture_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_picture_desc_init(hrbfnpr_picture_desc* desc, uint32_t struct_size);

/* ---- What a source holds ------------------------------------------------------ */

/* What it is. */
enum {
    HRBFNPR_SOURCE_KIND_POINTS = 1,
    HRBFNPR_SOURCE_KIND_MESH = 2,
    HRBFNPR_SOURCE_KIND_MODEL = 3,
    HRBFNPR_SOURCE_KIND_POINT_SET = 4
};

/* Which way normals look. */
enum {
    HRBFNPR_NORMALS_LOOK_UNKNOWN = 0, /* there are none, or the source cannot be drawn */
    HRBFNPR_NORMALS_LOOK_OUTWARD = 1,
    HRBFNPR_NORMALS_LOOK_INWARD = 2,
    HRBFNPR_NORMALS_LOOK_MIXED = 3,   /* some outward, others inward */
    HRBFNPR_NORMALS_LOOK_OPEN = 4,    /* they agree, and the surface encloses nothing */
    HRBFNPR_NORMALS_LOOK_FOREIGN = 5  /* they belong to other points; told of points along curves */
};

/* What is not known of this kind of source is 0, and so is what would have been found out after the finding that it
 * cannot be drawn. */
typedef struct hrbfnpr_source_info {
    uint32_t struct_size;
    uint32_t kind;            /* HRBFNPR_SOURCE_KIND_... */
    uint32_t severity;        /* HRBFNPR_SEVERITY_... of the worst finding: INFO = there is none, NOTE = a picture repairs
                                 it, WARNING, FAILURE = it cannot be drawn */
    uint32_t normals_look;    /* HRBFNPR_NORMALS_LOOK_...: of points or faces */
    int64_t points;           /* as given; vertices of a mesh, centres of a model, marks of a point set */
    int64_t triangles;        /* as given */
    int64_t no_data;          /* points at a value that stands for none; what follows is without them */
    int64_t strays;           /* points far from all others; what follows is without them */
    int64_t points_not_finite;
    int64_t duplicates;       /* points, or vertices of faces, at the place of another */
    double bounds_min[3];     /* of finite points */
    double bounds_max[3];
    double diagonal;          /* of these bounds */
    double up[3];             /* that a picture chooses by itself, of points and meshes; the reason is at the end */

    /* Normals of points; looks_down, normals_closed and normals_flipped_share of faces, too. */
    uint32_t has_normals;         /* 1: there are some that are not zero */
    uint32_t along_curves;        /* 1: the points lie along curves, as those of wires and cross sections */
    uint32_t looks_down;          /* a terrain looks down along an axis: 1 = y, 2 = z; 0 = it does not, or is none */
    uint32_t reserved;
    int64_t normals_zero;
    int64_t normals_not_finite;
    double normals_unit_share;    /* of length 1, of those that can be used; 0 .. 1 */
    double normals_closed;        /* sum of the winding numbers on both sides of the samples, in the middle: 1 closed and
                                     outward, -1 inward, 0 a flat sheet; not of points along curves */
    double normals_flipped_share; /* judged by neighbours; not of points along curves */

    /* The picture of a depth camera that has no normals. */
    int64_t image_seen;    /* pixels that have a point */
    int64_t image_dropped; /* of these, on no surface */
    double image_depth;    /* median of those that were seen */
    double image_noise;    /* standard deviation at that depth */

    /* A mesh, as given but for vertices at the same place, which are joined. */
    uint32_t closed;               /* 1: each edge has two faces, which run along it in opposite directions */
    uint32_t inside_out;           /* 1: it is closed, and its faces look inward */
    int64_t components;            /* parts that share no vertex */
    int64_t components_inside_out; /* parts without border whose faces look inward; inside another one it is a cavity */
    int64_t boundary_edges;        /* of one face */
    int64_t boundary_loops;        /* borders */
    int64_t nonmanifold_edges;     /* of more than two faces */
    int64_t nonmanifold_left;      /* what hrbfnpr_mesh_create leaves of them */
    int64_t contrary_edges;        /* of two faces, one of which is turned over */
    int64_t faces_not_finite;      /* with a corner that is not finite */
    int64_t degenerate_faces;      /* without area */
    int64_t repeated_faces;        /* with the corners of another */
    int64_t unused_vertices;       /* of no face */
    double area;
    double volume;                 /* enclosed; 0 where the mesh is not closed */

    char up_reason[128];           /* "it is so in PLY files"; "" = up is not known */
} hrbfnpr_source_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_source_info_init(hrbfnpr_source_info* info, uint32_t struct_size);

/* Looks at a source without drawing it: facts into info, findings as notes of on_event.  NOTE: what a picture repairs;
 * WARNING: what is wrong, with advice; FAILURE: a code NOT_USABLE that says why it cannot be drawn, and the call is
 * OK all the same.  One matter may be both repaired and wrong.  wording: HRBFNPR_WORDING_...; on_event and operation
 * may be NULL.
 * Errors: INVALID_ARGUMENT (fields of the source), OUT_OF_MEMORY, CANCELLED, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_source_inspect(hrbfnpr_context* context, const hrbfnpr_picture_source* source,
                                                  uint32_t wording, hrbfnpr_picture_event_fn on_event,
                                                  void* event_user, hrbfnpr_operation* operation,
                                                  hrbfnpr_source_info* info, hrbfnpr_error* error);

/* ---- Making and drawing ------------------------------------------------------ */

/* Fits, places marks and looks for lines; draws nothing yet.  operation may be NULL.
 * Needs the stack of hrbfnpr_model_fit.
 * Errors: INVALID_ARGUMENT (also for a source that cannot be drawn), SINGULAR_SYSTEM,
 * NOT_CONVERGED, OUT_OF_MEMORY, CANCELLED, CALLBACK. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_create(hrbfnpr_context* context, const hrbfnpr_picture_desc* desc,
                                                  hrbfnpr_operation* operation, hrbfnpr_picture** out_picture,
                                                  hrbfnpr_error* error);
/* The same surfaces in another style, size or view: desc has no sources.  Marks and lines
 * that fit are used again; else they are placed and looked for anew. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_restyle(const hrbfnpr_picture* picture, const hrbfnpr_picture_desc* desc,
                                                   hrbfnpr_operation* operation, hrbfnpr_picture** out_picture,
                                                   hrbfnpr_error* error);
HRBFNPR_API void hrbfnpr_picture_retain(hrbfnpr_picture* picture);  /* any thread; NULL is ignored */
HRBFNPR_API void hrbfnpr_picture_release(hrbfnpr_picture* picture); /* any thread; NULL is ignored */

/* Draws it.  camera NULL: as it was planned, and INVALID_ARGUMENT with a note BLANK if hardly
 * anything could be seen (ALLOW_BLANK lets it be).  Lines keep their numbers from one
 * drawing to the next.  operation may be NULL. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_draw(hrbfnpr_picture* picture, const hrbfnpr_camera* camera,
                                                hrbfnpr_operation* operation, hrbfnpr_drawing** out_drawing,
                                                hrbfnpr_error* error);

typedef struct hrbfnpr_picture_info {
    uint32_t struct_size;
    uint32_t preset;      /* HRBFNPR_PRESET_... */
    int64_t parts;        /* surfaces, or 1 of a point set */
    int64_t marks;        /* of all parts */
    int64_t notes;
    int64_t stages;
    int32_t width;        /* pixels, of the drawing */
    int32_t height;
    double bounds_min[3]; /* of all parts */
    double bounds_max[3];
    double up[3];         /* as used */
    double pen;           /* radius, pixels, as used */
    double seconds;       /* that it took to make */
} hrbfnpr_picture_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_picture_info_init(hrbfnpr_picture_info* info, uint32_t struct_size);
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_info(const hrbfnpr_picture* picture, hrbfnpr_picture_info* info,
                                                    hrbfnpr_error* error);

/* One surface: handles without references of their own, valid while the picture lives. */
typedef struct hrbfnpr_picture_part {
    uint32_t struct_size;
    uint32_t sides;                     /* HRBFNPR_SIDES_... as used */
    const hrbfnpr_model* model;         /* NULL of a point set */
    const hrbfnpr_point_set* point_set; /* NULL with SURFACE_ONLY */
    const hrbfnpr_line_set* line_set;   /* NULL without lines */
    const hrbfnpr_mesh* mesh;           /* of a mesh, as it was fitted to; else NULL */
} hrbfnpr_picture_part;

HRBFNPR_API hrbfnpr_status hrbfnpr_picture_part_init(hrbfnpr_picture_part* part, uint32_t struct_size);
/* number: 0 .. hrbfnpr_picture_info.parts - 1; the largest is 0. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_part(const hrbfnpr_picture* picture, int64_t number,
                                                    hrbfnpr_picture_part* part, hrbfnpr_error* error);
/* What was chosen for hrbfnpr_renderer_draw, valid while the picture lives. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_style(const hrbfnpr_picture* picture, const hrbfnpr_style** style,
                                                     hrbfnpr_error* error);
/* The descriptor that hrbfnpr_point_set_generate was given; *desc is NULL where the caller gave the marks. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_marks(const hrbfnpr_picture* picture,
                                                     const hrbfnpr_generate_desc** desc, hrbfnpr_error* error);
/* number: 0 .. hrbfnpr_picture_info.notes - 1.  The text is valid while the picture lives. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_note(const hrbfnpr_picture* picture, int64_t number,
                                                    hrbfnpr_note* note, hrbfnpr_error* error);
/* number: 0 .. hrbfnpr_picture_info.stages - 1: those that are over, as their last event. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_stage(const hrbfnpr_picture* picture, int64_t number,
                                                     hrbfnpr_picture_event* stage, hrbfnpr_error* error);

/* ---- Cameras ------------------------------------------------------------------ */

/* The camera that was planned. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_get_camera(const hrbfnpr_picture* picture, hrbfnpr_camera* camera,
                                                      hrbfnpr_error* error);
/* One from another side, with the size, the lens and the margin of the picture: along `direction`, or from azimuth and
 * elevation in degrees, where direction is NULL; NaN = as planned. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_look(const hrbfnpr_picture* picture, const double* direction,
                                                double azimuth, double elevation, hrbfnpr_camera* camera,
                                                hrbfnpr_error* error);
/* The planned one, turned about the up axis through the middle of the model (or the target of an eye). */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_orbit(const hrbfnpr_picture* picture, double degrees,
                                                 hrbfnpr_camera* camera, hrbfnpr_error* error);

/* ---- As an image and as vectors ------------------------------------------------ */

/* A plate is a drawing with the section and the scale bar that the picture has beside it; without these it is the
 * drawing alone.  In this part `camera` is the one that the drawing was made by; NULL = the planned one.
 * *width and *height get the pixels of the plate. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_plate_size(const hrbfnpr_picture* picture, const hrbfnpr_camera* camera,
                                                      int32_t* width, int32_t* height, hrbfnpr_error* error);
/* The plate as an image of at least plate_size pixels, from its top-left corner; as hrbfnpr_drawing_rasterize. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_rasterize(const hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing,
                                                     const hrbfnpr_camera* camera, const hrbfnpr_image* image,
                                                     hrbfnpr_error* error);

/* On which paper a drawing is written, and with which pens. */
typedef struct hrbfnpr_picture_page_desc {
    uint32_t struct_size;
    uint32_t reserved;
    const hrbfnpr_page_desc* page; /* format, flags, tolerance, speeds, pens and the like; its items, annotations and
                                      size are set by this call, and its title, description and metadata where they
                                      are NULL; NULL = its defaults */
    const char* paper;             /* "a0" .. "a6", "letter", "legal", "tabloid", or "210x297" in mm: the drawing fills
                                      it, turned as it fits better; NULL = a pixel is 25.4 / 96 mm */
    double paper_margin;           /* mm, free on each side of the paper; 10 */
    hrbfnpr_array pen_widths;      /* FLOAT64, 1, mm, ascending: of the pens at hand; each group gets that which is
                                      nearest to its lines' median width; not given */
} hrbfnpr_picture_page_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_picture_page_desc_init(hrbfnpr_picture_page_desc* desc, uint32_t struct_size);
/* The plate as vectors; as hrbfnpr_page_write.  desc, info and operation may be NULL.  Adds notes PENS and PLOTTED. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_write(hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing,
                                                 const hrbfnpr_camera* camera,
                                                 const hrbfnpr_picture_page_desc* desc, hrbfnpr_write_fn write,
                                                 void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation,
                                                 hrbfnpr_error* error);

/* ---- Settings: a descriptor as JSON --------------------------------------------- */

/* Reads what _write_settings or the viewer wrote (docs/settings.md).
 * Errors: IO, INVALID_ARGUMENT that names the key and what would be right, OUT_OF_MEMORY. */
HRBFNPR_API hrbfnpr_status hrbfnpr_settings_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
                                                 hrbfnpr_settings** out_settings, hrbfnpr_error* error);
HRBFNPR_API void hrbfnpr_settings_retain(const hrbfnpr_settings* settings);  /* any thread; NULL is ignored */
HRBFNPR_API void hrbfnpr_settings_release(const hrbfnpr_settings* settings); /* any thread; NULL is ignored */
/* Writes what a picture was made with.  What settings do not hold becomes a note NOT_IN_SETTINGS. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_write_settings(hrbfnpr_picture* picture, hrbfnpr_write_fn write,
                                                          void* user, hrbfnpr_error* error);

/*
 * ==========================================================================
 * 15  VIEWS: technical drawings on a sheet, to scale
 * ==========================================================================
 *
 * A sheet has orthographic views of a model, and sections, with the line conventions
 * of ISO 128: outlines are thick, hidden edges thin and dashed, cut faces hatched.
 * Views stand around the front view [ISO 5456-2], sections follow at the right, or
 * below if they are seen from above.  Where lines coincide one is drawn: outlines of
 * cuts before visible edges, then hidden ones, then smooth ones [ISO 128-2].  The
 * sheet has a frame [ISO 5457], a title block [ISO 7200] without a date, a scale bar,
 * and arrows and letters where it is cut [ISO 128-3].
 *
 * The model stands along the up axis of its picture; its front is +z, or -y where z
 * is up.  Contours and outlines of cuts are curves of the surface.  Sharp edges are
 * those of the model, or of the mesh that it was fitted to.
 *
 * Layers of the page have the name of their kind of lines and of their view: "outlines
 * front", "hidden top", "hatching A-A".  Of plotters, pen 1 is the wide one, pen 2 the
 * fine one.
 */

enum {
    HRBFNPR_VIEWS_CENTRE_LINES = 1, /* planes of symmetry through the middle have a centre line in each view that sees
                                       them as a line; a note NO_SYMMETRY says that there are none */
    HRBFNPR_VIEWS_LABELS = 2,       /* the name of each view stands above it; that of a section always does */
    HRBFNPR_VIEWS_UNIT_IS_METRE = 4 /* the format of the source is in metres, as glTF: a unit_mm of 0 is 1000, with a
                                       note UNIT_IS_METRE */
};

/* Where views stand [ISO 5456-2]. */
enum {
    HRBFNPR_VIEWS_ANGLE_FIRST = 0, /* first angle: the left view at the right, the top view below */
    HRBFNPR_VIEWS_ANGLE_THIRD = 1  /* third angle: the left view at the left, the top view above */
};

/* Hidden edges.  Sections never have any [ISO 128-3]. */
enum {
    HRBFNPR_VIEWS_HIDDEN_DASHED = 0, /* dashed thin lines */
    HRBFNPR_VIEWS_HIDDEN_NONE = 1,   /* they are not drawn */
    HRBFNPR_VIEWS_HIDDEN_SHOWN = 2   /* continuous thin lines */
};

/* Texts are UTF-8 and are read during the call only. */
typedef struct hrbfnpr_views_desc {
    uint32_t struct_size;
    uint32_t flags;       /* HRBFNPR_VIEWS_...; 0 */
    uint32_t projection;  /* HRBFNPR_VIEWS_ANGLE_...; FIRST */
    uint32_t hidden;      /* HRBFNPR_VIEWS_HIDDEN_...; DASHED */
    const char* views;    /* names with commas between: front, back, left, right, top, bottom, iso; each is drawn once.
                             NULL = "front,left,top,iso", with ANGLE_THIRD "front,right,top,iso" */
    const char* sections; /* planes with semicolons between: "z:20" cuts at z = 20, "z" through the middle, "1:1:0:5" at
                             x + y = 5.  An axis without a sign is seen from the front, from above or from the side that
                             is drawn; "+z:20" from above, "-z:20" from below.  They are called A-A, B-B, ...; NULL =
                             none */
    const char* paper;    /* "a0" .. "a6", "letter", "legal" or "tabloid", lying, or "297x210", width and height in mm;
                             "auto" = the smallest of a4 to a0 that has room at the scale, a3 where the scale is "auto",
                             too; NULL = "auto" */
    const char* scale;    /* "1:2" = half as large as it is; "auto" = the largest of 1, 2 and 5 times a power of ten
                             [ISO 5455] that has room on the paper; NULL = "auto" */
    const char* smooth;   /* thin lines where the surface bends without an edge: kinds with commas between, ridges,
                             valleys, suggestive; "none"; NULL = "none" */
    const char* title;    /* in the title block; NULL or "" = `model` without the ending of its name */
    const char* model;    /* the file's name, in the title block; NULL or "" = the name of the picture's source */
    double unit_mm;       /* mm of a unit of the model, up to 1e9; 0 = 1, or 1000 with UNIT_IS_METRE */
    double crease_angle;  /* degrees, > 0: edges of a mesh are sharp if its faces meet at more than this; 30.  Larger:
                             fewer edges */
    double line_width;    /* mm, 0.01 .. 1000: of outlines; thin lines are half as wide; 0.5 */
    double hatch_spacing; /* mm, 0.01 .. 1000: between the lines in cut faces; 3 */
    double spacing;       /* mm, > 0: free between views; 15 */
    const hrbfnpr_page_desc* page; /* format, flags, tolerance, speeds and the like; its items, annotations, pens and
                                      size are set by this call, and its title and description where they are NULL; NULL
                                      = its defaults with a tolerance of 0.02 */
} hrbfnpr_views_desc;

HRBFNPR_API hrbfnpr_status hrbfnpr_views_desc_init(hrbfnpr_views_desc* desc, uint32_t struct_size);

/* What was drawn. */
typedef struct hrbfnpr_views_info {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t views;       /* sections are among them */
    int64_t bytes;       /* that were written */
    double width;        /* mm, of the page */
    double height;       /* mm, of the page */
    double scale;        /* 0.5 of 1:2 */
    double unit_mm;      /* mm of a unit of the model, as used */
    char scale_text[64]; /* "1:2" */
    char paper[64];      /* "a3", "297 x 210" */
} hrbfnpr_views_info;

HRBFNPR_API hrbfnpr_status hrbfnpr_views_info_init(hrbfnpr_views_info* info, uint32_t struct_size);

/* Draws the first part of a picture, which has a model, as a sheet of views; a picture made with SURFACE_ONLY is
 * enough.  desc, info and operation may be NULL.  The picture gets stages LINES and VIEWS, and notes UNIT_IS_METRE,
 * NO_SYMMETRY and SECTION_OPEN.
 * Errors: INVALID_ARGUMENT (a picture of a point set; a text that is not understood; a plane that misses the model;
 * views that have no room on the paper at the scale: the message says which scale or paper has), and those of
 * hrbfnpr_line_set_create, hrbfnpr_renderer_draw and hrbfnpr_page_write. */
HRBFNPR_API hrbfnpr_status hrbfnpr_picture_write_views(hrbfnpr_picture* picture, const hrbfnpr_views_desc* desc,
                                                       hrbfnpr_write_fn write, void* user, hrbfnpr_views_info* info,
                                                       hrbfnpr_operation* operation, hrbfnpr_error* error);

#ifdef __cplusplus
}
#endif

#endif /* HRBFNPR_H */
