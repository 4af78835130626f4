// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.

/** An address in the module's memory; 0 is NULL. */
export type Pointer = number;

/** The functions of the C interface, by their own names.  64-bit integers are numbers here. */
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
   * origins:      n x 3, FLOAT32 or FLOAT64, finite
   * directions:   n x 3, FLOAT32 or FLOAT64, finite, of any length but 0
   * desc:         NULL = all defaults
   * hits:         the arrays that receive the results
   * operation:    may be NULL
   *
   * Errors: INVALID_ARGUMENT: NaN, infinity, a zero direction, different counts of
   * origins and directions, or a direction so short that the t of a hit is infinite.
   */
  hrbfnpr_model_cast_rays(model: Pointer, origins: Pointer, directions: Pointer, desc: Pointer, hits: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_lipschitz(const hrbfnpr_model* model, double* lipschitz, hrbfnpr_operation*
   * operation, hrbfnpr_error* error)
   *
   * Computes the bound on |grad f| that hrbfnpr_model_cast_rays uses if none is given.
   * For a solid of primitives it is a true bound (hrbfnpr_csg_info.lipschitz).  For other
   * models it is an estimate: 1.5 times the largest |grad f| at 24^3 points of the search
   * box.  A program that casts few rays in each call should ask for the bound once and
   * pass it on, because each call without it evaluates these points.
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
   *
   */
  hrbfnpr_line_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_line_set_desc_init(hrbfnpr_line_set_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_line_set_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_line_set_create(hrbfnpr_context* context, const hrbfnpr_model* model, const
   * hrbfnpr_line_set_desc* desc, hrbfnpr_operation* operation, hrbfnpr_line_set** out_line_set, hrbfnpr_error*
   * error)
   *
   * The line set keeps the model.  desc NULL = defaults.
   * Errors: INVALID_ARGUMENT (more than 4 000 000 triangles: a larger cell_size; a support without samples),
   * NOT_CONVERGED (no surface was found, or none near its samples), OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_line_set_create(context: Pointer, model: Pointer, desc: Pointer, operation: Pointer, out_line_set: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_line_set_retain(const hrbfnpr_line_set* line_set)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_line_set_retain(line_set: Pointer): void;
  /**
   * void hrbfnpr_line_set_release(const hrbfnpr_line_set* line_set)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_line_set_release(line_set: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_line_set_info_init(hrbfnpr_line_set_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_line_set_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_line_set_get_info(const hrbfnpr_line_set* line_set, hrbfnpr_line_set_info* info,
   * hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_line_set_get_info(line_set: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_init(hrbfnpr_camera* camera, uint32_t struct_size)
   *
   * Identity matrices, viewport 0 x 0 (which _draw refuses).
   */
  hrbfnpr_camera_init(camera: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_look_at(hrbfnpr_camera* camera, const double* eye, const double* target, const
   * double* up, hrbfnpr_error* error)
   *
   * Sets `view`: from eye towards target, up roughly along `up`; 3 doubles each.
   * INVALID_ARGUMENT if eye = target or up is parallel to the view.
   */
  hrbfnpr_camera_look_at(camera: Pointer, eye: Pointer, target: Pointer, up: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_perspective(hrbfnpr_camera* camera, double vertical_angle, double width, double
   * height, double near_plane, double far_plane, hrbfnpr_error* error)
   *
   * Sets `projection` and the viewport's size.  vertical_angle in radians, in
   * (0, pi); 0 < near_plane < far_plane.
   */
  hrbfnpr_camera_perspective(camera: Pointer, vertical_angle: number, width: number, height: number, near_plane: number, far_plane: number, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_orthographic(hrbfnpr_camera* camera, double view_height, double width, double
   * height, double near_plane, double far_plane, hrbfnpr_error* error)
   *
   * Sets `projection` and the viewport's size; `view_height` is the height of
   * the visible slab in world units; near_plane < far_plane, either sign.
   */
  hrbfnpr_camera_orthographic(camera: Pointer, view_height: number, width: number, height: number, near_plane: number, far_plane: number, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_fit_bounds(hrbfnpr_camera* camera, const double* bounds_min, const double*
   * bounds_max, const double* direction, const double* up, double vertical_angle, double width, double height,
   * double margin, hrbfnpr_error* error)
   *
   * Sets view, projection and viewport so that the box fills the picture but for
   * `margin` (share of the picture on each side, 0 .. 0.45), seen along
   * `direction` (from the eye into the scene).  vertical_angle 0 = orthographic.
   */
  hrbfnpr_camera_fit_bounds(camera: Pointer, bounds_min: Pointer, bounds_max: Pointer, direction: Pointer, up: Pointer, vertical_angle: number, width: number, height: number, margin: number, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_camera_fit_points(hrbfnpr_camera* camera, const hrbfnpr_array* points, const double*
   * origin, const double* direction, const double* up, double vertical_angle, double width, double height, double
   * margin, hrbfnpr_error* error)
   *
   * The same for n x 3 points, FLOAT32 or FLOAT64, n >= 1: the points themselves
   * fill the picture, not the corners of their box, and lie in its middle.
   * `origin` (3 doubles, NULL = 0) is added to each: with a point set's POSITION
   * give its info's origin.
   */
  hrbfnpr_camera_fit_points(camera: Pointer, points: Pointer, origin: Pointer, direction: Pointer, up: Pointer, vertical_angle: number, width: number, height: number, margin: number, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_layer_style_init(hrbfnpr_layer_style* style, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_layer_style_init(style: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_line_style_init(hrbfnpr_line_style* style, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_line_style_init(style: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_style_init(hrbfnpr_style* style, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_style_init(style: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_style_init_preset(hrbfnpr_style* style, uint32_t struct_size, uint32_t preset,
   * hrbfnpr_error* error)
   *
   * A full set of fields that a caller goes on changing.  style->layers and style->lines
   * point to constants of the library: copy an element to change it.
   */
  hrbfnpr_style_init_preset(style: Pointer, struct_size: number, preset: number, error: Pointer): number;
  /**
   * const hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint32_t preset, int64_t* count)
   *
   * The layers that a preset draws, with defaults: a list of constants for
   * hrbfnpr_generate_desc.layers (with layer_stride 0).  *count gets their number.
   * NULL and 0 for a number that is no preset's.
   */
  hrbfnpr_preset_layers(preset: number, count: Pointer): Pointer;
  /**
   * const char* hrbfnpr_preset_name(uint32_t preset)
   *
   * "stipple", "hatch", "cross-hatch", ...; NULL for a number that is no preset's:
   * presets are numbered from 0 without gaps.
   */
  hrbfnpr_preset_name(preset: number): Pointer;
  /**
   * hrbfnpr_status hrbfnpr_renderer_create(hrbfnpr_context* context, hrbfnpr_renderer** out_renderer,
   * hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_renderer_create(context: Pointer, out_renderer: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_renderer_retain(hrbfnpr_renderer* renderer)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_renderer_retain(renderer: Pointer): void;
  /**
   * void hrbfnpr_renderer_release(hrbfnpr_renderer* renderer)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_renderer_release(renderer: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_layer_pose_init(hrbfnpr_layer_pose* pose, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_layer_pose_init(pose: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_item_init(hrbfnpr_item* item, uint32_t struct_size)
   *
   * NULL pointers and the identity transform.
   */
  hrbfnpr_item_init(item: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_renderer_draw(hrbfnpr_renderer* renderer, const hrbfnpr_item* items, int64_t
   * item_count, int64_t item_stride, const hrbfnpr_camera* camera, hrbfnpr_drawing** out_drawing, hrbfnpr_error*
   * error)
   *
   * Classifies, shades and orders the marks of a list of items for one camera.
   * Styles of one drawing must have the same paper and visibility.
   * Contours of line sets begin with those of the renderer's last drawing where the
   * camera moved little, and are proven complete again: in their last digits, and by
   * `wobble`, a picture of lines depends on the drawings before it.
   * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CALLBACK.
   */
  hrbfnpr_renderer_draw(renderer: Pointer, items: Pointer, item_count: number, item_stride: number, camera: Pointer, out_drawing: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_renderer_draw_with_operation(hrbfnpr_renderer* renderer, const hrbfnpr_item* items,
   * int64_t item_count, int64_t item_stride, const hrbfnpr_camera* camera, hrbfnpr_operation* operation,
   * hrbfnpr_drawing** out_drawing, hrbfnpr_error* error)
   *
   * The same with an operation (NULL = none), for frames that take long: lines of
   * a fine surface, millions of marks, rays of an item's model, callbacks of tone.
   * After a cancel there is no drawing, and the renderer goes on as if the call
   * had not been made, but that contours of line sets are traced from nothing.
   * Errors: also CANCELLED.
   */
  hrbfnpr_renderer_draw_with_operation(renderer: Pointer, items: Pointer, item_count: number, item_stride: number, camera: Pointer, operation: Pointer, out_drawing: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_drawing_retain(const hrbfnpr_drawing* drawing)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_drawing_retain(drawing: Pointer): void;
  /**
   * void hrbfnpr_drawing_release(const hrbfnpr_drawing* drawing)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_drawing_release(drawing: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_drawing_info_init(hrbfnpr_drawing_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_drawing_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_get_info(const hrbfnpr_drawing* drawing, hrbfnpr_drawing_info* info,
   * hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_drawing_get_info(drawing: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_layer_info_init(hrbfnpr_drawing_layer_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_drawing_layer_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_get_layer_info(const hrbfnpr_drawing* drawing, int64_t number,
   * hrbfnpr_drawing_layer_info* info, hrbfnpr_error* error)
   *
   * number: 0 .. hrbfnpr_drawing_info.layers - 1.
   */
  hrbfnpr_drawing_get_layer_info(drawing: Pointer, number: number, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_raster_desc_init(hrbfnpr_raster_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_raster_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_image* image, const
   * hrbfnpr_raster_desc* desc, hrbfnpr_error* error)
   *
   * Draws into an image.  The viewport (clipped to the image) is filled with
   * paper and ink; pixels outside it are not touched.  desc may be NULL.
   */
  hrbfnpr_drawing_rasterize(drawing: Pointer, image: Pointer, desc: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_vertex_attribute_init(hrbfnpr_vertex_attribute* attribute, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_vertex_attribute_init(attribute: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_vertex_layout_init(hrbfnpr_vertex_layout* layout, uint32_t struct_size)
   *
   * Points, and no attributes.
   */
  hrbfnpr_vertex_layout_init(layout: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_vertex_bound(const hrbfnpr_drawing* drawing, uint32_t primitive, int64_t*
   * vertices, int64_t* indices, hrbfnpr_error* error)
   *
   * How many vertices and indices a primitive has; each may be NULL.
   */
  hrbfnpr_drawing_vertex_bound(drawing: Pointer, primitive: number, vertices: Pointer, indices: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_write_vertices(const hrbfnpr_drawing* drawing, const hrbfnpr_vertex_layout*
   * layout, void* vertices, int64_t vertex_capacity, int64_t* vertex_count, uint32_t* indices, int64_t
   * index_capacity, int64_t* index_count, hrbfnpr_error* error)
   *
   * Writes the drawing's dots or strokes, far to near.
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
   * (nullable) get the numbers written, or needed with BUFFER_TOO_SMALL.
   */
  hrbfnpr_drawing_write_vertices(drawing: Pointer, layout: Pointer, vertices: Pointer, vertex_capacity: number, vertex_count: Pointer, indices: Pointer, index_capacity: number, index_count: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mark_results_init(hrbfnpr_mark_results* results, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_mark_results_init(results: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_mark_results(const hrbfnpr_drawing* drawing, int64_t item, int64_t layer,
   * hrbfnpr_mark_results* results, hrbfnpr_error* error)
   *
   * Of one layer of one item's point set; also of a layer that is not drawn.
   */
  hrbfnpr_drawing_mark_results(drawing: Pointer, item: number, layer: number, results: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_write_mark_indices(const hrbfnpr_drawing* drawing, int64_t item, int64_t layer,
   * uint32_t mark_class, uint32_t primitive, uint32_t* indices, int64_t capacity, int64_t* count, hrbfnpr_error*
   * error)
   *
   * Which marks of a layer are drawn: numbers of marks, UINT32.
   * POINTS: those that are shown, far to near.  LINE_STRIPS: along strokes, a run
   * of shown marks each, ended by HRBFNPR_INDEX_RESTART.  TRIANGLE_STRIPS: the
   * same, 2 * number and 2 * number + 1 for each mark.
   * mark_class: HRBFNPR_CLASS_FRONT or SILHOUETTE.  *count gets the number written, or needed
   * with BUFFER_TOO_SMALL; indices may be NULL when capacity is 0.
   */
  hrbfnpr_drawing_write_mark_indices(drawing: Pointer, item: number, layer: number, mark_class: number, primitive: number, indices: Pointer, capacity: number, count: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mark_identity_init(hrbfnpr_mark_identity* identity, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_mark_identity_init(identity: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_drawing_identify(const hrbfnpr_drawing* drawing, uint32_t id, hrbfnpr_mark_identity*
   * identity, hrbfnpr_error* error)
   *
   * What an id stands for.  INVALID_ARGUMENT for one that is no mark's.
   */
  hrbfnpr_drawing_identify(drawing: Pointer, id: number, identity: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_desc_init(hrbfnpr_mesh_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_mesh_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_create(hrbfnpr_context* context, const hrbfnpr_mesh_desc* desc, hrbfnpr_operation*
   * operation, hrbfnpr_mesh** out_mesh, hrbfnpr_error* error)
   *
   * operation may be NULL.  Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
   */
  hrbfnpr_mesh_create(context: Pointer, desc: Pointer, operation: Pointer, out_mesh: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_mesh_retain(const hrbfnpr_mesh* mesh)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_mesh_retain(mesh: Pointer): void;
  /**
   * void hrbfnpr_mesh_release(const hrbfnpr_mesh* mesh)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_mesh_release(mesh: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_mesh_info_init(hrbfnpr_mesh_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_mesh_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_get_info(const hrbfnpr_mesh* mesh, hrbfnpr_mesh_info* info, hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_mesh_get_info(mesh: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_view(const hrbfnpr_mesh* mesh, uint32_t attribute, hrbfnpr_array* out_view,
   * hrbfnpr_error* error)
   *
   * A zero-copy view of what is kept, valid while the mesh lives.
   */
  hrbfnpr_mesh_view(mesh: Pointer, attribute: number, out_view: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_sample_desc_init(hrbfnpr_sample_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_sample_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_sample(const hrbfnpr_mesh* mesh, const hrbfnpr_sample_desc* desc, const
   * hrbfnpr_array_out* points, const hrbfnpr_array_out* normals, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * As many samples of the mesh as `points` has elements (at least 1, 10000000 at
   * most): random places, even over its area, of which each next one that is
   * taken is the farthest from those before, so that every prefix is even.
   * points, normals: n x 3, FLOAT32 or FLOAT64; normals (may be NULL) are unit,
   * interpolated between those of the corners, which take in the faces about
   * their vertex within the crease angle, by their angles there.
   * desc may be NULL; operation too.
   */
  hrbfnpr_mesh_sample(mesh: Pointer, desc: Pointer, points: Pointer, normals: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_edges_desc_init(hrbfnpr_mesh_edges_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_mesh_edges_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_edges_info_init(hrbfnpr_mesh_edges_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_mesh_edges_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_edges(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_edges_desc* desc, const
   * hrbfnpr_array_out* patch, const hrbfnpr_array_out* sharp, hrbfnpr_mesh_edges_info* info, hrbfnpr_operation*
   * operation, hrbfnpr_error* error)
   *
   * Finds the sharp edges of a mesh and the smooth patches between them, as
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
   * the mesh.  Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
   */
  hrbfnpr_mesh_edges(mesh: Pointer, desc: Pointer, patch: Pointer, sharp: Pointer, info: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_farthest_points(hrbfnpr_context* context, const hrbfnpr_array* points, const
   * hrbfnpr_array_out* indices, const hrbfnpr_array_out* distance, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Farthest-point order: each is the point farthest from those before it, the
   * first the one nearest to the middle of the bounding box; of equals the one of
   * lower number.  Every prefix is an even choice [Gonzalez 1985].
   * points:   n x 3, FLOAT32 or FLOAT64, finite, below 1e100.
   * indices:  k x 1, INT64, INT32 or UINT32, k <= n: numbers of points.
   * distance: k x 1, FLOAT32 or FLOAT64, or NULL: from those before; infinite for
   *           the first.
   * 20 000 of a million take half a second.  operation may be NULL.
   */
  hrbfnpr_farthest_points(context: Pointer, points: Pointer, indices: Pointer, distance: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_compare_desc_init(hrbfnpr_compare_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_compare_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_comparison_init(hrbfnpr_comparison* comparison, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_comparison_init(comparison: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_compare_mesh(const hrbfnpr_model* model, const hrbfnpr_mesh* mesh, const
   * hrbfnpr_compare_desc* desc, hrbfnpr_comparison* comparison, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Measures both ways, for any model, in the same coordinates as the mesh.  The
   * surface is found from places on the mesh and from 16^3 places of the box: a
   * small part of it that neither leads to is missed.
   * desc may be NULL; operation too.
   */
  hrbfnpr_model_compare_mesh(model: Pointer, mesh: Pointer, desc: Pointer, comparison: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_fit_desc_init(hrbfnpr_mesh_fit_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_mesh_fit_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_mesh_fit_info_init(hrbfnpr_mesh_fit_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_mesh_fit_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_fit_mesh(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_fit_desc* desc, const
   * hrbfnpr_fit_desc* fit, hrbfnpr_mesh_fit_info* info, hrbfnpr_operation* operation, hrbfnpr_model** out_model,
   * hrbfnpr_error* error)
   *
   * Fits a surface to a mesh with as many samples as that takes: some hundred
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
   * stack it needs as well.
   */
  hrbfnpr_model_fit_mesh(mesh: Pointer, desc: Pointer, fit: Pointer, info: Pointer, operation: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_page_item_init(hrbfnpr_page_item* item, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_page_item_init(item: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_pen_init(hrbfnpr_pen* pen, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_pen_init(pen: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_annotation_init(hrbfnpr_annotation* annotation, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_annotation_init(annotation: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_page_desc_init(hrbfnpr_page_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_page_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_page_info_init(hrbfnpr_page_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_page_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_page_write(hrbfnpr_context* context, const hrbfnpr_page_desc* desc, hrbfnpr_write_fn
   * write, void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * Writes a page, a buffer at a time; memory grows with the drawing's largest stroke,
   * in plot order with its largest group.  info and operation may be NULL.
   * Errors: INVALID_ARGUMENT (no drawing and no annotation; an empty page; text that
   * is not UTF-8; discs of paper, which PUBLISHED frames have, for plotters or in plot
   * order), IO (write failed), OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_page_write(context: Pointer, desc: Pointer, write: Pointer, user: Pointer, info: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_source_init(hrbfnpr_picture_source* source, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_picture_source_init(source: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_change_init(hrbfnpr_change* change, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_change_init(change: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_dab_init(hrbfnpr_dab* dab, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_dab_init(dab: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_note_init(hrbfnpr_note* note, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_note_init(note: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_event_init(hrbfnpr_picture_event* event, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_picture_event_init(event: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_desc_init(hrbfnpr_picture_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_picture_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_source_info_init(hrbfnpr_source_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_source_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_source_inspect(hrbfnpr_context* context, const hrbfnpr_picture_source* source, uint32_t
   * wording, hrbfnpr_picture_event_fn on_event, void* event_user, hrbfnpr_operation* operation,
   * hrbfnpr_source_info* info, hrbfnpr_error* error)
   *
   * Looks at a source without drawing it: facts into info, findings as notes of on_event.  NOTE: what a picture
   * repairs;
   * WARNING: what is wrong, with advice; FAILURE: a code NOT_USABLE that says why it cannot be drawn, and the call
   * is
   * OK all the same.  One matter may be both repaired and wrong.  wording: HRBFNPR_WORDING_...; on_event and
   * operation
   * may be NULL.
   * Errors: INVALID_ARGUMENT (fields of the source), OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_source_inspect(context: Pointer, source: Pointer, wording: number, on_event: Pointer, event_user: Pointer, operation: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_create(hrbfnpr_context* context, const hrbfnpr_picture_desc* desc,
   * hrbfnpr_operation* operation, hrbfnpr_picture** out_picture, hrbfnpr_error* error)
   *
   * Fits, places marks and looks for lines; draws nothing yet.  operation may be NULL.
   * Needs the stack of hrbfnpr_model_fit.
   * Errors: INVALID_ARGUMENT (also for a source that cannot be drawn), SINGULAR_SYSTEM,
   * NOT_CONVERGED, OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_picture_create(context: Pointer, desc: Pointer, operation: Pointer, out_picture: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_restyle(const hrbfnpr_picture* picture, const hrbfnpr_picture_desc* desc,
   * hrbfnpr_operation* operation, hrbfnpr_picture** out_picture, hrbfnpr_error* error)
   *
   * The same surfaces in another style, size or view: desc has no sources.  Marks and lines
   * that fit are used again; else they are placed and looked for anew.
   */
  hrbfnpr_picture_restyle(picture: Pointer, desc: Pointer, operation: Pointer, out_picture: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_picture_retain(hrbfnpr_picture* picture)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_picture_retain(picture: Pointer): void;
  /**
   * void hrbfnpr_picture_release(hrbfnpr_picture* picture)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_picture_release(picture: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_picture_draw(hrbfnpr_picture* picture, const hrbfnpr_camera* camera, hrbfnpr_operation*
   * operation, hrbfnpr_drawing** out_drawing, hrbfnpr_error* error)
   *
   * Draws it.  camera NULL: as it was planned, and INVALID_ARGUMENT with a note BLANK if hardly
   * anything could be seen (ALLOW_BLANK lets it be).  Lines keep their numbers from one
   * drawing to the next.  operation may be NULL.
   */
  hrbfnpr_picture_draw(picture: Pointer, camera: Pointer, operation: Pointer, out_drawing: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_info_init(hrbfnpr_picture_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_picture_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_info(const hrbfnpr_picture* picture, hrbfnpr_picture_info* info,
   * hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_picture_get_info(picture: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_part_init(hrbfnpr_picture_part* part, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_picture_part_init(part: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_part(const hrbfnpr_picture* picture, int64_t number, hrbfnpr_picture_part*
   * part, hrbfnpr_error* error)
   *
   * number: 0 .. hrbfnpr_picture_info.parts - 1; the largest is 0.
   */
  hrbfnpr_picture_get_part(picture: Pointer, number: number, part: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_style(const hrbfnpr_picture* picture, const hrbfnpr_style** style,
   * hrbfnpr_error* error)
   *
   * What was chosen for hrbfnpr_renderer_draw, valid while the picture lives.
   */
  hrbfnpr_picture_get_style(picture: Pointer, style: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_marks(const hrbfnpr_picture* picture, const hrbfnpr_generate_desc** desc,
   * hrbfnpr_error* error)
   *
   * The descriptor that hrbfnpr_point_set_generate was given; *desc is NULL where the caller gave the marks.
   */
  hrbfnpr_picture_get_marks(picture: Pointer, desc: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_note(const hrbfnpr_picture* picture, int64_t number, hrbfnpr_note* note,
   * hrbfnpr_error* error)
   *
   * number: 0 .. hrbfnpr_picture_info.notes - 1.  The text is valid while the picture lives.
   */
  hrbfnpr_picture_get_note(picture: Pointer, number: number, note: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_stage(const hrbfnpr_picture* picture, int64_t number,
   * hrbfnpr_picture_event* stage, hrbfnpr_error* error)
   *
   * number: 0 .. hrbfnpr_picture_info.stages - 1: those that are over, as their last event.
   */
  hrbfnpr_picture_get_stage(picture: Pointer, number: number, stage: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_get_camera(const hrbfnpr_picture* picture, hrbfnpr_camera* camera,
   * hrbfnpr_error* error)
   *
   * The camera that was planned.
   */
  hrbfnpr_picture_get_camera(picture: Pointer, camera: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_look(const hrbfnpr_picture* picture, const double* direction, double azimuth,
   * double elevation, hrbfnpr_camera* camera, hrbfnpr_error* error)
   *
   * One from another side, with the size, the lens and the margin of the picture: along `direction`, or from
   * azimuth and
   * elevation in degrees, where direction is NULL; NaN = as planned.
   */
  hrbfnpr_picture_look(picture: Pointer, direction: Pointer, azimuth: number, elevation: number, camera: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_orbit(const hrbfnpr_picture* picture, double degrees, hrbfnpr_camera* camera,
   * hrbfnpr_error* error)
   *
   * The planned one, turned about the up axis through the middle of the model (or the target of an eye).
   */
  hrbfnpr_picture_orbit(picture: Pointer, degrees: number, camera: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_plate_size(const hrbfnpr_picture* picture, const hrbfnpr_camera* camera,
   * int32_t* width, int32_t* height, hrbfnpr_error* error)
   *
   * A plate is a drawing with the section and the scale bar that the picture has beside it; without these it is
   * the
   * drawing alone.  In this part `camera` is the one that the drawing was made by; NULL = the planned one.
   * *width and *height get the pixels of the plate.
   */
  hrbfnpr_picture_plate_size(picture: Pointer, camera: Pointer, width: Pointer, height: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_rasterize(const hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing, const
   * hrbfnpr_camera* camera, const hrbfnpr_image* image, hrbfnpr_error* error)
   *
   * The plate as an image of at least plate_size pixels, from its top-left corner; as hrbfnpr_drawing_rasterize.
   */
  hrbfnpr_picture_rasterize(picture: Pointer, drawing: Pointer, camera: Pointer, image: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_page_desc_init(hrbfnpr_picture_page_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_picture_page_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_write(hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing, const
   * hrbfnpr_camera* camera, const hrbfnpr_picture_page_desc* desc, hrbfnpr_write_fn write, void* user,
   * hrbfnpr_page_info* info, hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * The plate as vectors; as hrbfnpr_page_write.  desc, info and operation may be NULL.  Adds notes PENS and
   * PLOTTED.
   */
  hrbfnpr_picture_write(picture: Pointer, drawing: Pointer, camera: Pointer, desc: Pointer, write: Pointer, user: Pointer, info: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_settings_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
   * hrbfnpr_settings** out_settings, hrbfnpr_error* error)
   *
   * Reads what _write_settings or the viewer wrote (docs/settings.md).
   * Errors: IO, INVALID_ARGUMENT that names the key and what would be right, OUT_OF_MEMORY.
   */
  hrbfnpr_settings_load(context: Pointer, read: Pointer, user: Pointer, out_settings: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_settings_retain(const hrbfnpr_settings* settings)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_settings_retain(settings: Pointer): void;
  /**
   * void hrbfnpr_settings_release(const hrbfnpr_settings* settings)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_settings_release(settings: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_picture_write_settings(hrbfnpr_picture* picture, hrbfnpr_write_fn write, void* user,
   * hrbfnpr_error* error)
   *
   * Writes what a picture was made with.  What settings do not hold becomes a note NOT_IN_SETTINGS.
   */
  hrbfnpr_picture_write_settings(picture: Pointer, write: Pointer, user: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_views_desc_init(hrbfnpr_views_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_views_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_views_info_init(hrbfnpr_views_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_views_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_picture_write_views(hrbfnpr_picture* picture, const hrbfnpr_views_desc* desc,
   * hrbfnpr_write_fn write, void* user, hrbfnpr_views_info* info, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Draws the first part of a picture, which has a model, as a sheet of views; a picture made with SURFACE_ONLY is
   * enough.  desc, info and operation may be NULL.  The picture gets stages LINES and VIEWS, and notes
   * UNIT_IS_METRE,
   * NO_SYMMETRY and SECTION_OPEN.
   * Errors: INVALID_ARGUMENT (a picture of a point set; a text that is not understood; a plane that misses the
   * model;
   * views that have no room on the paper at the scale: the message says which scale or paper has), and those of
   * hrbfnpr_line_set_create, hrbfnpr_renderer_draw and hrbfnpr_page_write.
   */
  hrbfnpr_picture_write_views(picture: Pointer, desc: Pointer, write: Pointer, user: Pointer, info: Pointer, operation: Pointer, error: Pointer): number;
}

export declare const FUNCTIONS: Readonly<Record<keyof Functions, string>>;
export declare const CALLBACKS: Readonly<Record<string, string>>;
