// SPDX-License-Identifier: MIT
// Finds where marks are on the screen (project, project_rows) and how much of each is drawn (select). There is a
// version for each instruction set, and all give the same bits.
#pragma once

#include "base/instruction_set.h"
#include "marks/point_set.h"

#include <cstdint>

namespace hrbfnpr::frame {

// How normals in the space of an item are lit. light.h makes tones from the result.
struct Light {
    bool rigid;         // If true, `towards` is in the space of the item and `normal` is not used.
    float normal[3][3]; // transforms normals to the space of the light
    float towards[3];   // a unit vector towards the light
};

// The matrices that take the positions and normals of a set to the picture, as rows.
struct ViewTransform {
    float clip[4][4];   // to (x w, y w, depth w, w), with x and y in pixels and the window depth
    float eye[3][4];    // to eye space
    bool rigid;         // the matrix `normal` keeps lengths
    float normal[3][3]; // to eye space
    Light light;
    float centre[3]; // in eye space: the centre of projection or, if `parallel`, the direction of all lines of sight
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
    const float *tone_x, *tone_y, *tone_z; // the normals for n . l
    std::int64_t count;
};

// The numbers of ProjectedMarks for any number of marks. `along` may be NULL.
struct ProjectedRows {
    float *x, *y, *window, *depth, *pixels_per_unit, *nu, *lit, *side_x, *side_y, *distance, *along;
};

struct ProjectedMarks {
    static constexpr std::int64_t most = marks::most_in_cluster;
    float x[most], y[most];           // in pixels
    float window[most];               // depth in the camera's convention
    float depth[most];                // eye units along the viewing direction
    float pixels_per_unit[most];      // pixels per eye unit; <= 0 or NaN if the mark is not in front of the camera
    float nu[most];                   // n . v
    float lit[most];                  // n . l
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

    // By the share rule, a mark is shown where 1 - rank <= min(1, needed(1 - tau) |nu| per_ink) share fade_factor scale
    // tau_depth. By the published rule, a mark is shown if it passes one test after the other.
    bool is_published;
    bool coverage;       // false: `needed` and |nu| are left out
    const float* needed; // ink per area needed for each coverage k / needed_steps, k from 0 to needed_steps
    float per_ink, share, fade_factor, scale;
    float fade;         // 0: a mark is shown in full or not at all
    float vanishing_nu; // > 0: ink fades where |nu| is below this value
};
inline constexpr int needed_steps = 64;

struct Selected {
    float front[ProjectedMarks::most]; // the share of each mark's area that is drawn
    std::uint16_t
        drawn[ProjectedMarks::most]; // a bit for each mark whose share is not 0; an element holds `lanes` marks
    std::int32_t lanes;
    std::int32_t outside, fronts, backs;
    std::int32_t dropped_tone, dropped_zoom, dropped_depth;
};

struct ProjectionLoops {
    void (*project)(const ViewTransform& view_transform, const MarkRange& marks, ProjectedMarks& projected);
    void (*project_rows)(const ViewTransform& view_transform, const MarkRows& marks, const ProjectedRows& projected);
    // tau and tau_depth hold a number for each mark; tau_depth may be NULL, which means 1 for all.
    void (*select)(const Selection& selection, const MarkRange& marks, const ProjectedMarks& projected,
                   const float* tau, const float* tau_depth, Selected& selected);
};

[[nodiscard]] ProjectionLoops projection_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::frame
