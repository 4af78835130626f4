// SPDX-License-Identifier: MIT
import { Call } from "./call.js";
import { FIELD_KIND } from "./generated/constants.js";
import { Made } from "./model.js";
import { operated } from "./operation.js";
import { sizeOf, write } from "./structs.js";

const KINDS = Object.fromEntries(Object.entries(FIELD_KIND).map(([name, value]) => [value, name.toLowerCase()]));

/** A set of marks on a surface, in layers. */
export class PointSet extends Made {
  constructor(context, pointer) {
    super(context, "hrbfnpr_point_set", pointer);
  }

  info() {
    return this.readInfo("hrbfnpr_point_set_get_info", "hrbfnpr_point_set_info");
  }

  layerInfo(layer) {
    return this.readInfo("hrbfnpr_point_set_get_layer_info", "hrbfnpr_layer_info", layer);
  }

  seedPlacement() {
    return this.readInfo("hrbfnpr_point_set_get_seed_placement", "hrbfnpr_placement_info");
  }

  placement(layer, level) {
    return this.readInfo("hrbfnpr_point_set_get_placement", "hrbfnpr_placement_info", layer, level);
  }

  view(layer, attribute) {
    return this.viewed("hrbfnpr_point_set_view", "MARK_ATTRIBUTE", attribute, layer);
  }

  withFields(fields, { transform } = {}, control) {
    const named = Object.entries(fields);
    const size = sizeOf("hrbfnpr_mark_field");
    return Call.with(this.library, (call) => {
      const matrix = transform === undefined ? 0 : call.doubles(transform, 16, "transform");
      const first = call.allocate(Math.max(size * named.length, 1));
      named.forEach(([name, field], at) => write(call, first + at * size, "hrbfnpr_mark_field",
        { name, field: field ?? undefined, transform: matrix }, `fields.${name}`));
      return new PointSet(this.context, operated(call, this.context.pointer, control, (operation) =>
        call.made("hrbfnpr_point_set_with_fields", this.context.pointer, this.pointer, named.length ? first : 0,
                  named.length, size, operation)));
    });
  }

  fields() {
    return Call.with(this.library, (call) => {
      const name = call.allocate(8);
      return Object.fromEntries(Array.from({ length: this.info().fieldCount }, (_, number) => {
        call.check("hrbfnpr_point_set_get_field", this.pointer, number, name, name + 4);
        return [this.library.text(call.getPointer(name)), KINDS[call.getPointer(name + 4)]];
      }));
    });
  }

  field(layer, name) {
    return Call.with(this.library, (call) => {
      const [values, weights] = [call.struct("hrbfnpr_array", {}), call.struct("hrbfnpr_array", {})];
      call.check("hrbfnpr_point_set_view_field", this.pointer, layer, call.text(name), values, weights);
      return { values: call.copyOfView(values), weights: call.copyOfView(weights) };
    });
  }

  save() {
    return this.saved("hrbfnpr_point_set_save");
  }
}
