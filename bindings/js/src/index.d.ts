// SPDX-License-Identifier: MIT
// Types of the package.  Options and results have the names of the C structs' fields in camelCase; their comments, with
// units, ranges and defaults, are in generated/options.d.ts.
import type * as C from "./generated/constants.js";
import type { Functions, Pointer } from "./generated/functions.js";
import type * as O from "./generated/options.js";

export * from "./generated/constants.js";
export type { Functions, Pointer } from "./generated/functions.js";
export type {
  Annotation, CastDesc, CompareDesc, Comparison, ContextDesc, ContextInfo, CsgDesc, CsgInfo, CsgNode, CustomDesc,
  DepthImageDesc, DepthImageInfo, DrawingInfo, DrawingLayerInfo, FitDesc, GenerateDesc, Item, LayerArrays, LayerDesc,
  LayerInfo, LayerPose, LayerStyle, LineDesc, LineSetDesc, LineSetInfo, LineStyle, MarkIdentity, MeshDesc, MeshFitDesc,
  MeshEdgesDesc, MeshFitInfo, MeshInfo, ModelInfo, OrientDesc, OrientInfo, PageDesc, PageInfo, PageItem, Pen, PictureDesc,
  PictureInfo, PicturePageDesc, PictureSource, PlacementInfo, ViewsDesc, ViewsInfo,
  PointSetDesc, PointSetInfo, ProjectDesc, SampleDesc, Style, TrimDesc, TrimInfo,
} from "./generated/options.js";

export type Numbers = ArrayLike<number>;
export type TypedArray = Float32Array | Float64Array | Uint8Array | Uint8ClampedArray | Uint32Array | Int32Array
  | BigInt64Array;
/** Elements one after the other (x y z x y z ...), or rows of them; or with another number of components. */
export type Elements = TypedArray | readonly number[] | readonly (readonly number[])[];
export type ArrayInput = Elements | { data: Elements; components: number };
/** Filled by the call. */
export type ArrayOutput = TypedArray | { data: TypedArray; components: number };

/** Progress in [0, 1]; false cancels. */
export type ProgressFn = (progress: number) => boolean | void;
/** A stage of a picture that runs or ends, or a note. */
export type PictureEventFn = (event: O.PictureEvent & { note?: O.Note }) => void;
export type LogFn = (message: string, level: "debug" | "info" | "warning") => void;
export type AllocateFn = never;
export type DeallocateFn = never;
export type RunTasksFn = never;
/** Fills `value` (n) and, where they are not null, `gradient` (3 n) and `hessian` (6 n: xx xy xz yy yz zz). */
export type ImplicitFn = (points: Float64Array, out: {
  value: Float64Array; gradient: Float64Array | null; hessian: Float64Array | null }) => void;
export type DensityFn = (positions: Float64Array, normals: Float64Array, density: Float64Array) => void;
export type DirectionFn = (positions: Float64Array, normals: Float64Array, directions: Float64Array) => void;
export type ToneFn = (positions: Float32Array, normals: Float32Array, tau: Float32Array) => void;

/** Of a long call.  It runs on the calling thread: a page makes it in a worker. */
export interface Control {
  onProgress?: ProgressFn;
  /** Looked at with each progress; another task can abort it only where the call itself lets it, as in onProgress. */
  signal?: AbortSignal;
  /** On shared memory: any thread cancels by a number other than 0 in its first element. */
  cancelFlag?: Int32Array;
}

export interface LoadOptions {
  /** 1 (default); a larger number, or "auto" for all processors where the page may: the build with threads. */
  threads?: number | "auto";
  /** The module's bytes, or Library.wasm of another worker's, instead of fetching them. */
  wasm?: WebAssembly.Module | BufferSource;
  /** An address in the folder "src" of the package, where that has been moved; import.meta.url. */
  base?: string | URL;
}

/** Compiles and starts the module. */
export function load(options?: LoadOptions): Promise<Library>;
/** Whether the build with threads can run here: a page has to be cross-origin isolated. */
export function canUseThreads(): boolean;

/** A call that failed.  The message names the argument and the remedy. */
export class HrbfnprError extends Error {
  constructor(status: number, message: string);
  /** One of STATUS. */
  readonly status: number;
  /** Such as "INVALID_ARGUMENT". */
  readonly statusName: string;
  readonly isCancelled: boolean;
}

/** One instance of the module. */
export class Library {
  private constructor();
  /** Threads that a context uses unless told otherwise. */
  readonly threads: number;
  readonly wasm: WebAssembly.Module;
  /** The C interface itself. */
  readonly raw: Functions;
  readonly version: string;
  readonly presetNames: C.PresetName[];
  /** The module's memory as it is now: a call that makes it grow makes views useless. */
  readonly views: { readonly bytes: Uint8Array; readonly data: DataView; readonly buffer: ArrayBufferLike };
  /** Bytes in the module's memory, for `raw`; 0 where there are none. */
  malloc(bytes: number): Pointer;
  free(address: Pointer): void;
  /** The text at an address. */
  text(address: Pointer): string | undefined;
  buildInfo(): Record<string, unknown>;
  layout(name: string): { name: string; size: number; align: number;
                          fields: { name: string; type: string; offset: number; size: number }[] } | undefined;
  /** Throws if the module is of another version than the package. */
  checkLayouts(): void;
  createContext(options?: O.ContextDesc): Context;
  createCamera(options?: O.Camera): Camera;
  /** A style as plain data, to be changed and given to Renderer.draw. */
  style(preset?: C.PresetName | number): O.Style;
  /** The layers that a preset draws. */
  presetLayers(preset: C.PresetName | number): O.LayerDesc[];
  /** The defaults of a struct of options, such as "hrbfnpr_fit_desc". */
  defaults(name: string): Record<string, unknown>;
}

/** What the library keeps until it is freed: by free(), by `using`, or some time after nothing refers to it any more. */
export class Handle {
  protected constructor();
  readonly library: Library;
  readonly pointer: Pointer;
  readonly isFreed: boolean;
  /** Gives it back; what was made from it lives on. */
  free(): void;
}

/** Threads, memory and log; everything else is made from one. */
export class Context extends Handle {
  info(): O.ContextInfo;
  /** Draws anything: points (n x 3, with or without normals), a mesh (points and triangles), a model or a point set, or
   *  several of these.  All that is left open is chosen, and told in the picture's notes. */
  draw(source: PictureInput | readonly PictureInput[], options?: PictureOptions, control?: Control): Picture;
  /** Reads a file of settings, for the option `settings`. */
  loadSettings(text: string | Uint8Array): Settings;
  /** Fits a surface to points (n x 3) and outward normals (n x 3); without normals set normalMode. */
  fit(options: O.FitDesc, control?: Control): Model;
  /** Fits a surface to a mesh; `fit` are options of the fits. */
  fitMesh(mesh: Mesh, options?: O.MeshFitDesc & { fit?: O.FitDesc }, control?: Control): Model;
  /** A solid put together from others: a list of nodes, each with the number of its parent. */
  createCsg(nodes: readonly O.CsgNode[], options?: Omit<O.CsgDesc, "nodes">): Model;
  /** Any implicit function.  `release` is called when nothing needs it any more. */
  createCustom(options: O.CustomDesc & { release?: () => void }): Model;
  createMesh(options: O.MeshDesc, control?: Control): Mesh;
  createPointSet(options: O.PointSetDesc): PointSet;
  createLineSet(model: Model, options?: O.LineSetDesc, control?: Control): LineSet;
  /** Places marks; `preset` gives the layers that are not in `layers`. */
  generate(model: Model, options?: O.GenerateDesc & { preset?: C.PresetName | number }, control?: Control): PointSet;
  loadModel(bytes: Uint8Array): Model;
  loadPointSet(bytes: Uint8Array): PointSet;
  createRenderer(): Renderer;
  /** Finds or repairs outward unit normals, n x 3. */
  smoothDepthImage(options: O.DepthImageDesc, control?: Control): {
    points: Float64Array; normals: Float64Array; info: O.DepthImageInfo;
  };
  orient(options: O.OrientDesc, control?: Control): { normals: Float64Array; info: O.OrientInfo };
  farthestPoints(points: ArrayInput, count: number, control?: Control): { indices: Uint32Array; distances: Float64Array };
  /** SVG, PDF, HPGL or G-code of drawings, lines and texts. */
  writePage(options: O.PageDesc, control?: Control): { bytes: Uint8Array; info: O.PageInfo };
  /** Squares of twice the initial step, 12 numbers each [NPAR 5.1]. */
  stepPatches(model: Model, count: number, options?: O.GenerateDesc, control?: Control): {
    corners: Float64Array; step: number };
}

/** An implicit surface f = 0: f < 0 inside.  Points are n x 3. */
export class Model extends Handle {
  readonly context: Context;
  /** What a fit to a mesh came to; undefined of other models. */
  readonly meshFit?: O.MeshFitInfo;
  info(): O.ModelInfo;
  trimInfo(): O.TrimInfo;
  csgInfo(): O.CsgInfo;
  /** A copy of the centres, their normals, or the solver's residuals. */
  view(attribute: C.ModelAttributeName | number): Float64Array;
  evaluate(points: ArrayInput, wanted?: { gradient?: boolean; hessian?: boolean }, control?: Control): {
    value: Float64Array; gradient?: Float64Array; hessian?: Float64Array };
  project(points: ArrayInput, options?: O.ProjectDesc, control?: Control): {
    position: Float64Array; normal: Float64Array; status: Uint8Array; converged: number };
  curvature(points: ArrayInput, control?: Control): {
    k1: Float64Array; k2: Float64Array; d1: Float64Array; d2: Float64Array; confidence: Float64Array };
  castRays(origins: ArrayInput, directions: ArrayInput, options?: O.CastDesc, control?: Control): {
    count: Uint32Array; t: Float64Array; position: Float64Array; normal: Float64Array; entering: Uint8Array;
    status: Uint8Array; hitRays: number };
  /** A bound on |grad f| for castRays. */
  lipschitz(control?: Control): number;
  /** 1 for each point inside. */
  contains(points: ArrayInput, control?: Control): Uint8Array;
  trim(options?: O.TrimDesc, control?: Control): Model;
  compareMesh(mesh: Mesh, options?: O.CompareDesc, control?: Control): O.Comparison;
  generate(options?: O.GenerateDesc & { preset?: C.PresetName | number }, control?: Control): PointSet;
  createLineSet(options?: O.LineSetDesc, control?: Control): LineSet;
  save(): Uint8Array;
}

/** Layers of marks on a surface. */
export class PointSet extends Handle {
  readonly context: Context;
  info(): O.PointSetInfo;
  layerInfo(layer: number): O.LayerInfo;
  seedPlacement(): O.PlacementInfo;
  placement(layer: number, level: number): O.PlacementInfo;
  /** A copy of one attribute of one layer. */
  view(layer: number, attribute: C.MarkAttributeName | number): TypedArray;
  save(): Uint8Array;
}

/** What the lines of a surface are drawn from. */
export class LineSet extends Handle {
  readonly context: Context;
  info(): O.LineSetInfo;
}

/** Triangles, made usable. */
export class Mesh extends Handle {
  readonly context: Context;
  info(): O.MeshInfo;
  view(attribute: C.MeshAttributeName | number): TypedArray;
  /** Even samples with their normals, each count x 3. */
  sample(count: number, options?: O.SampleDesc, control?: Control): { points: Float64Array; normals: Float64Array };
  /** Sharp edges (3 numbers for each face: 1 = the edge from that corner to the next is sharp), and patches of faces. */
  edges(options?: O.MeshEdgesDesc, control?: Control): { patches: Int32Array; sharp: Int32Array };
}

export interface PictureSize {
  width: number;
  height: number;
}

export interface FitView extends PictureSize {
  /** From the eye into the scene; (0, 0, -1). */
  direction?: Numbers;
  /** (0, 1, 0). */
  up?: Numbers;
  /** Radians; 0 = orthographic; 0.6. */
  verticalAngle?: number;
  /** Share of the picture on each side, 0 .. 0.45; 0.05. */
  margin?: number;
}

/** Where a scene is seen from. */
export class Camera implements O.Camera {
  private constructor();
  depthConvention: C.DepthName | number;
  /** 16 numbers, column by column. */
  view: number[];
  projection: number[];
  /** x, y, width, height in pixels. */
  viewport: number[];
  lookAt(eye: Numbers, target: Numbers, up?: Numbers): this;
  /** Angle in radians. */
  perspective(verticalAngle: number, width: number, height: number, near: number, far: number): this;
  orthographic(viewHeight: number, width: number, height: number, near: number, far: number): this;
  fitBounds(min: Numbers, max: Numbers, view: FitView): this;
  /** n x 3 points; `origin` is added to each. */
  fitPoints(points: ArrayInput, view: FitView & { origin?: Numbers }): this;
}

export type PictureInput = O.PictureSource;
export interface PictureOptions extends Omit<O.PictureDesc, "sources" | "style"> {
  /** The name of a style, such as "engraving", or one that is used as it is. */
  style?: C.PresetName | O.Style;
  /** Fields that are changed by their names: { "style.tone_exponent": 1.5, "fit.kernel": "gaussian" }. */
  set?: Record<string, string | number>;
  /** A picture in which hardly anything can be seen is no error. */
  allowBlank?: boolean;
}
export interface PictureNote {
  code: C.NoteName | number;
  severity: C.SeverityName | number;
  figures: number[];
  text: string;
}

/** One surface of a picture. */
export interface PicturePart {
  sides: C.SidesName | number;
  /** Undefined of a point set. */
  model?: Model;
  pointSet?: PointSet;
  /** Undefined without lines. */
  lineSet?: LineSet;
  /** Of a mesh, as it was fitted to. */
  mesh?: Mesh;
}

/** What was planned for a source, ready to be drawn. */
export class Picture extends Handle {
  readonly context: Context;
  /** By the camera that was planned; with allowBlank it is drawn when it is first asked for. */
  readonly drawing: Drawing;
  readonly notes: PictureNote[];
  info(): O.PictureInfo;
  /** The same surfaces in another style, size or view. */
  restyle(options?: PictureOptions, control?: Control): Picture;
  camera(): Camera;
  /** From another side; angles in degrees. */
  look(from?: { azimuth?: number; elevation?: number; direction?: Numbers }): Camera;
  /** The planned camera after some degrees around the up axis. */
  orbit(degrees: number): Camera;
  draw(camera?: O.Camera, control?: Control): Drawing;
  /** With a section and a scale bar where the picture has them. */
  rasterize(options?: { drawing?: Drawing; camera?: O.Camera; format?: C.FormatName | number }): {
    width: number; height: number; data: Uint8ClampedArray };
  /** SVG, PDF, HPGL or G-code. */
  write(options?: O.PicturePageDesc & { drawing?: Drawing; camera?: O.Camera }, control?: Control): {
    bytes: Uint8Array; info: O.PageInfo };
  toSVG(options?: O.PicturePageDesc & { drawing?: Drawing; camera?: O.Camera }): string;
  /** Views and sections on a sheet, to scale. */
  writeViews(options?: O.ViewsDesc, control?: Control): { bytes: Uint8Array; info: O.ViewsInfo };
  /** The text of a file of settings that draws the same. */
  settings(): string;
  /** The model of a part; undefined of a point set. */
  model(number?: number): Model | undefined;
  /** The surfaces, the largest first, for Renderer.draw. */
  parts(): PicturePart[];
  /** The style as it was planned, with lengths in pixels; what dabs paint is not in it. */
  style(): O.Style;
}

/** A file of settings that was read. */
export class Settings extends Handle {
  readonly context: Context;
}

/** From items and a camera to a drawing.  One call at a time. */
export class Renderer extends Handle {
  readonly context: Context;
  draw(items: O.Item | readonly O.Item[], camera: O.Camera, control?: Control): Drawing;
}

export interface RasterOptions {
  /** Pixels; the end of the camera's viewport. */
  width?: number;
  height?: number;
  /** "rgba8" (default), "bgra8", "rgba32f", ... */
  format?: C.FormatName | number;
  /** Laid under the drawing: its pixels in the same format. */
  image?: Uint8ClampedArray | Uint8Array | Float32Array;
  linearLight?: boolean;
  /** Ink behind it is not drawn: width x height. */
  hostDepth?: Float32Array;
  depth?: boolean;
  id?: boolean;
  markClass?: boolean;
}

/** A picture as a value. */
export class Drawing extends Handle {
  readonly context: Context;
  readonly width: number;
  readonly height: number;
  info(): O.DrawingInfo;
  layerInfo(number: number): O.DrawingLayerInfo;
  /** What an id of rasterize({ id: true }) stands for. */
  identify(id: number): O.MarkIdentity;
  rasterize(options?: RasterOptions): { width: number; height: number; data: Uint8ClampedArray | Float32Array;
                                        depth?: Float32Array; id?: Uint32Array; markClass?: Uint8Array };
  /** Vertices for the graphics card: their bytes, and where each attribute is in one. */
  vertices(primitive: C.PrimitiveName | number, attributes: readonly C.VertexAttributeName[]): {
    vertices: Uint8Array; stride: number; offsets: Record<string, number>; indices: Uint32Array };
  /** How each of the `count` marks of a layer is drawn. */
  markResults(item: number, layer: number, count: number): {
    shown: Uint8Array; radius: Float32Array; opacity: Float32Array };
  markIndices(item: number, layer: number, options?: {
    markClass?: C.ClassName | number; primitive?: C.PrimitiveName | number }): Uint32Array;
  /** The drawing alone, on a page of its size. */
  toSVG(options?: Omit<O.PageDesc, "items" | "format">): string;
}
