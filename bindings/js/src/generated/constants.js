// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/api.json; do not edit.

export const VERSION = Object.freeze({ VERSION_MAJOR: 0, VERSION_MINOR: 1, VERSION_PATCH: 0, ABI_VERSION: 1 });
export const STATUS = Object.freeze({ OK: 0, INVALID_ARGUMENT: -1, OUT_OF_MEMORY: -2, BUFFER_TOO_SMALL: -3,
  UNSUPPORTED_STRUCT: -4, SINGULAR_SYSTEM: -5, NOT_CONVERGED: -6, CANCELLED: -7, IO: -8, CORRUPT_DATA: -9,
  VERSION_MISMATCH: -10, CALLBACK: -11, INTERNAL: -99 });
export const SCALAR = Object.freeze({ FLOAT32: 1, FLOAT64: 2, UINT8: 3, UINT32: 4, INT32: 5, INT64: 6 });
export const FORMAT = Object.freeze({ RGBA8: 1, BGRA8: 2, RGBA8_PREMULTIPLIED: 3, BGRA8_PREMULTIPLIED: 4, RGBA32F: 5,
  RGBA32F_PREMULTIPLIED: 6, COVERAGE8: 7 });
export const LOG = Object.freeze({ DEBUG: 0, INFO: 1, WARNING: 2 });
export const INSTRUCTION_SET = Object.freeze({ AUTO: 0, BASELINE: 1, AVX2: 2, AVX512: 3, NEON: 4 });
export const THREAD_BACKEND = Object.freeze({ AUTO: 0, POOL: 1, OPENMP: 2, RUN_TASKS: 3, SERIAL: 4 });
export const KERNEL = Object.freeze({ TRIHARMONIC: 0, GAUSSIAN: 1, WENDLAND_C2: 2, CUSTOM: 3, CSG: 4 });
export const SOLVER = Object.freeze({ AUTO: 0, DIRECT: 1, ITERATIVE: 2 });
export const SOLVER_REASON = Object.freeze({ REQUESTED: 0, SMALL: 1, LARGE: 2, NOT_CONVERGED: 3, NOT_DEFINITE: 4 });
export const REPAIR = Object.freeze({ KEEP: 0, DROP: 1, REORIENT: 2 });
export const REGULARIZATION = Object.freeze({ GIVEN: 0, AUTO: 1 });
export const NORMALS = Object.freeze({ GIVEN: 0, NONE: 1, UNORIENTED: 2, MIXED: 3, INWARD: 4, AUTO: 5 });
export const TRIM = Object.freeze({ NEVER: 0, AUTO: 1 });
export const OUTWARD = Object.freeze({ INSIDE: 0, UP: 1, VIEWPOINT: 2, AS_GIVEN: 3 });
export const CUSTOM = Object.freeze({ HAS_GRADIENT: 1, HAS_HESSIAN: 2, THREAD_SAFE: 4 });
export const MODEL_ATTRIBUTE = Object.freeze({ POSITION: 0, NORMAL: 1, RESIDUAL_HISTORY: 2 });
export const PROJECTION = Object.freeze({ CONVERGED: 0, NOT_CONVERGED: 1, ZERO_GRADIENT: 2, NOT_FINITE: 3 });
export const RAY = Object.freeze({ HIT: 0, MISS: 1, TRUNCATED: 2, EVALUATION_LIMIT: 3, NOT_FINITE: 4 });
export const CSG = Object.freeze({ UNION: 0, INTERSECTION: 1, DIFFERENCE: 2, COMPLEMENT: 3, OFFSET: 4, SHELL: 5,
  MODEL: 6, HALF_SPACE: 7, BOX: 8, SPHERE: 9, CYLINDER: 10, CONE: 11, TORUS: 12 });
export const LAYER_KIND = Object.freeze({ ANY: 0, STIPPLES: 1, PRINCIPAL: 2, COMBING: 3, FIELD: 4, OWN: 5, HATCH: 6
  });
export const DISTRIBUTION = Object.freeze({ BLUE_NOISE: 0, PUBLISHED: 1 });
export const SYMMETRY = Object.freeze({ LINE: 0, CROSS: 1 });
export const HATCH_GUIDE = Object.freeze({ CURVATURE: 0, COMBING: 1, SECTIONS: 2, LIGHT: 3, SILHOUETTE: 4 });
export const SEED = Object.freeze({ AUTO: 0, SAMPLES: 1, BOX: 2, POINTS: 3 });
export const STROKE_START = Object.freeze({ SEEDS: 0, STIPPLES: 1 });
export const DENSITY = Object.freeze({ UNIFORM: 0, CURVATURE: 1, CALLBACK: 2 });
export const TONE_RANGES = Object.freeze({ FULL: 0, IN_TURN: 1 });
export const LAYER_WITH = Object.freeze({ CURVATURE: 1 });
export const MARK_ATTRIBUTE = Object.freeze({ POSITION: 0, NORMAL: 1, DIRECTION: 2, CURVATURE: 3, RANK: 4, LEVEL: 5,
  STROKE: 6, WIDTH: 7, STROKE_FIRST: 8, STROKE_ORDER: 9, TONE_NORMAL: 10 });
export const LINE_KIND = Object.freeze({ CONTOUR: 1, SUGGESTIVE_CONTOUR: 2, RIDGE: 3, VALLEY: 4, APPARENT_RIDGE: 5,
  PARABOLIC: 6, ISOPHOTE: 7, SECTION: 8, BORDER: 9, OWN: 10, CREASE: 11 });
export const LINE_SET_WITH = Object.freeze({ CURVATURE: 1 });
export const DEPTH = Object.freeze({ NEGATIVE_ONE_TO_ONE: 0, ZERO_TO_ONE: 1, REVERSED: 2 });
export const HIDDEN_LINES = Object.freeze({ ATTENUATE: 0, HIDE: 1, SHOW: 2 });
export const VISIBILITY = Object.freeze({ DEPTH_LAYERS: 0, PUBLISHED: 1 });
export const TONE_CURVE = Object.freeze({ COVERAGE: 0, LINEAR: 1 });
export const SILHOUETTE_LAW = Object.freeze({ WIDTH: 0, ANGLE: 1 });
export const TONE = Object.freeze({ NONE: 0, LIGHT: 1, CALLBACK: 2 });
export const TONE_RULE = Object.freeze({ SHARE: 0, PUBLISHED: 1 });
export const LIGHT = Object.freeze({ WORLD: 0, CAMERA: 1 });
export const SHAPE = Object.freeze({ DOTS: 0, STROKES: 1, HATCH: 2 });
export const HIDDEN_PARTS = Object.freeze({ NONE: 0, ATTENUATED: 1, DASHED: 2, SHOWN: 3 });
export const CAP = Object.freeze({ ROUND: 0, FLAT: 1, POINTED: 2 });
export const CREASES = Object.freeze({ ALL: 0, CONVEX: 1, CONCAVE: 2 });
export const PRESET = Object.freeze({ STIPPLE: 0, HATCH: 1, CROSS_HATCH: 2, COMBING: 3, SILHOUETTE: 4,
  CONTOUR_AND_STIPPLE: 5, XRAY: 6, FULL: 7, ENGRAVING: 8, ETCHING: 9, WOODCUT: 10, SCIENTIFIC_STIPPLE: 11, SKETCH: 12,
  BLUEPRINT: 13, ARCHAEOLOGICAL: 14 });
export const SIDES = Object.freeze({ FRONT: 0, BOTH: 1 });
export const CLASS = Object.freeze({ NONE: 0, FRONT: 1, BACK: 2, SILHOUETTE: 3 });
export const RASTER = Object.freeze({ OVER: 1, LINEAR_LIGHT: 2 });
export const PRIMITIVE = Object.freeze({ POINTS: 1, LINE_STRIPS: 2, TRIANGLE_STRIPS: 3 });
export const INDEX = Object.freeze({ RESTART: -1 });
export const VERTEX_ATTRIBUTE = Object.freeze({ POSITION: 0, WINDOW: 1, RADIUS: 2, COLOR: 3, NORMAL: 4, DIRECTION: 5,
  ID: 6, CLASS: 7, IS_PAPER: 8, LAYER: 9, LENGTH: 10, HIDDEN_LAYERS: 11, HIDDEN_BY: 12, LINE: 13 });
export const PARTS = Object.freeze({ OUTER: 0, ALL: 1, LARGEST: 2 });
export const FACES = Object.freeze({ TURN: 0, KEEP: 1 });
export const MESH_ATTRIBUTE = Object.freeze({ VERTEX: 0, TRIANGLE: 1, COMPONENT: 2, GIVEN_FACE: 3, CORNER_NORMAL: 4
  });
export const EDGES = Object.freeze({ AUTO: 0, SMOOTH: 1, SHARP: 2 });
export const PAGE_FORMAT = Object.freeze({ SVG: 0, PDF: 1, HPGL: 2, GCODE: 3 });
export const WIDTHS = Object.freeze({ OUTLINES: 0, CLASSES: 1 });
export const DOT_SHAPE = Object.freeze({ CIRCLES: 0, LINES: 1, SPIRALS: 2 });
export const PAGE = Object.freeze({ IN_PLOT_ORDER: 1, SINGLE_PASS: 4, WITHOUT_PAPER: 2 });
export const LINE_TYPE = Object.freeze({ AS_DRAWN: 0, CONTINUOUS: 1, DASHED: 2, DASHED_SPACED: 3, LONG_DASHED_DOTTED:
  4, LONG_DASHED_DOUBLE_DOTTED: 5, LONG_DASHED_TRIPLE_DOTTED: 6, DOTTED: 7, LONG_DASHED_SHORT_DASHED: 8,
  LONG_DASHED_DOUBLE_SHORT_DASHED: 9, DASHED_DOTTED: 10, DOUBLE_DASHED_DOTTED: 11, DASHED_DOUBLE_DOTTED: 12,
  DOUBLE_DASHED_DOUBLE_DOTTED: 13, DASHED_TRIPLE_DOTTED: 14, DOUBLE_DASHED_TRIPLE_DOTTED: 15 });

/** All groups, by name. */
export const GROUPS = { VERSION, STATUS, SCALAR, FORMAT, LOG, INSTRUCTION_SET, THREAD_BACKEND, KERNEL, SOLVER,
  SOLVER_REASON, REPAIR, REGULARIZATION, NORMALS, TRIM, OUTWARD, CUSTOM, MODEL_ATTRIBUTE, PROJECTION, RAY, CSG,
  LAYER_KIND, DISTRIBUTION, SYMMETRY, HATCH_GUIDE, SEED, STROKE_START, DENSITY, TONE_RANGES, LAYER_WITH,
  MARK_ATTRIBUTE, LINE_KIND, LINE_SET_WITH, DEPTH, HIDDEN_LINES, VISIBILITY, TONE_CURVE, SILHOUETTE_LAW, TONE,
  TONE_RULE, LIGHT, SHAPE, HIDDEN_PARTS, CAP, CREASES, PRESET, SIDES, CLASS, RASTER, PRIMITIVE, INDEX,
  VERTEX_ATTRIBUTE, PARTS, FACES, MESH_ATTRIBUTE, EDGES, PAGE_FORMAT, WIDTHS, DOT_SHAPE, PAGE, LINE_TYPE };
