// Inside of a frame: the items seen through the camera, and what is known of each mark.
#pragma once

#include "base/memory.h"
#include "frame/scene/attenuation.h"
#include "frame/scene/item.h"
#include "frame/scene/lens.h"
#include "frame/scene/mark_class.h"
#include "frame/scene/tone.h"

namespace hrbfnpr::frame {

// A cover this many spacings wide leaves no gaps between evenly spread marks.
inline constexpr float cover_spacings = 1.5F;
// Nearer to the contour than this discs are not pushed any farther.
inline constexpr float smallest_cosine = 0.05F;

// Sizes and opacities of the discs of one layer of marks, as functions of the place on the screen.
// All lengths in pixels; `ppe` is pixels per eye unit at the mark.
struct Pen {
    float spacing = 0.0F;      // of the layer's marks, eye units
    float zoom_per_ppe = 0.0F; // 0: no reference, the zoom is 1
    float zoom_exponent = 2.0F;
    float ink_radius = 1.0F, ink_zoom = 0.0F;
    float silhouette_radius = 1.0F, silhouette_zoom = 0.0F;
    float cover_radius = 0.0F; // 0: from the spacing
    float halo = 0.0F;
    float layers = 0.0F;
    float lambda_front = 1.0F, lambda_back = 1.0F;
    float largest_cover = 0.0F;

    [[nodiscard]] float zoom(float ppe) const noexcept { return zoom_per_ppe > 0.0F ? ppe * zoom_per_ppe : 1.0F; }
    [[nodiscard]] float scale(float ppe) const noexcept { return zoom_scale(zoom(ppe), zoom_exponent); }
    [[nodiscard]] float front_ink(float ppe) const noexcept { return grown(ink_radius, ink_zoom, ppe); }
    [[nodiscard]] float silhouette_ink(float ppe) const noexcept {
        return grown(silhouette_radius, silhouette_zoom, ppe);
    }

    [[nodiscard]] float front_cover(float ppe) const noexcept {
        // One pixel at least, so that small drawings are covered as well.
        const float radius = cover_radius > 0.0F ? cover_radius : std::max(1.0F, cover_spacings * spacing * ppe);
        return std::min(radius, largest_cover);
    }
    // The area scales with the zoom.  An automatic cover follows the zoom already, so there it is
    // only the halo that is left to scale.
    [[nodiscard]] float back_cover(float ppe) const noexcept {
        const float shrink = std::sqrt(scale(ppe));
        if (cover_radius > 0.0F) return std::min((cover_radius + halo) * shrink, largest_cover);
        return front_cover(ppe) + halo * shrink;
    }

    [[nodiscard]] float front_opacity(float nu, float radius, float ppe) const noexcept {
        return disc_opacity(front_alpha(nu, lambda_front), layers, expected_overlap(radius, spacing * ppe, nu));
    }
    [[nodiscard]] float back_opacity(float nu, float radius, float ppe) const noexcept {
        return disc_opacity(back_alpha(nu, lambda_back), layers, expected_overlap(radius, spacing * ppe, nu));
    }

private:
    [[nodiscard]] float grown(float radius, float exponent, float ppe) const noexcept {
        return exponent == 0.0F ? radius : radius * std::pow(zoom(ppe), exponent);
    }
};

// How far behind its mark, in eye units, a front mark's disc of paper is painted, so that it lies
// behind all ink of its own sheet: within the disc's radius R a sphere of any size that faces the
// eye under the angle theta falls back by R (1 + sin(theta)) / cos(theta) at most, be it a plane
// (R tan(theta)) or so small that its contour is just within reach.
[[nodiscard]] inline float front_push(float radius, float nu, float ppe) noexcept {
    const float cosine = std::clamp(std::abs(nu), smallest_cosine, 1.0F);
    return radius / ppe * (1.0F + std::sqrt(1.0F - cosine * cosine)) / cosine;
}

// The ink that a back mark must not cover is that of the contour, where its sheet turns to the
// front.  That is nearer to the eye, and all that is needed is some slack.
[[nodiscard]] inline float back_push(float radius, float ppe) noexcept { return radius / ppe; }

// One item's matrices.
struct ItemView {
    Style style;
    const implicit::Implicit* model = nullptr;
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

    // Of a mark by its number in the layer, relative to the set's origin.
    [[nodiscard]] glm::vec3 place(const marks::Layer& marks, std::int64_t mark) const noexcept {
        return glm::vec3(glm::dvec3(marks::vector_at(marks.position, mark)) / unit);
    }
};

// The marks of one layer of one item that take part in the frame.
struct Run {
    const marks::Layer* marks = nullptr;
    std::int32_t item = 0;
    std::int32_t group = 0; // its place in Style::group
    std::int64_t first = 0; // place of its first mark in the arrays below
    std::int64_t count = 0;
    std::int64_t first_place = 0; // of its clusters' blocks, one after the other
    std::uint32_t first_id = 0;
    std::uint32_t sets = 3; // of front ink
    bool draws_front = false;
    bool draws_silhouettes = false;
    bool paints_paper = false;     // HIDDEN_LINES_ATTENUATE
    bool occludes = false;         // HIDDEN_LINES_HIDE
    float earlier_contours = 0.0F; // contour marks per area of the item's runs before this one, eye space
    float separation = 0.0F;       // of strokes, eye units; 0: none is known
    bool spread_evenly = false;    // in a blue-noise order
    bool covers = false;           // its marks tell where the sheets of its item are
    Pen pen;

    [[nodiscard]] std::int64_t places() const noexcept { return marks->clusters.block.size() * marks::MarkBlock::size; }
    // Radius of the ink of a front mark, by its number in the layer.  Contours are not tapered.
    [[nodiscard]] float front_ink(std::int64_t mark, float ppe) const noexcept {
        const float radius = pen.front_ink(ppe);
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
        : x(memory), y(memory), window_depth(memory), depth(memory), ppe(memory), nu(memory), tau(memory),
          tau_depth(memory), mark_class(memory), role(memory) {}

    base::Array<float> x, y;         // pixels
    base::Array<float> window_depth; // in the camera's convention
    base::Array<float> depth;        // eye units along the view
    base::Array<float> ppe;          // pixels per eye unit
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
    explicit Scene(base::Memory& memory) noexcept : items(memory), runs(memory), chunks(memory), marks(memory) {}

    Lens lens;
    base::Array<ItemView> items;
    base::Array<Run> runs;
    base::Array<Chunk> chunks;
    Marks marks;

    [[nodiscard]] const ItemView& item_of(const Run& run) const noexcept { return items[run.item]; }
    [[nodiscard]] std::int64_t mark_count() const noexcept {
        return runs.empty() ? 0 : runs.span().back().first + runs.span().back().count;
    }
    [[nodiscard]] std::int64_t place_count() const noexcept {
        return runs.empty() ? 0 : runs.span().back().first_place + runs.span().back().places();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept;
};

// Fills lens, items and runs.  Throws Error{invalid_argument}.
void set_up(Scene& scene, std::span<const Item> items, const Camera& camera);
// Fills chunks, and makes room for the marks.
void add_chunks(Scene& scene);

// Where a disc of paper is painted in the order of painting, eye units along the view.
[[nodiscard]] inline float paper_depth(const Marks& marks, std::int64_t place, float radius) noexcept {
    const float ppe = marks.ppe[place];
    return marks.depth[place] + (marks.mark_class[place] == MarkClass::back ? back_push(radius, ppe)
                                                                            : front_push(radius, marks.nu[place], ppe));
}

// Where ink is painted in the order of painting, eye units along the view: pulled toward the eye by
// about its own size, so that it lies over the paper of its own sheet.
[[nodiscard]] inline float ink_depth(float depth, float radius, float ppe) noexcept { return depth - radius / ppe; }

} // namespace hrbfnpr::frame
