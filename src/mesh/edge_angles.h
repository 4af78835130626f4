// SPDX-License-Identifier: MIT
// How faces lie about an edge that more than two of them share.
#pragma once

#include "mesh/edges.h"

namespace hrbfnpr::mesh {

struct Turned {
    const Side* side;
    std::int64_t angle; // about the edge, from the first face, in parts of a radian, behind -pi and up to pi
    double rounding;    // what that may be off by
};

[[nodiscard]] inline std::int32_t low(const Side& side) noexcept { return static_cast<std::int32_t>(side.edge >> 32U); }
[[nodiscard]] inline std::int32_t high(const Side& side) noexcept {
    return static_cast<std::int32_t>(side.edge & 0xFFFFFFFFU);
}

// How far single precision, in which most files are, may have moved places.
[[nodiscard]] double coordinate_rounding(const base::Array<glm::dvec3>& vertex) noexcept;

class EdgeAngles {
public:
    EdgeAngles(const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle) noexcept
        : vertex_(vertex), triangle_(triangle), rounding_(coordinate_rounding(vertex)) {}

    // Of faces that have an area.
    void measure(const Side* first, const Side* last, base::Array<Turned>& result) const;
    // Whether both lie on the same side of the edge, one on the other, but for rounding.
    [[nodiscard]] static bool alike(const Turned& a, const Turned& b) noexcept;
    // How far the angle between two faces is from a half turn.
    [[nodiscard]] static std::int64_t bend(const Turned& a, const Turned& b) noexcept;

private:
    [[nodiscard]] std::int32_t third(const Side& side) const noexcept;

    const base::Array<glm::dvec3>& vertex_;
    const base::Array<Triangle>& triangle_;
    double rounding_;
};

} // namespace hrbfnpr::mesh
