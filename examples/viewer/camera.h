// SPDX-License-Identifier: MIT
// Where the eye is once a mouse has moved it.  The library plans the first view.
#pragma once

#include "handles.h"

#include <optional>

namespace viewer {

struct Size {
    int width = 0, height = 0;
};

struct View {
    Vec eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0};
    double vertical_angle = 0.5; // radians; 0 = orthographic ...
    double view_height = 1;      // ... of this height
    double near_plane = 0.1, far_plane = 10;

    // Matrices of the library stand in place of these until the eye is moved.  `given_size` is that of their picture.
    std::optional<std::array<double, 16>> view, projection;
    Size given_size;
};

// A view by a camera of the library, which turns about `target` and the direction `up` when it is moved.
View view_by(const hrbfnpr_camera& camera, const Vec& target, const Vec& up);

// For a picture of this size.
hrbfnpr_camera camera_of(const View& view, Size size);

// Writes what matrices say into the view's own words, so that it can be moved.
void take_over(View& view);
void orbit(View& view, double across, double upward); // radians
void pan(View& view, double across, double upward);   // shares of the picture's height
void zoom(View& view, double factor);                 // above 1 nearer
// The planes before and behind a ball about `centre`.
void enclose(View& view, const Vec& centre, double radius);

// The length of a pixel at a place, in units of the model.
double units_per_pixel(const hrbfnpr_camera& camera, const Vec& place);
// Pixel x and y, and the distance before the eye, which is negative behind it.
Vec window_of(const hrbfnpr_camera& camera, const Vec& place);
// From the eye through a pixel: the ray's origin and unit direction.
std::pair<Vec, Vec> ray_of(const hrbfnpr_camera& camera, double x, double y);
// A direction of the camera's space in the world's, and back.
Vec to_world(const hrbfnpr_camera& camera, const Vec& direction);
Vec to_camera(const hrbfnpr_camera& camera, const Vec& direction);

} // namespace viewer
