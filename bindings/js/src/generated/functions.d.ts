// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.

/** An address in the module's memory; 0 is NULL. */
export type Pointer = number;

/** The functions of the C interface, by their own names.  64-bit integers are numbers here. */
export interface Functions {
  /**
   * uint32_t hrbfnpr_version(void)
   *
   * The library's version as major * 10000 + minor * 100 + patch.
   */
  hrbfnpr_version(): number;
  /**
   * uint32_t hrbfnpr_abi_version(void)
   *
   * The library's ABI version; compare it with HRBFNPR_ABI_VERSION.
   */
  hrbfnpr_abi_version(): number;
  /**
   * const char* hrbfnpr_version_string(void)
   *
   * "major.minor.patch", static, UTF-8, never NULL.
   */
  hrbfnpr_version_string(): Pointer;
  /**
   * const char* hrbfnpr_status_name(hrbfnpr_status status)
   *
   * Name of a status, such as "INVALID_ARGUMENT"; "UNKNOWN" for a number that is
   * not in the list.  Static, never NULL.
   */
  hrbfnpr_status_name(status: number): Pointer;
  /**
   * hrbfnpr_status hrbfnpr_error_init(hrbfnpr_error* error, uint32_t struct_size)
   *
   * Sets struct_size, OK and an empty message.
   * INVALID_ARGUMENT if `error` is NULL, UNSUPPORTED_STRUCT if struct_size < 256.
   */
  hrbfnpr_error_init(error: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_build_info(char* destination, int64_t capacity, int64_t* needed)
   *
   * What this build is, as one JSON object: version, abi, compiler,
   * instruction_sets, thread_backends, dependencies.  Writes up to `capacity`
   * bytes with a terminating zero; `*needed` (nullable) gets the bytes needed.
   * BUFFER_TOO_SMALL writes nothing to `destination`.  destination may be NULL
   * when capacity is 0.
   */
  hrbfnpr_build_info(destination: Pointer, capacity: number, needed: Pointer): number;
  /**
   * const char* hrbfnpr_layout(const char* name)
   *
   * How this build lays out a struct, such as "hrbfnpr_fit_desc", as one JSON
   * object: name, size, align, and fields, a list of objects with name, type,
   * offset and size (bytes) in the header's order; of NULL a list of all structs.
   * A binding can compare its own structs with it before the first call.  Static,
   * UTF-8; NULL where there is no struct of that name.
   */
  hrbfnpr_layout(name: Pointer): Pointer;
  /**
   * hrbfnpr_status hrbfnpr_image_init(hrbfnpr_image* image, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_image_init(image: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_context_desc_init(hrbfnpr_context_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_context_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_context_create(const hrbfnpr_context_desc* desc, hrbfnpr_context** out_context,
   * hrbfnpr_error* error)
   *
   * `desc` may be NULL for all defaults.  The callbacks and their user pointers
   * must outlive the context and everything that was made from it.
   */
  hrbfnpr_context_create(desc: Pointer, out_context: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_context_retain(hrbfnpr_context* context)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_context_retain(context: Pointer): void;
  /**
   * void hrbfnpr_context_release(hrbfnpr_context* context)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_context_release(context: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_context_info_init(hrbfnpr_context_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_context_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_context_get_info(const hrbfnpr_context* context, hrbfnpr_context_info* info,
   * hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_context_get_info(context: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_operation_create(hrbfnpr_context* context, hrbfnpr_operation** out_operation,
   * hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_operation_create(context: Pointer, out_operation: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_operation_retain(hrbfnpr_operation* operation)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_operation_retain(operation: Pointer): void;
  /**
   * void hrbfnpr_operation_release(hrbfnpr_operation* operation)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_operation_release(operation: Pointer): void;
  /**
   * void hrbfnpr_operation_cancel(hrbfnpr_operation* operation)
   *
   * Any thread, any time, more than once; NULL is ignored.
   */
  hrbfnpr_operation_cancel(operation: Pointer): void;
  /**
   * int32_t hrbfnpr_operation_is_cancelled(const hrbfnpr_operation* operation)
   *
   * 1 after a cancel, else 0.  Any thread.
   */
  hrbfnpr_operation_is_cancelled(operation: Pointer): number;
  /**
   * double hrbfnpr_operation_progress(const hrbfnpr_operation* operation)
   *
   * Progress of the call in [0,1].  Any thread.
   */
  hrbfnpr_operation_progress(operation: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_operation_set_callback(hrbfnpr_operation* operation, hrbfnpr_progress_fn callback,
   * void* user, hrbfnpr_error* error)
   *
   * Not while a call that uses the operation runs.  `callback` NULL removes it.
   */
  hrbfnpr_operation_set_callback(operation: Pointer, callback: Pointer, user: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_fit_desc_init(hrbfnpr_fit_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_fit_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_fit(hrbfnpr_context* context, const hrbfnpr_fit_desc* desc, hrbfnpr_operation*
   * operation, hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * Fits f with f(x_i) = 0 and grad f(x_i) = n_i, so that f < 0 inside, f > 0
   * outside and |grad f| is near 1 at the surface [NPAR 4.1, equations 1, 2].
   * operation may be NULL.
   * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY (the message gives the bytes),
   * SINGULAR_SYSTEM, NOT_CONVERGED (the message gives the residual reached),
   * CANCELLED.
   */
  hrbfnpr_model_fit(context: Pointer, desc: Pointer, operation: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_orient_desc_init(hrbfnpr_orient_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_orient_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_orient_info_init(hrbfnpr_orient_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_orient_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_orient(hrbfnpr_context* context, const hrbfnpr_orient_desc* desc, hrbfnpr_operation*
   * operation, const hrbfnpr_array_out* out_normals, hrbfnpr_orient_info* info, hrbfnpr_error* error)
   *
   * Finds the outward unit normals of points, or repairs given ones.
   * out_normals: N x 3, FLOAT32 or FLOAT64; may be the given normals themselves.
   *   Given normals that stay are written as they were, bit for bit where the
   *   scalars are the same; turned ones are only that.
   * info:        may be NULL.  operation: may be NULL.
   * A confidence that is low is no error: the log warns.
   * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, CANCELLED.
   */
  hrbfnpr_orient(context: Pointer, desc: Pointer, operation: Pointer, out_normals: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_depth_image_desc_init(hrbfnpr_depth_image_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_depth_image_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_depth_image_info_init(hrbfnpr_depth_image_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_depth_image_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_smooth_depth_image(hrbfnpr_context* context, const hrbfnpr_depth_image_desc* desc,
   * hrbfnpr_operation* operation, const hrbfnpr_array_out* out_points, const hrbfnpr_array_out* out_normals,
   * hrbfnpr_depth_image_info* info, hrbfnpr_error* error)
   *
   * Takes the sensor's noise off the image of a depth camera, and finds normals.
   * out_points:  rows * columns x 3, FLOAT32 or FLOAT64; may be desc.points' memory, or NULL.  NaN where
   *   nothing was seen, and for points that are left out.
   * out_normals: of the same size, towards the camera, of unit length; 0 where out_points is NaN.  May be NULL.
   * info:        may be NULL.  operation: may be NULL.
   * To choose some of the points, as even in the image as they can be, pass x / z,
   * y / z and log |z| to hrbfnpr_farthest_points.
   * Errors: INVALID_ARGUMENT (the points are no such image), OUT_OF_MEMORY, CANCELLED.
   */
  hrbfnpr_smooth_depth_image(context: Pointer, desc: Pointer, operation: Pointer, out_points: Pointer, out_normals: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_custom_desc_init(hrbfnpr_custom_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_custom_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_create_custom(hrbfnpr_context* context, const hrbfnpr_custom_desc* desc,
   * hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_model_create_custom(context: Pointer, desc: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_model_retain(const hrbfnpr_model* model)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_model_retain(model: Pointer): void;
  /**
   * void hrbfnpr_model_release(const hrbfnpr_model* model)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_model_release(model: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_model_info_init(hrbfnpr_model_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_model_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_get_info(const hrbfnpr_model* model, hrbfnpr_model_info* info, hrbfnpr_error*
   * error)
   *
   *
   */
  hrbfnpr_model_get_info(model: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_view(const hrbfnpr_model* model, uint32_t attribute, hrbfnpr_array* out_view,
   * hrbfnpr_error* error)
   *
   * A zero-copy view of the merged samples or of the last fit's residuals, valid while the model lives.
   * Empty for a custom model.
   */
  hrbfnpr_model_view(model: Pointer, attribute: number, out_view: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_evaluate(const hrbfnpr_model* model, const hrbfnpr_array* points, const
   * hrbfnpr_array_out* value, const hrbfnpr_array_out* gradient, const hrbfnpr_array_out* hessian,
   * hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * f, grad f and the Hessian at n points.
   * points:   n x 3, FLOAT32 or FLOAT64, finite, and within 1e50 diagonals of the
   *           model's bounds, here and in _project and _curvature.
   * value:    n x 1, gradient: n x 3, hessian: n x 6 (xx xy xz yy yz zz), each
   *           FLOAT32 or FLOAT64, or NULL.  At a sample the Hessian leaves out
   *           that sample's own (direction-dependent, zero-mean) term.
   * A finite answer that does not fit into a FLOAT32 array, of whatever call, is
   * INVALID_ARGUMENT.  What a custom function itself gives (NaN, say) is passed on.
   *
   * Preparing.  Where there are so many points that it pays, the first such call
   * of a model takes longer, to sum up what is far into polynomials, which the
   * model keeps (docs/accuracy.md: when, how long, how much memory; the log says
   * how much, and what values and gradients are off by, which is measured); after
   * that a point hardly costs more with more centres.  f is then within 1e-9
   * diagonals of the sum over all centres, its gradient within 1e-7; of rough,
   * uneven samples within 200 times that, 5000 where rounding leaves no more, or
   * all centres are summed.  What a call
   * gives depends on its n, in the last bits on whether Hessians are asked for,
   * never on calls before it.  _project, _curvature and
   * hrbfnpr_point_set_generate do the same.
   */
  hrbfnpr_model_evaluate(model: Pointer, points: Pointer, value: Pointer, gradient: Pointer, hessian: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_project_desc_init(hrbfnpr_project_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_project_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_projection_init(hrbfnpr_projection* projection, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_projection_init(projection: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_project(const hrbfnpr_model* model, const hrbfnpr_array* points, const
   * hrbfnpr_project_desc* desc, hrbfnpr_projection* projection, hrbfnpr_operation* operation, hrbfnpr_error*
   * error)
   *
   * Projects n points on the surface by steepest descent on f^2 with Armijo's
   * rule, first step f^2's Newton step along the gradient [NPAR 4.2].
   * points: n x 3, FLOAT32 or FLOAT64.  desc may be NULL.
   * Of models with creases, and where a bound on |grad f| is known, a point that
   * descent leaves off the surface is searched a surface for around it, in the
   * search box, with up to 2000 more evaluations.
   * A point that fails keeps its last iterate.
   */
  hrbfnpr_model_project(model: Pointer, points: Pointer, desc: Pointer, projection: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_curvature_init(hrbfnpr_curvature* curvature, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_curvature_init(curvature: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_curvature(const hrbfnpr_model* model, const hrbfnpr_array* points,
   * hrbfnpr_curvature* curvature, hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * Principal curvatures and directions of the level set through each of n
   * points [NPAR 5.3; Kindlmann et al. 2003]: the tangent eigenpairs of
   * G = -P H P / |grad f|, P = I - n n^T.  k1 >= k2; a surface that bends away
   * from its normal (a sphere with outward normals) has negative curvature,
   * -1/radius.  The confidence is 0 at umbilics and on planes, where d1 and d2
   * fall back to a smooth field.  Where the gradient vanishes all are 0.
   */
  hrbfnpr_model_curvature(model: Pointer, points: Pointer, curvature: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_cast_desc_init(hrbfnpr_cast_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_cast_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_ray_hits_init(hrbfnpr_ray_hits* hits, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_ray_hits_init(hits: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_cast_rays(const hrbfnpr_model* model, const hrbfnpr_array* origins, const
   * hrbfnpr_array* directions, const hrbfnpr_cast_desc* desc, hrbfnpr_ray_hits* hits, hrbfnpr_operation*
   * operation, hrbfnpr_error* error)
   *
   * Where n rays origin + t direction, t_min <= t <= t_max, meet the surface, by
   * steps that it cannot lie within [Hart 1996, "Sphere tracing"].
   *
   * The surface is looked for in the search box: the bounds, grown by 0.05
   * diagonals on every side.  From a place where f is known the next is |f| /
   * lipschitz away, but not less than smallest_step.  A change of sign between
   * two places brackets a hit, which Newton's method along the ray, safeguarded
   * by bisection, finds to the tolerance.  What changes no sign from one place to
   * the next is missed: grazing rays that are inside, and sheets that are thick,
   * for less than smallest_step.  So are hits that follow each other that
   * closely, in pairs.  A hit at the very ends of the range may or may not be
   * found.  A bound that is too small may miss more; a step that shows it to be
   * is taken back, and the bound raised for that ray.  One that is too large
   * costs time only.
   *
   * origins, directions: n x 3, FLOAT32 or FLOAT64, finite; directions of any
   *            length but zero, and not so short that the t of a hit is infinite.
   *            Rays may start inside.
   * desc may be NULL.  A ray that starts on the surface may or may not meet it
   * there: begin behind it, with t_min.  NaN, infinity, a direction of zero,
   * numbers of directions and origins that differ, and fields out of their range
   * are INVALID_ARGUMENT.
   */
  hrbfnpr_model_cast_rays(model: Pointer, origins: Pointer, directions: Pointer, desc: Pointer, hits: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_lipschitz(const hrbfnpr_model* model, double* lipschitz, hrbfnpr_operation*
   * operation, hrbfnpr_error* error)
   *
   * The bound that _cast_rays takes where none is given: the largest |grad f| at
   * 24^3 points of the search box, times 1.5.  An estimate, and no proof; of a tree
   * of primitives (hrbfnpr_csg_info.lipschitz) a bound that holds.  A
   * program that casts few rays at a time asks for it once and passes it on:
   * otherwise each call evaluates those points.
   */
  hrbfnpr_model_lipschitz(model: Pointer, lipschitz: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_contains(const hrbfnpr_model* model, const hrbfnpr_array* points, const
   * hrbfnpr_array_out* inside, int64_t* inside_count, hrbfnpr_operation* operation, hrbfnpr_error* error)
   *
   * Which of n points lie inside the surface.
   * points: n x 3, FLOAT32 or FLOAT64, finite.
   * inside: n x 1, UINT8, or NULL: 1 where f < 0 and the point lies in the search
   *         box (the bounds, grown by 0.05 diagonals on every side), else 0.
   *         Beyond it, where f means nothing, it is not evaluated.
   * inside_count (nullable) gets the number of ones.
   * Of a surface with a border, which bounds nothing, it is the side that f says.
   */
  hrbfnpr_model_contains(model: Pointer, points: Pointer, inside: Pointer, inside_count: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_trim_desc_init(hrbfnpr_trim_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_trim_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_trim(const hrbfnpr_model* model, const hrbfnpr_trim_desc* desc,
   * hrbfnpr_operation* operation, hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * The same model with a surface that ends where its samples do: marks, line sets
   * and rays of the new model do.  f, projections, curvatures and _contains are
   * those of `model`, which it keeps.  Trimming a trimmed model begins with the
   * whole one again.  A surface of which nothing is to be left out stays whole, and
   * what is made from it is bit for bit that of `model`.
   * desc NULL = defaults.  operation may be NULL.
   * Files of models hold where they end.
   * Errors: INVALID_ARGUMENT (a custom model without points), NOT_CONVERGED (no
   * part of the surface is near the samples; one sample has no spacing),
   * OUT_OF_MEMORY, CANCELLED, CALLBACK.
   */
  hrbfnpr_model_trim(model: Pointer, desc: Pointer, operation: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_trim_info_init(hrbfnpr_trim_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_trim_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_get_trim_info(const hrbfnpr_model* model, hrbfnpr_trim_info* info, hrbfnpr_error*
   * error)
   *
   *
   */
  hrbfnpr_model_get_trim_info(model: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_csg_node_init(hrbfnpr_csg_node* node, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_csg_node_init(node: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_csg_desc_init(hrbfnpr_csg_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_csg_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_create_csg(hrbfnpr_context* context, const hrbfnpr_csg_desc* desc,
   * hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * Every operator works on the result; derivatives are those of what f is there.
   * It can be saved if its leaves can.  It keeps them, and is for as many threads at
   * a time as all of them are.
   * Errors: INVALID_ARGUMENT (also: the surface has no end, or there is none: give
   * bounds), UNSUPPORTED_STRUCT, OUT_OF_MEMORY.
   */
  hrbfnpr_model_create_csg(context: Pointer, desc: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_csg_info_init(hrbfnpr_csg_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_csg_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_model_get_csg_info(const hrbfnpr_model* model, hrbfnpr_csg_info* info, hrbfnpr_error*
   * error)
   *
   *
   */
  hrbfnpr_model_get_csg_info(model: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_save(const hrbfnpr_model* model, hrbfnpr_write_fn write, void* user,
   * hrbfnpr_error* error)
   *
   * Saving and loading.  The stream is little-endian, versioned and checksummed;
   * a loaded model evaluates to the same bits.  A custom model cannot be saved, nor
   * a tree with one in it (INVALID_ARGUMENT).  _save_memory: `*size` gets the bytes needed; a capacity
   * that is too small is BUFFER_TOO_SMALL and writes nothing else.
   */
  hrbfnpr_model_save(model: Pointer, write: Pointer, user: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_save_memory(const hrbfnpr_model* model, void* destination, int64_t capacity,
   * int64_t* size, hrbfnpr_error* error)
   *
   * See hrbfnpr_model_save.
   */
  hrbfnpr_model_save_memory(model: Pointer, destination: Pointer, capacity: number, size: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user, hrbfnpr_model**
   * out_model, hrbfnpr_error* error)
   *
   * See hrbfnpr_model_save.
   */
  hrbfnpr_model_load(context: Pointer, read: Pointer, user: Pointer, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_model_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
   * hrbfnpr_model** out_model, hrbfnpr_error* error)
   *
   * See hrbfnpr_model_save.
   */
  hrbfnpr_model_load_memory(context: Pointer, data: Pointer, size: number, out_model: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_layer_desc_init(hrbfnpr_layer_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_layer_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_generate_desc_init(hrbfnpr_generate_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_generate_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_generate(hrbfnpr_context* context, const hrbfnpr_model* model, const
   * hrbfnpr_generate_desc* desc, hrbfnpr_operation* operation, hrbfnpr_point_set** out_point_set, hrbfnpr_error*
   * error)
   *
   * Places marks on the surface.  desc may be NULL, operation may be NULL.
   * Marks whose projection fails or strays are dropped and counted
   * (hrbfnpr_placement_info); a set whose seeds are all dropped is an error
   * (NOT_CONVERGED), and so is one whose marks are, or that no stroke of a given
   * separation or step fits into.
   *
   * Sizes.  Marks are float: the diagonal of the model's bounds must be 1e-33 ..
   * 1e33, in whatever unit.  Beyond 1e-9 .. 1e9 the marks of a model that is
   * scaled by a power of two are the same ones, scaled; a curvature that does not
   * fit a float is the largest that does.  Custom bounds may be up to 500 times
   * as wide as the surface, seed_points within 1e4 diagonals of the bounds.
   * Everything else is INVALID_ARGUMENT, and so is a budget that is too large,
   * before any mark is placed.
   * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, NOT_CONVERGED, CANCELLED, CALLBACK.
   */
  hrbfnpr_point_set_generate(context: Pointer, model: Pointer, desc: Pointer, operation: Pointer, out_point_set: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_layer_arrays_init(hrbfnpr_layer_arrays* arrays, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_layer_arrays_init(arrays: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_desc_init(hrbfnpr_point_set_desc* desc, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_point_set_desc_init(desc: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_create(hrbfnpr_context* context, const hrbfnpr_point_set_desc* desc,
   * hrbfnpr_point_set** out_point_set, hrbfnpr_error* error)
   *
   * A set of the caller's marks, or of another set's layers and the caller's.
   * They are 1e-33 .. 1e33 across, or at one place.  A set with a base keeps its
   * origin, distribution and area: the spacing is smaller only where a new layer
   * has more marks than all before.
   * Errors: INVALID_ARGUMENT naming the layer, the array and the index,
   * OUT_OF_MEMORY.
   */
  hrbfnpr_point_set_create(context: Pointer, desc: Pointer, out_point_set: Pointer, error: Pointer): number;
  /**
   * void hrbfnpr_point_set_retain(const hrbfnpr_point_set* set)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_point_set_retain(set: Pointer): void;
  /**
   * void hrbfnpr_point_set_release(const hrbfnpr_point_set* set)
   *
   * any thread; NULL is ignored
   */
  hrbfnpr_point_set_release(set: Pointer): void;
  /**
   * hrbfnpr_status hrbfnpr_point_set_info_init(hrbfnpr_point_set_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_point_set_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_info(const hrbfnpr_point_set* set, hrbfnpr_point_set_info* info,
   * hrbfnpr_error* error)
   *
   *
   */
  hrbfnpr_point_set_get_info(set: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_layer_info_init(hrbfnpr_layer_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_layer_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_layer_info(const hrbfnpr_point_set* set, int64_t layer,
   * hrbfnpr_layer_info* info, hrbfnpr_error* error)
   *
   * layer: 0 .. hrbfnpr_point_set_info.layers - 1.
   */
  hrbfnpr_point_set_get_layer_info(set: Pointer, layer: number, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_placement_info_init(hrbfnpr_placement_info* info, uint32_t struct_size)
   *
   *
   */
  hrbfnpr_placement_info_init(info: Pointer, struct_size: number): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_seed_placement(const hrbfnpr_point_set* set, hrbfnpr_placement_info*
   * info, hrbfnpr_error* error)
   *
   * Of the seeds.
   */
  hrbfnpr_point_set_get_seed_placement(set: Pointer, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_get_placement(const hrbfnpr_point_set* set, int64_t layer, int32_t level,
   * hrbfnpr_placement_info* info, hrbfnpr_error* error)
   *
   * Of one level of one layer; level: 0 .. hrbfnpr_layer_info.levels.
   */
  hrbfnpr_point_set_get_placement(set: Pointer, layer: number, level: number, info: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_view(const hrbfnpr_point_set* set, int64_t layer, uint32_t attribute,
   * hrbfnpr_array* out_view, hrbfnpr_error* error)
   *
   * A zero-copy view of one attribute (HRBFNPR_MARK_ATTRIBUTE_...) of one layer,
   * valid while the set lives.  An empty layer, or an attribute that it has not,
   * gives count 0.
   */
  hrbfnpr_point_set_view(set: Pointer, layer: number, attribute: number, out_view: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_step_patches(hrbfnpr_context* context, const hrbfnpr_model* model, const
   * hrbfnpr_generate_desc* desc, const hrbfnpr_array_out* corners, double* step, hrbfnpr_operation* operation,
   * hrbfnpr_error* error)
   *
   * The visual feedback for choosing the initial step [NPAR 5.1, Figure 5]:
   * `patch_count` squares of side 2 * initial_step in tangent planes of randomly
   * chosen seeds.  corners: patch_count x 12 (four corners, counter-clockwise
   * seen from outside), FLOAT32 or FLOAT64, absolute.  The seeds and, if
   * desc->initial_step is 0, the estimate are those that _generate with the same
   * desc would use; *step (nullable) gets the step.  desc may be NULL.
   */
  hrbfnpr_point_set_step_patches(context: Pointer, model: Pointer, desc: Pointer, corners: Pointer, step: Pointer, operation: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_save(const hrbfnpr_point_set* set, hrbfnpr_write_fn write, void* user,
   * hrbfnpr_error* error)
   *
   * As for models.
   */
  hrbfnpr_point_set_save(set: Pointer, write: Pointer, user: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_save_memory(const hrbfnpr_point_set* set, void* destination, int64_t
   * capacity, int64_t* size, hrbfnpr_error* error)
   *
   * See hrbfnpr_point_set_save.
   */
  hrbfnpr_point_set_save_memory(set: Pointer, destination: Pointer, capacity: number, size: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
   * hrbfnpr_point_set** out_point_set, hrbfnpr_error* error)
   *
   * See hrbfnpr_point_set_save.
   */
  hrbfnpr_point_set_load(context: Pointer, read: Pointer, user: Pointer, out_point_set: Pointer, error: Pointer): number;
  /**
   * hrbfnpr_status hrbfnpr_point_set_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
   * hrbfnpr_point_set** out_point_set, hrbfnpr_error* error)
   *
   * See hrbfnpr_point_set_save.
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
