// SPDX-License-Identifier: MIT
// The data that both producers of a drawing begin with: the items seen through the camera, and the runs of marks that
// take part.
//
// set_up: items, camera -> Scene (lens, items, runs), and the drawing's layers and runs
// ToneCalls: places and normals of marks -> tau by the style's callback
#pragma once

#include "base/list.h"
#include "base/memory.h"
#include "base/view.h"
#include "drawing/drawing.h"
#include "features/line_set.h"
#include "frame/scene/camera.h"
#include "frame/scene/fields.h"
#include "frame/scene/inks.h"
#include "frame/scene/light.h"
#include "frame/scene/lighting.h"
#include "frame/scene/projection_loops.h"
#include "frame/scene/shading.h"
#include "frame/scene/style.h"
#include "frame/scene/tuning.h"
#include "implicit/implicit.h"
#include "marks/point_set.h"

#include <array>
#include <span>

namespace hrbfnpr::frame {

using drawing::Counts;
using drawing::Dot;
using drawing::dot_faces_back;
using drawing::dot_is_exact;
using drawing::dot_is_paper;
using drawing::faintest_ink;
using drawing::IndexRange;
using drawing::MarkClass;
using drawing::smallest_radius;
using drawing::soft_rim;
using drawing::Splat;

// ---- Pens and runs

// The positions of the marks of one layer in this drawing. Each view has one element for each mark of the layer.
struct Pose {
    std::int64_t layer = 0;
    base::InView position;  // absolute positions
    base::InView normal;    // unit vectors
    base::InView direction; // unit vectors, or empty
};

struct Item {
    const marks::PointSet* set = nullptr;
    const implicit::Implicit* model = nullptr; // if given, visibility is exact
    Style style;
    glm::dmat4 transform{1.0};
    std::span<const Pose> poses; // The caller owns the poses.
    const curves::LineSet* lines = nullptr;
    bool both_sides = false;          // If true, marks are drawn on the inside of the surface, too.
    const Shading* shading = nullptr; // Null: all light reaches the marks.
};

// ---- Items and runs as seen by the camera

// The sizes and opacities of the discs of a run's marks, as functions of the place on the screen. All lengths are in
// pixels. `pixels_per_unit` is the number of pixels per eye unit at the mark.
struct DiscSizes {
    const Style* style = nullptr; // The caller owns the style and the layer style.
    const LayerStyle* layer = nullptr;
    float spacing = 0.0F;     // the square root of the surface area that a mark represents, in eye units
    float separation = 0.0F;  // the distance between neighbouring strokes of the run, in eye units; 0: not known
    float zoom_at_one = 0.0F; // The zoom at which a pixel is an eye unit. 0: there is no reference, and the zoom is 1.
    float largest_splat = 0.0F;

    [[nodiscard]] float zoom(float pixels_per_unit) const noexcept {
        return zoom_at_one > 0.0F ? pixels_per_unit * zoom_at_one : 1.0F;
    }
    [[nodiscard]] float scale(float pixels_per_unit) const noexcept {
        return zoom_scale(zoom(pixels_per_unit), static_cast<float>(style->zoom_exponent));
    }
    [[nodiscard]] float front_ink(float pixels_per_unit) const noexcept {
        return grown(layer->radius, layer->radius_zoom, pixels_per_unit);
    }
    [[nodiscard]] float silhouette_ink(float pixels_per_unit) const noexcept {
        return grown(style->silhouette_radius, style->silhouette_radius_zoom, pixels_per_unit);
    }
    [[nodiscard]] float front_splat(float pixels_per_unit) const noexcept {
        // The radius is at least one pixel, so that small drawings are covered, too.
        const float own = std::max(1.0F, scene_tuning.splat_spacings * spacing * pixels_per_unit);
        return std::min(style->splat_radius > 0.0F ? style->splat_radius : own, largest_splat);
    }
    // The area scales with the zoom. An automatic splat already follows the zoom, so only the halo is scaled.
    [[nodiscard]] float back_splat(float pixels_per_unit) const noexcept {
        const float shrink = std::sqrt(scale(pixels_per_unit));
        if (style->splat_radius > 0.0F)
            return std::min((style->splat_radius + style->halo_width) * shrink, largest_splat);
        return front_splat(pixels_per_unit) + style->halo_width * shrink;
    }
    [[nodiscard]] float front_opacity(float nu, float radius, float pixels_per_unit) const noexcept {
        return disc_opacity(front_alpha(nu, static_cast<float>(style->attenuation_front)), style->splat_overlap,
                            expected_overlap(radius, spacing * pixels_per_unit, nu));
    }
    [[nodiscard]] float back_opacity(float nu, float radius, float pixels_per_unit) const noexcept {
        return disc_opacity(back_alpha(nu, static_cast<float>(style->attenuation_back)), style->splat_overlap,
                            expected_overlap(radius, spacing * pixels_per_unit, nu));
    }

private:
    [[nodiscard]] float grown(float radius, float exponent, float pixels_per_unit) const noexcept {
        return exponent == 0.0F ? radius : radius * std::pow(zoom(pixels_per_unit), exponent);
    }
};

// An item in the frame. Its matrices apply to positions relative to the origin of the set, in units of `unit`.
struct ItemView {
    Style style;
    bool both_sides = false;
    const implicit::Implicit* model = nullptr;
    const curves::LineSet* lines = nullptr;
    glm::dvec3 origin{0.0}; // The origin of the set's positions.
    double unit = 1.0;      // the unit of lengths in the set's clusters
    glm::vec3 centre{0.0F}; // the centre of a bounding ball of the marks, relative to `origin`, in `unit`
    float radius = 0.0F;
    glm::mat3 to_eye{1.0F};
    glm::vec3 eye_offset{0.0F};
    glm::mat3 normal_to_eye{1.0F}; // an inverse transpose, so that normals point outward even if the transform mirrors
    Lighting lighting{};           // with lamps in the space of the style's first light
    const Shading* shading = nullptr;
    glm::dmat4 to_world{1.0};
    glm::mat3 normal_to_world{1.0F};
};

// Those marks of a layer of an item that take part in the drawing.
struct Run {
    const marks::Layer* marks = nullptr;
    const LayerStyle* style = nullptr;
    DiscSizes discs;
    // For each mark: x, y and z. Positions are relative to the origin of the set. The arrays are those of the layer, or
    // transformed copies if the item has a pose. If `turned`, `normal` is a copy with opposite signs.
    const float* position = nullptr;
    const float* normal = nullptr;
    const float* posed_direction = nullptr; // NULL if the pose has no directions
    const marks::MarkClusters* clusters = nullptr;
    std::int32_t item = 0;      // the index of the item in the scene
    std::int32_t source = 0;    // the index of the item in the drawing
    std::int32_t layer = 0;     // the index of the layer in the item's set
    std::uint32_t first_id = 0; // the id of the run's first mark in the drawing
    std::int64_t first = 0;     // the index of the run's first mark among the marks of all runs
    std::int64_t count = 0;     // the number of marks in the run
    // The index of the run's first place among the places of all runs. A place is an element of a cluster's block.
    std::int64_t first_place = 0;
    // The drawing's layers of the run: one for its own ink, and one for each ink of the palette if the run has inks.
    std::uint32_t first_layer = 0;
    std::uint32_t layers = 1;
    std::int32_t inks = -1;       // index into the scene's choices of inks; -1: all marks have the layer's own ink
    RunFields fields;             // A published drawing has none.
    std::uint32_t directions = 3; // the directions whose strokes are front ink; bit 0 is the first, bit 1 the second
    Shape shape = Shape::dots;    // How front ink is drawn. Marks without strokes are always dots.
    bool draws_front = false;
    // True if the marks are spread evenly in the picture. False: they keep their even order on the surface.
    bool even_in_picture = false;
    bool makes_tone = true; // true if the ink of the run counts for the tone of its item
    bool splats = false;    // true if the marks are the splats that show where the layers of the item are
    // True for the other side of the surface. Its normals are opposite to the normals of the marks.
    bool turned = false;
    // only with VISIBILITY_PUBLISHED
    bool draws_silhouettes = false;
    bool paints_paper = false; // true with HIDDEN_LINES_ATTENUATE
    bool occludes = false;     // true with HIDDEN_LINES_HIDE

    [[nodiscard]] std::int64_t places() const noexcept { return clusters->block.size() * marks::MarkBlock::size; }
    [[nodiscard]] bool is_posed() const noexcept { return position != marks->position.data(); }
    [[nodiscard]] bool is_scattered() const noexcept { return !marks->has_strokes(); }
    // Returns whether the marks are in a blue-noise order.
    [[nodiscard]] bool is_even() const noexcept { return marks->progressive; }
    [[nodiscard]] bool draws_direction(std::uint32_t set) const noexcept {
        return directions == 3U || (directions >> set & 1U) != 0;
    }
    [[nodiscard]] glm::vec3 position_of(std::int64_t mark) const noexcept { return vector_of(position, mark); }
    [[nodiscard]] glm::vec3 normal_of(std::int64_t mark) const noexcept { return vector_of(normal, mark); }
    // Returns the position of a mark in the item's unit.
    [[nodiscard]] glm::vec3 place_of(std::int64_t mark, double unit) const noexcept {
        return glm::vec3(glm::dvec3(position_of(mark)) / unit);
    }
    [[nodiscard]] bool has_tone_normals() const noexcept { return !marks->tone_normal.empty(); }
    // Returns the normal for tone. In a posed layer, it is rotated together with normal and direction.
    [[nodiscard]] glm::vec3 tone_normal_of(std::int64_t mark) const noexcept {
        if (!has_tone_normals() || is_posed()) return posed_tone_normal_of(mark);
        return (turned ? -1.0F : 1.0F) * marks::vector_at(marks->tone_normal, mark);
    }
    // Returns what marks see of lights. The marks of the other side are lit as if all light reached them.
    [[nodiscard]] const Shading* shading_of(const ItemView& of) const noexcept { return turned ? nullptr : of.shading; }
    // Returns bounds for what fields do to the marks of a piece of a stroke.
    [[nodiscard]] FieldBounds field_bounds_of(const marks::StrokePiece& piece) const noexcept;
    // Returns the radius of the ink of a front mark, given by its index in the layer.
    [[nodiscard]] float front_ink(std::int64_t mark, float pixels_per_unit) const noexcept {
        const float radius = discs.front_ink(pixels_per_unit);
        return marks->width.empty() ? radius : radius * marks->width[mark];
    }

private:
    // Returns the normal for tone of a posed layer, or the normal of a layer without normals for tone.
    [[nodiscard]] glm::vec3 posed_tone_normal_of(std::int64_t mark) const noexcept;
    [[nodiscard]] glm::vec3 vector_of(const float* all, std::int64_t mark) const noexcept {
        HRBFNPR_ASSERT(mark >= 0 && mark < count);
        return {all[3 * mark], all[3 * mark + 1], all[3 * mark + 2]};
    }
};

// The strokes of lines or hatching, before they are sorted into the drawing.
struct LineStrokes {
    explicit LineStrokes(base::Memory& memory) noexcept : strokes(memory), points(memory) {}

    base::Array<drawing::Stroke> strokes; // in any order
    base::Array<drawing::StrokePoint> points;

    // Appends the points of a stroke. Their lengths become those from the first of them. The stroke itself is appended
    // by the caller, who may change the points before.
    void add_points(drawing::Stroke& stroke, std::span<const drawing::StrokePoint> from) {
        stroke.first = points.size();
        stroke.count = static_cast<std::int32_t>(from.size());
        for (const drawing::StrokePoint& point : from) {
            points.push_back(point);
            points.back().length = point.length - from.front().length;
        }
    }
};

// ---- The scene

struct Scene {
    explicit Scene(base::Memory& memory) noexcept
        : items(memory), runs(memory), inks(memory), posed(memory), turned(memory), turned_normal(memory) {}

    Lens lens;
    Camera camera;               // The camera. The unit of its eye space is that of the frame.
    base::Array<ItemView> items; // The items. Those for the other sides come last.
    base::Array<Run> runs;
    base::List<InkChoice> inks;             // the choices of the runs that have inks
    base::List<marks::MarkClusters> posed;  // the clusters of layers with moved marks
    base::List<marks::MarkClusters> turned; // the clusters of the runs of the other sides
    base::Array<float> turned_normal;       // the normals for the runs of the other sides, run after run

    [[nodiscard]] const ItemView& item_of(const Run& run) const noexcept { return items[run.item]; }
    // Returns how marks of a run choose their inks, or NULL.
    [[nodiscard]] const InkChoice* inks_of(const Run& run) const noexcept {
        return run.inks < 0 ? nullptr : &inks[run.inks];
    }
    [[nodiscard]] std::int64_t mark_count() const noexcept {
        return runs.empty() ? 0 : runs.span().back().first + runs.span().back().count;
    }
    [[nodiscard]] std::int64_t place_count() const noexcept {
        return runs.empty() ? 0 : runs.span().back().first_place + runs.span().back().places();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        std::int64_t sum = items.bytes() + runs.bytes() + inks.bytes() + turned_normal.bytes();
        for (const marks::MarkClusters& clusters : posed) sum += clusters.bytes();
        for (const marks::MarkClusters& clusters : turned) sum += clusters.bytes();
        return sum;
    }
};

// Sets lens, camera, items and runs of the scene, and window, paper, layers, items, runs and poses of the drawing. The
// drawing has a layer of front ink for each run. In a published drawing, each is followed by a layer of contours.
// Throws Error{invalid_argument}.
void set_up(Scene& scene, std::span<const Item> items, const Camera& given, drawing::Drawing& drawing);

// An item and the lens of its camera, without the item's runs.
struct SingleView {
    Lens lens;
    ItemView item;
};
// Returns how the camera sees an item that is the only one of a drawing. Throws Error{invalid_argument}.
[[nodiscard]] SingleView see(const Item& item, const Camera& camera);

// Asks a style's callback for tones, on the thread that called the library.
class ToneCalls {
public:
    explicit ToneCalls(base::Memory& memory) noexcept
        : positions_(memory), normals_(memory), tau_(memory), places_(memory) {}

    // The tone of each added mark is written to out[stride * place]. Call begin() before the marks of an item, and
    // end() after them.
    void begin(const ItemView& item, float* out, std::int64_t stride) noexcept;
    void add(const glm::vec3& own_position, const glm::vec3& own_normal, std::int64_t place);
    void end();

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return positions_.bytes() + normals_.bytes() + tau_.bytes() + places_.bytes();
    }

private:
    const ItemView* item_ = nullptr;
    float* out_ = nullptr;
    std::int64_t stride_ = 1;
    base::Array<float> positions_, normals_, tau_;
    base::Array<std::int64_t> places_;
};

// ---- Bounds that hold for many marks at once: for all that lie in a ball and have normals in a cone

// An item as seen in its own coordinates.
struct ItemSight {
    // `view_transform.rigid` is true if the transform keeps angles. Cones of normals then stay cones.
    ViewTransform view_transform;
    float scale = 1.0F;  // the largest length, in eye units, that a unit length of the object can have
    bool inside = false; // true if the whole item is certainly in the picture
    glm::vec3 eye{0.0F}; // in object space: the centre of projection, or the unit direction of all lines of sight
    Lighting lighting{}; // with lamps in object space, if the transform keeps angles
};

// The sides of the frustum in eye space. Inside, plane . (eye, 1) >= 0.
struct Frustum {
    std::array<glm::vec4, 6> plane; // left, right, top, bottom, near, far
    std::array<float, 6> norm;      // for each plane: the length of its first three numbers
    float w_norm = 0.0F;
};

[[nodiscard]] Frustum frustum_of(const Lens& lens) noexcept;
[[nodiscard]] ItemSight sight_of(const ItemView& item, const Lens& lens, const Frustum& frustum) noexcept;

// Bounds for all marks of a cluster, or of a piece of a stroke.
struct ClusterView {
    float beyond = -1.0F; // A lower bound in pixels for the distance of marks outside the picture. Below 0: not known.
    bool inside = false;  // true if all marks are certainly in the picture
    float pixels_per_unit = 1.0F; // at the centre of the ball
    // A lower bound for w of the projection. 0: some marks may not be in front of the camera.
    float nearest = 0.0F;
    float nu_min = -1.0F;
    float nu_max = 1.0F;
};

// Returns a lower bound of the tones by light, from the normals of the marks. Tone may use others. `seen` has the least
// shares of light that reach the marks.
[[nodiscard]] float least_tau(const marks::Extent& extent, const ItemSight& sight, const SeenShares& seen) noexcept;

[[nodiscard]] ClusterView view_cluster(const marks::Extent& extent, const ItemSight& sight, const Lens& lens,
                                       const Frustum& frustum) noexcept;

// Returns whether n . v > 0 for all marks. It returns false if the quick test cannot decide.
[[nodiscard]] bool faces_away(const marks::Extent& extent, const ItemSight& sight) noexcept;

// Returns a lower bound of the tones by light, from the piece's normals for tone.
[[nodiscard]] float least_tau_of_piece(const marks::StrokePiece& piece, const ItemSight& sight,
                                       const SeenShares& seen) noexcept;

} // namespace hrbfnpr::frame
