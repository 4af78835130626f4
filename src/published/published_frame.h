// SPDX-License-Identifier: MIT
// Makes a drawing as published: discs of ink and of paper, painted from far to near. [NPAR 6, 6.1, 6.2]
//
// 1. Marks are classified: each gets a place on the screen, a class (front, back or silhouette) and a tone.
// 2. A depth map of the discs that hide others is drawn (VisibilityMap).
// 3. Each mark's role is decided: ink, paper, both or none, by tone, depth, zoom and visibility.
// 4. Discs are sorted from far to near, and become the dots of the drawing.
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "drawing/tiles.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::published {

using namespace frame; // for the scene, which this folder classifies and paints

// A mark on the screen.
struct Mark {
    float x, y;            // pixels
    float window;          // depth in the camera's convention
    float depth;           // eye units along the view
    float pixels_per_unit; // pixels per eye unit
    float nu;
    float tau, tau_depth; // the tone by light, and by distance
    MarkClass mark_class; // none: the mark is outside of the picture, and the numbers before are not set
    bool is_ink, is_paper;
};

// A map of the nearest surface's depth, drawn as discs of the front and back marks of items that hide others. The discs
// lie as far beyond their own layer as discs of paper, so that the layer does not hide its own ink.
class VisibilityMap {
public:
    explicit VisibilityMap(base::Memory& memory) noexcept
        : bins_(memory, tile_size), depth_(memory), occluders_(memory) {}

    void build(const base::Parallel& parallel, const Scene& scene, const base::Array<Mark>& marks);

    // Tells whether a place is hidden. x and y are in pixels of the image, and depth is in eye units along the view.
    // Returns false outside the viewport.
    [[nodiscard]] bool hides(float x, float y, float depth) const noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept { return bins_.bytes() + depth_.bytes() + occluders_.bytes(); }

private:
    static constexpr std::int32_t tile_size = 32;

    // x, y and radius are in texels of the map, the depth is in eye units. The radius is negative if the mark hides
    // nothing.
    struct Occluder {
        float x, y, radius, depth;
    };
    void fill_tile(std::int64_t tile) noexcept;

    float left_ = 0.0F, top_ = 0.0F; // the viewport's top-left corner, pixels
    float texels_per_pixel_ = 1.0F;
    std::int32_t width_ = 0, height_ = 0;
    drawing::Tiles bins_;
    base::Array<float> depth_;
    base::Array<Occluder> occluders_; // one for each mark
};

class PublishedFrame {
public:
    explicit PublishedFrame(const base::Runtime& runtime) noexcept
        : runtime_(runtime), marks_(runtime.memory), tone_calls_(runtime.memory), visibility_(runtime.memory),
          order_(runtime.memory), next_key_(runtime.memory), counts_(runtime.memory), keys_(runtime.memory) {}

    // Fills in all of the drawing that the scene has not filled in. Throws Error{callback, out_of_memory}.
    void run(const Scene& scene, drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return marks_.bytes() + tone_calls_.bytes() + visibility_.bytes() + order_.bytes() + next_key_.bytes() +
               counts_.bytes() + keys_.bytes();
    }

private:
    void find_keys(const Scene& scene);

    const base::Runtime& runtime_;
    // The following memory is kept from frame to frame.
    base::Array<Mark> marks_; // one for each mark of the scene's runs
    ToneCalls tone_calls_;
    VisibilityMap visibility_;
    drawing::DepthSort order_;
    base::Array<std::int64_t> next_key_; // where each task's next key goes
    base::Array<Counts> counts_;         // one for each task
    base::Array<std::uint64_t> keys_;    // one for each disc: its depth, its mark's place, and whether it is paper
};

} // namespace hrbfnpr::published
