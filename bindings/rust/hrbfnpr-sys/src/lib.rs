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
//!   exception: if one of the calls hrbfnpr_model_evaluate, _project, _curvature,
//!   _cast_rays and _contains, or hrbfnpr_field_evaluate, fails or is cancelled,
//!   it may already have written a part of its arrays.
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
//!   stays in memory; on Windows until the process ends.  Callbacks run only on the thread
//! that called the library,
//!   unless they are flagged thread-safe.  No call changes the caller's
//!   floating-point state, locale or OpenMP settings.
//!
//! Stacks.  Calls that fit a surface or find normals need a thread stack of
//!   512 KiB: hrbfnpr_model_fit, hrbfnpr_model_fit_mesh, hrbfnpr_orient,
//!   hrbfnpr_picture_create and hrbfnpr_source_inspect.  With `run_tasks` the
//!   threads that run their tasks need as much.  Every other call runs on 64 KiB;
//!   12 KiB of them are for the caller's own frames and callbacks.
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
//! another way (docs/how-lines-work.md gives the formula).  Trimming looks at the connected
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
//! # LINE SET: the lines of a model's surface; immutable
//!
//! A line set holds what the lines of one model are drawn from, for every camera.  Contours
//! are traced as curves on the
//! surface itself.  Their visibility is counted and checked (Appel 1967, quantitative
//! invisibility; Benard & Hertzmann
//! 2019).  Make a line set once for a model and give it to hrbfnpr_item.line_set.  An item
//! that has a line set, and a
//! style that lists `lines`, is drawn with curves.  The method is described in docs/how-lines-work.md.
//!
//! # FIELDS: values on a surface; immutable
//!
//! A field gives each place of a surface a value and a weight.  The value is a number, a
//! colour or a direction.  The
//! weight is 0 where the field says nothing, and up to 1.  Values come from points or a mesh,
//! from a function, from dabs
//! of a brush, or from an image that is projected along a camera.
//!
//! A field sets where marks are made (hrbfnpr_layer_desc).  hrbfnpr_point_set_with_fields
//! keeps its values at the marks
//! of a set, and a layer's style says what they change.
//!
//! # RENDERER: from items and a camera to a drawing [NPAR 6]
//!
//! A renderer is the scratch memory of one thread.  It keeps a few of its last drawings, and
//! makes the next one in the
//! memory of a drawing that no one else holds.  So a program that releases each drawing
//! before it makes the next but one
//! allocates nothing after a few frames, unless lines are drawn.  The point sets of the last
//! drawing stay alive until
//! the next one is made or the renderer is released.
//!
//! # DRAWING: a picture as a value; immutable
//!
//! A drawing holds dots and strokes in window coordinates.  They are in layers of one ink and
//! one class each.  The id of
//! a mark is 1 + its number, counted over items and their layers in order.  All functions
//! that read a drawing may run on
//! several threads at the same time.  The context keeps the memory that they need, for the next call.
//!
//! ---- As an image ----------------------------------------------------------
//!
//! ---- As vertices ----------------------------------------------------------
//!
//! ---- As numbers for the marks of a set -------------------------------------
//!
//! ---- Picking ---------------------------------------------------------------
//!
//! # MESH: triangles, repaired; samples, fits and comparisons
//!
//! A mesh is immutable.  Making one repairs what can be repaired, and counts the repairs:
//! vertices at exactly the same
//! place are joined; triangles without area and repeated triangles are left out; unused
//! vertices are dropped; the faces
//! of each component are turned to agree; and a closed component that is inside out is turned
//! as a whole.
//!
//! # PAGE: drawings as vectors: SVG, PDF, HPGL, G-code, DXF
//!
//! A page holds drawings, each at its place and scale, and texts and lines beside them.  Its
//! unit is the millimetre,
//! from the top-left corner, y down.  Strokes become cubic Bezier curves within a tolerance
//! of the drawing's lines
//! [Schneider 1990], or arcs of circles where they are such arcs.  For plotters they become
//! arcs and straight lines
//! within that tolerance.
//!
//! Ink is in named groups, the layers of a file.  The group of a layer of marks has that
//! layer's name, such as
//! "stipples" or "hatch-2".  Groups of lines are called "contour", "suggestive", "ridge",
//! "valley", "apparent ridge",
//! "parabolic", "isophote", "section", "border", "crease", "shadow", "terminator", "soft
//! edge", "intersection",
//! "tangent edge", or have the name of lines of kind OWN.  Ink behind n layers of surface has
//! " hidden n" at the end of
//! its name.  A second layer of the same name has " 2".
//!
//! Groups follow the layers of the drawing, hidden ones first.  In a group strokes are in
//! order from far to near.  Where
//! inks of several colours lie on each other, groups begin anew with ", run 2" at the end of
//! their names, up to 32 runs,
//! so that all ink is painted from far to near there.  In plot order there is one run, so
//! that each pen is taken up
//! once.  Names of pens do not include the run.
//!
//! The bytes of a page are the same for every thread count and locale.
//!
//! # PICTURE: from any source to a drawing in one call
//!
//! A picture chooses what a user leaves open: repairs, samples, the fit, where the surface
//! ends, which way is up, the
//! camera, the size of the pen, the number of marks, and the lines.  It is made by the calls
//! of the sections above, and
//! each of its parts can be taken out for these calls.
//!
//! Each choice that a user may want to know is a note: a code, its figures and a sentence.  A
//! picture keeps its notes,
//! and the seconds of its stages. docs/pictures.md shows how to make pictures.
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
//! # SHEETS: technical drawings in several views, to scale
//!
//! A sheet has orthographic views and sections of a model, with the line conventions of ISO
//! 128: outlines are thick,
//! hidden edges are thin and dashed, cut faces are hatched.  Views stand around the front
//! view [ISO 5456-2].  Sections
//! follow at the right, or below if they are seen from above.  Where lines coincide, the
//! first in this order is drawn:
//! outlines of cuts, visible edges, hidden edges, smooth edges [ISO 128-2].  The sheet has a
//! frame [ISO 5457], a title
//! block [ISO 7200] without a date, a scale bar, and arrows and letters at each cutting plane
//! [ISO 128-3].
//!
//! The model stands along the up axis of its picture.  Its front is +z, or -y where z is up.
//! Contours and outlines of
//! cuts are curves of the surface.  Sharp edges are those of the model, or of the mesh that
//! it was fitted to.
//!
//! Layers of the page have the name of their kind of lines and of their view, such as
//! "outlines front", "hidden top" or
//! "hatching A-A".  For plotters, pen 1 is the wide pen and pen 2 the fine one.
//! docs/technical.md shows sheets.
#![no_std]
#![allow(non_camel_case_types)]
#![allow(rustdoc::broken_intra_doc_links)] // [NPAR 4.1] is not a link

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
    /// UTF-8, zero-terminated; a message of more bytes is cut between two characters
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

// How the linear system of a fit is solved.  docs/how-fitting-works.md explains both ways.
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

/// What to fit: N points with N outward normals, and how.
/// docs/how-fitting-works.md explains the methods.
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
    /// kernel and the number of samples. More neighbours give fewer iterations and a slower setup
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
/// be wrong.  docs/how-fitting-works.md explains the method.
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
/// docs/how-fitting-works.md explains the method.
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
    /// lower corner of the samples' box. For up to 20 000 samples along curves, or 100 others, it
    /// also holds the surface, if that closes within a third of a diagonal
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
/// f or its gradient is not finite, or the gradient exceeds 1e150
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

/// The lines of one model, and its mesh.
#[repr(C)]
pub struct hrbfnpr_line_set {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A handle to triangles that have been repaired, see hrbfnpr_mesh_create.  It never changes.
#[repr(C)]
pub struct hrbfnpr_mesh {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

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
    /// a line set of this model, whose mesh the rays meet first; default NULL = rays are searched
    /// without a mesh. It is read only during the call
    pub line_set: *const hrbfnpr_line_set,
    /// 1 = the hits on the mesh are moved along their rays to f = 0; 0 = they stay on the mesh,
    /// with the mean normals of its corners. Used with line_set; default 1
    pub refine: u32,
    pub reserved2: u32,
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
    /// A call with a few thousand rays on a fit prepares the model, as hrbfnpr_model_evaluate
    /// does (docs/accuracy.md), and is 30 to 60 times as fast, unless lipschitz is given.
    /// It finds the same hits within the tolerance.  The last bits depend on whether n is
    /// enough for that, but not on the other rays or on earlier calls.
    ///
    /// With line_set, each ray first meets the mesh of the line set, whose box tree is made
    /// in the first such call.  Newton's method then moves the hits to f = 0, as
    /// hrbfnpr_model_evaluate computes it (refine 1).  On a fit of 5000 samples this is 5
    /// times as fast as the search, and 11 times with refine 0.  If a hit does not lead
    /// there within a cell of the mesh, its ray is searched as without a mesh.  Parts of the
    /// surface that the mesh does not have are missed: those smaller than a cell, and those
    /// where a ray passes between the surface and its mesh, near its outline.  lipschitz,
    /// smallest_step and evaluation_limit are used only for the rays that are searched.
    ///
    /// origins:      n x 3, FLOAT32 or FLOAT64, finite
    /// directions:   n x 3, FLOAT32 or FLOAT64, finite, of any length but 0
    /// desc:         NULL = all defaults
    /// hits:         the arrays that receive the results
    /// operation:    may be NULL
    ///
    /// Errors: INVALID_ARGUMENT: NaN, infinity, a zero direction, different counts of
    /// origins and directions, a direction so short that the t of a hit is infinite, or a
    /// line_set of another model.
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
    /// box.  A program that casts a few rays in each call should ask for the bound once and
    /// pass it on, because each such call without it evaluates these points.
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

/// A handle to values on a surface, see hrbfnpr_field_create.  It never changes.
#[repr(C)]
pub struct hrbfnpr_field {
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
/// the density of density_field
pub const HRBFNPR_DENSITY_FIELD: u32 = 3;

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
    /// SCALAR: the density of DENSITY_FIELD, clamped to 0 .. 1; 1 where the field has no value. A
    /// place with the weight w has 1 + w (value - 1); default NULL
    ///
    /// Fields, in the coordinates of the model.
    pub density_field: *const hrbfnpr_field,
    /// DIRECTION: the directions that lines of HATCH follow. Where its weight is below 0.5, lines
    /// follow the smoothest field between; default NULL. It excludes direction_function
    pub direction_field: *const hrbfnpr_field,
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
    /// R: number of cells of BOX on the largest side of the bounds; 1 to 256; default 8 [NPAR
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
    /// memory that the set keeps, with what it shares with other sets
    pub bytes: i64,
    /// number of fields whose values the set holds
    pub field_count: i64,
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
}

/// A field whose values marks get.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mark_field {
    pub struct_size: u32,
    pub reserved: u32,
    /// name for styles; UTF-8, 1 to 63 bytes, copied; not NULL
    pub name: *const c_char,
    /// where the values come from; default NULL = the set gets none of this name, and loses those
    /// that it has
    pub field: *const hrbfnpr_field,
    /// 16 doubles: object to field, column-major, affine and invertible; default NULL = the identity
    pub transform: *const f64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_mark_field_init(
        field: *mut hrbfnpr_mark_field,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Creates a point set that has the same marks as `set`, and values of fields for them.
    /// Values that `set` has stay,
    /// except those of a name in the list.  The marks are shared, not copied, and the fields may
    /// be released.  Values are
    /// saved and loaded with the set.  A hrbfnpr_shading of `set` is one of the new set, too.
    ///
    /// fields:      a list; no name occurs twice
    /// operation:   may be NULL
    ///
    /// Errors: INVALID_ARGUMENT (the set would have more than 64 fields).  CALLBACK (the function
    /// of a field failed).
    pub fn hrbfnpr_point_set_with_fields(
        context: *mut hrbfnpr_context,
        set: *const hrbfnpr_point_set,
        fields: *const hrbfnpr_mark_field,
        field_count: i64,
        field_stride: i64,
        operation: *mut hrbfnpr_operation,
        out_point_set: *mut *mut hrbfnpr_point_set,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets the name and the kind (HRBFNPR_FIELD_KIND_...) of a field of a set.  `number` is 0 ..
    /// hrbfnpr_point_set_info.field_count - 1.  `name` and `kind` may be NULL.  The name is valid
    /// while the set lives.
    pub fn hrbfnpr_point_set_get_field(
        set: *const hrbfnpr_point_set,
        number: i64,
        name: *mut *const c_char,
        kind: *mut u32,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gives views of the values that a field has at the marks of one layer, without a copy.
    /// They are valid while the set
    /// lives.
    ///
    /// values:      FLOAT32: one number for SCALAR, three for COLOUR and DIRECTION.  Count 0 =
    /// the layer has none
    /// weights:     FLOAT32: 0 .. 1 for each mark; count 0 = all are 1.  It may be NULL
    ///
    /// Errors: INVALID_ARGUMENT (no layer of the set has a field of this name).
    pub fn hrbfnpr_point_set_view_field(
        set: *const hrbfnpr_point_set,
        layer: i64,
        name: *const c_char,
        values: *mut hrbfnpr_array,
        weights: *mut hrbfnpr_array,
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

// 8  LINE SET: the lines of a model's surface; immutable

// Kinds of lines.  Kinds marked "once" are found when the line set is made, for each element of
// hrbfnpr_line_set_desc.lines.  BORDER and CREASE are found then, too, without an element.
// All others are found for
// every drawing, except SHADOW and TERMINATOR, which are found with a shading.  The strength
// says how marked a line is
// at a place.  It has no unit, because lengths are measured in diagonals of the model.
// Kinds marked WITH_CURVATURE
// need a line set with that flag.
/// occluding contours: the line of sight is tangent to the surface there
pub const HRBFNPR_LINE_KIND_CONTOUR: u32 = 1;
/// curves that become contours in a nearby view; WITH_CURVATURE. Strength: the derivative of
/// the radial curvature towards the eye [DeCarlo et al. 2003]
pub const HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR: u32 = 2;
/// convex ridges; once. Strength: the curvature across the ridge minus the absolute value of
/// the one along it [Ohtake, Belyaev & Seidel 2004]
pub const HRBFNPR_LINE_KIND_RIDGE: u32 = 3;
/// concave valleys; once. The strength is that of ridges
pub const HRBFNPR_LINE_KIND_VALLEY: u32 = 4;
/// extrema of the view-dependent curvature, which is also the strength; WITH_CURVATURE [Judd,
/// Durand & Adelson 2007]
pub const HRBFNPR_LINE_KIND_APPARENT_RIDGE: u32 = 5;
/// curves of Gaussian curvature 0; once
pub const HRBFNPR_LINE_KIND_PARABOLIC: u32 = 6;
/// curves on which n . l is one of the line style's `levels`, n the normal and l the
/// direction to the style's light; WITH_CURVATURE
pub const HRBFNPR_LINE_KIND_ISOPHOTE: u32 = 7;
/// cuts of the surface by parallel planes; once
pub const HRBFNPR_LINE_KIND_SECTION: u32 = 8;
/// curves where the surface ends: at the search box, or beyond the last samples
/// (hrbfnpr_line_set_desc.support)
pub const HRBFNPR_LINE_KIND_BORDER: u32 = 9;
/// polylines of the caller, such as creases of a mesh; once
pub const HRBFNPR_LINE_KIND_OWN: u32 = 10;
/// edges and grooves in which smooth sheets of the surface meet, in models that have them.
/// Strength: the angle between the normals of both sheets, in degrees. Where one sheet faces
/// the eye and the other faces away, the crease is part of the CONTOUR and is drawn as
/// CONTOUR
pub const HRBFNPR_LINE_KIND_CREASE: u32 = 11;
/// borders of the shadows that fall on the item, of lights with a shadow; for items whose
/// shading has HRBFNPR_SHADING_WITH_LINES. Strength: the light's `shadow`
pub const HRBFNPR_LINE_KIND_SHADOW: u32 = 12;
/// borders between light and shade where the item turns away from a light with a shadow, n .
/// l = 0, and nothing else shades the place; as SHADOW
pub const HRBFNPR_LINE_KIND_TERMINATOR: u32 = 13;
/// edges and folds that are round, such as the worn rim of a base; once. Strength: the angle
/// by which the surface turns within a few cells of the line, less the turns beside that, in
/// degrees. Organic bumps, limbs and noise have none. `fade` of a line style makes the line
/// narrower and not paler
pub const HRBFNPR_LINE_KIND_SOFT_EDGE: u32 = 14;
/// curves in which the surface of the item crosses that of another item with a line set. If
/// both items draw them, they are lines of the item with the smaller mesh cells. Parts of one
/// model meet in CREASEs. Strength: the mean angle between both surfaces along a curve, in
/// degrees; `upper` and `fade` have no effect
pub const HRBFNPR_LINE_KIND_INTERSECTION: u32 = 15;
/// edges of a part along which two surfaces touch without a kink, such as those of a fillet;
/// once. The caller gives them as polylines, as OWN. hrbfnpr_mesh_edges finds them in a mesh
pub const HRBFNPR_LINE_KIND_TANGENT_EDGE: u32 = 16;

/// Lines to find once, when the line set is made.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_line_desc {
    pub struct_size: u32,
    /// HRBFNPR_LINE_KIND_RIDGE, VALLEY, PARABOLIC, SECTION, OWN, SOFT_EDGE or TANGENT_EDGE; default RIDGE
    pub kind: u32,
    /// name by which hrbfnpr_line_style.name selects these lines; UTF-8, up to 63 bytes; default NULL = ""
    pub name: *const c_char,
    /// least strength at which a line goes on; 0 or more; default 0. If `lower` and `upper` are
    /// 0, it is 6 for ridges and valleys, 15 (degrees) for soft edges, and 0 for other kinds
    pub lower: f64,
    /// strength that a line must reach somewhere, or it is dropped; not below `lower`; default 0.
    /// If `lower` and `upper` are 0, it is 15 for ridges and valleys, 35 (degrees) for soft
    /// edges, and 0 for other kinds
    pub upper: f64,
    /// length below which a line is dropped, in diagonals; 0 or more; default 0.01
    pub shortest: f64,
    /// SECTION: normal of the planes, of any length but 0; default (0, 0, 1)
    pub plane: [f64; 3],
    /// SECTION: places of the planes along the unit normal, in units of the model; n x 1, FLOAT32
    /// or FLOAT64; at least one
    pub levels: hrbfnpr_array,
    /// OWN, TANGENT_EDGE: points of all lines, on the surface or near it; n x 3, FLOAT32 or FLOAT64
    pub position: hrbfnpr_array,
    /// OWN, TANGENT_EDGE: number of the first position of each line, ascending, then the end of
    /// the last line; n x 1, UINT32. A line whose last position equals its first is closed
    pub line_first: hrbfnpr_array,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_line_desc_init(desc: *mut hrbfnpr_line_desc, struct_size: u32) -> hrbfnpr_status;
}

// What a line set measures.
/// measures curvatures and their derivatives, which suggestive contours, apparent ridges and
/// isophotes need
pub const HRBFNPR_LINE_SET_WITH_CURVATURE: u32 = 1;

/// How a line set is made.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_line_set_desc {
    pub struct_size: u32,
    /// HRBFNPR_LINE_SET_WITH_...; default 0
    pub flags: u32,
    /// side of the cells in which curves are searched, in units of the model; 0 or more; default
    /// 0 = half the samples' spacing, and finer where walls are thin. Loops smaller than a cell
    /// and walls thinner than 1.75 cells may be missed
    pub cell_size: f64,
    /// points near each part of the surface, where the search begins; n x 3, FLOAT32 or FLOAT64;
    /// not given = the samples, or places found within the bounds of a custom model
    pub seed_points: hrbfnpr_array,
    /// a list of lines to find once; default NULL
    pub lines: *const hrbfnpr_line_desc,
    /// number of `lines`; default 0
    pub line_count: i64,
    /// bytes from one element of `lines` to the next; default 0 = struct_size
    pub line_stride: i64,
    /// limit of s(x), as in hrbfnpr_trim_desc, beyond which the surface ends because samples are
    /// missing, as in an open scan or a terrain; 0 or more; default 0 = the surface ends where
    /// its model does: trimmed, or at the search box. The mesh and all curves end there, what
    /// lies beyond hides nothing, and the end is a BORDER. 1.5 ends the surface about 0.7 sample
    /// spacings beyond the last samples; 3 ends it about 0.9 spacings beyond them, and leaves
    /// larger holes closed
    pub support: f64,
    /// samples that `support` is measured from; n x 3, FLOAT32 or FLOAT64; not given = the
    /// model's centres. All points of a scan show where it ends better than the centres chosen
    /// from them
    pub support_points: hrbfnpr_array,
    /// normals of support_points, as many, of any length but 0; n x 3, FLOAT32 or FLOAT64; not
    /// given = normals of the surface there
    pub support_normals: hrbfnpr_array,
    /// the mesh that the model was fitted to; default NULL. Its triangles find lines where walls
    /// are thinner than cells. The line set does not keep it. Ignored with a cell_size, and if it
    /// has edges that are not manifold or whose faces do not agree
    pub mesh: *const hrbfnpr_mesh,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_line_set_desc_init(
        desc: *mut hrbfnpr_line_set_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Makes the line set of a model.  The line set keeps the model alive.  `desc` may be NULL
    /// for the defaults, and
    /// `operation` may be NULL.
    /// Errors: INVALID_ARGUMENT (a field of `desc`; more than 4 000 000 triangles: give a larger
    /// cell_size; a support
    /// without samples), NOT_CONVERGED (no surface was found, or none near its samples),
    /// OUT_OF_MEMORY, CANCELLED,
    /// CALLBACK.
    pub fn hrbfnpr_line_set_create(
        context: *mut hrbfnpr_context,
        model: *const hrbfnpr_model,
        desc: *const hrbfnpr_line_set_desc,
        operation: *mut hrbfnpr_operation,
        out_line_set: *mut *mut hrbfnpr_line_set,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_line_set_retain(line_set: *const hrbfnpr_line_set);
    /// Releases a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_line_set_release(line_set: *const hrbfnpr_line_set);
}

/// What making a line set found.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_line_set_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// triangles of the mesh on which curves are searched
    pub triangles: i64,
    /// triangles of that mesh that face away from the surface. The surface is finer than the
    /// cells there, and curves may be missed
    pub turned: i64,
    /// seeds that no triangle is near. A part of the surface is too thin for the cells there
    pub missed_seeds: i64,
    /// lines that were found once, for all elements of the list
    pub lines: i64,
    /// curves where the surface ends
    pub borders: i64,
    /// side of the cells as used, in units of the model
    pub cell_size: f64,
    /// time that it took to make the line set
    pub seconds: f64,
    /// memory that the line set keeps
    pub bytes: i64,
    /// share of the examined area that lies beyond the samples, 0 .. 1; 0 without a support.
    /// Little is examined beyond the end of a trimmed model: see its trim info
    pub left_out: f64,
    /// creases at any angle, each from corner to corner or closed
    pub creases: i64,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_line_set_info_init(
        info: *mut hrbfnpr_line_set_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Gets what making a line set found.
    pub fn hrbfnpr_line_set_get_info(
        line_set: *const hrbfnpr_line_set,
        info: *mut hrbfnpr_line_set_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 9  CAMERA AND STYLE: plain data

// How depth runs from the near plane to the far plane.
/// clip depth from -1 to 1, as in OpenGL; window depth from 0 to 1
pub const HRBFNPR_DEPTH_NEGATIVE_ONE_TO_ONE: u32 = 0;
/// clip and window depth from 0 to 1, as in Direct3D, Vulkan and Metal
pub const HRBFNPR_DEPTH_ZERO_TO_ONE: u32 = 1;
/// clip and window depth from 1 at the near plane to 0 at the far plane
pub const HRBFNPR_DEPTH_REVERSED: u32 = 2;

/// A camera: two matrices and a viewport.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_camera {
    pub struct_size: u32,
    /// depth of `projection` and of depth buffers, HRBFNPR_DEPTH_...; default NEGATIVE_ONE_TO_ONE
    pub depth_convention: u32,
    /// world to eye, column-major, invertible; the eye looks along -z; default the identity
    pub view: [f64; 16],
    /// eye to clip, column-major, invertible; default the identity
    pub projection: [f64; 16],
    /// x and y of the top-left corner, width and height, in pixels; up to 1048576 each; default 0
    /// x 0, which drawing refuses
    pub viewport: [f64; 4],
}

extern "C" {
    /// Sets struct_size, identity matrices and a viewport of 0 x 0.
    pub fn hrbfnpr_camera_init(camera: *mut hrbfnpr_camera, struct_size: u32) -> hrbfnpr_status;
    /// Sets `view` so that the camera looks from `eye` towards `target`, with `up` roughly upward
    /// in the picture; 3 doubles
    /// each.
    /// Errors: INVALID_ARGUMENT (eye and target are the same; `up` is 0 or parallel to the view;
    /// a number is not finite).
    pub fn hrbfnpr_camera_look_at(
        camera: *mut hrbfnpr_camera,
        eye: *const f64,
        target: *const f64,
        up: *const f64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Sets a perspective `projection`, and the viewport's width and height in pixels.
    /// `vertical_angle` is the vertical
    /// angle of view in radians, in (0, pi).  The planes are distances from the eye, 0 <
    /// near_plane < far_plane.
    /// Errors: INVALID_ARGUMENT (an argument is out of range).
    pub fn hrbfnpr_camera_perspective(
        camera: *mut hrbfnpr_camera,
        vertical_angle: f64,
        width: f64,
        height: f64,
        near_plane: f64,
        far_plane: f64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Sets an orthographic `projection`, and the viewport's width and height in pixels.
    /// `view_height` is the height of
    /// what is seen, in world units, above 0. near_plane < far_plane; either may be negative.
    /// Errors: INVALID_ARGUMENT (an argument is out of range).
    pub fn hrbfnpr_camera_orthographic(
        camera: *mut hrbfnpr_camera,
        view_height: f64,
        width: f64,
        height: f64,
        near_plane: f64,
        far_plane: f64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Sets view, projection and viewport so that a box fills the picture.  `direction` points
    /// from the eye into the scene,
    /// `up` roughly upward in the picture; 3 doubles each.  `vertical_angle` is in radians, in
    /// [0, pi); 0 = orthographic.
    /// `width` and `height` are in pixels.  `margin` is the share of the picture that stays free
    /// on each side, 0 .. 0.45.
    /// Errors: INVALID_ARGUMENT (an argument is out of range; `up` is parallel to the direction).
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
    /// Sets view, projection and viewport so that points fill the picture, and lie in its middle.
    /// It fits the points
    /// themselves, not the corners of their box.  `points` is n x 3, FLOAT32 or FLOAT64, n >= 1.
    /// `origin` (3 doubles, NULL
    /// = 0) is added to each point: with a point set's POSITION give the origin of its info.  The
    /// other arguments are those
    /// of hrbfnpr_camera_fit_bounds.
    /// Errors: INVALID_ARGUMENT (no points; a number is not finite; as for hrbfnpr_camera_fit_bounds).
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

// How ink is drawn that lies behind a depth layer of surface.
/// ink is seen faintly through the surface in front of it [NPAR 6.1]
pub const HRBFNPR_HIDDEN_LINES_ATTENUATE: u32 = 0;
/// ink behind a nearer depth layer is not drawn
pub const HRBFNPR_HIDDEN_LINES_HIDE: u32 = 1;
/// ink is drawn as if nothing were in front of it: lambda is 0
pub const HRBFNPR_HIDDEN_LINES_SHOW: u32 = 2;

// How the marks that a surface hides are found.
/// Depth layers of surface are found from the marks.  The ink of each mark is multiplied by
/// the transmittance of the
/// layers in front of it.  A depth layer never dims its own ink.  The picture does not depend
/// on the number of
/// marks.
pub const HRBFNPR_VISIBILITY_DEPTH_LAYERS: u32 = 0;
/// Marks paint discs of paper and of ink from far to near, as published [NPAR 6.1].
pub const HRBFNPR_VISIBILITY_PUBLISHED: u32 = 1;

// How many marks a tone shows.
/// The ink covers the share 1 - tau of the paper.  The number of marks follows from their
/// size, their density in the
/// picture and their overlap, so that the tone stays when the zoom or the budget changes.  If
/// all marks together
/// cover less than 0.6, all of them are shown where 0.6 is asked for, and fewer in proportion
/// where less is asked
/// for.
pub const HRBFNPR_TONE_CURVE_COVERAGE: u32 = 0;
/// the share of marks that is shown is 1 - tau [NPAR 6.2]
pub const HRBFNPR_TONE_CURVE_LINEAR: u32 = 1;

// Where stipples are evenly spread, with TONE_RULE_SHARE, TONE_CURVE_COVERAGE and
// DEPTH_LAYERS.  It has an effect on
// stipples of DISTRIBUTION_BLUE_NOISE.
/// In the picture.  Where the surface turns away, marks that are even on it would form rows.
/// So more marks than the
/// tone wants are considered there, in their order, and each gets smaller as far as earlier
/// ones are too near in
/// the picture.  Marks keep their places on the surface, change smoothly as the camera moves,
/// and never get smaller
/// by a zoom in.  docs/how-marks-work.md
pub const HRBFNPR_EVENNESS_PICTURE: u32 = 0;
/// On the surface: the first marks of the order are shown.  For drawings that show the same
/// marks by other means,
/// such as the prefixes of a vertex buffer.
pub const HRBFNPR_EVENNESS_SURFACE: u32 = 1;

// What the tone tau of a front mark comes from: 1 = light, 0 = dark.
/// tau = 0: all front marks are shown
pub const HRBFNPR_TONE_NONE: u32 = 0;
/// tau = max(0, n . l)^tone_exponent [NPAR 6.2], and fill_light on the unlit side
pub const HRBFNPR_TONE_LIGHT: u32 = 1;
/// tau is what tone_function returns
pub const HRBFNPR_TONE_CALLBACK: u32 = 2;

// Which front marks are shown. u is the rank of a mark, tau its tone, tau_d the tone of its
// distance (depth_min,
// depth_max), scale that of its zoom (zoom_reference), and share that of the layer style.
/// A mark is shown if u >= 1 - (1 - tau) * tau_d * scale * share.  All effects thin the same
/// order of marks, so that
/// a blue-noise order stays one.
pub const HRBFNPR_TONE_RULE_SHARE: u32 = 0;
/// A mark is shown if it passes each test, as published: u >= tau, u < tau_d, u < scale, u <
/// share [NPAR 6.2].
pub const HRBFNPR_TONE_RULE_PUBLISHED: u32 = 1;

// The space in which the direction to the light, or its place, is given.
/// world space: the light stays where it is when the camera moves
pub const HRBFNPR_LIGHT_WORLD: u32 = 0;
/// eye space: the light moves with the camera
pub const HRBFNPR_LIGHT_CAMERA: u32 = 1;
/// object space: the light moves with the item
pub const HRBFNPR_LIGHT_ITEM: u32 = 2;

// Where a light comes from.
/// from far away, everywhere from the same direction
pub const HRBFNPR_LIGHT_KIND_DIRECTIONAL: u32 = 0;
/// from a place; its strength does not fall with the distance
pub const HRBFNPR_LIGHT_KIND_PLACE: u32 = 1;

/// A light of a style.  It adds intensity * max(0, n . l)^tone_exponent to the light of a
/// mark, where l is the unit
/// vector to the light.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_light {
    pub struct_size: u32,
    /// where it comes from, HRBFNPR_LIGHT_KIND_...; default DIRECTIONAL
    pub kind: u32,
    /// space of `place`, HRBFNPR_LIGHT_...; default CAMERA
    pub space: u32,
    /// 0 .. 16; default 1 = a surface that faces the light is white
    pub intensity: f32,
    /// share of its light that cast shadows take away, 0 .. 1; default 0 = it casts none. It has
    /// an effect on items with a shading
    pub shadow: f32,
    /// radius of the light as it is seen from the surface, in radians, 0 .. 0.5; default 0 =
    /// shadows with sharp borders; the sun has 0.0047
    pub softness: f32,
    /// DIRECTIONAL: the direction to the light, of any length but 0; PLACE: the place; default
    /// (-0.4, 0.6, 0.7)
    pub place: [f64; 3],
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_light_init(light: *mut hrbfnpr_light, struct_size: u32) -> hrbfnpr_status;
}

/// Computes the tone of many places, by any illumination model.  It fills `tau` (count
/// floats, 1 = light, 0 = dark) from
/// world positions and unit normals (count x 3 floats each).  The normals are TONE_NORMAL if
/// the layer has them.  Values
/// are clamped to [0, 1].  It runs on the thread that called _draw.  A result other than 0,
/// or a NaN in `tau`, makes
/// that call fail with CALLBACK.
pub type hrbfnpr_tone_fn = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        count: i64,
        positions: *const f32,
        normals: *const f32,
        tau: *mut f32,
    ) -> i32,
>;

// How the front marks of a layer of strokes are drawn.  Layers without strokes are always
// dots, and so is everything
// with VISIBILITY_PUBLISHED.
/// each mark is a dot
pub const HRBFNPR_SHAPE_DOTS: u32 = 0;
/// consecutive marks of a stroke that are shown form one line, with their width and opacity.
/// A single mark is a dot
pub const HRBFNPR_SHAPE_STROKES: u32 = 1;
/// strokes are curves that are drawn where the tone is dark enough, and their width makes the
/// tone. The hatch_ fields of hrbfnpr_layer_style apply. Lines are nested: those of level k
/// lie midway between those of lower levels. As many levels are drawn as the picture has room
/// for, so that the tone does not depend on the zoom. Points of a line have the id of the
/// nearest mark. A stroke whose ends meet is closed [Winkenbach & Salesin 1994; Praun et al.
/// 2001]
pub const HRBFNPR_SHAPE_HATCH: u32 = 2;

// What tone_field does to the tone.
/// the tone becomes the value
pub const HRBFNPR_FIELD_RULE_REPLACE: u32 = 0;
/// the tone is multiplied by the value
pub const HRBFNPR_FIELD_RULE_SCALE: u32 = 1;

// Which inks of a palette the marks of an ink_field take.
/// each mark takes the ink that is nearest to its colour [Oklab, Ottosson 2020]
pub const HRBFNPR_PALETTE_NEAREST: u32 = 0;
/// neighbouring marks take the two or three inks whose mean has the colour's hue
pub const HRBFNPR_PALETTE_MIXED: u32 = 1;

/// How layers of marks are drawn.  Colours are straight RGBA in [0, 1], sRGB-encoded.
/// Lengths in pixels are those of
/// the picture.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_layer_style {
    pub struct_size: u32,
    /// kind of the layers that this style is for, HRBFNPR_LAYER_KIND_...; default ANY
    pub kind: u32,
    /// name of the layers that this style is for; default NULL = any name. It is read during _draw only
    pub name: *const c_char,
    /// 1 or 0: whether front marks are drawn; default 1
    pub shown: u32,
    /// 1 or 0, with VISIBILITY_PUBLISHED: whether marks near a contour draw it; default 1.
    /// Strokes of kind OWN never do, as they may be few. If `shown` is 0 and this is 1, the layer
    /// still hides what lies behind its surface; if both are 0, it takes no part
    pub contours: u32,
    /// which strokes are drawn: bit 0 the first direction, bit 1 the second; default 3
    pub directions: u32,
    /// shape of front marks, HRBFNPR_SHAPE_...; default DOTS
    pub shape: u32,
    /// share of the layer's marks that is used at all, 0 .. 1; default 1. Less makes the layer paler
    pub share: f32,
    /// radius of a mark, and half the width of a stroke, in pixels; above 0, up to 16384; default 1
    pub radius: f32,
    /// how the radius follows the zoom, relative to zoom_reference of the style; 0 .. 1; default
    /// 0 = the radius stays the same in pixels; 1 = it grows with the zoom
    pub radius_zoom: f32,
    pub reserved: u32,
    /// colour of the ink, straight RGBA; default black
    pub ink: [f32; 4],
    /// darkness, 1 - tau, at which lines begin; 0 .. 1; default 0.15. Larger: lights are emptier.
    /// See also hatch_fade
    ///
    /// SHAPE_HATCH.  Lines cover a share of the paper that grows with the darkness, 1 - tau.
    pub hatch_tone_begin: f32,
    /// darkness, 1 - tau, from which on lines get no wider; above hatch_tone_begin, up to 1; default 0.95
    pub hatch_tone_end: f32,
    /// share of the paper that lines cover at hatch_tone_begin, times `share`; above 0, up to 1;
    /// default 0.1
    pub hatch_coverage_begin: f32,
    /// share of the paper that lines cover at hatch_tone_end, times `share`; above 0, up to 1;
    /// default 0.82. Lines of unknown separation have the width 2 * radius there
    pub hatch_coverage_end: f32,
    /// least distance from line to line, in pixels; above 0, up to 16384; default 4.6. Larger:
    /// fewer, wider lines
    pub hatch_spacing: f32,
    /// least width of a line, in pixels; above 0, up to 16384; default 0.6. Lines are thinner
    /// only where they fade in or end, or are closer together than hatch_spacing
    pub hatch_pen: f32,
    /// least width of the paper between lines, in pixels; 0 .. 16384; default 1.2
    pub hatch_white: f32,
    /// length over which a line narrows where its tone ends, in pixels; 0 .. 16384; default 20.
    /// Where it ends for another reason, it narrows over a shorter length
    pub hatch_taper: f32,
    /// length below which a piece of a line is not drawn, in pixels; 0 .. 16384; default 10.
    /// Pieces up to twice this length are thinner
    pub hatch_shortest: f32,
    pub reserved2: u32,
    /// how far a line strays to either side, as if drawn by an unsteady hand, in multiples of
    /// hatch_pen; 0 .. 16; default 0. A swing covers about 60 hatch_pen
    pub hatch_wobble: f32,
    /// greatest length by which a line runs on past the end of its tone, in pixels; 0 .. 16384;
    /// default 0. Each end has another length
    pub hatch_overshoot: f32,
    /// seed of hatch_wobble, hatch_overshoot and hatch_fade; any number; default 0
    pub hatch_seed: u32,
    pub reserved3: u32,
    /// SCALAR: the share of marks that is shown is multiplied by the value, clamped to 0 .. 1.
    /// With SHAPE_HATCH, the darkness is multiplied
    ///
    /// Fields of the point set, by name (hrbfnpr_point_set_with_fields).  They are read during
    /// _draw only; default
    /// NULL = none.  A value v with the weight w changes what it acts on from x to x + w (v' -
    /// x), where v' is what v
    /// alone gives.  Layers without values of a field are drawn without it.  If no layer of a set
    /// has it, drawing fails
    /// with INVALID_ARGUMENT.  Fields have no effect with VISIBILITY_PUBLISHED.
    pub density_field: *const c_char,
    /// SCALAR: changes the tone tau, 1 = light, 0 = dark, as tone_field_rule says. REPLACE clamps
    /// the value to 0 .. 1, SCALE to 0 .. 16, and the result is clamped to 0 .. 1
    pub tone_field: *const c_char,
    /// SCALAR: radii and widths are multiplied by the value, clamped to 0 .. 16; 0 leaves marks out
    pub width_field: *const c_char,
    /// COLOUR: each mark takes an ink of the style's palette, as palette_rule says. Marks with a
    /// weight below 0.5 take `ink`. Strokes are cut where their ink changes, except that parts
    /// shorter than twice their width take the ink of the part before
    pub ink_field: *const c_char,
    /// SCALAR: marks with a value below 0.5 are left out, and strokes end there
    pub mask_field: *const c_char,
    /// HRBFNPR_FIELD_RULE_...; default REPLACE
    pub tone_field_rule: u32,
    /// HRBFNPR_PALETTE_...; default NEAREST
    pub palette_rule: u32,
    /// range of darkness below hatch_tone_begin over which lines end one after the other; 0 .. 1,
    /// counted up to hatch_tone_begin; default 0 = all lines end at hatch_tone_begin. Over this
    /// range the share of the paper that lines cover falls evenly to 0: lines become fewer, and
    /// break before they end. Places with a darkness of 0 stay empty. Larger: lights are less
    /// empty
    ///
    /// SHAPE_HATCH
    pub hatch_fade: f32,
    pub reserved4: u32,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_layer_style_init(
        style: *mut hrbfnpr_layer_style,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

// How the parts of a line that surface hides are drawn.  A layer of surface is two sheets.
/// hidden parts are not drawn
pub const HRBFNPR_HIDDEN_PARTS_NONE: u32 = 0;
/// hidden parts get paler with each layer of surface in front of them
pub const HRBFNPR_HIDDEN_PARTS_ATTENUATED: u32 = 1;
/// hidden parts are dashed; the more layers lie in front, the shorter the dashes
pub const HRBFNPR_HIDDEN_PARTS_DASHED: u32 = 2;
/// hidden parts are drawn like visible ones
pub const HRBFNPR_HIDDEN_PARTS_SHOWN: u32 = 3;

// The shape of a free end of a line: one that meets no other line in the picture, such as a
// cusp, where a contour turns
// behind its own surface.
/// half a disc beyond the end
pub const HRBFNPR_CAP_ROUND: u32 = 0;
/// cut off straight at the end
pub const HRBFNPR_CAP_FLAT: u32 = 1;
/// a tip, whose length is twice the width of the line there
pub const HRBFNPR_CAP_POINTED: u32 = 2;

// Which creases are drawn.
/// all creases
pub const HRBFNPR_CREASES_ALL: u32 = 0;
/// convex creases: edges
pub const HRBFNPR_CREASES_CONVEX: u32 = 1;
/// concave creases: grooves, and where something stands on a face
pub const HRBFNPR_CREASES_CONCAVE: u32 = 2;

/// How the lines of one kind are drawn, for items that have a line set.  Lengths are in
/// pixels unless a field says
/// otherwise.  Of two contours, borders, creases, intersections, ridges, valleys, suggestive
/// contours, apparent ridges
/// or tangent edges of one ink that run side by side, nearer than a pen, only one keeps its
/// width, and the other narrows
/// and ends: the one of the later kind in this list, or the thinner, or the shorter.  Items
/// whose halo_width is 0 keep
/// all their lines.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_line_style {
    pub struct_size: u32,
    /// kind of lines that this style is for, HRBFNPR_LINE_KIND_...; default CONTOUR
    pub kind: u32,
    /// name (hrbfnpr_line_desc.name) of the lines found once that this style is for; default NULL
    /// = any name. It is read during _draw only
    pub name: *const c_char,
    /// how hidden parts are drawn, HRBFNPR_HIDDEN_PARTS_...; default NONE
    pub hidden: u32,
    /// shape of free ends, HRBFNPR_CAP_...; default ROUND
    pub cap: u32,
    /// width of a line, in pixels; above 0, up to 16384; default 2
    pub width: f32,
    /// length over which a line narrows to a free end, as half an ellipse, in pixels; 0 .. 16384;
    /// default 12; 0 = it does not narrow. A part with a free end that is shorter than two tapers
    /// is thinner the shorter it is
    pub taper: f32,
    /// width of ATTENUATED and DASHED parts, in pixels; above 0, up to 16384; default 1.2
    pub hidden_width: f32,
    /// factor of the opacity of ATTENUATED parts for each layer in front, 0 .. 1; default 0.35
    pub hidden_opacity: f32,
    /// length of a dash of DASHED parts, in hidden_widths; above 0, up to 16384; default 5
    pub dash: f32,
    /// length of a gap between dashes, in hidden_widths; above 0, up to 16384; default 3
    pub gap: f32,
    /// length below which parts with a free end, and hidden parts, are not drawn, in pixels; 0 ..
    /// 16384; default 2. Feature lines that are found for every drawing have a length of at least
    /// 0.01 diagonals in any case
    pub shortest: f32,
    /// how much paler a line is where its strength is `lower` than where it is `upper`, 0 .. 1;
    /// default 1; 0 = it does not fade
    pub fade: f32,
    /// least strength at which a line goes on, as in hrbfnpr_line_desc; 0 or more; default 0. If
    /// `lower` and `upper` are 0, it is 10 for suggestive contours, 12 for apparent ridges, 15
    /// (degrees) for creases, 15 (degrees) for soft edges, 2 (degrees) for intersections, and 0
    /// for other kinds
    pub lower: f64,
    /// strength that a line must reach somewhere to be drawn; 0 or more; default 0. If `lower`
    /// and `upper` are 0, it is 30 for suggestive contours, 25 for apparent ridges, 30 (degrees)
    /// for creases, 35 (degrees) for soft edges, and 0 for other kinds
    pub upper: f64,
    /// values of n . l at which an ISOPHOTE lies; n x 1, FLOAT64, packed, -1 .. 1; at least one
    /// for ISOPHOTE. It is read during _draw only
    pub levels: hrbfnpr_array,
    /// colour of the ink, straight RGBA; default black
    pub ink: [f32; 4],
    /// factor of the width of CONTOUR and BORDER where nothing lies beside the line on its outer
    /// side: on the outline of all items that have lines; 0 .. 16; default 1. Beyond the ends of
    /// the outline it changes to 1 over 6 widths. All factors that apply to a place are
    /// multiplied
    ///
    /// Laws of the width: factors of `width`, 0 .. 16; 1 = no effect.  All that apply to a place
    /// are multiplied.  They
    /// follow the distance in the picture between a contour and an isophote [Goodwin et al. 2007].
    pub outline_factor: f32,
    /// factor of the width at the farthest place of the surfaces of all items that have lines, in
    /// the viewport; 0 .. 16; default 1. It is 1 at the nearest place, and changes evenly with
    /// depth. If the surfaces reach less deep than half of their extent across the line of sight,
    /// it changes as if they reached so deep
    pub far_factor: f32,
    /// factor of the width where the surface faces the style's light, whatever its tone; 0 .. 16;
    /// default 1. It is 1 where the surface faces away, and changes evenly with n . l
    pub lit_factor: f32,
    /// factor of the width where the surface bends sharply; 0 .. 16; default 1. It is 1 where the
    /// radius of curvature is curvature_radius or more, and changes evenly with the radius. For
    /// CONTOUR it is the radial curvature, along the line of sight; for other kinds it is the
    /// normal curvature across the line
    pub curvature_factor: f32,
    /// radius of curvature from which on curvature_factor has no effect, in diagonals; above 0;
    /// default 0.1
    pub curvature_radius: f32,
    /// how far a line strays to either side, in widths; 0 .. 16; default 0
    ///
    /// An unsteady hand.  It is the same in each drawing and, as lengths are in widths, at each
    /// size of the picture.
    pub wobble: f32,
    /// share by which the width of a line varies; 0 .. 1; default 0
    pub wobble_width: f32,
    /// approximate length from swing to swing, in widths; 1 .. 16384; default 40
    pub wobble_length: f32,
    /// seed of the wobble; any number; default 0
    pub wobble_seed: u32,
    /// which lines of the kinds CREASE and SOFT_EDGE are drawn, HRBFNPR_CREASES_...; default ALL
    pub creases: u32,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_line_style_init(
        style: *mut hrbfnpr_line_style,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// How an item is drawn. docs/presets.md shows named styles, and docs/how-marks-work.md
/// explains the method.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_style {
    pub struct_size: u32,
    /// source of the tone, HRBFNPR_TONE_...; default LIGHT
    pub tone: u32,
    /// colour of the paper, straight RGBA; default white; alpha 0 = transparent. It must be the
    /// same in all styles of a drawing
    pub paper: [f32; 4],
    /// a list of layer styles; default NULL. A layer of marks takes the first that is for it, or
    /// else the defaults of hrbfnpr_layer_style_init
    pub layers: *const hrbfnpr_layer_style,
    /// number of `layers`; default 0
    pub layer_count: i64,
    /// bytes from one element of `layers` to the next; default 0 = struct_size
    pub layer_stride: i64,
    /// which marks are shown, HRBFNPR_TONE_RULE_...; default SHARE
    ///
    /// Tone.
    pub tone_rule: u32,
    /// how many marks a tone shows, HRBFNPR_TONE_CURVE_...; default COVERAGE. Only for TONE_RULE_SHARE
    pub tone_curve: u32,
    /// direction to the light, of any length but 0 where a light is used; default (-0.4, 0.6, 0.7)
    pub light: [f64; 3],
    /// lambda, the exponent of the tone law; above 0; default 1. Larger: the picture gets darker
    pub tone_exponent: f64,
    /// tone of TONE_CALLBACK; default NULL
    pub tone_function: hrbfnpr_tone_fn,
    /// passed to tone_function; default NULL
    pub tone_user: *mut c_void,
    /// space of `light`, HRBFNPR_LIGHT_...; default CAMERA
    pub light_space: u32,
    /// share of the shown marks over which a mark grows from nothing to its full area, 0 .. 1;
    /// default 0.25; 0 = marks pop in. With DEPTH_LAYERS only
    pub tone_fade: f32,
    /// delta, which separates classes with PUBLISHED, in (0, 1); default 0.2. A mark is front if
    /// n . v < -delta, back if n . v > delta, else silhouette, where v points from the camera to
    /// the mark [NPAR 6]. Larger: wider contours
    ///
    /// Contours made of marks, with VISIBILITY_PUBLISHED.  With DEPTH_LAYERS contours are lines
    /// of an item's line
    /// set.
    pub silhouette_threshold: f64,
    /// radius of a silhouette mark, in pixels, with PUBLISHED; above 0, up to 16384; default 1
    pub silhouette_radius: f32,
    /// how silhouette_radius follows the zoom, as radius_zoom of hrbfnpr_layer_style; 0 .. 1; default 0
    pub silhouette_radius_zoom: f32,
    /// colour of silhouette marks, straight RGBA, with PUBLISHED; default black
    pub silhouette_ink: [f32; 4],
    /// how hidden marks are found, HRBFNPR_VISIBILITY_...; default DEPTH_LAYERS. It must be the
    /// same in all styles of a drawing
    ///
    /// Hidden lines.
    pub visibility: u32,
    /// how hidden ink is drawn, HRBFNPR_HIDDEN_LINES_...; default ATTENUATE
    pub hidden_lines: u32,
    /// lambda of alpha_f = nu^2 lambda, the opacity of surface that faces the eye, nu = n . v; 0
    /// or more; default 1. Larger: hidden ink is paler
    pub attenuation_front: f64,
    /// lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda, the opacity of surface that faces
    /// away; 0 or more; default 1. Larger: hidden ink is paler
    pub attenuation_back: f64,
    /// radius of the splat, the disc of surface around a mark, in pixels; 0 .. 16384; default 0 =
    /// from the marks' spacing in the picture
    pub splat_radius: f32,
    /// number n of splats that overlap in a depth layer, whose opacity is 1 - (1 - alpha)^n
    /// whatever the marks' density and the zoom; 0 .. 1e6; default 8; 0 = each mark paints with
    /// alpha itself, as published. Larger: hidden ink is paler
    pub splat_overlap: f32,
    /// width of the halo, in pixels at any zoom; 0 .. 16384; default 2. With DEPTH_LAYERS a
    /// surface hides what lies behind it up to this far beyond its contour; if it is above 0,
    /// lines that run beside others, nearer than a pen, are thinned (docs/lines.md). With
    /// PUBLISHED it is added to the radius of the paper of back marks
    pub halo_width: f32,
    /// 1 or 0; default 0. 1: rays from the eye are compared with all parts of the item's lines,
    /// and wrong parts are repaired; hrbfnpr_drawing_info has the counts (docs/lines.md)
    pub verify_lines: u32,
    /// distance from the camera at which marks begin to vanish, in world units; default 0. Either
    /// 0 < depth_min < depth_max, or both are 0 and distance has no effect. Between the two the
    /// share of marks falls with the logarithm of the distance
    ///
    /// Distance and zoom.
    pub depth_min: f64,
    /// distance from the camera from which on nothing is shown, in world units; above depth_min;
    /// default 0 = no effect
    pub depth_max: f64,
    /// pixels per world unit from which on all marks are shown; 0 or more; default 0 = no effect.
    /// Below it the share zoom^zoom_exponent of the marks is shown, where zoom is the pixels per
    /// world unit at a mark divided by this. The area of the paper of back marks scales alike
    /// [NPAR 6.2]
    pub zoom_reference: f64,
    /// exponent of the zoom, 0 or more; default 2, which keeps the ink per area
    pub zoom_exponent: f64,
    /// a list of line styles; default NULL = no lines
    ///
    /// Lines of items that have a line set, with DEPTH_LAYERS.
    pub lines: *const hrbfnpr_line_style,
    /// number of `lines`; default 0
    pub line_count: i64,
    /// bytes from one element of `lines` to the next; default 0 = struct_size
    pub line_stride: i64,
    /// strength of a light from the side opposite to `light`, which lets the unlit side keep its
    /// form: tau = fill_light * (n . l)^2 where n . l < 0; 0 .. 1; default 0.25. The lit side
    /// stays as it is. For TONE_LIGHT with DEPTH_LAYERS and TONE_RULE_SHARE. With `lights` it
    /// comes from the side opposite to the first one
    pub fill_light: f32,
    pub reserved2: u32,
    /// as in hrbfnpr_light; default 1
    ///
    /// Lights, for TONE_LIGHT with DEPTH_LAYERS and TONE_RULE_SHARE.  Their sum is the light s of
    /// a mark, and the tone
    /// law makes tau of it: tau = t^tone_gamma, where t = (s - tone_black) / (tone_white -
    /// tone_black), clamped to 0 ..
    /// 1.
    pub light_intensity: f32,
    /// as in hrbfnpr_light; default 0
    pub light_shadow: f32,
    /// as in hrbfnpr_light; default 0
    pub light_softness: f32,
    /// where stipples are evenly spread, HRBFNPR_EVENNESS_...; default PICTURE
    pub evenness: u32,
    /// a list of up to 8 lights; default NULL = one directional light, with the fields `light`
    /// and light_, which a list replaces. The first one is the light of isophotes and of
    /// lit_factor
    pub lights: *const hrbfnpr_light,
    /// number of `lights`; default 0
    pub light_count: i64,
    /// bytes from one element of `lights` to the next; default 0 = struct_size
    pub light_stride: i64,
    /// direction to the sky, in world space, of any length but 0; default (0, 1, 0)
    pub ambient_up: [f64; 3],
    /// light where the surface faces the sky; 0 .. 16; default 0. Ambient light is a mean of the
    /// light from the sky, weighted by (1 + n . up) / 2, and that from the ground
    pub ambient_sky: f32,
    /// light where the surface faces the ground; 0 .. 16; default 0
    pub ambient_ground: f32,
    /// share of the ambient light that is lost where no sky is seen, 0 .. 1; default 1. It has an
    /// effect on items with a shading
    pub occlusion: f32,
    /// ambient light is multiplied by the share of sky that is seen to this power; above 0, up to
    /// 16; default 1.5. Larger: hollows are darker
    pub occlusion_exponent: f32,
    /// adds rim_light * (1 - |n . v|)^rim_exponent, where v points to the eye: contours are
    /// lighter; 0 .. 16; default 0
    pub rim_light: f32,
    /// above 0, up to 64; default 3. Larger: the light rim is narrower
    pub rim_exponent: f32,
    /// light that is drawn as black; -16 .. 16; default 0
    pub tone_black: f32,
    /// light that is drawn as white; above tone_black, up to 16; default 1
    pub tone_white: f32,
    /// exponent of the tone law; above 0, up to 16; default 1. Larger: darker mid-tones
    pub tone_gamma: f32,
    /// number of flat tones, from black to white, 2 .. 6; default 0 = continuous tones. The steps
    /// of t have the same size
    pub tone_steps: u32,
    /// light that ridges and hills add, and that hollows take away: it is multiplied by a number
    /// from -1 to 1, tanh(3 H scale) less its mean over the surface, where H is the mean
    /// curvature; 0 .. 16; default 0. It has an effect on items whose shading was made with it
    /// (hrbfnpr_shading_desc.curvature_scale)
    pub curvature_contrast: f32,
    /// share of the light of all lights and of the fill light that is lost where no sky is seen,
    /// 0 .. 1; default 0. Hollows get darker, and the rest stays as it is. It has an effect on
    /// items with a shading
    pub occlusion_lights: f32,
    /// inks for ink_field, palette_count x 4, straight RGBA in [0, 1], sRGB-encoded; default
    /// NULL. It is read during _draw only
    pub palette: *const f32,
    /// number of inks; 0 .. 8; default 0. An ink_field needs at least one
    pub palette_count: i64,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_style_init(style: *mut hrbfnpr_style, struct_size: u32) -> hrbfnpr_status;
}

// Named styles, each with a picture in docs/presets.md. bindings/generate writes this list
// from bindings/presets.py.
/// stipples, denser where it is darker, without contours
pub const HRBFNPR_PRESET_STIPPLE: u32 = 0;
/// lines of one width, denser where it is darker, and contours
pub const HRBFNPR_PRESET_HATCH: u32 = 1;
/// up to three sets of lines of one width, at 0, 35 and -30 degrees, each for a darker tone,
/// and contours
pub const HRBFNPR_PRESET_CROSS_HATCH: u32 = 2;
/// lines along Stark's combing direction, with a second set in the darks, and contours
pub const HRBFNPR_PRESET_COMBING: u32 = 3;
/// contours only; hidden ones are paler
pub const HRBFNPR_PRESET_SILHOUETTE: u32 = 4;
/// contours and stipples
pub const HRBFNPR_PRESET_CONTOUR_AND_STIPPLE: u32 = 5;
/// contours only; hidden ones are dashed
pub const HRBFNPR_PRESET_XRAY: u32 = 6;
/// stipples, cross hatching in the darks, contours and halos [NPAR, Figure 1 (e)]
pub const HRBFNPR_PRESET_FULL: u32 = 7;
/// one set of lines that swell with the tone, and contours; lights have a few broken lines
pub const HRBFNPR_PRESET_ENGRAVING: u32 = 8;
/// up to three sets of thin lines, at 0, 50 and -40 degrees, each for a darker tone, and contours
pub const HRBFNPR_PRESET_ETCHING: u32 = 9;
/// few wide lines, which close up to black, and heavy contours
pub const HRBFNPR_PRESET_WOODCUT: u32 = 10;
/// fine stipples lit from the upper left, and outlines that swell in the shade; lights stay empty
pub const HRBFNPR_PRESET_SCIENTIFIC_STIPPLE: u32 = 11;
/// pencil on warm paper: two sets of lines that stray and run past their ends, and contours
/// drawn twice
pub const HRBFNPR_PRESET_SKETCH: u32 = 12;
/// pale lines on blue without tone: contours, borders, creases and lines called "crease";
/// hidden ones are dashed
pub const HRBFNPR_PRESET_BLUEPRINT: u32 = 13;
/// short lines along the curvature that taper to the light from the upper left, heavy
/// outlines, and the RIDGE lines of a line set
pub const HRBFNPR_PRESET_ARCHAEOLOGICAL: u32 = 14;

extern "C" {
    /// Sets all fields of a style to those of a preset. style->layers and style->lines point to
    /// constants of the library:
    /// copy an element to change it.
    /// Errors: INVALID_ARGUMENT (no such preset).
    pub fn hrbfnpr_style_init_preset(
        style: *mut hrbfnpr_style,
        struct_size: u32,
        preset: u32,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets the layers of marks that a preset draws, with their defaults: a list of constants for
    /// hrbfnpr_generate_desc.layers, with layer_stride 0. *count gets their number.  The result
    /// is NULL, with a count of 0,
    /// for a number that no preset has.
    pub fn hrbfnpr_preset_layers(preset: u32, count: *mut i64) -> *const hrbfnpr_layer_desc;
    /// Gets the name of a preset, such as "cross-hatch"; static.  The result is NULL for a number
    /// that no preset has.
    /// Presets are numbered from 0 without gaps.
    pub fn hrbfnpr_preset_name(preset: u32) -> *const c_char;
}

// 10  FIELDS: values on a surface; immutable

/// The surfaces that cast shadows and hide the sky, see hrbfnpr_occluders_create.  It does
/// not change, so any threads
/// may use it.
#[repr(C)]
pub struct hrbfnpr_occluders {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

// The values of a field.
/// one number
pub const HRBFNPR_FIELD_KIND_SCALAR: u32 = 0;
/// three numbers: r, g, b; sRGB-encoded, 0 .. 1
pub const HRBFNPR_FIELD_KIND_COLOUR: u32 = 1;
/// three numbers: x, y, z. Only the tangent part counts; its sign does not
pub const HRBFNPR_FIELD_KIND_DIRECTION: u32 = 2;

// Where the values of a field come from.
/// from values at points, or at the vertices of triangles
pub const HRBFNPR_FIELD_SOURCE_POINTS: u32 = 0;
/// from a function
pub const HRBFNPR_FIELD_SOURCE_FUNCTION: u32 = 1;
/// from dabs of a brush
pub const HRBFNPR_FIELD_SOURCE_DABS: u32 = 2;
/// from an image, which is projected onto the surface along a camera
pub const HRBFNPR_FIELD_SOURCE_IMAGE: u32 = 3;

// What a dab paints.
/// the tone: 1 = light, 0 = dark
pub const HRBFNPR_DAB_TONE: u32 = 0;
/// the density of stipples: 1 = all, 0 = none
pub const HRBFNPR_DAB_DENSITY: u32 = 1;
/// the direction of hatching
pub const HRBFNPR_DAB_DIRECTION: u32 = 2;

/// A dab of a brush: a ball on the surface in which what is painted moves towards a value.
/// Dabs act one after the
/// other.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_dab {
    pub struct_size: u32,
    /// what it paints in a picture, HRBFNPR_DAB_...; default TONE. Fields ignore it
    pub map: u32,
    /// middle of the ball, in coordinates of the source or of the field
    pub position: [f64; 3],
    /// unit normal of the surface there; surface that faces away from it is not painted
    pub normal: [f64; 3],
    /// radius of the ball, in the unit of `position`; above 0
    pub radius: f64,
    /// strength s in the middle, 0 .. 1; default 1. At the distance d from there it is s (1 - d^2
    /// / radius^2)^2
    pub strength: f64,
    /// value of TONE and DENSITY, 0 .. 1, or of a SCALAR field, any number; default 0
    pub value: f64,
    /// direction of DIRECTION, which hatching follows; the value of a field of three numbers
    pub direction: [f64; 3],
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_dab_init(dab: *mut hrbfnpr_dab, struct_size: u32) -> hrbfnpr_status;
}

/// Gives values on a surface.  A value that is not finite, a weight outside 0 .. 1, or a
/// result other than 0 fails the
/// call with CALLBACK.  Where the weight is 0, the value is not read.  The function gets some
/// thousand places at a time,
/// on the thread that called the library.
///
/// positions:   count x 3, absolute
/// normals:     count x 3, unit
/// values:      receives count x 1 (SCALAR) or count x 3 numbers
/// weights:     receives count numbers; they are 1 before the call
pub type hrbfnpr_field_fn = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        count: i64,
        positions: *const f64,
        normals: *const f64,
        values: *mut f64,
        weights: *mut f64,
    ) -> i32,
>;

/// What a field is made from.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_field_desc {
    pub struct_size: u32,
    /// HRBFNPR_FIELD_KIND_...; default SCALAR
    pub kind: u32,
    /// HRBFNPR_FIELD_SOURCE_...; default POINTS
    pub source: u32,
    /// reserved; 0
    pub flags: u32,
    /// SCALAR: range[0] becomes 0, range[1] becomes 1, and values are clamped; range[0] may be
    /// the larger one. Default 0, 0 = values stay as they are
    pub range: [f64; 2],
    /// n x 3, FLOAT32 or FLOAT64; 1 or more
    ///
    /// POINTS.
    pub points: hrbfnpr_array,
    /// m x 3, INT32, INT64 or UINT32: numbers of points. Not given: a place has the value of the
    /// nearest point. Given: it has the value of the nearest place of the triangles, interpolated
    /// between their corners
    pub triangles: hrbfnpr_array,
    /// n x 1 (SCALAR) or n x 3, FLOAT32, FLOAT64 or UINT8; UINT8 colours are 0 .. 255. Directions
    /// are interpolated as lines without a sign. Colours are clamped to 0 .. 1
    pub values: hrbfnpr_array,
    /// distance from the points or triangles beyond which a place has no value; 0 or more;
    /// default 0 = there is no such distance
    pub reach: f64,
    /// gives the values
    ///
    /// FUNCTION.
    pub function: hrbfnpr_field_fn,
    /// passed to `function`; it must stay valid while the field lives
    pub user: *mut c_void,
    /// a list, copied. All act, one after the other, whatever their `map`. SCALAR takes `value`,
    /// DIRECTION takes `direction`, COLOUR takes `direction` as r, g, b
    ///
    /// DABS.
    pub dabs: *const hrbfnpr_dab,
    /// number of dabs; 0 .. 1000000; default 0
    pub dab_count: i64,
    /// bytes from one dab to the next; 0 = the first one's struct_size
    pub dab_stride: i64,
    /// the image, copied. COLOUR takes its colour, SCALAR its luminance Y' = 0.2126 R' + 0.7152
    /// G' + 0.0722 B'. Alpha is the weight; COVERAGE8 and DIRECTION are refused
    ///
    /// IMAGE.  A place outside the image, one that faces away from the camera, and one that is
    /// hidden has no value.
    pub image: *const hrbfnpr_image,
    /// the camera along which it is projected, in the coordinates of the field. The image fills
    /// its viewport
    pub camera: *const hrbfnpr_camera,
    /// surfaces that hide places from the camera, in the coordinates of the field; default NULL = none
    pub occluders: *const hrbfnpr_occluders,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_field_desc_init(
        desc: *mut hrbfnpr_field_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Creates a field.
    ///
    /// operation:   may be NULL
    ///
    /// Errors: INVALID_ARGUMENT (an array is missing or has a wrong shape; the message names it).
    pub fn hrbfnpr_field_create(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_field_desc,
        operation: *mut hrbfnpr_operation,
        out_field: *mut *mut hrbfnpr_field,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference. Any thread.
    pub fn hrbfnpr_field_retain(field: *const hrbfnpr_field);
    /// Removes a reference. Any thread.
    pub fn hrbfnpr_field_release(field: *const hrbfnpr_field);
    /// Evaluates a field at places on a surface.
    ///
    /// positions:   n x 3, FLOAT32 or FLOAT64, absolute
    /// normals:     n x 3, FLOAT32 or FLOAT64, unit; may be NULL for POINTS
    /// values:      receives n x 1 (SCALAR) or n x 3, FLOAT32 or FLOAT64; 0 where the weight is
    /// 0; may be NULL
    /// weights:     receives n x 1, FLOAT32 or FLOAT64, 0 .. 1; 0 also where numbers overflow; may be NULL
    /// operation:   may be NULL
    ///
    /// Errors: CALLBACK (the field's function failed).
    pub fn hrbfnpr_field_evaluate(
        field: *const hrbfnpr_field,
        positions: *const hrbfnpr_array,
        normals: *const hrbfnpr_array,
        values: *const hrbfnpr_array_out,
        weights: *const hrbfnpr_array_out,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 11  RENDERER: from items and a camera to a drawing [NPAR 6]

/// The scratch memory of one thread, for drawing.
#[repr(C)]
pub struct hrbfnpr_renderer {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A picture as a value: dots and strokes in window coordinates.
#[repr(C)]
pub struct hrbfnpr_drawing {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

extern "C" {
    /// Makes a renderer.
    /// Errors: INVALID_ARGUMENT (a NULL argument), OUT_OF_MEMORY.
    pub fn hrbfnpr_renderer_create(
        context: *mut hrbfnpr_context,
        out_renderer: *mut *mut hrbfnpr_renderer,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_renderer_retain(renderer: *mut hrbfnpr_renderer);
    /// Releases a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_renderer_release(renderer: *mut hrbfnpr_renderer);
}

/// The marks of one layer as they are in this drawing, for an animated surface.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_layer_pose {
    pub struct_size: u32,
    pub reserved: u32,
    /// number of the layer in the item's point set; each layer has one pose at most
    pub layer: i64,
    /// absolute positions, in the order of the layer's n marks; n x 3, FLOAT32 or FLOAT64
    pub position: hrbfnpr_array,
    /// outward unit normals; n x 3, FLOAT32 or FLOAT64
    pub normal: hrbfnpr_array,
    /// unit directions; n x 3, FLOAT32 or FLOAT64; empty = the directions of the set
    pub direction: hrbfnpr_array,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_layer_pose_init(
        pose: *mut hrbfnpr_layer_pose,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

// The sides of an item's surface on which its marks are drawn.  Lines are seen from both
// sides in any case.
/// the side that the normals point to; for a solid, whose inside is never seen
pub const HRBFNPR_SIDES_FRONT: u32 = 0;
/// both sides; for a surface that ends, such as a bowl or a leaf. Where the other side faces
/// the camera, marks are drawn with opposite normals. Such marks keep their ids, count as
/// front and as back in hrbfnpr_drawing_info, and are in separate layers after those of all
/// items. With ATTENUATE a depth layer of such an item is as opaque as two, one that faces
/// the camera and one that faces away
pub const HRBFNPR_SIDES_BOTH: u32 = 1;

/// How much light reaches the marks of an item past the surfaces of all items; see
/// hrbfnpr_shading_create.
#[repr(C)]
pub struct hrbfnpr_shading {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// One thing to draw.  What it points to is read during _draw only, except that the drawing
/// retains the point set.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_item {
    pub struct_size: u32,
    /// sides on which marks are drawn, HRBFNPR_SIDES_...; default FRONT
    pub sides: u32,
    /// marks to draw; not NULL
    pub point_set: *const hrbfnpr_point_set,
    /// how they are drawn; default NULL = the defaults of hrbfnpr_style_init
    pub style: *const hrbfnpr_style,
    /// surface that the marks lie on; default NULL. With it, and DEPTH_LAYERS, a ray from each
    /// mark to the eye finds what hides the mark: exact, but slow. It must be NULL if there are
    /// poses
    pub model: *const hrbfnpr_model,
    /// object to world, column-major, affine and invertible; default the identity
    pub transform: [f64; 16],
    /// a list of layers whose marks have moved; default NULL
    pub poses: *const hrbfnpr_layer_pose,
    /// number of `poses`; default 0
    pub pose_count: i64,
    /// bytes from one element of `poses` to the next; default 0 = struct_size
    pub pose_stride: i64,
    /// what the style's lines are drawn from; default NULL = no lines. All items of a drawing
    /// that have one hide each other's lines; other items hide no lines. It must be NULL if there
    /// are poses
    pub line_set: *const hrbfnpr_line_set,
    /// how much light reaches the marks; default NULL = all. It must be that of `point_set`, and
    /// NULL if there are poses
    pub shading: *const hrbfnpr_shading,
}

extern "C" {
    /// Sets struct_size, NULL pointers and the identity transform.
    pub fn hrbfnpr_item_init(item: *mut hrbfnpr_item, struct_size: u32) -> hrbfnpr_status;
    /// Gathers the surfaces of all items that have a line set, at their transforms: the triangles
    /// on which lines are found.
    /// Walls thinner than a cell of the line set may let light through.  The occluders keep the
    /// line sets alive.
    ///
    /// items:       a list, of which line_set and transform are read; an item needs no point set
    /// operation:   may be NULL
    ///
    /// Errors: INVALID_ARGUMENT (no item has a line set).
    pub fn hrbfnpr_occluders_create(
        context: *mut hrbfnpr_context,
        items: *const hrbfnpr_item,
        item_count: i64,
        item_stride: i64,
        operation: *mut hrbfnpr_operation,
        out_occluders: *mut *mut hrbfnpr_occluders,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_occluders_retain(occluders: *const hrbfnpr_occluders);
    /// Releases a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_occluders_release(occluders: *const hrbfnpr_occluders);
}

// Flags of hrbfnpr_shading_desc.
/// lines of the kinds SHADOW and TERMINATOR are found, for items with a line_set
pub const HRBFNPR_SHADING_WITH_LINES: u32 = 1;

/// How a shading is computed.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_shading_desc {
    pub struct_size: u32,
    /// number of rays by which a mark sees the sky; 1 .. 4096; default 64; larger: less noise
    pub sky_rays: i32,
    /// number of rays by which a mark in a penumbra sees a light; 1 .. 4096; default 32
    pub shadow_rays: i32,
    /// HRBFNPR_SHADING_...; default 0
    pub flags: u32,
    /// distance beyond which nothing hides the sky, in diagonals of the box of all occluders; 0
    /// .. 100; default 0.35; 0 = the whole sky is seen everywhere. What is nearer hides the more,
    /// the nearer it is: 1 - distance / reach
    pub occlusion_reach: f64,
    /// a shading of the same item and the same occluders, but for other lights, whose occlusion
    /// is taken; default NULL = occlusion is computed. sky_rays and occlusion_reach then have no
    /// effect. Curvature is taken, too, if it has any
    pub previous: *const hrbfnpr_shading,
    /// distance over which curvature is measured, in diagonals of the box around the item's
    /// surface; 0 .. 1; default 0.02; 0 = it is not measured. It is measured if the item's style
    /// has a curvature_contrast, over at least about a cell of the item's line set
    pub curvature_scale: f64,
}

extern "C" {
    /// Sets every field to its default.
    pub fn hrbfnpr_shading_desc_init(
        desc: *mut hrbfnpr_shading_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Computes how much of the sky [Zhukov, Iones & Kronin 1998] and of each light with a shadow
    /// the marks of an item see.
    /// The result holds for the item's point set, its transform, the lights of its style, and the
    /// occluders.  It stays valid
    /// while these stay, for any camera, except that lights in camera space move with the camera.
    ///
    /// With HRBFNPR_SHADING_WITH_LINES it also finds the borders of shadows on the item, as exact
    /// curves: outlines that a
    /// light sees of the occluders, carried along its rays to the first surface.  Borders inside
    /// another shadow, and those
    /// shorter than 0.01 diagonals of all occluders, are left out.  Soft lights have the borders
    /// of their middle.  An item
    /// shows the lines if its style has line styles of the kinds SHADOW and TERMINATOR.
    ///
    /// occluders:   the surfaces, in world space
    /// item:        point_set, style and transform are read, and line_set with
    /// HRBFNPR_SHADING_WITH_LINES or if the style
    ///              has a curvature_contrast.  It need not be one of the occluders; then it casts
    /// no shadow itself
    /// camera:      the camera of lights in camera space that cast shadows; may be NULL without
    /// such lights
    /// desc:        NULL = all defaults
    ///
    /// operation:   may be NULL
    ///
    /// Errors: INVALID_ARGUMENT (for example WITH_LINES without a line_set).
    pub fn hrbfnpr_shading_create(
        context: *mut hrbfnpr_context,
        occluders: *const hrbfnpr_occluders,
        item: *const hrbfnpr_item,
        camera: *const hrbfnpr_camera,
        desc: *const hrbfnpr_shading_desc,
        operation: *mut hrbfnpr_operation,
        out_shading: *mut *mut hrbfnpr_shading,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets what the marks of a layer see, without a copy: FLOAT32, n x 1, in the order of the
    /// marks.  1 = all, 0 = nothing.
    /// `light` is the number of a light of the style, from 0, that casts shadows; -1 = the
    /// openness, the share of the sky.
    /// The view is valid as long as the shading.
    ///
    /// Errors: INVALID_ARGUMENT (there is no such layer; the light casts no shadow; the occlusion
    /// was not computed).
    pub fn hrbfnpr_shading_view(
        shading: *const hrbfnpr_shading,
        layer: i64,
        light: i64,
        out_view: *mut hrbfnpr_array,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_shading_retain(shading: *const hrbfnpr_shading);
    /// Releases a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_shading_release(shading: *const hrbfnpr_shading);
    /// Draws a list of items for one camera: it classifies, shades and orders their marks, and
    /// traces their lines.
    /// item_stride is the number of bytes from one item to the next; 0 = struct_size.  All styles
    /// must have the same paper
    /// and visibility.  All items together have at most 2147483647 marks.
    ///
    /// Where the camera moved little, contours begin with those of the renderer's last drawing,
    /// and are proven complete
    /// again.  So a picture of lines depends on the drawings before it: in its last digits, and
    /// by the wobble of its lines.
    ///
    /// Errors: INVALID_ARGUMENT (an item, a style or the camera; lines that need curvatures from
    /// a line set without
    /// WITH_CURVATURE), OUT_OF_MEMORY, CALLBACK.
    pub fn hrbfnpr_renderer_draw(
        renderer: *mut hrbfnpr_renderer,
        items: *const hrbfnpr_item,
        item_count: i64,
        item_stride: i64,
        camera: *const hrbfnpr_camera,
        out_drawing: *mut *mut hrbfnpr_drawing,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Draws like hrbfnpr_renderer_draw, with an operation (NULL = none).  Use it for frames that
    /// take long: lines of a fine
    /// surface, millions of marks, rays of an item's model, tone callbacks.  After a cancel there
    /// is no drawing.  The
    /// renderer then goes on as if the call had not been made, except that contours are not
    /// continued from the last drawing.
    /// Errors: those of hrbfnpr_renderer_draw, and CANCELLED.
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
    /// Places the marks of a still picture: like hrbfnpr_point_set_generate, but BLUE_NOISE
    /// leaves out marks that a drawing
    /// of `item` by `camera` does not need.  These are marks outside the picture, on a side that
    /// is not drawn, and in tones
    /// that are too light for them.  The other marks keep their density, ranks and tones; a few
    /// lie elsewhere.  Marks of a
    /// layer with a range of tones, of PUBLISHED, and of a style with VISIBILITY_PUBLISHED are all placed.
    ///
    /// item:        style, sides and transform of the drawing.  Its point_set may be NULL, and is not read
    /// desc:        NULL = all defaults
    /// operation:   may be NULL
    ///
    /// Another camera, transform or style would show gaps, so drawing with them fails.  Styles
    /// may differ in inks, lines and
    /// paper.  The set cannot be saved.
    /// Errors: those of hrbfnpr_point_set_generate; INVALID_ARGUMENT (the item, its style or the camera).
    pub fn hrbfnpr_point_set_generate_still(
        context: *mut hrbfnpr_context,
        model: *const hrbfnpr_model,
        desc: *const hrbfnpr_generate_desc,
        item: *const hrbfnpr_item,
        camera: *const hrbfnpr_camera,
        operation: *mut hrbfnpr_operation,
        out_point_set: *mut *mut hrbfnpr_point_set,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 12  DRAWING: a picture as a value; immutable

extern "C" {
    /// Adds a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_drawing_retain(drawing: *const hrbfnpr_drawing);
    /// Releases a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_drawing_release(drawing: *const hrbfnpr_drawing);
}

// How a mark faces the camera [NPAR 6].
/// no mark, or a mark that is not drawn
pub const HRBFNPR_CLASS_NONE: u32 = 0;
/// a mark whose normal points towards the eye
pub const HRBFNPR_CLASS_FRONT: u32 = 1;
/// a mark whose normal points away from the eye
pub const HRBFNPR_CLASS_BACK: u32 = 2;
/// a mark near a contour, with VISIBILITY_PUBLISHED
pub const HRBFNPR_CLASS_SILHOUETTE: u32 = 3;

/// What a drawing holds, and what making it did.  The counts of marks are over the layers
/// that the styles use, in all
/// items: marks = outside + front + back + silhouette + culled.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_drawing_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// items that were drawn
    pub items: i64,
    /// layers of the drawing, for hrbfnpr_drawing_get_layer_info
    pub layers: i64,
    /// dots of ink
    pub dots: i64,
    /// strokes of marks and of lines
    pub strokes: i64,
    /// points of all strokes
    pub stroke_points: i64,
    /// marks of the layers that the styles use, in all items
    pub marks: i64,
    /// marks outside the view frustum
    pub outside: i64,
    /// marks of class front inside the frustum
    pub front: i64,
    /// marks of class back inside the frustum
    pub back: i64,
    /// marks of class silhouette inside the frustum; PUBLISHED only
    pub silhouette: i64,
    /// marks without a class, because no tone could show them and they were skipped; DEPTH_LAYERS only
    pub culled: i64,
    /// marks drawn as ink
    pub shown: i64,
    /// front marks not shown because of light or share
    pub dropped_tone: i64,
    /// front and silhouette marks not shown because of their distance
    pub dropped_depth: i64,
    /// front marks not shown because of the zoom
    pub dropped_zoom: i64,
    /// marks not drawn because the surface in front of them lets nothing of them through
    pub dropped_hidden: i64,
    /// with PUBLISHED, discs of paper; with DEPTH_LAYERS, marks from which depth layers were found
    pub splats: i64,
    /// time for transforms, classes and tones
    pub nanoseconds_classify: i64,
    /// time for finding what hides marks
    pub nanoseconds_visibility: i64,
    /// time for ordering ink
    pub nanoseconds_sort: i64,
    /// memory that the drawing keeps
    pub bytes: i64,
    /// memory that its renderer keeps, without drawings
    pub scratch_bytes: i64,
    /// curves that lines were drawn from
    pub line_curves: i64,
    /// cusps of these curves
    pub line_cusps: i64,
    /// crossings of their images at which the farther curve changes its visibility
    pub line_crossings: i64,
    /// curves that end inside the surface, and places where a curve was missed
    pub line_broken: i64,
    /// curves whose visibility did not add up. A ray decided for each of their parts
    pub line_settled: i64,
    /// curves among these with a part whose ray was not certain
    pub line_contradictions: i64,
    /// time for lines
    pub nanoseconds_lines: i64,
    /// curves whose visibility did not add up at first. They, and those that cross them, were refined
    pub line_refined: i64,
    /// cells of the image, four pixels wide or more, with so many crossings that none was used.
    /// Lines run to and fro over each other there, as on a flat face seen edge-on
    pub line_tangles: i64,
    /// visible and hidden parts of lines that rays were compared with (`verify_lines`)
    pub line_pieces: i64,
    /// parts whose decided rays all agree with the drawing
    pub line_agreeing: i64,
    /// parts without a decided ray: they are within 0.4 pixels of an edge, in the image or in depth
    pub line_undecided: i64,
    /// parts that were divided, or drawn otherwise than counted, because rays disagreed
    pub line_repaired: i64,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_drawing_info_init(
        info: *mut hrbfnpr_drawing_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Gets what a drawing holds, and what making it did.
    pub fn hrbfnpr_drawing_get_info(
        drawing: *const hrbfnpr_drawing,
        info: *mut hrbfnpr_drawing_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// A layer of a drawing: the ink of one layer of marks, for front marks or (with PUBLISHED)
/// for contours; or the ink of
/// lines.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_drawing_layer_info {
    pub struct_size: u32,
    /// class of its marks: HRBFNPR_CLASS_FRONT or SILHOUETTE
    pub mark_class: u32,
    /// number of the item
    pub item: i64,
    /// number of the layer in the item's point set; -1 = lines
    pub layer: i64,
    /// kind of that layer, HRBFNPR_LAYER_KIND_...; for lines HRBFNPR_LINE_KIND_...
    pub kind: u32,
    /// shape of the ink, HRBFNPR_SHAPE_...
    pub shape: u32,
    /// name of that layer; for lines that of their style, or empty
    pub name: [c_char; 64],
    /// colour of the ink, straight RGBA
    pub ink: [f32; 4],
    /// dots of the layer
    pub dots: i64,
    /// strokes of the layer
    pub strokes: i64,
    /// number of the ink in the style's palette; -1 = the layer's own ink. Each ink that marks of
    /// a layer take is a layer of the drawing of its own
    pub ink_number: i32,
    pub reserved: u32,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_drawing_layer_info_init(
        info: *mut hrbfnpr_drawing_layer_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Gets what a layer of a drawing holds.  `number` is 0 .. hrbfnpr_drawing_info.layers - 1.
    /// Errors: INVALID_ARGUMENT (no such layer).
    pub fn hrbfnpr_drawing_get_layer_info(
        drawing: *const hrbfnpr_drawing,
        number: i64,
        info: *mut hrbfnpr_drawing_layer_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// Options of rasterizing.
/// lays the drawing over the image instead of replacing the image inside the viewport. Use it
/// with transparent paper
pub const HRBFNPR_RASTER_OVER: u32 = 1;
/// blends in linear light (sRGB decoded) instead of in encoded values
pub const HRBFNPR_RASTER_LINEAR_LIGHT: u32 = 2;

/// Optional inputs and outputs of rasterizing.  Each array has width * height elements of one
/// component, row by row from
/// the top-left pixel of the image.  An array with data NULL and count 0 is not wanted.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_raster_desc {
    pub struct_size: u32,
    /// HRBFNPR_RASTER_...; default 0
    pub flags: u32,
    /// depth of the host's scene, FLOAT32 in the camera's depth convention; ink behind it is not drawn
    pub host_depth: hrbfnpr_array,
    /// gets the depth of the nearest surface, FLOAT32 in the camera's depth convention; the far
    /// plane where there is no surface
    pub depth: hrbfnpr_array_out,
    /// gets the id of the nearest drawn mark, UINT32; 0 = none
    pub id: hrbfnpr_array_out,
    /// gets the class of that mark, HRBFNPR_CLASS_...; UINT8 or UINT32
    pub mark_class: hrbfnpr_array_out,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_raster_desc_init(
        desc: *mut hrbfnpr_raster_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Draws into an image.  It fills the viewport, clipped to the image, with paper and ink, and
    /// leaves other pixels as
    /// they are.  `desc` may be NULL for the defaults.
    /// Errors: INVALID_ARGUMENT (a field of the image or of `desc`), OUT_OF_MEMORY.
    pub fn hrbfnpr_drawing_rasterize(
        drawing: *const hrbfnpr_drawing,
        image: *const hrbfnpr_image,
        desc: *const hrbfnpr_raster_desc,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// What vertices are written for.
/// dots, with one vertex each
pub const HRBFNPR_PRIMITIVE_POINTS: u32 = 1;
/// strokes, with one vertex for each of their points
pub const HRBFNPR_PRIMITIVE_LINE_STRIPS: u32 = 2;
/// strokes, with two vertices for each point, on its left and right side
pub const HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS: u32 = 3;

// The index that ends a strip: 0xFFFFFFFF as UINT32.
pub const HRBFNPR_INDEX_RESTART: i32 = -1;

// What a vertex can carry, and the types it can have.
/// world position; FLOAT32 x 3. For marks and their line strips it is the place of the mark.
/// For lines, hatching and triangles it is the drawn place, as exact as the window depth
pub const HRBFNPR_VERTEX_ATTRIBUTE_POSITION: u32 = 0;
/// pixel x, pixel y and depth; FLOAT32 x 3
pub const HRBFNPR_VERTEX_ATTRIBUTE_WINDOW: u32 = 1;
/// radius of a dot or half the width of a stroke, in pixels; FLOAT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_RADIUS: u32 = 2;
/// colour, straight RGBA; FLOAT32 x 4 or UINT8 x 4
pub const HRBFNPR_VERTEX_ATTRIBUTE_COLOR: u32 = 3;
/// unit normal in the world, 0 for lines; FLOAT32 x 3
pub const HRBFNPR_VERTEX_ATTRIBUTE_NORMAL: u32 = 4;
/// unit direction in the world, 0 for lines; FLOAT32 x 3
pub const HRBFNPR_VERTEX_ATTRIBUTE_DIRECTION: u32 = 5;
/// id of the mark, 0 for lines; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_ID: u32 = 6;
/// class of the mark, HRBFNPR_CLASS_...; UINT8 or UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_CLASS: u32 = 7;
/// 1 = a disc of paper, 0 = ink; UINT8 or UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER: u32 = 8;
/// number of the layer in the drawing; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_LAYER: u32 = 9;
/// length along the stroke from its first point, in pixels, 0 for a dot; FLOAT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_LENGTH: u32 = 10;
/// number of layers of surface in front of this part of a line, 0 if it is visible or a mark; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_LAYERS: u32 = 11;
/// number of the item whose surface is nearest in front of this part of a line,
/// HRBFNPR_INDEX_RESTART if it is visible or a mark; UINT32
pub const HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_BY: u32 = 12;
/// number of the line, 0 for all else; UINT32. A line keeps it from one drawing of a renderer
/// to the next where the camera moves little
pub const HRBFNPR_VERTEX_ATTRIBUTE_LINE: u32 = 13;

/// One attribute of a vertex.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_vertex_attribute {
    pub struct_size: u32,
    /// what it holds, HRBFNPR_VERTEX_ATTRIBUTE_...; default POSITION
    pub attribute: u32,
    /// type of its numbers, HRBFNPR_SCALAR_...; default FLOAT32
    pub scalar: u32,
    /// bytes from the start of the vertex; default 0
    pub offset: u32,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_vertex_attribute_init(
        attribute: *mut hrbfnpr_vertex_attribute,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// What vertices are written for, and what each holds.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_vertex_layout {
    pub struct_size: u32,
    /// what vertices are written for, HRBFNPR_PRIMITIVE_...; default POINTS
    pub primitive: u32,
    /// a list of 1 to 64 attributes
    pub attributes: *const hrbfnpr_vertex_attribute,
    /// number of `attributes`
    pub attribute_count: i64,
    /// bytes from one element of `attributes` to the next; default 0 = struct_size
    pub attribute_stride: i64,
    /// bytes from one vertex to the next; default 0 = up to the end of the last attribute
    pub stride: i64,
}

extern "C" {
    /// Sets struct_size, POINTS and no attributes.
    pub fn hrbfnpr_vertex_layout_init(
        layout: *mut hrbfnpr_vertex_layout,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Gets the numbers of vertices and indices that hrbfnpr_drawing_write_vertices writes for a primitive
    /// (HRBFNPR_PRIMITIVE_...).  `vertices` and `indices` may be NULL.
    /// Errors: INVALID_ARGUMENT (no such primitive).
    pub fn hrbfnpr_drawing_vertex_bound(
        drawing: *const hrbfnpr_drawing,
        primitive: u32,
        vertices: *mut i64,
        indices: *mut i64,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Writes the vertices of a drawing's dots or strokes, from far to near.
    ///
    /// POINTS: discs of paper and of ink.  A host gets the dots of hrbfnpr_drawing_rasterize if
    /// it paints them in this
    /// order, as round anti-aliased points with "source over" blending; only host_depth has no
    /// effect.  A dot with a radius
    /// r below half a pixel is written with half a pixel, and its alpha times (2 r)^2.  With
    /// transparent paper the discs of
    /// paper must erase: destination times (1 - alpha).
    ///
    /// Strips: `indices` (UINT32, may be NULL) gets the vertices of one stroke after the other,
    /// each stroke ended by
    /// HRBFNPR_INDEX_RESTART.  A triangle strip has two vertices for each point, on its left and
    /// right, and two at the tip
    /// of a pointed end.  Round ends are cut off flat.  For POINTS `indices` gets 0, 1, 2 and so on.
    ///
    /// Capacities are numbers of vertices and of indices. *vertex_count and *index_count (may be
    /// NULL) get the numbers that
    /// were written, or that are needed with BUFFER_TOO_SMALL.
    /// Errors: INVALID_ARGUMENT (a field of the layout; a negative capacity), BUFFER_TOO_SMALL (a
    /// capacity is too small;
    /// nothing is written), OUT_OF_MEMORY.
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

/// How each mark of a layer is drawn, in the set's own order.  A host keeps the set's arrays
/// on the graphics card and
/// uploads only these.  Each array of the caller's has as many elements as the layer has
/// marks, or is not given.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mark_results {
    pub struct_size: u32,
    pub reserved: u32,
    /// gets the class as which the mark is drawn, HRBFNPR_CLASS_FRONT or SILHOUETTE, or NONE if
    /// it is not drawn; n x 1, UINT8
    pub shown: hrbfnpr_array_out,
    /// gets the radius of the mark in pixels, 0 if it is not drawn; n x 1, FLOAT32
    pub radius: hrbfnpr_array_out,
    /// gets the ink's alpha times the transmittance of what lies in front, 0 if the mark is not
    /// drawn; n x 1, FLOAT32
    pub opacity: hrbfnpr_array_out,
}

extern "C" {
    /// Sets struct_size; no array is given.
    pub fn hrbfnpr_mark_results_init(
        results: *mut hrbfnpr_mark_results,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Gets how each mark of one layer of one item's point set is drawn.  The layer need not be drawn.
    /// Errors: INVALID_ARGUMENT (no such item or layer; an array of another size or type).
    pub fn hrbfnpr_drawing_mark_results(
        drawing: *const hrbfnpr_drawing,
        item: i64,
        layer: i64,
        results: *mut hrbfnpr_mark_results,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Writes which marks of a layer are drawn as one class: the numbers of these marks, UINT32.
    /// `mark_class` is
    /// HRBFNPR_CLASS_FRONT or SILHOUETTE.  With POINTS they are the marks that are shown, from
    /// far to near.  With
    /// LINE_STRIPS they are runs of shown marks along strokes, each ended by
    /// HRBFNPR_INDEX_RESTART.  With TRIANGLE_STRIPS
    /// they are the same runs, with 2 * number and 2 * number + 1 for each mark.
    ///
    /// *count (not NULL) gets the number of indices written, or needed with BUFFER_TOO_SMALL.
    /// `indices` may be NULL if
    /// capacity is 0.
    /// Errors: INVALID_ARGUMENT (no such item, layer, class or primitive), BUFFER_TOO_SMALL
    /// (nothing is written),
    /// OUT_OF_MEMORY.
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

/// The mark that an id belongs to.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mark_identity {
    pub struct_size: u32,
    /// the id itself
    pub id: u32,
    /// number of the item
    pub item: i64,
    /// number of the layer in the item's point set
    pub layer: i64,
    /// number of the mark in the layer
    pub mark: i64,
    /// number of its stroke in the layer; -1 = it is in no stroke
    pub stroke: i64,
    /// its place along the stroke, from 0
    pub place: i64,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_mark_identity_init(
        identity: *mut hrbfnpr_mark_identity,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Finds the mark that has an id.
    /// Errors: INVALID_ARGUMENT (no mark has the id).
    pub fn hrbfnpr_drawing_identify(
        drawing: *const hrbfnpr_drawing,
        id: u32,
        identity: *mut hrbfnpr_mark_identity,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 13  MESH: triangles, repaired; samples, fits and comparisons

// Which components of a mesh are kept.  Faces that share vertices belong to one component.
// With ALL and SOLIDS, a closed component inside an odd number of closed ones is the wall of
// a cavity, and its faces
// are turned into the cavity.  One inside an even number is a solid.
/// keeps all components except those inside a closed one, such as eyes in a head or inner shells
pub const HRBFNPR_PARTS_OUTER: u32 = 0;
/// keeps all components
pub const HRBFNPR_PARTS_ALL: u32 = 1;
/// keeps the component of the largest area
pub const HRBFNPR_PARTS_LARGEST: u32 = 2;
/// keeps all components except open ones inside a closed one
pub const HRBFNPR_PARTS_SOLIDS: u32 = 3;
/// in a picture SOLIDS if hidden parts of lines or a section are drawn, or with SURFACE_ONLY;
/// else OUTER
pub const HRBFNPR_PARTS_AUTO: u32 = 4;

// Whether the order of a face's corners may change.
/// faces are turned to agree with their component, and closed components to face outward
pub const HRBFNPR_FACES_TURN: u32 = 0;
/// faces stay as they are
pub const HRBFNPR_FACES_KEEP: u32 = 1;

/// A mesh as it is given: triangles.  The caller cuts quadrilaterals and polygons into triangles.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_desc {
    pub struct_size: u32,
    /// components that are kept, HRBFNPR_PARTS_...; default OUTER
    pub parts: u32,
    /// positions; n x 3, FLOAT32 or FLOAT64, n < 2^31 - 1; coordinates up to 1e60
    pub vertices: hrbfnpr_array,
    /// numbers of vertices from 0, counter-clockwise as seen from outside; m x 3, INT32, INT64 or
    /// UINT32, m < 2^29
    pub triangles: hrbfnpr_array,
    /// angle between the normals of two faces, in degrees, above which they do not share corner
    /// normals; 0 .. 180; default 60
    pub crease_angle: f64,
    /// whether faces are turned, HRBFNPR_FACES_...; default TURN
    pub faces: u32,
    pub reserved: u32,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_mesh_desc_init(desc: *mut hrbfnpr_mesh_desc, struct_size: u32) -> hrbfnpr_status;
    /// Makes a mesh from triangles, and repairs it.  `operation` may be NULL.
    /// Errors: INVALID_ARGUMENT (a corner that is not the number of a vertex, or whose vertex is
    /// not finite: the message
    /// names the face and the index; coordinates beyond 1e60; a mesh less than 1e-60 across; a
    /// mesh that has no face left),
    /// OUT_OF_MEMORY, CANCELLED.
    pub fn hrbfnpr_mesh_create(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_mesh_desc,
        operation: *mut hrbfnpr_operation,
        out_mesh: *mut *mut hrbfnpr_mesh,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_mesh_retain(mesh: *const hrbfnpr_mesh);
    /// Releases a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_mesh_release(mesh: *const hrbfnpr_mesh);
}

/// What making a mesh found, and did.  Facts such as the numbers of vertices, faces and edges
/// are those of the mesh that
/// is kept; numbers of repairs are those of the mesh that was given.  An edge is at the
/// boundary if it has one face, and
/// not manifold if it has more than two.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_info {
    pub struct_size: u32,
    /// 1: no edge is at the boundary or not manifold, and all faces agree
    pub closed: u32,
    /// vertices that were given
    pub given_vertices: i64,
    /// faces that were given
    pub given_faces: i64,
    /// vertices that are kept. They are more than were given where solids that touch in an edge
    /// are parted, at most three for each face
    pub vertices: i64,
    /// faces that are kept
    pub faces: i64,
    /// vertices at the place of another, joined with it; on borders also those within 1e-6
    /// diagonals of another
    pub welded_vertices: i64,
    /// faces left out because they have no area beyond the rounding of single precision. The face
    /// across the largest side is cut in two at the corner on it, so that no slit stays
    pub degenerate_faces: i64,
    /// faces left out because another has the same corners; both where two solids share a wall
    pub repeated_faces: i64,
    /// faces turned to agree with those beside them
    pub turned_faces: i64,
    /// components of the given faces
    pub components: i64,
    /// closed components turned because they were inside out
    pub turned_components: i64,
    /// components inside a closed one
    pub nested_components: i64,
    /// components left out, by `parts`
    pub left_out_components: i64,
    /// faces of the components left out
    pub left_out_faces: i64,
    /// edges with one face
    pub boundary_edges: i64,
    /// loops that these edges form
    pub boundary_loops: i64,
    /// edges with more than two faces
    pub nonmanifold_edges: i64,
    /// edges whose two faces do not agree, because the mesh cannot be oriented or was not to be
    pub contrary_edges: i64,
    /// vertices - edges + faces
    pub euler_characteristic: i64,
    /// number of handles of all components; -1 if the mesh is not closed
    pub genus: i64,
    /// area, in squared units of the mesh
    pub area: f64,
    /// enclosed volume, in cubed units of the mesh; NaN if the mesh is not closed
    pub volume: f64,
    /// least coordinates of the vertices
    pub bounds_min: [f64; 3],
    /// greatest coordinates of the vertices
    pub bounds_max: [f64; 3],
    /// time that making it took
    pub seconds: f64,
    /// memory that the mesh keeps
    pub bytes: i64,
    /// length of the edges that bend by more than 30 degrees, in diagonals of the bounds
    pub crease_length: f64,
    /// 1: the mesh has edges that stand out, as those of machine parts do. hrbfnpr_model_fit_mesh
    /// keeps them sharp with edges AUTO and the default crease_angle
    pub creases: u32,
    /// components that are kept and are walls of cavities
    pub cavities: u32,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_mesh_info_init(info: *mut hrbfnpr_mesh_info, struct_size: u32) -> hrbfnpr_status;
    /// Gets what making a mesh found, and did.
    pub fn hrbfnpr_mesh_get_info(
        mesh: *const hrbfnpr_mesh,
        info: *mut hrbfnpr_mesh_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// Arrays of a mesh.
/// positions of the vertices; FLOAT64 x 3
pub const HRBFNPR_MESH_ATTRIBUTE_VERTEX: u32 = 0;
/// numbers of the vertices of each face; INT32 x 3
pub const HRBFNPR_MESH_ATTRIBUTE_TRIANGLE: u32 = 1;
/// number of the component of each face, from 0; INT32 x 1
pub const HRBFNPR_MESH_ATTRIBUTE_COMPONENT: u32 = 2;
/// number of each face among the given ones; INT32 x 1
pub const HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE: u32 = 3;
/// unit normals of the three corners of each face; FLOAT64 x 9
pub const HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL: u32 = 4;

extern "C" {
    /// Gets a view of an array of the mesh, HRBFNPR_MESH_ATTRIBUTE_..., without a copy.  It is
    /// valid while the mesh lives.
    /// Errors: INVALID_ARGUMENT (no such attribute).
    pub fn hrbfnpr_mesh_view(
        mesh: *const hrbfnpr_mesh,
        attribute: u32,
        out_view: *mut hrbfnpr_array,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// How a mesh is sampled.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_sample_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// random places to choose from, 0 .. 1000000; default 0 = 40 for each sample, up to 1000000.
    /// More: more even samples, in more time. There are never fewer than samples; with as many,
    /// the samples are all of them in random order
    pub candidates: i64,
    /// seed of the places, any number; default 1
    pub random_seed: u64,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_sample_desc_init(
        desc: *mut hrbfnpr_sample_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Samples a mesh evenly, with as many samples as `points` has elements, 1 .. 10000000.  Each
    /// sample is the candidate
    /// farthest from those before, so that every prefix is even.  `points` and `normals` are n x
    /// 3, FLOAT32 or FLOAT64.
    /// `normals` may be NULL.  They are unit, and interpolated between the normals of the
    /// corners.  A corner's normal takes
    /// in the faces around its vertex within the crease angle, weighted by their angles there.
    /// `desc` and `operation` may
    /// be NULL.
    /// Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
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
/// edges are sharp if they stand out from the faces beside them, as those of machine parts
/// do. Noise and coarse faces of round shapes do not stand out. Closed parts that cross are
/// fitted separately, and meet in creases
pub const HRBFNPR_EDGES_AUTO: u32 = 0;
/// no edge is sharp: a fit is one smooth surface, which rounds all edges
pub const HRBFNPR_EDGES_SMOOTH: u32 = 1;
/// all edges are sharp whose faces meet at more than crease_angle
pub const HRBFNPR_EDGES_SHARP: u32 = 2;

/// How sharp edges are found.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_edges_desc {
    pub struct_size: u32,
    /// which edges are sharp, HRBFNPR_EDGES_...; default AUTO
    pub edges: u32,
    /// angle between the normals of two faces, in degrees, above which their edge is sharp; 1 ..
    /// 179; default 30
    pub crease_angle: f64,
    /// distance, in units of the mesh, that decides about coarse faces; 0 or more; default 0 =
    /// 0.01 diagonals. Faces stay flat, with sharp edges, if a round surface would leave them by
    /// more than four fifths of it. With a large number, such as the diagonal, the angle alone
    /// decides
    pub far: f64,
    /// 1 also finds tangent edges, along which two surfaces of a part touch without a kink but
    /// bend differently, such as a fillet and a plane; default 0. They are found where the bends
    /// of the mesh agree with two different curvatures. Scans, noise and subdivided shapes have
    /// none
    pub tangent: u32,
    pub reserved: u32,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_mesh_edges_desc_init(
        desc: *mut hrbfnpr_mesh_edges_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// The sharp edges of a mesh as a whole.  Lengths are in units of the mesh.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_edges_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// number of sharp edges
    pub edges: i64,
    /// number of smooth patches between them; 1 if no edge is sharp
    pub patches: i64,
    /// length of the sharp edges
    pub length: f64,
    /// length of those sharp edges that have the same patch on both sides, as where a crease fades out
    pub fading: f64,
    /// with AUTO, length of edges that bend more than crease_angle but do not stand out; 0 if the
    /// mesh has sharp edges
    pub doubtful: f64,
    /// time that the search took
    pub seconds: f64,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_mesh_edges_info_init(
        info: *mut hrbfnpr_mesh_edges_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Finds the sharp edges of a mesh and the smooth patches between them, as
    /// hrbfnpr_model_fit_mesh does with the same
    /// edges, crease_angle and far.  A sharp edge that ends within a patch goes on along edges
    /// that keep its direction and
    /// bend by 8 degrees or more.  Short sharp edges that separate nothing are dropped as noise.
    /// Edges with one face, or
    /// with more than two, end patches but are not sharp.
    ///
    /// `patch` is m x 1 for the m faces of the mesh, INT64, INT32 or UINT32: it gets the number
    /// of each face's patch, from 0
    /// in the order of their first faces.  `sharp` is m x 3, of the same types: it gets 1 if the
    /// edge from corner k of the
    /// face to the next corner is sharp, 2 if it is a tangent edge, else 0.  `patch`, `sharp`,
    /// `desc`, `info` and
    /// `operation` may be NULL.  The call only reads the mesh, so several threads may make it at
    /// the same time.
    /// Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
    pub fn hrbfnpr_mesh_edges(
        mesh: *const hrbfnpr_mesh,
        desc: *const hrbfnpr_mesh_edges_desc,
        patch: *const hrbfnpr_array_out,
        sharp: *const hrbfnpr_array_out,
        info: *mut hrbfnpr_mesh_edges_info,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Orders points so that each is the farthest from those before it (farthest-point order), so
    /// that every prefix is an
    /// even choice [Gonzalez 1985].  The first is the point nearest to the middle of the bounding
    /// box.  If two points are
    /// equally far, the one with the lower number comes first.
    ///
    /// `points` is n x 3, FLOAT32 or FLOAT64, finite, up to 1e100.  `indices` is k x 1, INT64,
    /// INT32 or UINT32, 1 <= k <= n:
    /// it gets the numbers of the points.  `distance` is k x 1, FLOAT32 or FLOAT64, or NULL: it
    /// gets the distance of each
    /// from those before; infinite for the first.  `operation` may be NULL.
    /// Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
    pub fn hrbfnpr_farthest_points(
        context: *mut hrbfnpr_context,
        points: *const hrbfnpr_array,
        indices: *const hrbfnpr_array_out,
        distance: *const hrbfnpr_array_out,
        operation: *mut hrbfnpr_operation,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// How a surface is compared with a mesh.  The surface is that of the model within the box of
/// the mesh, grown by 0.05
/// diagonals.  Diagonals are those of the mesh.  Parts of the surface whose nearest place on
/// the mesh is on its border
/// lie beyond the mesh, and are left out.  Where closed components overlap, what lies inside
/// another is no part of the
/// mesh.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_compare_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// distance within which shares are counted, in units of the mesh; 0 or more; default 0 =
    /// 0.002 diagonals
    pub tolerance: f64,
    /// distance, in units of the mesh, beyond which surface is invented and mesh is missed; 0 or
    /// more; default 0 = 0.01 diagonals
    pub far: f64,
    /// limit of the support of the model's samples, beyond which surface is left out, as in
    /// hrbfnpr_line_set_desc; 0 or more; default 0 = nothing is left out. A custom model has no
    /// samples: give 0
    pub support: f64,
    /// places to measure at, on the surface and on the mesh each, 100 .. 10000000; default 0 = 20000
    pub points: i64,
    /// side of the cells in which the surface is searched, in units of the mesh, at least 0.001
    /// diagonals; default 0 = 1/128 diagonal, and finer where the surface is thin. What is
    /// thinner or smaller may be missed
    pub cell_size: f64,
    /// seed of the places, any number; default 1
    pub random_seed: u64,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_compare_desc_init(
        desc: *mut hrbfnpr_compare_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// How near a surface and a mesh are to each other.  Distances are in units of the mesh.  99
/// % of the distances are not
/// above p99.  Figures without any place to measure at are NaN.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_comparison {
    pub struct_size: u32,
    pub reserved: u32,
    /// places on the surface, even over its area
    pub surface_points: i64,
    /// mean of their distances from the mesh
    pub surface_mean: f64,
    /// 99th percentile of these distances
    pub surface_p99: f64,
    /// greatest of these distances
    pub surface_max: f64,
    /// share of the surface within the tolerance of the mesh, 0 .. 1
    pub surface_share: f64,
    /// share of the surface farther than `far` from the mesh, 0 .. 1
    pub invented_share: f64,
    /// share of the surface left out, beyond the mesh's border or by `support`, 0 .. 1; no other
    /// figure includes it
    pub left_out_share: f64,
    /// places on the mesh, even over its area
    pub mesh_points: i64,
    /// mean of their distances from the surface
    pub mesh_mean: f64,
    /// 99th percentile of these distances
    pub mesh_p99: f64,
    /// greatest of these distances
    pub mesh_max: f64,
    /// share of the mesh within the tolerance of the surface, 0 .. 1
    pub mesh_share: f64,
    /// share of the mesh farther than `far` from the surface, 0 .. 1
    pub missed_share: f64,
    /// mean angle between the mesh's normals and those of the surface beside them, in degrees
    pub normal_mean: f64,
    /// 99th percentile of these angles, in degrees
    pub normal_p99: f64,
    /// components of the surface
    pub components: i64,
    /// genus of the surface, summed over its components; -1 if it has a border in the box
    pub genus: i64,
    /// tolerance as used
    pub tolerance: f64,
    /// diagonal of the mesh
    pub diagonal: f64,
    /// time that the comparison took
    pub seconds: f64,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_comparison_init(
        comparison: *mut hrbfnpr_comparison,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Measures how near the surface of any model and a mesh are to each other, both ways.  Both
    /// are in the same
    /// coordinates.  The search for the surface starts from places on the mesh and from a lattice
    /// of 16^3 places in the box.
    /// A small part of the surface that is near none of these is missed.  `desc` and `operation`
    /// may be NULL.
    /// Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED, CALLBACK.
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
    /// distance within which surface and mesh shall be of each other, in units of the mesh; 1e-6
    /// diagonals or more; default 0 = 0.002 diagonals. Smaller: more samples and time
    pub tolerance: f64,
    /// share of both that must be within the tolerance; above 0, up to 1; default 0.99
    pub share: f64,
    /// distance that no part may exceed, in units of the mesh; not below the tolerance; default 0
    /// = five times the tolerance
    pub far: f64,
    /// the most centres of the fit, 16 .. 1000000; default 8000. A fit with sharp edges may have
    /// 32 for each of its sheets, if that is more, as each sheet is solved alone
    pub maximum_centres: i64,
    /// places on the mesh to choose samples from, 1000 .. 10000000; default 0 = by its area and
    /// its details
    pub candidates: i64,
    /// seed of the places, any number; default 1
    pub random_seed: u64,
    /// angle between the normals of two faces, in degrees, above which their edge is sharp; 5 ..
    /// 175; default 30. Edges of coarse faces are sharp, too, if rounding would move the surface
    /// off the mesh by four fifths of `far`
    pub crease_angle: f64,
    /// which edges are sharp, HRBFNPR_EDGES_...; default AUTO
    pub edges: u32,
    pub reserved2: u32,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_mesh_fit_desc_init(
        desc: *mut hrbfnpr_mesh_fit_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// The result of a fit to a mesh.  Distances are in units of the mesh.  They come from the
/// fit's last measurement, at
/// places that it did not use before. hrbfnpr_model_compare_mesh measures again, and more.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_mesh_fit_info {
    pub struct_size: u32,
    /// 1: surface and mesh keep the tolerance, the share and `far`, both ways
    pub reached: u32,
    /// tolerance as used
    pub tolerance: f64,
    /// `far` as used
    pub far: f64,
    /// places on the mesh that samples were chosen from
    pub candidates: i64,
    /// all centres
    pub centres: i64,
    /// centres off the surface, at which f is held to the distance from the mesh. They are the last ones
    pub off_surface_centres: i64,
    /// number of fits
    pub rounds: i32,
    /// 1: the mesh has a border, and the surface beyond it was not counted
    pub supported: u32,
    /// share of the surface within the tolerance of the mesh, 0 .. 1
    pub surface_share: f64,
    /// 99th percentile of the surface's distances from the mesh
    pub surface_p99: f64,
    /// greatest distance of the surface from the mesh
    pub surface_max: f64,
    /// share of the mesh within the tolerance of the surface, 0 .. 1
    pub mesh_share: f64,
    /// 99th percentile of the mesh's distances from the surface
    pub mesh_p99: f64,
    /// greatest distance of the mesh from the surface
    pub mesh_max: f64,
    /// time for choosing samples
    pub seconds_sample: f64,
    /// time for the fits of all rounds
    pub seconds_fit: f64,
    /// time for measuring distances
    pub seconds_measure: f64,
    /// time of the whole call
    pub seconds_total: f64,
    /// smooth sheets that the surface consists of; 1 if it has no sharp edges
    pub sheets: i32,
    pub reserved: u32,
    /// length of the mesh's edges that are sharp, in units of the mesh
    pub crease_length: f64,
    /// length of edges that stay smooth because the mesh could not be cut there, in units of the mesh
    pub smooth_length: f64,
    /// cells of space, in each of which a few sheets make the surface
    pub cells: i64,
    /// cells in which no maximum and minimum of sheets follows the mesh everywhere
    pub poor_cells: i64,
    /// numbers of two parts of the mesh, from 0, that are nearer to each other than the
    /// tolerance, so that the surface may join them; -1, -1 if none were found
    pub touching_parts: [i32; 2],
    /// place where these parts are near each other
    pub touching_place: [f64; 3],
    /// 1: these parts may go through each other there; 0 if they are near each other only
    pub parts_may_cross: u32,
    pub reserved2: u32,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_mesh_fit_info_init(
        info: *mut hrbfnpr_mesh_fit_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Fits a surface to a mesh, with as many samples as the tolerance takes.  It begins with
    /// some hundred even samples.  In
    /// rounds it adds samples where surface and mesh are far from each other.  Where the surface
    /// goes on far from the mesh,
    /// f is held to the signed distance from the mesh at a few places off it.  These places are
    /// the last centres of the
    /// model.  Their normals point to the mesh or away from it.
    ///
    /// A fit that ends short of the tolerance is no error: `reached` is 0, and the log warns.  It
    /// ends at maximum_centres,
    /// or when more centres gain nothing.  A smooth fit rounds edges by some tenths of the
    /// samples' spacing there.
    ///
    /// A mesh with sharp edges, as `edges` says, is cut along them into smooth patches.  Each
    /// patch gets its own fit, a
    /// sheet.  The surface is a maximum and minimum of sheets, which changes from cell to cell of
    /// space [Ohtake et al.
    /// 2003].  The points and normals of such a model are places all over the mesh, not its centres.
    /// docs/how-fitting-works.md explains how edges are kept.
    ///
    /// The model is trimmed by places on the mesh if the mesh is open, or if the fit did not
    /// reach the tolerance, unless the
    /// trim of `fit` is NEVER.
    ///
    /// `fit` (may be NULL) gives kernel, solver, regularization and trim.  Its points and normals
    /// must be empty, and its
    /// tolerance and maximum_centres 0.  With a smooth fit, a solver_tolerance of 0 is the
    /// tolerance / 200 diagonals, within
    /// 1e-8 .. 1e-5.  `desc`, `info` and `operation` may be NULL.  The call needs the stack of
    /// hrbfnpr_model_fit.
    /// Errors: those of hrbfnpr_model_fit.
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

// 14  PAGE: drawings as vectors: SVG, PDF, HPGL, G-code, DXF

// The format of a file.
/// SVG 1.1, with groups as layers of Inkscape
pub const HRBFNPR_PAGE_FORMAT_SVG: u32 = 0;
/// PDF 1.5, with groups as optional content, which viewers list as layers
pub const HRBFNPR_PAGE_FORMAT_PDF: u32 = 1;
/// HPGL for plotters: absolute coordinates, 40 units per mm, y up from the lower left corner
pub const HRBFNPR_PAGE_FORMAT_HPGL: u32 = 2;
/// G-code for plotters: G0 to G3 in mm, y up from the lower left corner
pub const HRBFNPR_PAGE_FORMAT_GCODE: u32 = 3;
/// DXF of AutoCAD 2004 (AC1018) in mm, y up from the lower left corner, with groups as
/// layers. There is no paper, and ink is cut off at the edges of drawings. Strokes of varying
/// width become polylines with a width at each point, and their outlines are not written.
/// Dots become circles or, as LINES, points
pub const HRBFNPR_PAGE_FORMAT_DXF: u32 = 4;

// How strokes are written whose width varies.
/// filled outlines, in SVG and PDF
pub const HRBFNPR_WIDTHS_OUTLINES: u32 = 0;
/// lines of even widths, whose ratios are powers of `width_step`
pub const HRBFNPR_WIDTHS_CLASSES: u32 = 1;

// How dots are written.
/// circles. Plotters fill them, or with SINGLE_PASS draw their outline
pub const HRBFNPR_DOT_SHAPE_CIRCLES: u32 = 0;
/// lines of length 0 with round ends, at which a plotter touches the paper
pub const HRBFNPR_DOT_SHAPE_LINES: u32 = 1;
/// spirals with which a pen fills the dot, if the dot is wider than the pen
pub const HRBFNPR_DOT_SHAPE_SPIRALS: u32 = 2;

// How the curves of lines of one width are written.  HPGL has straight lines only.
/// arcs of circles where lines consist of them: A in SVG, ARC, CIRCLE and bulges in DXF.
/// Other curves are as with SPLINES. GCODE has arcs (G2, G3) and straight lines only, and PDF
/// has no arcs
pub const HRBFNPR_CURVES_ARCS: u32 = 0;
/// cubic Bezier curves: SPLINE in DXF, G5 in GCODE
pub const HRBFNPR_CURVES_SPLINES: u32 = 1;
/// straight lines, for programs and machines that have neither arcs nor splines
pub const HRBFNPR_CURVES_LINES: u32 = 2;

// Options of a page.
/// sorts each group so that a pen travels little. HPGL and GCODE are always sorted. Lines may
/// be turned round, closed lines may begin elsewhere, and lines whose ends are nearer than
/// `join` become one
pub const HRBFNPR_PAGE_IN_PLOT_ORDER: u32 = 1;
/// draws a line that is wider than its pen once, along its centre. Without this flag, HPGL,
/// GCODE and pens in plot order fill such a line by several passes, side by side. A line up
/// to 1.2 times as wide as its pen takes one pass in any case
pub const HRBFNPR_PAGE_SINGLE_PASS: u32 = 4;
/// leaves out the paper. Without this flag the page has the paper of its first drawing, or
/// white, and drawings with another paper have theirs. Plotters never draw paper
pub const HRBFNPR_PAGE_WITHOUT_PAPER: u32 = 2;

// Types of lines, by the numbers of ISO 128-2.  Lengths in line widths: a dot is 0.5, dashes
// of the three kinds are 6,
// 12 and 24, a gap is 3, a space is 18.  They are stretched a little, so that each line
// begins and ends with a dash.
/// lines as the drawing has them
pub const HRBFNPR_LINE_TYPE_AS_DRAWN: u32 = 0;
/// a continuous line
pub const HRBFNPR_LINE_TYPE_CONTINUOUS: u32 = 1;
/// dashes, for hidden edges
pub const HRBFNPR_LINE_TYPE_DASHED: u32 = 2;
/// dashes with spaces between
pub const HRBFNPR_LINE_TYPE_DASHED_SPACED: u32 = 3;
/// a long dash, then a dot; for axes
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_DOTTED: u32 = 4;
/// a long dash, then two dots
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_DOTTED: u32 = 5;
/// a long dash, then three dots
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_TRIPLE_DOTTED: u32 = 6;
/// dots
pub const HRBFNPR_LINE_TYPE_DOTTED: u32 = 7;
/// a long dash, then a short dash
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_SHORT_DASHED: u32 = 8;
/// a long dash, then two short dashes
pub const HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_SHORT_DASHED: u32 = 9;
/// a dash, then a dot
pub const HRBFNPR_LINE_TYPE_DASHED_DOTTED: u32 = 10;
/// two dashes, then a dot
pub const HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOTTED: u32 = 11;
/// a dash, then two dots
pub const HRBFNPR_LINE_TYPE_DASHED_DOUBLE_DOTTED: u32 = 12;
/// two dashes, then two dots
pub const HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOUBLE_DOTTED: u32 = 13;
/// a dash, then three dots
pub const HRBFNPR_LINE_TYPE_DASHED_TRIPLE_DOTTED: u32 = 14;
/// two dashes, then three dots
pub const HRBFNPR_LINE_TYPE_DOUBLE_DASHED_TRIPLE_DOTTED: u32 = 15;

/// A drawing on a page.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_page_item {
    pub struct_size: u32,
    /// must be 0
    pub reserved: u32,
    /// the drawing, not NULL; what lies beyond its viewport is cut off
    pub drawing: *const hrbfnpr_drawing,
    /// place of the viewport's left edge, in mm; -1e6 .. 1e6; default 0
    pub x: f64,
    /// place of the viewport's top edge, in mm; -1e6 .. 1e6; default 0
    pub y: f64,
    /// mm of a pixel; above 0, up to 1e6; default 25.4 / 96
    pub scale: f64,
    /// name of the group around the drawing, UTF-8; default NULL = no name
    pub name: *const c_char,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_page_item_init(item: *mut hrbfnpr_page_item, struct_size: u32) -> hrbfnpr_status;
}

/// A pen that draws some groups.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_pen {
    pub struct_size: u32,
    /// type of the lines, HRBFNPR_LINE_TYPE_...; default AS_DRAWN
    pub line_type: u32,
    /// the groups: a name, or the beginning of names and a '*'; default NULL = all groups. The
    /// last pen that fits a group draws it
    pub groups: *const c_char,
    /// width of all lines, in mm; 0 .. 1e6; default 0 = as drawn. For plotters it is the width of
    /// the pen, 0.3 if it is 0
    pub width: f64,
    /// colour of the ink, straight RGBA; default alpha 0 = as drawn
    pub ink: [f32; 4],
    /// number of a plotter's pen, 1 .. 255; default 1. If it is for several groups, each ink of a
    /// style's palette has a pen of its own: the group "stipples ink 1" has number + 1, and so
    /// on. Without any pen, the numbers begin at 1
    pub number: u32,
    /// must be 0
    pub reserved: u32,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_pen_init(pen: *mut hrbfnpr_pen, struct_size: u32) -> hrbfnpr_status;
}

/// A line or a text beside the drawings.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_annotation {
    pub struct_size: u32,
    /// type of the line, HRBFNPR_LINE_TYPE_...; default CONTINUOUS
    pub line_type: u32,
    /// name of its group, UTF-8, 1 to 95 bytes; default "annotations". Consecutive annotations of
    /// one group share its layer and pen, and the ink and line type of the first of them
    pub group: *const c_char,
    /// a text, UTF-8; default NULL = the points are a line. HPGL writes texts as labels, GCODE
    /// leaves them out
    pub text: *const c_char,
    /// points of the line, two at least, or the start of the text's baseline, in mm; n x 2,
    /// FLOAT32 or FLOAT64
    pub points: hrbfnpr_array,
    /// width of the line, or height of the text's capitals, in mm; above 0, up to 1e6; default 0.35
    pub width: f64,
    /// colour of the ink, straight RGBA; default black
    pub ink: [f32; 4],
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_annotation_init(
        annotation: *mut hrbfnpr_annotation,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// A page to write.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_page_desc {
    pub struct_size: u32,
    /// format of the file, HRBFNPR_PAGE_FORMAT_...; default SVG
    pub format: u32,
    /// HRBFNPR_PAGE_IN_PLOT_ORDER and others; default 0
    pub flags: u32,
    /// how strokes of varying width are written, HRBFNPR_WIDTHS_...; default OUTLINES
    pub widths: u32,
    /// how dots are written, HRBFNPR_DOT_SHAPE_...; default CIRCLES
    pub dots: u32,
    /// how the curves of lines of one width are written, HRBFNPR_CURVES_...; default ARCS
    pub curves: u32,
    /// width of the page, in mm; 0 .. 1e6; default 0 = as far as the drawings reach
    pub width: f64,
    /// height of the page, in mm; 0 .. 1e6; default 0 = as far as the drawings reach
    pub height: f64,
    /// greatest distance between drawn and written lines, in mm; 0.001 .. 10; default 0.05.
    /// Larger: smaller files, rougher curves
    pub tolerance: f64,
    /// ratio of the widths of two consecutive classes (WIDTHS_CLASSES); 1.01 .. 4; default 1.25
    pub width_step: f64,
    /// in plot order, distance between the ends of two lines below which they become one, in mm;
    /// 0 .. 1e6; default 0 = the pen's width
    pub join: f64,
    /// in plot order, length below which lines are dropped, in mm; 0 .. 1e6; default 0 = half the
    /// pen's width
    pub shortest: f64,
    /// in plot order, distance from a dot that stays below which other dots are dropped, in mm; 0
    /// .. 1e6; default 0 = half the pen's width
    pub dot_distance: f64,
    /// speed of a plotter's pen on the paper, in mm/s; above 0, up to 1e6; default 30
    pub draw_speed: f64,
    /// speed of a plotter's pen above the paper, in mm/s; above 0, up to 1e6; default 80
    pub travel_speed: f64,
    /// seconds that it takes to lower or to raise the pen; 0 .. 3600; default 0.15
    pub pen_seconds: f64,
    /// GCODE: lines that lower the pen; default NULL = "G1 Z0"
    pub pen_down: *const c_char,
    /// GCODE: lines that raise the pen; default NULL = "G0 Z5"
    pub pen_up: *const c_char,
    /// title of the file, UTF-8; default NULL = none
    pub title: *const c_char,
    /// description of the file, UTF-8; default NULL = none
    pub description: *const c_char,
    /// text about the model, the camera or the style, UTF-8; default NULL = none. The library's
    /// version is added
    pub metadata: *const c_char,
    /// a list of drawings; default NULL
    pub items: *const hrbfnpr_page_item,
    /// number of `items`, 0 .. 4096; default 0
    pub item_count: i64,
    /// bytes from one element of `items` to the next; default 0 = struct_size
    pub item_stride: i64,
    /// a list of pens; default NULL
    pub pens: *const hrbfnpr_pen,
    /// number of `pens`, 0 .. 4096; default 0
    pub pen_count: i64,
    /// bytes from one element of `pens` to the next; default 0 = struct_size
    pub pen_stride: i64,
    /// a list of annotations; default NULL
    pub annotations: *const hrbfnpr_annotation,
    /// number of `annotations`, 0 .. 10000000; default 0
    pub annotation_count: i64,
    /// bytes from one element of `annotations` to the next; default 0 = struct_size
    pub annotation_stride: i64,
    /// in plot order, length that the pen draws at most before it is raised, in mm; 1 .. 1e6, or
    /// 0 = no limit; default 0. A longer line is cut into equal parts
    pub longest: f64,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_page_desc_init(desc: *mut hrbfnpr_page_desc, struct_size: u32) -> hrbfnpr_status;
}

/// What was written.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_page_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// bytes of the file
    pub bytes: i64,
    /// groups of ink
    pub groups: i64,
    /// lines and outlines
    pub paths: i64,
    /// curves or straight lines of all paths
    pub segments: i64,
    /// dots
    pub dots: i64,
    /// in plot order, pairs of ends that became one line
    pub joined: i64,
    /// lines dropped because they are too short for the pen
    pub dropped_paths: i64,
    /// dots dropped because they are too near to others for the pen
    pub dropped_dots: i64,
    /// width of the page, in mm
    pub width: f64,
    /// height of the page, in mm
    pub height: f64,
    /// length that a pen draws, in mm; in plot order, else 0
    pub drawn: f64,
    /// length that a pen travels above the paper, in mm; in plot order, else 0
    pub travelled: f64,
    /// time that a plotter takes at the given speeds, in seconds; in plot order, else 0
    pub seconds: f64,
    /// lines wider than their pen, drawn in several passes
    pub filled_paths: i64,
    /// lines longer than `longest`, cut into parts
    pub cut_paths: i64,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_page_info_init(info: *mut hrbfnpr_page_info, struct_size: u32) -> hrbfnpr_status;
    /// Writes a page, one buffer at a time.  Memory grows with the drawing's largest stroke; in
    /// plot order it grows with the
    /// largest group.  `info` and `operation` may be NULL.
    /// Errors: INVALID_ARGUMENT (no drawing and no annotation; an empty page; a text that is not
    /// UTF-8; a drawing with
    /// VISIBILITY_PUBLISHED, which has discs of paper, for plotters, in DXF or in plot order), IO
    /// (`write` failed),
    /// OUT_OF_MEMORY, CANCELLED, CALLBACK.
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

// 15  PICTURE: from any source to a drawing in one call

/// A picture: what was chosen for sources, and made of them.
#[repr(C)]
pub struct hrbfnpr_picture {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Settings of a picture, read from a file.
#[repr(C)]
pub struct hrbfnpr_settings {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

// What is known about a source.
/// says that `sharp_edges` is known, even if it is empty
pub const HRBFNPR_SOURCE_HAS_SHARP_EDGES: u32 = 1;
/// says that `viewpoint` is known
pub const HRBFNPR_SOURCE_HAS_VIEWPOINT: u32 = 2;
/// says that the points are one image of a depth camera that stood at `viewpoint`
pub const HRBFNPR_SOURCE_IS_PHOTO: u32 = 4;

/// Values of a source's points, such as the colours or a quality that a file has at its vertices.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_source_field {
    pub struct_size: u32,
    /// HRBFNPR_FIELD_KIND_...; default SCALAR
    pub kind: u32,
    /// name for styles; UTF-8, 1 to 63 bytes, copied; not NULL
    pub name: *const c_char,
    /// values, one for each point; n x 1 (SCALAR) or n x 3, FLOAT32, FLOAT64 or UINT8. Colours of
    /// UINT8 are 0 .. 255. A point with a value that is not finite has none
    pub values: hrbfnpr_array,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_source_field_init(
        field: *mut hrbfnpr_source_field,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// What is drawn, of one of four kinds: points (with or without normals), a mesh (points and
/// triangles), a model, or a
/// point set.  A model and a point set together are a model with its marks, which are used as
/// they are.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_source {
    pub struct_size: u32,
    /// HRBFNPR_SOURCE_...; default 0
    pub flags: u32,
    /// points, or the vertices of the triangles; n x 3, FLOAT32 or FLOAT64. Points that are not
    /// finite are left out
    pub points: hrbfnpr_array,
    /// normals of the points, of any length; n x 3, FLOAT32 or FLOAT64; not given, or all zero =
    /// no normals. They are not read for a mesh
    pub normals: hrbfnpr_array,
    /// triangles of a mesh, as numbers of points from 0; m x 3, INT32, INT64 or UINT32; not given = points
    pub triangles: hrbfnpr_array,
    /// edges of a mesh, as pairs of vertices, whose faces have separate normals in the file; k x
    /// 2, INT32, INT64 or UINT32; read with HAS_SHARP_EDGES
    pub sharp_edges: hrbfnpr_array,
    /// a model, which the picture keeps; default NULL
    pub model: *const hrbfnpr_model,
    /// a point set, which the picture keeps; default NULL. It must be the only source, unless it
    /// comes with a model
    pub point_set: *const hrbfnpr_point_set,
    /// direction that is up by the convention of the file's format; default 0, 0, 0 = not known
    pub up: [f64; 3],
    /// reason for `up` in notes, such as "PLY files"; default NULL = "files of this kind"
    pub up_by: *const c_char,
    /// place where the scanner stood; read with HAS_VIEWPOINT
    pub viewpoint: [f64; 3],
    /// number of columns of a depth camera's image, whose points are given row by row; default 0
    /// = the points are no image
    pub columns: i64,
    /// number of rows of that image; default 0
    pub rows: i64,
    /// name of the file, for titles and metadata, UTF-8; default NULL
    pub name: *const c_char,
    /// a list of values of the points or vertices, copied; default NULL. Places on the surface
    /// have those of the nearest place of the mesh, or of the nearest point. A layer style that
    /// names one gets it, see hrbfnpr_picture_create
    pub fields: *const hrbfnpr_source_field,
    /// number of `fields`; 0 .. 1000; default 0
    pub field_count: i64,
    /// bytes from one element of `fields` to the next; default 0 = struct_size
    pub field_stride: i64,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_picture_source_init(
        source: *mut hrbfnpr_picture_source,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

// Options of a picture.
/// allows a drawing in which hardly anything can be seen
pub const HRBFNPR_PICTURE_ALLOW_BLANK: u32 = 1;
/// turns all normals, whatever they look like
pub const HRBFNPR_PICTURE_FLIP: u32 = 2;
/// lets the surface go on beyond open data, as the fit has it
pub const HRBFNPR_PICTURE_CLOSE: u32 = 4;
/// fits an open mesh as one surface, even where its parts cross
pub const HRBFNPR_PICTURE_TOGETHER: u32 = 8;
/// makes the paper transparent
pub const HRBFNPR_PICTURE_TRANSPARENT: u32 = 16;
/// gives all layers all their marks, even if the style draws lines only, and even those that
/// the planned camera does not need; for marks that are saved, or drawn by a renderer of the
/// caller
pub const HRBFNPR_PICTURE_KEEP_MARKS: u32 = 32;
/// makes the model only: chooses no camera, places no marks, looks for no lines
pub const HRBFNPR_PICTURE_SURFACE_ONLY: u32 = 64;
/// says that the source is a part of a solid, so that up is y
pub const HRBFNPR_PICTURE_IS_SOLID: u32 = 128;
/// compares all lines with rays, and repairs wrong parts (verify_lines of the style); a note
/// has the counts
pub const HRBFNPR_PICTURE_VERIFY: u32 = 256;

// Which edges of a mesh are sharp.
/// edges are found as with AUTO. Where faces are coarse, the normals of the file decide if
/// they say anything about edges
pub const HRBFNPR_PICTURE_EDGES_AS_GIVEN: u32 = 0;
/// edges are found by HRBFNPR_EDGES_AUTO
pub const HRBFNPR_PICTURE_EDGES_AUTO: u32 = 1;
/// no edge is sharp (HRBFNPR_EDGES_SMOOTH)
pub const HRBFNPR_PICTURE_EDGES_SMOOTH: u32 = 2;
/// edges are sharp that bend by more than `edge_angle` (HRBFNPR_EDGES_SHARP)
pub const HRBFNPR_PICTURE_EDGES_SHARP: u32 = 3;

// Whether an upright section through the middle is drawn beside the drawing.
/// a section is drawn in the style archaeological only
pub const HRBFNPR_PROFILE_AUTO: u32 = 0;
/// a section is drawn
pub const HRBFNPR_PROFILE_YES: u32 = 1;
/// no section is drawn
pub const HRBFNPR_PROFILE_NO: u32 = 2;

// The sides of a surface on which marks are drawn.
/// both sides of a surface that ends, and the front of other surfaces
pub const HRBFNPR_PICTURE_SIDES_AUTO: u32 = 0;
/// the front (HRBFNPR_SIDES_FRONT)
pub const HRBFNPR_PICTURE_SIDES_FRONT: u32 = 1;
/// both sides (HRBFNPR_SIDES_BOTH)
pub const HRBFNPR_PICTURE_SIDES_BOTH: u32 = 2;

// The ground of a picture: a plane under the object, on which only what darkens it is drawn,
// which is cast shadows and
// the sky that the object hides.  Its marks are a layer named "ground", of stipples or
// hatching as the style draws.
// Open ground is white.  It casts no shadow and hides nothing.  If no light of the style
// casts shadows, the first one
// casts them on the ground, and only there.  The ground is not drawn by cameras below it.
/// no ground
pub const HRBFNPR_PICTURE_GROUND_NONE: u32 = 0;
/// at the lowest place of the object along the up direction
pub const HRBFNPR_PICTURE_GROUND_LOWEST: u32 = 1;
/// at ground_height along the up direction
pub const HRBFNPR_PICTURE_GROUND_HEIGHT: u32 = 2;

// How notes and errors write the options that they name.
/// as fields of a descriptor: samples 400
pub const HRBFNPR_WORDING_FIELDS: u32 = 0;
/// as options of a command line: --samples 400
pub const HRBFNPR_WORDING_OPTIONS: u32 = 1;
/// as arguments of a call in Python: samples=400
pub const HRBFNPR_WORDING_ARGUMENTS: u32 = 2;

/// A field to change after everything was chosen.  `field` is the path of the field:
///
///    style.F            a field of hrbfnpr_style; style.ink is the ink of all layers, lines
/// and contours
///    style.KIND.F       a field of hrbfnpr_layer_style, for one kind of layers: style.hatch.ink
///    style.layers.F     the same for all layers of the style; share is multiplied
///    style.lines.F      a field of hrbfnpr_line_style, for all lines
///    style.LINE.F       the same for one kind of lines: style.ridge.width
///    style.palette      inks for ink fields, #rrggbb with commas between; empty = up to
/// three, from the colours
///    style.field        what fields of the source change, as USE=NAME with commas between:
/// "tone=quality,ink=rgb".  USE
///                       is tone, density, width, ink, mask or direction.  The first five set
/// style.layers.tone_field
///                       and so on, the last sets marks.direction_field.  Without a NAME, the use ends
///    marks.direction_field  name of a DIRECTION field of the source, which hatching follows
///    fit.F              a field of hrbfnpr_fit_desc
///    mesh_fit.F         a field of hrbfnpr_mesh_fit_desc
///    marks.F            a field of hrbfnpr_generate_desc
///    marks.KIND.F       a field of hrbfnpr_layer_desc, for one kind of layers;
/// marks.layers.F for all layers
///    line_set.F         a field of hrbfnpr_line_set_desc
///
/// Lengths in pixels are those of this picture: they are not scaled by the pen.  The last
/// change of a field counts.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_change {
    pub struct_size: u32,
    pub reserved: u32,
    /// path of the field, UTF-8
    pub field: *const c_char,
    /// new value: a number, several numbers with commas between, a colour as #rrggbb or
    /// #rrggbbaa, or the name of a constant without its prefix, such as "blue-noise"
    pub value: *const c_char,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_change_init(change: *mut hrbfnpr_change, struct_size: u32) -> hrbfnpr_status;
}

// The stages of the work.
/// looks at a mesh: joins vertices, turns faces
pub const HRBFNPR_STAGE_MESH: u32 = 1;
/// chooses samples
pub const HRBFNPR_STAGE_SAMPLE: u32 = 2;
/// finds normals
pub const HRBFNPR_STAGE_ORIENT: u32 = 3;
/// smooths the image of a depth camera
pub const HRBFNPR_STAGE_SMOOTH: u32 = 4;
/// fits the surface
pub const HRBFNPR_STAGE_FIT: u32 = 5;
/// compares the surface with the mesh
pub const HRBFNPR_STAGE_COMPARE: u32 = 6;
/// finds the end of the surface
pub const HRBFNPR_STAGE_END: u32 = 7;
/// places marks
pub const HRBFNPR_STAGE_MARKS: u32 = 8;
/// finds lines
pub const HRBFNPR_STAGE_LINES: u32 = 9;
/// draws
pub const HRBFNPR_STAGE_FRAME: u32 = 10;
/// draws the views of a sheet
pub const HRBFNPR_STAGE_VIEWS: u32 = 11;
/// finds occlusion and cast shadows
pub const HRBFNPR_STAGE_SHADE: u32 = 12;

// How much a note matters.
/// a measurement
pub const HRBFNPR_SEVERITY_INFO: u32 = 0;
/// something was chosen, repaired or left out
pub const HRBFNPR_SEVERITY_NOTE: u32 = 1;
/// the result may be wrong in some place
pub const HRBFNPR_SEVERITY_WARNING: u32 = 2;
/// there is no result: the text is the error of the call, in full length
pub const HRBFNPR_SEVERITY_FAILURE: u32 = 3;

// Codes of notes.  Each line says when a note is given, with its figures in brackets; [] =
// no figures.  Figures are
// counts unless a line says otherwise.  Shares are 0 .. 1.
/// faces with a corner that is not finite are left out [faces]
pub const HRBFNPR_NOTE_FACES_NOT_FINITE: u32 = 1;
/// points at a value that means "no data" are left out [points, the value]
pub const HRBFNPR_NOTE_NO_DATA: u32 = 2;
/// points far from all others are left out [points]
pub const HRBFNPR_NOTE_STRAYS: u32 = 3;
/// only some of the points get normals, because there are many [points, points with normals]
pub const HRBFNPR_NOTE_SOME_ORIENTED: u32 = 4;
/// the points have no normals, and get some [points]
pub const HRBFNPR_NOTE_NORMALS_MADE: u32 = 5;
/// normals that were found are not certain [confidence, 0 .. 1]
pub const HRBFNPR_NOTE_NORMALS_NOT_SURE: u32 = 6;
/// the surface is open, and nothing tells which side is its front []
pub const HRBFNPR_NOTE_FRONT_NOT_TOLD: u32 = 7;
/// only some points are used as samples [points, points used]
pub const HRBFNPR_NOTE_SAMPLES_CHOSEN: u32 = 8;
/// points without a usable position or normal are left out [points]
pub const HRBFNPR_NOTE_POINTS_NOT_USABLE: u32 = 9;
/// places with several normals get the mean of these [places]
pub const HRBFNPR_NOTE_NORMALS_JOINED: u32 = 10;
/// places with opposite normals are left out [places]
pub const HRBFNPR_NOTE_NORMALS_OPPOSITE: u32 = 11;
/// a terrain looked down, and its normals are turned [axis: 1 = y, 2 = z]
pub const HRBFNPR_NOTE_TERRAIN_TURNED: u32 = 12;
/// all normals looked inward, and are turned []
pub const HRBFNPR_NOTE_NORMALS_TURNED: u32 = 13;
/// given normals are repaired [normals turned, normals made, what they were: HRBFNPR_NORMALS_...]
pub const HRBFNPR_NOTE_NORMALS_REPAIRED: u32 = 14;
/// some normals look against those around them [these normals, all normals]
pub const HRBFNPR_NOTE_NORMALS_AGAINST: u32 = 15;
/// some parts have outward normals and others inward ones [share that looks inward]
pub const HRBFNPR_NOTE_NORMALS_MIXED: u32 = 16;
/// most of an open surface looks inward []
pub const HRBFNPR_NOTE_NORMALS_INWARD: u32 = 17;
/// `viewpoint` is given, but the source needs none []
pub const HRBFNPR_NOTE_VIEWPOINT_NOT_USED: u32 = 18;
/// pixels of a depth camera that lie on no surface are left out [pixels]
pub const HRBFNPR_NOTE_PIXELS_LEFT_OUT: u32 = 19;
/// the noise of a depth camera was measured [standard deviation, depth where it holds; units
/// of the source]
pub const HRBFNPR_NOTE_DEPTH_NOISE: u32 = 20;
/// the samples have noise, and the surface does not pass through all of them []
pub const HRBFNPR_NOTE_SMOOTHED: u32 = 21;
/// samples at the same place are merged [samples]
pub const HRBFNPR_NOTE_SAMPLES_MERGED: u32 = 22;
/// samples very near to another are merged with it [samples]
pub const HRBFNPR_NOTE_SAMPLES_NEAR: u32 = 23;
/// samples are dropped as strays [samples]
pub const HRBFNPR_NOTE_SAMPLES_DROPPED: u32 = 24;
/// flipped normals of samples are repaired [samples]
pub const HRBFNPR_NOTE_SAMPLES_FLIPPED: u32 = 25;
/// samples that look like strays are kept [samples]
pub const HRBFNPR_NOTE_LIKE_STRAYS: u32 = 26;
/// samples whose normals look flipped are kept [samples]
pub const HRBFNPR_NOTE_LIKE_FLIPPED: u32 = 27;
/// the surface is a guess, because there are few points [points]
pub const HRBFNPR_NOTE_FEW_POINTS: u32 = 28;
/// all points are on a line []
pub const HRBFNPR_NOTE_ON_A_LINE: u32 = 29;
/// all points are in a plane []
pub const HRBFNPR_NOTE_IN_A_PLANE: u32 = 30;
/// the points lie along curves, and the surface between these is drawn, too []
pub const HRBFNPR_NOTE_ALONG_CURVES: u32 = 31;
/// the end of the surface was not found, and the surface goes on to the end of its box []
pub const HRBFNPR_NOTE_END_NOT_FOUND: u32 = 32;
/// another direction than y is chosen as up [x, y, z]
pub const HRBFNPR_NOTE_UP: u32 = 33;
/// faces that looked to the other side than those beside them are turned [faces]
pub const HRBFNPR_NOTE_FACES_TURNED: u32 = 34;
/// a mesh, or some of its parts, is inside out, and is turned [parts]
pub const HRBFNPR_NOTE_INSIDE_OUT: u32 = 35;
/// faces without area, and repeated faces, are left out [faces]
pub const HRBFNPR_NOTE_FACES_LEFT_OUT: u32 = 36;
/// parts of a mesh inside others are left out [parts, their faces]
pub const HRBFNPR_NOTE_PARTS_INSIDE: u32 = 37;
/// faces beside each other look to opposite sides and cannot be turned: the surface has one
/// side, or crosses itself [edges]
pub const HRBFNPR_NOTE_CONTRARY_EDGES: u32 = 38;
/// parts of a mesh far from all others are left out [parts, their faces]
pub const HRBFNPR_NOTE_PARTS_FAR: u32 = 39;
/// faces that hang on an edge of two others are left out [faces]
pub const HRBFNPR_NOTE_FLAPS: u32 = 40;
/// all faces stay flat, because the normals of the file say so []
pub const HRBFNPR_NOTE_ALL_FLAT: u32 = 41;
/// some edges are sharp, because the normals of the file say so []
pub const HRBFNPR_NOTE_EDGES_BY_NORMALS: u32 = 42;
/// coarse faces are divided towards a round surface [rounds; how far vertices moved; how far
/// places between them were raised; how far the faces were off a round surface, if they are
/// coarse; shares of the diagonal]
pub const HRBFNPR_NOTE_DIVIDED: u32 = 43;
/// coarse faces stay flat, because no round surface goes through them []
pub const HRBFNPR_NOTE_COARSE_FLAT: u32 = 44;
/// parts of a mesh that cross or are close are fitted in groups, each as a separate surface
/// [parts, groups]
pub const HRBFNPR_NOTE_GROUPS: u32 = 45;
/// the fit did not reach its tolerance everywhere [tolerance in diagonals, share of the mesh
/// within it, share of the surface within it, greatest distance in diagonals]
pub const HRBFNPR_NOTE_NOT_REACHED: u32 = 46;
/// some sharp edges of a mesh stay smooth [their length in diagonals]
pub const HRBFNPR_NOTE_EDGES_STAY_SMOOTH: u32 = 47;
/// the surface is far from the mesh in some places [share of the mesh, greatest distance in diagonals]
pub const HRBFNPR_NOTE_OFF_MESH: u32 = 48;
/// the fit made parts of surface that the mesh does not have, and they are left out [parts]
pub const HRBFNPR_NOTE_MADE_BY_FIT: u32 = 49;
/// two parts of a mesh are nearer to each other than the tolerance, so that the surface may
/// join them [numbers of both parts, from 0; x, y and z of the place]
pub const HRBFNPR_NOTE_PARTS_TOO_THIN: u32 = 50;
/// a layer has fewer marks than fill the darkest tone [marks wanted, marks made]
pub const HRBFNPR_NOTE_MARKS_LIMITED: u32 = 51;
/// the published method makes fewer refinement steps than fill the picture [steps wanted, steps made]
pub const HRBFNPR_NOTE_LEVELS_LIMITED: u32 = 52;
/// the image of a depth camera is seen from where the camera stood [azimuth in degrees]
pub const HRBFNPR_NOTE_SEEN_FROM_CAMERA: u32 = 53;
/// an open surface is seen from its front [azimuth in degrees]
pub const HRBFNPR_NOTE_SEEN_FROM_FRONT: u32 = 54;
/// no lines are drawn, because the source is a point set without a model []
pub const HRBFNPR_NOTE_NO_LINES_OF_MARKS: u32 = 55;
/// the surface is thinner than the cells in which lines are searched, so that lines may be
/// missing [triangles that look away, all triangles, samples missed]
pub const HRBFNPR_NOTE_LINES_THIN: u32 = 56;
/// lines end where the surface ends beyond its samples [borders, support, share of the area left out]
pub const HRBFNPR_NOTE_LINES_END: u32 = 57;
/// some curves end inside the surface, or were missed [curves]
pub const HRBFNPR_NOTE_LINES_BROKEN: u32 = 58;
/// the visibility of some lines contradicts itself [lines]
pub const HRBFNPR_NOTE_LINES_DOUBTED: u32 = 59;
/// lines cross so often in some places of the picture that no crossing was used [places]
pub const HRBFNPR_NOTE_LINES_TANGLED: u32 = 60;
/// hardly anything can be seen [marks shown, all marks, share of the picture that ink covers]
pub const HRBFNPR_NOTE_BLANK: u32 = 61;
/// pens are chosen by the widths at hand []
pub const HRBFNPR_NOTE_PENS: u32 = 62;
/// a plotter's file is written [metres drawn, metres travelled, seconds]
pub const HRBFNPR_NOTE_PLOTTED: u32 = 63;
/// something that the picture was made with is not in its settings []
pub const HRBFNPR_NOTE_NOT_IN_SETTINGS: u32 = 64;
/// the unit of the source is taken as a metre, because its format says so []
pub const HRBFNPR_NOTE_UNIT_IS_METRE: u32 = 65;
/// centre lines are asked for, but no plane of symmetry was found []
pub const HRBFNPR_NOTE_NO_SYMMETRY: u32 = 66;
/// outlines of a cut are not closed, and are not hatched [outlines]
pub const HRBFNPR_NOTE_SECTION_OPEN: u32 = 67;
/// normals get the length 1 [normals]
pub const HRBFNPR_NOTE_NORMALS_NOT_UNIT: u32 = 68;
/// all points are at one place []
pub const HRBFNPR_NOTE_AT_ONE_PLACE: u32 = 69;
/// the source is so far from the origin that single precision loses its details []
pub const HRBFNPR_NOTE_FAR_FROM_ORIGIN: u32 = 70;
/// vertices at the place of another are joined with it [vertices]
pub const HRBFNPR_NOTE_VERTICES_JOINED: u32 = 71;
/// vertices of no face are left out [vertices]
pub const HRBFNPR_NOTE_VERTICES_UNUSED: u32 = 72;
/// edges have more than two faces [edges]
pub const HRBFNPR_NOTE_NONMANIFOLD_EDGES: u32 = 73;
/// a mesh is open [borders, their edges]
pub const HRBFNPR_NOTE_MESH_OPEN: u32 = 74;
/// a mesh has several parts [parts]
pub const HRBFNPR_NOTE_SEVERAL_PARTS: u32 = 75;
/// a source cannot be drawn; the text says why []
pub const HRBFNPR_NOTE_NOT_USABLE: u32 = 76;
/// no ground is drawn; the text says why []
pub const HRBFNPR_NOTE_NO_GROUND: u32 = 77;
/// inks are chosen from the colours of the source [inks]
pub const HRBFNPR_NOTE_PALETTE_CHOSEN: u32 = 78;
/// borders of shadows are to be drawn, and no light casts shadows []
pub const HRBFNPR_NOTE_NO_SHADOWS: u32 = 79;
/// rays were compared with all parts of lines [decided parts, those that agree, undecided
/// parts, repaired parts]
pub const HRBFNPR_NOTE_LINES_VERIFIED: u32 = 95;

/// A note: something that was chosen, repaired, left out or measured, or that may be wrong.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_note {
    pub struct_size: u32,
    /// what it is about, HRBFNPR_NOTE_...
    pub code: u32,
    /// how much it matters, HRBFNPR_SEVERITY_...
    pub severity: u32,
    /// number of `figures` that are set, 0 .. 8
    pub figure_count: u32,
    /// figures of the code, in the order of its brackets
    pub figures: [f64; 8],
    /// a short sentence without a full stop, UTF-8, in the words of `wording`; at most 100 bytes
    /// for notes and warnings
    pub text: *const c_char,
    /// what to do about it, in the same words; NULL if the text says it or nothing needs doing
    pub advice: *const c_char,
    /// one or two more sentences that explain the text, in the same words; NULL if none
    pub detail: *const c_char,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_note_init(note: *mut hrbfnpr_note, struct_size: u32) -> hrbfnpr_status;
}

/// What happens while a picture is made: a new note, or the progress of a stage.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_event {
    pub struct_size: u32,
    /// stage that runs, HRBFNPR_STAGE_...; 0 = none runs
    pub stage: u32,
    /// progress of the stage: 0 when it begins, 1 when it ends; 0 with a note
    pub fraction: f64,
    /// time that the stage took, when it ends; else 0
    pub seconds: f64,
    /// name of the stage, such as "place marks"; NULL with a note
    pub name: *const c_char,
    /// the same for a progress bar, such as "placing marks"; NULL with a note
    pub doing: *const c_char,
    /// result of the stage in words, when it ends; else NULL
    pub says: *const c_char,
    /// a new note; NULL = the event is about the stage
    pub note: *const hrbfnpr_note,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_picture_event_init(
        event: *mut hrbfnpr_picture_event,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// Gets an event.  It runs on the thread that entered the library.  The event lives during
/// the call only.
pub type hrbfnpr_picture_event_fn =
    Option<unsafe extern "C" fn(user: *mut c_void, event: *const hrbfnpr_picture_event)>;

/// How a picture is made.  Each field has a default that makes a good picture.  A source is
/// enough, and a style if
/// wanted.  A default of NaN, 0 or NULL is chosen by the picture, as its line says.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_desc {
    pub struct_size: u32,
    /// HRBFNPR_PICTURE_...; default 0
    pub flags: u32,
    /// a list of 1 to 10000 sources, each a separate surface; NULL for hrbfnpr_picture_restyle
    pub sources: *const hrbfnpr_picture_source,
    /// number of `sources`; default 0
    pub source_count: i64,
    /// bytes from one element of `sources` to the next; default 0 = struct_size
    pub source_stride: i64,
    /// named style, HRBFNPR_PRESET_...; default CONTOUR_AND_STIPPLE
    ///
    /// Style.
    pub preset: u32,
    /// how notes and errors write options, HRBFNPR_WORDING_...; default FIELDS
    pub wording: u32,
    /// name of a preset, in place of its number; default NULL
    pub style_name: *const c_char,
    /// a style to use as it is, with lengths in pixels of this picture; default NULL. `preset`
    /// then says which layers of marks there are
    pub style: *const hrbfnpr_style,
    /// settings for what this descriptor leaves at its defaults; the picture keeps them; default NULL
    pub settings: *const hrbfnpr_settings,
    /// a list of fields to change; default NULL
    pub changes: *const hrbfnpr_change,
    /// number of `changes`; default 0
    pub change_count: i64,
    /// bytes from one element of `changes` to the next; default 0 = struct_size
    pub change_stride: i64,
    /// a list of dabs that paint the surface; default NULL
    pub dabs: *const hrbfnpr_dab,
    /// number of `dabs`, 0 .. 1000000; default 0
    pub dab_count: i64,
    /// bytes from one element of `dabs` to the next; default 0 = struct_size
    pub dab_stride: i64,
    /// width of the drawing, in pixels, 1 .. 32768, given with `height`; default 0 = from `size`
    ///
    /// Size, in pixels.
    pub width: i32,
    /// height of the drawing, in pixels, 1 .. 32768, given with `width`; default 0 = from `size`
    pub height: i32,
    /// longer side of the drawing, in pixels, 1 .. 32768; the shorter side is as the object needs
    /// it; default 0 = 1600
    pub size: i32,
    /// sides on which marks are drawn, HRBFNPR_PICTURE_SIDES_...; default AUTO
    pub sides: u32,
    /// radius of the pen in pixels, which styles vary a little; 1e-6 .. 1e6; default 0 = an 800th
    /// of the longer side, at least 0.75
    pub pen: f64,
    /// width of contours, in pixels; other lines are finer; 1e-6 .. 1e6; default 0 = that of the style
    pub line_width: f64,
    /// a camera to use as it is, with its viewport as the size; default NULL
    ///
    /// Camera.
    pub camera: *const hrbfnpr_camera,
    /// direction that is up; default 0, 0, 0 = by the format and the shape, or y where neither tells
    pub up: [f64; 3],
    /// azimuth of the camera about the up axis, from the front to the right, in degrees; default
    /// NaN = 30, and another where that sees the back of an open surface
    pub azimuth: f64,
    /// elevation of the camera above the horizon, in degrees; default NaN = 20
    pub elevation: f64,
    /// direction from the eye into the scene, in place of azimuth and elevation; default 0, 0, 0
    /// = not given
    pub direction: [f64; 3],
    /// place of the eye, which looks at `target`; default NaN = not given
    pub eye: [f64; 3],
    /// place that the eye looks at; default NaN = the middle of the model
    pub target: [f64; 3],
    /// vertical angle of view, in degrees, 0.01 .. 179; 0 = orthographic; default NaN = 30, or 0
    /// in the style archaeological
    pub fov: f64,
    /// share of the picture that is free on each side, 0 .. 0.45; default NaN = 0.05
    pub margin: f64,
    /// angle of an orbit that starts here, in degrees; the picture has room for all of it;
    /// default 0 = a still picture
    pub turn: f64,
    /// number of frames of that orbit, 1 .. 1000000; default 36
    pub turn_frames: i32,
    /// what is known of the normals of points, HRBFNPR_NORMALS_...; default AUTO
    ///
    /// From the source to a surface.
    pub normals: u32,
    /// number of samples of a mesh, or chosen from points, 0 .. 1e9; default 0 = as many as a
    /// mesh needs, and of points all up to 4096
    pub samples: i64,
    /// samples are chosen until the surface is this near to the mesh, or to all points, in units
    /// of the source; 0 or more; default 0 = 0.002 diagonals for a mesh, and no such end for
    /// points
    pub tolerance: f64,
    /// the most samples that are chosen, 0 or more; default 0 = 8000 for a mesh, and no limit for points
    pub maximum_centres: i64,
    /// parts of a mesh that are kept, HRBFNPR_PARTS_...; default AUTO
    pub parts: u32,
    /// edges of a mesh that are sharp, HRBFNPR_PICTURE_EDGES_...; default AS_GIVEN
    pub edges: u32,
    /// angle between the normals of two faces, in degrees, above which their edge is sharp, with
    /// EDGES_SHARP; 5 .. 175; default 30
    pub edge_angle: f64,
    /// angle between the normals of two faces, in degrees, above which they do not share corner
    /// normals; 0 .. 180; default NaN = 60
    pub crease_angle: f64,
    /// how often faces are divided into four towards a round surface, 0 .. 6; default -1 = where
    /// faces are coarse and no edges stand out
    pub subdivide: i32,
    /// whether a section is drawn beside the drawing, HRBFNPR_PROFILE_...; default AUTO
    pub profile: u32,
    /// place where the scanner stood, to which open surfaces without normals look; default NaN =
    /// as the source says
    pub viewpoint: [f64; 3],
    /// factor of the width over which the image of a depth camera is smoothed, 0 .. 100; 0 leaves
    /// its points where they are; default NaN = 1
    pub depth_smoothing: f64,
    /// seed of all random numbers; default 1
    pub random_seed: u64,
    /// kinds of layers of marks with commas between, such as "stipples,hatch"; default NULL =
    /// those of the style
    ///
    /// Marks, lines, and what stands beside the drawing.
    pub mark_kinds: *const c_char,
    /// points where marks of the published method start; n x 3, FLOAT32 or FLOAT64; not given =
    /// by seed_source of hrbfnpr_generate_desc
    pub seed_points: hrbfnpr_array,
    /// angle by which all lines of hatching are turned, in degrees, -360 .. 360; default 0
    pub hatch_angle: f64,
    /// kinds of lines with commas between: contour, suggestive, ridges, valleys, apparent,
    /// parabolic, isophotes=0.3:0.6, section=z:20, border, crease, shadow, terminator, soft,
    /// tangent; "none" = no lines, so that contours are drawn by marks with VISIBILITY_PUBLISHED
    /// only; default NULL = those of the style
    pub lines: *const c_char,
    /// unit of a scale bar below the drawing; "none" = no bar; default NULL = "units" in the
    /// style archaeological, else "none"
    pub scale_bar: *const c_char,
    /// gets events for as long as the picture lives; default NULL
    pub on_event: hrbfnpr_picture_event_fn,
    /// passed to on_event; it must outlive the picture
    pub event_user: *mut c_void,
    /// whether the picture has a ground, and where, HRBFNPR_PICTURE_GROUND_...; default NONE
    ///
    /// Ground.
    pub ground: u32,
    pub reserved: u32,
    /// height of the ground with GROUND_HEIGHT along the unit vector of the up direction, in
    /// units of the source; default 0
    pub ground_height: f64,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_picture_desc_init(
        desc: *mut hrbfnpr_picture_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

// The kind of a source.
/// points, with or without normals
pub const HRBFNPR_SOURCE_KIND_POINTS: u32 = 1;
/// a mesh
pub const HRBFNPR_SOURCE_KIND_MESH: u32 = 2;
/// a model, with or without marks
pub const HRBFNPR_SOURCE_KIND_MODEL: u32 = 3;
/// a point set without a model
pub const HRBFNPR_SOURCE_KIND_POINT_SET: u32 = 4;

// Which way normals look.
/// there are no normals, or the source cannot be drawn
pub const HRBFNPR_NORMALS_LOOK_UNKNOWN: u32 = 0;
/// all look outward
pub const HRBFNPR_NORMALS_LOOK_OUTWARD: u32 = 1;
/// all look inward
pub const HRBFNPR_NORMALS_LOOK_INWARD: u32 = 2;
/// some look outward, others inward
pub const HRBFNPR_NORMALS_LOOK_MIXED: u32 = 3;
/// they agree, and the surface encloses nothing
pub const HRBFNPR_NORMALS_LOOK_OPEN: u32 = 4;
/// they belong to other points; found for points along curves only
pub const HRBFNPR_NORMALS_LOOK_FOREIGN: u32 = 5;

/// What a source holds.  A field that does not apply to the kind of source is 0.  If the
/// source cannot be drawn, fields
/// that were not examined any more are 0.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_source_info {
    pub struct_size: u32,
    /// kind of the source, HRBFNPR_SOURCE_KIND_...
    pub kind: u32,
    /// severity of the worst finding, HRBFNPR_SEVERITY_...: INFO = no finding; NOTE = a picture
    /// repairs it; WARNING = something is wrong; FAILURE = it cannot be drawn
    pub severity: u32,
    /// which way the normals of points or faces look, HRBFNPR_NORMALS_LOOK_...
    pub normals_look: u32,
    /// points as given: points, vertices of a mesh, centres of a model, marks of a point set
    pub points: i64,
    /// triangles as given
    pub triangles: i64,
    /// points at a value that means "no data"; all fields below leave them out
    pub no_data: i64,
    /// points far from all others; all fields below leave them out
    pub strays: i64,
    /// points without a finite position
    pub points_not_finite: i64,
    /// points, or vertices of faces, at the place of another
    pub duplicates: i64,
    /// least coordinates of the finite points
    pub bounds_min: [f64; 3],
    /// greatest coordinates of the finite points
    pub bounds_max: [f64; 3],
    /// diagonal of these bounds
    pub diagonal: f64,
    /// direction that a picture chooses as up, for points and meshes; up_reason says why
    pub up: [f64; 3],
    /// 1: some normals are given that are not zero
    ///
    /// Normals of points. looks_down, normals_closed and normals_flipped_share are set for faces, too.
    pub has_normals: u32,
    /// 1: the points lie along curves, such as wires or cross sections
    pub along_curves: u32,
    /// axis along which a terrain looks down: 1 = y, 2 = z; 0 = it does not, or is no terrain
    pub looks_down: u32,
    pub reserved: u32,
    /// normals that are zero
    pub normals_zero: i64,
    /// normals that are not finite
    pub normals_not_finite: i64,
    /// share of the usable normals that have length 1, 0 .. 1
    pub normals_unit_share: f64,
    /// median over the samples of the sum of the winding numbers on both sides: 1 = closed and
    /// outward, -1 = inward, 0 = a flat sheet; 0 for points along curves
    pub normals_closed: f64,
    /// share of the normals that look flipped beside their neighbours, 0 .. 1; 0 for points along curves
    pub normals_flipped_share: f64,
    /// pixels that have a point
    ///
    /// The image of a depth camera, if it has no normals.
    pub image_seen: i64,
    /// pixels among these that lie on no surface
    pub image_dropped: i64,
    /// median depth of the pixels that have a point
    pub image_depth: f64,
    /// standard deviation of the depth, at that depth
    pub image_noise: f64,
    /// 1: each edge has two faces, which run along it in opposite directions
    ///
    /// A mesh as it was given, except that vertices at the same place are joined.
    pub closed: u32,
    /// 1: the mesh is closed, and its faces look inward
    pub inside_out: u32,
    /// parts that share no vertex
    pub components: i64,
    /// parts without a border whose faces look inward; inside another part it is a cavity
    pub components_inside_out: i64,
    /// edges with one face
    pub boundary_edges: i64,
    /// borders
    pub boundary_loops: i64,
    /// edges with more than two faces
    pub nonmanifold_edges: i64,
    /// edges among these that hrbfnpr_mesh_create cannot mend
    pub nonmanifold_left: i64,
    /// edges with two faces, one of which is turned over
    pub contrary_edges: i64,
    /// faces with a corner that is not finite
    pub faces_not_finite: i64,
    /// faces without area
    pub degenerate_faces: i64,
    /// faces with the same corners as another
    pub repeated_faces: i64,
    /// vertices of no face
    pub unused_vertices: i64,
    /// area, in squared units of the source
    pub area: f64,
    /// enclosed volume, in cubed units of the source; 0 if the mesh is not closed
    pub volume: f64,
    /// reason for `up`, such as "as in PLY files"; "" = up is not known
    pub up_reason: [c_char; 128],
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_source_info_init(
        info: *mut hrbfnpr_source_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Looks at a source without drawing it.  It puts facts into `info`, and passes findings to
    /// on_event as notes.  A NOTE
    /// is something that a picture repairs.  A WARNING is something that is wrong, with advice.
    /// One matter may give both.
    /// A FAILURE, with the code NOT_USABLE, says why the source cannot be drawn; the call
    /// succeeds all the same.  `wording`
    /// is HRBFNPR_WORDING_...; on_event and `operation` may be NULL.
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
    /// Makes a picture: fits surfaces, places marks and finds lines.  It draws nothing yet.
    /// `operation` may be NULL.  The
    /// call needs the stack of hrbfnpr_model_fit.
    ///
    /// A field of a layer style (tone_field and so on) names values of the source
    /// (hrbfnpr_source_field), or a field of its
    /// point set.  For numbers of a source, the name may say which value becomes 0 and which
    /// becomes 1, as in
    /// "quality:0.2..0.9"; else they are the least and the greatest value that is finite.
    /// Outliers do not count for this:
    /// values farther from the inner 96 % than a quarter of the range of these.  "-quality" turns
    /// this round.
    /// A colour in place of a number is its luminance, as in HRBFNPR_FIELD_SOURCE_IMAGE.  An
    /// ink_field without a palette
    /// gets one of three inks, or of up to eight if there are no more hues; a note names them.
    ///
    /// Errors: INVALID_ARGUMENT (a field of `desc`; a source that cannot be drawn),
    /// SINGULAR_SYSTEM, NOT_CONVERGED,
    /// OUT_OF_MEMORY, CANCELLED, CALLBACK.
    pub fn hrbfnpr_picture_create(
        context: *mut hrbfnpr_context,
        desc: *const hrbfnpr_picture_desc,
        operation: *mut hrbfnpr_operation,
        out_picture: *mut *mut hrbfnpr_picture,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Makes a picture of the same surfaces in another style, size or view.  `desc` has no
    /// sources.  Marks and lines that
    /// fit are used again; others are made anew.  `operation` may be NULL.
    /// Errors: those of hrbfnpr_picture_create; INVALID_ARGUMENT, too, if the picture was made
    /// with SURFACE_ONLY.
    pub fn hrbfnpr_picture_restyle(
        picture: *const hrbfnpr_picture,
        desc: *const hrbfnpr_picture_desc,
        operation: *mut hrbfnpr_operation,
        out_picture: *mut *mut hrbfnpr_picture,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_picture_retain(picture: *mut hrbfnpr_picture);
    /// Releases a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_picture_release(picture: *mut hrbfnpr_picture);
    /// Draws a picture.  `camera` NULL is the planned camera.  Lines keep their numbers from one
    /// drawing to the next.
    /// Without KEEP_MARKS and without a turn, the picture has only the marks that the planned
    /// camera needs.  The first
    /// drawing by another camera then places all marks, and takes longer.
    /// `operation` may be NULL.
    /// Errors: INVALID_ARGUMENT (the camera; a picture made with SURFACE_ONLY; with the planned
    /// camera, a drawing in which
    /// hardly anything can be seen, unless ALLOW_BLANK is set: a note BLANK says more),
    /// OUT_OF_MEMORY, CANCELLED,
    /// CALLBACK.
    pub fn hrbfnpr_picture_draw(
        picture: *mut hrbfnpr_picture,
        camera: *const hrbfnpr_camera,
        operation: *mut hrbfnpr_operation,
        out_drawing: *mut *mut hrbfnpr_drawing,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// What a picture is made of.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_info {
    pub struct_size: u32,
    /// named style as used, HRBFNPR_PRESET_...
    pub preset: u32,
    /// number of surfaces; 1 for a point set
    pub parts: i64,
    /// marks of all parts
    pub marks: i64,
    /// number of notes, for hrbfnpr_picture_get_note
    pub notes: i64,
    /// number of stages that have ended, for hrbfnpr_picture_get_stage
    pub stages: i64,
    /// width of the drawing, in pixels; 0 with SURFACE_ONLY
    pub width: i32,
    /// height of the drawing, in pixels; 0 with SURFACE_ONLY
    pub height: i32,
    /// least coordinates of all parts
    pub bounds_min: [f64; 3],
    /// greatest coordinates of all parts
    pub bounds_max: [f64; 3],
    /// direction that is up, as used
    pub up: [f64; 3],
    /// radius of the pen as used, in pixels
    pub pen: f64,
    /// time that it took to make the picture
    pub seconds: f64,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_picture_info_init(
        info: *mut hrbfnpr_picture_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Gets what a picture is made of.
    pub fn hrbfnpr_picture_get_info(
        picture: *const hrbfnpr_picture,
        info: *mut hrbfnpr_picture_info,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// One surface of a picture.  Its handles are valid while the picture lives; the caller
/// retains those that it keeps
/// longer.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_part {
    pub struct_size: u32,
    /// sides on which marks are drawn, as used, HRBFNPR_SIDES_...
    pub sides: u32,
    /// its model; NULL for a point set
    pub model: *const hrbfnpr_model,
    /// the marks that the planned camera draws: all marks with KEEP_MARKS, else a set of
    /// hrbfnpr_point_set_generate_still; NULL with SURFACE_ONLY
    pub point_set: *const hrbfnpr_point_set,
    /// its lines; NULL without lines
    pub line_set: *const hrbfnpr_line_set,
    /// the mesh that it was fitted to; NULL for other sources
    pub mesh: *const hrbfnpr_mesh,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_picture_part_init(
        part: *mut hrbfnpr_picture_part,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Gets one surface of a picture.  `number` is 0 .. hrbfnpr_picture_info.parts - 1; the
    /// largest surface is 0.  The last
    /// one is the ground, if the picture has one.
    /// Errors: INVALID_ARGUMENT (no such part).
    pub fn hrbfnpr_picture_get_part(
        picture: *const hrbfnpr_picture,
        number: i64,
        part: *mut hrbfnpr_picture_part,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets the style that was chosen for hrbfnpr_renderer_draw.  It is valid while the picture lives.
    /// Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY).
    pub fn hrbfnpr_picture_get_style(
        picture: *const hrbfnpr_picture,
        style: *mut *const hrbfnpr_style,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets the descriptor with which hrbfnpr_point_set_generate made the marks.  It is valid
    /// while the picture lives. *desc
    /// is NULL where the caller gave the marks.
    /// Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY).
    pub fn hrbfnpr_picture_get_marks(
        picture: *const hrbfnpr_picture,
        desc: *mut *const hrbfnpr_generate_desc,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets a note.  `number` is 0 .. hrbfnpr_picture_info.notes - 1.  Its texts are valid while
    /// the picture lives.
    /// Errors: INVALID_ARGUMENT (no such note).
    pub fn hrbfnpr_picture_get_note(
        picture: *const hrbfnpr_picture,
        number: i64,
        note: *mut hrbfnpr_note,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets the last event of a stage that has ended.  `number` is 0 .. hrbfnpr_picture_info.stages - 1.
    /// Errors: INVALID_ARGUMENT (no such stage).
    pub fn hrbfnpr_picture_get_stage(
        picture: *const hrbfnpr_picture,
        number: i64,
        stage: *mut hrbfnpr_picture_event,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets the planned camera.
    /// Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY).
    pub fn hrbfnpr_picture_get_camera(
        picture: *const hrbfnpr_picture,
        camera: *mut hrbfnpr_camera,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets a camera that looks from another side, with the size, the lens and the margin of the
    /// picture.  It looks along
    /// `direction` (3 doubles, from the eye into the scene).  If that is NULL, it looks from
    /// `azimuth` and `elevation`, in
    /// degrees; NaN = as planned.
    /// Errors: INVALID_ARGUMENT (a number is not finite; a picture made with SURFACE_ONLY).
    pub fn hrbfnpr_picture_look(
        picture: *const hrbfnpr_picture,
        direction: *const f64,
        azimuth: f64,
        elevation: f64,
        camera: *mut hrbfnpr_camera,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets the planned camera, turned by an angle in degrees about the up axis through the
    /// middle of the model.  If the
    /// descriptor gave an eye, the axis goes through its target.
    /// Errors: INVALID_ARGUMENT (the angle is not finite; a picture made with SURFACE_ONLY).
    pub fn hrbfnpr_picture_orbit(
        picture: *const hrbfnpr_picture,
        degrees: f64,
        camera: *mut hrbfnpr_camera,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Gets the size of a picture's plate, in pixels.  A plate is a drawing with the section and
    /// the scale bar beside it.
    /// Without these it is the drawing alone.  `camera` is the camera that the drawing was made
    /// with; NULL = the planned
    /// camera.
    /// Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY).
    pub fn hrbfnpr_picture_plate_size(
        picture: *const hrbfnpr_picture,
        camera: *const hrbfnpr_camera,
        width: *mut i32,
        height: *mut i32,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Draws the plate of a picture into an image, from the top-left corner on.  The image has at
    /// least the size that
    /// hrbfnpr_picture_plate_size gives.  `camera` is the camera that the drawing was made with;
    /// NULL = the planned camera.
    /// Errors: those of hrbfnpr_drawing_rasterize; INVALID_ARGUMENT, too, if the image is too small.
    pub fn hrbfnpr_picture_rasterize(
        picture: *const hrbfnpr_picture,
        drawing: *const hrbfnpr_drawing,
        camera: *const hrbfnpr_camera,
        image: *const hrbfnpr_image,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

/// The paper and the pens with which a drawing is written.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_picture_page_desc {
    pub struct_size: u32,
    pub reserved: u32,
    /// format, flags, tolerance, speeds, pens and the like; default NULL = its defaults. The call
    /// sets items, annotations and size, and title, description and metadata where they are NULL
    pub page: *const hrbfnpr_page_desc,
    /// paper that the drawing fills, turned as it fits better: "a0" .. "a6", "letter", "legal",
    /// "tabloid", or width and height in mm, such as "210x297"; default NULL = a pixel is 25.4 /
    /// 96 mm
    pub paper: *const c_char,
    /// free margin on each side of the paper, in mm; 0 or more; default 10
    pub paper_margin: f64,
    /// widths of the pens at hand, in mm, ascending; n x 1, FLOAT64; not given = `page` says.
    /// Each group gets the pen nearest to the median width of its lines
    pub pen_widths: hrbfnpr_array,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_picture_page_desc_init(
        desc: *mut hrbfnpr_picture_page_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Writes the plate of a picture as vectors.  `camera` is the camera that the drawing was
    /// made with; NULL = the planned
    /// camera.  `desc`, `info` and `operation` may be NULL.  The picture gets notes PENS and PLOTTED.
    /// Errors: those of hrbfnpr_page_write; INVALID_ARGUMENT, too, for a paper that is not known
    /// or has no room.
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
    /// Reads settings that hrbfnpr_picture_write_settings or the viewer wrote. docs/settings.md
    /// describes the format.
    /// Errors: IO (`read` failed), INVALID_ARGUMENT (the message names the key and says what
    /// would be right),
    /// OUT_OF_MEMORY.
    pub fn hrbfnpr_settings_load(
        context: *mut hrbfnpr_context,
        read: hrbfnpr_read_fn,
        user: *mut c_void,
        out_settings: *mut *mut hrbfnpr_settings,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
    /// Adds a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_settings_retain(settings: *const hrbfnpr_settings);
    /// Releases a reference.  Any thread may call it; NULL is ignored.
    pub fn hrbfnpr_settings_release(settings: *const hrbfnpr_settings);
    /// Writes what a picture was made with.  The picture gets a note NOT_IN_SETTINGS about what
    /// settings do not hold.
    /// Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY), IO (`write` failed), OUT_OF_MEMORY.
    pub fn hrbfnpr_picture_write_settings(
        picture: *mut hrbfnpr_picture,
        write: hrbfnpr_write_fn,
        user: *mut c_void,
        error: *mut hrbfnpr_error,
    ) -> hrbfnpr_status;
}

// 16  SHEETS: technical drawings in several views, to scale

// Options of a sheet.
/// draws a centre line for each plane of symmetry through the middle, in each view that sees
/// the plane as a line. A note NO_SYMMETRY says that there is no such plane
pub const HRBFNPR_VIEWS_CENTRE_LINES: u32 = 1;
/// writes the name of each view above it. Sections always have their names
pub const HRBFNPR_VIEWS_LABELS: u32 = 2;
/// says that the format of the source is in metres, as glTF is. A unit_mm of 0 then means
/// 1000, and a note UNIT_IS_METRE says so
pub const HRBFNPR_VIEWS_UNIT_IS_METRE: u32 = 4;
/// compares all drawn lines with rays, and repairs wrong pieces. hrbfnpr_views_info, a note
/// LINES_VERIFIED and, unless `page` has one, the page's description have the counts
pub const HRBFNPR_VIEWS_VERIFY: u32 = 8;

// Where views stand [ISO 5456-2].
/// first angle: the left view stands at the right, the top view below
pub const HRBFNPR_VIEWS_ANGLE_FIRST: u32 = 0;
/// third angle: the left view stands at the left, the top view above
pub const HRBFNPR_VIEWS_ANGLE_THIRD: u32 = 1;

// How hidden edges are drawn.  Sections never have hidden edges [ISO 128-3].
/// hidden edges are dashed thin lines
pub const HRBFNPR_VIEWS_HIDDEN_DASHED: u32 = 0;
/// hidden edges are not drawn
pub const HRBFNPR_VIEWS_HIDDEN_NONE: u32 = 1;
/// hidden edges are continuous thin lines
pub const HRBFNPR_VIEWS_HIDDEN_SHOWN: u32 = 2;

// How tangent edges are drawn, along which two surfaces of a part touch without a kink, such
// as those of a fillet.
// They are continuous thin lines; hidden ones are not drawn.
/// tangent edges end three widths of an outline before the lines that they would touch, as
/// ISO 128-3 asks of the lines of rounded edges; short ones end a quarter of their length
/// before
pub const HRBFNPR_VIEWS_TANGENT_SHORT: u32 = 0;
/// tangent edges go up to the lines that they touch
pub const HRBFNPR_VIEWS_TANGENT_THIN: u32 = 1;
/// tangent edges are not drawn
pub const HRBFNPR_VIEWS_TANGENT_NONE: u32 = 2;

/// A sheet of views.  Texts are UTF-8, and are read during the call only.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_views_desc {
    pub struct_size: u32,
    /// HRBFNPR_VIEWS_...; default 0
    pub flags: u32,
    /// where views stand, HRBFNPR_VIEWS_ANGLE_...; default FIRST
    pub projection: u32,
    /// how hidden edges are drawn, HRBFNPR_VIEWS_HIDDEN_...; default DASHED
    pub hidden: u32,
    /// names of views with commas between: front, back, left, right, top, bottom, iso; each is
    /// drawn once; default NULL = "front,left,top,iso", or "front,right,top,iso" with ANGLE_THIRD
    pub views: *const c_char,
    /// cutting planes with semicolons between: "z:20" cuts at z = 20, "z" through the middle,
    /// "1:1:0:5" at x + y = 5; default NULL = none. "+z:20" is seen from above and "-z:20" from
    /// below. An axis without a sign is seen from the front, from above, or from the side that is
    /// drawn. Sections are called A-A, B-B and so on
    pub sections: *const c_char,
    /// paper: "a0" .. "a6", "letter", "legal" or "tabloid", in landscape format, or width and
    /// height in mm, such as "297x210"; default NULL = "auto" = the smallest of a4 to a0 that has
    /// room at the scale, or a3 if the scale is "auto", too
    pub paper: *const c_char,
    /// scale, such as "1:2" for half the size; default NULL = "auto" = the largest of 1, 2 and 5
    /// times a power of ten that has room on the paper [ISO 5455]
    pub scale: *const c_char,
    /// thin lines where the surface bends without an edge, as kinds with commas between: ridges,
    /// valleys, suggestive; default NULL = "none"
    pub smooth: *const c_char,
    /// title in the title block; default NULL; NULL and "" = `model` without the ending of its name
    pub title: *const c_char,
    /// name of the file in the title block; default NULL; NULL and "" = the name of the picture's source
    pub model: *const c_char,
    /// mm of a unit of the model, above 0, up to 1e9; default 0 = 1, or 1000 with UNIT_IS_METRE
    pub unit_mm: f64,
    /// angle between two faces of a mesh, in degrees, above which their edge is sharp; above 0,
    /// up to 1e9; default 30. Larger: fewer edges
    pub crease_angle: f64,
    /// width of outlines, in mm; thin lines are half as wide; 0.01 .. 1000; default 0.5
    pub line_width: f64,
    /// distance between the lines in cut faces, in mm; 0.01 .. 1000; default 3
    pub hatch_spacing: f64,
    /// free space between views, in mm; above 0, up to 1e9; default 15
    pub spacing: f64,
    /// format, flags, tolerance, speeds and the like; default NULL = its defaults with a
    /// tolerance of 0.02. The call sets items, annotations, pens and size, and title and
    /// description where they are NULL
    pub page: *const hrbfnpr_page_desc,
    /// how tangent edges are drawn, HRBFNPR_VIEWS_TANGENT_...; default SHORT
    pub tangent: u32,
    pub reserved: u32,
}

extern "C" {
    /// Sets struct_size and all defaults.
    pub fn hrbfnpr_views_desc_init(
        desc: *mut hrbfnpr_views_desc,
        struct_size: u32,
    ) -> hrbfnpr_status;
}

/// The sheet that was written.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct hrbfnpr_views_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// number of views and sections
    pub views: i64,
    /// bytes that were written
    pub bytes: i64,
    /// width of the page, in mm
    pub width: f64,
    /// height of the page, in mm
    pub height: f64,
    /// scale as a number: 0.5 for 1:2
    pub scale: f64,
    /// mm of a unit of the model, as used
    pub unit_mm: f64,
    /// scale in words, such as "1:2"
    pub scale_text: [c_char; 64],
    /// paper, such as "a3" or "297 x 210"
    pub paper: [c_char; 64],
    /// with VERIFY, drawn pieces of lines that rays were compared with
    pub pieces: i64,
    /// pieces whose decided rays all agree with the drawing
    pub agreeing: i64,
    /// pieces without a decided ray: they are within 0.05 mm of an edge, in the view or in depth
    pub undecided: i64,
    /// pieces that were divided, or drawn otherwise, because rays disagreed
    pub repaired: i64,
}

extern "C" {
    /// Sets struct_size; all other fields are 0.
    pub fn hrbfnpr_views_info_init(
        info: *mut hrbfnpr_views_info,
        struct_size: u32,
    ) -> hrbfnpr_status;
    /// Writes a sheet of views of a picture's parts, which must have models.  A picture made with
    /// SURFACE_ONLY is enough,
    /// and its models have the cavities of meshes; others may need SOLIDS as `parts`.  `desc`,
    /// `info` and `operation` may be
    /// NULL.  The picture gets stages LINES and VIEWS, and notes UNIT_IS_METRE, NO_SYMMETRY,
    /// SECTION_OPEN and
    /// LINES_VERIFIED.
    /// Errors: INVALID_ARGUMENT (a picture of a point set; a text that is not understood; a plane
    /// that misses the model;
    /// views that have no room on the paper at the scale: the message names a scale or paper with
    /// room), and those of
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
