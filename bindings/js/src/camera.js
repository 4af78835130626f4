// SPDX-License-Identifier: MIT
import { Call } from "./call.js";

const NAME = "hrbfnpr_camera";

/** A camera: plain data, { depthConvention, view, projection, viewport }, with methods that set it. */
export class Camera {
  #library;

  constructor(library, options = {}) {
    this.#library = library;
    Call.with(library, (call) => Object.assign(this, call.read(call.structOf(options, NAME, "camera"), NAME)));
  }

  #set(name, work) {
    return Call.with(this.#library, (call) => {
      const camera = call.structOf({ ...this }, NAME, "camera");
      call.check(name, camera, ...work(call));
      return Object.assign(this, call.read(camera, NAME));
    });
  }

  lookAt(eye, target, up = [0, 1, 0]) {
    return this.#set("hrbfnpr_camera_look_at", (call) =>
      [call.doubles(eye, 3, "eye"), call.doubles(target, 3, "target"), call.doubles(up, 3, "up")]);
  }

  perspective(verticalAngle, width, height, near, far) {
    return this.#set("hrbfnpr_camera_perspective", () => [verticalAngle, width, height, near, far]);
  }

  orthographic(viewHeight, width, height, near, far) {
    return this.#set("hrbfnpr_camera_orthographic", () => [viewHeight, width, height, near, far]);
  }

  fitBounds(min, max, { direction = [0, 0, -1], up = [0, 1, 0], verticalAngle = 0.6, width, height, margin = 0.05 }) {
    return this.#set("hrbfnpr_camera_fit_bounds", (call) =>
      [call.doubles(min, 3, "min"), call.doubles(max, 3, "max"), call.doubles(direction, 3, "direction"),
       call.doubles(up, 3, "up"), verticalAngle, width, height, margin]);
  }

  fitPoints(points, { origin, direction = [0, 0, -1], up = [0, 1, 0], verticalAngle = 0.6, width, height,
                      margin = 0.05 }) {
    return this.#set("hrbfnpr_camera_fit_points", (call) =>
      [call.array(points, 3, "points"), origin ? call.doubles(origin, 3, "origin") : 0,
       call.doubles(direction, 3, "direction"), call.doubles(up, 3, "up"), verticalAngle, width, height, margin]);
  }
}
