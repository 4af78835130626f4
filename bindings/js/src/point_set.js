// SPDX-License-Identifier: MIT
import { Made } from "./model.js";

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

  save() {
    return this.saved("hrbfnpr_point_set_save");
  }
}
