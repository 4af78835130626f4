// SPDX-License-Identifier: MIT
// The mesh, creases and lines of a model that do not depend on the camera. They are computed once.
#pragma once

#include "base/list.h"
#include "creases/creases.h"
#include "curves/curves.h"
#include "curves/given_mesh.h"
#include "curves/mesh_edges.h"
#include "curves/sheet_count.h"
#include "curves/surface_mesh.h"
#include "features/feature_lines.h"
#include "surface/support_domain.h"

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace hrbfnpr::curves {

// The values equal the HRBFNPR_LINE_KIND constants.
enum class LineKind : std::uint32_t {
    contour = 1,
    suggestive_contour = 2,
    ridge = 3,
    valley = 4,
    apparent_ridge = 5,
    parabolic = 6,
    isophote = 7,
    section = 8,
    border = 9,
    own = 10,
    crease = 11,
    shadow = 12,
    terminator = 13,
    soft_edge = 14,
    intersection = 15,
    tangent_edge = 16
};
inline constexpr std::uint32_t line_kind_count = 17;
// Returns whether lines of this kind are found again for each camera or light.
[[nodiscard]] constexpr bool depends_on_view(LineKind kind) noexcept {
    return kind == LineKind::contour || kind == LineKind::suggestive_contour || kind == LineKind::apparent_ridge ||
           kind == LineKind::isophote;
}
// Returns the FeatureKind of a line kind.
[[nodiscard]] FeatureKind feature_of(LineKind kind) noexcept;
// Returns whether the caller gives lines of this kind as polylines.
[[nodiscard]] constexpr bool is_given(LineKind kind) noexcept {
    return kind == LineKind::own || kind == LineKind::tangent_edge;
}
struct Thresholds {
    double lower, upper;
};
// Returns the default limits for strengths, in the units of feature_value().
[[nodiscard]] Thresholds default_thresholds(LineKind kind) noexcept;
// Returns `given`, or the defaults if both values of `given` are 0.
[[nodiscard]] inline Thresholds thresholds_of(LineKind kind, const Thresholds& given) noexcept {
    return given.lower > 0.0 || given.upper > 0.0 ? given : default_thresholds(kind);
}

// A request for lines that are found once.
struct LineRequest {
    LineKind kind = LineKind::ridge;
    std::array<char, 64> name{};
    Thresholds thresholds{0.0, 0.0};     // if both values are 0, default_thresholds() is used
    double shortest = 0.0;               // in diagonals
    glm::dvec3 plane{0.0, 0.0, 1.0};     // sections: the normal of the planes
    std::span<const double> levels;      // sections: positions of the planes along their normal
    std::span<const double> points;      // lines of the caller: 3n packed positions
    std::span<const std::int64_t> first; // lines of the caller: the first point of each, and the total number of points
};

struct FoundLines {
    explicit FoundLines(base::Memory& memory) : lines(memory) {}
    LineKind kind = LineKind::ridge;
    std::array<char, 64> name{};
    SurfaceLines lines;
    bool concave = false; // whether these are the folds among the soft edges

    // Returns whether a style for this side draws the lines. Only soft edges have sides.
    [[nodiscard]] bool is_on(CreaseSide side) const noexcept {
        return kind != LineKind::soft_edge || side == CreaseSide::both || (side == CreaseSide::concave) == concave;
    }
};

// Where the surface ends because it has no samples.
struct SupportSettings {
    // The surface ends where s of surface/support.h exceeds this. 0: the surface continues to the end of its region.
    double limit = 0.0;
    std::span<const double> points;  // 3n packed samples; not empty if there is a limit
    std::span<const double> normals; // the samples' unit normals; empty: the surface's normals are used
    // The model's domain. It replaces the other settings, and must outlive the line set.
    const surface::SupportDomain* domain = nullptr;
};

struct LineSetSettings {
    // The side of the mesh's cells; 0: half the spacing of the seeds, or less where walls are thinner than that.
    double side = 0.0;
    std::span<const double> seeds; // 3n packed positions near the surface; empty: found from a lattice over the bounds
    double spacing = 0.0;          // the mean spacing of the seeds; 0: unknown
    // Triangles of the whole surface, which are used where walls are thinner than cells; may be empty.
    GivenTriangles triangles;
    SupportSettings support;
    bool with_shape = false; // whether curvatures are measured, for lines that depend on the view and on curvatures
    std::span<const LineRequest> lines;
};

class LineSet {
public:
    // `surface`, and everything that `shape` refers to, must outlive this object. Throws like triangulate(), and
    // Error{not_converged} if no surface is found.
    LineSet(const base::Work& work, const implicit::Implicit& surface,
            std::unique_ptr<const implicit::ShapeSource> shape, const LineSetSettings& settings);
    LineSet(const LineSet&) = delete;
    LineSet& operator=(const LineSet&) = delete;

    // Returns a pointer that identifies this set. It is unique among all sets that exist while the pointer is held.
    [[nodiscard]] const std::shared_ptr<const void>& identity() const noexcept { return identity_; }
    [[nodiscard]] const implicit::Implicit& surface() const noexcept { return surface_; }
    [[nodiscard]] const SurfaceMesh& mesh() const noexcept { return *mesh_; }
    [[nodiscard]] const SheetCounter& sheets() const noexcept { return *sheets_; }
    // Returns the surface for find_feature_lines(). Lines that need curvatures can be found on it if has_shape() is
    // true.
    [[nodiscard]] FeatureSurface features() const noexcept {
        return {surface_, *source_, has_shape() ? shaped_.mesh : *mesh_, shaped_.shape};
    }
    [[nodiscard]] bool has_shape() const noexcept { return !shaped_.shape.empty(); }
    [[nodiscard]] const base::List<FoundLines>& found() const noexcept { return found_; }
    [[nodiscard]] const SurfaceLines& border() const noexcept { return border_; }
    [[nodiscard]] const Creases& creases() const noexcept { return creases_; }
    // Returns whether a crease that is sharp enough to be drawn lies within the distance `reach` of the place. `reach`
    // is limited to half the side of a mesh cell.
    [[nodiscard]] bool has_crease_near(const glm::dvec3& place, double reach) const noexcept {
        return near_creases_ && near_creases_->has(place, reach);
    }
    // Returns the smooth parts of a surface with creases. Contours are traced on them.
    [[nodiscard]] const base::List<std::unique_ptr<SheetSurface>>& parts() const noexcept { return parts_; }
    // Returns the function whose zero line is the border; null if the border is the end of the region.
    [[nodiscard]] const Level* border_level() const noexcept { return border_exact_ ? &*border_level_ : nullptr; }
    // Returns the share of the surface's area that was cut off because it has no samples.
    [[nodiscard]] double left_out() const noexcept { return left_out_; }
    [[nodiscard]] double seconds() const noexcept { return seconds_; }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void make_mesh(const base::Work& work, const LineSetSettings& settings);
    // Returns whether walls are thinner than the cells of the mesh.
    [[nodiscard]] bool is_thin() const noexcept;
    void cut_mesh(const base::Work& work);
    // Replaces the mesh of cells by one of the given triangles, unless that resolves the surface worse.
    [[nodiscard]] bool use_triangles(const base::Work& work, const GivenTriangles& triangles);
    void measure_support(const base::Work& work, const SupportSettings& settings);
    void split_mesh(const base::Work& work);
    void keep_creases(Creases creases, double side);
    void clip_mesh(const base::Work& work);
    void find(const base::Work& work, const LineRequest& request);
    [[nodiscard]] SurfaceLines find_lines(const base::Work& work, const LineRequest& request) const;

    std::shared_ptr<const void> identity_ = std::make_shared<char>();
    const implicit::Implicit& surface_;
    std::unique_ptr<const implicit::ShapeSource> source_;
    std::optional<surface::SupportDomain> own_domain_;
    // own_domain_, or the model's domain; null: the surface ends at its region.
    const surface::SupportDomain* domain_ = nullptr;
    std::optional<SupportLevel> border_level_;
    bool border_exact_ = false;
    std::optional<SurfaceMesh> mesh_;
    std::optional<SheetCounter> sheets_;
    ShapedMesh shaped_;   // empty if no line needs curvatures
    SurfaceLines border_; // the lines where an open surface ends
    Creases creases_;
    std::optional<NearCreases> near_creases_; // empty if the surface has no creases
    base::List<std::unique_ptr<SheetSurface>> parts_;
    base::List<FoundLines> found_;
    double left_out_ = 0.0;
    double seconds_ = 0.0;
};

} // namespace hrbfnpr::curves
