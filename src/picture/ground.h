// SPDX-License-Identifier: MIT
// The ground of a picture: a plane on which only what darkens it is drawn, which is cast shadows and hidden sky.
//
//   ground_of         the plane, and lights that cast shadows on it, before there is a camera
//   framed_shadows    the places of the ground that the picture shows, for the camera
//   place_ground      the part of the plane that the object darkens, its style and its marks
//   set_ground_light  the tone law for a camera, by which open ground is white
#pragma once

#include "picture/call.h"
#include "picture/handles.h"
#include "picture/look.h"
#include "picture/plan.h"
#include "picture/style.h"

#include <array>
#include <span>

namespace hrbfnpr::picture {

// The plane dot(up, p) = height.
struct GroundPlane {
    glm::dvec3 up{0.0, 1.0, 0.0}; // a unit vector
    double height = 0.0;
};

struct Ground {
    explicit Ground(Style&& lit) : style(std::move(lit)) {}

    GroundPlane plane;
    Style style; // the lights, and after place_ground() the layer "ground", too
    hrbfnpr_style style_view{};
    float black = 0.0F;                // the light that the picture's style draws as black
    double diagonal = 0.0;             // the diagonal of the object's box
    std::array<glm::dvec3, 4> corners; // the corners of the rectangle that has marks
    glm::dvec3 along{1.0, 0.0, 0.0};   // the direction of hatching
    Model model;
    LineSet lines;  // null, unless the style draws borders of shadows
    PointSet marks; // For a still picture, only the marks that the planned camera needs.
    PointSet whole; // All marks of a still picture, once another camera needed them; else null.
};

// Returns the ground under places of the object. `style` is the style of the picture; only its lights and its ambient
// light are used. Without a light that casts shadows, the first light of the ground's style does.
[[nodiscard]] Ground ground_of(const Options& options, const Style& style, const glm::dvec3& up,
                               std::span<const glm::dvec3> places);

// Returns the places of the ground on which shadows of the object's places fall, as far as the picture shows them.
[[nodiscard]] Points framed_shadows(const Ground& ground, const hrbfnpr_camera& camera,
                                    std::span<const glm::dvec3> places, Pool& pool);

// Returns places around everything on the ground that may be drawn.
[[nodiscard]] Points rim_of_ground(const Ground& ground, const Points& object, Pool& pool);

// The picture for which a ground is placed.
struct GroundPlan {
    const Style& style;                         // the style of the picture, as planned
    std::span<const hrbfnpr_layer_desc> layers; // the picture's layers of marks, or none if they are not planned
    std::span<const glm::dvec3> surface;        // the vertices of the meshes that cast shadows
    const hrbfnpr_camera& camera;
    double pen;
    bool is_still; // only marks that the camera needs are placed
};

// Finds the ground's height and its dark part, and places its marks.
void place_ground(const Call& call, const GroundPlan& plan, Ground& ground);

// Places all marks of the ground of a still picture.
void complete_ground(const Call& call, const GroundPlan& plan, Ground& ground);

// Sets the tone law of the ground's style for a camera: open ground is white.
void set_ground_light(const hrbfnpr_camera& camera, Ground& ground);

// Tells whether the camera is above the ground.
[[nodiscard]] bool sees_ground(const hrbfnpr_camera& camera, const GroundPlane& plane) noexcept;

} // namespace hrbfnpr::picture
