// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.
//! hrbfnpr.h: Hermite RBF implicit surfaces, drawn in pen and ink.
//!
//! The library fits a smooth implicit surface to points with normals, places
//! marks on the surface, and draws the marks into an image of the caller or
//! hands them over as vertex arrays.  The method is that of
//!
//!   Vital Brazil, Macedo, Sousa, Velho, de Figueiredo: "A Few Good Samples:
//!   Shape & Tone Depiction for Hermite RBF Implicits", NPAR 2010,
//!
//! which the comments below cite as [NPAR] with a section number.
//!
//! SPDX-License-Identifier: MIT
//!
//! # CONTRACTS that hold for every function below
//!
//! Handles.  A handle is an opaque pointer.  Several threads may call functions
//!   that take `const T*` with the same handle at the same time.  A function
//!   that takes `T*` must be the only one that uses the handle.  Comments name
//!   the exceptions: _retain, _release and hrbfnpr_operation_cancel run on any
//!   thread at any time.  Several threads may use one context at the same time;
//!   its callbacks then run on all these threads.
//!
//! Ownership.  `_create`, `_fit`, `_generate` and `_load` return a handle with
//!   one reference.  `_retain` adds a reference.  `_release` removes one; the
//!   last one destroys the object.  Both ignore NULL.  A handle keeps alive
//!   whatever it needs of other handles, so handles may be released in any
//!   order.  A call reads input arrays before it returns and keeps no pointer to
//!   the caller's memory, unless its comment says so.  The caller never frees
//!   memory that the library returns.
//!
//! Descriptors.  A struct whose first field is `struct_size` must be set up with
//!   its function `_init(desc, sizeof *desc)`, which sets every field to its
//!   default.  New versions of the library add fields at the end of a struct
//!   only.  An older caller's struct is shorter: the missing fields have their
//!   defaults.  A newer caller's struct is longer: it is refused with
//!   UNSUPPORTED_STRUCT if the unknown fields are not all zero.  A struct_size
//!   below 8 or above 65536 is refused with the same status, because the struct
//!   was not set up.  `_init` of NULL returns INVALID_ARGUMENT.  Fields named
//!   `reserved` must be zero.
//!
//! Results.  Output structs (`_info`) are filled up to their struct_size.
//!   Result structs (_projection, _curvature, _ray_hits) describe arrays of the
//!   caller that a call fills; the numbers in them are written if struct_size
//!   has room for them.
//!
//! Lists.  A list of structs is a pointer, a count and a stride.  The stride is
//!   the number of bytes from one element to the next; 0 = the struct_size of
//!   the first element.  Each element is a descriptor with its own struct_size.
//!   If a list is too long, the message names the largest length.
//!
//! Failure.  A call that can fail returns a status.  Its last parameter is an
//!   hrbfnpr_error, which may be NULL.  A failed call leaves the caller's arrays
//!   and output structs untouched and sets `*out_handle` to NULL.  The message
//!   names the wrong argument, says what is wrong, and says what to do.  No C++
//!   exception, abort or signal leaves the library, and it prints nothing.  One
//!   exception: if one of the calls evaluate, project, curvature, cast_rays and
//!   contains fails or is cancelled, it may already have written a part of its
//!   arrays.
//!
//! Common errors.  Comments list the errors that are special to a call.  In
//!   addition, every call may return INVALID_ARGUMENT (a needed pointer is NULL,
//!   or an argument is out of its range), UNSUPPORTED_STRUCT (see Descriptors),
//!   OUT_OF_MEMORY, CANCELLED (if it takes an operation) and CALLBACK (a custom
//!   function or run_tasks of the caller failed).
//!
//! Arrays.  Strides are in bytes.  They may be negative or larger than the
//!   element; 0 = packed.  Elements need no alignment.  Every call checks
//!   count * stride for overflow before it touches the array.  Input and output
//!   arrays of one call must not overlap, unless the comment of the call allows
//!   it.
//!
//! Geometry.  Coordinate systems are right-handed.  A matrix has 16 doubles in
//!   column-major order and acts on column vectors, as in OpenGL.  Pixel (i, j)
//!   covers [i, i+1) x [j, j+1); its centre is at (i + 0.5, j + 0.5), and j
//!   grows downward from the first row.  Lengths are in the unit of the caller's
//!   samples, unless a comment says otherwise.  Normals point outward.
//!   "Diagonal" is the length of the diagonal of the samples' bounding box; for
//!   a model without samples, that of its bounds.  The "search box" of a model
//!   is the box of its bounds, enlarged by 0.05 diagonals on every side.
//!
//! Determinism.  The same input gives the same bits for every number of threads
//!   and every thread backend, on one build and one instruction set.
//!
//! Threads.  A context starts its threads in the first call that needs them and
//!   ends them with the last reference to it.  With thread_count 1 or a
//!   `run_tasks` callback it starts none.  The library's threads take no signals
//!   of the host.  After fork() the child may go on with the parent's contexts,
//!   which start new threads in it, but the fork must not happen inside a call
//!   (in a callback).  If the library is unloaded while a context has threads, it
//!   stays in memory.  Callbacks run only on the thread that called the library,
//!   unless they are flagged thread-safe.  No call changes the caller's
//!   floating-point state, locale or OpenMP settings.
//!
//! Stacks.  Every call except hrbfnpr_model_fit, hrbfnpr_model_fit_mesh and
//!   hrbfnpr_orient runs on a thread stack of 64 KiB; 12 KiB of them are for the
//!   caller's own frames and callbacks.  These three calls need 512 KiB on the
//!   calling thread and, with `run_tasks`, on the threads that run their tasks.
//!   The stack does not grow with the number of samples or marks.
//!
//! Callbacks.  A callback must return normally: it must not throw, longjmp, or
//!   call the library with the same non-const handle.  It runs in the default
//!   floating-point state (round to nearest, no traps).
//!
//! # OPERATION: progress and cancelling of one long call
//!
//! Pass an operation to a long call, then poll and cancel it from any thread.  An
//! operation serves one call at a time; a second call at the same time fails with
//! INVALID_ARGUMENT.  It may serve other calls afterwards: each sets the progress
//! back to 0.  A cancelled operation stays cancelled, and every later call that
//! takes it returns CANCELLED at once.
//!
//! Streams save and load models and point sets.  Both callbacks run on the thread
//! that called the library.
//!
//! # MODEL: an implicit surface f = 0, immutable [NPAR 4]
//!
//! A model is a function f of the place x.  The surface is where f = 0, the inside
//! is where f < 0.  Four calls make models: hrbfnpr_model_fit from samples,
//! hrbfnpr_model_fit_mesh from triangles (such a model may consist of several
//! smooth "sheets" that meet in creases), hrbfnpr_model_create_custom from a
//! function of the caller, and hrbfnpr_model_create_csg from other models and
//! primitives.
//!
//! --------------------------------------------------------------------------
//! Where a surface ends.  A fitted surface goes on where its samples end: that of
//! one view of a scan, or of a terrain, goes on to the end of the search box.  It
//! may also have sheets where there never was a sample.  Trimming leaves both out.
//!
//! A number s(x) tells how badly the samples support the surface at the place x.
//! It is near -4.7 among samples and grows away from them, and where they face
//! another way (docs/lines.md gives the formula).  Trimming looks at the connected
//! parts of the surface where s is above `limit`.  It leaves out a part that
//! reaches the end of the search box.  It also leaves out a part that is somewhere
//! farther than `hole` from all samples and has an s of 6 or more (with `closest`
//! above 0, the distance is enough).  Other parts are holes between samples, and
//! stay: the surface closes them.  Samples along curves, such as wires and cross
//! sections, have no holes between them: only parts that reach the end of the box
//! are left out.
//!
//! # POINT SET: layers of marks on a surface, immutable [NPAR 4.2, 5]
//!
//! A point set is a list of layers.  A layer is a list of marks of one kind, which
//! are made in one way and drawn in one style.  The number of a layer is its place
//! in the list, from 0.  The marks of some layers form strokes.
//!
//! # LINE SET: what the lines of a surface are drawn from, immutable
//!
//! Contours as curves, traced on the surface itself for every camera, with a
//! visibility that is counted and checked (Appel 1967, quantitative
//! invisibility; Benard & Hertzmann 2019).  A line set is made once for a model;
//! an item that has one, and a style with lines, is drawn with curves in the
//! place of contour marks.
//!
//! # RENDERER: from items and a camera to a drawing [NPAR 6]
//!
//! A renderer is the scratch of one thread.  It keeps a few of its last drawings
//! and makes the next one in the memory of one that nobody else holds: a program
//! that releases each drawing before it asks for the next but one allocates
//! nothing once warm.  The last drawing's point sets live until the next is made,
//! or the renderer is released.
//!
//! # DRAWING: a picture as a value, immutable
//!
//! A drawing is dots and strokes in window coordinates, in layers of one ink and
//! one class each.  A mark's id is 1 + its running number, counted over items
//! and layers in order.  All that reads a drawing may run on several threads at
//! the same time; what memory it needs for that, the context keeps for the next.
//!
//! ---- As an image ----------------------------------------------------------
//!
//! ---- As vertices ----------------------------------------------------------
//!
//! ---- As numbers for the marks of a set -------------------------------------
//!
//! ---- Picking ---------------------------------------------------------------
//!
//! # MESH: triangles as they come, made usable; samples, fits and errors by it
//!
//! A mesh is immutable.  Making one repairs what can be repaired, and counts it:
//! vertices in exactly the same place are joined, triangles without area and
//! repeated ones left out, unused vertices dropped; of each component the faces
//! are turned to agree, and a closed one that is inside out is turned whole.
//!
//! # PAGE: drawings as vectors: SVG, PDF, HPGL, G-code
//!
//! A page holds drawings, each at its place and scale, and texts and lines beside
//! them.  Its unit is the millimetre, from the top-left corner, y down.  Strokes are
//! cubic Bezier curves within a tolerance of the drawing's [Schneider 1990], or for
//! plotters straight lines within it.
//!
//! Ink stands in named groups, the layers of a file: of marks the layer's name in
//! its point set, such as "stipples" or "hatch-2"; of lines "contour", "suggestive",
//! "ridge", "valley", "apparent ridge", "parabolic", "isophote", "section", "border",
//! or the name of own ones.  What is behind n layers of surface has " hidden n" at its end, a second
//! layer of the same name " 2".  Groups follow the layers of the drawing, hidden ones
//! before the others; in a group strokes stand far to near.  Where inks of several
//! colours lie upon each other groups begin anew, with ", run 2" behind their names,
//! and so on up to 32, so that all is painted far to near there, as the raster does;
//! not in plot order, where each pen is taken up once.  Pens go by names without that.
//! The bytes are the same for every thread count and locale.
//!
//! # PICTURE: from any source to a drawing in one call
//!
//! A picture chooses what a user leaves open: repairs, samples, the fit, where the
//! surface ends, which way is up, the camera, the size of the pen, how many marks
//! there are, and which lines are drawn.  It is made of the calls of the sections
//! above, and each part of it can be taken out and used by them.
//!
//! Every choice that a user may want to know is a note: a code, its figures and a
//! sentence.  A picture keeps its notes and the seconds of its stages.
//!
//! ---- What is drawn ----------------------------------------------------------
//!
//! ---- How it is drawn ---------------------------------------------------------
//!
//! ---- What a source holds ------------------------------------------------------
//!
//! ---- Making and drawing ------------------------------------------------------
//!
//! ---- Cameras ------------------------------------------------------------------
//!
//! ---- As an image and as vectors ------------------------------------------------
//!
//! ---- Settings: a descriptor as JSON ---------------------------------------------
//!
//! # VIEWS: technical drawings on a sheet, to scale
//!
//! A sheet has orthographic views of a model, and sections, with the line conventions
//! of ISO 128: outlines are thick, hidden edges thin and dashed, cut faces hatched.
//! Views stand around the front view [ISO 5456-2], sections follow at the right, or
//! below if they are seen from above.  Where lines coincide one is drawn: outlines of
//! cuts before visible edges, then hidden ones, then smooth ones [ISO 128-2].  The
//! sheet has a frame [ISO 5457], a title block [ISO 7200] without a date, a scale bar,
//! and arrows and letters where it is cut [ISO 128-3].
//!
//! The model stands along the up axis of its picture; its front is +z, or -y where z
//! is up.  Contours and outlines of cuts are curves of the surface.  Sharp edges are
//! those of the model, or of the mesh that it was fitted to.
//!
//! Layers of the page have the name of their kind of lines and of their view: "outlines
//! front", "hidden top", "hatching A-A".  Of plotters, pen 1 is the wide one, pen 2 the
//! fine one.
#![no_std]
#![allow(non_camel_case_types)]
#![allow(rustdoc::broken_intra_doc_links)] // [NPAR 4.1] is none

#[cfg(hrbfnpr_no_core_c_char)]
extern crate std;

#[cfg(not(hrbfnpr_no_core_c_char))]
use core::ffi::c_char;
use core::ffi::c_void;
use core::marker::{PhantomData, PhantomPinned};
#[cfg(hrbfnpr_no_core_c_char)]
use std::os::raw::c_char;

mod layout;

// 1  VERSION

// The version of this header.  HRBFNPR_ABI_VERSION is the number in the SONAME
// of the shared library.  It changes only when an existing binary would break.
pub const HRBFNPR_VERSION_MAJOR: u32 = 0;
pub const HRBFNPR_VERSION_MINOR: u32 = 1;
pub const HRBFNPR_VERSION_PATCH: u32 = 0;
pub const HRBFNPR_ABI_VERSION: u32 = 1;

extern "C" {
    /// Returns the library's version as major * 10000 + minor * 100 + patch.
    pub fn hrbfnpr_version() -> u32;
    /// Returns the library's ABI version.  Compare it with HRBFNPR_ABI_VERSION.
    pub fn hrbfnpr_abi_version() -> u32;
    /// Returns the library's version as "major.minor.patch": static, UTF-8, never NULL.
    pub fn hrbfnpr_version_string() -> *const c_char;
}

// 2  STATUS AND ERRORS

/// The result of a call.  0 is success, negative numbers are failures.  The
/// numbers never change.  Treat a number that is not in the list like INTERNAL.
pub type hrbfnpr_status = i32;

/// success
pub const HRBFNPR_STATUS_OK: hrbfnpr_status = 0;
/// an argument is wrong: the message names it and says what to do
pub const HRBFNPR_STATUS_INVALID_ARGUMENT: hrbfnpr_status = -1;
/// the allocator returned NULL
pub const HRBFNPR_STATUS_OUT_OF_MEMORY: hrbfnpr_status = -2;
/// only the needed size has been written
pub const HRBFNPR_STATUS_BUFFER_TOO_SMALL: hrbfnpr_status = -3;
/// struct_size is out of range, or unknown fields are not zero
pub const HRBFNPR_STATUS_UNSUPPORTED_STRUCT: hrbfnpr_status = -4;
/// the fit has no numerically unique solution
pub const HRBFNPR_STATUS_SINGULAR_SYSTEM: hrbfnpr_status = -5;
/// an iteration ended before it reached its goal
pub const HRBFNPR_STATUS_NOT_CONVERGED: hrbfnpr_status = -6;
/// hrbfnpr_operation_cancel or a progress callback ended the call
pub const HRBFNPR_STATUS_CANCELLED: hrbfnpr_status = -7;
/// a read or write callback failed
pub const HRBFNPR_STATUS_IO: hrbfnpr_status = -8;
/// a stream is of another format, truncated or damaged
pub const HRBFNPR_STATUS_CORRUPT_DATA: hrbfnpr_status = -9;
/// a stream is newer than the library, or the header has another ABI version
pub const HRBFNPR_STATUS_VERSION_MISMATCH: hrbfnpr_status = -10;
/// a callback of the caller returned non-zero or gave invalid results
pub const HRBFNPR_STATUS_CALLBACK: hrbfnpr_status = -11;
/// a bug in the library: please report it
pub const HRBFNPR_STATUS_INTERNAL: hrbfnpr_status = -99;

extern "C" {
    /// Returns the name of a status, such as "INVALID_ARGUMENT", or "UNKNOWN" for a
    /// number that is not in the list.  The text is static and never NULL.
    pub fn hrbfnpr_status_name(status: hrbfnpr_status) -> *const c_char;
}

/// Describes a failure in words.  The caller owns it, sets it up once with
/// hrbfnpr_error_init, and may use it for any number of calls.  A call leaves it
/// untouched if the call succeeds or if struct_size is below 256.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_error {
    /// bytes; set by hrbfnpr_error_init
    pub struct_size: u32,
    /// the status that the failed call returned
    pub status: hrbfnpr_status,
    /// UTF-8, zero-terminated; a longer message is cut between two characters
    pub message: [c_char; 248],
}

extern "C" {
    /// Sets struct_size, the status OK and an empty message.
    ///
    /// Errors: INVALID_ARGUMENT: `error` is NULL.  UNSUPPORTED_STRUCT: struct_size is
    /// below 256.
    pub fn hrbfnpr_error_init(error: *mut hrbfnpr_error, struct_size: u32) -> hrbfnpr_status;
    /// Writes what this build of the library is, as one JSON object with the keys
    /// version, abi, compiler, instruction_sets, thread_backends and dependencies.
    ///
    /// destination:   receives the text with a terminating zero; may be NULL if capacity is 0
    /// capacity:      the size of destination in bytes, 0 or more
    /// needed:        receives the bytes that the text needs, with its zero; may be NULL
    ///
    /// Errors: BUFFER_TOO_SMALL: capacity is below *needed; only *needed is written.
    pub fn hrbfnpr_build_info(
        destination: *mut c_char,
        capacity: i64,
        needed: *mut i64,
    ) -> hrbfnpr_status;
    /// Returns how this build lays out a struct, such as "hrbfnpr_fit_desc", as one
    /// JSON object.  Its keys are name, size, align and fields: a list of objects with
    /// name, type, offset and size (bytes), in the order of the header.  For NULL it
    /// returns a list of all structs.  A binding can compare its own structs with it
    /// before the first call.  The text is static and UTF-8.  The result is NULL if
    /// there is no struct of that name.
    pub fn hrbfnpr_layout(name: *const c_char) -> *const c_char;
}

// 3  VIEWS of the caller's memory

// The type of the numbers in an array.
/// float
pub const HRBFNPR_SCALAR_FLOAT32: u32 = 1;
/// double
pub const HRBFNPR_SCALAR_FLOAT64: u32 = 2;
/// uint8_t
pub const HRBFNPR_SCALAR_UINT8: u32 = 3;
/// uint32_t
pub const HRBFNPR_SCALAR_UINT32: u32 = 4;
/// int32_t
pub const HRBFNPR_SCALAR_INT32: u32 = 5;
/// int64_t
pub const HRBFNPR_SCALAR_INT64: u32 = 6;

/// A view of an array that a call reads: `count` elements of `components` scalars
/// each, `stride` bytes apart.  It does not own the memory.  An array with data
/// NULL and count 0 is "not given".
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_array {
    /// the first element
    pub data: *const c_void,
    /// number of elements
    pub count: i64,
    /// bytes from one element to the next; may be negative; 0 = packed
    pub stride: i64,
    /// HRBFNPR_SCALAR_...: the type of each scalar
    pub scalar: u32,
    /// number of scalars in an element, packed side by side
    pub components: u32,
}

/// A view of an array that a call writes.  The fields are those of hrbfnpr_array.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_array_out {
    /// the first element
    pub data: *mut c_void,
    /// number of elements
    pub count: i64,
    /// bytes from one element to the next; may be negative; 0 = packed
    pub stride: i64,
    /// HRBFNPR_SCALAR_...: the type of each scalar
    pub scalar: u32,
    /// number of scalars in an element, packed side by side
    pub components: u32,
}

// The format of an image's pixels.  The name gives the order of the channels in
// memory.  A channel has 8 bits or is a float.  Colours are sRGB-encoded.
// PREMULTIPLIED: colours are multiplied by alpha.
/// 4 bytes
pub const HRBFNPR_FORMAT_RGBA8: u32 = 1;
/// 4 bytes
pub const HRBFNPR_FORMAT_BGRA8: u32 = 2;
/// 4 bytes
pub const HRBFNPR_FORMAT_RGBA8_PREMULTIPLIED: u32 = 3;
/// 4 bytes
pub const HRBFNPR_FORMAT_BGRA8_PREMULTIPLIED: u32 = 4;
/// 4 FLOAT32 from 0 to 1, aligned to 4 bytes
pub const HRBFNPR_FORMAT_RGBA32F: u32 = 5;
/// 4 FLOAT32 from 0 to 1, aligned to 4 bytes
pub const HRBFNPR_FORMAT_RGBA32F_PREMULTIPLIED: u32 = 6;
/// one byte: the share of the pixel that ink covers, of any colour
pub const HRBFNPR_FORMAT_COVERAGE8: u32 = 7;

/// An image of the caller.  `pixels` is the top-left pixel for either sign of
/// row_stride: for an image that is stored bottom-up, pass the address of its
/// last row and a negative row_stride.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_image {
    pub struct_size: u32,
    /// HRBFNPR_FORMAT_...; default RGBA8
    pub format: u32,
    /// pixels; 1 to 32768
    pub width: i32,
    /// pixels; 1 to 32768
    pub height: i32,
    /// the top-left pixel
    pub pixels: *mut c_void,
    /// bytes from a row to the row below; at least a row's bytes, or their negative; 0 = packed
    pub row_stride: i64,
}

extern "C" {
    /// Sets every field to its default; the size and the pixels are the caller's to set.
    pub fn hrbfnpr_image_init(image: *mut hrbfnpr_image, struct_size: u32) -> hrbfnpr_status;
}

// 4  CONTEXT: allocator, threads and log, which everything else needs

/// A handle that holds the allocator, the threads and the log.  All other handles
/// are made from a context.
#[repr(C)]
pub struct hrbfnpr_context {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Allocates `size` bytes with an alignment of `alignment` bytes, a power of two.
/// It returns NULL if there is no memory; the call then fails with OUT_OF_MEMORY.
/// It runs on every thread that does the library's work.
pub type hrbfnpr_allocate_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, size: u64, alignment: u64) -> *mut c_void>;

/// Frees memory that the allocate function returned.  size and alignment are
/// those of the allocation.
pub type hrbfnpr_deallocate_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, memory: *mut c_void, size: u64, alignment: u64)>;

// The level of a message in the log.
/// details for developers of the library
pub const HRBFNPR_LOG_DEBUG: i32 = 0;
/// what a call did, with counts and times
pub const HRBFNPR_LOG_INFO: u32 = 1;
/// the result may not be what the caller expects
pub const HRBFNPR_LOG_WARNING: u32 = 2;

/// Receives a message of the log.  `message` is UTF-8 and valid only during the
/// callback, which runs on the thread that called the library.
pub type hrbfnpr_log_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, level: i32, message: *const c_char)>;

/// A task of the library, which the caller's hrbfnpr_run_tasks_fn calls once for
/// every index in [0, count).
pub type hrbfnpr_task_fn = Option<unsafe extern "C" fn(task_context: *mut c_void, index: i64)>;

/// Runs tasks on the caller's job system: it calls task(task_context, i) once for
/// every i in [0, task_count), on any threads and in any order, and returns when
/// all calls have ended.  The library may call it again on a thread that runs a
/// task.  If tasks were left out or ran twice, the library call fails with
/// CALLBACK, and the message gives their number.
pub type hrbfnpr_run_tasks_fn = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        task: hrbfnpr_task_fn,
        task_context: *mut c_void,
        task_count: i64,
    ),
>;

// Instruction sets of processors, for `highest_instruction_set` and `instruction_set`.
/// the best one that both the build and the processor have
pub const HRBFNPR_INSTRUCTION_SET_AUTO: u32 = 0;
/// the one that the library was compiled for
pub const HRBFNPR_INSTRUCTION_SET_BASELINE: u32 = 1;
/// x86: 256 bits
pub const HRBFNPR_INSTRUCTION_SET_AVX2: u32 = 2;
/// x86: 512 bits
pub const HRBFNPR_INSTRUCTION_SET_AVX512: u32 = 3;
/// Arm: 128 bits
pub const HRBFNPR_INSTRUCTION_SET_NEON: u32 = 4;

// Which threads run the library's tasks.  The choice does not change the bits of
// any result.  docs/hosts.md compares them.
/// RUN_TASKS if run_tasks is given, else POOL
pub const HRBFNPR_THREAD_BACKEND_AUTO: u32 = 0;
/// threads that the context owns. The calling thread takes part and waits only for tasks that
/// others have begun, so a processor that is busy with other work costs little. Idle threads
/// sleep
pub const HRBFNPR_THREAD_BACKEND_POOL: u32 = 1;
/// the threads of the OpenMP runtime, shared with a host that uses it; serial in a forked
/// child. Use it only if no other work needs the processors. INVALID_ARGUMENT in a build
/// without OpenMP (hrbfnpr_build_info lists thread_backends)
pub const HRBFNPR_THREAD_BACKEND_OPENMP: u32 = 2;
/// the host's job system, through run_tasks
pub const HRBFNPR_THREAD_BACKEND_RUN_TASKS: u32 = 3;
/// the calling thread alone, as with thread_count 1
pub const HRBFNPR_THREAD_BACKEND_SERIAL: u32 = 4;

/// How a context works.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_context_desc {
    pub struct_size: u32,
    /// set by _init to HRBFNPR_ABI_VERSION. Another number is VERSION_MISMATCH
    pub abi_version: u32,
    /// number of threads; 0 or more; default 0 = one for each processor; 1 = serial. At most 256 are used
    pub thread_count: i32,
    /// must be 0
    pub flags: u32,
    /// HRBFNPR_THREAD_BACKEND_...; default AUTO
    pub thread_backend: u32,
    /// HRBFNPR_INSTRUCTION_SET_...; default AUTO. A cap: better ones are not used
    pub highest_instruction_set: u32,
    /// NULL (default) = aligned operator new. Give both functions or neither
    pub allocate: hrbfnpr_allocate_fn,
    /// NULL (default) = operator delete
    pub deallocate: hrbfnpr_deallocate_fn,
    /// passed to allocate and deallocate
    pub allocator_user: *mut c_void,
    /// receives messages; NULL (default) = no log
    pub log: hrbfnpr_log_fn,
    /// passed to log
    pub log_user: *mut c_void,
    /// HRBFNPR_LOG_...; default DEBUG. Messages below this level are not reported
    pub log_level: i32,
    pub reserved: u32,
    /// the host's job system; NULL (default) = none. Needs thread_backend AUTO or RUN_TASKS
    pub run_tasks: hrbfnpr_run_tasks_fn,
    /// passed to run_tasks
    pub run_tasks_user: *mut c_void,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_context_desc_init(
        desc: *mut hrbfnpr_context_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Creates a context.  `desc` NULL = all defaults.  The callbacks and their user
    /// pointers must stay valid until the context and everything that was made from
    /// it are released.
    ///
    /// Errors: VERSION_MISMATCH: the header and the library have different ABI
    /// versions.
    pub fn hrbfnpr_context_create(
        desc: *const hrbfnpr_context_desc,
        out_context: *mut *mut hrbfnpr_context,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference. Any thread.
    pub fn hrbfnpr_context_retain(context: *mut hrbfnpr_context);
    /// Removes a reference. Any thread.
    pub fn hrbfnpr_context_release(context: *mut hrbfnpr_context);
}

/// The settings that a context uses, and its memory.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_context_info {
    pub struct_size: u32,
    /// number of threads that a large call uses
    pub thread_count: i32,
    /// the instruction set in use
    pub instruction_set: u32,
    /// HRBFNPR_THREAD_BACKEND_POOL, OPENMP, RUN_TASKS or SERIAL
    pub thread_backend: u32,
    /// bytes that are allocated through this context now
    pub bytes_now: i64,
    /// the largest number of bytes that were ever allocated at the same time
    pub bytes_peak: i64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_context_info_init(
        info: *mut hrbfnpr_context_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Fills `info` with the settings in use and the memory of a context.
    pub fn hrbfnpr_context_get_info(
        context: *const hrbfnpr_context,
        info: *mut hrbfnpr_context_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 5  OPERATION: progress and cancelling of one long call

/// A handle through which one long call reports its progress and is cancelled.
#[repr(C)]
pub struct hrbfnpr_operation {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Receives the progress of a call, from 0 to 1, at irregular intervals.  The
/// progress never falls within a call.  The callback runs on the thread that made
/// the call.  Return 0 to go on; any other number cancels the call, which then
/// returns CANCELLED.
pub type hrbfnpr_progress_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, progress: f64) -> i32>;

extern "C" {
    /// Creates an operation.
    pub fn hrbfnpr_operation_create(
        context: *mut hrbfnpr_context,
        out_operation: *mut *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference. Any thread.
    pub fn hrbfnpr_operation_retain(operation: *mut hrbfnpr_operation);
    /// Removes a reference. Any thread.
    pub fn hrbfnpr_operation_release(operation: *mut hrbfnpr_operation);
    /// Cancels the call that uses the operation, and all later ones.  Any thread, any
    /// time, any number of times.  NULL is ignored.
    pub fn hrbfnpr_operation_cancel(operation: *mut hrbfnpr_operation);
    /// Returns 1 after a cancel, else 0.  Any thread.  NULL gives 0.
    pub fn hrbfnpr_operation_is_cancelled(operation: *const hrbfnpr_operation) -> i32;
    /// Returns the progress of the call, from 0 to 1.  Any thread.  NULL gives 0.
    pub fn hrbfnpr_operation_progress(operation: *const hrbfnpr_operation) -> f64;
    /// Sets the function that receives the progress; `callback` NULL removes it.
    ///
    /// Errors: INVALID_ARGUMENT: a call uses the operation at present.
    pub fn hrbfnpr_operation_set_callback(
        operation: *mut hrbfnpr_operation,
        callback: hrbfnpr_progress_fn,
        user: *mut c_void,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// Writes all `size` bytes of `data`.  Return 0 on success; any other number fails
/// the call with IO.
pub type hrbfnpr_write_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, data: *const c_void, size: u64) -> i32>;

/// Reads up to `size` bytes into `data`.  Return the number of bytes read, 0 at the
/// end of the stream, or a negative number, which fails the call with IO.
pub type hrbfnpr_read_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, data: *mut c_void, size: u64) -> i64>;

// 6  MODEL: an implicit surface f = 0, immutable [NPAR 4]

/// A handle to an implicit surface.  It never changes.
#[repr(C)]
pub struct hrbfnpr_model {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

// Radial functions phi(r) [NPAR 4.1].
/// r^3, without a parameter; the default
pub const HRBFNPR_KERNEL_TRIHARMONIC: u32 = 0;
/// exp(-r^2 / (2 radius^2))
pub const HRBFNPR_KERNEL_GAUSSIAN: u32 = 1;
/// (1 - r/radius)^4 (4 r/radius + 1) for r < radius, else 0
pub const HRBFNPR_KERNEL_WENDLAND_C2: u32 = 2;
/// not for fits: reported for a model made by _create_custom
pub const HRBFNPR_KERNEL_CUSTOM: u32 = 3;
/// not for fits: reported for a model made by _create_csg
pub const HRBFNPR_KERNEL_CSG: u32 = 4;

// How the linear system of a fit is solved.  docs/fitting.md gives times and memory.
/// DIRECT for few samples, ITERATIVE for many
pub const HRBFNPR_SOLVER_AUTO: u32 = 0;
/// dense factorization: memory grows with N^2, time with N^3
pub const HRBFNPR_SOLVER_DIRECT: u32 = 1;
/// preconditioned conjugate gradients: memory grows with N. TRIHARMONIC needs
/// polynomial_degree 1 or more [Schaefer, Katzfuss, Owhadi 2021]
pub const HRBFNPR_SOLVER_ITERATIVE: u32 = 2;

// Why a fit used the solver that it used.
/// the caller named it
pub const HRBFNPR_SOLVER_REASON_REQUESTED: u32 = 0;
/// AUTO took DIRECT, which is faster for few samples
pub const HRBFNPR_SOLVER_REASON_SMALL: u32 = 1;
/// AUTO took ITERATIVE: DIRECT would need too much memory or time
pub const HRBFNPR_SOLVER_REASON_LARGE: u32 = 2;
/// AUTO took DIRECT, because ITERATIVE did not reach its tolerance
pub const HRBFNPR_SOLVER_REASON_NOT_CONVERGED: u32 = 3;
/// AUTO took DIRECT, because ITERATIVE needs a definite system
pub const HRBFNPR_SOLVER_REASON_NOT_DEFINITE: u32 = 4;

// What a fit does with samples that look wrong.  It counts them in any case.
/// uses them as they are
pub const HRBFNPR_REPAIR_KEEP: u32 = 0;
/// leaves them out
pub const HRBFNPR_REPAIR_DROP: u32 = 1;
/// turns their normals round; for flipped normals only
pub const HRBFNPR_REPAIR_REORIENT: u32 = 2;

// Where the regularization of a fit comes from.
/// the field `regularization`
pub const HRBFNPR_REGULARIZATION_GIVEN: u32 = 0;
/// the measured noise of the samples; 0 for samples without noise
pub const HRBFNPR_REGULARIZATION_AUTO: u32 = 1;

// How far the given normals can be trusted, for a fit and for hrbfnpr_orient.
/// they are correct and point outward
pub const HRBFNPR_NORMALS_GIVEN: u32 = 0;
/// there are none, or they are useless: all are made
pub const HRBFNPR_NORMALS_NONE: u32 = 1;
/// the directions are correct, the signs are not
pub const HRBFNPR_NORMALS_UNORIENTED: u32 = 2;
/// the directions and most signs are correct; some patches are turned
pub const HRBFNPR_NORMALS_MIXED: u32 = 3;
/// they are consistent, but all point inward
pub const HRBFNPR_NORMALS_INWARD: u32 = 4;
/// find out which of these holds, and repair accordingly
pub const HRBFNPR_NORMALS_AUTO: u32 = 5;

// Whether a fitted surface ends where its samples end (see hrbfnpr_model_trim).
/// the surface goes on to the end of the search box
pub const HRBFNPR_TRIM_NEVER: u32 = 0;
/// an open surface ends where the given samples end (all of them, not only the chosen
/// centres). A closed surface stays whole, and so does one of fewer than ten samples.
/// hrbfnpr_model_get_trim_info says what was done
pub const HRBFNPR_TRIM_AUTO: u32 = 1;

/// What to fit: N points with N outward normals, and how.  docs/fitting.md
/// explains the methods.
///
/// Repairs.  The fit accepts and counts (hrbfnpr_model_info) the following.
/// Normals that are not of unit length are normalized.  Samples at the same place
/// (within 1e-9 diagonals) with the same normal (within 1 degree) are merged.  Of
/// 33 samples or more, near duplicates are merged: closer than 1e-3 of the local
/// spacing, normals within 15 degrees.  If many samples contradict each other so
/// much that the iterations break down, the fit adds a little regularization and
/// raises the solver tolerance; the log and hrbfnpr_model_info.regularization say
/// so.
///
/// Refused samples.  INVALID_ARGUMENT: samples at the same place with different
/// normals (the message gives both indices); NaN, infinity, zero normals;
/// coordinates beyond 1e100; samples less than 1e-100 across; empty arrays, or
/// arrays of different counts.  One sample is enough: its surface is a plane.
///
/// Outliers and flipped normals.  Of 33 samples or more, the fit counts samples
/// that do not agree with the 16 nearest others, and repairs them if `outliers`
/// or `flipped_normals` says so.  Outliers are far from their neighbours or from
/// their neighbours' tangent planes, or are the worse of two near duplicates with
/// different normals.  A flipped normal is opposite to nearly all neighbours'
/// normals on the same sheet.
///
/// Choosing centres.  With `tolerance` or `maximum_centres` the fit chooses some
/// samples as centres: first evenly spread ones, then in rounds those that the
/// last fit missed most.  It ends when every sample is within the tolerance
/// (|f| / |grad f|) or maximum_centres is reached.  If the tolerance is not
/// reached, the call still succeeds: hrbfnpr_model_info gives what was reached,
/// and the log warns.  With regularization, the tolerance applies to means over a
/// sample and its 16 neighbours, so that centres do not follow noise.
///
/// Normals.  With a normal_mode other than GIVEN, the fit first makes or repairs
/// the normals as hrbfnpr_orient with its defaults does.  With GIVEN, normals that
/// all point into a closed surface are fitted as they are; the log warns, and
/// hrbfnpr_model_info.normals_inward is 1.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_fit_desc {
    pub struct_size: u32,
    /// HRBFNPR_KERNEL_...: the radial function; TRIHARMONIC, GAUSSIAN or WENDLAND_C2; default TRIHARMONIC
    pub kernel: u32,
    /// N x 3, FLOAT32 or FLOAT64: the places of the samples
    pub points: hrbfnpr_array,
    /// N x 3, FLOAT32 or FLOAT64: outward normals of any length; normal_mode may say otherwise
    pub normals: hrbfnpr_array,
    /// radius of GAUSSIAN and WENDLAND_C2, in the unit of the points; 0 or more; default 0 = from
    /// the sample spacing. A larger radius fills larger gaps, but makes the system worse
    /// conditioned
    pub kernel_radius: f64,
    /// degree of the polynomial that is added to the kernels; -1 (none) to 3; default 1.
    /// TRIHARMONIC is well-posed from 1 on [Duchon 1977]; below that the fit may fail with
    /// SINGULAR_SYSTEM
    pub polynomial_degree: i32,
    /// HRBFNPR_REGULARIZATION_...; default GIVEN. AUTO needs regularization 0
    pub regularization_mode: u32,
    /// smoothing of the fit, added to the diagonal of the system in coordinates in which the
    /// samples' diagonal is 1; 0 or more; default 0 = pass through every sample. Larger values
    /// give a smoother surface that keeps a distance from noisy samples
    pub regularization: f64,
    /// HRBFNPR_REPAIR_KEEP or DROP; default KEEP
    pub outliers: u32,
    /// HRBFNPR_REPAIR_...; default KEEP
    pub flipped_normals: u32,
    /// largest distance of a sample from the surface at which no more centres are chosen, in the
    /// unit of the points; 0 or more; default 0 = none. Smaller values give more centres
    pub tolerance: f64,
    /// largest number of samples that are chosen as centres; 0 or more; default 0 = no limit. If
    /// tolerance is 0, too, every sample is a centre
    pub maximum_centres: i64,
    /// HRBFNPR_SOLVER_...; default AUTO
    pub solver: u32,
    /// steps of iterative refinement after a DIRECT solve; 0 to 20; default 2. More steps give
    /// smaller residuals
    pub refinement_steps: i32,
    /// relative residual at which ITERATIVE ends; 0 to 0.1; default 0 = 1e-10 up to 2048 centres,
    /// 1e-8 beyond, or, if rounding allows no more, up to 1e-6 with a warning in the log
    pub solver_tolerance: f64,
    /// largest number of iterations of ITERATIVE; 1 to 1000000; default 200
    pub iteration_limit: i32,
    /// neighbours of each sample in the preconditioner of ITERATIVE; 1 to 48; default 0 = by the
    /// kernel and the number of samples. More neighbours give fewer iterations and a longer setup
    pub preconditioner_neighbours: u32,
    /// HRBFNPR_NORMALS_...: how far `normals` can be trusted; default GIVEN. NONE and AUTO work
    /// without normals
    pub normal_mode: u32,
    /// HRBFNPR_TRIM_...; default AUTO
    pub trim: u32,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_fit_desc_init(desc: *mut hrbfnpr_fit_desc, struct_size: u32) -> hrbfnpr_status;
    /// Fits f with f(x_i) = 0 and grad f(x_i) = n_i at the samples, so that f < 0
    /// inside, f > 0 outside, and |grad f| is near 1 at the surface [NPAR 4.1,
    /// equations 1, 2].  The fit works in double precision and in coordinates in which
    /// the mean sample spacing is 1, whatever the caller's unit.
    ///
    /// desc:        what to fit
    /// operation:   may be NULL
    ///
    /// Errors: INVALID_ARGUMENT: see hrbfnpr_fit_desc.  OUT_OF_MEMORY: the message gives
    /// the bytes that are needed.  SINGULAR_SYSTEM: the system has no unique solution;
    /// the message says how to change it.  NOT_CONVERGED: ITERATIVE did not reach its
    /// tolerance; the message gives the residual.
    pub fn hrbfnpr_model_fit(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_fit_desc,
        operation: *mut hrbfnpr_operation,
        out_model: *mut *mut hrbfnpr_model,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// The points of hrbfnpr_orient: N points without normals, or with normals that may
/// be wrong.  docs/fitting.md explains the method.
///
/// Outward.  For a closed surface, outward is the side that it does not enclose.
/// For an open surface it is the side that the viewpoint sees, if one is given; else
/// the convex side, if the surface encloses one side more than the other; else, as for
/// a terrain, the side of `up`.  A closed surface inside another one bounds a hole: its
/// normals point into the hole.
///
/// Points that coincide (within 1/100 of the spacing) get the same normal.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_orient_desc {
    pub struct_size: u32,
    /// HRBFNPR_NORMALS_...: how far `normals` can be trusted; default AUTO. GIVEN only looks: it
    /// changes no normal
    pub mode: u32,
    /// N x 3, FLOAT32 or FLOAT64
    pub points: hrbfnpr_array,
    /// N x 3, FLOAT32 or FLOAT64, of any length; a zero normal is unknown and is made. Not needed
    /// with NONE and AUTO
    pub normals: hrbfnpr_array,
    /// the direction that decides for surfaces like a terrain; of any length, not 0; default (0, 0, 1)
    pub up: [f64; 3],
    /// the place from which the points were seen; used with has_viewpoint; default (0, 0, 0)
    pub viewpoint: [f64; 3],
    /// 1: normals of open surfaces point to the side of the viewpoint; 0: the viewpoint is
    /// ignored; default 0
    pub has_viewpoint: u32,
    pub reserved: u32,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_orient_desc_init(
        desc: *mut hrbfnpr_orient_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

// How hrbfnpr_orient decided which side is outward.
/// the surface encloses the other side
pub const HRBFNPR_OUTWARD_INSIDE: u32 = 0;
/// `up` points to this side
pub const HRBFNPR_OUTWARD_UP: u32 = 1;
/// the viewpoint is on this side
pub const HRBFNPR_OUTWARD_VIEWPOINT: u32 = 2;
/// most given normals point to this side
pub const HRBFNPR_OUTWARD_AS_GIVEN: u32 = 3;

/// What hrbfnpr_orient found and did.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_orient_info {
    pub struct_size: u32,
    /// HRBFNPR_NORMALS_...: how far the given normals could be trusted; NONE also if they have
    /// nothing to do with the points, as colours have not
    pub found: u32,
    /// number of given normals that were turned round
    pub turned: i64,
    /// number of normals that were made, because they were missing, zero or useless
    pub made: i64,
    /// number of points that coincide with another one
    pub merged: i64,
    /// mean angle between the lines of the given and the resulting normals, in degrees; NaN if no
    /// normals are given
    pub direction_change: f64,
    /// standard deviation of the points from their surface, in their unit; 0 if no noise is seen
    pub noise: f64,
    /// median distance of a point to its nearest neighbour, in the unit of the points
    pub spacing: f64,
    /// bending energy of the result per degree of freedom, in spacings. Below 0.006: the points
    /// resolve the surface; 0.026: points without any order
    pub energy: f64,
    /// how sure the result is; 0 to 1. A heuristic, not a probability: results above 0.9 are
    /// usually right; check the others
    pub confidence: f64,
    /// 1: the points surround one or several solids
    pub closed: u32,
    /// HRBFNPR_OUTWARD_...: how the outward side was decided
    pub outward_by: u32,
    /// number of pieces that lie apart by more than their spacing
    pub components: i64,
    /// time of the call
    pub seconds: f64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_orient_info_init(
        info: *mut hrbfnpr_orient_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Finds outward unit normals for points, or repairs given normals.  A low
    /// confidence is no error; the log warns.  Time and memory grow with N.
    /// [VIPSS: Huang, Carr, Ju, "Variational implicit point set surfaces", 2019]
    ///
    /// out_normals:   receives N x 3 normals, FLOAT32 or FLOAT64; may be the given normals' memory.  Given
    ///                normals that stay keep their bits (if the scalar types agree); turned ones
    /// change their sign only
    /// info:          may be NULL
    /// operation:     may be NULL
    ///
    /// Errors: INVALID_ARGUMENT: fewer than 4 different points; all points are on one
    /// line; NaN or infinity; no normals with a mode that needs them; `up` is 0.
    pub fn hrbfnpr_orient(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_orient_desc,
        operation: *mut hrbfnpr_operation,
        out_normals: *const hrbfnpr_array_out,
        info: *mut hrbfnpr_orient_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// The image of a depth camera (Kinect, RealSense, time of flight, stereo): one
/// point for each of columns x rows pixels.
///
/// The camera is at the origin and looks along +z or -z.  x / z grows or falls with
/// the column, y / z with the row.  For an image of depths z with the focal lengths
/// f and the centre c in pixels, the points are
/// x = (column - c_x) z / f_x and y = (row - c_y) z / f_y.
///
/// docs/fitting.md explains the method.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_depth_image_desc {
    pub struct_size: u32,
    /// pixels in a row; 8 to 65535
    pub columns: i32,
    /// number of rows; 8 to 65535
    pub rows: i32,
    /// 1: the points stay where they are and only get normals; 0: they are smoothed; default 0
    pub keep_points: u32,
    /// rows * columns x 3, row by row, FLOAT32 or FLOAT64. NaN, infinity or z = 0: nothing was
    /// seen at the pixel
    pub points: hrbfnpr_array,
    /// standard deviation of 1 / z, in 1 / (unit of the points); 0 or more; default 0 = measured
    pub noise: f64,
    /// factor of the radius over which pixels are averaged; above 0, at most 100; default 1.
    /// Larger values remove more noise and more small shapes
    pub smoothing: f64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_depth_image_desc_init(
        desc: *mut hrbfnpr_depth_image_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// What hrbfnpr_smooth_depth_image found and did.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_depth_image_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// number of pixels with a point
    pub seen: i64,
    /// number of these that are left out, because too few other pixels lie on their plane
    pub left_out: i64,
    /// standard deviation of 1 / z, as given or measured
    pub noise: f64,
    /// mean of the focal lengths in both directions, in pixels
    pub focal_length: f64,
    /// median of |z| over the points
    pub depth: f64,
    /// radius of the smoothing at this depth, in pixels
    pub radius: f64,
    /// time of the call
    pub seconds: f64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_depth_image_info_init(
        info: *mut hrbfnpr_depth_image_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Removes the sensor's noise from the image of a depth camera, and finds normals.
    /// To choose some of the points, evenly spread over the image, pass x / z, y / z and
    /// log |z| to hrbfnpr_farthest_points.
    ///
    /// out_points:    receives rows * columns x 3 points, FLOAT32 or FLOAT64; NaN where nothing
    /// was seen and for points that
    ///                are left out, such as those between an edge and what it hides; may be the
    /// memory of desc->points; may
    ///                be NULL
    /// out_normals:   receives as many unit normals, which point to the camera; 0 where
    /// out_points is NaN; may be NULL
    /// info:          may be NULL
    /// operation:     may be NULL
    ///
    /// Errors: INVALID_ARGUMENT: the points are not such an image.
    pub fn hrbfnpr_smooth_depth_image(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_depth_image_desc,
        operation: *mut hrbfnpr_operation,
        out_points: *const hrbfnpr_array_out,
        out_normals: *const hrbfnpr_array_out,
        info: *mut hrbfnpr_depth_image_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// Evaluates the caller's function at `count` points.  Return 0 on success; any other
/// number fails the whole call with CALLBACK.
///
/// points:     count x 3: x, y, z
/// value:      receives count values of f
/// gradient:   receives count x 3 derivatives; may be NULL
/// hessian:    receives count x 6 derivatives, xx xy xz yy yz zz; may be NULL
pub type hrbfnpr_implicit_fn = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        count: i64,
        points: *const f64,
        value: *mut f64,
        gradient: *mut f64,
        hessian: *mut f64,
    ) -> i32,
>;

// What a custom function can do.  Without a flag, the library computes the
// derivatives by differences and passes NULL for them.
/// the function fills `gradient`
pub const HRBFNPR_CUSTOM_HAS_GRADIENT: u32 = 1;
/// the function fills `hessian`
pub const HRBFNPR_CUSTOM_HAS_HESSIAN: u32 = 2;
/// the function may run on several threads at the same time; else it runs on one at a time,
/// on the thread that called the library
pub const HRBFNPR_CUSTOM_THREAD_SAFE: u32 = 4;

/// An implicit function of the caller, in place of a fit [NPAR 8].
///
/// The function should be negative inside and have a gradient of a length near 1 at
/// the surface.  It must be finite in a box twice as wide as the bounds.  Where it is
/// not finite, or where its gradient is shorter than 1e-150 or longer than 1e150, no
/// point is projected and no mark is placed.
///
/// The diagonal of the bounds must be from 1e-100 to 1e100.  Make the bounds fit the
/// surface closely: tolerances, differences and the cells in which marks are placed
/// are shares of the diagonal.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_custom_desc {
    pub struct_size: u32,
    /// HRBFNPR_CUSTOM_... flags, or-ed; default 0
    pub flags: u32,
    /// the function; must be given
    pub function: hrbfnpr_implicit_fn,
    /// passed to function and release
    pub user: *mut c_void,
    /// called once, on the thread that releases the last reference; NULL (default) = nothing to
    /// do. It is not called if the model cannot be created
    pub release: Option<unsafe extern "C" fn(user: *mut c_void)>,
    /// lower corner of the box that holds the surface
    pub bounds_min: [f64; 3],
    /// upper corner of the box
    pub bounds_max: [f64; 3],
    /// step of the differences, in the unit of the points; 0 or more; default 0 = 1e-4 diagonals
    /// for gradients, 1e-3 for Hessians
    pub difference_step: f64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_custom_desc_init(
        desc: *mut hrbfnpr_custom_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Creates a model from a function of the caller.
    ///
    /// Errors: INVALID_ARGUMENT: no function, or bounds that span no box.
    pub fn hrbfnpr_model_create_custom(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_custom_desc,
        out_model: *mut *mut hrbfnpr_model,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference. Any thread.
    pub fn hrbfnpr_model_retain(model: *const hrbfnpr_model);
    /// Removes a reference. Any thread.
    pub fn hrbfnpr_model_release(model: *const hrbfnpr_model);
}

/// What a fit found and did.  Lengths are in the unit of the points.  A custom model
/// and a solid have bounds, kernel and bytes only.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_model_info {
    pub struct_size: u32,
    /// HRBFNPR_KERNEL_...: the one used
    pub kernel: u32,
    /// the one used; -1 = none
    pub polynomial_degree: i32,
    /// number of fits that were made to choose the centres; 0 if all samples are centres
    pub choice_rounds: i32,
    /// number of samples as given
    pub samples: i64,
    /// number of centres, after merging, repairing and choosing
    pub centres: i64,
    /// number of samples that were merged into another one at the same place
    pub merged_samples: i64,
    /// number of samples that were merged into another one much nearer than the spacing
    pub near_duplicates: i64,
    /// number of normals whose length differed from 1 by more than 1e-4
    pub rescaled_normals: i64,
    /// number of samples far from all others, or from the tangent planes around them
    pub outliers_found: i64,
    /// number of these that were left out
    pub outliers_dropped: i64,
    /// number of normals that are opposite to those of their neighbours
    pub flipped_found: i64,
    /// number of these that were left out or turned round
    pub flipped_repaired: i64,
    /// lower corner of the samples' box. For up to 20 000 samples along curves, the box also
    /// holds the surface, if that closes within a third of a diagonal around the samples
    pub bounds_min: [f64; 3],
    /// upper corner of the box
    pub bounds_max: [f64; 3],
    /// mean distance of a sample to its nearest neighbour
    pub spacing: f64,
    /// the one used; 0 for TRIHARMONIC
    pub kernel_radius: f64,
    /// the one used; with AUTO, that of the values
    pub regularization: f64,
    /// standard deviation of the samples from their surface; 0 if no noise is seen, NaN with
    /// regularization GIVEN
    pub noise_estimate: f64,
    /// largest |f(x_i)| at the centres
    pub value_residual_max: f64,
    /// root mean square of |f(x_i)|
    pub value_residual_rms: f64,
    /// largest |grad f(x_i) - n_i| at the centres
    pub gradient_residual_max: f64,
    /// root mean square of |grad f(x_i) - n_i|
    pub gradient_residual_rms: f64,
    /// largest distance |f| / |grad f| of a sample from the surface; dropped ones do not count
    pub input_distance_max: f64,
    /// root mean square of these distances
    pub input_distance_rms: f64,
    /// share of all samples that lie within the tolerance; a dropped sample counts as outside;
    /// NaN with tolerance 0
    pub input_share_within: f64,
    /// HRBFNPR_SOLVER_...: the one used
    pub solver: u32,
    /// HRBFNPR_SOLVER_REASON_...: why it was used
    pub solver_reason: u32,
    /// number of refinement steps of DIRECT, or of steps of ITERATIVE
    pub iterations: i32,
    /// 1: the matrix was not definite, and LU with pivoting was used
    pub fallback: u32,
    /// relative residual of the linear system, in the 2-norm
    pub solver_residual: f64,
    /// condition of the matrix in the 1-norm (DIRECT), or of the preconditioned matrix in the
    /// 2-norm (ITERATIVE)
    pub condition_estimate: f64,
    /// time of finding duplicates, outliers, flipped normals and noise
    pub seconds_clean: f64,
    /// time of all rounds that chose centres, without the last fit
    pub seconds_choose: f64,
    /// time of reading the samples and assembling the matrix
    pub seconds_assemble: f64,
    /// time of making the preconditioner
    pub seconds_precondition: f64,
    /// time of solving
    pub seconds_solve: f64,
    /// time of the whole fit
    pub seconds_total: f64,
    /// memory that the model keeps
    pub bytes: i64,
    /// largest number of bytes allocated at the same time through the context, up to the fit's end
    pub peak_bytes: i64,
    /// hrbfnpr_orient_info.found, if the fit had a normal_mode; else GIVEN
    pub normals_found: u32,
    /// 1: the given normals (normal_mode GIVEN) all point into a closed surface
    pub normals_inward: u32,
    /// hrbfnpr_orient_info.turned
    pub normals_turned: i64,
    /// hrbfnpr_orient_info.confidence; NaN without a normal_mode
    pub normals_confidence: f64,
    /// time of making the normals
    pub seconds_orient: f64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_model_info_init(
        info: *mut hrbfnpr_model_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Fills `info` with what is known of a model.
    pub fn hrbfnpr_model_get_info(
        model: *const hrbfnpr_model,
        info: *mut hrbfnpr_model_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// The arrays of a model that hrbfnpr_model_view shows.
/// FLOAT64 x 3: the centres; for a model of sheets, places all over the surface
pub const HRBFNPR_MODEL_ATTRIBUTE_POSITION: u32 = 0;
/// FLOAT64 x 3: the unit normals at these places
pub const HRBFNPR_MODEL_ATTRIBUTE_NORMAL: u32 = 1;
/// FLOAT64: the relative residual after each iteration of ITERATIVE; empty after DIRECT and
/// after loading
pub const HRBFNPR_MODEL_ATTRIBUTE_RESIDUAL_HISTORY: u32 = 2;

extern "C" {
    /// Gives a view of an array of the model, without a copy.  The view is valid while
    /// the model lives.  It is empty for a custom model and a solid.
    pub fn hrbfnpr_model_view(
        model: *const hrbfnpr_model,
        attribute: u32,
        out_view: *mut hrbfnpr_array,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Evaluates f, its gradient and its Hessian at n points.
    ///
    /// points:      n x 3, FLOAT32 or FLOAT64; finite, and within 1e50 diagonals of the model's bounds
    /// value:       receives n values, FLOAT32 or FLOAT64; may be NULL
    /// gradient:    receives n x 3, FLOAT32 or FLOAT64; may be NULL
    /// hessian:     receives n x 6, xx xy xz yy yz zz, FLOAT32 or FLOAT64; may be NULL.  At a
    /// sample it leaves out the
    ///              sample's own term, which depends on the direction and has the mean 0
    /// operation:   may be NULL
    ///
    /// The first call with many points prepares the model for faster evaluation: it
    /// takes longer, and the model keeps the prepared data (docs/accuracy.md gives the
    /// threshold, the times and the memory).  Prepared values of f are within 1e-9
    /// diagonals of the exact sum, gradients within 1e-7.  For rough, uneven samples the
    /// errors may be 200 times as large, or 5000 times where rounding allows no less;
    /// otherwise the exact sum is used.  The log gives the measured errors.  The bits of
    /// a result depend on n, and in the last bits on whether Hessians are asked for, but
    /// not on earlier calls.  hrbfnpr_model_project, hrbfnpr_model_curvature and
    /// hrbfnpr_point_set_generate prepare the model in the same way.
    ///
    /// Errors: INVALID_ARGUMENT: a point is not finite or too far away, or a finite
    /// result does not fit into a FLOAT32 array.  Non-finite values of a custom function
    /// are passed on.
    pub fn hrbfnpr_model_evaluate(
        model: *const hrbfnpr_model,
        points: *const hrbfnpr_array,
        value: *const hrbfnpr_array_out,
        gradient: *const hrbfnpr_array_out,
        hessian: *const hrbfnpr_array_out,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// What became of a projected point.
/// the point is on the surface, within the tolerance
pub const HRBFNPR_PROJECTION_CONVERGED: u32 = 0;
/// the evaluation limit was reached, or no step lowers f^2
pub const HRBFNPR_PROJECTION_NOT_CONVERGED: u32 = 1;
/// the point is stuck off the surface, where the gradient vanishes
pub const HRBFNPR_PROJECTION_ZERO_GRADIENT: u32 = 2;
/// f or its gradient is not finite, or the gradient is longer than 1e150
pub const HRBFNPR_PROJECTION_NOT_FINITE: u32 = 3;

/// How points are projected.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_project_desc {
    pub struct_size: u32,
    /// largest number of evaluations of f for each point; 1 to 1000; default 50
    pub evaluation_limit: i32,
    /// largest distance |f| / |grad f| from the surface at which the projection ends, in
    /// diagonals; above 0; default 1e-9
    pub tolerance: f64,
    /// sigma of Armijo's rule: the share of the expected decrease that a step must reach; between
    /// 0 and 0.5; default 1e-4
    pub armijo_slope: f64,
    /// beta of Armijo's rule: the factor by which a step is shortened; between 0 and 1; default 0.5
    pub armijo_factor: f64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_project_desc_init(
        desc: *mut hrbfnpr_project_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// The results of hrbfnpr_model_project: arrays of the caller with n elements each.
/// An array that is all zero is not wanted.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_projection {
    pub struct_size: u32,
    pub reserved: u32,
    /// n x 3, FLOAT32 or FLOAT64: the projected points; may be the memory of the points
    pub position: hrbfnpr_array_out,
    /// n x 3, FLOAT32 or FLOAT64: the unit gradients; 0 where there is none
    pub normal: hrbfnpr_array_out,
    /// n x 1, UINT8 or UINT32: HRBFNPR_PROJECTION_...
    pub status: hrbfnpr_array_out,
    /// receives the number of points that converged
    pub converged: i64,
}

extern "C" {
    /// Sets up the struct with no array given.
    pub fn hrbfnpr_projection_init(
        projection: *mut hrbfnpr_projection,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Projects n points onto the surface, by steepest descent on f^2 with Armijo's rule
    /// [NPAR 4.2].  A point that fails keeps its last place; its status says why, and the
    /// call succeeds.  For models with creases, and where a bound on |grad f| is known,
    /// points that descent leaves off the surface are searched for the surface around
    /// them, within the search box: this takes up to 2000 more evaluations for each.
    ///
    /// points:       n x 3, FLOAT32 or FLOAT64; as for hrbfnpr_model_evaluate
    /// desc:         NULL = all defaults
    /// projection:   the arrays that receive the results
    /// operation:    may be NULL
    pub fn hrbfnpr_model_project(
        model: *const hrbfnpr_model,
        points: *const hrbfnpr_array,
        desc: *const hrbfnpr_project_desc,
        projection: *mut hrbfnpr_projection,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// The results of hrbfnpr_model_curvature: arrays of the caller with n elements each,
/// FLOAT32 or FLOAT64.  An array that is all zero is not wanted.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_curvature {
    pub struct_size: u32,
    pub reserved: u32,
    /// n x 1: the larger principal curvature, in 1 / unit of length
    pub k1: hrbfnpr_array_out,
    /// n x 1: the smaller principal curvature
    pub k2: hrbfnpr_array_out,
    /// n x 3: the direction of k1: unit, tangent, of arbitrary sign
    pub d1: hrbfnpr_array_out,
    /// n x 3: the direction of k2: unit, tangent, perpendicular to d1, of arbitrary sign
    pub d2: hrbfnpr_array_out,
    /// n x 1: (k1 - k2) / (|k1| + |k2| + 1e-3/diagonal), from 0 to 1
    pub confidence: hrbfnpr_array_out,
}

extern "C" {
    /// Sets up the struct with no array given.
    pub fn hrbfnpr_curvature_init(
        curvature: *mut hrbfnpr_curvature,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Computes the principal curvatures and directions of the level set through each of n
    /// points: the tangent eigenpairs of G = -P H P / |grad f|, where P = I - n n^T
    /// [NPAR 5.3; Kindlmann et al. 2003].  k1 >= k2.  A surface that bends away from its
    /// normal has negative curvature: a sphere with outward normals has -1/radius.  At
    /// umbilics and on planes the confidence is 0, and d1 and d2 follow a smooth field.
    /// Where the gradient vanishes, all results are 0.
    ///
    /// points:      n x 3, FLOAT32 or FLOAT64; as for hrbfnpr_model_evaluate
    /// curvature:   the arrays that receive the results
    /// operation:   may be NULL
    pub fn hrbfnpr_model_curvature(
        model: *const hrbfnpr_model,
        points: *const hrbfnpr_array,
        curvature: *mut hrbfnpr_curvature,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// What became of a ray.
/// it has one or several hits
pub const HRBFNPR_RAY_HIT: u32 = 0;
/// it has no hit
pub const HRBFNPR_RAY_MISS: u32 = 1;
/// it has more hits than maximum_hits; reported only if that is 2 or more
pub const HRBFNPR_RAY_TRUNCATED: u32 = 2;
/// the search ended at the evaluation limit; earlier hits are kept
pub const HRBFNPR_RAY_EVALUATION_LIMIT: u32 = 3;
/// f or its gradient is not finite; earlier hits are kept
pub const HRBFNPR_RAY_NOT_FINITE: u32 = 4;

/// How rays are cast.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_cast_desc {
    pub struct_size: u32,
    /// largest number of hits to find on a ray; 1 to 256; default 1 = only the first one
    pub maximum_hits: i32,
    /// largest number of evaluations of f for each ray; 1 to 1000000; default 20000
    pub evaluation_limit: i32,
    pub reserved: u32,
    /// where a ray begins, in lengths of its direction; finite; default 0
    pub t_min: f64,
    /// where a ray ends, in lengths of its direction; t_min or more; default infinity
    pub t_max: f64,
    /// a bound on |grad f| in the search box; 0 or more; default 0 = that of
    /// hrbfnpr_model_lipschitz. A bound that is too small may miss hits; one that is too large
    /// only takes time
    pub lipschitz: f64,
    /// smallest step along a ray, in diagonals; above 0, at most 0.1; default 1e-4. Smaller steps
    /// find thinner sheets and take more time
    pub smallest_step: f64,
    /// accuracy of the place of a hit along its ray, in diagonals; above 0; default 1e-9
    pub tolerance: f64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_cast_desc_init(desc: *mut hrbfnpr_cast_desc, struct_size: u32) -> hrbfnpr_status;
}

/// The results of hrbfnpr_model_cast_rays: arrays of the caller with n elements each.
/// An array that is all zero is not wanted.  h is maximum_hits; the hits of a ray are
/// in the order of t.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_ray_hits {
    pub struct_size: u32,
    pub reserved: u32,
    /// n x 1, UINT32: number of hits; 0 to h
    pub count: hrbfnpr_array_out,
    /// n x h, FLOAT32 or FLOAT64: places of the hits, in lengths of the direction; infinity after
    /// the last hit
    pub t: hrbfnpr_array_out,
    /// n x 3h, FLOAT32 or FLOAT64: x, y, z of the first hit, then of the second; 0 after the last
    /// hit. For far origins it is more exact than t, which is rounded
    pub position: hrbfnpr_array_out,
    /// n x 3h, FLOAT32 or FLOAT64: the unit gradients; 0 after the last hit
    pub normal: hrbfnpr_array_out,
    /// n x h, UINT8: 1 where the ray enters the inside (f changes from + to -), else 0
    pub entering: hrbfnpr_array_out,
    /// n x 1, UINT8 or UINT32: HRBFNPR_RAY_...
    pub status: hrbfnpr_array_out,
    /// receives the number of rays that have a hit
    pub hit_rays: i64,
}

extern "C" {
    /// Sets up the struct with no array given.
    pub fn hrbfnpr_ray_hits_init(hits: *mut hrbfnpr_ray_hits, struct_size: u32) -> hrbfnpr_status;
    /// Finds where n rays origin + t direction, t_min <= t <= t_max, meet the surface in the
    /// search box, by sphere tracing [Hart 1996].
    ///
    /// The search may miss: two hits that are closer than smallest_step along the ray, such
    /// as those of a grazing ray or a thin sheet; and a hit exactly at t_min or t_max.  A
    /// ray that starts on the surface may or may not have a hit there: start beyond it, with
    /// t_min.  Rays may start inside.
    ///
    /// origins:      n x 3, FLOAT32 or FLOAT64, finite
    /// directions:   n x 3, FLOAT32 or FLOAT64, finite, of any length but 0
    /// desc:         NULL = all defaults
    /// hits:         the arrays that receive the results
    /// operation:    may be NULL
    ///
    /// Errors: INVALID_ARGUMENT: NaN, infinity, a zero direction, different counts of
    /// origins and directions, or a direction so short that the t of a hit is infinite.
    pub fn hrbfnpr_model_cast_rays(
        model: *const hrbfnpr_model,
        origins: *const hrbfnpr_array,
        directions: *const hrbfnpr_array,
        desc: *const hrbfnpr_cast_desc,
        hits: *mut hrbfnpr_ray_hits,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Computes the bound on |grad f| that hrbfnpr_model_cast_rays uses if none is given.
    /// For a solid of primitives it is a true bound (hrbfnpr_csg_info.lipschitz).  For other
    /// models it is an estimate: 1.5 times the largest |grad f| at 24^3 points of the search
    /// box.  A program that casts few rays in each call should ask for the bound once and
    /// pass it on, because each call without it evaluates these points.
    ///
    /// lipschitz:   receives the bound
    /// operation:   may be NULL
    pub fn hrbfnpr_model_lipschitz(
        model: *const hrbfnpr_model,
        lipschitz: *mut f64,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Tells which of n points lie inside the surface: f < 0, and within the search box.
    /// Points beyond the box are outside; f is not evaluated there.  A surface with a border
    /// bounds nothing: the result then tells the side by the sign of f.
    ///
    /// points:         n x 3, FLOAT32 or FLOAT64, finite
    /// inside:         receives n x 1 UINT8: 1 inside, else 0; may be NULL
    /// inside_count:   receives the number of points inside; may be NULL
    /// operation:      may be NULL
    pub fn hrbfnpr_model_contains(
        model: *const hrbfnpr_model,
        points: *const hrbfnpr_array,
        inside: *const hrbfnpr_array_out,
        inside_count: *mut i64,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// How a surface is trimmed.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_trim_desc {
    pub struct_size: u32,
    /// must be 0
    pub reserved: u32,
    /// the surface ends where s is above this; 0.001 to 1000; default 1.5. Larger values end it
    /// later: 1.5 about 0.7 spacings beyond its last samples, 3 about 0.9
    pub limit: f64,
    /// holes whose points are all within this distance of a sample stay closed, in diagonals; 0
    /// or more; default 0.05. Larger values keep larger holes closed
    pub hole: f64,
    /// samples closer to each other than this are treated as this far apart, in diagonals; 0 to
    /// 1; default 0. Use it for samples that are much denser than the surface is accurate, such
    /// as many points of a mesh: 0.01 leaves out whatever is more than about 0.01 diagonals off
    /// them, and every part that is somewhere farther than `hole` from all samples
    pub closest: f64,
    /// N x 3, FLOAT32 or FLOAT64, finite: the samples; not given = the model's centres. All
    /// points of a scan show better than the chosen centres where it ends
    pub points: hrbfnpr_array,
    /// N x 3, FLOAT32 or FLOAT64, of any length but 0: one normal for each of `points`; not given
    /// = those of the centres, or of the surface at the given points
    pub normals: hrbfnpr_array,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_trim_desc_init(desc: *mut hrbfnpr_trim_desc, struct_size: u32) -> hrbfnpr_status;
    /// Makes the same model with a surface that ends where its samples end.  Marks, line sets
    /// and rays of the new model end there.  f, projections, curvatures and
    /// hrbfnpr_model_contains stay those of `model`, which the new model keeps alive.
    /// Trimming a trimmed model starts from the whole model.  If nothing is to be left out,
    /// the surface stays whole, and all results are bit for bit those of `model`.  Files of
    /// models store the trim.
    ///
    /// desc:        NULL = all defaults
    /// operation:   may be NULL
    ///
    /// Errors: INVALID_ARGUMENT: the model is not a fit, and no points are given.
    /// NOT_CONVERGED: no part of the surface is near the samples, or a single sample has no
    /// spacing.
    pub fn hrbfnpr_model_trim(
        model: *const hrbfnpr_model,
        desc: *const hrbfnpr_trim_desc,
        operation: *mut hrbfnpr_operation,
        out_model: *mut *mut hrbfnpr_model,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// What trimming left out.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_trim_info {
    pub struct_size: u32,
    /// 1: the surface ends somewhere; 0: it is whole, and all fields except samples and spacing are 0
    pub is_trimmed: u32,
    /// number of samples that were looked at; 0 if trimming was not asked for, if the model is a
    /// fit to a closed mesh, or if the end could not be found
    pub samples: i64,
    /// number of connected parts of the surface that are left out
    pub parts: i64,
    /// number of these that reach the end of the search box: the samples are open there
    pub parts_to_end: i64,
    /// share of the surface's area in the box that is left out; 0 to 1; accurate to some percent
    pub share: f64,
    /// largest distance of a place that is left out from the samples, in the model's unit
    pub farthest: f64,
    /// spacing of the samples: the median distance to the sixth neighbour
    pub spacing: f64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_trim_info_init(info: *mut hrbfnpr_trim_info, struct_size: u32) -> hrbfnpr_status;
    /// Fills `info` with what the last trim of a model left out.
    pub fn hrbfnpr_model_get_trim_info(
        model: *const hrbfnpr_model,
        info: *mut hrbfnpr_trim_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// --------------------------------------------------------------------------
// Solids (constructive solid geometry).  A solid is a tree of unions,
// intersections, differences and other operations.  Its leaves are primitives and
// models of any kind.  Where parts meet, there is a crease or a blend.  f is
// negative inside and has units of length:
//
//   union          min(a, b)
//   intersection   max(a, b)
//   difference     max(a, -b): the first child without all others
//   complement     -a
//   offset         a - distance
//   shell          max(a, -a - distance): a wall of this thickness inside the surface
//
// Primitives lie around the origin and along the z axis of their own coordinates.
// The transforms of a node and of its parents move them to their places.  For a
// half-space, a sphere and a torus f is the signed distance to the surface.  For a
// box, a cylinder and a cone it is the largest of the distances from their sides:
// the distance inside, and outside where one side is nearest; less beside edges
// and corners.
//
// A blend rounds the place where parts meet.  It acts where both parts are nearer
// than the radius R to their surfaces.  Children are blended one after the other,
// in their order.  For a union:
//
//   exponent 0     min(a, b) - R/6 (1 - |a - b|/R)^3 where |a - b| < R, else min(a, b)
//   exponent p     max(R, min(a, b)) - (A^p + B^p)^(1/p), A = max(0, R - a), B = max(0, R - b)
//
// Exponent 0 is twice continuously differentiable everywhere; at a right angle it
// begins at the distance R from the edge [after Barthe, Wyvill & de Groot 2004].
// Exponent 2 gives an arc of radius R at a right angle, and larger exponents are
// sharper [Ricci 1973].  Such a blend is smooth where f < R only, so do not offset
// it by R or more; |grad f| may grow by the factor 2^(1/p).
//
// A model as a leaf ends at its search box: everything beyond is outside, whatever
// f is there.  A leaf that is itself a solid becomes part of the new tree, and the
// bounds that were given for it are ignored.  A trimmed model bounds no solid and is
// refused: fit it with trim NEVER.
//
// The kinds of nodes are:
/// everything inside any child
pub const HRBFNPR_CSG_UNION: u32 = 0;
/// everything inside all children
pub const HRBFNPR_CSG_INTERSECTION: u32 = 1;
/// the first child without all others
pub const HRBFNPR_CSG_DIFFERENCE: u32 = 2;
/// everything outside its child; has one child
pub const HRBFNPR_CSG_COMPLEMENT: u32 = 3;
/// its child, grown outward by `distance`, or inward if that is negative; has one child.
/// Exact where f is the distance
pub const HRBFNPR_CSG_OFFSET: u32 = 4;
/// its child as a hollow body with a wall of thickness `distance` inside the surface; has one child
pub const HRBFNPR_CSG_SHELL: u32 = 5;
/// the field `model`; a leaf
pub const HRBFNPR_CSG_MODEL: u32 = 6;
/// z <= 0; a leaf
pub const HRBFNPR_CSG_HALF_SPACE: u32 = 7;
/// a box of the sides `size`, centred at the origin; a leaf
pub const HRBFNPR_CSG_BOX: u32 = 8;
/// a ball of `radius` around the origin; a leaf
pub const HRBFNPR_CSG_SPHERE: u32 = 9;
/// a cylinder of `radius` around the z axis, z from -height/2 to height/2; a leaf
pub const HRBFNPR_CSG_CYLINDER: u32 = 10;
/// a cone around the z axis, z from -height/2 to height/2, with `radius` at the lower end and
/// `second_radius` at the upper end; a leaf
pub const HRBFNPR_CSG_CONE: u32 = 11;
/// a tube of `second_radius` around a circle of `radius` around the z axis; a leaf
pub const HRBFNPR_CSG_TORUS: u32 = 12;

/// A node of a solid's tree.  Fields that its kind does not use are ignored.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_csg_node {
    pub struct_size: u32,
    /// HRBFNPR_CSG_...; default UNION
    pub kind: u32,
    /// index of the parent, which comes earlier in the list; default -1 = none, for the first
    /// node, which is the root. Children have the order of the list
    pub parent: i64,
    /// the model of MODEL, which the solid keeps alive; not trimmed
    pub model: *const hrbfnpr_model,
    /// affine map from the node's coordinates to the parent's; default the identity. It applies
    /// to the node and all below, and may turn, mirror and stretch. The largest stretch may be
    /// 1e4 times the least. If it stretches unevenly, lengths are measured by the least stretch,
    /// so that |grad f| does not grow
    pub transform: [f64; 16],
    /// sides of BOX; above 0; default 1
    pub size: [f64; 3],
    /// radius of SPHERE, CYLINDER, CONE and TORUS; above 0, but 0 or more for CONE, of which one
    /// radius must be above 0; default 1
    pub radius: f64,
    /// upper radius of CONE, 0 or more; tube radius of TORUS, above 0 and below `radius`; default 0.5
    pub second_radius: f64,
    /// height of CYLINDER and CONE; above 0; default 1
    pub height: f64,
    /// growth of OFFSET, finite; wall thickness of SHELL, above 0; default 0
    pub distance: f64,
    /// radius R of the blend of UNION, INTERSECTION and DIFFERENCE; 0 or more; default 0 = a
    /// crease. Larger values round more
    pub blend: f64,
    /// exponent of the blend; 0, or 2 to 64; default 0. From 2 on, larger values are sharper
    pub exponent: f64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_csg_node_init(node: *mut hrbfnpr_csg_node, struct_size: u32) -> hrbfnpr_status;
}

/// A solid to make.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_csg_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// the list of nodes: a tree of any depth; 1 to 65536 nodes, with those of solids that are leaves
    pub nodes: *const hrbfnpr_csg_node,
    /// number of nodes in the list
    pub node_count: i64,
    /// bytes from one node to the next; 0 = the first one's struct_size
    pub node_stride: i64,
    /// lower corner of the box in which the surface is looked for; both corners all 0 (default) =
    /// found from the tree
    pub bounds_min: [f64; 3],
    /// upper corner of the box
    pub bounds_max: [f64; 3],
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_csg_desc_init(desc: *mut hrbfnpr_csg_desc, struct_size: u32) -> hrbfnpr_status;
    /// Makes a solid.  Every function of this section works on it.  Derivatives are those of
    /// the part that is active at a place.  A solid can be saved if its leaves can.  It keeps
    /// its leaves alive.  It runs on several threads if all custom functions among its leaves
    /// are thread-safe.
    ///
    /// Errors: INVALID_ARGUMENT: a node is wrong (the message gives its index); the surface
    /// may have no end (intersect it with a box, or give bounds); nothing is left of the
    /// solid.
    pub fn hrbfnpr_model_create_csg(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_csg_desc,
        out_model: *mut *mut hrbfnpr_model,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// What a solid is made of.  All fields are 0 for a model that is not a solid.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_csg_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// number of nodes, with those of solids that became part of it
    pub nodes: i64,
    /// number of nodes from the root to the deepest leaf, both included
    pub depth: i64,
    /// number of different models among the leaves
    pub models: i64,
    /// number of smooth functions that it consists of: sides of primitives, sides of the boxes at
    /// which models end, and one for each pair of those that a blend joins
    pub sheets: i64,
    /// a bound on |grad f| that holds everywhere; 0 if none is known, because leaves are models
    pub lipschitz: f64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_csg_info_init(info: *mut hrbfnpr_csg_info, struct_size: u32) -> hrbfnpr_status;
    /// Fills `info` with what a solid is made of.
    pub fn hrbfnpr_model_get_csg_info(
        model: *const hrbfnpr_model,
        info: *mut hrbfnpr_csg_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Saves a model to a stream.  The stream is little-endian, has a version and a
    /// checksum, and is described in docs/file-format.md.  A loaded model evaluates to the
    /// same bits.
    ///
    /// Errors: INVALID_ARGUMENT: a custom model, or a solid with one among its leaves, cannot
    /// be saved.  IO: `write` failed.
    pub fn hrbfnpr_model_save(
        model: *const hrbfnpr_model,
        write: hrbfnpr_write_fn,
        user: *mut c_void,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Saves a model to memory.
    ///
    /// destination:   receives the stream; may be NULL if capacity is 0
    /// capacity:      the size of destination in bytes, 0 or more
    /// size:          receives the bytes that the stream needs; must be given
    ///
    /// Errors: those of hrbfnpr_model_save.  BUFFER_TOO_SMALL: capacity is below *size; only
    /// *size is written.
    pub fn hrbfnpr_model_save_memory(
        model: *const hrbfnpr_model,
        destination: *mut c_void,
        capacity: i64,
        size: *mut i64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Loads a model from a stream.
    ///
    /// Errors: IO: `read` failed.  CORRUPT_DATA: the stream is no model, truncated or
    /// damaged.  VERSION_MISMATCH: a newer library wrote it.
    pub fn hrbfnpr_model_load(
        context: *mut hrbfnpr_context,
        read: hrbfnpr_read_fn,
        user: *mut c_void,
        out_model: *mut *mut hrbfnpr_model,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Loads a model from `size` bytes of memory.  Errors: those of hrbfnpr_model_load,
    /// without IO.
    pub fn hrbfnpr_model_load_memory(
        context: *mut hrbfnpr_context,
        data: *const c_void,
        size: i64,
        out_model: *mut *mut hrbfnpr_model,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 7  POINT SET: layers of marks on a surface, immutable [NPAR 4.2, 5]

/// A handle to a set of marks.  It never changes.
#[repr(C)]
pub struct hrbfnpr_point_set {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

// The kind of a layer's marks.  Later versions may add kinds: treat an unknown one
// like OWN.
/// for styles only: layers of every kind
pub const HRBFNPR_LAYER_KIND_ANY: u32 = 0;
/// scattered marks
pub const HRBFNPR_LAYER_KIND_STIPPLES: u32 = 1;
/// lines along a field of directions, which `guide` or direction_function gives. With
/// BLUE_NOISE they are evenly spaced and nested: lines of level 0 are the coarsest, and lines
/// of each further level lie midway between all before [Knoeppel et al. 2015]. With PUBLISHED
/// they are strokes that grow from seeds, along the directions and across them [NPAR 5]
pub const HRBFNPR_LAYER_KIND_HATCH: u32 = 2;
/// marks or strokes of the caller
pub const HRBFNPR_LAYER_KIND_OWN: u32 = 3;

// How marks are distributed over a surface.
/// stipples are evenly spread in a progressive order, every prefix of which is evenly spread;
/// lines of HATCH are evenly spaced and nested; the default. Where the surface bends within
/// the spacing of stipples, a layer may miss its budget by some marks in a thousand
/// (docs/quality.md)
pub const HRBFNPR_DISTRIBUTION_BLUE_NOISE: u32 = 0;
/// the published recursion: each level has 5 times as many stipples, or 3 times as many marks
/// of strokes, and ranks are random [NPAR 5, 6.2]
pub const HRBFNPR_DISTRIBUTION_PUBLISHED: u32 = 1;

// The directions that lines of HATCH follow without a direction_function.  Where the
// directions have a low confidence, lines follow the smoothest field between.
// PUBLISHED takes CURVATURE, COMBING or a direction_function; another guide is
// INVALID_ARGUMENT.
/// the direction in which the surface bends most. PUBLISHED: strokes along both principal
/// directions, d1 and d2
pub const HRBFNPR_HATCH_GUIDE_CURVATURE: u32 = 0;
/// Stark's combing direction r. PUBLISHED: strokes along r and u [NPAR 5.3]
pub const HRBFNPR_HATCH_GUIDE_COMBING: u32 = 1;
/// sections of the surface by planes perpendicular to `axis`
pub const HRBFNPR_HATCH_GUIDE_SECTIONS: u32 = 2;
/// the tangent part of guide_direction, which points to the light
pub const HRBFNPR_HATCH_GUIDE_LIGHT: u32 = 3;
/// the direction conjugate to guide_direction, which points to the eye: near the silhouette,
/// lines run along it
pub const HRBFNPR_HATCH_GUIDE_SILHOUETTE: u32 = 4;

// The seeds from which marks start.
/// the samples, if the model has them (for PUBLISHED: well-spread ones), else BOX
pub const HRBFNPR_SEED_AUTO: u32 = 0;
/// the model's samples; INVALID_ARGUMENT for a model without samples
pub const HRBFNPR_SEED_SAMPLES: u32 = 1;
/// a jittered grid in the bounds, projected onto the surface
pub const HRBFNPR_SEED_BOX: u32 = 2;
/// seed_points, projected onto the surface
pub const HRBFNPR_SEED_POINTS: u32 = 3;

// Where the strokes of PUBLISHED start.
/// at the seeds
pub const HRBFNPR_STROKE_START_SEEDS: u32 = 0;
/// at the stipples up to level start_level
pub const HRBFNPR_STROKE_START_STIPPLES: u32 = 1;

// How densely the stipples of BLUE_NOISE lie.
/// the same number of stipples per area everywhere
pub const HRBFNPR_DENSITY_UNIFORM: u32 = 0;
/// more stipples where the surface bends: 1 - s + s c / (c + mean of c), where s is
/// density_strength and c = sqrt((k1^2 + k2^2) / 2)
pub const HRBFNPR_DENSITY_CURVATURE: u32 = 1;
/// the density of density_function
pub const HRBFNPR_DENSITY_CALLBACK: u32 = 2;

/// Gives a density on the surface: 1 where marks lie closest, 0 where there are none.
/// Larger numbers count as 1.  A negative number or NaN fails the call with CALLBACK, and
/// so does a result other than 0.  A density without any mark is INVALID_ARGUMENT.  The
/// function gets some thousand places at a time, on the thread that called _generate.
///
/// positions:   count x 3, absolute
/// normals:     count x 3, unit
/// density:     receives count numbers
pub type hrbfnpr_density_fn = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        count: i64,
        positions: *const f64,
        normals: *const f64,
        density: *mut f64,
    ) -> i32,
>;

/// Gives a field of directions on the surface.  Only the tangent part of a direction
/// counts; its sign and length do not.  (0, 0, 0) means no direction: lines follow the
/// smoothest field between the others.  NaN or infinity fails the call with CALLBACK, and
/// so does a result other than 0.  The function gets some thousand places at a time, on
/// the thread that called _generate.
///
/// positions:    count x 3, absolute
/// normals:      count x 3, unit
/// directions:   receives count x 3
pub type hrbfnpr_direction_fn = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        count: i64,
        positions: *const f64,
        normals: *const f64,
        directions: *mut f64,
    ) -> i32,
>;

// The tones in which layers appear, if they have no tone range of their own.
/// each layer covers all tones
pub const HRBFNPR_TONE_RANGES_FULL: u32 = 0;
/// the layers follow each other in the order of the list, each over an equal part of the
/// tones (of PUBLISHED strokes the first direction, then the second): cross-hatching builds
/// up from light to dark
pub const HRBFNPR_TONE_RANGES_IN_TURN: u32 = 1;

// What else is made for a layer.
/// fill the attribute CURVATURE; PUBLISHED strokes along CURVATURE always have it
pub const HRBFNPR_LAYER_WITH_CURVATURE: u32 = 1;

/// How one layer of marks is made.
///
/// tone_begin is the darkness (1 - tone) at which the first mark of the layer is shown,
/// tone_end the darkness at which all are shown: the rank u becomes
/// 1 - begin - (1 - u) (end - begin), with 0 <= begin < end <= 1.  If both are 0,
/// hrbfnpr_generate_desc.tone_ranges decides.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_layer_desc {
    pub struct_size: u32,
    /// HRBFNPR_LAYER_KIND_STIPPLES or HATCH; default STIPPLES
    pub kind: u32,
    /// name for styles; UTF-8, 1 to 63 bytes, copied; default NULL = "stipples" or "hatch"
    pub name: *const c_char,
    /// largest number of marks; 0 or more, at most 100000000 for BLUE_NOISE; default 40000. 0 =
    /// no limit, for PUBLISHED and for lines with a separation. PUBLISHED thins the level that
    /// exceeds the budget at random and stops there. Lines of BLUE_NOISE have about this number
    /// of marks, and ignore the budget if they have a separation. shared_budget replaces it
    pub budget: i64,
    /// darkness at which the first mark is shown; 0 to 1; default 0. For PUBLISHED strokes, those
    /// of the first direction
    pub tone_begin: f32,
    /// darkness at which all marks are shown; 0 to 1; default 0
    pub tone_end: f32,
    /// the same as tone_begin, for PUBLISHED strokes of the second direction; default 0
    pub second_tone_begin: f32,
    /// the same as tone_end, for PUBLISHED strokes of the second direction; default 0
    pub second_tone_end: f32,
    /// HRBFNPR_LAYER_WITH_... flags, or-ed; default 0
    pub flags: u32,
    /// HRBFNPR_DENSITY_...; default UNIFORM
    ///
    /// Stipples of BLUE_NOISE.  They keep their evenness: a mark is left out if its place in the uniform
    /// order, divided by the density, is too high.
    pub density: u32,
    /// strength of CURVATURE; 0 to 1; default 0.5. 0 = uniform; larger values put more stipples
    /// where the surface bends
    pub density_strength: f64,
    /// the function of CALLBACK. If its mean is below 1/16, the layer has fewer marks than its budget
    pub density_function: hrbfnpr_density_fn,
    /// passed to density_function
    pub density_user: *mut c_void,
    /// the directions that lines follow; default NULL = those of `guide`
    ///
    /// HATCH.
    pub direction_function: hrbfnpr_direction_fn,
    /// passed to direction_function
    pub direction_user: *mut c_void,
    /// HRBFNPR_HATCH_GUIDE_...; default CURVATURE
    pub guide: u32,
    /// HRBFNPR_STROKE_START_...; default SEEDS
    ///
    /// HATCH of PUBLISHED.
    pub start: u32,
    /// last level of stipples at which strokes start, with STROKE_START_STIPPLES; 0 to 12; default 0
    pub start_level: i32,
    /// number of refinement steps, for stipples of PUBLISHED, too; 0 to 12; default -1 = 4 for
    /// stipples, 3 for strokes. Strokes have 3^levels marks. Each further level makes five times
    /// as many stipples, or three times as many marks in each stroke
    pub levels: i32,
    /// mean distance of neighbouring lines, in the unit of the samples; 1e-12 to 1e9 diagonals;
    /// default 0 = by the budget. Smaller values give more lines
    ///
    /// HATCH of BLUE_NOISE.
    pub separation: f64,
    /// distance between the marks of a line, in the unit of the samples; 1e-12 to 1e9 diagonals;
    /// default 0 = 0.4 of the separation
    pub step: f64,
    /// angle by which lines are turned in the tangent plane, counter-clockwise as seen from
    /// outside, in degrees; -360 to 360; default 0
    pub angle: f64,
    /// length over which directions are smoothed, in diagonals; 1e-6 to 1; default 0.04. Larger
    /// values give calmer lines that follow the form less
    pub smoothing: f64,
    /// axis around which lines run where curvature has a low confidence; not 0; default (0, 1, 0)
    pub axis: [f64; 3],
    /// weight of the axis against curvature; 0 to 1000; default 0.06. Larger values make more
    /// lines run around the axis
    pub axis_weight: f64,
    /// direction to the light (LIGHT) or to the eye (SILHOUETTE), in the model's coordinates; not
    /// 0; default (0, 0, 1)
    pub guide_direction: [f64; 3],
    /// weight of a guide other than CURVATURE; curvature has the rest; 0 to 1; default 1.
    /// Directions are blended as exp(2 i angle)
    pub guide_weight: f64,
    /// length over which the attribute TONE_NORMAL is averaged, in diagonals; 0 to 0.1; 0 = none:
    /// tone follows NORMAL; default -1 = 0.006 for HATCH of BLUE_NOISE, 0 for others. Larger
    /// values keep the grain of a rough surface out of the tone
    ///
    /// All kinds.
    pub tone_smoothing: f64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_layer_desc_init(
        desc: *mut hrbfnpr_layer_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// The layers of marks to make.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_generate_desc {
    pub struct_size: u32,
    /// HRBFNPR_DISTRIBUTION_...; default BLUE_NOISE
    pub distribution: u32,
    /// the list of layers; default NULL, with layer_count 0 = one layer of stipples
    pub layers: *const hrbfnpr_layer_desc,
    /// number of layers; 0 to 65536; default 0
    pub layer_count: i64,
    /// bytes from one layer to the next; 0 = the first one's struct_size
    pub layer_stride: i64,
    /// largest number of marks of all layers together, which they share in proportion to the
    /// lengths of their tone ranges; 0 or more; default 0 = each layer has its own budget
    pub shared_budget: i64,
    /// HRBFNPR_TONE_RANGES_...; default FULL
    pub tone_ranges: u32,
    /// HRBFNPR_SEED_...; default AUTO
    pub seed_source: u32,
    /// n x 3, FLOAT32 or FLOAT64: the seeds of POINTS, within 1e4 diagonals of the bounds
    pub seed_points: hrbfnpr_array,
    /// alpha: largest random shift of the grid points of BOX, in cell sides; 0 to 0.5; default 0.25
    pub box_jitter: f64,
    /// R: number of cells of BOX along the longest side of the bounds; 1 to 256; default 8 [NPAR
    /// 4.2]. More cells give more seeds and miss fewer sheets. BLUE_NOISE with seed_source AUTO
    /// uses at least 16
    pub box_resolution: u32,
    pub reserved: u32,
    /// rho_0: first step of PUBLISHED, in the unit of the samples; 1e-12 to 1e9 diagonals;
    /// default 0 = the diameter of a cell for BOX, the mean diameter of empty balls between the
    /// seeds for others [NPAR 5.1]
    pub initial_step: f64,
    /// as in hrbfnpr_project_desc; above 0; default 1e-7
    pub projection_tolerance: f64,
    /// start of the random numbers; any number; default 1. Another number gives other marks
    pub random_seed: u64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_generate_desc_init(
        desc: *mut hrbfnpr_generate_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Places marks on the surface of a model.  Marks whose projection fails or lands too far
    /// away are dropped and counted (hrbfnpr_placement_info).
    ///
    /// desc:        NULL = all defaults
    /// operation:   may be NULL
    ///
    /// Sizes.  Marks are stored as floats, so the diagonal of the model's bounds must be from
    /// 1e-33 to 1e33.  If it is outside 1e-9 to 1e9, a model that is scaled by a power of two
    /// has the same marks, scaled; curvatures that do not fit into a float become the largest
    /// float.
    /// The bounds of a custom model may be up to 500 times as wide as its surface.
    ///
    /// Errors: INVALID_ARGUMENT, before any mark is placed: a size or a budget is out of its
    /// range.  NOT_CONVERGED: no seed or no mark could be placed, or no stroke has room with the
    /// given separation or step.  CALLBACK: a density or direction function failed.
    pub fn hrbfnpr_point_set_generate(
        context: *mut hrbfnpr_context,
        model: *const hrbfnpr_model,
        desc: *const hrbfnpr_generate_desc,
        operation: *mut hrbfnpr_operation,
        out_point_set: *mut *mut hrbfnpr_point_set,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// The arrays of a layer, with one element for each mark or for each of its S strokes.
/// FLOAT32 x 3: the place, relative to hrbfnpr_point_set_info.origin
pub const HRBFNPR_MARK_ATTRIBUTE_POSITION: u32 = 0;
/// FLOAT32 x 3: the normal; unit, outward
pub const HRBFNPR_MARK_ATTRIBUTE_NORMAL: u32 = 1;
/// FLOAT32 x 3: the direction along the stroke; unit, tangent. For a mark without a stroke:
/// the u of its basis [NPAR 5.2]
pub const HRBFNPR_MARK_ATTRIBUTE_DIRECTION: u32 = 2;
/// FLOAT32 x 3: k1, k2 and confidence, as hrbfnpr_model_curvature gives them
pub const HRBFNPR_MARK_ATTRIBUTE_CURVATURE: u32 = 3;
/// FLOAT32: the rank u of [NPAR 6.2], in [0, 1): a mark is shown where u >= tone. All marks
/// of a line of BLUE_NOISE have the same rank
pub const HRBFNPR_MARK_ATTRIBUTE_RANK: u32 = 4;
/// UINT8: the refinement step that placed the mark; 0 = a seed. For HATCH of BLUE_NOISE: the
/// level of its line there (see HRBFNPR_LAYER_KIND_HATCH)
pub const HRBFNPR_MARK_ATTRIBUTE_LEVEL: u32 = 5;
/// UINT32 x 2: 2 * number + direction (0 or 1) of the stroke, and the mark's place along it.
/// PUBLISHED: the number is that of the seed, and places are 0 to 3^levels - 1 with the seed
/// in the middle. Others: places are 0 to n - 1 from end to end. For a mark without a stroke:
/// 2 * its number (PUBLISHED: of its seed), and 0
pub const HRBFNPR_MARK_ATTRIBUTE_STROKE: u32 = 6;
/// FLOAT32: the width as a factor of the style's radius, in (0, 1]; 1 in the middle of a
/// stroke, less towards its tapered ends; for front marks. Count 0 = all 1
pub const HRBFNPR_MARK_ATTRIBUTE_WIDTH: u32 = 7;
/// UINT32, S + 1 elements: stroke s has the marks order[first[s]] to order[first[s + 1] - 1]
/// from end to end, where order is STROKE_ORDER. Count 0 = a layer without strokes
pub const HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST: u32 = 8;
/// UINT32: numbers of marks, stroke by stroke. Count 0 = the marks themselves are in this
/// order, as in every layer except those of PUBLISHED
pub const HRBFNPR_MARK_ATTRIBUTE_STROKE_ORDER: u32 = 9;
/// FLOAT32 x 3: the unit normal that sets the tone with DEPTH_LAYERS, averaged over
/// hrbfnpr_layer_desc.tone_smoothing on the same sheet. NORMAL decides whether the mark faces
/// the eye. Count 0 = NORMAL
pub const HRBFNPR_MARK_ATTRIBUTE_TONE_NORMAL: u32 = 10;

/// A layer of N ready-made marks.  position and normal must be given; the other arrays may be
/// empty.  The scalars are those that HRBFNPR_MARK_ATTRIBUTE_... lists; FLOAT64 is accepted
/// for FLOAT32.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_layer_arrays {
    pub struct_size: u32,
    /// HRBFNPR_LAYER_KIND_..., except ANY; default OWN
    pub kind: u32,
    /// name for styles; UTF-8, 1 to 63 bytes, copied; default NULL = that of the kind
    pub name: *const c_char,
    /// absolute places, not relative to an origin; N x 3
    pub position: hrbfnpr_array,
    /// outward normals of any length but 0; N x 3
    pub normal: hrbfnpr_array,
    /// UINT32, S + 1 elements that rise from 0 to N: stroke s has the marks first[s] to first[s +
    /// 1] - 1 from end to end. Empty = no strokes
    pub stroke_first: hrbfnpr_array,
    /// UINT8, S elements: 0 = the first direction, 1 = the second. Empty = 0
    pub stroke_direction: hrbfnpr_array,
    /// directions of any length, not along the normal; N x 3. Empty = along the stroke, or the u
    /// of the basis for a mark without a stroke
    pub direction: hrbfnpr_array,
    /// k1, k2 and confidence; N x 3. Empty = not known
    pub curvature: hrbfnpr_array,
    /// ranks in [0, 1); N x 1. Empty = random, the same for all marks of a stroke
    pub rank: hrbfnpr_array,
    /// refinement steps, UINT8; N x 1. Empty = 0
    pub level: hrbfnpr_array,
    /// widths in (0, 1]; N x 1. Empty = 1
    pub width: hrbfnpr_array,
}

extern "C" {
    /// Sets every field to its default; no array is given.
    pub fn hrbfnpr_layer_arrays_init(
        arrays: *mut hrbfnpr_layer_arrays,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// A set of ready-made marks to make.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_point_set_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// a set whose layers come first, copied; default NULL = none
    pub base: *const hrbfnpr_point_set,
    /// the list of layers that follow
    pub layers: *const hrbfnpr_layer_arrays,
    /// number of layers in the list; 0 to 65536; default 0
    pub layer_count: i64,
    /// bytes from one layer to the next; 0 = the first one's struct_size
    pub layer_stride: i64,
    /// start of the random numbers for ranks that are not given; any number; default 1
    pub random_seed: u64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_point_set_desc_init(
        desc: *mut hrbfnpr_point_set_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Creates a point set from marks of the caller, or from the layers of another set and marks
    /// of the caller.  The marks must be from 1e-33 to 1e33 across, or all at one place.  A set
    /// with a base keeps the base's origin and distribution.  It keeps its spacing, too, unless
    /// a new layer has more marks than each layer before: the same area then holds more marks.
    ///
    /// Errors: INVALID_ARGUMENT: there is no mark, or a number is wrong; the message names the
    /// layer, the array and the index.
    pub fn hrbfnpr_point_set_create(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_point_set_desc,
        out_point_set: *mut *mut hrbfnpr_point_set,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference. Any thread.
    pub fn hrbfnpr_point_set_retain(set: *const hrbfnpr_point_set);
    /// Removes a reference. Any thread.
    pub fn hrbfnpr_point_set_release(set: *const hrbfnpr_point_set);
}

/// What a point set holds, and how long it took.  Lengths are in the unit of the samples.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_point_set_info {
    pub struct_size: u32,
    /// HRBFNPR_DISTRIBUTION_...: the one used
    pub distribution: u32,
    /// the seed source used
    pub seed_source: u32,
    pub reserved: u32,
    /// number of layers
    pub layers: i64,
    /// number of marks in all layers
    pub marks: i64,
    /// add it to the attribute POSITION to get absolute places
    pub origin: [f64; 3],
    /// lower corner of the box around all marks, absolute
    pub bounds_min: [f64; 3],
    /// upper corner of the box
    pub bounds_max: [f64; 3],
    /// square root of the area per mark of the largest layer, estimated. A frame takes it as the
    /// size of a mark's piece of surface
    pub spacing: f64,
    /// time of finding the seeds
    pub seconds_seeds: f64,
    /// time of the whole call
    pub seconds_total: f64,
    /// memory that the set keeps
    pub bytes: i64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_point_set_info_init(
        info: *mut hrbfnpr_point_set_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Fills `info` with what a point set holds.
    pub fn hrbfnpr_point_set_get_info(
        set: *const hrbfnpr_point_set,
        info: *mut hrbfnpr_point_set_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// What a layer holds.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_layer_info {
    pub struct_size: u32,
    /// HRBFNPR_LAYER_KIND_...
    pub kind: u32,
    /// the layer's name; UTF-8, zero-terminated
    pub name: [c_char; 64],
    /// number of marks
    pub marks: i64,
    /// number of strokes that the marks form; 0 = none
    pub strokes: i64,
    /// number of marks that there would be if none had been dropped
    pub full_count: i64,
    /// number of refinement steps taken; for HATCH of BLUE_NOISE the highest level
    pub levels: i32,
    pub reserved: u32,
    /// initial step rho_0 used, in the unit of the samples; for HATCH of BLUE_NOISE the separation
    pub step: f64,
    /// time of making the layer
    pub seconds: f64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_layer_info_init(
        info: *mut hrbfnpr_layer_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Fills `info` with what a layer holds.  layer: 0 to hrbfnpr_point_set_info.layers - 1.
    pub fn hrbfnpr_point_set_get_layer_info(
        set: *const hrbfnpr_point_set,
        layer: i64,
        info: *mut hrbfnpr_layer_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// What became of the candidates for marks: attempted = placed + all dropped.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_placement_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// number of candidates
    pub attempted: i64,
    /// number of candidates that became marks
    pub placed: i64,
    /// number of candidates whose projection did not reach the tolerance
    pub dropped_not_converged: i64,
    /// number of candidates that landed farther away than a cell's diagonal or the step, lie
    /// beyond the end of a trimmed model, or lost the connection to their stroke because a mark
    /// between was dropped
    pub dropped_strayed: i64,
    /// number of candidates where the gradient is 0 or not finite
    pub dropped_degenerate: i64,
    /// number of candidates over the layer's budget
    pub dropped_budget: i64,
}

extern "C" {
    /// Clears the struct before its first use.
    pub fn hrbfnpr_placement_info_init(
        info: *mut hrbfnpr_placement_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Fills `info` with what became of the seeds.
    pub fn hrbfnpr_point_set_get_seed_placement(
        set: *const hrbfnpr_point_set,
        info: *mut hrbfnpr_placement_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Fills `info` with what became of the candidates of one level of one layer.
    /// level: 0 to hrbfnpr_layer_info.levels.
    pub fn hrbfnpr_point_set_get_placement(
        set: *const hrbfnpr_point_set,
        layer: i64,
        level: i32,
        info: *mut hrbfnpr_placement_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gives a view of one attribute (HRBFNPR_MARK_ATTRIBUTE_...) of one layer, without a copy.
    /// The view is valid while the set lives.  Its count is 0 for an empty layer, and for an
    /// attribute that the layer does not have.
    pub fn hrbfnpr_point_set_view(
        set: *const hrbfnpr_point_set,
        layer: i64,
        attribute: u32,
        out_view: *mut hrbfnpr_array,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Makes squares that show how large the initial step of PUBLISHED is [NPAR 5.1, Figure 5].
    /// Each square has sides of 2 * initial_step and lies in the tangent plane of a random seed.
    /// The seeds, and the estimate if initial_step is 0, are those that
    /// hrbfnpr_point_set_generate uses with the same desc.
    ///
    /// desc:        NULL = all defaults
    /// corners:     receives n x 12, FLOAT32 or FLOAT64: four corners for each square, absolute,
    /// counter-clockwise as seen
    ///              from outside
    /// step:        receives the initial step; may be NULL
    /// operation:   may be NULL
    pub fn hrbfnpr_point_set_step_patches(
        context: *mut hrbfnpr_context,
        model: *const hrbfnpr_model,
        desc: *const hrbfnpr_generate_desc,
        corners: *const hrbfnpr_array_out,
        step: *mut f64,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Saves a point set to a stream, like hrbfnpr_model_save.
    ///
    /// Errors: IO: `write` failed.
    pub fn hrbfnpr_point_set_save(
        set: *const hrbfnpr_point_set,
        write: hrbfnpr_write_fn,
        user: *mut c_void,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Saves a point set to memory, like hrbfnpr_model_save_memory.
    ///
    /// Errors: BUFFER_TOO_SMALL: capacity is below *size; only *size is written.
    pub fn hrbfnpr_point_set_save_memory(
        set: *const hrbfnpr_point_set,
        destination: *mut c_void,
        capacity: i64,
        size: *mut i64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Loads a point set from a stream.
    ///
    /// Errors: IO: `read` failed.  CORRUPT_DATA: the stream is no point set, truncated or
    /// damaged.  VERSION_MISMATCH: a newer library wrote it.
    pub fn hrbfnpr_point_set_load(
        context: *mut hrbfnpr_context,
        read: hrbfnpr_read_fn,
        user: *mut c_void,
        out_point_set: *mut *mut hrbfnpr_point_set,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Loads a point set from `size` bytes of memory.  Errors: those of
    /// hrbfnpr_point_set_load, without IO.
    pub fn hrbfnpr_point_set_load_memory(
        context: *mut hrbfnpr_context,
        data: *const c_void,
        size: i64,
        out_point_set: *mut *mut hrbfnpr_point_set,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 8  LINE SET: what the lines of a surface are drawn from, immutable

#[repr(C)]
pub struct hrbfnpr_line_set {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

// Kinds of lines.  Those marked "once" are found when a line set is made, for each element
// of its list; the others
// with every drawing.  Strengths have no unit: lengths are in diagonals of the model.
/// occluding contours: the line of sight is tangent to the surface
pub const HRBFNPR_LINE_KIND_CONTOUR: u32 = 1;
/// where a contour would appear soon; strength: the derivative of the radial curvature
/// towards the eye; WITH_CURVATURE [DeCarlo 2003]
pub const HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR: u32 = 2;
/// once; strength: curvature across the ridge less that along it [Ohtake, Belyaev & Seidel 2004]
pub const HRBFNPR_LINE_KIND_RIDGE: u32 = 3;
/// once; the same
pub const HRBFNPR_LINE_KIND_VALLEY: u32 = 4;
/// strength: view-dependent curvature; WITH_CURVATURE [Judd 2007]
pub const HRBFNPR_LINE_KIND_APPARENT_RIDGE: u32 = 5;
/// once; Gaussian curvature 0
pub const HRBFNPR_LINE_KIND_PARABOLIC: u32 = 6;
/// n . l = the levels of the style, l its light; WITH_CURVATURE
pub const HRBFNPR_LINE_KIND_ISOPHOTE: u32 = 7;
/// once; parallel planes
pub const HRBFNPR_LINE_KIND_SECTION: u32 = 8;
/// where the surface ends: at the search box, or beyond the last samples
/// (hrbfnpr_line_set_desc.support)
pub const HRBFNPR_LINE_KIND_BORDER: u32 = 9;
/// once; polylines of the caller, such as creases of a mesh
pub const HRBFNPR_LINE_KIND_OWN: u32 = 10;
/// where smooth sheets of the surface meet, of models that have such edges; found with the
/// line set, in no list. Strength: the angle between the sheets' normals, degrees. Where one
/// of them faces the eye and the other does not, a crease is a part of the CONTOUR and drawn
/// as that
pub const HRBFNPR_LINE_KIND_CREASE: u32 = 11;

/// Lines to find once.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_line_desc {
    pub struct_size: u32,
    /// HRBFNPR_LINE_KIND_RIDGE, VALLEY, PARABOLIC, SECTION or OWN; RIDGE
    pub kind: u32,
    /// up to 63 bytes of UTF-8, for styles; NULL = ""
    pub name: *const c_char,
    /// lines go on while their strength is at least `lower` ...
    pub lower: f64,
    /// ... and are kept if it is `upper` somewhere; 0 and 0 = those of the kind: 6 and 15 of
    /// ridges and valleys, 0 and 0 else
    pub upper: f64,
    /// shorter ones are dropped, in diagonals; 0.01
    pub shortest: f64,
    /// of SECTION: normal of the planes, of any length; (0, 0, 1)
    pub plane: [f64; 3],
    /// of SECTION: FLOAT64, 1: where the planes are, along the unit normal
    pub levels: hrbfnpr_array,
    /// of OWN: FLOAT32 or FLOAT64, 3: on the surface or near it
    pub position: hrbfnpr_array,
    /// of OWN: UINT32, 1: the first position of each line, ascending, and the end; one whose last
    /// position is its first is closed
    pub line_first: hrbfnpr_array,
}

extern "C" {
    pub fn hrbfnpr_line_desc_init(desc: *mut hrbfnpr_line_desc, struct_size: u32) -> hrbfnpr_status;
}

/// measure curvatures and their derivatives, for kinds that need them with every drawing
pub const HRBFNPR_LINE_SET_WITH_CURVATURE: u32 = 1;

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_line_set_desc {
    pub struct_size: u32,
    /// HRBFNPR_LINE_SET_WITH_...; 0
    pub flags: u32,
    /// of the mesh on which curves are looked for, units of the model; 0 = half the samples'
    /// spacing, and finer where walls are thin. Loops that are smaller, and walls that are
    /// thinner than 1.75 cells, may be missed
    pub cell_size: f64,
    /// FLOAT32 or FLOAT64, 3: near each part of the surface; not given = the samples, or places
    /// found in the bounds of a custom model
    pub seed_points: hrbfnpr_array,
    /// a list; NULL and 0
    pub lines: *const hrbfnpr_line_desc,
    pub line_count: i64,
    pub line_stride: i64,
    /// where the surface ends for want of samples, as an open scan or a terrain does: where s(x),
    /// as of hrbfnpr_trim_desc, exceeds this. Mesh, curves, and what hides them end there, and
    /// the end is a border. 1.5 ends it some 0.7 spacings beyond the last samples, 3 some 0.9,
    /// and leaves larger holes closed. 0 = it ends at the search box only; 0 or more, 0
    pub support: f64,
    /// FLOAT32 or FLOAT64, 3: those samples; not given = the model's centres. All points of a
    /// scan tell better where it ends than the centres chosen from them
    pub support_points: hrbfnpr_array,
    /// FLOAT32 or FLOAT64, 3: of support_points, as many, of any length; not given = the
    /// surface's own there
    pub support_normals: hrbfnpr_array,
}

extern "C" {
    pub fn hrbfnpr_line_set_desc_init(
        desc: *mut hrbfnpr_line_set_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// The line set keeps the model.  desc NULL = defaults.
    /// Errors: INVALID_ARGUMENT (more than 4 000 000 triangles: a larger cell_size; a support
    /// without samples),
    /// NOT_CONVERGED (no surface was found, or none near its samples), OUT_OF_MEMORY, CANCELLED, CALLBACK.
    pub fn hrbfnpr_line_set_create(
        context: *mut hrbfnpr_context,
        model: *const hrbfnpr_model,
        desc: *const hrbfnpr_line_set_desc,
        operation: *mut hrbfnpr_operation,
        out_line_set: *mut *mut hrbfnpr_line_set,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// any thread; NULL is ignored
    pub fn hrbfnpr_line_set_retain(line_set: *const hrbfnpr_line_set);
    /// any thread; NULL is ignored
    pub fn hrbfnpr_line_set_release(line_set: *const hrbfnpr_line_set);
}

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_line_set_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// of the mesh
    pub triangles: i64,
    /// of these, triangles that look away from the surface: it is finer than the cells there, and
    /// curves may be missed
    pub turned: i64,
    /// seeds that no triangle is near: a part of the surface is too thin for the cells
    pub missed_seeds: i64,
    /// that were found once, of all elements of the list
    pub lines: i64,
    /// curves where the surface ends
    pub borders: i64,
    /// as used
    pub cell_size: f64,
    /// that it took to make
    pub seconds: f64,
    /// kept
    pub bytes: i64,
    /// the share of the area that was looked at that lies beyond the samples, 0 to 1; 0 without
    /// support. Of a trimmed model little beyond its end is looked at: see its trim info
    pub left_out: f64,
    /// curves where sheets of the surface meet, at any angle: from corner to corner, or closed
    pub creases: i64,
}

extern "C" {
    pub fn hrbfnpr_line_set_info_init(
        info: *mut hrbfnpr_line_set_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    pub fn hrbfnpr_line_set_get_info(
        line_set: *const hrbfnpr_line_set,
        info: *mut hrbfnpr_line_set_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 9  CAMERA AND STYLE: plain data

// Range of window depth from near to far plane.
/// clip space of OpenGL; written depth is 0 .. 1
pub const HRBFNPR_DEPTH_NEGATIVE_ONE_TO_ONE: u32 = 0;
/// Direct3D, Vulkan, Metal
pub const HRBFNPR_DEPTH_ZERO_TO_ONE: u32 = 1;
/// 1 at the near plane, 0 at the far plane
pub const HRBFNPR_DEPTH_REVERSED: u32 = 2;

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_camera {
    pub struct_size: u32,
    /// HRBFNPR_DEPTH_...; of `projection` and of depth buffers
    pub depth_convention: u32,
    /// world to eye, column-major; the eye looks along -z
    pub view: [f64; 16],
    /// eye to clip
    pub projection: [f64; 16],
    /// x, y of the top-left corner, width, height, in pixels
    pub viewport: [f64; 4],
}

extern "C" {
    /// Identity matrices, viewport 0 x 0 (which _draw refuses).
    pub fn hrbfnpr_camera_init(camera: *mut hrbfnpr_camera, struct_size: u32) -> hrbfnpr_status;
    /// Sets `view`: from eye towards target, up roughly along `up`; 3 doubles each.
    /// INVALID_ARGUMENT if eye = target or up is parallel to the view.
    pub fn hrbfnpr_camera_look_at(
        camera: *mut hrbfnpr_camera,
        eye: *const f64,
        target: *const f64,
        up: *const f64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Sets `projection` and the viewport's size.  vertical_angle in radians, in
    /// (0, pi); 0 < near_plane < far_plane.
    pub fn hrbfnpr_camera_perspective(
        camera: *mut hrbfnpr_camera,
        vertical_angle: f64,
        width: f64,
        height: f64,
        near_plane: f64,
        far_plane: f64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Sets `projection` and the viewport's size; `view_height` is the height of
    /// the visible slab in world units; near_plane < far_plane, either sign.
    pub fn hrbfnpr_camera_orthographic(
        camera: *mut hrbfnpr_camera,
        view_height: f64,
        width: f64,
        height: f64,
        near_plane: f64,
        far_plane: f64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Sets view, projection and viewport so that the box fills the picture but for
    /// `margin` (share of the picture on each side, 0 .. 0.45), seen along
    /// `direction` (from the eye into the scene).  vertical_angle 0 = orthographic.
    pub fn hrbfnpr_camera_fit_bounds(
        camera: *mut hrbfnpr_camera,
        bounds_min: *const f64,
        bounds_max: *const f64,
        direction: *const f64,
        up: *const f64,
        vertical_angle: f64,
        width: f64,
        height: f64,
        margin: f64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// The same for n x 3 points, FLOAT32 or FLOAT64, n >= 1: the points themselves
    /// fill the picture, not the corners of their box, and lie in its middle.
    /// `origin` (3 doubles, NULL = 0) is added to each: with a point set's POSITION
    /// give its info's origin.
    pub fn hrbfnpr_camera_fit_points(
        camera: *mut hrbfnpr_camera,
        points: *const hrbfnpr_array,
        origin: *const f64,
        direction: *const f64,
        up: *const f64,
        vertical_angle: f64,
        width: f64,
        height: f64,
        margin: f64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// seen faintly through the surface in front [NPAR 6.1]
pub const HRBFNPR_HIDDEN_LINES_ATTENUATE: u32 = 0;
/// marks behind a nearer depth layer are not drawn
pub const HRBFNPR_HIDDEN_LINES_HIDE: u32 = 1;
/// as if nothing were in front (lambda = 0)
pub const HRBFNPR_HIDDEN_LINES_SHOW: u32 = 2;

/// Each mark of ink is seen through the depth layers of surface in front of it, which are found
/// from the marks: its opacity is multiplied by their transmittance.  A depth layer never dims its
/// own ink, and the picture does not depend on the number of marks.
pub const HRBFNPR_VISIBILITY_DEPTH_LAYERS: u32 = 0;
/// As published: marks paint discs of paper and of ink, from far to near [NPAR 6.1].
pub const HRBFNPR_VISIBILITY_PUBLISHED: u32 = 1;

/// The coverage of the drawing is the tone that was asked for, 1 - tau: the number of marks
/// follows from their size, their density on the screen and how they overlap, so that the
/// tone stays when the zoom or the budget changes.  Where all marks together cover less than
/// 0.6, the tone 0.6 shows all of them and the others are paler alike.
pub const HRBFNPR_TONE_CURVE_COVERAGE: u32 = 0;
/// the share of marks is 1 - tau [NPAR 6.2]
pub const HRBFNPR_TONE_CURVE_LINEAR: u32 = 1;

/// tau = 0: all front marks are shown
pub const HRBFNPR_TONE_NONE: u32 = 0;
/// tau = max(0, n . l)^tone_exponent [NPAR 6.2], and fill_light
pub const HRBFNPR_TONE_LIGHT: u32 = 1;
/// tau from tone_function
pub const HRBFNPR_TONE_CALLBACK: u32 = 2;

/// A front mark is shown if u >= 1 - (1 - tau) * tau_d * scale * share: all effects thin
/// one and the same order of marks, so that a blue-noise order stays one.
pub const HRBFNPR_TONE_RULE_SHARE: u32 = 0;
/// As published, test by test: u >= tau, u < tau_d, u < scale, u < share.
pub const HRBFNPR_TONE_RULE_PUBLISHED: u32 = 1;

pub const HRBFNPR_LIGHT_WORLD: u32 = 0;
pub const HRBFNPR_LIGHT_CAMERA: u32 = 1;

/// Any illumination model: fills tau (count, 1 = light, 0 = dark; clamped to
/// [0,1], NaN is CALLBACK) from world positions and unit normals (count x 3
/// each; TONE_NORMAL where there are any).  Runs on the thread that called _draw.  Non-zero fails it.
pub type hrbfnpr_tone_fn = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        count: i64,
        positions: *const f32,
        normals: *const f32,
        tau: *mut f32,
    ) -> i32,
>;

// How the front marks of a layer of strokes are drawn.  Layers without strokes are dots; so
// is everything with
// VISIBILITY_PUBLISHED.
/// each mark is a dot
pub const HRBFNPR_SHAPE_DOTS: u32 = 0;
/// marks that follow each other along a stroke, and are shown, are one line whose width and
/// opacity are theirs; a single one is a dot
pub const HRBFNPR_SHAPE_STROKES: u32 = 1;
/// strokes are curves, drawn where the tone is dark enough, and their width makes the tone:
/// hatch_... of hrbfnpr_layer_style. Of nested lines (those of level k midway between those
/// of lower levels) as many levels are drawn as the picture has room for, so that the tone
/// does not depend on the zoom. Points of lines have the id of the nearest mark; a stroke
/// whose ends meet is closed. [Winkenbach & Salesin 1994; Praun et al. 2001]
pub const HRBFNPR_SHAPE_HATCH: u32 = 2;

/// How layers are drawn.  Colours are straight RGBA in [0,1], sRGB-encoded.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_layer_style {
    pub struct_size: u32,
    /// the layers that this is for: HRBFNPR_LAYER_KIND_...; ANY
    pub kind: u32,
    /// ... and are called so; NULL = any name. Read during _draw only
    pub name: *const c_char,
    /// 1 or 0: whether front marks are drawn; 1
    pub shown: u32,
    /// 1 or 0, with VISIBILITY_PUBLISHED: whether marks near a contour draw it; 1. Not of OWN
    /// strokes, which may be few
    pub contours: u32,
    /// of strokes: bit 0 the first direction, bit 1 the second; 3
    pub directions: u32,
    /// HRBFNPR_SHAPE_...; DOTS
    pub shape: u32,
    /// 0 .. 1: share of the layer's marks that is used at all; 1
    pub share: f32,
    /// of a mark, half the width of a stroke, pixels, > 0; 1
    pub radius: f32,
    /// 0: radius is in pixels at any zoom; 1: grows with the zoom; between; 0
    pub radius_zoom: f32,
    pub reserved: u32,
    /// black
    pub ink: [f32; 4],
    /// darkness from which on there are lines, 0 .. 1; 0.15
    ///
    /// Of SHAPE_HATCH.  Darkness is 1 - tau, 0 .. 1; the share of the paper that the lines cover
    /// grows with it, times
    /// `share`.  Lines whose separation is not known have the width 2 * radius where that share
    /// is the greatest.
    pub hatch_tone_begin: f32,
    /// darkness from which on they get no wider, > hatch_tone_begin, to 1; 0.95
    pub hatch_tone_end: f32,
    /// > 0, to 1: share covered at hatch_tone_begin; 0.1
    pub hatch_coverage_begin: f32,
    /// > 0, to 1: share covered at hatch_tone_end; 0.82
    pub hatch_coverage_end: f32,
    /// least from line to line, pixels, > 0; 4.6
    pub hatch_spacing: f32,
    /// least width of a line, pixels, > 0; 0.6. Less only where lines fade in or end, or are
    /// closer together than hatch_spacing
    pub hatch_pen: f32,
    /// left between lines at least, pixels, 0 or more; 1.2
    pub hatch_white: f32,
    /// over which a line narrows where it ends by its tone, pixels, 0 or more; 20. Where it ends
    /// for another reason it is shorter
    pub hatch_taper: f32,
    /// pieces below this are not drawn, those up to twice of it are thinner; pixels, 0 or more; 10
    pub hatch_shortest: f32,
    pub reserved2: u32,
    /// how far a line may stray to either side, as of an unsteady hand, in hatch_pens, 0 .. 16;
    /// 0. From swing to swing it is about 60 hatch_pens
    pub hatch_wobble: f32,
    /// lines run on past the tone that they end at by up to this, each by another length; pixels,
    /// 0 or more; 0
    pub hatch_overshoot: f32,
    /// of the two above: any number; 0
    pub hatch_seed: u32,
    pub reserved3: u32,
}

extern "C" {
    pub fn hrbfnpr_layer_style_init(
        style: *mut hrbfnpr_layer_style,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

// What is drawn of the parts of a line that surface hides.
pub const HRBFNPR_HIDDEN_PARTS_NONE: u32 = 0;
/// paler with each layer of surface (two sheets) before them
pub const HRBFNPR_HIDDEN_PARTS_ATTENUATED: u32 = 1;
/// dashes, the shorter the more layers lie before them
pub const HRBFNPR_HIDDEN_PARTS_DASHED: u32 = 2;
/// like what is visible
pub const HRBFNPR_HIDDEN_PARTS_SHOWN: u32 = 3;

// How a line ends where it ends in the picture without meeting another: at a cusp, where it
// turns behind its own
// surface.
pub const HRBFNPR_CAP_ROUND: u32 = 0;
pub const HRBFNPR_CAP_FLAT: u32 = 1;
/// narrowing to a tip; the tip's length is twice the width there
pub const HRBFNPR_CAP_POINTED: u32 = 2;

// Creases by the way that the surface bends there.
pub const HRBFNPR_CREASES_ALL: u32 = 0;
/// edges
pub const HRBFNPR_CREASES_CONVEX: u32 = 1;
/// grooves, and where something stands on a face
pub const HRBFNPR_CREASES_CONCAVE: u32 = 2;

/// How the lines of one kind are drawn, of items that have a line set.  Lengths are in pixels.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_line_style {
    pub struct_size: u32,
    /// HRBFNPR_LINE_KIND_...; CONTOUR
    pub kind: u32,
    /// of lines found once: those that are called so; NULL = any name. Read during _draw only
    pub name: *const c_char,
    /// HRBFNPR_HIDDEN_PARTS_...; NONE
    pub hidden: u32,
    /// HRBFNPR_CAP_...: of free ends; ROUND
    pub cap: u32,
    /// > 0; 2
    pub width: f32,
    /// over which a line narrows to a free end, half an ellipse; 0 = not at all; 12. A part with
    /// a free end that is shorter than two tapers is the thinner, the shorter it is
    pub taper: f32,
    /// of ATTENUATED and DASHED, > 0; 1.2
    pub hidden_width: f32,
    /// 0 .. 1: of ATTENUATED, for each layer; 0.35
    pub hidden_opacity: f32,
    /// of DASHED, in hidden_widths, > 0; 5
    pub dash: f32,
    /// between dashes, in hidden_widths, > 0; 3
    pub gap: f32,
    /// parts with a free end, and hidden ones, that are shorter are not drawn; 2. Feature lines
    /// that are found with every drawing measure 0.01 diagonals or more
    pub shortest: f32,
    /// 0 .. 1: how much paler a line is where its strength is `lower` than where it is `upper`; 1
    pub fade: f32,
    /// strengths as in hrbfnpr_line_desc; 0 and 0 = those of the kind: 10 and 30 of suggestive
    /// contours, 12 and 25 of apparent ridges, 15 and 30 (degrees) of creases
    pub lower: f64,
    pub upper: f64,
    /// of ISOPHOTE: FLOAT64, 1: -1 .. 1. Read during _draw only
    pub levels: hrbfnpr_array,
    /// straight RGBA; black
    pub ink: [f32; 4],
    /// of CONTOUR and BORDER, where nothing lies beside the line on its outer side: the outline
    /// of all items that have lines. Falls to 1 over 6 widths beyond its ends; 1
    ///
    /// Laws of the width: factors, 0 .. 16, of which all that apply to a place are multiplied; 1
    /// = no effect.  By depth,
    /// light and radial curvature goes the distance between a contour and an isophote [Goodwin et
    /// al. 2007].
    pub outline_factor: f32,
    /// at the farthest place in the viewport of lines that are drawn, hidden ones too; 1 at the
    /// nearest, evenly by depth between; 1
    pub far_factor: f32,
    /// where the surface faces the style's light, whatever its tone; 1 where it faces away,
    /// evenly by n . l between; 1
    pub lit_factor: f32,
    /// where the surface bends sharply; 1 where its radius of curvature is curvature_radius or
    /// more, evenly by the radius between. Of CONTOUR the radial curvature, along the line of
    /// sight; of others the normal curvature across the line; 1
    pub curvature_factor: f32,
    /// diagonals, > 0; 0.1
    pub curvature_radius: f32,
    /// how far a line may stray to either side, widths, 0 .. 16; 0
    ///
    /// An unsteady hand, the same in each drawing and, as the lengths are in widths, at each size
    /// of the picture.
    pub wobble: f32,
    /// 0 .. 1: the share by which its width may vary; 0
    pub wobble_width: f32,
    /// from swing to swing, about, widths, >= 1; 40
    pub wobble_length: f32,
    /// 0
    pub wobble_seed: u32,
    /// of CREASE: HRBFNPR_CREASES_...; ALL
    pub creases: u32,
}

extern "C" {
    pub fn hrbfnpr_line_style_init(
        style: *mut hrbfnpr_line_style,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_style {
    pub struct_size: u32,
    /// HRBFNPR_TONE_...; LIGHT
    pub tone: u32,
    /// straight RGBA; alpha 0 = transparent; white. One for all styles of a drawing
    pub paper: [f32; 4],
    /// a list: a layer of marks takes the first that is for it, or the defaults of
    /// _layer_style_init; NULL and 0
    pub layers: *const hrbfnpr_layer_style,
    pub layer_count: i64,
    pub layer_stride: i64,
    /// HRBFNPR_TONE_RULE_...; SHARE
    ///
    /// Tone.
    pub tone_rule: u32,
    /// HRBFNPR_TONE_CURVE_...; COVERAGE. For TONE_RULE_SHARE
    pub tone_curve: u32,
    /// towards the light, normalised on use; (-0.4, 0.6, 0.7)
    pub light: [f64; 3],
    /// lambda of the tone law, > 0; 1
    pub tone_exponent: f64,
    /// for CALLBACK
    pub tone_function: hrbfnpr_tone_fn,
    pub tone_user: *mut c_void,
    /// HRBFNPR_LIGHT_...; CAMERA
    pub light_space: u32,
    /// 0 .. 1, DEPTH_LAYERS: a mark grows from nothing to its full area over this share of the
    /// marks shown, instead of popping; 0 = it pops; 0.25
    pub tone_fade: f32,
    /// delta in (0,1): front n.v < -delta, back n.v > delta, else silhouette, v from the camera
    /// to the mark [NPAR 6]; 0.2
    ///
    /// Contours that marks draw, with VISIBILITY_PUBLISHED only.  With DEPTH_LAYERS contours are
    /// lines of an item's
    /// line set.
    pub silhouette_threshold: f64,
    /// of a mark, pixels; 1
    pub silhouette_radius: f32,
    /// as radius_zoom; 0
    pub silhouette_radius_zoom: f32,
    /// black
    pub silhouette_ink: [f32; 4],
    /// HRBFNPR_VISIBILITY_...; DEPTH_LAYERS. One for all styles of a drawing
    ///
    /// Hidden lines.
    pub visibility: u32,
    /// HRBFNPR_HIDDEN_LINES_...; ATTENUATE
    pub hidden_lines: u32,
    /// lambda of alpha_f = nu^2 lambda; 1
    pub attenuation_front: f64,
    /// lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda; 1
    pub attenuation_back: f64,
    /// of the piece of surface that a mark stands for, pixels; 0 = from the marks' spacing on the screen
    pub splat_radius: f32,
    /// n > 0: a depth layer is as opaque as n overlapping splats of opacity alpha, 1 - (1 -
    /// alpha)^n, whatever the marks' density and the zoom; 0: each mark paints with alpha itself,
    /// as published; 8
    pub splat_overlap: f32,
    /// DEPTH_LAYERS: how far beyond its contour a surface hides what lies behind, pixels at any
    /// zoom. PUBLISHED: how much wider the paper of back marks is, pixels; 2
    pub halo_width: f32,
    pub reserved: u32,
    /// distance from the camera where depth attenuation starts, > 0
    ///
    /// Distance and zoom.
    pub depth_min: f64,
    /// ... and where nothing is shown any more; 0 and 0 = off (default)
    pub depth_max: f64,
    /// pixels per world unit at which marks are shown in full; 0 = off. Below it the chance to be
    /// shown is scale = zoom^zoom_exponent, exponential in the zoom level ln zoom; the area of
    /// the paper of back marks scales alike [NPAR 6.2]
    pub zoom_reference: f64,
    /// >= 0; 2 keeps the ink per area
    pub zoom_exponent: f64,
    /// a list; NULL and 0
    ///
    /// Lines, with DEPTH_LAYERS, of items that have a line set.
    pub lines: *const hrbfnpr_line_style,
    pub line_count: i64,
    pub line_stride: i64,
    /// Of TONE_LIGHT, DEPTH_LAYERS and TONE_RULE_SHARE: 0 .. 1, light from the side opposite to
    /// `light`, so that what
    /// is turned away keeps its form: tau = fill_light * (n . l)^2 where n . l < 0.  The lit side
    /// stays as it is;
    /// 0.25
    pub fill_light: f32,
    pub reserved2: u32,
}

extern "C" {
    pub fn hrbfnpr_style_init(style: *mut hrbfnpr_style, struct_size: u32) -> hrbfnpr_status;
}

// Named styles, each with a picture in docs/presets.md.  bindings/generate writes this list
// from bindings/presets.py.
/// stipples by light, no contours
pub const HRBFNPR_PRESET_STIPPLE: u32 = 0;
/// lines of one width, more of them where it is darker, and contours
pub const HRBFNPR_PRESET_HATCH: u32 = 1;
/// up to three sets of such lines, at 0, 35 and -30 degrees, a darker tone each, and contours
pub const HRBFNPR_PRESET_CROSS_HATCH: u32 = 2;
/// lines along Stark's combing direction, a second set in the darks, and contours
pub const HRBFNPR_PRESET_COMBING: u32 = 3;
/// contours only, hidden ones attenuated
pub const HRBFNPR_PRESET_SILHOUETTE: u32 = 4;
/// contours and stipples
pub const HRBFNPR_PRESET_CONTOUR_AND_STIPPLE: u32 = 5;
/// contours only, hidden ones shown
pub const HRBFNPR_PRESET_XRAY: u32 = 6;
/// stipples, cross hatching in the darks, contours and halo: Figure 1 (e)
pub const HRBFNPR_PRESET_FULL: u32 = 7;
/// one set of lines that swell with the tone, and contours; lights are empty
pub const HRBFNPR_PRESET_ENGRAVING: u32 = 8;
/// up to three sets of thin lines, at 0, 50 and -40 degrees, a darker tone each, and contours
pub const HRBFNPR_PRESET_ETCHING: u32 = 9;
/// few wide lines, which close up to black, and heavy contours
pub const HRBFNPR_PRESET_WOODCUT: u32 = 10;
/// fine stipples lit from the upper left, empty lights; outlines swell in the shade
pub const HRBFNPR_PRESET_SCIENTIFIC_STIPPLE: u32 = 11;
/// pencil on warm paper: two sets of lines that stray and run past their ends, contours drawn twice
pub const HRBFNPR_PRESET_SKETCH: u32 = 12;
/// pale lines on blue without tone: contours, borders, creases and lines called "crease",
/// hidden ones dashed
pub const HRBFNPR_PRESET_BLUEPRINT: u32 = 13;
/// lit from the upper left: short lines along curvature that taper to the light, heavy
/// outlines, and the RIDGE lines of a line set
pub const HRBFNPR_PRESET_ARCHAEOLOGICAL: u32 = 14;

extern "C" {
    /// A full set of fields that a caller goes on changing.  style->layers and style->lines
    /// point to constants of the library: copy an element to change it.
    pub fn hrbfnpr_style_init_preset(
        style: *mut hrbfnpr_style,
        struct_size: u32,
        preset: u32,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// The layers that a preset draws, with defaults: a list of constants for
    /// hrbfnpr_generate_desc.layers (with layer_stride 0).  *count gets their number.
    /// NULL and 0 for a number that is no preset's.
    pub fn hrbfnpr_preset_layers(preset: u32, count: *mut i64) -> *const hrbfnpr_layer_desc;
    /// "stipple", "hatch", "cross-hatch", ...; NULL for a number that is no preset's:
    /// presets are numbered from 0 without gaps.
    pub fn hrbfnpr_preset_name(preset: u32) -> *const c_char;
}

// 10  RENDERER: from items and a camera to a drawing [NPAR 6]

#[repr(C)]
pub struct hrbfnpr_renderer {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

#[repr(C)]
pub struct hrbfnpr_drawing {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

extern "C" {
    pub fn hrbfnpr_renderer_create(
        context: *mut hrbfnpr_context,
        out_renderer: *mut *mut hrbfnpr_renderer,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// any thread; NULL is ignored
    pub fn hrbfnpr_renderer_retain(renderer: *mut hrbfnpr_renderer);
    /// any thread; NULL is ignored
    pub fn hrbfnpr_renderer_release(renderer: *mut hrbfnpr_renderer);
}

/// Where the marks of one layer are in this drawing: of an animated surface.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_layer_pose {
    pub struct_size: u32,
    pub reserved: u32,
    /// of the item's point set
    pub layer: i64,
    /// n x 3, FLOAT32 or FLOAT64, absolute, in the order of the layer's n marks
    pub position: hrbfnpr_array,
    /// n x 3, FLOAT32 or FLOAT64, unit, outward
    pub normal: hrbfnpr_array,
    /// n x 3, FLOAT32 or FLOAT64, unit; empty = those of the set
    pub direction: hrbfnpr_array,
}

extern "C" {
    pub fn hrbfnpr_layer_pose_init(
        pose: *mut hrbfnpr_layer_pose,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

// Which sides of an item's surface its marks are drawn on.
/// that which the normals look to: a solid's inside is never seen
pub const HRBFNPR_SIDES_FRONT: u32 = 0;
/// of a surface that ends, such as a bowl or a leaf, the other one, too, where it looks to
/// the camera: with opposite normals for tone. Such marks count twice in
/// hrbfnpr_drawing_info, as of the front and of the back, their ids are the same, and the
/// drawing has their layers once more, behind those of all items. Lines are seen from both
/// sides anyway. With ATTENUATE a depth layer is as opaque as two, one that faces the camera
/// and one that faces away, as those of a solid before what it hides
pub const HRBFNPR_SIDES_BOTH: u32 = 1;

/// One thing to draw.  Everything it points to is read during _draw only, but
/// the drawing retains the point set.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_item {
    pub struct_size: u32,
    /// HRBFNPR_SIDES_...; FRONT
    pub sides: u32,
    pub point_set: *const hrbfnpr_point_set,
    /// NULL = default style
    pub style: *const hrbfnpr_style,
    /// NULL, or the surface that the marks lie on: with DEPTH_LAYERS, what hides a mark is then
    /// found by casting a ray from it to the eye, exact but slow
    pub model: *const hrbfnpr_model,
    /// object to world, column-major, affine, invertible
    pub transform: [f64; 16],
    /// a list: layers whose marks have moved; NULL and 0
    pub poses: *const hrbfnpr_layer_pose,
    pub pose_count: i64,
    pub pose_stride: i64,
    /// NULL, or what the style's lines are drawn from. All items of a drawing that have one hide
    /// each other's lines; others hide none
    pub line_set: *const hrbfnpr_line_set,
}

extern "C" {
    /// NULL pointers and the identity transform.
    pub fn hrbfnpr_item_init(item: *mut hrbfnpr_item, struct_size: u32) -> hrbfnpr_status;
    /// Classifies, shades and orders the marks of a list of items for one camera.
    /// Styles of one drawing must have the same paper and visibility.
    /// Contours of line sets begin with those of the renderer's last drawing where the
    /// camera moved little, and are proven complete again: in their last digits, and by
    /// `wobble`, a picture of lines depends on the drawings before it.
    /// Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CALLBACK.
    pub fn hrbfnpr_renderer_draw(
        renderer: *mut hrbfnpr_renderer,
        items: *const hrbfnpr_item,
        item_count: i64,
        item_stride: i64,
        camera: *const hrbfnpr_camera,
        out_drawing: *mut *mut hrbfnpr_drawing,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// The same with an operation (NULL = none), for frames that take long: lines of
    /// a fine surface, millions of marks, rays of an item's model, callbacks of tone.
    /// After a cancel there is no drawing, and the renderer goes on as if the call
    /// had not been made, but that contours of line sets are traced from nothing.
    /// Errors: also CANCELLED.
    pub fn hrbfnpr_renderer_draw_with_operation(
        renderer: *mut hrbfnpr_renderer,
        items: *const hrbfnpr_item,
        item_count: i64,
        item_stride: i64,
        camera: *const hrbfnpr_camera,
        operation: *mut hrbfnpr_operation,
        out_drawing: *mut *mut hrbfnpr_drawing,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 11  DRAWING: a picture as a value, immutable

extern "C" {
    /// any thread; NULL is ignored
    pub fn hrbfnpr_drawing_retain(drawing: *const hrbfnpr_drawing);
    /// any thread; NULL is ignored
    pub fn hrbfnpr_drawing_release(drawing: *const hrbfnpr_drawing);
}

// What a mark is for the camera.
pub const HRBFNPR_CLASS_NONE: u32 = 0;
pub const HRBFNPR_CLASS_FRONT: u32 = 1;
pub const HRBFNPR_CLASS_BACK: u32 = 2;
pub const HRBFNPR_CLASS_SILHOUETTE: u32 = 3;

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_drawing_info {
    pub struct_size: u32,
    pub reserved: u32,
    pub items: i64,
    /// for hrbfnpr_drawing_get_layer_info
    pub layers: i64,
    /// of ink
    pub dots: i64,
    pub strokes: i64,
    /// of all strokes
    pub stroke_points: i64,
    /// in all items, of the layers that the styles use: outside + front + back + silhouette + culled
    pub marks: i64,
    /// outside the frustum
    pub outside: i64,
    /// of those inside: by class
    pub front: i64,
    pub back: i64,
    /// PUBLISHED
    pub silhouette: i64,
    /// DEPTH_LAYERS: marks that are of no class, since no tone could show them: they were not
    /// looked at one by one
    pub culled: i64,
    /// drawn as ink
    pub shown: i64,
    /// front marks not shown because of light or share
    pub dropped_tone: i64,
    /// front and silhouette marks not shown because of depth attenuation
    pub dropped_depth: i64,
    /// front marks not shown because of tone scaling
    pub dropped_zoom: i64,
    /// marks not drawn because nothing of them is seen through what is in front
    pub dropped_hidden: i64,
    /// PUBLISHED: discs of paper; DEPTH_LAYERS: marks that depth layers were found from
    pub splats: i64,
    /// transform, classify, tone
    pub nanoseconds_classify: i64,
    pub nanoseconds_visibility: i64,
    pub nanoseconds_sort: i64,
    /// kept by the drawing
    pub bytes: i64,
    /// kept by its renderer, drawings left out
    pub scratch_bytes: i64,
    /// curves that lines were drawn from
    pub line_curves: i64,
    /// of these
    pub line_cusps: i64,
    /// of their images, where the farther one changes its visibility
    pub line_crossings: i64,
    /// curves that end inside the surface, and places where one was missed
    pub line_broken: i64,
    /// curves whose visibility did not add up: each part is as a ray of its own says
    pub line_settled: i64,
    /// of these, curves with a part whose ray was not certain
    pub line_contradictions: i64,
    pub nanoseconds_lines: i64,
    /// curves whose visibility did not add up at first: they, and those that cross them, were made finer
    pub line_refined: i64,
    /// cells of the image, four pixels wide or more, with so many crossings that none was taken:
    /// lines run to and fro over one another there, as on a flat face seen edge-on
    pub line_tangles: i64,
}

extern "C" {
    pub fn hrbfnpr_drawing_info_init(
        info: *mut hrbfnpr_drawing_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    pub fn hrbfnpr_drawing_get_info(
        drawing: *const hrbfnpr_drawing,
        info: *mut hrbfnpr_drawing_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// A layer of a drawing: ink of one layer of marks, of the front or (PUBLISHED) of contours; or lines.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_drawing_layer_info {
    pub struct_size: u32,
    /// HRBFNPR_CLASS_FRONT or SILHOUETTE
    pub mark_class: u32,
    pub item: i64,
    /// of the item's point set; -1: of lines
    pub layer: i64,
    /// HRBFNPR_LAYER_KIND_...; of lines HRBFNPR_LINE_KIND_...
    pub kind: u32,
    /// HRBFNPR_SHAPE_...
    pub shape: u32,
    /// of that layer; of lines the style's, or empty
    pub name: [c_char; 64],
    /// straight RGBA
    pub ink: [f32; 4],
    pub dots: i64,
    pub strokes: i64,
}

extern "C" {
    pub fn hrbfnpr_drawing_layer_info_init(
        info: *mut hrbfnpr_drawing_layer_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// number: 0 .. hrbfnpr_drawing_info.layers - 1.
    pub fn hrbfnpr_drawing_get_layer_info(
        drawing: *const hrbfnpr_drawing,
        number: i64,
        info: *mut hrbfnpr_drawing_layer_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// lay the drawing over the image's contents instead of replacing them inside the viewport;
/// wants a style with transparent paper
pub const HRBFNPR_RASTER_OVER: u32 = 1;
/// blend in linear light (sRGB decoded), not in encoded values
pub const HRBFNPR_RASTER_LINEAR_LIGHT: u32 = 2;

/// Optional inputs and outputs: width * height elements of one component each,
/// row by row from the top-left pixel of the image, stride between elements as
/// in every array.  Data NULL and count 0 = not wanted.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_raster_desc {
    pub struct_size: u32,
    /// HRBFNPR_RASTER_...; 0
    pub flags: u32,
    /// FLOAT32, camera's convention: ink behind it is not drawn
    pub host_depth: hrbfnpr_array,
    /// FLOAT32, camera's convention: the nearest surface, the far plane where there is none
    pub depth: hrbfnpr_array_out,
    /// UINT32: id of the nearest drawn mark; 0 = none
    pub id: hrbfnpr_array_out,
    /// UINT8 or UINT32: HRBFNPR_CLASS_... of that mark
    pub mark_class: hrbfnpr_array_out,
}

extern "C" {
    pub fn hrbfnpr_raster_desc_init(
        desc: *mut hrbfnpr_raster_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Draws into an image.  The viewport (clipped to the image) is filled with
    /// paper and ink; pixels outside it are not touched.  desc may be NULL.
    pub fn hrbfnpr_drawing_rasterize(
        drawing: *const hrbfnpr_drawing,
        image: *const hrbfnpr_image,
        desc: *const hrbfnpr_raster_desc,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// the dots: one vertex each
pub const HRBFNPR_PRIMITIVE_POINTS: u32 = 1;
/// the strokes: one vertex for each of their points
pub const HRBFNPR_PRIMITIVE_LINE_STRIPS: u32 = 2;
/// the strokes: two for each point, on their left and right side
pub const HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS: u32 = 3;

// Ends a strip in an array of indices.
pub const HRBFNPR_INDEX_RESTART: i32 = -1;

// What a vertex can carry, and the types it can have.
/// world, FLOAT32 x 3. Of marks and their line strips that of the mark; of lines, of hatching
/// and of triangles what is drawn, as exact as the window depth
pub const HRBFNPR_VERTEX_ATTRIBUTE_POSITION: u32 = 0;
/// pixel x, pixel y, depth; FLOAT32 x 3
pub const HRBFNPR_VERTEX_ATTRIBUTE_WINDOW: u32 = 1;
/// pixels; FLOAT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_RADIUS: u32 = 2;
/// straight RGBA; FLOAT32 x 4, or UINT8 x 4
pub const HRBFNPR_VERTEX_ATTRIBUTE_COLOR: u32 = 3;
/// world, unit; of lines 0; FLOAT32 x 3
pub const HRBFNPR_VERTEX_ATTRIBUTE_NORMAL: u32 = 4;
/// world, unit; of lines 0; FLOAT32 x 3
pub const HRBFNPR_VERTEX_ATTRIBUTE_DIRECTION: u32 = 5;
/// of the mark; 0 of lines; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_ID: u32 = 6;
/// HRBFNPR_CLASS_...; UINT8 or UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_CLASS: u32 = 7;
/// 1 = a disc of paper, 0 = ink; UINT8 or UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER: u32 = 8;
/// of the drawing; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_LAYER: u32 = 9;
/// along its stroke, pixels from its first point; 0 for a dot; FLOAT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_LENGTH: u32 = 10;
/// layers of surface before that part of a line, 0 = it is visible; 0 of marks; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_LAYERS: u32 = 11;
/// item of the nearest surface before that part of a line; HRBFNPR_INDEX_RESTART = it is
/// visible, or a mark; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_BY: u32 = 12;
/// of lines: a number that a line keeps from one drawing of a renderer to the next, where the
/// camera moves little; 0 of all else; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_LINE: u32 = 13;

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_vertex_attribute {
    pub struct_size: u32,
    /// HRBFNPR_VERTEX_ATTRIBUTE_...
    pub attribute: u32,
    /// HRBFNPR_SCALAR_...
    pub scalar: u32,
    /// bytes from the start of the vertex
    pub offset: u32,
}

extern "C" {
    pub fn hrbfnpr_vertex_attribute_init(
        attribute: *mut hrbfnpr_vertex_attribute,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_vertex_layout {
    pub struct_size: u32,
    /// HRBFNPR_PRIMITIVE_...; POINTS
    pub primitive: u32,
    /// a list, 1 and more
    pub attributes: *const hrbfnpr_vertex_attribute,
    pub attribute_count: i64,
    pub attribute_stride: i64,
    /// bytes of a vertex; 0 = up to the end of its last attribute
    pub stride: i64,
}

extern "C" {
    /// Points, and no attributes.
    pub fn hrbfnpr_vertex_layout_init(
        layout: *mut hrbfnpr_vertex_layout,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// How many vertices and indices a primitive has; each may be NULL.
    pub fn hrbfnpr_drawing_vertex_bound(
        drawing: *const hrbfnpr_drawing,
        primitive: u32,
        vertices: *mut i64,
        indices: *mut i64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Writes the drawing's dots or strokes, far to near.
    ///
    /// POINTS: discs of paper and of ink.  A host that paints them in this order as
    /// round anti-aliased points with ordinary "source over" blending gets the
    /// dots of _rasterize (without its host_depth; a dot of a radius r below half a
    /// pixel is painted with half a pixel, its alpha times (2 r)^2).  With transparent paper, the
    /// discs of paper must erase: destination times (1 - alpha).
    /// Strips: `indices` (UINT32, nullable) lists, far to near, the vertices of one stroke after
    /// the other, each ended by HRBFNPR_INDEX_RESTART (0xFFFFFFFF); of points it is
    /// 0, 1, 2 ...  A triangle strip has two vertices for each point, left and right of it, and
    /// two at the tip of a
    /// pointed end; round ends are cut off flat.
    /// Capacities are in vertices and in indices; *vertex_count and *index_count
    /// (nullable) get the numbers written, or needed with BUFFER_TOO_SMALL.
    pub fn hrbfnpr_drawing_write_vertices(
        drawing: *const hrbfnpr_drawing,
        layout: *const hrbfnpr_vertex_layout,
        vertices: *mut c_void,
        vertex_capacity: i64,
        vertex_count: *mut i64,
        indices: *mut u32,
        index_capacity: i64,
        index_count: *mut i64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// How each mark of a layer is drawn, in the set's own order: a host keeps the
/// set's arrays on the graphics card and uploads only these.  Arrays of the
/// caller's, each of as many elements as the layer has marks, or not given.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mark_results {
    pub struct_size: u32,
    pub reserved: u32,
    /// UINT8: the class that it is drawn as, HRBFNPR_CLASS_FRONT or SILHOUETTE; NONE = it is not drawn
    pub shown: hrbfnpr_array_out,
    /// FLOAT32, pixels; 0 = not drawn
    pub radius: hrbfnpr_array_out,
    /// FLOAT32: the ink's alpha times what is let through; 0 = not drawn
    pub opacity: hrbfnpr_array_out,
}

extern "C" {
    pub fn hrbfnpr_mark_results_init(
        results: *mut hrbfnpr_mark_results,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Of one layer of one item's point set; also of a layer that is not drawn.
    pub fn hrbfnpr_drawing_mark_results(
        drawing: *const hrbfnpr_drawing,
        item: i64,
        layer: i64,
        results: *mut hrbfnpr_mark_results,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Which marks of a layer are drawn: numbers of marks, UINT32.
    /// POINTS: those that are shown, far to near.  LINE_STRIPS: along strokes, a run
    /// of shown marks each, ended by HRBFNPR_INDEX_RESTART.  TRIANGLE_STRIPS: the
    /// same, 2 * number and 2 * number + 1 for each mark.
    /// mark_class: HRBFNPR_CLASS_FRONT or SILHOUETTE.  *count gets the number written, or needed
    /// with BUFFER_TOO_SMALL; indices may be NULL when capacity is 0.
    pub fn hrbfnpr_drawing_write_mark_indices(
        drawing: *const hrbfnpr_drawing,
        item: i64,
        layer: i64,
        mark_class: u32,
        primitive: u32,
        indices: *mut u32,
        capacity: i64,
        count: *mut i64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mark_identity {
    pub struct_size: u32,
    pub id: u32,
    pub item: i64,
    /// of the item's point set
    pub layer: i64,
    /// of the layer
    pub mark: i64,
    /// of the layer; -1 = of none
    pub stroke: i64,
    /// along the stroke
    pub place: i64,
}

extern "C" {
    pub fn hrbfnpr_mark_identity_init(
        identity: *mut hrbfnpr_mark_identity,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// What an id stands for.  INVALID_ARGUMENT for one that is no mark's.
    pub fn hrbfnpr_drawing_identify(
        drawing: *const hrbfnpr_drawing,
        id: u32,
        identity: *mut hrbfnpr_mark_identity,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 12  MESH: triangles as they come, made usable; samples, fits and errors by it

#[repr(C)]
pub struct hrbfnpr_mesh {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

// Which components are kept.  A component is what hangs together by shared
// vertices.
/// all but those that lie inside a closed one: eyes in a head, inner shells
pub const HRBFNPR_PARTS_OUTER: u32 = 0;
/// all; one that lies inside an odd number of closed ones is a cavity if its faces say so,
/// and is not turned
pub const HRBFNPR_PARTS_ALL: u32 = 1;
/// that of the largest area
pub const HRBFNPR_PARTS_LARGEST: u32 = 2;

// What becomes of the order of a face's corners.
/// faces are turned to agree with their component, and closed components outward
pub const HRBFNPR_FACES_TURN: u32 = 0;
/// as they are
pub const HRBFNPR_FACES_KEEP: u32 = 1;

/// Triangles; quadrilaterals and polygons are cut into them by the caller.
/// A corner that is no number of a vertex, or that a vertex which is not finite
/// belongs to, is INVALID_ARGUMENT, and the message names the face and the
/// index; so are coordinates beyond 1e60, a mesh less than 1e-60 across, and one that has no
/// face left.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_desc {
    pub struct_size: u32,
    /// HRBFNPR_PARTS_...; OUTER
    pub parts: u32,
    /// n x 3, FLOAT32 or FLOAT64; n < 2^31
    pub vertices: hrbfnpr_array,
    /// m x 3, INT32, INT64 or UINT32: numbers of vertices, from 0, counter-clockwise as seen from
    /// outside; m < 2^29
    pub triangles: hrbfnpr_array,
    /// degrees, 0 .. 180: faces that meet at a sharper angle do not share their normals; 60
    pub crease_angle: f64,
    /// HRBFNPR_FACES_...; TURN
    pub faces: u32,
    pub reserved: u32,
}

extern "C" {
    pub fn hrbfnpr_mesh_desc_init(desc: *mut hrbfnpr_mesh_desc, struct_size: u32) -> hrbfnpr_status;
    /// operation may be NULL.  Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
    pub fn hrbfnpr_mesh_create(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_mesh_desc,
        operation: *mut hrbfnpr_operation,
        out_mesh: *mut *mut hrbfnpr_mesh,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// any thread; NULL is ignored
    pub fn hrbfnpr_mesh_retain(mesh: *const hrbfnpr_mesh);
    /// any thread; NULL is ignored
    pub fn hrbfnpr_mesh_release(mesh: *const hrbfnpr_mesh);
}

/// Of what is kept, but for the numbers of what was found on the way.  An edge is
/// at the boundary if one face has it, and not manifold if more than two have.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_info {
    pub struct_size: u32,
    /// 1: no edge is at the boundary or not manifold, and all faces agree
    pub closed: u32,
    pub given_vertices: i64,
    pub given_faces: i64,
    /// kept; more than were given where solids that touch in an edge are parted there, at most
    /// three for each face
    pub vertices: i64,
    pub faces: i64,
    /// in the place of another, and joined with it; on borders also within 1e-6 of the diagonal
    /// from another
    pub welded_vertices: i64,
    /// without area but for the rounding of single precision, left out; the face across the
    /// largest side is cut in two at the corner that lies within it, so that no slit stays
    pub degenerate_faces: i64,
    /// with the corners of another, left out; both where two solids share a wall
    pub repeated_faces: i64,
    /// against those beside them, turned
    pub turned_faces: i64,
    /// of the given faces
    pub components: i64,
    /// closed and inside out, turned
    pub turned_components: i64,
    /// inside a closed one
    pub nested_components: i64,
    pub left_out_components: i64,
    /// of these
    pub left_out_faces: i64,
    pub boundary_edges: i64,
    pub boundary_loops: i64,
    pub nonmanifold_edges: i64,
    /// whose two faces do not agree: the mesh cannot be oriented, or was not to be
    pub contrary_edges: i64,
    /// vertices - edges + faces
    pub euler_characteristic: i64,
    /// sum of the handles of all components; -1 where the mesh is not closed
    pub genus: i64,
    pub area: f64,
    /// enclosed; NaN where the mesh is not closed
    pub volume: f64,
    pub bounds_min: [f64; 3],
    pub bounds_max: [f64; 3],
    /// that making it took
    pub seconds: f64,
    /// kept by the mesh
    pub bytes: i64,
    /// of the edges that bend by more than 30 degrees, in diagonals of the bounds
    pub crease_length: f64,
    /// 1: these stand out, as those of machine parts; hrbfnpr_model_fit_mesh with edges AUTO and
    /// the default crease angle keeps them sharp
    pub creases: u32,
    pub reserved: u32,
}

extern "C" {
    pub fn hrbfnpr_mesh_info_init(info: *mut hrbfnpr_mesh_info, struct_size: u32) -> hrbfnpr_status;
    pub fn hrbfnpr_mesh_get_info(
        mesh: *const hrbfnpr_mesh,
        info: *mut hrbfnpr_mesh_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// places, FLOAT64 x 3
pub const HRBFNPR_MESH_ATTRIBUTE_VERTEX: u32 = 0;
/// numbers of vertices, INT32 x 3, of each face
pub const HRBFNPR_MESH_ATTRIBUTE_TRIANGLE: u32 = 1;
/// from 0, INT32 x 1, of each face
pub const HRBFNPR_MESH_ATTRIBUTE_COMPONENT: u32 = 2;
/// the number that the face was given by, INT32 x 1
pub const HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE: u32 = 3;
/// unit normals of the three corners, FLOAT64 x 9, of each face
pub const HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL: u32 = 4;

extern "C" {
    /// A zero-copy view of what is kept, valid while the mesh lives.
    pub fn hrbfnpr_mesh_view(
        mesh: *const hrbfnpr_mesh,
        attribute: u32,
        out_view: *mut hrbfnpr_array,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_sample_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// random places to choose from, 0 = 40 for each sample, 1000000 at most; never fewer than
    /// samples; as many as samples: all of them, in random order
    pub candidates: i64,
    /// any number; 1
    pub random_seed: u64,
}

extern "C" {
    pub fn hrbfnpr_sample_desc_init(
        desc: *mut hrbfnpr_sample_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// As many samples of the mesh as `points` has elements (at least 1, 10000000 at
    /// most): random places, even over its area, of which each next one that is
    /// taken is the farthest from those before, so that every prefix is even.
    /// points, normals: n x 3, FLOAT32 or FLOAT64; normals (may be NULL) are unit,
    /// interpolated between those of the corners, which take in the faces about
    /// their vertex within the crease angle, by their angles there.
    /// desc may be NULL; operation too.
    pub fn hrbfnpr_mesh_sample(
        mesh: *const hrbfnpr_mesh,
        desc: *const hrbfnpr_sample_desc,
        points: *const hrbfnpr_array_out,
        normals: *const hrbfnpr_array_out,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// Which edges of a mesh are sharp.
/// sharp where the mesh has edges: they stand out, as those of machine parts do, from what is
/// beside them; noise and coarse faces of round shapes do not. Closed parts that cross are
/// fitted apart, and meet in creases
pub const HRBFNPR_EDGES_AUTO: u32 = 0;
/// no edge is: a fit is one smooth surface, which rounds them
pub const HRBFNPR_EDGES_SMOOTH: u32 = 1;
/// sharp wherever faces meet at more than crease_angle
pub const HRBFNPR_EDGES_SHARP: u32 = 2;

/// How sharp edges are found.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_edges_desc {
    pub struct_size: u32,
    /// HRBFNPR_EDGES_...; AUTO
    pub edges: u32,
    /// degrees between the normals of two faces, 1 .. 179: an edge that bends more is sharp; 30
    pub crease_angle: f64,
    /// coarse faces that a round surface would leave by four fifths of this stay flat, with sharp
    /// edges; in units of the mesh; 0 = 0.01 diagonals. A large number, such as the diagonal:
    /// only the angle counts
    pub far: f64,
}

extern "C" {
    pub fn hrbfnpr_mesh_edges_desc_init(
        desc: *mut hrbfnpr_mesh_edges_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_edges_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// the number of sharp edges
    pub edges: i64,
    /// the number of smooth patches between them; 1 where no edge is sharp
    pub patches: i64,
    /// of the sharp edges, in units of the mesh
    pub length: f64,
    /// of those among them that have the same patch on both sides, as where a crease fades out
    pub fading: f64,
    /// with AUTO: of edges that bend more than crease_angle but do not stand out, in units of the
    /// mesh; 0 where edges are sharp
    pub doubtful: f64,
    pub seconds: f64,
}

extern "C" {
    pub fn hrbfnpr_mesh_edges_info_init(
        info: *mut hrbfnpr_mesh_edges_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Finds the sharp edges of a mesh and the smooth patches between them, as
    /// hrbfnpr_model_fit_mesh does with the same edges, crease_angle and far.  Edges
    /// that bend by more than crease_angle are sharp; where one ends, it goes on along
    /// edges that bend by 8 degrees or more and keep its direction; short sharp edges
    /// that part nothing are dropped as noise.  Edges of one face, and of more than
    /// two, end patches, but are not sharp.
    /// patch: m x 1, INT64, INT32 or UINT32 for the m faces of the mesh: the number of
    ///        each face's patch, from 0 in the order of their first faces.  NULL: not
    ///        wanted.
    /// sharp: m x 3, the same types: 1 where the edge from corner k of the face to the
    ///        next corner is sharp, else 0.  NULL: not wanted.
    /// desc, info and operation may be NULL.  The call is thread-safe: it only reads
    /// the mesh.  Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
    pub fn hrbfnpr_mesh_edges(
        mesh: *const hrbfnpr_mesh,
        desc: *const hrbfnpr_mesh_edges_desc,
        patch: *const hrbfnpr_array_out,
        sharp: *const hrbfnpr_array_out,
        info: *mut hrbfnpr_mesh_edges_info,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Farthest-point order: each is the point farthest from those before it, the
    /// first the one nearest to the middle of the bounding box; of equals the one of
    /// lower number.  Every prefix is an even choice [Gonzalez 1985].
    /// points:   n x 3, FLOAT32 or FLOAT64, finite, below 1e100.
    /// indices:  k x 1, INT64, INT32 or UINT32, k <= n: numbers of points.
    /// distance: k x 1, FLOAT32 or FLOAT64, or NULL: from those before; infinite for
    ///           the first.
    /// 20 000 of a million take half a second.  operation may be NULL.
    pub fn hrbfnpr_farthest_points(
        context: *mut hrbfnpr_context,
        points: *const hrbfnpr_array,
        indices: *const hrbfnpr_array_out,
        distance: *const hrbfnpr_array_out,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// How near a surface is to a mesh.  "Surface": of the model, within the box of
/// the mesh, grown by 0.05 diagonals; "diagonal" is the mesh's.  What of it is
/// nearest to the mesh's border goes on beyond that, and is left out.  Where
/// closed components overlap, what lies inside is no part of the mesh.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_compare_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// that shares are counted for, in units of the mesh; 0 = 0.002 diagonals
    pub tolerance: f64,
    /// beyond it a part of the surface is an invention, and a part of the mesh missed; 0 = 0.01 diagonals
    pub far: f64,
    /// > 0: what the samples of the model do not bear out by this limit is left out, as a line
    /// set with the same `support` does; a custom model has none; 0 = nothing is left out
    pub support: f64,
    /// on each side, 100 .. 10000000; 0 = 20000
    pub points: i64,
    /// of the cells that the surface is looked for in; 0 = 1/128 of the diagonal, and finer where
    /// it is thin. What is thinner or smaller may be missed
    pub cell_size: f64,
    /// any number; 1
    pub random_seed: u64,
}

extern "C" {
    pub fn hrbfnpr_compare_desc_init(
        desc: *mut hrbfnpr_compare_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// Distances in units of the mesh.  p99: 99 % are not farther.  Of no points: NaN.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_comparison {
    pub struct_size: u32,
    pub reserved: u32,
    /// places on the surface, even over its area
    pub surface_points: i64,
    /// of their distances from the mesh
    pub surface_mean: f64,
    pub surface_p99: f64,
    pub surface_max: f64,
    /// within the tolerance
    pub surface_share: f64,
    /// of the surface, beyond `far`
    pub invented_share: f64,
    /// of the surface: beyond the mesh's border, or by `support`; in none of the above
    pub left_out_share: f64,
    /// places on the mesh, even over its area
    pub mesh_points: i64,
    /// of their distances from the surface
    pub mesh_mean: f64,
    pub mesh_p99: f64,
    pub mesh_max: f64,
    /// within the tolerance
    pub mesh_share: f64,
    /// of the mesh, beyond `far`
    pub missed_share: f64,
    /// degrees between the mesh's normals and the surface's beside them
    pub normal_mean: f64,
    pub normal_p99: f64,
    /// of the surface
    pub components: i64,
    /// of the surface, sum over its components; -1 if it has a border in the box
    pub genus: i64,
    /// as used
    pub tolerance: f64,
    pub diagonal: f64,
    pub seconds: f64,
}

extern "C" {
    pub fn hrbfnpr_comparison_init(
        comparison: *mut hrbfnpr_comparison,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Measures both ways, for any model, in the same coordinates as the mesh.  The
    /// surface is found from places on the mesh and from 16^3 places of the box: a
    /// small part of it that neither leads to is missed.
    /// desc may be NULL; operation too.
    pub fn hrbfnpr_model_compare_mesh(
        model: *const hrbfnpr_model,
        mesh: *const hrbfnpr_mesh,
        desc: *const hrbfnpr_compare_desc,
        comparison: *mut hrbfnpr_comparison,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// How a mesh is fitted.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_fit_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// how near the surface and the mesh are to be to each other, in units of the mesh; 0 = 0.002
    /// diagonals; not below 1e-6 diagonals
    pub tolerance: f64,
    /// of both that has to be within the tolerance, above 0, at most 1; 0.99
    pub share: f64,
    /// what no part may be beyond; 0 = five times the tolerance
    pub far: f64,
    /// 16 .. 1000000; 8000. A fit with sharp edges may have 32 for each of its sheets, if that is
    /// more: each is solved alone
    pub maximum_centres: i64,
    /// places on the mesh to choose from, 1000 .. 10000000; 0 = by its area and its details
    pub candidates: i64,
    /// any number; 1
    pub random_seed: u64,
    /// degrees between the normals of two faces, 5 .. 175: what bends more is an edge, and what
    /// rounding would take four fifths of `far` off the mesh; 30
    pub crease_angle: f64,
    /// HRBFNPR_EDGES_...; AUTO
    pub edges: u32,
    pub reserved2: u32,
}

extern "C" {
    pub fn hrbfnpr_mesh_fit_desc_init(
        desc: *mut hrbfnpr_mesh_fit_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// What a fit to a mesh came to: the last of the measurements that it went by,
/// at places of their own.  hrbfnpr_model_compare_mesh measures again, and more.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_fit_info {
    pub struct_size: u32,
    /// 1: tolerance, share and far are kept, both ways
    pub reached: u32,
    /// as used
    pub tolerance: f64,
    pub far: f64,
    pub candidates: i64,
    /// all
    pub centres: i64,
    /// of these, the last ones: where f is held to the distance from the mesh
    pub off_surface_centres: i64,
    /// fits
    pub rounds: i32,
    /// 1: the mesh has a border, and the surface beyond it was not counted
    pub supported: u32,
    /// of the surface, within the tolerance of the mesh
    pub surface_share: f64,
    pub surface_p99: f64,
    pub surface_max: f64,
    /// of the mesh, within the tolerance of the surface
    pub mesh_share: f64,
    pub mesh_p99: f64,
    pub mesh_max: f64,
    pub seconds_sample: f64,
    /// of all rounds
    pub seconds_fit: f64,
    pub seconds_measure: f64,
    pub seconds_total: f64,
    /// smooth pieces that the surface is made of; 1: it has no edges
    pub sheets: i32,
    pub reserved: u32,
    /// of the mesh's edges that are sharp
    pub crease_length: f64,
    /// of those that are not, as the mesh could not be cut there
    pub smooth_length: f64,
    /// of space, in each of which a few sheets rule
    pub cells: i64,
    /// in which no maximum and minimum of its sheets does all that the mesh does
    pub poor_cells: i64,
    /// of the mesh, from 0: two that are nearer to each other than the tolerance, so that the
    /// surface may join them; -1, -1: none were found
    pub touching_parts: [i32; 2],
    /// where they are
    pub touching_place: [f64; 3],
    /// 1: they may go through each other there; 0: they are near to each other
    pub parts_may_cross: u32,
    pub reserved2: u32,
}

extern "C" {
    pub fn hrbfnpr_mesh_fit_info_init(
        info: *mut hrbfnpr_mesh_fit_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Fits a surface to a mesh with as many samples as that takes: some hundred
    /// even ones, then, in rounds, more where the surface is off the mesh or the mesh
    /// off the surface.  Where the surface goes on far from the mesh, f is held to
    /// the signed distance from the mesh at a few places off it, if it is clear on
    /// which side of the mesh they lie, whatever small holes it has: these are the
    /// last centres of the model, whose normal is the way to the mesh or from it.
    ///
    /// An end short of the tolerance is no error: `reached` is 0, and the log warns.
    /// It comes with maximum_centres, or where more centres gain nothing.  Of a smooth
    /// fit edges are rounded by some tenths of the samples' spacing there, and coarse
    /// faces with smooth normals contradict these: both take many centres.
    ///
    /// A mesh with edges, as `edges` says, is cut along them into smooth patches.  Each
    /// gets a fit of its own, a sheet, and cells of space say which maximum and minimum
    /// of their sheets the surface is there [Ohtake et al. 2003, whose pieces are local];
    /// away from the surface they have the mesh's signs.  Sheets are held to a fortieth
    /// of the tolerance at edges, and to a quarter of it far from them.  An edge that ends
    /// within a patch is made to go on, smoothly.  The points and normals of such a model
    /// are places all over the mesh, not centres.
    /// Trimmed by places on the mesh is what was fitted to an open one, or not reached.
    /// desc may be NULL.  fit (may be NULL): kernel, solver, regularization and trim of
    /// the fits; its points and normals must be empty, its tolerance and maximum_centres
    /// 0; a solver_tolerance of 0 is, of a smooth fit, the tolerance / 200 diagonals,
    /// from 1e-8 to 1e-5: what a distance shows is a hundred times as much.
    /// info and operation may be NULL.  Errors as of hrbfnpr_model_fit, whose
    /// stack it needs as well.
    pub fn hrbfnpr_model_fit_mesh(
        mesh: *const hrbfnpr_mesh,
        desc: *const hrbfnpr_mesh_fit_desc,
        fit: *const hrbfnpr_fit_desc,
        info: *mut hrbfnpr_mesh_fit_info,
        operation: *mut hrbfnpr_operation,
        out_model: *mut *mut hrbfnpr_model,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 13  PAGE: drawings as vectors: SVG, PDF, HPGL, G-code

/// 1.1; groups are layers of Inkscape
pub const HRBFNPR_PAGE_FORMAT_SVG: u32 = 0;
/// 1.5; groups are optional content, which viewers list as layers
pub const HRBFNPR_PAGE_FORMAT_PDF: u32 = 1;
/// for plotters: absolute, 40 units a millimetre, y up from the lower left corner
pub const HRBFNPR_PAGE_FORMAT_HPGL: u32 = 2;
/// for plotters: G0 and G1, millimetres, y up from the lower left corner
pub const HRBFNPR_PAGE_FORMAT_GCODE: u32 = 3;

// How strokes are written whose width varies.
/// filled outlines; SVG and PDF
pub const HRBFNPR_WIDTHS_OUTLINES: u32 = 0;
/// lines of even widths, `width_step` apart
pub const HRBFNPR_WIDTHS_CLASSES: u32 = 1;

// How dots are written.
/// circles; plotters fill them, with SINGLE_PASS draw round them
pub const HRBFNPR_DOT_SHAPE_CIRCLES: u32 = 0;
/// lines of no length with round ends; plotters touch the paper
pub const HRBFNPR_DOT_SHAPE_LINES: u32 = 1;
/// spirals that a pen fills the disc with, if it is wider than the pen
pub const HRBFNPR_DOT_SHAPE_SPIRALS: u32 = 2;

/// groups are sorted so that a pen travels little, as HPGL and GCODE always are: greedily,
/// then by 2-opt and Or-opt; lines may be turned round, closed ones begin elsewhere, and
/// lines whose ends are nearer than `join` become one
pub const HRBFNPR_PAGE_IN_PLOT_ORDER: u32 = 1;
/// a line that is wider than its pen is drawn once, along its centre; else, with HPGL and
/// GCODE and with pens in plot order, it is filled: by passes side by side, 0.8 of the pen's
/// width apart or a little less, each only where the line is so wide. A line up to 1.2 times
/// as wide as the pen takes one
pub const HRBFNPR_PAGE_SINGLE_PASS: u32 = 4;
/// else the page has the paper of its first drawing, white without one, and other drawings
/// with another paper theirs; plotters draw none
pub const HRBFNPR_PAGE_WITHOUT_PAPER: u32 = 2;

// Kinds of lines by the numbers of ISO 128-2.  In line widths a dot is 0.5, the three kinds
// of dashes 6, 12 and 24,
// a gap 3, a space 18; a little more or less, so that lines begin and end with a dash.
pub const HRBFNPR_LINE_TYPE_AS_DRAWN: u32 = 0;
pub const HRBFNPR_LINE_TYPE_CONTINUOUS: u32 = 1;
/// hidden edges
pub const HRBFNPR_LINE_TYPE_DASHED: u32 = 2;
pub const HRBFNPR_LINE_TYPE_DASHED_SPACED: u32 = 3;
/// axes
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_DOTTED: u32 = 4;
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_DOTTED: u32 = 5;
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_TRIPLE_DOTTED: u32 = 6;
pub const HRBFNPR_LINE_TYPE_DOTTED: u32 = 7;
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_SHORT_DASHED: u32 = 8;
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_SHORT_DASHED: u32 = 9;
pub const HRBFNPR_LINE_TYPE_DASHED_DOTTED: u32 = 10;
pub const HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOTTED: u32 = 11;
pub const HRBFNPR_LINE_TYPE_DASHED_DOUBLE_DOTTED: u32 = 12;
pub const HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOUBLE_DOTTED: u32 = 13;
pub const HRBFNPR_LINE_TYPE_DASHED_TRIPLE_DOTTED: u32 = 14;
pub const HRBFNPR_LINE_TYPE_DOUBLE_DASHED_TRIPLE_DOTTED: u32 = 15;

/// A drawing on a page.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_page_item {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// what lies beyond its viewport is cut off
    pub drawing: *const hrbfnpr_drawing,
    /// mm: the viewport's left edge; 0
    pub x: f64,
    /// mm: its top edge; 0
    pub y: f64,
    /// mm of a pixel, > 0; 25.4 / 96
    pub scale: f64,
    /// UTF-8, of the group around it; NULL = none
    pub name: *const c_char,
}

extern "C" {
    pub fn hrbfnpr_page_item_init(item: *mut hrbfnpr_page_item, struct_size: u32) -> hrbfnpr_status;
}

/// What some groups are drawn with.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_pen {
    pub struct_size: u32,
    /// HRBFNPR_LINE_TYPE_...; AS_DRAWN
    pub line_type: u32,
    /// a group's name, or the beginning of names and a '*'; NULL = all. Of pens that fit a group
    /// the last one is taken
    pub groups: *const c_char,
    /// mm, >= 0; 0 = as drawn. Plotters: of the pen; 0 = 0.3
    pub width: f64,
    /// straight RGBA; alpha 0 = as drawn, the default
    pub ink: [f32; 4],
    /// 1 to 255, of a plotter's; 1
    pub number: u32,
    /// 0
    pub reserved: u32,
}

extern "C" {
    pub fn hrbfnpr_pen_init(pen: *mut hrbfnpr_pen, struct_size: u32) -> hrbfnpr_status;
}

/// A line, a filled shape or a text beside the drawings.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_annotation {
    pub struct_size: u32,
    /// HRBFNPR_LINE_TYPE_...; CONTINUOUS
    pub line_type: u32,
    /// UTF-8, of 1 to 95 bytes; "annotations". Those of one group that follow each other share
    /// its layer and pen; their inks and types are those of its first
    pub group: *const c_char,
    /// UTF-8; NULL = the points are a line. Plotters: HPGL writes labels, GCODE none
    pub text: *const c_char,
    /// FLOAT32 or FLOAT64, 2, mm: the line, or where the text's baseline begins
    pub points: hrbfnpr_array,
    /// mm, > 0: of the line, or the height of the text's capitals; 0.35
    pub width: f64,
    /// straight RGBA; black
    pub ink: [f32; 4],
}

extern "C" {
    pub fn hrbfnpr_annotation_init(
        annotation: *mut hrbfnpr_annotation,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_page_desc {
    pub struct_size: u32,
    /// HRBFNPR_PAGE_FORMAT_...; SVG
    pub format: u32,
    /// HRBFNPR_PAGE_IN_PLOT_ORDER and others; 0
    pub flags: u32,
    /// HRBFNPR_WIDTHS_...; OUTLINES
    pub widths: u32,
    /// HRBFNPR_DOT_SHAPE_...; CIRCLES
    pub dots: u32,
    pub reserved: u32,
    /// mm, >= 0; 0 = as far as the drawings reach
    pub width: f64,
    /// mm, >= 0; 0 = as far as the drawings reach
    pub height: f64,
    /// mm, 0.001 to 10: between what is drawn and what is written; 0.05
    pub tolerance: f64,
    /// 1.01 to 4: ratio of neighbouring classes of widths; 1.25
    pub width_step: f64,
    /// mm, >= 0: in plot order, see there; 0 = the pen's width
    pub join: f64,
    /// mm, >= 0: in plot order shorter lines are dropped; 0 = half the pen's width
    pub shortest: f64,
    /// mm, >= 0: in plot order dots nearer to one that stays are dropped; 0 = half the pen's width
    pub dot_distance: f64,
    /// mm/s, > 0; 30
    pub draw_speed: f64,
    /// mm/s, > 0; 80
    pub travel_speed: f64,
    /// >= 0: to lower or to raise the pen; 0.15
    pub pen_seconds: f64,
    /// GCODE: lines that lower it; NULL = "G1 Z0"
    pub pen_down: *const c_char,
    /// GCODE: lines that raise it; NULL = "G0 Z5"
    pub pen_up: *const c_char,
    /// UTF-8, or NULL
    pub title: *const c_char,
    /// UTF-8, or NULL
    pub description: *const c_char,
    /// UTF-8, or NULL: text on the model, the camera, the style; the version is added
    pub metadata: *const c_char,
    /// a list
    pub items: *const hrbfnpr_page_item,
    pub item_count: i64,
    pub item_stride: i64,
    /// a list; NULL and 0
    pub pens: *const hrbfnpr_pen,
    pub pen_count: i64,
    pub pen_stride: i64,
    /// a list; NULL and 0
    pub annotations: *const hrbfnpr_annotation,
    pub annotation_count: i64,
    pub annotation_stride: i64,
}

extern "C" {
    pub fn hrbfnpr_page_desc_init(desc: *mut hrbfnpr_page_desc, struct_size: u32) -> hrbfnpr_status;
}

/// What was written.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_page_info {
    pub struct_size: u32,
    pub reserved: u32,
    pub bytes: i64,
    pub groups: i64,
    /// lines and outlines
    pub paths: i64,
    /// curves or straight lines of all paths
    pub segments: i64,
    pub dots: i64,
    /// in plot order: pairs of ends that became one line
    pub joined: i64,
    /// too short for the pen
    pub dropped_paths: i64,
    /// too near to others for the pen
    pub dropped_dots: i64,
    /// mm, of the page
    pub width: f64,
    /// mm, of the page
    pub height: f64,
    /// mm that a pen draws; in plot order, else 0, as are the next two
    pub drawn: f64,
    /// mm between
    pub travelled: f64,
    /// that a plotter takes at the given speeds
    pub seconds: f64,
    /// lines wider than their pen, drawn in several passes
    pub filled_paths: i64,
}

extern "C" {
    pub fn hrbfnpr_page_info_init(info: *mut hrbfnpr_page_info, struct_size: u32) -> hrbfnpr_status;
    /// Writes a page, a buffer at a time; memory grows with the drawing's largest stroke,
    /// in plot order with its largest group.  info and operation may be NULL.
    /// Errors: INVALID_ARGUMENT (no drawing and no annotation; an empty page; text that
    /// is not UTF-8; discs of paper, which PUBLISHED frames have, for plotters or in plot
    /// order), IO (write failed), OUT_OF_MEMORY, CANCELLED, CALLBACK.
    pub fn hrbfnpr_page_write(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_page_desc,
        write: hrbfnpr_write_fn,
        user: *mut c_void,
        info: *mut hrbfnpr_page_info,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 14  PICTURE: from any source to a drawing in one call

#[repr(C)]
pub struct hrbfnpr_picture {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

#[repr(C)]
pub struct hrbfnpr_settings {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// `sharp_edges` is known, even if it is empty
pub const HRBFNPR_SOURCE_HAS_SHARP_EDGES: u32 = 1;
/// `viewpoint` is known
pub const HRBFNPR_SOURCE_HAS_VIEWPOINT: u32 = 2;
/// the points are one picture of a depth camera that stood at `viewpoint`
pub const HRBFNPR_SOURCE_IS_PHOTO: u32 = 4;

/// One of four kinds: points (with or without normals), a mesh (points and triangles), a
/// model, or a point set.  A model and a point set together are a model with its marks,
/// which are then used as they are.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_source {
    pub struct_size: u32,
    /// HRBFNPR_SOURCE_...; 0
    pub flags: u32,
    /// n x 3, FLOAT32 or FLOAT64: points, or the vertices of the triangles. Points that are not
    /// finite are left out
    pub points: hrbfnpr_array,
    /// n x 3, FLOAT32 or FLOAT64, of any length; not given or all zero = none. Not read of a mesh
    pub normals: hrbfnpr_array,
    /// m x 3, INT32, INT64 or UINT32: a mesh; not given = points
    pub triangles: hrbfnpr_array,
    /// k x 2, INT32, INT64 or UINT32: of a mesh, the pairs of vertices whose faces have normals
    /// of their own in its file; with HAS_SHARP_EDGES
    pub sharp_edges: hrbfnpr_array,
    /// kept; NULL
    pub model: *const hrbfnpr_model,
    /// kept; NULL
    pub point_set: *const hrbfnpr_point_set,
    /// which way is up by the convention of the file's format; 0, 0, 0 = not known
    pub up: [f64; 3],
    /// why, for the note: "PLY files"; NULL = "files of this kind"
    pub up_by: *const c_char,
    /// where the scanner stood, with HAS_VIEWPOINT
    pub viewpoint: [f64; 3],
    /// of a depth camera's image, whose points stand row by row; 0 = it is none
    pub columns: i64,
    pub rows: i64,
    /// UTF-8: of the file, for titles and metadata; NULL
    pub name: *const c_char,
}

extern "C" {
    pub fn hrbfnpr_picture_source_init(
        source: *mut hrbfnpr_picture_source,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// drawing what can hardly be seen is no error
pub const HRBFNPR_PICTURE_ALLOW_BLANK: u32 = 1;
/// all normals are turned, whatever they look like
pub const HRBFNPR_PICTURE_FLIP: u32 = 2;
/// the surface goes on beyond open data, as the fit has it
pub const HRBFNPR_PICTURE_CLOSE: u32 = 4;
/// an open mesh is one surface, also where its parts cross
pub const HRBFNPR_PICTURE_TOGETHER: u32 = 8;
/// the paper lets all through
pub const HRBFNPR_PICTURE_TRANSPARENT: u32 = 16;
/// layers have all their marks, also where the style draws lines alone: for marks that are saved
pub const HRBFNPR_PICTURE_KEEP_MARKS: u32 = 32;
/// no camera is chosen, no marks are placed, no lines are looked for: for the model alone
pub const HRBFNPR_PICTURE_SURFACE_ONLY: u32 = 64;
/// nothing is said of a source that is a part of a solid, and no up is looked for
pub const HRBFNPR_PICTURE_IS_SOLID: u32 = 128;

// The edges of a mesh.
/// as AUTO; where faces are coarse as the normals of the file tell, if they do
pub const HRBFNPR_PICTURE_EDGES_AS_GIVEN: u32 = 0;
/// HRBFNPR_EDGES_AUTO
pub const HRBFNPR_PICTURE_EDGES_AUTO: u32 = 1;
/// HRBFNPR_EDGES_SMOOTH
pub const HRBFNPR_PICTURE_EDGES_SMOOTH: u32 = 2;
/// HRBFNPR_EDGES_SHARP, with `edge_angle`
pub const HRBFNPR_PICTURE_EDGES_SHARP: u32 = 3;

/// YES of the style archaeological, else NO
pub const HRBFNPR_PROFILE_AUTO: u32 = 0;
/// an upright section through the middle stands beside the drawing
pub const HRBFNPR_PROFILE_YES: u32 = 1;
pub const HRBFNPR_PROFILE_NO: u32 = 2;

/// both of a surface that ends, else the front
pub const HRBFNPR_PICTURE_SIDES_AUTO: u32 = 0;
/// HRBFNPR_SIDES_FRONT
pub const HRBFNPR_PICTURE_SIDES_FRONT: u32 = 1;
/// HRBFNPR_SIDES_BOTH
pub const HRBFNPR_PICTURE_SIDES_BOTH: u32 = 2;

// How notes and errors name the options that they speak of.
/// samples 400
pub const HRBFNPR_WORDING_FIELDS: u32 = 0;
/// --samples 400, of a command line
pub const HRBFNPR_WORDING_OPTIONS: u32 = 1;
/// samples=400, of a call in Python
pub const HRBFNPR_WORDING_ARGUMENTS: u32 = 2;

/// One field that is changed on top of all that was chosen.  `field` is the path of a field:
///   style.F            of hrbfnpr_style; style.ink is that of all layers, lines and contours
///   style.KIND.F       of hrbfnpr_layer_style, of a kind of layers: style.hatch.ink
///   style.layers.F     of all layers of the style; share is multiplied
///   style.lines.F      of hrbfnpr_line_style, of all lines
///   style.LINE.F       the same, of a kind of lines: style.ridge.width
///   fit.F              of hrbfnpr_fit_desc
///   mesh_fit.F         of hrbfnpr_mesh_fit_desc
///   marks.F            of hrbfnpr_generate_desc
///   marks.KIND.F       of hrbfnpr_layer_desc, of a kind of layers; marks.layers.F of all
///   line_set.F         of hrbfnpr_line_set_desc
/// Lengths in pixels are those of this picture: they are not scaled by the pen.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_change {
    pub struct_size: u32,
    pub reserved: u32,
    pub field: *const c_char,
    /// a number, several with commas between, #rrggbb or #rrggbbaa of a colour, or the name of a
    /// constant without its prefix: "blue-noise"
    pub value: *const c_char,
}

extern "C" {
    pub fn hrbfnpr_change_init(change: *mut hrbfnpr_change, struct_size: u32) -> hrbfnpr_status;
}

// A stroke of a brush on the surface: within its radius what is painted goes towards a value.
pub const HRBFNPR_DAB_TONE: u32 = 0;
pub const HRBFNPR_DAB_DENSITY: u32 = 1;
pub const HRBFNPR_DAB_DIRECTION: u32 = 2;

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_dab {
    pub struct_size: u32,
    /// HRBFNPR_DAB_...; TONE: 1 = light, 0 = dark
    pub map: u32,
    pub position: [f64; 3],
    /// unit: what faces away from it is not painted
    pub normal: [f64; 3],
    /// > 0
    pub radius: f64,
    /// 0 .. 1 in the middle; it falls to 0 at the radius; 1
    pub strength: f64,
    /// of TONE and DENSITY, 0 .. 1
    pub value: f64,
    /// of DIRECTION: that of hatching
    pub direction: [f64; 3],
}

extern "C" {
    pub fn hrbfnpr_dab_init(dab: *mut hrbfnpr_dab, struct_size: u32) -> hrbfnpr_status;
}

// The parts of the work.
/// looking at a mesh: welding, turning faces
pub const HRBFNPR_STAGE_MESH: u32 = 1;
/// choosing samples
pub const HRBFNPR_STAGE_SAMPLE: u32 = 2;
/// looking for normals
pub const HRBFNPR_STAGE_ORIENT: u32 = 3;
/// the image of a depth camera
pub const HRBFNPR_STAGE_SMOOTH: u32 = 4;
pub const HRBFNPR_STAGE_FIT: u32 = 5;
/// the surface with the mesh
pub const HRBFNPR_STAGE_COMPARE: u32 = 6;
/// looking for the end of the surface
pub const HRBFNPR_STAGE_END: u32 = 7;
/// placing marks
pub const HRBFNPR_STAGE_MARKS: u32 = 8;
/// looking for lines
pub const HRBFNPR_STAGE_LINES: u32 = 9;
/// drawing
pub const HRBFNPR_STAGE_FRAME: u32 = 10;
/// drawing the views of a sheet
pub const HRBFNPR_STAGE_VIEWS: u32 = 11;

/// a measurement
pub const HRBFNPR_SEVERITY_INFO: u32 = 0;
/// what was chosen, repaired or left out
pub const HRBFNPR_SEVERITY_NOTE: u32 = 1;
/// the result may be wrong there
pub const HRBFNPR_SEVERITY_WARNING: u32 = 2;
/// there is no result: the error of the call, in full length
pub const HRBFNPR_SEVERITY_FAILURE: u32 = 3;

// Notes.  In brackets the figures of each.
/// left out [faces]
pub const HRBFNPR_NOTE_FACES_NOT_FINITE: u32 = 1;
/// points at a value that stands for none, left out [points, value]
pub const HRBFNPR_NOTE_NO_DATA: u32 = 2;
/// points far from all others, left out [points]
pub const HRBFNPR_NOTE_STRAYS: u32 = 3;
/// so many that only some get normals [points, used]
pub const HRBFNPR_NOTE_SOME_ORIENTED: u32 = 4;
/// there were none [points]
pub const HRBFNPR_NOTE_NORMALS_MADE: u32 = 5;
/// [confidence]
pub const HRBFNPR_NOTE_NORMALS_NOT_SURE: u32 = 6;
/// which side of an open surface is its front
pub const HRBFNPR_NOTE_FRONT_NOT_TOLD: u32 = 7;
/// [points, used]
pub const HRBFNPR_NOTE_SAMPLES_CHOSEN: u32 = 8;
/// without a position or normal, left out [points]
pub const HRBFNPR_NOTE_POINTS_NOT_USABLE: u32 = 9;
/// several at one place: their mean [places]
pub const HRBFNPR_NOTE_NORMALS_JOINED: u32 = 10;
/// opposite ones at one place, left out [places]
pub const HRBFNPR_NOTE_NORMALS_OPPOSITE: u32 = 11;
/// it looked down [axis]
pub const HRBFNPR_NOTE_TERRAIN_TURNED: u32 = 12;
/// all looked inward
pub const HRBFNPR_NOTE_NORMALS_TURNED: u32 = 13;
/// [turned, made, what they were: HRBFNPR_NORMALS_...]
pub const HRBFNPR_NOTE_NORMALS_REPAIRED: u32 = 14;
/// those around them [normals, of]
pub const HRBFNPR_NOTE_NORMALS_AGAINST: u32 = 15;
/// some parts outward, others inward [share]
pub const HRBFNPR_NOTE_NORMALS_MIXED: u32 = 16;
/// most of an open surface
pub const HRBFNPR_NOTE_NORMALS_INWARD: u32 = 17;
pub const HRBFNPR_NOTE_VIEWPOINT_NOT_USED: u32 = 18;
/// of a depth camera, on no surface [pixels]
pub const HRBFNPR_NOTE_PIXELS_LEFT_OUT: u32 = 19;
/// [noise, depth]
pub const HRBFNPR_NOTE_DEPTH_NOISE: u32 = 20;
/// the samples have noise, and the surface does not go through all
pub const HRBFNPR_NOTE_SMOOTHED: u32 = 21;
/// at the same place [samples]
pub const HRBFNPR_NOTE_SAMPLES_MERGED: u32 = 22;
/// merged with another very near [samples]
pub const HRBFNPR_NOTE_SAMPLES_NEAR: u32 = 23;
/// as strays [samples]
pub const HRBFNPR_NOTE_SAMPLES_DROPPED: u32 = 24;
/// with a flipped normal, repaired [samples]
pub const HRBFNPR_NOTE_SAMPLES_FLIPPED: u32 = 25;
/// samples that look so, and stay [samples]
pub const HRBFNPR_NOTE_LIKE_STRAYS: u32 = 26;
/// samples that look so, and stay [samples]
pub const HRBFNPR_NOTE_LIKE_FLIPPED: u32 = 27;
/// the surface is a guess [points]
pub const HRBFNPR_NOTE_FEW_POINTS: u32 = 28;
/// all points
pub const HRBFNPR_NOTE_ON_A_LINE: u32 = 29;
/// all points
pub const HRBFNPR_NOTE_IN_A_PLANE: u32 = 30;
/// the points: the surface between them is drawn, too
pub const HRBFNPR_NOTE_ALONG_CURVES: u32 = 31;
/// where the surface ends
pub const HRBFNPR_NOTE_END_NOT_FOUND: u32 = 32;
/// another direction than y [x, y, z]
pub const HRBFNPR_NOTE_UP: u32 = 33;
/// against those beside them [faces]
pub const HRBFNPR_NOTE_FACES_TURNED: u32 = 34;
/// a mesh, or parts of it, turned [parts]
pub const HRBFNPR_NOTE_INSIDE_OUT: u32 = 35;
/// without area, or twice there [faces]
pub const HRBFNPR_NOTE_FACES_LEFT_OUT: u32 = 36;
/// others, left out [parts, faces]
pub const HRBFNPR_NOTE_PARTS_INSIDE: u32 = 37;
/// a surface of one side, or one that crosses itself [edges]
pub const HRBFNPR_NOTE_CONTRARY_EDGES: u32 = 38;
/// from all others, left out [parts, faces]
pub const HRBFNPR_NOTE_PARTS_FAR: u32 = 39;
/// faces on an edge of two others, left out [faces]
pub const HRBFNPR_NOTE_FLAPS: u32 = 40;
/// by the normals of the file
pub const HRBFNPR_NOTE_ALL_FLAT: u32 = 41;
/// some edges are sharp by the normals of the file
pub const HRBFNPR_NOTE_EDGES_BY_NORMALS: u32 = 42;
/// faces [times, vertices moved, places between them raised, off a round surface; shares of
/// the diagonal]
pub const HRBFNPR_NOTE_DIVIDED: u32 = 43;
/// faces are coarse, but nothing round goes through them
pub const HRBFNPR_NOTE_COARSE_FLAT: u32 = 44;
/// parts that cross are surfaces of their own [parts, groups]
pub const HRBFNPR_NOTE_GROUPS: u32 = 45;
/// the tolerance [tolerance, share of the mesh, share of the surface, farthest; of the diagonal]
pub const HRBFNPR_NOTE_NOT_REACHED: u32 = 46;
/// [their length in diagonals]
pub const HRBFNPR_NOTE_EDGES_STAY_SMOOTH: u32 = 47;
/// the surface, at a share of the mesh [share, farthest]
pub const HRBFNPR_NOTE_OFF_MESH: u32 = 48;
/// parts of surface that the mesh does not have, left out [parts]
pub const HRBFNPR_NOTE_MADE_BY_FIT: u32 = 49;
/// parts of a mesh that the tolerance is too large for
pub const HRBFNPR_NOTE_PARTS_TOO_THIN: u32 = 50;
/// fewer than fill the darkest tone [wanted, made]
pub const HRBFNPR_NOTE_MARKS_LIMITED: u32 = 51;
/// of the published recursion [wanted, taken]
pub const HRBFNPR_NOTE_LEVELS_LIMITED: u32 = 52;
/// the depth camera's [azimuth]
pub const HRBFNPR_NOTE_SEEN_FROM_CAMERA: u32 = 53;
/// of an open surface [azimuth]
pub const HRBFNPR_NOTE_SEEN_FROM_FRONT: u32 = 54;
/// lines want a model, and the source is a point set
pub const HRBFNPR_NOTE_NO_LINES_OF_MARKS: u32 = 55;
/// the surface is thinner than the cells that lines are looked for in [triangles turned, of,
/// samples missed]
pub const HRBFNPR_NOTE_LINES_THIN: u32 = 56;
/// where the surface ends beyond its samples [borders, support, share]
pub const HRBFNPR_NOTE_LINES_END: u32 = 57;
/// curves that end inside the surface [curves]
pub const HRBFNPR_NOTE_LINES_BROKEN: u32 = 58;
/// lines whose visibility contradicts itself [lines]
pub const HRBFNPR_NOTE_LINES_DOUBTED: u32 = 59;
/// places with too many crossings of lines [places]
pub const HRBFNPR_NOTE_LINES_TANGLED: u32 = 60;
/// hardly anything can be seen [shown, marks, share of ink]
pub const HRBFNPR_NOTE_BLANK: u32 = 61;
/// that were chosen by the widths at hand
pub const HRBFNPR_NOTE_PENS: u32 = 62;
/// [metres drawn, metres travelled, seconds]
pub const HRBFNPR_NOTE_PLOTTED: u32 = 63;
/// what settings do not hold
pub const HRBFNPR_NOTE_NOT_IN_SETTINGS: u32 = 64;
/// of the format
pub const HRBFNPR_NOTE_UNIT_IS_METRE: u32 = 65;
/// for centre lines
pub const HRBFNPR_NOTE_NO_SYMMETRY: u32 = 66;
/// outlines of a cut that are not closed [outlines]
pub const HRBFNPR_NOTE_SECTION_OPEN: u32 = 67;
/// made of length 1 [normals]
pub const HRBFNPR_NOTE_NORMALS_NOT_UNIT: u32 = 68;
/// all points
pub const HRBFNPR_NOTE_AT_ONE_PLACE: u32 = 69;
/// for the source's size
pub const HRBFNPR_NOTE_FAR_FROM_ORIGIN: u32 = 70;
/// at the place of another [vertices]
pub const HRBFNPR_NOTE_VERTICES_JOINED: u32 = 71;
/// of no face, left out [vertices]
pub const HRBFNPR_NOTE_VERTICES_UNUSED: u32 = 72;
/// of more than two faces [edges]
pub const HRBFNPR_NOTE_NONMANIFOLD_EDGES: u32 = 73;
/// [borders, their edges]
pub const HRBFNPR_NOTE_MESH_OPEN: u32 = 74;
/// of a mesh [parts]
pub const HRBFNPR_NOTE_SEVERAL_PARTS: u32 = 75;
/// why a source cannot be drawn
pub const HRBFNPR_NOTE_NOT_USABLE: u32 = 76;

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_note {
    pub struct_size: u32,
    /// HRBFNPR_NOTE_...
    pub code: u32,
    /// HRBFNPR_SEVERITY_...
    pub severity: u32,
    pub figure_count: u32,
    /// as above, in that order
    pub figures: [f64; 8],
    /// one sentence without a full stop, UTF-8, in the words of `wording`
    pub text: *const c_char,
    /// what to do about it, in the same words; NULL where the text says it, or there is nothing to say
    pub advice: *const c_char,
}

extern "C" {
    pub fn hrbfnpr_note_init(note: *mut hrbfnpr_note, struct_size: u32) -> hrbfnpr_status;
}

/// What happens while a picture is made.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_event {
    pub struct_size: u32,
    /// HRBFNPR_STAGE_... that runs; 0 = between two
    pub stage: u32,
    /// of the stage, 0 when it begins, 1 when it is over
    pub fraction: f64,
    /// of the stage, when it is over
    pub seconds: f64,
    /// of the stage: "place marks"
    pub name: *const c_char,
    /// the same for a progress bar: "placing marks"
    pub doing: *const c_char,
    /// what the stage came to, when it is over; else NULL
    pub says: *const c_char,
    /// a new one; NULL = this is about the stage
    pub note: *const hrbfnpr_note,
}

extern "C" {
    pub fn hrbfnpr_picture_event_init(
        event: *mut hrbfnpr_picture_event,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// Runs on the thread that entered; what it is given lives during the call only.
pub type hrbfnpr_picture_event_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, event: *const hrbfnpr_picture_event)>;

/// Every field has a default that makes a good picture; a source and, if wanted, a style are enough.
/// NaN (or 0 or NULL, where a line says so) stands for what is chosen.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_desc {
    pub struct_size: u32,
    /// HRBFNPR_PICTURE_...; 0
    pub flags: u32,
    /// a list, 1 and more: each is a surface of its own
    pub sources: *const hrbfnpr_picture_source,
    pub source_count: i64,
    pub source_stride: i64,
    /// HRBFNPR_PRESET_...; CONTOUR_AND_STIPPLE
    ///
    /// Style.
    pub preset: u32,
    /// HRBFNPR_WORDING_...; FIELDS
    pub wording: u32,
    /// the name of a preset, in place of its number; NULL
    pub style_name: *const c_char,
    /// used as it is, with lengths in pixels of this picture; NULL. `preset` then says which
    /// layers of marks there are
    pub style: *const hrbfnpr_style,
    /// what this descriptor leaves at its defaults; kept; NULL
    pub settings: *const hrbfnpr_settings,
    /// a list; NULL and 0
    pub changes: *const hrbfnpr_change,
    pub change_count: i64,
    pub change_stride: i64,
    /// what is painted, a list; NULL and 0
    pub dabs: *const hrbfnpr_dab,
    pub dab_count: i64,
    pub dab_stride: i64,
    /// 1 .. 32768, with `height`; 0 = from `size`
    ///
    /// Size, in pixels.
    pub width: i32,
    pub height: i32,
    /// of the longer side, 1 .. 32768; the shorter one is as the object needs it; 0 = 1600
    pub size: i32,
    /// HRBFNPR_PICTURE_SIDES_...; AUTO
    pub sides: u32,
    /// radius of the pen, which styles vary a little; 0 = an 800th of the longer side, at least 0.75
    pub pen: f64,
    /// of contours; others are finer; 0 = that of the style
    pub line_width: f64,
    /// used as it is, with its viewport as size; NULL
    ///
    /// Camera.
    pub camera: *const hrbfnpr_camera,
    /// 0, 0, 0 = by the format and the shape, y where neither tells
    pub up: [f64; 3],
    /// degrees, of the camera about the up axis; NaN = 30, and another where that sees the back
    /// of an open surface
    pub azimuth: f64,
    /// degrees, of the camera above the horizon; NaN = 20
    pub elevation: f64,
    /// from the eye into the scene, in place of these two; 0, 0, 0 = not given
    pub direction: [f64; 3],
    /// place of the eye, which looks at `target`; NaN = not given
    pub eye: [f64; 3],
    /// NaN = the middle of the model
    pub target: [f64; 3],
    /// degrees, vertical angle of view, 0 = orthographic; NaN = 30, 0 of the style archaeological
    pub fov: f64,
    /// share that is free on each side, 0 .. 0.45; NaN = 0.05
    pub margin: f64,
    /// degrees, of an orbit that starts here: the picture has room for all of it; 0 = a still
    pub turn: f64,
    /// of that orbit, 1 and more; 36
    pub turn_frames: i32,
    /// HRBFNPR_NORMALS_...: what is known of those of points; AUTO
    ///
    /// From the source to a surface.
    pub normals: u32,
    /// of a mesh, or chosen from points; 0 = as many as a mesh needs, of points all up to 4096
    pub samples: i64,
    /// units of the source: samples are chosen until all is this near; 0 = 0.002 diagonals of a
    /// mesh, none of points
    pub tolerance: f64,
    /// the most samples that are chosen; 0 = 8000 of a mesh, no limit of points
    pub maximum_centres: i64,
    /// HRBFNPR_PARTS_...: of a mesh; OUTER
    pub parts: u32,
    /// HRBFNPR_PICTURE_EDGES_...: of a mesh; AS_GIVEN
    pub edges: u32,
    /// degrees, 5 .. 175: of EDGES_SHARP; 30
    pub edge_angle: f64,
    /// degrees, 0 .. 180: faces that meet at a sharper angle do not share their normals; NaN = 60
    pub crease_angle: f64,
    /// how often faces are divided into four towards something round, 0 .. 6; -1 = where they are
    /// coarse and no edges stand out
    pub subdivide: i32,
    /// HRBFNPR_PROFILE_...; AUTO
    pub profile: u32,
    /// where the scanner stood: open surfaces without normals look to it; NaN = as the source tells
    pub viewpoint: [f64; 3],
    /// factor of the width over which the image of a depth camera is smoothed; 0 leaves its
    /// points where they are; NaN = 1
    pub depth_smoothing: f64,
    /// of all that is random; 1
    pub random_seed: u64,
    /// kinds of layers with commas between, "stipples,hatch"; NULL = those of the style
    ///
    /// Marks, lines, and what stands beside the drawing.
    pub mark_kinds: *const c_char,
    /// n x 3: where marks of PUBLISHED start; not given
    pub seed_points: hrbfnpr_array,
    /// degrees by which all lines of hatching are turned; 0
    pub hatch_angle: f64,
    /// kinds with commas between: contour, suggestive, ridges, valleys, apparent, parabolic,
    /// isophotes=0.3:0.6, section=z:20, border, crease; "none": contours by marks; NULL = those
    /// of the style
    pub lines: *const c_char,
    /// the unit of a scale bar below the drawing; "none": no bar; NULL = "units" of the style
    /// archaeological, else "none"
    pub scale_bar: *const c_char,
    /// NULL; called for as long as the picture lives
    pub on_event: hrbfnpr_picture_event_fn,
    /// outlives the picture
    pub event_user: *mut c_void,
}

extern "C" {
    pub fn hrbfnpr_picture_desc_init(
        desc: *mut hrbfnpr_picture_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

// What it is.
pub const HRBFNPR_SOURCE_KIND_POINTS: u32 = 1;
pub const HRBFNPR_SOURCE_KIND_MESH: u32 = 2;
pub const HRBFNPR_SOURCE_KIND_MODEL: u32 = 3;
pub const HRBFNPR_SOURCE_KIND_POINT_SET: u32 = 4;

// Which way normals look.
/// there are none, or the source cannot be drawn
pub const HRBFNPR_NORMALS_LOOK_UNKNOWN: u32 = 0;
pub const HRBFNPR_NORMALS_LOOK_OUTWARD: u32 = 1;
pub const HRBFNPR_NORMALS_LOOK_INWARD: u32 = 2;
/// some outward, others inward
pub const HRBFNPR_NORMALS_LOOK_MIXED: u32 = 3;
/// they agree, and the surface encloses nothing
pub const HRBFNPR_NORMALS_LOOK_OPEN: u32 = 4;
/// they belong to other points; told of points along curves
pub const HRBFNPR_NORMALS_LOOK_FOREIGN: u32 = 5;

/// What is not known of this kind of source is 0, and so is what would have been found out
/// after the finding that it
/// cannot be drawn.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_source_info {
    pub struct_size: u32,
    /// HRBFNPR_SOURCE_KIND_...
    pub kind: u32,
    /// HRBFNPR_SEVERITY_... of the worst finding: INFO = there is none, NOTE = a picture repairs
    /// it, WARNING, FAILURE = it cannot be drawn
    pub severity: u32,
    /// HRBFNPR_NORMALS_LOOK_...: of points or faces
    pub normals_look: u32,
    /// as given; vertices of a mesh, centres of a model, marks of a point set
    pub points: i64,
    /// as given
    pub triangles: i64,
    /// points at a value that stands for none; what follows is without them
    pub no_data: i64,
    /// points far from all others; what follows is without them
    pub strays: i64,
    pub points_not_finite: i64,
    /// points, or vertices of faces, at the place of another
    pub duplicates: i64,
    /// of finite points
    pub bounds_min: [f64; 3],
    pub bounds_max: [f64; 3],
    /// of these bounds
    pub diagonal: f64,
    /// that a picture chooses by itself, of points and meshes; the reason is at the end
    pub up: [f64; 3],
    /// 1: there are some that are not zero
    ///
    /// Normals of points; looks_down, normals_closed and normals_flipped_share of faces, too.
    pub has_normals: u32,
    /// 1: the points lie along curves, as those of wires and cross sections
    pub along_curves: u32,
    /// a terrain looks down along an axis: 1 = y, 2 = z; 0 = it does not, or is none
    pub looks_down: u32,
    pub reserved: u32,
    pub normals_zero: i64,
    pub normals_not_finite: i64,
    /// of length 1, of those that can be used; 0 .. 1
    pub normals_unit_share: f64,
    /// sum of the winding numbers on both sides of the samples, in the middle: 1 closed and
    /// outward, -1 inward, 0 a flat sheet; not of points along curves
    pub normals_closed: f64,
    /// judged by neighbours; not of points along curves
    pub normals_flipped_share: f64,
    /// pixels that have a point
    ///
    /// The picture of a depth camera that has no normals.
    pub image_seen: i64,
    /// of these, on no surface
    pub image_dropped: i64,
    /// median of those that were seen
    pub image_depth: f64,
    /// standard deviation at that depth
    pub image_noise: f64,
    /// 1: each edge has two faces, which run along it in opposite directions
    ///
    /// A mesh, as given but for vertices at the same place, which are joined.
    pub closed: u32,
    /// 1: it is closed, and its faces look inward
    pub inside_out: u32,
    /// parts that share no vertex
    pub components: i64,
    /// parts without border whose faces look inward; inside another one it is a cavity
    pub components_inside_out: i64,
    /// of one face
    pub boundary_edges: i64,
    /// borders
    pub boundary_loops: i64,
    /// of more than two faces
    pub nonmanifold_edges: i64,
    /// what hrbfnpr_mesh_create leaves of them
    pub nonmanifold_left: i64,
    /// of two faces, one of which is turned over
    pub contrary_edges: i64,
    /// with a corner that is not finite
    pub faces_not_finite: i64,
    /// without area
    pub degenerate_faces: i64,
    /// with the corners of another
    pub repeated_faces: i64,
    /// of no face
    pub unused_vertices: i64,
    pub area: f64,
    /// enclosed; 0 where the mesh is not closed
    pub volume: f64,
    /// "it is so in PLY files"; "" = up is not known
    pub up_reason: [c_char; 128],
}

extern "C" {
    pub fn hrbfnpr_source_info_init(
        info: *mut hrbfnpr_source_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Looks at a source without drawing it: facts into info, findings as notes of on_event.
    /// NOTE: what a picture repairs;
    /// WARNING: what is wrong, with advice; FAILURE: a code NOT_USABLE that says why it cannot be
    /// drawn, and the call is
    /// OK all the same.  One matter may be both repaired and wrong.  wording:
    /// HRBFNPR_WORDING_...; on_event and operation
    /// may be NULL.
    /// Errors: INVALID_ARGUMENT (fields of the source), OUT_OF_MEMORY, CANCELLED, CALLBACK.
    pub fn hrbfnpr_source_inspect(
        context: *mut hrbfnpr_context,
        source: *const hrbfnpr_picture_source,
        wording: u32,
        on_event: hrbfnpr_picture_event_fn,
        event_user: *mut c_void,
        operation: *mut hrbfnpr_operation,
        info: *mut hrbfnpr_source_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Fits, places marks and looks for lines; draws nothing yet.  operation may be NULL.
    /// Needs the stack of hrbfnpr_model_fit.
    /// Errors: INVALID_ARGUMENT (also for a source that cannot be drawn), SINGULAR_SYSTEM,
    /// NOT_CONVERGED, OUT_OF_MEMORY, CANCELLED, CALLBACK.
    pub fn hrbfnpr_picture_create(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_picture_desc,
        operation: *mut hrbfnpr_operation,
        out_picture: *mut *mut hrbfnpr_picture,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// The same surfaces in another style, size or view: desc has no sources.  Marks and lines
    /// that fit are used again; else they are placed and looked for anew.
    pub fn hrbfnpr_picture_restyle(
        picture: *const hrbfnpr_picture,
        desc: *const hrbfnpr_picture_desc,
        operation: *mut hrbfnpr_operation,
        out_picture: *mut *mut hrbfnpr_picture,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// any thread; NULL is ignored
    pub fn hrbfnpr_picture_retain(picture: *mut hrbfnpr_picture);
    /// any thread; NULL is ignored
    pub fn hrbfnpr_picture_release(picture: *mut hrbfnpr_picture);
    /// Draws it.  camera NULL: as it was planned, and INVALID_ARGUMENT with a note BLANK if hardly
    /// anything could be seen (ALLOW_BLANK lets it be).  Lines keep their numbers from one
    /// drawing to the next.  operation may be NULL.
    pub fn hrbfnpr_picture_draw(
        picture: *mut hrbfnpr_picture,
        camera: *const hrbfnpr_camera,
        operation: *mut hrbfnpr_operation,
        out_drawing: *mut *mut hrbfnpr_drawing,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_info {
    pub struct_size: u32,
    /// HRBFNPR_PRESET_...
    pub preset: u32,
    /// surfaces, or 1 of a point set
    pub parts: i64,
    /// of all parts
    pub marks: i64,
    pub notes: i64,
    pub stages: i64,
    /// pixels, of the drawing
    pub width: i32,
    pub height: i32,
    /// of all parts
    pub bounds_min: [f64; 3],
    pub bounds_max: [f64; 3],
    /// as used
    pub up: [f64; 3],
    /// radius, pixels, as used
    pub pen: f64,
    /// that it took to make
    pub seconds: f64,
}

extern "C" {
    pub fn hrbfnpr_picture_info_init(
        info: *mut hrbfnpr_picture_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    pub fn hrbfnpr_picture_get_info(
        picture: *const hrbfnpr_picture,
        info: *mut hrbfnpr_picture_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// One surface: handles without references of their own, valid while the picture lives.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_part {
    pub struct_size: u32,
    /// HRBFNPR_SIDES_... as used
    pub sides: u32,
    /// NULL of a point set
    pub model: *const hrbfnpr_model,
    /// NULL with SURFACE_ONLY
    pub point_set: *const hrbfnpr_point_set,
    /// NULL without lines
    pub line_set: *const hrbfnpr_line_set,
    /// of a mesh, as it was fitted to; else NULL
    pub mesh: *const hrbfnpr_mesh,
}

extern "C" {
    pub fn hrbfnpr_picture_part_init(
        part: *mut hrbfnpr_picture_part,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// number: 0 .. hrbfnpr_picture_info.parts - 1; the largest is 0.
    pub fn hrbfnpr_picture_get_part(
        picture: *const hrbfnpr_picture,
        number: i64,
        part: *mut hrbfnpr_picture_part,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// What was chosen for hrbfnpr_renderer_draw, valid while the picture lives.
    pub fn hrbfnpr_picture_get_style(
        picture: *const hrbfnpr_picture,
        style: *mut *const hrbfnpr_style,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// The descriptor that hrbfnpr_point_set_generate was given; *desc is NULL where the caller
    /// gave the marks.
    pub fn hrbfnpr_picture_get_marks(
        picture: *const hrbfnpr_picture,
        desc: *mut *const hrbfnpr_generate_desc,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// number: 0 .. hrbfnpr_picture_info.notes - 1.  The text is valid while the picture lives.
    pub fn hrbfnpr_picture_get_note(
        picture: *const hrbfnpr_picture,
        number: i64,
        note: *mut hrbfnpr_note,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// number: 0 .. hrbfnpr_picture_info.stages - 1: those that are over, as their last event.
    pub fn hrbfnpr_picture_get_stage(
        picture: *const hrbfnpr_picture,
        number: i64,
        stage: *mut hrbfnpr_picture_event,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// The camera that was planned.
    pub fn hrbfnpr_picture_get_camera(
        picture: *const hrbfnpr_picture,
        camera: *mut hrbfnpr_camera,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// One from another side, with the size, the lens and the margin of the picture: along
    /// `direction`, or from azimuth and
    /// elevation in degrees, where direction is NULL; NaN = as planned.
    pub fn hrbfnpr_picture_look(
        picture: *const hrbfnpr_picture,
        direction: *const f64,
        azimuth: f64,
        elevation: f64,
        camera: *mut hrbfnpr_camera,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// The planned one, turned about the up axis through the middle of the model (or the target
    /// of an eye).
    pub fn hrbfnpr_picture_orbit(
        picture: *const hrbfnpr_picture,
        degrees: f64,
        camera: *mut hrbfnpr_camera,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// A plate is a drawing with the section and the scale bar that the picture has beside it;
    /// without these it is the
    /// drawing alone.  In this part `camera` is the one that the drawing was made by; NULL = the
    /// planned one.
    /// *width and *height get the pixels of the plate.
    pub fn hrbfnpr_picture_plate_size(
        picture: *const hrbfnpr_picture,
        camera: *const hrbfnpr_camera,
        width: *mut i32,
        height: *mut i32,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// The plate as an image of at least plate_size pixels, from its top-left corner; as
    /// hrbfnpr_drawing_rasterize.
    pub fn hrbfnpr_picture_rasterize(
        picture: *const hrbfnpr_picture,
        drawing: *const hrbfnpr_drawing,
        camera: *const hrbfnpr_camera,
        image: *const hrbfnpr_image,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// On which paper a drawing is written, and with which pens.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_page_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// format, flags, tolerance, speeds, pens and the like; its items, annotations and size are
    /// set by this call, and its title, description and metadata where they are NULL; NULL = its
    /// defaults
    pub page: *const hrbfnpr_page_desc,
    /// "a0" .. "a6", "letter", "legal", "tabloid", or "210x297" in mm: the drawing fills it,
    /// turned as it fits better; NULL = a pixel is 25.4 / 96 mm
    pub paper: *const c_char,
    /// mm, free on each side of the paper; 10
    pub paper_margin: f64,
    /// FLOAT64, 1, mm, ascending: of the pens at hand; each group gets that which is nearest to
    /// its lines' median width; not given
    pub pen_widths: hrbfnpr_array,
}

extern "C" {
    pub fn hrbfnpr_picture_page_desc_init(
        desc: *mut hrbfnpr_picture_page_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// The plate as vectors; as hrbfnpr_page_write.  desc, info and operation may be NULL.  Adds
    /// notes PENS and PLOTTED.
    pub fn hrbfnpr_picture_write(
        picture: *mut hrbfnpr_picture,
        drawing: *const hrbfnpr_drawing,
        camera: *const hrbfnpr_camera,
        desc: *const hrbfnpr_picture_page_desc,
        write: hrbfnpr_write_fn,
        user: *mut c_void,
        info: *mut hrbfnpr_page_info,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Reads what _write_settings or the viewer wrote (docs/settings.md).
    /// Errors: IO, INVALID_ARGUMENT that names the key and what would be right, OUT_OF_MEMORY.
    pub fn hrbfnpr_settings_load(
        context: *mut hrbfnpr_context,
        read: hrbfnpr_read_fn,
        user: *mut c_void,
        out_settings: *mut *mut hrbfnpr_settings,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// any thread; NULL is ignored
    pub fn hrbfnpr_settings_retain(settings: *const hrbfnpr_settings);
    /// any thread; NULL is ignored
    pub fn hrbfnpr_settings_release(settings: *const hrbfnpr_settings);
    /// Writes what a picture was made with.  What settings do not hold becomes a note NOT_IN_SETTINGS.
    pub fn hrbfnpr_picture_write_settings(
        picture: *mut hrbfnpr_picture,
        write: hrbfnpr_write_fn,
        user: *mut c_void,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 15  VIEWS: technical drawings on a sheet, to scale

/// planes of symmetry through the middle have a centre line in each view that sees them as a
/// line; a note NO_SYMMETRY says that there are none
pub const HRBFNPR_VIEWS_CENTRE_LINES: u32 = 1;
/// the name of each view stands above it; that of a section always does
pub const HRBFNPR_VIEWS_LABELS: u32 = 2;
/// the format of the source is in metres, as glTF: a unit_mm of 0 is 1000, with a note UNIT_IS_METRE
pub const HRBFNPR_VIEWS_UNIT_IS_METRE: u32 = 4;

// Where views stand [ISO 5456-2].
/// first angle: the left view at the right, the top view below
pub const HRBFNPR_VIEWS_ANGLE_FIRST: u32 = 0;
/// third angle: the left view at the left, the top view above
pub const HRBFNPR_VIEWS_ANGLE_THIRD: u32 = 1;

// Hidden edges.  Sections never have any [ISO 128-3].
/// dashed thin lines
pub const HRBFNPR_VIEWS_HIDDEN_DASHED: u32 = 0;
/// they are not drawn
pub const HRBFNPR_VIEWS_HIDDEN_NONE: u32 = 1;
/// continuous thin lines
pub const HRBFNPR_VIEWS_HIDDEN_SHOWN: u32 = 2;

/// Texts are UTF-8 and are read during the call only.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_views_desc {
    pub struct_size: u32,
    /// HRBFNPR_VIEWS_...; 0
    pub flags: u32,
    /// HRBFNPR_VIEWS_ANGLE_...; FIRST
    pub projection: u32,
    /// HRBFNPR_VIEWS_HIDDEN_...; DASHED
    pub hidden: u32,
    /// names with commas between: front, back, left, right, top, bottom, iso; each is drawn once.
    /// NULL = "front,left,top,iso", with ANGLE_THIRD "front,right,top,iso"
    pub views: *const c_char,
    /// planes with semicolons between: "z:20" cuts at z = 20, "z" through the middle, "1:1:0:5"
    /// at x + y = 5. An axis without a sign is seen from the front, from above or from the side
    /// that is drawn; "+z:20" from above, "-z:20" from below. They are called A-A, B-B, ...; NULL
    /// = none
    pub sections: *const c_char,
    /// "a0" .. "a6", "letter", "legal" or "tabloid", lying, or "297x210", width and height in mm;
    /// "auto" = the smallest of a4 to a0 that has room at the scale, a3 where the scale is
    /// "auto", too; NULL = "auto"
    pub paper: *const c_char,
    /// "1:2" = half as large as it is; "auto" = the largest of 1, 2 and 5 times a power of ten
    /// [ISO 5455] that has room on the paper; NULL = "auto"
    pub scale: *const c_char,
    /// thin lines where the surface bends without an edge: kinds with commas between, ridges,
    /// valleys, suggestive; "none"; NULL = "none"
    pub smooth: *const c_char,
    /// in the title block; NULL or "" = `model` without the ending of its name
    pub title: *const c_char,
    /// the file's name, in the title block; NULL or "" = the name of the picture's source
    pub model: *const c_char,
    /// mm of a unit of the model, up to 1e9; 0 = 1, or 1000 with UNIT_IS_METRE
    pub unit_mm: f64,
    /// degrees, > 0: edges of a mesh are sharp if its faces meet at more than this; 30. Larger:
    /// fewer edges
    pub crease_angle: f64,
    /// mm, 0.01 .. 1000: of outlines; thin lines are half as wide; 0.5
    pub line_width: f64,
    /// mm, 0.01 .. 1000: between the lines in cut faces; 3
    pub hatch_spacing: f64,
    /// mm, > 0: free between views; 15
    pub spacing: f64,
    /// format, flags, tolerance, speeds and the like; its items, annotations, pens and size are
    /// set by this call, and its title and description where they are NULL; NULL = its defaults
    /// with a tolerance of 0.02
    pub page: *const hrbfnpr_page_desc,
}

extern "C" {
    pub fn hrbfnpr_views_desc_init(
        desc: *mut hrbfnpr_views_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// What was drawn.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_views_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// sections are among them
    pub views: i64,
    /// that were written
    pub bytes: i64,
    /// mm, of the page
    pub width: f64,
    /// mm, of the page
    pub height: f64,
    /// 0.5 of 1:2
    pub scale: f64,
    /// mm of a unit of the model, as used
    pub unit_mm: f64,
    /// "1:2"
    pub scale_text: [c_char; 64],
    /// "a3", "297 x 210"
    pub paper: [c_char; 64],
}

extern "C" {
    pub fn hrbfnpr_views_info_init(
        info: *mut hrbfnpr_views_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Draws the first part of a picture, which has a model, as a sheet of views; a picture made
    /// with SURFACE_ONLY is
    /// enough.  desc, info and operation may be NULL.  The picture gets stages LINES and VIEWS,
    /// and notes UNIT_IS_METRE,
    /// NO_SYMMETRY and SECTION_OPEN.
    /// Errors: INVALID_ARGUMENT (a picture of a point set; a text that is not understood; a plane
    /// that misses the model;
    /// views that have no room on the paper at the scale: the message says which scale or paper
    /// has), and those of
    /// hrbfnpr_line_set_create, hrbfnpr_renderer_draw and hrbfnpr_page_write.
    pub fn hrbfnpr_picture_write_views(
        picture: *mut hrbfnpr_picture,
        desc: *const hrbfnpr_views_desc,
        write: hrbfnpr_write_fn,
        user: *mut c_void,
        info: *mut hrbfnpr_views_info,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}
