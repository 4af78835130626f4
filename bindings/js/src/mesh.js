// SPDX-License-Identifier: MIT
import { Call } from "./call.js";
import { Made } from "./model.js";
import { operated } from "./operation.js";

/** Triangles that have been repaired. */
export class Mesh extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_mesh", pointer);
  }

  info() {
    return this.readInfo("hrbfnpr_mesh_get_info", "hrbfnpr_mesh_info");
  }

  view(attribute) {
    return this.viewed("hrbfnpr_mesh_view", "MESH_ATTRIBUTE", attribute);
  }

  sample(count, options = {}, control) {
    const points = new Float64Array(3 * count);
    const normals = new Float64Array(3 * count);
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_sample_desc", "sample");
      const out = [call.arrayOut(points, 3), call.arrayOut(normals, 3)];
      operated(call, this.context.pointer, control, (operation) =>
        call.check("hrbfnpr_mesh_sample", this.pointer, desc, ...out, operation));
      return { points, normals };
    });
  }

  /** Finds sharp edges and the smooth patches between them: see hrbfnpr_mesh_edges. */
  edges(options = {}, control) {
    const faces = this.info().faces;
    const patches = new Int32Array(Number(faces));
    const sharp = new Int32Array(3 * Number(faces));
    return Call.with(this.library, (call) => {
      const desc = call.structOf(options, "hrbfnpr_mesh_edges_desc", "edges");
      const out = [call.arrayOut(patches, 1), call.arrayOut(sharp, 3)];
      operated(call, this.context.pointer, control, (operation) =>
        call.check("hrbfnpr_mesh_edges", this.pointer, desc, ...out, 0, operation));
      return { patches, sharp };
    });
  }
}
