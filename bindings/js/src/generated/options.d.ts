// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.

import type { CapName, ClassName, CreasesName, CsgName, DabName, DensityName, DepthName, DistributionName,
  DotShapeName, EdgesName, FacesName, HatchGuideName, HiddenLinesName, HiddenPartsName, InstructionSetName,
  KernelName, LayerKindName, LightName, LineKindName, LineTypeName, LogName, NormalsLookName, NormalsName, NoteName,
  OutwardName, PageFormatName, PartsName, PictureEdgesName, PictureSidesName, PresetName, PrimitiveName, ProfileName,
  RegularizationName, RepairName, ScalarName, SeedName, SeverityName, ShapeName, SidesName, SolverName,
  SolverReasonName, SourceKindName, StageName, StrokeStartName, ThreadBackendName, ToneCurveName, ToneName,
  ToneRangesName, ToneRuleName, TrimName, VertexAttributeName, ViewsAngleName, ViewsHiddenName, VisibilityName,
  WidthsName, WordingName } from "./constants.js";
import type { Pointer } from "./functions.js";
import type { AllocateFn, ArrayInput, ArrayOutput, DeallocateFn, DensityFn, DirectionFn, Drawing, ImplicitFn, LineSet,
  LogFn, Mesh, Model, Numbers, PictureEventFn, PointSet, RunTasksFn, Settings, ToneFn } from "../index.js";

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
 * What to fit: N points with N outward normals, and how.  docs/fitting.md
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
   * number of samples. More neighbours give fewer iterations and a longer setup
   */
  preconditionerNeighbours?: number;
  /** HRBFNPR_NORMALS_...: how far `normals` can be trusted; default GIVEN. NONE and AUTO work without normals */
  normalMode?: NormalsName | number;
  /** HRBFNPR_TRIM_...; default AUTO */
  trim?: TrimName | number;
}

/**
 * The points of hrbfnpr_orient: N points without normals, or with normals that may
 * be wrong.  docs/fitting.md explains the method.
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
 * docs/fitting.md explains the method.
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
   * lower corner of the samples' box. For up to 20 000 samples along curves, the box also holds the surface, if
   * that closes within a third of a diagonal around the samples
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
   * R: number of cells of BOX along the longest side of the bounds; 1 to 256; default 8 [NPAR 4.2]. More cells
   * give more seeds and miss fewer sheets. BLUE_NOISE with seed_source AUTO uses at least 16
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
  /** memory that the set keeps */
  readonly bytes: number;
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

/** Lines to find once. */
export interface LineDesc {
  /** HRBFNPR_LINE_KIND_RIDGE, VALLEY, PARABOLIC, SECTION or OWN; RIDGE */
  kind?: LineKindName | number;
  /** up to 63 bytes of UTF-8, for styles; NULL = "" */
  name?: string;
  /** lines go on while their strength is at least `lower` ... */
  lower?: number;
  /**
   * ... and are kept if it is `upper` somewhere; 0 and 0 = those of the kind: 6 and 15 of ridges and valleys, 0
   * and 0 else
   */
  upper?: number;
  /** shorter ones are dropped, in diagonals; 0.01 */
  shortest?: number;
  /** of SECTION: normal of the planes, of any length; (0, 0, 1) */
  plane?: Numbers;
  /** of SECTION: FLOAT64, 1: where the planes are, along the unit normal */
  levels?: ArrayInput;
  /** of OWN: FLOAT32 or FLOAT64, 3: on the surface or near it */
  position?: ArrayInput;
  /**
   * of OWN: UINT32, 1: the first position of each line, ascending, and the end; one whose last position is its
   * first is closed
   */
  lineFirst?: ArrayInput;
}

export interface LineSetDesc {
  /** HRBFNPR_LINE_SET_WITH_...; 0 */
  flags?: number;
  /**
   * of the mesh on which curves are looked for, units of the model; 0 = half the samples' spacing, and finer where
   * walls are thin. Loops that are smaller, and walls that are thinner than 1.75 cells, may be missed
   */
  cellSize?: number;
  /**
   * FLOAT32 or FLOAT64, 3: near each part of the surface; not given = the samples, or places found in the bounds
   * of a custom model
   */
  seedPoints?: ArrayInput;
  /** a list; NULL and 0 */
  lines?: readonly LineDesc[];
  /**
   * where the surface ends for want of samples, as an open scan or a terrain does: where s(x), as of
   * hrbfnpr_trim_desc, exceeds this. Mesh, curves, and what hides them end there, and the end is a border. 1.5
   * ends it some 0.7 spacings beyond the last samples, 3 some 0.9, and leaves larger holes closed. 0 = it ends at
   * the search box only; 0 or more, 0
   */
  support?: number;
  /**
   * FLOAT32 or FLOAT64, 3: those samples; not given = the model's centres. All points of a scan tell better where
   * it ends than the centres chosen from them
   */
  supportPoints?: ArrayInput;
  /** FLOAT32 or FLOAT64, 3: of support_points, as many, of any length; not given = the surface's own there */
  supportNormals?: ArrayInput;
}

export interface LineSetInfo {
  /** of the mesh */
  readonly triangles: number;
  /**
   * of these, triangles that look away from the surface: it is finer than the cells there, and curves may be
   * missed
   */
  readonly turned: number;
  /** seeds that no triangle is near: a part of the surface is too thin for the cells */
  readonly missedSeeds: number;
  /** that were found once, of all elements of the list */
  readonly lines: number;
  /** curves where the surface ends */
  readonly borders: number;
  /** as used */
  readonly cellSize: number;
  /** that it took to make */
  readonly seconds: number;
  /** kept */
  readonly bytes: number;
  /**
   * the share of the area that was looked at that lies beyond the samples, 0 to 1; 0 without support. Of a trimmed
   * model little beyond its end is looked at: see its trim info
   */
  readonly leftOut: number;
  /** curves where sheets of the surface meet, at any angle: from corner to corner, or closed */
  readonly creases: number;
}

export interface Camera {
  /** HRBFNPR_DEPTH_...; of `projection` and of depth buffers */
  depthConvention?: DepthName | number;
  /** world to eye, column-major; the eye looks along -z */
  view?: Numbers;
  /** eye to clip */
  projection?: Numbers;
  /** x, y of the top-left corner, width, height, in pixels */
  viewport?: Numbers;
}

/** How layers are drawn.  Colours are straight RGBA in [0,1], sRGB-encoded. */
export interface LayerStyle {
  /** the layers that this is for: HRBFNPR_LAYER_KIND_...; ANY */
  kind?: LayerKindName | number;
  /** ... and are called so; NULL = any name. Read during _draw only */
  name?: string;
  /** 1 or 0: whether front marks are drawn; 1 */
  shown?: number;
  /**
   * 1 or 0, with VISIBILITY_PUBLISHED: whether marks near a contour draw it; 1. Not of OWN strokes, which may be
   * few
   */
  contours?: number;
  /** of strokes: bit 0 the first direction, bit 1 the second; 3 */
  directions?: number;
  /** HRBFNPR_SHAPE_...; DOTS */
  shape?: ShapeName | number;
  /** 0 .. 1: share of the layer's marks that is used at all; 1 */
  share?: number;
  /** of a mark, half the width of a stroke, pixels, > 0; 1 */
  radius?: number;
  /** 0: radius is in pixels at any zoom; 1: grows with the zoom; between; 0 */
  radiusZoom?: number;
  /** black */
  ink?: Numbers;
  /**
   * darkness from which on there are lines, 0 .. 1; 0.15
   *
   * Of SHAPE_HATCH.  Darkness is 1 - tau, 0 .. 1; the share of the paper that the lines cover grows with it, times
   * `share`.  Lines whose separation is not known have the width 2 * radius where that share is the greatest.
   */
  hatchToneBegin?: number;
  /** darkness from which on they get no wider, > hatch_tone_begin, to 1; 0.95 */
  hatchToneEnd?: number;
  /** > 0, to 1: share covered at hatch_tone_begin; 0.1 */
  hatchCoverageBegin?: number;
  /** > 0, to 1: share covered at hatch_tone_end; 0.82 */
  hatchCoverageEnd?: number;
  /** least from line to line, pixels, > 0; 4.6 */
  hatchSpacing?: number;
  /**
   * least width of a line, pixels, > 0; 0.6. Less only where lines fade in or end, or are closer together than
   * hatch_spacing
   */
  hatchPen?: number;
  /** left between lines at least, pixels, 0 or more; 1.2 */
  hatchWhite?: number;
  /**
   * over which a line narrows where it ends by its tone, pixels, 0 or more; 20. Where it ends for another reason
   * it is shorter
   */
  hatchTaper?: number;
  /** pieces below this are not drawn, those up to twice of it are thinner; pixels, 0 or more; 10 */
  hatchShortest?: number;
  /**
   * how far a line may stray to either side, as of an unsteady hand, in hatch_pens, 0 .. 16; 0. From swing to
   * swing it is about 60 hatch_pens
   */
  hatchWobble?: number;
  /** lines run on past the tone that they end at by up to this, each by another length; pixels, 0 or more; 0 */
  hatchOvershoot?: number;
  /** of the two above: any number; 0 */
  hatchSeed?: number;
}

/** How the lines of one kind are drawn, of items that have a line set.  Lengths are in pixels. */
export interface LineStyle {
  /** HRBFNPR_LINE_KIND_...; CONTOUR */
  kind?: LineKindName | number;
  /** of lines found once: those that are called so; NULL = any name. Read during _draw only */
  name?: string;
  /** HRBFNPR_HIDDEN_PARTS_...; NONE */
  hidden?: HiddenPartsName | number;
  /** HRBFNPR_CAP_...: of free ends; ROUND */
  cap?: CapName | number;
  /** > 0; 2 */
  width?: number;
  /**
   * over which a line narrows to a free end, half an ellipse; 0 = not at all; 12. A part with a free end that is
   * shorter than two tapers is the thinner, the shorter it is
   */
  taper?: number;
  /** of ATTENUATED and DASHED, > 0; 1.2 */
  hiddenWidth?: number;
  /** 0 .. 1: of ATTENUATED, for each layer; 0.35 */
  hiddenOpacity?: number;
  /** of DASHED, in hidden_widths, > 0; 5 */
  dash?: number;
  /** between dashes, in hidden_widths, > 0; 3 */
  gap?: number;
  /**
   * parts with a free end, and hidden ones, that are shorter are not drawn; 2. Feature lines that are found with
   * every drawing measure 0.01 diagonals or more
   */
  shortest?: number;
  /** 0 .. 1: how much paler a line is where its strength is `lower` than where it is `upper`; 1 */
  fade?: number;
  /**
   * strengths as in hrbfnpr_line_desc; 0 and 0 = those of the kind: 10 and 30 of suggestive contours, 12 and 25 of
   * apparent ridges, 15 and 30 (degrees) of creases
   */
  lower?: number;
  upper?: number;
  /** of ISOPHOTE: FLOAT64, 1: -1 .. 1. Read during _draw only */
  levels?: ArrayInput;
  /** straight RGBA; black */
  ink?: Numbers;
  /**
   * of CONTOUR and BORDER, where nothing lies beside the line on its outer side: the outline of all items that
   * have lines. Falls to 1 over 6 widths beyond its ends; 1
   *
   * Laws of the width: factors, 0 .. 16, of which all that apply to a place are multiplied; 1 = no effect.  By
   * depth,
   * light and radial curvature goes the distance between a contour and an isophote [Goodwin et al. 2007].
   */
  outlineFactor?: number;
  /**
   * at the farthest place in the viewport of lines that are drawn, hidden ones too; 1 at the nearest, evenly by
   * depth between; 1
   */
  farFactor?: number;
  /**
   * where the surface faces the style's light, whatever its tone; 1 where it faces away, evenly by n . l between;
   * 1
   */
  litFactor?: number;
  /**
   * where the surface bends sharply; 1 where its radius of curvature is curvature_radius or more, evenly by the
   * radius between. Of CONTOUR the radial curvature, along the line of sight; of others the normal curvature
   * across the line; 1
   */
  curvatureFactor?: number;
  /** diagonals, > 0; 0.1 */
  curvatureRadius?: number;
  /**
   * how far a line may stray to either side, widths, 0 .. 16; 0
   *
   * An unsteady hand, the same in each drawing and, as the lengths are in widths, at each size of the picture.
   */
  wobble?: number;
  /** 0 .. 1: the share by which its width may vary; 0 */
  wobbleWidth?: number;
  /** from swing to swing, about, widths, >= 1; 40 */
  wobbleLength?: number;
  /** 0 */
  wobbleSeed?: number;
  /** of CREASE: HRBFNPR_CREASES_...; ALL */
  creases?: CreasesName | number;
}

export interface Style {
  /** HRBFNPR_TONE_...; LIGHT */
  tone?: ToneName | number;
  /** straight RGBA; alpha 0 = transparent; white. One for all styles of a drawing */
  paper?: Numbers;
  /** a list: a layer of marks takes the first that is for it, or the defaults of _layer_style_init; NULL and 0 */
  layers?: readonly LayerStyle[];
  /**
   * HRBFNPR_TONE_RULE_...; SHARE
   *
   * Tone.
   */
  toneRule?: ToneRuleName | number;
  /** HRBFNPR_TONE_CURVE_...; COVERAGE. For TONE_RULE_SHARE */
  toneCurve?: ToneCurveName | number;
  /** towards the light, normalised on use; (-0.4, 0.6, 0.7) */
  light?: Numbers;
  /** lambda of the tone law, > 0; 1 */
  toneExponent?: number;
  /** for CALLBACK */
  toneFunction?: ToneFn;
  /** HRBFNPR_LIGHT_...; CAMERA */
  lightSpace?: LightName | number;
  /**
   * 0 .. 1, DEPTH_LAYERS: a mark grows from nothing to its full area over this share of the marks shown, instead
   * of popping; 0 = it pops; 0.25
   */
  toneFade?: number;
  /**
   * delta in (0,1): front n.v < -delta, back n.v > delta, else silhouette, v from the camera to the mark [NPAR 6];
   * 0.2
   *
   * Contours that marks draw, with VISIBILITY_PUBLISHED only.  With DEPTH_LAYERS contours are lines of an item's
   * line set.
   */
  silhouetteThreshold?: number;
  /** of a mark, pixels; 1 */
  silhouetteRadius?: number;
  /** as radius_zoom; 0 */
  silhouetteRadiusZoom?: number;
  /** black */
  silhouetteInk?: Numbers;
  /**
   * HRBFNPR_VISIBILITY_...; DEPTH_LAYERS. One for all styles of a drawing
   *
   * Hidden lines.
   */
  visibility?: VisibilityName | number;
  /** HRBFNPR_HIDDEN_LINES_...; ATTENUATE */
  hiddenLines?: HiddenLinesName | number;
  /** lambda of alpha_f = nu^2 lambda; 1 */
  attenuationFront?: number;
  /** lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda; 1 */
  attenuationBack?: number;
  /** of the piece of surface that a mark stands for, pixels; 0 = from the marks' spacing on the screen */
  splatRadius?: number;
  /**
   * n > 0: a depth layer is as opaque as n overlapping splats of opacity alpha, 1 - (1 - alpha)^n, whatever the
   * marks' density and the zoom; 0: each mark paints with alpha itself, as published; 8
   */
  splatOverlap?: number;
  /**
   * DEPTH_LAYERS: how far beyond its contour a surface hides what lies behind, pixels at any zoom. PUBLISHED: how
   * much wider the paper of back marks is, pixels; 2
   */
  haloWidth?: number;
  /**
   * distance from the camera where depth attenuation starts, > 0
   *
   * Distance and zoom.
   */
  depthMin?: number;
  /** ... and where nothing is shown any more; 0 and 0 = off (default) */
  depthMax?: number;
  /**
   * pixels per world unit at which marks are shown in full; 0 = off. Below it the chance to be shown is scale =
   * zoom^zoom_exponent, exponential in the zoom level ln zoom; the area of the paper of back marks scales alike
   * [NPAR 6.2]
   */
  zoomReference?: number;
  /** >= 0; 2 keeps the ink per area */
  zoomExponent?: number;
  /**
   * a list; NULL and 0
   *
   * Lines, with DEPTH_LAYERS, of items that have a line set.
   */
  lines?: readonly LineStyle[];
  /**
   * Of TONE_LIGHT, DEPTH_LAYERS and TONE_RULE_SHARE: 0 .. 1, light from the side opposite to `light`, so that what
   * is turned away keeps its form: tau = fill_light * (n . l)^2 where n . l < 0.  The lit side stays as it is;
   * 0.25
   */
  fillLight?: number;
}

/** Where the marks of one layer are in this drawing: of an animated surface. */
export interface LayerPose {
  /** of the item's point set */
  layer?: number;
  /** n x 3, FLOAT32 or FLOAT64, absolute, in the order of the layer's n marks */
  position?: ArrayInput;
  /** n x 3, FLOAT32 or FLOAT64, unit, outward */
  normal?: ArrayInput;
  /** n x 3, FLOAT32 or FLOAT64, unit; empty = those of the set */
  direction?: ArrayInput;
}

/**
 * One thing to draw.  Everything it points to is read during _draw only, but
 * the drawing retains the point set.
 */
export interface Item {
  /** HRBFNPR_SIDES_...; FRONT */
  sides?: SidesName | number;
  pointSet?: PointSet;
  /** NULL = default style */
  style?: Style;
  /**
   * NULL, or the surface that the marks lie on: with DEPTH_LAYERS, what hides a mark is then found by casting a
   * ray from it to the eye, exact but slow
   */
  model?: Model;
  /** object to world, column-major, affine, invertible */
  transform?: Numbers;
  /** a list: layers whose marks have moved; NULL and 0 */
  poses?: readonly LayerPose[];
  /**
   * NULL, or what the style's lines are drawn from. All items of a drawing that have one hide each other's lines;
   * others hide none
   */
  lineSet?: LineSet;
}

export interface DrawingInfo {
  readonly items: number;
  /** for hrbfnpr_drawing_get_layer_info */
  readonly layers: number;
  /** of ink */
  readonly dots: number;
  readonly strokes: number;
  /** of all strokes */
  readonly strokePoints: number;
  /** in all items, of the layers that the styles use: outside + front + back + silhouette + culled */
  readonly marks: number;
  /** outside the frustum */
  readonly outside: number;
  /** of those inside: by class */
  readonly front: number;
  readonly back: number;
  /** PUBLISHED */
  readonly silhouette: number;
  /** DEPTH_LAYERS: marks that are of no class, since no tone could show them: they were not looked at one by one */
  readonly culled: number;
  /** drawn as ink */
  readonly shown: number;
  /** front marks not shown because of light or share */
  readonly droppedTone: number;
  /** front and silhouette marks not shown because of depth attenuation */
  readonly droppedDepth: number;
  /** front marks not shown because of tone scaling */
  readonly droppedZoom: number;
  /** marks not drawn because nothing of them is seen through what is in front */
  readonly droppedHidden: number;
  /** PUBLISHED: discs of paper; DEPTH_LAYERS: marks that depth layers were found from */
  readonly splats: number;
  /** transform, classify, tone */
  readonly nanosecondsClassify: number;
  readonly nanosecondsVisibility: number;
  readonly nanosecondsSort: number;
  /** kept by the drawing */
  readonly bytes: number;
  /** kept by its renderer, drawings left out */
  readonly scratchBytes: number;
  /** curves that lines were drawn from */
  readonly lineCurves: number;
  /** of these */
  readonly lineCusps: number;
  /** of their images, where the farther one changes its visibility */
  readonly lineCrossings: number;
  /** curves that end inside the surface, and places where one was missed */
  readonly lineBroken: number;
  /** curves whose visibility did not add up: each part is as a ray of its own says */
  readonly lineSettled: number;
  /** of these, curves with a part whose ray was not certain */
  readonly lineContradictions: number;
  readonly nanosecondsLines: number;
  /** curves whose visibility did not add up at first: they, and those that cross them, were made finer */
  readonly lineRefined: number;
  /**
   * cells of the image, four pixels wide or more, with so many crossings that none was taken: lines run to and fro
   * over one another there, as on a flat face seen edge-on
   */
  readonly lineTangles: number;
}

/** A layer of a drawing: ink of one layer of marks, of the front or (PUBLISHED) of contours; or lines. */
export interface DrawingLayerInfo {
  /** HRBFNPR_CLASS_FRONT or SILHOUETTE */
  readonly markClass: ClassName | number;
  readonly item: number;
  /** of the item's point set; -1: of lines */
  readonly layer: number;
  /** HRBFNPR_LAYER_KIND_...; of lines HRBFNPR_LINE_KIND_... */
  readonly kind: LayerKindName | number;
  /** HRBFNPR_SHAPE_... */
  readonly shape: ShapeName | number;
  /** of that layer; of lines the style's, or empty */
  readonly name: string;
  /** straight RGBA */
  readonly ink: Numbers;
  readonly dots: number;
  readonly strokes: number;
}

/**
 * Optional inputs and outputs: width * height elements of one component each,
 * row by row from the top-left pixel of the image, stride between elements as
 * in every array.  Data NULL and count 0 = not wanted.
 */
export interface RasterDesc {
  /** HRBFNPR_RASTER_...; 0 */
  flags?: number;
  /** FLOAT32, camera's convention: ink behind it is not drawn */
  hostDepth?: ArrayInput;
  /** FLOAT32, camera's convention: the nearest surface, the far plane where there is none */
  depth?: ArrayOutput;
  /** UINT32: id of the nearest drawn mark; 0 = none */
  id?: ArrayOutput;
  /** UINT8 or UINT32: HRBFNPR_CLASS_... of that mark */
  markClass?: ArrayOutput;
}

export interface VertexAttribute {
  /** HRBFNPR_VERTEX_ATTRIBUTE_... */
  attribute?: VertexAttributeName | number;
  /** HRBFNPR_SCALAR_... */
  scalar?: ScalarName | number;
  /** bytes from the start of the vertex */
  offset?: number;
}

export interface VertexLayout {
  /** HRBFNPR_PRIMITIVE_...; POINTS */
  primitive?: PrimitiveName | number;
  /** a list, 1 and more */
  attributes?: readonly VertexAttribute[];
  /** bytes of a vertex; 0 = up to the end of its last attribute */
  stride?: number;
}

/**
 * How each mark of a layer is drawn, in the set's own order: a host keeps the
 * set's arrays on the graphics card and uploads only these.  Arrays of the
 * caller's, each of as many elements as the layer has marks, or not given.
 */
export interface MarkResults {
  /** UINT8: the class that it is drawn as, HRBFNPR_CLASS_FRONT or SILHOUETTE; NONE = it is not drawn */
  shown?: ArrayOutput;
  /** FLOAT32, pixels; 0 = not drawn */
  radius?: ArrayOutput;
  /** FLOAT32: the ink's alpha times what is let through; 0 = not drawn */
  opacity?: ArrayOutput;
}

export interface MarkIdentity {
  readonly id: number;
  readonly item: number;
  /** of the item's point set */
  readonly layer: number;
  /** of the layer */
  readonly mark: number;
  /** of the layer; -1 = of none */
  readonly stroke: number;
  /** along the stroke */
  readonly place: number;
}

/**
 * Triangles; quadrilaterals and polygons are cut into them by the caller.
 * A corner that is no number of a vertex, or that a vertex which is not finite
 * belongs to, is INVALID_ARGUMENT, and the message names the face and the
 * index; so are coordinates beyond 1e60, a mesh less than 1e-60 across, and one that has no
 * face left.
 */
export interface MeshDesc {
  /** HRBFNPR_PARTS_...; OUTER */
  parts?: PartsName | number;
  /** n x 3, FLOAT32 or FLOAT64; n < 2^31 */
  vertices?: ArrayInput;
  /** m x 3, INT32, INT64 or UINT32: numbers of vertices, from 0, counter-clockwise as seen from outside; m < 2^29 */
  triangles?: ArrayInput;
  /** degrees, 0 .. 180: faces that meet at a sharper angle do not share their normals; 60 */
  creaseAngle?: number;
  /** HRBFNPR_FACES_...; TURN */
  faces?: FacesName | number;
}

/**
 * Of what is kept, but for the numbers of what was found on the way.  An edge is
 * at the boundary if one face has it, and not manifold if more than two have.
 */
export interface MeshInfo {
  /** 1: no edge is at the boundary or not manifold, and all faces agree */
  readonly closed: number;
  readonly givenVertices: number;
  readonly givenFaces: number;
  /** kept; more than were given where solids that touch in an edge are parted there, at most three for each face */
  readonly vertices: number;
  readonly faces: number;
  /** in the place of another, and joined with it; on borders also within 1e-6 of the diagonal from another */
  readonly weldedVertices: number;
  /**
   * without area but for the rounding of single precision, left out; the face across the largest side is cut in
   * two at the corner that lies within it, so that no slit stays
   */
  readonly degenerateFaces: number;
  /** with the corners of another, left out; both where two solids share a wall */
  readonly repeatedFaces: number;
  /** against those beside them, turned */
  readonly turnedFaces: number;
  /** of the given faces */
  readonly components: number;
  /** closed and inside out, turned */
  readonly turnedComponents: number;
  /** inside a closed one */
  readonly nestedComponents: number;
  readonly leftOutComponents: number;
  /** of these */
  readonly leftOutFaces: number;
  readonly boundaryEdges: number;
  readonly boundaryLoops: number;
  readonly nonmanifoldEdges: number;
  /** whose two faces do not agree: the mesh cannot be oriented, or was not to be */
  readonly contraryEdges: number;
  /** vertices - edges + faces */
  readonly eulerCharacteristic: number;
  /** sum of the handles of all components; -1 where the mesh is not closed */
  readonly genus: number;
  readonly area: number;
  /** enclosed; NaN where the mesh is not closed */
  readonly volume: number;
  readonly boundsMin: Numbers;
  readonly boundsMax: Numbers;
  /** that making it took */
  readonly seconds: number;
  /** kept by the mesh */
  readonly bytes: number;
  /** of the edges that bend by more than 30 degrees, in diagonals of the bounds */
  readonly creaseLength: number;
  /**
   * 1: these stand out, as those of machine parts; hrbfnpr_model_fit_mesh with edges AUTO and the default crease
   * angle keeps them sharp
   */
  readonly creases: CreasesName | number;
}

export interface SampleDesc {
  /**
   * random places to choose from, 0 = 40 for each sample, 1000000 at most; never fewer than samples; as many as
   * samples: all of them, in random order
   */
  candidates?: number;
  /** any number; 1 */
  randomSeed?: number;
}

/** How sharp edges are found. */
export interface MeshEdgesDesc {
  /** HRBFNPR_EDGES_...; AUTO */
  edges?: EdgesName | number;
  /** degrees between the normals of two faces, 1 .. 179: an edge that bends more is sharp; 30 */
  creaseAngle?: number;
  /**
   * coarse faces that a round surface would leave by four fifths of this stay flat, with sharp edges; in units of
   * the mesh; 0 = 0.01 diagonals. A large number, such as the diagonal: only the angle counts
   */
  far?: number;
}

export interface MeshEdgesInfo {
  /** the number of sharp edges */
  readonly edges: number;
  /** the number of smooth patches between them; 1 where no edge is sharp */
  readonly patches: number;
  /** of the sharp edges, in units of the mesh */
  readonly length: number;
  /** of those among them that have the same patch on both sides, as where a crease fades out */
  readonly fading: number;
  /**
   * with AUTO: of edges that bend more than crease_angle but do not stand out, in units of the mesh; 0 where edges
   * are sharp
   */
  readonly doubtful: number;
  readonly seconds: number;
}

/**
 * How near a surface is to a mesh.  "Surface": of the model, within the box of
 * the mesh, grown by 0.05 diagonals; "diagonal" is the mesh's.  What of it is
 * nearest to the mesh's border goes on beyond that, and is left out.  Where
 * closed components overlap, what lies inside is no part of the mesh.
 */
export interface CompareDesc {
  /** that shares are counted for, in units of the mesh; 0 = 0.002 diagonals */
  tolerance?: number;
  /** beyond it a part of the surface is an invention, and a part of the mesh missed; 0 = 0.01 diagonals */
  far?: number;
  /**
   * > 0: what the samples of the model do not bear out by this limit is left out, as a line set with the same
   * `support` does; a custom model has none; 0 = nothing is left out
   */
  support?: number;
  /** on each side, 100 .. 10000000; 0 = 20000 */
  points?: number;
  /**
   * of the cells that the surface is looked for in; 0 = 1/128 of the diagonal, and finer where it is thin. What is
   * thinner or smaller may be missed
   */
  cellSize?: number;
  /** any number; 1 */
  randomSeed?: number;
}

/** Distances in units of the mesh.  p99: 99 % are not farther.  Of no points: NaN. */
export interface Comparison {
  /** places on the surface, even over its area */
  readonly surfacePoints: number;
  /** of their distances from the mesh */
  readonly surfaceMean: number;
  readonly surfaceP99: number;
  readonly surfaceMax: number;
  /** within the tolerance */
  readonly surfaceShare: number;
  /** of the surface, beyond `far` */
  readonly inventedShare: number;
  /** of the surface: beyond the mesh's border, or by `support`; in none of the above */
  readonly leftOutShare: number;
  /** places on the mesh, even over its area */
  readonly meshPoints: number;
  /** of their distances from the surface */
  readonly meshMean: number;
  readonly meshP99: number;
  readonly meshMax: number;
  /** within the tolerance */
  readonly meshShare: number;
  /** of the mesh, beyond `far` */
  readonly missedShare: number;
  /** degrees between the mesh's normals and the surface's beside them */
  readonly normalMean: number;
  readonly normalP99: number;
  /** of the surface */
  readonly components: number;
  /** of the surface, sum over its components; -1 if it has a border in the box */
  readonly genus: number;
  /** as used */
  readonly tolerance: number;
  readonly diagonal: number;
  readonly seconds: number;
}

/** How a mesh is fitted. */
export interface MeshFitDesc {
  /**
   * how near the surface and the mesh are to be to each other, in units of the mesh; 0 = 0.002 diagonals; not
   * below 1e-6 diagonals
   */
  tolerance?: number;
  /** of both that has to be within the tolerance, above 0, at most 1; 0.99 */
  share?: number;
  /** what no part may be beyond; 0 = five times the tolerance */
  far?: number;
  /**
   * 16 .. 1000000; 8000. A fit with sharp edges may have 32 for each of its sheets, if that is more: each is
   * solved alone
   */
  maximumCentres?: number;
  /** places on the mesh to choose from, 1000 .. 10000000; 0 = by its area and its details */
  candidates?: number;
  /** any number; 1 */
  randomSeed?: number;
  /**
   * degrees between the normals of two faces, 5 .. 175: what bends more is an edge, and what rounding would take
   * four fifths of `far` off the mesh; 30
   */
  creaseAngle?: number;
  /** HRBFNPR_EDGES_...; AUTO */
  edges?: EdgesName | number;
}

/**
 * What a fit to a mesh came to: the last of the measurements that it went by,
 * at places of their own.  hrbfnpr_model_compare_mesh measures again, and more.
 */
export interface MeshFitInfo {
  /** 1: tolerance, share and far are kept, both ways */
  readonly reached: number;
  /** as used */
  readonly tolerance: number;
  readonly far: number;
  readonly candidates: number;
  /** all */
  readonly centres: number;
  /** of these, the last ones: where f is held to the distance from the mesh */
  readonly offSurfaceCentres: number;
  /** fits */
  readonly rounds: number;
  /** 1: the mesh has a border, and the surface beyond it was not counted */
  readonly supported: number;
  /** of the surface, within the tolerance of the mesh */
  readonly surfaceShare: number;
  readonly surfaceP99: number;
  readonly surfaceMax: number;
  /** of the mesh, within the tolerance of the surface */
  readonly meshShare: number;
  readonly meshP99: number;
  readonly meshMax: number;
  readonly secondsSample: number;
  /** of all rounds */
  readonly secondsFit: number;
  readonly secondsMeasure: number;
  readonly secondsTotal: number;
  /** smooth pieces that the surface is made of; 1: it has no edges */
  readonly sheets: number;
  /** of the mesh's edges that are sharp */
  readonly creaseLength: number;
  /** of those that are not, as the mesh could not be cut there */
  readonly smoothLength: number;
  /** of space, in each of which a few sheets rule */
  readonly cells: number;
  /** in which no maximum and minimum of its sheets does all that the mesh does */
  readonly poorCells: number;
  /**
   * of the mesh, from 0: two that are nearer to each other than the tolerance, so that the surface may join them;
   * -1, -1: none were found
   */
  readonly touchingParts: Numbers;
  /** where they are */
  readonly touchingPlace: Numbers;
  /** 1: they may go through each other there; 0: they are near to each other */
  readonly partsMayCross: number;
}

/** A drawing on a page. */
export interface PageItem {
  /** what lies beyond its viewport is cut off */
  drawing?: Drawing;
  /** mm: the viewport's left edge; 0 */
  x?: number;
  /** mm: its top edge; 0 */
  y?: number;
  /** mm of a pixel, > 0; 25.4 / 96 */
  scale?: number;
  /** UTF-8, of the group around it; NULL = none */
  name?: string;
}

/** What some groups are drawn with. */
export interface Pen {
  /** HRBFNPR_LINE_TYPE_...; AS_DRAWN */
  lineType?: LineTypeName | number;
  /**
   * a group's name, or the beginning of names and a '*'; NULL = all. Of pens that fit a group the last one is
   * taken
   */
  groups?: string;
  /** mm, >= 0; 0 = as drawn. Plotters: of the pen; 0 = 0.3 */
  width?: number;
  /** straight RGBA; alpha 0 = as drawn, the default */
  ink?: Numbers;
  /** 1 to 255, of a plotter's; 1 */
  number?: number;
}

/** A line, a filled shape or a text beside the drawings. */
export interface Annotation {
  /** HRBFNPR_LINE_TYPE_...; CONTINUOUS */
  lineType?: LineTypeName | number;
  /**
   * UTF-8, of 1 to 95 bytes; "annotations". Those of one group that follow each other share its layer and pen;
   * their inks and types are those of its first
   */
  group?: string;
  /** UTF-8; NULL = the points are a line. Plotters: HPGL writes labels, GCODE none */
  text?: string;
  /** FLOAT32 or FLOAT64, 2, mm: the line, or where the text's baseline begins */
  points?: ArrayInput;
  /** mm, > 0: of the line, or the height of the text's capitals; 0.35 */
  width?: number;
  /** straight RGBA; black */
  ink?: Numbers;
}

export interface PageDesc {
  /** HRBFNPR_PAGE_FORMAT_...; SVG */
  format?: PageFormatName | number;
  /** HRBFNPR_PAGE_IN_PLOT_ORDER and others; 0 */
  flags?: number;
  /** HRBFNPR_WIDTHS_...; OUTLINES */
  widths?: WidthsName | number;
  /** HRBFNPR_DOT_SHAPE_...; CIRCLES */
  dots?: DotShapeName | number;
  /** mm, >= 0; 0 = as far as the drawings reach */
  width?: number;
  /** mm, >= 0; 0 = as far as the drawings reach */
  height?: number;
  /** mm, 0.001 to 10: between what is drawn and what is written; 0.05 */
  tolerance?: number;
  /** 1.01 to 4: ratio of neighbouring classes of widths; 1.25 */
  widthStep?: number;
  /** mm, >= 0: in plot order, see there; 0 = the pen's width */
  join?: number;
  /** mm, >= 0: in plot order shorter lines are dropped; 0 = half the pen's width */
  shortest?: number;
  /** mm, >= 0: in plot order dots nearer to one that stays are dropped; 0 = half the pen's width */
  dotDistance?: number;
  /** mm/s, > 0; 30 */
  drawSpeed?: number;
  /** mm/s, > 0; 80 */
  travelSpeed?: number;
  /** >= 0: to lower or to raise the pen; 0.15 */
  penSeconds?: number;
  /** GCODE: lines that lower it; NULL = "G1 Z0" */
  penDown?: string;
  /** GCODE: lines that raise it; NULL = "G0 Z5" */
  penUp?: string;
  /** UTF-8, or NULL */
  title?: string;
  /** UTF-8, or NULL */
  description?: string;
  /** UTF-8, or NULL: text on the model, the camera, the style; the version is added */
  metadata?: string;
  /** a list */
  items?: readonly PageItem[];
  /** a list; NULL and 0 */
  pens?: readonly Pen[];
  /** a list; NULL and 0 */
  annotations?: readonly Annotation[];
}

/** What was written. */
export interface PageInfo {
  readonly bytes: number;
  readonly groups: number;
  /** lines and outlines */
  readonly paths: number;
  /** curves or straight lines of all paths */
  readonly segments: number;
  readonly dots: number;
  /** in plot order: pairs of ends that became one line */
  readonly joined: number;
  /** too short for the pen */
  readonly droppedPaths: number;
  /** too near to others for the pen */
  readonly droppedDots: number;
  /** mm, of the page */
  readonly width: number;
  /** mm, of the page */
  readonly height: number;
  /** mm that a pen draws; in plot order, else 0, as are the next two */
  readonly drawn: number;
  /** mm between */
  readonly travelled: number;
  /** that a plotter takes at the given speeds */
  readonly seconds: number;
  /** lines wider than their pen, drawn in several passes */
  readonly filledPaths: number;
}

/**
 * One of four kinds: points (with or without normals), a mesh (points and triangles), a
 * model, or a point set.  A model and a point set together are a model with its marks,
 * which are then used as they are.
 */
export interface PictureSource {
  /** HRBFNPR_SOURCE_...; 0 */
  flags?: number;
  /** n x 3, FLOAT32 or FLOAT64: points, or the vertices of the triangles. Points that are not finite are left out */
  points?: ArrayInput;
  /** n x 3, FLOAT32 or FLOAT64, of any length; not given or all zero = none. Not read of a mesh */
  normals?: ArrayInput;
  /** m x 3, INT32, INT64 or UINT32: a mesh; not given = points */
  triangles?: ArrayInput;
  /**
   * k x 2, INT32, INT64 or UINT32: of a mesh, the pairs of vertices whose faces have normals of their own in its
   * file; with HAS_SHARP_EDGES
   */
  sharpEdges?: ArrayInput;
  /** kept; NULL */
  model?: Model;
  /** kept; NULL */
  pointSet?: PointSet;
  /** which way is up by the convention of the file's format; 0, 0, 0 = not known */
  up?: Numbers;
  /** why, for the note: "PLY files"; NULL = "files of this kind" */
  upBy?: string;
  /** where the scanner stood, with HAS_VIEWPOINT */
  viewpoint?: Numbers;
  /** of a depth camera's image, whose points stand row by row; 0 = it is none */
  columns?: number;
  rows?: number;
  /** UTF-8: of the file, for titles and metadata; NULL */
  name?: string;
}

/**
 * One field that is changed on top of all that was chosen.  `field` is the path of a field:
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
 * Lengths in pixels are those of this picture: they are not scaled by the pen.
 */
export interface Change {
  field?: string;
  /**
   * a number, several with commas between, #rrggbb or #rrggbbaa of a colour, or the name of a constant without its
   * prefix: "blue-noise"
   */
  value?: string;
}

export interface Dab {
  /** HRBFNPR_DAB_...; TONE: 1 = light, 0 = dark */
  map?: DabName | number;
  position?: Numbers;
  /** unit: what faces away from it is not painted */
  normal?: Numbers;
  /** > 0 */
  radius?: number;
  /** 0 .. 1 in the middle; it falls to 0 at the radius; 1 */
  strength?: number;
  /** of TONE and DENSITY, 0 .. 1 */
  value?: number;
  /** of DIRECTION: that of hatching */
  direction?: Numbers;
}

export interface Note {
  /** HRBFNPR_NOTE_... */
  code?: NoteName | number;
  /** HRBFNPR_SEVERITY_... */
  severity?: SeverityName | number;
  figureCount?: number;
  /** as above, in that order */
  figures?: Numbers;
  /** one sentence without a full stop, UTF-8, in the words of `wording` */
  text?: string;
  /** what to do about it, in the same words; NULL where the text says it, or there is nothing to say */
  advice?: string;
}

/** What happens while a picture is made. */
export interface PictureEvent {
  /** HRBFNPR_STAGE_... that runs; 0 = between two */
  stage?: StageName | number;
  /** of the stage, 0 when it begins, 1 when it is over */
  fraction?: number;
  /** of the stage, when it is over */
  seconds?: number;
  /** of the stage: "place marks" */
  name?: string;
  /** the same for a progress bar: "placing marks" */
  doing?: string;
  /** what the stage came to, when it is over; else NULL */
  says?: string;
  /** a new one; NULL = this is about the stage */
  note?: Note;
}

/**
 * Every field has a default that makes a good picture; a source and, if wanted, a style are enough.
 * NaN (or 0 or NULL, where a line says so) stands for what is chosen.
 */
export interface PictureDesc {
  /** HRBFNPR_PICTURE_...; 0 */
  flags?: number;
  /** a list, 1 and more: each is a surface of its own */
  sources?: readonly PictureSource[];
  /**
   * HRBFNPR_PRESET_...; CONTOUR_AND_STIPPLE
   *
   * Style.
   */
  preset?: PresetName | number;
  /** HRBFNPR_WORDING_...; FIELDS */
  wording?: WordingName | number;
  /** the name of a preset, in place of its number; NULL */
  styleName?: string;
  /**
   * used as it is, with lengths in pixels of this picture; NULL. `preset` then says which layers of marks there
   * are
   */
  style?: Style;
  /** what this descriptor leaves at its defaults; kept; NULL */
  settings?: Settings;
  /** a list; NULL and 0 */
  changes?: readonly Change[];
  /** what is painted, a list; NULL and 0 */
  dabs?: readonly Dab[];
  /**
   * 1 .. 32768, with `height`; 0 = from `size`
   *
   * Size, in pixels.
   */
  width?: number;
  height?: number;
  /** of the longer side, 1 .. 32768; the shorter one is as the object needs it; 0 = 1600 */
  size?: number;
  /** HRBFNPR_PICTURE_SIDES_...; AUTO */
  sides?: PictureSidesName | number;
  /** radius of the pen, which styles vary a little; 0 = an 800th of the longer side, at least 0.75 */
  pen?: number;
  /** of contours; others are finer; 0 = that of the style */
  lineWidth?: number;
  /**
   * used as it is, with its viewport as size; NULL
   *
   * Camera.
   */
  camera?: Camera;
  /** 0, 0, 0 = by the format and the shape, y where neither tells */
  up?: Numbers;
  /** degrees, of the camera about the up axis; NaN = 30, and another where that sees the back of an open surface */
  azimuth?: number;
  /** degrees, of the camera above the horizon; NaN = 20 */
  elevation?: number;
  /** from the eye into the scene, in place of these two; 0, 0, 0 = not given */
  direction?: Numbers;
  /** place of the eye, which looks at `target`; NaN = not given */
  eye?: Numbers;
  /** NaN = the middle of the model */
  target?: Numbers;
  /** degrees, vertical angle of view, 0 = orthographic; NaN = 30, 0 of the style archaeological */
  fov?: number;
  /** share that is free on each side, 0 .. 0.45; NaN = 0.05 */
  margin?: number;
  /** degrees, of an orbit that starts here: the picture has room for all of it; 0 = a still */
  turn?: number;
  /** of that orbit, 1 and more; 36 */
  turnFrames?: number;
  /**
   * HRBFNPR_NORMALS_...: what is known of those of points; AUTO
   *
   * From the source to a surface.
   */
  normals?: NormalsName | number;
  /** of a mesh, or chosen from points; 0 = as many as a mesh needs, of points all up to 4096 */
  samples?: number;
  /** units of the source: samples are chosen until all is this near; 0 = 0.002 diagonals of a mesh, none of points */
  tolerance?: number;
  /** the most samples that are chosen; 0 = 8000 of a mesh, no limit of points */
  maximumCentres?: number;
  /** HRBFNPR_PARTS_...: of a mesh; OUTER */
  parts?: PartsName | number;
  /** HRBFNPR_PICTURE_EDGES_...: of a mesh; AS_GIVEN */
  edges?: PictureEdgesName | number;
  /** degrees, 5 .. 175: of EDGES_SHARP; 30 */
  edgeAngle?: number;
  /** degrees, 0 .. 180: faces that meet at a sharper angle do not share their normals; NaN = 60 */
  creaseAngle?: number;
  /**
   * how often faces are divided into four towards something round, 0 .. 6; -1 = where they are coarse and no edges
   * stand out
   */
  subdivide?: number;
  /** HRBFNPR_PROFILE_...; AUTO */
  profile?: ProfileName | number;
  /** where the scanner stood: open surfaces without normals look to it; NaN = as the source tells */
  viewpoint?: Numbers;
  /**
   * factor of the width over which the image of a depth camera is smoothed; 0 leaves its points where they are;
   * NaN = 1
   */
  depthSmoothing?: number;
  /** of all that is random; 1 */
  randomSeed?: number;
  /**
   * kinds of layers with commas between, "stipples,hatch"; NULL = those of the style
   *
   * Marks, lines, and what stands beside the drawing.
   */
  markKinds?: string;
  /** n x 3: where marks of PUBLISHED start; not given */
  seedPoints?: ArrayInput;
  /** degrees by which all lines of hatching are turned; 0 */
  hatchAngle?: number;
  /**
   * kinds with commas between: contour, suggestive, ridges, valleys, apparent, parabolic, isophotes=0.3:0.6,
   * section=z:20, border, crease; "none": contours by marks; NULL = those of the style
   */
  lines?: string;
  /**
   * the unit of a scale bar below the drawing; "none": no bar; NULL = "units" of the style archaeological, else
   * "none"
   */
  scaleBar?: string;
  /** NULL; called for as long as the picture lives */
  onEvent?: PictureEventFn;
}

/**
 * What is not known of this kind of source is 0, and so is what would have been found out after the finding that
 * it
 * cannot be drawn.
 */
export interface SourceInfo {
  /** HRBFNPR_SOURCE_KIND_... */
  readonly kind: SourceKindName | number;
  /**
   * HRBFNPR_SEVERITY_... of the worst finding: INFO = there is none, NOTE = a picture repairs it, WARNING, FAILURE
   * = it cannot be drawn
   */
  readonly severity: SeverityName | number;
  /** HRBFNPR_NORMALS_LOOK_...: of points or faces */
  readonly normalsLook: NormalsLookName | number;
  /** as given; vertices of a mesh, centres of a model, marks of a point set */
  readonly points: number;
  /** as given */
  readonly triangles: number;
  /** points at a value that stands for none; what follows is without them */
  readonly noData: number;
  /** points far from all others; what follows is without them */
  readonly strays: number;
  readonly pointsNotFinite: number;
  /** points, or vertices of faces, at the place of another */
  readonly duplicates: number;
  /** of finite points */
  readonly boundsMin: Numbers;
  readonly boundsMax: Numbers;
  /** of these bounds */
  readonly diagonal: number;
  /** that a picture chooses by itself, of points and meshes; the reason is at the end */
  readonly up: Numbers;
  /**
   * 1: there are some that are not zero
   *
   * Normals of points; looks_down, normals_closed and normals_flipped_share of faces, too.
   */
  readonly hasNormals: number;
  /** 1: the points lie along curves, as those of wires and cross sections */
  readonly alongCurves: number;
  /** a terrain looks down along an axis: 1 = y, 2 = z; 0 = it does not, or is none */
  readonly looksDown: number;
  readonly normalsZero: number;
  readonly normalsNotFinite: number;
  /** of length 1, of those that can be used; 0 .. 1 */
  readonly normalsUnitShare: number;
  /**
   * sum of the winding numbers on both sides of the samples, in the middle: 1 closed and outward, -1 inward, 0 a
   * flat sheet; not of points along curves
   */
  readonly normalsClosed: number;
  /** judged by neighbours; not of points along curves */
  readonly normalsFlippedShare: number;
  /**
   * pixels that have a point
   *
   * The picture of a depth camera that has no normals.
   */
  readonly imageSeen: number;
  /** of these, on no surface */
  readonly imageDropped: number;
  /** median of those that were seen */
  readonly imageDepth: number;
  /** standard deviation at that depth */
  readonly imageNoise: number;
  /**
   * 1: each edge has two faces, which run along it in opposite directions
   *
   * A mesh, as given but for vertices at the same place, which are joined.
   */
  readonly closed: number;
  /** 1: it is closed, and its faces look inward */
  readonly insideOut: number;
  /** parts that share no vertex */
  readonly components: number;
  /** parts without border whose faces look inward; inside another one it is a cavity */
  readonly componentsInsideOut: number;
  /** of one face */
  readonly boundaryEdges: number;
  /** borders */
  readonly boundaryLoops: number;
  /** of more than two faces */
  readonly nonmanifoldEdges: number;
  /** what hrbfnpr_mesh_create leaves of them */
  readonly nonmanifoldLeft: number;
  /** of two faces, one of which is turned over */
  readonly contraryEdges: number;
  /** with a corner that is not finite */
  readonly facesNotFinite: number;
  /** without area */
  readonly degenerateFaces: number;
  /** with the corners of another */
  readonly repeatedFaces: number;
  /** of no face */
  readonly unusedVertices: number;
  readonly area: number;
  /** enclosed; 0 where the mesh is not closed */
  readonly volume: number;
  /** "it is so in PLY files"; "" = up is not known */
  readonly upReason: string;
}

export interface PictureInfo {
  /** HRBFNPR_PRESET_... */
  readonly preset: PresetName | number;
  /** surfaces, or 1 of a point set */
  readonly parts: number;
  /** of all parts */
  readonly marks: number;
  readonly notes: number;
  readonly stages: number;
  /** pixels, of the drawing */
  readonly width: number;
  readonly height: number;
  /** of all parts */
  readonly boundsMin: Numbers;
  readonly boundsMax: Numbers;
  /** as used */
  readonly up: Numbers;
  /** radius, pixels, as used */
  readonly pen: number;
  /** that it took to make */
  readonly seconds: number;
}

/** One surface: handles without references of their own, valid while the picture lives. */
export interface PicturePart {
  /** HRBFNPR_SIDES_... as used */
  sides?: SidesName | number;
  /** NULL of a point set */
  model?: Model;
  /** NULL with SURFACE_ONLY */
  pointSet?: PointSet;
  /** NULL without lines */
  lineSet?: LineSet;
  /** of a mesh, as it was fitted to; else NULL */
  mesh?: Mesh;
}

/** On which paper a drawing is written, and with which pens. */
export interface PicturePageDesc {
  /**
   * format, flags, tolerance, speeds, pens and the like; its items, annotations and size are set by this call, and
   * its title, description and metadata where they are NULL; NULL = its defaults
   */
  page?: PageDesc;
  /**
   * "a0" .. "a6", "letter", "legal", "tabloid", or "210x297" in mm: the drawing fills it, turned as it fits
   * better; NULL = a pixel is 25.4 / 96 mm
   */
  paper?: string;
  /** mm, free on each side of the paper; 10 */
  paperMargin?: number;
  /**
   * FLOAT64, 1, mm, ascending: of the pens at hand; each group gets that which is nearest to its lines' median
   * width; not given
   */
  penWidths?: ArrayInput;
}

/** Texts are UTF-8 and are read during the call only. */
export interface ViewsDesc {
  /** HRBFNPR_VIEWS_...; 0 */
  flags?: number;
  /** HRBFNPR_VIEWS_ANGLE_...; FIRST */
  projection?: ViewsAngleName | number;
  /** HRBFNPR_VIEWS_HIDDEN_...; DASHED */
  hidden?: ViewsHiddenName | number;
  /**
   * names with commas between: front, back, left, right, top, bottom, iso; each is drawn once. NULL =
   * "front,left,top,iso", with ANGLE_THIRD "front,right,top,iso"
   */
  views?: string;
  /**
   * planes with semicolons between: "z:20" cuts at z = 20, "z" through the middle, "1:1:0:5" at x + y = 5. An axis
   * without a sign is seen from the front, from above or from the side that is drawn; "+z:20" from above, "-z:20"
   * from below. They are called A-A, B-B, ...; NULL = none
   */
  sections?: string;
  /**
   * "a0" .. "a6", "letter", "legal" or "tabloid", lying, or "297x210", width and height in mm; "auto" = the
   * smallest of a4 to a0 that has room at the scale, a3 where the scale is "auto", too; NULL = "auto"
   */
  paper?: string;
  /**
   * "1:2" = half as large as it is; "auto" = the largest of 1, 2 and 5 times a power of ten [ISO 5455] that has
   * room on the paper; NULL = "auto"
   */
  scale?: string;
  /**
   * thin lines where the surface bends without an edge: kinds with commas between, ridges, valleys, suggestive;
   * "none"; NULL = "none"
   */
  smooth?: string;
  /** in the title block; NULL or "" = `model` without the ending of its name */
  title?: string;
  /** the file's name, in the title block; NULL or "" = the name of the picture's source */
  model?: string;
  /** mm of a unit of the model, up to 1e9; 0 = 1, or 1000 with UNIT_IS_METRE */
  unitMm?: number;
  /** degrees, > 0: edges of a mesh are sharp if its faces meet at more than this; 30. Larger: fewer edges */
  creaseAngle?: number;
  /** mm, 0.01 .. 1000: of outlines; thin lines are half as wide; 0.5 */
  lineWidth?: number;
  /** mm, 0.01 .. 1000: between the lines in cut faces; 3 */
  hatchSpacing?: number;
  /** mm, > 0: free between views; 15 */
  spacing?: number;
  /**
   * format, flags, tolerance, speeds and the like; its items, annotations, pens and size are set by this call, and
   * its title and description where they are NULL; NULL = its defaults with a tolerance of 0.02
   */
  page?: PageDesc;
}

/** What was drawn. */
export interface ViewsInfo {
  /** sections are among them */
  readonly views: number;
  /** that were written */
  readonly bytes: number;
  /** mm, of the page */
  readonly width: number;
  /** mm, of the page */
  readonly height: number;
  /** 0.5 of 1:2 */
  readonly scale: number;
  /** mm of a unit of the model, as used */
  readonly unitMm: number;
  /** "1:2" */
  readonly scaleText: string;
  /** "a3", "297 x 210" */
  readonly paper: string;
}

