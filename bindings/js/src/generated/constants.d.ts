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
/** The constants of VERSION, as options spell them. */
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
/** The constants of STATUS, as options spell them. */
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
/** The constants of SCALAR, as options spell them. */
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
/** The constants of FORMAT, as options spell them. */
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
/** The constants of LOG, as options spell them. */
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
/** The constants of INSTRUCTION_SET, as options spell them. */
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
/** The constants of THREAD_BACKEND, as options spell them. */
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
/** The constants of KERNEL, as options spell them. */
export type KernelName = "triharmonic" | "gaussian" | "wendland-c2" | "custom" | "csg";

/** How the linear system of a fit is solved.  docs/how-fitting-works.md explains both ways. */
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
/** The constants of SOLVER, as options spell them. */
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
/** The constants of SOLVER_REASON, as options spell them. */
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
/** The constants of REPAIR, as options spell them. */
export type RepairName = "keep" | "drop" | "reorient";

/** Where the regularization of a fit comes from. */
export declare const REGULARIZATION: {
  /** the field `regularization` */
  readonly GIVEN: 0;
  /** the measured noise of the samples; 0 for samples without noise */
  readonly AUTO: 1;
};
/** The constants of REGULARIZATION, as options spell them. */
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
/** The constants of NORMALS, as options spell them. */
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
/** The constants of TRIM, as options spell them. */
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
/** The constants of OUTWARD, as options spell them. */
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
/** The constants of CUSTOM, as options spell them. */
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
/** The constants of MODEL_ATTRIBUTE, as options spell them. */
export type ModelAttributeName = "position" | "normal" | "residual-history";

/** What became of a projected point. */
export declare const PROJECTION: {
  /** the point is on the surface, within the tolerance */
  readonly CONVERGED: 0;
  /** the evaluation limit was reached, or no step lowers f^2 */
  readonly NOT_CONVERGED: 1;
  /** the point is stuck off the surface, where the gradient vanishes */
  readonly ZERO_GRADIENT: 2;
  /** f or its gradient is not finite, or the gradient exceeds 1e150 */
  readonly NOT_FINITE: 3;
};
/** The constants of PROJECTION, as options spell them. */
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
/** The constants of RAY, as options spell them. */
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
/** The constants of CSG, as options spell them. */
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
/** The constants of LAYER_KIND, as options spell them. */
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
/** The constants of DISTRIBUTION, as options spell them. */
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
/** The constants of HATCH_GUIDE, as options spell them. */
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
/** The constants of SEED, as options spell them. */
export type SeedName = "auto" | "samples" | "box" | "points";

/** Where the strokes of PUBLISHED start. */
export declare const STROKE_START: {
  /** at the seeds */
  readonly SEEDS: 0;
  /** at the stipples up to level start_level */
  readonly STIPPLES: 1;
};
/** The constants of STROKE_START, as options spell them. */
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
  /** the density of density_field */
  readonly FIELD: 3;
};
/** The constants of DENSITY, as options spell them. */
export type DensityName = "uniform" | "curvature" | "callback" | "field";

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
/** The constants of TONE_RANGES, as options spell them. */
export type ToneRangesName = "full" | "in-turn";

/** What else is made for a layer. */
export declare const LAYER_WITH: {
  /** fill the attribute CURVATURE; PUBLISHED strokes along CURVATURE always have it */
  readonly CURVATURE: 1;
};
/** The constants of LAYER_WITH, as options spell them. */
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
/** The constants of MARK_ATTRIBUTE, as options spell them. */
export type MarkAttributeName = "position" | "normal" | "direction" | "curvature" | "rank" | "level" | "stroke" |
  "width" | "stroke-first" | "stroke-order" | "tone-normal";

/**
 * Kinds of lines.  Kinds marked "once" are found when the line set is made, for each element of
 * hrbfnpr_line_set_desc.lines.  BORDER and CREASE are found then, too, without an element.  All others are found
 * for
 * every drawing, except SHADOW and TERMINATOR, which are found with a shading.  The strength says how marked a
 * line is
 * at a place.  It has no unit, because lengths are measured in diagonals of the model.  Kinds marked
 * WITH_CURVATURE
 * need a line set with that flag.
 */
export declare const LINE_KIND: {
  /** occluding contours: the line of sight is tangent to the surface there */
  readonly CONTOUR: 1;
  /**
   * curves that become contours in a nearby view; WITH_CURVATURE. Strength: the derivative of the radial curvature
   * towards the eye [DeCarlo et al. 2003]
   */
  readonly SUGGESTIVE_CONTOUR: 2;
  /**
   * convex ridges; once. Strength: the curvature across the ridge minus the absolute value of the one along it
   * [Ohtake, Belyaev & Seidel 2004]
   */
  readonly RIDGE: 3;
  /** concave valleys; once. The strength is that of ridges */
  readonly VALLEY: 4;
  /**
   * extrema of the view-dependent curvature, which is also the strength; WITH_CURVATURE [Judd, Durand & Adelson
   * 2007]
   */
  readonly APPARENT_RIDGE: 5;
  /** curves of Gaussian curvature 0; once */
  readonly PARABOLIC: 6;
  /**
   * curves on which n . l is one of the line style's `levels`, n the normal and l the direction to the style's
   * light; WITH_CURVATURE
   */
  readonly ISOPHOTE: 7;
  /** cuts of the surface by parallel planes; once */
  readonly SECTION: 8;
  /** curves where the surface ends: at the search box, or beyond the last samples (hrbfnpr_line_set_desc.support) */
  readonly BORDER: 9;
  /** polylines of the caller, such as creases of a mesh; once */
  readonly OWN: 10;
  /**
   * edges and grooves in which smooth sheets of the surface meet, in models that have them. Strength: the angle
   * between the normals of both sheets, in degrees. Where one sheet faces the eye and the other faces away, the
   * crease is part of the CONTOUR and is drawn as CONTOUR
   */
  readonly CREASE: 11;
  /**
   * borders of the shadows that fall on the item, of lights with a shadow; for items whose shading has
   * HRBFNPR_SHADING_WITH_LINES. Strength: the light's `shadow`
   */
  readonly SHADOW: 12;
  /**
   * borders between light and shade where the item turns away from a light with a shadow, n . l = 0, and nothing
   * else shades the place; as SHADOW
   */
  readonly TERMINATOR: 13;
  /**
   * edges and folds that are round, such as the worn rim of a base; once. Strength: the angle by which the surface
   * turns within a few cells of the line, less the turns beside that, in degrees. Organic bumps, limbs and noise
   * have none. `fade` of a line style makes the line narrower and not paler
   */
  readonly SOFT_EDGE: 14;
  /**
   * curves in which the surface of the item crosses that of another item with a line set. If both items draw them,
   * they are lines of the item with the smaller mesh cells. Parts of one model meet in CREASEs. Strength: the mean
   * angle between both surfaces along a curve, in degrees; `upper` and `fade` have no effect
   */
  readonly INTERSECTION: 15;
  /**
   * edges of a part along which two surfaces touch without a kink, such as those of a fillet; once. The caller
   * gives them as polylines, as OWN. hrbfnpr_mesh_edges finds them in a mesh
   */
  readonly TANGENT_EDGE: 16;
};
/** The constants of LINE_KIND, as options spell them. */
export type LineKindName = "contour" | "suggestive-contour" | "ridge" | "valley" | "apparent-ridge" | "parabolic" |
  "isophote" | "section" | "border" | "own" | "crease" | "shadow" | "terminator" | "soft-edge" | "intersection" |
  "tangent-edge";

/** What a line set measures. */
export declare const LINE_SET_WITH: {
  /** measures curvatures and their derivatives, which suggestive contours, apparent ridges and isophotes need */
  readonly CURVATURE: 1;
};
/** The constants of LINE_SET_WITH, as options spell them. */
export type LineSetWithName = "curvature";

/** How depth runs from the near plane to the far plane. */
export declare const DEPTH: {
  /** clip depth from -1 to 1, as in OpenGL; window depth from 0 to 1 */
  readonly NEGATIVE_ONE_TO_ONE: 0;
  /** clip and window depth from 0 to 1, as in Direct3D, Vulkan and Metal */
  readonly ZERO_TO_ONE: 1;
  /** clip and window depth from 1 at the near plane to 0 at the far plane */
  readonly REVERSED: 2;
};
/** The constants of DEPTH, as options spell them. */
export type DepthName = "negative-one-to-one" | "zero-to-one" | "reversed";

/** How ink is drawn that lies behind a depth layer of surface. */
export declare const HIDDEN_LINES: {
  /** ink is seen faintly through the surface in front of it [NPAR 6.1] */
  readonly ATTENUATE: 0;
  /** ink behind a nearer depth layer is not drawn */
  readonly HIDE: 1;
  /** ink is drawn as if nothing were in front of it: lambda is 0 */
  readonly SHOW: 2;
};
/** The constants of HIDDEN_LINES, as options spell them. */
export type HiddenLinesName = "attenuate" | "hide" | "show";

/** How the marks that a surface hides are found. */
export declare const VISIBILITY: {
  /**
   * Depth layers of surface are found from the marks.  The ink of each mark is multiplied by the transmittance of
   * the
   * layers in front of it.  A depth layer never dims its own ink.  The picture does not depend on the number of
   * marks.
   */
  readonly DEPTH_LAYERS: 0;
  /** Marks paint discs of paper and of ink from far to near, as published [NPAR 6.1]. */
  readonly PUBLISHED: 1;
};
/** The constants of VISIBILITY, as options spell them. */
export type VisibilityName = "depth-layers" | "published";

/** How many marks a tone shows. */
export declare const TONE_CURVE: {
  /**
   * The ink covers the share 1 - tau of the paper.  The number of marks follows from their size, their density in
   * the
   * picture and their overlap, so that the tone stays when the zoom or the budget changes.  If all marks together
   * cover less than 0.6, all of them are shown where 0.6 is asked for, and fewer in proportion where less is asked
   * for.
   */
  readonly COVERAGE: 0;
  /** the share of marks that is shown is 1 - tau [NPAR 6.2] */
  readonly LINEAR: 1;
};
/** The constants of TONE_CURVE, as options spell them. */
export type ToneCurveName = "coverage" | "linear";

/**
 * Where stipples are evenly spread, with TONE_RULE_SHARE, TONE_CURVE_COVERAGE and DEPTH_LAYERS.  It has an
 * effect on
 * stipples of DISTRIBUTION_BLUE_NOISE.
 */
export declare const EVENNESS: {
  /**
   * In the picture.  Where the surface turns away, marks that are even on it would form rows.  So more marks than
   * the
   * tone wants are considered there, in their order, and each gets smaller as far as earlier ones are too near in
   * the picture.  Marks keep their places on the surface, change smoothly as the camera moves, and never get
   * smaller
   * by a zoom in.  docs/how-marks-work.md
   */
  readonly PICTURE: 0;
  /**
   * On the surface: the first marks of the order are shown.  For drawings that show the same marks by other means,
   * such as the prefixes of a vertex buffer.
   */
  readonly SURFACE: 1;
};
/** The constants of EVENNESS, as options spell them. */
export type EvennessName = "picture" | "surface";

/** What the tone tau of a front mark comes from: 1 = light, 0 = dark. */
export declare const TONE: {
  /** tau = 0: all front marks are shown */
  readonly NONE: 0;
  /** tau = max(0, n . l)^tone_exponent [NPAR 6.2], and fill_light on the unlit side */
  readonly LIGHT: 1;
  /** tau is what tone_function returns */
  readonly CALLBACK: 2;
};
/** The constants of TONE, as options spell them. */
export type ToneName = "none" | "light" | "callback";

/**
 * Which front marks are shown. u is the rank of a mark, tau its tone, tau_d the tone of its distance (depth_min,
 * depth_max), scale that of its zoom (zoom_reference), and share that of the layer style.
 */
export declare const TONE_RULE: {
  /**
   * A mark is shown if u >= 1 - (1 - tau) * tau_d * scale * share.  All effects thin the same order of marks, so
   * that
   * a blue-noise order stays one.
   */
  readonly SHARE: 0;
  /** A mark is shown if it passes each test, as published: u >= tau, u < tau_d, u < scale, u < share [NPAR 6.2]. */
  readonly PUBLISHED: 1;
};
/** The constants of TONE_RULE, as options spell them. */
export type ToneRuleName = "share" | "published";

/** The space in which the direction to the light, or its place, is given. */
export declare const LIGHT: {
  /** world space: the light stays where it is when the camera moves */
  readonly WORLD: 0;
  /** eye space: the light moves with the camera */
  readonly CAMERA: 1;
  /** object space: the light moves with the item */
  readonly ITEM: 2;
};
/** The constants of LIGHT, as options spell them. */
export type LightName = "world" | "camera" | "item";

/** Where a light comes from. */
export declare const LIGHT_KIND: {
  /** from far away, everywhere from the same direction */
  readonly DIRECTIONAL: 0;
  /** from a place; its strength does not fall with the distance */
  readonly PLACE: 1;
};
/** The constants of LIGHT_KIND, as options spell them. */
export type LightKindName = "directional" | "place";

/**
 * How the front marks of a layer of strokes are drawn.  Layers without strokes are always dots, and so is
 * everything
 * with VISIBILITY_PUBLISHED.
 */
export declare const SHAPE: {
  /** each mark is a dot */
  readonly DOTS: 0;
  /**
   * consecutive marks of a stroke that are shown form one line, with their width and opacity. A single mark is a
   * dot
   */
  readonly STROKES: 1;
  /**
   * strokes are curves that are drawn where the tone is dark enough, and their width makes the tone. The hatch_
   * fields of hrbfnpr_layer_style apply. Lines are nested: those of level k lie midway between those of lower
   * levels. As many levels are drawn as the picture has room for, so that the tone does not depend on the zoom.
   * Points of a line have the id of the nearest mark. A stroke whose ends meet is closed [Winkenbach & Salesin
   * 1994; Praun et al. 2001]
   */
  readonly HATCH: 2;
};
/** The constants of SHAPE, as options spell them. */
export type ShapeName = "dots" | "strokes" | "hatch";

/** What tone_field does to the tone. */
export declare const FIELD_RULE: {
  /** the tone becomes the value */
  readonly REPLACE: 0;
  /** the tone is multiplied by the value */
  readonly SCALE: 1;
};
/** The constants of FIELD_RULE, as options spell them. */
export type FieldRuleName = "replace" | "scale";

/** Which inks of a palette the marks of an ink_field take. */
export declare const PALETTE: {
  /** each mark takes the ink that is nearest to its colour [Oklab, Ottosson 2020] */
  readonly NEAREST: 0;
  /** neighbouring marks take the two or three inks whose mean has the colour's hue */
  readonly MIXED: 1;
};
/** The constants of PALETTE, as options spell them. */
export type PaletteName = "nearest" | "mixed";

/** How the parts of a line that surface hides are drawn.  A layer of surface is two sheets. */
export declare const HIDDEN_PARTS: {
  /** hidden parts are not drawn */
  readonly NONE: 0;
  /** hidden parts get paler with each layer of surface in front of them */
  readonly ATTENUATED: 1;
  /** hidden parts are dashed; the more layers lie in front, the shorter the dashes */
  readonly DASHED: 2;
  /** hidden parts are drawn like visible ones */
  readonly SHOWN: 3;
};
/** The constants of HIDDEN_PARTS, as options spell them. */
export type HiddenPartsName = "none" | "attenuated" | "dashed" | "shown";

/**
 * The shape of a free end of a line: one that meets no other line in the picture, such as a cusp, where a
 * contour turns
 * behind its own surface.
 */
export declare const CAP: {
  /** half a disc beyond the end */
  readonly ROUND: 0;
  /** cut off straight at the end */
  readonly FLAT: 1;
  /** a tip, whose length is twice the width of the line there */
  readonly POINTED: 2;
};
/** The constants of CAP, as options spell them. */
export type CapName = "round" | "flat" | "pointed";

/** Which creases are drawn. */
export declare const CREASES: {
  /** all creases */
  readonly ALL: 0;
  /** convex creases: edges */
  readonly CONVEX: 1;
  /** concave creases: grooves, and where something stands on a face */
  readonly CONCAVE: 2;
};
/** The constants of CREASES, as options spell them. */
export type CreasesName = "all" | "convex" | "concave";

/**
 * Named styles, each with a picture in docs/presets.md. bindings/generate writes this list from
 * bindings/presets.py.
 */
export declare const PRESET: {
  /** stipples, denser where it is darker, without contours */
  readonly STIPPLE: 0;
  /** lines of one width, denser where it is darker, and contours */
  readonly HATCH: 1;
  /** up to three sets of lines of one width, at 0, 35 and -30 degrees, each for a darker tone, and contours */
  readonly CROSS_HATCH: 2;
  /** lines along Stark's combing direction, with a second set in the darks, and contours */
  readonly COMBING: 3;
  /** contours only; hidden ones are paler */
  readonly SILHOUETTE: 4;
  /** contours and stipples */
  readonly CONTOUR_AND_STIPPLE: 5;
  /** contours only; hidden ones are dashed */
  readonly XRAY: 6;
  /** stipples, cross hatching in the darks, contours and halos [NPAR, Figure 1 (e)] */
  readonly FULL: 7;
  /** one set of lines that swell with the tone, and contours; lights have a few broken lines */
  readonly ENGRAVING: 8;
  /** up to three sets of thin lines, at 0, 50 and -40 degrees, each for a darker tone, and contours */
  readonly ETCHING: 9;
  /** few wide lines, which close up to black, and heavy contours */
  readonly WOODCUT: 10;
  /** fine stipples lit from the upper left, and outlines that swell in the shade; lights stay empty */
  readonly SCIENTIFIC_STIPPLE: 11;
  /** pencil on warm paper: two sets of lines that stray and run past their ends, and contours drawn twice */
  readonly SKETCH: 12;
  /** pale lines on blue without tone: contours, borders, creases and lines called "crease"; hidden ones are dashed */
  readonly BLUEPRINT: 13;
  /**
   * short lines along the curvature that taper to the light from the upper left, heavy outlines, and the RIDGE
   * lines of a line set
   */
  readonly ARCHAEOLOGICAL: 14;
};
/** The constants of PRESET, as options spell them. */
export type PresetName = "stipple" | "hatch" | "cross-hatch" | "combing" | "silhouette" | "contour-and-stipple" |
  "xray" | "full" | "engraving" | "etching" | "woodcut" | "scientific-stipple" | "sketch" | "blueprint" |
  "archaeological";

/** The values of a field. */
export declare const FIELD_KIND: {
  /** one number */
  readonly SCALAR: 0;
  /** three numbers: r, g, b; sRGB-encoded, 0 .. 1 */
  readonly COLOUR: 1;
  /** three numbers: x, y, z. Only the tangent part counts; its sign does not */
  readonly DIRECTION: 2;
};
/** The constants of FIELD_KIND, as options spell them. */
export type FieldKindName = "scalar" | "colour" | "direction";

/** Where the values of a field come from. */
export declare const FIELD_SOURCE: {
  /** from values at points, or at the vertices of triangles */
  readonly POINTS: 0;
  /** from a function */
  readonly FUNCTION: 1;
  /** from dabs of a brush */
  readonly DABS: 2;
  /** from an image, which is projected onto the surface along a camera */
  readonly IMAGE: 3;
};
/** The constants of FIELD_SOURCE, as options spell them. */
export type FieldSourceName = "points" | "function" | "dabs" | "image";

/** What a dab paints. */
export declare const DAB: {
  /** the tone: 1 = light, 0 = dark */
  readonly TONE: 0;
  /** the density of stipples: 1 = all, 0 = none */
  readonly DENSITY: 1;
  /** the direction of hatching */
  readonly DIRECTION: 2;
};
/** The constants of DAB, as options spell them. */
export type DabName = "tone" | "density" | "direction";

/** The sides of an item's surface on which its marks are drawn.  Lines are seen from both sides in any case. */
export declare const SIDES: {
  /** the side that the normals point to; for a solid, whose inside is never seen */
  readonly FRONT: 0;
  /**
   * both sides; for a surface that ends, such as a bowl or a leaf. Where the other side faces the camera, marks
   * are drawn with opposite normals. Such marks keep their ids, count as front and as back in
   * hrbfnpr_drawing_info, and are in separate layers after those of all items. With ATTENUATE a depth layer of
   * such an item is as opaque as two, one that faces the camera and one that faces away
   */
  readonly BOTH: 1;
};
/** The constants of SIDES, as options spell them. */
export type SidesName = "front" | "both";

/** Flags of hrbfnpr_shading_desc. */
export declare const SHADING: {
  /** lines of the kinds SHADOW and TERMINATOR are found, for items with a line_set */
  readonly WITH_LINES: 1;
};
/** The constants of SHADING, as options spell them. */
export type ShadingName = "with-lines";

/** How a mark faces the camera [NPAR 6]. */
export declare const CLASS: {
  /** no mark, or a mark that is not drawn */
  readonly NONE: 0;
  /** a mark whose normal points towards the eye */
  readonly FRONT: 1;
  /** a mark whose normal points away from the eye */
  readonly BACK: 2;
  /** a mark near a contour, with VISIBILITY_PUBLISHED */
  readonly SILHOUETTE: 3;
};
/** The constants of CLASS, as options spell them. */
export type ClassName = "none" | "front" | "back" | "silhouette";

/** Options of rasterizing. */
export declare const RASTER: {
  /**
   * lays the drawing over the image instead of replacing the image inside the viewport. Use it with transparent
   * paper
   */
  readonly OVER: 1;
  /** blends in linear light (sRGB decoded) instead of in encoded values */
  readonly LINEAR_LIGHT: 2;
};
/** The constants of RASTER, as options spell them. */
export type RasterName = "over" | "linear-light";

/** What vertices are written for. */
export declare const PRIMITIVE: {
  /** dots, with one vertex each */
  readonly POINTS: 1;
  /** strokes, with one vertex for each of their points */
  readonly LINE_STRIPS: 2;
  /** strokes, with two vertices for each point, on its left and right side */
  readonly TRIANGLE_STRIPS: 3;
};
/** The constants of PRIMITIVE, as options spell them. */
export type PrimitiveName = "points" | "line-strips" | "triangle-strips";

/** The index that ends a strip: 0xFFFFFFFF as UINT32. */
export declare const INDEX: {
  readonly RESTART: -1;
};
/** The constants of INDEX, as options spell them. */
export type IndexName = "restart";

/** What a vertex can carry, and the types it can have. */
export declare const VERTEX_ATTRIBUTE: {
  /**
   * world position; FLOAT32 x 3. For marks and their line strips it is the place of the mark. For lines, hatching
   * and triangles it is the drawn place, as exact as the window depth
   */
  readonly POSITION: 0;
  /** pixel x, pixel y and depth; FLOAT32 x 3 */
  readonly WINDOW: 1;
  /** radius of a dot or half the width of a stroke, in pixels; FLOAT32 */
  readonly RADIUS: 2;
  /** colour, straight RGBA; FLOAT32 x 4 or UINT8 x 4 */
  readonly COLOR: 3;
  /** unit normal in the world, 0 for lines; FLOAT32 x 3 */
  readonly NORMAL: 4;
  /** unit direction in the world, 0 for lines; FLOAT32 x 3 */
  readonly DIRECTION: 5;
  /** id of the mark, 0 for lines; UINT32 */
  readonly ID: 6;
  /** class of the mark, HRBFNPR_CLASS_...; UINT8 or UINT32 */
  readonly CLASS: 7;
  /** 1 = a disc of paper, 0 = ink; UINT8 or UINT32 */
  readonly IS_PAPER: 8;
  /** number of the layer in the drawing; UINT32 */
  readonly LAYER: 9;
  /** length along the stroke from its first point, in pixels, 0 for a dot; FLOAT32 */
  readonly LENGTH: 10;
  /** number of layers of surface in front of this part of a line, 0 if it is visible or a mark; UINT32 */
  readonly HIDDEN_LAYERS: 11;
  /**
   * number of the item whose surface is nearest in front of this part of a line, HRBFNPR_INDEX_RESTART if it is
   * visible or a mark; UINT32
   */
  readonly HIDDEN_BY: 12;
  /**
   * number of the line, 0 for all else; UINT32. A line keeps it from one drawing of a renderer to the next where
   * the camera moves little
   */
  readonly LINE: 13;
};
/** The constants of VERTEX_ATTRIBUTE, as options spell them. */
export type VertexAttributeName = "position" | "window" | "radius" | "color" | "normal" | "direction" | "id" | "class"
  | "is-paper" | "layer" | "length" | "hidden-layers" | "hidden-by" | "line";

/**
 * Which components of a mesh are kept.  Faces that share vertices belong to one component.
 * With ALL and SOLIDS, a closed component inside an odd number of closed ones is the wall of a cavity, and its
 * faces
 * are turned into the cavity.  One inside an even number is a solid.
 */
export declare const PARTS: {
  /** keeps all components except those inside a closed one, such as eyes in a head or inner shells */
  readonly OUTER: 0;
  /** keeps all components */
  readonly ALL: 1;
  /** keeps the component of the largest area */
  readonly LARGEST: 2;
  /** keeps all components except open ones inside a closed one */
  readonly SOLIDS: 3;
  /** in a picture SOLIDS if hidden parts of lines or a section are drawn, or with SURFACE_ONLY; else OUTER */
  readonly AUTO: 4;
};
/** The constants of PARTS, as options spell them. */
export type PartsName = "outer" | "all" | "largest" | "solids" | "auto";

/** Whether the order of a face's corners may change. */
export declare const FACES: {
  /** faces are turned to agree with their component, and closed components to face outward */
  readonly TURN: 0;
  /** faces stay as they are */
  readonly KEEP: 1;
};
/** The constants of FACES, as options spell them. */
export type FacesName = "turn" | "keep";

/** Arrays of a mesh. */
export declare const MESH_ATTRIBUTE: {
  /** positions of the vertices; FLOAT64 x 3 */
  readonly VERTEX: 0;
  /** numbers of the vertices of each face; INT32 x 3 */
  readonly TRIANGLE: 1;
  /** number of the component of each face, from 0; INT32 x 1 */
  readonly COMPONENT: 2;
  /** number of each face among the given ones; INT32 x 1 */
  readonly GIVEN_FACE: 3;
  /** unit normals of the three corners of each face; FLOAT64 x 9 */
  readonly CORNER_NORMAL: 4;
};
/** The constants of MESH_ATTRIBUTE, as options spell them. */
export type MeshAttributeName = "vertex" | "triangle" | "component" | "given-face" | "corner-normal";

/** Which edges of a mesh are sharp. */
export declare const EDGES: {
  /**
   * edges are sharp if they stand out from the faces beside them, as those of machine parts do. Noise and coarse
   * faces of round shapes do not stand out. Closed parts that cross are fitted separately, and meet in creases
   */
  readonly AUTO: 0;
  /** no edge is sharp: a fit is one smooth surface, which rounds all edges */
  readonly SMOOTH: 1;
  /** all edges are sharp whose faces meet at more than crease_angle */
  readonly SHARP: 2;
};
/** The constants of EDGES, as options spell them. */
export type EdgesName = "auto" | "smooth" | "sharp";

/** The format of a file. */
export declare const PAGE_FORMAT: {
  /** SVG 1.1, with groups as layers of Inkscape */
  readonly SVG: 0;
  /** PDF 1.5, with groups as optional content, which viewers list as layers */
  readonly PDF: 1;
  /** HPGL for plotters: absolute coordinates, 40 units per mm, y up from the lower left corner */
  readonly HPGL: 2;
  /** G-code for plotters: G0 to G3 in mm, y up from the lower left corner */
  readonly GCODE: 3;
  /**
   * DXF of AutoCAD 2004 (AC1018) in mm, y up from the lower left corner, with groups as layers. There is no paper,
   * and ink is cut off at the edges of drawings. Strokes of varying width become polylines with a width at each
   * point, and their outlines are not written. Dots become circles or, as LINES, points
   */
  readonly DXF: 4;
};
/** The constants of PAGE_FORMAT, as options spell them. */
export type PageFormatName = "svg" | "pdf" | "hpgl" | "gcode" | "dxf";

/** How strokes are written whose width varies. */
export declare const WIDTHS: {
  /** filled outlines, in SVG and PDF */
  readonly OUTLINES: 0;
  /** lines of even widths, whose ratios are powers of `width_step` */
  readonly CLASSES: 1;
};
/** The constants of WIDTHS, as options spell them. */
export type WidthsName = "outlines" | "classes";

/** How dots are written. */
export declare const DOT_SHAPE: {
  /** circles. Plotters fill them, or with SINGLE_PASS draw their outline */
  readonly CIRCLES: 0;
  /** lines of length 0 with round ends, at which a plotter touches the paper */
  readonly LINES: 1;
  /** spirals with which a pen fills the dot, if the dot is wider than the pen */
  readonly SPIRALS: 2;
};
/** The constants of DOT_SHAPE, as options spell them. */
export type DotShapeName = "circles" | "lines" | "spirals";

/** How the curves of lines of one width are written.  HPGL has straight lines only. */
export declare const CURVES: {
  /**
   * arcs of circles where lines consist of them: A in SVG, ARC, CIRCLE and bulges in DXF. Other curves are as with
   * SPLINES. GCODE has arcs (G2, G3) and straight lines only, and PDF has no arcs
   */
  readonly ARCS: 0;
  /** cubic Bezier curves: SPLINE in DXF, G5 in GCODE */
  readonly SPLINES: 1;
  /** straight lines, for programs and machines that have neither arcs nor splines */
  readonly LINES: 2;
};
/** The constants of CURVES, as options spell them. */
export type CurvesName = "arcs" | "splines" | "lines";

/** Options of a page. */
export declare const PAGE: {
  /**
   * sorts each group so that a pen travels little. HPGL and GCODE are always sorted. Lines may be turned round,
   * closed lines may begin elsewhere, and lines whose ends are nearer than `join` become one
   */
  readonly IN_PLOT_ORDER: 1;
  /**
   * draws a line that is wider than its pen once, along its centre. Without this flag, HPGL, GCODE and pens in
   * plot order fill such a line by several passes, side by side. A line up to 1.2 times as wide as its pen takes
   * one pass in any case
   */
  readonly SINGLE_PASS: 4;
  /**
   * leaves out the paper. Without this flag the page has the paper of its first drawing, or white, and drawings
   * with another paper have theirs. Plotters never draw paper
   */
  readonly WITHOUT_PAPER: 2;
};
/** The constants of PAGE, as options spell them. */
export type PageName = "in-plot-order" | "single-pass" | "without-paper";

/**
 * Types of lines, by the numbers of ISO 128-2.  Lengths in line widths: a dot is 0.5, dashes of the three kinds
 * are 6,
 * 12 and 24, a gap is 3, a space is 18.  They are stretched a little, so that each line begins and ends with a
 * dash.
 */
export declare const LINE_TYPE: {
  /** lines as the drawing has them */
  readonly AS_DRAWN: 0;
  /** a continuous line */
  readonly CONTINUOUS: 1;
  /** dashes, for hidden edges */
  readonly DASHED: 2;
  /** dashes with spaces between */
  readonly DASHED_SPACED: 3;
  /** a long dash, then a dot; for axes */
  readonly LONG_DASHED_DOTTED: 4;
  /** a long dash, then two dots */
  readonly LONG_DASHED_DOUBLE_DOTTED: 5;
  /** a long dash, then three dots */
  readonly LONG_DASHED_TRIPLE_DOTTED: 6;
  /** dots */
  readonly DOTTED: 7;
  /** a long dash, then a short dash */
  readonly LONG_DASHED_SHORT_DASHED: 8;
  /** a long dash, then two short dashes */
  readonly LONG_DASHED_DOUBLE_SHORT_DASHED: 9;
  /** a dash, then a dot */
  readonly DASHED_DOTTED: 10;
  /** two dashes, then a dot */
  readonly DOUBLE_DASHED_DOTTED: 11;
  /** a dash, then two dots */
  readonly DASHED_DOUBLE_DOTTED: 12;
  /** two dashes, then two dots */
  readonly DOUBLE_DASHED_DOUBLE_DOTTED: 13;
  /** a dash, then three dots */
  readonly DASHED_TRIPLE_DOTTED: 14;
  /** two dashes, then three dots */
  readonly DOUBLE_DASHED_TRIPLE_DOTTED: 15;
};
/** The constants of LINE_TYPE, as options spell them. */
export type LineTypeName = "as-drawn" | "continuous" | "dashed" | "dashed-spaced" | "long-dashed-dotted" |
  "long-dashed-double-dotted" | "long-dashed-triple-dotted" | "dotted" | "long-dashed-short-dashed" |
  "long-dashed-double-short-dashed" | "dashed-dotted" | "double-dashed-dotted" | "dashed-double-dotted" |
  "double-dashed-double-dotted" | "dashed-triple-dotted" | "double-dashed-triple-dotted";

/** What is known about a source. */
export declare const SOURCE: {
  /** says that `sharp_edges` is known, even if it is empty */
  readonly HAS_SHARP_EDGES: 1;
  /** says that `viewpoint` is known */
  readonly HAS_VIEWPOINT: 2;
  /** says that the points are one image of a depth camera that stood at `viewpoint` */
  readonly IS_PHOTO: 4;
};
/** The constants of SOURCE, as options spell them. */
export type SourceName = "has-sharp-edges" | "has-viewpoint" | "is-photo";

/** Options of a picture. */
export declare const PICTURE: {
  /** allows a drawing in which hardly anything can be seen */
  readonly ALLOW_BLANK: 1;
  /** turns all normals, whatever they look like */
  readonly FLIP: 2;
  /** lets the surface go on beyond open data, as the fit has it */
  readonly CLOSE: 4;
  /** fits an open mesh as one surface, even where its parts cross */
  readonly TOGETHER: 8;
  /** makes the paper transparent */
  readonly TRANSPARENT: 16;
  /**
   * gives all layers all their marks, even if the style draws lines only, and even those that the planned camera
   * does not need; for marks that are saved, or drawn by a renderer of the caller
   */
  readonly KEEP_MARKS: 32;
  /** makes the model only: chooses no camera, places no marks, looks for no lines */
  readonly SURFACE_ONLY: 64;
  /** says that the source is a part of a solid, so that up is y */
  readonly IS_SOLID: 128;
  /** compares all lines with rays, and repairs wrong parts (verify_lines of the style); a note has the counts */
  readonly VERIFY: 256;
};
/** The constants of PICTURE, as options spell them. */
export type PictureName = "allow-blank" | "flip" | "close" | "together" | "transparent" | "keep-marks" |
  "surface-only" | "is-solid" | "verify";

/** Which edges of a mesh are sharp. */
export declare const PICTURE_EDGES: {
  /**
   * edges are found as with AUTO. Where faces are coarse, the normals of the file decide if they say anything
   * about edges
   */
  readonly AS_GIVEN: 0;
  /** edges are found by HRBFNPR_EDGES_AUTO */
  readonly AUTO: 1;
  /** no edge is sharp (HRBFNPR_EDGES_SMOOTH) */
  readonly SMOOTH: 2;
  /** edges are sharp that bend by more than `edge_angle` (HRBFNPR_EDGES_SHARP) */
  readonly SHARP: 3;
};
/** The constants of PICTURE_EDGES, as options spell them. */
export type PictureEdgesName = "as-given" | "auto" | "smooth" | "sharp";

/** Whether an upright section through the middle is drawn beside the drawing. */
export declare const PROFILE: {
  /** a section is drawn in the style archaeological only */
  readonly AUTO: 0;
  /** a section is drawn */
  readonly YES: 1;
  /** no section is drawn */
  readonly NO: 2;
};
/** The constants of PROFILE, as options spell them. */
export type ProfileName = "auto" | "yes" | "no";

/** The sides of a surface on which marks are drawn. */
export declare const PICTURE_SIDES: {
  /** both sides of a surface that ends, and the front of other surfaces */
  readonly AUTO: 0;
  /** the front (HRBFNPR_SIDES_FRONT) */
  readonly FRONT: 1;
  /** both sides (HRBFNPR_SIDES_BOTH) */
  readonly BOTH: 2;
};
/** The constants of PICTURE_SIDES, as options spell them. */
export type PictureSidesName = "auto" | "front" | "both";

/**
 * The ground of a picture: a plane under the object, on which only what darkens it is drawn, which is cast
 * shadows and
 * the sky that the object hides.  Its marks are a layer named "ground", of stipples or hatching as the style
 * draws.
 * Open ground is white.  It casts no shadow and hides nothing.  If no light of the style casts shadows, the
 * first one
 * casts them on the ground, and only there.  The ground is not drawn by cameras below it.
 */
export declare const PICTURE_GROUND: {
  /** no ground */
  readonly NONE: 0;
  /** at the lowest place of the object along the up direction */
  readonly LOWEST: 1;
  /** at ground_height along the up direction */
  readonly HEIGHT: 2;
};
/** The constants of PICTURE_GROUND, as options spell them. */
export type PictureGroundName = "none" | "lowest" | "height";

/** How notes and errors write the options that they name. */
export declare const WORDING: {
  /** as fields of a descriptor: samples 400 */
  readonly FIELDS: 0;
  /** as options of a command line: --samples 400 */
  readonly OPTIONS: 1;
  /** as arguments of a call in Python: samples=400 */
  readonly ARGUMENTS: 2;
};
/** The constants of WORDING, as options spell them. */
export type WordingName = "fields" | "options" | "arguments";

/** The stages of the work. */
export declare const STAGE: {
  /** looks at a mesh: joins vertices, turns faces */
  readonly MESH: 1;
  /** chooses samples */
  readonly SAMPLE: 2;
  /** finds normals */
  readonly ORIENT: 3;
  /** smooths the image of a depth camera */
  readonly SMOOTH: 4;
  /** fits the surface */
  readonly FIT: 5;
  /** compares the surface with the mesh */
  readonly COMPARE: 6;
  /** finds the end of the surface */
  readonly END: 7;
  /** places marks */
  readonly MARKS: 8;
  /** finds lines */
  readonly LINES: 9;
  /** draws */
  readonly FRAME: 10;
  /** draws the views of a sheet */
  readonly VIEWS: 11;
  /** finds occlusion and cast shadows */
  readonly SHADE: 12;
};
/** The constants of STAGE, as options spell them. */
export type StageName = "mesh" | "sample" | "orient" | "smooth" | "fit" | "compare" | "end" | "marks" | "lines" |
  "frame" | "views" | "shade";

/** How much a note matters. */
export declare const SEVERITY: {
  /** a measurement */
  readonly INFO: 0;
  /** something was chosen, repaired or left out */
  readonly NOTE: 1;
  /** the result may be wrong in some place */
  readonly WARNING: 2;
  /** there is no result: the text is the error of the call, in full length */
  readonly FAILURE: 3;
};
/** The constants of SEVERITY, as options spell them. */
export type SeverityName = "info" | "note" | "warning" | "failure";

/**
 * Codes of notes.  Each line says when a note is given, with its figures in brackets; [] = no figures.  Figures
 * are
 * counts unless a line says otherwise.  Shares are 0 .. 1.
 */
export declare const NOTE: {
  /** faces with a corner that is not finite are left out [faces] */
  readonly FACES_NOT_FINITE: 1;
  /** points at a value that means "no data" are left out [points, the value] */
  readonly NO_DATA: 2;
  /** points far from all others are left out [points] */
  readonly STRAYS: 3;
  /** only some of the points get normals, because there are many [points, points with normals] */
  readonly SOME_ORIENTED: 4;
  /** the points have no normals, and get some [points] */
  readonly NORMALS_MADE: 5;
  /** normals that were found are not certain [confidence, 0 .. 1] */
  readonly NORMALS_NOT_SURE: 6;
  /** the surface is open, and nothing tells which side is its front [] */
  readonly FRONT_NOT_TOLD: 7;
  /** only some points are used as samples [points, points used] */
  readonly SAMPLES_CHOSEN: 8;
  /** points without a usable position or normal are left out [points] */
  readonly POINTS_NOT_USABLE: 9;
  /** places with several normals get the mean of these [places] */
  readonly NORMALS_JOINED: 10;
  /** places with opposite normals are left out [places] */
  readonly NORMALS_OPPOSITE: 11;
  /** a terrain looked down, and its normals are turned [axis: 1 = y, 2 = z] */
  readonly TERRAIN_TURNED: 12;
  /** all normals looked inward, and are turned [] */
  readonly NORMALS_TURNED: 13;
  /** given normals are repaired [normals turned, normals made, what they were: HRBFNPR_NORMALS_...] */
  readonly NORMALS_REPAIRED: 14;
  /** some normals look against those around them [these normals, all normals] */
  readonly NORMALS_AGAINST: 15;
  /** some parts have outward normals and others inward ones [share that looks inward] */
  readonly NORMALS_MIXED: 16;
  /** most of an open surface looks inward [] */
  readonly NORMALS_INWARD: 17;
  /** `viewpoint` is given, but the source needs none [] */
  readonly VIEWPOINT_NOT_USED: 18;
  /** pixels of a depth camera that lie on no surface are left out [pixels] */
  readonly PIXELS_LEFT_OUT: 19;
  /** the noise of a depth camera was measured [standard deviation, depth where it holds; units of the source] */
  readonly DEPTH_NOISE: 20;
  /** the samples have noise, and the surface does not pass through all of them [] */
  readonly SMOOTHED: 21;
  /** samples at the same place are merged [samples] */
  readonly SAMPLES_MERGED: 22;
  /** samples very near to another are merged with it [samples] */
  readonly SAMPLES_NEAR: 23;
  /** samples are dropped as strays [samples] */
  readonly SAMPLES_DROPPED: 24;
  /** flipped normals of samples are repaired [samples] */
  readonly SAMPLES_FLIPPED: 25;
  /** samples that look like strays are kept [samples] */
  readonly LIKE_STRAYS: 26;
  /** samples whose normals look flipped are kept [samples] */
  readonly LIKE_FLIPPED: 27;
  /** the surface is a guess, because there are few points [points] */
  readonly FEW_POINTS: 28;
  /** all points are on a line [] */
  readonly ON_A_LINE: 29;
  /** all points are in a plane [] */
  readonly IN_A_PLANE: 30;
  /** the points lie along curves, and the surface between these is drawn, too [] */
  readonly ALONG_CURVES: 31;
  /** the end of the surface was not found, and the surface goes on to the end of its box [] */
  readonly END_NOT_FOUND: 32;
  /** another direction than y is chosen as up [x, y, z] */
  readonly UP: 33;
  /** faces that looked to the other side than those beside them are turned [faces] */
  readonly FACES_TURNED: 34;
  /** a mesh, or some of its parts, is inside out, and is turned [parts] */
  readonly INSIDE_OUT: 35;
  /** faces without area, and repeated faces, are left out [faces] */
  readonly FACES_LEFT_OUT: 36;
  /** parts of a mesh inside others are left out [parts, their faces] */
  readonly PARTS_INSIDE: 37;
  /**
   * faces beside each other look to opposite sides and cannot be turned: the surface has one side, or crosses
   * itself [edges]
   */
  readonly CONTRARY_EDGES: 38;
  /** parts of a mesh far from all others are left out [parts, their faces] */
  readonly PARTS_FAR: 39;
  /** faces that hang on an edge of two others are left out [faces] */
  readonly FLAPS: 40;
  /** all faces stay flat, because the normals of the file say so [] */
  readonly ALL_FLAT: 41;
  /** some edges are sharp, because the normals of the file say so [] */
  readonly EDGES_BY_NORMALS: 42;
  /**
   * coarse faces are divided towards a round surface [rounds; how far vertices moved; how far places between them
   * were raised; how far the faces were off a round surface, if they are coarse; shares of the diagonal]
   */
  readonly DIVIDED: 43;
  /** coarse faces stay flat, because no round surface goes through them [] */
  readonly COARSE_FLAT: 44;
  /** parts of a mesh that cross or are close are fitted in groups, each as a separate surface [parts, groups] */
  readonly GROUPS: 45;
  /**
   * the fit did not reach its tolerance everywhere [tolerance in diagonals, share of the mesh within it, share of
   * the surface within it, greatest distance in diagonals]
   */
  readonly NOT_REACHED: 46;
  /** some sharp edges of a mesh stay smooth [their length in diagonals] */
  readonly EDGES_STAY_SMOOTH: 47;
  /** the surface is far from the mesh in some places [share of the mesh, greatest distance in diagonals] */
  readonly OFF_MESH: 48;
  /** the fit made parts of surface that the mesh does not have, and they are left out [parts] */
  readonly MADE_BY_FIT: 49;
  /**
   * two parts of a mesh are nearer to each other than the tolerance, so that the surface may join them [numbers of
   * both parts, from 0; x, y and z of the place]
   */
  readonly PARTS_TOO_THIN: 50;
  /** a layer has fewer marks than fill the darkest tone [marks wanted, marks made] */
  readonly MARKS_LIMITED: 51;
  /** the published method makes fewer refinement steps than fill the picture [steps wanted, steps made] */
  readonly LEVELS_LIMITED: 52;
  /** the image of a depth camera is seen from where the camera stood [azimuth in degrees] */
  readonly SEEN_FROM_CAMERA: 53;
  /** an open surface is seen from its front [azimuth in degrees] */
  readonly SEEN_FROM_FRONT: 54;
  /** no lines are drawn, because the source is a point set without a model [] */
  readonly NO_LINES_OF_MARKS: 55;
  /**
   * the surface is thinner than the cells in which lines are searched, so that lines may be missing [triangles
   * that look away, all triangles, samples missed]
   */
  readonly LINES_THIN: 56;
  /** lines end where the surface ends beyond its samples [borders, support, share of the area left out] */
  readonly LINES_END: 57;
  /** some curves end inside the surface, or were missed [curves] */
  readonly LINES_BROKEN: 58;
  /** the visibility of some lines contradicts itself [lines] */
  readonly LINES_DOUBTED: 59;
  /** lines cross so often in some places of the picture that no crossing was used [places] */
  readonly LINES_TANGLED: 60;
  /** hardly anything can be seen [marks shown, all marks, share of the picture that ink covers] */
  readonly BLANK: 61;
  /** pens are chosen by the widths at hand [] */
  readonly PENS: 62;
  /** a plotter's file is written [metres drawn, metres travelled, seconds] */
  readonly PLOTTED: 63;
  /** something that the picture was made with is not in its settings [] */
  readonly NOT_IN_SETTINGS: 64;
  /** the unit of the source is taken as a metre, because its format says so [] */
  readonly UNIT_IS_METRE: 65;
  /** centre lines are asked for, but no plane of symmetry was found [] */
  readonly NO_SYMMETRY: 66;
  /** outlines of a cut are not closed, and are not hatched [outlines] */
  readonly SECTION_OPEN: 67;
  /** normals get the length 1 [normals] */
  readonly NORMALS_NOT_UNIT: 68;
  /** all points are at one place [] */
  readonly AT_ONE_PLACE: 69;
  /** the source is so far from the origin that single precision loses its details [] */
  readonly FAR_FROM_ORIGIN: 70;
  /** vertices at the place of another are joined with it [vertices] */
  readonly VERTICES_JOINED: 71;
  /** vertices of no face are left out [vertices] */
  readonly VERTICES_UNUSED: 72;
  /** edges have more than two faces [edges] */
  readonly NONMANIFOLD_EDGES: 73;
  /** a mesh is open [borders, their edges] */
  readonly MESH_OPEN: 74;
  /** a mesh has several parts [parts] */
  readonly SEVERAL_PARTS: 75;
  /** a source cannot be drawn; the text says why [] */
  readonly NOT_USABLE: 76;
  /** no ground is drawn; the text says why [] */
  readonly NO_GROUND: 77;
  /** inks are chosen from the colours of the source [inks] */
  readonly PALETTE_CHOSEN: 78;
  /** borders of shadows are to be drawn, and no light casts shadows [] */
  readonly NO_SHADOWS: 79;
  /** rays were compared with all parts of lines [decided parts, those that agree, undecided parts, repaired parts] */
  readonly LINES_VERIFIED: 95;
};
/** The constants of NOTE, as options spell them. */
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
  "vertices-joined" | "vertices-unused" | "nonmanifold-edges" | "mesh-open" | "several-parts" | "not-usable" |
  "no-ground" | "palette-chosen" | "no-shadows" | "lines-verified";

/** The kind of a source. */
export declare const SOURCE_KIND: {
  /** points, with or without normals */
  readonly POINTS: 1;
  /** a mesh */
  readonly MESH: 2;
  /** a model, with or without marks */
  readonly MODEL: 3;
  /** a point set without a model */
  readonly POINT_SET: 4;
};
/** The constants of SOURCE_KIND, as options spell them. */
export type SourceKindName = "points" | "mesh" | "model" | "point-set";

/** Which way normals look. */
export declare const NORMALS_LOOK: {
  /** there are no normals, or the source cannot be drawn */
  readonly UNKNOWN: 0;
  /** all look outward */
  readonly OUTWARD: 1;
  /** all look inward */
  readonly INWARD: 2;
  /** some look outward, others inward */
  readonly MIXED: 3;
  /** they agree, and the surface encloses nothing */
  readonly OPEN: 4;
  /** they belong to other points; found for points along curves only */
  readonly FOREIGN: 5;
};
/** The constants of NORMALS_LOOK, as options spell them. */
export type NormalsLookName = "unknown" | "outward" | "inward" | "mixed" | "open" | "foreign";

/** Options of a sheet. */
export declare const VIEWS: {
  /**
   * draws a centre line for each plane of symmetry through the middle, in each view that sees the plane as a line.
   * A note NO_SYMMETRY says that there is no such plane
   */
  readonly CENTRE_LINES: 1;
  /** writes the name of each view above it. Sections always have their names */
  readonly LABELS: 2;
  /**
   * says that the format of the source is in metres, as glTF is. A unit_mm of 0 then means 1000, and a note
   * UNIT_IS_METRE says so
   */
  readonly UNIT_IS_METRE: 4;
  /**
   * compares all drawn lines with rays, and repairs wrong pieces. hrbfnpr_views_info, a note LINES_VERIFIED and,
   * unless `page` has one, the page's description have the counts
   */
  readonly VERIFY: 8;
};
/** The constants of VIEWS, as options spell them. */
export type ViewsName = "centre-lines" | "labels" | "unit-is-metre" | "verify";

/** Where views stand [ISO 5456-2]. */
export declare const VIEWS_ANGLE: {
  /** first angle: the left view stands at the right, the top view below */
  readonly FIRST: 0;
  /** third angle: the left view stands at the left, the top view above */
  readonly THIRD: 1;
};
/** The constants of VIEWS_ANGLE, as options spell them. */
export type ViewsAngleName = "first" | "third";

/** How hidden edges are drawn.  Sections never have hidden edges [ISO 128-3]. */
export declare const VIEWS_HIDDEN: {
  /** hidden edges are dashed thin lines */
  readonly DASHED: 0;
  /** hidden edges are not drawn */
  readonly NONE: 1;
  /** hidden edges are continuous thin lines */
  readonly SHOWN: 2;
};
/** The constants of VIEWS_HIDDEN, as options spell them. */
export type ViewsHiddenName = "dashed" | "none" | "shown";

/**
 * How tangent edges are drawn, along which two surfaces of a part touch without a kink, such as those of a
 * fillet.
 * They are continuous thin lines; hidden ones are not drawn.
 */
export declare const VIEWS_TANGENT: {
  /**
   * tangent edges end three widths of an outline before the lines that they would touch, as ISO 128-3 asks of the
   * lines of rounded edges; short ones end a quarter of their length before
   */
  readonly SHORT: 0;
  /** tangent edges go up to the lines that they touch */
  readonly THIN: 1;
  /** tangent edges are not drawn */
  readonly NONE: 2;
};
/** The constants of VIEWS_TANGENT, as options spell them. */
export type ViewsTangentName = "short" | "thin" | "none";

export declare const GROUPS: Readonly<Record<string, Readonly<Record<string, number>>>>;
