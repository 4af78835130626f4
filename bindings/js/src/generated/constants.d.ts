// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.

/**
 * The version of this header.  HRBFNPR_ABI_VERSION is the number in the SONAME
 * of the shared library.  It changes only when an existing binary would break.
 */
export declare const VERSION: {
  readonly VERSION_MAJOR: 0;
  readonly VERSION_MINOR: 1;
  readonly VERSION_PATCH: 0;
  readonly ABI_VERSION: 1;
};
/** A constant of VERSION as options spell it. */
export type VersionName = "version-major" | "version-minor" | "version-patch" | "abi-version";

export declare const STATUS: {
  /** success */
  readonly OK: 0;
  /** an argument is wrong: the message names it and says what to do */
  readonly INVALID_ARGUMENT: -1;
  /** the allocator returned NULL */
  readonly OUT_OF_MEMORY: -2;
  /** only the needed size has been written */
  readonly BUFFER_TOO_SMALL: -3;
  /** struct_size is out of range, or unknown fields are not zero */
  readonly UNSUPPORTED_STRUCT: -4;
  /** the fit has no numerically unique solution */
  readonly SINGULAR_SYSTEM: -5;
  /** an iteration ended before it reached its goal */
  readonly NOT_CONVERGED: -6;
  /** hrbfnpr_operation_cancel or a progress callback ended the call */
  readonly CANCELLED: -7;
  /** a read or write callback failed */
  readonly IO: -8;
  /** a stream is of another format, truncated or damaged */
  readonly CORRUPT_DATA: -9;
  /** a stream is newer than the library, or the header has another ABI version */
  readonly VERSION_MISMATCH: -10;
  /** a callback of the caller returned non-zero or gave invalid results */
  readonly CALLBACK: -11;
  /** a bug in the library: please report it */
  readonly INTERNAL: -99;
};
/** A constant of STATUS as options spell it. */
export type StatusName = "ok" | "invalid-argument" | "out-of-memory" | "buffer-too-small" | "unsupported-struct" |
  "singular-system" | "not-converged" | "cancelled" | "io" | "corrupt-data" | "version-mismatch" | "callback" |
  "internal";

/** The type of the numbers in an array. */
export declare const SCALAR: {
  /** float */
  readonly FLOAT32: 1;
  /** double */
  readonly FLOAT64: 2;
  /** uint8_t */
  readonly UINT8: 3;
  /** uint32_t */
  readonly UINT32: 4;
  /** int32_t */
  readonly INT32: 5;
  /** int64_t */
  readonly INT64: 6;
};
/** A constant of SCALAR as options spell it. */
export type ScalarName = "float32" | "float64" | "uint8" | "uint32" | "int32" | "int64";

/**
 * The format of an image's pixels.  The name gives the order of the channels in
 * memory.  A channel has 8 bits or is a float.  Colours are sRGB-encoded.
 * PREMULTIPLIED: colours are multiplied by alpha.
 */
export declare const FORMAT: {
  /** 4 bytes */
  readonly RGBA8: 1;
  /** 4 bytes */
  readonly BGRA8: 2;
  /** 4 bytes */
  readonly RGBA8_PREMULTIPLIED: 3;
  /** 4 bytes */
  readonly BGRA8_PREMULTIPLIED: 4;
  /** 4 FLOAT32 from 0 to 1, aligned to 4 bytes */
  readonly RGBA32F: 5;
  /** 4 FLOAT32 from 0 to 1, aligned to 4 bytes */
  readonly RGBA32F_PREMULTIPLIED: 6;
  /** one byte: the share of the pixel that ink covers, of any colour */
  readonly COVERAGE8: 7;
};
/** A constant of FORMAT as options spell it. */
export type FormatName = "rgba8" | "bgra8" | "rgba8-premultiplied" | "bgra8-premultiplied" | "rgba32f" |
  "rgba32f-premultiplied" | "coverage8";

/** The level of a message in the log. */
export declare const LOG: {
  /** details for developers of the library */
  readonly DEBUG: 0;
  /** what a call did, with counts and times */
  readonly INFO: 1;
  /** the result may not be what the caller expects */
  readonly WARNING: 2;
};
/** A constant of LOG as options spell it. */
export type LogName = "debug" | "info" | "warning";

/** Instruction sets of processors, for `highest_instruction_set` and `instruction_set`. */
export declare const INSTRUCTION_SET: {
  /** the best one that both the build and the processor have */
  readonly AUTO: 0;
  /** the one that the library was compiled for */
  readonly BASELINE: 1;
  /** x86: 256 bits */
  readonly AVX2: 2;
  /** x86: 512 bits */
  readonly AVX512: 3;
  /** Arm: 128 bits */
  readonly NEON: 4;
};
/** A constant of INSTRUCTION_SET as options spell it. */
export type InstructionSetName = "auto" | "baseline" | "avx2" | "avx512" | "neon";

/**
 * Which threads run the library's tasks.  The choice does not change the bits of
 * any result.  docs/hosts.md compares them.
 */
export declare const THREAD_BACKEND: {
  /** RUN_TASKS if run_tasks is given, else POOL */
  readonly AUTO: 0;
  /**
   * threads that the context owns. The calling thread takes part and waits only for tasks that others have begun,
   * so a processor that is busy with other work costs little. Idle threads sleep
   */
  readonly POOL: 1;
  /**
   * the threads of the OpenMP runtime, shared with a host that uses it; serial in a forked child. Use it only if
   * no other work needs the processors. INVALID_ARGUMENT in a build without OpenMP (hrbfnpr_build_info lists
   * thread_backends)
   */
  readonly OPENMP: 2;
  /** the host's job system, through run_tasks */
  readonly RUN_TASKS: 3;
  /** the calling thread alone, as with thread_count 1 */
  readonly SERIAL: 4;
};
/** A constant of THREAD_BACKEND as options spell it. */
export type ThreadBackendName = "auto" | "pool" | "openmp" | "run-tasks" | "serial";

/** Radial functions phi(r) [NPAR 4.1]. */
export declare const KERNEL: {
  /** r^3, without a parameter; the default */
  readonly TRIHARMONIC: 0;
  /** exp(-r^2 / (2 radius^2)) */
  readonly GAUSSIAN: 1;
  /** (1 - r/radius)^4 (4 r/radius + 1) for r < radius, else 0 */
  readonly WENDLAND_C2: 2;
  /** not for fits: reported for a model made by _create_custom */
  readonly CUSTOM: 3;
  /** not for fits: reported for a model made by _create_csg */
  readonly CSG: 4;
};
/** A constant of KERNEL as options spell it. */
export type KernelName = "triharmonic" | "gaussian" | "wendland-c2" | "custom" | "csg";

/** How the linear system of a fit is solved.  docs/fitting.md gives times and memory. */
export declare const SOLVER: {
  /** DIRECT for few samples, ITERATIVE for many */
  readonly AUTO: 0;
  /** dense factorization: memory grows with N^2, time with N^3 */
  readonly DIRECT: 1;
  /**
   * preconditioned conjugate gradients: memory grows with N. TRIHARMONIC needs polynomial_degree 1 or more
   * [Schaefer, Katzfuss, Owhadi 2021]
   */
  readonly ITERATIVE: 2;
};
/** A constant of SOLVER as options spell it. */
export type SolverName = "auto" | "direct" | "iterative";

/** Why a fit used the solver that it used. */
export declare const SOLVER_REASON: {
  /** the caller named it */
  readonly REQUESTED: 0;
  /** AUTO took DIRECT, which is faster for few samples */
  readonly SMALL: 1;
  /** AUTO took ITERATIVE: DIRECT would need too much memory or time */
  readonly LARGE: 2;
  /** AUTO took DIRECT, because ITERATIVE did not reach its tolerance */
  readonly NOT_CONVERGED: 3;
  /** AUTO took DIRECT, because ITERATIVE needs a definite system */
  readonly NOT_DEFINITE: 4;
};
/** A constant of SOLVER_REASON as options spell it. */
export type SolverReasonName = "requested" | "small" | "large" | "not-converged" | "not-definite";

/** What a fit does with samples that look wrong.  It counts them in any case. */
export declare const REPAIR: {
  /** uses them as they are */
  readonly KEEP: 0;
  /** leaves them out */
  readonly DROP: 1;
  /** turns their normals round; for flipped normals only */
  readonly REORIENT: 2;
};
/** A constant of REPAIR as options spell it. */
export type RepairName = "keep" | "drop" | "reorient";

/** Where the regularization of a fit comes from. */
export declare const REGULARIZATION: {
  /** the field `regularization` */
  readonly GIVEN: 0;
  /** the measured noise of the samples; 0 for samples without noise */
  readonly AUTO: 1;
};
/** A constant of REGULARIZATION as options spell it. */
export type RegularizationName = "given" | "auto";

/** How far the given normals can be trusted, for a fit and for hrbfnpr_orient. */
export declare const NORMALS: {
  /** they are correct and point outward */
  readonly GIVEN: 0;
  /** there are none, or they are useless: all are made */
  readonly NONE: 1;
  /** the directions are correct, the signs are not */
  readonly UNORIENTED: 2;
  /** the directions and most signs are correct; some patches are turned */
  readonly MIXED: 3;
  /** they are consistent, but all point inward */
  readonly INWARD: 4;
  /** find out which of these holds, and repair accordingly */
  readonly AUTO: 5;
};
/** A constant of NORMALS as options spell it. */
export type NormalsName = "given" | "none" | "unoriented" | "mixed" | "inward" | "auto";

/** Whether a fitted surface ends where its samples end (see hrbfnpr_model_trim). */
export declare const TRIM: {
  /** the surface goes on to the end of the search box */
  readonly NEVER: 0;
  /**
   * an open surface ends where the given samples end (all of them, not only the chosen centres). A closed surface
   * stays whole, and so does one of fewer than ten samples. hrbfnpr_model_get_trim_info says what was done
   */
  readonly AUTO: 1;
};
/** A constant of TRIM as options spell it. */
export type TrimName = "never" | "auto";

/** How hrbfnpr_orient decided which side is outward. */
export declare const OUTWARD: {
  /** the surface encloses the other side */
  readonly INSIDE: 0;
  /** `up` points to this side */
  readonly UP: 1;
  /** the viewpoint is on this side */
  readonly VIEWPOINT: 2;
  /** most given normals point to this side */
  readonly AS_GIVEN: 3;
};
/** A constant of OUTWARD as options spell it. */
export type OutwardName = "inside" | "up" | "viewpoint" | "as-given";

/**
 * What a custom function can do.  Without a flag, the library computes the
 * derivatives by differences and passes NULL for them.
 */
export declare const CUSTOM: {
  /** the function fills `gradient` */
  readonly HAS_GRADIENT: 1;
  /** the function fills `hessian` */
  readonly HAS_HESSIAN: 2;
  /**
   * the function may run on several threads at the same time; else it runs on one at a time, on the thread that
   * called the library
   */
  readonly THREAD_SAFE: 4;
};
/** A constant of CUSTOM as options spell it. */
export type CustomName = "has-gradient" | "has-hessian" | "thread-safe";

/** The arrays of a model that hrbfnpr_model_view shows. */
export declare const MODEL_ATTRIBUTE: {
  /** FLOAT64 x 3: the centres; for a model of sheets, places all over the surface */
  readonly POSITION: 0;
  /** FLOAT64 x 3: the unit normals at these places */
  readonly NORMAL: 1;
  /** FLOAT64: the relative residual after each iteration of ITERATIVE; empty after DIRECT and after loading */
  readonly RESIDUAL_HISTORY: 2;
};
/** A constant of MODEL_ATTRIBUTE as options spell it. */
export type ModelAttributeName = "position" | "normal" | "residual-history";

/** What became of a projected point. */
export declare const PROJECTION: {
  /** the point is on the surface, within the tolerance */
  readonly CONVERGED: 0;
  /** the evaluation limit was reached, or no step lowers f^2 */
  readonly NOT_CONVERGED: 1;
  /** the point is stuck off the surface, where the gradient vanishes */
  readonly ZERO_GRADIENT: 2;
  /** f or its gradient is not finite, or the gradient is longer than 1e150 */
  readonly NOT_FINITE: 3;
};
/** A constant of PROJECTION as options spell it. */
export type ProjectionName = "converged" | "not-converged" | "zero-gradient" | "not-finite";

/** What became of a ray. */
export declare const RAY: {
  /** it has one or several hits */
  readonly HIT: 0;
  /** it has no hit */
  readonly MISS: 1;
  /** it has more hits than maximum_hits; reported only if that is 2 or more */
  readonly TRUNCATED: 2;
  /** the search ended at the evaluation limit; earlier hits are kept */
  readonly EVALUATION_LIMIT: 3;
  /** f or its gradient is not finite; earlier hits are kept */
  readonly NOT_FINITE: 4;
};
/** A constant of RAY as options spell it. */
export type RayName = "hit" | "miss" | "truncated" | "evaluation-limit" | "not-finite";

/**
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
export declare const CSG: {
  /** everything inside any child */
  readonly UNION: 0;
  /** everything inside all children */
  readonly INTERSECTION: 1;
  /** the first child without all others */
  readonly DIFFERENCE: 2;
  /** everything outside its child; has one child */
  readonly COMPLEMENT: 3;
  /**
   * its child, grown outward by `distance`, or inward if that is negative; has one child. Exact where f is the
   * distance
   */
  readonly OFFSET: 4;
  /** its child as a hollow body with a wall of thickness `distance` inside the surface; has one child */
  readonly SHELL: 5;
  /** the field `model`; a leaf */
  readonly MODEL: 6;
  /** z <= 0; a leaf */
  readonly HALF_SPACE: 7;
  /** a box of the sides `size`, centred at the origin; a leaf */
  readonly BOX: 8;
  /** a ball of `radius` around the origin; a leaf */
  readonly SPHERE: 9;
  /** a cylinder of `radius` around the z axis, z from -height/2 to height/2; a leaf */
  readonly CYLINDER: 10;
  /**
   * a cone around the z axis, z from -height/2 to height/2, with `radius` at the lower end and `second_radius` at
   * the upper end; a leaf
   */
  readonly CONE: 11;
  /** a tube of `second_radius` around a circle of `radius` around the z axis; a leaf */
  readonly TORUS: 12;
};
/** A constant of CSG as options spell it. */
export type CsgName = "union" | "intersection" | "difference" | "complement" | "offset" | "shell" | "model" |
  "half-space" | "box" | "sphere" | "cylinder" | "cone" | "torus";

/**
 * The kind of a layer's marks.  Later versions may add kinds: treat an unknown one
 * like OWN.
 */
export declare const LAYER_KIND: {
  /** for styles only: layers of every kind */
  readonly ANY: 0;
  /** scattered marks */
  readonly STIPPLES: 1;
  /**
   * lines along a field of directions, which `guide` or direction_function gives. With BLUE_NOISE they are evenly
   * spaced and nested: lines of level 0 are the coarsest, and lines of each further level lie midway between all
   * before [Knoeppel et al. 2015]. With PUBLISHED they are strokes that grow from seeds, along the directions and
   * across them [NPAR 5]
   */
  readonly HATCH: 2;
  /** marks or strokes of the caller */
  readonly OWN: 3;
};
/** A constant of LAYER_KIND as options spell it. */
export type LayerKindName = "any" | "stipples" | "hatch" | "own";

/** How marks are distributed over a surface. */
export declare const DISTRIBUTION: {
  /**
   * stipples are evenly spread in a progressive order, every prefix of which is evenly spread; lines of HATCH are
   * evenly spaced and nested; the default. Where the surface bends within the spacing of stipples, a layer may
   * miss its budget by some marks in a thousand (docs/quality.md)
   */
  readonly BLUE_NOISE: 0;
  /**
   * the published recursion: each level has 5 times as many stipples, or 3 times as many marks of strokes, and
   * ranks are random [NPAR 5, 6.2]
   */
  readonly PUBLISHED: 1;
};
/** A constant of DISTRIBUTION as options spell it. */
export type DistributionName = "blue-noise" | "published";

/**
 * The directions that lines of HATCH follow without a direction_function.  Where the
 * directions have a low confidence, lines follow the smoothest field between.
 * PUBLISHED takes CURVATURE, COMBING or a direction_function; another guide is
 * INVALID_ARGUMENT.
 */
export declare const HATCH_GUIDE: {
  /** the direction in which the surface bends most. PUBLISHED: strokes along both principal directions, d1 and d2 */
  readonly CURVATURE: 0;
  /** Stark's combing direction r. PUBLISHED: strokes along r and u [NPAR 5.3] */
  readonly COMBING: 1;
  /** sections of the surface by planes perpendicular to `axis` */
  readonly SECTIONS: 2;
  /** the tangent part of guide_direction, which points to the light */
  readonly LIGHT: 3;
  /** the direction conjugate to guide_direction, which points to the eye: near the silhouette, lines run along it */
  readonly SILHOUETTE: 4;
};
/** A constant of HATCH_GUIDE as options spell it. */
export type HatchGuideName = "curvature" | "combing" | "sections" | "light" | "silhouette";

/** The seeds from which marks start. */
export declare const SEED: {
  /** the samples, if the model has them (for PUBLISHED: well-spread ones), else BOX */
  readonly AUTO: 0;
  /** the model's samples; INVALID_ARGUMENT for a model without samples */
  readonly SAMPLES: 1;
  /** a jittered grid in the bounds, projected onto the surface */
  readonly BOX: 2;
  /** seed_points, projected onto the surface */
  readonly POINTS: 3;
};
/** A constant of SEED as options spell it. */
export type SeedName = "auto" | "samples" | "box" | "points";

/** Where the strokes of PUBLISHED start. */
export declare const STROKE_START: {
  /** at the seeds */
  readonly SEEDS: 0;
  /** at the stipples up to level start_level */
  readonly STIPPLES: 1;
};
/** A constant of STROKE_START as options spell it. */
export type StrokeStartName = "seeds" | "stipples";

/** How densely the stipples of BLUE_NOISE lie. */
export declare const DENSITY: {
  /** the same number of stipples per area everywhere */
  readonly UNIFORM: 0;
  /**
   * more stipples where the surface bends: 1 - s + s c / (c + mean of c), where s is density_strength and c =
   * sqrt((k1^2 + k2^2) / 2)
   */
  readonly CURVATURE: 1;
  /** the density of density_function */
  readonly CALLBACK: 2;
};
/** A constant of DENSITY as options spell it. */
export type DensityName = "uniform" | "curvature" | "callback";

/** The tones in which layers appear, if they have no tone range of their own. */
export declare const TONE_RANGES: {
  /** each layer covers all tones */
  readonly FULL: 0;
  /**
   * the layers follow each other in the order of the list, each over an equal part of the tones (of PUBLISHED
   * strokes the first direction, then the second): cross-hatching builds up from light to dark
   */
  readonly IN_TURN: 1;
};
/** A constant of TONE_RANGES as options spell it. */
export type ToneRangesName = "full" | "in-turn";

/** What else is made for a layer. */
export declare const LAYER_WITH: {
  /** fill the attribute CURVATURE; PUBLISHED strokes along CURVATURE always have it */
  readonly CURVATURE: 1;
};
/** A constant of LAYER_WITH as options spell it. */
export type LayerWithName = "curvature";

/** The arrays of a layer, with one element for each mark or for each of its S strokes. */
export declare const MARK_ATTRIBUTE: {
  /** FLOAT32 x 3: the place, relative to hrbfnpr_point_set_info.origin */
  readonly POSITION: 0;
  /** FLOAT32 x 3: the normal; unit, outward */
  readonly NORMAL: 1;
  /**
   * FLOAT32 x 3: the direction along the stroke; unit, tangent. For a mark without a stroke: the u of its basis
   * [NPAR 5.2]
   */
  readonly DIRECTION: 2;
  /** FLOAT32 x 3: k1, k2 and confidence, as hrbfnpr_model_curvature gives them */
  readonly CURVATURE: 3;
  /**
   * FLOAT32: the rank u of [NPAR 6.2], in [0, 1): a mark is shown where u >= tone. All marks of a line of
   * BLUE_NOISE have the same rank
   */
  readonly RANK: 4;
  /**
   * UINT8: the refinement step that placed the mark; 0 = a seed. For HATCH of BLUE_NOISE: the level of its line
   * there (see HRBFNPR_LAYER_KIND_HATCH)
   */
  readonly LEVEL: 5;
  /**
   * UINT32 x 2: 2 * number + direction (0 or 1) of the stroke, and the mark's place along it. PUBLISHED: the
   * number is that of the seed, and places are 0 to 3^levels - 1 with the seed in the middle. Others: places are 0
   * to n - 1 from end to end. For a mark without a stroke: 2 * its number (PUBLISHED: of its seed), and 0
   */
  readonly STROKE: 6;
  /**
   * FLOAT32: the width as a factor of the style's radius, in (0, 1]; 1 in the middle of a stroke, less towards its
   * tapered ends; for front marks. Count 0 = all 1
   */
  readonly WIDTH: 7;
  /**
   * UINT32, S + 1 elements: stroke s has the marks order[first[s]] to order[first[s + 1] - 1] from end to end,
   * where order is STROKE_ORDER. Count 0 = a layer without strokes
   */
  readonly STROKE_FIRST: 8;
  /**
   * UINT32: numbers of marks, stroke by stroke. Count 0 = the marks themselves are in this order, as in every
   * layer except those of PUBLISHED
   */
  readonly STROKE_ORDER: 9;
  /**
   * FLOAT32 x 3: the unit normal that sets the tone with DEPTH_LAYERS, averaged over
   * hrbfnpr_layer_desc.tone_smoothing on the same sheet. NORMAL decides whether the mark faces the eye. Count 0 =
   * NORMAL
   */
  readonly TONE_NORMAL: 10;
};
/** A constant of MARK_ATTRIBUTE as options spell it. */
export type MarkAttributeName = "position" | "normal" | "direction" | "curvature" | "rank" | "level" | "stroke" |
  "width" | "stroke-first" | "stroke-order" | "tone-normal";

/**
 * Kinds of lines.  Those marked "once" are found when a line set is made, for each element of its list; the
 * others
 * with every drawing.  Strengths have no unit: lengths are in diagonals of the model.
 */
export declare const LINE_KIND: {
  /** occluding contours: the line of sight is tangent to the surface */
  readonly CONTOUR: 1;
  /**
   * where a contour would appear soon; strength: the derivative of the radial curvature towards the eye;
   * WITH_CURVATURE [DeCarlo 2003]
   */
  readonly SUGGESTIVE_CONTOUR: 2;
  /** once; strength: curvature across the ridge less that along it [Ohtake, Belyaev & Seidel 2004] */
  readonly RIDGE: 3;
  /** once; the same */
  readonly VALLEY: 4;
  /** strength: view-dependent curvature; WITH_CURVATURE [Judd 2007] */
  readonly APPARENT_RIDGE: 5;
  /** once; Gaussian curvature 0 */
  readonly PARABOLIC: 6;
  /** n . l = the levels of the style, l its light; WITH_CURVATURE */
  readonly ISOPHOTE: 7;
  /** once; parallel planes */
  readonly SECTION: 8;
  /** where the surface ends: at the search box, or beyond the last samples (hrbfnpr_line_set_desc.support) */
  readonly BORDER: 9;
  /** once; polylines of the caller, such as creases of a mesh */
  readonly OWN: 10;
  /**
   * where smooth sheets of the surface meet, of models that have such edges; found with the line set, in no list.
   * Strength: the angle between the sheets' normals, degrees. Where one of them faces the eye and the other does
   * not, a crease is a part of the CONTOUR and drawn as that
   */
  readonly CREASE: 11;
};
/** A constant of LINE_KIND as options spell it. */
export type LineKindName = "contour" | "suggestive-contour" | "ridge" | "valley" | "apparent-ridge" | "parabolic" |
  "isophote" | "section" | "border" | "own" | "crease";

export declare const LINE_SET_WITH: {
  /** measure curvatures and their derivatives, for kinds that need them with every drawing */
  readonly CURVATURE: 1;
};
/** A constant of LINE_SET_WITH as options spell it. */
export type LineSetWithName = "curvature";

/** Range of window depth from near to far plane. */
export declare const DEPTH: {
  /** clip space of OpenGL; written depth is 0 .. 1 */
  readonly NEGATIVE_ONE_TO_ONE: 0;
  /** Direct3D, Vulkan, Metal */
  readonly ZERO_TO_ONE: 1;
  /** 1 at the near plane, 0 at the far plane */
  readonly REVERSED: 2;
};
/** A constant of DEPTH as options spell it. */
export type DepthName = "negative-one-to-one" | "zero-to-one" | "reversed";

export declare const HIDDEN_LINES: {
  /** seen faintly through the surface in front [NPAR 6.1] */
  readonly ATTENUATE: 0;
  /** marks behind a nearer depth layer are not drawn */
  readonly HIDE: 1;
  /** as if nothing were in front (lambda = 0) */
  readonly SHOW: 2;
};
/** A constant of HIDDEN_LINES as options spell it. */
export type HiddenLinesName = "attenuate" | "hide" | "show";

export declare const VISIBILITY: {
  /**
   * Each mark of ink is seen through the depth layers of surface in front of it, which are found
   * from the marks: its opacity is multiplied by their transmittance.  A depth layer never dims its
   * own ink, and the picture does not depend on the number of marks.
   */
  readonly DEPTH_LAYERS: 0;
  /** As published: marks paint discs of paper and of ink, from far to near [NPAR 6.1]. */
  readonly PUBLISHED: 1;
};
/** A constant of VISIBILITY as options spell it. */
export type VisibilityName = "depth-layers" | "published";

export declare const TONE_CURVE: {
  /**
   * The coverage of the drawing is the tone that was asked for, 1 - tau: the number of marks
   * follows from their size, their density on the screen and how they overlap, so that the
   * tone stays when the zoom or the budget changes.  Where all marks together cover less than
   * 0.6, the tone 0.6 shows all of them and the others are paler alike.
   */
  readonly COVERAGE: 0;
  /** the share of marks is 1 - tau [NPAR 6.2] */
  readonly LINEAR: 1;
};
/** A constant of TONE_CURVE as options spell it. */
export type ToneCurveName = "coverage" | "linear";

export declare const TONE: {
  /** tau = 0: all front marks are shown */
  readonly NONE: 0;
  /** tau = max(0, n . l)^tone_exponent [NPAR 6.2], and fill_light */
  readonly LIGHT: 1;
  /** tau from tone_function */
  readonly CALLBACK: 2;
};
/** A constant of TONE as options spell it. */
export type ToneName = "none" | "light" | "callback";

export declare const TONE_RULE: {
  /**
   * A front mark is shown if u >= 1 - (1 - tau) * tau_d * scale * share: all effects thin
   * one and the same order of marks, so that a blue-noise order stays one.
   */
  readonly SHARE: 0;
  /** As published, test by test: u >= tau, u < tau_d, u < scale, u < share. */
  readonly PUBLISHED: 1;
};
/** A constant of TONE_RULE as options spell it. */
export type ToneRuleName = "share" | "published";

export declare const LIGHT: {
  readonly WORLD: 0;
  readonly CAMERA: 1;
};
/** A constant of LIGHT as options spell it. */
export type LightName = "world" | "camera";

/**
 * How the front marks of a layer of strokes are drawn.  Layers without strokes are dots; so is everything with
 * VISIBILITY_PUBLISHED.
 */
export declare const SHAPE: {
  /** each mark is a dot */
  readonly DOTS: 0;
  /**
   * marks that follow each other along a stroke, and are shown, are one line whose width and opacity are theirs; a
   * single one is a dot
   */
  readonly STROKES: 1;
  /**
   * strokes are curves, drawn where the tone is dark enough, and their width makes the tone: hatch_... of
   * hrbfnpr_layer_style. Of nested lines (those of level k midway between those of lower levels) as many levels
   * are drawn as the picture has room for, so that the tone does not depend on the zoom. Points of lines have the
   * id of the nearest mark; a stroke whose ends meet is closed. [Winkenbach & Salesin 1994; Praun et al. 2001]
   */
  readonly HATCH: 2;
};
/** A constant of SHAPE as options spell it. */
export type ShapeName = "dots" | "strokes" | "hatch";

/** What is drawn of the parts of a line that surface hides. */
export declare const HIDDEN_PARTS: {
  readonly NONE: 0;
  /** paler with each layer of surface (two sheets) before them */
  readonly ATTENUATED: 1;
  /** dashes, the shorter the more layers lie before them */
  readonly DASHED: 2;
  /** like what is visible */
  readonly SHOWN: 3;
};
/** A constant of HIDDEN_PARTS as options spell it. */
export type HiddenPartsName = "none" | "attenuated" | "dashed" | "shown";

/**
 * How a line ends where it ends in the picture without meeting another: at a cusp, where it turns behind its own
 * surface.
 */
export declare const CAP: {
  readonly ROUND: 0;
  readonly FLAT: 1;
  /** narrowing to a tip; the tip's length is twice the width there */
  readonly POINTED: 2;
};
/** A constant of CAP as options spell it. */
export type CapName = "round" | "flat" | "pointed";

/** Creases by the way that the surface bends there. */
export declare const CREASES: {
  readonly ALL: 0;
  /** edges */
  readonly CONVEX: 1;
  /** grooves, and where something stands on a face */
  readonly CONCAVE: 2;
};
/** A constant of CREASES as options spell it. */
export type CreasesName = "all" | "convex" | "concave";

/**
 * Named styles, each with a picture in docs/presets.md.  bindings/generate writes this list from
 * bindings/presets.py.
 */
export declare const PRESET: {
  /** stipples by light, no contours */
  readonly STIPPLE: 0;
  /** lines of one width, more of them where it is darker, and contours */
  readonly HATCH: 1;
  /** up to three sets of such lines, at 0, 35 and -30 degrees, a darker tone each, and contours */
  readonly CROSS_HATCH: 2;
  /** lines along Stark's combing direction, a second set in the darks, and contours */
  readonly COMBING: 3;
  /** contours only, hidden ones attenuated */
  readonly SILHOUETTE: 4;
  /** contours and stipples */
  readonly CONTOUR_AND_STIPPLE: 5;
  /** contours only, hidden ones shown */
  readonly XRAY: 6;
  /** stipples, cross hatching in the darks, contours and halo: Figure 1 (e) */
  readonly FULL: 7;
  /** one set of lines that swell with the tone, and contours; lights are empty */
  readonly ENGRAVING: 8;
  /** up to three sets of thin lines, at 0, 50 and -40 degrees, a darker tone each, and contours */
  readonly ETCHING: 9;
  /** few wide lines, which close up to black, and heavy contours */
  readonly WOODCUT: 10;
  /** fine stipples lit from the upper left, empty lights; outlines swell in the shade */
  readonly SCIENTIFIC_STIPPLE: 11;
  /** pencil on warm paper: two sets of lines that stray and run past their ends, contours drawn twice */
  readonly SKETCH: 12;
  /** pale lines on blue without tone: contours, borders, creases and lines called "crease", hidden ones dashed */
  readonly BLUEPRINT: 13;
  /**
   * lit from the upper left: short lines along curvature that taper to the light, heavy outlines, and the RIDGE
   * lines of a line set
   */
  readonly ARCHAEOLOGICAL: 14;
};
/** A constant of PRESET as options spell it. */
export type PresetName = "stipple" | "hatch" | "cross-hatch" | "combing" | "silhouette" | "contour-and-stipple" |
  "xray" | "full" | "engraving" | "etching" | "woodcut" | "scientific-stipple" | "sketch" | "blueprint" |
  "archaeological";

/** Which sides of an item's surface its marks are drawn on. */
export declare const SIDES: {
  /** that which the normals look to: a solid's inside is never seen */
  readonly FRONT: 0;
  /**
   * of a surface that ends, such as a bowl or a leaf, the other one, too, where it looks to the camera: with
   * opposite normals for tone. Such marks count twice in hrbfnpr_drawing_info, as of the front and of the back,
   * their ids are the same, and the drawing has their layers once more, behind those of all items. Lines are seen
   * from both sides anyway. With ATTENUATE a depth layer is as opaque as two, one that faces the camera and one
   * that faces away, as those of a solid before what it hides
   */
  readonly BOTH: 1;
};
/** A constant of SIDES as options spell it. */
export type SidesName = "front" | "both";

/** What a mark is for the camera. */
export declare const CLASS: {
  readonly NONE: 0;
  readonly FRONT: 1;
  readonly BACK: 2;
  readonly SILHOUETTE: 3;
};
/** A constant of CLASS as options spell it. */
export type ClassName = "none" | "front" | "back" | "silhouette";

export declare const RASTER: {
  /**
   * lay the drawing over the image's contents instead of replacing them inside the viewport; wants a style with
   * transparent paper
   */
  readonly OVER: 1;
  /** blend in linear light (sRGB decoded), not in encoded values */
  readonly LINEAR_LIGHT: 2;
};
/** A constant of RASTER as options spell it. */
export type RasterName = "over" | "linear-light";

export declare const PRIMITIVE: {
  /** the dots: one vertex each */
  readonly POINTS: 1;
  /** the strokes: one vertex for each of their points */
  readonly LINE_STRIPS: 2;
  /** the strokes: two for each point, on their left and right side */
  readonly TRIANGLE_STRIPS: 3;
};
/** A constant of PRIMITIVE as options spell it. */
export type PrimitiveName = "points" | "line-strips" | "triangle-strips";

/** Ends a strip in an array of indices. */
export declare const INDEX: {
  readonly RESTART: -1;
};
/** A constant of INDEX as options spell it. */
export type IndexName = "restart";

/** What a vertex can carry, and the types it can have. */
export declare const VERTEX_ATTRIBUTE: {
  /**
   * world, FLOAT32 x 3. Of marks and their line strips that of the mark; of lines, of hatching and of triangles
   * what is drawn, as exact as the window depth
   */
  readonly POSITION: 0;
  /** pixel x, pixel y, depth; FLOAT32 x 3 */
  readonly WINDOW: 1;
  /** pixels; FLOAT32 */
  readonly RADIUS: 2;
  /** straight RGBA; FLOAT32 x 4, or UINT8 x 4 */
  readonly COLOR: 3;
  /** world, unit; of lines 0; FLOAT32 x 3 */
  readonly NORMAL: 4;
  /** world, unit; of lines 0; FLOAT32 x 3 */
  readonly DIRECTION: 5;
  /** of the mark; 0 of lines; UINT32 */
  readonly ID: 6;
  /** HRBFNPR_CLASS_...; UINT8 or UINT32 */
  readonly CLASS: 7;
  /** 1 = a disc of paper, 0 = ink; UINT8 or UINT32 */
  readonly IS_PAPER: 8;
  /** of the drawing; UINT32 */
  readonly LAYER: 9;
  /** along its stroke, pixels from its first point; 0 for a dot; FLOAT32 */
  readonly LENGTH: 10;
  /** layers of surface before that part of a line, 0 = it is visible; 0 of marks; UINT32 */
  readonly HIDDEN_LAYERS: 11;
  /**
   * item of the nearest surface before that part of a line; HRBFNPR_INDEX_RESTART = it is visible, or a mark;
   * UINT32
   */
  readonly HIDDEN_BY: 12;
  /**
   * of lines: a number that a line keeps from one drawing of a renderer to the next, where the camera moves
   * little; 0 of all else; UINT32
   */
  readonly LINE: 13;
};
/** A constant of VERTEX_ATTRIBUTE as options spell it. */
export type VertexAttributeName = "position" | "window" | "radius" | "color" | "normal" | "direction" | "id" | "class"
  | "is-paper" | "layer" | "length" | "hidden-layers" | "hidden-by" | "line";

/**
 * Which components are kept.  A component is what hangs together by shared
 * vertices.
 */
export declare const PARTS: {
  /** all but those that lie inside a closed one: eyes in a head, inner shells */
  readonly OUTER: 0;
  /** all; one that lies inside an odd number of closed ones is a cavity if its faces say so, and is not turned */
  readonly ALL: 1;
  /** that of the largest area */
  readonly LARGEST: 2;
};
/** A constant of PARTS as options spell it. */
export type PartsName = "outer" | "all" | "largest";

/** What becomes of the order of a face's corners. */
export declare const FACES: {
  /** faces are turned to agree with their component, and closed components outward */
  readonly TURN: 0;
  /** as they are */
  readonly KEEP: 1;
};
/** A constant of FACES as options spell it. */
export type FacesName = "turn" | "keep";

export declare const MESH_ATTRIBUTE: {
  /** places, FLOAT64 x 3 */
  readonly VERTEX: 0;
  /** numbers of vertices, INT32 x 3, of each face */
  readonly TRIANGLE: 1;
  /** from 0, INT32 x 1, of each face */
  readonly COMPONENT: 2;
  /** the number that the face was given by, INT32 x 1 */
  readonly GIVEN_FACE: 3;
  /** unit normals of the three corners, FLOAT64 x 9, of each face */
  readonly CORNER_NORMAL: 4;
};
/** A constant of MESH_ATTRIBUTE as options spell it. */
export type MeshAttributeName = "vertex" | "triangle" | "component" | "given-face" | "corner-normal";

/** Which edges of a mesh are sharp. */
export declare const EDGES: {
  /**
   * sharp where the mesh has edges: they stand out, as those of machine parts do, from what is beside them; noise
   * and coarse faces of round shapes do not. Closed parts that cross are fitted apart, and meet in creases
   */
  readonly AUTO: 0;
  /** no edge is: a fit is one smooth surface, which rounds them */
  readonly SMOOTH: 1;
  /** sharp wherever faces meet at more than crease_angle */
  readonly SHARP: 2;
};
/** A constant of EDGES as options spell it. */
export type EdgesName = "auto" | "smooth" | "sharp";

export declare const PAGE_FORMAT: {
  /** 1.1; groups are layers of Inkscape */
  readonly SVG: 0;
  /** 1.5; groups are optional content, which viewers list as layers */
  readonly PDF: 1;
  /** for plotters: absolute, 40 units a millimetre, y up from the lower left corner */
  readonly HPGL: 2;
  /** for plotters: G0 and G1, millimetres, y up from the lower left corner */
  readonly GCODE: 3;
};
/** A constant of PAGE_FORMAT as options spell it. */
export type PageFormatName = "svg" | "pdf" | "hpgl" | "gcode";

/** How strokes are written whose width varies. */
export declare const WIDTHS: {
  /** filled outlines; SVG and PDF */
  readonly OUTLINES: 0;
  /** lines of even widths, `width_step` apart */
  readonly CLASSES: 1;
};
/** A constant of WIDTHS as options spell it. */
export type WidthsName = "outlines" | "classes";

/** How dots are written. */
export declare const DOT_SHAPE: {
  /** circles; plotters fill them, with SINGLE_PASS draw round them */
  readonly CIRCLES: 0;
  /** lines of no length with round ends; plotters touch the paper */
  readonly LINES: 1;
  /** spirals that a pen fills the disc with, if it is wider than the pen */
  readonly SPIRALS: 2;
};
/** A constant of DOT_SHAPE as options spell it. */
export type DotShapeName = "circles" | "lines" | "spirals";

export declare const PAGE: {
  /**
   * groups are sorted so that a pen travels little, as HPGL and GCODE always are: greedily, then by 2-opt and Or-
   * opt; lines may be turned round, closed ones begin elsewhere, and lines whose ends are nearer than `join`
   * become one
   */
  readonly IN_PLOT_ORDER: 1;
  /**
   * a line that is wider than its pen is drawn once, along its centre; else, with HPGL and GCODE and with pens in
   * plot order, it is filled: by passes side by side, 0.8 of the pen's width apart or a little less, each only
   * where the line is so wide. A line up to 1.2 times as wide as the pen takes one
   */
  readonly SINGLE_PASS: 4;
  /**
   * else the page has the paper of its first drawing, white without one, and other drawings with another paper
   * theirs; plotters draw none
   */
  readonly WITHOUT_PAPER: 2;
};
/** A constant of PAGE as options spell it. */
export type PageName = "in-plot-order" | "single-pass" | "without-paper";

/**
 * Kinds of lines by the numbers of ISO 128-2.  In line widths a dot is 0.5, the three kinds of dashes 6, 12 and
 * 24,
 * a gap 3, a space 18; a little more or less, so that lines begin and end with a dash.
 */
export declare const LINE_TYPE: {
  readonly AS_DRAWN: 0;
  readonly CONTINUOUS: 1;
  /** hidden edges */
  readonly DASHED: 2;
  readonly DASHED_SPACED: 3;
  /** axes */
  readonly LONG_DASHED_DOTTED: 4;
  readonly LONG_DASHED_DOUBLE_DOTTED: 5;
  readonly LONG_DASHED_TRIPLE_DOTTED: 6;
  readonly DOTTED: 7;
  readonly LONG_DASHED_SHORT_DASHED: 8;
  readonly LONG_DASHED_DOUBLE_SHORT_DASHED: 9;
  readonly DASHED_DOTTED: 10;
  readonly DOUBLE_DASHED_DOTTED: 11;
  readonly DASHED_DOUBLE_DOTTED: 12;
  readonly DOUBLE_DASHED_DOUBLE_DOTTED: 13;
  readonly DASHED_TRIPLE_DOTTED: 14;
  readonly DOUBLE_DASHED_TRIPLE_DOTTED: 15;
};
/** A constant of LINE_TYPE as options spell it. */
export type LineTypeName = "as-drawn" | "continuous" | "dashed" | "dashed-spaced" | "long-dashed-dotted" |
  "long-dashed-double-dotted" | "long-dashed-triple-dotted" | "dotted" | "long-dashed-short-dashed" |
  "long-dashed-double-short-dashed" | "dashed-dotted" | "double-dashed-dotted" | "dashed-double-dotted" |
  "double-dashed-double-dotted" | "dashed-triple-dotted" | "double-dashed-triple-dotted";

export declare const SOURCE: {
  /** `sharp_edges` is known, even if it is empty */
  readonly HAS_SHARP_EDGES: 1;
  /** `viewpoint` is known */
  readonly HAS_VIEWPOINT: 2;
  /** the points are one picture of a depth camera that stood at `viewpoint` */
  readonly IS_PHOTO: 4;
};
/** A constant of SOURCE as options spell it. */
export type SourceName = "has-sharp-edges" | "has-viewpoint" | "is-photo";

export declare const PICTURE: {
  /** drawing what can hardly be seen is no error */
  readonly ALLOW_BLANK: 1;
  /** all normals are turned, whatever they look like */
  readonly FLIP: 2;
  /** the surface goes on beyond open data, as the fit has it */
  readonly CLOSE: 4;
  /** an open mesh is one surface, also where its parts cross */
  readonly TOGETHER: 8;
  /** the paper lets all through */
  readonly TRANSPARENT: 16;
  /** layers have all their marks, also where the style draws lines alone: for marks that are saved */
  readonly KEEP_MARKS: 32;
  /** no camera is chosen, no marks are placed, no lines are looked for: for the model alone */
  readonly SURFACE_ONLY: 64;
  /** nothing is said of a source that is a part of a solid, and no up is looked for */
  readonly IS_SOLID: 128;
};
/** A constant of PICTURE as options spell it. */
export type PictureName = "allow-blank" | "flip" | "close" | "together" | "transparent" | "keep-marks" |
  "surface-only" | "is-solid";

/** The edges of a mesh. */
export declare const PICTURE_EDGES: {
  /** as AUTO; where faces are coarse as the normals of the file tell, if they do */
  readonly AS_GIVEN: 0;
  /** HRBFNPR_EDGES_AUTO */
  readonly AUTO: 1;
  /** HRBFNPR_EDGES_SMOOTH */
  readonly SMOOTH: 2;
  /** HRBFNPR_EDGES_SHARP, with `edge_angle` */
  readonly SHARP: 3;
};
/** A constant of PICTURE_EDGES as options spell it. */
export type PictureEdgesName = "as-given" | "auto" | "smooth" | "sharp";

export declare const PROFILE: {
  /** YES of the style archaeological, else NO */
  readonly AUTO: 0;
  /** an upright section through the middle stands beside the drawing */
  readonly YES: 1;
  readonly NO: 2;
};
/** A constant of PROFILE as options spell it. */
export type ProfileName = "auto" | "yes" | "no";

export declare const PICTURE_SIDES: {
  /** both of a surface that ends, else the front */
  readonly AUTO: 0;
  /** HRBFNPR_SIDES_FRONT */
  readonly FRONT: 1;
  /** HRBFNPR_SIDES_BOTH */
  readonly BOTH: 2;
};
/** A constant of PICTURE_SIDES as options spell it. */
export type PictureSidesName = "auto" | "front" | "both";

/** How notes and errors name the options that they speak of. */
export declare const WORDING: {
  /** samples 400 */
  readonly FIELDS: 0;
  /** --samples 400, of a command line */
  readonly OPTIONS: 1;
  /** samples=400, of a call in Python */
  readonly ARGUMENTS: 2;
};
/** A constant of WORDING as options spell it. */
export type WordingName = "fields" | "options" | "arguments";

/** A stroke of a brush on the surface: within its radius what is painted goes towards a value. */
export declare const DAB: {
  readonly TONE: 0;
  readonly DENSITY: 1;
  readonly DIRECTION: 2;
};
/** A constant of DAB as options spell it. */
export type DabName = "tone" | "density" | "direction";

/** The parts of the work. */
export declare const STAGE: {
  /** looking at a mesh: welding, turning faces */
  readonly MESH: 1;
  /** choosing samples */
  readonly SAMPLE: 2;
  /** looking for normals */
  readonly ORIENT: 3;
  /** the image of a depth camera */
  readonly SMOOTH: 4;
  readonly FIT: 5;
  /** the surface with the mesh */
  readonly COMPARE: 6;
  /** looking for the end of the surface */
  readonly END: 7;
  /** placing marks */
  readonly MARKS: 8;
  /** looking for lines */
  readonly LINES: 9;
  /** drawing */
  readonly FRAME: 10;
  /** drawing the views of a sheet */
  readonly VIEWS: 11;
};
/** A constant of STAGE as options spell it. */
export type StageName = "mesh" | "sample" | "orient" | "smooth" | "fit" | "compare" | "end" | "marks" | "lines" |
  "frame" | "views";

export declare const SEVERITY: {
  /** a measurement */
  readonly INFO: 0;
  /** what was chosen, repaired or left out */
  readonly NOTE: 1;
  /** the result may be wrong there */
  readonly WARNING: 2;
  /** there is no result: the error of the call, in full length */
  readonly FAILURE: 3;
};
/** A constant of SEVERITY as options spell it. */
export type SeverityName = "info" | "note" | "warning" | "failure";

/** Notes.  In brackets the figures of each. */
export declare const NOTE: {
  /** left out [faces] */
  readonly FACES_NOT_FINITE: 1;
  /** points at a value that stands for none, left out [points, value] */
  readonly NO_DATA: 2;
  /** points far from all others, left out [points] */
  readonly STRAYS: 3;
  /** so many that only some get normals [points, used] */
  readonly SOME_ORIENTED: 4;
  /** there were none [points] */
  readonly NORMALS_MADE: 5;
  /** [confidence] */
  readonly NORMALS_NOT_SURE: 6;
  /** which side of an open surface is its front */
  readonly FRONT_NOT_TOLD: 7;
  /** [points, used] */
  readonly SAMPLES_CHOSEN: 8;
  /** without a position or normal, left out [points] */
  readonly POINTS_NOT_USABLE: 9;
  /** several at one place: their mean [places] */
  readonly NORMALS_JOINED: 10;
  /** opposite ones at one place, left out [places] */
  readonly NORMALS_OPPOSITE: 11;
  /** it looked down [axis] */
  readonly TERRAIN_TURNED: 12;
  /** all looked inward */
  readonly NORMALS_TURNED: 13;
  /** [turned, made, what they were: HRBFNPR_NORMALS_...] */
  readonly NORMALS_REPAIRED: 14;
  /** those around them [normals, of] */
  readonly NORMALS_AGAINST: 15;
  /** some parts outward, others inward [share] */
  readonly NORMALS_MIXED: 16;
  /** most of an open surface */
  readonly NORMALS_INWARD: 17;
  readonly VIEWPOINT_NOT_USED: 18;
  /** of a depth camera, on no surface [pixels] */
  readonly PIXELS_LEFT_OUT: 19;
  /** [noise, depth] */
  readonly DEPTH_NOISE: 20;
  /** the samples have noise, and the surface does not go through all */
  readonly SMOOTHED: 21;
  /** at the same place [samples] */
  readonly SAMPLES_MERGED: 22;
  /** merged with another very near [samples] */
  readonly SAMPLES_NEAR: 23;
  /** as strays [samples] */
  readonly SAMPLES_DROPPED: 24;
  /** with a flipped normal, repaired [samples] */
  readonly SAMPLES_FLIPPED: 25;
  /** samples that look so, and stay [samples] */
  readonly LIKE_STRAYS: 26;
  /** samples that look so, and stay [samples] */
  readonly LIKE_FLIPPED: 27;
  /** the surface is a guess [points] */
  readonly FEW_POINTS: 28;
  /** all points */
  readonly ON_A_LINE: 29;
  /** all points */
  readonly IN_A_PLANE: 30;
  /** the points: the surface between them is drawn, too */
  readonly ALONG_CURVES: 31;
  /** where the surface ends */
  readonly END_NOT_FOUND: 32;
  /** another direction than y [x, y, z] */
  readonly UP: 33;
  /** against those beside them [faces] */
  readonly FACES_TURNED: 34;
  /** a mesh, or parts of it, turned [parts] */
  readonly INSIDE_OUT: 35;
  /** without area, or twice there [faces] */
  readonly FACES_LEFT_OUT: 36;
  /** others, left out [parts, faces] */
  readonly PARTS_INSIDE: 37;
  /** a surface of one side, or one that crosses itself [edges] */
  readonly CONTRARY_EDGES: 38;
  /** from all others, left out [parts, faces] */
  readonly PARTS_FAR: 39;
  /** faces on an edge of two others, left out [faces] */
  readonly FLAPS: 40;
  /** by the normals of the file */
  readonly ALL_FLAT: 41;
  /** some edges are sharp by the normals of the file */
  readonly EDGES_BY_NORMALS: 42;
  /** faces [times, vertices moved, places between them raised, off a round surface; shares of the diagonal] */
  readonly DIVIDED: 43;
  /** faces are coarse, but nothing round goes through them */
  readonly COARSE_FLAT: 44;
  /** parts that cross are surfaces of their own [parts, groups] */
  readonly GROUPS: 45;
  /** the tolerance [tolerance, share of the mesh, share of the surface, farthest; of the diagonal] */
  readonly NOT_REACHED: 46;
  /** [their length in diagonals] */
  readonly EDGES_STAY_SMOOTH: 47;
  /** the surface, at a share of the mesh [share, farthest] */
  readonly OFF_MESH: 48;
  /** parts of surface that the mesh does not have, left out [parts] */
  readonly MADE_BY_FIT: 49;
  /** parts of a mesh that the tolerance is too large for */
  readonly PARTS_TOO_THIN: 50;
  /** fewer than fill the darkest tone [wanted, made] */
  readonly MARKS_LIMITED: 51;
  /** of the published recursion [wanted, taken] */
  readonly LEVELS_LIMITED: 52;
  /** the depth camera's [azimuth] */
  readonly SEEN_FROM_CAMERA: 53;
  /** of an open surface [azimuth] */
  readonly SEEN_FROM_FRONT: 54;
  /** lines want a model, and the source is a point set */
  readonly NO_LINES_OF_MARKS: 55;
  /** the surface is thinner than the cells that lines are looked for in [triangles turned, of, samples missed] */
  readonly LINES_THIN: 56;
  /** where the surface ends beyond its samples [borders, support, share] */
  readonly LINES_END: 57;
  /** curves that end inside the surface [curves] */
  readonly LINES_BROKEN: 58;
  /** lines whose visibility contradicts itself [lines] */
  readonly LINES_DOUBTED: 59;
  /** places with too many crossings of lines [places] */
  readonly LINES_TANGLED: 60;
  /** hardly anything can be seen [shown, marks, share of ink] */
  readonly BLANK: 61;
  /** that were chosen by the widths at hand */
  readonly PENS: 62;
  /** [metres drawn, metres travelled, seconds] */
  readonly PLOTTED: 63;
  /** what settings do not hold */
  readonly NOT_IN_SETTINGS: 64;
  /** of the format */
  readonly UNIT_IS_METRE: 65;
  /** for centre lines */
  readonly NO_SYMMETRY: 66;
  /** outlines of a cut that are not closed [outlines] */
  readonly SECTION_OPEN: 67;
  /** made of length 1 [normals] */
  readonly NORMALS_NOT_UNIT: 68;
  /** all points */
  readonly AT_ONE_PLACE: 69;
  /** for the source's size */
  readonly FAR_FROM_ORIGIN: 70;
  /** at the place of another [vertices] */
  readonly VERTICES_JOINED: 71;
  /** of no face, left out [vertices] */
  readonly VERTICES_UNUSED: 72;
  /** of more than two faces [edges] */
  readonly NONMANIFOLD_EDGES: 73;
  /** [borders, their edges] */
  readonly MESH_OPEN: 74;
  /** of a mesh [parts] */
  readonly SEVERAL_PARTS: 75;
  /** why a source cannot be drawn */
  readonly NOT_USABLE: 76;
};
/** A constant of NOTE as options spell it. */
export type NoteName = "faces-not-finite" | "no-data" | "strays" | "some-oriented" | "normals-made" |
  "normals-not-sure" | "front-not-told" | "samples-chosen" | "points-not-usable" | "normals-joined" |
  "normals-opposite" | "terrain-turned" | "normals-turned" | "normals-repaired" | "normals-against" | "normals-mixed"
  | "normals-inward" | "viewpoint-not-used" | "pixels-left-out" | "depth-noise" | "smoothed" | "samples-merged" |
  "samples-near" | "samples-dropped" | "samples-flipped" | "like-strays" | "like-flipped" | "few-points" | "on-a-line"
  | "in-a-plane" | "along-curves" | "end-not-found" | "up" | "faces-turned" | "inside-out" | "faces-left-out" |
  "parts-inside" | "contrary-edges" | "parts-far" | "flaps" | "all-flat" | "edges-by-normals" | "divided" |
  "coarse-flat" | "groups" | "not-reached" | "edges-stay-smooth" | "off-mesh" | "made-by-fit" | "parts-too-thin" |
  "marks-limited" | "levels-limited" | "seen-from-camera" | "seen-from-front" | "no-lines-of-marks" | "lines-thin" |
  "lines-end" | "lines-broken" | "lines-doubted" | "lines-tangled" | "blank" | "pens" | "plotted" | "not-in-settings"
  | "unit-is-metre" | "no-symmetry" | "section-open" | "normals-not-unit" | "at-one-place" | "far-from-origin" |
  "vertices-joined" | "vertices-unused" | "nonmanifold-edges" | "mesh-open" | "several-parts" | "not-usable";

/** What it is. */
export declare const SOURCE_KIND: {
  readonly POINTS: 1;
  readonly MESH: 2;
  readonly MODEL: 3;
  readonly POINT_SET: 4;
};
/** A constant of SOURCE_KIND as options spell it. */
export type SourceKindName = "points" | "mesh" | "model" | "point-set";

/** Which way normals look. */
export declare const NORMALS_LOOK: {
  /** there are none, or the source cannot be drawn */
  readonly UNKNOWN: 0;
  readonly OUTWARD: 1;
  readonly INWARD: 2;
  /** some outward, others inward */
  readonly MIXED: 3;
  /** they agree, and the surface encloses nothing */
  readonly OPEN: 4;
  /** they belong to other points; told of points along curves */
  readonly FOREIGN: 5;
};
/** A constant of NORMALS_LOOK as options spell it. */
export type NormalsLookName = "unknown" | "outward" | "inward" | "mixed" | "open" | "foreign";

export declare const VIEWS: {
  /**
   * planes of symmetry through the middle have a centre line in each view that sees them as a line; a note
   * NO_SYMMETRY says that there are none
   */
  readonly CENTRE_LINES: 1;
  /** the name of each view stands above it; that of a section always does */
  readonly LABELS: 2;
  /** the format of the source is in metres, as glTF: a unit_mm of 0 is 1000, with a note UNIT_IS_METRE */
  readonly UNIT_IS_METRE: 4;
};
/** A constant of VIEWS as options spell it. */
export type ViewsName = "centre-lines" | "labels" | "unit-is-metre";

/** Where views stand [ISO 5456-2]. */
export declare const VIEWS_ANGLE: {
  /** first angle: the left view at the right, the top view below */
  readonly FIRST: 0;
  /** third angle: the left view at the left, the top view above */
  readonly THIRD: 1;
};
/** A constant of VIEWS_ANGLE as options spell it. */
export type ViewsAngleName = "first" | "third";

/** Hidden edges.  Sections never have any [ISO 128-3]. */
export declare const VIEWS_HIDDEN: {
  /** dashed thin lines */
  readonly DASHED: 0;
  /** they are not drawn */
  readonly NONE: 1;
  /** continuous thin lines */
  readonly SHOWN: 2;
};
/** A constant of VIEWS_HIDDEN as options spell it. */
export type ViewsHiddenName = "dashed" | "none" | "shown";

export declare const GROUPS: Readonly<Record<string, Readonly<Record<string, number>>>>;
