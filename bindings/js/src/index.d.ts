// SPDX-License-Identifier: MIT
// Types of the package.  Options and results have the names of the fields of C structs, in camelCase.  Their comments,
// with units, ranges and defaults, are in generated/options.d.ts.
import type * as C from "./generated/constants.js";
import type { Functions, Pointer } from "./generated/functions.js";
import type * as O from "./generated/options.js";

export * from "./generated/constants.js";
export type { Functions, Pointer } from "./generated/functions.js";
export type {
  Annotation, CastDesc, CompareDesc, Comparison, ContextDesc, ContextInfo, CsgDesc, CsgInfo, CsgNode, CustomDesc,
  Dab, DepthImageDesc, DepthImageInfo, DrawingInfo, DrawingLayerInfo, FieldDesc, FitDesc, GenerateDesc, Item, LayerArrays, LayerDesc,
  LayerInfo, LayerPose, LayerStyle, Light, LineDesc, LineSetDesc, LineSetInfo, LineStyle, MarkIdentity, MeshDesc, MeshFitDesc,
  MeshEdgesDesc, MeshFitInfo, MeshInfo, ModelInfo, OrientDesc, OrientInfo, PageDesc, PageInfo, PageItem, Pen, PictureDesc,
  PictureInfo, PicturePageDesc, PictureSource, PlacementInfo, ViewsDesc, ViewsInfo,
  PointSetDesc, PointSetInfo, ProjectDesc, SampleDesc, ShadingDesc, Style, TrimDesc, TrimInfo,
} from "./generated/options.js";

export type Numbers = ArrayLike<number>;
export type TypedArray = Float32Array | Float64Array | Uint8Array | Uint8ClampedArray | Uint32Array | Int32Array
  | BigInt64Array;
/** Numbers of all elements, one element after the other (x y z x y z ...), or rows of numbers. */
export type Elements = TypedArray | readonly number[] | readonly (readonly number[])[];
/** Elements with the usual number of components, or with another one. */
export type ArrayInput = Elements | { data: Elements; components: number };
/** An array that the call fills. */
export type ArrayOutput = TypedArray | { data: TypedArray; components: number };

/** Receives the progress, from 0 to 1.  Return false to cancel the call. */
export type ProgressFn = (progress: number) => boolean | void;
/** Receives events of a picture: the progress of a stage, or a note. */
export type PictureEventFn = (event: O.PictureEvent & { note?: O.Note }) => void;
/** Receives messages of the library's log. */
export type LogFn = (message: string, level: "debug" | "info" | "warning") => void;
/** Not available in JavaScript, and neither are the two types below. */
export type AllocateFn = never;
export type DeallocateFn = never;
export type RunTasksFn = never;
/** Fills `value` (n numbers) and, if they are not null, `gradient` (3 n) and `hessian` (6 n: xx xy xz yy yz zz). */
export type ImplicitFn = (points: Float64Array, out: {
  value: Float64Array; gradient: Float64Array | null; hessian: Float64Array | null }) => void;
/** Fills `density` (n numbers): 1 where marks lie closest, 0 where no mark lies. */
export type DensityFn = (positions: Float64Array, normals: Float64Array, density: Float64Array) => void;
/** Fills `directions` (3 n numbers); (0, 0, 0) = no direction. */
export type DirectionFn = (positions: Float64Array, normals: Float64Array, directions: Float64Array) => void;
/** Fills `values` (n numbers for a scalar, 3 n for other kinds) and `weights` (n numbers from 0 to 1; they are 1 before
 *  the call). */
export type FieldFn = (positions: Float64Array, normals: Float64Array, out: {
  values: Float64Array; weights: Float64Array }) => void;
/** Fills `tau` (n numbers): 1 = light, 0 = dark. */
export type ToneFn = (positions: Float32Array, normals: Float32Array, tau: Float32Array) => void;

/** Progress and cancelling of a long call.  The call runs on the calling thread, so a web page makes it in a worker. */
export interface Control {
  /** Receives the progress; return false to cancel. */
  onProgress?: ProgressFn;
  /** Checked with each progress.  While the call runs, only its own callbacks, such as onProgress, can abort it. */
  signal?: AbortSignal;
  /** An array in shared memory.  Any thread cancels the call by writing a number other than 0 to its first element. */
  cancelFlag?: Int32Array;
}

export interface LoadOptions {
  /** Number of threads; 1 to 256; default 1.  More than 1 loads the build with threads.  "auto" = one for each
   *  processor, or 1 if threads cannot be used. */
  threads?: number | "auto";
  /** The bytes of the module, or Library.wasm of another worker; default: they are fetched. */
  wasm?: WebAssembly.Module | BufferSource;
  /** An address in the package's folder "src", if that was moved; default import.meta.url. */
  base?: string | URL;
}

/** Compiles and starts the module. */
export function load(options?: LoadOptions): Promise<Library>;
/** Whether the build with threads can run here.  A web page must be cross-origin isolated. */
export function canUseThreads(): boolean;

/** A call failed.  The message names the wrong argument and says what to do. */
export class HrbfnprError extends Error {
  constructor(status: number, message: string);
  /** A number of STATUS. */
  readonly status: number;
  /** The name of the status, such as "INVALID_ARGUMENT". */
  readonly statusName: string;
  /** Whether the caller cancelled the call. */
  readonly isCancelled: boolean;
}

/** One instance of the WebAssembly module. */
export class Library {
  private constructor();
  /** Default number of threads of a context, the calling one included. */
  readonly threads: number;
  /** The compiled module, for load() in another worker. */
  readonly wasm: WebAssembly.Module;
  /** The functions of the C interface, by their names in C. */
  readonly raw: Functions;
  /** The library's version, "major.minor.patch". */
  readonly version: string;
  /** The names of the presets, in the order of their numbers. */
  readonly presetNames: C.PresetName[];
  /** Views of the module's memory.  A call that makes the memory grow invalidates them. */
  readonly views: { readonly bytes: Uint8Array; readonly data: DataView; readonly buffer: ArrayBufferLike };
  /** Allocates bytes in the module's memory, for `raw`; 0 if there are none left. */
  malloc(bytes: number): Pointer;
  /** Frees bytes that malloc allocated. */
  free(address: Pointer): void;
  /** The text at an address; undefined for NULL. */
  text(address: Pointer): string | undefined;
  /** Describes the build: version, abi, compiler, instruction_sets, thread_backends, dependencies. */
  buildInfo(): Record<string, unknown>;
  /** How the module lays out a struct, such as "hrbfnpr_fit_desc"; undefined for an unknown name. */
  layout(name: string): { name: string; size: number; align: number;
                          fields: { name: string; type: string; offset: number; size: number }[] } | undefined;
  /** Throws if the package and the module lay out structs differently, because their versions differ. */
  checkLayouts(): void;
  /** Creates a context, from which everything else is made. */
  createContext(options?: O.ContextDesc): Context;
  /** Creates a camera. */
  createCamera(options?: O.Camera): Camera;
  /** A style as plain data, which can be changed and passed to Renderer.draw; without a preset the default style. */
  style(preset?: C.PresetName | number): O.Style;
  /** The layers that a preset draws, for `generate`. */
  presetLayers(preset: C.PresetName | number): O.LayerDesc[];
  /** The defaults of a struct of options, such as "hrbfnpr_fit_desc". */
  defaults(name: string): Record<string, unknown>;
}

/** An object of the library.  free() or `using` frees it, or the garbage collector at some time after its last use. */
export class Handle {
  protected constructor();
  readonly library: Library;
  /** The address of the object, for Library.raw. */
  readonly pointer: Pointer;
  readonly isFreed: boolean;
  /** Frees the object.  Objects that were made from it stay alive. */
  free(): void;
}

/** Holds the threads, the memory and the log.  Everything else is made from a context. */
export class Context extends Handle {
  info(): O.ContextInfo;
  /** Draws one or several sources: points (n x 3, with or without normals), a mesh (points and triangles), { model }
   *  or { pointSet }.  The picture chooses what the options leave open, and tells its choices in its notes. */
  draw(source: PictureInput | readonly PictureInput[], options?: PictureOptions, control?: Control): Picture;
  /** Reads the text of a settings file, for the option `settings`. */
  loadSettings(text: string | Uint8Array): Settings;
  /** Fits a surface to points (n x 3) and outward normals (n x 3).  Without normals, set normalMode. */
  fit(options: O.FitDesc, control?: Control): Model;
  /** Fits a surface to a mesh.  `fit` has kernel, solver, regularization and trim. */
  fitMesh(mesh: Mesh, options?: O.MeshFitDesc & { fit?: O.FitDesc }, control?: Control): Model;
  /** Makes a solid from a list of nodes, each with the index of its parent. */
  createCsg(nodes: readonly O.CsgNode[], options?: Omit<O.CsgDesc, "nodes">): Model;
  /** Makes a model of any implicit function.  `release` is called when the model is released. */
  createCustom(options: O.CustomDesc & { release?: () => void }): Model;
  /** Makes a mesh from triangles, and repairs it. */
  createMesh(options: O.MeshDesc, control?: Control): Mesh;
  /** Makes a point set from marks of the caller. */
  createPointSet(options: O.PointSetDesc): PointSet;
  /** Makes the line set of a model, from which its lines are drawn for every camera. */
  createLineSet(model: Model, options?: O.LineSetDesc, control?: Control): LineSet;
  /** Gathers the surfaces that cast shadows and hide the sky: those of all items that have a line set, at their
   *  transforms.  Walls thinner than a cell of the line set may let light through. */
  createOccluders(items: O.Item | readonly O.Item[], control?: Control): Occluders;
  /** Computes how much of the sky and of each light with a shadow the marks of an item see, for `shading` of the item.
   *  It uses the item's point set, style and transform.  Lights in camera space that cast shadows need `camera`. */
  createShading(occluders: Occluders, item: O.Item, options?: O.ShadingDesc & { camera?: O.Camera },
                control?: Control): Shading;
  /** Makes a field from `points` and `values`, a `function`, `dabs`, or an `image` with a `camera`; `source` follows. */
  createField(options: FieldOptions, control?: Control): Field;
  /** Places marks on the surface of a model.  `preset` gives the layers if `layers` is missing. */
  generate(model: Model, options?: O.GenerateDesc & { preset?: C.PresetName | number }, control?: Control): PointSet;
  /** Loads what Model.save returned. */
  loadModel(bytes: Uint8Array): Model;
  /** Loads what PointSet.save returned. */
  loadPointSet(bytes: Uint8Array): PointSet;
  /** Creates a renderer. */
  createRenderer(): Renderer;
  /** Removes the sensor's noise from the image of a depth camera, and finds normals. */
  smoothDepthImage(options: O.DepthImageDesc, control?: Control): {
    points: Float64Array; normals: Float64Array; info: O.DepthImageInfo;
  };
  /** Finds outward unit normals for points, or repairs given normals, n x 3. */
  orient(options: O.OrientDesc, control?: Control): { normals: Float64Array; info: O.OrientInfo };
  /** Orders points so that each is the farthest from those before it. */
  farthestPoints(points: ArrayInput, count: number, control?: Control): { indices: Uint32Array; distances: Float64Array };
  /** Writes drawings, lines and texts as SVG, PDF, HPGL, G-code or DXF. */
  writePage(options: O.PageDesc, control?: Control): { bytes: Uint8Array; info: O.PageInfo };
  /** Makes squares with sides of two initial steps; 12 numbers each [NPAR 5.1]. */
  stepPatches(model: Model, count: number, options?: O.GenerateDesc, control?: Control): {
    corners: Float64Array; step: number };
}

/** An implicit surface f = 0; f is negative inside.  Points are n x 3. */
export class Model extends Handle {
  readonly context: Context;
  /** The result of a fit to a mesh; undefined for other models. */
  readonly meshFit?: O.MeshFitInfo;
  /** What the fit found and did. */
  info(): O.ModelInfo;
  /** What the last trim left out. */
  trimInfo(): O.TrimInfo;
  /** What a solid is made of. */
  csgInfo(): O.CsgInfo;
  /** Copies the centres, their normals, or the residuals of the solver. */
  view(attribute: C.ModelAttributeName | number): Float64Array;
  /** Evaluates f, its gradient and its Hessian (xx xy xz yy yz zz). */
  evaluate(points: ArrayInput, wanted?: { gradient?: boolean; hessian?: boolean }, control?: Control): {
    value: Float64Array; gradient?: Float64Array; hessian?: Float64Array };
  /** Projects points onto the surface. */
  project(points: ArrayInput, options?: O.ProjectDesc, control?: Control): {
    position: Float64Array; normal: Float64Array; status: Uint8Array; converged: number };
  /** Computes the principal curvatures and directions of the level set through each point. */
  curvature(points: ArrayInput, control?: Control): {
    k1: Float64Array; k2: Float64Array; d1: Float64Array; d2: Float64Array; confidence: Float64Array };
  /** Finds where rays origin + t direction meet the surface. */
  castRays(origins: ArrayInput, directions: ArrayInput, options?: O.CastDesc, control?: Control): {
    count: Uint32Array; t: Float64Array; position: Float64Array; normal: Float64Array; entering: Uint8Array;
    status: Uint8Array; hitRays: number };
  /** Computes the bound on |grad f| that castRays uses if none is given. */
  lipschitz(control?: Control): number;
  /** Returns 1 for each point inside, else 0. */
  contains(points: ArrayInput, control?: Control): Uint8Array;
  /** Makes the same model with a surface that ends where its samples end. */
  trim(options?: O.TrimDesc, control?: Control): Model;
  /** Measures how near the surface and a mesh are to each other, both ways. */
  compareMesh(mesh: Mesh, options?: O.CompareDesc, control?: Control): O.Comparison;
  /** Places marks on the surface.  `preset` gives the layers if `layers` is missing. */
  generate(options?: O.GenerateDesc & { preset?: C.PresetName | number }, control?: Control): PointSet;
  /** Makes the line set of the model, from which its lines are drawn for every camera. */
  createLineSet(options?: O.LineSetDesc, control?: Control): LineSet;
  save(): Uint8Array;
}

/** A set of marks on a surface, in layers. */
export class PointSet extends Handle {
  readonly context: Context;
  info(): O.PointSetInfo;
  layerInfo(layer: number): O.LayerInfo;
  /** What became of the seeds. */
  seedPlacement(): O.PlacementInfo;
  /** What became of the candidates of one level of one layer. */
  placement(layer: number, level: number): O.PlacementInfo;
  /** Copies one attribute of one layer. */
  view(layer: number, attribute: C.MarkAttributeName | number): TypedArray;
  /** Makes a set that has the same marks, and values of fields for them.  null removes the values of a name.
   *  `transform` leads from the marks to the fields (16 numbers, column-major). */
  withFields(fields: Readonly<Record<string, Field | null>>, options?: { transform?: Numbers }, control?: Control): PointSet;
  /** The kinds of the fields, by name. */
  fields(): Record<string, C.FieldKindName>;
  /** Copies the values and weights of a field at the marks of a layer.  No weights: all are 1. */
  field(layer: number, name: string): { values: Float32Array; weights: Float32Array };
  save(): Uint8Array;
}

/** An image: RGBA, row by row from the top, as ImageData or { width, height, data }. */
export interface FieldImage {
  width: number;
  height: number;
  /** Bytes from 0 to 255, or numbers from 0 to 1. */
  data: Uint8Array | Uint8ClampedArray | Float32Array;
}
export interface FieldOptions extends Omit<O.FieldDesc, "image" | "source" | "values"> {
  image?: FieldImage;
  values?: Elements;
}

/** Values on a surface: a number, a colour or a direction at each place, and a weight. */
export class Field extends Handle {
  readonly context: Context;
  readonly fieldKind: C.FieldKindName;
  /** Returns the values at places, and their weights.  Fields of points do not need normals. */
  evaluate(positions: Elements, normals?: Elements, control?: Control): { values: Float64Array; weights: Float64Array };
}

/** Holds what the lines of one model are drawn from, for every camera. */
export class LineSet extends Handle {
  readonly context: Context;
  info(): O.LineSetInfo;
}

/** Holds the surfaces that cast shadows and hide the sky. */
export class Occluders extends Handle {
  readonly context: Context;
  /** Computes the shading of an item, as Context.createShading. */
  createShading(item: O.Item, options?: O.ShadingDesc & { camera?: O.Camera }, control?: Control): Shading;
}

/** Holds how much of the sky and of each light with a shadow the marks of an item see.  It holds for the item's point
 *  set, transform and lights, and for the occluders, and for any camera.  Only lights in camera space move with it. */
export class Shading extends Handle {
  readonly context: Context;
  /** Copies what the marks of a layer see of a light of the style, or, if `light` is -1, of the sky: 1 = all. */
  view(layer?: number, light?: number): Float32Array;
}

/** Triangles that have been repaired. */
export class Mesh extends Handle {
  readonly context: Context;
  info(): O.MeshInfo;
  view(attribute: C.MeshAttributeName | number): TypedArray;
  /** Samples the mesh evenly; points and unit normals are count x 3 each. */
  sample(count: number, options?: O.SampleDesc, control?: Control): { points: Float64Array; normals: Float64Array };
  /** Finds sharp edges (3 numbers for each face: 1 = the edge from that corner to the next is sharp) and the number of
   *  each face's patch. */
  edges(options?: O.MeshEdgesDesc, control?: Control): { patches: Int32Array; sharp: Int32Array };
}

/** The size of a picture, in pixels. */
export interface PictureSize {
  width: number;
  height: number;
}

export interface FitView extends PictureSize {
  /** Direction from the eye into the scene; default (0, 0, -1). */
  direction?: Numbers;
  /** Direction roughly upward in the picture; default (0, 1, 0). */
  up?: Numbers;
  /** Vertical angle of view, in radians; 0 = orthographic; default 0.6. */
  verticalAngle?: number;
  /** Share of the picture that stays free on each side; 0 to 0.45; default 0.05. */
  margin?: number;
}

/** A camera: plain data, with methods that set it. */
export class Camera implements O.Camera {
  private constructor();
  depthConvention: C.DepthName | number;
  /** World to eye: 16 numbers, column-major. */
  view: number[];
  /** Eye to clip: 16 numbers, column-major. */
  projection: number[];
  /** x and y of the top-left corner, width and height, in pixels. */
  viewport: number[];
  /** Looks from an eye towards a target. */
  lookAt(eye: Numbers, target: Numbers, up?: Numbers): this;
  /** Sets a perspective projection; the vertical angle of view is in radians. */
  perspective(verticalAngle: number, width: number, height: number, near: number, far: number): this;
  /** Sets an orthographic projection; viewHeight is the height of the visible region, in world units. */
  orthographic(viewHeight: number, width: number, height: number, near: number, far: number): this;
  /** Shows a box as large as the viewport and the margin allow. */
  fitBounds(min: Numbers, max: Numbers, view: FitView): this;
  /** Shows points (n x 3) as large as the viewport and the margin allow; `origin` is added to each. */
  fitPoints(points: ArrayInput, view: FitView & { origin?: Numbers }): this;
}

export type PictureInput = O.PictureSource;
export interface PictureOptions extends Omit<O.PictureDesc, "sources" | "style"> {
  /** The name of a preset, such as "engraving", or a style to use as it is. */
  style?: C.PresetName | O.Style;
  /** Fields to change after everything was chosen: { "style.tone_exponent": 1.5, "fit.kernel": "gaussian" }. */
  set?: Record<string, string | number>;
  /** Allows a drawing in which hardly anything can be seen; default false. */
  allowBlank?: boolean;
}
/** A note: something that was chosen, repaired, left out or measured, or that may be wrong. */
export interface PictureNote {
  code: C.NoteName | number;
  severity: C.SeverityName | number;
  figures: number[];
  text: string;
  /** What to do about it; undefined if the text says it or nothing needs doing. */
  advice?: string;
  /** One or two more sentences that explain the text; undefined if none. */
  detail?: string;
}

/** One surface of a picture. */
export interface PicturePart {
  sides: C.SidesName | number;
  /** Undefined for a point set. */
  model?: Model;
  pointSet?: PointSet;
  /** Undefined without lines. */
  lineSet?: LineSet;
  /** The mesh that the surface was fitted to; undefined for other sources. */
  mesh?: Mesh;
}

/** A picture of sources, with the choices that were made for it. */
export class Picture extends Handle {
  readonly context: Context;
  /** The drawing for the planned camera.  With allowBlank it is made when it is first read. */
  readonly drawing: Drawing;
  readonly notes: PictureNote[];
  info(): O.PictureInfo;
  /** Makes a picture of the same surfaces in another style, size or view. */
  restyle(options?: PictureOptions, control?: Control): Picture;
  /** The planned camera. */
  camera(): Camera;
  /** A camera that looks from another side; angles in degrees. */
  look(from?: { azimuth?: number; elevation?: number; direction?: Numbers }): Camera;
  /** The planned camera, turned about the up axis by an angle in degrees. */
  orbit(degrees: number): Camera;
  /** Draws the picture for a camera; the default is the planned one. */
  draw(camera?: O.Camera, control?: Control): Drawing;
  /** Draws an image of the plate: the drawing with the section and the scale bar beside it. */
  rasterize(options?: { drawing?: Drawing; camera?: O.Camera; format?: C.FormatName | number }): {
    width: number; height: number; data: Uint8ClampedArray };
  /** Writes the plate as SVG, PDF, HPGL, G-code or DXF. */
  write(options?: O.PicturePageDesc & { drawing?: Drawing; camera?: O.Camera }, control?: Control): {
    bytes: Uint8Array; info: O.PageInfo };
  /** Writes the plate as SVG text. */
  toSVG(options?: O.PicturePageDesc & { drawing?: Drawing; camera?: O.Camera }): string;
  /** Writes a technical drawing: views and sections on a sheet, to scale. */
  writeViews(options?: O.ViewsDesc, control?: Control): { bytes: Uint8Array; info: O.ViewsInfo };
  /** The text of a settings file that makes the same picture. */
  settings(): string;
  /** The model of a part, by default of part 0; undefined for a point set. */
  model(number?: number): Model | undefined;
  /** The surfaces, the largest first, for Renderer.draw. */
  parts(): PicturePart[];
  /** The planned style, with lengths in pixels.  It does not include what dabs paint. */
  style(): O.Style;
}

/** Settings that were read from a file. */
export class Settings extends Handle {
  readonly context: Context;
}

/** Makes drawings of items for a camera. */
export class Renderer extends Handle {
  readonly context: Context;
  draw(items: O.Item | readonly O.Item[], camera: O.Camera, control?: Control): Drawing;
}

export interface RasterOptions {
  /** Width of the image, in pixels; default: the right edge of the camera's viewport. */
  width?: number;
  /** Height of the image, in pixels; default: the bottom edge of the camera's viewport. */
  height?: number;
  /** Format of the pixels, such as "bgra8"; default "rgba8". */
  format?: C.FormatName | number;
  /** The pixels of an image over which the drawing is laid, in the same format. */
  image?: Uint8ClampedArray | Uint8Array | Float32Array;
  /** Blends in linear light instead of in encoded values; default false. */
  linearLight?: boolean;
  /** Depth of the host's scene, width x height; ink behind it is not drawn. */
  hostDepth?: Float32Array;
  /** Whether to return the depth of the nearest surface of each pixel; default false. */
  depth?: boolean;
  /** Whether to return the id of the nearest drawn mark of each pixel; default false. */
  id?: boolean;
  /** Whether to return the class of that mark; default false. */
  markClass?: boolean;
}

/** A picture as a value: dots and strokes. */
export class Drawing extends Handle {
  readonly context: Context;
  readonly width: number;
  readonly height: number;
  info(): O.DrawingInfo;
  layerInfo(number: number): O.DrawingLayerInfo;
  /** Finds the mark that has an id, as rasterize({ id: true }) returns it. */
  identify(id: number): O.MarkIdentity;
  /** Draws an image, with the arrays that the options ask for. */
  rasterize(options?: RasterOptions): { width: number; height: number; data: Uint8ClampedArray | Float32Array;
                                        depth?: Float32Array; id?: Uint32Array; markClass?: Uint8Array };
  /** Vertices for the graphics card: their bytes, and the offset of each attribute in a vertex. */
  vertices(primitive: C.PrimitiveName | number, attributes: readonly C.VertexAttributeName[]): {
    vertices: Uint8Array; stride: number; offsets: Record<string, number>; indices: Uint32Array };
  /** How each of the `count` marks of a layer is drawn. */
  markResults(item: number, layer: number, count: number): {
    shown: Uint8Array; radius: Float32Array; opacity: Float32Array };
  /** Numbers of the marks of a layer that are drawn as one class. */
  markIndices(item: number, layer: number, options?: {
    markClass?: C.ClassName | number; primitive?: C.PrimitiveName | number }): Uint32Array;
  /** Writes the drawing alone, on a page of its size, as SVG text. */
  toSVG(options?: Omit<O.PageDesc, "items" | "format">): string;
}
