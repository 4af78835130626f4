// SPDX-License-Identifier: MIT
import { Call, joined } from "./call.js";
import { Drawing } from "./drawing.js";
import { PICTURE } from "./generated/constants.js";
import { OFFSETS } from "./generated/layout.js";
import { LineSet } from "./line_set.js";
import { Mesh } from "./mesh.js";
import { Made, Model } from "./model.js";
import { operated } from "./operation.js";
import { PointSet } from "./point_set.js";
import { constant } from "./structs.js";

const NAN = Number.NaN;
const PART = { model: ["hrbfnpr_model", Model], point_set: ["hrbfnpr_point_set", PointSet],
               line_set: ["hrbfnpr_line_set", LineSet], mesh: ["hrbfnpr_mesh", Mesh] };

/** Turns the options of a picture into fields of its descriptor: style, set and allowBlank have other names there. */
function descriptor({ style, set, allowBlank, ...rest }) {
  const given = { ...rest };
  if (typeof style === "string") given.styleName = style;
  else if (style !== undefined) given.style = style;
  if (allowBlank) given.flags = (given.flags ?? 0) | PICTURE.ALLOW_BLANK;
  if (set !== undefined)
    given.changes = [...(given.changes ?? []),
                     ...Object.entries(set).map(([field, value]) => ({ field, value: String(value) }))];
  return given;
}

/** Reads a style as plain data, with the levels of its lines; `read` leaves out arrays. */
function styleAt(call, address) {
  const style = call.read(address, "hrbfnpr_style");
  const { lines, line_stride: stride } = OFFSETS.hrbfnpr_style;
  const first = call.getPointer(address + lines);
  const step = Number(call.library.views.data.getBigInt64(address + stride, true)) || call.sizeOf("hrbfnpr_line_style");
  style.lines?.forEach((line, number) => {
    const levels = first + number * step + OFFSETS.hrbfnpr_line_style.levels;
    if (call.getPointer(levels) !== 0) line.levels = call.copyOfView(levels);
  });
  return style;
}

/** A picture of sources, with the choices that were made for it. */
export class Picture extends Made {
  #drawing;

  constructor(context, pointer) {
    super(context, "hrbfnpr_picture", pointer);
  }

  /** Private: use Context.draw. */
  static made(context, name, first, options, control) {
    return Call.with(context.library, (call) => {
      const desc = call.structOf(descriptor(options), "hrbfnpr_picture_desc", "picture");
      const picture = new Picture(context, operated(call, context.pointer, control,
        (operation) => call.made(name, first, desc, operation)));
      // Only a drawing shows whether anything can be seen.  If a blank picture is no error, the drawing is made later.
      const { flags = 0 } = call.read(desc, "hrbfnpr_picture_desc");
      if ((flags & (PICTURE.ALLOW_BLANK | PICTURE.SURFACE_ONLY)) === 0)
        picture.#drawing = picture.draw(undefined, control);
      return picture;
    });
  }

  /** The drawing for the planned camera. */
  get drawing() {
    this.#drawing ??= this.draw();
    return this.#drawing;
  }

  /** Makes a picture of the same surfaces in another style, size or view. */
  restyle(options = {}, control) {
    return Picture.made(this.context, "hrbfnpr_picture_restyle", this.pointer, options, control);
  }

  info() {
    return this.readInfo("hrbfnpr_picture_get_info", "hrbfnpr_picture_info");
  }

  /** The notes about choices, repairs and omissions: { code, severity, figures, text, advice, detail } each. */
  get notes() {
    return Array.from({ length: this.info().notes }, (_, number) => {
      const { figures, figureCount, ...note } = this.readInfo("hrbfnpr_picture_get_note", "hrbfnpr_note", number);
      return { ...note, figures: figures.slice(0, figureCount) };
    });
  }

  /** Returns the planned camera, for Renderer.draw. */
  camera() {
    return this.#camera("hrbfnpr_picture_get_camera");
  }

  /** Returns a camera that looks from another side: { azimuth, elevation } in degrees, or { direction }. */
  look({ azimuth = NAN, elevation = NAN, direction } = {}) {
    return Call.with(this.library, (call) => {
      const along = direction === undefined ? 0 : call.doubles(direction, 3, "direction");
      return this.#cameraOf(call, "hrbfnpr_picture_look", along, azimuth, elevation);
    });
  }

  /** Returns the planned camera, turned about the up axis by an angle in degrees. */
  orbit(degrees) {
    return this.#camera("hrbfnpr_picture_orbit", degrees);
  }

  #camera(name, ...values) {
    return Call.with(this.library, (call) => this.#cameraOf(call, name, ...values));
  }

  #cameraOf(call, name, ...values) {
    const camera = call.struct("hrbfnpr_camera", {});
    call.check(name, this.pointer, ...values, camera);
    return this.library.createCamera(call.read(camera, "hrbfnpr_camera"));
  }

  /** Draws the picture for a camera; the default is the planned one. */
  draw(camera, control) {
    return Call.with(this.library, (call) => operated(call, this.context.pointer, control, (operation) => {
      const seen = call.structOf(camera && { ...camera }, "hrbfnpr_camera", "camera");
      const pointer = call.made("hrbfnpr_picture_draw", this.pointer, seen, operation);
      return new Drawing(this.context, pointer, (camera ?? this.camera()).viewport);
    }));
  }

  /** Draws an image of the plate: { width, height, data } for an ImageData. */
  rasterize({ drawing = this.drawing, camera, format = "rgba8" } = {}) {
    const number = constant("FORMAT", format, "format");
    return Call.with(this.library, (call) => {
      const seen = call.structOf(camera && { ...camera }, "hrbfnpr_camera", "camera");
      const sides = [call.allocate(4), call.allocate(4)];
      call.check("hrbfnpr_picture_plate_size", this.pointer, seen, ...sides);
      const [width, height] = sides.map((at) => this.library.views.data.getInt32(at, true));
      const data = new Uint8ClampedArray(4 * width * height);
      const pixels = call.allocate(data.length);
      const image = call.structOf({ format: number, width, height, pixels }, "hrbfnpr_image");
      call.check("hrbfnpr_picture_rasterize", this.pointer, drawing.pointer, seen, image);
      data.set(this.library.views.bytes.subarray(pixels, pixels + data.length));
      return { width, height, data };
    });
  }

  /** Writes the plate as SVG, PDF, HPGL, G-code or DXF: { bytes, info }. */
  write({ drawing = this.drawing, camera, ...page } = {}, control) {
    return Call.with(this.library, (call) => {
      const seen = call.structOf(camera && { ...camera }, "hrbfnpr_camera", "camera");
      const desc = call.structOf(page, "hrbfnpr_picture_page_desc", "page");
      const chunks = [];
      const [write, user] = call.callback("hrbfnpr_write_fn", (chunk) => void chunks.push(chunk), "write");
      const info = call.struct("hrbfnpr_page_info", {});
      operated(call, this.context.pointer, control, (operation) => call.check(
        "hrbfnpr_picture_write", this.pointer, drawing.pointer, seen, desc, write, user, info, operation));
      return { bytes: joined(chunks), info: call.read(info, "hrbfnpr_page_info") };
    });
  }

  toSVG(options = {}) {
    return new TextDecoder().decode(this.write(options).bytes);
  }

  /** Writes a technical drawing on a sheet: { bytes, info }. */
  writeViews(options = {}, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_views_desc", "views");
      const chunks = [];
      const [write, user] = call.callback("hrbfnpr_write_fn", (chunk) => void chunks.push(chunk), "write");
      const info = call.struct("hrbfnpr_views_info", {});
      operated(call, this.context.pointer, control, (operation) => call.check(
        "hrbfnpr_picture_write_views", this.pointer, desc, write, user, info, operation));
      return { bytes: joined(chunks), info: call.read(info, "hrbfnpr_views_info") };
    });
  }

  /** Returns what the picture was made with, as the text of a settings file. */
  settings() {
    return new TextDecoder().decode(this.saved("hrbfnpr_picture_write_settings"));
  }

  /** Returns the surfaces, the largest first: { sides, model, pointSet, lineSet, mesh }, without absent objects. */
  parts() {
    return Array.from({ length: this.info().parts }, (_, number) => this.#part(number, Object.keys(PART)));
  }

  /** Returns the planned style, as plain data for Renderer.draw.  It does not include what dabs paint. */
  style() {
    return Call.with(this.library, (call) => {
      const out = call.allocate(4);
      call.check("hrbfnpr_picture_get_style", this.pointer, out);
      return styleAt(call, call.getPointer(out));
    });
  }

  /** Returns the model of a part, by default of part 0; undefined for a point set. */
  model(number = 0) {
    return this.#part(number, ["model"]).model;
  }

  #part(number, wanted) {
    return Call.with(this.library, (call) => {
      const at = call.struct("hrbfnpr_picture_part", {});
      call.check("hrbfnpr_picture_get_part", this.pointer, number, at);
      const part = { sides: call.read(at, "hrbfnpr_picture_part").sides };
      for (const field of wanted) {
        const [kind, type] = PART[field];
        const pointer = call.getPointer(at + call.offsetOf("hrbfnpr_picture_part", field));
        if (pointer === 0) continue;
        this.library.raw[`${kind}_retain`](pointer);
        part[field.replace("_s", "S")] = new type(this.context, pointer);
      }
      return part;
    });
  }
}
