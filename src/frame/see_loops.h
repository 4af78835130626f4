// From marks to places on the screen, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::frame {

// What is done to the marks of one item: rows of matrices, of positions and normals of the set.
struct Seer {
    float clip[4][4];         // to x w, y w, window depth w, w
    float eye[3][4];          // to eye space
    bool rigid;               // `normal` keeps lengths, and `light` is a direction of the set's own space
    float normal[3][3];       // to eye space, of any length
    float normal_light[3][3]; // to the space that the light is in
    float light[3];
    float centre[3]; // of projection, eye space; or the direction of all lines of sight
    bool parallel;
    float pixels; // per eye unit where w is 1
};

// Consecutive marks, structure of arrays.
struct MarkBlock {
    const float *x, *y, *z, *nx, *ny, *nz;
    std::int64_t count;
};

struct Seen {
    static constexpr std::int64_t most = 128;
    float x[most], y[most];           // pixels
    float window[most];               // depth in the camera's convention
    float depth[most];                // eye units along the view
    float ppe[most];                  // pixels per eye unit; <= 0 or not a number: behind the camera
    float nu[most];                   // n . v
    float lit[most];                  // n . l
    float side_x[most], side_y[most]; // of the unit normal, eye space
    float along[most];                // how far a unit step of v goes along the view
    float distance[most];             // from the centre of projection, eye units; parallel: depth
};

struct SeeLoops {
    void (*see)(const Seer& seer, const MarkBlock& marks, Seen& seen); // marks.count <= Seen::most
};

[[nodiscard]] SeeLoops see_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::frame
