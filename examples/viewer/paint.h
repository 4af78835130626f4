// SPDX-License-Identifier: MIT
// Maps painted on the surface, as a list of dabs: one after the other each pulls what lies within its radius towards
// its value.
#pragma once

#include "handles.h"

#include <unordered_map>

namespace viewer {

enum class Map { tone, density, direction };

struct Dab {
    Map map = Map::tone;
    Vec position{}, normal{};
    double radius = 1;
    double value = 0;    // of tone 0 dark .. 1 light; of density 0 no stipples .. 1 all
    double strength = 1; // 0 .. 1: how far it pulls in its middle
    Vec direction{};     // of direction
};

// The dabs of one map, ready for many questions.
class PaintedMap {
public:
    PaintedMap(const std::vector<Dab>& dabs, Map map);
    bool is_empty() const { return dabs_.empty(); }
    // What was `value` before at a place with a unit normal.
    double pulled(double value, const Vec& place, const Vec& normal) const;
    // The direction there; 0 where none was painted.
    Vec direction(const Vec& place, const Vec& normal) const;

private:
    // Numbers of the dabs that reach into a cell, in their order.
    const std::vector<std::uint32_t>* near(const Vec& place) const;
    std::uint64_t cell_of(std::int64_t x, std::int64_t y, std::int64_t z) const;

    std::vector<Dab> dabs_;
    double cell_ = 1;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

// The light of a style and a painted map of tones: what hrbfnpr_style.tone_user points to.
struct PaintedTone {
    const PaintedMap* map;
    Vec light; // unit, in world space
    double exponent, fill;
    bool lit; // else the tone is 0 where nothing is painted
};

std::int32_t painted_tone(void* tone, std::int64_t count, const float* positions, const float* normals, float* tau);
// For hrbfnpr_layer_desc; the user is a PaintedMap.
std::int32_t painted_density(void* map, std::int64_t count, const double* positions, const double* normals,
                             double* density);
std::int32_t painted_direction(void* map, std::int64_t count, const double* positions, const double* normals,
                               double* directions);

} // namespace viewer
