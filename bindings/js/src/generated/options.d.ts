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

export interface ContextDesc {
  /** _init sets HRBFNPR_ABI_VERSION; another one is VERSION_MISMATCH */
  abiVersion?: number;
  /** 0 = all processors (default), 1 = serial; at most 256 are used */
  threadCount?: number;
  /** must be 0 */
  flags?: number;
  /** HRBFNPR_THREAD_BACKEND_...; AUTO */
  threadBackend?: ThreadBackendName | number;
  /** HRBFNPR_INSTRUCTION_SET_...; AUTO */
  highestInstructionSet?: InstructionSetName | number;
  /** both or none; none = aligned operator new */
  allocate?: AllocateFn;
  deallocate?: DeallocateFn;
  /** may be NULL */
  log?: LogFn;
  /** HRBFNPR_LOG_...: less than this is not reported; DEBUG */
  logLevel?: LogName | number;
  /** may be NULL; only with thread_backend AUTO or RUN_TASKS */
  runTasks?: RunTasksFn;
}

export interface ContextInfo {
  /** threads that a large call will use */
  readonly threadCount: number;
  /** the one in use */
  readonly instructionSet: InstructionSetName | number;
  /** HRBFNPR_THREAD_BACKEND_POOL, OPENMP, RUN_TASKS or SERIAL */
  readonly threadBackend: ThreadBackendName | number;
  /** allocated through this context at present */
  readonly bytesNow: number;
  /** the most there ever were */
  readonly bytesPeak: number;
}

/**
 * What to fit: N points with N outward normals.
 *
 * The fit is in double precision, in normalised coordinates (centred, mean
 * sample spacing 1), whatever the caller's unit.  Accepted repairs, counted in
 * hrbfnpr_model_info: normals that are not of unit length are normalised;
 * samples that coincide (within 1e-9 diagonals) and agree in their normal
 * (within 1 degree) are merged, and so are, of 33 samples and more, near
 * duplicates (within 1e-3 of the spacing on the spot, and 15 degrees).
 * Many samples that contradict each other so much (slivers of a mesh in single
 * precision) that the iterations break down get a little regularization and a
 * larger solver tolerance (docs/fitting.md); the log and
 * hrbfnpr_model_info.regularization say so.
 * Samples that coincide and disagree are an INVALID_ARGUMENT that names both
 * indices, as are NaN, infinity, zero normals, and an empty or mismatched
 * array; so are coordinates beyond 1e100, and samples less than 1e-100 across.
 * One sample is a plane.
 *
 * Measured samples.  Of 33 and more, those that do not fit to the 16 nearest
 * others are counted, and repaired only if asked for:
 * - outliers: three times as far from their neighbours as these from theirs,
 *   or far above the tangent planes of most of them; and of near duplicates
 *   that disagree, the one that agrees less with those around it;
 * - flipped normals: opposite to 7 of 8 neighbours at least, which agree with
 *   each other, lie on the same sheet, and all around.
 *
 * Choosing.  With a tolerance or maximum_centres, samples are chosen as
 * centres: some by farthest-point order, then, in rounds, those worst off the
 * fit to the ones before, until every sample is within the tolerance (to first
 * order, |f| / |grad f|), or there are maximum_centres.  An end short of the
 * tolerance is no error: hrbfnpr_model_info says what was reached, and the log
 * warns.  With regularization, what has to be within the tolerance, less two
 * standard deviations of the noise (but not less than half), is the mean
 * over a sample and its 16 neighbours, so that centres do not follow noise.
 *
 * Automatic regularization.  The noise is measured by how far each sample is
 * from the planes of its neighbours, where that does not vanish with their
 * distance.  The fit is then the most likely function for it: regularization
 * is the noise's variance over that of the function, which maximum likelihood
 * gives (Rasmussen and Williams, "Gaussian Processes for Machine Learning",
 * 2006, 5.4), with a value of its own for the normals.  Samples without noise
 * are interpolated.
 *
 * Normals.  With a normal_mode other than GIVEN the normals are first made by
 * hrbfnpr_orient with its defaults; hrbfnpr_model_info says what was found.
 * Normals as given that all point into a closed surface are fitted as they
 * are, but the log warns, and hrbfnpr_model_info.normals_inward is 1.
 */
export interface FitDesc {
  /** HRBFNPR_KERNEL_...; TRIHARMONIC */
  kernel?: KernelName | number;
  /** N x 3, FLOAT32 or FLOAT64 */
  points?: ArrayInput;
  /** N x 3, FLOAT32 or FLOAT64, outward; normal_mode says otherwise */
  normals?: ArrayInput;
  /** sigma or rho, in units of the points; 0 = from the sample spacing */
  kernelRadius?: number;
  /** -1 (none) .. 3; 1. TRIHARMONIC is well-posed from 1 on (Duchon 1977); below that a pivoted LU is tried. */
  polynomialDegree?: number;
  /** HRBFNPR_REGULARIZATION_...; GIVEN. AUTO needs regularization 0 */
  regularizationMode?: RegularizationName | number;
  /**
   * >= 0; 0 interpolates. Added to the diagonal of the system in coordinates whose diagonal is 1: larger is
   * smoother
   */
  regularization?: number;
  /** HRBFNPR_REPAIR_KEEP or DROP; KEEP */
  outliers?: RepairName | number;
  /** HRBFNPR_REPAIR_...; KEEP */
  flippedNormals?: RepairName | number;
  /**
   * > 0: samples are chosen as centres until all lie this near to the surface, in units of the points; 0: no such
   * end
   */
  tolerance?: number;
  /**
   * > 0: no more samples than this are chosen as centres; 0: no limit. With tolerance 0, too, every sample is a
   * centre
   */
  maximumCentres?: number;
  /** HRBFNPR_SOLVER_...; AUTO */
  solver?: SolverName | number;
  /** of iterative refinement after a DIRECT solve, 0 .. 20; 2 */
  refinementSteps?: number;
  /**
   * relative residual at which ITERATIVE ends; 0 = 1e-8, of 2048 samples and fewer 1e-10; or, where rounding
   * allows no more, 1e-6, with a warning
   */
  solverTolerance?: number;
  /** most iterations of ITERATIVE, 1 .. 1000000; 200 */
  iterationLimit?: number;
  /** of ITERATIVE, 1 .. 48: more are fewer iterations and more setup; 0 = by kernel and number of samples */
  preconditionerNeighbours?: number;
  /** HRBFNPR_NORMALS_...; GIVEN. NONE, and AUTO, need no normals */
  normalMode?: NormalsName | number;
  /** HRBFNPR_TRIM_...; AUTO */
  trim?: TrimName | number;
}

/**
 * Points that want normals, or whose normals may be wrong: N of them.
 *
 * Normals are the unit vectors that need the least energy of a Hermite fit
 * (kernel r^3) with f = 0 at all points (VIPSS: Huang, Carr, Ju, "Variational
 * implicit point set surfaces", 2019), found from several starts: planes
 * through neighbours, whose signs are chosen by the same energy, cluster by
 * cluster.  The energy is a sparse sum of squares (docs/fitting.md), so that
 * time and memory grow with N.  Noise is measured first, and allowed for.
 *
 * Outward is, of a closed surface, where its winding number is 0; of an open
 * one the side on which it is the smaller, which is the convex one; and where
 * that tells nothing, as of terrain, the side that `up` or, if given, the
 * viewpoint is on for most points.  Of closed surfaces in one another the
 * inner ones bound holes: their normals point into these.
 *
 * Points that coincide (within 1/100 of the spacing) get the same normal.
 * INVALID_ARGUMENT that names the argument: fewer than 4 different points, or
 * all on one line; NaN or infinity; with a mode that goes by given normals,
 * none of them.  A normal that is zero is one that is not known: it is made.
 */
export interface OrientDesc {
  /** HRBFNPR_NORMALS_...; AUTO. GIVEN only looks: no normal is changed */
  mode?: NormalsName | number;
  /** N x 3, FLOAT32 or FLOAT64 */
  points?: ArrayInput;
  /** N x 3, FLOAT32 or FLOAT64, of any length; or none, with NONE and AUTO */
  normals?: ArrayInput;
  /** of any length; (0, 0, 1) */
  up?: Numbers;
  /** where the points were seen from, with has_viewpoint; 0 */
  viewpoint?: Numbers;
  /** 1: open surfaces are turned to it; 0 */
  hasViewpoint?: number;
}

export interface OrientInfo {
  /**
   * HRBFNPR_NORMALS_...: what the given normals turned out to be; NONE also if they have nothing to do with the
   * points, as colours have not
   */
  readonly found: NormalsName | number;
  /** normals that were given and have been turned round */
  readonly turned: number;
  /** normals that were not given, or zero, or not to go by */
  readonly made: number;
  /** points that coincide with another */
  readonly merged: number;
  /** mean angle between the lines of given and resulting normals, in degrees; NaN if there are none */
  readonly directionChange: number;
  /** standard deviation of the points off their surface, in their unit; 0 if none is seen */
  readonly noise: number;
  /** median distance of a point to its nearest neighbour */
  readonly spacing: number;
  /**
   * of the result, over its degrees of freedom, in spacings: below 0.006 for surfaces that the points resolve;
   * 0.026 is that of points without any order
   */
  readonly energy: number;
  /**
   * 0 .. 1: how far starts with energies as low agree, and how low that is, less for noise. A heuristic: above 0.9
   * results were right (docs/fitting.md), below look
   */
  readonly confidence: number;
  /** 1: the points are all around a solid, or several */
  readonly closed: number;
  /** HRBFNPR_OUTWARD_... */
  readonly outwardBy: OutwardName | number;
  /** pieces that lie apart by more than their spacing */
  readonly components: number;
  readonly seconds: number;
}

/**
 * The image of a depth camera (Kinect, RealSense, time of flight, stereo): columns x rows points.
 *
 * The camera is in the origin and looks along z, or against it; x / z goes
 * with the column and y / z with the row, either way.  Of an image of depths
 * with focal lengths f and a centre c, in pixels, those are
 * x = (column - c_x) z / f_x and y = (row - c_y) z / f_y.
 *
 * The sensor's errors are as large everywhere in 1 / z, so that they grow with
 * z^2, and planes are linear in it.  A plane is fitted in 1 / z to the pixels
 * around each, those that are within 6.5 standard deviations of it: what lies
 * beyond an edge does not count.  The point moves along its ray onto the plane,
 * whose normal is the normal.  The radius is 12 sqrt(s f) pixels, for a standard
 * deviation of s z in the depth, and from 2 to 48.  Points with hardly any others on
 * their plane, as between an edge and what is behind it, are left out.
 */
export interface DepthImageDesc {
  /** 8 .. 65535 */
  columns?: number;
  /** 8 .. 65535 */
  rows?: number;
  /** 1: points stay where they are, and get normals; 0 */
  keepPoints?: number;
  /** rows * columns x 3, row by row, FLOAT32 or FLOAT64; NaN, infinity or z = 0: nothing was seen there */
  points?: ArrayInput;
  /** standard deviation of 1 / z, in 1 / unit of the points; 0 = measured */
  noise?: number;
  /** factor of the radius, > 0 .. 100; 1 */
  smoothing?: number;
}

export interface DepthImageInfo {
  /** pixels that have a point */
  readonly seen: number;
  /** of these, without enough others on their plane */
  readonly leftOut: number;
  /** standard deviation of 1 / z, as given or measured */
  readonly noise: number;
  /** in pixels: the mean of both directions' */
  readonly focalLength: number;
  /** median distance |z| of the points */
  readonly depth: number;
  /** smoothed over at this depth, in pixels */
  readonly radius: number;
  readonly seconds: number;
}

/**
 * Any implicit function in place of a fit: every operator below works on it
 * [NPAR 8].  It should be negative inside and of a gradient near 1 at the
 * surface; it must be finite inside twice the bounds.  Where it is not, or its
 * gradient is shorter than 1e-150 or longer than 1e150, no point is projected
 * and no mark placed.  The bounds' diagonal is 1e-100 .. 1e100; they
 * should fit the surface: tolerances, differences and the cells in which marks
 * are placed are parts of the diagonal.
 */
export interface CustomDesc {
  /** HRBFNPR_CUSTOM_..., or-ed; 0 */
  flags?: number;
  function?: ImplicitFn;
  /** the box that the surface lies in */
  boundsMin?: Numbers;
  boundsMax?: Numbers;
  /** for differences; 0 = 1e-4 (Hessian 1e-3) of the diagonal */
  differenceStep?: number;
}

export interface ModelInfo {
  readonly kernel: KernelName | number;
  readonly polynomialDegree: number;
  /** fits made to choose the centres; 0 if all samples are centres */
  readonly choiceRounds: number;
  /** as given */
  readonly samples: number;
  /** after merging, cleaning and choosing */
  readonly centres: number;
  /** samples that were merged into another */
  readonly mergedSamples: number;
  /** samples much nearer to another than the spacing, merged into it */
  readonly nearDuplicates: number;
  /** normals whose length was off 1 by more than 1e-4 */
  readonly rescaledNormals: number;
  readonly outliersFound: number;
  readonly outliersDropped: number;
  /** normals against those of their neighbours */
  readonly flippedFound: number;
  /** of these, dropped or turned round */
  readonly flippedRepaired: number;
  /**
   * of the samples; of samples along curves, 20 000 at most, that of the surface, too, if it closes within a third
   * of a diagonal around them
   */
  readonly boundsMin: Numbers;
  readonly boundsMax: Numbers;
  /** mean distance of a sample to its nearest neighbour */
  readonly spacing: number;
  /** as used */
  readonly kernelRadius: number;
  /** as used; of AUTO, that of the values */
  readonly regularization: number;
  /**
   * standard deviation of the samples off their surface, in units of the points; 0 if none is seen, NaN if nobody
   * asked (regularization GIVEN)
   */
  readonly noiseEstimate: number;
  /** max |f(x_i)|, in units of the points */
  readonly valueResidualMax: number;
  readonly valueResidualRms: number;
  /** max |grad f(x_i) - n_i| */
  readonly gradientResidualMax: number;
  readonly gradientResidualRms: number;
  /** of all samples but dropped ones from the surface, |f| / |grad f| */
  readonly inputDistanceMax: number;
  readonly inputDistanceRms: number;
  /** share of all samples that lie within the tolerance; a dropped one counts as outside; NaN with tolerance 0 */
  readonly inputShareWithin: number;
  /** the one used */
  readonly solver: SolverName | number;
  /** HRBFNPR_SOLVER_REASON_... */
  readonly solverReason: SolverReasonName | number;
  /** refinement steps of DIRECT, steps of ITERATIVE */
  readonly iterations: number;
  /** 1: the matrix was not definite and a pivoted LU was used */
  readonly fallback: number;
  /** relative residual of the linear system, 2-norm */
  readonly solverResidual: number;
  /** DIRECT: of the matrix, 1-norm; ITERATIVE: of the preconditioned one, 2-norm */
  readonly conditionEstimate: number;
  readonly secondsClean: number;
  /** of all rounds but the last fit */
  readonly secondsChoose: number;
  readonly secondsAssemble: number;
  readonly secondsPrecondition: number;
  readonly secondsSolve: number;
  readonly secondsTotal: number;
  /** kept by the model */
  readonly bytes: number;
  /** most that the context's allocator had given out at a time, up to the fit's end */
  readonly peakBytes: number;
  /** of a fit with a normal_mode: hrbfnpr_orient_info.found; GIVEN otherwise */
  readonly normalsFound: number;
  /** 1: normals as given (normal_mode GIVEN) that all point into a closed surface */
  readonly normalsInward: number;
  /** hrbfnpr_orient_info.turned */
  readonly normalsTurned: number;
  /** hrbfnpr_orient_info.confidence; NaN without a normal_mode */
  readonly normalsConfidence: number;
  readonly secondsOrient: number;
}

export interface ProjectDesc {
  /** of f at each point, 1 .. 1000; 50 */
  evaluationLimit?: number;
  /** stop when |f| / |grad f| <= tolerance * diagonal; 1e-9 */
  tolerance?: number;
  /** sigma in (0, 0.5); 1e-4 */
  armijoSlope?: number;
  /** beta in (0, 1); 0.5 */
  armijoFactor?: number;
}

/**
 * Where _project puts its results: arrays of the caller's, each of n elements,
 * or not given (all zero).
 */
export interface Projection {
  /** n x 3, FLOAT32 or FLOAT64; may be the points themselves */
  position?: ArrayOutput;
  /** n x 3, FLOAT32 or FLOAT64: the unit gradient */
  normal?: ArrayOutput;
  /** n x 1, UINT8 or UINT32: HRBFNPR_PROJECTION_... */
  status?: ArrayOutput;
  /** written: how many points converged */
  converged?: number;
}

/**
 * Where _curvature puts its results: arrays of the caller's, each of n
 * elements, FLOAT32 or FLOAT64, or not given (all zero).
 */
export interface Curvature {
  /** n x 1: the larger principal curvature */
  k1?: ArrayOutput;
  /** n x 1 */
  k2?: ArrayOutput;
  /** n x 3: their directions, unit, orthogonal, tangent, of arbitrary sign */
  d1?: ArrayOutput;
  d2?: ArrayOutput;
  /** n x 1: (k1 - k2) / (|k1| + |k2| + 1e-3/diagonal), in [0,1] */
  confidence?: ArrayOutput;
}

export interface CastDesc {
  /** to find on a ray, 1 .. 256; 1: the first */
  maximumHits?: number;
  /** of f on each ray, 1 .. 1000000; 20000 */
  evaluationLimit?: number;
  /** where a ray begins and ends, in lengths of its direction: t_min finite, 0 */
  tMin?: number;
  /** not below t_min; infinity */
  tMax?: number;
  /** bound on |grad f| in the search box; 0 = hrbfnpr_model_lipschitz's */
  lipschitz?: number;
  /** in diagonals, above 0, at most 0.1; 1e-4 */
  smallestStep?: number;
  /** on the place of a hit along the ray, in diagonals, above 0; 1e-9 */
  tolerance?: number;
}

/**
 * Where _cast_rays puts its results: arrays of the caller's, each of n
 * elements, or not given (all zero).  h = maximum_hits; of each ray its hits
 * in order.
 */
export interface RayHits {
  /** n x 1, UINT32: how many were found, 0 .. h */
  count?: ArrayOutput;
  /** n x h, FLOAT32 or FLOAT64; infinity after the last */
  t?: ArrayOutput;
  /**
   * n x 3h, FLOAT32 or FLOAT64: x y z of the first hit, then of the second ...; 0 after the last. From far origins
   * it is more exact than t, which is rounded
   */
  position?: ArrayOutput;
  /** n x 3h, FLOAT32 or FLOAT64: the unit gradients; 0 after the last */
  normal?: ArrayOutput;
  /** n x h, UINT8: 1 where f goes from + to - along the ray, else 0 */
  entering?: ArrayOutput;
  /** n x 1, UINT8 or UINT32: HRBFNPR_RAY_... */
  status?: ArrayOutput;
  /** written: how many rays have a hit */
  hitRays?: number;
}

export interface TrimDesc {
  /** of s, > 0; 1.5. The surface ends some 0.7 spacings beyond its last samples, with 3 some 0.9 */
  limit?: number;
  /** >= 0, diagonals; 0.05: holes that nowhere are farther from the samples stay closed */
  hole?: number;
  /**
   * 0 to 1, diagonals; 0: no spacing h_j is taken to be less. For samples that are much denser than the surface is
   * accurate, such as many points of a mesh: 0.01 leaves out what is more than about 0.01 diagonals off them, and
   * every part that is farther than `hole` from all of them; with 0 such a part also needs a place where s is 6
   * and more
   */
  closest?: number;
  /**
   * FLOAT32 or FLOAT64, 3, finite: the samples; not given = the model's centres. All points of a scan tell better
   * than the centres chosen from them where it ends
   */
  points?: ArrayInput;
  /** FLOAT32 or FLOAT64, 3: of `points`, as many, not 0, of any length; not given = the surface's own there */
  normals?: ArrayInput;
}

export interface TrimInfo {
  /** 1: the surface ends somewhere; 0: it is whole, and all else is 0 but samples, spacing */
  readonly isTrimmed: number;
  /** that tell where; 0: nobody asked, or a fit to a closed mesh, or it could not be told */
  readonly samples: number;
  /** of the surface, connected, that are left out */
  readonly parts: number;
  /** of these, those that reach the end of the search box: the samples are open there */
  readonly partsToEnd: number;
  /** of the surface's area in the box that is left out, 0 to 1, within some percent */
  readonly share: number;
  /** place left out from the samples, units of the model */
  readonly farthest: number;
  /** of the samples, the median of h_j */
  readonly spacing: number;
}

/** What a kind has no use for is not looked at. */
export interface CsgNode {
  /** HRBFNPR_CSG_...; UNION */
  kind?: CsgName | number;
  /** the index of a node before this one; of the first, the root, -1; -1. Children are in the order of the list */
  parent?: number;
  /** of MODEL; kept */
  model?: Model;
  /**
   * of all that is here and below, affine: a place here to one in the parent; the identity. It may turn, mirror
   * and stretch. Where it stretches unevenly lengths are measured by its least stretch, so that |grad f| does not
   * grow; the most may be 1e4 times the least
   */
  transform?: Numbers;
  /** of BOX, > 0; 1 */
  size?: Numbers;
  /** > 0; of CONE 0 or more, and one of both is not 0; 1 */
  radius?: number;
  /** of CONE, 0 or more; of TORUS, > 0 and less than the radius; 0.5 */
  secondRadius?: number;
  /** of CYLINDER and CONE, > 0; 1 */
  height?: number;
  /** of OFFSET, finite; of SHELL, > 0; 0 */
  distance?: number;
  /** radius R of UNION, INTERSECTION and DIFFERENCE, 0 or more; 0 = a crease */
  blend?: number;
  /** of the blend: 0, or 2 .. 64; 0 */
  exponent?: number;
}

export interface CsgDesc {
  /** a list: a tree of any depth. 1 .. 65536 nodes, counting those of trees that are leaves of this one */
  nodes?: readonly CsgNode[];
  /** the box that the surface lies in: what is beyond is not seen. All 0 = found from the tree */
  boundsMin?: Numbers;
  boundsMax?: Numbers;
}

export interface CsgInfo {
  /** with those of trees that became part of it; 0: the model is no tree, and so is all else */
  readonly nodes: number;
  /** nodes from the root to the deepest leaf, both counted */
  readonly depth: number;
  /** leaves that are models, each once */
  readonly models: number;
  /**
   * smooth functions that it is made of: sides of primitives and of boxes that models end at; a blend has one for
   * each pair of those that it joins
   */
  readonly sheets: number;
  /** a bound on |grad f| that holds everywhere; 0: models have none that is known */
  readonly lipschitz: number;
}

/**
 * How one layer is made.
 *
 * The darkness 1 - tau at which the first mark of the layer is shown is
 * tone_begin, that at which all are tone_end: rank u becomes 1 - begin -
 * (1 - u) (end - begin), 0 <= begin < end <= 1.  Both 0: as
 * hrbfnpr_generate_desc.tone_ranges says.
 */
export interface LayerDesc {
  /** HRBFNPR_LAYER_KIND_STIPPLES or HATCH; STIPPLES */
  kind?: LayerKindName | number;
  /** UTF-8, 1 .. 63 bytes, copied; NULL = "stipples" or "hatch" */
  name?: string;
  /**
   * the most marks; at most 100000000 for BLUE_NOISE; 40000. 0 = no limit, for PUBLISHED and for lines with a
   * separation. PUBLISHED thins the level that exceeds it at random and stops there; lines of BLUE_NOISE come near
   * to it, and do not ask for it where they have a separation. Not used with a shared_budget
   */
  budget?: number;
  /** of stipples, of lines, and of PUBLISHED strokes of the first direction; 0 and 0 */
  toneBegin?: number;
  toneEnd?: number;
  /** of PUBLISHED strokes of the second direction; 0 and 0 */
  secondToneBegin?: number;
  secondToneEnd?: number;
  /** HRBFNPR_LAYER_WITH_...; 0 */
  flags?: number;
  /**
   * HRBFNPR_DENSITY_...; UNIFORM
   *
   * Stipples of BLUE_NOISE, which keep their evenness: a mark is left out where its place in the
   * uniform order, divided by the density, is too high.
   */
  density?: DensityName | number;
  /** of CURVATURE, 0 .. 1; 0.5 */
  densityStrength?: number;
  /** for CALLBACK. Where its mean is below 1/16 of 1, fewer marks than the budget are made */
  densityFunction?: DensityFn;
  /**
   * NULL = by `guide`
   *
   * HATCH.  Lengths are in object units; separation and step are 0, or 1e-12 .. 1e9 diagonals.
   */
  directionFunction?: DirectionFn;
  /** HRBFNPR_HATCH_GUIDE_...; CURVATURE */
  guide?: HatchGuideName | number;
  /**
   * HRBFNPR_STROKE_START_...; SEEDS
   *
   * HATCH of PUBLISHED.
   */
  start?: StrokeStartName | number;
  /** with STROKE_START_STIPPLES: the last stippling level used; 0 */
  startLevel?: number;
  /**
   * of stipples, too: refinement steps, 0 .. 12; -1 = 4 for stipples, 3 for strokes, which then have 3^levels
   * marks; -1
   */
  levels?: number;
  /**
   * mean distance of neighbouring lines; 0 = as many lines as make about the budget's marks
   *
   * HATCH of BLUE_NOISE.
   */
  separation?: number;
  /** distance of the marks of a line; 0 = 0.4 of the separation */
  step?: number;
  /** by which lines are turned in the tangent plane, counter-clockwise as seen from outside; degrees; 0 */
  angle?: number;
  /** of directions: the distance over which they are evened out; diagonals, > 0, 1 at most; 0.04 */
  smoothing?: number;
  /** where curvature says little lines run around this; not 0; (0, 1, 0) */
  axis?: Numbers;
  /** against curvature; >= 0; 0.06 */
  axisWeight?: number;
  /** of LIGHT and SILHOUETTE, in object space; not 0; (0, 0, 1) */
  guideDirection?: Numbers;
  /**
   * of a guide other than CURVATURE: what is left of 1 is curvature's, 0 .. 1; 1. Lines are blended as exp(2 i
   * angle)
   */
  guideWeight?: number;
  /**
   * over which the attribute TONE_NORMAL is averaged: the tone of a rough surface goes by that; diagonals, 0 ..
   * 0.1; 0 = tone goes by NORMAL; -1 = 0.006 for HATCH of BLUE_NOISE, 0 for others; -1
   *
   * Of all kinds.
   */
  toneSmoothing?: number;
}

export interface GenerateDesc {
  /** HRBFNPR_DISTRIBUTION_...; BLUE_NOISE */
  distribution?: DistributionName | number;
  /** a list; NULL and 0 = one layer of stipples */
  layers?: readonly LayerDesc[];
  /** the most marks of all layers together: each gets its part of the tones; 0 = each layer has its own budget */
  sharedBudget?: number;
  /** HRBFNPR_TONE_RANGES_...; FULL */
  toneRanges?: ToneRangesName | number;
  /** HRBFNPR_SEED_...; AUTO */
  seedSource?: SeedName | number;
  /** for POINTS: n x 3, FLOAT32 or FLOAT64 */
  seedPoints?: ArrayInput;
  /** alpha: in cell sides, 0 .. 0.5; 0.25 */
  boxJitter?: number;
  /** R: cells on the largest side, 1 .. 256; 8 [NPAR 4.2] */
  boxResolution?: number;
  /**
   * rho_0, 0 or 1e-12 .. 1e9 diagonals; 0 = voxel diameter for BOX, mean empty-ball diameter of the seeds for
   * others [NPAR 5.1]. PUBLISHED only
   */
  initialStep?: number;
  /** as in hrbfnpr_project_desc; 1e-7 */
  projectionTolerance?: number;
  /** any number; 1 */
  randomSeed?: number;
}

/**
 * A layer of ready-made marks.  Types and components as in the list above,
 * FLOAT64 accepted for FLOAT32.  position and normal are needed, the others
 * may be left empty.
 */
export interface LayerArrays {
  /** HRBFNPR_LAYER_KIND_... but ANY; OWN */
  kind?: LayerKindName | number;
  /** UTF-8, 1 .. 63 bytes, copied; NULL = as in hrbfnpr_layer_desc, "own" for OWN */
  name?: string;
  /** absolute, not relative to an origin */
  position?: ArrayInput;
  /** unit, outward */
  normal?: ArrayInput;
  /**
   * UINT32, S + 1 elements, rising from 0 to the number of marks: stroke s has the marks first[s] .. first[s + 1]
   * - 1 from end to end. Empty = no strokes
   */
  strokeFirst?: ArrayInput;
  /** UINT8, S elements: 0 the first direction, 1 the second. Empty = 0 */
  strokeDirection?: ArrayInput;
  /** empty = along the stroke; of a mark of none its basis */
  direction?: ArrayInput;
  /** empty = not known */
  curvature?: ArrayInput;
  /** empty = random, the same for all marks of a stroke */
  rank?: ArrayInput;
  /** empty = 0 */
  level?: ArrayInput;
  /** in (0,1]; empty = 1 */
  width?: ArrayInput;
}

export interface PointSetDesc {
  /** its layers come first; NULL = none. Copied */
  base?: PointSet;
  /** a list: the layers that follow */
  layers?: readonly LayerArrays[];
  /** for ranks that are not given; 1 */
  randomSeed?: number;
}

export interface PointSetInfo {
  readonly distribution: DistributionName | number;
  /** the one used */
  readonly seedSource: number;
  /** how many */
  readonly layers: number;
  /** in all layers */
  readonly marks: number;
  /** add to POSITION */
  readonly origin: Numbers;
  /** of all marks, absolute */
  readonly boundsMin: Numbers;
  readonly boundsMax: Numbers;
  /**
   * sqrt(area per mark) of the largest layer, estimated: what a frame uses as the size of a mark's piece of
   * surface
   */
  readonly spacing: number;
  readonly secondsSeeds: number;
  readonly secondsTotal: number;
  /** kept by the set */
  readonly bytes: number;
}

export interface LayerInfo {
  /** HRBFNPR_LAYER_KIND_... */
  readonly kind: LayerKindName | number;
  /** UTF-8, always terminated */
  readonly name: string;
  readonly marks: number;
  /** 0: its marks form none */
  readonly strokes: number;
  /** what `marks` would be if nothing had been dropped */
  readonly fullCount: number;
  /** refinement steps taken; HATCH of BLUE_NOISE: the highest level */
  readonly levels: number;
  /** initial step rho_0 used; HATCH of BLUE_NOISE: the separation */
  readonly step: number;
  readonly seconds: number;
}

/** What became of candidates for marks: attempted = placed + all dropped. */
export interface PlacementInfo {
  readonly attempted: number;
  readonly placed: number;
  /** projection ended short of the tolerance */
  readonly droppedNotConverged: number;
  /**
   * landed farther away than a cell diagonal or the step, or beyond the end of a trimmed model; or cut off the
   * rest of its stroke by one that was dropped
   */
  readonly droppedStrayed: number;
  /** zero gradient or not finite */
  readonly droppedDegenerate: number;
  /** over the layer's budget */
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

