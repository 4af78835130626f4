// SPDX-License-Identifier: MIT
// The data that both producers of a drawing begin with: the items seen through the camera, and the runs of marks that
// take part.
//
// set_up: items, camera -> Scene (lens, items, runs), and the drawing's layers and runs
// ToneCalls: places and normals of marks -> tau by the style's callback
// add_chunks, Marks: what is known of each mark of a drawing as published
#pragma once

#include "base/list.h"
#include "base/memory.h"
#include "base/view.h"
#include "drawing/drawing.h"
#include "features/line_set.h"
#include "frame/scene/attenuation.h"
#include "frame/scene/camera.h"
#include "frame/scene/light.h"
#include "frame/scene/style.h"
#include "frame/scene/tuning.h"
#include "implicit/implicit.h"
#include "marks/point_set.h"

#include <span>

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

// ---- Pens and runs

// Where the marks of one layer are in this drawing: views of as many elements as it has marks.
struct Pose {
    std::int64_t layer = 0;
    base::InView position;  // absolute
    base::InView normal;    // unit
    base::InView direction; // unit; or empty
};

struct Item {
    const marks::PointSet* set = nullptr;
    const implicit::Implicit* model = nullptr; // if it is given, visibility is exact
    Style style;
    glm::dmat4 transform{1.0};
    std::span<const Pose> poses; // the caller keeps them
    const curves::LineSet* lines = nullptr;
    bool both_sides = false; // marks are drawn on the inside of the surface, too
};

// ---- How it is seen

// Sizes and opacities of the discs of one group of marks, as functions of the place on the screen. All lengths are in
// pixels; `pixels_per_unit` is pixels per eye unit at the mark.
struct Pen {
    const Style* style = nullptr; // the caller keeps both
    const LayerStyle* layer = nullptr;
    float spacing = 0.0F;     // a mark stands for spacing^2 of surface; eye units
    float separation = 0.0F;  // distance between neighbouring strokes of the group, eye units; 0: not known
    float zoom_at_one = 0.0F; // the zoom where a pixel is an eye unit; 0: no reference, and the zoom is 1
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
        // One pixel at least, so that small drawings are covered as well.
        const float own = std::max(1.0F, scene_tuning.splat_spacings * spacing * pixels_per_unit);
        return std::min(style->splat_radius > 0.0F ? style->splat_radius : own, largest_splat);
    }
    // The area scales with the zoom. An automatic splat follows the zoom already, so only the halo is left to scale.
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

// One item's matrices. They take places relative to the set's origin, in `unit`.
struct ItemView {
    Style style;
    bool both_sides = false;
    const implicit::Implicit* model = nullptr;
    const curves::LineSet* lines = nullptr;
    glm::dvec3 origin{0.0}; // the set's positions are relative to it
    double unit = 1.0;      // the unit of lengths in the set's clusters
    glm::vec3 centre{0.0F}; // centre of a ball around the marks, relative to `origin`, in `unit`
    float radius = 0.0F;
    glm::mat3 to_eye{1.0F};
    glm::vec3 eye_offset{0.0F};
    glm::mat3 normal_to_eye{1.0F}; // an inverse transpose, so that normals stay outward under mirrors, too
    Light light{};
    glm::dmat4 to_world{1.0};
    glm::mat3 normal_to_world{1.0F};
};

// The marks of one layer of one item that take part in the drawing.
struct Run {
    const marks::Layer* marks = nullptr;
    const LayerStyle* style = nullptr;
    Pen pen;
    // Three numbers for each mark; positions are relative to the set's origin. The arrays are the layer's, those of the
    // item's pose, or those made for the other side.
    const float* position = nullptr;
    const float* normal = nullptr;
    const float* posed_direction = nullptr; // NULL: the pose has none
    const marks::MarkClusters* clusters = nullptr;
    std::int32_t item = 0;        // its number in the scene
    std::int32_t source = 0;      // the item's number in the drawing
    std::int32_t layer = 0;       // its number in the item's set
    std::uint32_t first_id = 0;   // the id of its first mark in the drawing
    std::int64_t first = 0;       // place of its first mark among the marks of all runs
    std::int64_t count = 0;       // the number of its marks
    std::int64_t first_place = 0; // the first of its places in clusters' blocks, counted over all runs
    std::uint32_t directions = 3; // directions of strokes that are front ink: bit 0 the first, bit 1 the second
    Shape shape = Shape::dots;    // how front ink is drawn: marks that form no strokes are dots whatever the style says
    bool draws_front = false;
    bool makes_tone = true; // its ink counts for the tone of its item
    bool splats = false;    // its marks tell where the layers of its item are
    bool turned = false;    // it is the other side: normals are opposite to those of the marks
    // With VISIBILITY_PUBLISHED only.
    bool draws_silhouettes = false;
    bool paints_paper = false; // HIDDEN_LINES_ATTENUATE
    bool occludes = false;     // HIDDEN_LINES_HIDE

    [[nodiscard]] std::int64_t places() const noexcept { return clusters->block.size() * marks::MarkBlock::size; }
    [[nodiscard]] bool is_posed() const noexcept { return position != marks->position.data(); }
    [[nodiscard]] bool is_scattered() const noexcept { return !marks->has_strokes(); }
    // Whether its marks are in a blue-noise order.
    [[nodiscard]] bool is_even() const noexcept { return marks->progressive; }
    [[nodiscard]] bool draws_set(std::uint32_t set) const noexcept {
        return directions == 3U || (directions >> set & 1U) != 0;
    }
    [[nodiscard]] glm::vec3 position_of(std::int64_t mark) const noexcept { return vector_of(position, mark); }
    [[nodiscard]] glm::vec3 normal_of(std::int64_t mark) const noexcept { return vector_of(normal, mark); }
    // In the item's unit.
    [[nodiscard]] glm::vec3 place_of(std::int64_t mark, double unit) const noexcept {
        return glm::vec3(glm::dvec3(position_of(mark)) / unit);
    }
    [[nodiscard]] bool has_tone_normals() const noexcept { return !marks->tone_normal.empty(); }
    // The normal from which tone is found. Where the layer is posed it is turned with normal and direction.
    [[nodiscard]] glm::vec3 tone_normal_of(std::int64_t mark) const noexcept;
    // Radius of the ink of a front mark, by its number in the layer.
    [[nodiscard]] float front_ink(std::int64_t mark, float pixels_per_unit) const noexcept {
        const float radius = pen.front_ink(pixels_per_unit);
        return marks->width.empty() ? radius : radius * marks->width[mark];
    }

private:
    [[nodiscard]] glm::vec3 vector_of(const float* all, std::int64_t mark) const noexcept {
        HRBFNPR_ASSERT(mark >= 0 && mark < count);
        return {all[3 * mark], all[3 * mark + 1], all[3 * mark + 2]};
    }
};

// Strokes of lines or of hatching, before they stand among the others of a drawing.
struct LineStrokes {
    explicit LineStrokes(base::Memory& memory) noexcept : strokes(memory), points(memory) {}

    base::Array<drawing::Stroke> strokes; // in any order
    base::Array<drawing::StrokePoint> points;
};

// ---- The numbers of each mark, as published

// Consecutive marks of a run.
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
    base::Array<MarkClass> mark_class; // none: the mark lies outside of the picture
    base::Array<std::uint8_t> role;    // bits of role_ink and role_paper: the parts of the mark that are drawn

    template <class F>
    void for_arrays(const F& f) {
        for (base::Array<float>* a : {&x, &y, &window_depth, &depth, &pixels_per_unit, &nu, &tau, &tau_depth}) f(*a);
        f(mark_class);
        f(role);
    }
};

inline constexpr std::uint8_t role_ink = 1;
inline constexpr std::uint8_t role_paper = 2;

// ---- The scene

struct Scene {
    explicit Scene(base::Memory& memory) noexcept
        : items(memory), runs(memory), chunks(memory), marks(memory), posed(memory), turned(memory),
          turned_normal(memory) {}

    Lens lens;
    Camera camera;               // in the unit that eye space is measured in
    base::Array<ItemView> items; // those of the other sides come last
    base::Array<Run> runs;
    base::Array<Chunk> chunks;
    Marks marks;
    base::List<marks::MarkClusters> posed;  // clusters of the layers whose marks have moved
    base::List<marks::MarkClusters> turned; // clusters of the runs of the other sides
    base::Array<float> turned_normal;       // normals of the marks of those runs, run after run

    [[nodiscard]] const ItemView& item_of(const Run& run) const noexcept { return items[run.item]; }
    [[nodiscard]] std::int64_t mark_count() const noexcept {
        return runs.empty() ? 0 : runs.span().back().first + runs.span().back().count;
    }
    [[nodiscard]] std::int64_t place_count() const noexcept {
        return runs.empty() ? 0 : runs.span().back().first_place + runs.span().back().places();
    }
    [[nodiscard]] std::int64_t bytes() noexcept;
};

// Fills lens, items and runs, and of the drawing its window, paper, layers, items, runs and poses. The drawing has a
// layer of front ink for each run; as published each is followed by a layer of contours.
// Throws Error{invalid_argument}.
void set_up(Scene& scene, std::span<const Item> items, const Camera& given, drawing::Drawing& drawing);
// Fills chunks, and makes room for the marks.
void add_chunks(Scene& scene);

// Asks a style's tone callback for tau, on the thread that entered.
class ToneCalls {
public:
    explicit ToneCalls(base::Memory& memory) noexcept
        : positions_(memory), normals_(memory), tau_(memory), places_(memory) {}

    // The answers to all marks added go to out[place]. Call begin() first, for each item, and end() last.
    void begin(const ItemView& item, base::Array<float>& out) noexcept;
    void add(const glm::vec3& own_position, const glm::vec3& own_normal, std::int64_t place);
    void end();

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return positions_.bytes() + normals_.bytes() + tau_.bytes() + places_.bytes();
    }

private:
    const ItemView* item_ = nullptr;
    base::Array<float>* out_ = nullptr;
    base::Array<float> positions_, normals_, tau_;
    base::Array<std::int64_t> places_;
};

// ---- The order of painting, as published

// How far after its mark, in eye units, a front mark's disc of paper is painted, so that it lies after all ink of its
// own layer: within the disc's radius R a sphere of any size that faces the eye under the angle theta falls back by R
// (1 + sin(theta)) / cos(theta) at most, be it a plane (R tan(theta)) or so small that its contour is just within
// reach.
[[nodiscard]] inline float front_push(float radius, float nu, float pixels_per_unit) noexcept {
    const float cosine = std::clamp(std::abs(nu), scene_tuning.smallest_cosine, 1.0F);
    return radius / pixels_per_unit * (1.0F + std::sqrt(1.0F - cosine * cosine)) / cosine;
}

// The ink that a back mark must not cover is the contour's, where its layer turns to the front. It is nearer to the
// eye, so only some slack is needed.
[[nodiscard]] inline float back_push(float radius, float pixels_per_unit) noexcept { return radius / pixels_per_unit; }

// Where a disc of paper is painted in the order of painting, eye units along the view.
[[nodiscard]] inline float paper_depth(const Marks& marks, std::int64_t place, float radius) noexcept {
    const float pixels_per_unit = marks.pixels_per_unit[place];
    return marks.depth[place] + (marks.mark_class[place] == MarkClass::back
                                     ? back_push(radius, pixels_per_unit)
                                     : front_push(radius, marks.nu[place], pixels_per_unit));
}

// Where ink is painted in the order of painting, eye units along the view: it is pulled toward the eye by about its own
// size, so that it lies over the paper of its own layer.
[[nodiscard]] inline float ink_depth(float depth, float radius, float pixels_per_unit) noexcept {
    return depth - radius / pixels_per_unit;
}

} // namespace hrbfnpr::frame
