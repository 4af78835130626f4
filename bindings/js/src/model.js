// SPDX-License-Identifier: MIT
import { Call, joined } from "./call.js";
import { Handle } from "./handle.js";
import { operated } from "./operation.js";
import { constant } from "./structs.js";

/** The base of everything that is made from a context. */
export class Made extends Handle {
  constructor(context, kind, pointer) {
    super(context.library, kind, pointer);
    this.context = context;
  }

  /** Returns the struct that a function fills.  The function takes the handle and further arguments. */
  readInfo(name, struct, ...values) {
    return Call.with(this.library, (call) => {
      const info = call.struct(struct, {});
      call.check(name, this.pointer, ...values, info);
      return call.read(info, struct);
    });
  }

  /** Returns the bytes that a save function of the library writes. */
  saved(name) {
    return Call.with(this.library, (call) => {
      const chunks = [];
      const [write, user] = call.callback("hrbfnpr_write_fn", (chunk) => void chunks.push(chunk), "write");
      call.check(name, this.pointer, write, user);
      return joined(chunks);
    });
  }

  /** Copies one of the arrays that the library keeps. */
  viewed(name, group, attribute, ...values) {
    return Call.with(this.library, (call) => {
      const view = call.struct("hrbfnpr_array", {});
      call.check(name, this.pointer, ...values, constant(group, attribute, "attribute"), view);
      return call.copyOfView(view);
    });
  }
}

const length3 = (points) => (Array.isArray(points) ? points.flat().length : points.length) / 3;

/** An implicit surface f = 0; f is negative inside. */
export class Model extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_model", pointer);
  }

  info() {
    return this.readInfo("hrbfnpr_model_get_info", "hrbfnpr_model_info");
  }

  trimInfo() {
    return this.readInfo("hrbfnpr_model_get_trim_info", "hrbfnpr_trim_info");
  }

  csgInfo() {
    return this.readInfo("hrbfnpr_model_get_csg_info", "hrbfnpr_csg_info");
  }

  view(attribute) {
    return this.viewed("hrbfnpr_model_view", "MODEL_ATTRIBUTE", attribute);
  }

  save() {
    return this.saved("hrbfnpr_model_save");
  }

  /** Calls a function with the model, the points, `values`, and an operation. */
  #batch(points, control, work) {
    return Call.with(this.library, (call) => operated(call, this.context.pointer, control, (operation) =>
      work(call, call.array(points, 3, "points"), operation)));
  }

  evaluate(points, { gradient = false, hessian = false } = {}, control) {
    const count = length3(points);
    const result = { value: new Float64Array(count) };
    if (gradient) result.gradient = new Float64Array(3 * count);
    if (hessian) result.hessian = new Float64Array(6 * count);
    return this.#batch(points, control, (call, given, operation) => {
      const out = [["value", 1], ["gradient", 3], ["hessian", 6]].map(([name, components]) =>
        (result[name] ? call.arrayOut(result[name], components) : 0));
      call.check("hrbfnpr_model_evaluate", this.pointer, given, ...out, operation);
      return result;
    });
  }

  project(points, options = {}, control) {
    const count = length3(points);
    const result = { position: new Float64Array(3 * count), normal: new Float64Array(3 * count),
                     status: new Uint8Array(count) };
    return this.#batch(points, control, (call, given, operation) => {
      const desc = call.structOf(options, "hrbfnpr_project_desc", "project");
      const out = call.structOf({ position: { data: result.position, components: 3 },
                                  normal: { data: result.normal, components: 3 }, status: result.status },
                                "hrbfnpr_projection");
      call.check("hrbfnpr_model_project", this.pointer, given, desc, out, operation);
      return { ...result, converged: call.read(out, "hrbfnpr_projection").converged };
    });
  }

  curvature(points, control) {
    const count = length3(points);
    const sizes = { k1: 1, k2: 1, d1: 3, d2: 3, confidence: 1 };
    const result = Object.fromEntries(Object.entries(sizes).map(([name, components]) =>
      [name, new Float64Array(components * count)]));
    return this.#batch(points, control, (call, given, operation) => {
      const out = call.structOf(Object.fromEntries(Object.entries(sizes).map(([name, components]) =>
        [name, { data: result[name], components }])), "hrbfnpr_curvature");
      call.check("hrbfnpr_model_curvature", this.pointer, given, out, operation);
      return result;
    });
  }

  castRays(origins, directions, options = {}, control) {
    const count = length3(origins);
    const hits = options.maximumHits ?? 1;
    const result = { count: new Uint32Array(count), t: new Float64Array(hits * count),
                     position: new Float64Array(3 * hits * count), normal: new Float64Array(3 * hits * count),
                     entering: new Uint8Array(hits * count), status: new Uint8Array(count) };
    return this.#batch(origins, control, (call, given, operation) => {
      const desc = call.structOf(options, "hrbfnpr_cast_desc", "cast");
      const along = call.array(directions, 3, "directions");
      const out = call.structOf({ count: result.count, t: { data: result.t, components: hits },
                                  position: { data: result.position, components: 3 * hits },
                                  normal: { data: result.normal, components: 3 * hits },
                                  entering: { data: result.entering, components: hits }, status: result.status },
                                "hrbfnpr_ray_hits");
      call.check("hrbfnpr_model_cast_rays", this.pointer, given, along, desc, out, operation);
      return { ...result, hitRays: call.read(out, "hrbfnpr_ray_hits").hitRays };
    });
  }

  lipschitz(control) {
    return Call.with(this.library, (call) => operated(call, this.context.pointer, control, (operation) => {
      const out = call.allocate(8);
      call.check("hrbfnpr_model_lipschitz", this.pointer, out, operation);
      return this.library.views.data.getFloat64(out, true);
    }));
  }

  contains(points, control) {
    const inside = new Uint8Array(length3(points));
    return this.#batch(points, control, (call, given, operation) => {
      call.check("hrbfnpr_model_contains", this.pointer, given, call.arrayOut(inside, 1), 0, operation);
      return inside;
    });
  }

  trim(options = {}, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_trim_desc", "trim");
      return new Model(this.context, operated(call, this.context.pointer, control,
        (operation) => call.made("hrbfnpr_model_trim", this.pointer, desc, operation)));
    });
  }

  compareMesh(mesh, options = {}, control) {
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_compare_desc", "compare");
      const out = call.struct("hrbfnpr_comparison", {});
      operated(call, this.context.pointer, control, (operation) =>
        call.check("hrbfnpr_model_compare_mesh", this.pointer, mesh.pointer, desc, out, operation));
      return call.read(out, "hrbfnpr_comparison");
    });
  }

  generate(options, control) {
    return this.context.generate(this, options, control);
  }

  createLineSet(options, control) {
    return this.context.createLineSet(this, options, control);
  }
}
