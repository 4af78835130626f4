// SPDX-License-Identifier: MIT
import { Call } from "./call.js";
import { FORMAT, PRIMITIVE, SCALAR, VERTEX_ATTRIBUTE } from "./generated/constants.js";
import { Made } from "./model.js";
import { constant } from "./structs.js";

const CHANNELS = { [FORMAT.RGBA32F]: Float32Array, [FORMAT.RGBA32F_PREMULTIPLIED]: Float32Array };
// The scalar type and the number of scalars of each vertex attribute.
const VERTICES = { POSITION: [1, 3], WINDOW: [1, 3], RADIUS: [1, 1], COLOR: [1, 4], NORMAL: [1, 3], DIRECTION: [1, 3],
                   ID: [4, 1], CLASS: [4, 1], IS_PAPER: [4, 1], LAYER: [4, 1], LENGTH: [1, 1], HIDDEN_LAYERS: [4, 1],
                   HIDDEN_BY: [4, 1], LINE: [4, 1] };

/** A picture as a value: dots and strokes. */
export class Drawing extends Made {
  constructor(context, pointer, viewport) {
    super(context, "hrbfnpr_drawing", pointer);
    this.width = Math.ceil(viewport[0] + viewport[2]);
    this.height = Math.ceil(viewport[1] + viewport[3]);
  }

  info() {
    return this.readInfo("hrbfnpr_drawing_get_info", "hrbfnpr_drawing_info");
  }

  layerInfo(number) {
    return this.readInfo("hrbfnpr_drawing_get_layer_info", "hrbfnpr_drawing_layer_info", number);
  }

  identify(id) {
    return this.readInfo("hrbfnpr_drawing_identify", "hrbfnpr_mark_identity", id);
  }

  /** Draws an image: { width, height, data } for an ImageData, with depth, id and markClass if they are wanted. */
  rasterize({ width = this.width, height = this.height, format = "rgba8", image, linearLight = false, hostDepth,
              depth = false, id = false, markClass = false } = {}) {
    const number = constant("FORMAT", format, "format");
    const type = CHANNELS[number] ?? Uint8ClampedArray;
    const size = width * height * (number === FORMAT.COVERAGE8 ? 1 : 4);
    if (image && image.length !== size)
      throw new TypeError(`image has ${image.length} numbers; it must have ${size} for ${width} x ${height} pixels`);
    const result = { width, height, data: new type(size) };
    const planes = {};
    if (depth) planes.depth = result.depth = new Float32Array(width * height);
    if (id) planes.id = result.id = new Uint32Array(width * height);
    if (markClass) planes.markClass = result.markClass = new Uint8Array(width * height);
    return Call.with(this.library, (call) => {
      const pixels = call.bytes(image ?? result.data);
      const target = call.structOf({ format: number, width, height, pixels }, "hrbfnpr_image");
      const desc = call.structOf({ flags: (image ? 1 : 0) | (linearLight ? 2 : 0), hostDepth, ...planes },
                                 "hrbfnpr_raster_desc");
      call.check("hrbfnpr_drawing_rasterize", this.pointer, target, desc);
      const bytes = new Uint8Array(result.data.buffer);
      bytes.set(this.library.views.bytes.subarray(pixels, pixels + bytes.length));
      return result;
    });
  }

  /** Returns the vertices of a primitive: { vertices: Uint8Array, stride, offsets, indices }. */
  vertices(primitive, attributes) {
    const number = constant("PRIMITIVE", primitive, "primitive");
    const offsets = {};
    let stride = 0;
    const list = attributes.map((name) => {
      const attribute = constant("VERTEX_ATTRIBUTE", name, "attributes");
      const [key] = Object.entries(VERTEX_ATTRIBUTE).find(([, value]) => value === attribute);
      const [scalar, count] = VERTICES[key];
      offsets[name] = stride;
      stride += 4 * count;
      return { attribute, scalar: scalar === 1 ? SCALAR.FLOAT32 : SCALAR.UINT32, offset: offsets[name] };
    });
    return Call.with(this.library, (call) => {
      const counts = [call.allocate(8), call.allocate(8)];
      call.check("hrbfnpr_drawing_vertex_bound", this.pointer, number, ...counts);
      const [vertexCount, indexCount] = counts.map((at) => Number(this.library.views.data.getBigInt64(at, true)));
      const layout = call.structOf({ primitive: number, attributes: list, stride }, "hrbfnpr_vertex_layout");
      const vertices = call.allocate(Math.max(stride * vertexCount, 1));
      const indices = call.allocate(Math.max(4 * indexCount, 1));
      call.check("hrbfnpr_drawing_write_vertices", this.pointer, layout, vertices, vertexCount, counts[0], indices,
                 indexCount, counts[1]);
      const { bytes } = this.library.views;
      return { vertices: bytes.slice(vertices, vertices + stride * vertexCount), stride, offsets,
               indices: new Uint32Array(bytes.slice(indices, indices + 4 * indexCount).buffer) };
    });
  }

  /** Returns how each mark of a layer of an item's point set is drawn. */
  markResults(item, layer, count) {
    const result = { shown: new Uint8Array(count), radius: new Float32Array(count),
                     opacity: new Float32Array(count) };
    return Call.with(this.library, (call) => {
      const out = call.structOf(result, "hrbfnpr_mark_results");
      call.check("hrbfnpr_drawing_mark_results", this.pointer, item, layer, out);
      return result;
    });
  }

  /** Returns the numbers of the marks of a layer that are drawn. */
  markIndices(item, layer, { markClass = "front", primitive = PRIMITIVE.POINTS } = {}) {
    const chosen = [constant("CLASS", markClass, "markClass"), constant("PRIMITIVE", primitive, "primitive")];
    return Call.with(this.library, (call) => {
      const count = call.allocate(8);
      const counted = () => Number(this.library.views.data.getBigInt64(count, true));
      this.library.raw.hrbfnpr_drawing_write_mark_indices(this.pointer, item, layer, ...chosen, 0, 0, count,
                                                          call.error);
      const size = counted();
      const indices = call.allocate(Math.max(4 * size, 1));
      call.check("hrbfnpr_drawing_write_mark_indices", this.pointer, item, layer, ...chosen, indices, size, count);
      return new Uint32Array(this.library.views.bytes.slice(indices, indices + 4 * size).buffer);
    });
  }

  /** Returns the drawing alone, on a page of its size, as SVG text. */
  toSVG(options = {}) {
    const { bytes } = this.context.writePage({ ...options, format: "svg", items: [{ drawing: this }] });
    return new TextDecoder().decode(bytes);
  }
}
