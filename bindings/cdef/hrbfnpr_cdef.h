/* SPDX-License-Identifier: MIT */
/* Made by bindings/cdef/make_cdef.py from include/hrbfnpr.h; do not edit. */
enum { HRBFNPR_VERSION_MAJOR = 0, HRBFNPR_VERSION_MINOR = 1, HRBFNPR_VERSION_PATCH = 0, HRBFNPR_ABI_VERSION = 1 };
uint32_t hrbfnpr_version(void); uint32_t hrbfnpr_abi_version(void); const char* hrbfnpr_version_string(void);
typedef int32_t hrbfnpr_status; enum { HRBFNPR_STATUS_OK = 0, HRBFNPR_STATUS_INVALID_ARGUMENT = -1,
    HRBFNPR_STATUS_OUT_OF_MEMORY = -2, HRBFNPR_STATUS_BUFFER_TOO_SMALL = -3, HRBFNPR_STATUS_UNSUPPORTED_STRUCT = -4,
    HRBFNPR_STATUS_SINGULAR_SYSTEM = -5, HRBFNPR_STATUS_NOT_CONVERGED = -6, HRBFNPR_STATUS_CANCELLED = -7,
    HRBFNPR_STATUS_IO = -8, HRBFNPR_STATUS_CORRUPT_DATA = -9, HRBFNPR_STATUS_VERSION_MISMATCH = -10,
    HRBFNPR_STATUS_CALLBACK = -11, HRBFNPR_STATUS_INTERNAL = -99 };
const char* hrbfnpr_status_name(hrbfnpr_status status);
typedef struct hrbfnpr_error { uint32_t struct_size; hrbfnpr_status status; char message[248]; } hrbfnpr_error;
hrbfnpr_status hrbfnpr_error_init(hrbfnpr_error* error, uint32_t struct_size);
hrbfnpr_status hrbfnpr_build_info(char* destination, int64_t capacity, int64_t* needed);
const char* hrbfnpr_layout(const char* name); enum { HRBFNPR_SCALAR_FLOAT32 = 1, HRBFNPR_SCALAR_FLOAT64 = 2,
    HRBFNPR_SCALAR_UINT8 = 3, HRBFNPR_SCALAR_UINT32 = 4, HRBFNPR_SCALAR_INT32 = 5, HRBFNPR_SCALAR_INT64 = 6 };
typedef struct hrbfnpr_array { const void* data; int64_t count; int64_t stride; uint32_t scalar; uint32_t components;
    } hrbfnpr_array; typedef struct hrbfnpr_array_out { void* data; int64_t count; int64_t stride; uint32_t scalar;
    uint32_t components; } hrbfnpr_array_out; enum { HRBFNPR_FORMAT_RGBA8 = 1, HRBFNPR_FORMAT_BGRA8 = 2,
    HRBFNPR_FORMAT_RGBA8_PREMULTIPLIED = 3, HRBFNPR_FORMAT_BGRA8_PREMULTIPLIED = 4, HRBFNPR_FORMAT_RGBA32F = 5,
    HRBFNPR_FORMAT_RGBA32F_PREMULTIPLIED = 6, HRBFNPR_FORMAT_COVERAGE8 = 7 };
typedef struct hrbfnpr_image { uint32_t struct_size; uint32_t format; int32_t width; int32_t height; void* pixels;
    int64_t row_stride; } hrbfnpr_image; hrbfnpr_status hrbfnpr_image_init(hrbfnpr_image* image, uint32_t struct_size);
typedef struct hrbfnpr_context hrbfnpr_context;
typedef void* (*hrbfnpr_allocate_fn)(void* user, uint64_t size, uint64_t alignment);
typedef void (*hrbfnpr_deallocate_fn)(void* user, void* memory, uint64_t size, uint64_t alignment);
enum { HRBFNPR_LOG_DEBUG = 0, HRBFNPR_LOG_INFO = 1, HRBFNPR_LOG_WARNING = 2 };
typedef void (*hrbfnpr_log_fn)(void* user, int32_t level, const char* message);
typedef void (*hrbfnpr_task_fn)(void* task_context, int64_t index);
typedef void (*hrbfnpr_run_tasks_fn)(void* user, hrbfnpr_task_fn task, void* task_context, int64_t task_count);
enum { HRBFNPR_INSTRUCTION_SET_AUTO = 0, HRBFNPR_INSTRUCTION_SET_BASELINE = 1, HRBFNPR_INSTRUCTION_SET_AVX2 = 2,
    HRBFNPR_INSTRUCTION_SET_AVX512 = 3, HRBFNPR_INSTRUCTION_SET_NEON = 4 };
enum { HRBFNPR_THREAD_BACKEND_AUTO = 0, HRBFNPR_THREAD_BACKEND_POOL = 1, HRBFNPR_THREAD_BACKEND_OPENMP = 2,
    HRBFNPR_THREAD_BACKEND_RUN_TASKS = 3, HRBFNPR_THREAD_BACKEND_SERIAL = 4 };
typedef struct hrbfnpr_context_desc { uint32_t struct_size; uint32_t abi_version; int32_t thread_count; uint32_t flags;
    uint32_t thread_backend; uint32_t highest_instruction_set; hrbfnpr_allocate_fn allocate;
    hrbfnpr_deallocate_fn deallocate; void* allocator_user; hrbfnpr_log_fn log; void* log_user; int32_t log_level;
    uint32_t reserved; hrbfnpr_run_tasks_fn run_tasks; void* run_tasks_user; } hrbfnpr_context_desc;
hrbfnpr_status hrbfnpr_context_desc_init(hrbfnpr_context_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_context_create(const hrbfnpr_context_desc* desc, hrbfnpr_context** out_context,
    hrbfnpr_error* error); void hrbfnpr_context_retain(hrbfnpr_context* context);
void hrbfnpr_context_release(hrbfnpr_context* context);
typedef struct hrbfnpr_context_info { uint32_t struct_size; int32_t thread_count; uint32_t instruction_set;
    uint32_t thread_backend; int64_t bytes_now; int64_t bytes_peak; } hrbfnpr_context_info;
hrbfnpr_status hrbfnpr_context_info_init(hrbfnpr_context_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_context_get_info(const hrbfnpr_context* context, hrbfnpr_context_info* info,
    hrbfnpr_error* error); typedef struct hrbfnpr_operation hrbfnpr_operation;
typedef int32_t (*hrbfnpr_progress_fn)(void* user, double progress);
hrbfnpr_status hrbfnpr_operation_create(hrbfnpr_context* context, hrbfnpr_operation** out_operation,
    hrbfnpr_error* error); void hrbfnpr_operation_retain(hrbfnpr_operation* operation);
void hrbfnpr_operation_release(hrbfnpr_operation* operation);
void hrbfnpr_operation_cancel(hrbfnpr_operation* operation);
int32_t hrbfnpr_operation_is_cancelled(const hrbfnpr_operation* operation);
double hrbfnpr_operation_progress(const hrbfnpr_operation* operation);
hrbfnpr_status hrbfnpr_operation_set_callback(hrbfnpr_operation* operation, hrbfnpr_progress_fn callback, void* user,
    hrbfnpr_error* error); typedef int32_t (*hrbfnpr_write_fn)(void* user, const void* data, uint64_t size);
typedef int64_t (*hrbfnpr_read_fn)(void* user, void* data, uint64_t size); typedef struct hrbfnpr_model hrbfnpr_model;
enum { HRBFNPR_KERNEL_TRIHARMONIC = 0, HRBFNPR_KERNEL_GAUSSIAN = 1, HRBFNPR_KERNEL_WENDLAND_C2 = 2,
    HRBFNPR_KERNEL_CUSTOM = 3, HRBFNPR_KERNEL_CSG = 4 };
enum { HRBFNPR_SOLVER_AUTO = 0, HRBFNPR_SOLVER_DIRECT = 1, HRBFNPR_SOLVER_ITERATIVE = 2 };
enum { HRBFNPR_SOLVER_REASON_REQUESTED = 0, HRBFNPR_SOLVER_REASON_SMALL = 1, HRBFNPR_SOLVER_REASON_LARGE = 2,
    HRBFNPR_SOLVER_REASON_NOT_CONVERGED = 3, HRBFNPR_SOLVER_REASON_NOT_DEFINITE = 4 };
enum { HRBFNPR_REPAIR_KEEP = 0, HRBFNPR_REPAIR_DROP = 1, HRBFNPR_REPAIR_REORIENT = 2 };
enum { HRBFNPR_REGULARIZATION_GIVEN = 0, HRBFNPR_REGULARIZATION_AUTO = 1 };
enum { HRBFNPR_NORMALS_GIVEN = 0, HRBFNPR_NORMALS_NONE = 1, HRBFNPR_NORMALS_UNORIENTED = 2, HRBFNPR_NORMALS_MIXED = 3,
    HRBFNPR_NORMALS_INWARD = 4, HRBFNPR_NORMALS_AUTO = 5 }; enum { HRBFNPR_TRIM_NEVER = 0, HRBFNPR_TRIM_AUTO = 1 };
typedef struct hrbfnpr_fit_desc { uint32_t struct_size; uint32_t kernel; hrbfnpr_array points; hrbfnpr_array normals;
    double kernel_radius; int32_t polynomial_degree; uint32_t regularization_mode; double regularization;
    uint32_t outliers; uint32_t flipped_normals; double tolerance; int64_t maximum_centres; uint32_t solver;
    int32_t refinement_steps; double solver_tolerance; int32_t iteration_limit; uint32_t preconditioner_neighbours;
    uint32_t normal_mode; uint32_t trim; } hrbfnpr_fit_desc;
hrbfnpr_status hrbfnpr_fit_desc_init(hrbfnpr_fit_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_fit(hrbfnpr_context* context, const hrbfnpr_fit_desc* desc, hrbfnpr_operation* operation,
    hrbfnpr_model** out_model, hrbfnpr_error* error);
typedef struct hrbfnpr_orient_desc { uint32_t struct_size; uint32_t mode; hrbfnpr_array points; hrbfnpr_array normals;
    double up[3]; double viewpoint[3]; uint32_t has_viewpoint; uint32_t reserved; } hrbfnpr_orient_desc;
hrbfnpr_status hrbfnpr_orient_desc_init(hrbfnpr_orient_desc* desc, uint32_t struct_size); enum {
    HRBFNPR_OUTWARD_INSIDE = 0, HRBFNPR_OUTWARD_UP = 1, HRBFNPR_OUTWARD_VIEWPOINT = 2, HRBFNPR_OUTWARD_AS_GIVEN = 3 };
typedef struct hrbfnpr_orient_info { uint32_t struct_size; uint32_t found; int64_t turned; int64_t made; int64_t merged;
    double direction_change; double noise; double spacing; double energy; double confidence; uint32_t closed;
    uint32_t outward_by; int64_t components; double seconds; } hrbfnpr_orient_info;
hrbfnpr_status hrbfnpr_orient_info_init(hrbfnpr_orient_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_orient(hrbfnpr_context* context, const hrbfnpr_orient_desc* desc, hrbfnpr_operation* operation,
    const hrbfnpr_array_out* out_normals, hrbfnpr_orient_info* info, hrbfnpr_error* error);
typedef struct hrbfnpr_depth_image_desc { uint32_t struct_size; int32_t columns; int32_t rows; uint32_t keep_points;
    hrbfnpr_array points; double noise; double smoothing; } hrbfnpr_depth_image_desc;
hrbfnpr_status hrbfnpr_depth_image_desc_init(hrbfnpr_depth_image_desc* desc, uint32_t struct_size);
typedef struct hrbfnpr_depth_image_info { uint32_t struct_size; uint32_t reserved; int64_t seen; int64_t left_out;
    double noise; double focal_length; double depth; double radius; double seconds; } hrbfnpr_depth_image_info;
hrbfnpr_status hrbfnpr_depth_image_info_init(hrbfnpr_depth_image_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_smooth_depth_image(hrbfnpr_context* context, const hrbfnpr_depth_image_desc* desc,
    hrbfnpr_operation* operation, const hrbfnpr_array_out* out_points, const hrbfnpr_array_out* out_normals,
    hrbfnpr_depth_image_info* info, hrbfnpr_error* error); typedef int32_t (*hrbfnpr_implicit_fn)(void* user,
    int64_t count, const double* points, double* value, double* gradient, double* hessian);
enum { HRBFNPR_CUSTOM_HAS_GRADIENT = 1, HRBFNPR_CUSTOM_HAS_HESSIAN = 2, HRBFNPR_CUSTOM_THREAD_SAFE = 4 };
typedef struct hrbfnpr_custom_desc { uint32_t struct_size; uint32_t flags; hrbfnpr_implicit_fn function; void* user;
    void (*release)(void* user); double bounds_min[3]; double bounds_max[3]; double difference_step;
    } hrbfnpr_custom_desc; hrbfnpr_status hrbfnpr_custom_desc_init(hrbfnpr_custom_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_create_custom(hrbfnpr_context* context, const hrbfnpr_custom_desc* desc,
    hrbfnpr_model** out_model, hrbfnpr_error* error); void hrbfnpr_model_retain(const hrbfnpr_model* model);
void hrbfnpr_model_release(const hrbfnpr_model* model);
typedef struct hrbfnpr_model_info { uint32_t struct_size; uint32_t kernel; int32_t polynomial_degree;
    int32_t choice_rounds; int64_t samples; int64_t centres; int64_t merged_samples; int64_t near_duplicates;
    int64_t rescaled_normals; int64_t outliers_found; int64_t outliers_dropped; int64_t flipped_found;
    int64_t flipped_repaired; double bounds_min[3]; double bounds_max[3]; double spacing; double kernel_radius;
    double regularization; double noise_estimate; double value_residual_max; double value_residual_rms;
    double gradient_residual_max; double gradient_residual_rms; double input_distance_max; double input_distance_rms;
    double input_share_within; uint32_t solver; uint32_t solver_reason; int32_t iterations; uint32_t fallback;
    double solver_residual; double condition_estimate; double seconds_clean; double seconds_choose;
    double seconds_assemble; double seconds_precondition; double seconds_solve; double seconds_total; int64_t bytes;
    int64_t peak_bytes; uint32_t normals_found; uint32_t normals_inward; int64_t normals_turned;
    double normals_confidence; double seconds_orient; } hrbfnpr_model_info;
hrbfnpr_status hrbfnpr_model_info_init(hrbfnpr_model_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_get_info(const hrbfnpr_model* model, hrbfnpr_model_info* info, hrbfnpr_error* error);
enum { HRBFNPR_MODEL_ATTRIBUTE_POSITION = 0, HRBFNPR_MODEL_ATTRIBUTE_NORMAL = 1,
    HRBFNPR_MODEL_ATTRIBUTE_RESIDUAL_HISTORY = 2 }; hrbfnpr_status hrbfnpr_model_view(const hrbfnpr_model* model,
    uint32_t attribute, hrbfnpr_array* out_view, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_model_evaluate(const hrbfnpr_model* model, const hrbfnpr_array* points,
    const hrbfnpr_array_out* value, const hrbfnpr_array_out* gradient, const hrbfnpr_array_out* hessian,
    hrbfnpr_operation* operation, hrbfnpr_error* error); enum { HRBFNPR_PROJECTION_CONVERGED = 0,
    HRBFNPR_PROJECTION_NOT_CONVERGED = 1, HRBFNPR_PROJECTION_ZERO_GRADIENT = 2, HRBFNPR_PROJECTION_NOT_FINITE = 3 };
typedef struct hrbfnpr_project_desc { uint32_t struct_size; int32_t evaluation_limit; double tolerance;
    double armijo_slope; double armijo_factor; } hrbfnpr_project_desc;
hrbfnpr_status hrbfnpr_project_desc_init(hrbfnpr_project_desc* desc, uint32_t struct_size);
typedef struct hrbfnpr_projection { uint32_t struct_size; uint32_t reserved; hrbfnpr_array_out position;
    hrbfnpr_array_out normal; hrbfnpr_array_out status; int64_t converged; } hrbfnpr_projection;
hrbfnpr_status hrbfnpr_projection_init(hrbfnpr_projection* projection, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_project(const hrbfnpr_model* model, const hrbfnpr_array* points,
    const hrbfnpr_project_desc* desc, hrbfnpr_projection* projection, hrbfnpr_operation* operation,
    hrbfnpr_error* error);
typedef struct hrbfnpr_curvature { uint32_t struct_size; uint32_t reserved; hrbfnpr_array_out k1; hrbfnpr_array_out k2;
    hrbfnpr_array_out d1; hrbfnpr_array_out d2; hrbfnpr_array_out confidence; } hrbfnpr_curvature;
hrbfnpr_status hrbfnpr_curvature_init(hrbfnpr_curvature* curvature, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_curvature(const hrbfnpr_model* model, const hrbfnpr_array* points,
    hrbfnpr_curvature* curvature, hrbfnpr_operation* operation, hrbfnpr_error* error); enum { HRBFNPR_RAY_HIT = 0,
    HRBFNPR_RAY_MISS = 1, HRBFNPR_RAY_TRUNCATED = 2, HRBFNPR_RAY_EVALUATION_LIMIT = 3, HRBFNPR_RAY_NOT_FINITE = 4 };
typedef struct hrbfnpr_line_set hrbfnpr_line_set; typedef struct hrbfnpr_mesh hrbfnpr_mesh;
typedef struct hrbfnpr_cast_desc { uint32_t struct_size; int32_t maximum_hits; int32_t evaluation_limit;
    uint32_t reserved; double t_min; double t_max; double lipschitz; double smallest_step; double tolerance;
    const hrbfnpr_line_set* line_set; uint32_t refine; uint32_t reserved2; } hrbfnpr_cast_desc;
hrbfnpr_status hrbfnpr_cast_desc_init(hrbfnpr_cast_desc* desc, uint32_t struct_size);
typedef struct hrbfnpr_ray_hits { uint32_t struct_size; uint32_t reserved; hrbfnpr_array_out count; hrbfnpr_array_out t;
    hrbfnpr_array_out position; hrbfnpr_array_out normal; hrbfnpr_array_out entering; hrbfnpr_array_out status;
    int64_t hit_rays; } hrbfnpr_ray_hits;
hrbfnpr_status hrbfnpr_ray_hits_init(hrbfnpr_ray_hits* hits, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_cast_rays(const hrbfnpr_model* model, const hrbfnpr_array* origins,
    const hrbfnpr_array* directions, const hrbfnpr_cast_desc* desc, hrbfnpr_ray_hits* hits,
    hrbfnpr_operation* operation, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_model_lipschitz(const hrbfnpr_model* model, double* lipschitz, hrbfnpr_operation* operation,
    hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_model_contains(const hrbfnpr_model* model, const hrbfnpr_array* points,
    const hrbfnpr_array_out* inside, int64_t* inside_count, hrbfnpr_operation* operation, hrbfnpr_error* error);
typedef struct hrbfnpr_trim_desc { uint32_t struct_size; uint32_t reserved; double limit; double hole; double closest;
    hrbfnpr_array points; hrbfnpr_array normals; } hrbfnpr_trim_desc;
hrbfnpr_status hrbfnpr_trim_desc_init(hrbfnpr_trim_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_trim(const hrbfnpr_model* model, const hrbfnpr_trim_desc* desc,
    hrbfnpr_operation* operation, hrbfnpr_model** out_model, hrbfnpr_error* error);
typedef struct hrbfnpr_trim_info { uint32_t struct_size; uint32_t is_trimmed; int64_t samples; int64_t parts;
    int64_t parts_to_end; double share; double farthest; double spacing; } hrbfnpr_trim_info;
hrbfnpr_status hrbfnpr_trim_info_init(hrbfnpr_trim_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_get_trim_info(const hrbfnpr_model* model, hrbfnpr_trim_info* info, hrbfnpr_error* error);
enum { HRBFNPR_CSG_UNION = 0, HRBFNPR_CSG_INTERSECTION = 1, HRBFNPR_CSG_DIFFERENCE = 2, HRBFNPR_CSG_COMPLEMENT = 3,
    HRBFNPR_CSG_OFFSET = 4, HRBFNPR_CSG_SHELL = 5, HRBFNPR_CSG_MODEL = 6, HRBFNPR_CSG_HALF_SPACE = 7,
    HRBFNPR_CSG_BOX = 8, HRBFNPR_CSG_SPHERE = 9, HRBFNPR_CSG_CYLINDER = 10, HRBFNPR_CSG_CONE = 11,
    HRBFNPR_CSG_TORUS = 12 }; typedef struct hrbfnpr_csg_node { uint32_t struct_size; uint32_t kind; int64_t parent;
    const hrbfnpr_model* model; double transform[16]; double size[3]; double radius; double second_radius;
    double height; double distance; double blend; double exponent; } hrbfnpr_csg_node;
hrbfnpr_status hrbfnpr_csg_node_init(hrbfnpr_csg_node* node, uint32_t struct_size);
typedef struct hrbfnpr_csg_desc { uint32_t struct_size; uint32_t reserved; const hrbfnpr_csg_node* nodes;
    int64_t node_count; int64_t node_stride; double bounds_min[3]; double bounds_max[3]; } hrbfnpr_csg_desc;
hrbfnpr_status hrbfnpr_csg_desc_init(hrbfnpr_csg_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_create_csg(hrbfnpr_context* context, const hrbfnpr_csg_desc* desc,
    hrbfnpr_model** out_model, hrbfnpr_error* error);
typedef struct hrbfnpr_csg_info { uint32_t struct_size; uint32_t reserved; int64_t nodes; int64_t depth; int64_t models;
    int64_t sheets; double lipschitz; } hrbfnpr_csg_info;
hrbfnpr_status hrbfnpr_csg_info_init(hrbfnpr_csg_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_get_csg_info(const hrbfnpr_model* model, hrbfnpr_csg_info* info, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_model_save(const hrbfnpr_model* model, hrbfnpr_write_fn write, void* user, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_model_save_memory(const hrbfnpr_model* model, void* destination, int64_t capacity, int64_t* size,
    hrbfnpr_error* error); hrbfnpr_status hrbfnpr_model_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
    hrbfnpr_model** out_model, hrbfnpr_error* error); hrbfnpr_status hrbfnpr_model_load_memory(hrbfnpr_context* context,
    const void* data, int64_t size, hrbfnpr_model** out_model, hrbfnpr_error* error);
typedef struct hrbfnpr_point_set hrbfnpr_point_set; typedef struct hrbfnpr_field hrbfnpr_field;
enum { HRBFNPR_LAYER_KIND_ANY = 0, HRBFNPR_LAYER_KIND_STIPPLES = 1, HRBFNPR_LAYER_KIND_HATCH = 2,
    HRBFNPR_LAYER_KIND_OWN = 3 }; enum { HRBFNPR_DISTRIBUTION_BLUE_NOISE = 0, HRBFNPR_DISTRIBUTION_PUBLISHED = 1 };
enum { HRBFNPR_HATCH_GUIDE_CURVATURE = 0, HRBFNPR_HATCH_GUIDE_COMBING = 1, HRBFNPR_HATCH_GUIDE_SECTIONS = 2,
    HRBFNPR_HATCH_GUIDE_LIGHT = 3, HRBFNPR_HATCH_GUIDE_SILHOUETTE = 4 };
enum { HRBFNPR_SEED_AUTO = 0, HRBFNPR_SEED_SAMPLES = 1, HRBFNPR_SEED_BOX = 2, HRBFNPR_SEED_POINTS = 3 };
enum { HRBFNPR_STROKE_START_SEEDS = 0, HRBFNPR_STROKE_START_STIPPLES = 1 }; enum { HRBFNPR_DENSITY_UNIFORM = 0,
    HRBFNPR_DENSITY_CURVATURE = 1, HRBFNPR_DENSITY_CALLBACK = 2, HRBFNPR_DENSITY_FIELD = 3 };
typedef int32_t (*hrbfnpr_density_fn)(void* user, int64_t count, const double* positions, const double* normals,
    double* density); typedef int32_t (*hrbfnpr_direction_fn)(void* user, int64_t count, const double* positions,
    const double* normals, double* directions); enum { HRBFNPR_TONE_RANGES_FULL = 0, HRBFNPR_TONE_RANGES_IN_TURN = 1 };
enum { HRBFNPR_LAYER_WITH_CURVATURE = 1 }; typedef struct hrbfnpr_layer_desc { uint32_t struct_size; uint32_t kind;
    const char* name; int64_t budget; float tone_begin; float tone_end; float second_tone_begin; float second_tone_end;
    uint32_t flags; uint32_t density; double density_strength; hrbfnpr_density_fn density_function; void* density_user;
    hrbfnpr_direction_fn direction_function; void* direction_user; uint32_t guide; uint32_t start; int32_t start_level;
    int32_t levels; double separation; double step; double angle; double smoothing; double axis[3]; double axis_weight;
    double guide_direction[3]; double guide_weight; double tone_smoothing; const hrbfnpr_field* density_field;
    const hrbfnpr_field* direction_field; } hrbfnpr_layer_desc;
hrbfnpr_status hrbfnpr_layer_desc_init(hrbfnpr_layer_desc* desc, uint32_t struct_size);
typedef struct hrbfnpr_generate_desc { uint32_t struct_size; uint32_t distribution; const hrbfnpr_layer_desc* layers;
    int64_t layer_count; int64_t layer_stride; int64_t shared_budget; uint32_t tone_ranges; uint32_t seed_source;
    hrbfnpr_array seed_points; double box_jitter; uint32_t box_resolution; uint32_t reserved; double initial_step;
    double projection_tolerance; uint64_t random_seed; } hrbfnpr_generate_desc;
hrbfnpr_status hrbfnpr_generate_desc_init(hrbfnpr_generate_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_point_set_generate(hrbfnpr_context* context, const hrbfnpr_model* model,
    const hrbfnpr_generate_desc* desc, hrbfnpr_operation* operation, hrbfnpr_point_set** out_point_set,
    hrbfnpr_error* error);
enum { HRBFNPR_MARK_ATTRIBUTE_POSITION = 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL = 1, HRBFNPR_MARK_ATTRIBUTE_DIRECTION = 2,
    HRBFNPR_MARK_ATTRIBUTE_CURVATURE = 3, HRBFNPR_MARK_ATTRIBUTE_RANK = 4, HRBFNPR_MARK_ATTRIBUTE_LEVEL = 5,
    HRBFNPR_MARK_ATTRIBUTE_STROKE = 6, HRBFNPR_MARK_ATTRIBUTE_WIDTH = 7, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST = 8,
    HRBFNPR_MARK_ATTRIBUTE_STROKE_ORDER = 9, HRBFNPR_MARK_ATTRIBUTE_TONE_NORMAL = 10 };
typedef struct hrbfnpr_layer_arrays { uint32_t struct_size; uint32_t kind; const char* name; hrbfnpr_array position;
    hrbfnpr_array normal; hrbfnpr_array stroke_first; hrbfnpr_array stroke_direction; hrbfnpr_array direction;
    hrbfnpr_array curvature; hrbfnpr_array rank; hrbfnpr_array level; hrbfnpr_array width; } hrbfnpr_layer_arrays;
hrbfnpr_status hrbfnpr_layer_arrays_init(hrbfnpr_layer_arrays* arrays, uint32_t struct_size);
typedef struct hrbfnpr_point_set_desc { uint32_t struct_size; uint32_t reserved; const hrbfnpr_point_set* base;
    const hrbfnpr_layer_arrays* layers; int64_t layer_count; int64_t layer_stride; uint64_t random_seed;
    } hrbfnpr_point_set_desc;
hrbfnpr_status hrbfnpr_point_set_desc_init(hrbfnpr_point_set_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_point_set_create(hrbfnpr_context* context, const hrbfnpr_point_set_desc* desc,
    hrbfnpr_point_set** out_point_set, hrbfnpr_error* error);
void hrbfnpr_point_set_retain(const hrbfnpr_point_set* set);
void hrbfnpr_point_set_release(const hrbfnpr_point_set* set); typedef struct hrbfnpr_point_set_info {
    uint32_t struct_size; uint32_t distribution; uint32_t seed_source; uint32_t reserved; int64_t layers; int64_t marks;
    double origin[3]; double bounds_min[3]; double bounds_max[3]; double spacing; double seconds_seeds;
    double seconds_total; int64_t bytes; int64_t field_count; } hrbfnpr_point_set_info;
hrbfnpr_status hrbfnpr_point_set_info_init(hrbfnpr_point_set_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_point_set_get_info(const hrbfnpr_point_set* set, hrbfnpr_point_set_info* info,
    hrbfnpr_error* error);
typedef struct hrbfnpr_layer_info { uint32_t struct_size; uint32_t kind; char name[64]; int64_t marks; int64_t strokes;
    int64_t full_count; int32_t levels; uint32_t reserved; double step; double seconds; } hrbfnpr_layer_info;
hrbfnpr_status hrbfnpr_layer_info_init(hrbfnpr_layer_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_point_set_get_layer_info(const hrbfnpr_point_set* set, int64_t layer, hrbfnpr_layer_info* info,
    hrbfnpr_error* error); typedef struct hrbfnpr_placement_info { uint32_t struct_size; uint32_t reserved;
    int64_t attempted; int64_t placed; int64_t dropped_not_converged; int64_t dropped_strayed;
    int64_t dropped_degenerate; int64_t dropped_budget; } hrbfnpr_placement_info;
hrbfnpr_status hrbfnpr_placement_info_init(hrbfnpr_placement_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_point_set_get_seed_placement(const hrbfnpr_point_set* set, hrbfnpr_placement_info* info,
    hrbfnpr_error* error); hrbfnpr_status hrbfnpr_point_set_get_placement(const hrbfnpr_point_set* set, int64_t layer,
    int32_t level, hrbfnpr_placement_info* info, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_point_set_view(const hrbfnpr_point_set* set, int64_t layer, uint32_t attribute,
    hrbfnpr_array* out_view, hrbfnpr_error* error); typedef struct hrbfnpr_mark_field { uint32_t struct_size;
    uint32_t reserved; const char* name; const hrbfnpr_field* field; const double* transform; } hrbfnpr_mark_field;
hrbfnpr_status hrbfnpr_mark_field_init(hrbfnpr_mark_field* field, uint32_t struct_size);
hrbfnpr_status hrbfnpr_point_set_with_fields(hrbfnpr_context* context, const hrbfnpr_point_set* set,
    const hrbfnpr_mark_field* fields, int64_t field_count, int64_t field_stride, hrbfnpr_operation* operation,
    hrbfnpr_point_set** out_point_set, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_point_set_get_field(const hrbfnpr_point_set* set, int64_t number, const char** name,
    uint32_t* kind, hrbfnpr_error* error); hrbfnpr_status hrbfnpr_point_set_view_field(const hrbfnpr_point_set* set,
    int64_t layer, const char* name, hrbfnpr_array* values, hrbfnpr_array* weights, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_point_set_step_patches(hrbfnpr_context* context, const hrbfnpr_model* model,
    const hrbfnpr_generate_desc* desc, const hrbfnpr_array_out* corners, double* step, hrbfnpr_operation* operation,
    hrbfnpr_error* error); hrbfnpr_status hrbfnpr_point_set_save(const hrbfnpr_point_set* set, hrbfnpr_write_fn write,
    void* user, hrbfnpr_error* error); hrbfnpr_status hrbfnpr_point_set_save_memory(const hrbfnpr_point_set* set,
    void* destination, int64_t capacity, int64_t* size, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_point_set_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
    hrbfnpr_point_set** out_point_set, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_point_set_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
    hrbfnpr_point_set** out_point_set, hrbfnpr_error* error); enum { HRBFNPR_LINE_KIND_CONTOUR = 1,
    HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR = 2, HRBFNPR_LINE_KIND_RIDGE = 3, HRBFNPR_LINE_KIND_VALLEY = 4,
    HRBFNPR_LINE_KIND_APPARENT_RIDGE = 5, HRBFNPR_LINE_KIND_PARABOLIC = 6, HRBFNPR_LINE_KIND_ISOPHOTE = 7,
    HRBFNPR_LINE_KIND_SECTION = 8, HRBFNPR_LINE_KIND_BORDER = 9, HRBFNPR_LINE_KIND_OWN = 10,
    HRBFNPR_LINE_KIND_CREASE = 11, HRBFNPR_LINE_KIND_SHADOW = 12, HRBFNPR_LINE_KIND_TERMINATOR = 13,
    HRBFNPR_LINE_KIND_SOFT_EDGE = 14, HRBFNPR_LINE_KIND_INTERSECTION = 15, HRBFNPR_LINE_KIND_TANGENT_EDGE = 16 };
typedef struct hrbfnpr_line_desc { uint32_t struct_size; uint32_t kind; const char* name; double lower; double upper;
    double shortest; double plane[3]; hrbfnpr_array levels; hrbfnpr_array position; hrbfnpr_array line_first;
    } hrbfnpr_line_desc; hrbfnpr_status hrbfnpr_line_desc_init(hrbfnpr_line_desc* desc, uint32_t struct_size);
enum { HRBFNPR_LINE_SET_WITH_CURVATURE = 1 };
typedef struct hrbfnpr_line_set_desc { uint32_t struct_size; uint32_t flags; double cell_size;
    hrbfnpr_array seed_points; const hrbfnpr_line_desc* lines; int64_t line_count; int64_t line_stride; double support;
    hrbfnpr_array support_points; hrbfnpr_array support_normals; const hrbfnpr_mesh* mesh; } hrbfnpr_line_set_desc;
hrbfnpr_status hrbfnpr_line_set_desc_init(hrbfnpr_line_set_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_line_set_create(hrbfnpr_context* context, const hrbfnpr_model* model,
    const hrbfnpr_line_set_desc* desc, hrbfnpr_operation* operation, hrbfnpr_line_set** out_line_set,
    hrbfnpr_error* error); void hrbfnpr_line_set_retain(const hrbfnpr_line_set* line_set);
void hrbfnpr_line_set_release(const hrbfnpr_line_set* line_set);
typedef struct hrbfnpr_line_set_info { uint32_t struct_size; uint32_t reserved; int64_t triangles; int64_t turned;
    int64_t missed_seeds; int64_t lines; int64_t borders; double cell_size; double seconds; int64_t bytes;
    double left_out; int64_t creases; } hrbfnpr_line_set_info;
hrbfnpr_status hrbfnpr_line_set_info_init(hrbfnpr_line_set_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_line_set_get_info(const hrbfnpr_line_set* line_set, hrbfnpr_line_set_info* info,
    hrbfnpr_error* error);
enum { HRBFNPR_DEPTH_NEGATIVE_ONE_TO_ONE = 0, HRBFNPR_DEPTH_ZERO_TO_ONE = 1, HRBFNPR_DEPTH_REVERSED = 2 };
typedef struct hrbfnpr_camera { uint32_t struct_size; uint32_t depth_convention; double view[16]; double projection[16];
    double viewport[4]; } hrbfnpr_camera;
hrbfnpr_status hrbfnpr_camera_init(hrbfnpr_camera* camera, uint32_t struct_size);
hrbfnpr_status hrbfnpr_camera_look_at(hrbfnpr_camera* camera, const double* eye, const double* target, const double* up,
    hrbfnpr_error* error); hrbfnpr_status hrbfnpr_camera_perspective(hrbfnpr_camera* camera, double vertical_angle,
    double width, double height, double near_plane, double far_plane, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_camera_orthographic(hrbfnpr_camera* camera, double view_height, double width, double height,
    double near_plane, double far_plane, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_camera_fit_bounds(hrbfnpr_camera* camera, const double* bounds_min, const double* bounds_max,
    const double* direction, const double* up, double vertical_angle, double width, double height, double margin,
    hrbfnpr_error* error); hrbfnpr_status hrbfnpr_camera_fit_points(hrbfnpr_camera* camera, const hrbfnpr_array* points,
    const double* origin, const double* direction, const double* up, double vertical_angle, double width, double height,
    double margin, hrbfnpr_error* error);
enum { HRBFNPR_HIDDEN_LINES_ATTENUATE = 0, HRBFNPR_HIDDEN_LINES_HIDE = 1, HRBFNPR_HIDDEN_LINES_SHOW = 2 };
enum { HRBFNPR_VISIBILITY_DEPTH_LAYERS = 0, HRBFNPR_VISIBILITY_PUBLISHED = 1 };
enum { HRBFNPR_TONE_CURVE_COVERAGE = 0, HRBFNPR_TONE_CURVE_LINEAR = 1 };
enum { HRBFNPR_EVENNESS_PICTURE = 0, HRBFNPR_EVENNESS_SURFACE = 1 };
enum { HRBFNPR_TONE_NONE = 0, HRBFNPR_TONE_LIGHT = 1, HRBFNPR_TONE_CALLBACK = 2 };
enum { HRBFNPR_TONE_RULE_SHARE = 0, HRBFNPR_TONE_RULE_PUBLISHED = 1 };
enum { HRBFNPR_LIGHT_WORLD = 0, HRBFNPR_LIGHT_CAMERA = 1, HRBFNPR_LIGHT_ITEM = 2 };
enum { HRBFNPR_LIGHT_KIND_DIRECTIONAL = 0, HRBFNPR_LIGHT_KIND_PLACE = 1 };
typedef struct hrbfnpr_light { uint32_t struct_size; uint32_t kind; uint32_t space; float intensity; float shadow;
    float softness; double place[3]; } hrbfnpr_light;
hrbfnpr_status hrbfnpr_light_init(hrbfnpr_light* light, uint32_t struct_size);
typedef int32_t (*hrbfnpr_tone_fn)(void* user, int64_t count, const float* positions, const float* normals, float* tau);
enum { HRBFNPR_SHAPE_DOTS = 0, HRBFNPR_SHAPE_STROKES = 1, HRBFNPR_SHAPE_HATCH = 2 };
enum { HRBFNPR_FIELD_RULE_REPLACE = 0, HRBFNPR_FIELD_RULE_SCALE = 1 };
enum { HRBFNPR_PALETTE_NEAREST = 0, HRBFNPR_PALETTE_MIXED = 1 };
typedef struct hrbfnpr_layer_style { uint32_t struct_size; uint32_t kind; const char* name; uint32_t shown;
    uint32_t contours; uint32_t directions; uint32_t shape; float share; float radius; float radius_zoom;
    uint32_t reserved; float ink[4]; float hatch_tone_begin; float hatch_tone_end; float hatch_coverage_begin;
    float hatch_coverage_end; float hatch_spacing; float hatch_pen; float hatch_white; float hatch_taper;
    float hatch_shortest; uint32_t reserved2; float hatch_wobble; float hatch_overshoot; uint32_t hatch_seed;
    uint32_t reserved3; const char* density_field; const char* tone_field; const char* width_field;
    const char* ink_field; const char* mask_field; uint32_t tone_field_rule; uint32_t palette_rule; float hatch_fade;
    uint32_t reserved4; } hrbfnpr_layer_style;
hrbfnpr_status hrbfnpr_layer_style_init(hrbfnpr_layer_style* style, uint32_t struct_size);
enum { HRBFNPR_HIDDEN_PARTS_NONE = 0, HRBFNPR_HIDDEN_PARTS_ATTENUATED = 1, HRBFNPR_HIDDEN_PARTS_DASHED = 2,
    HRBFNPR_HIDDEN_PARTS_SHOWN = 3 }; enum { HRBFNPR_CAP_ROUND = 0, HRBFNPR_CAP_FLAT = 1, HRBFNPR_CAP_POINTED = 2 };
enum { HRBFNPR_CREASES_ALL = 0, HRBFNPR_CREASES_CONVEX = 1, HRBFNPR_CREASES_CONCAVE = 2 };
typedef struct hrbfnpr_line_style { uint32_t struct_size; uint32_t kind; const char* name; uint32_t hidden;
    uint32_t cap; float width; float taper; float hidden_width; float hidden_opacity; float dash; float gap;
    float shortest; float fade; double lower; double upper; hrbfnpr_array levels; float ink[4]; float outline_factor;
    float far_factor; float lit_factor; float curvature_factor; float curvature_radius; float wobble;
    float wobble_width; float wobble_length; uint32_t wobble_seed; uint32_t creases; } hrbfnpr_line_style;
hrbfnpr_status hrbfnpr_line_style_init(hrbfnpr_line_style* style, uint32_t struct_size);
typedef struct hrbfnpr_style { uint32_t struct_size; uint32_t tone; float paper[4]; const hrbfnpr_layer_style* layers;
    int64_t layer_count; int64_t layer_stride; uint32_t tone_rule; uint32_t tone_curve; double light[3];
    double tone_exponent; hrbfnpr_tone_fn tone_function; void* tone_user; uint32_t light_space; float tone_fade;
    double silhouette_threshold; float silhouette_radius; float silhouette_radius_zoom; float silhouette_ink[4];
    uint32_t visibility; uint32_t hidden_lines; double attenuation_front; double attenuation_back; float splat_radius;
    float splat_overlap; float halo_width; uint32_t verify_lines; double depth_min; double depth_max;
    double zoom_reference; double zoom_exponent; const hrbfnpr_line_style* lines; int64_t line_count;
    int64_t line_stride; float fill_light; uint32_t reserved2; float light_intensity; float light_shadow;
    float light_softness; uint32_t evenness; const hrbfnpr_light* lights; int64_t light_count; int64_t light_stride;
    double ambient_up[3]; float ambient_sky; float ambient_ground; float occlusion; float occlusion_exponent;
    float rim_light; float rim_exponent; float tone_black; float tone_white; float tone_gamma; uint32_t tone_steps;
    float curvature_contrast; float occlusion_lights; const float* palette; int64_t palette_count; } hrbfnpr_style;
hrbfnpr_status hrbfnpr_style_init(hrbfnpr_style* style, uint32_t struct_size);
enum { HRBFNPR_PRESET_STIPPLE = 0, HRBFNPR_PRESET_HATCH = 1, HRBFNPR_PRESET_CROSS_HATCH = 2, HRBFNPR_PRESET_COMBING = 3,
    HRBFNPR_PRESET_SILHOUETTE = 4, HRBFNPR_PRESET_CONTOUR_AND_STIPPLE = 5, HRBFNPR_PRESET_XRAY = 6,
    HRBFNPR_PRESET_FULL = 7, HRBFNPR_PRESET_ENGRAVING = 8, HRBFNPR_PRESET_ETCHING = 9, HRBFNPR_PRESET_WOODCUT = 10,
    HRBFNPR_PRESET_SCIENTIFIC_STIPPLE = 11, HRBFNPR_PRESET_SKETCH = 12, HRBFNPR_PRESET_BLUEPRINT = 13,
    HRBFNPR_PRESET_ARCHAEOLOGICAL = 14 }; hrbfnpr_status hrbfnpr_style_init_preset(hrbfnpr_style* style,
    uint32_t struct_size, uint32_t preset, hrbfnpr_error* error);
const hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint32_t preset, int64_t* count);
const char* hrbfnpr_preset_name(uint32_t preset); typedef struct hrbfnpr_occluders hrbfnpr_occluders;
enum { HRBFNPR_FIELD_KIND_SCALAR = 0, HRBFNPR_FIELD_KIND_COLOUR = 1, HRBFNPR_FIELD_KIND_DIRECTION = 2 };
enum { HRBFNPR_FIELD_SOURCE_POINTS = 0, HRBFNPR_FIELD_SOURCE_FUNCTION = 1, HRBFNPR_FIELD_SOURCE_DABS = 2,
    HRBFNPR_FIELD_SOURCE_IMAGE = 3 }; enum { HRBFNPR_DAB_TONE = 0, HRBFNPR_DAB_DENSITY = 1, HRBFNPR_DAB_DIRECTION = 2 };
typedef struct hrbfnpr_dab { uint32_t struct_size; uint32_t map; double position[3]; double normal[3]; double radius;
    double strength; double value; double direction[3]; } hrbfnpr_dab;
hrbfnpr_status hrbfnpr_dab_init(hrbfnpr_dab* dab, uint32_t struct_size); typedef int32_t (*hrbfnpr_field_fn)(void* user,
    int64_t count, const double* positions, const double* normals, double* values, double* weights);
typedef struct hrbfnpr_field_desc { uint32_t struct_size; uint32_t kind; uint32_t source; uint32_t flags;
    double range[2]; hrbfnpr_array points; hrbfnpr_array triangles; hrbfnpr_array values; double reach;
    hrbfnpr_field_fn function; void* user; const hrbfnpr_dab* dabs; int64_t dab_count; int64_t dab_stride;
    const hrbfnpr_image* image; const hrbfnpr_camera* camera; const hrbfnpr_occluders* occluders; } hrbfnpr_field_desc;
hrbfnpr_status hrbfnpr_field_desc_init(hrbfnpr_field_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_field_create(hrbfnpr_context* context, const hrbfnpr_field_desc* desc,
    hrbfnpr_operation* operation, hrbfnpr_field** out_field, hrbfnpr_error* error);
void hrbfnpr_field_retain(const hrbfnpr_field* field); void hrbfnpr_field_release(const hrbfnpr_field* field);
hrbfnpr_status hrbfnpr_field_evaluate(const hrbfnpr_field* field, const hrbfnpr_array* positions,
    const hrbfnpr_array* normals, const hrbfnpr_array_out* values, const hrbfnpr_array_out* weights,
    hrbfnpr_operation* operation, hrbfnpr_error* error); typedef struct hrbfnpr_renderer hrbfnpr_renderer;
typedef struct hrbfnpr_drawing hrbfnpr_drawing;
hrbfnpr_status hrbfnpr_renderer_create(hrbfnpr_context* context, hrbfnpr_renderer** out_renderer, hrbfnpr_error* error);
void hrbfnpr_renderer_retain(hrbfnpr_renderer* renderer); void hrbfnpr_renderer_release(hrbfnpr_renderer* renderer);
typedef struct hrbfnpr_layer_pose { uint32_t struct_size; uint32_t reserved; int64_t layer; hrbfnpr_array position;
    hrbfnpr_array normal; hrbfnpr_array direction; } hrbfnpr_layer_pose;
hrbfnpr_status hrbfnpr_layer_pose_init(hrbfnpr_layer_pose* pose, uint32_t struct_size);
enum { HRBFNPR_SIDES_FRONT = 0, HRBFNPR_SIDES_BOTH = 1 }; typedef struct hrbfnpr_shading hrbfnpr_shading;
typedef struct hrbfnpr_item { uint32_t struct_size; uint32_t sides; const hrbfnpr_point_set* point_set;
    const hrbfnpr_style* style; const hrbfnpr_model* model; double transform[16]; const hrbfnpr_layer_pose* poses;
    int64_t pose_count; int64_t pose_stride; const hrbfnpr_line_set* line_set; const hrbfnpr_shading* shading;
    } hrbfnpr_item; hrbfnpr_status hrbfnpr_item_init(hrbfnpr_item* item, uint32_t struct_size);
hrbfnpr_status hrbfnpr_occluders_create(hrbfnpr_context* context, const hrbfnpr_item* items, int64_t item_count,
    int64_t item_stride, hrbfnpr_operation* operation, hrbfnpr_occluders** out_occluders, hrbfnpr_error* error);
void hrbfnpr_occluders_retain(const hrbfnpr_occluders* occluders);
void hrbfnpr_occluders_release(const hrbfnpr_occluders* occluders); enum { HRBFNPR_SHADING_WITH_LINES = 1 };
typedef struct hrbfnpr_shading_desc { uint32_t struct_size; int32_t sky_rays; int32_t shadow_rays; uint32_t flags;
    double occlusion_reach; const hrbfnpr_shading* previous; double curvature_scale; } hrbfnpr_shading_desc;
hrbfnpr_status hrbfnpr_shading_desc_init(hrbfnpr_shading_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_shading_create(hrbfnpr_context* context, const hrbfnpr_occluders* occluders,
    const hrbfnpr_item* item, const hrbfnpr_camera* camera, const hrbfnpr_shading_desc* desc,
    hrbfnpr_operation* operation, hrbfnpr_shading** out_shading, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_shading_view(const hrbfnpr_shading* shading, int64_t layer, int64_t light,
    hrbfnpr_array* out_view, hrbfnpr_error* error); void hrbfnpr_shading_retain(const hrbfnpr_shading* shading);
void hrbfnpr_shading_release(const hrbfnpr_shading* shading);
hrbfnpr_status hrbfnpr_renderer_draw(hrbfnpr_renderer* renderer, const hrbfnpr_item* items, int64_t item_count,
    int64_t item_stride, const hrbfnpr_camera* camera, hrbfnpr_drawing** out_drawing, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_renderer_draw_with_operation(hrbfnpr_renderer* renderer, const hrbfnpr_item* items,
    int64_t item_count, int64_t item_stride, const hrbfnpr_camera* camera, hrbfnpr_operation* operation,
    hrbfnpr_drawing** out_drawing, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_point_set_generate_still(hrbfnpr_context* context, const hrbfnpr_model* model,
    const hrbfnpr_generate_desc* desc, const hrbfnpr_item* item, const hrbfnpr_camera* camera,
    hrbfnpr_operation* operation, hrbfnpr_point_set** out_point_set, hrbfnpr_error* error);
void hrbfnpr_drawing_retain(const hrbfnpr_drawing* drawing);
void hrbfnpr_drawing_release(const hrbfnpr_drawing* drawing);
enum { HRBFNPR_CLASS_NONE = 0, HRBFNPR_CLASS_FRONT = 1, HRBFNPR_CLASS_BACK = 2, HRBFNPR_CLASS_SILHOUETTE = 3 };
typedef struct hrbfnpr_drawing_info { uint32_t struct_size; uint32_t reserved; int64_t items; int64_t layers;
    int64_t dots; int64_t strokes; int64_t stroke_points; int64_t marks; int64_t outside; int64_t front; int64_t back;
    int64_t silhouette; int64_t culled; int64_t shown; int64_t dropped_tone; int64_t dropped_depth;
    int64_t dropped_zoom; int64_t dropped_hidden; int64_t splats; int64_t nanoseconds_classify;
    int64_t nanoseconds_visibility; int64_t nanoseconds_sort; int64_t bytes; int64_t scratch_bytes; int64_t line_curves;
    int64_t line_cusps; int64_t line_crossings; int64_t line_broken; int64_t line_settled; int64_t line_contradictions;
    int64_t nanoseconds_lines; int64_t line_refined; int64_t line_tangles; int64_t line_pieces; int64_t line_agreeing;
    int64_t line_undecided; int64_t line_repaired; } hrbfnpr_drawing_info;
hrbfnpr_status hrbfnpr_drawing_info_init(hrbfnpr_drawing_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_drawing_get_info(const hrbfnpr_drawing* drawing, hrbfnpr_drawing_info* info,
    hrbfnpr_error* error); typedef struct hrbfnpr_drawing_layer_info { uint32_t struct_size; uint32_t mark_class;
    int64_t item; int64_t layer; uint32_t kind; uint32_t shape; char name[64]; float ink[4]; int64_t dots;
    int64_t strokes; int32_t ink_number; uint32_t reserved; } hrbfnpr_drawing_layer_info;
hrbfnpr_status hrbfnpr_drawing_layer_info_init(hrbfnpr_drawing_layer_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_drawing_get_layer_info(const hrbfnpr_drawing* drawing, int64_t number,
    hrbfnpr_drawing_layer_info* info, hrbfnpr_error* error);
enum { HRBFNPR_RASTER_OVER = 1, HRBFNPR_RASTER_LINEAR_LIGHT = 2 };
typedef struct hrbfnpr_raster_desc { uint32_t struct_size; uint32_t flags; hrbfnpr_array host_depth;
    hrbfnpr_array_out depth; hrbfnpr_array_out id; hrbfnpr_array_out mark_class; } hrbfnpr_raster_desc;
hrbfnpr_status hrbfnpr_raster_desc_init(hrbfnpr_raster_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_drawing_rasterize(const hrbfnpr_drawing* drawing, const hrbfnpr_image* image,
    const hrbfnpr_raster_desc* desc, hrbfnpr_error* error);
enum { HRBFNPR_PRIMITIVE_POINTS = 1, HRBFNPR_PRIMITIVE_LINE_STRIPS = 2, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS = 3 };
enum { HRBFNPR_INDEX_RESTART = -1 }; enum { HRBFNPR_VERTEX_ATTRIBUTE_POSITION = 0, HRBFNPR_VERTEX_ATTRIBUTE_WINDOW = 1,
    HRBFNPR_VERTEX_ATTRIBUTE_RADIUS = 2, HRBFNPR_VERTEX_ATTRIBUTE_COLOR = 3, HRBFNPR_VERTEX_ATTRIBUTE_NORMAL = 4,
    HRBFNPR_VERTEX_ATTRIBUTE_DIRECTION = 5, HRBFNPR_VERTEX_ATTRIBUTE_ID = 6, HRBFNPR_VERTEX_ATTRIBUTE_CLASS = 7,
    HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER = 8, HRBFNPR_VERTEX_ATTRIBUTE_LAYER = 9, HRBFNPR_VERTEX_ATTRIBUTE_LENGTH = 10,
    HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_LAYERS = 11, HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_BY = 12,
    HRBFNPR_VERTEX_ATTRIBUTE_LINE = 13 }; typedef struct hrbfnpr_vertex_attribute { uint32_t struct_size;
    uint32_t attribute; uint32_t scalar; uint32_t offset; } hrbfnpr_vertex_attribute;
hrbfnpr_status hrbfnpr_vertex_attribute_init(hrbfnpr_vertex_attribute* attribute, uint32_t struct_size);
typedef struct hrbfnpr_vertex_layout { uint32_t struct_size; uint32_t primitive;
    const hrbfnpr_vertex_attribute* attributes; int64_t attribute_count; int64_t attribute_stride; int64_t stride;
    } hrbfnpr_vertex_layout;
hrbfnpr_status hrbfnpr_vertex_layout_init(hrbfnpr_vertex_layout* layout, uint32_t struct_size);
hrbfnpr_status hrbfnpr_drawing_vertex_bound(const hrbfnpr_drawing* drawing, uint32_t primitive, int64_t* vertices,
    int64_t* indices, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_drawing_write_vertices(const hrbfnpr_drawing* drawing, const hrbfnpr_vertex_layout* layout,
    void* vertices, int64_t vertex_capacity, int64_t* vertex_count, uint32_t* indices, int64_t index_capacity,
    int64_t* index_count, hrbfnpr_error* error);
typedef struct hrbfnpr_mark_results { uint32_t struct_size; uint32_t reserved; hrbfnpr_array_out shown;
    hrbfnpr_array_out radius; hrbfnpr_array_out opacity; } hrbfnpr_mark_results;
hrbfnpr_status hrbfnpr_mark_results_init(hrbfnpr_mark_results* results, uint32_t struct_size);
hrbfnpr_status hrbfnpr_drawing_mark_results(const hrbfnpr_drawing* drawing, int64_t item, int64_t layer,
    hrbfnpr_mark_results* results, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_drawing_write_mark_indices(const hrbfnpr_drawing* drawing, int64_t item, int64_t layer,
    uint32_t mark_class, uint32_t primitive, uint32_t* indices, int64_t capacity, int64_t* count, hrbfnpr_error* error);
typedef struct hrbfnpr_mark_identity { uint32_t struct_size; uint32_t id; int64_t item; int64_t layer; int64_t mark;
    int64_t stroke; int64_t place; } hrbfnpr_mark_identity;
hrbfnpr_status hrbfnpr_mark_identity_init(hrbfnpr_mark_identity* identity, uint32_t struct_size);
hrbfnpr_status hrbfnpr_drawing_identify(const hrbfnpr_drawing* drawing, uint32_t id, hrbfnpr_mark_identity* identity,
    hrbfnpr_error* error); enum { HRBFNPR_PARTS_OUTER = 0, HRBFNPR_PARTS_ALL = 1, HRBFNPR_PARTS_LARGEST = 2,
    HRBFNPR_PARTS_SOLIDS = 3, HRBFNPR_PARTS_AUTO = 4 }; enum { HRBFNPR_FACES_TURN = 0, HRBFNPR_FACES_KEEP = 1 };
typedef struct hrbfnpr_mesh_desc { uint32_t struct_size; uint32_t parts; hrbfnpr_array vertices;
    hrbfnpr_array triangles; double crease_angle; uint32_t faces; uint32_t reserved; } hrbfnpr_mesh_desc;
hrbfnpr_status hrbfnpr_mesh_desc_init(hrbfnpr_mesh_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_mesh_create(hrbfnpr_context* context, const hrbfnpr_mesh_desc* desc,
    hrbfnpr_operation* operation, hrbfnpr_mesh** out_mesh, hrbfnpr_error* error);
void hrbfnpr_mesh_retain(const hrbfnpr_mesh* mesh); void hrbfnpr_mesh_release(const hrbfnpr_mesh* mesh);
typedef struct hrbfnpr_mesh_info { uint32_t struct_size; uint32_t closed; int64_t given_vertices; int64_t given_faces;
    int64_t vertices; int64_t faces; int64_t welded_vertices; int64_t degenerate_faces; int64_t repeated_faces;
    int64_t turned_faces; int64_t components; int64_t turned_components; int64_t nested_components;
    int64_t left_out_components; int64_t left_out_faces; int64_t boundary_edges; int64_t boundary_loops;
    int64_t nonmanifold_edges; int64_t contrary_edges; int64_t euler_characteristic; int64_t genus; double area;
    double volume; double bounds_min[3]; double bounds_max[3]; double seconds; int64_t bytes; double crease_length;
    uint32_t creases; uint32_t cavities; } hrbfnpr_mesh_info;
hrbfnpr_status hrbfnpr_mesh_info_init(hrbfnpr_mesh_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_mesh_get_info(const hrbfnpr_mesh* mesh, hrbfnpr_mesh_info* info, hrbfnpr_error* error);
enum { HRBFNPR_MESH_ATTRIBUTE_VERTEX = 0, HRBFNPR_MESH_ATTRIBUTE_TRIANGLE = 1, HRBFNPR_MESH_ATTRIBUTE_COMPONENT = 2,
    HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE = 3, HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL = 4 };
hrbfnpr_status hrbfnpr_mesh_view(const hrbfnpr_mesh* mesh, uint32_t attribute, hrbfnpr_array* out_view,
    hrbfnpr_error* error); typedef struct hrbfnpr_sample_desc { uint32_t struct_size; uint32_t reserved;
    int64_t candidates; uint64_t random_seed; } hrbfnpr_sample_desc;
hrbfnpr_status hrbfnpr_sample_desc_init(hrbfnpr_sample_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_mesh_sample(const hrbfnpr_mesh* mesh, const hrbfnpr_sample_desc* desc,
    const hrbfnpr_array_out* points, const hrbfnpr_array_out* normals, hrbfnpr_operation* operation,
    hrbfnpr_error* error); enum { HRBFNPR_EDGES_AUTO = 0, HRBFNPR_EDGES_SMOOTH = 1, HRBFNPR_EDGES_SHARP = 2 };
typedef struct hrbfnpr_mesh_edges_desc { uint32_t struct_size; uint32_t edges; double crease_angle; double far;
    uint32_t tangent; uint32_t reserved; } hrbfnpr_mesh_edges_desc;
hrbfnpr_status hrbfnpr_mesh_edges_desc_init(hrbfnpr_mesh_edges_desc* desc, uint32_t struct_size);
typedef struct hrbfnpr_mesh_edges_info { uint32_t struct_size; uint32_t reserved; int64_t edges; int64_t patches;
    double length; double fading; double doubtful; double seconds; } hrbfnpr_mesh_edges_info;
hrbfnpr_status hrbfnpr_mesh_edges_info_init(hrbfnpr_mesh_edges_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_mesh_edges(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_edges_desc* desc,
    const hrbfnpr_array_out* patch, const hrbfnpr_array_out* sharp, hrbfnpr_mesh_edges_info* info,
    hrbfnpr_operation* operation, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_farthest_points(hrbfnpr_context* context, const hrbfnpr_array* points,
    const hrbfnpr_array_out* indices, const hrbfnpr_array_out* distance, hrbfnpr_operation* operation,
    hrbfnpr_error* error);
typedef struct hrbfnpr_compare_desc { uint32_t struct_size; uint32_t reserved; double tolerance; double far;
    double support; int64_t points; double cell_size; uint64_t random_seed; } hrbfnpr_compare_desc;
hrbfnpr_status hrbfnpr_compare_desc_init(hrbfnpr_compare_desc* desc, uint32_t struct_size);
typedef struct hrbfnpr_comparison { uint32_t struct_size; uint32_t reserved; int64_t surface_points;
    double surface_mean; double surface_p99; double surface_max; double surface_share; double invented_share;
    double left_out_share; int64_t mesh_points; double mesh_mean; double mesh_p99; double mesh_max; double mesh_share;
    double missed_share; double normal_mean; double normal_p99; int64_t components; int64_t genus; double tolerance;
    double diagonal; double seconds; } hrbfnpr_comparison;
hrbfnpr_status hrbfnpr_comparison_init(hrbfnpr_comparison* comparison, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_compare_mesh(const hrbfnpr_model* model, const hrbfnpr_mesh* mesh,
    const hrbfnpr_compare_desc* desc, hrbfnpr_comparison* comparison, hrbfnpr_operation* operation,
    hrbfnpr_error* error); typedef struct hrbfnpr_mesh_fit_desc { uint32_t struct_size; uint32_t reserved;
    double tolerance; double share; double far; int64_t maximum_centres; int64_t candidates; uint64_t random_seed;
    double crease_angle; uint32_t edges; uint32_t reserved2; } hrbfnpr_mesh_fit_desc;
hrbfnpr_status hrbfnpr_mesh_fit_desc_init(hrbfnpr_mesh_fit_desc* desc, uint32_t struct_size);
typedef struct hrbfnpr_mesh_fit_info { uint32_t struct_size; uint32_t reached; double tolerance; double far;
    int64_t candidates; int64_t centres; int64_t off_surface_centres; int32_t rounds; uint32_t supported;
    double surface_share; double surface_p99; double surface_max; double mesh_share; double mesh_p99; double mesh_max;
    double seconds_sample; double seconds_fit; double seconds_measure; double seconds_total; int32_t sheets;
    uint32_t reserved; double crease_length; double smooth_length; int64_t cells; int64_t poor_cells;
    int32_t touching_parts[2]; double touching_place[3]; uint32_t parts_may_cross; uint32_t reserved2;
    } hrbfnpr_mesh_fit_info;
hrbfnpr_status hrbfnpr_mesh_fit_info_init(hrbfnpr_mesh_fit_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_model_fit_mesh(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_fit_desc* desc,
    const hrbfnpr_fit_desc* fit, hrbfnpr_mesh_fit_info* info, hrbfnpr_operation* operation, hrbfnpr_model** out_model,
    hrbfnpr_error* error); enum { HRBFNPR_PAGE_FORMAT_SVG = 0, HRBFNPR_PAGE_FORMAT_PDF = 1,
    HRBFNPR_PAGE_FORMAT_HPGL = 2, HRBFNPR_PAGE_FORMAT_GCODE = 3, HRBFNPR_PAGE_FORMAT_DXF = 4 };
enum { HRBFNPR_WIDTHS_OUTLINES = 0, HRBFNPR_WIDTHS_CLASSES = 1 };
enum { HRBFNPR_DOT_SHAPE_CIRCLES = 0, HRBFNPR_DOT_SHAPE_LINES = 1, HRBFNPR_DOT_SHAPE_SPIRALS = 2 };
enum { HRBFNPR_CURVES_ARCS = 0, HRBFNPR_CURVES_SPLINES = 1, HRBFNPR_CURVES_LINES = 2 };
enum { HRBFNPR_PAGE_IN_PLOT_ORDER = 1, HRBFNPR_PAGE_SINGLE_PASS = 4, HRBFNPR_PAGE_WITHOUT_PAPER = 2 };
enum { HRBFNPR_LINE_TYPE_AS_DRAWN = 0, HRBFNPR_LINE_TYPE_CONTINUOUS = 1, HRBFNPR_LINE_TYPE_DASHED = 2,
    HRBFNPR_LINE_TYPE_DASHED_SPACED = 3, HRBFNPR_LINE_TYPE_LONG_DASHED_DOTTED = 4,
    HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_DOTTED = 5, HRBFNPR_LINE_TYPE_LONG_DASHED_TRIPLE_DOTTED = 6,
    HRBFNPR_LINE_TYPE_DOTTED = 7, HRBFNPR_LINE_TYPE_LONG_DASHED_SHORT_DASHED = 8,
    HRBFNPR_LINE_TYPE_LONG_DASHED_DOUBLE_SHORT_DASHED = 9, HRBFNPR_LINE_TYPE_DASHED_DOTTED = 10,
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOTTED = 11, HRBFNPR_LINE_TYPE_DASHED_DOUBLE_DOTTED = 12,
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_DOUBLE_DOTTED = 13, HRBFNPR_LINE_TYPE_DASHED_TRIPLE_DOTTED = 14,
    HRBFNPR_LINE_TYPE_DOUBLE_DASHED_TRIPLE_DOTTED = 15 };
typedef struct hrbfnpr_page_item { uint32_t struct_size; uint32_t reserved; const hrbfnpr_drawing* drawing; double x;
    double y; double scale; const char* name; } hrbfnpr_page_item;
hrbfnpr_status hrbfnpr_page_item_init(hrbfnpr_page_item* item, uint32_t struct_size);
typedef struct hrbfnpr_pen { uint32_t struct_size; uint32_t line_type; const char* groups; double width; float ink[4];
    uint32_t number; uint32_t reserved; } hrbfnpr_pen;
hrbfnpr_status hrbfnpr_pen_init(hrbfnpr_pen* pen, uint32_t struct_size);
typedef struct hrbfnpr_annotation { uint32_t struct_size; uint32_t line_type; const char* group; const char* text;
    hrbfnpr_array points; double width; float ink[4]; } hrbfnpr_annotation;
hrbfnpr_status hrbfnpr_annotation_init(hrbfnpr_annotation* annotation, uint32_t struct_size);
typedef struct hrbfnpr_page_desc { uint32_t struct_size; uint32_t format; uint32_t flags; uint32_t widths;
    uint32_t dots; uint32_t curves; double width; double height; double tolerance; double width_step; double join;
    double shortest; double dot_distance; double draw_speed; double travel_speed; double pen_seconds;
    const char* pen_down; const char* pen_up; const char* title; const char* description; const char* metadata;
    const hrbfnpr_page_item* items; int64_t item_count; int64_t item_stride; const hrbfnpr_pen* pens; int64_t pen_count;
    int64_t pen_stride; const hrbfnpr_annotation* annotations; int64_t annotation_count; int64_t annotation_stride;
    double longest; } hrbfnpr_page_desc;
hrbfnpr_status hrbfnpr_page_desc_init(hrbfnpr_page_desc* desc, uint32_t struct_size); typedef struct hrbfnpr_page_info {
    uint32_t struct_size; uint32_t reserved; int64_t bytes; int64_t groups; int64_t paths; int64_t segments;
    int64_t dots; int64_t joined; int64_t dropped_paths; int64_t dropped_dots; double width; double height;
    double drawn; double travelled; double seconds; int64_t filled_paths; int64_t cut_paths; } hrbfnpr_page_info;
hrbfnpr_status hrbfnpr_page_info_init(hrbfnpr_page_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_page_write(hrbfnpr_context* context, const hrbfnpr_page_desc* desc, hrbfnpr_write_fn write,
    void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation, hrbfnpr_error* error);
typedef struct hrbfnpr_picture hrbfnpr_picture; typedef struct hrbfnpr_settings hrbfnpr_settings;
enum { HRBFNPR_SOURCE_HAS_SHARP_EDGES = 1, HRBFNPR_SOURCE_HAS_VIEWPOINT = 2, HRBFNPR_SOURCE_IS_PHOTO = 4 };
typedef struct hrbfnpr_source_field { uint32_t struct_size; uint32_t kind; const char* name; hrbfnpr_array values;
    } hrbfnpr_source_field; hrbfnpr_status hrbfnpr_source_field_init(hrbfnpr_source_field* field, uint32_t struct_size);
typedef struct hrbfnpr_picture_source { uint32_t struct_size; uint32_t flags; hrbfnpr_array points;
    hrbfnpr_array normals; hrbfnpr_array triangles; hrbfnpr_array sharp_edges; const hrbfnpr_model* model;
    const hrbfnpr_point_set* point_set; double up[3]; const char* up_by; double viewpoint[3]; int64_t columns;
    int64_t rows; const char* name; const hrbfnpr_source_field* fields; int64_t field_count; int64_t field_stride;
    } hrbfnpr_picture_source;
hrbfnpr_status hrbfnpr_picture_source_init(hrbfnpr_picture_source* source, uint32_t struct_size);
enum { HRBFNPR_PICTURE_ALLOW_BLANK = 1, HRBFNPR_PICTURE_FLIP = 2, HRBFNPR_PICTURE_CLOSE = 4,
    HRBFNPR_PICTURE_TOGETHER = 8, HRBFNPR_PICTURE_TRANSPARENT = 16, HRBFNPR_PICTURE_KEEP_MARKS = 32,
    HRBFNPR_PICTURE_SURFACE_ONLY = 64, HRBFNPR_PICTURE_IS_SOLID = 128, HRBFNPR_PICTURE_VERIFY = 256 };
enum { HRBFNPR_PICTURE_EDGES_AS_GIVEN = 0, HRBFNPR_PICTURE_EDGES_AUTO = 1, HRBFNPR_PICTURE_EDGES_SMOOTH = 2,
    HRBFNPR_PICTURE_EDGES_SHARP = 3 };
enum { HRBFNPR_PROFILE_AUTO = 0, HRBFNPR_PROFILE_YES = 1, HRBFNPR_PROFILE_NO = 2 };
enum { HRBFNPR_PICTURE_SIDES_AUTO = 0, HRBFNPR_PICTURE_SIDES_FRONT = 1, HRBFNPR_PICTURE_SIDES_BOTH = 2 };
enum { HRBFNPR_PICTURE_GROUND_NONE = 0, HRBFNPR_PICTURE_GROUND_LOWEST = 1, HRBFNPR_PICTURE_GROUND_HEIGHT = 2 };
enum { HRBFNPR_WORDING_FIELDS = 0, HRBFNPR_WORDING_OPTIONS = 1, HRBFNPR_WORDING_ARGUMENTS = 2 };
typedef struct hrbfnpr_change { uint32_t struct_size; uint32_t reserved; const char* field; const char* value;
    } hrbfnpr_change; hrbfnpr_status hrbfnpr_change_init(hrbfnpr_change* change, uint32_t struct_size);
enum { HRBFNPR_STAGE_MESH = 1, HRBFNPR_STAGE_SAMPLE = 2, HRBFNPR_STAGE_ORIENT = 3, HRBFNPR_STAGE_SMOOTH = 4,
    HRBFNPR_STAGE_FIT = 5, HRBFNPR_STAGE_COMPARE = 6, HRBFNPR_STAGE_END = 7, HRBFNPR_STAGE_MARKS = 8,
    HRBFNPR_STAGE_LINES = 9, HRBFNPR_STAGE_FRAME = 10, HRBFNPR_STAGE_VIEWS = 11, HRBFNPR_STAGE_SHADE = 12 }; enum {
    HRBFNPR_SEVERITY_INFO = 0, HRBFNPR_SEVERITY_NOTE = 1, HRBFNPR_SEVERITY_WARNING = 2, HRBFNPR_SEVERITY_FAILURE = 3 };
enum { HRBFNPR_NOTE_FACES_NOT_FINITE = 1, HRBFNPR_NOTE_NO_DATA = 2, HRBFNPR_NOTE_STRAYS = 3,
    HRBFNPR_NOTE_SOME_ORIENTED = 4, HRBFNPR_NOTE_NORMALS_MADE = 5, HRBFNPR_NOTE_NORMALS_NOT_SURE = 6,
    HRBFNPR_NOTE_FRONT_NOT_TOLD = 7, HRBFNPR_NOTE_SAMPLES_CHOSEN = 8, HRBFNPR_NOTE_POINTS_NOT_USABLE = 9,
    HRBFNPR_NOTE_NORMALS_JOINED = 10, HRBFNPR_NOTE_NORMALS_OPPOSITE = 11, HRBFNPR_NOTE_TERRAIN_TURNED = 12,
    HRBFNPR_NOTE_NORMALS_TURNED = 13, HRBFNPR_NOTE_NORMALS_REPAIRED = 14, HRBFNPR_NOTE_NORMALS_AGAINST = 15,
    HRBFNPR_NOTE_NORMALS_MIXED = 16, HRBFNPR_NOTE_NORMALS_INWARD = 17, HRBFNPR_NOTE_VIEWPOINT_NOT_USED = 18,
    HRBFNPR_NOTE_PIXELS_LEFT_OUT = 19, HRBFNPR_NOTE_DEPTH_NOISE = 20, HRBFNPR_NOTE_SMOOTHED = 21,
    HRBFNPR_NOTE_SAMPLES_MERGED = 22, HRBFNPR_NOTE_SAMPLES_NEAR = 23, HRBFNPR_NOTE_SAMPLES_DROPPED = 24,
    HRBFNPR_NOTE_SAMPLES_FLIPPED = 25, HRBFNPR_NOTE_LIKE_STRAYS = 26, HRBFNPR_NOTE_LIKE_FLIPPED = 27,
    HRBFNPR_NOTE_FEW_POINTS = 28, HRBFNPR_NOTE_ON_A_LINE = 29, HRBFNPR_NOTE_IN_A_PLANE = 30,
    HRBFNPR_NOTE_ALONG_CURVES = 31, HRBFNPR_NOTE_END_NOT_FOUND = 32, HRBFNPR_NOTE_UP = 33,
    HRBFNPR_NOTE_FACES_TURNED = 34, HRBFNPR_NOTE_INSIDE_OUT = 35, HRBFNPR_NOTE_FACES_LEFT_OUT = 36,
    HRBFNPR_NOTE_PARTS_INSIDE = 37, HRBFNPR_NOTE_CONTRARY_EDGES = 38, HRBFNPR_NOTE_PARTS_FAR = 39,
    HRBFNPR_NOTE_FLAPS = 40, HRBFNPR_NOTE_ALL_FLAT = 41, HRBFNPR_NOTE_EDGES_BY_NORMALS = 42, HRBFNPR_NOTE_DIVIDED = 43,
    HRBFNPR_NOTE_COARSE_FLAT = 44, HRBFNPR_NOTE_GROUPS = 45, HRBFNPR_NOTE_NOT_REACHED = 46,
    HRBFNPR_NOTE_EDGES_STAY_SMOOTH = 47, HRBFNPR_NOTE_OFF_MESH = 48, HRBFNPR_NOTE_MADE_BY_FIT = 49,
    HRBFNPR_NOTE_PARTS_TOO_THIN = 50, HRBFNPR_NOTE_MARKS_LIMITED = 51, HRBFNPR_NOTE_LEVELS_LIMITED = 52,
    HRBFNPR_NOTE_SEEN_FROM_CAMERA = 53, HRBFNPR_NOTE_SEEN_FROM_FRONT = 54, HRBFNPR_NOTE_NO_LINES_OF_MARKS = 55,
    HRBFNPR_NOTE_LINES_THIN = 56, HRBFNPR_NOTE_LINES_END = 57, HRBFNPR_NOTE_LINES_BROKEN = 58,
    HRBFNPR_NOTE_LINES_DOUBTED = 59, HRBFNPR_NOTE_LINES_TANGLED = 60, HRBFNPR_NOTE_BLANK = 61, HRBFNPR_NOTE_PENS = 62,
    HRBFNPR_NOTE_PLOTTED = 63, HRBFNPR_NOTE_NOT_IN_SETTINGS = 64, HRBFNPR_NOTE_UNIT_IS_METRE = 65,
    HRBFNPR_NOTE_NO_SYMMETRY = 66, HRBFNPR_NOTE_SECTION_OPEN = 67, HRBFNPR_NOTE_NORMALS_NOT_UNIT = 68,
    HRBFNPR_NOTE_AT_ONE_PLACE = 69, HRBFNPR_NOTE_FAR_FROM_ORIGIN = 70, HRBFNPR_NOTE_VERTICES_JOINED = 71,
    HRBFNPR_NOTE_VERTICES_UNUSED = 72, HRBFNPR_NOTE_NONMANIFOLD_EDGES = 73, HRBFNPR_NOTE_MESH_OPEN = 74,
    HRBFNPR_NOTE_SEVERAL_PARTS = 75, HRBFNPR_NOTE_NOT_USABLE = 76, HRBFNPR_NOTE_NO_GROUND = 77,
    HRBFNPR_NOTE_PALETTE_CHOSEN = 78, HRBFNPR_NOTE_NO_SHADOWS = 79, HRBFNPR_NOTE_LINES_VERIFIED = 95 };
typedef struct hrbfnpr_note { uint32_t struct_size; uint32_t code; uint32_t severity; uint32_t figure_count;
    double figures[8]; const char* text; const char* advice; const char* detail; } hrbfnpr_note;
hrbfnpr_status hrbfnpr_note_init(hrbfnpr_note* note, uint32_t struct_size);
typedef struct hrbfnpr_picture_event { uint32_t struct_size; uint32_t stage; double fraction; double seconds;
    const char* name; const char* doing; const char* says; const hrbfnpr_note* note; } hrbfnpr_picture_event;
hrbfnpr_status hrbfnpr_picture_event_init(hrbfnpr_picture_event* event, uint32_t struct_size);
typedef void (*hrbfnpr_picture_event_fn)(void* user, const hrbfnpr_picture_event* event);
typedef struct hrbfnpr_picture_desc { uint32_t struct_size; uint32_t flags; const hrbfnpr_picture_source* sources;
    int64_t source_count; int64_t source_stride; uint32_t preset; uint32_t wording; const char* style_name;
    const hrbfnpr_style* style; const hrbfnpr_settings* settings; const hrbfnpr_change* changes; int64_t change_count;
    int64_t change_stride; const hrbfnpr_dab* dabs; int64_t dab_count; int64_t dab_stride; int32_t width;
    int32_t height; int32_t size; uint32_t sides; double pen; double line_width; const hrbfnpr_camera* camera;
    double up[3]; double azimuth; double elevation; double direction[3]; double eye[3]; double target[3]; double fov;
    double margin; double turn; int32_t turn_frames; uint32_t normals; int64_t samples; double tolerance;
    int64_t maximum_centres; uint32_t parts; uint32_t edges; double edge_angle; double crease_angle; int32_t subdivide;
    uint32_t profile; double viewpoint[3]; double depth_smoothing; uint64_t random_seed; const char* mark_kinds;
    hrbfnpr_array seed_points; double hatch_angle; const char* lines; const char* scale_bar;
    hrbfnpr_picture_event_fn on_event; void* event_user; uint32_t ground; uint32_t reserved; double ground_height;
    } hrbfnpr_picture_desc; hrbfnpr_status hrbfnpr_picture_desc_init(hrbfnpr_picture_desc* desc, uint32_t struct_size);
enum { HRBFNPR_SOURCE_KIND_POINTS = 1, HRBFNPR_SOURCE_KIND_MESH = 2, HRBFNPR_SOURCE_KIND_MODEL = 3,
    HRBFNPR_SOURCE_KIND_POINT_SET = 4 };
enum { HRBFNPR_NORMALS_LOOK_UNKNOWN = 0, HRBFNPR_NORMALS_LOOK_OUTWARD = 1, HRBFNPR_NORMALS_LOOK_INWARD = 2,
    HRBFNPR_NORMALS_LOOK_MIXED = 3, HRBFNPR_NORMALS_LOOK_OPEN = 4, HRBFNPR_NORMALS_LOOK_FOREIGN = 5 };
typedef struct hrbfnpr_source_info { uint32_t struct_size; uint32_t kind; uint32_t severity; uint32_t normals_look;
    int64_t points; int64_t triangles; int64_t no_data; int64_t strays; int64_t points_not_finite; int64_t duplicates;
    double bounds_min[3]; double bounds_max[3]; double diagonal; double up[3]; uint32_t has_normals;
    uint32_t along_curves; uint32_t looks_down; uint32_t reserved; int64_t normals_zero; int64_t normals_not_finite;
    double normals_unit_share; double normals_closed; double normals_flipped_share; int64_t image_seen;
    int64_t image_dropped; double image_depth; double image_noise; uint32_t closed; uint32_t inside_out;
    int64_t components; int64_t components_inside_out; int64_t boundary_edges; int64_t boundary_loops;
    int64_t nonmanifold_edges; int64_t nonmanifold_left; int64_t contrary_edges; int64_t faces_not_finite;
    int64_t degenerate_faces; int64_t repeated_faces; int64_t unused_vertices; double area; double volume;
    char up_reason[128]; } hrbfnpr_source_info;
hrbfnpr_status hrbfnpr_source_info_init(hrbfnpr_source_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_source_inspect(hrbfnpr_context* context, const hrbfnpr_picture_source* source, uint32_t wording,
    hrbfnpr_picture_event_fn on_event, void* event_user, hrbfnpr_operation* operation, hrbfnpr_source_info* info,
    hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_picture_create(hrbfnpr_context* context, const hrbfnpr_picture_desc* desc,
    hrbfnpr_operation* operation, hrbfnpr_picture** out_picture, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_picture_restyle(const hrbfnpr_picture* picture, const hrbfnpr_picture_desc* desc,
    hrbfnpr_operation* operation, hrbfnpr_picture** out_picture, hrbfnpr_error* error);
void hrbfnpr_picture_retain(hrbfnpr_picture* picture); void hrbfnpr_picture_release(hrbfnpr_picture* picture);
hrbfnpr_status hrbfnpr_picture_draw(hrbfnpr_picture* picture, const hrbfnpr_camera* camera,
    hrbfnpr_operation* operation, hrbfnpr_drawing** out_drawing, hrbfnpr_error* error);
typedef struct hrbfnpr_picture_info { uint32_t struct_size; uint32_t preset; int64_t parts; int64_t marks;
    int64_t notes; int64_t stages; int32_t width; int32_t height; double bounds_min[3]; double bounds_max[3];
    double up[3]; double pen; double seconds; } hrbfnpr_picture_info;
hrbfnpr_status hrbfnpr_picture_info_init(hrbfnpr_picture_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_picture_get_info(const hrbfnpr_picture* picture, hrbfnpr_picture_info* info,
    hrbfnpr_error* error); typedef struct hrbfnpr_picture_part { uint32_t struct_size; uint32_t sides;
    const hrbfnpr_model* model; const hrbfnpr_point_set* point_set; const hrbfnpr_line_set* line_set;
    const hrbfnpr_mesh* mesh; } hrbfnpr_picture_part;
hrbfnpr_status hrbfnpr_picture_part_init(hrbfnpr_picture_part* part, uint32_t struct_size);
hrbfnpr_status hrbfnpr_picture_get_part(const hrbfnpr_picture* picture, int64_t number, hrbfnpr_picture_part* part,
    hrbfnpr_error* error); hrbfnpr_status hrbfnpr_picture_get_style(const hrbfnpr_picture* picture,
    const hrbfnpr_style** style, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_picture_get_marks(const hrbfnpr_picture* picture, const hrbfnpr_generate_desc** desc,
    hrbfnpr_error* error); hrbfnpr_status hrbfnpr_picture_get_note(const hrbfnpr_picture* picture, int64_t number,
    hrbfnpr_note* note, hrbfnpr_error* error); hrbfnpr_status hrbfnpr_picture_get_stage(const hrbfnpr_picture* picture,
    int64_t number, hrbfnpr_picture_event* stage, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_picture_get_camera(const hrbfnpr_picture* picture, hrbfnpr_camera* camera, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_picture_look(const hrbfnpr_picture* picture, const double* direction, double azimuth,
    double elevation, hrbfnpr_camera* camera, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_picture_orbit(const hrbfnpr_picture* picture, double degrees, hrbfnpr_camera* camera,
    hrbfnpr_error* error); hrbfnpr_status hrbfnpr_picture_plate_size(const hrbfnpr_picture* picture,
    const hrbfnpr_camera* camera, int32_t* width, int32_t* height, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_picture_rasterize(const hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing,
    const hrbfnpr_camera* camera, const hrbfnpr_image* image, hrbfnpr_error* error);
typedef struct hrbfnpr_picture_page_desc { uint32_t struct_size; uint32_t reserved; const hrbfnpr_page_desc* page;
    const char* paper; double paper_margin; hrbfnpr_array pen_widths; } hrbfnpr_picture_page_desc;
hrbfnpr_status hrbfnpr_picture_page_desc_init(hrbfnpr_picture_page_desc* desc, uint32_t struct_size);
hrbfnpr_status hrbfnpr_picture_write(hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing,
    const hrbfnpr_camera* camera, const hrbfnpr_picture_page_desc* desc, hrbfnpr_write_fn write, void* user,
    hrbfnpr_page_info* info, hrbfnpr_operation* operation, hrbfnpr_error* error);
hrbfnpr_status hrbfnpr_settings_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
    hrbfnpr_settings** out_settings, hrbfnpr_error* error);
void hrbfnpr_settings_retain(const hrbfnpr_settings* settings);
void hrbfnpr_settings_release(const hrbfnpr_settings* settings);
hrbfnpr_status hrbfnpr_picture_write_settings(hrbfnpr_picture* picture, hrbfnpr_write_fn write, void* user,
    hrbfnpr_error* error); enum { HRBFNPR_VIEWS_CENTRE_LINES = 1, HRBFNPR_VIEWS_LABELS = 2,
    HRBFNPR_VIEWS_UNIT_IS_METRE = 4, HRBFNPR_VIEWS_VERIFY = 8 };
enum { HRBFNPR_VIEWS_ANGLE_FIRST = 0, HRBFNPR_VIEWS_ANGLE_THIRD = 1 };
enum { HRBFNPR_VIEWS_HIDDEN_DASHED = 0, HRBFNPR_VIEWS_HIDDEN_NONE = 1, HRBFNPR_VIEWS_HIDDEN_SHOWN = 2 };
enum { HRBFNPR_VIEWS_TANGENT_SHORT = 0, HRBFNPR_VIEWS_TANGENT_THIN = 1, HRBFNPR_VIEWS_TANGENT_NONE = 2 };
typedef struct hrbfnpr_views_desc { uint32_t struct_size; uint32_t flags; uint32_t projection; uint32_t hidden;
    const char* views; const char* sections; const char* paper; const char* scale; const char* smooth;
    const char* title; const char* model; double unit_mm; double crease_angle; double line_width; double hatch_spacing;
    double spacing; const hrbfnpr_page_desc* page; uint32_t tangent; uint32_t reserved; } hrbfnpr_views_desc;
hrbfnpr_status hrbfnpr_views_desc_init(hrbfnpr_views_desc* desc, uint32_t struct_size);
typedef struct hrbfnpr_views_info { uint32_t struct_size; uint32_t reserved; int64_t views; int64_t bytes; double width;
    double height; double scale; double unit_mm; char scale_text[64]; char paper[64]; int64_t pieces; int64_t agreeing;
    int64_t undecided; int64_t repaired; } hrbfnpr_views_info;
hrbfnpr_status hrbfnpr_views_info_init(hrbfnpr_views_info* info, uint32_t struct_size);
hrbfnpr_status hrbfnpr_picture_write_views(hrbfnpr_picture* picture, const hrbfnpr_views_desc* desc,
    hrbfnpr_write_fn write, void* user, hrbfnpr_views_info* info, hrbfnpr_operation* operation, hrbfnpr_error* error);
