// SPDX-License-Identifier: MIT
// How much light reaches the marks of a set past the surfaces that cast shadows. It is computed once, and kept while
// lights and items stay.
//
//   casters_of    meshes in the world → a hierarchy of boxes over their triangles
//   find_shading  the marks of an item, casters, lights → the shares of the sky and of each light that marks see
#pragma once

#include "base/list.h"
#include "base/work.h"
#include "curves/surface_mesh.h"
#include "features/line_set.h"
#include "frame/scene/camera.h"
#include "frame/scene/lighting.h"
#include "geometry/bvh.h"
#include "light/light.h"
#include "marks/point_set.h"

#include <array>
#include <span>

namespace hrbfnpr::frame {

// A number for each mark of a layer. Empty: it is the same for all marks.
struct MarkNumbers {
    explicit MarkNumbers(base::Memory& memory) noexcept : of_mark(memory), in_blocks(memory) {}

    base::Array<float> of_mark;
    base::Array<float> in_blocks; // the same numbers in the order of the blocks of the layer's clusters

    [[nodiscard]] bool empty() const noexcept { return of_mark.empty(); }
    [[nodiscard]] std::int64_t bytes() const noexcept { return of_mark.bytes() + in_blocks.bytes(); }
};

struct LayerShading {
    explicit LayerShading(base::Memory& memory) noexcept
        : open(memory), bend(memory), visible(memory), of_cluster(memory), of_piece(memory) {}

    MarkNumbers open;                // the share of the sky; empty: 1
    MarkNumbers bend;                // -1 in hollows, 1 on ridges; empty: 0
    base::List<MarkNumbers> visible; // for each light of the style: the share of the light; empty: it casts no shadow
    base::Array<SeenShares> of_cluster, of_piece; // the least shares of each cluster, and of each piece of a stroke
};

struct Shading {
    explicit Shading(base::Memory& memory) noexcept : layers(memory), lines(memory) {}

    base::List<LayerShading> layers;      // an element for each layer of the set
    base::List<curves::FoundLines> lines; // the borders of shadows on the item, in its coordinates

    // Returns the shares of marks, beginning with a place in the order of the blocks.
    [[nodiscard]] LightShares in_blocks(std::int64_t layer, std::int64_t first_place) const noexcept;
    // Returns the shares of all marks of a layer, of a light or, if `light` is -1, of the sky. Empty: they are all 1.
    [[nodiscard]] std::span<const float> of_layer(std::int64_t layer, std::int64_t light) const noexcept;
    [[nodiscard]] SeenShares of_mark(std::int64_t layer, std::int64_t mark) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;
};

// A surface that casts shadows.
struct Caster {
    const curves::SurfaceMesh* mesh;
    glm::dmat4 to_world;
    const curves::LineSet* lines = nullptr; // the line set of the mesh; null: borders of its shadows are not found
};

struct Casters {
    geometry::Bvh tree; // in world space
    double cell;        // the longest side of a cell of the meshes, in world units
    double diagonal;    // the diagonal of the box around the meshes, in world units
    base::Array<Caster> caster;
    base::Array<std::int64_t> first_face; // for each caster: the number of its first face in the tree
    base::Array<geometry::Bounds> bounds; // for each caster: the box around its mesh in the world
};
// The meshes and the line sets must outlive the result.
[[nodiscard]] Casters casters_of(const base::Work& work, std::span<const Caster> casters);

struct ShadingSettings {
    double reach = 0.0; // Parts farther away than this hide no sky, in world units. 0: the whole sky is seen.
    std::int32_t sky_rays = 64;
    std::int32_t shadow_rays = 32;
    double curvature_scale = 0.0;      // the distance over which curvature is measured, in diagonals of the item's mesh
    const Shading* previous = nullptr; // a shading of the same marks, whose occlusion and curvature are taken
};

struct ShadedItem {
    const marks::PointSet* set;
    glm::dmat4 to_world;
    std::span<const LightStyle> lights;
    glm::dmat4 view;                           // from world space to eye space
    const curves::LineSet* lines = nullptr;    // the line set of the surface; null: no borders of shadows are found
    const curves::SurfaceMesh* mesh = nullptr; // the mesh of the surface, for curvature; null: curvature is not found
};
// Returns a light in world space. A direction has the length 1.
[[nodiscard]] light::Lamp lamp_of(const LightStyle& style, const ShadedItem& item, std::int32_t rays) noexcept;
[[nodiscard]] Shading find_shading(const base::Work& work, const Casters& casters, const ShadedItem& item,
                                   const ShadingSettings& settings);

// Marks of a layer by their indices, and their shading, which may be null.
struct ShadedMarks {
    const Shading* shading;
    std::int64_t layer;
    std::span<const std::uint32_t> marks;
};
// Computes tau of marks. `rows` has their places and normals, nu their n . v.
void light_marks(const ProjectionLoops& loops, const Lighting& lighting, const ShadedMarks& shaded,
                 const MarkRows& rows, const float* nu, float* tau) noexcept;

} // namespace hrbfnpr::frame
