// SPDX-License-Identifier: MIT
// Finds where marks are on the screen (project, project_rows), how light they are (light, light_rows), and how much of
// each is drawn (select). There is a version for each instruction set, and all give the same bits.
#pragma once

#include "base/instruction_set.h"
#include "marks/point_set.h"

#include <cstdint>

namespace hrbfnpr::frame {

// A light in the space of an item's lighting.
struct Lamp {
    float place[4]; // a unit vector towards the light and 0, or the place of the light and 1
    float intensity;
    float fill;   // the strength of a light from the opposite side
    float shadow; // the share of its light that a shadow takes away
};

// How light the marks of an item are: the sum of lamps, ambient light and rim light, changed by a tone law.
struct Lighting {
    bool rigid;         // If true, lamps are in the space of the item, and `normal` and `place` are not used.
    float normal[3][3]; // transforms normals to the space of the lamps
    float place[3][3];  // the same for positions
    Lamp lamps[8];
    std::int32_t count;       // the number of lamps
    float exponent;           // the exponent of n . l
    float ambient;            // the mean of the light from the sky and that from the ground
    float from_sky;           // half the difference between them
    float up[3];              // a unit vector towards the sky
    float occlusion;          // the share of the ambient light that is lost where no sky is seen
    float occlusion_lights;   // the same of the light of lamps
    float occlusion_exponent; // the exponent of the share of the sky that is seen
    float rim, rim_exponent;
    float curvature_contrast; // the light that a ridge adds and a hollow takes away
    // The tone is the power `gamma` of (sum - black) * per_range, rounded down to one of `steps` tones. steps = 0: any
    // tone.
    float black, per_range, gamma;
    std::int32_t steps;
};

// How much light reaches marks past what casts shadows, with an element for each mark. NULL: all.
struct LightShares {
    const float* open = nullptr;  // the share of the sky that is seen
    const float* visible[8] = {}; // the share of each lamp that is seen
    const float* bend = nullptr;  // -1 in hollows, 1 on ridges; NULL: 0
};

// The matrices that take the positions and normals of a set to the picture, as rows.
struct ViewTransform {
    float clip[4][4];   // to (x w, y w, depth w, w), with x and y in pixels and the window depth
    float eye[3][4];    // to eye space
    bool rigid;         // the matrix `normal` keeps lengths
    float normal[3][3]; // to eye space
    float centre[3];    // in eye space: the centre of projection or, if `parallel`, the direction of all lines of sight
    bool parallel;
    float pixels; // the number of pixels per eye unit where w is 1
};

// The first marks of a cluster.
struct MarkRange {
    const marks::MarkBlock* blocks;
    std::int64_t count; // <= ProjectedMarks::most
};

// Marks, with an array for each coordinate. A vector may read beyond the last mark.
struct MarkRows {
    const float *x, *y, *z, *nx, *ny, *nz;
    std::int64_t count;
};

// The numbers of ProjectedMarks for any number of marks. `along` may be NULL.
struct ProjectedRows {
    float *x, *y, *window, *depth, *pixels_per_unit, *nu, *side_x, *side_y, *distance, *along;
};

struct ProjectedMarks {
    static constexpr std::int64_t most = marks::most_in_cluster;
    float x[most], y[most];           // in pixels
    float window[most];               // depth in the camera's convention
    float depth[most];                // eye units along the viewing direction
    float pixels_per_unit[most];      // pixels per eye unit; <= 0 or NaN if the mark is not in front of the camera
    float nu[most];                   // n . v
    float side_x[most], side_y[most]; // x and y of the unit normal in eye space
    float along[most];                // the component, along the viewing direction, of the unit vector v
    // Distance from the centre of projection in eye units; with parallel lines of sight, the depth.
    float distance[most];
};

// The rules for drawing the front marks of a cluster as ink.
struct Selection {
    // The window plus a strip around it in which discs may still touch it. all_inside: all marks are certainly in this
    // area.
    float left, right, top, bottom;
    bool all_inside;

    // By the share rule, a mark is shown where 1 - rank <= min(1, needed(1 - tau) |nu| per_ink) share fade_factor
    // density scale tau_depth. By the published rule, a mark is shown if it passes one test after the other.
    bool is_published;
    bool coverage;       // false: `needed` and |nu| are left out
    const float* needed; // ink per area needed for each coverage k / needed_steps, k from 0 to needed_steps
    float per_ink, share, fade_factor, scale;
    float fade;         // 0: a mark is shown in full or not at all
    float vanishing_nu; // > 0: ink fades where |nu| is below this value
    // For marks that are even in the picture: their place there, as a share of 1 - rank, for each |nu| = k /
    // needed_steps. Then `front` is 1 for each mark that may be shown. NULL for other marks.
    const float* flat_places;
};
inline constexpr int needed_steps = 64;

struct Selected {
    float front[ProjectedMarks::most]; // the share of each mark's area that is drawn
    std::uint16_t
        drawn[ProjectedMarks::most]; // a bit for each mark whose share is not 0; an element holds `lanes` marks
    // For marks that are even in the picture: their least place there, and the place up to which they are shown.
    float flat[ProjectedMarks::most], limit[ProjectedMarks::most];
    std::int32_t lanes;
    std::int32_t outside, fronts, backs;
    std::int32_t dropped_tone, dropped_zoom, dropped_depth;
};

struct ProjectionLoops {
    void (*project)(const ViewTransform& view_transform, const MarkRange& marks, ProjectedMarks& projected);
    void (*project_rows)(const ViewTransform& view_transform, const MarkRows& marks, const ProjectedRows& projected);
    // Computes tau of marks whose normals for tone are those of `marks`. nu holds n . v of each mark.
    // The shares begin with that of the first mark. A vector may read beyond the last mark.
    void (*light)(const Lighting& lighting, const MarkRange& marks, const float* nu, const LightShares& shares,
                  float* tau);
    void (*light_rows)(const Lighting& lighting, const MarkRows& marks, const float* nu, const LightShares& shares,
                       float* tau);
    // tau, density and tau_depth hold a number for each mark. density and tau_depth may be NULL, which means 1 for all.
    void (*select)(const Selection& selection, const MarkRange& marks, const ProjectedMarks& projected,
                   const float* tau, const float* density, const float* tau_depth, Selected& selected);
};

[[nodiscard]] ProjectionLoops projection_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::frame
