// SPDX-License-Identifier: MIT
// Where a picture is seen from, and how large it is.
//
// The camera looks along a direction, as far away as the box of the source needs; then the picture is cut to where
// points on the surface are.  A camera at an eye of the caller's is not cut.
#pragma once

#include "picture/call.h"

#include <span>

namespace hrbfnpr::picture {

// ---- Marks as points

// A few marks spread evenly over a model, to learn its area and where it is.
struct Probe {
    explicit Probe(Pool& pool) : places(&pool) {}

    PointSet marks;
    Points places; // of the marks
    double area = 0.0;
    glm::dvec3 mean_normal{0.0};
};

[[nodiscard]] Probe probe(const Call& call, const Model& model);

// The area of a surface, from even marks on it.
[[nodiscard]] double area_of(const PointSet& marks);
// Absolute positions of all marks, layer by layer.
[[nodiscard]] Points positions_of(const PointSet& marks, Pool& pool);
[[nodiscard]] Points normals_of(const PointSet& marks, Pool& pool);

// The box of a model's samples, of a set's marks, or of several models.
[[nodiscard]] geometry::Bounds bounds_of(const Model& model);
[[nodiscard]] geometry::Bounds bounds_of(const PointSet& marks);
[[nodiscard]] geometry::Bounds bounds_of(std::span<const Model> models);

// ---- Cameras

// The options of a camera.  Nothing stands for a choice that is made later.
struct View {
    std::optional<hrbfnpr_camera> camera; // it is used as it is, and nothing below matters
    std::optional<double> azimuth;        // degrees, from the front to the right
    std::optional<double> elevation;      // degrees above the horizon
    std::optional<glm::dvec3> direction;  // from the eye into the scene; azimuth and elevation do not matter then
    std::optional<glm::dvec3> eye;        // direction does not matter then
    std::optional<glm::dvec3> target;     // the eye looks at it
    std::optional<double> fov;            // degrees, vertical; 0: orthographic
    double margin = 0.0;                  // share of the picture that is free on each side
    glm::dvec3 up{0.0, 1.0, 0.0};
    std::int32_t width = 0; // pixels, with height; 0: as `size` and the object need it
    std::int32_t height = 0;
    std::int32_t size = 0; // pixels, of the longer side
};

// What the options and their settings say of a camera.
[[nodiscard]] View view_of(const Options& options, const glm::dvec3& up);

// The camera for a view, which sees all of the places.  bounds: the box of the source.  is_find: finds are drawn
// without perspective, as they are measured.
[[nodiscard]] hrbfnpr_camera camera_for(const View& view, const geometry::Bounds& bounds, const Points& places,
                                        bool is_find);

// From the eye into the scene.  Azimuth 0 looks from the front: +z, or -y where z is up.  Angles in degrees.
[[nodiscard]] glm::dvec3 direction_of_view(const glm::dvec3& up, double azimuth, double elevation) noexcept;
// The azimuth from which an eye sees what looks in this direction; degrees, 0 to 360.
[[nodiscard]] double azimuth_of(const glm::dvec3& up, const glm::dvec3& direction) noexcept;
// The azimuth from which an open surface of this mean normal shows its front, if the usual camera sees its back.
[[nodiscard]] std::optional<double> front_azimuth(const glm::dvec3& up, const glm::dvec3& normal) noexcept;

// Lets the view see an open surface from the side that it looks to, where nothing is said of the camera, and notes it.
// shape: nullable.  probes: those of all surfaces, one and more.
void look_at_front(const Call& call, View& view, const Shape* shape, std::span<const Probe> probes);

// A place in the clip space of a camera.
[[nodiscard]] glm::dvec4 clip_place(const hrbfnpr_camera& camera, const glm::dvec3& place) noexcept;

// Pixels that a length across the view has, at a place.
[[nodiscard]] double pixels_per_unit(const hrbfnpr_camera& camera, const glm::dvec3& place) noexcept;

// ---- Orbits

// What an orbit goes around: the middle of the box, or the target of an eye.
[[nodiscard]] glm::dvec3 orbit_centre(const View& view, const geometry::Bounds& bounds) noexcept;
// The camera of an orbit's first frame: its picture has room for all others.  turn: degrees of the whole orbit.
[[nodiscard]] hrbfnpr_camera first_camera(const View& view, const geometry::Bounds& bounds, const Points& places,
                                          double turn, std::int32_t frames, bool is_find);
// The camera after it went some degrees around an axis through a centre.
[[nodiscard]] hrbfnpr_camera turned(const hrbfnpr_camera& camera, const glm::dvec3& axis, const glm::dvec3& centre,
                                    double degrees) noexcept;

} // namespace hrbfnpr::picture
