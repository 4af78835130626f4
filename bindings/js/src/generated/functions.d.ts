// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.

/** An address in the module's memory; 0 is NULL. */
export type Pointer = number;

/** The functions of the C interface, by their names in C.  64-bit integers are numbers here. */
export interface Functions {
  /**
   * uint32_t hrbfnpr_version(void)
   *
   * Returns the library's version as major * 10000 + minor * 100 + patch.
   */
  hrbfnpr_version(): number;
  /**
   * uint32_t hrbfnpr_abi_version(void)
   *
   * Returns the library's ABI version.  Compare it with HRBFNPR_ABI_VERSION.
   */
  hrbfnpr_abi_version(): number;
  /**
   * const char* hrbfnpr_version_string(void)
   *
   * Returns the library's version as "major.minor.patch": static, UTF-8, never NULL.
   */
  hrbfnpr_version_string(): Pointer;
  /**
   * const char* hrbfnpr_status_name(hrbfnpr_status status)
   *
   * Returns the name of a status, such as "INVALID_ARGUMENT", or "UNKNOWN" for a
   * number that is not in the list.  The text is static and never NULL.
   */
  hrbfnpr_status_name(status: number): Pointer;
  /**
   * hrbfnpr_status hrbfnpr_error_init(hrbfnpr_error* error, uint32_t struct_size)
   *
   * Sets struct_size, the status OK and an empty message.
   *
   * Errors: INVALID_ARGUMENT: `error` is NULL.  UNSUPPORTED_STRUCT: struct_size is
   * below 256.
   */
  hrbfnpr_error_init(error: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_build_info(char* destination, int64_t capacity, int64_t* needed)
   *
   * Writes what this build of the library is, as one JSON object with the keys
   * version, abi, compiler, instruction_sets, thread_backends and dependencies.
   *
   * destination:   receives the text with a terminating zero; may be NULL if capacity is 0
   * capacity:      the size of destination in bytes, 0 or more
   * needed:        receives the bytes that the text needs, with its zero; may be NULL
   *
   * Errors: BUFFER_TOO_SMALL: capacity is below *needed; only *needed is written.
   */
  hrbfnpr_build_info(destination: Pointer, capacity: number, needed: Pointer): number;
  /**
   * const char* hrbfnpr_layout(const char* name)
   *
   * Returns how this build lays out a struct, such as "hrbfnpr_fit_desc", as one
   * JSON object.  Its keys are name, size, align and fields: a list of objects with
   * name, type, offset and size (bytes), in the order of the header.  For NULL it
   * returns a list of all structs.  A binding can compare its own structs with it
   * before the first call.  The text is static and UTF-8.  The result is NULL if
   * there is no struct of that name.
   */
  hrbfnpr_layout(name: Pointer): Pointer;
  /**
   * hrbfnpr_status hrbfnpr_image_init(hrbfnpr_image* image, uint32_t struct_size)
   *
   * Sets every field to its default; the size and the pixels are the caller's to set.
   */
  hrbfnpr_image_init(image: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_context_desc_init(hrbfnpr_context_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_context_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_context_create(const hrbfnpr_context_desc* desc, hrbfnpr_context** out_context,
   * hrbfnpr_error* error)
   *
   * Creates a context.  `desc` NULL = all defaults.  The callbacks and their user
   * pointers must stay valid until the context and everything that was made from
   * it are released.
   *
   * Errors: VERSION_MISMATCH: the header and the library have different ABI
   * versions.
   */
  hrbfnpr_context_create(desc: Pointer, out_context: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_context_retain(hrbfnpr_context* context)
   *
   * Adds a reference. Any thread.
   */
  hrbfnpr_context_retain(context: Pointer): void;
  /**
   * void hrbfnpr_context_release(hrbfnpr_context* context)
   *
   * Removes a reference. Any thread.
   */
  hrbfnpr_context_release(context: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_context_info_init(hrbfnpr_context_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_context_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_context_get_info(const hrbfnpr_context* context, hrbfnpr_context_info* info,
   * hrbfnpr_error* error)
   *
   * Fills `info` with the settings in use and the memory of a context.
   */
  hrbfnpr_context_get_info(context: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_operation_create(hrbfnpr_context* context, hrbfnpr_operation** out_operation,
   * hrbfnpr_error* error)
   *
   * Creates an operation.
   */
  hrbfnpr_operation_create(context: Pointer, out_operation: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_operation_retain(hrbfnpr_operation* operation)
   *
   * Adds a reference. Any thread.
   */
  hrbfnpr_operation_retain(operation: Pointer): void;
  /**
   * void hrbfnpr_operation_release(hrbfnpr_operation* operation)
   *
   * Removes a reference. Any thread.
   */
  hrbfnpr_operation_release(operation: Pointer): void;
  /**
   * void hrbfnpr_operation_cancel(hrbfnpr_operation* operation)
   *
   * Cancels the call that uses the operation, and all later ones.  Any thread, any
   * time, any number of times.  NULL is ignored.
   */
  hrbfnpr_operation_cancel(operation: Pointer): void;
  /**
   * int32_t hrbfnpr_operation_is_cancelled(const hrbfnpr_operation* operation)
   *
   * Returns 1 after a cancel, else 0.  Any thread.  NULL gives 0.
   */
  hrbfnpr_operation_is_cancelled(operation: Pointer): number;
  /**
   * double hrbfnpr_operation_progress(const hrbfnpr_operation* operation)
   *
   * Returns the progress of the call, from 0 to 1.  Any thread.  NULL gives 0.
   */
  hrbfnpr_operation_progress(operation: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_operation_set_callback(hrbfnpr_operation* operation, hrbfnpr_progress_fn callback,
   * void* user, hrbfnpr_error* error)
   *
   * Sets the function that receives the progress; `callback` NULL removes it.
   *
   * Errors: INVALID_ARGUMENT: a call uses the operation at present.
   */
  hrbfnpr_operation_set_callback(operation: Pointer, callback: Pointer, user: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_fit_desc_init(hrbfnpr_fit_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_fit_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_fit(hrbfnpr_context* context, const hrbfnpr_fit_desc* desc, hrbfnpr_operation*
   * operation, hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * Fits f with f(x_i) = 0 and grad f(x_i) = n_i at the samples, so that f < 0
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
   * tolerance; the message gives the residual.
   */
  hrbfnpr_model_fit(context: Pointer, desc: Pointer, operation: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_orient_desc_init(hrbfnpr_orient_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_orient_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_orient_info_init(hrbfnpr_orient_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_orient_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_orient(hrbfnpr_context* context, const hrbfnpr_orient_desc* desc, hrbfnpr_operation*
   * operation, const hrbfnpr_array_out* out_normals, hrbfnpr_orient_info* info, hrbfnpr_error* error)
   *
   * Finds outward unit normals for points, or repairs given normals.  A low
   * confidence is no error; the log warns.  Time and memory grow with N.
   * [VIPSS: Huang, Carr, Ju, "Variational implicit point set surfaces", 2019]
   *
   * out_normals:   receives N x 3 normals, FLOAT32 or FLOAT64; may be the given normals' memory.  Given
   *                normals that stay keep their bits (if the scalar types agree); turned ones change their sign
   * only
   * info:          may be NULL
   * operation:     may be NULL
   *
   * Errors: INVALID_ARGUMENT: fewer than 4 different points; all points are on one
   * line; NaN or infinity; no normals with a mode that needs them; `up` is 0.
   */
  hrbfnpr_orient(context: Pointer, desc: Pointer, operation: Pointer, out_normals: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_depth_image_desc_init(hrbfnpr_depth_image_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_depth_image_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_depth_image_info_init(hrbfnpr_depth_image_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_depth_image_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_smooth_depth_image(hrbfnpr_context* context, const hrbfnpr_depth_image_desc* desc,
   * hrbfnpr_operation* operation, const hrbfnpr_array_out* out_points, const hrbfnpr_array_out* out_normals,
   * hrbfnpr_depth_image_info* info, hrbfnpr_error* error)
   *
   * Removes the sensor's noise from the image of a depth camera, and finds normals.
   * To choose some of the points, evenly spread over the image, pass x / z, y / z and
   * log |z| to hrbfnpr_farthest_points.
   *
   * out_points:    receives rows * columns x 3 points, FLOAT32 or FLOAT64; NaN where nothing was seen and for
   * points that
   *                are left out, such as those between an edge and what it hides; may be the memory of
   * desc->points; may
   *                be NULL
   * out_normals:   receives as many unit normals, which point to the camera; 0 where out_points is NaN; may be
   * NULL
   * info:          may be NULL
   * operation:     may be NULL
   *
   * Errors: INVALID_ARGUMENT: the points are not such an image.
   */
  hrbfnpr_smooth_depth_image(context: Pointer, desc: Pointer, operation: Pointer, out_points: Pointer, out_normals: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_custom_desc_init(hrbfnpr_custom_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_custom_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_create_custom(hrbfnpr_context* context, const hrbfnpr_custom_desc* desc,
   * hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * Creates a model from a function of the caller.
   *
   * Errors: INVALID_ARGUMENT: no function, or bounds that span no box.
   */
  hrbfnpr_model_create_custom(context: Pointer, desc: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_model_retain(const hrbfnpr_model* model)
   *
   * Adds a reference. Any thread.
   */
  hrbfnpr_model_retain(model: Pointer): void;
  /**
   * void hrbfnpr_model_release(const hrbfnpr_model* model)
   *
   * Removes a reference. Any thread.
   */
  hrbfnpr_model_release(model: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_model_info_init(hrbfnpr_model_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_model_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_get_info(const hrbfnpr_model* model, hrbfnpr_model_info* info, hrbfnpr_error*
   * error)
   *
   * Fills `info` with what is known of a model.
   */
  hrbfnpr_model_get_info(model: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_view(const hrbfnpr_model* model, uint32_t attribute, hrbfnpr_array* out_view,
   * hrbfnpr_error* error)
   *
   * Gives a view of an array of the model, without a copy.  The view is valid while
   * the model lives.  It is empty for a custom model and a solid.
   */
  hrbfnpr_model_view(model: Pointer, attribute: number, out_view: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_evaluate(const hrbfnpr_model* model, const hrbfnpr_array* points, const
   * hrbfnpr_array_out* value, const hrbfnpr_array_out* gradient, const hrbfnpr_array_out* hessian,
   * hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * Evaluates f, its gradient and its Hessian at n points.
   *
   * points:      n x 3, FLOAT32 or FLOAT64; finite, and within 1e50 diagonals of the model's bounds
   * value:       receives n values, FLOAT32 or FLOAT64; may be NULL
   * gradient:    receives n x 3, FLOAT32 or FLOAT64; may be NULL
   * hessian:     receives n x 6, xx xy xz yy yz zz, FLOAT32 or FLOAT64; may be NULL.  At a sample it leaves out
   * the
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
   * are passed on.
   */
  hrbfnpr_model_evaluate(model: Pointer, points: Pointer, value: Pointer, gradient: Pointer, hessian: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_project_desc_init(hrbfnpr_project_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_project_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_projection_init(hrbfnpr_projection* projection, uint32_t struct_size)
   *
   * Sets up the struct with no array given.
   */
  hrbfnpr_projection_init(projection: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_project(const hrbfnpr_model* model, const hrbfnpr_array* points, const
   * hrbfnpr_project_desc* desc, hrbfnpr_projection* projection, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Projects n points onto the surface, by steepest descent on f^2 with Armijo's rule
   * [NPAR 4.2].  A point that fails keeps its last place; its status says why, and the
   * call succeeds.  For models with creases, and where a bound on |grad f| is known,
   * points that descent leaves off the surface are searched for the surface around
   * them, within the search box: this takes up to 2000 more evaluations for each.
   *
   * points:       n x 3, FLOAT32 or FLOAT64; as for hrbfnpr_model_evaluate
   * desc:         NULL = all defaults
   * projection:   the arrays that receive the results
   * operation:    may be NULL
   */
  hrbfnpr_model_project(model: Pointer, points: Pointer, desc: Pointer, projection: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_curvature_init(hrbfnpr_curvature* curvature, uint32_t struct_size)
   *
   * Sets up the struct with no array given.
   */
  hrbfnpr_curvature_init(curvature: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_curvature(const hrbfnpr_model* model, const hrbfnpr_array* points,
   * hrbfnpr_curvature* curvature, hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * Computes the principal curvatures and directions of the level set through each of n
   * points: the tangent eigenpairs of G = -P H P / |grad f|, where P = I - n n^T
   * [NPAR 5.3; Kindlmann et al. 2003].  k1 >= k2.  A surface that bends away from its
   * normal has negative curvature: a sphere with outward normals has -1/radius.  At
   * umbilics and on planes the confidence is 0, and d1 and d2 follow a smooth field.
   * Where the gradient vanishes, all results are 0.
   *
   * points:      n x 3, FLOAT32 or FLOAT64; as for hrbfnpr_model_evaluate
   * curvature:   the arrays that receive the results
   * operation:   may be NULL
   */
  hrbfnpr_model_curvature(model: Pointer, points: Pointer, curvature: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_cast_desc_init(hrbfnpr_cast_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_cast_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_ray_hits_init(hrbfnpr_ray_hits* hits, uint32_t struct_size)
   *
   * Sets up the struct with no array given.
   */
  hrbfnpr_ray_hits_init(hits: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_cast_rays(const hrbfnpr_model* model, const hrbfnpr_array* origins, const
   * hrbfnpr_array* directions, const hrbfnpr_cast_desc* desc, hrbfnpr_ray_hits* hits, hrbfnpr_operation*
   * operation, hrbfnpr_error* error)
   *
   * Finds where n rays origin + t direction, t_min <= t <= t_max, meet the surface in the
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
   * line_set of another model.
   */
  hrbfnpr_model_cast_rays(model: Pointer, origins: Pointer, directions: Pointer, desc: Pointer, hits: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_lipschitz(const hrbfnpr_model* model, double* lipschitz, hrbfnpr_operation*
   * operation, hrbfnpr_error* error)
   *
   * Computes the bound on |grad f| that hrbfnpr_model_cast_rays uses if none is given.
   * For a solid of primitives it is a true bound (hrbfnpr_csg_info.lipschitz).  For other
   * models it is an estimate: 1.5 times the largest |grad f| at 24^3 points of the search
   * box.  A program that casts a few rays in each call should ask for the bound once and
   * pass it on, because each such call without it evaluates these points.
   *
   * lipschitz:   receives the bound
   * operation:   may be NULL
   */
  hrbfnpr_model_lipschitz(model: Pointer, lipschitz: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_contains(const hrbfnpr_model* model, const hrbfnpr_array* points, const
   * hrbfnpr_array_out* inside, int64_t* inside_count, hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * Tells which of n points lie inside the surface: f < 0, and within the search box.
   * Points beyond the box are outside; f is not evaluated there.  A surface with a border
   * bounds nothing: the result then tells the side by the sign of f.
   *
   * points:         n x 3, FLOAT32 or FLOAT64, finite
   * inside:         receives n x 1 UINT8: 1 inside, else 0; may be NULL
   * inside_count:   receives the number of points inside; may be NULL
   * operation:      may be NULL
   */
  hrbfnpr_model_contains(model: Pointer, points: Pointer, inside: Pointer, inside_count: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_trim_desc_init(hrbfnpr_trim_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_trim_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_trim(const hrbfnpr_model* model, const hrbfnpr_trim_desc* desc,
   * hrbfnpr_operation* operation, hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * Makes the same model with a surface that ends where its samples end.  Marks, line sets
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
   * spacing.
   */
  hrbfnpr_model_trim(model: Pointer, desc: Pointer, operation: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_trim_info_init(hrbfnpr_trim_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_trim_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_get_trim_info(const hrbfnpr_model* model, hrbfnpr_trim_info* info, hrbfnpr_error*
   * error)
   *
   * Fills `info` with what the last trim of a model left out.
   */
  hrbfnpr_model_get_trim_info(model: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_csg_node_init(hrbfnpr_csg_node* node, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_csg_node_init(node: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_csg_desc_init(hrbfnpr_csg_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_csg_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_create_csg(hrbfnpr_context* context, const hrbfnpr_csg_desc* desc,
   * hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * Makes a solid.  Every function of this section works on it.  Derivatives are those of
   * the part that is active at a place.  A solid can be saved if its leaves can.  It keeps
   * its leaves alive.  It runs on several threads if all custom functions among its leaves
   * are thread-safe.
   *
   * Errors: INVALID_ARGUMENT: a node is wrong (the message gives its index); the surface
   * may have no end (intersect it with a box, or give bounds); nothing is left of the
   * solid.
   */
  hrbfnpr_model_create_csg(context: Pointer, desc: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_csg_info_init(hrbfnpr_csg_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_csg_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_get_csg_info(const hrbfnpr_model* model, hrbfnpr_csg_info* info, hrbfnpr_error*
   * error)
   *
   * Fills `info` with what a solid is made of.
   */
  hrbfnpr_model_get_csg_info(model: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_save(const hrbfnpr_model* model, hrbfnpr_write_fn write, void* user,
   * hrbfnpr_error* error)
   *
   * Saves a model to a stream.  The stream is little-endian, has a version and a
   * checksum, and is described in docs/file-format.md.  A loaded model evaluates to the
   * same bits.
   *
   * Errors: INVALID_ARGUMENT: a custom model, or a solid with one among its leaves, cannot
   * be saved.  IO: `write` failed.
   */
  hrbfnpr_model_save(model: Pointer, write: Pointer, user: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_save_memory(const hrbfnpr_model* model, void* destination, int64_t capacity,
   * int64_t* size, hrbfnpr_error* error)
   *
   * Saves a model to memory.
   *
   * destination:   receives the stream; may be NULL if capacity is 0
   * capacity:      the size of destination in bytes, 0 or more
   * size:          receives the bytes that the stream needs; must be given
   *
   * Errors: those of hrbfnpr_model_save.  BUFFER_TOO_SMALL: capacity is below *size; only
   * *size is written.
   */
  hrbfnpr_model_save_memory(model: Pointer, destination: Pointer, capacity: number, size: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user, hrbfnpr_model**
   * out_model, hrbfnpr_error* error)
   *
   * Loads a model from a stream.
   *
   * Errors: IO: `read` failed.  CORRUPT_DATA: the stream is no model, truncated or
   * damaged.  VERSION_MISMATCH: a newer library wrote it.
   */
  hrbfnpr_model_load(context: Pointer, read: Pointer, user: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
   * hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * Loads a model from `size` bytes of memory.  Errors: those of hrbfnpr_model_load,
   * without IO.
   */
  hrbfnpr_model_load_memory(context: Pointer, data: Pointer, size: number, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_layer_desc_init(hrbfnpr_layer_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_layer_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_generate_desc_init(hrbfnpr_generate_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_generate_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_generate(hrbfnpr_context* context, const hrbfnpr_model* model, const
   * hrbfnpr_generate_desc* desc, hrbfnpr_operation* operation, hrbfnpr_point_set** out_point_set, hrbfnpr_error*
   * error)
   *
   * Places marks on the surface of a model.  Marks whose projection fails or lands too far
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
   * given separation or step.  CALLBACK: a density or direction function failed.
   */
  hrbfnpr_point_set_generate(context: Pointer, model: Pointer, desc: Pointer, operation: Pointer, out_point_set: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_layer_arrays_init(hrbfnpr_layer_arrays* arrays, uint32_t struct_size)
   *
   * Sets every field to its default; no array is given.
   */
  hrbfnpr_layer_arrays_init(arrays: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_desc_init(hrbfnpr_point_set_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_point_set_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_create(hrbfnpr_context* context, const hrbfnpr_point_set_desc* desc,
   * hrbfnpr_point_set** out_point_set, hrbfnpr_error* error)
   *
   * Creates a point set from marks of the caller, or from the layers of another set and marks
   * of the caller.  The marks must be from 1e-33 to 1e33 across, or all at one place.  A set
   * with a base keeps the base's origin and distribution.  It keeps its spacing, too, unless
   * a new layer has more marks than each layer before: the same area then holds more marks.
   *
   * Errors: INVALID_ARGUMENT: there is no mark, or a number is wrong; the message names the
   * layer, the array and the index.
   */
  hrbfnpr_point_set_create(context: Pointer, desc: Pointer, out_point_set: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_point_set_retain(const hrbfnpr_point_set* set)
   *
   * Adds a reference. Any thread.
   */
  hrbfnpr_point_set_retain(set: Pointer): void;
  /**
   * void hrbfnpr_point_set_release(const hrbfnpr_point_set* set)
   *
   * Removes a reference. Any thread.
   */
  hrbfnpr_point_set_release(set: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_point_set_info_init(hrbfnpr_point_set_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_point_set_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_info(const hrbfnpr_point_set* set, hrbfnpr_point_set_info* info,
   * hrbfnpr_error* error)
   *
   * Fills `info` with what a point set holds.
   */
  hrbfnpr_point_set_get_info(set: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_layer_info_init(hrbfnpr_layer_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_layer_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_layer_info(const hrbfnpr_point_set* set, int64_t layer,
   * hrbfnpr_layer_info* info, hrbfnpr_error* error)
   *
   * Fills `info` with what a layer holds.  layer: 0 to hrbfnpr_point_set_info.layers - 1.
   */
  hrbfnpr_point_set_get_layer_info(set: Pointer, layer: number, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_placement_info_init(hrbfnpr_placement_info* info, uint32_t struct_size)
   *
   * Clears the struct before its first use.
   */
  hrbfnpr_placement_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_seed_placement(const hrbfnpr_point_set* set, hrbfnpr_placement_info*
   * info, hrbfnpr_error* error)
   *
   * Fills `info` with what became of the seeds.
   */
  hrbfnpr_point_set_get_seed_placement(set: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_placement(const hrbfnpr_point_set* set, int64_t layer, int32_t level,
   * hrbfnpr_placement_info* info, hrbfnpr_error* error)
   *
   * Fills `info` with what became of the candidates of one level of one layer.
   * level: 0 to hrbfnpr_layer_info.levels.
   */
  hrbfnpr_point_set_get_placement(set: Pointer, layer: number, level: number, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_view(const hrbfnpr_point_set* set, int64_t layer, uint32_t attribute,
   * hrbfnpr_array* out_view, hrbfnpr_error* error)
   *
   * Gives a view of one attribute (HRBFNPR_MARK_ATTRIBUTE_...) of one layer, without a copy.
   * The view is valid while the set lives.  Its count is 0 for an empty layer, and for an
   * attribute that the layer does not have.
   */
  hrbfnpr_point_set_view(set: Pointer, layer: number, attribute: number, out_view: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mark_field_init(hrbfnpr_mark_field* field, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_mark_field_init(field: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_with_fields(hrbfnpr_context* context, const hrbfnpr_point_set* set, const
   * hrbfnpr_mark_field* fields, int64_t field_count, int64_t field_stride, hrbfnpr_operation* operation,
   * hrbfnpr_point_set** out_point_set, hrbfnpr_error* error)
   *
   * Creates a point set that has the same marks as `set`, and values of fields for them.  Values that `set` has
   * stay,
   * except those of a name in the list.  The marks are shared, not copied, and the fields may be released.  Values
   * are
   * saved and loaded with the set.  A hrbfnpr_shading of `set` is one of the new set, too.
   *
   * fields:      a list; no name occurs twice
   * operation:   may be NULL
   *
   * Errors: INVALID_ARGUMENT (the set would have more than 64 fields).  CALLBACK (the function of a field failed).
   */
  hrbfnpr_point_set_with_fields(context: Pointer, set: Pointer, fields: Pointer, field_count: number, field_stride: number, operation: Pointer, out_point_set: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_field(const hrbfnpr_point_set* set, int64_t number, const char** name,
   * uint32_t* kind, hrbfnpr_error* error)
   *
   * Gets the name and the kind (HRBFNPR_FIELD_KIND_...) of a field of a set.  `number` is 0 ..
   * hrbfnpr_point_set_info.field_count - 1.  `name` and `kind` may be NULL.  The name is valid while the set
   * lives.
   */
  hrbfnpr_point_set_get_field(set: Pointer, number: number, name: Pointer, kind: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_view_field(const hrbfnpr_point_set* set, int64_t layer, const char* name,
   * hrbfnpr_array* values, hrbfnpr_array* weights, hrbfnpr_error* error)
   *
   * Gives views of the values that a field has at the marks of one layer, without a copy.  They are valid while
   * the set
   * lives.
   *
   * values:      FLOAT32: one number for SCALAR, three for COLOUR and DIRECTION.  Count 0 = the layer has none
   * weights:     FLOAT32: 0 .. 1 for each mark; count 0 = all are 1.  It may be NULL
   *
   * Errors: INVALID_ARGUMENT (no layer of the set has a field of this name).
   */
  hrbfnpr_point_set_view_field(set: Pointer, layer: number, name: Pointer, values: Pointer, weights: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_step_patches(hrbfnpr_context* context, const hrbfnpr_model* model, const
   * hrbfnpr_generate_desc* desc, const hrbfnpr_array_out* corners, double* step, hrbfnpr_operation* operation,
   * hrbfnpr_error* error)
   *
   * Makes squares that show how large the initial step of PUBLISHED is [NPAR 5.1, Figure 5].
   * Each square has sides of 2 * initial_step and lies in the tangent plane of a random seed.
   * The seeds, and the estimate if initial_step is 0, are those that
   * hrbfnpr_point_set_generate uses with the same desc.
   *
   * desc:        NULL = all defaults
   * corners:     receives n x 12, FLOAT32 or FLOAT64: four corners for each square, absolute, counter-clockwise as
   * seen
   *              from outside
   * step:        receives the initial step; may be NULL
   * operation:   may be NULL
   */
  hrbfnpr_point_set_step_patches(context: Pointer, model: Pointer, desc: Pointer, corners: Pointer, step: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_save(const hrbfnpr_point_set* set, hrbfnpr_write_fn write, void* user,
   * hrbfnpr_error* error)
   *
   * Saves a point set to a stream, like hrbfnpr_model_save.
   *
   * Errors: IO: `write` failed.
   */
  hrbfnpr_point_set_save(set: Pointer, write: Pointer, user: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_save_memory(const hrbfnpr_point_set* set, void* destination, int64_t
   * capacity, int64_t* size, hrbfnpr_error* error)
   *
   * Saves a point set to memory, like hrbfnpr_model_save_memory.
   *
   * Errors: BUFFER_TOO_SMALL: capacity is below *size; only *size is written.
   */
  hrbfnpr_point_set_save_memory(set: Pointer, destination: Pointer, capacity: number, size: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
   * hrbfnpr_point_set** out_point_set, hrbfnpr_error* error)
   *
   * Loads a point set from a stream.
   *
   * Errors: IO: `read` failed.  CORRUPT_DATA: the stream is no point set, truncated or
   * damaged.  VERSION_MISMATCH: a newer library wrote it.
   */
  hrbfnpr_point_set_load(context: Pointer, read: Pointer, user: Pointer, out_point_set: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
   * hrbfnpr_point_set** out_point_set, hrbfnpr_error* error)
   *
   * Loads a point set from `size` bytes of memory.  Errors: those of
   * hrbfnpr_point_set_load, without IO.
   */
  hrbfnpr_point_set_load_memory(context: Pointer, data: Pointer, size: number, out_point_set: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_line_desc_init(hrbfnpr_line_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_line_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_line_set_desc_init(hrbfnpr_line_set_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_line_set_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_line_set_create(hrbfnpr_context* context, const hrbfnpr_model* model, const
   * hrbfnpr_line_set_desc* desc, hrbfnpr_operation* operation, hrbfnpr_line_set** out_line_set, hrbfnpr_error*
   * error)
   *
   * Makes the line set of a model.  The line set keeps the model alive.  `desc` may be NULL for the defaults, and
   * `operation` may be NULL.
   * Errors: INVALID_ARGUMENT (a field of `desc`; more than 4 000 000 triangles: give a larger cell_size; a support
   * without samples), NOT_CONVERGED (no surface was found, or none near its samples), OUT_OF_MEMORY, CANCELLED,
   * CALLBACK.
   */
  hrbfnpr_line_set_create(context: Pointer, model: Pointer, desc: Pointer, operation: Pointer, out_line_set: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_line_set_retain(const hrbfnpr_line_set* line_set)
   *
   * Adds a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_line_set_retain(line_set: Pointer): void;
  /**
   * void hrbfnpr_line_set_release(const hrbfnpr_line_set* line_set)
   *
   * Releases a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_line_set_release(line_set: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_line_set_info_init(hrbfnpr_line_set_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_line_set_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_line_set_get_info(const hrbfnpr_line_set* line_set, hrbfnpr_line_set_info* info,
   * hrbfnpr_error* error)
   *
   * Gets what making a line set found.
   */
  hrbfnpr_line_set_get_info(line_set: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_init(hrbfnpr_camera* camera, uint32_t struct_size)
   *
   * Sets struct_size, identity matrices and a viewport of 0 x 0.
   */
  hrbfnpr_camera_init(camera: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_look_at(hrbfnpr_camera* camera, const double* eye, const double* target, const
   * double* up, hrbfnpr_error* error)
   *
   * Sets `view` so that the camera looks from `eye` towards `target`, with `up` roughly upward in the picture; 3
   * doubles
   * each.
   * Errors: INVALID_ARGUMENT (eye and target are the same; `up` is 0 or parallel to the view; a number is not
   * finite).
   */
  hrbfnpr_camera_look_at(camera: Pointer, eye: Pointer, target: Pointer, up: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_perspective(hrbfnpr_camera* camera, double vertical_angle, double width, double
   * height, double near_plane, double far_plane, hrbfnpr_error* error)
   *
   * Sets a perspective `projection`, and the viewport's width and height in pixels.  `vertical_angle` is the
   * vertical
   * angle of view in radians, in (0, pi).  The planes are distances from the eye, 0 < near_plane < far_plane.
   * Errors: INVALID_ARGUMENT (an argument is out of range).
   */
  hrbfnpr_camera_perspective(camera: Pointer, vertical_angle: number, width: number, height: number, near_plane: number, far_plane: number, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_orthographic(hrbfnpr_camera* camera, double view_height, double width, double
   * height, double near_plane, double far_plane, hrbfnpr_error* error)
   *
   * Sets an orthographic `projection`, and the viewport's width and height in pixels.  `view_height` is the height
   * of
   * what is seen, in world units, above 0. near_plane < far_plane; either may be negative.
   * Errors: INVALID_ARGUMENT (an argument is out of range).
   */
  hrbfnpr_camera_orthographic(camera: Pointer, view_height: number, width: number, height: number, near_plane: number, far_plane: number, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_fit_bounds(hrbfnpr_camera* camera, const double* bounds_min, const double*
   * bounds_max, const double* direction, const double* up, double vertical_angle, double width, double height,
   * double margin, hrbfnpr_error* error)
   *
   * Sets view, projection and viewport so that a box fills the picture.  `direction` points from the eye into the
   * scene,
   * `up` roughly upward in the picture; 3 doubles each.  `vertical_angle` is in radians, in [0, pi); 0 =
   * orthographic.
   * `width` and `height` are in pixels.  `margin` is the share of the picture that stays free on each side, 0 ..
   * 0.45.
   * Errors: INVALID_ARGUMENT (an argument is out of range; `up` is parallel to the direction).
   */
  hrbfnpr_camera_fit_bounds(camera: Pointer, bounds_min: Pointer, bounds_max: Pointer, direction: Pointer, up: Pointer, vertical_angle: number, width: number, height: number, margin: number, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_fit_points(hrbfnpr_camera* camera, const hrbfnpr_array* points, const double*
   * origin, const double* direction, const double* up, double vertical_angle, double width, double height, double
   * margin, hrbfnpr_error* error)
   *
   * Sets view, projection and viewport so that points fill the picture, and lie in its middle.  It fits the points
   * themselves, not the corners of their box.  `points` is n x 3, FLOAT32 or FLOAT64, n >= 1.  `origin` (3
   * doubles, NULL
   * = 0) is added to each point: with a point set's POSITION give the origin of its info.  The other arguments are
   * those
   * of hrbfnpr_camera_fit_bounds.
   * Errors: INVALID_ARGUMENT (no points; a number is not finite; as for hrbfnpr_camera_fit_bounds).
   */
  hrbfnpr_camera_fit_points(camera: Pointer, points: Pointer, origin: Pointer, direction: Pointer, up: Pointer, vertical_angle: number, width: number, height: number, margin: number, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_light_init(hrbfnpr_light* light, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_light_init(light: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_layer_style_init(hrbfnpr_layer_style* style, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_layer_style_init(style: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_line_style_init(hrbfnpr_line_style* style, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_line_style_init(style: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_style_init(hrbfnpr_style* style, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_style_init(style: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_style_init_preset(hrbfnpr_style* style, uint32_t struct_size, uint32_t preset,
   * hrbfnpr_error* error)
   *
   * Sets all fields of a style to those of a preset. style->layers and style->lines point to constants of the
   * library:
   * copy an element to change it.
   * Errors: INVALID_ARGUMENT (no such preset).
   */
  hrbfnpr_style_init_preset(style: Pointer, struct_size: number, preset: number, error: Pointer): number;
  /**
   * const hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint32_t preset, int64_t* count)
   *
   * Gets the layers of marks that a preset draws, with their defaults: a list of constants for
   * hrbfnpr_generate_desc.layers, with layer_stride 0. *count gets their number.  The result is NULL, with a count
   * of 0,
   * for a number that no preset has.
   */
  hrbfnpr_preset_layers(preset: number, count: Pointer): Pointer;
  /**
   * const char* hrbfnpr_preset_name(uint32_t preset)
   *
   * Gets the name of a preset, such as "cross-hatch"; static.  The result is NULL for a number that no preset has.
   * Presets are numbered from 0 without gaps.
   */
  hrbfnpr_preset_name(preset: number): Pointer;
  /**
   * hrbfnpr_status hrbfnpr_dab_init(hrbfnpr_dab* dab, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_dab_init(dab: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_field_desc_init(hrbfnpr_field_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_field_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_field_create(hrbfnpr_context* context, const hrbfnpr_field_desc* desc,
   * hrbfnpr_operation* operation, hrbfnpr_field** out_field, hrbfnpr_error* error)
   *
   * Creates a field.
   *
   * operation:   may be NULL
   *
   * Errors: INVALID_ARGUMENT (an array is missing or has a wrong shape; the message names it).
   */
  hrbfnpr_field_create(context: Pointer, desc: Pointer, operation: Pointer, out_field: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_field_retain(const hrbfnpr_field* field)
   *
   * Adds a reference. Any thread.
   */
  hrbfnpr_field_retain(field: Pointer): void;
  /**
   * void hrbfnpr_field_release(const hrbfnpr_field* field)
   *
   * Removes a reference. Any thread.
   */
  hrbfnpr_field_release(field: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_field_evaluate(const hrbfnpr_field* field, const hrbfnpr_array* positions, const
   * hrbfnpr_array* normals, const hrbfnpr_array_out* values, const hrbfnpr_array_out* weights, hrbfnpr_operation*
   * operation, hrbfnpr_error* error)
   *
   * Evaluates a field at places on a surface.
   *
   * positions:   n x 3, FLOAT32 or FLOAT64, absolute
   * normals:     n x 3, FLOAT32 or FLOAT64, unit; may be NULL for POINTS
   * values:      receives n x 1 (SCALAR) or n x 3, FLOAT32 or FLOAT64; 0 where the weight is 0; may be NULL
   * weights:     receives n x 1, FLOAT32 or FLOAT64, 0 .. 1; 0 also where numbers overflow; may be NULL
   * operation:   may be NULL
   *
   * Errors: CALLBACK (the field's function failed).
   */
  hrbfnpr_field_evaluate(field: Pointer, positions: Pointer, normals: Pointer, values: Pointer, weights: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_renderer_create(hrbfnpr_context* context, hrbfnpr_renderer** out_renderer,
   * hrbfnpr_error* error)
   *
   * Makes a renderer.
   * Errors: INVALID_ARGUMENT (a NULL argument), OUT_OF_MEMORY.
   */
  hrbfnpr_renderer_create(context: Pointer, out_renderer: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_renderer_retain(hrbfnpr_renderer* renderer)
   *
   * Adds a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_renderer_retain(renderer: Pointer): void;
  /**
   * void hrbfnpr_renderer_release(hrbfnpr_renderer* renderer)
   *
   * Releases a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_renderer_release(renderer: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_layer_pose_init(hrbfnpr_layer_pose* pose, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_layer_pose_init(pose: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_item_init(hrbfnpr_item* item, uint32_t struct_size)
   *
   * Sets struct_size, NULL pointers and the identity transform.
   */
  hrbfnpr_item_init(item: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_occluders_create(hrbfnpr_context* context, const hrbfnpr_item* items, int64_t
   * item_count, int64_t item_stride, hrbfnpr_operation* operation, hrbfnpr_occluders** out_occluders,
   * hrbfnpr_error* error)
   *
   * Gathers the surfaces of all items that have a line set, at their transforms: the triangles on which lines are
   * found.
   * Walls thinner than a cell of the line set may let light through.  The occluders keep the line sets alive.
   *
   * items:       a list, of which line_set and transform are read; an item needs no point set
   * operation:   may be NULL
   *
   * Errors: INVALID_ARGUMENT (no item has a line set).
   */
  hrbfnpr_occluders_create(context: Pointer, items: Pointer, item_count: number, item_stride: number, operation: Pointer, out_occluders: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_occluders_retain(const hrbfnpr_occluders* occluders)
   *
   * Adds a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_occluders_retain(occluders: Pointer): void;
  /**
   * void hrbfnpr_occluders_release(const hrbfnpr_occluders* occluders)
   *
   * Releases a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_occluders_release(occluders: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_shading_desc_init(hrbfnpr_shading_desc* desc, uint32_t struct_size)
   *
   * Sets every field to its default.
   */
  hrbfnpr_shading_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_shading_create(hrbfnpr_context* context, const hrbfnpr_occluders* occluders, const
   * hrbfnpr_item* item, const hrbfnpr_camera* camera, const hrbfnpr_shading_desc* desc, hrbfnpr_operation*
   * operation, hrbfnpr_shading** out_shading, hrbfnpr_error* error)
   *
   * Computes how much of the sky [Zhukov, Iones & Kronin 1998] and of each light with a shadow the marks of an
   * item see.
   * The result holds for the item's point set, its transform, the lights of its style, and the occluders.  It
   * stays valid
   * while these stay, for any camera, except that lights in camera space move with the camera.
   *
   * With HRBFNPR_SHADING_WITH_LINES it also finds the borders of shadows on the item, as exact curves: outlines
   * that a
   * light sees of the occluders, carried along its rays to the first surface.  Borders inside another shadow, and
   * those
   * shorter than 0.01 diagonals of all occluders, are left out.  Soft lights have the borders of their middle.  An
   * item
   * shows the lines if its style has line styles of the kinds SHADOW and TERMINATOR.
   *
   * occluders:   the surfaces, in world space
   * item:        point_set, style and transform are read, and line_set with HRBFNPR_SHADING_WITH_LINES or if the
   * style
   *              has a curvature_contrast.  It need not be one of the occluders; then it casts no shadow itself
   * camera:      the camera of lights in camera space that cast shadows; may be NULL without such lights
   * desc:        NULL = all defaults
   *
   * operation:   may be NULL
   *
   * Errors: INVALID_ARGUMENT (for example WITH_LINES without a line_set).
   */
  hrbfnpr_shading_create(context: Pointer, occluders: Pointer, item: Pointer, camera: Pointer, desc: Pointer, operation: Pointer, out_shading: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_shading_view(const hrbfnpr_shading* shading, int64_t layer, int64_t light,
   * hrbfnpr_array* out_view, hrbfnpr_error* error)
   *
   * Gets what the marks of a layer see, without a copy: FLOAT32, n x 1, in the order of the marks.  1 = all, 0 =
   * nothing.
   * `light` is the number of a light of the style, from 0, that casts shadows; -1 = the openness, the share of the
   * sky.
   * The view is valid as long as the shading.
   *
   * Errors: INVALID_ARGUMENT (there is no such layer; the light casts no shadow; the occlusion was not computed).
   */
  hrbfnpr_shading_view(shading: Pointer, layer: number, light: number, out_view: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_shading_retain(const hrbfnpr_shading* shading)
   *
   * Adds a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_shading_retain(shading: Pointer): void;
  /**
   * void hrbfnpr_shading_release(const hrbfnpr_shading* shading)
   *
   * Releases a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_shading_release(shading: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_renderer_draw(hrbfnpr_renderer* renderer, const hrbfnpr_item* items, int64_t
   * item_count, int64_t item_stride, const hrbfnpr_camera* camera, hrbfnpr_drawing** out_drawing, hrbfnpr_error*
   * error)
   *
   * Draws a list of items for one camera: it classifies, shades and orders their marks, and traces their lines.
   * item_stride is the number of bytes from one item to the next; 0 = struct_size.  All styles must have the same
   * paper
   * and visibility.  All items together have at most 2147483647 marks.
   *
   * Where the camera moved little, contours begin with those of the renderer's last drawing, and are proven
   * complete
   * again.  So a picture of lines depends on the drawings before it: in its last digits, and by the wobble of its
   * lines.
   *
   * Errors: INVALID_ARGUMENT (an item, a style or the camera; lines that need curvatures from a line set without
   * WITH_CURVATURE), OUT_OF_MEMORY, CALLBACK.
   */
  hrbfnpr_renderer_draw(renderer: Pointer, items: Pointer, item_count: number, item_stride: number, camera: Pointer, out_drawing: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_renderer_draw_with_operation(hrbfnpr_renderer* renderer, const hrbfnpr_item* items,
   * int64_t item_count, int64_t item_stride, const hrbfnpr_camera* camera, hrbfnpr_operation* operation,
   * hrbfnpr_drawing** out_drawing, hrbfnpr_error* error)
   *
   * Draws like hrbfnpr_renderer_draw, with an operation (NULL = none).  Use it for frames that take long: lines of
   * a fine
   * surface, millions of marks, rays of an item's model, tone callbacks.  After a cancel there is no drawing.  The
   * renderer then goes on as if the call had not been made, except that contours are not continued from the last
   * drawing.
   * Errors: those of hrbfnpr_renderer_draw, and CANCELLED.
   */
  hrbfnpr_renderer_draw_with_operation(renderer: Pointer, items: Pointer, item_count: number, item_stride: number, camera: Pointer, operation: Pointer, out_drawing: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_generate_still(hrbfnpr_context* context, const hrbfnpr_model* model, const
   * hrbfnpr_generate_desc* desc, const hrbfnpr_item* item, const hrbfnpr_camera* camera, hrbfnpr_operation*
   * operation, hrbfnpr_point_set** out_point_set, hrbfnpr_error* error)
   *
   * Places the marks of a still picture: like hrbfnpr_point_set_generate, but BLUE_NOISE leaves out marks that a
   * drawing
   * of `item` by `camera` does not need.  These are marks outside the picture, on a side that is not drawn, and in
   * tones
   * that are too light for them.  The other marks keep their density, ranks and tones; a few lie elsewhere.  Marks
   * of a
   * layer with a range of tones, of PUBLISHED, and of a style with VISIBILITY_PUBLISHED are all placed.
   *
   * item:        style, sides and transform of the drawing.  Its point_set may be NULL, and is not read
   * desc:        NULL = all defaults
   * operation:   may be NULL
   *
   * Another camera, transform or style would show gaps, so drawing with them fails.  Styles may differ in inks,
   * lines and
   * paper.  The set cannot be saved.
   * Errors: those of hrbfnpr_point_set_generate; INVALID_ARGUMENT (the item, its style or the camera).
   */
  hrbfnpr_point_set_generate_still(context: Pointer, model: Pointer, desc: Pointer, item: Pointer, camera: Pointer, operation: Pointer, out_point_set: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_drawing_retain(const hrbfnpr_drawing* drawing)
   *
   * Adds a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_drawing_retain(drawing: Pointer): void;
  /**
   * void hrbfnpr_drawing_release(const hrbfnpr_drawing* drawing)
   *
   * Releases a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_drawing_release(drawing: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_drawing_info_init(hrbfnpr_drawing_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_drawing_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_get_info(const hrbfnpr_drawing* drawing, hrbfnpr_drawing_info* info,
   * hrbfnpr_error* error)
   *
   * Gets what a drawing holds, and what making it did.
   */
  hrbfnpr_drawing_get_info(drawing: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_layer_info_init(hrbfnpr_drawing_layer_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_drawing_layer_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_get_layer_info(const hrbfnpr_drawing* drawing, int64_t number,
   * hrbfnpr_drawing_layer_info* info, hrbfnpr_error* error)
   *
   * Gets what a layer of a drawing holds.  `number` is 0 .. hrbfnpr_drawing_info.layers - 1.
   * Errors: INVALID_ARGUMENT (no such layer).
   */
  hrbfnpr_drawing_get_layer_info(drawing: Pointer, number: number, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_raster_desc_init(hrbfnpr_raster_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_raster_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_image* image, const
   * hrbfnpr_raster_desc* desc, hrbfnpr_error* error)
   *
   * Draws into an image.  It fills the viewport, clipped to the image, with paper and ink, and leaves other pixels
   * as
   * they are.  `desc` may be NULL for the defaults.
   * Errors: INVALID_ARGUMENT (a field of the image or of `desc`), OUT_OF_MEMORY.
   */
  hrbfnpr_drawing_rasterize(drawing: Pointer, image: Pointer, desc: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_vertex_attribute_init(hrbfnpr_vertex_attribute* attribute, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_vertex_attribute_init(attribute: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_vertex_layout_init(hrbfnpr_vertex_layout* layout, uint32_t struct_size)
   *
   * Sets struct_size, POINTS and no attributes.
   */
  hrbfnpr_vertex_layout_init(layout: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_vertex_bound(const hrbfnpr_drawing* drawing, uint32_t primitive, int64_t*
   * vertices, int64_t* indices, hrbfnpr_error* error)
   *
   * Gets the numbers of vertices and indices that hrbfnpr_drawing_write_vertices writes for a primitive
   * (HRBFNPR_PRIMITIVE_...).  `vertices` and `indices` may be NULL.
   * Errors: INVALID_ARGUMENT (no such primitive).
   */
  hrbfnpr_drawing_vertex_bound(drawing: Pointer, primitive: number, vertices: Pointer, indices: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_write_vertices(const hrbfnpr_drawing* drawing, const hrbfnpr_vertex_layout*
   * layout, void* vertices, int64_t vertex_capacity, int64_t* vertex_count, uint32_t* indices, int64_t
   * index_capacity, int64_t* index_count, hrbfnpr_error* error)
   *
   * Writes the vertices of a drawing's dots or strokes, from far to near.
   *
   * POINTS: discs of paper and of ink.  A host gets the dots of hrbfnpr_drawing_rasterize if it paints them in
   * this
   * order, as round anti-aliased points with "source over" blending; only host_depth has no effect.  A dot with a
   * radius
   * r below half a pixel is written with half a pixel, and its alpha times (2 r)^2.  With transparent paper the
   * discs of
   * paper must erase: destination times (1 - alpha).
   *
   * Strips: `indices` (UINT32, may be NULL) gets the vertices of one stroke after the other, each stroke ended by
   * HRBFNPR_INDEX_RESTART.  A triangle strip has two vertices for each point, on its left and right, and two at
   * the tip
   * of a pointed end.  Round ends are cut off flat.  For POINTS `indices` gets 0, 1, 2 and so on.
   *
   * Capacities are numbers of vertices and of indices. *vertex_count and *index_count (may be NULL) get the
   * numbers that
   * were written, or that are needed with BUFFER_TOO_SMALL.
   * Errors: INVALID_ARGUMENT (a field of the layout; a negative capacity), BUFFER_TOO_SMALL (a capacity is too
   * small;
   * nothing is written), OUT_OF_MEMORY.
   */
  hrbfnpr_drawing_write_vertices(drawing: Pointer, layout: Pointer, vertices: Pointer, vertex_capacity: number, vertex_count: Pointer, indices: Pointer, index_capacity: number, index_count: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mark_results_init(hrbfnpr_mark_results* results, uint32_t struct_size)
   *
   * Sets struct_size; no array is given.
   */
  hrbfnpr_mark_results_init(results: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_mark_results(const hrbfnpr_drawing* drawing, int64_t item, int64_t layer,
   * hrbfnpr_mark_results* results, hrbfnpr_error* error)
   *
   * Gets how each mark of one layer of one item's point set is drawn.  The layer need not be drawn.
   * Errors: INVALID_ARGUMENT (no such item or layer; an array of another size or type).
   */
  hrbfnpr_drawing_mark_results(drawing: Pointer, item: number, layer: number, results: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_write_mark_indices(const hrbfnpr_drawing* drawing, int64_t item, int64_t layer,
   * uint32_t mark_class, uint32_t primitive, uint32_t* indices, int64_t capacity, int64_t* count, hrbfnpr_error*
   * error)
   *
   * Writes which marks of a layer are drawn as one class: the numbers of these marks, UINT32.  `mark_class` is
   * HRBFNPR_CLASS_FRONT or SILHOUETTE.  With POINTS they are the marks that are shown, from far to near.  With
   * LINE_STRIPS they are runs of shown marks along strokes, each ended by HRBFNPR_INDEX_RESTART.  With
   * TRIANGLE_STRIPS
   * they are the same runs, with 2 * number and 2 * number + 1 for each mark.
   *
   * *count (not NULL) gets the number of indices written, or needed with BUFFER_TOO_SMALL.  `indices` may be NULL
   * if
   * capacity is 0.
   * Errors: INVALID_ARGUMENT (no such item, layer, class or primitive), BUFFER_TOO_SMALL (nothing is written),
   * OUT_OF_MEMORY.
   */
  hrbfnpr_drawing_write_mark_indices(drawing: Pointer, item: number, layer: number, mark_class: number, primitive: number, indices: Pointer, capacity: number, count: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mark_identity_init(hrbfnpr_mark_identity* identity, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_mark_identity_init(identity: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_identify(const hrbfnpr_drawing* drawing, uint32_t id, hrbfnpr_mark_identity*
   * identity, hrbfnpr_error* error)
   *
   * Finds the mark that has an id.
   * Errors: INVALID_ARGUMENT (no mark has the id).
   */
  hrbfnpr_drawing_identify(drawing: Pointer, id: number, identity: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_desc_init(hrbfnpr_mesh_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_mesh_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_create(hrbfnpr_context* context, const hrbfnpr_mesh_desc* desc, hrbfnpr_operation*
   * operation, hrbfnpr_mesh** out_mesh, hrbfnpr_error* error)
   *
   * Makes a mesh from triangles, and repairs it.  `operation` may be NULL.
   * Errors: INVALID_ARGUMENT (a corner that is not the number of a vertex, or whose vertex is not finite: the
   * message
   * names the face and the index; coordinates beyond 1e60; a mesh less than 1e-60 across; a mesh that has no face
   * left),
   * OUT_OF_MEMORY, CANCELLED.
   */
  hrbfnpr_mesh_create(context: Pointer, desc: Pointer, operation: Pointer, out_mesh: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_mesh_retain(const hrbfnpr_mesh* mesh)
   *
   * Adds a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_mesh_retain(mesh: Pointer): void;
  /**
   * void hrbfnpr_mesh_release(const hrbfnpr_mesh* mesh)
   *
   * Releases a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_mesh_release(mesh: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_mesh_info_init(hrbfnpr_mesh_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_mesh_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_get_info(const hrbfnpr_mesh* mesh, hrbfnpr_mesh_info* info, hrbfnpr_error* error)
   *
   * Gets what making a mesh found, and did.
   */
  hrbfnpr_mesh_get_info(mesh: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_view(const hrbfnpr_mesh* mesh, uint32_t attribute, hrbfnpr_array* out_view,
   * hrbfnpr_error* error)
   *
   * Gets a view of an array of the mesh, HRBFNPR_MESH_ATTRIBUTE_..., without a copy.  It is valid while the mesh
   * lives.
   * Errors: INVALID_ARGUMENT (no such attribute).
   */
  hrbfnpr_mesh_view(mesh: Pointer, attribute: number, out_view: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_sample_desc_init(hrbfnpr_sample_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_sample_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_sample(const hrbfnpr_mesh* mesh, const hrbfnpr_sample_desc* desc, const
   * hrbfnpr_array_out* points, const hrbfnpr_array_out* normals, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Samples a mesh evenly, with as many samples as `points` has elements, 1 .. 10000000.  Each sample is the
   * candidate
   * farthest from those before, so that every prefix is even.  `points` and `normals` are n x 3, FLOAT32 or
   * FLOAT64.
   * `normals` may be NULL.  They are unit, and interpolated between the normals of the corners.  A corner's normal
   * takes
   * in the faces around its vertex within the crease angle, weighted by their angles there.  `desc` and
   * `operation` may
   * be NULL.
   * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
   */
  hrbfnpr_mesh_sample(mesh: Pointer, desc: Pointer, points: Pointer, normals: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_edges_desc_init(hrbfnpr_mesh_edges_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_mesh_edges_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_edges_info_init(hrbfnpr_mesh_edges_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_mesh_edges_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_edges(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_edges_desc* desc, const
   * hrbfnpr_array_out* patch, const hrbfnpr_array_out* sharp, hrbfnpr_mesh_edges_info* info, hrbfnpr_operation*
   * operation, hrbfnpr_error* error)
   *
   * Finds the sharp edges of a mesh and the smooth patches between them, as hrbfnpr_model_fit_mesh does with the
   * same
   * edges, crease_angle and far.  A sharp edge that ends within a patch goes on along edges that keep its
   * direction and
   * bend by 8 degrees or more.  Short sharp edges that separate nothing are dropped as noise.  Edges with one
   * face, or
   * with more than two, end patches but are not sharp.
   *
   * `patch` is m x 1 for the m faces of the mesh, INT64, INT32 or UINT32: it gets the number of each face's patch,
   * from 0
   * in the order of their first faces.  `sharp` is m x 3, of the same types: it gets 1 if the edge from corner k
   * of the
   * face to the next corner is sharp, 2 if it is a tangent edge, else 0.  `patch`, `sharp`, `desc`, `info` and
   * `operation` may be NULL.  The call only reads the mesh, so several threads may make it at the same time.
   * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
   */
  hrbfnpr_mesh_edges(mesh: Pointer, desc: Pointer, patch: Pointer, sharp: Pointer, info: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_farthest_points(hrbfnpr_context* context, const hrbfnpr_array* points, const
   * hrbfnpr_array_out* indices, const hrbfnpr_array_out* distance, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Orders points so that each is the farthest from those before it (farthest-point order), so that every prefix
   * is an
   * even choice [Gonzalez 1985].  The first is the point nearest to the middle of the bounding box.  If two points
   * are
   * equally far, the one with the lower number comes first.
   *
   * `points` is n x 3, FLOAT32 or FLOAT64, finite, up to 1e100.  `indices` is k x 1, INT64, INT32 or UINT32, 1 <=
   * k <= n:
   * it gets the numbers of the points.  `distance` is k x 1, FLOAT32 or FLOAT64, or NULL: it gets the distance of
   * each
   * from those before; infinite for the first.  `operation` may be NULL.
   * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
   */
  hrbfnpr_farthest_points(context: Pointer, points: Pointer, indices: Pointer, distance: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_compare_desc_init(hrbfnpr_compare_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_compare_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_comparison_init(hrbfnpr_comparison* comparison, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_comparison_init(comparison: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_compare_mesh(const hrbfnpr_model* model, const hrbfnpr_mesh* mesh, const
   * hrbfnpr_compare_desc* desc, hrbfnpr_comparison* comparison, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Measures how near the surface of any model and a mesh are to each other, both ways.  Both are in the same
   * coordinates.  The search for the surface starts from places on the mesh and from a lattice of 16^3 places in
   * the box.
   * A small part of the surface that is near none of these is missed.  `desc` and `operation` may be NULL.
   * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_model_compare_mesh(model: Pointer, mesh: Pointer, desc: Pointer, comparison: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_fit_desc_init(hrbfnpr_mesh_fit_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_mesh_fit_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_fit_info_init(hrbfnpr_mesh_fit_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_mesh_fit_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_fit_mesh(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_fit_desc* desc, const
   * hrbfnpr_fit_desc* fit, hrbfnpr_mesh_fit_info* info, hrbfnpr_operation* operation, hrbfnpr_model** out_model,
   * hrbfnpr_error* error)
   *
   * Fits a surface to a mesh, with as many samples as the tolerance takes.  It begins with some hundred even
   * samples.  In
   * rounds it adds samples where surface and mesh are far from each other.  Where the surface goes on far from the
   * mesh,
   * f is held to the signed distance from the mesh at a few places off it.  These places are the last centres of
   * the
   * model.  Their normals point to the mesh or away from it.
   *
   * A fit that ends short of the tolerance is no error: `reached` is 0, and the log warns.  It ends at
   * maximum_centres,
   * or when more centres gain nothing.  A smooth fit rounds edges by some tenths of the samples' spacing there.
   *
   * A mesh with sharp edges, as `edges` says, is cut along them into smooth patches.  Each patch gets its own fit,
   * a
   * sheet.  The surface is a maximum and minimum of sheets, which changes from cell to cell of space [Ohtake et
   * al.
   * 2003].  The points and normals of such a model are places all over the mesh, not its centres.
   * docs/how-fitting-works.md explains how edges are kept.
   *
   * The model is trimmed by places on the mesh if the mesh is open, or if the fit did not reach the tolerance,
   * unless the
   * trim of `fit` is NEVER.
   *
   * `fit` (may be NULL) gives kernel, solver, regularization and trim.  Its points and normals must be empty, and
   * its
   * tolerance and maximum_centres 0.  With a smooth fit, a solver_tolerance of 0 is the tolerance / 200 diagonals,
   * within
   * 1e-8 .. 1e-5.  `desc`, `info` and `operation` may be NULL.  The call needs the stack of hrbfnpr_model_fit.
   * Errors: those of hrbfnpr_model_fit.
   */
  hrbfnpr_model_fit_mesh(mesh: Pointer, desc: Pointer, fit: Pointer, info: Pointer, operation: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_page_item_init(hrbfnpr_page_item* item, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_page_item_init(item: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_pen_init(hrbfnpr_pen* pen, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_pen_init(pen: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_annotation_init(hrbfnpr_annotation* annotation, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_annotation_init(annotation: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_page_desc_init(hrbfnpr_page_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_page_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_page_info_init(hrbfnpr_page_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_page_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_page_write(hrbfnpr_context* context, const hrbfnpr_page_desc* desc, hrbfnpr_write_fn
   * write, void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * Writes a page, one buffer at a time.  Memory grows with the drawing's largest stroke; in plot order it grows
   * with the
   * largest group.  `info` and `operation` may be NULL.
   * Errors: INVALID_ARGUMENT (no drawing and no annotation; an empty page; a text that is not UTF-8; a drawing
   * with
   * VISIBILITY_PUBLISHED, which has discs of paper, for plotters, in DXF or in plot order), IO (`write` failed),
   * OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_page_write(context: Pointer, desc: Pointer, write: Pointer, user: Pointer, info: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_source_field_init(hrbfnpr_source_field* field, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_source_field_init(field: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_source_init(hrbfnpr_picture_source* source, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_picture_source_init(source: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_change_init(hrbfnpr_change* change, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_change_init(change: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_note_init(hrbfnpr_note* note, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_note_init(note: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_event_init(hrbfnpr_picture_event* event, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_picture_event_init(event: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_desc_init(hrbfnpr_picture_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_picture_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_source_info_init(hrbfnpr_source_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_source_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_source_inspect(hrbfnpr_context* context, const hrbfnpr_picture_source* source, uint32_t
   * wording, hrbfnpr_picture_event_fn on_event, void* event_user, hrbfnpr_operation* operation,
   * hrbfnpr_source_info* info, hrbfnpr_error* error)
   *
   * Looks at a source without drawing it.  It puts facts into `info`, and passes findings to on_event as notes.  A
   * NOTE
   * is something that a picture repairs.  A WARNING is something that is wrong, with advice.  One matter may give
   * both.
   * A FAILURE, with the code NOT_USABLE, says why the source cannot be drawn; the call succeeds all the same.
   * `wording`
   * is HRBFNPR_WORDING_...; on_event and `operation` may be NULL.
   * Errors: INVALID_ARGUMENT (fields of the source), OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_source_inspect(context: Pointer, source: Pointer, wording: number, on_event: Pointer, event_user: Pointer, operation: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_create(hrbfnpr_context* context, const hrbfnpr_picture_desc* desc,
   * hrbfnpr_operation* operation, hrbfnpr_picture** out_picture, hrbfnpr_error* error)
   *
   * Makes a picture: fits surfaces, places marks and finds lines.  It draws nothing yet.  `operation` may be NULL.
   * The
   * call needs the stack of hrbfnpr_model_fit.
   *
   * A field of a layer style (tone_field and so on) names values of the source (hrbfnpr_source_field), or a field
   * of its
   * point set.  For numbers of a source, the name may say which value becomes 0 and which becomes 1, as in
   * "quality:0.2..0.9"; else they are the least and the greatest value that is finite.  Outliers do not count for
   * this:
   * values farther from the inner 96 % than a quarter of the range of these.  "-quality" turns this round.
   * A colour in place of a number is its luminance, as in HRBFNPR_FIELD_SOURCE_IMAGE.  An ink_field without a
   * palette
   * gets one of three inks, or of up to eight if there are no more hues; a note names them.
   *
   * Errors: INVALID_ARGUMENT (a field of `desc`; a source that cannot be drawn), SINGULAR_SYSTEM, NOT_CONVERGED,
   * OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_picture_create(context: Pointer, desc: Pointer, operation: Pointer, out_picture: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_restyle(const hrbfnpr_picture* picture, const hrbfnpr_picture_desc* desc,
   * hrbfnpr_operation* operation, hrbfnpr_picture** out_picture, hrbfnpr_error* error)
   *
   * Makes a picture of the same surfaces in another style, size or view.  `desc` has no sources.  Marks and lines
   * that
   * fit are used again; others are made anew.  `operation` may be NULL.
   * Errors: those of hrbfnpr_picture_create; INVALID_ARGUMENT, too, if the picture was made with SURFACE_ONLY.
   */
  hrbfnpr_picture_restyle(picture: Pointer, desc: Pointer, operation: Pointer, out_picture: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_picture_retain(hrbfnpr_picture* picture)
   *
   * Adds a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_picture_retain(picture: Pointer): void;
  /**
   * void hrbfnpr_picture_release(hrbfnpr_picture* picture)
   *
   * Releases a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_picture_release(picture: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_picture_draw(hrbfnpr_picture* picture, const hrbfnpr_camera* camera, hrbfnpr_operation*
   * operation, hrbfnpr_drawing** out_drawing, hrbfnpr_error* error)
   *
   * Draws a picture.  `camera` NULL is the planned camera.  Lines keep their numbers from one drawing to the next.
   * Without KEEP_MARKS and without a turn, the picture has only the marks that the planned camera needs.  The
   * first
   * drawing by another camera then places all marks, and takes longer.
   * `operation` may be NULL.
   * Errors: INVALID_ARGUMENT (the camera; a picture made with SURFACE_ONLY; with the planned camera, a drawing in
   * which
   * hardly anything can be seen, unless ALLOW_BLANK is set: a note BLANK says more), OUT_OF_MEMORY, CANCELLED,
   * CALLBACK.
   */
  hrbfnpr_picture_draw(picture: Pointer, camera: Pointer, operation: Pointer, out_drawing: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_info_init(hrbfnpr_picture_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_picture_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_info(const hrbfnpr_picture* picture, hrbfnpr_picture_info* info,
   * hrbfnpr_error* error)
   *
   * Gets what a picture is made of.
   */
  hrbfnpr_picture_get_info(picture: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_part_init(hrbfnpr_picture_part* part, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_picture_part_init(part: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_part(const hrbfnpr_picture* picture, int64_t number, hrbfnpr_picture_part*
   * part, hrbfnpr_error* error)
   *
   * Gets one surface of a picture.  `number` is 0 .. hrbfnpr_picture_info.parts - 1; the largest surface is 0.
   * The last
   * one is the ground, if the picture has one.
   * Errors: INVALID_ARGUMENT (no such part).
   */
  hrbfnpr_picture_get_part(picture: Pointer, number: number, part: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_style(const hrbfnpr_picture* picture, const hrbfnpr_style** style,
   * hrbfnpr_error* error)
   *
   * Gets the style that was chosen for hrbfnpr_renderer_draw.  It is valid while the picture lives.
   * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY).
   */
  hrbfnpr_picture_get_style(picture: Pointer, style: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_marks(const hrbfnpr_picture* picture, const hrbfnpr_generate_desc** desc,
   * hrbfnpr_error* error)
   *
   * Gets the descriptor with which hrbfnpr_point_set_generate made the marks.  It is valid while the picture
   * lives. *desc
   * is NULL where the caller gave the marks.
   * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY).
   */
  hrbfnpr_picture_get_marks(picture: Pointer, desc: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_note(const hrbfnpr_picture* picture, int64_t number, hrbfnpr_note* note,
   * hrbfnpr_error* error)
   *
   * Gets a note.  `number` is 0 .. hrbfnpr_picture_info.notes - 1.  Its texts are valid while the picture lives.
   * Errors: INVALID_ARGUMENT (no such note).
   */
  hrbfnpr_picture_get_note(picture: Pointer, number: number, note: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_stage(const hrbfnpr_picture* picture, int64_t number,
   * hrbfnpr_picture_event* stage, hrbfnpr_error* error)
   *
   * Gets the last event of a stage that has ended.  `number` is 0 .. hrbfnpr_picture_info.stages - 1.
   * Errors: INVALID_ARGUMENT (no such stage).
   */
  hrbfnpr_picture_get_stage(picture: Pointer, number: number, stage: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_camera(const hrbfnpr_picture* picture, hrbfnpr_camera* camera,
   * hrbfnpr_error* error)
   *
   * Gets the planned camera.
   * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY).
   */
  hrbfnpr_picture_get_camera(picture: Pointer, camera: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_look(const hrbfnpr_picture* picture, const double* direction, double azimuth,
   * double elevation, hrbfnpr_camera* camera, hrbfnpr_error* error)
   *
   * Gets a camera that looks from another side, with the size, the lens and the margin of the picture.  It looks
   * along
   * `direction` (3 doubles, from the eye into the scene).  If that is NULL, it looks from `azimuth` and
   * `elevation`, in
   * degrees; NaN = as planned.
   * Errors: INVALID_ARGUMENT (a number is not finite; a picture made with SURFACE_ONLY).
   */
  hrbfnpr_picture_look(picture: Pointer, direction: Pointer, azimuth: number, elevation: number, camera: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_orbit(const hrbfnpr_picture* picture, double degrees, hrbfnpr_camera* camera,
   * hrbfnpr_error* error)
   *
   * Gets the planned camera, turned by an angle in degrees about the up axis through the middle of the model.  If
   * the
   * descriptor gave an eye, the axis goes through its target.
   * Errors: INVALID_ARGUMENT (the angle is not finite; a picture made with SURFACE_ONLY).
   */
  hrbfnpr_picture_orbit(picture: Pointer, degrees: number, camera: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_plate_size(const hrbfnpr_picture* picture, const hrbfnpr_camera* camera,
   * int32_t* width, int32_t* height, hrbfnpr_error* error)
   *
   * Gets the size of a picture's plate, in pixels.  A plate is a drawing with the section and the scale bar beside
   * it.
   * Without these it is the drawing alone.  `camera` is the camera that the drawing was made with; NULL = the
   * planned
   * camera.
   * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY).
   */
  hrbfnpr_picture_plate_size(picture: Pointer, camera: Pointer, width: Pointer, height: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_rasterize(const hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing, const
   * hrbfnpr_camera* camera, const hrbfnpr_image* image, hrbfnpr_error* error)
   *
   * Draws the plate of a picture into an image, from the top-left corner on.  The image has at least the size that
   * hrbfnpr_picture_plate_size gives.  `camera` is the camera that the drawing was made with; NULL = the planned
   * camera.
   * Errors: those of hrbfnpr_drawing_rasterize; INVALID_ARGUMENT, too, if the image is too small.
   */
  hrbfnpr_picture_rasterize(picture: Pointer, drawing: Pointer, camera: Pointer, image: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_page_desc_init(hrbfnpr_picture_page_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_picture_page_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_write(hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing, const
   * hrbfnpr_camera* camera, const hrbfnpr_picture_page_desc* desc, hrbfnpr_write_fn write, void* user,
   * hrbfnpr_page_info* info, hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * Writes the plate of a picture as vectors.  `camera` is the camera that the drawing was made with; NULL = the
   * planned
   * camera.  `desc`, `info` and `operation` may be NULL.  The picture gets notes PENS and PLOTTED.
   * Errors: those of hrbfnpr_page_write; INVALID_ARGUMENT, too, for a paper that is not known or has no room.
   */
  hrbfnpr_picture_write(picture: Pointer, drawing: Pointer, camera: Pointer, desc: Pointer, write: Pointer, user: Pointer, info: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_settings_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
   * hrbfnpr_settings** out_settings, hrbfnpr_error* error)
   *
   * Reads settings that hrbfnpr_picture_write_settings or the viewer wrote. docs/settings.md describes the format.
   * Errors: IO (`read` failed), INVALID_ARGUMENT (the message names the key and says what would be right),
   * OUT_OF_MEMORY.
   */
  hrbfnpr_settings_load(context: Pointer, read: Pointer, user: Pointer, out_settings: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_settings_retain(const hrbfnpr_settings* settings)
   *
   * Adds a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_settings_retain(settings: Pointer): void;
  /**
   * void hrbfnpr_settings_release(const hrbfnpr_settings* settings)
   *
   * Releases a reference.  Any thread may call it; NULL is ignored.
   */
  hrbfnpr_settings_release(settings: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_picture_write_settings(hrbfnpr_picture* picture, hrbfnpr_write_fn write, void* user,
   * hrbfnpr_error* error)
   *
   * Writes what a picture was made with.  The picture gets a note NOT_IN_SETTINGS about what settings do not hold.
   * Errors: INVALID_ARGUMENT (a picture made with SURFACE_ONLY), IO (`write` failed), OUT_OF_MEMORY.
   */
  hrbfnpr_picture_write_settings(picture: Pointer, write: Pointer, user: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_views_desc_init(hrbfnpr_views_desc* desc, uint32_t struct_size)
   *
   * Sets struct_size and all defaults.
   */
  hrbfnpr_views_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_views_info_init(hrbfnpr_views_info* info, uint32_t struct_size)
   *
   * Sets struct_size; all other fields are 0.
   */
  hrbfnpr_views_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_write_views(hrbfnpr_picture* picture, const hrbfnpr_views_desc* desc,
   * hrbfnpr_write_fn write, void* user, hrbfnpr_views_info* info, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Writes a sheet of views of a picture's parts, which must have models.  A picture made with SURFACE_ONLY is
   * enough,
   * and its models have the cavities of meshes; others may need SOLIDS as `parts`.  `desc`, `info` and `operation`
   * may be
   * NULL.  The picture gets stages LINES and VIEWS, and notes UNIT_IS_METRE, NO_SYMMETRY, SECTION_OPEN and
   * LINES_VERIFIED.
   * Errors: INVALID_ARGUMENT (a picture of a point set; a text that is not understood; a plane that misses the
   * model;
   * views that have no room on the paper at the scale: the message names a scale or paper with room), and those of
   * hrbfnpr_line_set_create, hrbfnpr_renderer_draw and hrbfnpr_page_write.
   */
  hrbfnpr_picture_write_views(picture: Pointer, desc: Pointer, write: Pointer, user: Pointer, info: Pointer, operation: Pointer, error: Pointer): number;
}

export declare const FUNCTIONS: Readonly<Record<keyof Functions, string>>;
export declare const CALLBACKS: Readonly<Record<string, string>>;
