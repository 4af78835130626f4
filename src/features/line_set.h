// SPDX-License-Identifier: MIT
// The mesh, creases and lines of a model that do not depend on the camera. They are computed once.
#pragma once

#include "base/list.h"
#include "creases/creases.h"
#include "curves/curves.h"
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
    crease = 11
};
inline constexpr std::uint32_t line_kind_count = 12;
// Lines that are traced again for each camera or light.
[[nodiscard]] constexpr bool depends_on_view(LineKind kind) noexcept {
    return kind == LineKind::contour || kind == LineKind::suggestive_contour || kind == LineKind::apparent_ridge ||
           kind == LineKind::isophote;
}
// The FeatureKind of a line kind.
[[nodiscard]] FeatureKind feature_of(LineKind kind) noexcept;
struct Thresholds {
    double lower, upper;
};
// Limits of strengths as feature_value() computes them.
[[nodiscard]] Thresholds default_thresholds(LineKind kind) noexcept;
// Returns `given`, or the defaults if both values are 0.
[[nodiscard]] inline Thresholds thresholds_of(LineKind kind, const Thresholds& given) noexcept {
    return given.lower > 0.0 || given.upper > 0.0 ? given : default_thresholds(kind);
}

// A request for lines that are found once.
struct LineRequest {
    LineKind kind = LineKind::ridge;
    std::array<char, 64> name{};
    Thresholds thresholds{0.0, 0.0};     // if both are 0, default_thresholds() is used
    double shortest = 0.0;               // diagonals
    glm::dvec3 plane{0.0, 0.0, 1.0};     // sections: the planes' normal
    std::span<const double> levels;      // sections: positions of the planes along their normal
    std::span<const double> points;      // own lines: 3n packed positions
    std::span<const std::int64_t> first; // own lines: the first point of each line, and the total number of points
};

struct FoundLines {
    explicit FoundLines(base::Memory& memory) : lines(memory) {}
    LineKind kind = LineKind::ridge;
    std::array<char, 64> name{};
    SurfaceLines lines;
};

// Where the surface ends because it has no samples.
struct SupportSettings {
    // The surface ends where s of surface/support.h exceeds this; 0: it continues to the end of its region.
    double limit = 0.0;
    std::span<const double> points;  // 3n packed samples; not empty if there is a limit
    std::span<const double> normals; // the samples' unit normals; empty: the surface's normals are used
    // The model's domain. It replaces the other settings, and must outlive the line set.
    const surface::SupportDomain* domain = nullptr;
};

struct LineSetSettings {
    double side = 0.0;             // the cell side of the mesh; 0: half the spacing, and finer if walls are thinner
    std::span<const double> seeds; // 3n packed positions near the surface; empty: found from a lattice over the bounds
    double spacing = 0.0;          // the mean spacing of the seeds; 0: unknown
    SupportSettings support;
    bool with_shape = false; // whether curvatures are measured, for lines that depend on the view and on curvatures
    std::span<const LineRequest> lines;
};

class LineSet {
public:
    // The implicit, and everything that `shape` refers to, must outlive the set. Throws like triangulate(), and
    // Error{not_converged} if no surface is found.
    LineSet(const base::Work& work, const implicit::Implicit& surface,
            std::unique_ptr<const implicit::ShapeSource> shape, const LineSetSettings& settings);
    LineSet(const LineSet&) = delete;
    LineSet& operator=(const LineSet&) = delete;

    // The identity is unique among the sets that exist while a pointer to it is held.
    [[nodiscard]] const std::shared_ptr<const void>& identity() const noexcept { return identity_; }
    [[nodiscard]] const implicit::Implicit& surface() const noexcept { return surface_; }
    [[nodiscard]] const SurfaceMesh& mesh() const noexcept { return *mesh_; }
    [[nodiscard]] const SheetCounter& sheets() const noexcept { return *sheets_; }
    // The surface for find_feature_lines(). It supports lines that need curvatures if has_shape() is true.
    [[nodiscard]] FeatureSurface features() const noexcept {
        return {surface_, *source_, has_shape() ? shaped_.mesh : *mesh_, shaped_.shape};
    }
    [[nodiscard]] bool has_shape() const noexcept { return !shaped_.shape.empty(); }
    [[nodiscard]] const base::List<FoundLines>& found() const noexcept { return found_; }
    [[nodiscard]] const SurfaceLines& border() const noexcept { return border_; }
    [[nodiscard]] const Creases& creases() const noexcept { return creases_; }
    // Whether a crease sharp enough to be drawn lies within `reach`, or within half a mesh side if that is less.
    [[nodiscard]] bool has_crease_near(const glm::dvec3& place, double reach) const noexcept {
        return near_creases_ && near_creases_->has(place, reach);
    }
    // The smooth parts of a surface with creases, on which contours are traced.
    [[nodiscard]] const base::List<std::unique_ptr<SheetSurface>>& parts() const noexcept { return parts_; }
    // The level whose zero line is the border; null if the border is the end of a region.
    [[nodiscard]] const Level* border_level() const noexcept { return border_exact_ ? &*border_level_ : nullptr; }
    // The share of the surface's area that is cut off because it has no samples.
    [[nodiscard]] double left_out() const noexcept { return left_out_; }
    [[nodiscard]] double seconds() const noexcept { return seconds_; }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void make_mesh(const base::Work& work, const LineSetSettings& settings);
    void measure_support(const base::Work& work, const SupportSettings& settings);
    void split_mesh(const base::Work& work);
    void clip_mesh(const base::Work& work);
    [[nodiscard]] SurfaceLines find(const base::Work& work, const LineRequest& request) const;

    std::shared_ptr<const void> identity_ = std::make_shared<char>();
    const implicit::Implicit& surface_;
    std::unique_ptr<const implicit::ShapeSource> source_;
    std::optional<surface::SupportDomain> own_domain_;
    const surface::SupportDomain* domain_ = nullptr; // own_domain_ or the model's; null: the surface ends at its region
    std::optional<SupportLevel> border_level_;
    bool border_exact_ = false;
    std::optional<SurfaceMesh> mesh_;
    std::optional<SheetCounter> sheets_;
    ShapedMesh shaped_;   // empty unless lines need curvatures
    SurfaceLines border_; // where an open surface ends
    Creases creases_;
    std::optional<NearCreases> near_creases_; // null: the surface has no creases
    base::List<std::unique_ptr<SheetSurface>> parts_;
    base::List<FoundLines> found_;
    double left_out_ = 0.0;
    double seconds_ = 0.0;
};

} // namespace hrbfnpr::curves
