// SPDX-License-Identifier: MIT
// Chooses the camera and the size of a picture.
//
// The camera looks along a direction, from a distance at which it sees the whole box of the source. Then the picture is
// cropped to the points of the surface. If the caller gives the eye, the picture is not cropped.
#pragma once

#include "picture/call.h"

#include <span>

namespace hrbfnpr::picture {

// ---- Positions and normals of marks

// A few marks spread evenly over a model. They show its area and its position.
struct Probe {
    explicit Probe(Pool& pool) : places(&pool) {}

    PointSet marks;
    Points places; // The positions of the marks.
    double area = 0.0;
    glm::dvec3 mean_normal{0.0};
};

[[nodiscard]] Probe probe(const Call& call, const Model& model);

// Estimates the area of a surface from evenly spread marks.
[[nodiscard]] double area_of(const PointSet& marks);
// These functions return the absolute positions or the normals of all marks, layer by layer.
[[nodiscard]] Points positions_of(const PointSet& marks, Pool& pool);
[[nodiscard]] Points normals_of(const PointSet& marks, Pool& pool);

// These functions return the bounding box of a model's samples, of the marks of a set, or of several models.
[[nodiscard]] geometry::Bounds bounds_of(const Model& model);
[[nodiscard]] geometry::Bounds bounds_of(const PointSet& marks);
[[nodiscard]] geometry::Bounds bounds_of(std::span<const Model> models);

// ---- Cameras

// The options of a camera. Options without a value are chosen later.
struct View {
    std::optional<hrbfnpr_camera> camera; // If set, this camera is used unchanged, and the other members are ignored.
    std::optional<double> azimuth;        // in degrees; 0: the eye is in front; 90: it is on the right
    std::optional<double> elevation;      // in degrees above the horizon
    // The direction from the eye into the scene. It replaces azimuth and elevation.
    std::optional<glm::dvec3> direction;
    std::optional<glm::dvec3> eye;    // The position of the eye. It replaces `direction`.
    std::optional<glm::dvec3> target; // The place that the eye looks at.
    std::optional<double> fov;        // the vertical angle of view in degrees; 0: orthographic
    double margin = 0.0;              // the share of the picture's width or height that is empty on each side
    glm::dvec3 up{0.0, 1.0, 0.0};
    // The width in pixels. If it is 0, width and height follow from `size` and the extent of the object.
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::int32_t size = 0; // The longer side of the picture, in pixels.
};

// Reads the options of the camera from the options of the picture, which include the settings.
[[nodiscard]] View view_of(const Options& options, const glm::dvec3& up);

// Returns a camera that sees all of the places. `bounds` is the box of the source. Archaeological finds (`is_find`) are
// drawn without perspective, so that they can be measured.
[[nodiscard]] hrbfnpr_camera camera_for(const View& view, const geometry::Bounds& bounds, const Points& places,
                                        bool is_find);

// Returns the camera with its near and far planes moved, where needed, so that the places lie between them.
[[nodiscard]] hrbfnpr_camera with_depth_of(const hrbfnpr_camera& camera, const Points& places) noexcept;

// Returns the direction from the eye into the scene. At azimuth 0, the eye is in front of the scene: on the +z side, or
// on the -y side if z is up. The angles are in degrees.
[[nodiscard]] glm::dvec3 direction_of_view(const glm::dvec3& up, double azimuth, double elevation) noexcept;
// Returns the azimuth, in degrees from 0 to 360, from which the camera sees a surface that faces this direction.
[[nodiscard]] double azimuth_of(const glm::dvec3& up, const glm::dvec3& direction) noexcept;
// Returns the azimuth that shows the front of an open surface with this mean normal, or nullopt if the default camera
// already sees the front.
[[nodiscard]] std::optional<double> front_azimuth(const glm::dvec3& up, const glm::dvec3& normal) noexcept;

// If the options do not choose a camera, turns the view to the front of an open surface and reports it in a note.
// `shape` may be null. `probes` has the probes of all surfaces, at least one.
void look_at_front(const Call& call, View& view, const Shape* shape, std::span<const Probe> probes);

// Returns the position of a point in the clip space of a camera.
[[nodiscard]] glm::dvec4 clip_place(const hrbfnpr_camera& camera, const glm::dvec3& place) noexcept;

// Returns the length in pixels of one world unit at a given place, measured perpendicular to the camera's axis.
[[nodiscard]] double pixels_per_unit(const hrbfnpr_camera& camera, const glm::dvec3& place) noexcept;

// ---- Orbits

// Returns the centre of an orbit: the target if both eye and target are given, else the middle of the box.
[[nodiscard]] glm::dvec3 orbit_centre(const View& view, const geometry::Bounds& bounds) noexcept;
// Returns the camera of the first frame of an orbit. Its picture is cropped so that the places stay inside it in all
// frames. `turn` is the angle of the whole orbit in degrees.
[[nodiscard]] hrbfnpr_camera first_camera(const View& view, const geometry::Bounds& bounds, const Points& places,
                                          double turn, std::int32_t frames, bool is_find);
// Returns the camera turned by an angle in degrees about an axis through a centre.
[[nodiscard]] hrbfnpr_camera turned(const hrbfnpr_camera& camera, const glm::dvec3& axis, const glm::dvec3& centre,
                                    double degrees) noexcept;

} // namespace hrbfnpr::picture
