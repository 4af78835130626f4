// SPDX-License-Identifier: MIT
// Makes a drawing as published: discs of ink and of paper, painted from far to near. [NPAR 6, 6.1, 6.2]
//
// 1. Classify marks: each gets a place on the screen, a class (front, back or silhouette) and a tone.
// 2. Draw a depth map of the discs that hide others (VisibilityMap).
// 3. Decide the role of each mark by tone, depth, zoom and visibility: ink, paper, both or none.
// 4. Sort the discs from far to near. They become the dots of the drawing.
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "drawing/tiles.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::published {

using namespace frame; // for the scene, which this folder uses

// A mark on the screen.
struct Mark {
    float x, y;            // in pixels
    float window;          // depth in the camera's convention
    float depth;           // in eye units along the view
    float pixels_per_unit; // pixels per eye unit at the depth of the mark
    float nu;
    float tau, tau_depth; // the tone from light, and the tone from distance
    MarkClass mark_class; // none: the mark is outside the picture, and the other members are not set
    bool is_ink, is_paper;
};

// A map of the nearest surface's depth. It is drawn as discs around the front and back marks of items that hide others.
// Each disc is moved away from the eye, by as much as the discs of paper that make hidden lines paler, so that a layer
// does not hide its own ink.
class VisibilityMap {
public:
    explicit VisibilityMap(base::Memory& memory) noexcept
        : bins_(memory, tile_size), depth_(memory), occluders_(memory) {}

    void build(const base::Parallel& parallel, const Scene& scene, const base::Array<Mark>& marks);

    // Returns whether a place is hidden; false outside the viewport. x and y are in pixels of the image, and `depth` is
    // in eye units along the view.
    [[nodiscard]] bool hides(float x, float y, float depth) const noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept { return bins_.bytes() + depth_.bytes() + occluders_.bytes(); }

private:
    static constexpr std::int32_t tile_size = 32;

    // x, y and radius are in texels of the map, and depth is in eye units. The radius is negative if the mark hides
    // nothing.
    struct Occluder {
        float x, y, radius, depth;
    };
    void fill_tile(std::int64_t tile) noexcept;

    float left_ = 0.0F, top_ = 0.0F; // the top-left corner of the viewport, in pixels
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

    // Fills in everything in the drawing that the scene has not filled in. Throws Error{callback, out_of_memory}.
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
    base::Array<std::int64_t> next_key_; // for each task, the index where its next key is stored
    base::Array<Counts> counts_;         // one for each task
    base::Array<std::uint64_t> keys_;    // for each disc: its depth, the index of its mark, and whether it is paper
};

} // namespace hrbfnpr::published
