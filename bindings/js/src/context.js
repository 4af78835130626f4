// SPDX-License-Identifier: MIT
import { Call, joined } from "./call.js";
import { Field } from "./field.js";
import { OFFSETS } from "./generated/layout.js";
import { Handle } from "./handle.js";
import { LineSet } from "./line_set.js";
import { Mesh } from "./mesh.js";
import { Model } from "./model.js";
import { operated } from "./operation.js";
import { Picture } from "./picture.js";
import { PointSet } from "./point_set.js";
import { itemStructs, Renderer } from "./renderer.js";
import { Settings } from "./settings.js";
import { Occluders, Shading } from "./shading.js";
import { sizeOf } from "./structs.js";

/** Returns a source whose triangles, numbers or lists of three, are an Int32Array, which the library accepts. */
const withIndices = (source) =>
  Array.isArray(source.triangles) ? { ...source, triangles: Int32Array.from(source.triangles.flat()) } : source;

/** Holds the threads, the memory and the log.  Everything else is made from a context. */
export class Context extends Handle {
  /** Private: use Library.createContext. */
  constructor(library, options) {
    const pointer = Call.with(library, (call) => {
      const made = call.made("hrbfnpr_context_create", call.structOf(options, "hrbfnpr_context_desc", "context"));
      call.keepCallbacks(); // the log function may run as long as an object of this context exists
      return made;
    });
    super(library, "hrbfnpr_context", pointer);
  }

  info() {
    return Call.with(this.library, (call) => {
      const info = call.struct("hrbfnpr_context_info", {});
      call.check("hrbfnpr_context_get_info", this.pointer, info);
      return call.read(info, "hrbfnpr_context_info");
    });
  }

  #made(type, name, options, struct, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, struct, struct.replace(/hrbfnpr_|_desc/g, ""));
      return new type(this, operated(call, this.pointer, control,
        (operation) => call.made(name, this.pointer, desc, ...(control === null ? [] : [operation]))));
    });
  }

  draw(source, options = {}, control) {
    const sources = (Array.isArray(source) ? source : [source]).map(withIndices);
    return Picture.made(this, "hrbfnpr_picture_create", this.pointer, { ...options, sources }, control);
  }

  loadSettings(text) {
    return Call.with(this.library, (call) => {
      let left = typeof text === "string" ? new TextEncoder().encode(text) : text;
      const [read, user] = call.callback("hrbfnpr_read_fn", (size) => {
        const chunk = left.subarray(0, size);
        left = left.subarray(chunk.length);
        return chunk;
      }, "read");
      return new Settings(this, call.made("hrbfnpr_settings_load", this.pointer, read, user));
    });
  }

  fit(options, control) {
    return this.#made(Model, "hrbfnpr_model_fit", options, "hrbfnpr_fit_desc", control);
  }

  createMesh(options, control) {
    return this.#made(Mesh, "hrbfnpr_mesh_create", options, "hrbfnpr_mesh_desc", control);
  }

  createCsg(nodes, options = {}) {
    return this.#made(Model, "hrbfnpr_model_create_csg", { ...options, nodes }, "hrbfnpr_csg_desc", null);
  }

  createPointSet(options) {
    return this.#made(PointSet, "hrbfnpr_point_set_create", options, "hrbfnpr_point_set_desc", null);
  }

  createCustom(options) {
    if (options.flags & 4)
      throw new TypeError("custom.flags must not have CUSTOM.THREAD_SAFE, because JavaScript runs on one thread");
    const { release, ...rest } = options;
    return Call.with(this.library, (call) => {
      const desc = call.structOf(rest, "hrbfnpr_custom_desc", "custom");
      const { user, release: at } = OFFSETS.hrbfnpr_custom_desc;
      call.setPointer(desc + at, this.library.callbacks.releaseOf(call.getPointer(desc + user), release));
      const model = new Model(this, call.made("hrbfnpr_model_create_custom", this.pointer, desc));
      call.keepCallbacks(); // the library releases it with the model
      return model;
    });
  }

  #loaded(type, name, bytes) {
    return Call.with(this.library, (call) =>
      new type(this, call.made(name, this.pointer, call.bytes(bytes), bytes.byteLength)));
  }

  loadModel(bytes) {
    return this.#loaded(Model, "hrbfnpr_model_load_memory", bytes);
  }

  loadPointSet(bytes) {
    return this.#loaded(PointSet, "hrbfnpr_point_set_load_memory", bytes);
  }

  createRenderer() {
    return Call.with(this.library, (call) => new Renderer(this, call.made("hrbfnpr_renderer_create", this.pointer)));
  }

  orient(options, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_orient_desc", "orient");
      const { data } = this.library.views; // the struct that was just written
      const normals = new Float64Array(3 * Number(data.getBigInt64(desc + 16, true)));
      const out = call.arrayOut(normals, 3);
      const info = call.struct("hrbfnpr_orient_info", {});
      operated(call, this.pointer, control,
        (operation) => call.check("hrbfnpr_orient", this.pointer, desc, operation, out, info));
      return { normals, info: call.read(info, "hrbfnpr_orient_info") };
    });
  }

  smoothDepthImage(options, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_depth_image_desc", "depthImage");
      const { data } = this.library.views; // the struct that was just written
      const count = Number(data.getBigInt64(desc + 24, true));
      const points = new Float64Array(3 * count);
      const normals = new Float64Array(3 * count);
      const out = [call.arrayOut(points, 3), call.arrayOut(normals, 3)];
      const info = call.struct("hrbfnpr_depth_image_info", {});
      operated(call, this.pointer, control,
        (operation) => call.check("hrbfnpr_smooth_depth_image", this.pointer, desc, operation, ...out, info));
      return { points, normals, info: call.read(info, "hrbfnpr_depth_image_info") };
    });
  }

  farthestPoints(points, count, control) {
    return Call.with(this.library, (call) => {
      const indices = new Uint32Array(count);
      const distances = new Float64Array(count);
      const out = [call.arrayOut(indices, 1), call.arrayOut(distances, 1)];
      const given = call.array(points, 3, "points");
      operated(call, this.pointer, control,
        (operation) => call.check("hrbfnpr_farthest_points", this.pointer, given, ...out, operation));
      return { indices, distances };
    });
  }

  writePage(options, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_page_desc", "page");
      const chunks = [];
      const [write, user] = call.callback("hrbfnpr_write_fn", (chunk) => void chunks.push(chunk), "write");
      const info = call.struct("hrbfnpr_page_info", {});
      operated(call, this.pointer, control, (operation) =>
        call.check("hrbfnpr_page_write", this.pointer, desc, write, user, info, operation));
      return { bytes: joined(chunks), info: call.read(info, "hrbfnpr_page_info") };
    });
  }

  stepPatches(model, count, options = {}, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_generate_desc", "generate");
      const corners = new Float64Array(12 * count);
      const out = call.arrayOut(corners, 12);
      const step = call.allocate(8);
      operated(call, this.pointer, control, (operation) =>
        call.check("hrbfnpr_point_set_step_patches", this.pointer, model.pointer, desc, out, step, operation));
      return { corners, step: this.library.views.data.getFloat64(step, true) };
    });
  }

  generate(model, options = {}, control) {
    const { preset, ...rest } = options;
    const layers = preset === undefined ? {} : { layers: this.library.presetLayers(preset) };
    return Call.with(this.library, (call) => {
      const desc = call.structOf({ ...layers, ...rest }, "hrbfnpr_generate_desc", "generate");
      return new PointSet(this, operated(call, this.pointer, control, (operation) =>
        call.made("hrbfnpr_point_set_generate", this.pointer, model.pointer, desc, operation)));
    });
  }

  createLineSet(model, options = {}, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_line_set_desc", "line set");
      return new LineSet(this, operated(call, this.pointer, control, (operation) =>
        call.made("hrbfnpr_line_set_create", this.pointer, model.pointer, desc, operation)));
    });
  }

  createOccluders(items, control) {
    // Shadings are left out: the caller may have freed them to make new ones.
    const list = (Array.isArray(items) ? items : [items]).map((item) => ({ ...item, shading: undefined }));
    return Call.with(this.library, (call) => {
      const first = itemStructs(call, list);
      return new Occluders(this, operated(call, this.pointer, control, (operation) =>
        call.made("hrbfnpr_occluders_create", this.pointer, first, list.length, sizeOf("hrbfnpr_item"), operation)));
    });
  }

  createField(options, control) {
    return Field.made(this, options, control);
  }

  createShading(occluders, item, { camera, ...options } = {}, control) {
    return Call.with(this.library, (call) => {
      const given = call.structOf({ ...item, shading: undefined }, "hrbfnpr_item", "item");
      const seen = camera ? call.structOf({ ...camera }, "hrbfnpr_camera", "camera") : 0;
      const desc = call.structOf(options, "hrbfnpr_shading_desc", "shading");
      return new Shading(this, operated(call, this.pointer, control, (operation) =>
        call.made("hrbfnpr_shading_create", this.pointer, occluders.pointer, given, seen, desc, operation)));
    });
  }

  fitMesh(mesh, options = {}, control) {
    const { fit, ...rest } = options;
    return Call.with(this.library, (call) => {
      const desc = call.structOf(rest, "hrbfnpr_mesh_fit_desc", "mesh fit");
      const inner = call.structOf(fit, "hrbfnpr_fit_desc", "mesh fit.fit");
      const info = call.struct("hrbfnpr_mesh_fit_info", {});
      const model = new Model(this, operated(call, this.pointer, control, (operation) =>
        call.made("hrbfnpr_model_fit_mesh", mesh.pointer, desc, inner, info, operation)));
      model.meshFit = call.read(info, "hrbfnpr_mesh_fit_info");
      return model;
    });
  }
}
