// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.

import type { CapName, ClassName, CreasesName, CsgName, CurvesName, DabName, DensityName, DepthName, DistributionName,
  DotShapeName, EdgesName, EvennessName, FacesName, FieldKindName, FieldRuleName, FieldSourceName, FormatName,
  HatchGuideName, HiddenLinesName, HiddenPartsName, InstructionSetName, KernelName, LayerKindName, LightKindName,
  LightName, LineKindName, LineTypeName, LogName, NormalsLookName, NormalsName, NoteName, OutwardName, PageFormatName,
  PaletteName, PartsName, PictureEdgesName, PictureGroundName, PictureSidesName, PresetName, PrimitiveName,
  ProfileName, RegularizationName, RepairName, ScalarName, SeedName, SeverityName, ShapeName, SidesName, SolverName,
  SolverReasonName, SourceKindName, StageName, StrokeStartName, ThreadBackendName, ToneCurveName, ToneName,
  ToneRangesName, ToneRuleName, TrimName, VertexAttributeName, ViewsAngleName, ViewsHiddenName, ViewsTangentName,
  VisibilityName, WidthsName, WordingName } from "./constants.js";
import type { Pointer } from "./functions.js";
import type { AllocateFn, ArrayInput, ArrayOutput, DeallocateFn, DensityFn, DirectionFn, Drawing, Field, FieldFn,
  ImplicitFn, LineSet, LogFn, Mesh, Model, Numbers, Occluders, PictureEventFn, PointSet, RunTasksFn, Settings,
  Shading, ToneFn } from "../index.js";

/**
 * An image of the caller.  `pixels` is the top-left pixel for either sign of
 * row_stride: for an image that is stored bottom-up, pass the address of its
 * last row and a negative row_stride.
 */
export interface Image {
  /** HRBFNPR_FORMAT_...; default RGBA8 */
  format?: FormatName | number;
  /** pixels; 1 to 32768 */
  width?: number;
  /** pixels; 1 to 32768 */
  height?: number;
  /** the top-left pixel */
  pixels?: Pointer;
  /** bytes from a row to the row below; at least a row's bytes, or their negative; 0 = packed */
  rowStride?: number;
}

/** How a context works. */
export interface ContextDesc {
  /** set by _init to HRBFNPR_ABI_VERSION. Another number is VERSION_MISMATCH */
  abiVersion?: number;
  /** number of threads; 0 or more; default 0 = one for each processor; 1 = serial. At most 256 are used */
  threadCount?: number;
  /** must be 0 */
  flags?: number;
  /** HRBFNPR_THREAD_BACKEND_...; default AUTO */
  threadBackend?: ThreadBackendName | number;
  /** HRBFNPR_INSTRUCTION_SET_...; default AUTO. A cap: better ones are not used */
  highestInstructionSet?: InstructionSetName | number;
  /** NULL (default) = aligned operator new. Give both functions or neither */
  allocate?: AllocateFn;
  /** NULL (default) = operator delete */
  deallocate?: DeallocateFn;
  /** receives messages; NULL (default) = no log */
  log?: LogFn;
  /** HRBFNPR_LOG_...; default DEBUG. Messages below this level are not reported */
  logLevel?: LogName | number;
  /** the host's job system; NULL (default) = none. Needs thread_backend AUTO or RUN_TASKS */
  runTasks?: RunTasksFn;
}

/** The settings that a context uses, and its memory. */
export interface ContextInfo {
  /** number of threads that a large call uses */
  readonly threadCount: number;
  /** the instruction set in use */
  readonly instructionSet: InstructionSetName | number;
  /** HRBFNPR_THREAD_BACKEND_POOL, OPENMP, RUN_TASKS or SERIAL */
  readonly threadBackend: ThreadBackendName | number;
  /** bytes that are allocated through this context now */
  readonly bytesNow: number;
  /** the largest number of bytes that were ever allocated at the same time */
  readonly bytesPeak: number;
}

/**
 * What to fit: N points with N outward normals, and how.
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
 * hrbfnpr_model_info.normals_inward is 1.
 */
export interface FitDesc {
  /** HRBFNPR_KERNEL_...: the radial function; TRIHARMONIC, GAUSSIAN or WENDLAND_C2; default TRIHARMONIC */
  kernel?: KernelName | number;
  /** N x 3, FLOAT32 or FLOAT64: the places of the samples */
  points?: ArrayInput;
  /** N x 3, FLOAT32 or FLOAT64: outward normals of any length; normal_mode may say otherwise */
  normals?: ArrayInput;
  /**
   * radius of GAUSSIAN and WENDLAND_C2, in the unit of the points; 0 or more; default 0 = from the sample spacing.
   * A larger radius fills larger gaps, but makes the system worse conditioned
   */
  kernelRadius?: number;
  /**
   * degree of the polynomial that is added to the kernels; -1 (none) to 3; default 1. TRIHARMONIC is well-posed
   * from 1 on [Duchon 1977]; below that the fit may fail with SINGULAR_SYSTEM
   */
  polynomialDegree?: number;
  /** HRBFNPR_REGULARIZATION_...; default GIVEN. AUTO needs regularization 0 */
  regularizationMode?: RegularizationName | number;
  /**
   * smoothing of the fit, added to the diagonal of the system in coordinates in which the samples' diagonal is 1;
   * 0 or more; default 0 = pass through every sample. Larger values give a smoother surface that keeps a distance
   * from noisy samples
   */
  regularization?: number;
  /** HRBFNPR_REPAIR_KEEP or DROP; default KEEP */
  outliers?: RepairName | number;
  /** HRBFNPR_REPAIR_...; default KEEP */
  flippedNormals?: RepairName | number;
  /**
   * largest distance of a sample from the surface at which no more centres are chosen, in the unit of the points;
   * 0 or more; default 0 = none. Smaller values give more centres
   */
  tolerance?: number;
  /**
   * largest number of samples that are chosen as centres; 0 or more; default 0 = no limit. If tolerance is 0, too,
   * every sample is a centre
   */
  maximumCentres?: number;
  /** HRBFNPR_SOLVER_...; default AUTO */
  solver?: SolverName | number;
  /** steps of iterative refinement after a DIRECT solve; 0 to 20; default 2. More steps give smaller residuals */
  refinementSteps?: number;
  /**
   * relative residual at which ITERATIVE ends; 0 to 0.1; default 0 = 1e-10 up to 2048 centres, 1e-8 beyond, or, if
   * rounding allows no more, up to 1e-6 with a warning in the log
   */
  solverTolerance?: number;
  /** largest number of iterations of ITERATIVE; 1 to 1000000; default 200 */
  iterationLimit?: number;
  /**
   * neighbours of each sample in the preconditioner of ITERATIVE; 1 to 48; default 0 = by the kernel and the
   * number of samples. More neighbours give fewer iterations and a slower setup
   */
  preconditionerNeighbours?: number;
  /** HRBFNPR_NORMALS_...: how far `normals` can be trusted; default GIVEN. NONE and AUTO work without normals */
  normalMode?: NormalsName | number;
  /** HRBFNPR_TRIM_...; default AUTO */
  trim?: TrimName | number;
}

/**
 * The points of hrbfnpr_orient: N points without normals, or with normals that may
 * be wrong.  docs/how-fitting-works.md explains the method.
 *
 * Outward.  For a closed surface, outward is the side that it does not enclose.
 * For an open surface it is the side that the viewpoint sees, if one is given; else
 * the convex side, if the surface encloses one side more than the other; else, as for
 * a terrain, the side of `up`.  A closed surface inside another one bounds a hole: its
 * normals point into the hole.
 *
 * Points that coincide (within 1/100 of the spacing) get the same normal.
 */
export interface OrientDesc {
  /** HRBFNPR_NORMALS_...: how far `normals` can be trusted; default AUTO. GIVEN only looks: it changes no normal */
  mode?: NormalsName | number;
  /** N x 3, FLOAT32 or FLOAT64 */
  points?: ArrayInput;
  /** N x 3, FLOAT32 or FLOAT64, of any length; a zero normal is unknown and is made. Not needed with NONE and AUTO */
  normals?: ArrayInput;
  /** the direction that decides for surfaces like a terrain; of any length, not 0; default (0, 0, 1) */
  up?: Numbers;
  /** the place from which the points were seen; used with has_viewpoint; default (0, 0, 0) */
  viewpoint?: Numbers;
  /** 1: normals of open surfaces point to the side of the viewpoint; 0: the viewpoint is ignored; default 0 */
  hasViewpoint?: number;
}

/** What hrbfnpr_orient found and did. */
export interface OrientInfo {
  /**
   * HRBFNPR_NORMALS_...: how far the given normals could be trusted; NONE also if they have nothing to do with the
   * points, as colours have not
   */
  readonly found: NormalsName | number;
  /** number of given normals that were turned round */
  readonly turned: number;
  /** number of normals that were made, because they were missing, zero or useless */
  readonly made: number;
  /** number of points that coincide with another one */
  readonly merged: number;
  /** mean angle between the lines of the given and the resulting normals, in degrees; NaN if no normals are given */
  readonly directionChange: number;
  /** standard deviation of the points from their surface, in their unit; 0 if no noise is seen */
  readonly noise: number;
  /** median distance of a point to its nearest neighbour, in the unit of the points */
  readonly spacing: number;
  /**
   * bending energy of the result per degree of freedom, in spacings. Below 0.006: the points resolve the surface;
   * 0.026: points without any order
   */
  readonly energy: number;
  /**
   * how sure the result is; 0 to 1. A heuristic, not a probability: results above 0.9 are usually right; check the
   * others
   */
  readonly confidence: number;
  /** 1: the points surround one or several solids */
  readonly closed: number;
  /** HRBFNPR_OUTWARD_...: how the outward side was decided */
  readonly outwardBy: OutwardName | number;
  /** number of pieces that lie apart by more than their spacing */
  readonly components: number;
  /** time of the call */
  readonly seconds: number;
}

/**
 * The image of a depth camera (Kinect, RealSense, time of flight, stereo): one
 * point for each of columns x rows pixels.
 *
 * The camera is at the origin and looks along +z or -z.  x / z grows or falls with
 * the column, y / z with the row.  For an image of depths z with the focal lengths
 * f and the centre c in pixels, the points are
 * x = (column - c_x) z / f_x and y = (row - c_y) z / f_y.
 *
 * docs/how-fitting-works.md explains the method.
 */
export interface DepthImageDesc {
  /** pixels in a row; 8 to 65535 */
  columns?: number;
  /** number of rows; 8 to 65535 */
  rows?: number;
  /** 1: the points stay where they are and only get normals; 0: they are smoothed; default 0 */
  keepPoints?: number;
  /** rows * columns x 3, row by row, FLOAT32 or FLOAT64. NaN, infinity or z = 0: nothing was seen at the pixel */
  points?: ArrayInput;
  /** standard deviation of 1 / z, in 1 / (unit of the points); 0 or more; default 0 = measured */
  noise?: number;
  /**
   * factor of the radius over which pixels are averaged; above 0, at most 100; default 1. Larger values remove
   * more noise and more small shapes
   */
  smoothing?: number;
}

/** What hrbfnpr_smooth_depth_image found and did. */
export interface DepthImageInfo {
  /** number of pixels with a point */
  readonly seen: number;
  /** number of these that are left out, because too few other pixels lie on their plane */
  readonly leftOut: number;
  /** standard deviation of 1 / z, as given or measured */
  readonly noise: number;
  /** mean of the focal lengths in both directions, in pixels */
  readonly focalLength: number;
  /** median of |z| over the points */
  readonly depth: number;
  /** radius of the smoothing at this depth, in pixels */
  readonly radius: number;
  /** time of the call */
  readonly seconds: number;
}

/**
 * An implicit function of the caller, in place of a fit [NPAR 8].
 *
 * The function should be negative inside and have a gradient of a length near 1 at
 * the surface.  It must be finite in a box twice as wide as the bounds.  Where it is
 * not finite, or where its gradient is shorter than 1e-150 or longer than 1e150, no
 * point is projected and no mark is placed.
 *
 * The diagonal of the bounds must be from 1e-100 to 1e100.  Make the bounds fit the
 * surface closely: tolerances, differences and the cells in which marks are placed
 * are shares of the diagonal.
 */
export interface CustomDesc {
  /** HRBFNPR_CUSTOM_... flags, or-ed; default 0 */
  flags?: number;
  /** the function; must be given */
  function?: ImplicitFn;
  /** lower corner of the box that holds the surface */
  boundsMin?: Numbers;
  /** upper corner of the box */
  boundsMax?: Numbers;
  /**
   * step of the differences, in the unit of the points; 0 or more; default 0 = 1e-4 diagonals for gradients, 1e-3
   * for Hessians
   */
  differenceStep?: number;
}

/**
 * What a fit found and did.  Lengths are in the unit of the points.  A custom model
 * and a solid have bounds, kernel and bytes only.
 */
export interface ModelInfo {
  /** HRBFNPR_KERNEL_...: the one used */
  readonly kernel: KernelName | number;
  /** the one used; -1 = none */
  readonly polynomialDegree: number;
  /** number of fits that were made to choose the centres; 0 if all samples are centres */
  readonly choiceRounds: number;
  /** number of samples as given */
  readonly samples: number;
  /** number of centres, after merging, repairing and choosing */
  readonly centres: number;
  /** number of samples that were merged into another one at the same place */
  readonly mergedSamples: number;
  /** number of samples that were merged into another one much nearer than the spacing */
  readonly nearDuplicates: number;
  /** number of normals whose length differed from 1 by more than 1e-4 */
  readonly rescaledNormals: number;
  /** number of samples far from all others, or from the tangent planes around them */
  readonly outliersFound: number;
  /** number of these that were left out */
  readonly outliersDropped: number;
  /** number of normals that are opposite to those of their neighbours */
  readonly flippedFound: number;
  /** number of these that were left out or turned round */
  readonly flippedRepaired: number;
  /**
   * lower corner of the samples' box. For up to 20 000 samples along curves, or 100 others, it also holds the
   * surface, if that closes within a third of a diagonal
   */
  readonly boundsMin: Numbers;
  /** upper corner of the box */
  readonly boundsMax: Numbers;
  /** mean distance of a sample to its nearest neighbour */
  readonly spacing: number;
  /** the one used; 0 for TRIHARMONIC */
  readonly kernelRadius: number;
  /** the one used; with AUTO, that of the values */
  readonly regularization: number;
  /** standard deviation of the samples from their surface; 0 if no noise is seen, NaN with regularization GIVEN */
  readonly noiseEstimate: number;
  /** largest |f(x_i)| at the centres */
  readonly valueResidualMax: number;
  /** root mean square of |f(x_i)| */
  readonly valueResidualRms: number;
  /** largest |grad f(x_i) - n_i| at the centres */
  readonly gradientResidualMax: number;
  /** root mean square of |grad f(x_i) - n_i| */
  readonly gradientResidualRms: number;
  /** largest distance |f| / |grad f| of a sample from the surface; dropped ones do not count */
  readonly inputDistanceMax: number;
  /** root mean square of these distances */
  readonly inputDistanceRms: number;
  /** share of all samples that lie within the tolerance; a dropped sample counts as outside; NaN with tolerance 0 */
  readonly inputShareWithin: number;
  /** HRBFNPR_SOLVER_...: the one used */
  readonly solver: SolverName | number;
  /** HRBFNPR_SOLVER_REASON_...: why it was used */
  readonly solverReason: SolverReasonName | number;
  /** number of refinement steps of DIRECT, or of steps of ITERATIVE */
  readonly iterations: number;
  /** 1: the matrix was not definite, and LU with pivoting was used */
  readonly fallback: number;
  /** relative residual of the linear system, in the 2-norm */
  readonly solverResidual: number;
  /** condition of the matrix in the 1-norm (DIRECT), or of the preconditioned matrix in the 2-norm (ITERATIVE) */
  readonly conditionEstimate: number;
  /** time of finding duplicates, outliers, flipped normals and noise */
  readonly secondsClean: number;
  /** time of all rounds that chose centres, without the last fit */
  readonly secondsChoose: number;
  /** time of reading the samples and assembling the matrix */
  readonly secondsAssemble: number;
  /** time of making the preconditioner */
  readonly secondsPrecondition: number;
  /** time of solving */
  readonly secondsSolve: number;
  /** time of the whole fit */
  readonly secondsTotal: number;
  /** memory that the model keeps */
  readonly bytes: number;
  /** largest number of bytes allocated at the same time through the context, up to the fit's end */
  readonly peakBytes: number;
  /** hrbfnpr_orient_info.found, if the fit had a normal_mode; else GIVEN */
  readonly normalsFound: number;
  /** 1: the given normals (normal_mode GIVEN) all point into a closed surface */
  readonly normalsInward: number;
  /** hrbfnpr_orient_info.turned */
  readonly normalsTurned: number;
  /** hrbfnpr_orient_info.confidence; NaN without a normal_mode */
  readonly normalsConfidence: number;
  /** time of making the normals */
  readonly secondsOrient: number;
}

/** How points are projected. */
export interface ProjectDesc {
  /** largest number of evaluations of f for each point; 1 to 1000; default 50 */
  evaluationLimit?: number;
  /**
   * largest distance |f| / |grad f| from the surface at which the projection ends, in diagonals; above 0; default
   * 1e-9
   */
  tolerance?: number;
  /**
   * sigma of Armijo's rule: the share of the expected decrease that a step must reach; between 0 and 0.5; default
   * 1e-4
   */
  armijoSlope?: number;
  /** beta of Armijo's rule: the factor by which a step is shortened; between 0 and 1; default 0.5 */
  armijoFactor?: number;
}

/**
 * The results of hrbfnpr_model_project: arrays of the caller with n elements each.
 * An array that is all zero is not wanted.
 */
export interface Projection {
  /** n x 3, FLOAT32 or FLOAT64: the projected points; may be the memory of the points */
  position?: ArrayOutput;
  /** n x 3, FLOAT32 or FLOAT64: the unit gradients; 0 where there is none */
  normal?: ArrayOutput;
  /** n x 1, UINT8 or UINT32: HRBFNPR_PROJECTION_... */
  status?: ArrayOutput;
  /** receives the number of points that converged */
  converged?: number;
}

/**
 * The results of hrbfnpr_model_curvature: arrays of the caller with n elements each,
 * FLOAT32 or FLOAT64.  An array that is all zero is not wanted.
 */
export interface Curvature {
  /** n x 1: the larger principal curvature, in 1 / unit of length */
  k1?: ArrayOutput;
  /** n x 1: the smaller principal curvature */
  k2?: ArrayOutput;
  /** n x 3: the direction of k1: unit, tangent, of arbitrary sign */
  d1?: ArrayOutput;
  /** n x 3: the direction of k2: unit, tangent, perpendicular to d1, of arbitrary sign */
  d2?: ArrayOutput;
  /** n x 1: (k1 - k2) / (|k1| + |k2| + 1e-3/diagonal), from 0 to 1 */
  confidence?: ArrayOutput;
}

/** How rays are cast. */
export interface CastDesc {
  /** largest number of hits to find on a ray; 1 to 256; default 1 = only the first one */
  maximumHits?: number;
  /** largest number of evaluations of f for each ray; 1 to 1000000; default 20000 */
  evaluationLimit?: number;
  /** where a ray begins, in lengths of its direction; finite; default 0 */
  tMin?: number;
  /** where a ray ends, in lengths of its direction; t_min or more; default infinity */
  tMax?: number;
  /**
   * a bound on |grad f| in the search box; 0 or more; default 0 = that of hrbfnpr_model_lipschitz. A bound that is
   * too small may miss hits; one that is too large only takes time
   */
  lipschitz?: number;
  /**
   * smallest step along a ray, in diagonals; above 0, at most 0.1; default 1e-4. Smaller steps find thinner sheets
   * and take more time
   */
  smallestStep?: number;
  /** accuracy of the place of a hit along its ray, in diagonals; above 0; default 1e-9 */
  tolerance?: number;
  /**
   * a line set of this model, whose mesh the rays meet first; default NULL = rays are searched without a mesh. It
   * is read only during the call
   */
  lineSet?: LineSet;
  /**
   * 1 = the hits on the mesh are moved along their rays to f = 0; 0 = they stay on the mesh, with the mean normals
   * of its corners. Used with line_set; default 1
   */
  refine?: number;
}

/**
 * The results of hrbfnpr_model_cast_rays: arrays of the caller with n elements each.
 * An array that is all zero is not wanted.  h is maximum_hits; the hits of a ray are
 * in the order of t.
 */
export interface RayHits {
  /** n x 1, UINT32: number of hits; 0 to h */
  count?: ArrayOutput;
  /** n x h, FLOAT32 or FLOAT64: places of the hits, in lengths of the direction; infinity after the last hit */
  t?: ArrayOutput;
  /**
   * n x 3h, FLOAT32 or FLOAT64: x, y, z of the first hit, then of the second; 0 after the last hit. For far
   * origins it is more exact than t, which is rounded
   */
  position?: ArrayOutput;
  /** n x 3h, FLOAT32 or FLOAT64: the unit gradients; 0 after the last hit */
  normal?: ArrayOutput;
  /** n x h, UINT8: 1 where the ray enters the inside (f changes from + to -), else 0 */
  entering?: ArrayOutput;
  /** n x 1, UINT8 or UINT32: HRBFNPR_RAY_... */
  status?: ArrayOutput;
  /** receives the number of rays that have a hit */
  hitRays?: number;
}

/** How a surface is trimmed. */
export interface TrimDesc {
  /**
   * the surface ends where s is above this; 0.001 to 1000; default 1.5. Larger values end it later: 1.5 about 0.7
   * spacings beyond its last samples, 3 about 0.9
   */
  limit?: number;
  /**
   * holes whose points are all within this distance of a sample stay closed, in diagonals; 0 or more; default
   * 0.05. Larger values keep larger holes closed
   */
  hole?: number;
  /**
   * samples closer to each other than this are treated as this far apart, in diagonals; 0 to 1; default 0. Use it
   * for samples that are much denser than the surface is accurate, such as many points of a mesh: 0.01 leaves out
   * whatever is more than about 0.01 diagonals off them, and every part that is somewhere farther than `hole` from
   * all samples
   */
  closest?: number;
  /**
   * N x 3, FLOAT32 or FLOAT64, finite: the samples; not given = the model's centres. All points of a scan show
   * better than the chosen centres where it ends
   */
  points?: ArrayInput;
  /**
   * N x 3, FLOAT32 or FLOAT64, of any length but 0: one normal for each of `points`; not given = those of the
   * centres, or of the surface at the given points
   */
  normals?: ArrayInput;
}

/** What trimming left out. */
export interface TrimInfo {
  /** 1: the surface ends somewhere; 0: it is whole, and all fields except samples and spacing are 0 */
  readonly isTrimmed: number;
  /**
   * number of samples that were looked at; 0 if trimming was not asked for, if the model is a fit to a closed
   * mesh, or if the end could not be found
   */
  readonly samples: number;
  /** number of connected parts of the surface that are left out */
  readonly parts: number;
  /** number of these that reach the end of the search box: the samples are open there */
  readonly partsToEnd: number;
  /** share of the surface's area in the box that is left out; 0 to 1; accurate to some percent */
  readonly share: number;
  /** largest distance of a place that is left out from the samples, in the model's unit */
  readonly farthest: number;
  /** spacing of the samples: the median distance to the sixth neighbour */
  readonly spacing: number;
}

/** A node of a solid's tree.  Fields that its kind does not use are ignored. */
export interface CsgNode {
  /** HRBFNPR_CSG_...; default UNION */
  kind?: CsgName | number;
  /**
   * index of the parent, which comes earlier in the list; default -1 = none, for the first node, which is the
   * root. Children have the order of the list
   */
  parent?: number;
  /** the model of MODEL, which the solid keeps alive; not trimmed */
  model?: Model;
  /**
   * affine map from the node's coordinates to the parent's; default the identity. It applies to the node and all
   * below, and may turn, mirror and stretch. The largest stretch may be 1e4 times the least. If it stretches
   * unevenly, lengths are measured by the least stretch, so that |grad f| does not grow
   */
  transform?: Numbers;
  /** sides of BOX; above 0; default 1 */
  size?: Numbers;
  /**
   * radius of SPHERE, CYLINDER, CONE and TORUS; above 0, but 0 or more for CONE, of which one radius must be above
   * 0; default 1
   */
  radius?: number;
  /** upper radius of CONE, 0 or more; tube radius of TORUS, above 0 and below `radius`; default 0.5 */
  secondRadius?: number;
  /** height of CYLINDER and CONE; above 0; default 1 */
  height?: number;
  /** growth of OFFSET, finite; wall thickness of SHELL, above 0; default 0 */
  distance?: number;
  /**
   * radius R of the blend of UNION, INTERSECTION and DIFFERENCE; 0 or more; default 0 = a crease. Larger values
   * round more
   */
  blend?: number;
  /** exponent of the blend; 0, or 2 to 64; default 0. From 2 on, larger values are sharper */
  exponent?: number;
}

/** A solid to make. */
export interface CsgDesc {
  /** the list of nodes: a tree of any depth; 1 to 65536 nodes, with those of solids that are leaves */
  nodes?: readonly CsgNode[];
  /** lower corner of the box in which the surface is looked for; both corners all 0 (default) = found from the tree */
  boundsMin?: Numbers;
  /** upper corner of the box */
  boundsMax?: Numbers;
}

/** What a solid is made of.  All fields are 0 for a model that is not a solid. */
export interface CsgInfo {
  /** number of nodes, with those of solids that became part of it */
  readonly nodes: number;
  /** number of nodes from the root to the deepest leaf, both included */
  readonly depth: number;
  /** number of different models among the leaves */
  readonly models: number;
  /**
   * number of smooth functions that it consists of: sides of primitives, sides of the boxes at which models end,
   * and one for each pair of those that a blend joins
   */
  readonly sheets: number;
  /** a bound on |grad f| that holds everywhere; 0 if none is known, because leaves are models */
  readonly lipschitz: number;
}

/**
 * How one layer of marks is made.
 *
 * tone_begin is the darkness (1 - tone) at which the first mark of the layer is shown,
 * tone_end the darkness at which all are shown: the rank u becomes
 * 1 - begin - (1 - u) (end - begin), with 0 <= begin < end <= 1.  If both are 0,
 * hrbfnpr_generate_desc.tone_ranges decides.
 */
export interface LayerDesc {
  /** HRBFNPR_LAYER_KIND_STIPPLES or HATCH; default STIPPLES */
  kind?: LayerKindName | number;
  /** name for styles; UTF-8, 1 to 63 bytes, copied; default NULL = "stipples" or "hatch" */
  name?: string;
  /**
   * largest number of marks; 0 or more, at most 100000000 for BLUE_NOISE; default 40000. 0 = no limit, for
   * PUBLISHED and for lines with a separation. PUBLISHED thins the level that exceeds the budget at random and
   * stops there. Lines of BLUE_NOISE have about this number of marks, and ignore the budget if they have a
   * separation. shared_budget replaces it
   */
  budget?: number;
  /**
   * darkness at which the first mark is shown; 0 to 1; default 0. For PUBLISHED strokes, those of the first
   * direction
   */
  toneBegin?: number;
  /** darkness at which all marks are shown; 0 to 1; default 0 */
  toneEnd?: number;
  /** the same as tone_begin, for PUBLISHED strokes of the second direction; default 0 */
  secondToneBegin?: number;
  /** the same as tone_end, for PUBLISHED strokes of the second direction; default 0 */
  secondToneEnd?: number;
  /** HRBFNPR_LAYER_WITH_... flags, or-ed; default 0 */
  flags?: number;
  /**
   * HRBFNPR_DENSITY_...; default UNIFORM
   *
   * Stipples of BLUE_NOISE.  They keep their evenness: a mark is left out if its place in the uniform
   * order, divided by the density, is too high.
   */
  density?: DensityName | number;
  /**
   * strength of CURVATURE; 0 to 1; default 0.5. 0 = uniform; larger values put more stipples where the surface
   * bends
   */
  densityStrength?: number;
  /** the function of CALLBACK. If its mean is below 1/16, the layer has fewer marks than its budget */
  densityFunction?: DensityFn;
  /**
   * the directions that lines follow; default NULL = those of `guide`
   *
   * HATCH.
   */
  directionFunction?: DirectionFn;
  /** HRBFNPR_HATCH_GUIDE_...; default CURVATURE */
  guide?: HatchGuideName | number;
  /**
   * HRBFNPR_STROKE_START_...; default SEEDS
   *
   * HATCH of PUBLISHED.
   */
  start?: StrokeStartName | number;
  /** last level of stipples at which strokes start, with STROKE_START_STIPPLES; 0 to 12; default 0 */
  startLevel?: number;
  /**
   * number of refinement steps, for stipples of PUBLISHED, too; 0 to 12; default -1 = 4 for stipples, 3 for
   * strokes. Strokes have 3^levels marks. Each further level makes five times as many stipples, or three times as
   * many marks in each stroke
   */
  levels?: number;
  /**
   * mean distance of neighbouring lines, in the unit of the samples; 1e-12 to 1e9 diagonals; default 0 = by the
   * budget. Smaller values give more lines
   *
   * HATCH of BLUE_NOISE.
   */
  separation?: number;
  /**
   * distance between the marks of a line, in the unit of the samples; 1e-12 to 1e9 diagonals; default 0 = 0.4 of
   * the separation
   */
  step?: number;
  /**
   * angle by which lines are turned in the tangent plane, counter-clockwise as seen from outside, in degrees; -360
   * to 360; default 0
   */
  angle?: number;
  /**
   * length over which directions are smoothed, in diagonals; 1e-6 to 1; default 0.04. Larger values give calmer
   * lines that follow the form less
   */
  smoothing?: number;
  /** axis around which lines run where curvature has a low confidence; not 0; default (0, 1, 0) */
  axis?: Numbers;
  /**
   * weight of the axis against curvature; 0 to 1000; default 0.06. Larger values make more lines run around the
   * axis
   */
  axisWeight?: number;
  /**
   * direction to the light (LIGHT) or to the eye (SILHOUETTE), in the model's coordinates; not 0; default (0, 0,
   * 1)
   */
  guideDirection?: Numbers;
  /**
   * weight of a guide other than CURVATURE; curvature has the rest; 0 to 1; default 1. Directions are blended as
   * exp(2 i angle)
   */
  guideWeight?: number;
  /**
   * length over which the attribute TONE_NORMAL is averaged, in diagonals; 0 to 0.1; 0 = none: tone follows
   * NORMAL; default -1 = 0.006 for HATCH of BLUE_NOISE, 0 for others. Larger values keep the grain of a rough
   * surface out of the tone
   *
   * All kinds.
   */
  toneSmoothing?: number;
  /**
   * SCALAR: the density of DENSITY_FIELD, clamped to 0 .. 1; 1 where the field has no value. A place with the
   * weight w has 1 + w (value - 1); default NULL
   *
   * Fields, in the coordinates of the model.
   */
  densityField?: Field;
  /**
   * DIRECTION: the directions that lines of HATCH follow. Where its weight is below 0.5, lines follow the
   * smoothest field between; default NULL. It excludes direction_function
   */
  directionField?: Field;
}

/** The layers of marks to make. */
export interface GenerateDesc {
  /** HRBFNPR_DISTRIBUTION_...; default BLUE_NOISE */
  distribution?: DistributionName | number;
  /** the list of layers; default NULL, with layer_count 0 = one layer of stipples */
  layers?: readonly LayerDesc[];
  /**
   * largest number of marks of all layers together, which they share in proportion to the lengths of their tone
   * ranges; 0 or more; default 0 = each layer has its own budget
   */
  sharedBudget?: number;
  /** HRBFNPR_TONE_RANGES_...; default FULL */
  toneRanges?: ToneRangesName | number;
  /** HRBFNPR_SEED_...; default AUTO */
  seedSource?: SeedName | number;
  /** n x 3, FLOAT32 or FLOAT64: the seeds of POINTS, within 1e4 diagonals of the bounds */
  seedPoints?: ArrayInput;
  /** alpha: largest random shift of the grid points of BOX, in cell sides; 0 to 0.5; default 0.25 */
  boxJitter?: number;
  /**
   * R: number of cells of BOX on the largest side of the bounds; 1 to 256; default 8 [NPAR 4.2]. More cells give
   * more seeds and miss fewer sheets. BLUE_NOISE with seed_source AUTO uses at least 16
   */
  boxResolution?: number;
  /**
   * rho_0: first step of PUBLISHED, in the unit of the samples; 1e-12 to 1e9 diagonals; default 0 = the diameter
   * of a cell for BOX, the mean diameter of empty balls between the seeds for others [NPAR 5.1]
   */
  initialStep?: number;
  /** as in hrbfnpr_project_desc; above 0; default 1e-7 */
  projectionTolerance?: number;
  /** start of the random numbers; any number; default 1. Another number gives other marks */
  randomSeed?: number;
}

/**
 * A layer of N ready-made marks.  position and normal must be given; the other arrays may be
 * empty.  The scalars are those that HRBFNPR_MARK_ATTRIBUTE_... lists; FLOAT64 is accepted
 * for FLOAT32.
 */
export interface LayerArrays {
  /** HRBFNPR_LAYER_KIND_..., except ANY; default OWN */
  kind?: LayerKindName | number;
  /** name for styles; UTF-8, 1 to 63 bytes, copied; default NULL = that of the kind */
  name?: string;
  /** absolute places, not relative to an origin; N x 3 */
  position?: ArrayInput;
  /** outward normals of any length but 0; N x 3 */
  normal?: ArrayInput;
  /**
   * UINT32, S + 1 elements that rise from 0 to N: stroke s has the marks first[s] to first[s + 1] - 1 from end to
   * end. Empty = no strokes
   */
  strokeFirst?: ArrayInput;
  /** UINT8, S elements: 0 = the first direction, 1 = the second. Empty = 0 */
  strokeDirection?: ArrayInput;
  /**
   * directions of any length, not along the normal; N x 3. Empty = along the stroke, or the u of the basis for a
   * mark without a stroke
   */
  direction?: ArrayInput;
  /** k1, k2 and confidence; N x 3. Empty = not known */
  curvature?: ArrayInput;
  /** ranks in [0, 1); N x 1. Empty = random, the same for all marks of a stroke */
  rank?: ArrayInput;
  /** refinement steps, UINT8; N x 1. Empty = 0 */
  level?: ArrayInput;
  /** widths in (0, 1]; N x 1. Empty = 1 */
  width?: ArrayInput;
}

/** A set of ready-made marks to make. */
export interface PointSetDesc {
  /** a set whose layers come first, copied; default NULL = none */
  base?: PointSet;
  /** the list of layers that follow */
  layers?: readonly LayerArrays[];
  /** start of the random numbers for ranks that are not given; any number; default 1 */
  randomSeed?: number;
}

/** What a point set holds, and how long it took.  Lengths are in the unit of the samples. */
export interface PointSetInfo {
  /** HRBFNPR_DISTRIBUTION_...: the one used */
  readonly distribution: DistributionName | number;
  /** the seed source used */
  readonly seedSource: number;
  /** number of layers */
  readonly layers: number;
  /** number of marks in all layers */
  readonly marks: number;
  /** add it to the attribute POSITION to get absolute places */
  readonly origin: Numbers;
  /** lower corner of the box around all marks, absolute */
  readonly boundsMin: Numbers;
  /** upper corner of the box */
  readonly boundsMax: Numbers;
  /**
   * square root of the area per mark of the largest layer, estimated. A frame takes it as the size of a mark's
   * piece of surface
   */
  readonly spacing: number;
  /** time of finding the seeds */
  readonly secondsSeeds: number;
  /** time of the whole call */
  readonly secondsTotal: number;
  /** memory that the set keeps, with what it shares with other sets */
  readonly bytes: number;
  /** number of fields whose values the set holds */
  readonly fieldCount: number;
}

/** What a layer holds. */
export interface LayerInfo {
  /** HRBFNPR_LAYER_KIND_... */
  readonly kind: LayerKindName | number;
  /** the layer's name; UTF-8, zero-terminated */
  readonly name: string;
  /** number of marks */
  readonly marks: number;
  /** number of strokes that the marks form; 0 = none */
  readonly strokes: number;
  /** number of marks that there would be if none had been dropped */
  readonly fullCount: number;
  /** number of refinement steps taken; for HATCH of BLUE_NOISE the highest level */
  readonly levels: number;
  /** initial step rho_0 used, in the unit of the samples; for HATCH of BLUE_NOISE the separation */
  readonly step: number;
  /** time of making the layer */
  readonly seconds: number;
}

/** What became of the candidates for marks: attempted = placed + all dropped. */
export interface PlacementInfo {
  /** number of candidates */
  readonly attempted: number;
  /** number of candidates that became marks */
  readonly placed: number;
  /** number of candidates whose projection did not reach the tolerance */
  readonly droppedNotConverged: number;
  /**
   * number of candidates that landed farther away than a cell's diagonal or the step, lie beyond the end of a
   * trimmed model, or lost the connection to their stroke because a mark between was dropped
   */
  readonly droppedStrayed: number;
  /** number of candidates where the gradient is 0 or not finite */
  readonly droppedDegenerate: number;
  /** number of candidates over the layer's budget */
  readonly droppedBudget: number;
}

/** A field whose values marks get. */
export interface MarkField {
  /** name for styles; UTF-8, 1 to 63 bytes, copied; not NULL */
  name?: string;
  /** where the values come from; default NULL = the set gets none of this name, and loses those that it has */
  field?: Field;
  /** 16 doubles: object to field, column-major, affine and invertible; default NULL = the identity */
  transform?: Pointer;
}

/** Lines to find once, when the line set is made. */
export interface LineDesc {
  /** HRBFNPR_LINE_KIND_RIDGE, VALLEY, PARABOLIC, SECTION, OWN, SOFT_EDGE or TANGENT_EDGE; default RIDGE */
  kind?: LineKindName | number;
  /** name by which hrbfnpr_line_style.name selects these lines; UTF-8, up to 63 bytes; default NULL = "" */
  name?: string;
  /**
   * least strength at which a line goes on; 0 or more; default 0. If `lower` and `upper` are 0, it is 6 for ridges
   * and valleys, 15 (degrees) for soft edges, and 0 for other kinds
   */
  lower?: number;
  /**
   * strength that a line must reach somewhere, or it is dropped; not below `lower`; default 0. If `lower` and
   * `upper` are 0, it is 15 for ridges and valleys, 35 (degrees) for soft edges, and 0 for other kinds
   */
  upper?: number;
  /** length below which a line is dropped, in diagonals; 0 or more; default 0.01 */
  shortest?: number;
  /** SECTION: normal of the planes, of any length but 0; default (0, 0, 1) */
  plane?: Numbers;
  /**
   * SECTION: places of the planes along the unit normal, in units of the model; n x 1, FLOAT32 or FLOAT64; at
   * least one
   */
  levels?: ArrayInput;
  /** OWN, TANGENT_EDGE: points of all lines, on the surface or near it; n x 3, FLOAT32 or FLOAT64 */
  position?: ArrayInput;
  /**
   * OWN, TANGENT_EDGE: number of the first position of each line, ascending, then the end of the last line; n x 1,
   * UINT32. A line whose last position equals its first is closed
   */
  lineFirst?: ArrayInput;
}

/** How a line set is made. */
export interface LineSetDesc {
  /** HRBFNPR_LINE_SET_WITH_...; default 0 */
  flags?: number;
  /**
   * side of the cells in which curves are searched, in units of the model; 0 or more; default 0 = half the
   * samples' spacing, and finer where walls are thin. Loops smaller than a cell and walls thinner than 1.75 cells
   * may be missed
   */
  cellSize?: number;
  /**
   * points near each part of the surface, where the search begins; n x 3, FLOAT32 or FLOAT64; not given = the
   * samples, or places found within the bounds of a custom model
   */
  seedPoints?: ArrayInput;
  /** a list of lines to find once; default NULL */
  lines?: readonly LineDesc[];
  /**
   * limit of s(x), as in hrbfnpr_trim_desc, beyond which the surface ends because samples are missing, as in an
   * open scan or a terrain; 0 or more; default 0 = the surface ends where its model does: trimmed, or at the
   * search box. The mesh and all curves end there, what lies beyond hides nothing, and the end is a BORDER. 1.5
   * ends the surface about 0.7 sample spacings beyond the last samples; 3 ends it about 0.9 spacings beyond them,
   * and leaves larger holes closed
   */
  support?: number;
  /**
   * samples that `support` is measured from; n x 3, FLOAT32 or FLOAT64; not given = the model's centres. All
   * points of a scan show where it ends better than the centres chosen from them
   */
  supportPoints?: ArrayInput;
  /**
   * normals of support_points, as many, of any length but 0; n x 3, FLOAT32 or FLOAT64; not given = normals of the
   * surface there
   */
  supportNormals?: ArrayInput;
  /**
   * the mesh that the model was fitted to; default NULL. Its triangles find lines where walls are thinner than
   * cells. The line set does not keep it. Ignored with a cell_size, and if it has edges that are not manifold or
   * whose faces do not agree
   */
  mesh?: Mesh;
}

/** What making a line set found. */
export interface LineSetInfo {
  /** triangles of the mesh on which curves are searched */
  readonly triangles: number;
  /**
   * triangles of that mesh that face away from the surface. The surface is finer than the cells there, and curves
   * may be missed
   */
  readonly turned: number;
  /** seeds that no triangle is near. A part of the surface is too thin for the cells there */
  readonly missedSeeds: number;
  /** lines that were found once, for all elements of the list */
  readonly lines: number;
  /** curves where the surface ends */
  readonly borders: number;
  /** side of the cells as used, in units of the model */
  readonly cellSize: number;
  /** time that it took to make the line set */
  readonly seconds: number;
  /** memory that the line set keeps */
  readonly bytes: number;
  /**
   * share of the examined area that lies beyond the samples, 0 .. 1; 0 without a support. Little is examined
   * beyond the end of a trimmed model: see its trim info
   */
  readonly leftOut: number;
  /** creases at any angle, each from corner to corner or closed */
  readonly creases: number;
}

/** A camera: two matrices and a viewport. */
export interface Camera {
  /** depth of `projection` and of depth buffers, HRBFNPR_DEPTH_...; default NEGATIVE_ONE_TO_ONE */
  depthConvention?: DepthName | number;
  /** world to eye, column-major, invertible; the eye looks along -z; default the identity */
  view?: Numbers;
  /** eye to clip, column-major, invertible; default the identity */
  projection?: Numbers;
  /**
   * x and y of the top-left corner, width and height, in pixels; up to 1048576 each; default 0 x 0, which drawing
   * refuses
   */
  viewport?: Numbers;
}

/**
 * A light of a style.  It adds intensity * max(0, n . l)^tone_exponent to the light of a mark, where l is the
 * unit
 * vector to the light.
 */
export interface Light {
  /** where it comes from, HRBFNPR_LIGHT_KIND_...; default DIRECTIONAL */
  kind?: LightKindName | number;
  /** space of `place`, HRBFNPR_LIGHT_...; default CAMERA */
  space?: LightName | number;
  /** 0 .. 16; default 1 = a surface that faces the light is white */
  intensity?: number;
  /**
   * share of its light that cast shadows take away, 0 .. 1; default 0 = it casts none. It has an effect on items
   * with a shading
   */
  shadow?: number;
  /**
   * radius of the light as it is seen from the surface, in radians, 0 .. 0.5; default 0 = shadows with sharp
   * borders; the sun has 0.0047
   */
  softness?: number;
  /** DIRECTIONAL: the direction to the light, of any length but 0; PLACE: the place; default (-0.4, 0.6, 0.7) */
  place?: Numbers;
}

/**
 * How layers of marks are drawn.  Colours are straight RGBA in [0, 1], sRGB-encoded.  Lengths in pixels are
 * those of
 * the picture.
 */
export interface LayerStyle {
  /** kind of the layers that this style is for, HRBFNPR_LAYER_KIND_...; default ANY */
  kind?: LayerKindName | number;
  /** name of the layers that this style is for; default NULL = any name. It is read during _draw only */
  name?: string;
  /** 1 or 0: whether front marks are drawn; default 1 */
  shown?: number;
  /**
   * 1 or 0, with VISIBILITY_PUBLISHED: whether marks near a contour draw it; default 1. Strokes of kind OWN never
   * do, as they may be few. If `shown` is 0 and this is 1, the layer still hides what lies behind its surface; if
   * both are 0, it takes no part
   */
  contours?: number;
  /** which strokes are drawn: bit 0 the first direction, bit 1 the second; default 3 */
  directions?: number;
  /** shape of front marks, HRBFNPR_SHAPE_...; default DOTS */
  shape?: ShapeName | number;
  /** share of the layer's marks that is used at all, 0 .. 1; default 1. Less makes the layer paler */
  share?: number;
  /** radius of a mark, and half the width of a stroke, in pixels; above 0, up to 16384; default 1 */
  radius?: number;
  /**
   * how the radius follows the zoom, relative to zoom_reference of the style; 0 .. 1; default 0 = the radius stays
   * the same in pixels; 1 = it grows with the zoom
   */
  radiusZoom?: number;
  /** colour of the ink, straight RGBA; default black */
  ink?: Numbers;
  /**
   * darkness, 1 - tau, at which lines begin; 0 .. 1; default 0.15. Larger: lights are emptier. See also hatch_fade
   *
   * SHAPE_HATCH.  Lines cover a share of the paper that grows with the darkness, 1 - tau.
   */
  hatchToneBegin?: number;
  /** darkness, 1 - tau, from which on lines get no wider; above hatch_tone_begin, up to 1; default 0.95 */
  hatchToneEnd?: number;
  /** share of the paper that lines cover at hatch_tone_begin, times `share`; above 0, up to 1; default 0.1 */
  hatchCoverageBegin?: number;
  /**
   * share of the paper that lines cover at hatch_tone_end, times `share`; above 0, up to 1; default 0.82. Lines of
   * unknown separation have the width 2 * radius there
   */
  hatchCoverageEnd?: number;
  /** least distance from line to line, in pixels; above 0, up to 16384; default 4.6. Larger: fewer, wider lines */
  hatchSpacing?: number;
  /**
   * least width of a line, in pixels; above 0, up to 16384; default 0.6. Lines are thinner only where they fade in
   * or end, or are closer together than hatch_spacing
   */
  hatchPen?: number;
  /** least width of the paper between lines, in pixels; 0 .. 16384; default 1.2 */
  hatchWhite?: number;
  /**
   * length over which a line narrows where its tone ends, in pixels; 0 .. 16384; default 20. Where it ends for
   * another reason, it narrows over a shorter length
   */
  hatchTaper?: number;
  /**
   * length below which a piece of a line is not drawn, in pixels; 0 .. 16384; default 10. Pieces up to twice this
   * length are thinner
   */
  hatchShortest?: number;
  /**
   * how far a line strays to either side, as if drawn by an unsteady hand, in multiples of hatch_pen; 0 .. 16;
   * default 0. A swing covers about 60 hatch_pen
   */
  hatchWobble?: number;
  /**
   * greatest length by which a line runs on past the end of its tone, in pixels; 0 .. 16384; default 0. Each end
   * has another length
   */
  hatchOvershoot?: number;
  /** seed of hatch_wobble, hatch_overshoot and hatch_fade; any number; default 0 */
  hatchSeed?: number;
  /**
   * SCALAR: the share of marks that is shown is multiplied by the value, clamped to 0 .. 1. With SHAPE_HATCH, the
   * darkness is multiplied
   *
   * Fields of the point set, by name (hrbfnpr_point_set_with_fields).  They are read during _draw only; default
   * NULL = none.  A value v with the weight w changes what it acts on from x to x + w (v' - x), where v' is what v
   * alone gives.  Layers without values of a field are drawn without it.  If no layer of a set has it, drawing
   * fails
   * with INVALID_ARGUMENT.  Fields have no effect with VISIBILITY_PUBLISHED.
   */
  densityField?: string;
  /**
   * SCALAR: changes the tone tau, 1 = light, 0 = dark, as tone_field_rule says. REPLACE clamps the value to 0 ..
   * 1, SCALE to 0 .. 16, and the result is clamped to 0 .. 1
   */
  toneField?: string;
  /** SCALAR: radii and widths are multiplied by the value, clamped to 0 .. 16; 0 leaves marks out */
  widthField?: string;
  /**
   * COLOUR: each mark takes an ink of the style's palette, as palette_rule says. Marks with a weight below 0.5
   * take `ink`. Strokes are cut where their ink changes, except that parts shorter than twice their width take the
   * ink of the part before
   */
  inkField?: string;
  /** SCALAR: marks with a value below 0.5 are left out, and strokes end there */
  maskField?: string;
  /** HRBFNPR_FIELD_RULE_...; default REPLACE */
  toneFieldRule?: FieldRuleName | number;
  /** HRBFNPR_PALETTE_...; default NEAREST */
  paletteRule?: PaletteName | number;
  /**
   * range of darkness below hatch_tone_begin over which lines end one after the other; 0 .. 1, counted up to
   * hatch_tone_begin; default 0 = all lines end at hatch_tone_begin. Over this range the share of the paper that
   * lines cover falls evenly to 0: lines become fewer, and break before they end. Places with a darkness of 0 stay
   * empty. Larger: lights are less empty
   *
   * SHAPE_HATCH
   */
  hatchFade?: number;
}

/**
 * How the lines of one kind are drawn, for items that have a line set.  Lengths are in pixels unless a field
 * says
 * otherwise.  Of two contours, borders, creases, intersections, ridges, valleys, suggestive contours, apparent
 * ridges
 * or tangent edges of one ink that run side by side, nearer than a pen, only one keeps its width, and the other
 * narrows
 * and ends: the one of the later kind in this list, or the thinner, or the shorter.  Items whose halo_width is 0
 * keep
 * all their lines.
 */
export interface LineStyle {
  /** kind of lines that this style is for, HRBFNPR_LINE_KIND_...; default CONTOUR */
  kind?: LineKindName | number;
  /**
   * name (hrbfnpr_line_desc.name) of the lines found once that this style is for; default NULL = any name. It is
   * read during _draw only
   */
  name?: string;
  /** how hidden parts are drawn, HRBFNPR_HIDDEN_PARTS_...; default NONE */
  hidden?: HiddenPartsName | number;
  /** shape of free ends, HRBFNPR_CAP_...; default ROUND */
  cap?: CapName | number;
  /** width of a line, in pixels; above 0, up to 16384; default 2 */
  width?: number;
  /**
   * length over which a line narrows to a free end, as half an ellipse, in pixels; 0 .. 16384; default 12; 0 = it
   * does not narrow. A part with a free end that is shorter than two tapers is thinner the shorter it is
   */
  taper?: number;
  /** width of ATTENUATED and DASHED parts, in pixels; above 0, up to 16384; default 1.2 */
  hiddenWidth?: number;
  /** factor of the opacity of ATTENUATED parts for each layer in front, 0 .. 1; default 0.35 */
  hiddenOpacity?: number;
  /** length of a dash of DASHED parts, in hidden_widths; above 0, up to 16384; default 5 */
  dash?: number;
  /** length of a gap between dashes, in hidden_widths; above 0, up to 16384; default 3 */
  gap?: number;
  /**
   * length below which parts with a free end, and hidden parts, are not drawn, in pixels; 0 .. 16384; default 2.
   * Feature lines that are found for every drawing have a length of at least 0.01 diagonals in any case
   */
  shortest?: number;
  /**
   * how much paler a line is where its strength is `lower` than where it is `upper`, 0 .. 1; default 1; 0 = it
   * does not fade
   */
  fade?: number;
  /**
   * least strength at which a line goes on, as in hrbfnpr_line_desc; 0 or more; default 0. If `lower` and `upper`
   * are 0, it is 10 for suggestive contours, 12 for apparent ridges, 15 (degrees) for creases, 15 (degrees) for
   * soft edges, 2 (degrees) for intersections, and 0 for other kinds
   */
  lower?: number;
  /**
   * strength that a line must reach somewhere to be drawn; 0 or more; default 0. If `lower` and `upper` are 0, it
   * is 30 for suggestive contours, 25 for apparent ridges, 30 (degrees) for creases, 35 (degrees) for soft edges,
   * and 0 for other kinds
   */
  upper?: number;
  /**
   * values of n . l at which an ISOPHOTE lies; n x 1, FLOAT64, packed, -1 .. 1; at least one for ISOPHOTE. It is
   * read during _draw only
   */
  levels?: ArrayInput;
  /** colour of the ink, straight RGBA; default black */
  ink?: Numbers;
  /**
   * factor of the width of CONTOUR and BORDER where nothing lies beside the line on its outer side: on the outline
   * of all items that have lines; 0 .. 16; default 1. Beyond the ends of the outline it changes to 1 over 6
   * widths. All factors that apply to a place are multiplied
   *
   * Laws of the width: factors of `width`, 0 .. 16; 1 = no effect.  All that apply to a place are multiplied.
   * They
   * follow the distance in the picture between a contour and an isophote [Goodwin et al. 2007].
   */
  outlineFactor?: number;
  /**
   * factor of the width at the farthest place of the surfaces of all items that have lines, in the viewport; 0 ..
   * 16; default 1. It is 1 at the nearest place, and changes evenly with depth. If the surfaces reach less deep
   * than half of their extent across the line of sight, it changes as if they reached so deep
   */
  farFactor?: number;
  /**
   * factor of the width where the surface faces the style's light, whatever its tone; 0 .. 16; default 1. It is 1
   * where the surface faces away, and changes evenly with n . l
   */
  litFactor?: number;
  /**
   * factor of the width where the surface bends sharply; 0 .. 16; default 1. It is 1 where the radius of curvature
   * is curvature_radius or more, and changes evenly with the radius. For CONTOUR it is the radial curvature, along
   * the line of sight; for other kinds it is the normal curvature across the line
   */
  curvatureFactor?: number;
  /** radius of curvature from which on curvature_factor has no effect, in diagonals; above 0; default 0.1 */
  curvatureRadius?: number;
  /**
   * how far a line strays to either side, in widths; 0 .. 16; default 0
   *
   * An unsteady hand.  It is the same in each drawing and, as lengths are in widths, at each size of the picture.
   */
  wobble?: number;
  /** share by which the width of a line varies; 0 .. 1; default 0 */
  wobbleWidth?: number;
  /** approximate length from swing to swing, in widths; 1 .. 16384; default 40 */
  wobbleLength?: number;
  /** seed of the wobble; any number; default 0 */
  wobbleSeed?: number;
  /** which lines of the kinds CREASE and SOFT_EDGE are drawn, HRBFNPR_CREASES_...; default ALL */
  creases?: CreasesName | number;
}

/** How an item is drawn. docs/presets.md shows named styles, and docs/how-marks-work.md explains the method. */
export interface Style {
  /** source of the tone, HRBFNPR_TONE_...; default LIGHT */
  tone?: ToneName | number;
  /**
   * colour of the paper, straight RGBA; default white; alpha 0 = transparent. It must be the same in all styles of
   * a drawing
   */
  paper?: Numbers;
  /**
   * a list of layer styles; default NULL. A layer of marks takes the first that is for it, or else the defaults of
   * hrbfnpr_layer_style_init
   */
  layers?: readonly LayerStyle[];
  /**
   * which marks are shown, HRBFNPR_TONE_RULE_...; default SHARE
   *
   * Tone.
   */
  toneRule?: ToneRuleName | number;
  /** how many marks a tone shows, HRBFNPR_TONE_CURVE_...; default COVERAGE. Only for TONE_RULE_SHARE */
  toneCurve?: ToneCurveName | number;
  /** direction to the light, of any length but 0 where a light is used; default (-0.4, 0.6, 0.7) */
  light?: Numbers;
  /** lambda, the exponent of the tone law; above 0; default 1. Larger: the picture gets darker */
  toneExponent?: number;
  /** tone of TONE_CALLBACK; default NULL */
  toneFunction?: ToneFn;
  /** space of `light`, HRBFNPR_LIGHT_...; default CAMERA */
  lightSpace?: LightName | number;
  /**
   * share of the shown marks over which a mark grows from nothing to its full area, 0 .. 1; default 0.25; 0 =
   * marks pop in. With DEPTH_LAYERS only
   */
  toneFade?: number;
  /**
   * delta, which separates classes with PUBLISHED, in (0, 1); default 0.2. A mark is front if n . v < -delta, back
   * if n . v > delta, else silhouette, where v points from the camera to the mark [NPAR 6]. Larger: wider contours
   *
   * Contours made of marks, with VISIBILITY_PUBLISHED.  With DEPTH_LAYERS contours are lines of an item's line
   * set.
   */
  silhouetteThreshold?: number;
  /** radius of a silhouette mark, in pixels, with PUBLISHED; above 0, up to 16384; default 1 */
  silhouetteRadius?: number;
  /** how silhouette_radius follows the zoom, as radius_zoom of hrbfnpr_layer_style; 0 .. 1; default 0 */
  silhouetteRadiusZoom?: number;
  /** colour of silhouette marks, straight RGBA, with PUBLISHED; default black */
  silhouetteInk?: Numbers;
  /**
   * how hidden marks are found, HRBFNPR_VISIBILITY_...; default DEPTH_LAYERS. It must be the same in all styles of
   * a drawing
   *
   * Hidden lines.
   */
  visibility?: VisibilityName | number;
  /** how hidden ink is drawn, HRBFNPR_HIDDEN_LINES_...; default ATTENUATE */
  hiddenLines?: HiddenLinesName | number;
  /**
   * lambda of alpha_f = nu^2 lambda, the opacity of surface that faces the eye, nu = n . v; 0 or more; default 1.
   * Larger: hidden ink is paler
   */
  attenuationFront?: number;
  /**
   * lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda, the opacity of surface that faces away; 0 or more; default
   * 1. Larger: hidden ink is paler
   */
  attenuationBack?: number;
  /**
   * radius of the splat, the disc of surface around a mark, in pixels; 0 .. 16384; default 0 = from the marks'
   * spacing in the picture
   */
  splatRadius?: number;
  /**
   * number n of splats that overlap in a depth layer, whose opacity is 1 - (1 - alpha)^n whatever the marks'
   * density and the zoom; 0 .. 1e6; default 8; 0 = each mark paints with alpha itself, as published. Larger:
   * hidden ink is paler
   */
  splatOverlap?: number;
  /**
   * width of the halo, in pixels at any zoom; 0 .. 16384; default 2. With DEPTH_LAYERS a surface hides what lies
   * behind it up to this far beyond its contour; if it is above 0, lines that run beside others, nearer than a
   * pen, are thinned (docs/lines.md). With PUBLISHED it is added to the radius of the paper of back marks
   */
  haloWidth?: number;
  /**
   * 1 or 0; default 0. 1: rays from the eye are compared with all parts of the item's lines, and wrong parts are
   * repaired; hrbfnpr_drawing_info has the counts (docs/lines.md)
   */
  verifyLines?: number;
  /**
   * distance from the camera at which marks begin to vanish, in world units; default 0. Either 0 < depth_min <
   * depth_max, or both are 0 and distance has no effect. Between the two the share of marks falls with the
   * logarithm of the distance
   *
   * Distance and zoom.
   */
  depthMin?: number;
  /**
   * distance from the camera from which on nothing is shown, in world units; above depth_min; default 0 = no
   * effect
   */
  depthMax?: number;
  /**
   * pixels per world unit from which on all marks are shown; 0 or more; default 0 = no effect. Below it the share
   * zoom^zoom_exponent of the marks is shown, where zoom is the pixels per world unit at a mark divided by this.
   * The area of the paper of back marks scales alike [NPAR 6.2]
   */
  zoomReference?: number;
  /** exponent of the zoom, 0 or more; default 2, which keeps the ink per area */
  zoomExponent?: number;
  /**
   * a list of line styles; default NULL = no lines
   *
   * Lines of items that have a line set, with DEPTH_LAYERS.
   */
  lines?: readonly LineStyle[];
  /**
   * strength of a light from the side opposite to `light`, which lets the unlit side keep its form: tau =
   * fill_light * (n . l)^2 where n . l < 0; 0 .. 1; default 0.25. The lit side stays as it is. For TONE_LIGHT with
   * DEPTH_LAYERS and TONE_RULE_SHARE. With `lights` it comes from the side opposite to the first one
   */
  fillLight?: number;
  /**
   * as in hrbfnpr_light; default 1
   *
   * Lights, for TONE_LIGHT with DEPTH_LAYERS and TONE_RULE_SHARE.  Their sum is the light s of a mark, and the
   * tone
   * law makes tau of it: tau = t^tone_gamma, where t = (s - tone_black) / (tone_white - tone_black), clamped to 0
   * ..
   * 1.
   */
  lightIntensity?: number;
  /** as in hrbfnpr_light; default 0 */
  lightShadow?: number;
  /** as in hrbfnpr_light; default 0 */
  lightSoftness?: number;
  /** where stipples are evenly spread, HRBFNPR_EVENNESS_...; default PICTURE */
  evenness?: EvennessName | number;
  /**
   * a list of up to 8 lights; default NULL = one directional light, with the fields `light` and light_, which a
   * list replaces. The first one is the light of isophotes and of lit_factor
   */
  lights?: readonly Light[];
  /** direction to the sky, in world space, of any length but 0; default (0, 1, 0) */
  ambientUp?: Numbers;
  /**
   * light where the surface faces the sky; 0 .. 16; default 0. Ambient light is a mean of the light from the sky,
   * weighted by (1 + n . up) / 2, and that from the ground
   */
  ambientSky?: number;
  /** light where the surface faces the ground; 0 .. 16; default 0 */
  ambientGround?: number;
  /**
   * share of the ambient light that is lost where no sky is seen, 0 .. 1; default 1. It has an effect on items
   * with a shading
   */
  occlusion?: number;
  /**
   * ambient light is multiplied by the share of sky that is seen to this power; above 0, up to 16; default 1.5.
   * Larger: hollows are darker
   */
  occlusionExponent?: number;
  /**
   * adds rim_light * (1 - |n . v|)^rim_exponent, where v points to the eye: contours are lighter; 0 .. 16; default
   * 0
   */
  rimLight?: number;
  /** above 0, up to 64; default 3. Larger: the light rim is narrower */
  rimExponent?: number;
  /** light that is drawn as black; -16 .. 16; default 0 */
  toneBlack?: number;
  /** light that is drawn as white; above tone_black, up to 16; default 1 */
  toneWhite?: number;
  /** exponent of the tone law; above 0, up to 16; default 1. Larger: darker mid-tones */
  toneGamma?: number;
  /**
   * number of flat tones, from black to white, 2 .. 6; default 0 = continuous tones. The steps of t have the same
   * size
   */
  toneSteps?: number;
  /**
   * light that ridges and hills add, and that hollows take away: it is multiplied by a number from -1 to 1, tanh(3
   * H scale) less its mean over the surface, where H is the mean curvature; 0 .. 16; default 0. It has an effect
   * on items whose shading was made with it (hrbfnpr_shading_desc.curvature_scale)
   */
  curvatureContrast?: number;
  /**
   * share of the light of all lights and of the fill light that is lost where no sky is seen, 0 .. 1; default 0.
   * Hollows get darker, and the rest stays as it is. It has an effect on items with a shading
   */
  occlusionLights?: number;
  /**
   * inks for ink_field, palette_count x 4, straight RGBA in [0, 1], sRGB-encoded; default NULL. It is read during
   * _draw only
   */
  palette?: readonly Numbers[];
}

/**
 * A dab of a brush: a ball on the surface in which what is painted moves towards a value.  Dabs act one after
 * the
 * other.
 */
export interface Dab {
  /** what it paints in a picture, HRBFNPR_DAB_...; default TONE. Fields ignore it */
  map?: DabName | number;
  /** middle of the ball, in coordinates of the source or of the field */
  position?: Numbers;
  /** unit normal of the surface there; surface that faces away from it is not painted */
  normal?: Numbers;
  /** radius of the ball, in the unit of `position`; above 0 */
  radius?: number;
  /** strength s in the middle, 0 .. 1; default 1. At the distance d from there it is s (1 - d^2 / radius^2)^2 */
  strength?: number;
  /** value of TONE and DENSITY, 0 .. 1, or of a SCALAR field, any number; default 0 */
  value?: number;
  /** direction of DIRECTION, which hatching follows; the value of a field of three numbers */
  direction?: Numbers;
}

/** What a field is made from. */
export interface FieldDesc {
  /** HRBFNPR_FIELD_KIND_...; default SCALAR */
  kind?: FieldKindName | number;
  /** HRBFNPR_FIELD_SOURCE_...; default POINTS */
  source?: FieldSourceName | number;
  /** reserved; 0 */
  flags?: number;
  /**
   * SCALAR: range[0] becomes 0, range[1] becomes 1, and values are clamped; range[0] may be the larger one.
   * Default 0, 0 = values stay as they are
   */
  range?: Numbers;
  /**
   * n x 3, FLOAT32 or FLOAT64; 1 or more
   *
   * POINTS.
   */
  points?: ArrayInput;
  /**
   * m x 3, INT32, INT64 or UINT32: numbers of points. Not given: a place has the value of the nearest point.
   * Given: it has the value of the nearest place of the triangles, interpolated between their corners
   */
  triangles?: ArrayInput;
  /**
   * n x 1 (SCALAR) or n x 3, FLOAT32, FLOAT64 or UINT8; UINT8 colours are 0 .. 255. Directions are interpolated as
   * lines without a sign. Colours are clamped to 0 .. 1
   */
  values?: ArrayInput;
  /**
   * distance from the points or triangles beyond which a place has no value; 0 or more; default 0 = there is no
   * such distance
   */
  reach?: number;
  /**
   * gives the values
   *
   * FUNCTION.
   */
  function?: FieldFn;
  /**
   * a list, copied. All act, one after the other, whatever their `map`. SCALAR takes `value`, DIRECTION takes
   * `direction`, COLOUR takes `direction` as r, g, b
   *
   * DABS.
   */
  dabs?: readonly Dab[];
  /**
   * the image, copied. COLOUR takes its colour, SCALAR its luminance Y' = 0.2126 R' + 0.7152 G' + 0.0722 B'. Alpha
   * is the weight; COVERAGE8 and DIRECTION are refused
   *
   * IMAGE.  A place outside the image, one that faces away from the camera, and one that is hidden has no value.
   */
  image?: Image;
  /** the camera along which it is projected, in the coordinates of the field. The image fills its viewport */
  camera?: Camera;
  /** surfaces that hide places from the camera, in the coordinates of the field; default NULL = none */
  occluders?: Occluders;
}

/** The marks of one layer as they are in this drawing, for an animated surface. */
export interface LayerPose {
  /** number of the layer in the item's point set; each layer has one pose at most */
  layer?: number;
  /** absolute positions, in the order of the layer's n marks; n x 3, FLOAT32 or FLOAT64 */
  position?: ArrayInput;
  /** outward unit normals; n x 3, FLOAT32 or FLOAT64 */
  normal?: ArrayInput;
  /** unit directions; n x 3, FLOAT32 or FLOAT64; empty = the directions of the set */
  direction?: ArrayInput;
}

/**
 * One thing to draw.  What it points to is read during _draw only, except that the drawing retains the point
 * set.
 */
export interface Item {
  /** sides on which marks are drawn, HRBFNPR_SIDES_...; default FRONT */
  sides?: SidesName | number;
  /** marks to draw; not NULL */
  pointSet?: PointSet;
  /** how they are drawn; default NULL = the defaults of hrbfnpr_style_init */
  style?: Style;
  /**
   * surface that the marks lie on; default NULL. With it, and DEPTH_LAYERS, a ray from each mark to the eye finds
   * what hides the mark: exact, but slow. It must be NULL if there are poses
   */
  model?: Model;
  /** object to world, column-major, affine and invertible; default the identity */
  transform?: Numbers;
  /** a list of layers whose marks have moved; default NULL */
  poses?: readonly LayerPose[];
  /**
   * what the style's lines are drawn from; default NULL = no lines. All items of a drawing that have one hide each
   * other's lines; other items hide no lines. It must be NULL if there are poses
   */
  lineSet?: LineSet;
  /**
   * how much light reaches the marks; default NULL = all. It must be that of `point_set`, and NULL if there are
   * poses
   */
  shading?: Shading;
}

/** How a shading is computed. */
export interface ShadingDesc {
  /** number of rays by which a mark sees the sky; 1 .. 4096; default 64; larger: less noise */
  skyRays?: number;
  /** number of rays by which a mark in a penumbra sees a light; 1 .. 4096; default 32 */
  shadowRays?: number;
  /** HRBFNPR_SHADING_...; default 0 */
  flags?: number;
  /**
   * distance beyond which nothing hides the sky, in diagonals of the box of all occluders; 0 .. 100; default 0.35;
   * 0 = the whole sky is seen everywhere. What is nearer hides the more, the nearer it is: 1 - distance / reach
   */
  occlusionReach?: number;
  /**
   * a shading of the same item and the same occluders, but for other lights, whose occlusion is taken; default
   * NULL = occlusion is computed. sky_rays and occlusion_reach then have no effect. Curvature is taken, too, if it
   * has any
   */
  previous?: Shading;
  /**
   * distance over which curvature is measured, in diagonals of the box around the item's surface; 0 .. 1; default
   * 0.02; 0 = it is not measured. It is measured if the item's style has a curvature_contrast, over at least about
   * a cell of the item's line set
   */
  curvatureScale?: number;
}

/**
 * What a drawing holds, and what making it did.  The counts of marks are over the layers that the styles use, in
 * all
 * items: marks = outside + front + back + silhouette + culled.
 */
export interface DrawingInfo {
  /** items that were drawn */
  readonly items: number;
  /** layers of the drawing, for hrbfnpr_drawing_get_layer_info */
  readonly layers: number;
  /** dots of ink */
  readonly dots: number;
  /** strokes of marks and of lines */
  readonly strokes: number;
  /** points of all strokes */
  readonly strokePoints: number;
  /** marks of the layers that the styles use, in all items */
  readonly marks: number;
  /** marks outside the view frustum */
  readonly outside: number;
  /** marks of class front inside the frustum */
  readonly front: number;
  /** marks of class back inside the frustum */
  readonly back: number;
  /** marks of class silhouette inside the frustum; PUBLISHED only */
  readonly silhouette: number;
  /** marks without a class, because no tone could show them and they were skipped; DEPTH_LAYERS only */
  readonly culled: number;
  /** marks drawn as ink */
  readonly shown: number;
  /** front marks not shown because of light or share */
  readonly droppedTone: number;
  /** front and silhouette marks not shown because of their distance */
  readonly droppedDepth: number;
  /** front marks not shown because of the zoom */
  readonly droppedZoom: number;
  /** marks not drawn because the surface in front of them lets nothing of them through */
  readonly droppedHidden: number;
  /** with PUBLISHED, discs of paper; with DEPTH_LAYERS, marks from which depth layers were found */
  readonly splats: number;
  /** time for transforms, classes and tones */
  readonly nanosecondsClassify: number;
  /** time for finding what hides marks */
  readonly nanosecondsVisibility: number;
  /** time for ordering ink */
  readonly nanosecondsSort: number;
  /** memory that the drawing keeps */
  readonly bytes: number;
  /** memory that its renderer keeps, without drawings */
  readonly scratchBytes: number;
  /** curves that lines were drawn from */
  readonly lineCurves: number;
  /** cusps of these curves */
  readonly lineCusps: number;
  /** crossings of their images at which the farther curve changes its visibility */
  readonly lineCrossings: number;
  /** curves that end inside the surface, and places where a curve was missed */
  readonly lineBroken: number;
  /** curves whose visibility did not add up. A ray decided for each of their parts */
  readonly lineSettled: number;
  /** curves among these with a part whose ray was not certain */
  readonly lineContradictions: number;
  /** time for lines */
  readonly nanosecondsLines: number;
  /** curves whose visibility did not add up at first. They, and those that cross them, were refined */
  readonly lineRefined: number;
  /**
   * cells of the image, four pixels wide or more, with so many crossings that none was used. Lines run to and fro
   * over each other there, as on a flat face seen edge-on
   */
  readonly lineTangles: number;
  /** visible and hidden parts of lines that rays were compared with (`verify_lines`) */
  readonly linePieces: number;
  /** parts whose decided rays all agree with the drawing */
  readonly lineAgreeing: number;
  /** parts without a decided ray: they are within 0.4 pixels of an edge, in the image or in depth */
  readonly lineUndecided: number;
  /** parts that were divided, or drawn otherwise than counted, because rays disagreed */
  readonly lineRepaired: number;
}

/**
 * A layer of a drawing: the ink of one layer of marks, for front marks or (with PUBLISHED) for contours; or the
 * ink of
 * lines.
 */
export interface DrawingLayerInfo {
  /** class of its marks: HRBFNPR_CLASS_FRONT or SILHOUETTE */
  readonly markClass: ClassName | number;
  /** number of the item */
  readonly item: number;
  /** number of the layer in the item's point set; -1 = lines */
  readonly layer: number;
  /** kind of that layer, HRBFNPR_LAYER_KIND_...; for lines HRBFNPR_LINE_KIND_... */
  readonly kind: LayerKindName | number;
  /** shape of the ink, HRBFNPR_SHAPE_... */
  readonly shape: ShapeName | number;
  /** name of that layer; for lines that of their style, or empty */
  readonly name: string;
  /** colour of the ink, straight RGBA */
  readonly ink: Numbers;
  /** dots of the layer */
  readonly dots: number;
  /** strokes of the layer */
  readonly strokes: number;
  /**
   * number of the ink in the style's palette; -1 = the layer's own ink. Each ink that marks of a layer take is a
   * layer of the drawing of its own
   */
  readonly inkNumber: number;
}

/**
 * Optional inputs and outputs of rasterizing.  Each array has width * height elements of one component, row by
 * row from
 * the top-left pixel of the image.  An array with data NULL and count 0 is not wanted.
 */
export interface RasterDesc {
  /** HRBFNPR_RASTER_...; default 0 */
  flags?: number;
  /** depth of the host's scene, FLOAT32 in the camera's depth convention; ink behind it is not drawn */
  hostDepth?: ArrayInput;
  /**
   * gets the depth of the nearest surface, FLOAT32 in the camera's depth convention; the far plane where there is
   * no surface
   */
  depth?: ArrayOutput;
  /** gets the id of the nearest drawn mark, UINT32; 0 = none */
  id?: ArrayOutput;
  /** gets the class of that mark, HRBFNPR_CLASS_...; UINT8 or UINT32 */
  markClass?: ArrayOutput;
}

/** One attribute of a vertex. */
export interface VertexAttribute {
  /** what it holds, HRBFNPR_VERTEX_ATTRIBUTE_...; default POSITION */
  attribute?: VertexAttributeName | number;
  /** type of its numbers, HRBFNPR_SCALAR_...; default FLOAT32 */
  scalar?: ScalarName | number;
  /** bytes from the start of the vertex; default 0 */
  offset?: number;
}

/** What vertices are written for, and what each holds. */
export interface VertexLayout {
  /** what vertices are written for, HRBFNPR_PRIMITIVE_...; default POINTS */
  primitive?: PrimitiveName | number;
  /** a list of 1 to 64 attributes */
  attributes?: readonly VertexAttribute[];
  /** bytes from one vertex to the next; default 0 = up to the end of the last attribute */
  stride?: number;
}

/**
 * How each mark of a layer is drawn, in the set's own order.  A host keeps the set's arrays on the graphics card
 * and
 * uploads only these.  Each array of the caller's has as many elements as the layer has marks, or is not given.
 */
export interface MarkResults {
  /**
   * gets the class as which the mark is drawn, HRBFNPR_CLASS_FRONT or SILHOUETTE, or NONE if it is not drawn; n x
   * 1, UINT8
   */
  shown?: ArrayOutput;
  /** gets the radius of the mark in pixels, 0 if it is not drawn; n x 1, FLOAT32 */
  radius?: ArrayOutput;
  /** gets the ink's alpha times the transmittance of what lies in front, 0 if the mark is not drawn; n x 1, FLOAT32 */
  opacity?: ArrayOutput;
}

/** The mark that an id belongs to. */
export interface MarkIdentity {
  /** the id itself */
  readonly id: number;
  /** number of the item */
  readonly item: number;
  /** number of the layer in the item's point set */
  readonly layer: number;
  /** number of the mark in the layer */
  readonly mark: number;
  /** number of its stroke in the layer; -1 = it is in no stroke */
  readonly stroke: number;
  /** its place along the stroke, from 0 */
  readonly place: number;
}

/** A mesh as it is given: triangles.  The caller cuts quadrilaterals and polygons into triangles. */
export interface MeshDesc {
  /** components that are kept, HRBFNPR_PARTS_...; default OUTER */
  parts?: PartsName | number;
  /** positions; n x 3, FLOAT32 or FLOAT64, n < 2^31 - 1; coordinates up to 1e60 */
  vertices?: ArrayInput;
  /** numbers of vertices from 0, counter-clockwise as seen from outside; m x 3, INT32, INT64 or UINT32, m < 2^29 */
  triangles?: ArrayInput;
  /**
   * angle between the normals of two faces, in degrees, above which they do not share corner normals; 0 .. 180;
   * default 60
   */
  creaseAngle?: number;
  /** whether faces are turned, HRBFNPR_FACES_...; default TURN */
  faces?: FacesName | number;
}

/**
 * What making a mesh found, and did.  Facts such as the numbers of vertices, faces and edges are those of the
 * mesh that
 * is kept; numbers of repairs are those of the mesh that was given.  An edge is at the boundary if it has one
 * face, and
 * not manifold if it has more than two.
 */
export interface MeshInfo {
  /** 1: no edge is at the boundary or not manifold, and all faces agree */
  readonly closed: number;
  /** vertices that were given */
  readonly givenVertices: number;
  /** faces that were given */
  readonly givenFaces: number;
  /**
   * vertices that are kept. They are more than were given where solids that touch in an edge are parted, at most
   * three for each face
   */
  readonly vertices: number;
  /** faces that are kept */
  readonly faces: number;
  /** vertices at the place of another, joined with it; on borders also those within 1e-6 diagonals of another */
  readonly weldedVertices: number;
  /**
   * faces left out because they have no area beyond the rounding of single precision. The face across the largest
   * side is cut in two at the corner on it, so that no slit stays
   */
  readonly degenerateFaces: number;
  /** faces left out because another has the same corners; both where two solids share a wall */
  readonly repeatedFaces: number;
  /** faces turned to agree with those beside them */
  readonly turnedFaces: number;
  /** components of the given faces */
  readonly components: number;
  /** closed components turned because they were inside out */
  readonly turnedComponents: number;
  /** components inside a closed one */
  readonly nestedComponents: number;
  /** components left out, by `parts` */
  readonly leftOutComponents: number;
  /** faces of the components left out */
  readonly leftOutFaces: number;
  /** edges with one face */
  readonly boundaryEdges: number;
  /** loops that these edges form */
  readonly boundaryLoops: number;
  /** edges with more than two faces */
  readonly nonmanifoldEdges: number;
  /** edges whose two faces do not agree, because the mesh cannot be oriented or was not to be */
  readonly contraryEdges: number;
  /** vertices - edges + faces */
  readonly eulerCharacteristic: number;
  /** number of handles of all components; -1 if the mesh is not closed */
  readonly genus: number;
  /** area, in squared units of the mesh */
  readonly area: number;
  /** enclosed volume, in cubed units of the mesh; NaN if the mesh is not closed */
  readonly volume: number;
  /** least coordinates of the vertices */
  readonly boundsMin: Numbers;
  /** greatest coordinates of the vertices */
  readonly boundsMax: Numbers;
  /** time that making it took */
  readonly seconds: number;
  /** memory that the mesh keeps */
  readonly bytes: number;
  /** length of the edges that bend by more than 30 degrees, in diagonals of the bounds */
  readonly creaseLength: number;
  /**
   * 1: the mesh has edges that stand out, as those of machine parts do. hrbfnpr_model_fit_mesh keeps them sharp
   * with edges AUTO and the default crease_angle
   */
  readonly creases: CreasesName | number;
  /** components that are kept and are walls of cavities */
  readonly cavities: number;
}

/** How a mesh is sampled. */
export interface SampleDesc {
  /**
   * random places to choose from, 0 .. 1000000; default 0 = 40 for each sample, up to 1000000. More: more even
   * samples, in more time. There are never fewer than samples; with as many, the samples are all of them in random
   * order
   */
  candidates?: number;
  /** seed of the places, any number; default 1 */
  randomSeed?: number;
}

/** How sharp edges are found. */
export interface MeshEdgesDesc {
  /** which edges are sharp, HRBFNPR_EDGES_...; default AUTO */
  edges?: EdgesName | number;
  /** angle between the normals of two faces, in degrees, above which their edge is sharp; 1 .. 179; default 30 */
  creaseAngle?: number;
  /**
   * distance, in units of the mesh, that decides about coarse faces; 0 or more; default 0 = 0.01 diagonals. Faces
   * stay flat, with sharp edges, if a round surface would leave them by more than four fifths of it. With a large
   * number, such as the diagonal, the angle alone decides
   */
  far?: number;
  /**
   * 1 also finds tangent edges, along which two surfaces of a part touch without a kink but bend differently, such
   * as a fillet and a plane; default 0. They are found where the bends of the mesh agree with two different
   * curvatures. Scans, noise and subdivided shapes have none
   */
  tangent?: number;
}

/** The sharp edges of a mesh as a whole.  Lengths are in units of the mesh. */
export interface MeshEdgesInfo {
  /** number of sharp edges */
  readonly edges: number;
  /** number of smooth patches between them; 1 if no edge is sharp */
  readonly patches: number;
  /** length of the sharp edges */
  readonly length: number;
  /** length of those sharp edges that have the same patch on both sides, as where a crease fades out */
  readonly fading: number;
  /**
   * with AUTO, length of edges that bend more than crease_angle but do not stand out; 0 if the mesh has sharp
   * edges
   */
  readonly doubtful: number;
  /** time that the search took */
  readonly seconds: number;
}

/**
 * How a surface is compared with a mesh.  The surface is that of the model within the box of the mesh, grown by
 * 0.05
 * diagonals.  Diagonals are those of the mesh.  Parts of the surface whose nearest place on the mesh is on its
 * border
 * lie beyond the mesh, and are left out.  Where closed components overlap, what lies inside another is no part
 * of the
 * mesh.
 */
export interface CompareDesc {
  /** distance within which shares are counted, in units of the mesh; 0 or more; default 0 = 0.002 diagonals */
  tolerance?: number;
  /**
   * distance, in units of the mesh, beyond which surface is invented and mesh is missed; 0 or more; default 0 =
   * 0.01 diagonals
   */
  far?: number;
  /**
   * limit of the support of the model's samples, beyond which surface is left out, as in hrbfnpr_line_set_desc; 0
   * or more; default 0 = nothing is left out. A custom model has no samples: give 0
   */
  support?: number;
  /** places to measure at, on the surface and on the mesh each, 100 .. 10000000; default 0 = 20000 */
  points?: number;
  /**
   * side of the cells in which the surface is searched, in units of the mesh, at least 0.001 diagonals; default 0
   * = 1/128 diagonal, and finer where the surface is thin. What is thinner or smaller may be missed
   */
  cellSize?: number;
  /** seed of the places, any number; default 1 */
  randomSeed?: number;
}

/**
 * How near a surface and a mesh are to each other.  Distances are in units of the mesh.  99 % of the distances
 * are not
 * above p99.  Figures without any place to measure at are NaN.
 */
export interface Comparison {
  /** places on the surface, even over its area */
  readonly surfacePoints: number;
  /** mean of their distances from the mesh */
  readonly surfaceMean: number;
  /** 99th percentile of these distances */
  readonly surfaceP99: number;
  /** greatest of these distances */
  readonly surfaceMax: number;
  /** share of the surface within the tolerance of the mesh, 0 .. 1 */
  readonly surfaceShare: number;
  /** share of the surface farther than `far` from the mesh, 0 .. 1 */
  readonly inventedShare: number;
  /** share of the surface left out, beyond the mesh's border or by `support`, 0 .. 1; no other figure includes it */
  readonly leftOutShare: number;
  /** places on the mesh, even over its area */
  readonly meshPoints: number;
  /** mean of their distances from the surface */
  readonly meshMean: number;
  /** 99th percentile of these distances */
  readonly meshP99: number;
  /** greatest of these distances */
  readonly meshMax: number;
  /** share of the mesh within the tolerance of the surface, 0 .. 1 */
  readonly meshShare: number;
  /** share of the mesh farther than `far` from the surface, 0 .. 1 */
  readonly missedShare: number;
  /** mean angle between the mesh's normals and those of the surface beside them, in degrees */
  readonly normalMean: number;
  /** 99th percentile of these angles, in degrees */
  readonly normalP99: number;
  /** components of the surface */
  readonly components: number;
  /** genus of the surface, summed over its components; -1 if it has a border in the box */
  readonly genus: number;
  /** tolerance as used */
  readonly tolerance: number;
  /** diagonal of the mesh */
  readonly diagonal: number;
  /** time that the comparison took */
  readonly seconds: number;
}

/** How a mesh is fitted. */
export interface MeshFitDesc {
  /**
   * distance within which surface and mesh shall be of each other, in units of the mesh; 1e-6 diagonals or more;
   * default 0 = 0.002 diagonals. Smaller: more samples and time
   */
  tolerance?: number;
  /** share of both that must be within the tolerance; above 0, up to 1; default 0.99 */
  share?: number;
  /**
   * distance that no part may exceed, in units of the mesh; not below the tolerance; default 0 = five times the
   * tolerance
   */
  far?: number;
  /**
   * the most centres of the fit, 16 .. 1000000; default 8000. A fit with sharp edges may have 32 for each of its
   * sheets, if that is more, as each sheet is solved alone
   */
  maximumCentres?: number;
  /** places on the mesh to choose samples from, 1000 .. 10000000; default 0 = by its area and its details */
  candidates?: number;
  /** seed of the places, any number; default 1 */
  randomSeed?: number;
  /**
   * angle between the normals of two faces, in degrees, above which their edge is sharp; 5 .. 175; default 30.
   * Edges of coarse faces are sharp, too, if rounding would move the surface off the mesh by four fifths of `far`
   */
  creaseAngle?: number;
  /** which edges are sharp, HRBFNPR_EDGES_...; default AUTO */
  edges?: EdgesName | number;
}

/**
 * The result of a fit to a mesh.  Distances are in units of the mesh.  They come from the fit's last
 * measurement, at
 * places that it did not use before. hrbfnpr_model_compare_mesh measures again, and more.
 */
export interface MeshFitInfo {
  /** 1: surface and mesh keep the tolerance, the share and `far`, both ways */
  readonly reached: number;
  /** tolerance as used */
  readonly tolerance: number;
  /** `far` as used */
  readonly far: number;
  /** places on the mesh that samples were chosen from */
  readonly candidates: number;
  /** all centres */
  readonly centres: number;
  /** centres off the surface, at which f is held to the distance from the mesh. They are the last ones */
  readonly offSurfaceCentres: number;
  /** number of fits */
  readonly rounds: number;
  /** 1: the mesh has a border, and the surface beyond it was not counted */
  readonly supported: number;
  /** share of the surface within the tolerance of the mesh, 0 .. 1 */
  readonly surfaceShare: number;
  /** 99th percentile of the surface's distances from the mesh */
  readonly surfaceP99: number;
  /** greatest distance of the surface from the mesh */
  readonly surfaceMax: number;
  /** share of the mesh within the tolerance of the surface, 0 .. 1 */
  readonly meshShare: number;
  /** 99th percentile of the mesh's distances from the surface */
  readonly meshP99: number;
  /** greatest distance of the mesh from the surface */
  readonly meshMax: number;
  /** time for choosing samples */
  readonly secondsSample: number;
  /** time for the fits of all rounds */
  readonly secondsFit: number;
  /** time for measuring distances */
  readonly secondsMeasure: number;
  /** time of the whole call */
  readonly secondsTotal: number;
  /** smooth sheets that the surface consists of; 1 if it has no sharp edges */
  readonly sheets: number;
  /** length of the mesh's edges that are sharp, in units of the mesh */
  readonly creaseLength: number;
  /** length of edges that stay smooth because the mesh could not be cut there, in units of the mesh */
  readonly smoothLength: number;
  /** cells of space, in each of which a few sheets make the surface */
  readonly cells: number;
  /** cells in which no maximum and minimum of sheets follows the mesh everywhere */
  readonly poorCells: number;
  /**
   * numbers of two parts of the mesh, from 0, that are nearer to each other than the tolerance, so that the
   * surface may join them; -1, -1 if none were found
   */
  readonly touchingParts: Numbers;
  /** place where these parts are near each other */
  readonly touchingPlace: Numbers;
  /** 1: these parts may go through each other there; 0 if they are near each other only */
  readonly partsMayCross: number;
}

/** A drawing on a page. */
export interface PageItem {
  /** the drawing, not NULL; what lies beyond its viewport is cut off */
  drawing?: Drawing;
  /** place of the viewport's left edge, in mm; -1e6 .. 1e6; default 0 */
  x?: number;
  /** place of the viewport's top edge, in mm; -1e6 .. 1e6; default 0 */
  y?: number;
  /** mm of a pixel; above 0, up to 1e6; default 25.4 / 96 */
  scale?: number;
  /** name of the group around the drawing, UTF-8; default NULL = no name */
  name?: string;
}

/** A pen that draws some groups. */
export interface Pen {
  /** type of the lines, HRBFNPR_LINE_TYPE_...; default AS_DRAWN */
  lineType?: LineTypeName | number;
  /**
   * the groups: a name, or the beginning of names and a '*'; default NULL = all groups. The last pen that fits a
   * group draws it
   */
  groups?: string;
  /**
   * width of all lines, in mm; 0 .. 1e6; default 0 = as drawn. For plotters it is the width of the pen, 0.3 if it
   * is 0
   */
  width?: number;
  /** colour of the ink, straight RGBA; default alpha 0 = as drawn */
  ink?: Numbers;
  /**
   * number of a plotter's pen, 1 .. 255; default 1. If it is for several groups, each ink of a style's palette has
   * a pen of its own: the group "stipples ink 1" has number + 1, and so on. Without any pen, the numbers begin at
   * 1
   */
  number?: number;
}

/** A line or a text beside the drawings. */
export interface Annotation {
  /** type of the line, HRBFNPR_LINE_TYPE_...; default CONTINUOUS */
  lineType?: LineTypeName | number;
  /**
   * name of its group, UTF-8, 1 to 95 bytes; default "annotations". Consecutive annotations of one group share its
   * layer and pen, and the ink and line type of the first of them
   */
  group?: string;
  /** a text, UTF-8; default NULL = the points are a line. HPGL writes texts as labels, GCODE leaves them out */
  text?: string;
  /** points of the line, two at least, or the start of the text's baseline, in mm; n x 2, FLOAT32 or FLOAT64 */
  points?: ArrayInput;
  /** width of the line, or height of the text's capitals, in mm; above 0, up to 1e6; default 0.35 */
  width?: number;
  /** colour of the ink, straight RGBA; default black */
  ink?: Numbers;
}

/** A page to write. */
export interface PageDesc {
  /** format of the file, HRBFNPR_PAGE_FORMAT_...; default SVG */
  format?: PageFormatName | number;
  /** HRBFNPR_PAGE_IN_PLOT_ORDER and others; default 0 */
  flags?: number;
  /** how strokes of varying width are written, HRBFNPR_WIDTHS_...; default OUTLINES */
  widths?: WidthsName | number;
  /** how dots are written, HRBFNPR_DOT_SHAPE_...; default CIRCLES */
  dots?: DotShapeName | number;
  /** how the curves of lines of one width are written, HRBFNPR_CURVES_...; default ARCS */
  curves?: CurvesName | number;
  /** width of the page, in mm; 0 .. 1e6; default 0 = as far as the drawings reach */
  width?: number;
  /** height of the page, in mm; 0 .. 1e6; default 0 = as far as the drawings reach */
  height?: number;
  /**
   * greatest distance between drawn and written lines, in mm; 0.001 .. 10; default 0.05. Larger: smaller files,
   * rougher curves
   */
  tolerance?: number;
  /** ratio of the widths of two consecutive classes (WIDTHS_CLASSES); 1.01 .. 4; default 1.25 */
  widthStep?: number;
  /**
   * in plot order, distance between the ends of two lines below which they become one, in mm; 0 .. 1e6; default 0
   * = the pen's width
   */
  join?: number;
  /** in plot order, length below which lines are dropped, in mm; 0 .. 1e6; default 0 = half the pen's width */
  shortest?: number;
  /**
   * in plot order, distance from a dot that stays below which other dots are dropped, in mm; 0 .. 1e6; default 0 =
   * half the pen's width
   */
  dotDistance?: number;
  /** speed of a plotter's pen on the paper, in mm/s; above 0, up to 1e6; default 30 */
  drawSpeed?: number;
  /** speed of a plotter's pen above the paper, in mm/s; above 0, up to 1e6; default 80 */
  travelSpeed?: number;
  /** seconds that it takes to lower or to raise the pen; 0 .. 3600; default 0.15 */
  penSeconds?: number;
  /** GCODE: lines that lower the pen; default NULL = "G1 Z0" */
  penDown?: string;
  /** GCODE: lines that raise the pen; default NULL = "G0 Z5" */
  penUp?: string;
  /** title of the file, UTF-8; default NULL = none */
  title?: string;
  /** description of the file, UTF-8; default NULL = none */
  description?: string;
  /** text about the model, the camera or the style, UTF-8; default NULL = none. The library's version is added */
  metadata?: string;
  /** a list of drawings; default NULL */
  items?: readonly PageItem[];
  /** a list of pens; default NULL */
  pens?: readonly Pen[];
  /** a list of annotations; default NULL */
  annotations?: readonly Annotation[];
  /**
   * in plot order, length that the pen draws at most before it is raised, in mm; 1 .. 1e6, or 0 = no limit;
   * default 0. A longer line is cut into equal parts
   */
  longest?: number;
}

/** What was written. */
export interface PageInfo {
  /** bytes of the file */
  readonly bytes: number;
  /** groups of ink */
  readonly groups: number;
  /** lines and outlines */
  readonly paths: number;
  /** curves or straight lines of all paths */
  readonly segments: number;
  /** dots */
  readonly dots: number;
  /** in plot order, pairs of ends that became one line */
  readonly joined: number;
  /** lines dropped because they are too short for the pen */
  readonly droppedPaths: number;
  /** dots dropped because they are too near to others for the pen */
  readonly droppedDots: number;
  /** width of the page, in mm */
  readonly width: number;
  /** height of the page, in mm */
  readonly height: number;
  /** length that a pen draws, in mm; in plot order, else 0 */
  readonly drawn: number;
  /** length that a pen travels above the paper, in mm; in plot order, else 0 */
  readonly travelled: number;
  /** time that a plotter takes at the given speeds, in seconds; in plot order, else 0 */
  readonly seconds: number;
  /** lines wider than their pen, drawn in several passes */
  readonly filledPaths: number;
  /** lines longer than `longest`, cut into parts */
  readonly cutPaths: number;
}

/** Values of a source's points, such as the colours or a quality that a file has at its vertices. */
export interface SourceField {
  /** HRBFNPR_FIELD_KIND_...; default SCALAR */
  kind?: FieldKindName | number;
  /** name for styles; UTF-8, 1 to 63 bytes, copied; not NULL */
  name?: string;
  /**
   * values, one for each point; n x 1 (SCALAR) or n x 3, FLOAT32, FLOAT64 or UINT8. Colours of UINT8 are 0 .. 255.
   * A point with a value that is not finite has none
   */
  values?: ArrayInput;
}

/**
 * What is drawn, of one of four kinds: points (with or without normals), a mesh (points and triangles), a model,
 * or a
 * point set.  A model and a point set together are a model with its marks, which are used as they are.
 */
export interface PictureSource {
  /** HRBFNPR_SOURCE_...; default 0 */
  flags?: number;
  /** points, or the vertices of the triangles; n x 3, FLOAT32 or FLOAT64. Points that are not finite are left out */
  points?: ArrayInput;
  /**
   * normals of the points, of any length; n x 3, FLOAT32 or FLOAT64; not given, or all zero = no normals. They are
   * not read for a mesh
   */
  normals?: ArrayInput;
  /** triangles of a mesh, as numbers of points from 0; m x 3, INT32, INT64 or UINT32; not given = points */
  triangles?: ArrayInput;
  /**
   * edges of a mesh, as pairs of vertices, whose faces have separate normals in the file; k x 2, INT32, INT64 or
   * UINT32; read with HAS_SHARP_EDGES
   */
  sharpEdges?: ArrayInput;
  /** a model, which the picture keeps; default NULL */
  model?: Model;
  /** a point set, which the picture keeps; default NULL. It must be the only source, unless it comes with a model */
  pointSet?: PointSet;
  /** direction that is up by the convention of the file's format; default 0, 0, 0 = not known */
  up?: Numbers;
  /** reason for `up` in notes, such as "PLY files"; default NULL = "files of this kind" */
  upBy?: string;
  /** place where the scanner stood; read with HAS_VIEWPOINT */
  viewpoint?: Numbers;
  /**
   * number of columns of a depth camera's image, whose points are given row by row; default 0 = the points are no
   * image
   */
  columns?: number;
  /** number of rows of that image; default 0 */
  rows?: number;
  /** name of the file, for titles and metadata, UTF-8; default NULL */
  name?: string;
  /**
   * a list of values of the points or vertices, copied; default NULL. Places on the surface have those of the
   * nearest place of the mesh, or of the nearest point. A layer style that names one gets it, see
   * hrbfnpr_picture_create
   */
  fields?: readonly SourceField[];
}

/**
 * A field to change after everything was chosen.  `field` is the path of the field:
 *
 *    style.F            a field of hrbfnpr_style; style.ink is the ink of all layers, lines and contours
 *    style.KIND.F       a field of hrbfnpr_layer_style, for one kind of layers: style.hatch.ink
 *    style.layers.F     the same for all layers of the style; share is multiplied
 *    style.lines.F      a field of hrbfnpr_line_style, for all lines
 *    style.LINE.F       the same for one kind of lines: style.ridge.width
 *    style.palette      inks for ink fields, #rrggbb with commas between; empty = up to three, from the colours
 *    style.field        what fields of the source change, as USE=NAME with commas between:
 * "tone=quality,ink=rgb".  USE
 *                       is tone, density, width, ink, mask or direction.  The first five set
 * style.layers.tone_field
 *                       and so on, the last sets marks.direction_field.  Without a NAME, the use ends
 *    marks.direction_field  name of a DIRECTION field of the source, which hatching follows
 *    fit.F              a field of hrbfnpr_fit_desc
 *    mesh_fit.F         a field of hrbfnpr_mesh_fit_desc
 *    marks.F            a field of hrbfnpr_generate_desc
 *    marks.KIND.F       a field of hrbfnpr_layer_desc, for one kind of layers; marks.layers.F for all layers
 *    line_set.F         a field of hrbfnpr_line_set_desc
 *
 * Lengths in pixels are those of this picture: they are not scaled by the pen.  The last change of a field
 * counts.
 */
export interface Change {
  /** path of the field, UTF-8 */
  field?: string;
  /**
   * new value: a number, several numbers with commas between, a colour as #rrggbb or #rrggbbaa, or the name of a
   * constant without its prefix, such as "blue-noise"
   */
  value?: string;
}

/** A note: something that was chosen, repaired, left out or measured, or that may be wrong. */
export interface Note {
  /** what it is about, HRBFNPR_NOTE_... */
  code?: NoteName | number;
  /** how much it matters, HRBFNPR_SEVERITY_... */
  severity?: SeverityName | number;
  /** number of `figures` that are set, 0 .. 8 */
  figureCount?: number;
  /** figures of the code, in the order of its brackets */
  figures?: Numbers;
  /**
   * a short sentence without a full stop, UTF-8, in the words of `wording`; at most 100 bytes for notes and
   * warnings
   */
  text?: string;
  /** what to do about it, in the same words; NULL if the text says it or nothing needs doing */
  advice?: string;
  /** one or two more sentences that explain the text, in the same words; NULL if none */
  detail?: string;
}

/** What happens while a picture is made: a new note, or the progress of a stage. */
export interface PictureEvent {
  /** stage that runs, HRBFNPR_STAGE_...; 0 = none runs */
  stage?: StageName | number;
  /** progress of the stage: 0 when it begins, 1 when it ends; 0 with a note */
  fraction?: number;
  /** time that the stage took, when it ends; else 0 */
  seconds?: number;
  /** name of the stage, such as "place marks"; NULL with a note */
  name?: string;
  /** the same for a progress bar, such as "placing marks"; NULL with a note */
  doing?: string;
  /** result of the stage in words, when it ends; else NULL */
  says?: string;
  /** a new note; NULL = the event is about the stage */
  note?: Note;
}

/**
 * How a picture is made.  Each field has a default that makes a good picture.  A source is enough, and a style
 * if
 * wanted.  A default of NaN, 0 or NULL is chosen by the picture, as its line says.
 */
export interface PictureDesc {
  /** HRBFNPR_PICTURE_...; default 0 */
  flags?: number;
  /** a list of 1 to 10000 sources, each a separate surface; NULL for hrbfnpr_picture_restyle */
  sources?: readonly PictureSource[];
  /**
   * named style, HRBFNPR_PRESET_...; default CONTOUR_AND_STIPPLE
   *
   * Style.
   */
  preset?: PresetName | number;
  /** how notes and errors write options, HRBFNPR_WORDING_...; default FIELDS */
  wording?: WordingName | number;
  /** name of a preset, in place of its number; default NULL */
  styleName?: string;
  /**
   * a style to use as it is, with lengths in pixels of this picture; default NULL. `preset` then says which layers
   * of marks there are
   */
  style?: Style;
  /** settings for what this descriptor leaves at its defaults; the picture keeps them; default NULL */
  settings?: Settings;
  /** a list of fields to change; default NULL */
  changes?: readonly Change[];
  /** a list of dabs that paint the surface; default NULL */
  dabs?: readonly Dab[];
  /**
   * width of the drawing, in pixels, 1 .. 32768, given with `height`; default 0 = from `size`
   *
   * Size, in pixels.
   */
  width?: number;
  /** height of the drawing, in pixels, 1 .. 32768, given with `width`; default 0 = from `size` */
  height?: number;
  /**
   * longer side of the drawing, in pixels, 1 .. 32768; the shorter side is as the object needs it; default 0 =
   * 1600
   */
  size?: number;
  /** sides on which marks are drawn, HRBFNPR_PICTURE_SIDES_...; default AUTO */
  sides?: PictureSidesName | number;
  /**
   * radius of the pen in pixels, which styles vary a little; 1e-6 .. 1e6; default 0 = an 800th of the longer side,
   * at least 0.75
   */
  pen?: number;
  /** width of contours, in pixels; other lines are finer; 1e-6 .. 1e6; default 0 = that of the style */
  lineWidth?: number;
  /**
   * a camera to use as it is, with its viewport as the size; default NULL
   *
   * Camera.
   */
  camera?: Camera;
  /** direction that is up; default 0, 0, 0 = by the format and the shape, or y where neither tells */
  up?: Numbers;
  /**
   * azimuth of the camera about the up axis, from the front to the right, in degrees; default NaN = 30, and
   * another where that sees the back of an open surface
   */
  azimuth?: number;
  /** elevation of the camera above the horizon, in degrees; default NaN = 20 */
  elevation?: number;
  /** direction from the eye into the scene, in place of azimuth and elevation; default 0, 0, 0 = not given */
  direction?: Numbers;
  /** place of the eye, which looks at `target`; default NaN = not given */
  eye?: Numbers;
  /** place that the eye looks at; default NaN = the middle of the model */
  target?: Numbers;
  /**
   * vertical angle of view, in degrees, 0.01 .. 179; 0 = orthographic; default NaN = 30, or 0 in the style
   * archaeological
   */
  fov?: number;
  /** share of the picture that is free on each side, 0 .. 0.45; default NaN = 0.05 */
  margin?: number;
  /**
   * angle of an orbit that starts here, in degrees; the picture has room for all of it; default 0 = a still
   * picture
   */
  turn?: number;
  /** number of frames of that orbit, 1 .. 1000000; default 36 */
  turnFrames?: number;
  /**
   * what is known of the normals of points, HRBFNPR_NORMALS_...; default AUTO
   *
   * From the source to a surface.
   */
  normals?: NormalsName | number;
  /**
   * number of samples of a mesh, or chosen from points, 0 .. 1e9; default 0 = as many as a mesh needs, and of
   * points all up to 4096
   */
  samples?: number;
  /**
   * samples are chosen until the surface is this near to the mesh, or to all points, in units of the source; 0 or
   * more; default 0 = 0.002 diagonals for a mesh, and no such end for points
   */
  tolerance?: number;
  /** the most samples that are chosen, 0 or more; default 0 = 8000 for a mesh, and no limit for points */
  maximumCentres?: number;
  /** parts of a mesh that are kept, HRBFNPR_PARTS_...; default AUTO */
  parts?: PartsName | number;
  /** edges of a mesh that are sharp, HRBFNPR_PICTURE_EDGES_...; default AS_GIVEN */
  edges?: PictureEdgesName | number;
  /**
   * angle between the normals of two faces, in degrees, above which their edge is sharp, with EDGES_SHARP; 5 ..
   * 175; default 30
   */
  edgeAngle?: number;
  /**
   * angle between the normals of two faces, in degrees, above which they do not share corner normals; 0 .. 180;
   * default NaN = 60
   */
  creaseAngle?: number;
  /**
   * how often faces are divided into four towards a round surface, 0 .. 6; default -1 = where faces are coarse and
   * no edges stand out
   */
  subdivide?: number;
  /** whether a section is drawn beside the drawing, HRBFNPR_PROFILE_...; default AUTO */
  profile?: ProfileName | number;
  /** place where the scanner stood, to which open surfaces without normals look; default NaN = as the source says */
  viewpoint?: Numbers;
  /**
   * factor of the width over which the image of a depth camera is smoothed, 0 .. 100; 0 leaves its points where
   * they are; default NaN = 1
   */
  depthSmoothing?: number;
  /** seed of all random numbers; default 1 */
  randomSeed?: number;
  /**
   * kinds of layers of marks with commas between, such as "stipples,hatch"; default NULL = those of the style
   *
   * Marks, lines, and what stands beside the drawing.
   */
  markKinds?: string;
  /**
   * points where marks of the published method start; n x 3, FLOAT32 or FLOAT64; not given = by seed_source of
   * hrbfnpr_generate_desc
   */
  seedPoints?: ArrayInput;
  /** angle by which all lines of hatching are turned, in degrees, -360 .. 360; default 0 */
  hatchAngle?: number;
  /**
   * kinds of lines with commas between: contour, suggestive, ridges, valleys, apparent, parabolic,
   * isophotes=0.3:0.6, section=z:20, border, crease, shadow, terminator, soft, tangent; "none" = no lines, so that
   * contours are drawn by marks with VISIBILITY_PUBLISHED only; default NULL = those of the style
   */
  lines?: string;
  /**
   * unit of a scale bar below the drawing; "none" = no bar; default NULL = "units" in the style archaeological,
   * else "none"
   */
  scaleBar?: string;
  /** gets events for as long as the picture lives; default NULL */
  onEvent?: PictureEventFn;
  /**
   * whether the picture has a ground, and where, HRBFNPR_PICTURE_GROUND_...; default NONE
   *
   * Ground.
   */
  ground?: PictureGroundName | number;
  /**
   * height of the ground with GROUND_HEIGHT along the unit vector of the up direction, in units of the source;
   * default 0
   */
  groundHeight?: number;
}

/**
 * What a source holds.  A field that does not apply to the kind of source is 0.  If the source cannot be drawn,
 * fields
 * that were not examined any more are 0.
 */
export interface SourceInfo {
  /** kind of the source, HRBFNPR_SOURCE_KIND_... */
  readonly kind: SourceKindName | number;
  /**
   * severity of the worst finding, HRBFNPR_SEVERITY_...: INFO = no finding; NOTE = a picture repairs it; WARNING =
   * something is wrong; FAILURE = it cannot be drawn
   */
  readonly severity: SeverityName | number;
  /** which way the normals of points or faces look, HRBFNPR_NORMALS_LOOK_... */
  readonly normalsLook: NormalsLookName | number;
  /** points as given: points, vertices of a mesh, centres of a model, marks of a point set */
  readonly points: number;
  /** triangles as given */
  readonly triangles: number;
  /** points at a value that means "no data"; all fields below leave them out */
  readonly noData: number;
  /** points far from all others; all fields below leave them out */
  readonly strays: number;
  /** points without a finite position */
  readonly pointsNotFinite: number;
  /** points, or vertices of faces, at the place of another */
  readonly duplicates: number;
  /** least coordinates of the finite points */
  readonly boundsMin: Numbers;
  /** greatest coordinates of the finite points */
  readonly boundsMax: Numbers;
  /** diagonal of these bounds */
  readonly diagonal: number;
  /** direction that a picture chooses as up, for points and meshes; up_reason says why */
  readonly up: Numbers;
  /**
   * 1: some normals are given that are not zero
   *
   * Normals of points. looks_down, normals_closed and normals_flipped_share are set for faces, too.
   */
  readonly hasNormals: number;
  /** 1: the points lie along curves, such as wires or cross sections */
  readonly alongCurves: number;
  /** axis along which a terrain looks down: 1 = y, 2 = z; 0 = it does not, or is no terrain */
  readonly looksDown: number;
  /** normals that are zero */
  readonly normalsZero: number;
  /** normals that are not finite */
  readonly normalsNotFinite: number;
  /** share of the usable normals that have length 1, 0 .. 1 */
  readonly normalsUnitShare: number;
  /**
   * median over the samples of the sum of the winding numbers on both sides: 1 = closed and outward, -1 = inward,
   * 0 = a flat sheet; 0 for points along curves
   */
  readonly normalsClosed: number;
  /** share of the normals that look flipped beside their neighbours, 0 .. 1; 0 for points along curves */
  readonly normalsFlippedShare: number;
  /**
   * pixels that have a point
   *
   * The image of a depth camera, if it has no normals.
   */
  readonly imageSeen: number;
  /** pixels among these that lie on no surface */
  readonly imageDropped: number;
  /** median depth of the pixels that have a point */
  readonly imageDepth: number;
  /** standard deviation of the depth, at that depth */
  readonly imageNoise: number;
  /**
   * 1: each edge has two faces, which run along it in opposite directions
   *
   * A mesh as it was given, except that vertices at the same place are joined.
   */
  readonly closed: number;
  /** 1: the mesh is closed, and its faces look inward */
  readonly insideOut: number;
  /** parts that share no vertex */
  readonly components: number;
  /** parts without a border whose faces look inward; inside another part it is a cavity */
  readonly componentsInsideOut: number;
  /** edges with one face */
  readonly boundaryEdges: number;
  /** borders */
  readonly boundaryLoops: number;
  /** edges with more than two faces */
  readonly nonmanifoldEdges: number;
  /** edges among these that hrbfnpr_mesh_create cannot mend */
  readonly nonmanifoldLeft: number;
  /** edges with two faces, one of which is turned over */
  readonly contraryEdges: number;
  /** faces with a corner that is not finite */
  readonly facesNotFinite: number;
  /** faces without area */
  readonly degenerateFaces: number;
  /** faces with the same corners as another */
  readonly repeatedFaces: number;
  /** vertices of no face */
  readonly unusedVertices: number;
  /** area, in squared units of the source */
  readonly area: number;
  /** enclosed volume, in cubed units of the source; 0 if the mesh is not closed */
  readonly volume: number;
  /** reason for `up`, such as "as in PLY files"; "" = up is not known */
  readonly upReason: string;
}

/** What a picture is made of. */
export interface PictureInfo {
  /** named style as used, HRBFNPR_PRESET_... */
  readonly preset: PresetName | number;
  /** number of surfaces; 1 for a point set */
  readonly parts: number;
  /** marks of all parts */
  readonly marks: number;
  /** number of notes, for hrbfnpr_picture_get_note */
  readonly notes: number;
  /** number of stages that have ended, for hrbfnpr_picture_get_stage */
  readonly stages: number;
  /** width of the drawing, in pixels; 0 with SURFACE_ONLY */
  readonly width: number;
  /** height of the drawing, in pixels; 0 with SURFACE_ONLY */
  readonly height: number;
  /** least coordinates of all parts */
  readonly boundsMin: Numbers;
  /** greatest coordinates of all parts */
  readonly boundsMax: Numbers;
  /** direction that is up, as used */
  readonly up: Numbers;
  /** radius of the pen as used, in pixels */
  readonly pen: number;
  /** time that it took to make the picture */
  readonly seconds: number;
}

/**
 * One surface of a picture.  Its handles are valid while the picture lives; the caller retains those that it
 * keeps
 * longer.
 */
export interface PicturePart {
  /** sides on which marks are drawn, as used, HRBFNPR_SIDES_... */
  sides?: SidesName | number;
  /** its model; NULL for a point set */
  model?: Model;
  /**
   * the marks that the planned camera draws: all marks with KEEP_MARKS, else a set of
   * hrbfnpr_point_set_generate_still; NULL with SURFACE_ONLY
   */
  pointSet?: PointSet;
  /** its lines; NULL without lines */
  lineSet?: LineSet;
  /** the mesh that it was fitted to; NULL for other sources */
  mesh?: Mesh;
}

/** The paper and the pens with which a drawing is written. */
export interface PicturePageDesc {
  /**
   * format, flags, tolerance, speeds, pens and the like; default NULL = its defaults. The call sets items,
   * annotations and size, and title, description and metadata where they are NULL
   */
  page?: PageDesc;
  /**
   * paper that the drawing fills, turned as it fits better: "a0" .. "a6", "letter", "legal", "tabloid", or width
   * and height in mm, such as "210x297"; default NULL = a pixel is 25.4 / 96 mm
   */
  paper?: string;
  /** free margin on each side of the paper, in mm; 0 or more; default 10 */
  paperMargin?: number;
  /**
   * widths of the pens at hand, in mm, ascending; n x 1, FLOAT64; not given = `page` says. Each group gets the pen
   * nearest to the median width of its lines
   */
  penWidths?: ArrayInput;
}

/** A sheet of views.  Texts are UTF-8, and are read during the call only. */
export interface ViewsDesc {
  /** HRBFNPR_VIEWS_...; default 0 */
  flags?: number;
  /** where views stand, HRBFNPR_VIEWS_ANGLE_...; default FIRST */
  projection?: ViewsAngleName | number;
  /** how hidden edges are drawn, HRBFNPR_VIEWS_HIDDEN_...; default DASHED */
  hidden?: ViewsHiddenName | number;
  /**
   * names of views with commas between: front, back, left, right, top, bottom, iso; each is drawn once; default
   * NULL = "front,left,top,iso", or "front,right,top,iso" with ANGLE_THIRD
   */
  views?: string;
  /**
   * cutting planes with semicolons between: "z:20" cuts at z = 20, "z" through the middle, "1:1:0:5" at x + y = 5;
   * default NULL = none. "+z:20" is seen from above and "-z:20" from below. An axis without a sign is seen from
   * the front, from above, or from the side that is drawn. Sections are called A-A, B-B and so on
   */
  sections?: string;
  /**
   * paper: "a0" .. "a6", "letter", "legal" or "tabloid", in landscape format, or width and height in mm, such as
   * "297x210"; default NULL = "auto" = the smallest of a4 to a0 that has room at the scale, or a3 if the scale is
   * "auto", too
   */
  paper?: string;
  /**
   * scale, such as "1:2" for half the size; default NULL = "auto" = the largest of 1, 2 and 5 times a power of ten
   * that has room on the paper [ISO 5455]
   */
  scale?: string;
  /**
   * thin lines where the surface bends without an edge, as kinds with commas between: ridges, valleys, suggestive;
   * default NULL = "none"
   */
  smooth?: string;
  /** title in the title block; default NULL; NULL and "" = `model` without the ending of its name */
  title?: string;
  /** name of the file in the title block; default NULL; NULL and "" = the name of the picture's source */
  model?: string;
  /** mm of a unit of the model, above 0, up to 1e9; default 0 = 1, or 1000 with UNIT_IS_METRE */
  unitMm?: number;
  /**
   * angle between two faces of a mesh, in degrees, above which their edge is sharp; above 0, up to 1e9; default
   * 30. Larger: fewer edges
   */
  creaseAngle?: number;
  /** width of outlines, in mm; thin lines are half as wide; 0.01 .. 1000; default 0.5 */
  lineWidth?: number;
  /** distance between the lines in cut faces, in mm; 0.01 .. 1000; default 3 */
  hatchSpacing?: number;
  /** free space between views, in mm; above 0, up to 1e9; default 15 */
  spacing?: number;
  /**
   * format, flags, tolerance, speeds and the like; default NULL = its defaults with a tolerance of 0.02. The call
   * sets items, annotations, pens and size, and title and description where they are NULL
   */
  page?: PageDesc;
  /** how tangent edges are drawn, HRBFNPR_VIEWS_TANGENT_...; default SHORT */
  tangent?: ViewsTangentName | number;
}

/** The sheet that was written. */
export interface ViewsInfo {
  /** number of views and sections */
  readonly views: number;
  /** bytes that were written */
  readonly bytes: number;
  /** width of the page, in mm */
  readonly width: number;
  /** height of the page, in mm */
  readonly height: number;
  /** scale as a number: 0.5 for 1:2 */
  readonly scale: number;
  /** mm of a unit of the model, as used */
  readonly unitMm: number;
  /** scale in words, such as "1:2" */
  readonly scaleText: string;
  /** paper, such as "a3" or "297 x 210" */
  readonly paper: string;
  /** with VERIFY, drawn pieces of lines that rays were compared with */
  readonly pieces: number;
  /** pieces whose decided rays all agree with the drawing */
  readonly agreeing: number;
  /** pieces without a decided ray: they are within 0.05 mm of an edge, in the view or in depth */
  readonly undecided: number;
  /** pieces that were divided, or drawn otherwise, because rays disagreed */
  readonly repaired: number;
}

