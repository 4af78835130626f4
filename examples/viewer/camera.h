// SPDX-License-Identifier: MIT
// The camera as the mouse moves it. The library plans the first view.
#pragma once

#include "handles.h"

#include <optional>

namespace viewer {

struct Size {
    int width = 0, height = 0;
};

struct View {
    Vec eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0};
    double vertical_angle = 0.5; // radians; 0 = orthographic
    double view_height = 1;      // height of the view if it is orthographic
    double near_plane = 0.1, far_plane = 10;

    // Until the eye is moved, the library's matrices are used in place of these fields. `given_size` is the size of the
    // picture that the matrices were made for.
    std::optional<std::array<double, 16>> view, projection;
    Size given_size;
};

// Makes a view from a camera of the library. When it is moved, it turns about `target` and the direction `up`.
View view_by(const hrbfnpr_camera& camera, const Vec& target, const Vec& up);

// Returns the camera for a picture of this size.
hrbfnpr_camera camera_of(const View& view, Size size);

// Replaces the matrices by the fields of the view, so that it can be moved.
void take_over(View& view);
void orbit(View& view, double across, double upward); // radians
void pan(View& view, double across, double upward);   // shares of the picture's height
void zoom(View& view, double factor);                 // above 1: nearer
// Sets the near and far planes so that they enclose a ball about `centre`.
void enclose(View& view, const Vec& centre, double radius);

// The length of a pixel at a place, in units of the model.
double units_per_pixel(const hrbfnpr_camera& camera, const Vec& place);
// Returns the pixel x and y and the distance in front of the eye, which is negative behind the eye.
Vec window_of(const hrbfnpr_camera& camera, const Vec& place);
// Returns the ray from the eye through a pixel: its origin and its unit direction.
std::pair<Vec, Vec> ray_of(const hrbfnpr_camera& camera, double x, double y);
// These convert a direction from the camera's space to the world's, and back.
Vec to_world(const hrbfnpr_camera& camera, const Vec& direction);
Vec to_camera(const hrbfnpr_camera& camera, const Vec& direction);

} // namespace viewer
