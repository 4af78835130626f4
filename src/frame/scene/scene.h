// SPDX-License-Identifier: MIT
// Inside of a frame: the items seen through the camera, and what is known of each mark.
#pragma once

#include "base/memory.h"
#include "drawing/drawing.h"
#include "frame/scene/attenuation.h"
#include "frame/scene/item.h"
#include "frame/scene/lens.h"
#include "frame/scene/tone.h"

namespace hrbfnpr::frame {

using drawing::Counts;
using drawing::Dot;
using drawing::dot_faces_back;
using drawing::dot_is_exact;
using drawing::dot_is_paper;
using drawing::faintest_ink;
using drawing::MarkClass;
using drawing::Piece;
using drawing::smallest_radius;
using drawing::soft_rim;
using drawing::Splat;

// Splats this many spacings wide leaves no gaps between evenly spread marks.
inline constexpr float splat_spacings = 1.5F;
// Nearer to the contour than this discs are not pushed any farther.
inline constexpr float smallest_cosine = 0.05F;

// Sizes and opacities of the discs of one group of marks, as functions of the place on the screen.
// All lengths in pixels; `pixels_per_unit` is pixels per eye unit at the mark.
struct Pen {
    float spacing = 0.0F;     // of the group's marks, eye units
    float zoom_at_one = 0.0F; // where a pixel is a unit; 0: no reference, the zoom is 1
    float zoom_exponent = 2.0F;
    float ink_radius = 1.0F, ink_zoom = 0.0F;
    float silhouette_radius = 1.0F, silhouette_zoom = 0.0F;
    float splat_radius = 0.0F; // 0: from the spacing
    float halo = 0.0F;
    float overlap = 0.0F; // of splats: hrbfnpr_style.splat_overlap
    float lambda_front = 1.0F, lambda_back = 1.0F;
    float largest_splat = 0.0F;

    [[nodiscard]] float zoom(float pixels_per_unit) const noexcept {
        return zoom_at_one > 0.0F ? pixels_per_unit * zoom_at_one : 1.0F;
    }
    [[nodiscard]] float scale(float pixels_per_unit) const noexcept {
        return zoom_scale(zoom(pixels_per_unit), zoom_exponent);
    }
    [[nodiscard]] float front_ink(float pixels_per_unit) const noexcept {
        return grown(ink_radius, ink_zoom, pixels_per_unit);
    }
    [[nodiscard]] float silhouette_ink(float pixels_per_unit) const noexcept {
        return grown(silhouette_radius, silhouette_zoom, pixels_per_unit);
    }

    [[nodiscard]] float front_splat(float pixels_per_unit) const noexcept {
        // One pixel at least, so that small drawings are covered as well.
        const float radius =
            splat_radius > 0.0F ? splat_radius : std::max(1.0F, splat_spacings * spacing * pixels_per_unit);
        return std::min(radius, largest_splat);
    }
    // The area scales with the zoom.  An automatic splat follows the zoom already, so there it is
    // only the halo that is left to scale.
    [[nodiscard]] float back_splat(float pixels_per_unit) const noexcept {
        const float shrink = std::sqrt(scale(pixels_per_unit));
        if (splat_radius > 0.0F) return std::min((splat_radius + halo) * shrink, largest_splat);
        return front_splat(pixels_per_unit) + halo * shrink;
    }

    [[nodiscard]] float front_opacity(float nu, float radius, float pixels_per_unit) const noexcept {
        return disc_opacity(front_alpha(nu, lambda_front), overlap,
                            expected_overlap(radius, spacing * pixels_per_unit, nu));
    }
    [[nodiscard]] float back_opacity(float nu, float radius, float pixels_per_unit) const noexcept {
        return disc_opacity(back_alpha(nu, lambda_back), overlap,
                            expected_overlap(radius, spacing * pixels_per_unit, nu));
    }

private:
    [[nodiscard]] float grown(float radius, float exponent, float pixels_per_unit) const noexcept {
        return exponent == 0.0F ? radius : radius * std::pow(zoom(pixels_per_unit), exponent);
    }
};

// How far behind its mark, in eye units, a front mark's disc of paper is painted, so that it lies
// behind all ink of its own layer: within the disc's radius R a sphere of any size that faces the
// eye under the angle theta falls back by R (1 + sin(theta)) / cos(theta) at most, be it a plane
// (R tan(theta)) or so small that its contour is just within reach.
[[nodiscard]] inline float front_push(float radius, float nu, float pixels_per_unit) noexcept {
    const float cosine = std::clamp(std::abs(nu), smallest_cosine, 1.0F);
    return radius / pixels_per_unit * (1.0F + std::sqrt(1.0F - cosine * cosine)) / cosine;
}

// The ink that a back mark must not cover is that of the contour, where its layer turns to the
// front.  That is nearer to the eye, and all that is needed is some slack.
[[nodiscard]] inline float back_push(float radius, float pixels_per_unit) noexcept { return radius / pixels_per_unit; }

// One item's matrices.
struct ItemView {
    Style style;
    bool both_sides = false;
    const implicit::Implicit* model = nullptr;
    const curves::LineSet* lines = nullptr;
    glm::dvec3 origin{0.0}; // of the set's positions
    double unit = 1.0;      // in which positions are taken from here on: that of the set's clusters
    glm::vec3 centre{0.0F}; // of a ball around them, relative to the origin
    float radius = 0.0F;
    glm::mat3 to_eye{1.0F}; // of positions relative to the set's origin
    glm::vec3 eye_offset{0.0F};
    glm::mat3 normal_to_eye{1.0F};   // inverse transposes, so that normals stay outward under mirrors too
    glm::mat3 normal_to_light{1.0F}; // to the space that the light is in
    glm::vec3 light{0.0F};           // unit
    glm::dmat4 to_world{1.0};        // of positions relative to the set's origin
    glm::mat3 normal_to_world{1.0F};
};

// The marks of one layer of one item that take part in the drawing.
struct Run {
    const marks::Layer* marks = nullptr;
    const LayerStyle* style = nullptr;
    // Three of each mark, relative to the set's origin: those of the layer, or of the item's pose.
    const float* position = nullptr;
    const float* normal = nullptr;
    const float* posed_direction = nullptr;        // of the pose, if it has them
    const marks::MarkClusters* clusters = nullptr; // the layer's, the pose's, or the other side's
    bool is_posed = false;
    std::int32_t item = 0;   // among the scene's
    std::int32_t source = 0; // among the drawing's
    std::int32_t layer = 0;  // of the item's set
    std::int64_t first = 0;  // place of its first mark in the arrays below
    std::int64_t count = 0;
    std::int64_t first_place = 0; // of its clusters' blocks, one after the other
    std::uint32_t first_id = 0;
    std::uint32_t directions = 3; // of front ink
    bool draws_front = false;
    bool draws_silhouettes = false; // of VISIBILITY_PUBLISHED
    bool paints_paper = false;      // HIDDEN_LINES_ATTENUATE
    bool occludes = false;          // HIDDEN_LINES_HIDE
    float separation = 0.0F;        // of strokes, eye units; 0: none is known
    std::int64_t first_joined = 0;  // of those that are drawn as strokes: place of the first mark among all such
    bool as_strokes = false;        // marks that follow each other become lines
    bool as_hatch = false;          // strokes become lines whose width makes the tone
    bool scattered = true;          // its marks form no strokes
    bool makes_tone = true;         // its ink counts for the tone of its item
    bool spread_evenly = false;     // in a blue-noise order
    bool splats = false;            // its marks tell where the layers of its item are
    bool turned = false;            // the other side: normals are opposite to those of the marks; lays no layers itself
    Pen pen;

    [[nodiscard]] std::int64_t places() const noexcept { return clusters->block.size() * marks::MarkBlock::size; }
    [[nodiscard]] glm::vec3 position_of(std::int64_t mark) const noexcept {
        return {position[3 * mark], position[3 * mark + 1], position[3 * mark + 2]};
    }
    [[nodiscard]] glm::vec3 normal_of(std::int64_t mark) const noexcept {
        return {normal[3 * mark], normal[3 * mark + 1], normal[3 * mark + 2]};
    }
    [[nodiscard]] bool has_tone_normals() const noexcept { return !marks->tone_normal.empty(); }
    // What tone goes by: where the layer is posed, turned with normal and direction, or the normal.
    [[nodiscard]] glm::vec3 tone_normal_of(std::int64_t mark) const noexcept {
        if (!has_tone_normals()) return normal_of(mark);
        const glm::vec3 n = is_posed ? posed_tone_normal(mark) : marks::vector_at(marks->tone_normal, mark);
        return turned ? -n : n;
    }
    // In the item's unit.
    [[nodiscard]] glm::vec3 place_of(std::int64_t mark, double unit) const noexcept {
        return glm::vec3(glm::dvec3(position_of(mark)) / unit);
    }
    [[nodiscard]] glm::vec3 posed_tone_normal(std::int64_t mark) const noexcept; // of the front side
    // Radius of the ink of a front mark, by its number in the layer.  Contours are not tapered.
    [[nodiscard]] float front_ink(std::int64_t mark, float pixels_per_unit) const noexcept {
        const float radius = pen.front_ink(pixels_per_unit);
        return marks->width.empty() ? radius : radius * marks->width[mark];
    }
};

// A piece of a run: the unit of work.
struct Chunk {
    std::int32_t run = 0;
    std::int64_t begin = 0, end = 0; // places in the arrays
};

// One entry for each mark of the runs.
struct Marks {
    explicit Marks(base::Memory& memory) noexcept
        : x(memory), y(memory), window_depth(memory), depth(memory), pixels_per_unit(memory), nu(memory), tau(memory),
          tau_depth(memory), mark_class(memory), role(memory) {}

    base::Array<float> x, y;            // pixels
    base::Array<float> window_depth;    // in the camera's convention
    base::Array<float> depth;           // eye units along the view
    base::Array<float> pixels_per_unit; // pixels per eye unit
    base::Array<float> nu;
    base::Array<float> tau;
    base::Array<float> tau_depth;
    base::Array<MarkClass> mark_class; // none = outside
    base::Array<std::uint8_t> role;    // what is drawn of it, bits below

    void resize(std::int64_t count);
    [[nodiscard]] std::int64_t bytes() const noexcept;
};

inline constexpr std::uint8_t role_ink = 1;
inline constexpr std::uint8_t role_paper = 2;

struct Scene {
    explicit Scene(base::Memory& memory) noexcept
        : items(memory), runs(memory), chunks(memory), marks(memory), posed(memory), turned(memory),
          turned_normal(memory) {}

    Lens lens;
    Camera camera; // in the unit that eye space is measured in
    base::Array<ItemView> items;
    base::Array<Run> runs;
    base::Array<Chunk> chunks;
    Marks marks;
    std::int64_t joined = 0;                // marks of runs that are drawn as strokes
    base::List<marks::MarkClusters> posed;  // of layers whose marks have moved
    base::List<marks::MarkClusters> turned; // of runs that are
    base::Array<float> turned_normal;       // of these, one after the other

    [[nodiscard]] const ItemView& item_of(const Run& run) const noexcept { return items[run.item]; }
    [[nodiscard]] std::int64_t mark_count() const noexcept {
        return runs.empty() ? 0 : runs.span().back().first + runs.span().back().count;
    }
    [[nodiscard]] std::int64_t place_count() const noexcept {
        return runs.empty() ? 0 : runs.span().back().first_place + runs.span().back().places();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept;
};

// Fills lens, items and runs, and of the drawing its window, paper, layers, items, runs and poses.
// Throws Error{invalid_argument}.
void set_up(Scene& scene, std::span<const Item> items, const Camera& given, drawing::Drawing& drawing);
// Fills chunks, and makes room for the marks.
void add_chunks(Scene& scene);

// Where a disc of paper is painted in the order of painting, eye units along the view.
[[nodiscard]] inline float paper_depth(const Marks& marks, std::int64_t place, float radius) noexcept {
    const float pixels_per_unit = marks.pixels_per_unit[place];
    return marks.depth[place] + (marks.mark_class[place] == MarkClass::back
                                     ? back_push(radius, pixels_per_unit)
                                     : front_push(radius, marks.nu[place], pixels_per_unit));
}

// Where ink is painted in the order of painting, eye units along the view: pulled toward the eye by
// about its own size, so that it lies over the paper of its own layer.
[[nodiscard]] inline float ink_depth(float depth, float radius, float pixels_per_unit) noexcept {
    return depth - radius / pixels_per_unit;
}

} // namespace hrbfnpr::frame
