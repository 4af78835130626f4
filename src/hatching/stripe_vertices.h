// SPDX-License-Identifier: MIT
// Lines and waves of samples at the vertices of a mesh.
#pragma once

#include "base/list.h"
#include "curves/surface_mesh.h"
#include "hatching/stripe_phase.h"

namespace hrbfnpr::hatching {

// Waves of several periods on the same samples, the first the coarsest.
struct SampleWaves {
    explicit SampleWaves(base::Memory& memory) noexcept : phases(memory) {}

    base::List<Phases> phases;
    double period = 0.0; // of the first; each further one has half of the one before

    [[nodiscard]] std::int64_t levels() const noexcept { return phases.size(); }
    [[nodiscard]] double period_of(std::int64_t level) const noexcept {
        return std::ldexp(period, -static_cast<int>(level));
    }
};

struct StripeVertices {
    // sheets: of the mesh's vertices, where samples have them; else empty.
    StripeVertices(const base::Runtime& runtime, const LineSamples& samples, const SampleWaves& waves,
                   const curves::SurfaceMesh& mesh, const base::Array<std::int32_t>& sheets,
                   const base::Progress& progress);

    // By how much the phase of a wave grows from vertex a to b, in the sense of a's line.
    [[nodiscard]] double growth(std::int32_t a, std::int32_t b, bool turned, double period) const noexcept;
    [[nodiscard]] bool turned(std::int32_t a, std::int32_t b) const noexcept {
        return glm::dot(along[a], along[b]) < 0.0;
    }

    // Adds waves of half the period, and again, down to this one: each the square of the one before, averaged among
    // neighbours on the mesh, so that a fork of two lines becomes two forks.
    void refine(const base::Runtime& runtime, const curves::SurfaceMesh& mesh, double period, int halvings,
                const base::Progress& progress);

    const geometry::VecArray& position;
    geometry::VecArray across;             // unit, tangent; the phase grows that way
    geometry::VecArray along;              // unit, tangent; 0 where no sample is near
    base::List<base::Array<Complex>> wave; // of each level; its size says how far the samples agree, 1 at most
};

} // namespace hrbfnpr::hatching
